#include "mc/study/study_limits.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "distributions/iso286.hpp"
#include "mc/study/study_inputs.hpp"
#include "mc/study/study_keys.hpp"
#include "src/input/former_names.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostCandidates = 1000;

Limit read_limit(const toml::table& entry, const std::string& file,
                 const std::vector<std::string>& labels) {
  const auto info = [](const std::string& name) -> const KeyInfo& {
    return info_of(limit_keys(), "limit." + name);
  };
  const auto missing = [&](const std::string& what, const std::string& remedy) {
    return InputError(place_of(entry, file), "limit", shown(entry), what, remedy);
  };
  Limit limit;
  const auto* quantity = entry.get("quantity");
  if (!quantity)
    throw missing("the limit names no quantity",
                  "add quantity = \"...\", a key of `simulate --json`");
  limit.quantity = text_value(info("quantity"), *quantity, file);
  if (const auto* node = entry.get("operating_point"))
    limit.quantity =
        labelled_name(limit.quantity, text_value(info("operating_point"), *node, file));
  if (labelled_index(limit.quantity, labels) < 0)
    throw no_such_quantity(*quantity, "limit.quantity", limit.quantity, file, labels);
  if (const auto* node = entry.get("min")) limit.minimum = number_value(info("min"), *node, file);
  if (const auto* node = entry.get("max")) limit.maximum = number_value(info("max"), *node, file);
  if (const auto* node = entry.get("max_at_minimum_loads"))
    limit.minimum_loads = number_value(info("max_at_minimum_loads"), *node, file);
  if (!limit.minimum && !limit.maximum && !limit.minimum_loads)
    throw missing("the limit has neither min nor max", "add min = ..., max = ..., or both");
  if (limit.minimum && limit.maximum && *limit.minimum > *limit.maximum)
    throw missing("min is larger than max: nothing can meet this limit", "correct one of the two");
  const auto* source = entry.get("source");
  if (source) limit.source = text_value(info("source"), *source, file);
  if (limit.source.empty())
    throw missing("the limit does not say where it comes from",
                  "add source = \"...\": a standard, a drawing, a test, an assumption");
  if (const auto* node = entry.get("cage_revolutions"))
    limit.cage_revolutions = number_value(info("cage_revolutions"), *node, file);
  return limit;
}

bool has_maximum(const Limit& limit) {
  return limit.maximum || limit.minimum_loads;
}

const UncertainInput* find_input(const std::vector<UncertainInput>& inputs,
                                 const std::string& key) {
  for (const auto& input : inputs)
    if (input.key == key) return &input;
  return nullptr;
}

/// Of a candidate that is none: what it may be meant to be.
InputError no_tolerance(const toml::node& element, const std::string& text,
                        const std::string& file) {
  const std::string letters = text.substr(0, text.find_first_of("0123456789 ,.+-")),
                    meant =
                        "IT" + text.substr(std::min(text.find_first_of("0123456789"), text.size()));
  const bool ends = text.find('/') != std::string::npos, grade = grade_number(meant).has_value(),
             other = grade && !letters.empty() && letters != "it" && letters != "IT";
  return InputError(
      place_of(element, file), "tolerance.dimension.candidates", shown(element),
      ends    ? "these are no deviations in mm, the upper one first and above the lower one"
      : other ? "the fundamental deviation " + letters + " is not known here"
              : "this is neither an ISO 286 grade nor a tolerance",
      ends ? "write \"+0.10/0\" or \"+0.05/-0.02\""
      : other
          ? "known are H (from the nominal size upwards), js, JS and IT (about it); give others "
            "as deviations in mm, \"+0.05/-0.02\""
      : grade ? "did you mean \"" + meant + "\"?"
              : "give a grade like \"IT9\" or a full width in mm above 0, a class like \"H9\" or "
                "deviations like \"+0.10/0\"");
}

