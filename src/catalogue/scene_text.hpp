// A scene file as text, line by line: sections, keys with the source of their values, assumptions.
#pragma once

#include <string>

namespace cagetol {

class SceneText {
 public:
  /// Lines of comment before what follows, broken at 100 columns.
  void comment(const std::string& text);
  void section(const std::string& name);
  /// `source` stands behind the value: where it is from.
  void number(const std::string& key, double value, const std::string& source);
  void word(const std::string& key, const std::string& value, const std::string& source);
  void flag(const std::string& key, const std::string& source) { line(key, "true", source); }
  /// An [[assumption]] entry, written after all sections.
  void assume(const std::string& key, const std::string& note);
  void assume(const std::string& key, const std::string& note, double low, double high);

  std::string str() const { return lines_ + assumptions_; }

 private:
  void line(const std::string& key, const std::string& value, const std::string& source);

  std::string lines_, assumptions_;
};

/// `length` in mm, to a micrometre.
double in_mm(double length);

}  // namespace cagetol
