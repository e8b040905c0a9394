// Puts the page together.
"use strict";
const byId = (id) => document.getElementById(id);

/** What a reader wants to know first. */
function answer() {
  const last = data.times.length - 1, {best, ties} = bestAt(last);
  if (best < 0) return "No method finished a pass in the longest time.";
  if (data.dials) return `What every dial is worth around ${data.candidates[0].name}, whose error after ${seconds(data.times[last])} is ${percent(data.candidates[0].at_times[last].relative_mse?.median)}.`;
  const name = data.candidates[best].name, at = data.candidates[best].at_times[last], error = (at.at_most ? "less than " : "") + percent(at.relative_mse.median), time = seconds(data.times[last]);
  if (data.candidates.length === 1) return `After ${time}, ${name} has an error of ${error}.`;
  if (ties.length) return `After ${time}, ${name} has the lowest median error, ${error}, but the error bars do not tell it apart from ${ties.map((i) => data.candidates[i].name).join(", ")}.`;
  return `After ${time}, ${name} has the lowest error, ${error}.`;
}

function header() {
  const scene = data.scene.file.split("/").slice(-2).join("/"), layer = data.layer === "image" ? "" : `, ${data.layer.replaceAll("_", " ")}`;
  byId("title").textContent = scene + layer;
  document.title = `${scene}: accuracy against time`;
  const devices = [...new Set(data.candidates.map((c) => c.device).filter(Boolean))];
  byId("facts").textContent = [`${data.width} × ${data.height} pixels`, `${data.repeats} ${data.repeats === 1 ? "run" : "runs"} of each`, `reference: ${data.reference.origin}`, ...devices, `Tyndall ${data.version}`].join(" · ");
  byId("warnings").replaceChildren(...data.warnings.map((w) => el("p", {class: "warning"}, w)));
}

/** Follows the system until the reader chooses. */
function themeButton() {
  const root = document.documentElement, system = matchMedia("(prefers-color-scheme: dark)");
  const dark = () => (root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark";
  const show = () => byId("theme").textContent = dark() ? "light page" : "dark page";
  byId("theme").addEventListener("click", () => (root.dataset.theme = dark() ? "light" : "dark", show()));
  system.addEventListener("change", show);
  show();
}

function verdicts() {
  const last = data.times.at(-1), shown = data.verdicts.filter((v) => v.seconds === last);
  byId("verdicts").replaceChildren(...shown.map((v) => el("li", {class: v.significant ? "" : "unsure"}, v.sentence)));
}

header();
themeButton();
byId("answer").textContent = answer();
makeChart(byId("chart"), byId("legend"), byId("live"));
equalTable(byId("equal"));
verdicts();
everyDial(byId("dials-section"), byId("dials"), byId("dials-table"));
numbersTable(byId("numbers"));
layersTable(byId("layers-section"), byId("layers"));
stageBars(byId("stages"));
settings(byId("settings"));
makeViewer(byId("viewer-controls"), byId("split"), byId("scale"), byId("strip"));
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((d) => d.open = true));
