#include "mc/commands/command.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "src/input/input_error.hpp"

namespace cagetol {

void add_settings_option(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "Give a key another value, as in the file: --set load.radial_N=300 (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw InputError({}, "", "", std::string("cannot write the output: ") + std::strerror(errno),
                     "free space on the disk or choose another place");
}

}  // namespace cagetol
