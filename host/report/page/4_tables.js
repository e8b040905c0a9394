// Tables that sort, bars of the stages, the settings to repeat it.
"use strict";
/** columns: {head, title, value(row) (a number or text to sort by), cell(row) (what is shown)}. */
function sortable(holder, columns, rows) {
  let by = null, down = false;
  const body = el("tbody");
  const heads = columns.map((column, k) => el("th", {scope: "col", title: column.title, "aria-sort": "none"}, el("button", {type: "button", onclick: () => {
    down = by === k && !down, by = k;
    fill();
  }}, column.head)));
  function fill() {
    const order = [...rows];
    if (by !== null) order.sort((a, b) => {
      const [x, y] = [columns[by].value(a), columns[by].value(b)];
      if (x === null || y === null || x === undefined || y === undefined) return (x ?? null) === null ? ((y ?? null) === null ? 0 : 1) : -1;
      return (typeof x === "string" ? x.localeCompare(y) : x - y) * (down ? -1 : 1);
    });
    heads.forEach((head, k) => head.setAttribute("aria-sort", k !== by ? "none" : down ? "descending" : "ascending"));
    body.replaceChildren(...order.map((row) => el("tr", {}, columns.map((column) => {
      const shown = column.cell(row);
      return shown instanceof HTMLTableCellElement ? shown : el("td", {}, shown);
    }))));
  }
  fill();
  holder.replaceChildren(el("table", {}, el("thead", {}, el("tr", {}, heads)), body));
}

const named = (c) => el("span", {}, el("span", {class: "key", style: `background:${colour(data.candidates.indexOf(c))}`}), c.name);
const duration = (s) => s === 0 ? "–" : s < .9995 ? short(1000 * s) + " ms" : short(s) + " s";
const withSpread = (s, shown = short) => s ? [shown(s.median), el("small", {}, `${shown(s.low)} to ${shown(s.high)}`)] : "–";
const nameColumn = {head: "method", value: (c) => c.name, cell: named};

/** At one time: the candidate with the lowest error, and who is not told apart from it. */
function bestAt(t) {
  const known = data.candidates.map((c, i) => ({i, at: c.at_times[t]})).filter((k) => k.at.relative_mse);
  if (!known.length) return {best: -1, ties: []};
  const best = known.reduce((a, b) => b.at.relative_mse.median < a.at.relative_mse.median ? b : a).i;
  if (data.dials) return {best, ties: known.map((k) => k.i).filter((i) => i !== best)};  // only pairs with the usual value were asked about
  const unsure = data.verdicts.filter((v) => v.seconds === data.times[t] && !v.significant);
  return {best, ties: known.map((k) => k.i).filter((i) => i !== best && unsure.some((v) => [v.better, v.worse].includes(i) && [v.better, v.worse].includes(best)))};
}

function equalTable(holder) {
  const errors = data.times.map((time, t) => {
    const {best, ties} = bestAt(t);
    return {head: `error at ${seconds(time)}`, value: (c) => c.at_times[t].relative_mse?.median, cell: (c) => {
      const at = c.at_times[t], i = data.candidates.indexOf(c), alone = i === best && !ties.length && data.candidates.length > 1;
      if (!at.relative_mse) return el("td", {}, "no pass yet");
      const chip = data.dials ? null : alone ? el("span", {class: "chip"}, "lowest") : i === best || ties.includes(i) ? (data.candidates.length > 1 ? el("span", {class: "chip plain", title: "not told apart from the lowest"}, "≈ lowest") : null) : null;
      return el("td", {class: alone ? "best" : ""}, (at.at_most ? "< " : "") + percent(at.relative_mse.median), chip, el("small", {}, `${percent(at.relative_mse.low)} to ${percent(at.relative_mse.high)}`));
    }};
  });
  sortable(holder, [nameColumn, ...errors,
    {head: "bias of the mean", value: (c) => Math.abs(c.bias.relative), cell: (c) => [c.bias.half_width === null ? "unknown" : `${signed(100 * c.bias.relative)} % ± ${(100 * c.bias.half_width).toFixed(2)} %`,
      c.bias.significant ? el("span", {class: "chip warn"}, "biased") : null, c.unbiased ? null : el("span", {class: "chip plain", title: "this method is not unbiased by design"}, "by design")]},
    {head: "outliers", value: (c) => c.outliers.share_of_largest, cell: (c) => c.outliers.runs ? el("span", {class: "chip warn", title: `worst at pixel (${c.outliers.x}, ${c.outliers.y})`}, `in ${c.outliers.runs} of ${data.repeats}`) : "none"}],
  data.candidates);
}

