// Laws by the names that studies and study files use: { law = "normal", mean = 0, sigma = 0.009 }.
// mc/README.md lists them ("law object").
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "distributions/law.hpp"

namespace cagetol {

/// Every parameter that some law has. An optional number that is not finite is not stated.
struct LawParameters {
  double mean = 0, sigma = 0, mode = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double log_mean = 0, log_sigma = 0, shift = 0, shape = 1, scale = 1;
  double cp = 1, cpk = std::numeric_limits<double>::quiet_NaN(), cpk_lower = cpk, offset = cpk;
  std::vector<double> edges = {}, weights = {}, values = {};
};

enum class LawRange { any, not_negative, positive };

/// One of them: a number or a list of numbers.
struct LawParameter {
  using Member = std::variant<double LawParameters::*, std::vector<double> LawParameters::*>;
  std::string name;
  Member member;
  LawRange range = LawRange::any;
  std::string meaning;
};

const std::vector<LawParameter>& law_parameters();
/// Throws std::invalid_argument when there is none of that name.
const LawParameter& law_parameter(std::string_view name);

/// A law's name, the parameters it must have, those it may have, and how it is made.
struct LawForm {
  std::string name;
  std::vector<std::string> required, optional;
  Law (*make)(const LawParameters& parameters);
};

const std::vector<LawForm>& law_forms();
/// nullptr when there is none of that name.
const LawForm* find_law_form(std::string_view name);

/// The reverse of LawForm::make.
LawParameters parameters_of(const Law& law);

/// Whether this program has the law of a study file's law object; earlier ones had more.
bool knows_law(const nlohmann::json& object);

/// A law object of a study file. Throws StudyFileError for an unknown name, a missing key or
/// parameters that make no law; `where` names the input.
Law read_law(const nlohmann::json& object, const std::string& where);

}  // namespace cagetol
