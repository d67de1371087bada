"""What a scene needs: nodes of the grid, and bits of the stored halves, against what they cost."""

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, NullFormatter, NullLocator

from plots import labels
from plots.style import INK, read_rows, save

COLORS = ["#009E73", "#D55E00", "#0072B2", "#CC79A7", "#CF8C00", "#3A9FDB"]
MARKS = ["o", "^", "s", "D", "v", "X"]

NODES, BITS = "nodes per axis", "mantissa bits"
GRID_PANELS = [
    ("deviation mean RMS", "mean RMS deviation\nfrom the direct solution (log)", True),
    ("under A p99", "99 % of CIEDE2000 under A below\n(against the direct solution; log)", True),
    ("bake", "bake of the whole texture,\nprocessor seconds (half, ZIP)", False),
    ("nodes solved", "nodes that the texture needed (log)", True),
]
BIT_PANELS = [
    ("under A max", "largest CIEDE2000 under A (log)", True),
    ("file", "file, bytes per texel", False),
]


def panel(axes, rows, quantity, unit, ylabel, log):
    sets = list(dict.fromkeys(row["set"] for row in rows))
    axes.set_ylabel(ylabel)
    if log:
        axes.set_yscale("log")
    if unit == NODES:
        axes.set_xscale("log")
    ends = []
    ticks = set()
    for name in sets:
        line = sorted((row["at"], row["value"]) for row in rows if row["set"] == name
                      and row["quantity"] == quantity and row["at_unit"] == unit
                      and not (log and row["value"] <= 0))
        if not line:
            continue
        color = COLORS[sets.index(name) % len(COLORS)]
        axes.plot(*zip(*line), "-", marker=MARKS[sets.index(name) % len(MARKS)], ms=4, lw=1.4,
                  color=color)
        ends.append((line[-1], name, color))
        ticks.update(x for x, _ in line)
    axes.xaxis.set_major_locator(FixedLocator(sorted(ticks)))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xticklabels([f"{t:g}" for t in sorted(ticks)])
    axes.set_xlabel(unit + (" (log)" if unit == NODES else ""))
    axes.autoscale_view()
    to_axes = axes.transData + axes.transAxes.inverted()
    heights = [to_axes.transform(end)[1] for end, _, _ in ends]
    for y, (_, name, color) in zip(labels.spread(heights, 0.075), ends):
        axes.annotate(name, (1.02, y), xycoords="axes fraction", va="center", fontsize=8,
                      color=color)


def draw(path, folder):
    rows = read_rows(path)
    title = "What a texture needs: nodes of the grid (smooth, D65), and bits of the stored halves"
    figure, grid = plt.subplots(3, 2, figsize=(10.5, 11))
    for axes, (quantity, ylabel, log) in zip(grid.flat, GRID_PANELS):
        panel(axes, rows, quantity, NODES, ylabel, log)
    for axes, (quantity, ylabel, log) in zip(grid.flat[4:], BIT_PANELS):
        panel(axes, rows, quantity, BITS, ylabel, log)
    memory = sorted({(row["at"], row["value"]) for row in rows
                     if row["quantity"] == "all nodes, memory"})
    note = "all nodes in memory:  " + ",  ".join(f"{n:g}: {b / 1e6:.2g} MB" for n, b in memory)
    figure.text(0.08, 0.92, title, fontsize=11, color=INK)
    figure.text(0.08, 0.902, note, fontsize=8, color=INK)
    figure.subplots_adjust(wspace=0.62, hspace=0.32)
    save(figure, folder / "scene.svg", title)
