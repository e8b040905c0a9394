#!/usr/bin/env python3
"""What every feature costs: seconds per pair of a light and an eye with and without it, on a scene whose image does not depend on it.

    bench/effects/effects.py build/tyndall [--passes 6] [--lights 512] [--json effects.json]

The scene is scenes/six_vrls, where nothing is needed: every mask gives the same image, so the difference is the price of the feature alone. Counted are
processor seconds of the whole process (user and system), which other processes on the machine disturb less than wall clock; each mask is run twice, the first
time for the driver's cache, and what the mask "none" needs with a single light is taken off as everything that is not a pair.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile

MASKS = ["none", "ANISOTROPIC", "COLOURED", "OCCLUDERS", "MANY_MEDIA", "BOUNDARIES", "NONCONVEX_MEDIA,OCCLUDERS", "SHORT_LIGHTS", "DEPTH_LIMIT", "all"]


def processor_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def measure(program, scene, mask, lights, passes):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "image.exr")
        command = [program, "render", scene, "-o", output, "-p", str(passes), "--lights", str(lights), "--layer", "media_to_media", "--resolution", "128x128",
                   "--progress", "none", "--features", mask]
        processor_seconds(command)
        seconds = min(processor_seconds(command) for _ in range(2))
        with open(os.path.join(folder, "image.json")) as report:
            return seconds, json.load(report)["counts"]["pairs"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--passes", type=int, default=4)
    parser.add_argument("--lights", type=int, default=1024)
    parser.add_argument("--json")
    arguments = parser.parse_args()
    scene = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes/six_vrls/scene.xml")
    rest, _ = measure(arguments.program, scene, "none", 1, arguments.passes)
    rows = []
    for mask in MASKS:
        seconds, pairs = measure(arguments.program, scene, mask, 8 if "NONCONVEX" in mask or mask == "all" else arguments.lights, arguments.passes)
        rows.append({"features": mask, "pairs": pairs, "nanoseconds_per_pair": 1e9 * (seconds - rest) / pairs})
        print(f"{mask:28} {pairs:>12} pairs {rows[-1]['nanoseconds_per_pair']:9.2f} ns each, {rows[-1]['nanoseconds_per_pair'] - rows[0]['nanoseconds_per_pair']:+9.2f}", flush=True)
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump({"schema": "tyndall-bench-effects/1", "rows": rows}, file, indent=2)


if __name__ == "__main__":
    sys.exit(main())
