#include "mc/study/study_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mc/study/study_keys.hpp"
#include "mc/study_file/named_law.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/input/unit.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

const std::vector<std::string> kScopes = {"lot", "pocket", "noise"};

const toml::table& law_node(const toml::node& node, const std::string& key,
                            const std::string& file) {
  if (const auto* table = node.as_table()) return *table;
  throw InputError(place_of(node, file), key, shown(node),
                   std::string("this is ") + type_name(node) + ", expected a law",
                   "write { law = \"normal\", sigma = ... }");
}

// Laws are deviations. A law whose middle lies near the nominal value was surely meant as the value
// itself.
void check_deviation(const Law& law, const UncertainInput& input, const toml::table& table,
                     const std::string& key, const std::string& file) {
  const double middle = quantile(law, 0.5), nominal = input.nominal[0];
  if (!MeasuredKey{nominal}.is_size(middle)) return;
  throw InputError(place_of(table, file), key, shown(table),
                   "the law's middle is " + number_text(middle) + ", near the nominal value " +
                       number_text(nominal) + "; laws describe deviations that are added to it",
                   "subtract the nominal value from the law's parameters");
}

void set_scope(UncertainInput& input, const std::string& scope, const toml::node& node,
               const std::string& file, std::size_t pockets, MeasurementFiles& measurements) {
  const std::string key = input.key + "." + scope;
  if (scope == "pocket" && !input.per_pocket)
    throw InputError(place_of(node, file), key, shown(node),
                     "this key holds one number for the bearing, it has no pockets",
                     "use lot (drawn once per cage) or noise (drawn for each run)");
  const auto& table = law_node(node, key, file);
  auto& place = scope == "lot" ? input.lot : scope == "pocket" ? input.pocket : input.noise;
  const std::size_t before = measurements.size();
  place = read_law(table, key, unit_of(input.key).suffix, file, measurements,
                   {input.nominal[0], scope == "pocket" ? pockets : 0});
  check_deviation(*place, input, table, key, file);
  if (measurements.size() == before) return;
  input.measured = measurements.back();
  if (!input.measured->is_grouped()) return;
  if (input.lot)
    throw InputError(place_of(node, file), key, shown(node),
                     "measured cages say how cages differ, and a law of scope lot says so, too",
                     "take one of them out");
  input.lot = laws_of(*input.measured).lot;
}

/// Of a resolved study.
void read_stored_parts(const toml::node& node, const std::string& file, UncertainInput& input) {
  input.measured = MeasuredParts();
  for (const auto& [name, value] : law_node(node, input.key + ".measured", file))
    if (const auto* key = find_key(measured_keys(), name.str()))
      read_key(*key, value, file, 1, *input.measured);
  input.measured->by_cage();
}

void read_scopes(const toml::table& table, const std::string& file, std::size_t pockets,
                 UncertainInput& input, MeasurementFiles& measurements) {
  for (const auto& [name, node] : table) {
    const std::string scope(name.str());
    if (scope == "measured") read_stored_parts(node, file, input);
    if (scope == "measured" || scope == "nominal") continue;
    if (std::find(kScopes.begin(), kScopes.end(), scope) == kScopes.end()) {
      const auto law = std::find_if(law_forms().begin(), law_forms().end(), [&](const auto& form) {
        return std::count(form.required.begin(), form.required.end(), scope) > 0;
      });
      throw InputError(
          place_of(node, file), input.key + "." + scope, shown(node),
          "a distribution has no such part",
          law != law_forms().end()
              ? "add law = \"" + law->name + "\""
              : suggestion(scope, kScopes, "parts are nominal, lot, pocket, noise, or a law"));
    }
    if (const auto* law = node.as_table(); law && law->contains("nominal"))
      throw InputError(place_of(node, file), input.key + "." + scope, shown(node),
                       "the nominal value stands inside a law",
                       "put nominal = ... beside " + scope + ", not inside it");
    set_scope(input, scope, node, file, pockets, measurements);
  }
}

