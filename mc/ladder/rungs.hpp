// The model ladder: what a scene's keys switch, as rungs from the cheapest model to the dearest,
// and as refinements of one scene.
#pragma once

#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

/// One model of the ladder. Its keys replace those of the scene; all others stay as given.
struct Rung {
  std::string name;
  std::string meaning;                ///< in words, against the rung it is compared with
  std::vector<std::string> settings;  ///< "dotted.key=value", each key once
};

/// Cheapest first by this order, never by measured time. The lowest rung has no motion, the second
/// all of it; from there each rung adds one thing to the one below it. The last one is the
/// reference. An oil film, and an inner ring whose tilt is free, stay as the scene has them, their
/// data are the scene's to give; equilibria are dry.
const std::vector<Rung>& climbing_rungs();

/// The scene as it is, "as-run", last, and before it the scene with one setting refined at a time:
/// `integrator` (a tenth of its tolerance, the default method), `modes` (a rigid cage becomes
/// flexible with the default modes, a flexible one gets 36), `slices` (2 n + 1), `mesh` (two more
/// elements through the thickness of a flexible cage), `window` (measured twice as long). What
/// cannot be refined in this scene is left out.
std::vector<Rung> refining_rungs(const Scene& scene);

/// The scene on that rung.
Scene on_rung(Scene scene, const Rung& rung);

/// Those of `rungs` that give this scene a model of its own: not one that takes away what the scene
/// has not, nor one without what the scene needs (equilibria carry no axial load). The last one,
/// the reference, stays.
std::vector<Rung> rungs_for(const Scene& scene, const std::vector<Rung>& rungs);

/// The study's first `samples` random samples on that rung, without its replicates.
/// All rungs of a study draw the same samples. A study in which nothing varies gets scatter of the
/// start: any phase, and a tenth of the pocket clearance in y and z. Throws InputError where a key
/// of the rung is a distribution.
Study rung_study(const Study& study, const Rung& rung, long samples);

/// Size of the study whose standard error sets the budget: its rows; of a mere scene, 1000.
double ladder_study_samples(const Study& study);

}  // namespace cagetol
