#include "mc/law_reader.hpp"

#include <gtest/gtest.h>
#include <fstream>

#include "mc/measurement_csv.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

Law law_of(const std::string& text) {
  MeasurementFiles files;
  const auto root = parse_toml("x = " + text, "t.toml");
  return read_law(*root.get_as<toml::table>("x"), "x", "t.toml", files);
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
      "{ law = 'beta', alpha = 2, beta = 3, lower = -1, upper = 1 }",
      "{ law = 'weibull', shape = 1.5, scale = 2 }",
      "{ law = 'gamma', shape = 1.5, scale = 2, shift = 0.5 }",
      "{ law = 'histogram', edges = [0, 1, 3], weights = [2, 1] }",
      "{ law = 'empirical', values = [0.3, -0.1, 0.2] }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33 }",
      "{ law = 'capability', lower = -0.05, upper = 0.05, cp = 1.33, cpk = 1 }",
  };
  for (const char* text : texts) {
    const Law law = law_of(text);
    std::ostringstream written;
    written << toml::toml_formatter(law_table(law), toml::format_flags::none);
    const auto again_table = parse_toml(written.str(), "again");
    MeasurementFiles files;
    const Law again = read_law(again_table, "x", "again", files);
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

TEST(MeasurementCsv, ReadsWhatSpreadsheetsWrite) {
  EXPECT_EQ(csv_column("a,b\n1,2\n3,4\n", "f", "b"), (std::vector<double>{2, 4}));
  EXPECT_EQ(csv_column("# note\r\n\"a\"; \"b\"\r\n1; -2e-3\r\n\r\n3;4\r\n", "f", "b"),
            (std::vector<double>{-2e-3, 4}));
}

TEST(MeasurementCsv, NamesWhatIsWrong) {
  const auto problem = [](const std::string& text, const std::string& column) -> std::string {
    try {
      csv_column(text, "f.csv", column);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(problem("a,b\n1,2\n", "c")
                .find("f.csv:1: there is no column 'c'\n  remedy: the columns are: a, b"),
            std::string::npos);
  EXPECT_NE(problem("a,b\n1,x2\n", "b").find("f.csv:2: b = 'x2': this is not a number"),
            std::string::npos);
  EXPECT_NE(problem("a,b\n1,2mm\n", "b").find("this is not a number"), std::string::npos);
  EXPECT_NE(problem("a,b\n1,\n", "b").find("f.csv:2: b: the field is empty"), std::string::npos);
  EXPECT_NE(problem("a,b\n1,nan\n", "b").find("not a finite number"), std::string::npos);
  EXPECT_NE(problem("a,b\n1,2,3\n", "b").find("f.csv:2: 3 fields, but the header names 2"),
            std::string::npos);
  EXPECT_NE(problem("", "b").find("no header line"), std::string::npos);
  EXPECT_NE(problem("a,b\n", "b").find("holds no measurements"), std::string::npos);
}

}  // namespace
}  // namespace cagetol
