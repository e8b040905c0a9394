#!/usr/bin/env python3
"""What more virtual lights per pass cost and what they are worth.

    bench/scaling.py build/tyndall [--lights 1024,4096,...] [--seeds 3] [--passes 3] [--size 256] [--json scaling.json] [--svg scaling.svg] [SCENE ...]

For each scene and number of lights, in turns over the seeds: processor seconds of a pass (a render less one of a single pass) and relMSE of that many passes against
a long render of its own seed, whose estimated share is taken off. The error of single pixels and of means over 8 x 8 pixels comes from `tyndall compare`. Drawn: the
time of a pass, and the error that a fixed time leaves, both beside the fewest lights = 1. Only the layer media_to_media is rendered.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def seconds_of(command):
    """Processor seconds and the peak of memory, in MiB, of one run."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    complaint = process.stderr.read().decode()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)}: {complaint}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


class Bench:
    def __init__(self, program, scene, size, folder):
        self.program, self.scene, self.size, self.folder = program, os.path.join(ROOT, "scenes", scene, "scene.xml"), size, folder
        self.reference = os.path.join(folder, f"{scene}.exr")

    def render(self, output, *options):
        return seconds_of([self.program, "render", self.scene, "-o", output, "--resolution", f"{self.size}x{self.size}", "--layer", "media_to_media", "--progress", "none", *map(str, options)])

    def make_reference(self, passes):
        self.render(self.reference, "--passes", passes, "--lights", 16384, "--selected", 256, "--seed", 999983)
        with open(self.reference[:-4] + ".json", encoding="utf-8") as report:
            self.share = json.load(report)["error"] ** 2

    def errors(self, image):
        """relMSE of single pixels and of means over 8 x 8, without the reference's share of the first."""
        result = subprocess.run([self.program, "compare", image, self.reference, "--json"], check=True, capture_output=True, text=True)
        error = json.loads(result.stdout)
        return error["relative_mse"] - self.share, error["blocks_relative_mse"]

    def row(self, lights, seed, passes):
        image = os.path.join(self.folder, "image.exr")
        one, _ = self.render(image, "--passes", 1, "--lights", lights, "--seed", seed)
        many, memory = self.render(image, "--passes", passes, "--lights", lights, "--seed", seed)
        pixels, blocks = self.errors(image)
        return {"seconds": (many - one) / (passes - 1), "pixels": pixels * passes, "blocks": blocks * passes, "memory": memory}


def measure(arguments, scene, folder):
    bench = Bench(arguments.program, scene, arguments.size, folder)
    bench.make_reference(arguments.reference_passes)
    runs = {lights: [] for lights in arguments.lights}
    for seed in range(1, arguments.seeds + 1):
        for lights in arguments.lights:
            runs[lights].append(bench.row(lights, seed, arguments.passes))
    rows = []
    for lights, of_lights in runs.items():
        seconds = [run["seconds"] for run in of_lights]
        mean = {key: statistics.mean(run[key] for run in of_lights) for key in ("pixels", "blocks")}
        rows.append({"lights": lights, "seconds": statistics.median(seconds), "low": min(seconds), "high": max(seconds), "memory_mib": max(run["memory"] for run in of_lights),
                     "relative_mse": mean["pixels"], "relative_mse_blocks": mean["blocks"],
                     "lowest": min(run["pixels"] for run in of_lights), "highest": max(run["pixels"] for run in of_lights)})
        print(f"{scene}: {lights} lights: {rows[-1]['seconds']:.3f} s, relMSE of a pass {mean['pixels']:.4g}, of means {mean['blocks']:.4g}, {rows[-1]['memory_mib']:.0f} MiB", file=sys.stderr)
    return {"scene": scene, "rows": rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", default=["cornell_fog", "fruit_juice", "fog_and_slit"])
    parser.add_argument("--lights", type=lambda text: [int(n) for n in text.split(",")], default=[1 << n for n in range(10, 21, 2)])
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--passes", type=int, default=3)
    parser.add_argument("--reference-passes", type=int, default=48)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--json")
    parser.add_argument("--svg")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        result = {"size": arguments.size, "passes": arguments.passes, "seeds": arguments.seeds, "scenes": [measure(arguments, scene, folder) for scene in arguments.scenes]}
    text = json.dumps(result, indent=1)
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            file.write(text + "\n")
    else:
        print(text)
    if arguments.svg:
        import scaling_figure
        scaling_figure.draw(result, arguments.svg)


if __name__ == "__main__":
    main()
