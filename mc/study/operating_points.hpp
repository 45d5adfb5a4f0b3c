// Several operating points of one study (a duty list): one sample is one drawn bearing, run at each
// point. A limit on a quantity must be met at every point, one on QUANTITY@POINT at that point.
//
// Of a sample, each point has quantities of its own. Those without a label are joined over the
// points as their kind says (quantity_table.hpp). A sample fails with its first point that does.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "mc/study/study.hpp"
#include "src/quantities/outcome.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {

/// Labels of all quantities of the study's samples, in the order of study.h5: of each operating
/// point POINT and its phases POINT.PHASE, or the phases of the scene. None: no labels.
std::vector<std::string> quantity_labels(const Study& study);

/// The [[operating_point]] entries. Throws InputError for keys that are not about the operation of
/// a bearing, that vary in the study, or whose scene is impossible.
std::vector<OperatingPointPlan> read_operating_points(const toml::table& root,
                                                      const std::string& file, const Study& study);
/// One entry; throws likewise.
OperatingPointPlan read_operating_point(const toml::table& entry, const std::string& file,
                                        const Study& study);
toml::table operating_point_table(const OperatingPointPlan& point);

/// Finds the temperatures of the scene and of each point where temperature.balance asks for it
/// (src/heat_balance.hpp).
void find_temperatures(Study& study);
/// Writes window.whirl_clearance_um of the nominal bearing where some run measures whirl.
void find_whirl_clearance(Study& study);
/// They are to be found again: something changed that they depend on.
void forget_temperatures(Study& study);

/// The scene at the point.
Scene at_operating_point(Scene scene, const OperatingPointPlan& point);

/// Limits on a quantity without a label become one for each point.
std::vector<Limit> limits_at_points(std::vector<Limit> limits,
                                    const std::vector<OperatingPointPlan>& points);

/// Value over the points of the quantity in that row; NaN where its kind has none.
double over_points(const Quantity& quantity, std::size_t row, const Study& study,
                   const std::vector<Outcome>& outcomes);

/// The outcome of a sample from those of its points in order; a failed one may be the last.
Outcome join_points(const Study& study, const std::vector<Outcome>& outcomes);

/// The points, the runs and the motion of a sample that they make; empty where there are none.
std::string operating_points_text(const Study& study);

}  // namespace cagetol
