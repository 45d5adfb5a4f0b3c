#include "mc/law_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "mc/measurement_csv.hpp"
#include "src/input/key_table.hpp"

namespace cagetol {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Every parameter that some law has.
struct Parameters {
  std::string law, file, column, decimal = ".";
  double mean = 0, sigma = 0, lower = -kInfinity, mode = 0, upper = kInfinity;
  double log_mean = 0, log_sigma = 0, shift = 0, alpha = 1, beta = 1, shape = 1, scale = 1;
  double cp = 1, cpk = std::numeric_limits<double>::quiet_NaN();
  bool centred = false;
  std::vector<double> edges, weights, values;
};

// clang-format off
#define AT(member) [](Parameters& p) -> auto& { return p.member; }
const KeyTable<Parameters>& parameter_keys() {
  static const KeyTable<Parameters> keys = {
      {"law", any_value(), AT(law), "name of the law"},
      {"mean", any_value(), AT(mean), "mean deviation from the nominal value"},
      {"sigma", at_least(0), AT(sigma), "standard deviation"},
      {"lower", any_value(), AT(lower), "lower end"},
      {"mode", any_value(), AT(mode), "most likely deviation"},
      {"upper", any_value(), AT(upper), "upper end"},
      {"log_mean", any_value(), AT(log_mean), "mean of the logarithm"},
      {"log_sigma", at_least(0), AT(log_sigma), "standard deviation of the logarithm"},
      {"shift", any_value(), AT(shift), "where the law begins"},
      {"alpha", above(0), AT(alpha), "first shape parameter"},
      {"beta", above(0), AT(beta), "second shape parameter"},
      {"shape", above(0), AT(shape), "shape parameter"},
      {"scale", above(0), AT(scale), "scale parameter"},
      {"cp", above(0), AT(cp), "capability index Cp of the limits"},
      {"cpk", any_value(), AT(cpk), "capability index Cpk towards the upper limit"},
      {"edges", any_value(), AT(edges), "ends of the bins, ascending"},
      {"weights", at_least(0), AT(weights), "weight of each bin"},
      {"values", any_value(), AT(values), "measured deviations"},
      {"file", any_value(), AT(file), "CSV file of measurements, beside this file"},
      {"column", any_value(), AT(column), "column of the CSV file"},
      {"decimal", one_of({".", ","}), AT(decimal), "decimal mark of the numbers in the CSV file"},
      {"centred", any_value(), AT(centred), "subtract the mean of the measurements"},
  };
  return keys;
}
#undef AT

// A law's name, the parameters it must have, those it may have, and how it is made.
struct LawForm {
  std::string name;
  std::vector<std::string> required, optional;
  Law (*make)(const Parameters&);
};

const std::vector<LawForm>& law_forms() {
  static const std::vector<LawForm> forms = {
      {"normal", {"sigma"}, {"mean"}, [](const Parameters& p) -> Law { return Normal{p.mean, p.sigma}; }},
      {"truncated_normal", {"sigma"}, {"mean", "lower", "upper"}, [](const Parameters& p) -> Law { return TruncatedNormal{p.mean, p.sigma, p.lower, p.upper}; }},
      {"uniform", {"lower", "upper"}, {}, [](const Parameters& p) -> Law { return Uniform{p.lower, p.upper}; }},
      {"triangular", {"lower", "mode", "upper"}, {}, [](const Parameters& p) -> Law { return Triangular{p.lower, p.mode, p.upper}; }},
      {"lognormal", {"log_mean", "log_sigma"}, {"shift"}, [](const Parameters& p) -> Law { return Lognormal{p.log_mean, p.log_sigma, p.shift}; }},
      {"beta", {"alpha", "beta", "lower", "upper"}, {}, [](const Parameters& p) -> Law { return Beta{p.alpha, p.beta, p.lower, p.upper}; }},
      {"weibull", {"shape", "scale"}, {"shift"}, [](const Parameters& p) -> Law { return Weibull{p.shape, p.scale, p.shift}; }},
      {"gamma", {"shape", "scale"}, {"shift"}, [](const Parameters& p) -> Law { return Gamma{p.shape, p.scale, p.shift}; }},
      {"histogram", {"edges", "weights"}, {}, [](const Parameters& p) -> Law { return Histogram{p.edges, p.weights}; }},
      {"empirical", {}, {"file", "column", "decimal", "centred", "values"}, [](const Parameters& p) -> Law { return make_empirical(p.values); }},
      {"capability", {"lower", "upper", "cp"}, {"cpk"}, [](const Parameters& p) -> Law { return Capability{p.lower, p.upper, p.cp, std::isnan(p.cpk) ? std::nullopt : std::optional(p.cpk)}; }},
  };
  return forms;
}
// clang-format on

const LawForm& form_of(const toml::table& table, const std::string& key, const std::string& file) {
  std::vector<std::string> names;
  for (const auto& form : law_forms()) names.push_back(form.name);
  const auto* node = table.get("law");
  if (!node)
    throw InputError(
        place_of(table, file), key, shown(table), "a distribution needs a law",
        "add law = \"normal\" or another of: " + fmt::format("{}", fmt::join(names, ", ")));
  const auto name = node->value<std::string>();
  for (const auto& form : law_forms())
    if (name == form.name) return form;
  throw InputError(place_of(*node, file), key + ".law", shown(*node), "there is no such law",
                   (name ? "did you mean " + nearest_name(*name, names) + "? " : std::string()) +
                       "laws are: " + fmt::format("{}", fmt::join(names, ", ")));
}

// The parameter's key under the law's full name, so that messages name it whole.
Key<Parameters> named_below(Key<Parameters> parameter, const std::string& key) {
  parameter.name = key + "." + parameter.name;
  return parameter;
}

void read_measurements(const toml::table& table, const std::string& key, const std::string& unit,
                       const std::string& file, MeasurementFiles& measurements,
                       Parameters& parameters) {
  const bool from_file = table.contains("file");
  if (from_file == table.contains("values"))
    throw InputError(place_of(table, file), key, shown(table),
                     from_file ? "both file and values are given" : "no measurements are given",
                     "give file = \"parts.csv\" and column = \"...\", or values = [...]");
  for (const char* of_file : {"column", "decimal"})
    if (!from_file && table.contains(of_file))
      throw InputError(place_of(*table.get(of_file), file), key + "." + of_file,
                       shown(*table.get(of_file)), "this belongs to a file, but values are given",
                       "take it out, or give file = \"parts.csv\" in place of values");
  if (from_file) {
    if (!table.contains("column"))
      throw InputError(place_of(table, file), key, shown(table), "the column is not named",
                       "add column = \"...\", a name from the file's header line");
    const auto source = place_of(*table.get("file"), file).file;
    const auto path = (std::filesystem::path(source).parent_path() / parameters.file).string();
    std::string text;
    try {
      text = read_text_file(path);
    } catch (const InputError& error) {
      throw InputError(place_of(*table.get("file"), file), key + ".file", shown(*table.get("file")),
                       error.what(),
                       "give the path of a CSV file relative to the file that names it");
    }
    parameters.values =
        csv_column(text, path, {parameters.column, unit, parameters.decimal == ","});
    measurements.emplace_back(parameters.file, text);
  }
  if (parameters.centred && !parameters.values.empty()) {
    const double mean = std::accumulate(parameters.values.begin(), parameters.values.end(), 0.0) /
                        static_cast<double>(parameters.values.size());
    for (double& value : parameters.values) value -= mean;
  }
}

void read_parameters(const toml::table& table, const LawForm& form, const std::string& key,
                     const std::string& file, Parameters& parameters) {
  std::vector<std::string> names = form.required;
  names.insert(names.end(), form.optional.begin(), form.optional.end());
  for (const auto& [name, node] : table) {
    const std::string parameter(name.str());
    if (parameter == "law" || parameter == "nominal") continue;
    if (std::find(names.begin(), names.end(), parameter) == names.end())
      throw InputError(place_of(node, file), key + "." + parameter, shown(node),
                       "the law \"" + form.name + "\" has no such parameter",
                       "did you mean " + nearest_name(parameter, names) +
                           "? its parameters are: " + fmt::format("{}", fmt::join(names, ", ")));
    const auto* array = node.as_array();
    read_key(named_below(*find_key(parameter_keys(), parameter), key), node, file,
             array ? array->size() : 1, parameters);
  }
  for (const auto& name : form.required)
    if (!table.contains(name))
      throw InputError(place_of(table, file), key, shown(table),
                       "the law \"" + form.name + "\" needs " + name + " (" +
                           find_key(parameter_keys(), name)->meaning + ")",
                       "add " + name + " = ...");
}

}  // namespace

