"""Speed against accuracy: a point a method and setting, and the fronts that none of them beats."""

import math

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, NullLocator

from plots import labels
from plots.style import INK, color_of, mark_of, methods_of, name_of, read_rows, save, value

SRGB_SETS = {"RGB cube", "8-bit lattice", "dark", "near black, saturated", "near white"}
OUTSIDE = "just outside"  # no spectrum has these: failing is right
OWN_FRAME = "his white"  # Smits in the frame of his paper: not the same colours
LIMIT = ("memset", "")
# what has a neighbour of the same speed and spectra
UNSHOWN = {("smooth", "Newton alone"), ("descent", "closed form, flat, grid 17"),
           ("descent", "straight, random, grid 17")}
NODES_LABELLED = {"5", "17", "25", "33", "65"}  # those that stand apart
OWN = {"natural", "smooth"}
GRIDS = "natural, grid of 5 to 65 nodes (default 17)"
EXACT = 2.0 ** -23  # |ΔXYZ| below which is the rounding of stored floats
SPEED = "texels per second on one thread, 81 floats each (log)  →  faster"
KEY = ("filled: for every colour that a surface can have.  half: for all of sRGB only.  "
       "hollow: fails inside sRGB\n(CIEDE2000 > 1, a sample outside [0, 1] by > 0.001, or it says "
       "so).  ")


def soundness(rows, method):
    """full: fails nowhere in the solid; left: nowhere in sRGB; none: somewhere there."""
    if value(rows, method, "failed", SRGB_SETS) > 0:
        return "none"
    if method[0] in OWN:
        method = (method[0], "direct")  # which the grid's colours outside the cube get
    everywhere = {row["set"] for row in rows} - {OUTSIDE}
    return "left" if value(rows, method, "failed", everywhere) > 0 else "full"


def front(points):
    """The points that no other beats: as fast and nearer, or as near and faster."""
    kept = []
    for point in sorted(points, key=lambda p: (-p["x"], p["y"])):
        if not kept or point["y"] < kept[-1]["y"]:
            kept.append(point)
    return kept


def collect(rows, error):
    points = []
    for method in methods_of(rows):
        if method[1] == OWN_FRAME or method == LIMIT or method in UNSHOWN:
            continue
        points.append({"method": method, "x": value(rows, method, "throughput"),
                       "y": error(method), "sound": soundness(rows, method)})
    return points


def label_of(p):
    return p["x"], p["y"], name_of(p["method"]), color_of(p["method"][0])


def mark(axes, p, y=None):
    family = p["method"][0]
    axes.plot(p["x"], p["y"] if y is None else y, mark_of(family), color=color_of(family),
              ms=10 if mark_of(family) == "*" else 7, fillstyle=p["sound"],
              markerfacecoloralt="none", zorder=3)


def mark_limit(axes, rows):
    """What writing alone allows."""
    speed = value(rows, LIMIT, "throughput")
    axes.axvline(speed, color="#888888", lw=1, ls=":")
    axes.annotate("memset of\nas much", (speed, 1), xycoords=("data", "axes fraction"),
                  xytext=(3, -2), textcoords="offset points", va="top", fontsize=7.5)


def row_of(method):
    """The methods that share a row of the exact ones."""
    return ("natural", "grid") if method[0] == "natural" and "grid" in method[1] else method


def label_nodes(axes, points):
    """points: (point, y)."""
    for p, y in points:
        nodes = p["method"][1].removeprefix("grid ")
        if nodes in NODES_LABELLED:
            first = nodes == "5"  # others stand close above it
            axes.annotate(nodes, (p["x"], y), xytext=(5, 4) if first else (0, 6),
                          textcoords="offset points", ha="left" if first else "center",
                          fontsize=7, color=color_of("natural"))


def draw_exact(axes, points):
    """A row a method: below the floats' rounding, only speed differs."""
    rows = list(dict.fromkeys(row_of(p["method"])
                              for p in sorted(points, key=lambda p: (p["x"]))))
    for k, row in enumerate(rows):
        line = [p for p in points if row_of(p["method"]) == row]
        axes.plot([p["x"] for p in line], [k] * len(line), lw=1, color=color_of(row[0]), alpha=0.6)
        for p in line:
            mark(axes, p, k)
        if len(line) > 1:
            label_nodes(axes, [(p, k) for p in line])
        text = GRIDS if len(line) > 1 else name_of(row)
        first = min(p["x"] for p in line)
        right = first < 3e5
        axes.annotate(text, (first, k), xytext=(9 if right else -9, 0),
                      textcoords="offset points", ha="left" if right else "right", va="center",
                      fontsize=8, color=color_of(row[0]))
    axes.set_ylim(-0.7, len(rows) - 0.1)
    axes.set_yticks([])
    axes.set_ylabel(f"exact: |ΔXYZ| < {EXACT:.1e},\nthe floats' rounding")


