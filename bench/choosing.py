#!/usr/bin/env python3
"""Which method for which fog: virtual ray lights, point lights and path tracing beside each other, from thin to dense, from isotropic to forward, with something in the way and without.

    bench/choosing.py build/tyndall [--seconds 3] [--size 48] [--json choosing.json] [--svg choosing.svg]

For each fog, method and layer set: processor seconds of a pass on one core (a render less one of a single pass), the error that the spread of the passes gives for single
pixels, and for means over 8 x 8 pixels the difference of two renders with other seeds. The inefficiency is error^2 x seconds; what is told is that of path tracing over that of
the method: how many times less processor time it needs for the same error. Only unbiased methods are in it: of a biased one the spread tells no error.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

from choosing_figure import draw
from scaling import ROOT, seconds_of

METHODS = ["path", "vrl", "vpl"]
MEAN_FREE_PATHS = [.3, 1, 3, 10, 30]  # across the fog
ASYMMETRIES = [0, .6, .9]

# A cube of fog with a lamp beside it: every connection is free.
CUBE = """<scene version="3.0.0">
  <default name="sigma_t" value="1"/>
  <default name="g" value="0"/>
  <integrator type="volpath"/>
  <medium type="homogeneous" id="fog"><float name="sigma_t" value="$sigma_t"/><float name="albedo" value="0.9"/><phase type="hg"><float name="g" value="$g"/></phase></medium>
  <shape type="cube"><bsdf type="null"/><ref name="interior" id="fog"/></shape>
  <emitter type="point"><point name="position" x="0.4" y="1.6" z="0.5"/><rgb name="intensity" value="10, 9, 8"/></emitter>
  <sensor type="perspective"><float name="fov" value="40"/><transform name="to_world"><lookat origin="0.6, 0.9, 4.2" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="64"/><integer name="height" value="64"/><rfilter type="box"/></film></sensor>
</scene>
"""


class Bench:
    def __init__(self, arguments, folder):
        self.program, self.size, self.seconds, self.folder = arguments.program, arguments.size, arguments.seconds, folder

    def render(self, name, scene, method, layers, passes, seed):
        image = os.path.join(self.folder, name + ".exr")
        command = [self.program, "render", scene["file"], "-o", image, "--resolution", f"{self.size}x{self.size}", "--method", method, "--passes", str(passes), "--seed", str(seed),
                   "--threads", "1", "--progress", "none", *(["--layer", ",".join(layers)] if layers else []), *scene["options"]]
        return seconds_of(command)[0], image

    def relative_mse_of_blocks(self, a, b):
        """Of one of the two: half of what lies between them."""
        result = subprocess.run([self.program, "compare", a, b, "--json"], check=True, capture_output=True, text=True)
        return .5 * json.loads(result.stdout)["blocks_relative_mse"]

    def measure(self, scene, method, layers):
        one, _ = self.render("one", scene, method, layers, 1, 1)
        few, spent = 8, 0
        while spent < .25 * self.seconds:  # until the passes stand out from start and noise
            few *= 4
            spent = self.render("one", scene, method, layers, few, 1)[0] - one
        passes = max(8, round(few * self.seconds / spent))
        runs = [self.render(f"run{seed}", scene, method, layers, passes, seed) for seed in (2, 3)]
        errors = []
        for _, image in runs:
            with open(image[:-4] + ".json", encoding="utf-8") as report:
                errors.append(json.load(report)["error"] ** 2)
        seconds = statistics.mean(total - one for total, _ in runs)
        return {"pixels": statistics.mean(errors) * seconds, "blocks": self.relative_mse_of_blocks(runs[0][1], runs[1][1]) * seconds, "passes": passes, "seconds": seconds}


def scenes(folder):
    """Two kinds of place, each with every fog. The room is 2 high, the cube 2 wide."""
    cube = os.path.join(folder, "cube.xml")
    with open(cube, "w", encoding="utf-8") as file:
        file.write(CUBE)
    for place, file in (("free", cube), ("shadowed", os.path.join(ROOT, "scenes", "forward_fog", "scene.xml"))):
        for g in ASYMMETRIES:
            for across in MEAN_FREE_PATHS:
                yield {"place": place, "g": g, "mean_free_paths": across, "file": file, "options": ["-D", f"sigma_t={across / 2}", "-D", f"g={g}"]}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=3)
    parser.add_argument("--size", type=int, default=48)
    parser.add_argument("--json")
    parser.add_argument("--svg")
    arguments = parser.parse_args()
    os.environ["POCL_MAX_PTHREAD_COUNT"] = "1"
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        for scene in scenes(folder):
            for what, layers in (("media_to_media", ["media_to_media"]), ("image", [])):
                measured = {method: bench.measure(scene, method, layers) for method in METHODS}
                row = {key: scene[key] for key in ("place", "g", "mean_free_paths")} | {"what": what}
                for kind in ("pixels", "blocks"):
                    row[kind] = {method: measured["path"][kind] / measured[method][kind] for method in METHODS[1:]}
                rows.append(row)
                print(f"{row['place']:9} g {row['g']:<3} {row['mean_free_paths']:>4} mean free paths  {what:15}" +
                      "".join(f"  {m} {row['pixels'][m]:8.3g} pixels {row['blocks'][m]:8.3g} means" for m in METHODS[1:]), file=sys.stderr, flush=True)
    result = {"size": arguments.size, "seconds": arguments.seconds, "rows": rows}
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)
            file.write("\n")
    if arguments.svg:
        draw(result, arguments.svg)


if __name__ == "__main__":
    main()
