#!/usr/bin/env python3
"""render.py PROGRAM SCENE REPETITIONS: seconds per stage and peak memory of whole renders (512 x 512, 4096 virtual lights, one pass, two threads).

Prints JSON in the manner of Google Benchmark: one entry per repetition.
"""
import json
import os
import subprocess
import sys
import tempfile


def render(program, scene, folder):
    """One render in a process of its own: its report, and what the system says it used."""
    command = [program, "render", scene, "-o", os.path.join(folder, "image.exr"), "--lights", "4096", "--select", "all", "--passes", "1",
               "--resolution", "512x512", "--threads", "2", "--progress", "none"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(message.decode())
    with open(os.path.join(folder, "image.json"), encoding="utf-8") as file:
        return json.load(file), usage


def main():
    program, scene, repetitions = sys.argv[1], sys.argv[2], int(sys.argv[3])
    runs = []
    with tempfile.TemporaryDirectory() as folder:
        render(program, scene, folder)  # fills the driver's cache of compiled kernels
        for _ in range(repetitions):
            report, usage = render(program, scene, folder)
            run = {"name": "render/" + os.path.basename(os.path.dirname(scene)), "seconds": report["timings"]["seconds"],
                   "processor_seconds": usage.ru_utime + usage.ru_stime, "pairs_per_second": report["timings"]["pairs_per_second"], "peak_memory_bytes": usage.ru_maxrss * 1024}
            for stage in report["stages"]:
                run[stage["stage"] + "_seconds"] = stage["seconds"]
            runs.append(run)
    json.dump({"benchmarks": runs}, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
