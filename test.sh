#!/usr/bin/env bash
# Builds and runs the tests, from a bare Debian 12: ./test.sh [--nightly]
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
nightly=
[ "${1:-}" = --nightly ] && nightly=1
need_packages "${program_packages[@]}" "${figure_packages[@]}" "${test_packages[@]}"
[ -n "$nightly" ] && need_packages chromium # plays the animations
build all
[ -n "$nightly" ] && export CAGETOL_NIGHTLY=1
which=(--label-exclude nightly --timeout 600)
[ -n "$nightly" ] && which=(--timeout 14400)
# One more than cores: tests of ranks, of which one runs at a time, mostly wait.
exec ctest --test-dir build --output-on-failure --no-tests=error -j "$(($(cores) + 1))" "${which[@]}"
