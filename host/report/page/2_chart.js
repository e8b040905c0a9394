// Error against time, both logarithmic, with error bars and a reading line.
"use strict";

/** Powers of ten, and 2 and 5 times them where they are few. */
function logarithmicTicks(low, high) {
  const steps = Math.log10(high / low) > 3 ? [1] : Math.log10(high / low) > 1.6 ? [1, 3] : [1, 2, 5], found = [];
  for (let e = Math.floor(Math.log10(low)) - 1; e <= Math.log10(high); ++e) for (const s of steps) if (s * 10 ** e >= low && s * 10 ** e <= high) found.push(s * 10 ** e);
  return found;
}

function makeChart(holder, legend, live) {
  const turned = new Set((data.dials ?? []).slice(1).flatMap((sweep) => sweep.values.map((v) => v.candidate)));  // values of dials have charts of their own; the legend shows them here too
  const shown = data.candidates.map((_, i) => !turned.has(i));
  const curves = data.candidates.map((candidate) => candidate.curve.filter((p) => p.relative_mse && p.relative_mse.median > 0));
  const grid = [...new Set(curves.flat().map((p) => p.seconds))].sort((a, b) => a - b);
  const floor = errorOf(data.reference.relative_mse);
  let reading = null, frame = null;

  function limits() {
    const errors = curves.flat().flatMap((p) => [errorOf(p.relative_mse.low), errorOf(p.relative_mse.high)]).filter((e) => e > 0);
    const last = Math.max(...data.times), first = Math.min(...grid, last / 2);
    const low = Math.min(...errors), high = Math.max(...errors);
    return {t: [first / 1.08, last * 1.08], e: [low / 1.25, Math.max(high * 1.25, low * 4)]};
  }

  /** Value on a curve at a time that need not be one of its points; null outside. */
  function readAt(curve, time) {
    const after = curve.findIndex((p) => p.seconds >= time * (1 - 1e-9));
    if (after < 0 || (after === 0 && curve[0].seconds > time * (1 + 1e-9))) return null;
    const b = curve[after], a = curve[Math.max(after - 1, 0)], share = a === b ? 1 : Math.log(time / a.seconds) / Math.log(b.seconds / a.seconds);
    const mix = (name) => a.relative_mse[name] > 0 ? a.relative_mse[name] * (b.relative_mse[name] / a.relative_mse[name]) ** share : b.relative_mse[name];
    return {median: mix("median"), low: mix("low"), high: mix("high"), atMost: a.at_most || b.at_most};
  }

  function draw() {
    const width = Math.max(holder.clientWidth, 280), narrow = width < 560, height = Math.round(Math.min(Math.max(width * .52, 260), 460));
    const margin = {left: narrow ? 46 : 58, right: narrow ? 14 : 24 + 7.2 * Math.min(Math.max(...data.candidates.map((c) => c.name.length)), 21), top: 22, bottom: 44}, range = limits();
    const x = (t) => margin.left + Math.log(t / range.t[0]) / Math.log(range.t[1] / range.t[0]) * (width - margin.left - margin.right);
    const y = (e) => margin.top + Math.log(range.e[1] / e) / Math.log(range.e[1] / range.e[0]) * (height - margin.top - margin.bottom);
    frame = {x, y, width, height, margin, range};
    const svg = el("svg", {viewBox: `0 0 ${width} ${height}`, role: "img", tabindex: 0, "aria-label": "Error against time for " + data.candidates.map((c) => c.name).join(", ")});
    for (const t of logarithmicTicks(...range.t)) {
      svg.append(el("line", {class: "grid", x1: x(t), x2: x(t), y1: margin.top, y2: height - margin.bottom}), el("text", {x: x(t), y: height - margin.bottom + 17, "text-anchor": "middle"}, short(t)));
    }
    for (const e of logarithmicTicks(...range.e)) {
      svg.append(el("line", {class: "grid", x1: margin.left, x2: width - margin.right, y1: y(e), y2: y(e)}), el("text", {x: margin.left - 7, y: y(e) + 4, "text-anchor": "end"}, short(e) + " %"));
    }
    svg.append(el("line", {class: "axis", x1: margin.left, x2: width - margin.right, y1: height - margin.bottom, y2: height - margin.bottom}));
    svg.append(el("text", {x: (margin.left + width - margin.right) / 2, y: height - 8, "text-anchor": "middle"}, "seconds"));
    svg.append(el("text", {x: margin.left + 6, y: margin.top + 10}, "error"));
    for (const t of data.times) {
      svg.append(el("line", {class: "wanted", x1: x(t), x2: x(t), y1: margin.top, y2: height - margin.bottom}), el("text", {x: x(t), y: margin.top - 5, "text-anchor": "middle"}, seconds(t)));
    }
    if (floor > range.e[0] && floor < range.e[1])
      svg.append(el("line", {class: "floor", x1: margin.left, x2: width - margin.right, y1: y(floor), y2: y(floor)}), el("text", {x: margin.left + 6, y: y(floor) - 5}, "noise of the reference"));
    data.candidates.forEach((candidate, i) => shown[i] && svg.append(drawCurve(candidate, i)));
    if (!narrow) labelEnds(svg);
    svg.append(el("line", {class: "reading", y1: margin.top, y2: height - margin.bottom, visibility: "hidden"}));
    svg.addEventListener("pointermove", (event) => read(timeAt(event)));
    svg.addEventListener("pointerleave", () => read(null));
    svg.addEventListener("keydown", step);
    svg.addEventListener("blur", () => read(null));
    holder.replaceChildren(svg, el("div", {class: "tip", hidden: true}));
  }

  function drawCurve(candidate, i) {
    const {x, y, range} = frame, lowest = range.e[0], at = (p, name) => `${x(p.seconds).toFixed(1)},${y(Math.max(errorOf(p.relative_mse[name]), lowest)).toFixed(1)}`, points = curves[i];
    const group = el("g", {"data-curve": candidate.name, fill: colour(i), stroke: colour(i)});
    if (!points.length) return group;
    group.append(el("path", {class: "band", stroke: "none", d: "M" + points.map((p) => at(p, "high")).join("L") + "L" + [...points].reverse().map((p) => at(p, "low")).join("L") + "Z"}));
    group.append(el("path", {class: "curve", "stroke-dasharray": dash(i), d: "M" + points.map((p) => at(p, "median")).join("L")}));
    for (const p of candidate.at_times) {
      if (!p.relative_mse || !(p.relative_mse.median > 0)) continue;
      const px = x(p.seconds) + (i - (data.candidates.length - 1) / 2) * 3, [high, low] = ["high", "low"].map((name) => y(Math.max(errorOf(p.relative_mse[name]), lowest)));
      group.append(el("path", {class: "error-bar", fill: "none", "stroke-width": 1.5, d: `M${px},${low}V${high}M${px - 3},${low}h6M${px - 3},${high}h6`}));
      group.append(el("path", {d: mark(i), transform: `translate(${px} ${y(errorOf(p.relative_mse.median))})`, fill: p.at_most ? "var(--panel)" : colour(i), "stroke-width": 1.5}));
    }
    return group;
  }

  /** Names at the right ends, pushed apart. */
  function labelEnds(svg) {
    const labels = data.candidates.map((c, i) => ({name: c.name, i, last: curves[i].at(-1)})).filter((l) => shown[l.i] && l.last);
    labels.forEach((l) => l.y = frame.y(errorOf(l.last.relative_mse.median)));
    labels.sort((a, b) => a.y - b.y).forEach((l, k) => l.y = k ? Math.max(l.y, labels[k - 1].y + 15) : l.y);
    const over = labels.length ? labels.at(-1).y - (frame.height - frame.margin.bottom) : 0;
    for (const l of labels) {
      const name = l.name.length > 21 ? l.name.slice(0, 20) + "…" : l.name;
      const text = el("text", {class: "end", x: frame.width - frame.margin.right + 12, y: l.y + 4 - Math.max(over, 0)}, name);
      text.style.fill = colour(l.i);
      svg.append(text);
    }
  }

  function timeAt(event) {
    const box = holder.querySelector("svg").getBoundingClientRect(), px = (event.clientX - box.left) * frame.width / box.width;
    const share = (px - frame.margin.left) / (frame.width - frame.margin.left - frame.margin.right);
    if (share < 0 || share > 1.02) return null;
    const t = frame.range.t[0] * (frame.range.t[1] / frame.range.t[0]) ** share;
    return grid.reduce((best, g) => Math.abs(Math.log(g / t)) < Math.abs(Math.log(best / t)) ? g : best, grid[0]);
  }

  function step(event) {
    const move = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!move) return;
    event.preventDefault();
    const at = reading === null ? (move > 0 ? -1 : grid.length) : grid.indexOf(reading);
    read(grid[Math.min(Math.max(at + move, 0), grid.length - 1)]);
    live.textContent = holder.querySelector(".tip").innerText;
  }

  function read(time) {
    const tip = holder.querySelector(".tip"), line = holder.querySelector(".reading");
    reading = time;
    tip.hidden = time === null || time === undefined;
    line.setAttribute("visibility", tip.hidden ? "hidden" : "visible");
    if (tip.hidden) return;
    const px = frame.x(time);
    line.setAttribute("x1", px), line.setAttribute("x2", px);
    const rows = data.candidates.map((c, i) => ({c, i, value: shown[i] ? readAt(curves[i], time) : null})).filter((r) => r.value).sort((a, b) => b.value.median - a.value.median);
    tip.replaceChildren(el("strong", {}, seconds(time)), el("table", {}, rows.map(({c, i, value}) => el("tr", {},
      el("td", {}, el("span", {class: "key", style: `background:${colour(i)}`}), c.name),
      el("td", {}, `${value.atMost ? "< " : ""}${percent(value.median)} `, el("small", {}, `${short(errorOf(value.low))}–${short(errorOf(value.high))}`))))));
    const scale = holder.clientWidth / frame.width;
    tip.style.top = "1rem";
    tip.style.left = Math.min(Math.max(px * scale + (px > frame.width / 2 ? -tip.offsetWidth - 14 : 14), 4), Math.max(holder.clientWidth - tip.offsetWidth - 4, 4)) + "px";
  }

  data.candidates.forEach((candidate, i) => {
    const sample = el("svg", {width: 30, height: 14}, el("path", {d: "M0,7H30", stroke: colour(i), "stroke-width": 2, "stroke-dasharray": dash(i)}), el("path", {d: mark(i, 4), fill: colour(i), transform: "translate(15 7)"}));
    legend.append(el("button", {type: "button", "aria-pressed": String(shown[i]), onclick: (event) => {
      shown[i] = !shown[i];
      event.currentTarget.setAttribute("aria-pressed", shown[i]);
      draw();
    }}, sample, candidate.name));
  });
  new ResizeObserver(() => frame && Math.abs(holder.clientWidth - frame.width) > 1 && draw()).observe(holder);
  addEventListener("beforeprint", () => draw());
  draw();
}