function numbersTable(holder) {
  const spreadColumn = (head, title, name, shown) => ({head, title, value: (c) => c[name]?.median, cell: (c) => el("td", {}, withSpread(c[name], shown))});
  sortable(holder, [nameColumn,
    spreadColumn("relMSE at the end", "as measured, the reference's noise included", "relative_mse"),
    spreadColumn("trimmed", "without the largest thousandth of the terms", "trimmed_relative_mse"),
    spreadColumn("RMSE", "in radiance", "rmse"),
    {head: "z of the bias", value: (c) => c.bias.z, cell: (c) => short(c.bias.z)},
    {head: "largest block z", title: "of the 8 × 8 blocks, each on its own", value: (c) => Math.abs(c.bias.largest_block_z), cell: (c) => el("td", {}, short(c.bias.largest_block_z), el("small", {}, `of ${c.bias.lit_blocks}`))},
    {head: "largest .1 % hold", title: "share of the squared error", value: (c) => c.outliers.share_of_largest, cell: (c) => short(100 * c.outliers.share_of_largest) + " %"},
    spreadColumn("slope", "of log error over log passes; −.5 is what independent passes give", "slope"),
    spreadColumn("efficiency", "1 / (relMSE × seconds)", "efficiency"),
    spreadColumn("s per pass", "", "seconds_per_pass")], data.candidates);
}

function layersTable(section, holder) {
  const names = [...new Set(data.candidates.flatMap((c) => c.layers.map((l) => l.layer)))];
  section.hidden = names.length < 2;
  const columns = [{head: "layer", value: (n) => n, cell: (n) => n.replaceAll("_", " ")}, ...data.candidates.map((c) => {
    const of = (n) => c.layers.find((l) => l.layer === n);
    return {head: c.name, value: (n) => of(n)?.relative_mse, cell: (n) => {
      const l = of(n), floor = l?.floor ?? 0;
      if (!l || l.relative_mse === null) return "–";
      return l.relative_mse < 2 * floor ? "< " + percent(l.relative_mse) : percent(l.relative_mse - floor);
    }};
  })];
  sortable(holder, columns, names);
}

function stageBars(holder) {
  const used = data.candidates[0]?.stages.map((s) => s.stage).filter((stage) => data.candidates.some((c) => c.stages.find((s) => s.stage === stage)?.seconds > 0)) ?? [];
  const palette = ["#6b7075", "#1f6f9f", "#b0518a", "#a94a00", "#00735a", "#86650c", "#4d4d4d"], tint = (stage) => palette[used.indexOf(stage) % palette.length];
  const bars = data.candidates.map((c) => {
    const total = c.stages.reduce((sum, s) => sum + s.seconds, 0) || 1;
    return el("div", {}, named(c), el("div", {class: "bar", role: "img", "aria-label": c.stages.filter((s) => s.seconds > 0).map((s) => `${s.stage} ${Math.round(100 * s.seconds / total)} %`).join(", ")},
      c.stages.filter((s) => s.seconds > 0).map((s) => el("span", {style: `width:${100 * s.seconds / total}%;background:${tint(s.stage)}`, title: `${s.stage}: ${short(100 * s.seconds / total)} %`}, s.seconds > .08 * total ? s.stage : ""))));
  });
  const table = el("div", {class: "scroll"});
  sortable(table, [nameColumn, ...used.map((stage) => ({head: stage, value: (c) => c.stages.find((s) => s.stage === stage).seconds, cell: (c) => {
    const passes = c.runs.reduce((sum, r) => sum + r.passes, 0), own = c.stages.find((s) => s.stage === stage).seconds;
    return duration(own / (stage === "prepare" ? c.runs.length : passes));
  }}))], data.candidates);
  holder.replaceChildren(el("div", {class: "bars"}, bars), table, el("p", {class: "note"}, "Shares of all runs; the table has prepare per run, everything else per pass. Stages that overlap in time are counted each."));
}

function settings(holder) {
  const copy = (text) => el("button", {type: "button", class: "quiet", onclick: async (event) => {
    await navigator.clipboard?.writeText(text);
    event.target.textContent = "copied";
  }}, "copy");
  const block = (title, text) => [el("h3", {}, title, " ", copy(text)), el("pre", {tabindex: 0}, text)];
  holder.replaceChildren(...block("This comparison", data.command), ...data.candidates.flatMap((c) => block(c.name, c.render_command)),
    el("p", {class: "note"}, "Seeds: ", data.candidates.map((c) => `${c.name} ${c.runs.map((r) => r.seed).join(", ")}`).join("; "), `. Reference: ${data.reference.origin}.`));
}
