#!/usr/bin/env python3
"""variance.py VARIANCE.json PAIRS.json SHADOW.json OUT: tables and a figure of what bench/variance.cpp printed, with the time of a sample from `pairs` (Google Benchmark's JSON,
16 lanes, one core; or an earlier OUT/variance.json, whose times are taken again) and of a shadow segment from bench/results/shadow_1_core.json. Writes OUT/variance.json, .md and .svg."""
import json
import os
import statistics
import sys

ISOTROPIC = {"paper-isotropic": "isotropic_grey", "paper": "isotropic_grey", "paper-6": "paper_6_isotropic", "table-3x2": "table_3x2_isotropic"}
LOBES = {"paper-isotropic": "henyey_greenstein_grey", "paper": "product_sampler", "paper-6": "paper_6", "table": "table", "table-4x4": "table_4x4", "table-3x2": "table_3x2"}


def nanoseconds(path):
    """{benchmark: ns per pair at 16 lanes}."""
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    if "nanoseconds" in data:
        return data["nanoseconds"]
    entries = data["benchmarks"]
    rates = {}
    for entry in entries:
        if "/lanes:16" in entry["name"] and entry.get("run_type", "iteration") == "iteration":
            rates.setdefault(entry["name"].split("/")[1], []).append(entry["pairs_per_second"])
    return {name: 1e9 / statistics.median(values) for name, values in rates.items()}


def columns_of(data):
    return [f"{c['sigma_t']:g} / {c['g']:g}" for c in data["columns"]]


def table(data, value, title):
    """One row per sampler; `value` of (sampler, column) as text."""
    names = list(data["columns"][0]["samplers"])
    lines = [f"\n## {title}\n", "| σ_t·size / g | " + " | ".join(columns_of(data)) + " |", "|---" * (len(data["columns"]) + 1) + "|"]
    for name in names:
        cells = [value(name, c) for c in data["columns"]]
        if any(cells):
            lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def time_of(data, name, column):
    """Nanoseconds of one sample, or None where it was not measured."""
    base = name.split(",")[0]
    times, names = data["nanoseconds"], LOBES if column["g"] != 0 else {**LOBES, **ISOTROPIC}
    one = times.get(names.get(base, ""))
    return one and one * (4 if ", 4 " in name else 1)


def efficiency(data, shadow):
    def value(name, column):
        time, samples = time_of(data, name, column), 4 if ", 4 " in name else 1
        return f"{column['samplers'][name]['variance'] * (time + shadow * samples):.2g}" if time else ""
    return value


def crossing(data, shadow):
    """Per asymmetry and sampler: variance x time of paper-isotropic over its own, geometric mean over the extinctions; above 1 it wins."""
    math = __import__("math")
    names, rows = ["paper", "paper-6"], ["| g | paper | paper-6 | paper, with a shadow segment | paper-6, with a shadow segment |\n|---|---|---|---|---|"]
    for g in sorted({c["g"] for c in data["crossing"]}):
        cells = []
        for segment in (0, shadow):
            price = lambda n, c: c["samplers"][n]["variance"] * (time_of(data, n, c) + segment)
            for name in names:
                logs = [math.log(price("paper-isotropic", c) / price(name, c)) for c in data["crossing"] if c["g"] == g]
                cells.append(f"{math.exp(statistics.mean(logs)):.2f}")
        rows.append(f"| {g:g} | " + " | ".join(cells) + " |")
    return "\n## Where the product begins to win\n\nVariance × time of `paper-isotropic` over that of the sampler, mean over extinctions .1, 1 and 4; above 1 the sampler wins in single pairs.\n\n" + "\n".join(rows) + "\n"


def figure(data):
    names = [n for n in data["columns"][0]["samplers"] if ", 4 " not in n]
    colours = ["#7a869a", "#3b5b92", "#5a8fd0", "#3f9b8a", "#b3392f", "#d9822b", "#e0b03c"]
    log = lambda v: __import__("math").log10(max(v, 1e-4)) + 4
    parts, width, height = ['<rect width="760" height="330" fill="#fff"/>'], 680 / len(data["columns"]), 230
    for i, column in enumerate(data["columns"]):
        for k, name in enumerate(names):
            h = height * log(column["samplers"][name]["variance"]) / 5
            parts.append(f'<rect x="{60 + i * width + 5 + k * (width - 10) / len(names):.1f}" y="{30 + height - h:.1f}" width="{(width - 10) / len(names) - 1:.1f}" height="{h:.1f}" fill="{colours[k]}"/>')
        parts.append(f'<text x="{60 + (i + .5) * width:.1f}" y="{30 + height + 16}" text-anchor="middle">{columns_of(data)[i]}</text>')
    for k in range(6):
        y = 30 + height * (1 - k / 5)
        parts.append(f'<text x="52" y="{y + 4:.0f}" text-anchor="end">{10 ** (k - 4):g}</text><path d="M58 {y:.1f}H742" stroke="#ddd"/>')
    for k, name in enumerate(names):
        parts.append(f'<rect x="{60 + k * 98}" y="300" width="10" height="10" fill="{colours[k]}"/><text x="{74 + k * 98}" y="310">{name}</text>')
    return '<svg xmlns="http://www.w3.org/2000/svg" width="760" height="330" font-family="sans-serif" font-size="12"><text x="60" y="18" font-weight="bold">Variance over squared mean of one sample; extinction x size / g</text>' \
        .replace("<text", parts.pop(0) + "<text", 1) + "".join(parts) + "</svg>\n"


def main():
    variance, pairs, shadow_path, out = sys.argv[1:5]
    with open(variance, encoding="utf-8") as file:
        data = json.load(file)
    with open(shadow_path, encoding="utf-8") as file:
        shadow = 1e9 / json.load(file)["results"]["packets/triangles:28/cores:1"]["segments_per_second"]["median"]
    data["nanoseconds"] = {k: round(v, 1) for k, v in nanoseconds(pairs).items()}
    data["shadow_nanoseconds"] = round(shadow, 1)
    os.makedirs(out, exist_ok=True)
    text = f"# Variance of the samplers\n\nWritten by `bench/variance.py`; what the figures mean: [README](../../README.md). {data['pairs']} pairs, {data['samples']} samples each, seed {data['seed']}.\n"
    text += table(data, lambda n, c: f"{c['samplers'][n]['variance']:.2g} ± {c['samplers'][n]['standard_error']:.1g}", "Variance over squared mean")
    text += table(data, efficiency(data, 0), "The same times nanoseconds per sample, nothing occludes")
    text += table(data, efficiency(data, shadow), f"The same with a shadow segment of {shadow:.0f} ns per sample")
    text += crossing(data, shadow)
    text += "\nNanoseconds per sample, 16 lanes, one core: " + ", ".join(f"{k} {v}" for k, v in sorted(data["nanoseconds"].items())) + ".\n"
    for name, content in (("json", json.dumps(data, indent=1) + "\n"), ("md", text), ("svg", figure(data))):
        with open(os.path.join(out, f"variance.{name}"), "w", encoding="utf-8") as file:
            file.write(content)


if __name__ == "__main__":
    main()
