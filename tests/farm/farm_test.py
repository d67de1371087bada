#!/usr/bin/python3
"""An array of a real Slurm that loses a node, has a task requeued, and meets a corrupt tile.

It must end with the bytes of one local process, and with a status that names the one bad tile.

    farm_test.py SPECBAKE [--measure SIDE]

--measure: instead of that, how long tiles of SIDE by SIDE take on one node and on two.
"""

import argparse
import hashlib
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import time
import zlib

import slurm

HERE = pathlib.Path(__file__).resolve().parent
JOB = HERE.parent.parent / "tools" / "farm" / "bake.sbatch"
TILES = 60
TASKS = 6
BAD = 1017
# Slow, for a task to be interrupted in its middle.
OPTIONS = ["--compression", "zip:9", "--data-type", "float"]


def png(width, height, seed):
    """Some colours with some noise."""
    noise = random.Random(seed)
    rows = bytearray()
    for y in range(height):
        base = (seed * 37 + y) % 200
        row = noise.randbytes(3 * width)
        rows += b"\0" + bytes(base + (value & 15) for value in row)

    def chunk(name, data):
        body = name + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 1)) + chunk(b"IEND", b""))


def make_tiles(folder, sides, bad=None):
    """The list of them. The bad one ends in the midst of its texels."""
    (folder / "tiles").mkdir()
    names = []
    for i in range(TILES):
        side = sides[i % len(sides)]
        data = png(side, side, i)
        number = 1001 + i
        path = folder / "tiles" / f"hull.{number}.png"
        path.write_bytes(data[:len(data) // 2] if number == bad else data)
        names.append(f"{path}\n")
    path = folder / "list.txt"
    path.write_text("".join(names))
    return path


def checksums(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.glob("*.exr"))}


def submit(cluster, tiles, out, options, program):
    words = ["sbatch", "--parsable", f"--array=1-{TASKS}", f"--output={out.parent}/log/%A_%a.log",
             f"--export=ALL,SPECBAKE={program},SPECBAKE_THREADS=0"]
    job = cluster.call(*words, str(JOB), str(tiles), str(out), *options).strip()
    last = cluster.call("sbatch", "--parsable", f"--dependency=afterany:{job}",
                        f"--output={out.parent}/log/status-%j.log", "--wrap",
                        f"{program} status @{tiles} -o {out} {' '.join(options)}").strip()
    return job, last


def lines_of(out):
    """The lines of statistics that there are: task and attempt, and what they tell."""
    for path in sorted((out / ".specbake" / "stats").glob("*.jsonl")):
        _, task, attempt = path.stem.split("-")
        for line in path.read_text().splitlines():
            try:
                yield int(task), int(attempt), json.loads(line)
            except ValueError:  # it is being written
                pass


def done_by(out, task):
    return sum(line["status"] == "baked" for number, _, line in lines_of(out) if number == task)


def running(cluster, job, node):
    """The task of the array that runs on a node; none: 0."""
    for task, (state, where) in cluster.tasks(job).items():
        if state == "RUNNING" and where == node:
            return task
    return 0


class Log:
    """Says what happens, and when."""

    def __init__(self):
        self.start = time.monotonic()

    def __call__(self, text):
        print(f"{time.monotonic() - self.start:6.1f} s  {text}", flush=True)


def disturb(cluster, job, out, log):
    """In the midst of a task each: one is requeued, the other loses its node."""
    for node, what in (("n1", "requeue"), ("n2", "lose")):
        def in_midst(node=node):
            return 2 <= done_by(out, running(cluster, job, node)) <= TILES // TASKS - 4
        cluster.wait(in_midst, 60, f"{node} is in the midst of a task")
        task = running(cluster, job, node)
        log(f"task {task} has {done_by(out, task)} of its tiles on {node}: "
            f"{'requeued' if what == 'requeue' else 'the node is lost'}")
        if what == "requeue":
            cluster.requeue(job, task)
        else:
            cluster.lose(node)


def run_out(cluster, jobs, log):
    """Until nothing of them is left; what is new is told."""
    told = {}
    deadline = time.monotonic() + 300
    while time.monotonic() < deadline:
        states = {node: state.rstrip("*") for node, state in cluster.states().items()}
        tasks = {job: cluster.tasks(job) for job in jobs}
        if states != told:
            log(f"nodes: {states}")
            told = states
        if not any(tasks.values()):
            return
        cluster.hasten(jobs[0])
        time.sleep(0.2)
    raise TimeoutError(f"300 s, and still not over: {tasks}")


def check(what, holds):
    print(f"{'ok' if holds else 'NOT OK'}: {what}", flush=True)
    return bool(holds)


def run_test(program, folder):
    log = Log()
    tiles = make_tiles(folder, [96, 128, 160], BAD)
    (folder / "log").mkdir()
    local, out = folder / "local", folder / "out"
    alone = subprocess.run([program, "bake", "-q", f"@{tiles}", "-o", local, *OPTIONS, "-j", "1"],
                           stderr=subprocess.DEVNULL)
    log(f"one local process: exit code {alone.returncode}")
    with slurm.Slurm(folder / "slurm", ["n1", "n2"]) as cluster:
        log(f"slurm stands: {cluster.states()}")
        job, last = submit(cluster, tiles, out, OPTIONS, program)
        disturb(cluster, job, out, log)
        run_out(cluster, [job, last], log)
        log("the array is over")
        ended = cluster.call("scontrol", "show", "job", last)
    status = subprocess.run([program, "status", f"@{tiles}", "-o", out, "--json", *OPTIONS],
                            stdout=subprocess.PIPE, text=True)
    told = json.loads(status.stdout)
    text = (folder / "log" / f"status-{last}.log").read_text()
    print(text)
    subprocess.run([HERE.parent.parent / "tools" / "farm" / "merge_stats", out])
    lines = list(lines_of(out))
    again = [line["status"] for _, attempt, line in lines if attempt > 0]
    bad = str(folder / "tiles" / f"hull.{BAD}.png")
    results, expected = checksums(out), checksums(local)
    good = [
        check("the local process baked all but the bad tile",
              alone.returncode == 1 and len(expected) == TILES - 1),
        check(f"{len(results)} results have its bytes", results == expected),
        check("the status names the one bad tile, and no other",
              status.returncode == 1 and told["done"] == TILES - 1 and
              [line["input"] for line in told["open"] if line["status"] == "failed"] == [bad] and
              len(told["open"]) == 1),
        check("the last job says the same, and ends with exit code 1",
              f"{TILES - 1}  done" in text and bad in text and "ExitCode=1:0" in ended),
        check("two attempts were second ones",
              len({(t, a) for t, a, _ in lines if a > 0}) == 2),
        check(f"they went on where the first were: {again.count('current')} tiles were there",
              again.count("current") >= 4),
        check(f"at most the tile that the lost node was at is half-written: {told['leftovers']}",
              len(told["leftovers"]) <= 1),
    ]
    if not all(good):
        for path in sorted((folder / "log").iterdir()):
            print(f"== {path.name}\n{path.read_text()}")
    return all(good)


def timed(cluster, words):
    """Seconds until all tasks of what is submitted are over."""
    begin = time.monotonic()
    job = cluster.call("sbatch", "--parsable", f"--array=1-{TASKS}", *words).strip()
    while cluster.tasks(job):
        time.sleep(0.1)
    return time.monotonic() - begin


def run_measure(program, folder, side):
    """An array by the model: what one process takes, shared by the nodes, and an empty array."""
    log = Log()
    tiles = make_tiles(folder, [side])
    (folder / "log").mkdir()
    log(f"{TILES} tiles of {side} x {side}")
    begin = time.monotonic()
    subprocess.run([program, "bake", "-q", f"@{tiles}", "-o", folder / "alone", "-j", "1"])
    alone = time.monotonic() - begin
    log(f"one process of one thread: {alone:.1f} s")
    with slurm.Slurm(folder / "slurm", ["n1", "n2"]) as cluster:
        for count in (1, 2):
            where = [] if count == 2 else ["--exclude=n2"]
            where.append(f"--output={folder}/log/%A_%a.log")
            out = folder / f"out{count}"
            # Twice: the first array waits for the scheduler's own start too.
            empty = min(timed(cluster, [*where, "--wrap", "true"]) for _ in range(2))
            took = timed(cluster, [*where, f"--export=ALL,SPECBAKE={program}", str(JOB),
                                   str(tiles), str(out)])
            model = alone / count + empty
            log(f"nodes: {count}; by the model {alone:.1f} / {count} + {empty:.1f} (an empty array) "
                f"= {model:.1f} s; measured {took:.1f} s")
            subprocess.run([HERE.parent.parent / "tools" / "farm" / "merge_stats", out])
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("--measure", type=int, metavar="SIDE")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="specbake-farm-") as name:
        folder = pathlib.Path(name).resolve()
        if arguments.measure:
            return run_measure(arguments.program, folder, arguments.measure)
        return run_test(arguments.program, folder)


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
