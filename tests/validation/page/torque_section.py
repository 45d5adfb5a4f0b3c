"""Friction torque against the makers' models over load and speed, and which mechanism takes it."""

from math import log

from matplotlib import pyplot

from bearings import BEARINGS, NU205
from report import WIDTH, logarithmic, number, percent, ticks_within, verdict
from torque_models import ratio_to_nearer

MECHANISMS = (("rolling", "power_rolling_W"), ("race sliding", "power_race_sliding_W"), ("pockets", "power_pocket_W"),
              ("ends, flanges", ("power_end_W", "power_flange_W")), ("lands", "power_land_W"),
              ("churning", "power_churning_W"),
              ("squeeze, damping, film", ("power_squeeze_W", "power_damping_W", "power_film_W")))
NU205_LIGHT_BAR = 1.9  # at 300 N; 1.6 from 1 kN on


def shares(run):
    """Share of each mechanism in the power loss."""
    def power(keys):
        return sum(run[key] for key in ((keys,) if isinstance(keys, str) else keys))

    return [power(keys) / run["power_loss_W"] for _, keys in MECHANISMS]


def points(bearing, quick):
    """(load, speed): over load at the working speed, then over speed at the working load."""
    if quick:
        return [(bearing.load, bearing.rpm)]
    return list(dict.fromkeys([(load, bearing.rpm) for load in bearing.loads]
                              + [(bearing.load, rpm) for rpm in bearing.speeds]))


def bar_of(bearing, load, rpm):
    """The factor asked for at this point, or None."""
    if bearing is NU205 and rpm == bearing.rpm:
        return {300: NU205_LIGHT_BAR, 1000: bearing.bar, 3000: bearing.bar, 10000: bearing.bar}.get(load)
    return bearing.bar if (load, rpm) == (bearing.load, bearing.rpm) else None


def along(bearing, runs, over_load):
    """Rows (load or speed, torque, SKF, Palmgren) of the runs that are ok."""
    return sorted((load if over_load else rpm, run["friction_torque_Nmm"], *bearing.models(load, rpm))
                  for (load, rpm), run in runs.items() if run.ok
                  and (rpm == bearing.rpm if over_load else load == bearing.load))


def draw(found, over_load):
    figure, axes = pyplot.subplots(2, 4, figsize=(1.6 * WIDTH, 5.2))
    for axis, (bearing, runs) in zip(axes.flat, found.items()):
        place, *torques = zip(*along(bearing, runs, over_load))
        for torque, style, label in zip(torques, ("o-", "s--", "^:"), ("cagetol", "SKF", "Palmgren")):
            axis.plot(place, torque, style, label=label)
        logarithmic(axis, place)
        logarithmic(axis, ticks_within(min(map(min, torques)), max(map(max, torques))), "y")
        axis.set_xlabel("load [N]" if over_load else "speed [r/min]")
        axis.set_title(f"{bearing.title}, " + (f"{bearing.rpm:g} r/min" if over_load else f"{bearing.load:g} N"))
    for row in axes:
        row[0].set_ylabel("torque [N mm]")
    axes[1][3].axis("off")
    axes[0][0].legend()
    return figure


def exponents(page, found):
    """Slopes of log torque between the ends of what was run."""
    page.add("### How torque grows", "", "Exponent of the torque between the ends of the loads and speeds above.", "")
    rows = []
    for bearing, runs in found.items():
        cells = [bearing.title]
        for over_load in (True, False):
            ends = along(bearing, runs, over_load)
            first, last = ends[0], ends[-1]
            cells += [f"{log(last[k] / first[k]) / log(last[0] / first[0]):.2f}" for k in (1, 2, 3)]
        rows.append(cells)
    page.table(["bearing", "of load: program", "SKF", "Palmgren", "of speed: program", "SKF", "Palmgren"], rows)
    page.add("SKF's model lowers rolling resistance at speed by heating of the inlet and by a factor for",
             "starvation, and has boundary friction at low speed; here a meniscus cuts the inlets short, and mixed",
             "friction at low speed hardly counts.", "")


def torque_section(page, program, quick):
    page.heading("Friction torque against SKF and Palmgren")
    page.add("Mean torque that drives the inner ring, N mm, beside two makers' models (`page/torque_models.py`).",
             "Ratio: over the nearer of the two, 1 between them. They differ among themselves by up to 2.1, so",
             "agreement within that is all that can be claimed. The split is of the power lost.", "")
    found, working = {}, []
    for bearing in ([NU205] if quick else BEARINGS):
        rows = []
        for load, rpm in points(bearing, quick):
            run = program.run(bearing.scene, bearing.settings | {"load.radial_N": load, "speed.inner_rpm": rpm})
            found.setdefault(bearing, {})[load, rpm] = run
            skf, palmgren = bearing.models(load, rpm)
            if page.note_failure(f"torque, {bearing.title}, {load:g} N, {rpm:g} r/min", run):
                rows.append([number(load), number(rpm), run.status, number(skf), number(palmgren)]
                            + ["-"] * (3 + len(MECHANISMS)))
                continue
            torque = run["friction_torque_Nmm"]
            ratio, bar = ratio_to_nearer(torque, skf, palmgren), bar_of(bearing, load, rpm)
            factor = max(ratio, 1 / ratio)
            if bar:
                page.bar(f"torque, {bearing.title}, {load:g} N, {rpm:g} r/min",
                         f"within a factor of {bar:g} of the nearer model", number(factor), factor <= bar)
            rows.append([number(load), number(rpm), number(torque), number(skf), number(palmgren), number(ratio),
                         f"{bar:g}: {verdict(factor <= bar)}" if bar else "-", percent(run["driving_slip_ratio"])]
                        + [percent(s) for s in shares(run)])
        page.add(f"### {bearing.title}", "")
        page.table(["load, N", "r/min", "torque", "SKF", "Palmgren", "ratio", "bar", "slip, %"]
                   + [f"{name}, %" for name, _ in MECHANISMS], rows)
    if not quick:
        page.figure("validation-torque-load", draw(found, True), "Friction torque over load, program and makers")
        page.figure("validation-torque-speed", draw(found, False), "Friction torque over speed, program and makers")
        exponents(page, found)
