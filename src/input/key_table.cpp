// Above 400 lines: one kind of key after another, read, checked and written alike.
#include "src/input/key_table.hpp"

#include <fmt/format.h>

#include "src/input/former_names.hpp"
#include "src/input/printable.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cagetol {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string section_name(std::string_view name) {
  const auto dot = name.rfind('.');
  return std::string(dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot));
}

std::string last_part(std::string_view name) {
  const auto dot = name.rfind('.');
  return std::string(dot == std::string_view::npos ? name : name.substr(dot + 1));
}

// " mm" behind a number; nothing for a pure number.
std::string unit_behind(const KeyInfo& key) {
  return key.unit == "-" ? "" : " " + key.unit;
}

std::string words_of(const KeyRange& range) {
  return std::string(range.may_be_auto ? " or \"auto\"" : "") +
         (range.may_be_flooded ? " or \"flooded\"" : "");
}

std::string example_of(const KeyInfo& key) {
  switch (key.kind) {
    case KeyKind::boolean:
      return "true or false";
    case KeyKind::choice:
    case KeyKind::text:
      return "a text in quotes";
    case KeyKind::integer:
      return "a whole number, " + range_text(key);
    case KeyKind::numbers:
      return "a number in " + key.unit + ", or an array with one for each pocket";
    case KeyKind::list:
      return "an array of numbers in " + key.unit;
    case KeyKind::names:
      return "an array of texts in quotes";
    default:
      return (key.unit == "-" ? std::string("a plain number") : "a number in " + key.unit) +
             words_of(key.range);
  }
}

InputError wrong_type(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (const auto number = node.value_exact<double>(); key.kind == KeyKind::integer && number &&
                                                      *number == std::round(*number) &&
                                                      std::abs(*number) < 1e15)
    return {place_of(node, file), key.name, shown(node), "a whole number has no point or exponent",
            fmt::format("write {:.0f}", *number)};
  return {place_of(node, file), key.name, shown(node),
          std::string("this is ") + type_name(node) + ", expected " + example_of(key),
          "give " + example_of(key) + " (" + key.meaning + ")"};
}

InputError out_of_range(const KeyInfo& key, const std::string& value, const SourcePlace& place) {
  return {place, key.name, value, "outside the range of this key (" + key.meaning + ")",
          "give a value " + range_text(key)};
}

double checked_number(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (!node.is_number()) throw wrong_type(key, node, file);
  const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                         : node.as_floating_point()->get();
  if (!std::isfinite(value))
    throw InputError(place_of(node, file), key.name, shown(node), "not a finite number",
                     "give " + example_of(key) + ", " + range_text(key));
  if (!allows(key, value)) throw out_of_range(key, shown(node), place_of(node, file));
  return value;
}

/// What a word in place of a number stands for, where the key allows it.
std::optional<double> word_value(const KeyInfo& key, const toml::node& node) {
  const auto word = node.value<std::string>();
  if (key.range.may_be_auto && word == "auto") return std::numeric_limits<double>::quiet_NaN();
  if (key.range.may_be_flooded && word == "flooded") return kInfinity;
  return {};
}

}  // namespace

KeyRange any_value() {
  return {};
}

KeyRange above(double minimum, double maximum) {
  return {.minimum = minimum, .maximum = maximum, .open_minimum = true};
}

KeyRange at_least(double minimum) {
  return {.minimum = minimum};
}

KeyRange within(double minimum, double maximum) {
  return {.minimum = minimum, .maximum = maximum};
}

KeyRange one_of(std::vector<std::string> choices) {
  return {.choices = std::move(choices)};
}

KeyRange or_auto(KeyRange range) {
  range.may_be_auto = true;
  return range;
}

KeyRange or_flooded(KeyRange range) {
  range.may_be_flooded = true;
  return range;
}

KeyRange required(KeyRange range) {
  range.required = true;
  return range;
}

KeyRange required_where(std::string condition, KeyRange range) {
  range.required_where = std::move(condition);
  return range;
}

