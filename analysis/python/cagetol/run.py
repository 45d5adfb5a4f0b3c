"""Time histories of one run (run.h5 of `cagetol simulate -o` and `cagetol replay -o`, mc/RUN_FORMAT.md)."""

from dataclasses import dataclass

import pandas

from .sealed import open_sealed
from .study import text_of


@dataclass
class Run:
    scene: str
    #: Numbers of the bearing, indexed by time [s].
    bearing: pandas.DataFrame
    #: Numbers of each roller: columns are (channel, roller), so that run.rollers["inner_force"] has one column a roller.
    rollers: pandas.DataFrame
    units: dict


def read_run(path):
    """Reads run.h5. Throws FileNotFoundError, and ValueError where the file is damaged."""
    with open_sealed(path) as file:
        time = pandas.Index(file["time"][()], name="time_s")
        bearing, rollers, units = {}, {}, {}
        for name, data in file.items():
            units[name] = text_of(data.attrs["unit"])
            if name == "time":
                continue
            values = data[()]
            if values.ndim == 1:
                bearing[name] = values
            else:
                rollers.update({(name, j): values[:, j] for j in range(values.shape[1])})
        frame = pandas.DataFrame(rollers, index=time)
        if len(frame.columns):
            frame.columns = pandas.MultiIndex.from_tuples(frame.columns, names=["channel", "roller"])
        return Run(scene=text_of(file.attrs["scene"]), bearing=pandas.DataFrame(bearing, index=time), rollers=frame, units=units)
