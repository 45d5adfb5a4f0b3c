#!/usr/bin/env bash
# The Python package, installed by pip from a copy of the tree, and its notebook on a study made short:
# python_package.sh SOURCE_DIR PROGRAM. Skipped (77) without pandas or pip.
set -eu
source=$1
python=/usr/bin/python3
$python -c 'import setuptools, pip, pandas, h5py' 2>/dev/null || exit 77
place=$(mktemp -d); trap 'rm -rf "$place"' EXIT
mkdir "$place/analysis"
cp -r "$source/analysis/python" "$source/analysis/figures" "$place/analysis"
ln -s "$source/inputs" "$place/inputs"
$python -m pip install --quiet --no-index --no-build-isolation --no-deps --target "$place/site" "$place/analysis/python" \
  >"$place/log" 2>&1 || { cat "$place/log"; exit 1; }
export PYTHONPATH=$place/site CAGETOL=$2 OUT=$place/out SAMPLES=4 MPLBACKEND=agg
cd "$place/analysis/python"
$python -B - <<'END'
import json
import os

import h5py
import numpy

of_notebook = {}
for cell in json.load(open("example.ipynb", encoding="utf-8"))["cells"]:
    if cell["cell_type"] == "code":
        exec(compile("".join(cell["source"]), "example.ipynb", "exec"), of_notebook)
study, run, figures = of_notebook["study"], of_notebook["run"], of_notebook["figures"]
report = json.load(open(os.environ["OUT"] + "/report.json", encoding="utf-8"))

assert figures["limited_quantities"].svg.count("<path") > 10
assert set(figures) == {file[:-4] for file in os.listdir(os.environ["OUT"] + "/figures") if file.endswith(".svg")}
with h5py.File(os.environ["OUT"] + "/study.h5", "r") as file:
    width = file["inputs/cage.pocket_width_mm/value"]
    assert (study.samples["cage.pocket_width_mm[12]"].to_numpy() == width[:, 12]).all()
    for name, values in file["quantities"].items():
        assert numpy.array_equal(study.quantities[name].to_numpy(), values[()], equal_nan=True), name
        assert study.units[name] == values.attrs["unit"].decode()
assert len(study.samples) == len(study.ok) >= 4
# A damaged file is refused before HDF5 opens it.
flipped = bytearray(open(os.environ["OUT"] + "/study.h5", "rb").read())
flipped[len(flipped) // 2] ^= 4
open(os.environ["OUT"] + "/flipped.h5", "wb").write(flipped)
try:
    of_notebook["cagetol"].read_study(os.environ["OUT"] + "/flipped.h5")
    raise SystemExit("a flipped bit was read")
except ValueError as problem:
    assert "damaged" in str(problem)
# Replicates repeat samples, the report's statistics are of the first runs.
first = study.samples["replicate"] == 0
torque = next(q for q in report["quantities"] if q["quantity"] == "friction_torque_Nmm")
assert abs(study.quantities["friction_torque_Nmm"][first].mean() - torque["statistics"]["mean"]["value"]) < 1e-9
limited = study.quantities["friction_torque_Nmm"]
study.plan["limit"] = [{"quantity": "friction_torque_Nmm", "max": float(limited.max()) - 1e-9}]
assert study.meets().sum() == len(limited) - 1
assert run.rollers["inner_force"].shape == (len(run.bearing), 13) and run.units["inner_force"] == "N"
END
