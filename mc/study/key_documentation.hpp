// The keys of input files as text: files to start from, and the tables of inputs/KEYS.md.
#pragma once

#include <string>

namespace cagetol {

/// A scene file with every key at its default, commented. Reads back to the defaults.
std::string default_scene_text();

/// A study file with every plain key at its default and its scene below [scene]; limits, tolerances
/// and correlations as comments.
std::string default_study_text();

/// Every key of scene and study in Markdown: unit, default, range, meaning.
std::string key_documentation();

}  // namespace cagetol
