#include "mc/commands/motion_page.hpp"

#include "mc/host/file_write.hpp"
#include "mc/study_file/shipped_file.hpp"
#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

std::string page_part(const std::string& name) {
  return read_text_file(shipped_file("analysis/pages/" + name).string());
}

/// A title may hold a study's name, which holds anything.
std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : text)
    safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

void replace_all(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

}  // namespace

void write_motion_page(const std::string& file, const std::string& title,
                       const MotionFrames& frames) {
  const nlohmann::ordered_json motion = frames.json();
  if (motion.is_null())
    throw InputError({}, "output", file, "the run has no motion to show: it ended before it began",
                     "choose a sample that runs");
  // A scene's name in the data must not end the script.
  std::string data = motion.dump();
  replace_all(data, "</", "<\\/");
  std::string page = page_part("motion.html");
  replace_all(page, "TITLE", html_text(title));
  replace_all(page, "MOTION_CSS", page_part("motion.css"));
  replace_all(page, "MOTION_JS", page_part("motion.js"));
  replace_all(page, "MOTION_DATA", data);
  replace_file(file, page);
}

}  // namespace cagetol
