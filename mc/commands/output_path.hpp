// Where a command writes: every -o is checked here, before anything is computed.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cagetol {

/// -o, --output: a directory, required, which the command makes where it is missing.
CLI::Option* add_output_directory(CLI::App& command, std::string& directory,
                                  const std::string& description);

/// `names` ("-o,--output"): a file that is written or replaced; not required. What the command
/// writes begins with `begins`: no other file is replaced.
CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& file,
                             const std::string& begins, const std::string& description);

/// DIR, required: a directory that holds results.
CLI::Option* add_result_directory(CLI::App& command, const std::string& name,
                                  std::string& directory, const std::string& description);

/// Throw InputError with reason and remedy for names that are empty or blank, hold control
/// characters (a line break would end the name in messages between ranks) or are too long for the
/// system with what is put below them; for a directory, where something else has its name or that
/// of a folder above it; for a file, where it is no ordinary file or its folder does not exist, and
/// where one is there that does not begin with `begins` or is a sweep's own.
void check_output_directory(const std::string& option, const std::string& directory);
void check_output_file(const std::string& option, const std::string& file,
                       const std::string& begins);

/// Likewise for a directory that is read: its study.h5 must not be a pipe or a device. That there
/// is one is for its readers to say.
void check_result_directory(const std::string& option, const std::string& directory);

}  // namespace cagetol
