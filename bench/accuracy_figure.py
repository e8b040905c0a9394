#!/usr/bin/env python3
"""What every dial is worth, from `tyndall bench --accuracy` or `tyndall compare --dials`, as a figure: accuracy_figure.py comparison.json accuracy.svg [prices.json]

A row per value: its relMSE at equal time over that of the usual value, with the interval; right of 1 it needs longer for the same error. Filled: told apart; hollow: not."""
import json
import math
import sys

WIDTH, LABELS, RIGHT, ROW, TOP = 820, 330, 120, 17, 64
SAVES, COSTS, UNSURE = "#2f7d4f", "#b4452c", "#777"


def prices(data):
    """(dial, usual value, [(value, ratio, low, high, significant, biased)])."""
    for dial in data["dials"]:
        rows = [(v["value"], *(v["price"][k] for k in ("ratio", "low", "high", "told_apart")), v["biased"]) for v in dial["values"] if v["price"] and v["price"]["high"] is not None]
        if rows:
            yield dial["dial"], dial["usual_value"], rows


def draw(data, path):
    dials = list(prices(data))
    low = min(.5, min(r[1] for _, _, rows in dials for r in rows) / 1.3)
    high = max(2, max(r[1] for _, _, rows in dials for r in rows) * 1.3)
    clipped = lambda v: min(max(v, low), high)
    x = lambda v: LABELS + (WIDTH - LABELS - RIGHT) * math.log(clipped(v) / low) / math.log(high / low)
    height = TOP + sum(ROW * len(rows) + 8 for _, _, rows in dials) + 40
    parts = [f'<text x="16" y="22" font-weight="bold" font-size="15">Times as long for the same error</text>',
             f'<text x="16" y="40" fill="#555">{data["layer"].replace("_", " ")}, {data["width"]} × {data["height"]}, {data["times"][-1]:.2g} s, {data["repeats"]} runs; usual value = 1; intervals hold together with 95 %</text>']
    for v in (.1, .2, .5, 1, 2, 5, 10, 20, 50, 100, 200, 500):
        if low <= v <= high:
            parts.append(f'<path d="M{x(v):.1f} {TOP - 8}V{height - 34}" stroke="{"#555" if v == 1 else "#e4e4e4"}"/><text x="{x(v):.1f}" y="{height - 18}" text-anchor="middle">{v:g}</text>')
    y = TOP
    for dial, usual, rows in dials:
        parts.append(f'<text x="16" y="{y + 10}" font-weight="bold">{dial}</text><text x="16" y="{y + 23}" fill="#777" font-size="10">{usual if len(rows) > 1 else ""}</text>')
        for value, ratio, lowest, highest, sure, biased in rows:
            colour = UNSURE if not sure else COSTS if ratio > 1 else SAVES
            parts.append(f'<text x="{LABELS - 12}" y="{y + 10}" text-anchor="end">{value}</text><path d="M{x(lowest):.1f} {y + 6}H{x(highest):.1f}" stroke="{colour}" stroke-width="2"/>'
                         f'<circle cx="{x(ratio):.1f}" cy="{y + 6}" r="4" fill="{colour if sure else "#fff"}" stroke="{colour}" stroke-width="1.6"/>'
                         f'<text x="{WIDTH - RIGHT + 12}" y="{y + 10}" fill="{colour}">{ratio:.3g}{" biased" if biased else ""}</text>')
            y += ROW
        y += 8
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>' + "".join(parts) + "</svg>\n")


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        measured = json.load(stream)
    draw(measured, sys.argv[2])
    if len(sys.argv) > 3:
        keys = ["value", "ratio", "low", "high", "told_apart", "biased"]
        prices_alone = {key: measured[key] for key in ("version", "layer", "width", "height", "times", "repeats")} | {"device": measured["candidates"][0]["device"]}
        prices_alone["dials"] = [{"dial": dial, "usual": usual, "values": [dict(zip(keys, row)) for row in rows]} for dial, usual, rows in prices(measured)]
        with open(sys.argv[3], "w", encoding="utf-8") as stream:
            json.dump(prices_alone, stream, indent=1)
            stream.write("\n")
