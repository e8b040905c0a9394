#!/usr/bin/env python3
"""The talk's comparisons at equal time: see talk.sh. Writes images, talk.json, talk.md and talk.svg into OUT.

Errors are roots of relMSE against a reference by virtual ray lights with a seed of its own, rendered for twice the longest time (eight times in the smoky room); its own share, from the spread of its passes, is
taken off, and where that is more than half of what was measured only a bound is told (<).
"""
import argparse
import base64
import json
import os
import shlex
import subprocess
import sys

from talk_figure import draw, markdown

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
EXPERIMENTS = {
    "juice": {"title": "Fruit juice, media to media", "scene": "fruit_juice", "layer": "media_to_media", "methods": ["vrl", "beams", "vpl"], "times": [6, 60, 1200], "talk": {"vrl": "4 K", "beams": "1 K", "vpl": "4 K"}},
    "room": {"title": "Smoky room, media to media", "scene": "smoky_room", "layer": "media_to_media", "methods": ["vrl", "beams", "vpl"], "times": [5, 100], "reference": 8, "talk": {"vrl": "6 K", "beams": "142 K", "vpl": "8 K"}},
    "surfaces": {"title": "Smoky room, media to surface", "scene": "smoky_room", "layer": "media_to_surface", "methods": ["vrl", "vpl"], "times": [600], "talk": {}},
}
FRAME_SECONDS, FRAMES = 20, 24


class Talk:
    def __init__(self, arguments):
        self.program, self.folder, self.shrink, self.size = arguments.program, arguments.out, 10 if arguments.quick else 1, arguments.resolution
        os.makedirs(self.folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run(self, *command):
        print(" ".join(map(shlex.quote, command)), file=sys.stderr, flush=True)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    def render(self, name, scene, layer, method, seconds, seed, *options):
        """Renders unless the same command has finished here before; returns its report."""
        image, done = self.path(name + ".exr"), self.path(name + ".command")
        command = [self.program, "render", os.path.join(ROOT, "scenes", scene, "scene.xml"), "-o", image, "--method", method, "--layer", layer, "--time", f"{seconds:g}", "--seed", str(seed), "--resume",
                   "--progress", "none", *(["--resolution", self.size] if self.size else []), *options]
        text = " ".join(map(shlex.quote, command[1:]))
        if not (os.path.exists(done) and open(done, encoding="utf-8").read() == text and os.path.exists(image)):
            self.run(*command)
            with open(done, "w", encoding="utf-8") as file:
                file.write(text)
        with open(self.path(name + ".json"), encoding="utf-8") as report:
            return json.load(report)

    def error(self, image, reference, floor):
        result = json.loads(subprocess.run([self.program, "compare", self.path(image + ".exr"), self.path(reference + ".exr"), "--json"], check=True, capture_output=True, text=True).stdout)
        measured = result["relative_mse"]
        return {"error": max(measured - floor, 0) ** .5 if measured > 2 * floor else measured ** .5, "at_most": measured <= 2 * floor, "trimmed": result["trimmed_relative_mse"] ** .5,
                "blocks": result["blocks_relative_mse"] ** .5}

    def experiment(self, key):
        e = EXPERIMENTS[key]
        times = [t / self.shrink for t in e["times"]]
        reference = f"{key}_reference"
        reference_seconds = e.get("reference", 2) * times[-1]
        report = self.render(reference, e["scene"], e["layer"], "vrl", reference_seconds, 999983)
        exposure = ["--exposure", f"{report['exposure']:g}"]
        floor = report["error"] ** 2
        rows = []
        for seconds in times:
            for method in e["methods"]:
                name = f"{key}_{method}_{seconds:g}s"
                own = self.render(name, e["scene"], e["layer"], method, seconds, 1, *exposure)
                rows.append({"method": method, "seconds": seconds, "took": own["timings"]["seconds"], "passes": own["passes"], "lights": own["counts"]["virtual_lights"], "talk_lights": e["talk"].get(method), "image": self.picture(name), **self.error(name, reference, floor)})
        return {"key": key, "title": e["title"], "reference_error": floor ** .5, "reference_seconds": reference_seconds, "rows": rows, "reference_image": self.picture(reference)}

    def picture(self, name):
        with open(self.path(name + ".png"), "rb") as file:
            return "data:image/png;base64," + base64.b64encode(file.read()).decode()

    def animation(self):
        """Flicker of VRLs at t a frame against beams at t and VPLs at t and 3 t."""
        t, rows = FRAME_SECONDS / self.shrink, []
        for method, seconds in (("vrl", t), ("beams", t), ("vpl", t), ("vpl", 3 * t)):
            folder = self.path(f"animation_{method}_{seconds:g}s")
            self.run(self.program, "animate", os.path.join(ROOT, "scenes", "turning_light"), "--frames", f"0:{FRAMES}", "--seed-per-frame", "varying", "-o", folder, "--method", method, "--layer", "media_to_media",
                     "--time", f"{seconds:g}", *(["--resolution", self.size] if self.size else []))
            flicker = subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench", "flicker.py"), folder, "--layer", "media_to_media", "--json"], check=True, capture_output=True, text=True).stdout
            rows.append({"method": method, "seconds": seconds, "frames": FRAMES, "flicker": json.loads(flicker)["frames"]["flicker"]})
            self.run(sys.executable, "-B", os.path.join(ROOT, "bench", "contact_sheet.py"), folder, "--exposure", "4", "--shrink", "2", "-o", self.path(f"animation_{method}_{seconds:g}s.png"))
        return rows


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--quick", action="store_true", help="a tenth of all times")
    parser.add_argument("--only", default="juice,room,surfaces,animation")
    parser.add_argument("--resolution", help="WxH for all images, for trials")
    parser.add_argument("out", nargs="?", default=os.path.join("out", "talk"))
    arguments = parser.parse_intermixed_args()
    talk, wanted = Talk(arguments), arguments.only.split(",")
    result = {"quick": arguments.quick, "experiments": [talk.experiment(key) for key in EXPERIMENTS if key in wanted]}
    if "animation" in wanted:
        result["animation"] = talk.animation()
    draw(result, talk.path("talk.svg"))
    for e in result["experiments"]:  # pictures are in the figure
        e.pop("reference_image")
        for row in e["rows"]:
            row.pop("image")
    with open(talk.path("talk.json"), "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
        file.write("\n")
    with open(talk.path("talk.md"), "w", encoding="utf-8") as file:
        file.write(markdown(result))


if __name__ == "__main__":
    main()
