#!/usr/bin/env bash
# Builds and runs the tests, from a bare Debian 12: ./test.sh [--nightly]
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
nightly=
[ "${1:-}" = --nightly ] && nightly=1
need_packages "${program_packages[@]}" "${test_packages[@]}"
build all
export CAGETOL_NIGHTLY=$nightly
exec ctest --test-dir build --output-on-failure --no-tests=error -j "$(nproc)" --timeout "$([ -n "$nightly" ] && echo 14400 || echo 600)"
