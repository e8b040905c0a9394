#!/usr/bin/env python3
"""bias_slopes.py PROGRAM FOLDER: what bench/bias_slopes.cpp prints, as bias.json and bias.svg in FOLDER: the relative bias of a layer against the radius, both axes logarithmic, with the slope that
is predicted through the middle of each. PROGRAM may be a bias.json that is there already."""
import json
import math
import os
import subprocess
import sys

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 820, 400, 70, 40, 460, 300
NARROW, WIDE, LEAST, MOST = .003, .3, .001, .3
COLOURS = ["#c0392b", "#3b5b92", "#2e7d4f", "#d9822b"]


def at_x(radius):
    return LEFT + PLOT_WIDTH * math.log(radius / NARROW) / math.log(WIDE / NARROW)


def at_y(bias):
    return TOP + PLOT_HEIGHT * (1 - math.log(max(bias, LEAST) / LEAST) / math.log(MOST / LEAST))


def predicted_line(rows, slope):
    """The line of the predicted slope through the mean of the logarithms."""
    middle = sum(math.log(r) for r, _, _ in rows) / len(rows), sum(math.log(abs(b)) for _, b, _ in rows) / len(rows)
    ends = [rows[0][0] / 1.15, rows[-1][0] * 1.15]
    return "M" + "L".join(f"{at_x(r):.1f} {at_y(math.exp(middle[1] + slope * (math.log(r) - middle[0]))):.1f}" for r in ends)


def drawn(name, study, colour, place):
    parts = [f'<path d="{predicted_line(study["bias"], study["predicted"])}" stroke="{colour}" stroke-dasharray="5 4" fill="none"/>']
    for radius, bias, error in study["bias"]:
        x, low, high = at_x(radius), at_y(abs(bias) - 1.96 * error), at_y(abs(bias) + 1.96 * error)
        parts.append(f'<path d="M{x:.1f} {low:.1f}V{high:.1f}" stroke="{colour}"/><circle cx="{x:.1f}" cy="{at_y(abs(bias)):.1f}" r="4" fill="{colour}"/>')
    sign = "too dark" if study["bias"][-1][1] < 0 else "too bright"
    for i, line in enumerate([f"{name}, {study['layer']}", f"slope {study['slope']:.2f} ± {study['half_width']:.2f}, predicted {study['predicted']:g}; {sign}"]):
        parts.append(f'<text x="{LEFT + PLOT_WIDTH + 20}" y="{TOP + 20 + 60 * place + 17 * i}" fill="{colour}">{line}</text>')
    return parts


def axes():
    parts = [f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>', f'<text x="{LEFT}" y="22" font-weight="bold">Relative bias of a layer, 95 % confidence; dashed: the predicted slope</text>',
             f'<path d="M{LEFT} {TOP}V{TOP + PLOT_HEIGHT}H{LEFT + PLOT_WIDTH}" stroke="#222" fill="none"/>']
    parts += [f'<text x="{at_x(r):.1f}" y="{TOP + PLOT_HEIGHT + 18}" text-anchor="middle">{r:g}</text>' for r in (.003, .01, .03, .1, .3)]
    parts += [f'<text x="{LEFT - 8}" y="{at_y(b) + 4:.1f}" text-anchor="end">{100 * b:g} %</text>' for b in (.001, .003, .01, .03, .1, .3)]
    parts.append(f'<text x="{LEFT}" y="{HEIGHT - 12}">Radius as a share of the scene\'s half diagonal; of a clamp C: 1/√C, below which connections are dimmed.</text>')
    return parts


def main():
    source, folder = sys.argv[1], sys.argv[2]
    if source.endswith(".json"):
        with open(source, encoding="utf-8") as file:
            text = file.read()
    else:
        text = subprocess.run([source], check=True, capture_output=True, text=True).stdout
    os.makedirs(folder, exist_ok=True)
    parts = axes()
    for place, ((name, study), colour) in enumerate(zip(json.loads(text).items(), COLOURS)):
        parts += drawn(name, study, colour, place)
    with open(os.path.join(folder, "bias.svg"), "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">' + "".join(parts) + "</svg>\n")
    with open(os.path.join(folder, "bias.json"), "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
