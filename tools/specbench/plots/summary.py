"""One line a method: the figures that the text speaks of."""

import csv

from plots.pareto import OUTSIDE, SRGB_SETS
from plots.style import methods_of, read_rows, value

CUBE = {"RGB cube"}


def columns(rows):
    everywhere = {row["set"] for row in rows} - {OUTSIDE}
    charts = list(dict.fromkeys(row["set"] for row in rows if row["quantity"] == "under A mean"))
    yield "Mtexel/s", lambda m: value(rows, m, "throughput") / 1e6
    yield "set-up, s", lambda m: value(rows, m, "set-up")
    for quantity, sets, name in [
            ("residual max", SRGB_SETS, "sRGB: largest |ΔXYZ|"),
            ("round trip max", SRGB_SETS, "sRGB: largest CIEDE2000"),
            ("failed", SRGB_SETS, "sRGB: failed, worst set"),
            ("out of bounds", CUBE, "RGB cube: colours out of bounds"),
            ("samples out of bounds", CUBE, "RGB cube: samples out of bounds"),
            ("out of bounds by", CUBE, "RGB cube: out of bounds by"),
            ("failed", {"solid"}, "solid: failed"),
            ("failed", everywhere, "anywhere inside: failed, worst set"),
            ("roughness", CUBE, "RGB cube: roughness"),
            ("continuity p99.9", CUBE, "RGB cube: continuity p99.9")]:
        yield name, lambda m, q=quantity, s=sets: value(rows, m, q, s)
    for chart in charts:
        yield (f"{chart}: reflectance error, RMS",
               lambda m, c=chart: value(rows, m, "reflectance error mean RMS", {c}))
        for light in ("A", "D50", "F2", "F11", "LED-B3"):
            yield (f"{chart}: mean CIEDE2000 under {light}",
                   lambda m, c=chart, li=light: value(rows, m, f"under {li} mean", {c}))
        for part in ("p95", "max"):
            yield (f"{chart}: {part} CIEDE2000 under A",
                   lambda m, c=chart, q=part: value(rows, m, f"under A {q}", {c}))


def write(path, folder):
    rows = read_rows(path)
    table = list(columns(rows))
    with open(folder / "methods.csv", "w", encoding="utf-8", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["method", *(name for name, _ in table)])
        for method in methods_of(rows):
            if method[0] == "memset":
                continue
            figures = (f"{of(method):.3g}".replace("nan", "") for _, of in table)
            out.writerow([", ".join(part for part in method if part), *figures])
    print(folder / "methods.csv")
