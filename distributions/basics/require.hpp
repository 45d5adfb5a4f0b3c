#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace cagetol {

/// Throws std::invalid_argument unless the condition holds. The message is the parts in sequence.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
  if (condition) return;
  std::ostringstream message;
  (message << ... << parts);
  throw std::invalid_argument(message.str());
}

/// Throws the error of laws without a density.
[[noreturn]] inline void refuse_density(const char* reason) {
  throw std::domain_error(std::string("no density: ") + reason +
                          "; use a law with a spread, or draw from it only");
}

}  // namespace cagetol
