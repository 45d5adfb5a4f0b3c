// The subcommands of cagetol as a table: a new one is a file of its own and a row here.
#pragma once

#include "mc/commands/command.hpp"

namespace cagetol {

/// Declares all subcommands with their options. The one that the command line chooses leaves what
/// is to be done in `chosen`.
void add_subcommands(CLI::App& app, Chosen& chosen);

}  // namespace cagetol
