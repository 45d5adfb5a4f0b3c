#include "src/reading/unmodelled_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

struct Unmodelled {
  std::array<std::string_view, 3> words;  ///< of a key's last part
  std::string_view what, remedy;
};
constexpr std::array kUnmodelled = {
    Unmodelled{{"row", "rows", "double"},
               "a bearing has one row of rollers: double-row bearings are not modelled",
               "simulate one row by itself, under its share of the load, and leave the key out"},
    Unmodelled{{"split", "segments", "segmented"},
               "a cage is one closed ring: split and segmented cages are not modelled",
               "leave the key out; the scene then has a cage without a gap"},
};

}  // namespace

void refuse_unmodelled_key(const TomlLeaf& leaf, const std::string& file) {
  const std::string last = "_" + leaf.name.substr(leaf.name.rfind('.') + 1) + "_";
  for (const Unmodelled& of : kUnmodelled)
    for (const std::string_view word : of.words)
      if (last.find(fmt::format("_{}_", word)) != std::string::npos)
        throw InputError(place_of(*leaf.node, file), leaf.name, "", std::string(of.what),
                         std::string(of.remedy));
}

}  // namespace cagetol
