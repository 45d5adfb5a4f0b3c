#!/usr/bin/env bash
# Is `cagetol rig` right about a rig that is the model itself? Measures the NU 205 by single runs from starts of another seed, then
# with a slip that is 3 points higher. Ends with 1 unless the first lie within their intervals in 90 % of the rows, and the second
# outside wherever the interval's half-width is below 1 point. Goes on where the last start ended.
# nightly_rig.sh SOURCE_DIR PROGRAM OUTPUT_DIR [SEED [OPTION...]]; options are those of `cagetol rig`
set -eu
source=$1 program=$2 out=$3 seed=${4:-7}; shift $(($# < 4 ? $# : 4))
cd "$source"
. .ci/setup.sh
build=$(sha256sum "$program"); out=$out/${build:0:12} # runs go on by the same build only
mkdir -p "$out"
scene=inputs/scenes/nu205.toml
[ -s "$out/rig.csv" ] || /usr/bin/env python3 - "$program" "$scene" "$out" "$seed" "$@" <<'PYTHON'
import json, os, random, subprocess, sys
program, scene, out, seed, options = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4]), sys.argv[5:]
settings = [word for k, name in enumerate(options) if name == "--set" for word in ("--set", options[k + 1])]
draw = random.Random(seed)
as_is, slipping = "radial_N,speed_rpm,cage_order\n", "radial_N,speed_rpm,cage_order\n"
for speed in (2000, 6000, 12000):
    for load in (300, 600, 1500, 4000):
        start = {"start.cage_offset_y_um": draw.gauss(0, 20), "start.cage_offset_z_um": draw.gauss(0, 20),
                 "start.cage_phase_deg": draw.uniform(0, 360), "load.radial_N": load, "speed.inner_rpm": speed}
        command = [program, "simulate", scene, "--json", *settings]
        for key, value in start.items():
            command += ["--set", f"{key}={value}"]
        point = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["operating_point"]
        order = point["with_slip"]["cage_order"]
        as_is += f"{load},{speed},{order}\n"
        slipping += f"{load},{speed},{order - 0.03 * point['values']['cage_order']}\n"
for name, text in (("slipping", slipping), ("rig", as_is)):
    with open(f"{out}/{name}.part", "w") as file:
        file.write(text)
    os.replace(f"{out}/{name}.part", f"{out}/{name}.csv")
PYTHON
# Rows of the same load and speed share their runs: the second command runs nothing.
for name in rig slipping; do
  mpirun -n "$(nproc)" "$program" rig "$scene" "$out/$name.csv" -o "$out/runs" "$@"
  mv "$out/runs/rig.json" "$out/$name.json"
done
/usr/bin/env python3 - "$out" <<'PYTHON'
import json, sys
rows, slipping = (json.load(open(f"{sys.argv[1]}/{name}.json"))["rows"] for name in ("rig", "slipping"))
starts = sum(row["standing"] == "within starts" for row in rows)
within = sum(row["standing"].startswith("within") for row in rows)
sharp = [row for row in slipping if row["upper"] is not None and row["upper"] - row["lower"] < 0.02]
missed = [row["line"] for row in sharp if row["standing"] != "outside"]
print(f"{len(rows)} rows of another seed: {within} within their intervals, {starts} within those over starts")
print(f"3 points more slip: {len(sharp)} rows with a half-width below 1 point, lines not found outside: {missed}")
sys.exit(0 if within >= 0.9 * len(rows) and starts >= 0.75 * len(rows) and sharp and not missed else 1)
PYTHON
