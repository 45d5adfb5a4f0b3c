#include "mc/study_file/named_law.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

using P = LawParameters;
using Json = nlohmann::json;

P stated(const Normal& law) {
  return {.mean = law.mean, .sigma = law.sigma};
}
P stated(const TruncatedNormal& law) {
  return {.mean = law.mean, .sigma = law.sigma, .lower = law.lower, .upper = law.upper};
}
P stated(const Uniform& law) {
  return {.lower = law.lower, .upper = law.upper};
}
P stated(const Triangular& law) {
  return {.mode = law.mode, .lower = law.lower, .upper = law.upper};
}
P stated(const Lognormal& law) {
  return {.log_mean = law.log_mean, .log_sigma = law.log_sigma, .shift = law.shift};
}
P stated(const Weibull& law) {
  return {.shift = law.shift, .shape = law.shape, .scale = law.scale};
}
P stated(const Histogram& law) {
  return {.edges = law.edges, .weights = law.weights};
}
P stated(const Empirical& law) {
  return {.values = law.values};
}
P stated(const Capability& law) {
  return {.lower = law.lower,
          .upper = law.upper,
          .cp = law.cp,
          .cpk = law.cpk.value_or(P().cpk),
          .cpk_lower = law.cpk_lower.value_or(P().cpk),
          .offset = law.offset.value_or(P().cpk)};
}

std::optional<double> if_stated(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void read_parameter(const Json& value, const std::string& name, P& parameters) {
  std::visit([&](auto member) { value.get_to(parameters.*member); }, law_parameter(name).member);
}

/// An end that is not finite was written as a text once.
bool is_stated(const Json& object, const std::string& name) {
  if (!object.contains(name) || object.at(name).is_null()) return false;
  return object.at(name).is_number() || (name != "lower" && name != "upper");
}

Law law_of(const Json& object) {
  const auto name = object.at("law").get<std::string>();
  const LawForm* form = find_law_form(name);
  if (form == nullptr) throw std::invalid_argument("there is no law `" + name + "`");
  P parameters;
  for (const std::string& required : form->required)
    read_parameter(object.at(required), required, parameters);
  for (const std::string& optional : form->optional)
    if (is_stated(object, optional)) read_parameter(object.at(optional), optional, parameters);
  return form->make(parameters);
}

}  // namespace

const std::vector<LawParameter>& law_parameters() {
  using enum LawRange;
  static const std::vector<LawParameter> parameters = {
      {"mean", &P::mean, any, "mean deviation from the nominal value"},
      {"sigma", &P::sigma, not_negative, "standard deviation"},
      {"lower", &P::lower, any, "lower end"},
      {"mode", &P::mode, any, "most likely deviation"},
      {"upper", &P::upper, any, "upper end"},
      {"log_mean", &P::log_mean, any, "mean of the logarithm"},
      {"log_sigma", &P::log_sigma, not_negative, "standard deviation of the logarithm"},
      {"shift", &P::shift, any, "where the law begins"},
      {"shape", &P::shape, positive, "shape parameter"},
      {"scale", &P::scale, positive, "scale parameter"},
      {"cp", &P::cp, positive, "capability index Cp of the limits"},
      {"cpk", &P::cpk, any, "capability index Cpk towards the upper limit"},
      {"cpk_lower", &P::cpk_lower, any, "capability index Cpk towards the lower limit"},
      {"offset", &P::offset, any, "mean less the middle of the limits"},
      {"edges", &P::edges, any, "ends of the bins, ascending"},
      {"weights", &P::weights, not_negative, "weight of each bin"},
      {"values", &P::values, any, "measured deviations"},
  };
  return parameters;
}

const LawParameter& law_parameter(std::string_view name) {
  for (const LawParameter& parameter : law_parameters())
    if (parameter.name == name) return parameter;
  throw std::invalid_argument("no law has a parameter `" + std::string(name) + "`");
}

// clang-format off
const std::vector<LawForm>& law_forms() {
  static const std::vector<LawForm> forms = {
      {"normal", {"sigma"}, {"mean"}, [](const P& p) -> Law { return Normal{p.mean, p.sigma}; }},
      {"truncated_normal", {"sigma"}, {"mean", "lower", "upper"}, [](const P& p) -> Law { return TruncatedNormal{p.mean, p.sigma, p.lower, p.upper}; }},
      {"uniform", {"lower", "upper"}, {}, [](const P& p) -> Law { return Uniform{p.lower, p.upper}; }},
      {"triangular", {"lower", "mode", "upper"}, {}, [](const P& p) -> Law { return Triangular{p.lower, p.mode, p.upper}; }},
      {"lognormal", {"log_mean", "log_sigma"}, {"shift"}, [](const P& p) -> Law { return Lognormal{p.log_mean, p.log_sigma, p.shift}; }},
      {"weibull", {"shape", "scale"}, {"shift"}, [](const P& p) -> Law { return Weibull{p.shape, p.scale, p.shift}; }},
      {"histogram", {"edges", "weights"}, {}, [](const P& p) -> Law { return Histogram{p.edges, p.weights}; }},
      {"empirical", {"values"}, {}, [](const P& p) -> Law { return make_empirical(p.values); }},
      {"capability", {"lower", "upper", "cp"}, {"cpk", "cpk_lower", "offset"}, [](const P& p) -> Law { return Capability{p.lower, p.upper, p.cp, if_stated(p.cpk), if_stated(p.cpk_lower), if_stated(p.offset)}; }},
  };
  return forms;
}
// clang-format on

const LawForm* find_law_form(std::string_view name) {
  for (const LawForm& form : law_forms())
    if (form.name == name) return &form;
  return nullptr;
}

LawParameters parameters_of(const Law& law) {
  return std::visit([](const auto& of) { return stated(of); }, law);
}

bool knows_law(const Json& object) {
  return find_law_form(object.at("law").get<std::string>()) != nullptr;
}

Law read_law(const Json& object, const std::string& where) {
  try {
    const Law law = law_of(object);
    check(law);
    return law;
  } catch (const std::exception& error) {
    throw StudyFileError("study.h5",
                         "/study/json: the law of " + where + " cannot be used: " + error.what(),
                         "run the study again with the version of the program that reads it");
  }
}

}  // namespace cagetol
