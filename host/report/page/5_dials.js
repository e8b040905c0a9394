// Every dial by itself: curves of its values beside the usual one, and what each is worth.
"use strict";

/** Error against time for the values of one dial; all dials share their axes, so that they can be compared by eye. */
function dialChart(sweep, range) {
  const width = 330, height = 200, margin = {left: 46, right: 12, top: 8, bottom: 34};
  const x = (t) => margin.left + Math.log(t / range.t[0]) / Math.log(range.t[1] / range.t[0]) * (width - margin.left - margin.right);
  const y = (e) => margin.top + Math.log(range.e[1] / e) / Math.log(range.e[1] / range.e[0]) * (height - margin.top - margin.bottom);
  const members = [sweep.usual, ...sweep.values.map((v) => v.candidate)];
  const svg = el("svg", {viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `Error against time for ${sweep.dial}: ${[sweep.usual_value, ...sweep.values.map((v) => v.value)].join(", ")}`});
  for (const t of logarithmicTicks(...range.t)) svg.append(el("line", {class: "grid", x1: x(t), x2: x(t), y1: margin.top, y2: height - margin.bottom}), el("text", {x: x(t), y: height - margin.bottom + 15, "text-anchor": "middle"}, short(t)));
  for (const e of logarithmicTicks(...range.e)) svg.append(el("line", {class: "grid", x1: margin.left, x2: width - margin.right, y1: y(e), y2: y(e)}), el("text", {x: margin.left - 6, y: y(e) + 4, "text-anchor": "end"}, short(e) + " %"));
  svg.append(el("text", {x: (margin.left + width - margin.right) / 2, y: height - 4, "text-anchor": "middle"}, "seconds"));
  members.forEach((index, k) => {
    const points = data.candidates[index].curve.filter((p) => p.relative_mse && p.relative_mse.median > 0), last = points.at(-1);
    if (!last) return;
    const group = el("g", {"data-curve": data.candidates[index].name, fill: colour(k), stroke: colour(k)});
    const at = (p, name) => `${x(p.seconds).toFixed(1)},${y(Math.max(errorOf(p.relative_mse[name]), range.e[0])).toFixed(1)}`;
    group.append(el("path", {class: "band", stroke: "none", d: "M" + points.map((p) => at(p, "high")).join("L") + "L" + [...points].reverse().map((p) => at(p, "low")).join("L") + "Z"}));
    group.append(el("path", {class: "curve", "stroke-dasharray": k ? "" : "6 3", d: "M" + points.map((p) => at(p, "median")).join("L")}));
    group.append(el("path", {d: mark(k, 3.5), transform: `translate(${x(last.seconds)} ${y(errorOf(last.relative_mse.median))})`, fill: last.at_most ? "var(--panel)" : colour(k), "stroke-width": 1.5}));
    svg.append(group);
  });
  const key = (k, text) => el("span", {}, el("span", {class: "key", style: `background:${colour(k)}`}), text);
  return el("figure", {class: "dial"}, el("figcaption", {}, el("b", {}, sweep.dial), " ", el("span", {class: "keys"}, key(0, sweep.usual_value + ", usual"), sweep.values.map((v, k) => key(k + 1, v.value)))), svg);
}

function dialsTable(holder) {
  const rows = data.dials.flatMap((sweep) => sweep.values.map(({value, candidate, price}) => ({sweep, instead: value, price, candidate: data.candidates[candidate]})));
  sortable(holder, [{head: "dial", value: (r) => r.sweep.dial, cell: (r) => r.sweep.dial},
    {head: "usual", value: (r) => r.sweep.usual_value, cell: (r) => r.sweep.usual_value},
    {head: "instead", value: (r) => r.instead, cell: (r) => r.instead},
    {head: "times as long for the same error", title: "relMSE over that of the usual value, at equal time", value: (r) => r.price?.ratio, cell: (r) => {
      if (!r.price) return el("td", {}, "no pass yet");
      const chip = r.price.told_apart ? el("span", {class: "chip" + (r.price.ratio > 1 ? " warn" : "")}, r.price.ratio > 1 ? "costs" : "saves") : el("span", {class: "chip plain"}, "not told apart");
      return el("td", {}, short(r.price.ratio), chip, el("small", {}, r.price.high === null ? "no error bar" : `${short(r.price.low)} to ${short(r.price.high)}`));
    }},
    {head: `error at ${seconds(data.times.at(-1))}`, value: (r) => r.candidate.at_times.at(-1).relative_mse?.median, cell: (r) => {
      const at = r.candidate.at_times.at(-1);
      return at.relative_mse ? (at.at_most ? "< " : "") + percent(at.relative_mse.median) : "–";
    }},
    {head: "bias of the mean", value: (r) => Math.abs(r.candidate.bias.relative), cell: (r) => [r.candidate.bias.half_width === null ? "unknown" : `${signed(100 * r.candidate.bias.relative)} % ± ${(100 * r.candidate.bias.half_width).toFixed(2)} %`,
      r.candidate.bias.significant ? el("span", {class: "chip warn"}, "biased") : null, r.candidate.unbiased ? null : el("span", {class: "chip plain", title: "not unbiased by design"}, "by design")]}], rows);
}

/** Fills the section, which is hidden in comparisons of all with all. */
function everyDial(section, charts, table) {
  section.hidden = !data.dials;
  if (!data.dials) return;
  const points = data.candidates.flatMap((c) => c.curve.filter((p) => p.relative_mse && p.relative_mse.median > 0)), errors = points.map((p) => errorOf(p.relative_mse.median));
  const last = Math.max(...data.times), range = {t: [Math.min(...points.map((p) => p.seconds), last / 2) / 1.05, last * 1.05], e: [Math.min(...errors) / 1.2, Math.max(...errors) * 1.2]};
  charts.replaceChildren(...data.dials.map((sweep) => dialChart(sweep, range)));
  dialsTable(table);
}
