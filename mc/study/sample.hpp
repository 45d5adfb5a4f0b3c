// One sample of a study: a pure function of (study, id), whatever rank computes it and whenever.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "distributions/design.hpp"

#include "mc/study/study.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The drawn parts of one uncertain input, in the key's unit, already scaled by the sample's
/// candidate. Empty where not varied.
struct DrawnInput {
  std::vector<double> lot;     ///< 0 or 1 value
  std::vector<double> pocket;  ///< 0 or Z values
  std::vector<double> noise;   ///< 0 or 1 value
  std::vector<double> value;   ///< what is simulated: 1 or Z values
};

struct Sample {
  std::uint64_t id = 0;
  std::uint64_t row = 0;        ///< design row
  std::uint64_t replicate = 0;  ///< 0, or the k-th repetition of the row with fresh noise
  std::uint64_t lot = 0;
  long candidate = -1;
  std::vector<DrawnInput> inputs;  ///< in the order of Study::inputs
  Scene scene;                     ///< ready to simulate
};

/// Number of columns of the design. Laws of zero width are plain numbers and have none.
std::size_t design_columns(const Study& study);

/// Draws samples: owns the design and the correlations, made once. Immutable, cheap to copy, usable
/// from any thread.
class Sampler {
 public:
  /// Throws InputError when the study makes no design or its correlations contradict each other.
  explicit Sampler(const Study& study);

  /// Id to row and replicate: ids 0 .. rows-1 are replicate 0; further ids go through the rows
  /// again, replicate 1, 2, ... A pure function of (study, id). Drawn values beyond the range of
  /// their key (a negative length; read_study refuses laws for which this is likely) are set to its
  /// end.
  /// With Study::redraw_jams a cage that does not fit is drawn again, all of it and its lot, until
  /// one does; the number of redraws is part of the address of its random numbers.
  Sample draw(std::uint64_t id) const;

  /// All of a sample as first drawn but its scene, which is left as it is.
  void draw_deviations(std::uint64_t id, Sample& sample) const;

  const Design& design() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// One sample. Makes a Sampler each time: for many samples make one and keep it.
Sample draw_sample(const Study& study, std::uint64_t id);

}  // namespace cagetol
