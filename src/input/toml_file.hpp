// Reads TOML files: parses them with readable messages, applies settings (--set) and lists all
// leaves with their places in the file.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

/// The text of the file `path`. Throws InputError for a missing, unreadable or absurdly large file.
std::string read_text_file(const std::string& path);

/// Parses the TOML file `path`. Throws InputError with file and line for unreadable files and
/// syntax errors.
toml::table read_toml(const std::string& path);

/// Parses TOML text; `name` stands for the file in messages.
toml::table parse_toml(std::string_view text, const std::string& name);

/// Applies "dotted.key=value" (value in TOML syntax; a bare word is taken as a string). Throws
/// InputError.
void apply_setting(toml::table& root, const std::string& setting);

/// The dotted key of a setting "dotted.key=value". Throws InputError where there is none.
std::string setting_key(const std::string& setting);

/// Merges `overrides` into `base`, table by table. A table for which `stop_at` is true counts as a
/// value and replaces the old value as a whole.
void merge_tables(toml::table& base, toml::table&& overrides,
                  const std::function<bool(const toml::table&)>& stop_at);

/// One leaf of a TOML document: its dotted name and its node. Arrays are leaves, and so are tables
/// for which `stop_at` is true (distributions) and empty tables: every entry of a file is either
/// read or reported as an error.
struct TomlLeaf {
  std::string name;
  const toml::node* node;
};
std::vector<TomlLeaf> toml_leaves(const toml::table& root,
                                  const std::function<bool(const toml::table&)>& stop_at = {});

/// The node at a dotted name, or nullptr.
const toml::node* find_node(const toml::table& root, std::string_view name);

/// Place of a node: the file that it was read from, or "--set" for a setting; `file` if neither is
/// known.
SourcePlace place_of(const toml::node& node, const std::string& file);

/// A node's value as TOML text for messages, shortened where it is long.
std::string shown(const toml::node& node);

/// "a text", "a whole number", ...: what a node holds, for messages.
const char* type_name(const toml::node& node);

}  // namespace cagetol
