#include "mc/commands/motion_page.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

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

/// The page with each word replaced, in one pass: what stands in for a word is not read again.
std::string filled(std::string_view page,
                   std::initializer_list<std::pair<std::string_view, std::string>> words) {
  std::string text;
  while (!page.empty()) {
    const auto word = std::find_if(words.begin(), words.end(), [&](const auto& entry) {
      return page.starts_with(entry.first);
    });
    text += word == words.end() ? std::string(page.substr(0, 1)) : word->second;
    page.remove_prefix(word == words.end() ? 1 : word->first.size());
  }
  return text;
}

}  // namespace

void write_motion_page(const std::string& file, const std::string& title,
                       const MotionFrames& frames) {
  const nlohmann::ordered_json motion = frames.json();
  if (motion.is_null())
    throw InputError({}, "output", file, "the run has no motion to show: it ended before it began",
                     "choose a sample that runs");
  // A scene's name in the data must not end the script, nor begin a comment of the page.
  replace_file(file, filled(page_part("motion.html"),
                            {{"TITLE", html_text(title)},
                             {"MOTION_CSS", page_part("motion.css")},
                             {"MOTION_JS", page_part("motion.js")},
                             {"MOTION_DATA", filled(motion.dump(), {{"<", "\\u003c"}})}}));
}

}  // namespace cagetol
