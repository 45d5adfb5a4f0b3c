// Names of keys, values and quantities that earlier versions knew: each is refused with what became
// of it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cagetol {

/// What became of a name.
struct FormerName {
  std::string_view name;    ///< dotted key, section or quantity as it was, without "scene."
  std::string_view value;   ///< the choice of the key `name` that is gone; empty: the name itself
  std::string_view now;     ///< what it is called now; empty: it is gone
  std::string_view why;     ///< why it is gone
  std::string_view remedy;  ///< what to use instead; not needed beside `now`
};

/// All of them.
std::span<const FormerName> former_names();

/// The row of a key, of a key in a former section, or of a quantity (`value` empty), or of a choice
/// of a key; nullptr where there is none.
const FormerName* former_name(std::string_view name, std::string_view value = {});

/// Problem and remedy for a message about `row`.
std::string former_problem(const FormerName& row);
std::string former_remedy(const FormerName& row);

}  // namespace cagetol
