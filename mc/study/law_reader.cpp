#include "mc/study/law_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "mc/study_file/named_law.hpp"
#include "src/input/key_table.hpp"
#include "src/input/measurement_csv.hpp"

namespace cagetol {
namespace {

// A law as a study states it: with the source of its measurements.
struct StatedLaw : LawParameters, StatedFile {
  std::string law;
};

KeyRange range_of(LawRange range) {
  switch (range) {
    case LawRange::not_negative:
      return at_least(0);
    case LawRange::positive:
      return above(0);
    case LawRange::any:
      break;
  }
  return any_value();
}

KeyTable<StatedLaw> make_parameter_keys() {
#define AT(member)               \
  [](StatedLaw & law) -> auto& { \
    return law.member;           \
  }
  KeyTable<StatedLaw> keys = {
      {"law", any_value(), AT(law), "name of the law"},
      {"file", any_value(), AT(file), "CSV file of measurements, beside this file"},
      {"column", any_value(), AT(column), "column of the CSV file"},
      {"decimal", one_of({".", ","}), AT(decimal), "decimal mark of the numbers in the CSV file"},
      {"centred", any_value(), AT(centred), "subtract the mean of the measurements"},
      {"group", any_value(), AT(group), "column that names the cage of each part"},
      {"fitted", any_value(), AT(fitted), "draw from normal laws fitted to the measurements"},
      {"resample", any_value(), AT(resample), "take cages of another number of pockets"},
      {"missing", one_of({"refuse", "skip"}), AT(missing), "what an empty field is"},
      {"exclude", at_least(1), AT(exclude), "lines of the CSV file to leave out"},
  };
#undef AT
  for (const LawParameter& parameter : law_parameters())
    std::visit(
        [&](auto member) {
          keys.emplace_back(
              parameter.name,
              range_of(parameter.range), [member](StatedLaw & law) -> auto& { return law.*member; },
              parameter.meaning);
        },
        parameter.member);
  return keys;
}

const KeyTable<StatedLaw>& parameter_keys() {
  static const KeyTable<StatedLaw> keys = make_parameter_keys();
  return keys;
}

const std::vector<std::string> kOfFile = {"column",  "decimal", "group",   "fitted",
                                          "missing", "exclude", "resample"};

// The forms of a study file, but measurements may stand in a file of their own.
std::vector<LawForm> make_stated_forms() {
  std::vector<LawForm> forms = law_forms();
  for (LawForm& form : forms)
    if (form.name == "empirical") {
      form.required.clear();
      form.optional = kOfFile;
      form.optional.insert(form.optional.end(), {"file", "centred", "values"});
    }
  return forms;
}

const std::vector<LawForm>& stated_forms() {
  static const std::vector<LawForm> forms = make_stated_forms();
  return forms;
}

const LawForm& form_of(const toml::table& table, const std::string& key, const std::string& file) {
  std::vector<std::string> names;
  for (const auto& form : stated_forms()) names.push_back(form.name);
  const auto* node = table.get("law");
  if (!node)
    throw InputError(
        place_of(table, file), key, shown(table), "a distribution needs a law",
        "add law = \"normal\" or another of: " + fmt::format("{}", fmt::join(names, ", ")));
  const auto name = node->value<std::string>();
  for (const auto& form : stated_forms())
    if (name == form.name) return form;
  throw InputError(
      place_of(*node, file), key + ".law", shown(*node), "there is no such law",
      suggestion(name.value_or(""), names, fmt::format("laws are: {}", fmt::join(names, ", "))));
}

// The parameter's key under the law's full name, so that messages name it whole.
Key<StatedLaw> named_below(Key<StatedLaw> parameter, const std::string& key) {
  parameter.name = key + "." + parameter.name;
  return parameter;
}

void read_measurements(const toml::table& table, const std::string& key, const std::string& unit,
                       const std::string& file, const MeasuredKey& of,
                       MeasurementFiles& measurements, StatedLaw& parameters) {
  const bool from_file = table.contains("file");
  if (from_file == table.contains("values"))
    throw InputError(place_of(table, file), key, shown(table),
                     from_file ? "both file and values are given" : "no measurements are given",
                     "give file = \"parts.csv\" and column = \"...\", or values = [...]");
  for (const std::string& of_file : kOfFile)
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
    measurements.push_back(read_measured_parts(text, path, parameters, key, unit, of));
  } else if (parameters.centred && !parameters.values.empty()) {
    const double middle = mean(Empirical{parameters.values});
    for (double& value : parameters.values) value -= middle;
  }
}

void read_parameters(const toml::table& table, const LawForm& form, const std::string& key,
                     const std::string& file, StatedLaw& parameters) {
  std::vector<std::string> names = form.required;
  names.insert(names.end(), form.optional.begin(), form.optional.end());
  for (const auto& [name, node] : table) {
    const std::string parameter(name.str());
    if (parameter == "law" || parameter == "nominal") continue;
    if (std::find(names.begin(), names.end(), parameter) == names.end())
      throw InputError(place_of(node, file), key + "." + parameter, shown(node),
                       "the law \"" + form.name + "\" has no such parameter",
                       suggestion(parameter, names,
                                  fmt::format("its parameters are: {}", fmt::join(names, ", "))));
    if (parameter == "group" && node.value_exact<bool>() == false) {
      parameters.ungrouped = true;
      continue;
    }
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
             const std::string& file, MeasurementFiles& measurements, const MeasuredKey& of) {
  const auto& form = form_of(table, key, file);
  StatedLaw parameters;
  read_parameters(table, form, key, file, parameters);
  if (form.name == "empirical")
    read_measurements(table, key, unit, file, of, measurements, parameters);
  const Law law = table.contains("file") && form.name == "empirical"
                      ? laws_of(measurements.back()).pocket
                      : form.make(parameters);
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

void insert(toml::table& table, const std::string& name, double value) {
  if (std::isfinite(value)) table.insert(name, value);
}
void insert(toml::table& table, const std::string& name, const std::vector<double>& values) {
  table.insert(name, key_detail::array_of(values));
}

}  // namespace

toml::table law_table(const Law& law) {
  const LawForm& form = *find_law_form(law_name(law));
  const LawParameters parameters = parameters_of(law);
  toml::table table;
  table.insert("law", form.name);
  for (const auto& names : {form.required, form.optional})
    for (const std::string& name : names)
      std::visit([&](auto member) { insert(table, name, parameters.*member); },
                 law_parameter(name).member);
  return table;
}

}  // namespace cagetol
