// The keys of an input file as a table. Each key is declared once, with its unit, its range, its
// meaning and the member of a plain struct that it fills. The reader, --dump-default, --set, error
// messages and the tables of inputs/KEYS.md are all made from it.
//
//   const KeyTable<Scene> table = {
//       {"cage.width_mm", above(0), [](Scene& s) -> auto& { return s.cage.width; },
//        "axial width of the cage"},
//   };
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "src/input/choice.hpp"
#include "src/input/input_error.hpp"
#include "src/input/number_list.hpp"
#include "src/input/toml_file.hpp"
#include "src/input/unit.hpp"

namespace cagetol {

/// Type of a key's value. `numbers`: one number for all pockets (or rollers), or an array with one
/// for each. `list`, `names`: an array of any length, empty by default.
enum class KeyKind { number, numbers, integer, boolean, choice, text, list, names };

/// Values a key may take, in the key's unit.
struct KeyRange {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool open_minimum = false;  ///< the minimum itself is not allowed
  /// "auto" is allowed: computed from the rest of the scene, stored as NaN.
  bool may_be_auto = false;
  bool may_be_flooded = false;  ///< "flooded" is allowed: oil without end, stored as infinity
  bool required = false;        ///< the key has no default and must be given
  /// The key must be given if another key has this value, for example "model.motion = \"dynamic\"".
  /// Empty: no such condition.
  std::string required_where = {};
  std::vector<std::string> choices = {};
};
KeyRange any_value();
KeyRange above(double minimum, double maximum = std::numeric_limits<double>::infinity());
KeyRange at_least(double minimum);
/// Of a text: a line of so many characters.
KeyRange within(double minimum, double maximum);
KeyRange one_of(std::vector<std::string> choices);
KeyRange or_auto(KeyRange range);
KeyRange or_flooded(KeyRange range);
KeyRange required(KeyRange range);
KeyRange required_where(std::string condition, KeyRange range);

/// A key without the struct that it fills.
struct KeyInfo {
  std::string name;  ///< dotted, with its unit as suffix: "cage.pocket_width_mm"
  KeyRange range;
  std::string meaning;
  KeyKind kind = KeyKind::number;
  std::string unit;  ///< as shown to users; "-" for a pure number
  double to_si = 1;  ///< factor from the key's unit to SI

  KeyInfo(std::string key_name, KeyRange allowed, std::string key_meaning, KeyKind key_kind);
};

/// A member whose type is a closed set (choice.hpp), read and written as text.
template <class T>
struct ChoicePlace {
  std::function<std::string(T&)> text;
  std::function<void(T&, const std::string&)> set;
};

/// A reason for which a key does nothing.
template <class T>
struct Idle {
  /// For messages. Without `holds` it is the condition itself and compares the text of a key:
  /// `cage.model = "rigid"`, `window.settle_time_s is given`.
  std::string_view why;
  bool (*holds)(const T&) = nullptr;

  constexpr Idle(const char* text, bool (*condition)(const T&) = nullptr)
      : why(text), holds(condition) {}
};

/// One key of an input file that fills a struct of type T.
template <class T>
struct Key : KeyInfo {
  using Place =
      std::variant<std::function<double&(T&)>, std::function<std::vector<double>&(T&)>,
                   std::function<long&(T&)>, std::function<bool&(T&)>,
                   std::function<std::string&(T&)>, ChoicePlace<T>, std::function<NumberList&(T&)>,
                   std::function<std::vector<std::string>&(T&)>>;
  Place place;
  std::vector<Idle<T>> idle;  ///< where it does nothing; the first that holds is named

  /// The unit follows from the suffix of the name, the kind from the type that `accessor` returns.
  /// A closed set allows all of its values unless `allowed` lists some.
  template <class Accessor>
  Key(std::string key_name, KeyRange allowed, Accessor accessor, std::string key_meaning,
      std::vector<Idle<T>> where_idle = {});
};

template <class T>
using KeyTable = std::vector<Key<T>>;

/// The key called `name`, or nullptr.
template <class T>
const Key<T>* find_key(const KeyTable<T>& table, std::string_view name);

template <class T>
std::vector<KeyInfo> key_infos(const KeyTable<T>& table);

/// The known name nearest to `name` by edit distance, for "did you mean".
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);
/// "did you mean X?" where a known name is near, and `more`; without both "choose from" them all.
std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                       const std::string& more = {});

/// The error for an unknown key. If only the unit is wrong it names the right one and converts the
/// value, otherwise it names the nearest key.
InputError unknown_key(const TomlLeaf& leaf, const std::string& file,
                       const std::vector<KeyInfo>& known);

/// Checked values of a node, in the key's unit; NaN stands for "auto". All throw InputError with
/// file, line, key, value, reason and remedy.
double number_value(const KeyInfo& key, const toml::node& node, const std::string& file);
std::vector<double> numbers_value(const KeyInfo& key, const toml::node& node,
                                  const std::string& file, std::size_t count);
std::vector<double> list_value(const KeyInfo& key, const toml::node& node, const std::string& file);
std::vector<std::string> names_value(const KeyInfo& key, const toml::node& node,
                                     const std::string& file);
long integer_value(const KeyInfo& key, const toml::node& node, const std::string& file);
bool boolean_value(const KeyInfo& key, const toml::node& node, const std::string& file);
std::string text_value(const KeyInfo& key, const toml::node& node, const std::string& file);

/// Whether a number given in the key's unit lies in the key's range. NaN and infinities never do.
bool in_range(const KeyRange& range, double value);
/// Likewise, and neither in SI nor back in the key's unit would it become zero or infinite.
bool allows(const KeyInfo& key, double value);
/// The range in words: "above 0 mm", "0 to 1".
std::string range_text(const KeyInfo& key);

/// Fills `target` at `key` from `node`, in the key's unit. `count` is the length that an array must
/// have (the number of pockets). Throws InputError.
template <class T>
void read_key(const Key<T>& key, const toml::node& node, const std::string& file, std::size_t count,
              T& target);

/// Sets a number (or, for `numbers` keys, one per pocket) given in the key's unit. Does not check
/// the range.
template <class T>
void set_key_numbers(const Key<T>& key, const std::vector<double>& values, T& target);

/// The numbers at a `number`, `numbers` or `list` key, in the key's unit.
template <class T>
std::vector<double> key_numbers(const Key<T>& key, const T& source);

/// The value at a key as TOML text: 7.65, "auto", [7.65, 7.66], "rigid", true.
template <class T>
std::string key_text(const Key<T>& key, const T& source);

/// Whether "KEY = VALUE" or "KEY is given" (neither "auto" nor an empty list) holds of `source`.
template <class T>
bool condition_holds(const KeyTable<T>& table, std::string_view condition, const T& source);

/// Why a key does nothing in `source`; empty if it does something.
template <class T>
std::string_view why_idle(const KeyTable<T>& table, const Key<T>& key, const T& source);

/// Inserts the value at a key into a TOML table, in the section that the key belongs to.
template <class T>
void insert_key(const Key<T>& key, const T& source, toml::table& root);

/// The table as TOML text with the values of `source`, grouped by section. A comment gives unit,
/// range and meaning of each key. `prefix` ("scene.") is put in front of every section.
template <class T>
std::string dump_keys(const KeyTable<T>& table, const T& source, const std::string& prefix = "");

/// The table in Markdown with the columns key, unit, default (from `defaults`, or "required"),
/// range and meaning.
template <class T>
std::string key_table_markdown(const KeyTable<T>& table, const T& defaults);

}  // namespace cagetol

#include "src/input/key_table_impl.hpp"
