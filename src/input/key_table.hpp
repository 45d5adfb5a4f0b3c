// Keys of an input file as a table: each key is declared once, with its unit, range, meaning and the place in a plain struct
// that it fills. Reading, --dump-default, --set, error messages and the tables of inputs/README.md all come from it.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <variant>
#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

/// What a key holds. `Numbers` is one number for all pockets (or rollers), or an array with one each.
enum class KeyKind { number, numbers, integer, boolean, choice, text };

/// One key of an input file that fills a struct of type T.
template <class T>
struct Key {
  std::string name;     ///< dotted, with its unit as suffix: "cage.pocket_width_mm"
  std::string unit;     ///< as shown to users; "-" for a pure number
  double to_si = 1;     ///< factor from the key's unit to SI
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool open_minimum = false;  ///< the minimum itself is not allowed
  bool may_be_auto = false;   ///< "auto" is allowed: computed from the rest of the scene (stored as NaN)
  std::vector<std::string> choices;
  std::string meaning;
  std::variant<std::function<double&(T&)>, std::function<std::vector<double>&(T&)>,
               std::function<long&(T&)>, std::function<bool&(T&)>, std::function<std::string&(T&)>>
      place;
  KeyKind kind = KeyKind::number;
};

template <class T>
using KeyTable = std::vector<Key<T>>;

/// The key called `name`, or nullptr.
template <class T>
const Key<T>* find_key(const KeyTable<T>& table, std::string_view name) {
  for (const auto& key : table)
    if (key.name == name) return &key;
  return nullptr;
}

/// The known name nearest to `name` by edit distance, for "did you mean".
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// One leaf of a TOML document: its dotted name and node. Arrays are leaves; tables are walked into, unless `stop_at` says that
/// a table is itself a value (a distribution).
struct TomlLeaf {
  std::string name;
  const toml::node* node;
};
std::vector<TomlLeaf> toml_leaves(const toml::table& root,
                                  const std::function<bool(const toml::table&)>& stop_at = {});

/// Parses the TOML file `path`. Throws InputError with file and line for unreadable files and syntax errors.
toml::table read_toml(const std::string& path);

/// Applies "dotted.key=value" (value in TOML syntax; a bare word is taken as a string). Throws InputError.
void apply_setting(toml::table& root, const std::string& setting);

/// Place of a node in its file; settings from the command line are called "--set".
SourcePlace place_of(const toml::node& node, const std::string& file);

/// A node's value as the user wrote it, for messages.
std::string shown(const toml::node& node);

/// Fills `target` at `key` from `node`, in the key's unit. `count` is the length that an array must have (the number of
/// pockets). Throws InputError with file, line, key, value, reason and remedy.
template <class T>
void read_key(const Key<T>& key, const toml::node& node, const std::string& file, std::size_t count,
              T& target);

/// Sets a number (or, for `numbers` keys, one per pocket) given in the key's unit, checked against the key's range.
template <class T>
void set_key_numbers(const Key<T>& key, const std::vector<double>& values, T& target);

/// The table as TOML text with the values of `source`, grouped by section, each key commented with unit, range and meaning.
template <class T>
std::string dump_keys(const KeyTable<T>& table, const T& source);

/// The table in Markdown: key, unit, default (from `defaults`), range, meaning.
template <class T>
std::string key_table_markdown(const KeyTable<T>& table, const T& defaults);

}  // namespace cagetol

#include "src/input/key_table_impl.hpp"
