#include "src/input/toml_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "src/input/printable.hpp"

namespace cagetol {
namespace {

constexpr const char* kSettings = "--set";
constexpr std::uintmax_t kLargestFile = 16u << 20;
constexpr std::size_t kLongestLine = 16384;

constexpr std::size_t kLongestKey = 32;

/// A file descriptor, closed once.
struct OpenFile {
  int descriptor = -1;
  explicit OpenFile(int opened) : descriptor(opened) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

/// Parts of the longest dotted name in a line, "a.b.'c d'": each part is a table inside the other.
std::size_t longest_dotted_name(std::string_view line) {
  std::size_t longest = 0, parts = 0;
  bool in_part = false;  // the last character that counts belongs to a part
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' || c == '\'') {
      const auto end = line.find(c, i + 1);
      i = std::min(end, line.size() - 1);
      parts += in_part ? 0 : 1;
      in_part = true;
    } else if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-') {
      parts += in_part ? 0 : 1;
      in_part = true;
    } else if (c == '.') {
      in_part = false;
    } else if (c != ' ' && c != '\t') {
      parts = 0;
      in_part = false;
    }
    longest = std::max(longest, parts);
  }
  return longest;
}

/// Tables a hundred thousand deep would take more stack than there is, wherever they are walked.
void refuse_long_names(std::string_view line, const SourcePlace& place) {
  const std::size_t parts = longest_dotted_name(line);
  if (parts > kLongestKey)
    throw InputError(place, "", "",
                     "a key of " + std::to_string(parts) + " parts: keys have at most three",
                     "write keys like cage.pocket_width_mm");
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 100;
  return text.size() > longest ? text.substr(0, longest - 3) + "..." : text;
}

bool is_bare_word(std::string_view text) {
  if (text.empty() || !(std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '/' ||
                        text[0] == '.' || text[0] == '_'))
    return false;
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) ||
           std::string_view("_-./").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// The value part of a setting as a table with the single key "value".
toml::table setting_value(const std::string& setting, std::string_view value) {
  try {
    auto parsed = toml::parse("value = " + std::string(value), std::string_view(kSettings));
    if (parsed.size() == 1) return parsed;
  } catch (const std::exception&) {  // a parse_error, or the parser's own assertion
    if (is_bare_word(value))
      return toml::parse("value = '" + std::string(value) + "'", std::string_view(kSettings));
  }
  throw InputError({kSettings, 0}, "", "", "cannot read the value of '" + shortened(setting) + "'",
                   "write the value as in a TOML file: a number, true, false, a word, 'a text', "
                   "[1, 2] or { lot = { law = 'normal', sigma = 0.01 } }");
}

void walk(const toml::table& table, const std::string& prefix,
          const std::function<bool(const toml::table&)>& stop_at, std::vector<TomlLeaf>& leaves) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    const auto* inner = node.as_table();
    if (inner && !inner->empty() && !(stop_at && stop_at(*inner)))
      walk(*inner, name + ".", stop_at, leaves);
    else
      leaves.push_back({name, &node});
  }
}

void insert_moved(toml::table& table, std::string_view key, toml::node&& node) {
  std::move(node).visit(
      [&](auto&& value) { table.insert_or_assign(key, std::forward<decltype(value)>(value)); });
}

std::vector<std::string> parts_of(std::string_view name) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const auto dot = name.find('.', begin);
    parts.emplace_back(name.substr(begin, dot == std::string_view::npos ? dot : dot - begin));
    if (dot == std::string_view::npos) return parts;
    begin = dot + 1;
  }
}

}  // namespace

