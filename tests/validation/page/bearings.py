"""The bearings of the page: scene, makers' data, and the working point at which they are judged."""

import tomllib
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import rating
from load_distribution import RollerSet
from lubricant import curve, viscosity_fall
from torque_models import SERIES, palmgren_torque, skf_torque

ROOT = Path(__file__).resolve().parents[3]


@dataclass(frozen=True, eq=False)  # each is itself alone, a key of tables
class Bearing:
    title: str
    scene: Path
    series: str                # of SERIES
    viscosity: float           # kinematic, for the makers' models [mm2/s]
    bar: float                 # factor allowed against the nearer model at the working point
    loads: tuple               # [N], torque over load
    speeds: tuple              # [r/min], torque over speed
    reference_rpm: float = 0   # SKF's thermal reference speed; 0: not in a catalogue
    C: float = 0               # catalogue ratings [N]; 0: not in a catalogue
    C0: float = 0
    factor: float = rating.STANDARD_FACTOR
    settings: dict = field(default_factory=dict)  # of every run
    at: tuple = ()             # load and speed at which it is judged, where they are not the scene's
    # Viscosities at 40 and 100 degC [mm2/s], degC, alpha [1/Pa] of the oil named in the scene, as in the program.
    oil: tuple = ((68, 8.7), 70, 1.8e-8)

    @cached_property
    def file(self):
        return tomllib.loads(self.scene.read_text(encoding="utf-8"))

    @property
    def load(self):
        return float(self.at[0] if self.at else self.file["load"]["radial_N"])

    @property
    def rpm(self):
        return float(self.at[1] if self.at else self.file["speed"]["inner_rpm"])

    @property
    def dynamic_viscosity(self):
        """[Pa s]"""
        key = "viscosity_Pa_s"
        return self.settings.get("lubrication." + key) or self.file["lubrication"][key]

    @property
    def viscosity_fall(self):
        """beta of the oil [1/K]."""
        return viscosity_fall(curve(*self.oil[0]), self.oil[1])

    @property
    def bore(self):
        return self.file["bearing"]["bore_diameter_mm"]

    @property
    def outside(self):
        return self.file["bearing"]["outside_diameter_mm"]

    @property
    def pitch(self):
        b = self.file["bearing"]
        return (b["inner_raceway_diameter_mm"] + b["outer_raceway_diameter_mm"]) / 2

    def rollers(self, misaligned=False):
        b, r = self.file["bearing"], self.file["roller"]
        left = b["outer_raceway_diameter_mm"] - b["inner_raceway_diameter_mm"] - 2 * r["diameter_mm"]
        return RollerSet(b["roller_count"], r["diameter_mm"], r["length_mm"],
                         left + 1e-3 * b["internal_clearance_um"], r.get("profile", "none") == "logarithmic",
                         1e-3 * b.get("misalignment_z_mrad", 0) if misaligned else 0.0)

    def inner_race(self):
        """Radius [mm] as the program has it: half of the clearance on each raceway."""
        b = self.file["bearing"]
        return b["inner_raceway_diameter_mm"] / 2 - 1e-3 * b["internal_clearance_um"] / 4

    def outer_race(self):
        b = self.file["bearing"]
        return b["outer_raceway_diameter_mm"] / 2 + 1e-3 * b["internal_clearance_um"] / 4

    def models(self, load, rpm):
        """Torque by (SKF, Palmgren) [N mm]."""
        which = (SERIES[self.series], self.bore, self.outside, load, rpm, self.viscosity)
        return skf_torque(*which), palmgren_torque(*which)

    def dynamic_rating(self):
        r = self.file["roller"]
        return rating.dynamic_rating(self.file["bearing"]["roller_count"], r["diameter_mm"], r["length_mm"],
                                     self.pitch, self.factor)

    def static_rating(self):
        r = self.file["roller"]
        return rating.static_rating(self.file["bearing"]["roller_count"], r["diameter_mm"], r["length_mm"], self.pitch)


def scene_of(name):
    return ROOT / "tests/validation/scenes" / f"{name}.toml"


# The default scene at the point at which it is judged: oiled, 0.02 Pa s, which is 23 mm2/s at 870 kg/m3.
NU205 = Bearing("NU 205", ROOT / "inputs/scenes/nu205.toml", "2", 23, 1.6,
                (100, 300, 1000, 3000, 10000), (1000, 3000, 6000, 9000, 14000), 14000, 28600, 27000,
                settings={"lubrication.viscosity_Pa_s": 0.02})
NU208 = Bearing("NU 208", scene_of("nu208"), "2", 20, 1.8, (1500, 3000, 6000, 12000), (1500, 3000, 6000, 9000),
                9500, 62000, 53000, rating.EXPLORER_FACTOR)
NU215 = Bearing("NU 215", scene_of("nu215"), "2", 20, 1.8, (), (), 5600, 150000, 156000, rating.EXPLORER_FACTOR)  # slip alone
NU226 = Bearing("NU 226", scene_of("nu226"), "2", 20, 1.8, (10000, 20000, 41500, 83000), (425, 850, 1700, 2550),
                3200, 415000, 455000, rating.EXPLORER_FACTOR)
NU2226 = Bearing("NU 2226", scene_of("nu2226"), "22", 20, 1.8, (15000, 30000, 61000, 122000), (425, 850, 1700, 2550),
                 3200, 610000, 735000, rating.EXPLORER_FACTOR)
NU2322 = Bearing("NU 2322", scene_of("nu2322"), "23", 100, 1.8, (15000, 30000, 60000, 120000), (225, 450, 900, 1800),
                 3000, 780000, 900000, rating.EXPLORER_FACTOR)
# Not in a catalogue: factors of series 2; those of series 10 give 616 and 1236 in place of 600 and 1250 N mm.
AERO = Bearing("118 mm aero", scene_of("aero118"), "2", 5, 2.5, (500, 1000, 2000, 5000, 10000),
               (5000, 10000, 15000, 20000), oil=((25.5, 5.1), 100, 1.2e-8))
# At the point at which it is judged: 10 mm2/s at 850 kg/m3.
N1014 = Bearing("N 1014", ROOT / "inputs/scenes/n1014-spindle.toml", "10", 10, 2.5, (500, 1000, 2000, 4000),
                (5000, 10000, 15000), settings={"lubrication.viscosity_Pa_s": 0.0085, "temperature.balance": False,
                          "lubrication.temperature_C": 45}, at=(1000, 15000),
                oil=((15, 3.4), 45, 1.6e-8))
BEARINGS = (NU205, NU208, NU226, NU2226, NU2322, N1014, AERO)
