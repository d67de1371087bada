"""What a scene needs: nodes of the grid, and bits of the stored halves, against what they cost."""

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, NullLocator

from plots import labels
from plots.style import read_rows, save

COLORS = ["#009E73", "#D55E00", "#0072B2", "#CC79A7", "#CF8C00", "#3A9FDB"]
MARKS = ["o", "^", "s", "D", "v", "X"]

COLUMNS = ["nodes per axis", "mantissa bits"]
DEFAULTS = {"nodes per axis": 17, "mantissa bits": 10}
DEVIATION = ("deviation RMS", "RMS deviation of the reflectance\nfrom the direct solution (log)")
SEEN = ("under A p99", "99 % of colours within this\nCIEDE2000 under A (log)")
TIME = ("bake, per texel", "bake, processor time:\nµs per texel")
NODES = ("nodes, memory", "nodes that the texture needs:\nbytes (log)")
FILE = ("file", "file (half, ZIP):\nbytes per texel")
ROWS = [(DEVIATION, DEVIATION), (SEEN, SEEN), (TIME, TIME), (NODES, FILE)]


def draw_panel(axes, rows, quantity, unit, ylabel):
    axes.set_xscale("log" if unit == COLUMNS[0] else "linear")
    axes.set_yscale("log" if "(log)" in ylabel else "linear")
    axes.set_ylabel(ylabel)
    sets = list(dict.fromkeys(row["set"] for row in rows))
    found = [row for row in rows if row["quantity"] == quantity and row["at_unit"] == unit]
    ends = []
    for k, name in enumerate(sets):
        line = sorted((row["at"], row["value"]) for row in found if row["set"] == name)
        if not line:
            continue
        color = COLORS[k % len(COLORS)]
        axes.plot(*zip(*line), "-", marker=MARKS[k % len(MARKS)], ms=4, lw=1.4, color=color)
        ends.append((*line[-1], name, color))
    ticks = sorted({row["at"] for row in found})
    axes.axvline(DEFAULTS[unit], color="#888888", lw=1, ls="--")
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xticklabels([f"{t:g}" for t in ticks])
    if axes.get_yscale() == "linear":
        axes.set_ylim(0, 1.08 * max(row["value"] for row in found))
    labels.column(axes, ends)


def draw(path, folder):
    rows = read_rows(path)
    title = "What a scene needs: nodes of the grid, and bits of the stored halves (natural, D65)"
    figure, grid = plt.subplots(len(ROWS), 2, figsize=(10.5, 12.5))
    for line, quantities in zip(grid, ROWS):
        for axes, (quantity, ylabel), unit in zip(line, quantities, COLUMNS):
            draw_panel(axes, rows, quantity, unit, ylabel)
    for axes, unit in zip(grid[-1], COLUMNS):
        axes.set_xlabel(unit + (" (log)" if unit == COLUMNS[0] else ""))
    figure.text(0.08, 0.905, title + ".  Dashed: the default.", fontsize=10)
    figure.subplots_adjust(wspace=0.62, hspace=0.2)
    save(figure, folder / "scene.svg", title)
