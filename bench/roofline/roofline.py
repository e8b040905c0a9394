#!/usr/bin/env python3
"""roofline.py COUNTS BENCH PEAKS OUT: instructions and bytes per pair of each kernel, and what bounds it, as OUT/roofline.json, .md and .svg.

COUNTS: roofline_count's, how often each instruction was executed for two numbers of lights; what the second has more is what the additional pairs cost. BENCH: `tyndall bench --json`.
PEAKS: roofline_peaks'. Reads the kernels' code with objdump. One vector of 16 pairs is the unit: lanes of 16 on registers of 64 bytes.
"""
import collections
import json
import math
import os
import re
import subprocess
import sys

WIDTHS = {"ZMMWORD": 64, "YMMWORD": 32, "XMMWORD": 16, "QWORD": 8, "DWORD": 4, "WORD": 2, "BYTE": 1}
LANES = 16
NAMES = {"fused": "fused", "plain": "+ − ×", "divided": "÷", "rooted": "√", "other": "other numbers", "chosen": "comparisons, choices", "integer": "integers", "moved": "moves",
         "scalar": "scalar"}


def code_of(path):
    """{address: (mnemonic, operands)} of a file."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", "-M", "intel", path], check=True, capture_output=True, text=True).stdout
    lines = (re.match(r"\s*([0-9a-f]+):\s+(\S+)\s*(.*)", line) for line in text.splitlines())
    return {int(m[1], 16): (m[2], m[3].split("#")[0].strip()) for m in lines if m}


def kind_of(name, operands):
    if not re.search(r"[xyz]mm|\bk[0-7]\b", operands):
        return "scalar"
    if name.startswith(("vfmadd", "vfmsub", "vfnmadd", "vfnmsub")):
        return "fused"
    if name.startswith(("vadd", "vsub", "vmul")):
        return "plain"
    if name.startswith("vdiv"):
        return "divided"
    if name.startswith("vsqrt"):
        return "rooted"
    if name.startswith(("vcmp", "vpcmp", "vptest", "vblend", "vpblend", "vptern", "k")):
        return "chosen"
    if name.startswith(("vmov", "vbroadcast", "vpbroadcast", "vinsert", "vextract", "vshuf", "vperm", "vunpck", "vpgather", "vgather")):
        return "moved"
    return "integer" if name.startswith("vp") else "other"


def bytes_of(name, operands):
    """(loaded, stored) by one execution."""
    if name in ("lea", "nop", "nopw", "nopl") or "[" not in operands or "PTR" not in operands and "BCST" not in operands:
        return 0, 0
    size = WIDTHS[re.search(r"(\w+) (?:PTR|BCST)", operands)[1]]
    if "gather" in name:
        return LANES * size, 0
    stores = operands.split(",")[0].find("[") >= 0 and not name.startswith(("vcmp", "cmp", "test", "vuc", "vcom", "jmp", "call", "push"))
    return (0, size) if stores else (size, 0)


def lanes_of(operands, name):
    if name.endswith(("ss", "sd")):
        return 1
    return 16 if "zmm" in operands or "ZMMWORD" in operands else 8 if "ymm" in operands else 4


def per_vector(few, many):
    """Executed per 16 pairs: by kind, flops, bytes loaded and stored."""
    vectors = (many["lights"] - few["lights"]) * many["eyes"] / LANES
    code, total = code_of(many["file"]), collections.Counter()
    for address, count in many["counts"].items():
        times = (count - few["counts"].get(address, 0)) / vectors
        name, operands = code.get(int(address), ("memcpy", ""))  # of the C library; its bytes are not counted
        kind = kind_of(name, operands)
        loaded, stored = bytes_of(name, operands)
        total["instructions"] += times
        total[kind] += times
        total["flops"] += times * lanes_of(operands, name) * {"fused": 2, "plain": 1, "divided": 1, "rooted": 1}.get(kind, 0)
        total["loaded"] += times * loaded
        total["stored"] += times * stored
        total["loads"] += times * (loaded > 0) * (LANES if "gather" in name else 1)
        total["stores"] += times * (stored > 0)
    return total


def bounds_of(total, peaks):
    """Cycles per 16 pairs that each part of the core needs at least. Vectors of 64 bytes go to two ports, loads to two, stores to one; the rest was measured."""
    hertz = peaks["cycles_per_second"]
    vectors = sum(total[kind] for kind in ("fused", "plain", "divided", "rooted", "other", "chosen", "integer"))
    return {"issue": total["instructions"] * hertz / peaks["instructions_per_second"],
            "vector ports": vectors * 2 * hertz / peaks["fused_per_second"] / 2,
            "divider": total["divided"] * hertz / peaks["divided_per_second"] + total["rooted"] * hertz / peaks["rooted_per_second"],
            "loads and stores": max(total["loads"] / 2, total["stores"])}


def row_of(few, many, seconds, peaks):
    total = per_vector(few, many)
    cycles = seconds * LANES * peaks["cycles_per_second"]
    bounds = bounds_of(total, peaks)
    return {"kernel": many["kernel"], "nanoseconds_per_pair": seconds * 1e9, "cycles": cycles, "flops": total["flops"], "loaded_bytes": total["loaded"], "stored_bytes": total["stored"],
            "instructions": {"all": total["instructions"], **{kind: total[kind] for kind in NAMES}}, "bounds_cycles": bounds,
            "flops_per_second": total["flops"] / LANES / seconds, "flops_per_byte": total["flops"] / (total["loaded"] + total["stored"])}


def markdown(data):
    p = data["peaks"]
    lines = ["# Roofline: what was counted", "", "Written by `bench/run.sh`; what it means: [roofline](../../../host/docs/roofline.md). One core, lanes of 16; everything per 16 pairs unless said.", "",
             "| one core can do | |", "|---|---|", f"| cycles per second | {p['cycles_per_second'] / 1e9:.2f} G |",
             f"| instructions per cycle | {p['instructions_per_second'] / p['cycles_per_second']:.1f} |"]
    for name, text in (("fused", "fused multiplications and additions"), ("divided", "divisions"), ("rooted", "square roots")):
        rate = p[name + "_per_second"]
        lines.append(f"| {text} of 16 numbers | {rate / 1e9:.2f} G/s, one in {p['cycles_per_second'] / rate:.1f} cycles |")
    for name, text in (("l1", "16 KiB"), ("l2", "1 MiB"), ("memory", "256 MiB")):
        lines.append(f"| loads out of {text} | {p[name + '_bytes_per_second'] / 1e9:.0f} GB/s |")
    lines += ["", "| kernel | ns per pair | cycles | instructions | " + " | ".join(NAMES.values()) + " | bytes loaded, stored per pair | flops per pair | Gflop/s, of peak |", "|---" * (len(NAMES) + 7) + "|"]
    peak = 32 * p["fused_per_second"]
    for row in data["kernels"]:
        n = row["instructions"]
        lines.append(f"| `{row['kernel']}` | {row['nanoseconds_per_pair']:.2f} | {row['cycles']:.0f} | {n['all']:.0f} | " + " | ".join(f"{n[kind]:.0f}" for kind in NAMES)
                     + f" | {row['loaded_bytes'] / LANES:.0f}, {row['stored_bytes'] / LANES:.0f} | {row['flops'] / LANES:.0f} | {row['flops_per_second'] / 1e9:.1f}, {100 * row['flops_per_second'] / peak:.0f} % |")
    parts = list(data["kernels"][0]["bounds_cycles"])
    lines += ["", "| kernel | cycles | " + " | ".join(f"at least, for {part}" for part in parts) + " | largest bound, share of the time |", "|---" * (len(parts) + 3) + "|"]
    for row in data["kernels"]:
        b = row["bounds_cycles"]
        most = max(b, key=b.get)
        lines.append(f"| `{row['kernel']}` | {row['cycles']:.0f} | " + " | ".join(f"{b[part]:.0f}" for part in parts) + f" | {most}, {100 * b[most] / row['cycles']:.0f} % |")
    return "\n".join(lines) + "\n"


def figure(data):
    """Flops per second over flops per byte of the first-level cache, both logarithmic, with the roofs."""
    p, width, height, left, top = data["peaks"], 640, 330, 70, 30
    xs, ys = (-1, 2), (9, 12)
    x = lambda v: left + width * (math.log10(v) - xs[0]) / (xs[1] - xs[0])
    y = lambda v: top + height * (1 - (math.log10(v) - ys[0]) / (ys[1] - ys[0]))
    peak, parts = 32 * p["fused_per_second"], []
    for value in (.1, 1, 10, 100):
        parts.append(f'<path d="M{x(value):.0f} {top}V{top + height}" stroke="#ddd"/><text x="{x(value):.0f}" y="{top + height + 16}" text-anchor="middle">{value:g}</text>')
    for value in (1e9, 1e10, 1e11, 1e12):
        parts.append(f'<path d="M{left} {y(value):.0f}H{left + width}" stroke="#ddd"/><text x="{left - 6}" y="{y(value) + 4:.0f}" text-anchor="end">{value / 1e9:g}</text>')
    for name, rate in (("first-level cache", p["l1_bytes_per_second"]), ("second-level cache", p["l2_bytes_per_second"]), ("memory", p["memory_bytes_per_second"])):
        knee, start = peak / rate, max(.1, 1e9 / rate)
        parts.append(f'<path d="M{x(start):.1f} {y(start * rate):.1f}L{x(min(knee, 100)):.1f} {y(min(knee, 100) * rate):.1f}" stroke="#7a869a" stroke-width="1.5" fill="none"/>')
        at, down = {"first-level cache": (.16, -40), "second-level cache": (.16, 16), "memory": (.4, -30)}[name]
        parts.append(f'<text x="{x(at):.0f}" y="{y(at * rate) + down:.0f}" fill="#55606f">{name}</text>')
    parts.append(f'<path d="M{x(peak / p["l1_bytes_per_second"]):.1f} {y(peak):.1f}H{left + width}" stroke="#7a869a" stroke-width="1.5"/>'
                 f'<text x="{left + width}" y="{y(peak) - 6:.0f}" text-anchor="end" fill="#55606f">fused multiplication and addition</text>')
    for i, row in enumerate(sorted(data["kernels"], key=lambda r: -r["flops_per_second"])):
        px, py, label = x(row["flops_per_byte"]), y(row["flops_per_second"]), top + 150 + 18 * i
        parts.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="4" fill="#d9822b"/><path d="M{px:.1f} {py:.1f}L{left + 430} {label - 4}" stroke="#d9822b" stroke-width=".5"/>'
                     f'<text x="{left + 434}" y="{label}">{row["kernel"]}</text>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + width + 30}" height="{top + height + 40}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>'
            '<text x="8" y="18" font-weight="bold">Gflop/s of one core, over flops per byte loaded or stored</text>' + "".join(parts) + "</svg>\n")


def main():
    read = lambda path: json.load(open(path, encoding="utf-8"))
    counts, bench, peaks, out = read(sys.argv[1]), read(sys.argv[2]), read(sys.argv[3]), sys.argv[4]
    seconds = {kernel["kernel"]: 1 / entry["pairs_per_second"]["median"] for kernel in bench["kernels"] for entry in kernel["lanes"] if entry["lanes"] == LANES}
    seconds["estimate"] = peaks["seconds_per_estimate"]
    data = {"peaks": peaks, "kernels": [row_of(few, many, seconds[many["kernel"]], peaks) for few, many in zip(counts[::2], counts[1::2])]}
    os.makedirs(out, exist_ok=True)
    for suffix, content in (("json", json.dumps(data, indent=1) + "\n"), ("md", markdown(data)), ("svg", figure(data))):
        with open(os.path.join(out, "roofline." + suffix), "w", encoding="utf-8") as file:
            file.write(content)


if __name__ == "__main__":
    main()
