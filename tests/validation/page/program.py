"""Runs of the program, kept under the build directory so that a page that was interrupted goes on where it stopped."""

import hashlib
import json
import os
import subprocess
import sys
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

# What Open MPI wants to hear as root, or with more ranks than cores.
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
       "OMPI_MCA_rmaps_base_oversubscribe": "1"}


@dataclass(frozen=True)
class Run:
    """One outcome: status, reason, quantities by key (None where undefined), the run's own numbers."""
    status: str
    reason: str
    q: dict
    run: dict
    history: dict = field(default_factory=dict)  # first row of each series that was asked for

    @property
    def ok(self):
        return self.status == "ok"

    def __getitem__(self, key):
        value = self.q.get(key)
        return float("nan") if value is None else value


def toml_value(value):
    """As the program's --set reads it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"'{value}'" if isinstance(value, str) else repr(value)


class Program:
    """The executable, and what it has answered so far."""

    def __init__(self, path, cache, common=None):
        self.path = Path(path).resolve()
        if not os.access(self.path, os.X_OK):
            sys.exit(f"--program = {path}: there is no such program\n"
                     "  remedy: build it with `cmake --build build --target cagetol`")
        self.cache = Path(cache)
        self.cache.mkdir(parents=True, exist_ok=True)
        self.common = dict(common or {})  # settings of every run
        self.build = hashlib.sha256(self.path.read_bytes()).hexdigest()
        self.fresh = self.kept = 0

    def commit(self):
        """Commit the executable was built from."""
        text = subprocess.run([self.path, "--version"], env=os.environ | MPI, capture_output=True, text=True,
                              check=True).stdout
        return next((line.split()[1] for line in text.splitlines() if line.startswith("commit ")), "unknown")

    def run(self, scene, settings=None, series=()):
        """The outcome of a scene file with settings {key: value}; `series`: histories whose first row is kept."""
        settings = dict(settings or {}) | self.common
        content = tomllib.loads(Path(scene).read_text(encoding="utf-8"))  # comments change no run
        key = json.dumps([self.build, content, sorted(settings.items()), sorted(series)])
        place = self.cache / (hashlib.sha256(key.encode()).hexdigest()[:24] + ".json")
        if place.exists():
            self.kept += 1
            return Run(**json.loads(place.read_text(encoding="utf-8")))
        answer = self._simulate(scene, settings, series)
        unfinished = place.with_suffix(".part")
        unfinished.write_text(json.dumps(answer), encoding="utf-8")
        unfinished.replace(place)
        self.fresh += 1
        return Run(**answer)

    def directory(self, command, file, result, options=(), settings=None, reads=()):
        """Directory of `cagetol COMMAND FILE -o DIR OPTIONS` with the file `result` in it; kept by program, options and the
        content of the file and of what it `reads`."""
        settings = sorted(dict(settings or {}).items())
        contents = [Path(each).read_text(encoding="utf-8") for each in (file, *reads)]
        key = json.dumps([self.build, contents, settings, list(options)])
        place = self.cache / f"{command}-{hashlib.sha256(key.encode()).hexdigest()[:24]}"
        if not (place / result).exists():
            self.execute([command, file, "-o", place, *options], settings)
        return place

    def execute(self, arguments, settings=()):
        """Runs a command of the program; ends the page where it fails."""
        command = [str(each) for each in (self.path, *arguments)]
        for name, value in settings:
            command += ["--set", f"{name}={toml_value(value)}"]
        done = subprocess.run(command, env=os.environ | MPI, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}\nended with code {done.returncode}:\n{done.stderr}")

    def _simulate(self, scene, settings, series):
        command = [str(self.path), "simulate", str(scene), "--json"]
        for key, value in settings.items():
            command += ["--set", f"{key}={toml_value(value)}"]
        history = self.cache / f"history-{os.getpid()}.h5"
        if series:
            command += ["-o", str(history)]
        done = subprocess.run(command, env=os.environ | MPI, capture_output=True, text=True)
        start = done.stdout.find("{")
        if start < 0:
            sys.exit(f"{' '.join(command)}\nended with code {done.returncode} and no result:\n{done.stderr}")
        answer = json.loads(done.stdout[start:done.stdout.rfind("}") + 1])
        answer = {"status": answer["status"], "reason": answer["reason"], "q": answer["qoi"], "run": answer["run"],
                  "history": {}}
        if series:
            import h5py  # what reads the program's histories elsewhere, too

            with h5py.File(history) as file:
                answer["history"] = {name: file[name][0].tolist() for name in series}
            history.unlink()
        return answer
