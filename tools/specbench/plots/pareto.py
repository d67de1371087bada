"""Speed against accuracy: a point a method and setting, and the front that none of them beats."""

import math

import matplotlib.pyplot as plt

from plots import labels
from plots.style import INK, color_of, mark_of, methods_of, read_rows, save, value

SRGB_SETS = {"RGB cube", "8-bit lattice", "dark", "near black, saturated", "near white"}
OWN_FRAME = "his white"  # Smits in the frame of his paper: not the same colours


def front(points, exact):
    """The points that no other beats: as fast and nearer, or as near and faster.

    Errors below `exact` are rounding, and equal."""
    kept = []
    for point in sorted(points, key=lambda p: (-p["x"], p["y"])):
        if not kept or max(point["y"], exact) < max(kept[-1]["y"], exact):
            kept.append(point)
    return kept


def short(method):
    family, parameters = method
    if family == "smooth" and parameters.startswith("grid "):
        nodes = parameters.removeprefix("grid ")
        return f"smooth, grid {nodes} (default)" if nodes == "17" else nodes
    return f"{family}, {parameters}" if parameters else family


def collect(rows, error):
    points = []
    for method in methods_of(rows):
        if method[1] == OWN_FRAME:
            continue
        speed = value(rows, method, "throughput")
        bad = value(rows, method, "failed", SRGB_SETS)
        found = error(method)
        if math.isfinite(speed) and math.isfinite(found):
            points.append({"method": method, "x": speed, "y": found, "sound": bad == 0})
    return points


def chart(points, path, title, ylabel, exact):
    log = exact > 0
    figure, axes = plt.subplots(figsize=(9, 5.6))
    axes.set_xscale("log")
    if log:
        axes.set_yscale("log")
    for family in dict.fromkeys(p["method"][0] for p in points):
        for kind in ("grid", ""):
            line = [p for p in points if p["method"][0] == family
                    and ("grid" in p["method"][1]) == bool(kind)]
            if kind and family == "smooth":
                axes.plot([p["x"] for p in line], [p["y"] for p in line], "-", lw=1,
                          color=color_of(family), alpha=0.6)
            for p in line:
                axes.plot(p["x"], p["y"], mark_of(family), ms=8 if mark_of(family) == "*" else 6,
                          color=color_of(family),
                          markerfacecolor=color_of(family) if p["sound"] else "none")
    if exact:
        axes.axhspan(axes.get_ylim()[0], exact, color="#888888", alpha=0.15, lw=0)
        axes.text(0.01, exact, "exact, to the float's rounding", fontsize=8, va="top",
                  transform=axes.get_yaxis_transform())
        axes.set_ylim(5e-9)
    best = front([p for p in points if p["sound"]], exact)
    axes.plot([p["x"] for p in best], [p["y"] for p in best], "--", color=INK, lw=1,
              drawstyle="steps-post", alpha=0.7)
    axes.set_xlabel("texels per second on one thread, 81 floats each (log)  →  faster")
    axes.set_ylabel(ylabel)
    axes.set_title(title, loc="left", fontsize=10)
    low, high = axes.get_xlim()
    axes.set_xlim(low, high * 1.3)
    axes.text(0.0, -0.14, "dashed: the Pareto front of the methods that do not fail.  "
              "hollow: fails for some colours of sRGB (missed by CIEDE2000 > 1, or outside [0, 1])",
              transform=axes.transAxes, fontsize=8)
    labels.place(axes, [(p["x"], p["y"], short(p["method"]), color_of(p["method"][0]))
                        for p in points])
    save(figure, path, title)
    return best


def draw(path, folder):
    rows = read_rows(path)
    floor = 1e-8  # below the float's rounding
    round_trip = collect(rows, lambda m: max(floor, value(rows, m, "residual max", SRGB_SETS)))
    best = chart(round_trip, folder / "speed-roundtrip.svg",
                 "Speed against round-trip error inside sRGB (five sets of colours, D65)",
                 "largest |ΔXYZ| of the stored floats (log; white has Y = 1)",
                 2.0 ** -23)
    print("  front, round trip:", ", ".join(short(p["method"]) for p in best))
    charts = [s for s in dict.fromkeys(row["set"] for row in rows
                                       if row["quantity"] == "under A mean")]
    nature = collect(rows, lambda m: value(rows, m, "under A mean", charts,
                                           lambda v: sum(v) / len(v)))
    best = chart(nature, folder / "speed-nature.svg",
                 "Speed against closeness to nature: measured reflectances rebuilt from their D65 "
                 "colour,\nseen under illuminant A (" + ", ".join(charts) + ")",
                 "mean CIEDE2000 under A", 0)
    print("  front, under A:", ", ".join(short(p["method"]) for p in best))
