"""Samples and quantities of a sweep (study.h5, mc/RESULTS_FORMAT.md) as pandas frames."""

import json
import pathlib
from dataclasses import dataclass

import numpy
import pandas

from .sealed import open_sealed

STATUS = {0: "ok", 1: "jammed", 2: "failed", 3: "censored", 5: "poisoned"}


def study_file(place):
    """study.h5 of a directory that `cagetol sweep` or `cagetol recommend` filled (there the mixture's), or the file itself."""
    place = pathlib.Path(place)
    if place.is_file():
        return place
    for file in (place / "mixture" / "study.h5", place / "study.h5"):
        if file.is_file():
            return file
    raise FileNotFoundError(f"{place} holds no study.h5: give the directory of a sweep or of a recommendation, or one of its stages")


def text_of(value):
    return value.decode() if isinstance(value, bytes) else value


@dataclass
class Study:
    """A sweep. Every frame has one row for each sample, indexed by its id."""

    name: str
    #: The resolved study: limits, laws, tolerance, scene (mc/README.md lists the keys).
    plan: dict
    #: row, replicate, lot, candidate, status (a word), reason, and of each uncertain input what was simulated: KEY, or
    #: KEY[j] for pocket j.
    samples: pandas.DataFrame
    #: Quantities of interest; QUANTITY@LABEL for operating points and phases.
    quantities: pandas.DataFrame
    #: What the runs cost and how sound they were: steps, energy_residual, ...
    runs: pandas.DataFrame
    #: Unit and definition of each quantity.
    units: dict
    definitions: dict
    attributes: dict

    @property
    def ok(self):
        """Ids of the samples that ran to their end."""
        return self.samples.index[self.samples["status"] == "ok"]

    def limits(self):
        """The study's limits: quantity, min, max, source."""
        return pandas.DataFrame(self.plan.get("limit", []))

    def meets(self):
        """Whether each sample meets every limit. A sample that is not ok, or lacks a limited quantity, does not."""
        meets = self.samples["status"] == "ok"
        for limit in self.plan.get("limit", []):
            values = self.quantities[limit["quantity"]]
            meets &= values.notna() & (values >= limit.get("min", -numpy.inf)) & (values <= limit.get("max", numpy.inf))
        return meets


def frame_of(group, index):
    return pandas.DataFrame({name: data[()] for name, data in group.items()}, index=index)


def samples_of(file, index):
    columns = {name: data[()] for name, data in file["samples"].items() if name != "id"}
    columns["status"] = [STATUS.get(code, str(code)) for code in columns["status"]]
    columns["reason"] = [text_of(reason) for reason in columns["reason"]]
    for key, group in file.get("inputs", {}).items():
        value = group["value"][()]
        if value.ndim == 1:
            columns[key] = value
        else:
            columns.update({f"{key}[{j}]": value[:, j] for j in range(value.shape[1])})
    return pandas.DataFrame(columns, index=index)


def read_study(place):
    """Reads a sweep, or a stage of a recommendation. `place`: its directory or study.h5. Throws FileNotFoundError, and ValueError where
    the file is damaged."""
    with open_sealed(study_file(place)) as file:
        ids = pandas.Index(file["samples/id"][()], name="sample")
        quantities = file["quantities"]
        return Study(name=text_of(file.attrs["study_name"]),
                     plan=json.loads(text_of(file["study/json"][()])),
                     samples=samples_of(file, ids),
                     quantities=frame_of(quantities, ids),
                     runs=frame_of(file["run"], ids),
                     units={name: text_of(data.attrs["unit"]) for name, data in quantities.items()},
                     definitions={name: text_of(data.attrs["description"]) for name, data in quantities.items()},
                     attributes={name: text_of(value) for name, value in file.attrs.items()})
