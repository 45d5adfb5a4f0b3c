// Mutated inputs of every reader of files: whatever they hold, it reads them or refuses them as it
// documents. By night tests/fuzz/run.sh does the same a million times, under sanitizers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>

#include "tests/support/reader_probes.hpp"

namespace cagetol {
namespace {

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

class EveryReader : public testing::TestWithParam<ReaderProbe> {};

TEST_P(EveryReader, ReadsWhatShips) {
  const std::string name = GetParam().name;
  const auto seeds = GetParam().seeds();
  // Of a study file the first seed is the whole file, the others are edits of it.
  const bool edits = name == "study_file" || name == "study_data";
  for (std::size_t i = 0; i < (edits ? 1 : seeds.size()); ++i)
    EXPECT_TRUE(GetParam().read(seeds[i])) << seeds[i];
}

TEST_P(EveryReader, ReadsOrRefusesWhateverItIsGiven) {
  // A study that is read may simulate its bearing to find temperatures: most of them by night.
  static const std::map<std::string, int> slow = {
      {"study", std::getenv("CAGETOL_NIGHTLY") ? 400 : 100}, {"resolved", 400}, {"settings", 300}};
  const std::string name = GetParam().name;
  const int inputs = slow.contains(name) ? slow.at(name) : 2000;
  const auto seeds = GetParam().seeds();
  Mutator mutated(205);
  int read = 0;
  for (int i = 0; i < inputs; ++i) {
    const std::string input = mutated(seeds[static_cast<std::size_t>(i) % seeds.size()]);
    ASSERT_NO_THROW(read += GetParam().read(input)) << testing::PrintToString(input);
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, inputs - inputs / 10);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryReader, testing::ValuesIn(reader_probes()),
                         [](const auto& probe) { return std::string(probe.param.name); });

}  // namespace
}  // namespace cagetol
