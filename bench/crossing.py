#!/usr/bin/env python3
"""The talk's two by two: point lights and ray lights, media to surface and media to media, at equal time where singularities are at their worst (scenes/crossing_rays).

    bench/crossing.py build/tyndall [--seconds 10] [--size 160] [--json crossing.json] [--svg crossing.svg]

Beside each image: the largest pixel and the 99.9th percentile, in means of the reference, and those of the reference itself (ray lights, eight times as long, another seed). A method without
bright spots has the reference's numbers; what is far above them is a spot.
"""
import argparse
import base64
import json
import os
import subprocess
import tempfile

import exr_frames

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
LAYERS, METHODS = ["media_to_surface", "media_to_media"], ["vpl", "vrl"]
NAMES = {"vpl": "virtual point lights", "vrl": "virtual ray lights"}


def luminances(image):
    _, _, planes = exr_frames.read(image, {"R", "G", "B"})
    return [.2126 * r + .7152 * g + .0722 * b for r, g, b in zip(planes["R"], planes["G"], planes["B"])]


def stand_out(values, mean):
    """Largest value and 99.9th percentile, in means."""
    ordered = sorted(values)
    return {"largest": ordered[-1] / mean, "percentile_99_9": ordered[min(len(ordered) - 1, round(.999 * len(ordered)))] / mean}


class Bench:
    def __init__(self, arguments, folder):
        self.program, self.size, self.folder = arguments.program, arguments.size, folder

    def render(self, name, layer, method, seconds, seed, *options):
        image = os.path.join(self.folder, name + ".exr")
        subprocess.run([self.program, "render", os.path.join(ROOT, "scenes", "crossing_rays", "scene.xml"), "-o", image, "--layer", layer, "--method", method, "--time", f"{seconds:g}", "--seed", str(seed),
                        "--resolution", f"{self.size}x{self.size}", "--progress", "none", *options], check=True, stdout=subprocess.DEVNULL)
        with open(image[:-4] + ".json", encoding="utf-8") as report:
            return image, json.load(report)

    def error(self, image, reference):
        result = subprocess.run([self.program, "compare", image, reference, "--json"], check=True, capture_output=True, text=True)
        return json.loads(result.stdout)["error"]

    def row(self, layer, seconds):
        reference, report = self.render(layer, layer, "vrl", 8 * seconds, 999983)
        values = luminances(reference)
        mean = sum(values) / len(values)
        cells = []
        for method in METHODS:
            image, own = self.render(f"{layer}_{method}", layer, method, seconds, 1, "--exposure", f"{report['exposure']:g}")
            with open(image[:-4] + ".png", "rb") as file:
                picture = "data:image/png;base64," + base64.b64encode(file.read()).decode()
            cells.append({"method": method, "passes": own["passes"], "error": self.error(image, reference), **stand_out(luminances(image), mean), "picture": picture})
        return {"layer": layer, "reference": stand_out(values, mean), "reference_error": report["error"], "cells": cells}


def draw(result, path):
    side, gap, parts = 300, 20, []
    parts.append(f'<text x="20" y="24" font-weight="bold" font-size="15">Crossing rays, {result["seconds"]:g} s each</text>')
    for j, row in enumerate(result["rows"]):
        y = 44 + j * (side + 89)
        parts.append(f'<text x="20" y="{y + 12}" font-weight="bold">{row["layer"].replace("_", " ")}</text><text x="{20 + side + gap}" y="{y + 12}" fill="#555">reference: largest {row["reference"]["largest"]:.3g}, '
                     f'99.9 % below {row["reference"]["percentile_99_9"]:.3g} means</text>')
        for i, cell in enumerate(row["cells"]):
            x = 20 + i * (side + gap)
            parts.append(f'<image x="{x}" y="{y + 20}" width="{side}" height="{side}" href="{cell["picture"]}"/><text x="{x}" y="{y + side + 37}" font-weight="bold">{NAMES[cell["method"]]}</text>'
                         f'<text x="{x}" y="{y + side + 52}">largest {cell["largest"]:.3g}, 99.9 % below {cell["percentile_99_9"]:.3g} means</text>'
                         f'<text x="{x}" y="{y + side + 67}">error {100 * cell["error"]:.3g} %</text>')
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {40 + 2 * side + gap} {44 + 2 * (side + 89)}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>' + "".join(parts) + "</svg>\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--size", type=int, default=160)
    parser.add_argument("--json")
    parser.add_argument("--svg")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        result = {"seconds": arguments.seconds, "size": arguments.size, "rows": [bench.row(layer, arguments.seconds) for layer in LAYERS]}
    if arguments.svg:
        draw(result, arguments.svg)
    for row in result["rows"]:
        for cell in row["cells"]:
            del cell["picture"]
            print(f"{row['layer']:17} {NAMES[cell['method']]:21} largest {cell['largest']:8.3g}  99.9 % below {cell['percentile_99_9']:8.3g}  (reference {row['reference']['largest']:.3g}, {row['reference']['percentile_99_9']:.3g})  error {100 * cell['error']:.3g} %")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
