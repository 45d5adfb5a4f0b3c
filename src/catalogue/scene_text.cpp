#include "src/catalogue/scene_text.hpp"

#include <cmath>
#include <sstream>

#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kWidth = 100;        // of comments
constexpr std::size_t kSourceColumn = 40;  // of the sources of values

std::string quoted(const std::string& text) {
  return '"' + text + '"';
}

}  // namespace

void SceneText::comment(const std::string& text) {
  std::string line = "#", word;
  for (std::istringstream words(text); words >> word; line += " " + word)
    if (line.size() + 1 + word.size() > kWidth) {
      lines_ += line + "\n";
      line = "#";
    }
  lines_ += line + "\n";
}

void SceneText::section(const std::string& name) {
  lines_ += "\n[" + name + "]\n";
}

void SceneText::line(const std::string& key, const std::string& value, const std::string& source) {
  std::string text = key + " = " + value;
  text.resize(std::max(text.size() + 2, kSourceColumn), ' ');
  lines_ += text + "# " + source + "\n";
}

void SceneText::number(const std::string& key, double value, const std::string& source) {
  line(key, number_text(value), source);
}

void SceneText::word(const std::string& key, const std::string& value, const std::string& source) {
  line(key, quoted(value), source);
}

void SceneText::assume(const std::string& key, const std::string& note) {
  assumptions_ += "\n[[assumption]]\nkey = " + quoted(key) + "\nnote = " + quoted(note) + "\n";
}

void SceneText::assume(const std::string& key, const std::string& note, double low, double high) {
  assume(key, note);
  assumptions_ += "low = " + number_text(low) + "\nhigh = " + number_text(high) + "\n";
}

double in_mm(double length) {
  return std::round(1e6 * length) / 1e3;
}

}  // namespace cagetol
