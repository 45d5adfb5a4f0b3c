// The text of inputs/catalogue.csv, built into the program: a moved program still has it.
#pragma once

#include <string_view>

namespace cagetol {

std::string_view catalogue_table();

}  // namespace cagetol
