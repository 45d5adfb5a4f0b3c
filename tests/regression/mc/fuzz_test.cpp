// Mutated input files: whatever they hold, the reader answers with a study or with an InputError.
#include <gtest/gtest.h>
#include <filesystem>
#include <random>

#include "mc/measurement_csv.hpp"
#include "mc/sample.hpp"
#include "mc/study.hpp"
#include "src/input/toml_file.hpp"
#include "src/scene/scene_keys.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

std::string shipped_text(const std::string& path) {
  return read_text_file(shipped(path));
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    static const std::vector<std::string> pieces = {"nan",
                                                    "inf",
                                                    "-1",
                                                    "0",
                                                    "1e308",
                                                    "-1e-320",
                                                    "99999999999999999999",
                                                    "[",
                                                    "]",
                                                    "{",
                                                    "}",
                                                    "=",
                                                    "\"",
                                                    "'''",
                                                    "\n",
                                                    "[[limit]]\n",
                                                    "[scene]\n",
                                                    "auto",
                                                    "true",
                                                    "law",
                                                    "sigma",
                                                    "{ law = 'normal', sigma = -1 }",
                                                    "2024-01-01",
                                                    "\xff\xfe",
                                                    std::string(1, '\0'),
                                                    ".",
                                                    "#"};
    const int edits = 1 + pick(6);
    for (int i = 0; i < edits && !text.empty(); ++i) {
      const std::size_t at = pick(text.size());
      switch (pick(5)) {
        case 0:
          text[at] = static_cast<char>(pick(256));
          break;
        case 1:
          text.erase(at, 1 + pick(20));
          break;
        case 2:
          text.insert(at, pieces[pick(pieces.size())]);
          break;
        case 3:
          text.insert(at, text.substr(pick(text.size()), pick(60)));
          break;
        default:
          replace_value(text, pieces[pick(pieces.size())]);
      }
    }
    return text;
  }

 private:
  std::size_t pick(std::size_t count) { return random_() % count; }

  // Exchanges what stands behind one of the equals signs.
  void replace_value(std::string& text, const std::string& value) {
    const auto equals = text.find('=', pick(text.size()));
    if (equals == std::string::npos) return;
    text.replace(equals + 1, text.find('\n', equals) - equals - 1, " " + value);
  }

  std::mt19937 random_;
};

TEST(Fuzz, ScenesAreReadOrRefused) {
  Mutator mutated(205);
  int read = 0, refused = 0;
  for (const char* path : {"scenes/nu205.toml", "scenes/speed-z16-skew.toml"}) {
    const std::string text = shipped_text(path);
    for (int i = 0; i < 2000; ++i) {
      try {
        read_scene(parse_toml(mutated(text), "fuzz.toml"), "fuzz.toml");
        ++read;
      } catch (const InputError& error) {
        ++refused;
        EXPECT_NE(std::string(error.what()).find("remedy: "), std::string::npos) << error.what();
      }
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 1000);
}

TEST(Fuzz, StudiesAreReadOrRefused) {
  Mutator mutated(16);
  const std::string text = read_study(shipped("studies/nu205.toml")).resolved_toml;
  const std::string measured = read_study(shipped("studies/nu205-measured.toml")).resolved_toml;
  int read = 0, refused = 0;
  for (int i = 0; i < 1500; ++i) {
    try {
      const Study study = read_resolved_study(mutated(i % 3 ? text : measured), "fuzz.toml");
      draw_sample(study, sample_count(study) - 1);
      ++read;
    } catch (const InputError& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("remedy: "), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(read, 10);
  EXPECT_GT(refused, 500);
}

TEST(Fuzz, MeasurementsAreReadOrRefused) {
  Mutator mutated(3);
  const std::string text = shipped_text("measurements/pockets-synthetic.csv");
  for (int i = 0; i < 2000; ++i) {
    try {
      csv_column(mutated(text), "fuzz.csv", "width_deviation_mm");
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace cagetol
