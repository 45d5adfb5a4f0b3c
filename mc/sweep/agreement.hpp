// What all ranks must agree on before any of them starts: program, command, study, directory. Two
// hosts may hold different files, and mpirun may be given a different command for each rank.
#pragma once

#include <functional>
#include <string>

#include "mc/host/build_info.hpp"
#include "mc/ranks/team.hpp"
#include "mc/study/study.hpp"

namespace cagetol {

/// What went wrong on this rank, if anything.
struct Problem {
  std::string text;
  int code = 0;
};

/// Calls `work` and turns what it throws into a problem: code 75 when writing failed for a passing
/// reason, else that of exit_code_for().
Problem problem_of(const std::function<void()>& work);

/// The exit code that all ranks agree on: 0 when none has a problem. The first rank that has one
/// prints it. Every rank must call it.
int agreed(const Team& team, const Problem& problem);

/// The following throw InputError on one rank, with both ranks, their hosts and values named; the
/// others return. Every rank must call them, and agreed() afterwards.

/// One build of the program, and one kind of `command`.
void check_same_program(const Team& team, const BuildInfo& build, const std::string& command);
/// One study: its keys, its scene and the files that it reads.
void check_same_study(const Team& team, const Study& study);
/// One directory: every rank finds the `file` there that rank 0 has just made.
void check_same_directory(const Team& team, const std::string& directory, const std::string& file);

}  // namespace cagetol
