#include "src/input/toml_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <filesystem>
#include <fstream>

#include "src/input/key_table.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

template <class Action>
std::string problem_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string written(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "toml_file_" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string reading(const std::string& path) {
  return problem_of([&] { read_toml(path); });
}

TEST(TomlFile, MissingFolderAndUnreadable) {
  EXPECT_THAT(reading("/no/such/file.toml"),
              HasSubstr("/no/such/file.toml: no such file\n  remedy: "));
  EXPECT_THAT(reading(testing::TempDir()), HasSubstr("this is a folder, not a file"));
  const auto path = written("locked.toml", "a = 1\n");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (geteuid() != 0) {
    EXPECT_THAT(reading(path), HasSubstr("cannot be read: Permission denied"));
  }
  std::filesystem::remove(path);
}

TEST(TomlFile, OnlyOrdinaryFilesAreRead) {
  EXPECT_THAT(reading("/dev/zero"), HasSubstr("/dev/zero: this is a device or a pipe"));
  const auto pipe = testing::TempDir() + "toml_file_pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(reading(pipe), HasSubstr("this is a device or a pipe"));  // nobody writes into it
  std::filesystem::remove(pipe);
  const auto sparse = written("sparse.toml", "a = 1\n");
  std::filesystem::resize_file(sparse, 10ull << 30);
  EXPECT_THAT(reading(sparse), HasSubstr("the file has 10737418240 bytes"));
  std::filesystem::remove(sparse);
  for (const char* blank : {"", "  "})
    EXPECT_THAT(reading(blank), HasSubstr("the name of the file is empty"));
  EXPECT_THAT(reading("/dev/null/x.toml"), HasSubstr("no such file"));
}

TEST(TomlFile, SyntaxErrorsNameTheLine) {
  const auto path = written("syntax.toml", "a = 1\n[cage\nb = 2\n");
  EXPECT_THAT(reading(path), HasSubstr("syntax.toml:2: not valid TOML"));
  EXPECT_THAT(reading(path), HasSubstr("remedy: correct the line"));
  std::filesystem::remove(path);
  EXPECT_THAT(problem_of([] { parse_toml("a = 1\na = 2\n", "t"); }),
              HasSubstr("t:2: not valid TOML"));
  EXPECT_THAT(problem_of([] { parse_toml("a = 99999999999999999999\n", "t"); }),
              HasSubstr("t:1: not valid TOML"));
  EXPECT_THAT(problem_of([] { parse_toml("a = 1e999999\n", "t"); }), HasSubstr("t:1: "));
}

TEST(TomlFile, MalformedInlineTablesAreErrorsToo) {
  const auto text = problem_of([] { parse_toml("a = 1\nb = { , }\nc = { = 1 }\n", "t"); });
  EXPECT_THAT(text, HasSubstr("t:2: not valid TOML"));
  EXPECT_THAT(problem_of([] { parse_toml("a = 1\nc = { a = 1, [ }\n", "t"); }),
              HasSubstr("t:2: not valid TOML"));
  toml::table root;
  EXPECT_THAT(problem_of([&] { apply_setting(root, "a={ , }"); }),
              HasSubstr("cannot read the value"));
}

TEST(TomlFile, OtherEncodingsAreNamed) {
  const auto problem = [](std::string_view text) {
    return problem_of([&] { parse_toml(text, "t"); });
  };
  using std::string_view_literals::operator""sv;
  EXPECT_THAT(problem("\xff\xfe"
                      "a\0=\0001\0"sv),
              HasSubstr("looks like UTF-16"));
  EXPECT_THAT(problem("name = 'Zylinderrollenlager f\xfcr M\xfchlen'\n"), HasSubstr("Latin-1"));
  EXPECT_THAT(problem("a = 1\rb = 2\r"), HasSubstr("CR alone"));
  EXPECT_EQ(problem("name = 'für \u6a5f'\r\n"), "no error");
}

TEST(TomlFile, BinaryAndHugeNonsense) {
  std::string garbage(4096, '\0');
  for (std::size_t i = 0; i < garbage.size(); ++i)
    garbage[i] = static_cast<char>((i * 131) ^ (i >> 3));
  EXPECT_THAT(problem_of([&] { parse_toml(garbage, "t"); }), HasSubstr("t:"));
  const std::string line(100000, 'x');
  EXPECT_THAT(problem_of([&] { parse_toml("a = 1\n" + line, "t"); }),
              HasSubstr("t:2: a line of 100000 characters: this does not look like a TOML file"));
  const auto path = written("huge.toml", std::string(17u << 20, '#'));
  EXPECT_THAT(reading(path), HasSubstr("the file has 17825792 bytes"));
  std::filesystem::remove(path);
  std::string nonsense;
  for (int i = 0; i < 100000; ++i)
    nonsense += "key" + std::to_string(i) + " = " + std::to_string(i) + "\n";
  EXPECT_EQ(parse_toml(nonsense, "t").size(), 100000u);
}

TEST(TomlFile, DeepNestingEndsInAMessage) {
  const auto parsing = [](const std::string& text) {
    return problem_of([&] { toml_leaves(parse_toml(text, "t")); });
  };
  const auto repeated = [](const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  EXPECT_THAT(parsing("a = 1\n[" + repeated("a.", 8000) + "a]\n"),
              HasSubstr("t:2: a key of 8001 parts"));
  EXPECT_THAT(parsing(repeated("'a.b' . \"c\" . ", 20) + "a = 1\n"),
              HasSubstr("t:1: a key of 41 parts"));
  EXPECT_THAT(parsing("x = { " + repeated("a.", 40) + "a = 1 }\n"), HasSubstr("t:1: a key of 41"));
  EXPECT_EQ(parsing("[" + repeated("a.", 31) + "a]\n" + repeated("b.", 31) + "b = 1.5\n"),
            "no error");
  EXPECT_EQ(parsing("a = [" + repeated("1.5, ", 1000) + "]\nb = '" + repeated("a.", 100) + "'\n"),
            "no error");
  EXPECT_THAT(parsing("a = " + std::string(5000, '[')), HasSubstr("t:1: not valid TOML"));
  EXPECT_THAT(parsing("a = " + repeated("[\n", 100000) + repeated("]\n", 100000)),
              HasSubstr("not valid TOML"));
  // The deepest that is read: tables in tables in arrays.
  EXPECT_EQ(parsing("x = " + repeated("[{" + repeated("a.", 30) + "a = ", 15) + "1" +
                    repeated("}]", 15) + "\n"),
            "no error");
  toml::table root;
  EXPECT_THAT(problem_of([&] { apply_setting(root, repeated("a.", 60000) + "a=1"); }),
              HasSubstr("a key of 60001 parts"));
  EXPECT_THAT(problem_of([&] { apply_setting(root, "a={ " + repeated("a.", 60000) + "a=1 }"); }),
              HasSubstr("a key of 60001 parts"));
}

TEST(TomlFile, SettingsAreTyped) {
  toml::table root;
  apply_setting(root, "a.b=1.5");
  apply_setting(root, "a.c = rigid");
  apply_setting(root, "a.d=[1, 2]");
  apply_setting(root, "a.e={ law = 'normal', sigma = 1 }");
  apply_setting(root, "f=../scenes/x.toml");
  apply_setting(root, "g=true");
  EXPECT_EQ(root["a"]["b"].value<double>(), 1.5);
  EXPECT_EQ(root["a"]["c"].value<std::string>(), "rigid");
  EXPECT_EQ(root["a"]["d"].as_array()->size(), 2u);
  EXPECT_TRUE(root["a"]["e"]["law"].is_string());
  EXPECT_EQ(root["f"].value<std::string>(), "../scenes/x.toml");
  EXPECT_EQ(root["g"].value<bool>(), true);
  EXPECT_EQ(place_of(*root["a"].as_table()->get("b"), "other").file, "--set");
  EXPECT_THAT(problem_of([&] { apply_setting(root, "a.b.c=1"); }),
              HasSubstr("'b' holds a value, not keys"));
  EXPECT_THAT(problem_of([&] { apply_setting(root, "a="); }), HasSubstr("cannot read the value"));
  EXPECT_THAT(problem_of([&] { apply_setting(root, std::string("a=b\0c", 5)); }),
              HasSubstr("cannot read the value"));
  EXPECT_THAT(problem_of([&] { apply_setting(root, "a..b=1"); }),
              HasSubstr("not of the form key=value"));
}

TEST(KeyTable, NearestName) {
  EXPECT_EQ(nearest_name("pocket_widht", {"pocket_width", "pocket_length", "model"}),
            "pocket_width");
  EXPECT_EQ(nearest_name("", {"a", "bc"}), "a");
  EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(TomlFile, CharactersThatAreNoBlanksAreNoneToTheParser) {
  for (const char* character : {"\xc2\xb5", "\xd2\x99", "\xe2\xb8\x8e", "\xef\xbb\xb8"})
    EXPECT_THAT(problem_of([&] { parse_toml("a" + std::string(character) + " = 1", "t.toml"); }),
                HasSubstr("t.toml:1: not valid TOML"))
        << character;
}

}  // namespace
}  // namespace cagetol
