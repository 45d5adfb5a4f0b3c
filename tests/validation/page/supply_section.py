"""Torque by named supply beside the makers' models, and an oil bath beside minimum oil."""

from bearings import AERO, BEARINGS, NU205, NU208
from report import number, verdict
from torque_models import ratio_to_nearer

SUPPLIES = ("oil-air", "grease", "circulation", "bath")
# Oil bath over minimum oil, 40 mm bore, 16,000 r/min: about twice, by the abstract of one measurement.
BATH = (NU208, 2000, 16000, 1.4, 2.8)
HEAVY_AERO_BAR = 3.5  # where it does not skid; churning is a third of its torque
LAYERS = ("race_layer_um", "outer_layer_um", "pocket_layer_um", "land_layer_um", "oil_share")


def torque_of(program, page, bearing, load, rpm, supply):
    """[N mm], all that the supply leaves open left to it."""
    settings = bearing.settings | {f"lubrication.{key}": "auto" for key in LAYERS} | {
        "lubrication.supply": supply, "load.radial_N": load, "speed.inner_rpm": rpm}
    run = program.run(bearing.scene, settings)
    page.note_failure(f"torque, {bearing.title}, {supply}", run)
    return run["friction_torque_Nmm"]


def supply_section(page, program, quick):
    page.heading("Torque by supply of oil")
    page.add("A supply sets up to which gap oil fills the inlets of races, pockets and lands, and the share of oil in the",
             "free space (`lubrication.supply`): assumptions, which no measurement of these gaps backs. N mm.", "")
    rows = []
    for bearing in ([NU205] if quick else BEARINGS):
        points = [(bearing.load, bearing.rpm)] + ([(5000.0, bearing.rpm)] if bearing is AERO else [])
        for load, rpm in points:
            torques = [torque_of(program, page, bearing, load, rpm, supply) for supply in SUPPLIES]
            models = bearing.models(load, rpm)
            spans = min(torques) <= min(models) and max(torques) >= max(models)
            page.bar(f"torque by supply, {bearing.title}, {load:g} N", "spans both models",
                     f"{number(min(torques))} to {number(max(torques))} N mm", spans)
            if load != bearing.load:
                ratio = ratio_to_nearer(torques[SUPPLIES.index("circulation")], *models)
                page.bar(f"torque, {bearing.title}, {load:g} N, {rpm:g} r/min",
                         f"within a factor of {HEAVY_AERO_BAR:g} of the nearer model", number(ratio),
                         ratio <= HEAVY_AERO_BAR)
            rows.append([bearing.title, f"{load:g}", f"{rpm:g}", *map(number, torques), *map(number, models),
                         *(number(ratio_to_nearer(t, *models)) for t in torques), verdict(spans)])
    page.table(["bearing", "load, N", "r/min", *SUPPLIES, "SKF", "Palmgren", *(f"ratio, {s}" for s in SUPPLIES),
                "spans both"], rows)
    bearing, load, rpm, low, high = BATH
    ratio = (torque_of(program, page, bearing, load, rpm, "bath")
             / torque_of(program, page, bearing, load, rpm, "oil-air"))
    page.bar(f"bath over oil and air, {bearing.title}, {load:g} N, {rpm:g} r/min", f"{low:g} to {high:g}", number(ratio),
             low <= ratio <= high)
    page.add(f"Oil bath over oil and air, {bearing.title} at {load:g} N and {rpm:g} r/min: {number(ratio)}; one measurement",
             f"of a bearing of 40 mm bore at this speed: about twice ({low:g} to {high:g} will do).", "")
