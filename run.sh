#!/usr/bin/env bash
# The default study, from a bare Debian 12 to its report: ./run.sh [STUDY [OUTPUT_DIR]]
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
study=${1:-inputs/studies/nu205.toml}
out=${2:-out/$(basename "$study" .toml)}
can_install || need_packages "${program_packages[@]}" "${figure_packages[@]}" # one line to run, for all
need_packages "${program_packages[@]}"
need_packages "${figure_packages[@]}" & # while the program is built
build cagetol
wait $!
ranks=$(nproc)
echo "Sweeping $study with $ranks ranks"
progress=plain; [ -t 2 ] && progress=line
mpirun -n "$ranks" build/cagetol sweep "$study" -o "$out" --progress "$progress"
build/cagetol report "$out"
