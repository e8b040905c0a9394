#!/usr/bin/env python3
"""two_cores.py PROGRAM SHADOW [--rounds N] [--json FILE]: what a second core brings, by the clock on the wall, in turns with one core.

kernels    pairs per second of fused kernels, nothing in the way of the light: tyndall bench, one core and two
renders    fog in a closed room and a glass of juice, one process on one core and on two
workers    two shards of the room, one after the other on one core, and at the same time on a core each; then `merge`, whose time counts

SHADOW is bench/shadow, whose pipelines answer shadow segments. Prints a table; medians with the lowest and highest round. Needs two cores with nothing else to do.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PASSES = {"cornell_fog": 16, "fruit_juice": 12}


def on(cores, command, environment=None):
    """A process that may use these cores only."""
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=lambda: os.sched_setaffinity(0, cores),
                            env={**os.environ, **(environment or {})})


def done(*processes):
    """Standard outputs, once all have ended well."""
    outputs = []
    for process in processes:
        output, error = process.communicate()
        if process.returncode != 0:
            sys.exit(error.decode())
        outputs.append(output)
    return outputs


def timed(work):
    start = time.monotonic()
    work()
    return time.monotonic() - start


def rates(text):
    return {k["kernel"]: entry["pairs_per_second"]["median"] for k in json.loads(text)["kernels"] for entry in k["lanes"] if entry["lanes"] == 16}


def kernels(program, cores):
    bench = [program, "bench", "--lanes", "16", "--time", "5s", "--json", "--cores"]
    one, both = (rates(done(on(cores, bench + [which]))[0]) for which in ("one", "all"))
    return {f"kernel {name}": both[name] / one[name] for name in one}


def pipelines(shadow, cores):
    found = {}
    for count in (1, 2):
        command = [shadow, f"--cores={count}", "--benchmark_filter=pipeline", "--benchmark_format=json"]
        for run in json.loads(done(on(cores, command))[0])["benchmarks"]:
            found[run["name"].split("/")[1], count] = run["pairs_per_second"]
    return {f"pairs with shadow segments, {where}": found[where, 2] / found[where, 1] for where, count in found if count == 1}


def render(program, scene, folder, more=(), name="image.exr"):
    return [program, "render", os.path.join(ROOT, "scenes", scene, "scene.xml"), "-o", os.path.join(folder, name), "--passes", str(PASSES[scene]), "--resolution", "256x256",
            "--progress", "none", *more]


def renders(program, cores, folder):
    result = {}
    for scene in PASSES:
        one = timed(lambda: done(on(cores[:1], render(program, scene, folder))))
        result[f"render {scene}"] = one / timed(lambda: done(on(cores, render(program, scene, folder))))
    return result


def workers(program, cores, folder):
    shards = [render(program, "cornell_fog", folder, ["--shard", f"{i}/2", "--no-timestamps"], f"{i}.shard") for i in (1, 2)]
    whole = os.path.join(folder, "merged.exr")

    def merge():
        done(on(cores[:1], [program, "merge", "--output", whole] + [os.path.join(folder, f"{i}.shard") for i in (1, 2)]))

    def in_turn():
        for shard in shards:
            done(on(cores[:1], shard))
        merge()

    def together():
        done(*[on([core], shard) for core, shard in zip(cores, shards)])
        merge()

    return {"workers: shards of cornell_fog": timed(in_turn) / timed(together)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("shadow")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--json")
    wanted = parser.parse_args()
    cores = sorted(os.sched_getaffinity(0))[:2]
    if len(cores) < 2:
        sys.exit("two_cores.py: this process may use one core only")
    rounds = {}
    with tempfile.TemporaryDirectory() as folder:
        for scene in PASSES:
            done(on(cores, render(wanted.program, scene, folder)))  # fills the driver's cache of compiled kernels
        for _ in range(wanted.rounds):
            for name, value in {**kernels(wanted.program, cores), **pipelines(wanted.shadow, cores), **renders(wanted.program, cores, folder), **workers(wanted.program, cores, folder)}.items():
                rounds.setdefault(name, []).append(value)
    table = {name: {"median": statistics.median(v), "low": min(v), "high": max(v), "rounds": len(v)} for name, v in rounds.items()}
    for name, row in table.items():
        print(f"{name:45s} {row['median']:.2f} ({row['low']:.2f} - {row['high']:.2f})")
    if wanted.json:
        with open(wanted.json, "w", encoding="utf-8") as file:
            json.dump({"speed_up_on_two_cores": table}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