def draw_round_trip(rows, path):
    title = "Speed against round-trip error inside sRGB (five sets of colours, D65)"
    points = collect(rows, lambda m: value(rows, m, "residual max", SRGB_SETS))
    figure, (above, below) = plt.subplots(2, 1, figsize=(9, 7.4), sharex=True,
                                          height_ratios=(1, 1.35))
    above.set_xscale("log")
    above.set_yscale("log")
    missing = [p for p in points if p["y"] >= EXACT]
    for p in missing:
        mark(above, p)
    above.set_ylabel("largest |ΔXYZ| (log; white has Y = 1)")
    above.set_title(title, loc="left", fontsize=10)
    draw_exact(below, [p for p in points if p["y"] < EXACT])
    mark_limit(below, rows)
    above.axvline(value(rows, LIMIT, "throughput"), color="#888888", lw=1, ls=":")
    for sound, dash in ((("full", "left"), "--"), (("full",), "-")):
        best = max((p for p in points if p["y"] < EXACT and p["sound"] in sound),
                   key=lambda p: p["x"])
        print("  exact and fastest:", name_of(best["method"]))
        for axes in (above, below):
            axes.axvline(best["x"], color=INK, lw=1, ls=dash, alpha=0.7)
    below.set_xlabel(SPEED)
    below.text(0, -0.17, KEY + "lines: the Pareto fronts of the filled (solid), and of filled and "
               "half (dashed)", transform=below.transAxes, fontsize=8, va="top")
    above.set_xlim(6e3, 6e7)
    figure.subplots_adjust(hspace=0.06)
    labels.place(above, [label_of(p) for p in missing])
    save(figure, path, title)


def draw_nature(rows, path):
    charts = list(dict.fromkeys(row["set"] for row in rows if row["quantity"] == "under A mean"))
    title = ("Speed against closeness to nature: measured reflectances rebuilt from their D65 "
             "colour,\nseen under illuminant A (" + ", ".join(charts) + ")")
    points = collect(rows, lambda m: value(rows, m, "under A mean", charts,
                                           lambda v: sum(v) / len(v)))
    figure, axes = plt.subplots(figsize=(9, 6.2))
    axes.set_xscale("log")
    axes.set_yscale("log")
    grid = [p for p in points if row_of(p["method"]) == ("natural", "grid")]
    axes.plot([p["x"] for p in grid], [p["y"] for p in grid], lw=1, color=color_of("natural"),
              alpha=0.6)
    for p in points:
        mark(axes, p)
    for sound, dash in ((("full", "left"), "--"), (("full",), "-")):
        best = front([p for p in points if p["sound"] in sound])
        print("  front under A:", "; ".join(name_of(p["method"]) for p in best))
        axes.plot([6e3] + [p["x"] for p in reversed(best)] + [best[0]["x"]],
                  [best[-1]["y"]] + [p["y"] for p in reversed(best)] + [20], dash, color=INK, lw=1,
                  drawstyle="steps-post", alpha=0.7)
    ticks = [0.7, 1, 1.5, 2, 3, 5, 8]
    axes.yaxis.set_major_locator(FixedLocator(ticks))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_yticklabels([f"{t:g}" for t in ticks])
    axes.set_xlim(6e3, 6e7)
    low = min(p["y"] for p in points)
    axes.set_ylim(0.8 * low, 1.15 * max(p["y"] for p in points))
    mark_limit(axes, rows)
    axes.set_xlabel(SPEED)
    axes.set_ylabel("mean CIEDE2000 under A (log)")
    axes.set_title(title, loc="left", fontsize=10)
    axes.text(0, -0.11, KEY + "lines: the Pareto fronts of the filled (solid), and of filled and "
              "half (dashed)", transform=axes.transAxes, fontsize=8, va="top")
    fast = [p for p in points if p["x"] > 1.9e7]
    labels.column(axes, [label_of(p) for p in fast])
    label_nodes(axes, [(p, p["y"]) for p in grid])
    left = min(grid, key=lambda p: p["x"])
    axes.annotate(GRIDS, (left["x"], left["y"]), xytext=(14, 17), textcoords="offset points",
                  ha="right", fontsize=8, color=color_of("natural"))
    labels.place(axes, [label_of(p) for p in points if p not in fast and p not in grid],
                 [(p["x"], p["y"]) for p in fast + grid])
    save(figure, path, title)


def draw(path, folder):
    rows = read_rows(path)
    draw_round_trip(rows, folder / "speed-roundtrip.svg")
    draw_nature(rows, folder / "speed-nature.svg")
