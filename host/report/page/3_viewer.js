// Images side by side: a split that is dragged, the same window of every image, exposure, maps of the error.
"use strict";
async function makeViewer(controls, holder, scaleHolder, strip) {
  const reference = await decode(data.reference.image), last = data.times.length - 1;
  const mean = data.reference.mean, aspect = reference.width / reference.height;
  const base = automaticExposure(reference);
  const largest = Math.max(...data.candidates.map((c) => Math.sqrt(c.snapshots[last].relative_mse ?? 0)), .01);
  const state = {left: "0", right: data.candidates.length > 1 ? "1" : "reference", time: last, layer: "image", mode: "image", exposure: 0, range: Math.min(Math.max(2 * largest, .005), 4), zoom: 1, x: .5, y: .5, split: .5};
  const decoded = new Map([["reference image", reference]]), toned = new Map();

  /** What `who` ("reference" or a candidate's number) shows in a layer: encoded image, or nothing. */
  function source(who, layer, time) {
    const from = who === "reference" ? data.reference : data.candidates[who];
    if (layer !== "image") return from.layer_images?.[layer];
    return who === "reference" ? from.image : from.snapshots[time].image;
  }
  const keyOf = (who, layer, time) => who === "reference" || layer !== "image" ? `${who} ${layer}` : `${who} ${layer} ${time}`;

  async function imageOf(who, layer, time) {
    const key = keyOf(who, layer, time), encoded = source(who, layer, time);
    if (!encoded) return null;
    if (!decoded.has(key)) decoded.set(key, await decode(encoded));
    return decoded.get(key);
  }

  /** A canvas with the image's pixels as the controls ask; made anew only when they change. */
  async function picture(who, layer, time) {
    const image = await imageOf(who, layer, time), against = await imageOf("reference", layer, 0);
    const mode = against ? state.mode : "image", stamp = [mode, state.exposure, state.range].join(" "), key = keyOf(who, layer, time);
    if (!image) return null;
    if (toned.get(key)?.stamp !== stamp) {
      const canvas = toned.get(key)?.canvas ?? Object.assign(document.createElement("canvas"), {width: image.width, height: image.height});
      const pixels = mode === "blocks" ? blockPixels(image, data.candidates[who]?.bias.block_z) : pixelsOf(image, against ?? image, mode, base + state.exposure, state.range, layerMean(layer));
      canvas.getContext("2d").putImageData(pixels, 0, 0);
      toned.set(key, {stamp, canvas});
    }
    return toned.get(key).canvas;
  }
  const means = new Map([["image", mean]]);
  function layerMean(layer) {
    if (!means.has(layer)) {
      const v = decoded.get(`reference ${layer}`)?.values ?? reference.values;
      means.set(layer, v.reduce((sum, value) => sum + value, 0) / v.length || 1e-30);
    }
    return means.get(layer);
  }

  /** The window of the image that every canvas shows, as shares of the image. */
  function paint(canvas, image, from = 0, to = 1) {
    const width = Math.max(Math.round(canvas.clientWidth * devicePixelRatio), 1), height = Math.round(width / aspect), context = canvas.getContext("2d");
    if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
    const scale = state.zoom * width / reference.width, left = width / 2 - state.x * reference.width * scale, top = height / 2 - state.y * reference.height * scale;
    context.save();
    context.beginPath(), context.rect(from * width, 0, (to - from) * width, height), context.clip();
    context.imageSmoothingEnabled = scale < 1;
    if (image) context.drawImage(image, left, top, reference.width * scale, reference.height * scale);
    else context.fillStyle = "#333", context.fillRect(0, 0, width, height);
    context.restore();
  }

  const nameOf = (who) => who === "reference" ? "reference" : data.candidates[who].name;
  const canvas = el("canvas", {tabindex: 0, role: "img", "aria-label": "Two images, split. Arrow keys move the window, plus and minus zoom, 0 shows all."});
  const handle = el("div", {class: "handle", role: "slider", tabindex: 0, "aria-label": "Split between left and right image", "aria-valuemin": 0, "aria-valuemax": 100, "aria-valuenow": 50});
  const tagA = el("div", {class: "tag a"}), tagB = el("div", {class: "tag b"});
  holder.replaceChildren(canvas, tagA, tagB, handle);

  let pending = false;
  function refresh() {
    if (pending) return;
    pending = true;
    requestAnimationFrame(async () => {
      pending = false;
      const margin = .5 / state.zoom;
      state.x = Math.min(Math.max(state.x, margin), 1 - margin), state.y = Math.min(Math.max(state.y, margin), 1 - margin);
      const a = await picture(state.left, state.layer, state.time), b = await picture(state.right, state.layer, state.time);
      paint(canvas, a, 0, state.split), paint(canvas, b, state.split, 1);
      handle.style.left = 100 * state.split + "%";
      handle.setAttribute("aria-valuenow", Math.round(100 * state.split));
      tagA.textContent = nameOf(state.left), tagB.textContent = nameOf(state.right);
      tagA.hidden = state.split < .12, tagB.hidden = state.split > .88;
      for (const cell of strip.querySelectorAll("canvas")) paint(cell, await picture(cell.dataset.who, state.layer, Number(cell.dataset.time)));
      showScale();
      holder.dataset.ready = "true", holder.dataset.split = state.split.toFixed(3), holder.dataset.zoom = state.zoom;
    });
  }

  function showScale() {
    const range = short(100 * state.range, 2);
    if (state.mode === "image") scaleHolder.replaceChildren(`Tone-mapped, exposure ${signed(base + state.exposure, 1)} stops. Every image has the same.`);
    else if (state.mode === "difference") scaleHolder.replaceChildren(`−${range} %`, el("i", {style: `background:${gradient(signedStops)}`}), `+${range} %`, el("span", {}, "of the reference's mean; white: none"));
    else if (state.mode === "blocks") scaleHolder.replaceChildren(`z −${blockRange}`, el("i", {style: `background:${gradient(signedStops)}`}), `+${blockRange}`,
      el("span", {}, "of blocks of 8 × 8 pixels, whole comparison, all passes of all runs; grey: too dark"));
    else scaleHolder.replaceChildren("0", el("i", {style: `background:${gradient(relativeStops)}`}), `${range} %`, el("span", {}, "root of the pixel's own relMSE"));
  }

  const set = (change) => (Object.assign(state, change), refresh());
  const zoomAt = (factor, x = state.x, y = state.y) => {
    const zoom = Math.min(Math.max(state.zoom * factor, 1), 32), share = state.zoom / zoom;
    set({zoom, x: x + (state.x - x) * share, y: y + (state.y - y) * share});
    canvas.style.touchAction = zoom > 1 ? "none" : "pan-y";
  };
  const setSplit = (split) => set({split: Math.min(Math.max(split, 0), 1)});

  handle.addEventListener("pointerdown", (event) => handle.setPointerCapture(event.pointerId));
  handle.addEventListener("pointermove", (event) => {
    const box = holder.getBoundingClientRect();
    if (handle.hasPointerCapture(event.pointerId)) setSplit((event.clientX - box.left) / box.width);
  });
  handle.addEventListener("keydown", (event) => {
    const to = {ArrowLeft: state.split - .02, ArrowRight: state.split + .02, Home: 0, End: 1}[event.key];
    if (to !== undefined) event.preventDefault(), setSplit(to);
  });
  canvas.addEventListener("pointerdown", (event) => state.zoom > 1 && canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    const box = canvas.getBoundingClientRect();
    set({x: state.x - event.movementX / box.width / state.zoom, y: state.y - event.movementY / box.height / state.zoom});
  });
  canvas.addEventListener("dblclick", (event) => {
    const box = canvas.getBoundingClientRect();
    zoomAt(2, state.x + ((event.clientX - box.left) / box.width - .5) / state.zoom, state.y + ((event.clientY - box.top) / box.height - .5) / state.zoom);
  });
  canvas.addEventListener("wheel", (event) => event.ctrlKey && (event.preventDefault(), zoomAt(event.deltaY < 0 ? 1.25 : .8)), {passive: false});
  canvas.addEventListener("keydown", (event) => {
    const step = .1 / state.zoom, move = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]}[event.key];
    if (move && state.zoom > 1) event.preventDefault(), set({x: state.x + move[0], y: state.y + move[1]});
    else if (event.key === "+" || event.key === "=") zoomAt(2);
    else if (event.key === "-") zoomAt(.5);
    else if (event.key === "0") set({zoom: 1, x: .5, y: .5});
  });
  new ResizeObserver(refresh).observe(holder);
  addEventListener("beforeprint", refresh);
  makeViewerControls(controls, state, set, zoomAt);
  makeStrip(strip, set, controls);
  refresh();
}

