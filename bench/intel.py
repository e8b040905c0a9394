#!/usr/bin/env python3
"""intel.py RAW OUT PASSED: what bench/intel.sh measured, as OUT/intel.json and OUT/intel.md. PASSED: true if Intel's runtime passed the selftest.

A rate is the median over the turns of the medians of `tyndall bench`, its range that of those medians; a ratio is PoCL's rate at its best lane width over Intel's at its own, turn by turn.
"""
import glob
import json
import os
import statistics
import sys


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def turns_of(raw, device):
    return [read(path) for path in sorted(glob.glob(os.path.join(raw, device + ".*.json"))) if path.rsplit(".", 2)[1].isdigit()]


def rates_of(turns):
    """{kernel: {lanes or "scalar": [median of each turn]}}"""
    rates = {}
    for turn in turns:
        for kernel in turn["kernels"]:
            of_one = rates.setdefault(kernel["kernel"], {})
            for entry in kernel["lanes"]:
                of_one.setdefault(entry["lanes"], []).append(entry["pairs_per_second"]["median"])
            if kernel["scalar_pairs_per_second"]:
                of_one.setdefault("scalar", []).append(kernel["scalar_pairs_per_second"]["median"])
    return rates


def summary(values):
    return {"median": statistics.median(values), "low": min(values), "high": max(values), "turns": len(values)}


def best(rates):
    """The lane width with the highest median; the scalar kernel is none."""
    return max((lanes for lanes in rates if lanes != "scalar"), key=lambda lanes: statistics.median(rates[lanes]))


def million(s):
    return f"{s['median'] / 1e6:.3g} M ({s['low'] / 1e6:.3g} – {s['high'] / 1e6:.3g})"


def row_of(kernel, pocl, intel):
    ours, theirs = best(pocl), best(intel)
    row = {"kernel": kernel, "pocl_lanes": ours, "intel_lanes": theirs, "pocl": summary(pocl[ours]), "intel": summary(intel[theirs]),
           "ratio": summary([a / b for a, b in zip(pocl[ours], intel[theirs])])}
    if "scalar" in pocl:
        row.update(pocl_scalar=summary(pocl["scalar"]), intel_scalar=summary(intel["scalar"]))
    return row


def markdown(result):
    lines = [f"# {result['intel_device']} beside {result['pocl_device']}", "",
             "Written by `bench/intel.sh`. Pairs per second of one core by processor time, each at its best lane width, taken in turns; median (lowest – highest) of the turns.", "",
             "| kernel | PoCL, lanes | Intel, lanes | PoCL over Intel | scalar kernel: PoCL, Intel |", "|---|---|---|---|---|"]
    for row in result["kernels"]:
        r = row["ratio"]
        scalar = f"{row['pocl_scalar']['median'] / 1e6:.3g} M, {row['intel_scalar']['median'] / 1e6:.3g} M" if "pocl_scalar" in row else ""
        lines.append(f"| `{row['kernel']}` | {million(row['pocl'])}, {row['pocl_lanes']} | {million(row['intel'])}, {row['intel_lanes']} | {r['median']:.2f} ({r['low']:.2f} – {r['high']:.2f}) | {scalar} |")
    difference = f"root of the relative mean square difference {result['image_difference']:.1e}" if result["image_difference"] else "every pixel is the same in every bit"
    lines += ["", f"Selftest on Intel's runtime at all lane widths: {'passed' if result['selftest_passed'] else 'FAILED'}. `cornell_fog`, 64 × 64 pixels, 8 passes with the same seed on both: "
              f"{difference}.", ""]
    return "\n".join(lines)


def main():
    raw, out, passed = sys.argv[1:4]
    pocl, intel = turns_of(raw, "portable"), turns_of(raw, "intel")
    ours, theirs = rates_of(pocl), rates_of(intel)
    name = lambda turn: f"{turn['device']['platform']} {turn['device']['driver']}"
    images = read(os.path.join(raw, "images.json"))
    result = {"schema": "tyndall-intel/1", "pocl_device": name(pocl[0]), "intel_device": name(intel[0]), "kernels": [row_of(k, ours[k], theirs[k]) for k in ours],
              "selftest_passed": passed == "true", "image_difference": images["error"]}
    with open(os.path.join(out, "intel.json"), "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
        file.write("\n")
    with open(os.path.join(out, "intel.md"), "w", encoding="utf-8") as file:
        file.write(markdown(result))


if __name__ == "__main__":
    main()
