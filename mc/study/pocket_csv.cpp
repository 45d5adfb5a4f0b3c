#include "mc/study/pocket_csv.hpp"

#include "mc/study/measurement_csv.hpp"
#include "src/input/toml_file.hpp"
#include "src/input/unit.hpp"

namespace cagetol {

std::vector<PocketDeviation> read_pocket_deviations(const std::string& path, long pocket_count,
                                                    bool decimal_comma) {
  const std::string text = read_text_file(path);
  std::vector<PocketDeviation> pockets(static_cast<std::size_t>(pocket_count));
  const auto read = [&](const char* column, double PocketDeviation::*deviation) {
    const std::vector<double> values = csv_column(
        text, path, {std::string(without_unit(column)), unit_of(column).suffix, decimal_comma});
    if (values.size() != pockets.size())
      throw InputError({path, 0}, column, "",
                       std::to_string(values.size()) + " rows, but the cage has " +
                           std::to_string(pocket_count) + " pockets",
                       "give one row for each pocket");
    for (std::size_t j = 0; j < pockets.size(); ++j) pockets[j].*deviation = 1e-3 * values[j];
  };
  read("width_mm", &PocketDeviation::width);
  read("length_mm", &PocketDeviation::length);
  read("pitch_mrad", &PocketDeviation::pitch);
  read("squareness_mrad", &PocketDeviation::squareness);
  return pockets;
}

}  // namespace cagetol
