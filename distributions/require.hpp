#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace cagetol {

/// Throws std::invalid_argument with the parts written one after the other, unless the condition
/// holds.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
  if (condition) return;
  std::ostringstream message;
  (message << ... << parts);
  throw std::invalid_argument(message.str());
}

/// Laws without a density end up here.
[[noreturn]] inline void refuse_density(const char* reason) {
  throw std::domain_error(std::string("no density: ") + reason +
                          "; use a law with a spread, or draw from it only");
}

}  // namespace cagetol