function makeViewerControls(controls, state, set, zoomAt) {
  const whos = [...data.candidates.map((c, i) => [String(i), c.name]), ["reference", "reference"]];
  const choice = (label, id, options, name, read = (v) => v) => el("label", {}, label, el("select", {id, onchange: (event) => set({[name]: read(event.target.value)})},
    options.map(([value, text]) => el("option", {value, selected: String(state[name]) === value}, text))));
  const slider = (label, id, low, high, step, value, text, change) => {
    const output = el("output", {}, text(value));
    return el("label", {}, el("span", {}, label + " ", output), el("input", {id, type: "range", min: low, max: high, step, value, oninput: (event) => {
      output.textContent = text(Number(event.target.value));
      change(Number(event.target.value));
    }}));
  };
  const layers = Object.keys(data.reference.layer_images ?? {});
  controls.replaceChildren(
    choice("left", "left", whos, "left"), choice("right", "right", whos, "right"),
    choice("time", "time", data.times.map((t, i) => [String(i), seconds(t)]), "time", Number),
    layers.length ? choice("layer", "layer", [["image", data.layer === "image" ? "whole image" : data.layer], ...layers.map((l) => [l, l.replaceAll("_", " ")])], "layer") : null,
    choice("show", "mode", [["image", "image"], ["difference", "signed difference"], ["relative", "relative error"], ["blocks", "bias of blocks"]], "mode"),
    slider("exposure", "exposure", -6, 6, .1, 0, (v) => signed(v, 1), (exposure) => set({exposure})),
    slider("range of maps", "range", -7.6, 2, .1, Math.log2(state.range), (v) => short(100 * 2 ** v, 2) + " %", (v) => set({range: 2 ** v})),
    el("div", {class: "group"}, "zoom", el("div", {class: "buttons"},
      el("button", {type: "button", "aria-label": "zoom out", onclick: () => zoomAt(.5)}, "−"), el("button", {type: "button", "aria-label": "zoom in", onclick: () => zoomAt(2)}, "+"),
      el("button", {type: "button", onclick: () => set({zoom: 1, x: .5, y: .5})}, "all"))));
}

