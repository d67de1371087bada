#!/usr/bin/python3
"""How fast specbake bakes, as ratios measured side by side in one run.

    speed.py BUILD OUT [--pairs N] [--full] [--textures FILE...]

BUILD holds specbake, write_again and texel_path_bench. Writes OUT/speed.json, and prints the same
as tables. Every ratio is the median over pairs of runs that alternate, so that what else the
machine does falls on both alike.
"""

import argparse
import json
import os
import pathlib
import platform
import re
import shutil
import statistics
import subprocess
import sys
import time

COMPRESSIONS = ["none", "zip", "piz"]


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(command):
    """Wall seconds, processor seconds and peak memory in MiB of a command."""
    start = time.perf_counter()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    if status != 0:
        sys.exit(f"speed.py: failed: {' '.join(map(str, command))}")
    return {"wall": wall, "processor": usage.ru_utime + usage.ru_stime,
            "memory": usage.ru_maxrss / 1024}


def clear(path):
    """No file there, and none that the disk is still busy with: replacing one would wait for it."""
    path.unlink(missing_ok=True)
    os.sync()


class WriteAgain:
    """OpenImageIO, writing the pixels of a file from memory."""

    def __init__(self, program, source, target, compression):
        self.target = target
        self.process = subprocess.Popen([program, source, target, compression], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.process.stdout.readline()

    def seconds(self):
        clear(self.target)
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.wait()


class Bench:
    def __init__(self, build, work, pairs):
        self.build, self.work, self.pairs = build, work, pairs
        self.baked, self.written = work / "baked.exr", work / "written.exr"

    def bake(self, texture, *options):
        clear(self.baked)
        return run([self.build / "specbake", "bake", "-q", texture, "-o", self.baked, *options])

    def whole_bake(self, texture, compression, pairs):
        """A bake beside OpenImageIO writing the same pixels; sizes beside each other."""
        self.bake(texture, "--compression", "none")
        plain = self.work / "plain.exr"
        self.baked.rename(plain)
        other = WriteAgain(self.build / "write_again", plain, self.written, compression)
        times = []
        for _ in range(pairs):
            ours = self.bake(texture, "--compression", compression)["wall"]
            times.append((ours, other.seconds()))
        other.close()
        plain.unlink()
        result = {"texture": texture.name, "compression": compression,
                  "bake_seconds": statistics.median(ours for ours, _ in times),
                  "write_seconds": statistics.median(theirs for _, theirs in times),
                  "ratio": statistics.median(ours / theirs for ours, theirs in times),
                  "size_ratio": self.baked.stat().st_size / self.written.stat().st_size}
        if compression == "none":
            result["copy_ratio"] = self.beside_copy(texture, pairs)
        return result

    def beside_copy(self, texture, pairs):
        ratios = []
        for _ in range(pairs):
            ours = self.bake(texture, "--compression", "none")["wall"]
            clear(self.written)
            ratios.append(ours / run(["cp", self.baked, self.written])["wall"])
        return statistics.median(ratios)

    def threads(self, texture, pairs):
        ratios = []
        for _ in range(pairs):
            one = self.bake(texture, "--compression", "zip", "--threads", 1)["wall"]
            ratios.append(one / self.bake(texture, "--compression", "zip", "--threads", 2)["wall"])
        return statistics.median(ratios)

    def pattern(self, side):
        """A synthetic texture: slow ramps with the noise of a photograph."""
        path = self.work / f"pattern_{side}.png"
        ramps = ":".join(["fill", "topleft=0.75,0.55,0.35", "topright=0.35,0.5,0.3",
                          "bottomleft=0.3,0.35,0.55", "bottomright=0.6,0.25,0.2"])
        subprocess.run(["oiiotool", "--pattern", ramps, f"{side}x{side}", "3",
                        "--noise:type=gaussian:stddev=0.01:seed=1", "-d", "uint8", "-o", path],
                       check=True)
        return path


def kernel(build):
    """Shares of the three-primaries product's speed, one thread, floats."""
    output = subprocess.run([build / "texel_path_bench", "--benchmark_format=json"], check=True,
                            capture_output=True, text=True).stdout
    return {run["run_name"]: run["items_per_second"] for run in json.loads(output)["benchmarks"]
            if run["aggregate_name"] == "median"}


def machine():
    info = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    model = re.search(r"model name\s*: (.*)", info)
    return {"processor": model[1] if model else platform.machine(), "threads": os.cpu_count(),
            "load": os.getloadavg()[0]}


def table(titles, rows):
    print("\n| " + " | ".join(titles) + " |\n|" + "---|" * len(titles))
    for row in rows:
        print("| " + " | ".join(f"{v:.3g}" if isinstance(v, float) else str(v) for v in row) + " |")


def report(results):
    m = results["machine"]
    print(f"{m['processor']}, {m['threads']} threads; load before the run {m['load']:.2f}")
    rates = results["kernel"]
    base = rates["threePrimaries/float"]
    table(["kernel, one thread", "Mtexel/s", "share of three primaries"],
          [(name, rate / 1e6, rate / base) for name, rate in sorted(rates.items())])
    table(["texture", "compression", "bake, s", "OpenImageIO, s", "ratio", "size ratio",
           "to cp"],
          [(b["texture"], b["compression"], b["bake_seconds"], b["write_seconds"], b["ratio"],
            b["size_ratio"], b.get("copy_ratio", "")) for b in results["bakes"]])
    table(["1 : 2 threads, zip", "ratio"], list(results["threads"].items()))
    table(["peak memory, zip", "MiB"], list(results["memory"].items()))
    table(["16×16 texture, whole process", "ms"], list(results["start"].items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--full", action="store_true", help="as many pairs of 4096² too")
    parser.add_argument("--textures", type=pathlib.Path, nargs="*", default=[],
                        help="besides the synthetic one")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    work = options.out / "work"
    work.mkdir(exist_ok=True)
    bench = Bench(options.build.resolve(), work.resolve(), options.pairs)
    results = {"machine": machine(), "pairs": options.pairs}

    say("kernel")
    results["kernel"] = kernel(bench.build)
    say("start")
    tiny = bench.pattern(16)
    starts = [bench.bake(tiny) for _ in range(21)]
    results["start"] = {"wall": statistics.median(s["wall"] for s in starts) * 1e3,
                        "processor": statistics.median(s["processor"] for s in starts) * 1e3}
    results["bakes"], results["threads"], results["memory"] = [], {}, {}
    large = bench.pattern(4096)
    for texture in [*options.textures, large]:
        pairs = options.pairs if texture != large or options.full else 1
        for compression in COMPRESSIONS:
            say(f"{texture.name}, {compression}")
            results["bakes"].append(bench.whole_bake(texture, compression, pairs))
    for texture in [*options.textures[:1], large]:
        say(f"{texture.name}, 1 and 2 threads")
        results["threads"][texture.name] = bench.threads(texture, options.pairs)
    for side in [1024, 4096, 8192]:
        say(f"memory of {side}²")
        results["memory"][f"{side}²"] = bench.bake(bench.pattern(side))["memory"]
    shutil.rmtree(work)
    (options.out / "speed.json").write_text(json.dumps(results, indent=1), encoding="utf-8")
    report(results)


if __name__ == "__main__":
    main()
