#include "distributions/designs/grid.hpp"

#include "distributions/basics/require.hpp"

namespace cagetol {

namespace {

/// "2 x 1000 x 30", shortened beyond eight factors.
std::string product_text(const std::vector<std::uint64_t>& levels) {
  std::string text;
  for (std::size_t g = 0; g < levels.size(); ++g) {
    if (g == 8) return text + " x ...";
    text += (g == 0 ? "" : " x ") + std::to_string(levels[g]);
  }
  return text;
}

}  // namespace

Grid::Grid(const DesignSpec& spec)
    : rows_(spec.rows), trim_(spec.trim), levels_(spec.grid_levels), strides_(levels_.size()) {
  std::uint64_t stride = 1;
  for (std::size_t g = levels_.size(); g-- > 0; stride *= levels_[g]) strides_[g] = stride;
  for (const DesignColumn& column : spec.columns) group_of_column_.push_back(column.group);
}

std::uint64_t Grid::complete_rows(const DesignSpec& spec) {
  require(spec.grid_levels.size() == group_count(spec), "a grid of ", group_count(spec),
          " groups needs as many numbers of levels, not ", spec.grid_levels.size(),
          "; give grid_levels = [5] for all groups, or one number for each");
  std::uint64_t rows = 1;
  for (const std::uint64_t levels : spec.grid_levels) {
    require(levels >= 1,
            "a grid needs at least one level in each group; give 1 to keep the median");
    require(levels <= most_rows / rows, "a grid of ", product_text(spec.grid_levels),
            " rows has more than 2^40; use fewer levels");
    rows *= levels;
  }
  return rows;
}

void Grid::point(std::uint64_t row, std::span<double> u) const {
  for (std::size_t i = 0; i < group_of_column_.size(); ++i) {
    const std::uint32_t group = group_of_column_[i];
    u[i] = level_value(row / strides_[group] % levels_[group], levels_[group], trim_);
  }
}

}  // namespace cagetol
