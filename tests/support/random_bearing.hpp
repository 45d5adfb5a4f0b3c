// Random scenes and states for tests that compare two ways of computing the same thing: every
// contact kind touches somewhere, every option of a rigid bearing occurs. Deterministic in the
// seed.
#pragma once

#include <vector>

#include "src/model/bearing_model.hpp"

namespace cagetol {

struct RandomBearing {
  Scene scene;
  BearingModel model;
  std::vector<double> y;
  double t = 0;
};

/// Which motions of the bearing are free: those of rollers, or of rollers and the inner ring's
/// tilt.
enum class Freedom { spatial, tilting };
/// For names of tests.
const char* freedom_name(Freedom freedom);

/// Which part of their bars rollers meet: flat faces, the rounded edges of flat faces, lips, curved
/// faces and their edges.
enum class Outline { flat, edges, lips, curved };
const char* outline_name(Outline outline);

struct RandomBearingOptions {
  double lean = 1;                     ///< scales every small angle: axes, misalignment, squareness
  double depth = 30e-6;                ///< typical penetration and gap [m]
  int modes = 0;                       ///< elastic modes of the cage, of random shape
  Freedom freedom = Freedom::spatial;  ///< tilting: no cage is guided by the inner ring
  bool oiled_lands = false;            ///< a dry bearing but for its guide film
  bool lubricated = false;             ///< lubrication.model = LubricationModel::film
  Outline outline = Outline::flat;     ///< else rollers stand apart from the races
  bool wavy = false;                   ///< raceways with random waves
  bool sphere_ends = false;            ///< of rollers, against inclined flanges
  bool inner_flanges = true;           ///< on every fourth bearing whose ring does not tilt
};

/// Gives the model of a dry scene the film that its guide lands would have in oil of 20 mPa s.
void oil_the_lands(const Scene& scene, BearingModel& model);

/// Scene number `seed`: Z = 13 or 16, both laws, one or five slices, all guidances, tapered,
/// unbalanced, misaligned.
Scene random_scene(unsigned seed, double lean = 1);

/// The scene's bearing in a random state whose gaps and penetrations are of the order `depth`,
/// sliding in every friction regime.
RandomBearing random_bearing(unsigned seed, const RandomBearingOptions& options = {});

}  // namespace cagetol
