#include "src/input/measurement_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using namespace std::string_literals;

std::vector<double> read(const std::string& bytes, const std::string& column,
                         bool decimal_comma = false) {
  return csv_column(bytes, "f.csv", {column, "mm", decimal_comma});
}

std::string problem(const std::string& bytes, const std::string& column,
                    bool decimal_comma = false) {
  try {
    read(bytes, column, decimal_comma);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The text as UTF-16 with a byte order mark; characters below 256 only.
std::string utf16(const std::string& text, bool little) {
  std::string bytes = little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : text) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

TEST(MeasurementCsv, SeparatorsAreThoseOfTheHeader) {
  EXPECT_THAT(read("a,b\n1,2\n3,4\n", "b"), ElementsAre(2, 4));
  EXPECT_THAT(read("a;b\n1;2\n3;4", "b"), ElementsAre(2, 4));
  EXPECT_THAT(read("a\tb\n1\t2\n3\t4\n", "b"), ElementsAre(2, 4));
  EXPECT_THAT(read("sep=;\na, left;b\n1;2\n3;4\n", "b"), ElementsAre(2, 4));
  EXPECT_THAT(read("\"sep=|\"\r\na|b\r\n1|2\r\n", "b"), ElementsAre(2));
  EXPECT_THAT(read("a\n1\n2\n", "a"), ElementsAre(1, 2));
}

TEST(MeasurementCsv, LinesEndInEveryWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "# note" + end + "a;b" + end + end + "1;2" + end + " \t" + end + "3;4";
    EXPECT_THAT(read(text, "b"), ElementsAre(2, 4));
    EXPECT_THAT(read(text + end + ";;" + end, "b"), ElementsAre(2, 4));
    EXPECT_THAT(problem(text + end + "5;x" + end, "b"), HasSubstr("f.csv:7: column 2 (b) = 'x'"));
  }
}

TEST(MeasurementCsv, SignsOfNumbers) {
  EXPECT_THAT(read("a\n+0.012\n-0.5\n+1e-3\n\xe2\x88\x92"
                   "0.25\n.5\n",
                   "a"),
              ElementsAre(0.012, -0.5, 1e-3, -0.25, 0.5));
  for (const char* wrong : {"+-1", "-+1", "++1", "+", "+ 1", "1 000", "1'000", "0x10", "1_0"})
    EXPECT_THAT(problem("a\n1\n2\n3\n"s + wrong + "\n", "a"),
                HasSubstr("f.csv:5: column 1 (a) = '"s + wrong + "': this is not a number"))
        << wrong;
}

TEST(MeasurementCsv, ByteOrderMarksAndEncodings) {
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_THAT(read(mark + "a,b\n1,2\n", "a"), ElementsAre(1));
  EXPECT_THAT(read(mark + "# note\na,b\n1,2\n", "a"), ElementsAre(1));
  EXPECT_THAT(read("# note\n" + mark + "a,b\n1,2\n", "a"), ElementsAre(1));
  EXPECT_THAT(read(utf16("a\tb\r\n1\t2\r\n", true), "b"), ElementsAre(2));
  EXPECT_THAT(read(utf16("a\tb\r\n1\t2\r\n", false), "b"), ElementsAre(2));
  EXPECT_THAT(read("L\xe4nge;b\n1;2\n", "L\xc3\xa4nge"), ElementsAre(1));  // Latin-1
  EXPECT_THAT(read("a [\xb5m];b\n1;2\n", "a"), ElementsAre(0.001));        // Latin-1
  EXPECT_THAT(read("a\n1\xc2\xa0\n\xc2\xa0"
                   "2\n",
                   "a"),
              ElementsAre(1, 2));  // no-break space
}

TEST(MeasurementCsv, WhatIsNoTextIsRefused) {
  const std::string remedy = "remedy: save the measurements as CSV with the encoding UTF-8";
  EXPECT_THAT(problem("a\n1\0\n"s, "a"), AllOf(HasSubstr("byte 4"), HasSubstr(remedy)));
  EXPECT_THAT(problem(utf16("a\n1\n", true).substr(2), "a"),
              AllOf(HasSubstr("UTF-16 needs a byte order mark"), HasSubstr(remedy)));
  EXPECT_THAT(problem("\xff\xfe\0\0a\0\0\0"s, "a"), HasSubstr("UTF-32"));
  EXPECT_THAT(problem(utf16("a\n1\n", true) + "x", "a"), HasSubstr("ends within a character"));
  EXPECT_THAT(problem("\xff\xfe\x00\xd8\x41\x00"s, "a"), HasSubstr("starts like UTF-16"));
  EXPECT_THAT(problem("\x7f"
                      "ELF\n1\n",
                      "a"),
              HasSubstr("byte 1 is a control character"));
}

TEST(MeasurementCsv, DecimalCommasWantTheirKey) {
  EXPECT_THAT(read("a;b\n7,65;+0,5\n-7,66;1\n", "a", true), ElementsAre(7.65, -7.66));
  EXPECT_THAT(read("a\n7,65\n7,66\n", "a", true), ElementsAre(7.65, 7.66));
  EXPECT_THAT(read("a,b\n\"7,65\",1\n", "a", true), ElementsAre(7.65));
  EXPECT_THAT(problem("a;b\n7,65;1\n", "a"),
              AllOf(HasSubstr("f.csv:2: column 1 (a) = '7,65': this number has a decimal comma"),
                    HasSubstr("remedy: add decimal = \",\" beside file and column")));
  EXPECT_THAT(problem("a\n7,65\n", "a"),
              AllOf(HasSubstr("f.csv:2: 2 fields, but the header names 1 columns"),
                    HasSubstr("add decimal = \",\"")));
  EXPECT_THAT(problem("a;b\n7.65;1\n", "a", true),
              AllOf(HasSubstr("column 1 (a) = '7.65': this number has a decimal point"),
                    HasSubstr("leave decimal = \",\" out")));
  EXPECT_THAT(problem("a;b\n1.234,5;1\n", "a", true), HasSubstr("nothing between thousands"));
}

TEST(MeasurementCsv, QuotesAfterRfc4180) {
  EXPECT_THAT(read("\"a, \"\"left\"\"\",\"b\"\n\"1\",\"2\"\n", "a, \"left\""), ElementsAre(1));
  EXPECT_THAT(read("a,b\n\"two\r\nlines, one field\",3\n", "b"), ElementsAre(3));
  EXPECT_THAT(read("a;b\n 6\" pipe ; \"3\" \n", "b"), ElementsAre(3));
  EXPECT_THAT(problem("a,b\n\"two\nlines\",3\nx,y\n", "b"), HasSubstr("f.csv:4: column 2 (b)"));
  EXPECT_THAT(problem("a,b\n1,\"2\n3,4\n", "b"),
              HasSubstr("f.csv:2: column 2: the quote that opens here is never closed"));
  EXPECT_THAT(problem("a,b\n1,\"2\"3\n", "b"),
              HasSubstr("f.csv:2: column 2: text follows the quote that ends the field"));
}

TEST(MeasurementCsv, TrailingSeparatorsNameNoColumn) {
  EXPECT_THAT(read("a;b;\n1;2;\n3;4\n5;6;;;\n", "b"), ElementsAre(2, 4, 6));
  EXPECT_THAT(problem("a;b;\n1;2;3\n", "b"),
              HasSubstr("f.csv:2: 3 fields, but the header names 2 columns: column 3 has no name"));
  EXPECT_THAT(problem("a;b;c\n1;2\n", "b"),
              HasSubstr("f.csv:2: 2 fields, but the header names 3 columns: column 3 is missing"));
}

TEST(MeasurementCsv, UnitsOfHeadings) {
  for (const char* heading : {"width", "width [mm]", "width (mm)", "width / mm", "width/mm",
                              "\"width, mm\"", "width in mm", "width_mm", "Width [mm]"})
    EXPECT_THAT(read(heading + "\n7.65\n"s, "width"), ElementsAre(7.65)) << heading;
  for (const char* heading :
       {"width [um]", "width (\xc2\xb5m)", "width / \xce\xbcm", "width_um", "width_micron"})
    EXPECT_THAT(read(heading + "\n12\n"s, "width"), ElementsAre(0.012)) << heading;
  EXPECT_THAT(read("width [um]\n12\n", "width [um]"), ElementsAre(0.012));
  EXPECT_THAT(read("width [m]\n0.00765\n", "width"), ElementsAre(7.65));
  EXPECT_THAT(read("width [inch]\n1\n", "width"), ElementsAre(testing::DoubleEq(25.4)));
  EXPECT_THAT(read("width (left)\n7.65\n", "width (left)"), ElementsAre(7.65));
  EXPECT_THAT(problem("width [mrad]\n1\n", "width"),
              AllOf(HasSubstr("f.csv:1: column 1 (width [mrad]): the unit 'mrad' is one of angle; "
                              "values in mm are wanted"),
                    HasSubstr("remedy: convert the column, and give its unit in brackets: [mm]")));
  EXPECT_THAT(problem("width [zoll]\n1\n", "width"), HasSubstr("the unit 'zoll' is not known"));
  EXPECT_THAT(problem("width [mm]\n1\n", "width [um]"), HasSubstr("there is no column"));
}

TEST(MeasurementCsv, APureNumberTakesNoUnit) {
  EXPECT_EQ(csv_column("share\n0.5\n", "f", {"share", ""}), std::vector<double>{0.5});
  EXPECT_THROW(csv_column("share [mm]\n0.5\n", "f", {"share", ""}), InputError);
}

TEST(MeasurementCsv, AmbiguousNamesAreRefused) {
  EXPECT_THAT(problem("a,b,a\n1,2,3\n", "a"),
              HasSubstr("f.csv:1: columns 1 and 3 are both called 'a'"));
  EXPECT_THAT(problem("w [mm];w [um]\n1;2\n", "w"), HasSubstr("columns 1 and 2 are both called"));
  EXPECT_THAT(read("w [mm];w [um]\n1;2\n", "w [um]"), ElementsAre(0.002));
  EXPECT_THAT(read("a,b,a\n1,2,3\n", "b"), ElementsAre(2));
  EXPECT_THAT(read("w,W\n1,2\n", "W"), ElementsAre(2));
  EXPECT_THAT(problem("Ab,aB\n1,2\n", "ab"), HasSubstr("columns 1 and 2 are both called"));
}

TEST(MeasurementCsv, ThousandsOfColumns) {
  std::string header = "c0", row = "0";
  for (int i = 1; i < 5000; ++i) header += ",c" + std::to_string(i), row += "," + std::to_string(i);
  EXPECT_THAT(read(header + "\n" + row + "\n", "c4321"), ElementsAre(4321));
  EXPECT_THAT(problem(header + "\n" + row + "\n", "c43210"),
              AllOf(HasSubstr("? the columns are: c0, c1, c2"), HasSubstr(" and 4988 more"),
                    Not(HasSubstr("c99"))));
  EXPECT_THAT(problem(std::string(200000, ','), "a"), HasSubstr("more than 100000 fields"));
}

TEST(MeasurementCsv, NamesWhatIsWrong) {
  EXPECT_THAT(problem("a,b\n1,2\n", "c"),
              HasSubstr("f.csv:1: there is no column 'c'\n  remedy: did you mean"));
  EXPECT_THAT(problem("1,2\n3,4\n", "c"), HasSubstr("the first line holds numbers"));
  EXPECT_THAT(problem("a,b\n1,2mm\n", "b"),
              HasSubstr("column 2 (b) = '2mm': this is not a number"));
  EXPECT_THAT(problem("a,b\n1,\n", "b"), HasSubstr("f.csv:2: column 2 (b): the field is empty"));
  for (const char* wrong : {"nan", "inf", "-inf", "1e999"})
    EXPECT_THAT(problem("a,b\n1,"s + wrong + "\n", "b"), HasSubstr("not a finite number"));
  EXPECT_THAT(problem("", "b"), HasSubstr("no header line"));
  EXPECT_THAT(problem("a,b\n", "b"), HasSubstr("holds no measurements"));
}

TEST(MeasurementCsv, OtherFilesAreNotQuoted) {
  const std::string shadow = "root:$y$j9T$secret:19000:0:99999:7:::\ndaemon:*:19000:0:99999:7:::\n";
  EXPECT_THAT(
      problem(shadow, "width"),
      AllOf(HasSubstr("f.csv:1: there is no column 'width', nor numbers in most lines below"),
            Not(HasSubstr("secret")), Not(HasSubstr("daemon")), Not(HasSubstr("root"))));
  const std::string key = "-----BEGIN KEY-----\nb3BlbnNzaC\nkZXktdjEA\n-----END KEY-----\n";
  EXPECT_THAT(problem(key, "-----BEGIN KEY-----"),
              AllOf(HasSubstr("f.csv:2: column 1"), HasSubstr("this is not a number"),
                    Not(HasSubstr("b3Blb"))));
  EXPECT_THAT(problem("a\n1\n2\n3\n\x1b[31mred\n", "a"), HasSubstr("is a control character"));
}

}  // namespace
}  // namespace cagetol
