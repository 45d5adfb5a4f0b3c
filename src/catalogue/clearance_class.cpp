#include "src/catalogue/clearance_class.hpp"

#include <stdexcept>

namespace cagetol {
namespace {

struct TableRow {
  double largest_bore;   // [mm]
  ClearanceRange of[4];  // C2, CN, C3, C4 [um]
};

// clang-format off
constexpr TableRow kTable[] = {
    { 24, {{ 0,  25}, { 20,  45}, { 35,  60}, { 50,  75}}},
    { 30, {{ 0,  25}, { 20,  45}, { 35,  60}, { 50,  75}}},
    { 40, {{ 5,  30}, { 25,  50}, { 45,  70}, { 60,  85}}},
    { 50, {{ 5,  35}, { 30,  60}, { 50,  80}, { 70, 100}}},
    { 65, {{10,  40}, { 40,  70}, { 60,  90}, { 80, 110}}},
    { 80, {{10,  45}, { 40,  75}, { 65, 100}, { 90, 125}}},
    {100, {{15,  50}, { 50,  85}, { 75, 110}, {105, 140}}},
    {120, {{15,  55}, { 50,  90}, { 85, 125}, {125, 165}}},
    {140, {{15,  60}, { 60, 105}, {100, 145}, {145, 190}}},
    {160, {{20,  70}, { 70, 120}, {115, 165}, {165, 215}}},
    {180, {{25,  75}, { 75, 125}, {120, 170}, {170, 220}}},
    {200, {{35,  90}, { 90, 145}, {140, 195}, {195, 250}}},
    {225, {{45, 105}, {105, 165}, {160, 220}, {220, 280}}},
    {250, {{45, 110}, {110, 175}, {170, 235}, {235, 300}}},
};
// clang-format on

}  // namespace

ClearanceRange clearance_range(ClearanceClass which, double bore) {
  for (const TableRow& row : kTable) {
    if (1e3 * bore > row.largest_bore * (1 + 1e-9)) continue;  // rounding
    const ClearanceRange& range = row.of[static_cast<int>(which)];
    return {1e-6 * range.minimum, 1e-6 * range.most};
  }
  throw std::domain_error("clearance: the table ends at a bore of 250 mm");
}

}  // namespace cagetol
