// Standard tolerance grades of ISO 286-1 (2010), table 1: width of the tolerance for a grade
// and a nominal size, as rounded in the standard. Grades IT5 to IT14, sizes up to 500 mm. A size on
// the border of two ranges belongs to the lower one ("above 6 up to and including 10 mm").
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cagetol {

inline constexpr int kFinestGrade = 5;
inline constexpr int kCoarsestGrade = 14;

/// Full width of the tolerance in um. Throws std::invalid_argument with the valid range for other
/// grades or sizes.
double grade_width_um(int grade, double nominal_mm);

/// The coarsest grade with a tolerance not wider than `width_um`; empty if the finest grade is
/// wider. Throws std::invalid_argument for sizes outside the table.
std::optional<int> grade_within(double width_um, double nominal_mm);

/// 9 for "IT9"; empty for any other form. Does not check that the table has the grade.
std::optional<int> grade_number(std::string_view name);

/// A tolerance class: its grade, and the middle of its zone above the nominal size, as a share of
/// its width.
struct ToleranceClass {
  int grade = 0;
  double middle = 0;
};

/// Of "IT9", "js9" and "JS9", which lie about the nominal size, and of "H9", which begins there;
/// empty for any other form. Does not check that the table has the grade.
std::optional<ToleranceClass> tolerance_class(std::string_view name);

/// "IT9".
std::string grade_name(int grade);

}  // namespace cagetol
