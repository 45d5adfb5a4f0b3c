"""What drives the torque: rolling resistance by race; the aero bearing with one mechanism off at a time."""

from math import pi

from bearings import AERO, BEARINGS, NU205
from report import number, percent
from static_rolling import centrifugal_force, rolling_kinematics, static_rolling

SWITCHES = ("churning", "rolling_resistance", "inlet_heating", "film_traction", "land_film", "end_film", "pocket_film")


def rolling_by_race(page, program, quick):
    page.add("### Rolling resistance without slip, by race", "",
             "Sum of 2 f u over the static load distribution with inlet heating and all inlets flooded",
             "(`page/static_rolling.py`), beside what rolling resistance takes in the run, N mm. A run that slips",
             "entrains less oil.", "")
    rows = []
    for b in ([NU205] if quick else BEARINGS):
        run = program.run(b.scene, b.settings | {"load.radial_N": b.load, "speed.inner_rpm": b.rpm})
        inner, outer = static_rolling(b, b.load, heating=True)
        cold = sum(static_rolling(b, b.load))
        rows.append([b.title, f"{b.load:g}", f"{b.rpm:g}", number(rolling_kinematics(b, b.rpm)[2]),
                     number(centrifugal_force(b, b.rpm)), number(inner), number(outer), number(cold),
                     number(1e3 * run["power_rolling_W"] / (b.rpm * pi / 30)), percent(run["driving_slip_ratio"])])
    page.table(["bearing", "load, N", "r/min", "u, m/s", "centrifugal force of a roller, N", "inner race", "outer race",
                "both, isothermal", "run", "slip of the run, %"], rows)


def one_off_at_a_time(page, program):
    page.add(f"### {AERO.title}: one mechanism off at a time", "",
             f"{AERO.load:g} N, {AERO.rpm:g} r/min; shares of the power lost over the ring's speed, N mm.", "")
    names = ("torque", "rolling", "race sliding", "churning", "lands", "flanges", "pockets")
    keys = ("rolling", "race_sliding", "churning", "land", "flange", "pocket")
    rows = []
    for switch in (None, *SWITCHES):
        run = program.run(AERO.scene, AERO.settings | {"load.radial_N": AERO.load, "speed.inner_rpm": AERO.rpm}
                          | ({f"lubrication.{switch}": False} if switch else {}))
        name = f"without {switch.replace('_', ' ')}" if switch else "all"
        if page.note_failure(f"{AERO.title}, {name}", run):
            rows.append([name, run.status] + ["-"] * len(names))
            continue
        rows.append([name, percent(run["driving_slip_ratio"]), number(run["friction_torque_Nmm"])]
                    + [number(1e3 * run[f"power_{key}_W"] / (AERO.rpm * pi / 30)) for key in keys])
    page.table(["", "slip, %", *names], rows)


def mechanism_section(page, program, quick):
    page.heading("What drives the torque")
    rolling_by_race(page, program, quick)
    if quick:
        return
    one_off_at_a_time(page, program)
    page.add("At the aero bearing's speed centrifugal force presses every roller on the outer race, loaded or",
             "not, and all of them pay rolling resistance there; the makers' models know the radial load alone.",
             "With the drag of the free space on the rollers this brakes more than the traction of the few",
             "loaded inner contacts drives: it skids, and sliding adds to the torque. Rollers stand in the stream",
             "with their whole length, which may well be too much.", "")
