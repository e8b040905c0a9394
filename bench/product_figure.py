#!/usr/bin/env python3
"""product_figure.py PROGRAM OUT.svg: draws what bench/product_figure.cpp prints: the product of phase functions and the density over the angle."""
import json
import math
import subprocess
import sys

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 760, 360, 60, 40, 680, 270


def main():
    data = json.loads(subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout)
    highest = max(max(f, p) for _, f, p in data["curve"]) * 1.05
    at = lambda x, y: f"{LEFT + PLOT_WIDTH * x:.1f} {TOP + PLOT_HEIGHT * (1 - y / highest):.1f}"
    line = lambda rows: "M" + "L".join(at(x, y) for x, y in rows)
    degrees = lambda x: math.degrees(data["start"] + data["extent"] * x)
    parts = [f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
             f'<text x="{LEFT}" y="22" font-weight="bold">Product of two Henyey-Greenstein lobes, g = {data["g"]}, and the ten-vertex density; largest f/p = {data["largest_ratio"]:.2f}</text>',
             f'<path d="M{LEFT} {TOP}V{TOP + PLOT_HEIGHT}H{LEFT + PLOT_WIDTH}" stroke="#222" fill="none"/>']
    for k in range(5):
        x = k / 4
        parts.append(f'<text x="{LEFT + PLOT_WIDTH * x:.1f}" y="{TOP + PLOT_HEIGHT + 18}" text-anchor="middle">{degrees(x):.0f}\u00b0</text>')
    parts.append(f'<text x="{LEFT - 8}" y="{TOP + 8}" text-anchor="end">{highest:.1f}</text><text x="{LEFT - 8}" y="{TOP + PLOT_HEIGHT}" text-anchor="end">0</text>')
    parts.append(f'<path d="{line([(x, p) for x, _, p in data["curve"]])}" stroke="#d9822b" stroke-width="2" fill="none"/>')
    parts.append(f'<path d="{line([(x, f) for x, f, _ in data["curve"]])}" stroke="#3b5b92" stroke-width="1.5" fill="none"/>')
    for x, p in data["vertices"]:
        cx, cy = at(x, p).split()
        parts.append(f'<circle cx="{cx}" cy="{cy}" r="3.5" fill="#d9822b"/>')
    parts.append(f'<text x="{LEFT}" y="{HEIGHT - 12}">angle at the light, relative to the even density; blue: product of phase functions, orange: density that is drawn from (a tenth of it even)</text>')
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">' + "".join(parts) + "</svg>\n")
    print(f"largest f/p: {data['largest_ratio']}")


if __name__ == "__main__":
    main()
