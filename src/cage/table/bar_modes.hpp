// Static modes of the bars: how each bar deflects under a roller beyond what the kept elastic
// modes carry. Those leave out a third to a half of a bar's compliance, and 36 of them hardly less
// than 20: a bar bends locally, which takes modes far above 100 kHz to compose.
//
// For every bar, the static response (inertia relief) to a unit tangential force spread over the
// stations of both its faces, less the part of the kept modes: a residual attachment mode
// (R. R. Craig, AIAA Journal 23, 1985). The Z responses are combined to be orthogonal in mass and
// stiffness, so that they join the elastic modes as they are. On the undeviated mesh the static
// response of the cage to a force spread over a bar is then exact.
#pragma once

#include <Eigen/Core>

#include "src/cage/table/cage_table.hpp"

namespace cagetol {

/// A unit force on every bar, a column each: half of it on each face, along the stations by their
/// lengths. A row for every bar station, in the order of station_stress() [N].
Eigen::MatrixXd forces_on_bars(const CageStations& stations, Eigen::Index sectors);

struct BarModes {
  Eigen::MatrixXd load;       ///< forces on all bar stations [N] of which each mode is the response
  Eigen::MatrixXd fields;     ///< coefficients of all columns, mass-normalised
  Eigen::ArrayXd eigenvalue;  ///< omega^2 [1/s^2]
};

/// `rows`: tangential displacement of all columns at all bar stations; `residual`: static response
/// of all columns to a unit force on each, without the kept modes.
BarModes make_bar_modes(const CageTable& table, const CageProjection& projection,
                        const Eigen::MatrixXd& rows, const Eigen::MatrixXd& residual);

}  // namespace cagetol
