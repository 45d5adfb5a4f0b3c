#include "analysis/report/refining_ladder.hpp"

#include <fstream>

namespace cagetol {

Json read_refining_ladder(const std::filesystem::path& sweep_directory) {
  std::ifstream file(sweep_directory / kRefiningLadderFolder / "ladder.json");
  const Json ladder = file ? Json::parse(file, nullptr, false) : Json();
  return ladder.is_object() ? ladder : Json();
}

}  // namespace cagetol
