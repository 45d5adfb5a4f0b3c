#include "src/input/input_error.hpp"

#include "src/input/printable.hpp"

namespace cagetol {
namespace {

std::string message(const SourcePlace& place, const std::string& key, const std::string& value,
                    const std::string& problem, const std::string& remedy) {
  std::string text = printable(place.file);
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  if (!key.empty()) text += printable(key);
  if (!value.empty()) text += " = " + printable(value);
  if (!key.empty()) text += ": ";
  text += printable(problem, LineBreaks::kept);
  if (!remedy.empty()) text += "\n  remedy: " + printable(remedy, LineBreaks::kept);
  return text;
}

}  // namespace

InputError::InputError(const SourcePlace& place, const std::string& key, const std::string& value,
                       const std::string& problem, const std::string& remedy)
    : std::runtime_error(message(place, key, value, problem, remedy)) {}

}  // namespace cagetol
