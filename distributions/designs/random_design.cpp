#include "distributions/designs/random_design.hpp"

namespace cagetol {

RandomDesign::RandomDesign(const DesignSpec& spec)
    : seed_(spec.seed),
      rows_(spec.rows),
      cages_per_lot_(spec.cages_per_lot),
      columns_(spec.columns) {}

void RandomDesign::point(std::uint64_t row, std::span<double> u) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto& [purpose, stream, draw] = columns_[i];
    const std::uint64_t id = purpose == Purpose::lot ? row / cages_per_lot_ : row;
    u[i] = uniform(seed_, purpose, id, stream, draw);
  }
}

}  // namespace cagetol