void read_bare_law(const toml::table& table, const std::string& file, std::size_t pockets,
                   UncertainInput& input, MeasurementFiles& measurements) {
  if (!table.contains("nominal") && input.nominal[0] != 0)
    throw InputError(place_of(table, file), input.key, shown(table),
                     "the nominal value is not given; laws describe deviations from it",
                     "add nominal = " + number_text(input.nominal[0]) + " or another value");
  for (const auto& scope : kScopes)
    if (table.contains(scope))
      throw InputError(place_of(table, file), input.key, shown(table),
                       "a law stands beside the scope \"" + scope + "\"",
                       "put the law into a scope of its own: lot = { law = ... }");
  set_scope(input, input.per_pocket ? "pocket" : "lot", table, file, pockets, measurements);
}

constexpr double kRareDraw = 1e-5;  ///< share of draws beyond what is checked
const std::string kCageBore = "cage.inner_diameter_mm", kCageOutside = "cage.outer_diameter_mm";

double deviation_at(const std::optional<Law>& law, double p) {
  return law ? quantile(*law, p) : 0;
}

/// By which the widest candidate tolerance scales the deviations of a key.
double widest_scale(const Study& study, const std::string& key) {
  double scale = 1;
  for (std::size_t d = 0; d < study.tolerance.dimensions.size(); ++d)
    if (study.tolerance.dimensions[d].key == key)
      for (const auto& candidate : study.candidates) scale = std::max(scale, candidate.scales[d]);
  return scale;
}

/// Farthest shifts of the candidates' centres, down and up.
std::pair<double, double> farthest_shifts(const Study& study, const std::string& key) {
  std::pair<double, double> shifts{0, 0};
  for (std::size_t d = 0; d < study.tolerance.dimensions.size(); ++d)
    if (study.tolerance.dimensions[d].key == key)
      for (const auto& candidate : study.candidates) {
        shifts.first = std::min(shifts.first, candidate.shift(d));
        shifts.second = std::max(shifts.second, candidate.shift(d));
      }
  return shifts;
}

}  // namespace

std::vector<UncertainInput> read_inputs(const toml::table& scene, const std::string& file,
                                        const Scene& nominal, MeasurementFiles& measurements) {
  std::map<std::string, const toml::table*> distributions;
  for (const auto& leaf : toml_leaves(scene, is_distribution))
    if (leaf.node->is_table() && !leaf.node->as_table()->empty())
      distributions[leaf.name] = leaf.node->as_table();
  std::vector<UncertainInput> inputs;
  const auto pockets = static_cast<std::size_t>(nominal.bearing.roller_count);
  for (const auto& key : scene_keys()) {
    const auto found = distributions.find(key.name);
    if (found == distributions.end()) continue;
    const toml::table& table = *found->second;
    if (key.kind != KeyKind::number && key.kind != KeyKind::numbers)
      throw InputError(place_of(table, file), key.name, shown(table),
                       "this key cannot be a distribution: it is not a number with a unit",
                       "give a plain value");
    UncertainInput input;
    input.key = key.name;
    input.unit = key.unit;
    input.per_pocket = key.kind == KeyKind::numbers;
    input.nominal = key_numbers(key, nominal);
    if (!std::isfinite(input.nominal[0]))
      throw InputError(place_of(table, file), key.name, shown(table),
                       "the nominal value is " + key_detail::numbers_text(input.nominal) +
                           "; nothing can be added to that",
                       "add nominal = ... with a number");
    if (table.contains("law"))
      read_bare_law(table, file, pockets, input, measurements);
    else
      read_scopes(table, file, pockets, input, measurements);
    if (input.lot || input.pocket || input.noise) inputs.push_back(std::move(input));
  }
  return inputs;
}

