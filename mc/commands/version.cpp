// cagetol --version: what this program was built from.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mc/commands/command.hpp"
#include "mc/host/build_info.hpp"

namespace cagetol {

void add_version_option(CLI::App& app, Chosen& chosen) {
  app.add_flag_callback(
      "--version",
      [&chosen] {
        chosen = [] {
          const BuildInfo info = build_info();
          std::string text = fmt::format("cagetol {}\ncommit {}\nbuilt with {}\n", info.version,
                                         info.commit, info.compiler);
          const auto libraries = nlohmann::ordered_json::parse(info.libraries);
          for (const auto& [library, version] : libraries.items())
            text += fmt::format("{} {}\n", library, version.get<std::string>());
          print(text);
          return kDone;
        };
      },
      "Print version, commit, compiler and libraries");
}

}  // namespace cagetol
