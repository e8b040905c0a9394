#!/usr/bin/env python3
"""How much an animation flickers: the change from frame to frame that is noise, not motion.

    python3 bench/flicker.py FRAMES [--against FRAMES] [--layer LAYER] [--json]

FRAMES is a folder of `tyndall animate`, of frames that are rendered with seeds of their own. A pixel's curve over time is smooth where nothing but a light moves, so its second difference
d = x(f-1) - 2 x(f) + x(f+1), which straight changes leave at 0, is noise: the variance of a frame is E d^2 / 6. Flicker is the root of the mean of that over pixels and channels, relative to the pixel's mean over
time as Tyndall's error is: every square over m^2 + (.05 mean of all)^2. What bends remains in it, so compare animations of the same frames. With --against, the ratio of two.

    --layer media_to_media   of one layer, or several with commas (the image)
    --range FIRST:END        of these frames alone

Standard output: a line, or with --json an object with frames, flicker and the frames' names.
"""
import argparse
import json
import os
import sys

import exr_frames


def frames_of(folder, wanted):
    first, end = (int(x) for x in wanted.split(":")) if wanted else (0, 10**9)
    files = sorted(f for f in os.listdir(folder) if f.startswith("frame_") and f.endswith(".exr") and first <= int(f[6:-4]) < end)
    if len(files) < 3:
        sys.exit(f"{folder} has {len(files)} frames; flicker needs three that follow each other")
    return [os.path.join(folder, f) for f in files]


def image_of(file, layers):
    """All values of the frame, channels behind each other: the image, or the sum of some of its layers."""
    prefixes = [layer + "." for layer in layers] if layers else [""]
    _, _, planes = exr_frames.read(file, {p + c for p in prefixes for c in "RGB"})
    if len(planes) != 3 * len(prefixes):
        sys.exit(f"{file} has no layer {', '.join(layers)}")
    total = []
    for channel in "RGB":
        total += [sum(values) for values in zip(*(planes[p + channel] for p in prefixes))]
    return total


def flicker_of(files, layers):
    images = [image_of(file, layers) for file in files]
    means = [sum(values) / len(images) for values in zip(*images)]
    floor = (0.05 * sum(means) / len(means)) ** 2
    total = 0.0
    for before, now, after in zip(images, images[1:], images[2:]):
        total += sum((a - 2 * b + c) ** 2 / (6 * (m * m + floor)) for a, b, c, m in zip(before, now, after, means))
    return (total / ((len(images) - 2) * len(means))) ** 0.5


def main():
    parser = argparse.ArgumentParser(description="Flicker of an animation.")
    parser.add_argument("frames")
    parser.add_argument("--against")
    parser.add_argument("--layer", default="")
    parser.add_argument("--range", default="")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    layers = [layer for layer in options.layer.split(",") if layer]
    result = {}
    for key, folder in (("frames", options.frames), ("against", options.against)):
        if folder:
            files = frames_of(folder, options.range)
            result[key] = {"folder": folder, "frames": len(files), "flicker": flicker_of(files, layers)}
    if options.against:
        result["ratio"] = result["frames"]["flicker"] / result["against"]["flicker"]
    if options.json:
        print(json.dumps(result, indent=1))
    else:
        print("flicker %.4g" % result["frames"]["flicker"] + (", against %.4g: ratio %.3g" % (result["against"]["flicker"], result["ratio"]) if options.against else ""))


if __name__ == "__main__":
    main()