Law read_law(const toml::table& table, const std::string& key, const std::string& unit,
             const std::string& file, MeasurementFiles& measurements) {
  const auto& form = form_of(table, key, file);
  Parameters parameters;
  read_parameters(table, form, key, file, parameters);
  if (form.name == "empirical") read_measurements(table, key, unit, file, measurements, parameters);
  Law law = form.make(parameters);
  try {
    check(law);
  } catch (const std::invalid_argument& error) {
    // The distributions room writes "reason; remedy".
    const std::string text = error.what();
    const auto cut = text.find("; ");
    throw InputError(
        place_of(table, file), key, shown(table), text.substr(0, cut),
        cut == std::string::npos ? "correct the parameters of the law" : text.substr(cut + 2));
  }
  return law;
}

namespace {

toml::array array_of(const std::vector<double>& values) {
  toml::array array;
  for (const double value : values) array.push_back(value);
  return array;
}

void add_parameters(toml::table& t, const Normal& law) {
  t.insert("mean", law.mean);
  t.insert("sigma", law.sigma);
}
void add_parameters(toml::table& t, const TruncatedNormal& law) {
  t.insert("mean", law.mean);
  t.insert("sigma", law.sigma);
  if (std::isfinite(law.lower)) t.insert("lower", law.lower);
  if (std::isfinite(law.upper)) t.insert("upper", law.upper);
}
void add_parameters(toml::table& t, const Uniform& law) {
  t.insert("lower", law.lower);
  t.insert("upper", law.upper);
}
void add_parameters(toml::table& t, const Triangular& law) {
  t.insert("lower", law.lower);
  t.insert("mode", law.mode);
  t.insert("upper", law.upper);
}
void add_parameters(toml::table& t, const Lognormal& law) {
  t.insert("log_mean", law.log_mean);
  t.insert("log_sigma", law.log_sigma);
  t.insert("shift", law.shift);
}
void add_parameters(toml::table& t, const Beta& law) {
  t.insert("alpha", law.alpha);
  t.insert("beta", law.beta);
  t.insert("lower", law.lower);
  t.insert("upper", law.upper);
}
template <class ShapeScaleShift>  // Weibull and Gamma
void add_parameters(toml::table& t, const ShapeScaleShift& law) {
  t.insert("shape", law.shape);
  t.insert("scale", law.scale);
  t.insert("shift", law.shift);
}
void add_parameters(toml::table& t, const Histogram& law) {
  t.insert("edges", array_of(law.edges));
  t.insert("weights", array_of(law.weights));
}
void add_parameters(toml::table& t, const Empirical& law) {
  t.insert("values", array_of(law.values));
}
void add_parameters(toml::table& t, const Capability& law) {
  t.insert("lower", law.lower);
  t.insert("upper", law.upper);
  t.insert("cp", law.cp);
  if (law.cpk) t.insert("cpk", *law.cpk);
}

}  // namespace

toml::table law_table(const Law& law) {
  toml::table table;
  table.insert("law", std::string(law_name(law)));
  std::visit([&](const auto& form) { add_parameters(table, form); }, law);
  return table;
}

}  // namespace cagetol
