"""The results of scaling.py as a figure: time of a pass, and error at a fixed time, against the number of virtual lights; both axes logarithmic."""
import math

WIDTH, HEIGHT, PANEL, TOP, BOTTOM = 860, 330, 330, 56, 270
COLOURS = ["#4c78a8", "#d9822b", "#54a24b", "#b279a2", "#e45756"]


def panel(left, title, note, curves, low, high, lights):
    x = lambda n: left + PANEL * (math.log(n) - math.log(lights[0])) / (math.log(lights[-1]) - math.log(lights[0]))
    y = lambda v: BOTTOM - (BOTTOM - TOP) * (math.log(v) - math.log(low)) / (math.log(high) - math.log(low))
    parts = [f'<text x="{left}" y="24" font-weight="bold">{title}</text><text x="{left}" y="40" fill="#555">{note}</text>']
    for e in range(-3, 4):
        for m in (1, 2, 5):
            v = m * 10.0**e
            if low <= v <= high:
                parts.append(f'<path d="M{left} {y(v):.1f}H{left + PANEL}" stroke="{"#999" if v == 1 else "#e4e4e4"}"/><text x="{left - 6}" y="{y(v) + 4:.1f}" text-anchor="end">{v:g}</text>')
    for n in lights:
        name = f"{n >> 20} M" if n >= 1 << 20 else f"{n >> 10} K" if n >= 1 << 10 else str(n)
        parts.append(f'<text x="{x(n):.1f}" y="{BOTTOM + 18}" text-anchor="middle">{name}</text>')
    for colour, dash, values in curves:
        points = " ".join(f"{x(n):.1f},{y(v):.1f}" for n, v in zip(lights, values))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/>')
        parts += [f'<circle cx="{x(n):.1f}" cy="{y(v):.1f}" r="3" fill="{colour}"/>' for n, v in zip(lights, values)]
    return parts


def draw(result, path):
    lights = [row["lights"] for row in result["scenes"][0]["rows"]]
    time, error = [], []
    for colour, scene in zip(COLOURS, result["scenes"]):
        rows = scene["rows"]
        at_fixed_time = lambda key: [math.sqrt(max(row[key], 1e-12) * row["seconds"]) for row in rows]
        relative = lambda values: [value / values[0] for value in values]
        time.append((colour, "", relative([row["seconds"] for row in rows])))
        error += [(colour, "", relative(at_fixed_time("relative_mse"))), (colour, "5 4", relative(at_fixed_time("relative_mse_blocks")))]
    bounds = lambda curves: (min(min(values) for _, _, values in curves) / 1.2, max(max(values) for _, _, values in curves) * 1.2)
    parts = panel(52, "Time of a pass", f"fewest lights = 1; {result['size']} x {result['size']} pixels", time, *bounds(time), lights)
    parts += panel(478, "Error at a fixed time", "fewest lights = 1; pixels, and dashed means over 8 x 8", error, *bounds(error), lights)
    for i, scene in enumerate(result["scenes"]):
        parts.append(f'<rect x="{52 + 180 * i}" y="{HEIGHT - 20}" width="12" height="12" fill="{COLOURS[i]}"/><text x="{70 + 180 * i}" y="{HEIGHT - 10}">{scene["scene"]}</text>')
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">'
                   f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>' + "".join(parts) + "</svg>\n")