std::vector<std::string> candidate_names(const toml::node* node, const toml::table& entry,
                                         const std::string& file) {
  const auto* array = node ? node->as_array() : nullptr;
  const bool single = node && !array;
  if (!array || array->empty())
    throw InputError(
        place_of(node ? *node : entry, file), "tolerance.dimension.candidates",
        node ? shown(*node) : "", single ? "this is no array" : "there are no candidate tolerances",
        single ? "write candidates = [" + shown(*node) + "]"
               : "give candidates = [\"IT9\", \"IT10\"] or full widths in mm, [0.05, 0.1]");
  std::vector<std::string> names;
  for (const auto& element : *array) {
    const auto text = element.value<std::string>();
    const auto width = element.value<double>();
    const bool zone = text && (tolerance_class(*text) || deviations_of(*text));
    // std::stod, which reads the name again, takes subnormal numbers for errors.
    const bool usable = element.is_number() && width && std::isnormal(*width) && *width > 0;
    if (!zone && !usable) throw no_tolerance(element, text.value_or(""), file);
    names.push_back(zone ? *text : number_text(*width));
    if (std::find(names.begin(), names.end() - 1, names.back()) != names.end() - 1)
      throw InputError(place_of(element, file), "tolerance.dimension.candidates", shown(element),
                       "this candidate is named twice", "name each once");
  }
  return names;
}

std::vector<double> read_centres(const toml::node* node, const UncertainInput& input,
                                 const std::string& file) {
  std::vector<double> centres;
  if (!node) return centres;
  const auto refuse = [&](const toml::node& where, const char* why, const char* remedy) {
    return InputError(place_of(where, file), "tolerance.dimension.centres", shown(where), why,
                      remedy);
  };
  const auto* array = node->as_array();
  if (!array || array->empty())
    throw refuse(*node, "there are no centres",
                 "give nominal values in the unit of the key, centres = [7.6, 7.65, 7.7]");
  if (std::any_of(input.nominal.begin(), input.nominal.end(),
                  [&](double value) { return value != input.nominal.front(); }))
    throw refuse(*node, "the nominal values of the pockets differ: there is no centre to move",
                 "give the key one nominal value, or leave out centres");
  for (const auto& element : *array) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value))
      throw refuse(element, "this is no number", "give nominal values in the unit of the key");
    if (!centres.empty() && *value <= centres.back())
      throw refuse(element, "centres must ascend", "sort them and name each once");
    centres.push_back(*value);
  }
  return centres;
}

CostTable cost_table(const toml::node* node, const std::string& file) {
  CostTable table;
  if (!node) return table;
  const auto* rows = node->as_array();
  for (std::size_t i = 0; rows && i < rows->size(); ++i) {
    const auto* row = (*rows)[i].as_array();
    const auto width = row && row->size() == 2 ? (*row)[0].value<double>() : std::nullopt;
    const auto cost = row && row->size() == 2 ? (*row)[1].value<double>() : std::nullopt;
    if (!width || !cost || !(*width > 0) || !(*cost >= 0) || !std::isfinite(*width + *cost) ||
        (!table.empty() && *width <= table.back().first)) {
      table.clear();
      break;
    }
    table.emplace_back(*width, *cost);
  }
  if (table.size() < 2)
    throw InputError(
        place_of(*node, file), "tolerance.dimension.cost_table", shown(*node),
        "this is no table of costs",
        "give two or more [tolerance width in mm, cost], widths above 0 and ascending: "
        "[[0.036, 9.5], [0.09, 4.0]]");
  return table;
}

// A nominal size in mm, whatever unit of length its key has.
double nominal_mm(const UncertainInput& input) {
  const double mean = std::accumulate(input.nominal.begin(), input.nominal.end(), 0.0) /
                      static_cast<double>(input.nominal.size());
  return from_si(to_si(mean, unit_of(input.key).to_si), 1e-3);
}

/// A tolerance wider than the size itself is one in other units.
void require_narrower(double width, const UncertainInput& input, const SourcePlace& place,
                      const std::string& key) {
  const double size = nominal_mm(input);
  if (size <= 0 || width <= size) return;
  throw InputError(
      place, "tolerance.dimension." + key, number_text(width),
      "this tolerance is wider than the size itself, " + number_text(size) + " mm",
      "widths are in mm: " + number_text(width) + " um are " + number_text(width / 1000));
}

