#!/usr/bin/env python3
"""What every effect costs in time and in noise.

    bench/effects/effects.py build/tyndall [--passes 16] [--lights 256] [--repeats 3] [--json effects.json] [--svg effects.svg]

Two tables. "Price": scenes/six_vrls, where nothing is needed, with kernels built for one feature more: the image is the same, the difference is the price of the
feature alone. "Effect": the scenes of effect_scenes.py, one for each effect, beside the same scene without it: time per pass, relMSE after as many passes, and
their product, which is what an image of equal quality costs. Counted are processor seconds of the whole process, which other processes disturb less than the clock
on the wall, less those of a render of the same passes with one light; medians of the repeats, and the spread. Only the layer media_to_media is rendered.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile

import effect_scenes
import effects_figure

MASKS = ["none", "ANISOTROPIC", "ANISOTROPIC,PHASE_LOBES", "COLOURED", "OCCLUDERS", "MANY_MEDIA", "BOUNDARIES", "NONCONVEX_MEDIA,OCCLUDERS", "HETEROGENEOUS", "COLOURED,HETEROGENEOUS,COLOURED_GRIDS", "SHORT_LIGHTS",
         "DEPTH_LIMIT", "all"]
ON_THE_HOST = ("NONCONVEX_MEDIA,OCCLUDERS", "all")  # each connection is walked there


def render(program, scene, folder, options):
    """Processor seconds and the report of one render of media_to_media."""
    output = os.path.join(folder, "image.exr")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "render", scene, "-o", output, "--layer", "media_to_media", "--progress", "none", *options], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "image.json"), encoding="utf-8") as report:
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, json.load(report)


def measure(program, scene, folder, lights, arguments, options):
    """Nanoseconds per pair (one per repeat), pairs and relMSE; the first render fills the driver's cache and is not counted."""
    def seconds(count):
        return render(program, scene, folder, ["-p", str(arguments.passes), "--lights", str(count), *options])
    seconds(1)
    repeats = []
    for _ in range(arguments.repeats):
        rest, few = seconds(1)
        whole, report = seconds(lights)
        pairs = report["counts"]["pairs"]
        repeats.append((whole - rest) / (pairs - few["counts"]["pairs"]) * 1e9)
    return sorted(repeats), pairs, report["error"] ** 2 if report["error"] else None


def row_of(repeats, **more):
    return {"nanoseconds_per_pair": statistics.median(repeats), "low": repeats[0], "high": repeats[-1], **more}


def prices(arguments):
    scene = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes/six_vrls/scene.xml")
    rows = []
    for mask in MASKS:
        with tempfile.TemporaryDirectory() as folder:
            lights = 8 if mask in ON_THE_HOST else 4 * arguments.lights
            repeats, _, _ = measure(arguments.program, scene, folder, lights, arguments, ["--resolution", "128x128", "--features", mask])
        rows.append(row_of(repeats, features=mask))
        print(f"price   {mask:28} {rows[-1]['nanoseconds_per_pair']:8.2f} ns per pair ({repeats[0]:.2f} - {repeats[-1]:.2f})", flush=True)
    return rows


def effects(arguments):
    rows = []
    for effect in effect_scenes.VARIANTS:
        with tempfile.TemporaryDirectory() as folder:
            scene, options = effect_scenes.write(effect, folder)
            repeats, pairs, square = measure(arguments.program, scene, folder, arguments.lights, arguments, options)
        rows.append(row_of(repeats, effect=effect, pairs=pairs, relative_square_error=square))
        base = rows[0]
        time = rows[-1]["nanoseconds_per_pair"] / base["nanoseconds_per_pair"]
        noise = square / base["relative_square_error"]
        rows[-1].update(time_ratio=time, variance_ratio=noise)
        print(f"effect  {effect:18} {rows[-1]['nanoseconds_per_pair']:8.2f} ns per pair ({repeats[0]:.2f} - {repeats[-1]:.2f})  time x{time:6.2f}  variance x{noise:6.2f}  "
              f"both x{time * noise:7.2f}", flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--lights", type=int, default=256)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--json")
    parser.add_argument("--svg")
    arguments = parser.parse_args()
    results = {"schema": "tyndall-bench-effects/2", "prices": prices(arguments), "effects": effects(arguments)}
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(results, file, indent=1)
            file.write("\n")
    if arguments.svg:
        with open(arguments.svg, "w", encoding="utf-8") as file:
            file.write(effects_figure.figure(results))


if __name__ == "__main__":
    sys.exit(main())
