#include "mc/commands/output_path.hpp"

#include <algorithm>
#include <climits>
#include <filesystem>
#include <fstream>

#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

// Room for what a command puts below its directory, such as
// mixture/fidelity/first-look/quasi-static/journal/rank0000-0123456789abcdef.journal, and for
// ".part1234567".
constexpr std::size_t kRoomBelow = 200;
constexpr std::size_t kRoomOfSuffix = 24;

std::string quoted(const std::string& path) {
  constexpr std::size_t longest = 80;
  std::string text = path.size() > longest ? path.substr(0, longest - 3) + "..." : path;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return "\"" + text + "\"";
}

[[noreturn]] void refuse(const std::string& option, const std::string& path,
                         const std::string& problem, const std::string& remedy) {
  throw InputError({}, option, quoted(path), problem, remedy);
}

void check_name(const std::string& option, const std::string& path, std::size_t room) {
  if (path.find_first_not_of(" \t\r\n") == std::string::npos)
    refuse(option, path, path.empty() ? "the name is empty" : "the name is blank",
           "give a name, for example out/nu205");
  if (std::any_of(path.begin(), path.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    refuse(option, path, "the name holds a control character, such as a line break",
           "give a name without it");
  if (path.size() + room > PATH_MAX)
    refuse(option, path,
           "the name has " + std::to_string(path.size()) + " characters; with what is put below " +
               "it, it is longer than the system's " + std::to_string(PATH_MAX),
           "give a shorter name");
  for (const fs::path& part : fs::path(path))
    if (part.native().size() + kRoomOfSuffix > NAME_MAX)
      refuse(option, path,
             "a part of the name has " + std::to_string(part.native().size()) +
                 " characters; the system allows " + std::to_string(NAME_MAX) +
                 ", some of which temporary files need",
             "give a shorter name");
}

const char* kind_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::regular:
      return "a file";
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::symlink:
      return "a link to nothing";
    default:
      return "a device, a pipe or a socket";
  }
}

/// The nearest folder above, or the path itself, that there is.
fs::path existing_part(fs::path path) {
  std::error_code error;
  while (!path.empty() && fs::symlink_status(path, error).type() == fs::file_type::not_found) {
    const fs::path above = path.parent_path();
    if (above == path) break;
    path = above;
  }
  return path.empty() ? fs::path(".") : path;
}

}  // namespace

void check_output_directory(const std::string& option, const std::string& directory) {
  check_name(option, directory, kRoomBelow);
  std::error_code error;
  // A file above the directory makes every status below it an error: then ask that file.
  for (fs::path path = existing_part(directory); !path.empty(); path = path.parent_path()) {
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::directory) return;
    if (fs::exists(status) || fs::is_symlink(fs::symlink_status(path, error)))
      refuse(option, directory,
             path.string() + " is " +
                 kind_of(fs::exists(status) ? status.type() : fs::file_type::symlink) +
                 ", not a folder",
             "choose another output directory with " + option);
    if (path == path.parent_path()) return;
  }
}

void check_output_file(const std::string& option, const std::string& file,
                       const std::string& begins) {
  check_name(option, file, kRoomOfSuffix);
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && status.type() != fs::file_type::regular)
    refuse(option, file, std::string("this is ") + kind_of(status.type()) + ", not a file",
           "give the name of a file to write");
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    refuse(option, file, "there is no folder " + folder.string(),
           "make the folder, or choose another place with " + option);
  if (fs::path(file).filename().empty())
    refuse(option, file, "this is a folder, not a file", "give the name of a file to write");
  std::string head(begins.size(), '\0');
  std::ifstream existing(file, std::ios::binary);
  existing.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::string name = fs::path(file).filename();
  const bool of_sweep = name == "study.h5" || name == "report.html";
  if (existing.gcount() > 0 && (head != begins || of_sweep))
    refuse(option, file, "there is a file that this command did not write",
           "choose another name, or remove that file first");
}

void check_result_directory(const std::string& option, const std::string& directory) {
  check_name(option, directory, kRoomBelow);
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (fs::exists(status) && !fs::is_directory(status))
    refuse(option, directory, std::string("this is ") + kind_of(status.type()) + ", not a folder",
           "give the directory of a sweep, in which study.h5 is");
  for (const char* name : {"study.h5", "mixture/study.h5"}) {
    const fs::file_status file = fs::status(fs::path(directory) / name, error);
    if (fs::exists(file) && file.type() != fs::file_type::regular)
      refuse(option, directory, std::string(name) + " there is " + kind_of(file.type()),
             "give the directory of a sweep");
  }
}

CLI::Option* add_output_directory(CLI::App& command, std::string& directory,
                                  const std::string& description) {
  return command.add_option("-o,--output", directory, description)
      ->required()
      ->check([](const std::string& path) {
        check_output_directory("-o", path);
        return std::string();
      });
}

CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& file,
                             const std::string& begins, const std::string& description) {
  const std::string option = names.substr(0, names.find(','));
  return command.add_option(names, file, description)
      ->check([option, begins](const std::string& path) {
        check_output_file(option, path, begins);
        return std::string();
      });
}

CLI::Option* add_result_directory(CLI::App& command, const std::string& name,
                                  std::string& directory, const std::string& description) {
  return command.add_option(name, directory, description)
      ->required()
      ->check([name](const std::string& path) {
        check_result_directory(name, path);
        return std::string();
      });
}

}  // namespace cagetol
