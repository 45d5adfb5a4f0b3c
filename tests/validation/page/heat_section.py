"""Temperature at which a bearing sheds what it loses: the program beside sums over static loads and the standard's heat.

Losses here: rolling resistance of flooded races alone (static_rolling.py); heat: ISO 15312, 0.016 W/mm2 over
pi B (d + D) at 50 K above ambient.
"""

from dataclasses import replace
from math import pi

from bearings import NU205
from lubricant import curve, viscosity
from report import number
from static_rolling import static_rolling

AMBIENT = (0, 20, 40, 60)  # [degC]
WITHIN = 8                 # [K]
DENSITY = 870              # of the oil at 15 degC [kg/m3]


def losses(celsius):
    """[W]"""
    density = DENSITY * (1 - 0.00065 * (celsius - 15))
    eta = 1e-6 * viscosity(curve(*NU205.oil[0]), celsius) * density
    warm = replace(NU205, settings={"lubrication.viscosity_Pa_s": eta}, oil=(NU205.oil[0], celsius, NU205.oil[2]))
    return 1e-3 * sum(static_rolling(warm, NU205.load, heating=True)) * NU205.rpm * pi / 30


def conductance():
    """[W/K]"""
    b = NU205.file["bearing"]
    return 0.016 * pi * b["width_mm"] * (b["bore_diameter_mm"] + b["outside_diameter_mm"]) / 50


def balanced(ambient):
    """[degC]"""
    low, high = ambient, 250.0
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if losses(middle) > conductance() * (middle - ambient) else (low, middle)
    return low


def heat_section(page, program, quick):
    page.heading("Temperature by the heat balance")
    page.add(f"NU 205, {NU205.load:g} N, {NU205.rpm:g} r/min, `temperature.balance = true`, beside rolling resistance of",
             "flooded races summed over static loads against the heat of ISO 15312 (`page/heat_section.py`). degC, W.", "")
    rows = []
    for ambient in AMBIENT[1:2] if quick else AMBIENT:
        # The scene's own oil: its viscosity follows the temperature.
        run = program.run(NU205.scene, {"temperature.balance": True, "temperature.found_C": "auto",
                                        "temperature.ambient_C": ambient})
        if page.note_failure(f"heat balance, {ambient:g} degC", run):
            continue
        due, found = balanced(ambient), run["operating_temperature_C"]
        page.bar(f"heat balance, NU 205 at {ambient:g} degC", f"within {WITHIN} K of the static sum",
                 f"{found - due:+.1f} K", abs(found - due) <= WITHIN)
        rows.append([f"{ambient:g}", number(found), number(due), f"{found - due:+.1f}", number(run["power_loss_W"]),
                     number(run["heat_shed_W"]), number(run["friction_torque_Nmm"])])
    page.table(["ambient", "program", "static sum", "K", "power lost", "heat shed", "torque, N mm"], rows)
