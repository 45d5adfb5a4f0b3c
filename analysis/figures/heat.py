"""Where heat arises in the nominal bearing's runs, and where it goes."""

import matplotlib.pyplot as plt

from common import WIDTH

MECHANISMS = (("rolling", "power_rolling_W"), ("race sliding", "power_race_sliding_W"), ("pockets", "power_pocket_W"),
              ("roller ends", "power_end_W"), ("flanges", "power_flange_W"), ("lands", "power_land_W"),
              ("churning", "power_churning_W"), ("squeeze", "power_squeeze_W"), ("damping", "power_damping_W"))
SMALLEST = 0.02  # share of the whole from which a part has a name of its own


def parts_of(pairs):
    """(name, W), the small ones together."""
    whole = sum(value for _, value in pairs)
    large = [(name, value) for name, value in pairs if value >= SMALLEST * whole]
    rest = whole - sum(value for _, value in large)
    return large + ([("others", rest)] if rest > 1e-3 * whole else [])


def heat(report):
    """Watts in by mechanism, means over samples, above watts out by path."""
    shed = (report["bearing"] or {}).get("heat")
    mean = {q["quantity"]: q["statistics"]["mean"]["value"] for q in report["quantities"] if q.get("statistics")}
    lost = [(name, mean[key]) for name, key in MECHANISMS if mean.get(key)]
    if not shed or not lost:
        return None
    bars = (("is shed", parts_of([("housing", shed["housing_W"]), ("oil", shed["oil_W"])])), ("arises", parts_of(lost)))
    figure, axis = plt.subplots(figsize=(WIDTH, 2.3))
    for row, (_, parts) in enumerate(bars):
        left = 0.0
        for index, (name, value) in enumerate(parts):
            axis.barh(row, value, left=left, height=0.55, color=plt.cm.Blues(0.75 - 0.6 * index / max(len(parts), 2)),
                      edgecolor="white")
            if value > 0.09 * sum(watts for _, watts in parts):
                axis.text(left + value / 2, row, f"{name}\n{value:.3g} W", ha="center", va="center", fontsize=8,
                          color="white" if index == 0 else "black")
            else:
                axis.annotate(name, (left + value / 2, row + 0.28), xytext=(0, 2), textcoords="offset points", fontsize=7,
                              rotation=35, ha="left", va="bottom")
            left += value
    axis.set_yticks(range(len(bars)), [name for name, _ in bars])
    axis.set_ylim(-0.4, 2.0)
    axis.grid(visible=False, axis="y")
    axis.set_xlabel("power [W]")
    axis.set_title(f"Oil and outer ring at {shed['temperature_C']:.0f} °C; 10 K more around the bearing warm them by "
                   f"{shed['warmer_by_10_K_of_ambient_K']:.1f} K", fontsize=9)
    return figure