std::string read_text_file(const std::string& path) {
  const auto refuse = [&](const std::string& problem, const std::string& remedy) {
    return InputError({path, 0}, "", "", problem, remedy);
  };
  if (path.find_first_not_of(" \t") == std::string::npos)
    throw InputError({}, "FILE", "\"" + path + "\"", "the name of the file is empty",
                     "give the path of a file");
  // Opening waits for nobody at the other end of a pipe; what was opened is what is asked about.
  const OpenFile file{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  if (file.descriptor < 0 && (errno == ENOENT || errno == ENOTDIR))
    throw refuse("no such file",
                 "check the path (relative paths start at the current folder, those inside a "
                 "study at the study's folder)");
  struct stat status {};
  if (file.descriptor < 0 || ::fstat(file.descriptor, &status) != 0)
    throw refuse(std::string("cannot be read: ") + std::strerror(errno),
                 errno == EMFILE || errno == ENFILE ? "raise the limit on open files (ulimit -n)"
                                                    : "check the path and the file's permissions");
  if (S_ISDIR(status.st_mode)) throw refuse("this is a folder, not a file", "name a file in it");
  if (!S_ISREG(status.st_mode))
    throw refuse("this is a device or a pipe, which may never end",
                 "write what it gives into an ordinary file and name that");
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > kLargestFile)
    throw refuse("the file has " + std::to_string(size) + " bytes; input files are read up to " +
                     std::to_string(kLargestFile),
                 "check that this is the file you meant");
  std::string text;
  std::array<char, 65536> part;
  ssize_t count = 0;
  while (text.size() <= kLargestFile &&
         (count = ::read(file.descriptor, part.data(), part.size())) != 0) {
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw refuse(std::string("cannot be read: ") + std::strerror(errno), "check the file");
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  if (text.size() > kLargestFile)
    throw refuse("it grows while it is read, beyond " + std::to_string(kLargestFile) + " bytes",
                 "name a file that is complete");
  return text;
}

toml::table read_toml(const std::string& path) {
  return parse_toml(read_text_file(path), path);
}

namespace {

// The first line on which the parser gives up without saying where: 0 for texts too long to try.
int line_of_broken_parse(std::string_view text) {
  constexpr std::size_t longest = 100000;
  int line = 1;
  for (std::size_t end = text.find('\n'); text.size() < longest;
       end = text.find('\n', end + 1), ++line) {
    try {
      [[maybe_unused]] const auto parsed = toml::parse(text.substr(0, end));
    } catch (const std::logic_error&) {
      return line;
    } catch (const std::exception&) {
    }
    if (end == std::string_view::npos) break;
  }
  return 0;
}

/// How a text was saved that is not UTF-8 with usual line ends; empty where it may be.
std::string other_encoding(std::string_view text) {
  const auto zero = [&](std::size_t i) { return i < text.size() && text[i] == '\0'; };
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || (zero(1) && zero(3)) ||
      (zero(0) && zero(2)))
    return "UTF-16";
  if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
    return "lines that end with CR alone, as on old Macintoshes";
  if (text.find('\0') != std::string_view::npos) return "";  // no text at all
  std::size_t follow = 0;                                    // bytes of a character still to come
  for (const unsigned char c : text) {
    const bool within = (c & 0xc0) == 0x80;
    if (within != (follow > 0)) return "Latin-1 or Windows-1252";
    follow = within ? follow - 1 : c < 0x80 ? 0 : c >= 0xf0 ? 3 : c >= 0xe0 ? 2 : 1;
  }
  return "";
}

InputError not_toml(const std::string& name, int line, const std::string& description) {
  return {{name, line},
          "",
          "",
          "not valid TOML: " + description,
          "correct the line; keys look like  pocket_width_mm = 7.65  below a section like  [cage]"};
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& name) {
  if (const std::string as = other_encoding(text); !as.empty())
    throw InputError({name, 0}, "", "", "the file is not in UTF-8: it looks like " + as,
                     "save it as UTF-8, with line ends as usual");
  // A dotted key of a million parts would be a table a million deep: no input file needs such
  // lines.
  int line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const auto end = std::min(text.find('\n', begin), text.size());
    if (end - begin > kLongestLine)
      throw InputError({name, line}, "", "",
                       "a line of " + std::to_string(end - begin) +
                           " characters: this does not look like a TOML file",
                       "break lines before " + std::to_string(kLongestLine) + " characters");
    refuse_long_names(text.substr(begin, end - begin), {name, line});
    begin = end + 1;
  }
  try {
    return toml::parse(text, std::string_view(name));
  } catch (const toml::parse_error& error) {
    // What the parser saw is left out: the file may be no TOML at all, and nobody's business.
    const std::string_view description = error.description();
    throw not_toml(name, static_cast<int>(error.source().begin.line),
                   excerpt(description.substr(0, description.find(", saw")), 200));
  } catch (const std::logic_error&) {
    throw not_toml(name, line_of_broken_parse(text), "a key or a value is missing or misplaced");
  }
}

std::string setting_key(const std::string& setting) {
  const auto equals = setting.find('=');
  std::string key(trimmed(std::string_view(setting).substr(0, equals)));
  const auto parts = parts_of(key);
  if (equals == std::string::npos ||
      std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); }))
    throw InputError({kSettings, 0}, "", "",
                     "'" + shortened(setting) + "' is not of the form key=value",
                     "write for example --set load.radial_N=300");
  return key;
}

void apply_setting(toml::table& root, const std::string& setting) {
  refuse_long_names(setting, {kSettings, 0});
  const std::string key = setting_key(setting);
  auto value =
      setting_value(setting, trimmed(std::string_view(setting).substr(setting.find('=') + 1)));
  const auto parts = parts_of(key);
  toml::table* table = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    auto* node = table->get(parts[i]);
    if (!node) node = &table->insert(parts[i], toml::table{}).first->second;
    table = node->as_table();
    if (!table)
      throw InputError({kSettings, 0}, key, "", "'" + parts[i] + "' holds a value, not keys",
                       "set it whole, for example --set " + parts[i] + "=...");
  }
  insert_moved(*table, parts.back(), std::move(*value.get("value")));
}

void merge_tables(toml::table& base, toml::table&& overrides,
                  const std::function<bool(const toml::table&)>& stop_at) {
  for (auto&& [key, node] : overrides) {
    auto* inner = node.as_table();
    auto* existing = base.get(key.str());
    auto* existing_table = existing ? existing->as_table() : nullptr;
    if (inner && existing_table && !stop_at(*inner))
      merge_tables(*existing_table, std::move(*inner), stop_at);
    else
      insert_moved(base, key.str(), std::move(node));
  }
}

std::vector<TomlLeaf> toml_leaves(const toml::table& root,
                                  const std::function<bool(const toml::table&)>& stop_at) {
  std::vector<TomlLeaf> leaves;
  walk(root, "", stop_at, leaves);
  return leaves;
}

const toml::node* find_node(const toml::table& root, std::string_view name) {
  const toml::node* node = &root;
  for (const auto& part : parts_of(name)) {
    const auto* table = node->as_table();
    node = table ? table->get(part) : nullptr;
    if (!node) return nullptr;
  }
  return node;
}

SourcePlace place_of(const toml::node& node, const std::string& file) {
  const auto& source = node.source();
  const std::string name = source.path ? *source.path : file;
  return {name, name == kSettings ? 0 : static_cast<int>(source.begin.line)};
}

std::string shown(const toml::node& node) {
  constexpr std::size_t longest = 60;
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  std::string result = text.str();
  std::replace(result.begin(), result.end(), '\n', ' ');
  if (result.size() > longest) result = result.substr(0, longest - 3) + "...";
  return result;
}

const char* type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

}  // namespace cagetol
