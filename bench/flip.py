"""Does another measure of difference agree? FLIP, which models what a person sees, beside relMSE, for more and more passes of one scene.

    python3 bench/flip.py TYNDALL SCENE [--resolution WxH]

Needs NumPy, OpenEXR's bindings and flip-evaluator in the Python environment (pip install numpy openexr flip-evaluator); nothing else of Tyndall does. Renders virtual ray
lights with 1, 4, 16 and 64 passes and a reference by path tracing, and prints both measures. Exit code 1 if one falls where the other rises."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import flip_evaluator
import numpy as np
import OpenEXR

PASSES = (1, 4, 16, 64)


def pixels(file):
    channels = OpenEXR.File(str(file), separate_channels=True).channels()
    return np.ascontiguousarray(np.maximum(np.stack([channels[c].pixels for c in "RGB"], -1), 0), np.float32)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tyndall"), parser.add_argument("scene"), parser.add_argument("--resolution", default="128x128"), parser.add_argument("--reference-passes", default="1024")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def render(file, *more):
            command = [options.tyndall, "render", options.scene, "--resolution", options.resolution, "--progress", "none", "-o", str(folder / file), *more]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

        render("reference.exr", "--method", "path", "--passes", options.reference_passes, "--seed", "1000")
        reference, rows = pixels(folder / "reference.exr"), []
        for passes in PASSES:
            render("image.exr", "--passes", str(passes))
            compared = subprocess.run([options.tyndall, "compare", str(folder / "image.exr"), str(folder / "reference.exr"), "--json"], check=True, capture_output=True, text=True)
            _, flip, _ = flip_evaluator.evaluate(reference, pixels(folder / "image.exr"), "HDR", applyMagma=False)
            rows.append((passes, json.loads(compared.stdout)["error"], flip))
    print(f"{'passes':>6}  {'error':>8}  {'FLIP':>7}")
    for passes, error, flip in rows:
        print(f"{passes:6d}  {100 * error:6.2f} %  {flip:7.4f}")
    agree = all((a[1] > b[1]) == (a[2] > b[2]) for a, b in zip(rows, rows[1:]))
    print("both measures order the images alike" if agree else "the measures disagree on the order of the images")
    sys.exit(not agree)


if __name__ == "__main__":
    main()
