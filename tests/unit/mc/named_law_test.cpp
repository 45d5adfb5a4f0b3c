#include "mc/study_file/named_law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

template <std::size_t... I>
std::vector<Law> one_of_each(std::index_sequence<I...>) {
  return {Law(std::in_place_index<I>)...};
}

TEST(NamedLaw, EveryLawHasAFormOfItsNameThatMakesIt) {
  for (const Law& law : one_of_each(std::make_index_sequence<std::variant_size_v<Law>>())) {
    const LawForm* form = find_law_form(law_name(law));
    ASSERT_NE(form, nullptr) << law_name(law);
    EXPECT_EQ(form->make(parameters_of(law)).index(), law.index()) << form->name;
    for (const auto& names : {form->required, form->optional})
      for (const std::string& name : names) EXPECT_NO_THROW(law_parameter(name)) << form->name;
  }
}

TEST(NamedLaw, ParametersOfALawAreThoseItIsMadeOf) {
  LawParameters given;
  double next = 1;
  for (const LawParameter& parameter : law_parameters())
    if (const auto* number = std::get_if<double LawParameters::*>(&parameter.member))
      given.*(*number) = next++;
  given.edges = {0, 1, 3};
  given.weights = {2, 1};
  given.values = {-1, 4};
  for (const LawForm& form : law_forms()) {
    const LawParameters again = parameters_of(form.make(given));
    for (const auto& names : {form.required, form.optional})
      for (const std::string& name : names)
        std::visit(
            [&](auto member) { EXPECT_EQ(again.*member, given.*member) << form.name << name; },
            law_parameter(name).member);
  }
}

std::string refusal(const std::string& json) {
  try {
    read_law(nlohmann::json::parse(json), "cage.pocket_width_mm:lot");
    return "";
  } catch (const StudyFileError& error) {
    return error.what();
  }
}

TEST(NamedLaw, ReadsTheLawObjectsOfStudyFiles) {
  const auto read = [](const char* text) { return read_law(nlohmann::json::parse(text), "x"); };
  const auto half = std::get<TruncatedNormal>(
      read(R"({"law": "truncated_normal", "sigma": 2, "lower": -1, "upper": "inf"})"));
  EXPECT_EQ(half.sigma, 2);
  EXPECT_EQ(half.lower, -1);
  EXPECT_EQ(half.upper, TruncatedNormal().upper);
  const auto able =
      std::get<Capability>(read(R"({"law": "capability", "lower": -1, "upper": 1, "cp": 1.5})"));
  EXPECT_FALSE(able.cpk);
  EXPECT_EQ(
      std::get<Histogram>(read(R"({"law": "histogram", "edges": [0, 1], "weights": [3]})")).edges,
      (std::vector<double>{0, 1}));
}

TEST(NamedLaw, RefusalsNameTheInputAndWhatIsWrong) {
  EXPECT_THAT(
      refusal(R"({"law": "wiebull"})"),
      HasSubstr("the law of cage.pocket_width_mm:lot cannot be used: there is no law `wiebull`"));
  EXPECT_THAT(refusal(R"({"law": "normal"})"), HasSubstr("sigma"));
  EXPECT_THAT(refusal(R"({"law": "normal", "sigma": 1, "mean": "much"})"), HasSubstr("number"));
  EXPECT_THAT(refusal(R"({"law": "uniform", "lower": 2, "upper": 1})"),
              HasSubstr("cannot be used"));
}

}  // namespace
}  // namespace cagetol
