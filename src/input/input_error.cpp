#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

std::string message(const SourcePlace& place, const std::string& key, const std::string& value,
                    const std::string& problem, const std::string& remedy) {
  std::string text = place.file;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  if (!key.empty()) text += key;
  if (!value.empty()) text += " = " + value;
  if (!key.empty()) text += ": ";
  text += problem;
  if (!remedy.empty()) text += "\n  remedy: " + remedy;
  return text;
}

}  // namespace

InputError::InputError(const SourcePlace& place, const std::string& key, const std::string& value,
                       const std::string& problem, const std::string& remedy)
    : std::runtime_error(message(place, key, value, problem, remedy)) {}

}  // namespace cagetol
