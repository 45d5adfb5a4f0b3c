// cagetol --man-page and --completion: the manual and bash's completion. Both are made from the
// command line itself, so they always agree with it.
#include <fmt/format.h>

#include <algorithm>

#include "mc/commands/command.hpp"
#include "mc/host/build_info.hpp"
#include "src/catalogue/catalogue.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command);
  return commands;
}

/// Options that are shown to users: not the two of this file.
std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  std::vector<const CLI::Option*> options = app.get_options();
  std::erase_if(options, [](const CLI::Option* option) { return option->get_group().empty(); });
  return options;
}

/// Text of roff: a hyphen is a minus, a line does not begin with a dot or an apostrophe.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool begins = escaped.empty() || escaped.back() == '\n';
    if (begins && (c == '.' || c == '\'')) escaped += "\\&";
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped;
}

std::string option_roff(const CLI::Option& option) {
  std::string name = option.get_name(option.get_positional(), true);
  std::replace(name.begin(), name.end(), ',', ' ');
  // CLI11 adds the permitted values behind a colon.
  const std::string all = option.get_type_name(), type = all.substr(0, all.find(':'));
  if (!type.empty() && !option.get_positional()) name += " " + type;
  return ".TP\n.B " + roff(name) + "\n" + roff(option.get_description()) + "\n";
}

std::string examples_roff(const std::string& footer) {
  return footer.empty() ? "" : ".PP\n.nf\n" + roff(footer) + "\n.fi\n";
}

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH CAGETOL 1 \"\" \"cagetol {}\" \"User Commands\"\n.SH NAME\ncagetol \\- {}\n"
      ".SH SYNOPSIS\n.B cagetol\n.I COMMAND\n[\\fIARGUMENTS\\fR]\n.br\n.B mpirun cagetol\n"
      ".I COMMAND\n[\\fIARGUMENTS\\fR]\n.SH OPTIONS\n",
      build_info().version, roff(app.get_description()));
  for (const CLI::Option* option : options_of(app)) text += option_roff(*option);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app)) {
    text += ".SS " + roff(command->get_name()) + "\n" + roff(command->get_description()) + "\n";
    for (const CLI::Option* option : options_of(*command)) text += option_roff(*option);
    text += examples_roff(command->get_footer());
  }
  return text + ".SH EXIT CODES AND EXAMPLES" + "\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
}

std::string words_of(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string flags_of(const CLI::App& app) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : options_of(app))
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  return words_of(flags);
}

/// Designations as `cagetol scene` takes them without a space: NU208ECP.
std::string designations() {
  std::vector<std::string> names;
  for (const CatalogueRow* row : matching_rows("")) {
    names.push_back(row->designation);
    std::erase(names.back(), ' ');
  }
  return words_of(names);
}

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> commands, keys, quantities;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    commands.push_back(command->get_name());
    cases += fmt::format("    {}) flags=\"{}\" ;;\n", command->get_name(), flags_of(*command));
  }
  for (const auto& key : scene_keys()) keys.push_back(key.name + "=");
  for (const Quantity& quantity : quantity_table()) quantities.emplace_back(quantity.key);
  return "# bash completion of cagetol; written by cagetol --completion\n_cagetol() {\n"
         "  local word=$2 before=$3 command=${COMP_WORDS[1]} flags=\"" +
         flags_of(app) + "\"\n  local commands=\"" + words_of(commands) +
         "\"\n  case $command in\n" + cases +
         "  esac\n"
         "  if [ \"$before\" = --set ]; then\n"
         "    compopt -o nospace\n"
         "    local keys=\"" +
         words_of(keys) +
         "\"\n"
         "    [[ $word == scene.* ]] && keys=\"scene.${keys// / scene.}\"\n"
         "    COMPREPLY=($(compgen -W \"$keys\" -- \"$word\"))\n"
         "  elif [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$flags\" -- \"$word\"))\n"
         "  elif [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n"
         "  elif [ \"$command\" = scene ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         designations() +
         "\" -- \"${word^^}\"))\n"
         "  elif [ \"$command\" = quantities ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         words_of(quantities) +
         "\" -- \"$word\"))\n"
         "  else\n"
         "    compopt -o filenames\n"
         "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -F _cagetol cagetol\n";
}

}  // namespace

void add_manual_options(CLI::App& app, Chosen& chosen) {
  const auto add = [&](const char* name, std::string (*text)(const CLI::App&), const char* what) {
    app.add_flag_callback(
           name,
           [&app, &chosen, text] {
             chosen = [&app, text] {
               print(text(app));
               return kDone;
             };
           },
           what)
        ->group("");  // of the build and of packages
  };
  add("--man-page", man_page, "Print the manual page (roff)");
  add("--completion", bash_completion, "Print the completion script of bash");
}

}  // namespace cagetol
