"""The results of effects.py as a figure: for each effect, time and variance beside the scene without it, on a logarithmic scale."""
import math

WIDTH, LEFT, RIGHT, ROW = 760, 190, 700, 40
TIME, VARIANCE = "#d9822b", "#4c78a8"


def ticks(low, high):
    return [v * 10.0**e for e in range(-2, 4) for v in (1, 2, 5) if low <= v * 10.0**e <= high]


def figure(results):
    rows = [r for r in results["effects"] if r["effect"] != "none"]
    ratios = [r[key] for r in rows for key in ("time_ratio", "variance_ratio")]
    low, high = min(.5, min(ratios) / 1.2), max(2, max(ratios) * 1.6)
    x = lambda v: LEFT + (RIGHT - LEFT) * (math.log(v) - math.log(low)) / (math.log(high) - math.log(low))
    height = 70 + ROW * len(rows)
    parts = ['<text x="8" y="18" font-weight="bold">What each effect costs in media_to_media, beside the same scene without it</text>',
             f'<rect x="{LEFT}" y="28" width="12" height="12" fill="{TIME}"/><text x="{LEFT + 18}" y="38">time per pair</text>',
             f'<rect x="{LEFT + 120}" y="28" width="12" height="12" fill="{VARIANCE}"/><text x="{LEFT + 138}" y="38">variance after as many passes</text>']
    for tick in ticks(low, high):
        colour = "#444" if tick == 1 else "#ddd"
        parts.append(f'<path d="M{x(tick):.1f} 46V{height - 20}" stroke="{colour}"/><text x="{x(tick):.1f}" y="{height - 6}" text-anchor="middle">x{tick:g}</text>')
    for i, row in enumerate(rows):
        y = 50 + ROW * i
        parts.append(f'<text x="{LEFT - 8}" y="{y + 20}" text-anchor="end">{row["effect"]}</text>')
        for offset, key, colour in ((2, "time_ratio", TIME), (17, "variance_ratio", VARIANCE)):
            a, b = sorted((x(1), x(row[key])))
            parts.append(f'<rect x="{a:.1f}" y="{y + offset}" width="{max(b - a, 1):.1f}" height="13" fill="{colour}"/>')
            parts.append(f'<text x="{b + 5:.1f}" y="{y + offset + 11}" font-size="11">x{row[key]:.2f}</text>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="12">'
            f'<rect width="{WIDTH}" height="{height}" fill="#fff"/>' + "".join(parts) + "</svg>\n")