/** A row for every candidate, a column for every time, the reference below. */
function makeStrip(strip, set, controls) {
  const choose = (side, who, time) => {
    set({[side]: who, time});
    controls.querySelector("#" + side).value = who, controls.querySelector("#time").value = time;
    document.getElementById("viewer-controls").scrollIntoView({block: "nearest", behavior: "smooth"});
  };
  const cell = (who, time, caption) => el("td", {}, el("figure", {}, el("canvas", {"data-who": who, "data-time": time, onclick: () => choose("right", who, time)}), el("figcaption", {}, caption),
    el("div", {class: "sides"}, ["left", "right"].map((side) => el("button", {type: "button", onclick: () => choose(side, who, time)}, side)))));
  const rows = data.candidates.map((c, i) => el("tr", {}, c.snapshots.map((s, t) => cell(String(i), t,
    [el("b", {}, el("span", {class: "key", style: `background:${colour(i)}`}), c.name), el("br"), `${seconds(s.seconds)}, ${s.passes} ${s.passes === 1 ? "pass" : "passes"}, error ${percent(s.relative_mse)}`]))));
  rows.push(el("tr", {}, cell("reference", data.times.length - 1, [el("b", {}, "reference"), el("br"), data.reference.origin])));
  strip.replaceChildren(el("table", {}, el("thead", {}, el("tr", {}, data.times.map((t) => el("th", {}, `for ${seconds(t)}`)))), el("tbody", {}, rows)));
}
