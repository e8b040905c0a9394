"""The results of talk.py as a figure with the images side by side, and as tables."""

NAMES = {"vrl": "virtual ray lights", "vpl": "virtual point lights", "beams": "photon beams"}
COLUMN, GAP, CAPTION = 250, 14, 54


def error_text(row):
    return f"{'< ' if row['at_most'] else ''}{100 * row['error']:.3g} %"


def size_of(uri):
    """Pixels of a PNG, from its header."""
    import base64
    header = base64.b64decode(uri.split(",", 1)[1][:64])
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")


def draw(result, path):
    parts, y, width = [], 20, 0
    for e in result["experiments"]:
        across, high = size_of(e["reference_image"])
        height = round(COLUMN * high / across)
        parts.append(f'<text x="16" y="{y + 14}" font-weight="bold" font-size="15">{e["title"]}</text>')
        y += 26
        times = sorted({row["seconds"] for row in e["rows"]})
        for k, seconds in enumerate(times):
            cells = [(row["image"], NAMES[row["method"]], f"{seconds:g} s, {row['lights']:,} lights", f"error {error_text(row)}") for row in e["rows"] if row["seconds"] == seconds]
            if k == len(times) - 1:
                cells.append((e["reference_image"], "reference", f"{e['reference_seconds']:g} s", f"error {100 * e['reference_error']:.2g} %"))
            for i, (image, *lines) in enumerate(cells):
                x = 16 + i * (COLUMN + GAP)
                width = max(width, x + COLUMN + 16)
                parts.append(f'<image x="{x}" y="{y}" width="{COLUMN}" height="{height}" href="{image}"/>')
                parts += [f'<text x="{x}" y="{y + height + 15 + 15 * n}"{" font-weight=" + chr(34) + "bold" + chr(34) if n == 0 else ""}>{line}</text>' for n, line in enumerate(lines)]
            y += height + CAPTION
        y += 10
    for row in result.get("animation", []):
        parts.append(f'<text x="16" y="{y + 14}">{NAMES[row["method"]]}, {row["seconds"]:g} s a frame: flicker {100 * row["flicker"]:.3g} %</text>')
        y += 20
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {max(width, 600)} {y + 16}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>' + "".join(parts) + "</svg>\n")


def markdown(result):
    text = ["# The talk's experiments", "", "Equal time on this machine" + (", a tenth of the talk's times" if result["quick"] else "") + ".", ""]
    for e in result["experiments"]:
        text += [f"## {e['title']}", "", f"Reference: virtual ray lights, {e['reference_seconds']:g} s, own error {100 * e['reference_error']:.2g} %.", "", "| seconds | took | method | error | trimmed | means over 8 × 8 | passes | lights | the talk's |", "|---|---|---|---|---|---|---|---|---|"]
        for row in e["rows"]:
            text.append(f"| {row['seconds']:g} | {row['took']:.3g} | {NAMES[row['method']]} | {error_text(row)} | {100 * row['trimmed']:.3g} % | {100 * row['blocks']:.3g} % | {row['passes']} | {row['lights']:,} | {row['talk_lights'] or ''} |")
        text.append("")
    if result.get("animation"):
        text += ["## Turning light", "", "| method | seconds a frame | flicker |", "|---|---|---|"]
        text += [f"| {NAMES[row['method']]} | {row['seconds']:g} | {100 * row['flicker']:.3g} % |" for row in result["animation"]]
        text.append("")
    return "\n".join(text)
