#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "distributions/design.hpp"

namespace cagetol {

/// Columns of inputs "0", "1", ...
inline std::vector<DesignColumn> single_columns(std::uint32_t count) {
  std::vector<DesignColumn> columns;
  for (std::uint32_t i = 0; i < count; ++i) {
    columns.push_back({Purpose::lot, stream_address(std::to_string(i)), 0});
  }
  return columns;
}

inline DesignSpec spec_of(DesignKind kind, std::uint64_t rows, std::uint32_t columns) {
  DesignSpec spec;
  spec.kind = kind;
  spec.rows = rows;
  spec.seed = 2024;
  spec.columns = single_columns(columns);
  return spec;
}

inline std::vector<double> point_of(const Design& design, std::uint64_t row) {
  std::vector<double> u(design.dimensions());
  design.point(row, u);
  return u;
}

inline std::vector<std::vector<double>> points_of(const Design& design) {
  std::vector<std::vector<double>> points;
  for (std::uint64_t row = 0; row < design.rows(); ++row) points.push_back(point_of(design, row));
  return points;
}

}  // namespace cagetol
