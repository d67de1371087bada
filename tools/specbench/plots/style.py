"""How every chart looks: ink that follows the page, one colour and mark a family, text as text."""

import csv
import math
import re

import matplotlib

matplotlib.use("agg")  # measures text; the files are SVG
import matplotlib.pyplot as plt  # noqa: E402

INK = "#010203"  # stands for the page's text colour until the file is written
STYLE = (  # a middle tone for viewers that know of no scheme
    "<style>svg{color:#7a7a7a}"
    "@media(prefers-color-scheme:light){svg{color:#24292f}}"
    "@media(prefers-color-scheme:dark){svg{color:#e6edf3}}</style>"
)

# M. Okabe, K. Ito, "Color Universal Design", 2008; their black is the ink, their yellow is left
# out, orange and sky blue are a shade darker and blue is a shade lighter, so that words in them
# can be read on white and on black.
FAMILIES = {
    "natural": ("#009E73", "o"),
    "material": ("#D81B60", "h"),
    "samples": ("#D81B60", "h"),
    "smooth": ("#6B8E23", "H"),
    "descent": ("#1677BD", "s"),
    "dual Newton": ("#8C6BB1", "p"),
    "Jakob & Hanika 2019": ("#D55E00", "^"),
    "Mallett & Yuksel 2019": ("#CC79A7", "D"),
    "max entropy": ("#CF8C00", "v"),
    "nearest to grey": ("#8A8A8A", "P"),
    "Smits 1999": ("#3A9FDB", "X"),
    "Glassner 1989": (INK, "*"),
    "measured": (INK, ""),
}

plt.rcParams.update(
    {
        "svg.fonttype": "none",
        "svg.hashsalt": "specbake",  # the same figures give the same file
        "font.family": "sans-serif",
        "font.sans-serif": ["DejaVu Sans", "Verdana", "sans-serif"],
        "font.size": 9,
        "axes.edgecolor": INK,
        "axes.labelcolor": INK,
        "axes.titlecolor": INK,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "text.color": INK,
        "xtick.color": INK,
        "ytick.color": INK,
        "grid.color": "#888888",
        "grid.alpha": 0.25,
        "axes.grid": True,
        "axes.axisbelow": True,
    }
)


def color_of(family):
    return FAMILIES.get(family, (INK, "o"))[0]


def mark_of(family):
    return FAMILIES.get(family, (INK, "o"))[1]


def read_rows(path):
    """Rows as dicts; numbers where they are numbers, NaN where the measure was none."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for row in rows:
        for key in ("value", "at"):
            if key in row:
                row[key] = float(row[key]) if row[key] else math.nan
    return rows


def value(rows, method, quantity, sets=None, pick=max):
    """The figure of a method, `pick`ed over the sets (None: all)."""
    found = [
        row["value"]
        for row in rows
        if (row["family"], row["parameters"]) == method
        and row["quantity"] == quantity
        and (sets is None or row["set"] in sets)
    ]
    return pick(found) if found else math.nan


def name_of(method):
    return f"{method[0]}, {method[1]}" if method[1] else method[0]


def methods_of(rows):
    """(family, parameters) in the order in which they were measured."""
    return list(dict.fromkeys((row["family"], row["parameters"]) for row in rows))


def save(figure, path, title):
    figure.savefig(path, transparent=True, bbox_inches="tight", pad_inches=0.1,
                   metadata={"Date": None, "Title": title})
    plt.close(figure)
    text = path.read_text(encoding="utf-8").replace(INK, "currentColor")
    # A hundredth of a point is enough.
    text = re.sub(r' (d|x|y)="[^"]*"', lambda a: re.sub(r"(\.\d\d)\d+", r"\1", a[0]), text)
    start = text.index("<metadata>")
    path.write_text(text[:start] + STYLE + "\n " + text[start:], encoding="utf-8")
    print(path)
