// Morris trajectories over groups (Morris 1991, doi:10.1080/00401706.1991.10484804; groups:
// Campolongo, Cariboni, Saltelli 2007, doi:10.1016/j.envsoft.2006.10.004). Every column starts at a
// random level; then one group after the other, in random order, has its columns moved by
//   delta = p / (2 (p - 1))
// of the range, each up or down at random. p levels span [trim, 1 - trim].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class Morris {
 public:
  explicit Morris(const DesignSpec& spec);

  static std::uint64_t complete_rows(const DesignSpec& spec);
  static std::string row_rule(const DesignSpec& spec);

  Layout layout() const { return {groups_ + std::uint64_t{1}, rows_ / (groups_ + 1), true}; }
  void point(std::uint64_t row, std::span<double> u) const;

  /// 2 trajectory before the group moves, 2 trajectory + 1 afterwards.
  std::uint64_t source_of(std::uint64_t row, std::uint32_t group) const;

  std::optional<std::uint32_t> moved_group(std::uint64_t row) const;

 private:
  /// Step of the trajectory at which the group moves, 1 .. groups.
  std::uint64_t step_of(std::uint64_t trajectory, std::uint32_t group) const;

  std::uint64_t rows_, levels_;
  std::uint32_t groups_;
  double trim_;
  PhiloxKey key_;
  std::vector<PhiloxKey> column_keys_;
  std::vector<std::uint32_t> group_of_column_;
};

}  // namespace cagetol
