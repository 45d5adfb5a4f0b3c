#include "src/quantities/along_rolling.hpp"

#include <cmath>

namespace cagetol {

void AlongRolling::record(double t, double rolling, double cage, double rollers, double centre) {
  const Seen now{t, rolling, cage, rollers, centre};
  if (started_) {
    const double sum = last_.rolling + rolling, way = sum > 0 ? 1 : sum < 0 ? -1 : 0;
    rolled_ += (t - last_.t) * (std::abs(last_.rolling) + std::abs(rolling)) / 2;
    cage_ += way * (cage - last_.cage);
    rollers_ += way * (rollers - last_.rollers);
    centre_ += way * (centre - last_.centre);
    travelled_ += std::abs(cage - last_.cage);
  }
  started_ = true;
  last_ = now;
}

}  // namespace cagetol
