#!/usr/bin/env python3
"""How long until the first pixel: scenes rendered for one pass with an empty kernel cache of the driver, and again with a full one.

    bench/cold_start/cold_start.py build/tyndall [--json cold_start.json] [SCENE ...]

"Start to pixel" is wall clock from the start of the process to the end of the first pass. Processor seconds are what the same process took on all cores,
which other work on the machine disturbs less. The caches are PoCL's (POCL_CACHE_DIR in an empty folder) and Tyndall's own (XDG_CACHE_HOME): cold includes the
selftest before a device's first render. Other drivers keep their kernels elsewhere and look warm here from the second run on. Goals on two cores: cornell_fog's
programs within 2.5 s cold, its first pixel within 3 s cold and 1 s warm.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes")


def first_pixel(program, scene, cache, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    output = os.path.join(folder, "image.exr")
    process = subprocess.Popen([program, "render", scene, "-o", output, "-p", "1", "--progress", "json"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                               env={**os.environ, "POCL_CACHE_DIR": cache, "XDG_CACHE_HOME": cache})
    process.stdout.readline()
    pixel = time.monotonic() - start
    process.stdout.read()
    if process.wait() != 0:
        raise RuntimeError(f"{scene}: exit code {process.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "image.json")) as file:
        report = json.load(file)
    stages = {stage["stage"]: stage["seconds"] for stage in report["stages"]}
    return {"start_to_pixel": pixel, "programs": report["counts"]["programs"], "build_kernels": stages.get("build_kernels", 0.0),
            "processor_seconds": after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--json")
    arguments = parser.parse_args()
    scenes = arguments.scenes or sorted(os.path.join(SCENES, name, "scene.xml") for name in os.listdir(SCENES) if os.path.isdir(os.path.join(SCENES, name)))
    rows = []
    for scene in scenes:
        with tempfile.TemporaryDirectory() as cache, tempfile.TemporaryDirectory() as folder:
            for state in ("cold", "warm"):
                row = {"scene": os.path.relpath(scene), "cache": state, **first_pixel(arguments.program, scene, cache, folder)}
                rows.append(row)
                print(f"{row['scene']:50} {state}  first pixel {row['start_to_pixel']:6.2f} s   {row['programs']} programs {row['build_kernels']:5.2f} s   "
                      f"processor {row['processor_seconds']:5.2f} s", flush=True)
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump({"schema": "tyndall-bench-cold-start/1", "rows": rows}, file, indent=2)


if __name__ == "__main__":
    sys.exit(main())
