#!/usr/bin/python3
"""Whether specbake reads what other programs read: every row of docs/inputs.md.

    foreign.py PROGRAM WORK [--rows ROOM] [--only TEXT] [--table FILE]

A room is one of ROOMS; without one, all. Makes small files in WORK with other programs, bakes each with PROGRAM (build/specbake), and compares
the bands, texel by texel, with the colours that other programs decode. --table writes the rows into
FILE, between its two marks. Exit status 77 if a program that makes or decodes files is missing,
unless CI is set: then, and if a row is wrong, it is 1.
"""

import argparse
import importlib
import os
import pathlib
import shutil
import sys

ROOMS = ["formats", "layers", "turned", "profiles"]
PROGRAMS = ["convert", "identify", "gif2rgb", "cwebp", "dwebp", "raw2tiff", "tiffcp",
            "tiffset", "exiftool", "exrheader", "transicc"]
SKIPPED = 77
BEGIN, END = "<!-- rows: tests/foreign -->\n", "<!-- end of rows -->\n"


def missing():
    lacking = [name for name in PROGRAMS if shutil.which(name) is None]
    try:
        import numpy  # noqa: F401
        from PIL import Image  # noqa: F401
    except ImportError as error:
        lacking.append(error.name)
    return lacking


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--rows", choices=ROOMS)
    parser.add_argument("--only", default="")
    parser.add_argument("--table", type=pathlib.Path)
    return parser.parse_args()


def rows_of(room):
    for name in [room] if room else ROOMS:
        yield from importlib.import_module(name).rows()


def row_of_table(case, outcome):
    kind = case.kind + ("" if not case.options or "`" in case.kind else
                        ", `" + " ".join(case.options) + "`")
    what = "refused" if case.refused else case.read or "all of it"
    line = outcome.line.replace("|", "\\|")
    figures = "" if case.refused else f"{outcome.mean:.4f} | {outcome.largest:.4f}"
    return (f"| {case.format} | {kind} | {what} | {case.maker} | "
            f"{case.decoder if not case.refused else ''} | {figures or ' | '} | {line} |")


def write_table(path, rows):
    text = path.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    head = ("| format | kind | what is read | made by | compared with | mean ΔE2000 | max | remark "
            "or refusal |\n|---|---|---|---|---|---|---|---|\n")
    path.write_text(text[:begin] + head + "\n".join(rows) + "\n" + text[end:])


def main():
    a = arguments()
    lacking = missing()
    if lacking:
        print("missing, see ./dev: " + ", ".join(lacking), file=sys.stderr)
        return 1 if os.environ.get("CI") else SKIPPED
    from case import judge
    shutil.rmtree(a.work, ignore_errors=True)
    a.work.mkdir(parents=True)
    table, failures, count = [], 0, 0
    for case in rows_of(a.rows):
        if a.only and a.only not in f"{case.format} {case.kind} {case.name}":
            continue
        outcome = judge(case, a.program.resolve(), a.work.resolve())
        count += 1
        table.append(row_of_table(case, outcome))
        if outcome.failure:
            failures += 1
            print(f"{case.format}, {case.kind}: {outcome.failure}", file=sys.stderr)
    print(f"{count} rows, {failures} wrong")
    if a.table and failures == 0:
        write_table(a.table, table)
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
