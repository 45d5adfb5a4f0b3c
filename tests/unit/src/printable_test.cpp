#include "src/input/printable.hpp"

#include <gtest/gtest.h>

#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

TEST(Printable, LeavesTextsOfAllLanguagesAsTheyAre) {
  for (const char* text : {"Käfig 7,65 µm – 軸受 🛞", "", "a\\b"})
    EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable("a\tb\nc", LineBreaks::kept), "a\tb\nc");
}

TEST(Printable, EscapesWhatActsOnATerminal) {
  EXPECT_EQ(printable("\x1b[2J\r\n\x7f"), "\\x1b[2J\\x0d\\x0a\\x7f");
  EXPECT_EQ(printable("\r\n", LineBreaks::kept), "\\x0d\n");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\xc2\\x9b31m");  // C1: CSI
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            "a\\xe2\\x80\\xaeb");  // writes backwards
  EXPECT_EQ(printable("\xe2\x80\xa8\xe2\x81\xa6"), "\\xe2\\x80\\xa8\\xe2\\x81\\xa6");
  EXPECT_EQ(printable("\xe2\x80\x93"), "\xe2\x80\x93");  // a dash
}

TEST(Printable, EscapesWhatIsNotUtf8) {
  for (const char* bytes : {"\x80", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                            "\xf0\x80\x80\xaf", "\xf4\x90\x80\x80", "\xe2\x82"})
    EXPECT_EQ(printable(bytes).substr(0, 2), "\\x") << printable(bytes);
}

TEST(Excerpt, CutsBetweenCharacters) {
  EXPECT_EQ(excerpt("abcdef", 6), "abcdef");
  EXPECT_EQ(excerpt("abcdefg", 6), "abc...");
  EXPECT_EQ(excerpt("ab\xc3\xa4"
                    "cdef",
                    6),
            "ab...");
}

TEST(Messages, HoldNothingThatActsOnATerminal) {
  const InputError error({"\x1b]0;x.toml", 3}, "a\nb", "\x1b[31m", "why\x07\nmore", "do\rthis");
  EXPECT_STREQ(error.what(),
               "\\x1b]0;x.toml:3: a\\x0ab = \\x1b[31m: why\\x07\nmore\n  remedy: do\\x0dthis");
}

std::string refusal_of(const std::string& toml) {
  try {
    read_scene(parse_toml(toml, "t.toml"), "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Messages, QuoteNothingOfOtherFiles) {
  EXPECT_EQ(refusal_of("root:$y$secret:19000:0\n").find("secret"), std::string::npos);
  EXPECT_EQ(refusal_of("root:$y$secret:19000:0\n").find("saw"), std::string::npos);
  const std::string environment = refusal_of("API_KEY = \"hunter2\"\n");
  EXPECT_NE(environment.find("t.toml:1: API_KEY: no such key"), std::string::npos) << environment;
}

TEST(Messages, TextsWithControlCharactersAreRefused) {
  const std::string refusal = refusal_of("name = \"a\\u001b[31mred\"\n");
  EXPECT_NE(refusal.find("t.toml:1: name = 'a\\x1b[31mred': the text holds characters"),
            std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace cagetol
