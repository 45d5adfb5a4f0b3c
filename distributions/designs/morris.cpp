#include "distributions/designs/morris.hpp"

#include "distributions/basics/require.hpp"
#include "distributions/designs/permutation.hpp"

namespace cagetol {

Morris::Morris(const DesignSpec& spec)
    : rows_(spec.rows),
      levels_(spec.morris_levels),
      groups_(group_count(spec)),
      trim_(spec.trim),
      key_(design_key(spec.seed)) {
  require(levels_ >= 2 && levels_ % 2 == 0, "morris needs an even number of levels, not ", levels_,
          "; 4 is common");
  for (const DesignColumn& column : spec.columns) {
    column_keys_.push_back(column_key(spec.seed, column));
    group_of_column_.push_back(column.group);
  }
}

std::uint64_t Morris::complete_rows(const DesignSpec& spec) {
  const std::uint64_t steps = std::uint64_t{1} + group_count(spec);
  return rows_of(divided_up(spec.rows, steps), steps);
}

std::string Morris::row_rule(const DesignSpec& spec) {
  return "a multiple of groups + 1 = " + std::to_string(std::uint64_t{1} + group_count(spec));
}

std::uint64_t Morris::step_of(std::uint64_t trajectory, std::uint32_t group) const {
  const PhiloxCounter order = philox(
      {static_cast<std::uint32_t>(trajectory), static_cast<std::uint32_t>(trajectory >> 32), 0, 0},
      key_);
  return 1 + Permutation(groups_, {order[0], order[1]})(group);
}

std::uint64_t Morris::source_of(std::uint64_t row, std::uint32_t group) const {
  const std::uint64_t trajectory = row / (groups_ + 1);
  const bool moved = row % (groups_ + 1) >= step_of(trajectory, group);
  return 2 * trajectory + (moved ? 1 : 0);
}

std::optional<std::uint32_t> Morris::moved_group(std::uint64_t row) const {
  for (std::uint32_t group = 0; group < groups_; ++group) {
    if (row % (groups_ + 1) == step_of(row / (groups_ + 1), group)) return group;
  }
  return std::nullopt;
}

void Morris::point(std::uint64_t row, std::span<double> u) const {
  const std::uint64_t trajectory = row / (groups_ + 1);
  std::vector<bool> moved(groups_);
  for (std::uint32_t group = 0; group < groups_; ++group) {
    moved[group] = source_of(row, group) % 2 == 1;
  }
  for (std::size_t i = 0; i < column_keys_.size(); ++i) {
    const PhiloxCounter block = philox({static_cast<std::uint32_t>(trajectory),
                                        static_cast<std::uint32_t>(trajectory >> 32), 0, 2},
                                       column_keys_[i]);
    const bool starts_high = block[2] & 1u;
    const bool high = starts_high != moved[group_of_column_[i]];
    const std::uint64_t level = index_of(bits_of(block), levels_ / 2) + (high ? levels_ / 2 : 0);
    u[i] = level_value(level, levels_, trim_);
  }
}

}  // namespace cagetol
