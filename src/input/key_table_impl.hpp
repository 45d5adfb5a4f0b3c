// Templates of key_table.hpp. Code that does not depend on the struct is in key_table.cpp.
#pragma once

#include <type_traits>
#include <utility>

#include "src/input/key_table.hpp"

namespace cagetol {

namespace key_detail {

template <class Value>
constexpr KeyKind kind_of() {
  if constexpr (std::is_same_v<Value, double>) return KeyKind::number;
  if constexpr (std::is_same_v<Value, std::vector<double>>) return KeyKind::numbers;
  if constexpr (std::is_same_v<Value, NumberList>) return KeyKind::list;
  if constexpr (std::is_same_v<Value, std::vector<std::string>>) return KeyKind::names;
  if constexpr (std::is_same_v<Value, long>) return KeyKind::integer;
  if constexpr (std::is_same_v<Value, bool>) return KeyKind::boolean;
  if constexpr (std::is_enum_v<Value>) return KeyKind::choice;
  return KeyKind::text;
}

template <class T, class Accessor>
using PlaceType = std::remove_cvref_t<std::invoke_result_t<Accessor, T&>>;

/// `allowed`, completed by all spellings of a closed set of type Value if it lists none.
template <class Value>
KeyRange with_choices(KeyRange allowed) {
  if constexpr (std::is_enum_v<Value>)
    if (allowed.choices.empty()) allowed.choices = choice_texts<Value>();
  return allowed;
}

template <class T, class Accessor>
typename Key<T>::Place make_place(Accessor accessor) {
  using Value = PlaceType<T, Accessor>;
  if constexpr (std::is_enum_v<Value>) {
    return ChoicePlace<T>{[accessor](T& source) { return std::string(spelled(accessor(source))); },
                          [accessor](T& target, const std::string& text) {
                            accessor(target) = choice_of<Value>(text);
                          }};
  } else {
    return std::function<Value&(T&)>(std::move(accessor));
  }
}

template <class Value>
void read_value(const KeyInfo& key, const toml::node& node, const std::string& file,
                std::size_t count, Value& value) {
  if constexpr (std::is_same_v<Value, double>) {
    value = to_si(number_value(key, node, file), key.to_si);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    value = numbers_value(key, node, file, count);
    for (double& each_value : value) each_value = to_si(each_value, key.to_si);
  } else if constexpr (std::is_same_v<Value, NumberList>) {
    value.values = list_value(key, node, file);
    for (double& each_value : value.values) each_value = to_si(each_value, key.to_si);
  } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    value = names_value(key, node, file);
  } else if constexpr (std::is_same_v<Value, long>) {
    value = integer_value(key, node, file);
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = boolean_value(key, node, file);
  } else {
    value = text_value(key, node, file);
  }
}

/// The text at a key that holds a text or a closed set.
template <class T>
std::string text_at(const Key<T>& key, T& source) {
  if (const auto* choice = std::get_if<ChoicePlace<T>>(&key.place)) return choice->text(source);
  return std::get<std::function<std::string&(T&)>>(key.place)(source);
}

/// One line of a dump: "pocket_width_mm = 7.65  # [mm] above 0: opening ...".
std::string dump_line(const KeyInfo& key, const std::string& value);
/// "[section]" if the section of `name` differs from that of `previous`, otherwise empty.
std::string section_header(const std::string& name, const std::string& previous,
                           const std::string& prefix);
std::string markdown_row(const KeyInfo& key, const std::string& value);
std::string numbers_text(const std::vector<double>& values);
/// As an array, whatever its length.
std::string list_text(const std::vector<double>& values);
std::string names_text(const std::vector<std::string>& names);
std::string quoted(const std::string& text);
/// The table of `root` that holds a dotted name, created if missing, and the last part of the name.
/// nullptr if a value other than a table is in the way.
std::pair<toml::table*, std::string> section_of(toml::table& root, const std::string& name);
template <class Value>
toml::array array_of(const std::vector<Value>& values) {
  toml::array list;
  for (const Value& value : values) list.push_back(value);
  return list;
}
void insert_numbers(toml::table& table, const std::string& name, const std::vector<double>& values);

}  // namespace key_detail

template <class T>
template <class Accessor>
Key<T>::Key(std::string key_name, KeyRange allowed, Accessor accessor, std::string key_meaning,
            std::vector<Idle<T>> where_idle)
    : KeyInfo(std::move(key_name),
              key_detail::with_choices<key_detail::PlaceType<T, Accessor>>(std::move(allowed)),
              std::move(key_meaning), key_detail::kind_of<key_detail::PlaceType<T, Accessor>>()),
      place(key_detail::make_place<T>(std::move(accessor))),
      idle(std::move(where_idle)) {}

template <class T>
const Key<T>* find_key(const KeyTable<T>& table, std::string_view name) {
  for (const auto& key : table)
    if (key.name == name) return &key;
  return nullptr;
}

