#include "distributions/designs/pick_freeze.hpp"

namespace cagetol {

namespace {

std::uint64_t block_count(const DesignSpec& spec) {
  return std::uint64_t{2} + group_count(spec);
}

}  // namespace

PickFreeze::PickFreeze(const DesignSpec& spec)
    : seed_(spec.seed), rows_(spec.rows), blocks_(block_count(spec)), columns_(spec.columns) {}

std::uint64_t PickFreeze::complete_rows(const DesignSpec& spec) {
  return rows_of(divided_up(spec.rows, block_count(spec)), block_count(spec));
}

std::string PickFreeze::row_rule(const DesignSpec& spec) {
  return "a multiple of groups + 2 = " + std::to_string(block_count(spec));
}

std::uint64_t PickFreeze::source_of(std::uint64_t row, std::uint32_t group) const {
  const std::uint64_t block = row % blocks_;
  const bool from_b = block == 1 || block == std::uint64_t{2} + group;
  return 2 * (row / blocks_) + (from_b ? 1 : 0);
}

void PickFreeze::point(std::uint64_t row, std::span<double> u) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto& [purpose, stream, draw, group] = columns_[i];
    u[i] = uniform(seed_, purpose, source_of(row, group), stream, draw);
  }
}

}  // namespace cagetol
