#include "mc/study/law_reader.hpp"

#include <gtest/gtest.h>

#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

Law law_of(const std::string& text) {
  MeasurementFiles files;
  const auto root = parse_toml("x = " + text, "t.toml");
  return read_law(*root.get_as<toml::table>("x"), "x", "mm", "t.toml", files);
}

TEST(LawReader, EveryLawReadsAndReadsBack) {
  const char* texts[] = {
      "{ law = 'normal', sigma = 0.5 }",
      "{ law = 'normal', mean = 1, sigma = 0 }",
      "{ law = 'truncated_normal', sigma = 0.5, lower = -1, upper = 1.5 }",
      "{ law = 'truncated_normal', sigma = 0.5, lower = 0 }",
      "{ law = 'uniform', lower = -1, upper = 2 }",
      "{ law = 'triangular', lower = -1, mode = 0, upper = 2 }",
      "{ law = 'lognormal', log_mean = 0.1, log_sigma = 0.2, shift = -1 }",
      "{ law = 'weibull', shape = 1.5, scale = 2 }",
      "{ law = 'histogram', edges = [0, 1, 3], weights = [2, 1] }",
      "{ law = 'empirical', values = [0.3, -0.1, 0.2] }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33 }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33, cpk = 1 }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33, cpk_lower = 1 }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33, offset = -0.008 }",
  };
  for (const char* text : texts) {
    const Law law = law_of(text);
    std::ostringstream written;
    written << toml::toml_formatter(law_table(law), toml::format_flags::none);
    const auto again_table = parse_toml(written.str(), "again");
    MeasurementFiles files;
    const Law again = read_law(again_table, "x", "mm", "again", files);
    EXPECT_EQ(law_name(law), law_name(again));
    for (const double p : {0.01, 0.3, 0.5, 0.99})
      EXPECT_EQ(quantile(law, p), quantile(again, p)) << text;
  }
}

TEST(LawReader, MeasurementsAreCentredOnRequest) {
  const Law law = law_of("{ law = 'empirical', values = [1, 2, 6], centred = true }");
  EXPECT_EQ(quantile(law, 0), -2);
  EXPECT_EQ(quantile(law, 1), 3);
}

TEST(LawReader, CapabilityIsTheNormalLawOfItsLimits) {
  const Law law =
      law_of("{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.3333333333333333 }");
  EXPECT_NEAR(standard_deviation(law), 0.1 / 8, 1e-12);
  EXPECT_NEAR(mean(law), 0, 1e-15);
}

}  // namespace
}  // namespace cagetol
