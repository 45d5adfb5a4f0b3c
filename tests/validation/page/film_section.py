"""Film thickness against Dowson-Higginson and Pan-Hamrock."""

from dataclasses import replace
from math import pi

from bearings import NU205
from film_formulas import LineContact, both_regimes, dowson_higginson, effective_modulus, pan_hamrock
from load_distribution import distribution
from report import number, signed_percent

# A published check: races 69.5/85.5 mm, 20 rollers 8 x 8 mm, no clearance, 837 rad/s, 0.01 Pa s, 20 1/GPa, 210 GPa.
PUBLISHED = {8000: (1600, 0.4247), 4000: (800, 0.4647), 2000: (400, 0.5085)}  # load: largest roller [N], film [um]
CHECK_SCENE = """name = "film-check"
[bearing]
roller_count = 20
bore_diameter_mm = 60
outside_diameter_mm = 95
width_mm = 18
inner_raceway_diameter_mm = 69.5
outer_raceway_diameter_mm = 85.5
shoulder_diameter_mm = 82
internal_clearance_um = 0
flange_clearance_mm = 0.08
ring_young_GPa = 210
[roller]
diameter_mm = 8
length_mm = 8
young_GPa = 210
[cage]
inner_diameter_mm = 75
outer_diameter_mm = 81.3
width_mm = 16
pocket_width_mm = 8.16
pocket_length_mm = 8.25
[lubrication]
model = "film"
viscosity_Pa_s = 0.01
pressure_viscosity_1_GPa = 20
[load]
radial_N = 8000
[speed]
inner_rpm = 7992.76
"""
FILM_LOADS = (300, 1000, 3000, 10000)


def contact_of(inner_race, outer_race, roller, rpm, viscosity, alpha, young=208e9):
    """Inner contact of rolling rollers; radii [m]."""
    ring = rpm * pi / 30
    orbit = ring * inner_race / (inner_race + outer_race)
    return LineContact(viscosity, alpha, roller * inner_race / (roller + inner_race), effective_modulus(young),
                       (ring - orbit) * inner_race)


def row(name, load, thinnest, contact, line_load, published=None):
    dh, ph, both = (f(contact, line_load) * 1e6 for f in (dowson_higginson, pan_hamrock, both_regimes))
    return [name, f"{load:g}", number(line_load * 1e-3), number(contact.speed), number(thinnest, 4), number(dh, 4),
            signed_percent(thinnest / dh - 1), number(ph, 4), signed_percent(thinnest / ph - 1), number(both, 4),
            number(published, 4), signed_percent(dh / published - 1, 2) if published else "-"]


def film_section(page, program, quick):
    page.heading("Film thickness against Dowson-Higginson and Pan-Hamrock")
    page.add("`film_min_um` of a run is the thinnest film of loaded race contacts over the window. Beside it the",
             "formulas for the inner contact of the most loaded roller, from its static load over its whole",
             "length (published check: 4 F/Z). A run has more: rollers pass between positions, load scatters,",
             "and its film is (h_E^4 + h_I^4)^(1/4). Where the default tolerance of 0.001 fails a run, it is",
             "shown and repeated with 0.0001.", "")
    rows = []
    scene = program.cache / "film-check.toml"
    scene.write_text(CHECK_SCENE, encoding="utf-8")
    for load, (largest, film) in list(PUBLISHED.items())[:1 if quick else None]:
        run = program.run(scene, {"load.radial_N": load})
        page.note_failure(f"film check, {load:g} N", run)
        contact = contact_of(34.75e-3, 42.75e-3, 4e-3, 7992.76, 0.01, 2e-8, 210e9)
        rows.append(row("published check", load, run["film_min_um"], contact, largest / 8e-3, film))
    b = NU205
    contact = contact_of(1e-3 * b.inner_race(), 1e-3 * b.outer_race(), 3.75e-3, b.rpm, 0.02, 1.8e-8)
    for load in ((1000,) if quick else FILM_LOADS):
        largest = distribution(replace(b.rollers(), logarithmic=False), load).loads.max()
        # Straight, aligned rollers: one film over the whole length, without the profile's edges.
        for tolerance in (1e-3, 1e-4):
            run = program.run(b.scene, b.settings | {
                "load.radial_N": load, "bearing.misalignment_z_mrad": 0, "roller.profile": "none", "integration.tolerance": tolerance})
            page.note_failure(f"film, NU 205, straight rollers, {load:g} N, tolerance {tolerance:g}", run)
            name = f"NU 205, straight rollers, tolerance {tolerance:g}: {run.status}"
            rows.append(row(name, load, run["film_min_um"], contact, largest / 9e-3))
            if run.ok:
                break
    page.table(["case", "load, N", "line load, N/mm", "u, m/s", "program, um", "Dowson-Higginson", "%",
                "Pan-Hamrock", "%", "both regimes", "published", "formula against published, %"], rows)
