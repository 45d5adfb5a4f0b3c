#include "mc/study_file/tolerance.hpp"

namespace cagetol {

bool is_size(const std::string& key) {
  const std::string name = key.substr(key.rfind('.') + 1);
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return name.ends_with("_mm") && !has("film") &&
         (has("diameter") || has("width") || has("length"));
}

}  // namespace cagetol
