#include <sstream>
#include "src/input/key_table.hpp"
#include "src/outcome.hpp"
#include "src/quantities/quantity_table.hpp"
namespace cagetol {
const std::vector<Quantity>& quantity_table() {
  static const std::vector<Quantity> t{{"a_um", "um", "a"}, {"b_N", "N", "b"}};
  return t;
}
const std::vector<RunField>& run_fields() {
  static const std::vector<RunField> t{
      {"simulated_s", "s", "x"}, {"steps", "-", "y"}, {"wall_s", "s", "z"}};
  return t;
}
std::vector<double> run_values(const RunRecord& r) {
  return {r.simulated_s, r.steps, r.wall_s};
}
std::string shown(const toml::node& n) {
  std::ostringstream o;
  n.visit([&](auto& v) { o << v; });
  return o.str();
}
static void walk(const toml::table& t, std::string p, std::vector<TomlLeaf>& l) {
  for (auto&& [k, v] : t) {
    std::string n = p + std::string(k.str());
    if (v.is_table())
      walk(*v.as_table(), n + ".", l);
    else
      l.push_back({n, &v});
  }
}
std::vector<TomlLeaf> toml_leaves(const toml::table& r,
                                  const std::function<bool(const toml::table&)>&) {
  std::vector<TomlLeaf> l;
  walk(r, "", l);
  return l;
}
}  // namespace cagetol