KeyInfo::KeyInfo(std::string key_name, KeyRange allowed, std::string key_meaning, KeyKind key_kind)
    : name(std::move(key_name)),
      range(std::move(allowed)),
      meaning(std::move(key_meaning)),
      kind(key_kind == KeyKind::text && !range.choices.empty() ? KeyKind::choice : key_kind),
      unit(unit_of(name).text),
      to_si(unit_of(name).to_si) {}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t smallest = std::numeric_limits<std::size_t>::max();
  const std::string_view compared = name.substr(0, 200);
  for (const auto& candidate : known) {
    // What it begins or ends is nearer than what it resembles.
    const bool begun =
        !name.empty() && (candidate.starts_with(name) || last_part(candidate) == name);
    const std::size_t distance = begun ? 0 : edit_distance(compared, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                       const std::string& more) {
  const std::string nearest = nearest_name(name, known);
  const std::string_view asked = name.substr(0, 200);
  const std::size_t apart = std::min(edit_distance(asked, nearest),
                                     edit_distance(asked, nearest.substr(0, asked.size())));
  const bool is_near = nearest.starts_with(name) || last_part(nearest) == name ||
                       apart <= std::max<std::size_t>(2, name.size() / 2);
  if (is_near) return "did you mean " + nearest + "?" + (more.empty() ? "" : " " + more);
  return more.empty() ? "choose from " + joined(known) : more;
}

InputError unknown_key(const TomlLeaf& leaf, const std::string& file,
                       const std::vector<KeyInfo>& known) {
  const auto place = place_of(*leaf.node, file);
  const std::string value = leaf.node->is_table() ? "" : shown(*leaf.node);
  if (const FormerName* former = former_name(leaf.name))
    return {place, leaf.name, value, former_problem(*former), former_remedy(*former)};
  std::vector<std::string> names, section;
  for (const auto& key : known) {
    names.push_back(key.name);
    if (leaf.name.starts_with(key.name + "."))
      return {place, leaf.name, value, key.name + " holds a value and has no keys of its own",
              "give one value; or, in a study, the law of its deviations: " + key.name +
                  " = { nominal = ..., law = \"normal\", sigma = ... }"};
    if (key.name.starts_with(leaf.name + ".")) section.push_back(key.name);
    const auto stem = without_unit(leaf.name);
    if (without_unit(key.name) != stem && without_unit(key.name) != leaf.name) continue;
    const Unit& given = unit_of(leaf.name);
    const Unit& wanted = unit_of(key.name);
    const auto number = leaf.node->value<double>();
    if (without_unit(key.name) == leaf.name || given.suffix.empty())
      return {place, leaf.name, value, "the unit is missing from the key's name",
              "write " + key.name + ", in " + wanted.text};
    if (given.dimension != wanted.dimension || !number)
      return {place, leaf.name, value,
              "wrong unit: this key is a " + wanted.dimension + " in " + wanted.text + ", not in " +
                  given.text,
              "write " + key.name + ", in " + wanted.text};
    const auto in_wanted = [&](double amount) {
      return fmt::format("{:.12g}", from_si(cagetol::to_si(amount, given.to_si), wanted.to_si));
    };
    return {place, leaf.name, value,
            "wrong unit: this key is in " + wanted.text + ", not in " + given.text,
            "write " + key.name + " = " + in_wanted(*number) + "  (1 " + given.text + " = " +
                in_wanted(1) + " " + wanted.text + ")"};
  }
  // Longer endings are misspelt words.
  if (const auto cut = leaf.name.rfind('_');
      cut != std::string::npos && cut + 5 >= leaf.name.size())
    for (const auto& key : known)
      if (key.unit != "-" && without_unit(key.name) == leaf.name.substr(0, cut))
        return {place, leaf.name, value, "the unit " + leaf.name.substr(cut + 1) + " is not known",
                "convert the value and write " + key.name + ", in " + key.unit};
  if (!section.empty())
    return {place, leaf.name, value, "this is a section, not a key",
            "give the keys of the section, for example " + section.front()};
  // Anything but a number may be nobody's business: this may be some other program's file.
  return {place, leaf.name, leaf.node->is_number() ? value : "", "no such key",
          suggestion(leaf.name, names, "inputs/KEYS.md lists every key")};
}

bool in_range(const KeyRange& range, double value) {
  if (!std::isfinite(value) || value > range.maximum) return false;
  return range.open_minimum ? value > range.minimum : value >= range.minimum;
}

bool allows(const KeyInfo& key, double value) {
  const double si = to_si(value, key.to_si);
  const bool kept = value == 0 || (std::isnormal(si) && std::isfinite(from_si(si, key.to_si)));
  return kept && in_range(key.range, value);
}

std::string range_text(const KeyInfo& key) {
  const auto& range = key.range;
  const std::string unit = unit_behind(key);
  std::string text;
  if (!range.choices.empty()) {
    for (const auto& choice : range.choices) text += (text.empty() ? "\"" : ", \"") + choice + "\"";
  } else if (key.kind == KeyKind::text && range.maximum < kInfinity) {
    text = "a line of at most " + number_text(range.maximum) + " characters";
  } else if (range.maximum < kInfinity && range.open_minimum) {
    text = "above " + number_text(range.minimum) + ", up to " + number_text(range.maximum) + unit;
  } else if (range.maximum < kInfinity) {
    text = "from " + number_text(range.minimum) + " to " + number_text(range.maximum) + unit;
  } else if (range.minimum > -kInfinity) {
    text = (range.open_minimum ? "above " : "at least ") + number_text(range.minimum) + unit;
  } else if (key.kind == KeyKind::boolean) {
    text = "true, false";
  } else {
    text = "any";
  }
  return text + words_of(range);
}

double number_value(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (const auto word = word_value(key, node)) return *word;
  return checked_number(key, node, file);
}

std::vector<double> numbers_value(const KeyInfo& key, const toml::node& node,
                                  const std::string& file, std::size_t count) {
  const auto* array = node.as_array();
  if (!array) return {number_value(key, node, file)};
  if (array->size() != count)
    throw InputError(place_of(node, file), key.name, shown(node),
                     "an array of " + std::to_string(array->size()) + " values, but there are " +
                         std::to_string(count) + " rollers (bearing.roller_count)",
                     "give one number for all, or an array of " + std::to_string(count));
  std::vector<double> values;
  for (const auto& element : *array) values.push_back(checked_number(key, element, file));
  return values;
}

std::vector<double> list_value(const KeyInfo& key, const toml::node& node,
                               const std::string& file) {
  const auto* array = node.as_array();
  if (!array) throw wrong_type(key, node, file);
  std::vector<double> values;
  for (const auto& element : *array) values.push_back(checked_number(key, element, file));
  return values;
}

std::vector<std::string> names_value(const KeyInfo& key, const toml::node& node,
                                     const std::string& file) {
  const auto* array = node.as_array();
  if (!array) throw wrong_type(key, node, file);
  std::vector<std::string> names;
  for (const auto& element : *array) names.push_back(text_value(key, element, file));
  return names;
}

long integer_value(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (!node.is_integer()) throw wrong_type(key, node, file);
  const auto value = node.value<int64_t>().value();
  if (!in_range(key.range, static_cast<double>(value)))
    throw out_of_range(key, shown(node), place_of(node, file));
  return value;
}

bool boolean_value(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (!node.is_boolean()) throw wrong_type(key, node, file);
  return node.value<bool>().value();
}

std::string text_value(const KeyInfo& key, const toml::node& node, const std::string& file) {
  if (!node.is_string()) throw wrong_type(key, node, file);
  auto text = node.value<std::string>().value();
  if (printable(text, LineBreaks::kept) != text)
    throw InputError(place_of(node, file), key.name, "'" + printable(text) + "'",
                     "the text holds characters that control a terminal",
                     "leave them out; letters, signs and line breaks of any language may stay");
  const auto characters =
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; });
  if (static_cast<double>(characters) > key.range.maximum ||
      (key.range.maximum < kInfinity && text.find('\n') != std::string::npos))
    throw out_of_range(key, "'" + printable(text) + "'", place_of(node, file));
  const auto& choices = key.range.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end()) {
    if (const FormerName* former = former_name(key.name, text))
      throw InputError(place_of(node, file), key.name, shown(node), former_problem(*former),
                       former_remedy(*former));
    throw InputError(
        place_of(node, file), key.name, shown(node),
        "not one of the choices of this key (" + key.meaning + ")",
        "choose from " + joined(choices) + "; nearest: " + nearest_name(text, choices));
  }
  return text;
}

