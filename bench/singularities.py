#!/usr/bin/env python3
"""singularities.py PROGRAM FOLDER: what bench/singularities.cpp prints, as singularities.json and singularities.svg in FOLDER: second moments of one sample against the least distance of a
light, relative to those at .1; both axes logarithmic."""
import json
import math
import os
import subprocess
import sys

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 760, 400, 70, 40, 520, 300
DECADES, NEAREST, FARTHEST = 5, 1e-7, 1e-1
COLOURS = ["#c0392b", "#d9822b", "#3b5b92", "#2e7d4f"]


def main():
    text = subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout
    data, folder = json.loads(text), sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    at_x = lambda h: LEFT + PLOT_WIDTH * math.log10(FARTHEST / h) / math.log10(FARTHEST / NEAREST)
    at_y = lambda m: TOP + PLOT_HEIGHT * (1 - math.log10(m) / DECADES)
    parts = [f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
             f'<text x="{LEFT}" y="22" font-weight="bold">Second moment of one sample, over lights no nearer than h</text>',
             f'<path d="M{LEFT} {TOP}V{TOP + PLOT_HEIGHT}H{LEFT + PLOT_WIDTH}" stroke="#222" fill="none"/>']
    for k in range(1, 8):
        parts.append(f'<text x="{at_x(10.0 ** -k):.1f}" y="{TOP + PLOT_HEIGHT + 18}" text-anchor="middle">1e-{k}</text>')
    for k in range(DECADES + 1):
        parts.append(f'<text x="{LEFT - 8}" y="{at_y(10.0 ** k) + 4:.1f}" text-anchor="end">{10 ** k}</text>')
    lowest_label = -math.inf
    for (name, rows), colour in zip(data.items(), COLOURS):
        shown = [(h, m / rows[0][1]) for h, m in rows if m / rows[0][1] <= 10 ** DECADES]
        parts.append(f'<path d="M{"L".join(f"{at_x(h):.1f} {at_y(m):.1f}" for h, m in shown)}" stroke="{colour}" stroke-width="2" fill="none"/>')
        x, y = at_x(shown[-1][0]) + 6, max(at_y(shown[-1][1]) + 4, lowest_label + 15)
        lowest_label = y
        parts.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}">{name}</text>')
    parts.append(f'<text x="{LEFT}" y="{HEIGHT - 12}">h, in units of the farthest light counted; moments relative to those at h = .1. A straight rise is a power law.</text>')
    with open(os.path.join(folder, "singularities.svg"), "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">' + "".join(parts) + "</svg>\n")
    with open(os.path.join(folder, "singularities.json"), "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