void check_drawn_range(const Study& study, const toml::table& scene, const std::string& file) {
  for (const auto& input : study.inputs) {
    const auto& key = *find_key(scene_keys(), input.key);
    const double scale = widest_scale(study, input.key);
    const auto [down, up] = farthest_shifts(study, input.key);
    const auto [smallest, largest] =
        std::minmax_element(input.nominal.begin(), input.nominal.end());
    const auto extreme = [&](double nominal, double p) {
      return nominal + (study.scale_lots ? scale : 1) * deviation_at(input.lot, p) +
             scale * deviation_at(input.pocket, p) + deviation_at(input.noise, p);
    };
    for (const double value :
         {extreme(*smallest + down, kRareDraw), extreme(*largest + up, 1 - kRareDraw)}) {
      if (in_range(key.range, value)) continue;
      const auto* node = find_node(scene, input.key);
      throw InputError(node ? place_of(*node, file) : SourcePlace{file, 0}, input.key,
                       node ? shown(*node) : "",
                       "the laws draw values like " + number_text(value) +
                           ", outside the range of this key: " + range_text(key),
                       "narrow the laws or use truncated_normal");
    }
  }
}

double thickness_scatter(const Study& study) {
  const double thickness =
      1e3 * (study.scene.cage.outer_diameter - study.scene.cage.inner_diameter);
  double sum = 0;
  for (const auto& input : study.inputs) {
    if (input.key != kCageBore && input.key != kCageOutside) continue;
    const double scale = study.scale_lots ? widest_scale(study, input.key) : 1;
    const auto [down, up] = farthest_shifts(study, input.key);
    double farthest = 0;
    for (const double p : {kRareDraw, 1 - kRareDraw})
      farthest = std::max(
          farthest, std::abs(scale * deviation_at(input.lot, p) + deviation_at(input.noise, p)) +
                        std::max(-down, up));
    sum += farthest;
  }
  return sum / thickness;
}

void check_flexible_cage(const Study& study, const toml::table& scene, const std::string& file) {
  static const std::set<std::string> tabulated = {
      "cage.width_mm", "cage.land_offset_mm", "cage.young_GPa",     "cage.poisson",
      "cage.mass_kg",  "cage.density_kg_m3",  "cage.temperature_C", "cage.swelling_percent"};
  if (!is_flexible(study.scene)) return;
  if (const double share = thickness_scatter(study); share > kThicknessShare) {
    const bool outside = find_node(scene, kCageOutside) &&
                         std::any_of(study.inputs.begin(), study.inputs.end(),
                                     [](const auto& input) { return input.key == kCageOutside; });
    const std::string key = outside ? kCageOutside : kCageBore;
    const auto* node = find_node(scene, key);
    throw InputError(node ? place_of(*node, file) : SourcePlace{file, 0}, key,
                     node ? shown(*node) : "",
                     "bore and outside of the flexible cage deviate together by up to " +
                         number_text(std::round(1e4 * share) / 100) +
                         " % of its thickness; its elasticity is tabulated for nominal diameters, "
                         "which is right for up to " +
                         number_text(100 * kThicknessShare) + " %",
                     "narrow the laws (uniform and truncated_normal have ends), or set cage.model "
                     "= \"rigid\"");
  }
  const bool grows = study.scene.temperature.growth;
  for (const auto& input : study.inputs) {
    const bool warms = input.key == "lubrication.temperature_C" &&
                       std::isnan(study.scene.cage.temperature) &&
                       (grows || softens(study.scene.cage.material));
    const bool expands =
        grows && (input.key == "cage.expansion_um_m_K" || input.key == "temperature.reference_C");
    if (!warms && !expands && !tabulated.contains(input.key)) continue;
    const auto* node = find_node(scene, input.key);
    throw InputError(node ? place_of(*node, file) : SourcePlace{file, 0}, input.key,
                     node ? shown(*node) : "",
                     "this cannot be a distribution while cage.model = \"flexible\": the elastic "
                     "cage is tabulated once for its nominal value, only its pockets and diameters "
                     "may deviate",
                     "give a plain number (one study each for several), or set cage.model = "
                     "\"rigid\"");
  }
}

