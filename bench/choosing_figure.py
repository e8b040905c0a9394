"""The results of choosing.py as a figure: how many times less processor time than path tracing, against the density of the fog."""
import math

WIDTH, PANEL_WIDTH, PANEL_HEIGHT, LEFT, TOP, GAP = 900, 360, 230, 60, 60, 100
COLOURS = {0: "#4c78a8", .6: "#d9822b", .9: "#b279a2"}
LOW, HIGH = .02, 5000


def panel(left, top, title, rows, method):
    across = sorted({row["mean_free_paths"] for row in rows})
    x = lambda n: left + PANEL_WIDTH * math.log(n / across[0]) / math.log(across[-1] / across[0])
    y = lambda v: top + PANEL_HEIGHT * math.log(HIGH / min(max(v, LOW), HIGH)) / math.log(HIGH / LOW)
    parts = [f'<text x="{left}" y="{top - 12}" font-weight="bold">{title}</text>']
    for e in range(-1, 4):
        v = 10.0**e
        parts.append(f'<path d="M{left} {y(v):.1f}h{PANEL_WIDTH}" stroke="{"#777" if v == 1 else "#e4e4e4"}"/><text x="{left - 6}" y="{y(v) + 4:.1f}" text-anchor="end">{v:g}</text>')
    for n in across:
        parts.append(f'<text x="{x(n):.1f}" y="{top + PANEL_HEIGHT + 17}" text-anchor="middle">{n:g}</text>')
    for g, colour in COLOURS.items():
        for kind, dash in (("pixels", ""), ("blocks", "5 4")):
            line = sorted((row["mean_free_paths"], row[kind][method]) for row in rows if row["g"] == g)
            parts.append(f'<polyline points="{" ".join(f"{x(n):.1f},{y(v):.1f}" for n, v in line)}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/>')
            parts += [f'<circle cx="{x(n):.1f}" cy="{y(v):.1f}" r="2.6" fill="{colour}"/>' for n, v in line]
    return parts


def draw(result, path):
    names = {("free", "media_to_media"): "media to media, nothing in the way", ("shadowed", "media_to_media"): "media to media, a block in the way", ("free", "image"): "whole image, nothing in the way",
             ("shadowed", "image"): "whole image, a block in the way"}
    parts = ['<text x="20" y="22" font-weight="bold" font-size="15">Processor time of path tracing over that of virtual ray lights, for the same error</text>']
    height = TOP + 2 * (PANEL_HEIGHT + GAP)
    for i, ((place, what), title) in enumerate(names.items()):
        rows = [row for row in result["rows"] if row["place"] == place and row["what"] == what]
        parts += panel(LEFT + i % 2 * (PANEL_WIDTH + 70), TOP + i // 2 * (PANEL_HEIGHT + GAP - 30), title, rows, "vrl")
    bottom = height - 44
    parts.append(f'<text x="{WIDTH / 2}" y="{bottom - 18}" text-anchor="middle">mean free paths across the fog; solid: pixels, dashed: means over 8 x 8; above 1 ray lights win</text>')
    for i, (g, colour) in enumerate(COLOURS.items()):
        parts.append(f'<rect x="{LEFT + 130 * i}" y="{bottom}" width="12" height="12" fill="{colour}"/><text x="{LEFT + 18 + 130 * i}" y="{bottom + 11}">g = {g:g}</text>')
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>' + "".join(parts) + "</svg>\n")
