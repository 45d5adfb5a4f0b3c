#include "distributions/iso286.hpp"

#include <array>
#include <charconv>

#include "distributions/basics/require.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kGrades = kCoarsestGrade - kFinestGrade + 1;

// One range of nominal sizes: above the previous row's end, up to and including its own.
struct SizeRange {
  double up_to_mm;
  std::array<double, kGrades> width_um;
};

// clang-format off
constexpr std::array<SizeRange, 13> kTable = {{
    //  mm   IT5  IT6  IT7  IT8  IT9 IT10 IT11 IT12 IT13  IT14
    {  3, {   4,   6,  10,  14,  25,  40,  60, 100, 140,  250}},
    {  6, {   5,   8,  12,  18,  30,  48,  75, 120, 180,  300}},
    { 10, {   6,   9,  15,  22,  36,  58,  90, 150, 220,  360}},
    { 18, {   8,  11,  18,  27,  43,  70, 110, 180, 270,  430}},
    { 30, {   9,  13,  21,  33,  52,  84, 130, 210, 330,  520}},
    { 50, {  11,  16,  25,  39,  62, 100, 160, 250, 390,  620}},
    { 80, {  13,  19,  30,  46,  74, 120, 190, 300, 460,  740}},
    {120, {  15,  22,  35,  54,  87, 140, 220, 350, 540,  870}},
    {180, {  18,  25,  40,  63, 100, 160, 250, 400, 630, 1000}},
    {250, {  20,  29,  46,  72, 115, 185, 290, 460, 720, 1150}},
    {315, {  23,  32,  52,  81, 130, 210, 320, 520, 810, 1300}},
    {400, {  25,  36,  57,  89, 140, 230, 360, 570, 890, 1400}},
    {500, {  27,  40,  63,  97, 155, 250, 400, 630, 970, 1550}},
}};
// clang-format on

const SizeRange& range_of(double nominal_mm) {
  require(nominal_mm > 0 && nominal_mm <= kTable.back().up_to_mm, "ISO 286 grades need a nominal ",
          "size above 0 and up to ", kTable.back().up_to_mm, " mm, not ", nominal_mm,
          " mm; give the tolerance width in mm");
  for (const auto& range : kTable)
    if (nominal_mm <= range.up_to_mm) return range;
  return kTable.back();
}

}  // namespace

double grade_width_um(int grade, double nominal_mm) {
  require(grade >= kFinestGrade && grade <= kCoarsestGrade, "there is no IT", grade,
          " here; choose from IT", kFinestGrade, " to IT", kCoarsestGrade);
  return range_of(nominal_mm).width_um[static_cast<std::size_t>(grade - kFinestGrade)];
}

std::optional<int> grade_within(double width_um, double nominal_mm) {
  const auto& widths = range_of(nominal_mm).width_um;
  std::optional<int> coarsest;
  for (std::size_t i = 0; i < widths.size(); ++i)
    if (widths[i] <= width_um) coarsest = kFinestGrade + static_cast<int>(i);
  return coarsest;
}

std::optional<int> grade_number(std::string_view name) {
  if (!name.starts_with("IT")) return std::nullopt;
  int grade = 0;
  const auto* end = name.data() + name.size();
  const auto result = std::from_chars(name.data() + 2, end, grade);
  if (result.ec != std::errc{} || result.ptr != end || grade < 0) return std::nullopt;
  return grade;
}

std::optional<ToleranceClass> tolerance_class(std::string_view name) {
  const auto letters = name.substr(0, name.find_first_of("0123456789"));
  const auto grade = grade_number("IT" + std::string(name.substr(letters.size())));
  if (!grade || (letters != "IT" && letters != "js" && letters != "JS" && letters != "H"))
    return std::nullopt;
  return ToleranceClass{*grade, letters == "H" ? 0.5 : 0};
}

std::string grade_name(int grade) {
  return "IT" + std::to_string(grade);
}

}  // namespace cagetol