namespace key_detail {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      constexpr const char* hex = "0123456789abcdef";
      result += std::string("\\u00") + hex[c / 16] + hex[c % 16];
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string numbers_text(const std::vector<double>& values) {
  const auto text = [](double value) -> std::string {
    if (!std::isfinite(value)) return std::isnan(value) ? "\"auto\"" : "\"flooded\"";
    const std::string digits = number_text(value);
    // TOML takes digits alone for an integer, which has 64 bits.
    const bool long_integer = std::abs(value) > 9e18 && digits.find('e') == std::string::npos;
    return digits + (long_integer ? ".0" : "");
  };
  if (values.size() == 1) return text(values[0]);
  std::string list = "[";
  for (const double value : values) list += (list.size() > 1 ? ", " : "") + text(value);
  return list + "]";
}

std::string list_text(const std::vector<double>& values) {
  return values.size() == 1 ? "[" + numbers_text(values) + "]" : numbers_text(values);
}

std::string names_text(const std::vector<std::string>& names) {
  std::string list = "[";
  for (const std::string& name : names) list += (list.size() > 1 ? ", " : "") + quoted(name);
  return list + "]";
}

std::string dump_line(const KeyInfo& key, const std::string& value) {
  const std::string line = last_part(key.name) + " = " + value;
  const std::string padding(line.size() < 34 ? 34 - line.size() : 1, ' ');
  const std::string unit = key.unit == "-" ? "" : "[" + key.unit + "] ";
  const std::string& conditional = key.range.required_where;
  return line + padding + "# " + unit + key.meaning + " (" + range_text(key) +
         (key.range.required ? "; required" : "") +
         (conditional.empty() ? "" : "; required where " + conditional) + ")\n";
}

std::string section_header(const std::string& name, const std::string& previous,
                           const std::string& prefix) {
  const std::string section = section_name(name);
  if (section == section_name(previous) && previous != ".") return "";
  if (section.empty())
    return prefix.empty() ? "" : "\n[" + prefix.substr(0, prefix.size() - 1) + "]\n";
  return "\n[" + prefix + section + "]\n";
}

std::string markdown_row(const KeyInfo& key, const std::string& value) {
  const std::string per_pocket =
      key.kind == KeyKind::numbers ? "; one number or one for each pocket"
      : key.kind == KeyKind::list || key.kind == KeyKind::names ? "; an array"
                                                                : "";
  const std::string& conditional = key.range.required_where;
  const std::string otherwise =
      conditional.empty() ? value : "required where " + conditional + ", else " + value;
  return "| `" + key.name + "` | " + key.unit + " | " +
         (key.range.required ? "required" : otherwise) + " | " + range_text(key) + " | " +
         key.meaning + per_pocket + " |\n";
}

std::pair<toml::table*, std::string> section_of(toml::table& root, const std::string& name) {
  toml::table* table = &root;
  std::string_view rest = name;
  for (auto dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
    table = table->insert(rest.substr(0, dot), toml::table{}).first->second.as_table();
    if (!table) return {nullptr, ""};
    rest = rest.substr(dot + 1);
  }
  return {table, std::string(rest)};
}

void insert_numbers(toml::table& table, const std::string& name,
                    const std::vector<double>& values) {
  if (values.size() == 1) {
    if (!std::isfinite(values[0]))
      table.insert_or_assign(name, std::isnan(values[0]) ? "auto" : "flooded");
    else
      table.insert_or_assign(name, values[0]);
    return;
  }
  table.insert_or_assign(name, array_of(values));
}

}  // namespace key_detail
}  // namespace cagetol
