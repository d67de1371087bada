"""The stability atlas: what happens towards the boundary, and where in the chromaticity diagram."""

import matplotlib.pyplot as plt
import numpy as np

from plots import labels
from plots.style import color_of, mark_of, methods_of, name_of, read_rows, save

PANELS = [
    ("failed", "failed, share of colours\n(linear to 1 %, then log)"),
    ("residual p99", "99 % of residuals below,\n|ΔXYZ| (log)"),
    ("continuity p99", "99 % of stretches below,\n|Δs| / |ΔRGB| (log)"),
]
# without failures, as the one of their family that is shown
UNMAPPED = {("smooth", "Newton alone"), ("descent", "straight, flat"),
            ("descent", "closed form, random, released"), ("dual Newton", "nearest to Y")}
VERDICTS = {"good": None, "missed": "#D55E00", "out of bounds": "#0072B2", "gave up": "#CC79A7"}
MEANING = {"good": "", "missed": ": CIEDE2000 > 1", "out of bounds": ": a sample, by > 0.001",
           "gave up": ": the method says so"}
FLOOR = 1e-16


def line_of(rows, method, quantity):
    found = [(row["at"], row["value"]) for row in rows
             if (row["family"], row["parameters"]) == method and row["quantity"] == quantity]
    return zip(*sorted(found, reverse=True))


def dash_of(methods, method):
    """Methods of one family differ by their dashes."""
    family = [m for m in methods if m[0] == method[0]]
    return ["-", "--", ":", "-."][family.index(method) % 4]


def draw_lines(path, folder):
    rows = read_rows(path)
    methods = methods_of(rows)
    title = "Towards the boundary of the object-colour solid: random directions, D65"
    figure, panels = plt.subplots(3, 1, figsize=(9, 12), sharex=True)
    panels[0].set_xscale("log")
    panels[0].invert_xaxis()
    panels[0].set_title(title, loc="left", fontsize=10)
    for axes, (quantity, ylabel) in zip(panels, PANELS):
        if quantity == "failed":
            axes.set_yscale("symlog", linthresh=0.01, linscale=0.6)
            axes.set_yticks([0, 0.01, 0.1, 1], ["0", "1 %", "10 %", "100 %"])
        else:
            axes.set_yscale("log")
        ends = []
        for method in methods:
            x, y = line_of(rows, method, quantity)
            y = y if quantity == "failed" else [max(v, FLOOR) for v in y]
            axes.plot(x, y, dash_of(methods, method), marker=mark_of(method[0]), ms=3.5, lw=1.3,
                      color=color_of(method[0]))
            ends.append((x[-1], y[-1], name_of(method), color_of(method[0])))
        axes.set_ylabel(ylabel)
        labels.column(axes, ends)
    panels[-1].set_xlabel("1 − gauge (log)  →  nearer to the boundary")
    figure.subplots_adjust(hspace=0.12)
    save(figure, folder / "stability.svg", title)


def picture(points, step):
    """An RGBA image of one method at one luminance: faint where good, coloured where not."""
    columns, lines = round(0.75 / step) + 1, round(0.85 / step) + 1
    image = np.zeros((lines, columns, 4))
    for row in points:
        i, j = round(float(row["x"]) / step), round(float(row["y"]) / step)
        color = VERDICTS[row["verdict"]]
        image[j, i] = (0.5, 0.5, 0.5, 0.3) if color is None else \
            (*matplotlib_rgb(color), 1.0)
    return image


def matplotlib_rgb(color):
    from matplotlib.colors import to_rgb
    return to_rgb(color)


def draw_map(path, folder):
    rows = read_rows(path)
    methods = [m for m in methods_of(rows) if m not in UNMAPPED]
    luminances = sorted({float(row["luminance"]) for row in rows})
    xs = sorted({float(row["x"]) for row in rows})
    step = min(b - a for a, b in zip(xs, xs[1:]))
    title = "Where each method fails: every chromaticity that a surface can have at a luminance"
    figure, grid = plt.subplots(len(luminances), len(methods), sharex=True, sharey=True,
                                figsize=(1.45 * len(methods), 1.65 * len(luminances) + 0.6))
    for line, Y in enumerate(luminances):
        for axes, method in zip(grid[line], methods):
            points = [row for row in rows if (row["family"], row["parameters"]) == method
                      and float(row["luminance"]) == Y]
            axes.imshow(picture(points, step), origin="lower", interpolation="nearest",
                        extent=(-step / 2, 0.75 + step / 2, -step / 2, 0.85 + step / 2))
            bad = sum(row["verdict"] != "good" for row in points) / max(1, len(points))
            axes.text(0.98, 0.97, "none" if bad == 0 else f"{100 * bad:.2g} %", fontsize=7,
                      ha="right", va="top", transform=axes.transAxes)
            axes.tick_params(labelsize=6)
            if line == 0:
                axes.set_title(name_of(method).replace(" & ", " &\n").replace(", ", ",\n", 1),
                               fontsize=7.5, color=color_of(method[0]))
            if method == methods[0]:
                axes.set_ylabel(f"Y = {Y:g}\ny", fontsize=8)
            if line + 1 == len(luminances):
                axes.set_xlabel("x", fontsize=8)
    legend = [(k, v) for k, v in VERDICTS.items() if v]
    figure.subplots_adjust(wspace=0.12, hspace=0.02, top=0.87, bottom=0.1)
    figure.text(0.09, 0.955, title + ". In the corners: the share that fails.", fontsize=10)
    for k, (name, color) in enumerate([("good", "#888888")] + legend):
        figure.text(0.09 + 0.24 * k, 0.02, "■ " + name + MEANING[name], color=color, fontsize=8.5)
    save(figure, folder / "stability-map.svg", title)
