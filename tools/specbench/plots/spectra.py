"""Measured spectra, and what each method makes of their colour."""

import matplotlib.pyplot as plt

from plots.style import color_of, methods_of, name_of, read_rows, save

STRONG = {"measured": 2.4, "natural": 1.8}
WEAK = {"descent": 0.5}  # it would cover the rest

# settings that are the same curve, or have a neighbour that is enough
HIDDEN = {("smooth", "Newton alone"), ("descent", "straight, flat"),
          ("descent", "closed form, random, released"), ("dual Newton", "nearest to Y")}


def draw_patch(axes, rows, methods, patch):
    for method in methods:
        line = [(row["at"], row["value"]) for row in rows if row["set"] == patch
                and (row["family"], row["parameters"]) == method]
        if not line:
            continue
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


def draw_patches(path, file, title, columns, lines):
    rows = read_rows(path)
    methods = [m for m in methods_of(rows) if m not in HIDDEN]
    patches = list(dict.fromkeys(row["set"] for row in rows))
    height = 2.4 * lines + 0.9
    figure, grid = plt.subplots(lines, columns, figsize=(10, height), sharex=True)
    for axes, patch in zip(grid.flat, patches):
        draw_patch(axes, rows, methods, patch)
    for axes in grid[-1]:
        axes.set_xlabel("wavelength, nm")
    for axes in grid[:, 0]:
        axes.set_ylabel("reflectance")
    line = 0.18 / height
    top = 0.9 + line * (2 + (len(methods) - 1) // 3)
    figure.text(0.07, top + 1.3 * line, title, fontsize=11)
    for k, method in enumerate(methods):
        dash = "┄┄ " if method[0] == "measured" else "━ "
        figure.text(0.07 + 0.29 * (k % 3), top - line * (k // 3), dash + name_of(method),
                    color=color_of(method[0]), fontsize=8.5,
                    fontweight="bold" if method[0] in STRONG else "normal")
    save(figure, file, title)


def draw(path, folder):
    draw_patches(path, folder / "spectra.svg",
                 "A dozen ColorChecker patches, rebuilt from their colour under D65", 3, 4)


def draw_natural(path, folder):
    draw_patches(path, folder / "nature-spectra.svg",
                 "Skin, leaves, wood and paint, rebuilt from their colour under D65", 2, 4)
