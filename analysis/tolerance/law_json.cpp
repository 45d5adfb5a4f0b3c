#include "analysis/tolerance/law_json.hpp"

#include "analysis/study/study_file_error.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::json;

Law law_of(const Json& object) {
  const auto name = object.at("law").get<std::string>();
  const auto at = [&](const char* key) { return object.at(key).get<double>(); };
  const auto or_zero = [&](const char* key) { return object.value(key, 0.0); };
  const auto list = [&](const char* key) { return object.at(key).get<std::vector<double>>(); };
  if (name == "normal") return Normal{or_zero("mean"), at("sigma")};
  if (name == "truncated_normal") {
    TruncatedNormal law{.mean = or_zero("mean"), .sigma = at("sigma")};
    if (object.contains("lower") && object.at("lower").is_number()) law.lower = at("lower");
    if (object.contains("upper") && object.at("upper").is_number()) law.upper = at("upper");
    return law;
  }
  if (name == "uniform") return Uniform{at("lower"), at("upper")};
  if (name == "triangular") return Triangular{at("lower"), at("mode"), at("upper")};
  if (name == "lognormal") return Lognormal{at("log_mean"), at("log_sigma"), or_zero("shift")};
  if (name == "beta") return Beta{at("alpha"), at("beta"), at("lower"), at("upper")};
  if (name == "weibull") return Weibull{at("shape"), at("scale"), or_zero("shift")};
  if (name == "gamma") return Gamma{at("shape"), at("scale"), or_zero("shift")};
  if (name == "histogram") return Histogram{list("edges"), list("weights")};
  if (name == "empirical") return make_empirical(list("values"));
  if (name == "capability") {
    Capability law{at("lower"), at("upper"), at("cp"), {}};
    if (object.contains("cpk") && !object.at("cpk").is_null()) law.cpk = at("cpk");
    return law;
  }
  throw std::invalid_argument("there is no law `" + name + "`");
}

}  // namespace

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
