// cagetol --dump-default scene|study|keys: the defaults as files to start from, and the tables of
// inputs/KEYS.md.
#include "mc/commands/command.hpp"
#include "mc/study/key_documentation.hpp"

namespace cagetol {

void add_dump_default_option(CLI::App& app, Chosen& chosen) {
  app.add_option_function<std::string>(
         "--dump-default",
         [&chosen](const std::string& what) {
           chosen = [what] {
             print(what == "scene"   ? default_scene_text()
                   : what == "study" ? default_study_text()
                                     : key_documentation());
             return kDone;
           };
         },
         "Print a scene or study file with every default, or the table of all keys (Markdown)")
      ->type_name("scene|study|keys")
      ->check(CLI::IsMember({"scene", "study", "keys"}));
}

}  // namespace cagetol