// A table of costs says nothing beyond its ends.
void check_costs(const std::vector<ToleranceDimension>& dimensions,
                 const std::vector<Candidate>& candidates, const SourcePlace& place) {
  for (std::size_t d = 0; d < dimensions.size(); ++d)
    for (const Candidate& candidate : candidates) {
      const CostTable& table = dimensions[d].cost;
      if (table.empty()) break;
      const double width = candidate.tolerance_widths_mm[d];
      if (width < table.front().first || width > table.back().first)
        throw InputError(place, "tolerance.dimension.cost_table", number_text(width),
                         "the candidate tolerance of " + dimensions[d].key + " of " +
                             number_text(width) + " mm lies outside the table of costs, " +
                             number_text(table.front().first) + " to " +
                             number_text(table.back().first) + " mm",
                         "extend the table, or leave the candidate out");
    }
}

}  // namespace

InputError no_such_quantity(const toml::node& node, const std::string& key,
                            const std::string& quantity, const std::string& file,
                            const std::vector<std::string>& labels) {
  if (const auto [plain, label] = labelled_key(quantity);
      !label.empty() && quantity_index(plain) >= 0) {
    std::string known;
    for (const std::string& name : labels) known += (known.empty() ? "" : ", ") + name;
    return InputError(place_of(node, file), key, shown(node),
                      "no phase and no operating point is called '" + label + "'",
                      known.empty() ? "leave out @" + label +
                                          ", or name phases ([[scene.phase]]) or operating points"
                                    : "choose from " + known);
  }
  if (const FormerName* former = former_name(labelled_key(quantity).key))
    return InputError(place_of(node, file), key, shown(node), former_problem(*former),
                      former_remedy(*former));
  std::vector<std::string> names;
  for (const auto& known : quantity_table()) names.emplace_back(known.key);
  for (const OperatingRow& row : operating_rows())
    if (quantity == row.key)
      return InputError(place_of(node, file), key, shown(node),
                        "this belongs to the operating point: no run changes it",
                        "read it in `cagetol check`, and leave the limit out");
  return InputError(place_of(node, file), key, shown(node), "there is no such quantity of interest",
                    suggestion(quantity, names, "`cagetol quantities` lists them all"));
}

std::vector<Limit> read_limits(const toml::table& root, const std::string& file,
                               const std::vector<std::string>& labels) {
  std::vector<Limit> limits;
  for (const auto* entry : table_entries(root, "limit", limit_keys(), file)) {
    limits.push_back(read_limit(*entry, file, labels));
    for (auto other = limits.begin(); other + 1 != limits.end(); ++other)
      if (const Limit& own = limits.back();
          other->quantity == own.quantity &&
          ((has_maximum(*other) && has_maximum(own)) || (other->minimum && own.minimum)))
        throw InputError(place_of(*entry, file), "limit.quantity", own.quantity,
                         "another limit gives this quantity a value on the same side",
                         "keep one of the two, or name the operating point of each "
                         "(quantity = \"KEY@POINT\")");
  }
  return limits;
}

