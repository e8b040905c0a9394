#!/usr/bin/env python3
"""Prediction beside measurement: what `tyndall explain` says of a render's time, what the render itself says after two passes, and what it took.

    bench/effects/prediction.py build/tyndall [--passes 12] [--json prediction.json]

Every shipped scene with both methods. Exit code 1 if a prediction is off by more than a factor of two, which on a machine with nothing else to do is a fault.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes")


def compare(program, scene, method, passes):
    options = ["--method", method, "--passes", str(passes)]
    explained = subprocess.run([program, "explain", scene, "--json", *options], check=True, capture_output=True, text=True)
    calibration = json.loads(explained.stdout)["calibration"]
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "image.exr")
        subprocess.run([program, "render", scene, "-o", output, "--progress", "none", *options], check=True, capture_output=True)
        with open(os.path.join(folder, "image.json")) as file:
            report = json.load(file)
    return {"explained": calibration["before_seconds"] + calibration["first_pass_seconds"] + (passes - 1) * calibration["pass_seconds"],
            "after_two_passes": report["prediction"]["seconds"], "measured": report["timings"]["seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--passes", type=int, default=12)
    parser.add_argument("--json")
    arguments = parser.parse_args()
    rows, within = [], True
    for name in sorted(os.listdir(SCENES)):
        scene = os.path.join(SCENES, name, "scene.xml")
        for method in ("vrl", "path") if os.path.exists(scene) else ():
            row = {"scene": name, "method": method, **compare(arguments.program, scene, method, arguments.passes)}
            ratios = [row[key] / row["measured"] for key in ("explained", "after_two_passes")]
            within = within and all(.5 <= ratio <= 2 for ratio in ratios)
            rows.append(row)
            print(f"{name:16} {method:5} explained {row['explained']:7.2f} s ({ratios[0]:.2f})  after two passes {row['after_two_passes']:7.2f} s ({ratios[1]:.2f})  "
                  f"measured {row['measured']:7.2f} s", flush=True)
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump({"schema": "tyndall-bench-prediction/1", "rows": rows}, file, indent=2)
    return 0 if within else 1


if __name__ == "__main__":
    sys.exit(main())