template <class T>
std::vector<KeyInfo> key_infos(const KeyTable<T>& table) {
  return {table.begin(), table.end()};
}

template <class T>
void read_key(const Key<T>& key, const toml::node& node, const std::string& file, std::size_t count,
              T& target) {
  std::visit(
      [&](const auto& place) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(place)>, ChoicePlace<T>>)
          place.set(target, text_value(key, node, file));
        else
          key_detail::read_value(key, node, file, count, place(target));
      },
      key.place);
}

template <class T>
void set_key_numbers(const Key<T>& key, const std::vector<double>& values, T& target) {
  if (key.kind == KeyKind::number) {
    std::get<std::function<double&(T&)>>(key.place)(target) = to_si(values.at(0), key.to_si);
    return;
  }
  auto& place = std::get<std::function<std::vector<double>&(T&)>>(key.place)(target);
  place.resize(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) place[j] = to_si(values[j], key.to_si);
}

template <class T>
std::vector<double> key_numbers(const Key<T>& key, const T& source) {
  T& readable = const_cast<T&>(source);  // accessors serve reading and writing alike
  if (key.kind == KeyKind::number)
    return {unit_value(std::get<std::function<double&(T&)>>(key.place)(readable), key.to_si)};
  std::vector<double> values =
      key.kind == KeyKind::list
          ? std::get<std::function<NumberList&(T&)>>(key.place)(readable).values
          : std::get<std::function<std::vector<double>&(T&)>>(key.place)(readable);
  for (double& value : values) value = unit_value(value, key.to_si);
  return values;
}

template <class T>
std::string key_text(const Key<T>& key, const T& source) {
  T& readable = const_cast<T&>(source);
  switch (key.kind) {
    case KeyKind::number:
    case KeyKind::numbers:
      return key_detail::numbers_text(key_numbers(key, source));
    case KeyKind::list:
      return key_detail::list_text(key_numbers(key, source));
    case KeyKind::names:
      return key_detail::names_text(
          std::get<std::function<std::vector<std::string>&(T&)>>(key.place)(readable));
    case KeyKind::integer:
      return std::to_string(std::get<std::function<long&(T&)>>(key.place)(readable));
    case KeyKind::boolean:
      return std::get<std::function<bool&(T&)>>(key.place)(readable) ? "true" : "false";
    default:
      return key_detail::quoted(key_detail::text_at(key, readable));
  }
}

template <class T>
void insert_key(const Key<T>& key, const T& source, toml::table& root) {
  T& readable = const_cast<T&>(source);
  const auto [section, name] = key_detail::section_of(root, key.name);
  switch (key.kind) {
    case KeyKind::number:
    case KeyKind::numbers:
      key_detail::insert_numbers(*section, name, key_numbers(key, source));
      break;
    case KeyKind::list:
      section->insert_or_assign(name, key_detail::array_of(key_numbers(key, source)));
      break;
    case KeyKind::names:
      section->insert_or_assign(
          name, key_detail::array_of(
                    std::get<std::function<std::vector<std::string>&(T&)>>(key.place)(readable)));
      break;
    case KeyKind::integer:
      section->insert_or_assign(
          name, static_cast<int64_t>(std::get<std::function<long&(T&)>>(key.place)(readable)));
      break;
    case KeyKind::boolean:
      section->insert_or_assign(name, std::get<std::function<bool&(T&)>>(key.place)(readable));
      break;
    default:
      section->insert_or_assign(name, key_detail::text_at(key, readable));
  }
}

template <class T>
std::string dump_keys(const KeyTable<T>& table, const T& source, const std::string& prefix) {
  std::string text, previous = ".";
  for (const auto& key : table) {
    text += key_detail::section_header(key.name, previous, prefix);
    text += key_detail::dump_line(key, key_text(key, source));
    previous = key.name;
  }
  return text;
}

template <class T>
bool condition_holds(const KeyTable<T>& table, std::string_view condition, const T& source) {
  const auto text = [&](std::size_t end) {
    return key_text(*find_key(table, condition.substr(0, end)), source);
  };
  if (const std::size_t end = condition.find(" = "); end != std::string_view::npos)
    return text(end) == condition.substr(end + 3);
  const std::string value = text(condition.find(' '));
  return value != "\"auto\"" && value != "[]";
}

template <class T>
std::string_view why_idle(const KeyTable<T>& table, const Key<T>& key, const T& source) {
  for (const Idle<T>& reason : key.idle)
    if (reason.holds ? reason.holds(source) : condition_holds(table, reason.why, source))
      return reason.why;
  return "";
}

template <class T>
std::string key_table_markdown(const KeyTable<T>& table, const T& defaults) {
  std::string text = "| key | unit | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const auto& key : table) text += key_detail::markdown_row(key, key_text(key, defaults));
  return text;
}

}  // namespace cagetol