InputScope find_input_scope(const std::vector<UncertainInput>& inputs, const std::string& name) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (name == inputs[i].key + ":lot" && inputs[i].lot) return {static_cast<long>(i), false};
    if (name == inputs[i].key + ":pocket" && inputs[i].pocket) return {static_cast<long>(i), true};
  }
  return {};
}

const KeyInfo& info_of(const std::vector<KeyInfo>& known, const std::string& name) {
  return *std::find_if(known.begin(), known.end(),
                       [&](const auto& key) { return key.name == name; });
}

std::vector<const toml::table*> table_entries(const toml::table& root, const std::string& name,
                                              const std::vector<KeyInfo>& known,
                                              const std::string& file) {
  const auto* node = find_node(root, name);
  if (!node) return {};
  const auto* array = node->as_array();
  std::vector<const toml::table*> entries;
  if (array)
    for (const auto& element : *array)
      if (const auto* table = element.as_table()) entries.push_back(table);
  if (!array || entries.size() != array->size())
    throw InputError(place_of(*node, file), name, shown(*node),
                     std::string("this is ") + type_name(*node) + ", expected a list of tables",
                     "write each one below a line [[" + name + "]]");
  for (const auto* entry : entries)
    for (const auto& [key, value] : *entry) {
      const TomlLeaf leaf{name + "." + std::string(key.str()), &value};
      if (std::none_of(known.begin(), known.end(),
                       [&](const auto& info) { return info.name == leaf.name; }))
        throw unknown_key(leaf, file, known);
    }
  return entries;
}

std::vector<Correlation> read_correlations(const toml::table& root, const std::string& file,
                                           const std::vector<UncertainInput>& inputs) {
  std::vector<std::string> names;
  for (const auto& input : inputs) {
    if (input.lot) names.push_back(input.key + ":lot");
    if (input.pocket) names.push_back(input.key + ":pocket");
  }
  std::vector<Correlation> correlations;
  for (const auto* entry : table_entries(root, "correlation", correlation_keys(), file)) {
    const auto* between = entry->get_as<toml::array>("between");
    const auto* rho = entry->get("rho");
    if (!between || between->size() != 2 || !(*between)[0].is_string() ||
        !(*between)[1].is_string() || !rho)
      throw InputError(place_of(*entry, file), "correlation", shown(*entry),
                       "a correlation needs two inputs and rho",
                       "write between = [\"KEY:lot\", \"KEY:lot\"] and rho = ...");
    Correlation correlation{
        *(*between)[0].value<std::string>(), *(*between)[1].value<std::string>(),
        number_value(info_of(correlation_keys(), "correlation.rho"), *rho, file)};
    for (const auto& name : {correlation.first, correlation.second})
      if (find_input_scope(inputs, name).input < 0)
        throw InputError(
            place_of(*between, file), "correlation.between", shown(*between),
            "the study has no uncertain input \"" + name + "\"",
            names.empty() ? "give the scene distributions first" : suggestion(name, names));
    const auto first = find_input_scope(inputs, correlation.first);
    const auto second = find_input_scope(inputs, correlation.second);
    if (first.pocket != second.pocket || first.input == second.input)
      throw InputError(place_of(*between, file), "correlation.between", shown(*between),
                       "a correlation joins two different inputs of the same scope",
                       "name two keys, both with :lot or both with :pocket");
    for (const Correlation& other : correlations)
      if (const auto pair = std::minmax(correlation.first, correlation.second);
          pair == std::minmax(other.first, other.second))
        throw InputError(place_of(*between, file), "correlation.between", shown(*between),
                         "these two inputs have a correlation already", "keep one of the two");
    for (const auto& scope : {first, second})
      if (inputs[static_cast<std::size_t>(scope.input)].draws_cages())
        throw InputError(place_of(*between, file), "correlation.between", shown(*between),
                         "one is drawn as whole measured cages, whatever they have in common",
                         "take the correlation out, or draw from laws: fitted = true");
    correlations.push_back(std::move(correlation));
  }
  return correlations;
}

}  // namespace cagetol
