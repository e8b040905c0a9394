#!/usr/bin/env python3
"""How long kernel variants take to build: cold (the driver's cache is empty) and warm, first launch included.

    bench/cold_start/variants.py build/tyndall [--json variants.json]

A covering set: every feature alone, with all others, and none; every sampler with the general mask; every lane width. scenes/six_vrls at 16 x 16 pixels needs
nothing, so any mask may be asked for and what is counted is the driver's work: the stages build_kernels and media_to_media of the report. Goals: 5 s cold, .2 s warm.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes/six_vrls/scene.xml")
FEATURES = ["ANISOTROPIC", "COLOURED", "OCCLUDERS", "MANY_MEDIA", "BOUNDARIES", "NONCONVEX_MEDIA,OCCLUDERS", "SHORT_LIGHTS", "DEPTH_LIMIT", "ANISOTROPIC,PHASE_LOBES", "HETEROGENEOUS",
            "COLOURED,HETEROGENEOUS,COLOURED_GRIDS"]
SAMPLERS = ["paper-isotropic", "paper", "paper-6", "table", "table-4x4", "table-3x2"]


def variants():
    yield from (("none", "auto", lanes) for lanes in (1, 4, 8, 16))
    yield from ((mask, "auto", 16) for mask in FEATURES)
    yield from (("all", sampler, lanes) for sampler in SAMPLERS for lanes in (1, 16))


def seconds(program, variant, cache, folder):
    mask, sampler, lanes = variant
    output = os.path.join(folder, "image.exr")
    subprocess.run([program, "render", SCENE, "-o", output, "-p", "1", "--lights", "8", "--resolution", "16x16", "--layer", "media_to_media", "--progress", "none", "--no-selftest",
                    "--features", mask, "--sampler", sampler, "--lanes", str(lanes)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "POCL_CACHE_DIR": cache})
    with open(os.path.join(folder, "image.json"), encoding="utf-8") as file:
        stages = {stage["stage"]: stage["seconds"] for stage in json.load(file)["stages"]}
    return stages["build_kernels"] + stages["media_to_media"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--json")
    arguments = parser.parse_args()
    rows = []
    for variant in variants():
        with tempfile.TemporaryDirectory() as cache, tempfile.TemporaryDirectory() as folder:
            cold, warm = (seconds(arguments.program, variant, cache, folder) for _ in range(2))
        rows.append({"features": variant[0], "sampler": variant[1], "lanes": variant[2], "cold_seconds": cold, "warm_seconds": warm})
        print(f"{variant[0]:40} {variant[1]:16} {variant[2]:2} lanes  cold {cold:5.2f} s  warm {warm:5.3f} s", flush=True)
    print(f"slowest: cold {max(r['cold_seconds'] for r in rows):.2f} s, warm {max(r['warm_seconds'] for r in rows):.3f} s")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump({"schema": "tyndall-bench-variants/1", "rows": rows}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    sys.exit(main())
