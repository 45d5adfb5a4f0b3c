"""Draws every figure of a report from its numbers: draw.py REPORT_JSON OUTPUT_DIR.

Computes nothing that is not in report.json. Each figure becomes OUTPUT_DIR/NAME.svg; a figure for which the report has no data is
left out. A figure that fails is named on standard error, the others are still drawn, and the exit code is 1.
"""

import json
import pathlib
import sys
import traceback


def main(report_file, output_dir):
    here = pathlib.Path(__file__).resolve().parent
    sys.path.insert(0, str(here))
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    plt.style.use(str(here / "cagetol.mplstyle"))
    eastern = sorted({font.name for font in matplotlib.font_manager.fontManager.ttflist if "CJK" in font.name})
    plt.rcParams["font.family"] = plt.rcParams["font.family"] + eastern[:1]
    import bearing
    import cage
    import centres
    import contributors
    import engine
    import error_budget
    import fidelity
    import heat
    import history
    import operating_map
    import pocket
    import process
    import quantities
    import rare
    import rig
    import screen
    import tolerance

    of_report = {
        "bearing": bearing.bearing, "heat": heat.heat,
        "width_curves": tolerance.width_curves, "yield_curves": tolerance.yield_curves, "yield_map": tolerance.yield_map,
        "jam_curves": tolerance.jam_curves, "map": lambda report: report.get("map") and operating_map.operating_map(report["map"]),
        "centre_curves": centres.centre_curves, "centre_map": centres.centre_map,
        "centre_responses": centres.centre_responses,
        "limited_quantities": quantities.limited_quantities,
        **{f"other_quantities_{page + 1}": quantities.other_quantities(page) for page in range(5)},
        "pareto": contributors.pareto, "matrix": contributors.matrix, "pocket_map": contributors.pocket_map,
        "responses": contributors.responses, "convergence": quantities.convergence, "health": quantities.health,
        "process": process.process, "cage_stress": cage.cage_stress, "rare": rare.of_report,
        "error_budget": error_budget.error_budget,
    }
    of_engine = {"chart": {"chart": engine.chart}, "stability": {"stability": engine.stability},
                 "ladder": {"ladder": fidelity.ladder}, "cage": {"pocket": pocket.pocket},
                 "rig": {"rig": rig.rig}, "rare": {"rare": rare.rare}, "screen": {"screen": screen.screen},
                 "map": {"map": operating_map.operating_map}, "history": {"history": history.history}}
    with open(report_file, encoding="utf-8") as source:
        report = json.load(source)
    of_limits = {"limit_curves": tolerance.limit_curves, "yield_curves": tolerance.yield_curves}
    figures = of_limits if "limit_curves" in report else of_engine.get(report.get("kind"), of_report)
    output = pathlib.Path(output_dir)
    output.mkdir(parents=True, exist_ok=True)
    failed = 0
    for name, draw in figures.items():
        target = output / f"{name}.svg"
        target.unlink(missing_ok=True)
        try:
            figure = draw(report)
            if figure is not None:
                figure.savefig(target, metadata={"Date": None})
                plt.close(figure)
        except Exception:  # one broken figure must not cost the others
            failed += 1
            print(f"figure {name}: {traceback.format_exc(limit=-2)}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