std::vector<ToleranceDimension> read_dimensions(const toml::table& root, const std::string& file,
                                                const std::vector<UncertainInput>& inputs) {
  std::vector<std::string> names;
  for (const auto& input : inputs)
    if (unit_of(input.key).dimension == "length" && (input.lot || input.pocket))
      names.push_back(input.key);
  std::vector<ToleranceDimension> dimensions;
  for (const auto* entry : table_entries(root, "tolerance.dimension", dimension_keys(), file)) {
    const auto* key = entry->get("key");
    const auto* width = entry->get("tolerance_width_mm");
    if (!key || !width)
      throw InputError(
          place_of(*entry, file), "tolerance.dimension", shown(*entry),
          key ? "the tolerance to which the laws belong is missing" : "the key is missing",
          "write key = \"cage.pocket_width_mm\" and tolerance_width_mm = 0.1");
    ToleranceDimension dimension;
    dimension.key = text_value(info_of(dimension_keys(), "tolerance.dimension.key"), *key, file);
    dimension.tolerance_width_mm = number_value(
        info_of(dimension_keys(), "tolerance.dimension.tolerance_width_mm"), *width, file);
    const auto* input = find_input(inputs, dimension.key);
    const bool scalable =
        input && unit_of(input->key).dimension == "length" && (input->lot || input->pocket);
    if (!scalable)
      throw InputError(place_of(*key, file), "tolerance.dimension.key", shown(*key),
                       "this is no length of the scene that varies by lot or pocket in this study",
                       find_key(scene_keys(), dimension.key) || names.empty()
                           ? "give the key a law below [scene]; --set " + dimension.key +
                                 ".nominal=... keeps a law that a plain number takes away"
                           : suggestion(dimension.key, names));
    require_narrower(dimension.tolerance_width_mm, *input, place_of(*width, file),
                     "tolerance_width_mm");
    for (const auto& other : dimensions)
      if (other.key == dimension.key)
        throw InputError(place_of(*key, file), "tolerance.dimension.key", shown(*key),
                         "this key has a tolerance.dimension already", "join the two");
    dimension.candidates = candidate_names(entry->get("candidates"), *entry, file);
    dimension.centres = read_centres(entry->get("centres"), *input, file);
    dimension.cost = cost_table(entry->get("cost_table"), file);
    if (!dimensions.empty() && dimension.cost.empty() != dimensions.front().cost.empty())
      throw InputError(place_of(*entry, file), "tolerance.dimension", shown(*entry),
                       "one dimension has a cost and another has none: no total can be compared",
                       "give every dimension a cost, or none");
    dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

std::vector<Candidate> make_candidates(const Study& study, const toml::table& root,
                                       const std::string& file) {
  const auto& dimensions = study.tolerance.dimensions;
  if (dimensions.empty()) return {};
  const auto entries = table_entries(root, "tolerance.dimension", dimension_keys(), file);
  std::vector<Candidate> candidates = {Candidate{}};
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    const auto& dimension = dimensions[d];
    const auto place = place_of(*entries[d], file);
    const UncertainInput& input = *find_input(study.inputs, dimension.key);
    const double nominal = input.nominal.front();
    const auto centres =
        dimension.centres.empty() ? std::vector<double>{nominal} : dimension.centres;
    if (candidates.size() * dimension.candidates.size() * centres.size() > kMostCandidates)
      throw InputError(
          place, "tolerance.dimension", "",
          "more than " + std::to_string(kMostCandidates) + " combinations of candidates",
          "name fewer candidates for each dimension");
    std::vector<Candidate> longer;
    for (const auto& shorter : candidates)
      for (const auto& name : dimension.candidates) {
        Candidate candidate = shorter;
        double width = 0;
        const auto deviations = deviations_of(name);
        if (const auto of_class = tolerance_class(name)) {
          if (!is_size(dimension.key))
            throw InputError(place, "tolerance.dimension.candidates", name,
                             "ISO 286 grades sizes, and " + dimension.key +
                                 " is no diameter, width or length in mm",
                             "give full widths in mm, such as 0.01");
          try {
            width = grade_width_um(of_class->grade, nominal_mm(input)) / 1000;
          } catch (const std::invalid_argument& error) {
            throw InputError(place, "tolerance.dimension.candidates", name, error.what(),
                             "choose another grade or give the full width in mm");
          }
        } else {
          width = deviations ? deviations->upper - deviations->lower : std::stod(name);
        }
        require_narrower(width, input, place, "candidates");
        candidate.middles.push_back(
            from_si(to_si(zone_middle(name, width), 1e-3), unit_of(dimension.key).to_si));
        candidate.grades.push_back(deviations || tolerance_class(name) ? name : "");
        candidate.tolerance_widths_mm.push_back(width);
        candidate.scales.push_back(width / dimension.tolerance_width_mm);
        for (const double centre : centres) {
          longer.push_back(candidate);
          longer.back().shifts.push_back(centre - nominal);
        }
      }
    candidates = std::move(longer);
  }
  check_costs(dimensions, candidates, place_of(*entries[0], file));
  return candidates;
}

}  // namespace cagetol
