// What subcommands (subcommands.hpp) share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mc/host/progress.hpp"
#include "mc/study_file/exit_code.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct Study;

/// What a command line asks for; returns the exit code of the program.
using Chosen = std::function<int()>;

/// --dump-default scene|study|keys, an option of the program itself.
void add_dump_default_option(CLI::App& app, Chosen& chosen);
/// --version, likewise.
void add_version_option(CLI::App& app, Chosen& chosen);

/// Beyond the ids of all samples: -1 would become 18446744073709551615.
constexpr long kMostSamples = 9999999999;

/// The repeatable option --set dotted.key=value of every command that reads a file.
void add_settings_option(CLI::App& command, std::vector<std::string>& settings);

/// Where a given temperature cannot be held, a sentence each; runs each point for a moment.
std::vector<std::string> heat_doubts(const Study& study);

/// What is worth knowing of a study before it is swept: notes and warnings, as log lines.
void log_notes(const Study& study, const std::vector<std::string>& notes);

/// Reads a study when it is called, and logs its notes (study_notes).
std::function<Study()> reading_study(const std::string& file,
                                     const std::vector<std::string>& settings);

/// The option --progress of every command that sweeps.
void add_progress_option(CLI::App& command, ProgressStyle& style);

/// The option --methods a,b: names of integration methods, checked.
void add_methods_option(CLI::App& command, std::vector<IntegrationMethod>& methods);

/// Throws InputError where the scene is quasi-static; `option` with `value` asks for what only an
/// integrated motion has, `what`.
void require_dynamic(const Scene& scene, const std::string& option, const std::string& value,
                     const std::string& what);

/// Prints a text on standard output. Throws InputError when it cannot be written (a full disk, a
/// closed pipe).
void print(const std::string& text);

/// Draws a JSON file's figures into figures/ beside it and returns that folder; what went wrong is
/// said on standard error.
std::string draw_beside(const std::filesystem::path& json);

/// Writes KIND.json, `rows` without what they nest as KIND.csv, KIND.html and, where asked for,
/// KIND.pdf, KIND as `result` has it. Problems of pages are said on standard error.
void write_result(const nlohmann::ordered_json& result, const nlohmann::ordered_json& rows,
                  const std::filesystem::path& directory, bool pdf = false);

}  // namespace cagetol
