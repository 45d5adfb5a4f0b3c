# Sourced by run.sh and test.sh from the project's root: Debian packages, the build, and what Open MPI wants to hear.

can_install() { [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null && sudo -n true 2>/dev/null; }; }

# need_packages PACKAGE...: installs what is missing, as root or through sudo; else prints the line to run and stops.
need_packages() {
  local missing=() p
  for p in "$@"; do dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing+=("$p"); done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  local as=""
  if [ "$(id -u)" -ne 0 ]; then
    if can_install; then as="sudo"; else
      echo "Not root, and sudo wants a password. Run this line, then start again:" >&2
      echo "  sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}" >&2
      exit 2
    fi
  fi
  local log; log=$(mktemp)
  if ! { $as apt-get update -qq && $as env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "Installing packages failed; the whole output is in $log." >&2
    exit 2
  fi
  rm -f "$log"
}

# libblas-dev and liblapack-dev: else apt takes OpenBLAS's threaded build for SuiteSparse's sake, whose threads hinder
# ranks and, where memory is short, end the program with a signal.
program_packages=(g++ cmake ninja-build pkg-config git ca-certificates
  libeigen3-dev libsundials-dev libopenmpi-dev openmpi-bin libhdf5-dev libgsl-dev libspectra-dev libsuitesparse-dev
  libopenblas0-serial libblas-dev liblapack-dev libboost-dev librandom123-dev libtomlplusplus-dev libcli11-dev
  libfmt-dev libspdlog-dev
  nlohmann-json3-dev help2man)
figure_packages=(python3 python3-jinja2 python3-matplotlib python3-h5py fonts-dejavu-core weasyprint)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev calculix-ccx python3-scipy python3-pandas python3-pip
  python3-setuptools poppler-utils clang-format-14)

# Cores that this process may use, by its affinity and the quota of its control group.
cores() {
  local count quota period
  count=$(nproc)
  if { read -r quota period < /sys/fs/cgroup/cpu.max; } 2>/dev/null && [ "$quota" != max ] && [ $((quota / period)) -lt "$count" ]; then
    count=$((quota < period ? 1 : quota / period))
  fi
  echo "$count"
}

# build TARGET...: configures and builds in build/.
build() {
  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >build.log 2>&1 ||
    { tail -n 30 build.log >&2; echo "Configuring failed; the whole output is in build.log." >&2; exit 2; }
  echo "Building (log: build.log)"
  cmake --build build --target "$@" >>build.log 2>&1 ||
    { grep -E 'error|FAILED' build.log | head -n 30 >&2; echo "Building failed; the whole output is in build.log." >&2; exit 2; }
}

# Open MPI refuses root and more ranks than cores unless told; both are right for one machine.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
# Without these, ranks waiting for work burn a core each and containers without ptrace print warnings.
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
