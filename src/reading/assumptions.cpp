#include "src/reading/assumptions.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

const char* const kBoth = "give low and high, both in the unit of the key, or leave both out";

/// The key as far as it bounds an end of a range.
KeyInfo end_of(const KeyInfo& key, const char* end) {
  KeyInfo info = key;
  info.name = std::string("assumption.") + end;
  info.range.may_be_auto = info.range.may_be_flooded = false;
  info.kind = KeyKind::number;
  info.meaning = key.name + ": " + key.meaning;
  return info;
}

void read_range(const toml::table& entry, const KeyInfo& key, const std::string& file,
                Assumption& assumption) {
  const auto *low = entry.get("low"), *high = entry.get("high");
  if (!low && !high) return;
  const toml::node& given = low ? *low : *high;
  const std::string name = low ? "assumption.low" : "assumption.high";
  if (key.kind != KeyKind::number && key.kind != KeyKind::numbers)
    throw InputError(place_of(given, file), name, shown(given),
                     key.name + " cannot have a range: it is not a number with a unit",
                     "leave low and high out");
  if (!low || !high)
    throw InputError(place_of(given, file), name, shown(given),
                     "the range of " + key.name + " has one end only", kBoth);
  assumption.low = number_value(end_of(key, "low"), *low, file);
  assumption.high = number_value(end_of(key, "high"), *high, file);
  if (assumption.low > assumption.high)
    throw InputError(
        place_of(*low, file), "assumption.low", shown(*low),
        "the range of " + key.name + " begins above its end (high = " + shown(*high) + ")",
        "exchange low and high");
}

void refuse_other_keys(const toml::table& entry, const std::string& file) {
  static const std::vector<std::string> known = {"key", "note", "low", "high"};
  for (const auto& [name, value] : entry)
    if (std::find(known.begin(), known.end(), name.str()) == known.end())
      throw InputError(place_of(value, file), "assumption." + std::string(name.str()), shown(value),
                       "no such key", suggestion(name.str(), known));
}

std::string key_of(const toml::node& entry) {
  const auto* table = entry.as_table();
  const auto* key = table ? table->get_as<std::string>("key") : nullptr;
  return key ? key->get() : "";
}

}  // namespace

std::vector<Assumption> read_assumptions(const toml::node& node, const std::string& file) {
  std::vector<Assumption> assumptions;
  const auto wrong = [&](const toml::node& at, const std::string& problem) {
    return InputError(
        place_of(at, file), "assumption", shown(at), problem,
        "write [[assumption]] with key = \"bearing.internal_clearance_um\" and note = \"why\"");
  };
  if (!node.is_array()) throw wrong(node, "this is a list of tables");
  for (const auto& element : *node.as_array()) {
    const auto* table = element.as_table();
    const auto* name = table ? table->get_as<std::string>("key") : nullptr;
    const auto* note = table ? table->get_as<std::string>("note") : nullptr;
    if (!name || !note) throw wrong(element, "an assumption has a key and a note, both text");
    const auto* key = find_key(scene_keys(), name->get());
    if (!key) throw wrong(element, "no key of a scene is called '" + name->get() + "'");
    refuse_other_keys(*table, file);
    Assumption assumption{name->get(), note->get()};
    read_range(*table, *key, file, assumption);
    const auto twice =
        std::find_if(assumptions.begin(), assumptions.end(),
                     [&](const Assumption& other) { return other.key == assumption.key; });
    if (twice != assumptions.end() && (twice->has_range() || assumption.has_range()))
      throw InputError(place_of(element, file), "assumption", shown(element),
                       "a second entry for " + assumption.key + ", where one has a range",
                       "put both into one entry");
    assumptions.push_back(std::move(assumption));
  }
  return assumptions;
}

void add_assumptions(toml::array&& base, toml::array& replacing) {
  toml::array all;
  const auto take = [&](toml::node& entry) {
    std::move(entry).visit(
        [&](auto&& value) { all.push_back(std::forward<decltype(value)>(value)); });
  };
  std::vector<std::string> keys;
  for (const auto& entry : replacing) keys.push_back(key_of(entry));
  std::vector<bool> taken(replacing.size(), false);
  for (auto& entry : base) {
    const std::string key = key_of(entry);
    const auto found = key.empty() ? keys.end() : std::find(keys.begin(), keys.end(), key);
    if (found == keys.end()) {
      take(entry);
      continue;
    }
    const auto place = static_cast<std::size_t>(found - keys.begin());
    if (!taken[place]) take(*replacing.get(place));
    taken[place] = true;
  }
  for (std::size_t place = 0; place < taken.size(); ++place)
    if (!taken[place]) take(*replacing.get(place));
  replacing = std::move(all);
}

}  // namespace cagetol
