// What a screen answers in one cell of a map: how wide each tolerance may be, and what ends it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/tolerance/screen.hpp"

namespace cagetol {

/// Name of jams among what ends a tolerance; all others are limited quantities.
inline constexpr const char* kJams = "jams";

/// The width at which it misses the target alone, with its interval; nothing: not within what was
/// searched. That of jams is exact.
struct CellCause {
  std::string name;
  std::optional<double> width_mm = {}, lower_mm = {}, upper_mm = {};
  bool may_decide = false;  ///< the first cause, and those that intervals do not tell from it
};

/// Of one dimension, all others at their narrowest.
struct CellAnswer {
  LimitReach reach = {};  ///< of all causes together
  /// Places of the widest candidate that meets the target: by the estimate, and by the ends of its
  /// interval; -1: none does.
  long candidate = -1, lower = -1, upper = -1;
  bool resolved = false;               ///< `lower` and `upper` are at most one candidate apart
  bool certain = false;                ///< they are the same, and one cause alone may decide
  std::vector<CellCause> causes = {};  ///< narrowest width first
  /// The first cause, where it ends the tolerance within the candidates; else empty.
  std::string decides = {};
};

/// Whether both have the same candidate and what decides.
bool same_answer(const CellAnswer& one, const CellAnswer& other);

/// `candidates` are those of the dimension: grades by their width in mm.
CellAnswer cell_answer(const Screen& screen, std::size_t dimension,
                       const std::map<double, std::string>& candidates);

}  // namespace cagetol
