// A run of one sample, with its time histories in a file where -o FILE.h5 asks for them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "mc/study/sample.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

void add_history_option(CLI::App& command, std::string& history);

/// Runs the sample and writes its time histories, unless `history` is empty. Throws InputError
/// where it has none or the file cannot be written.
Outcome recorded_run(const Study& study, const Sample& sample, const std::string& history);

}  // namespace cagetol
