#include "mc/study/document.hpp"

#include "mc/study/study_keys.hpp"

namespace cagetol {

std::map<std::string, std::string> read_document(const std::string& file) {
  const std::string section = "document.";
  const toml::table root = read_toml(file);
  std::map<std::string, std::string> texts;
  for (const TomlLeaf& leaf : toml_leaves(root)) {
    if (!leaf.name.starts_with(section)) continue;
    const auto* key = find_key(study_keys(), leaf.name);
    if (!key) throw unknown_key(leaf, file, key_infos(study_keys()));
    texts[leaf.name.substr(section.size())] = text_value(*key, *leaf.node, file);
  }
  if (texts.empty())
    throw InputError(
        {file, 0}, "document", "", "the file has no such section, or an empty one",
        "write [document] and below it customer = \"...\"; inputs/KEYS.md has its keys");
  return texts;
}

}  // namespace cagetol
