#!/usr/bin/python3
"""Draws docs/charts/*.svg from what specbench wrote, and methods.csv: plot.py RESULTS CHARTS

One module a kind of chart, in plots/. A chart whose figures are absent is skipped, and that is said.
"""

import pathlib
import sys

sys.dont_write_bytecode = True


sys.path.insert(0, str(pathlib.Path(__file__).parent))

from plots import atlas, pareto, scene, spectra, summary  # noqa: E402


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, charts = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    charts.mkdir(parents=True, exist_ok=True)
    drawings = [
        ("accuracy.csv", pareto.draw),
        ("accuracy.csv", summary.write),
        ("stability.csv", atlas.draw_lines),
        ("map.csv", atlas.draw_map),
        ("scene.csv", scene.draw),
        ("spectra.csv", spectra.draw),
        ("nature-spectra.csv", spectra.draw_natural),
    ]
    for name, draw in drawings:
        if not (results / name).exists():
            print(f"{name}: not in {results}, its charts are skipped")
            continue
        draw(results / name, charts)


if __name__ == "__main__":
    main()
