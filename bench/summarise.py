#!/usr/bin/env python3
"""summarise.py RAW OUT: what RAW/*.json (Google Benchmark, all repetitions) say, as OUT/<benchmark>.json; OUT/results.md and OUT/results.svg show all that lie in OUT.

Every figure becomes {"median", "low", "high", "repetitions"}: low and high are the smallest and largest repetition. Nothing in it names the machine, only its kind.
"""
import json
import os
import statistics
import sys

BOOKKEEPING = {"name", "run_name", "run_type", "repetitions", "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit", "family_index",
               "per_family_instance_index", "aggregate_name", "aggregate_unit"}


def short(name):
    return "/".join(part for part in name.split("/") if part != "manual_time" and not part.startswith(("iterations:", "repeats:")))


def read(path):
    """{benchmark: {figure: [value per repetition]}} of one file; a benchmark that failed ends everything."""
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    figures = {}
    for entry in content["benchmarks"]:
        if entry.get("error_occurred"):
            sys.exit(f"{entry['name']}: {entry['error_message']}")
        if entry.get("run_type", "iteration") != "iteration":
            continue
        of_one = figures.setdefault(short(entry["name"]), {})
        for key, value in entry.items():
            if key not in BOOKKEEPING and isinstance(value, (int, float)):
                of_one.setdefault(key, []).append(value)
    return figures, content.get("context", {}).get("device")


def summary(values):
    digits = lambda x: float(f"{x:.4g}")
    return {"median": digits(statistics.median(values)), "low": digits(min(values)), "high": digits(max(values)), "repetitions": len(values)}


def readable(figure, value):
    if figure.endswith("_bytes"):
        return f"{value / 2**20:.0f} MiB"
    if figure.endswith("_per_second"):
        return f"{value / 1e6:.3g} M/s"
    if figure.endswith("_seconds") or figure == "seconds":
        return f"{value:.3g} s"
    return f"{value:.3g}"


def table(results):
    lines = ["| benchmark | figure | median | lowest – highest |", "|---|---|---|---|"]
    for name, figures in results.items():
        for figure, s in figures.items():
            if figure in ("agreeing_sums", "blocked_share") or s["median"] == 0:
                continue
            lines.append(f"| {name} | {figure} | {readable(figure, s['median'])} | {readable(figure, s['low'])} – {readable(figure, s['high'])} |")
    return "\n".join(lines) + "\n"


def bars(title, rows, unit):
    """One panel: horizontal bars with whiskers from lowest to highest. rows: (label, summary, colour)."""
    most = max(s["high"] for _, s, _ in rows)
    height, parts = 30 + 22 * len(rows), [f'<text x="8" y="18" font-weight="bold">{title}</text>']
    for i, (label, s, colour) in enumerate(rows):
        y, scale = 28 + 22 * i, 400 / most
        parts.append(f'<text x="230" y="{y + 13}" text-anchor="end">{label}</text>')
        parts.append(f'<rect x="238" y="{y}" width="{s["median"] * scale:.1f}" height="16" fill="{colour}"/>')
        parts.append(f'<path d="M{238 + s["low"] * scale:.1f} {y + 8}H{238 + s["high"] * scale:.1f}" stroke="#222" stroke-width="1.5"/>')
        parts.append(f'<text x="{246 + s["high"] * scale:.1f}" y="{y + 13}">{s["median"] / unit[0]:.3g} {unit[1]}</text>')
    return height + 12, parts


def figure(results):
    panels, ours, theirs = [], "#d9822b", "#7a869a"
    million = (1e6, "M/s")
    rows = [(name.removeprefix("pairs/henyey_greenstein_grey/"), f["pairs_per_second"], ours) for name, f in results.items() if "henyey_greenstein_grey" in name]
    if rows:
        base = next(f["scalar_pairs_per_second"] for name, f in results.items() if "henyey_greenstein_grey" in name)
        panels.append(bars("Pairs per second, one core, Henyey-Greenstein, no visibility", [("plain scalar kernel", base, theirs)] + rows, million))
    rows = []
    for name, f in results.items():
        where = name.partition("/")[2].replace("/", ", ")
        if name.startswith("packets/"):
            rows += [(f"Embree alone, {where}", f["embree_robust_per_second"], theirs), (f"packets, {where}", f["segments_per_second"], ours)]
        elif name.startswith("pipeline/"):
            rows.append((f"pipeline, {where}", f["pairs_per_second"], ours))
    if rows:
        panels.append(bars("Shadow segments, and pairs with visibility, per second", rows, million))
    for name, f in results.items():
        if name.startswith("render/"):
            rows = [(key.removesuffix("_seconds"), s, ours) for key, s in f.items() if key.endswith("_seconds") and "." not in key and key != "processor_seconds" and s["median"] > .005]
            panels.append(bars(f"Seconds per stage of {name.removeprefix('render/')}, 512 x 512, 4096 lights, one pass, two cores", rows, (1, "s")))
    body, y = [], 0
    for height, parts in panels:
        body.append(f'<g transform="translate(0 {y})">' + "".join(parts) + "</g>")
        y += height
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="760" height="{y}" font-family="sans-serif" font-size="12">'
            f'<rect width="760" height="{y}" fill="#fff"/>' + "".join(body) + "</svg>\n")


def main():
    raw, out = sys.argv[1], sys.argv[2]
    os.makedirs(out, exist_ok=True)
    for name in json_files(raw):
        figures, device = read(os.path.join(raw, name))
        results = {benchmark: {key: summary(values) for key, values in of_one.items()} for benchmark, of_one in sorted(figures.items(), key=lambda f: order(f[0]))}
        with open(os.path.join(out, name), "w", encoding="utf-8") as file:
            json.dump({"cores": os.cpu_count(), "device": device, "results": results}, file, indent=1)
            file.write("\n")
    everything, device = {}, None
    for name in json_files(out):
        with open(os.path.join(out, name), encoding="utf-8") as file:
            content = json.load(file)
        everything.update(content["results"])
        device = content["device"] or device
    with open(os.path.join(out, "results.md"), "w", encoding="utf-8") as file:
        file.write(f"# Results\n\nWritten by `bench/run.sh`; what the figures mean: [README](../README.md). {os.cpu_count()} cores, {device}.\n\n" + table(everything))
    with open(os.path.join(out, "results.svg"), "w", encoding="utf-8") as file:
        file.write(figure(everything))


def json_files(folder):
    return sorted(name for name in os.listdir(folder) if name.endswith(".json"))


def order(name):
    """By name, numbers by value: lanes:4 before lanes:16."""
    return [int(part) if part.isdigit() else part for part in name.replace(":", "/").split("/")]


if __name__ == "__main__":
    main()
