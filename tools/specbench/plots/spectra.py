"""Spectra of a dozen measured colours by every method, beside the measured ones."""

import matplotlib.pyplot as plt

from plots.style import color_of, methods_of, name_of, read_rows, save

STRONG = {"measured": 2.4, "smooth": 1.8}
WEAK = {"descent": 0.5}  # it would cover the rest

# settings that are the same curve, or have a neighbour that is enough
HIDDEN = {("smooth", "Newton alone"), ("descent", "straight, flat"),
          ("descent", "closed form, random, released"), ("dual Newton", "nearest to Y")}


def draw(path, folder):
    rows = read_rows(path)
    methods = [m for m in methods_of(rows) if m not in HIDDEN]
    patches = list(dict.fromkeys(row["set"] for row in rows))
    title = "A dozen ColorChecker patches, rebuilt from their colour under D65"
    figure, grid = plt.subplots(4, 3, figsize=(10, 10.5), sharex=True)
    for axes, patch in zip(grid.flat, patches):
        for method in methods:
            line = [(row["at"], row["value"]) for row in rows if row["set"] == patch
                    and (row["family"], row["parameters"]) == method]
            width = STRONG.get(method[0], WEAK.get(method[0], 0.9))
            axes.plot(*zip(*line), color=color_of(method[0]), lw=width,
                      ls=":" if method[0] == "measured" else "-",
                      alpha=0.5 if method[0] in WEAK else 1,
                      zorder=3 if method[0] in STRONG else 2)
        for bound in (0, 1):
            axes.axhline(bound, lw=0.6, color="#888888")
        low, high = axes.get_ylim()
        axes.set_ylim(max(low, -0.3), min(high, 1.25))
        axes.set_title(patch, loc="left", fontsize=9)
    for axes in grid[-1]:
        axes.set_xlabel("wavelength, nm")
    for axes in grid[:, 0]:
        axes.set_ylabel("reflectance")
    figure.text(0.07, 0.962, title, fontsize=11)
    for k, method in enumerate(methods):
        dash = "┄┄ " if method[0] == "measured" else "━ "
        figure.text(0.07 + 0.29 * (k % 3), 0.94 - 0.017 * (k // 3), dash + name_of(method),
                    color=color_of(method[0]), fontsize=8.5,
                    fontweight="bold" if method[0] in STRONG else "normal")
    save(figure, folder / "spectra.svg", title)
