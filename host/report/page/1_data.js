// The data, numbers as people read them, and images: decoding, tone mapping, maps of errors.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);

/** An element with attributes and children (elements or text); text is never read as markup. */
function el(tag, attributes = {}, ...children) {
  const svg = ["svg", "path", "line", "text", "g"].includes(tag);
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

/** Three significant digits, without an exponent where that stays short; a true minus sign. */
function short(value, digits = 3) {
  if (value === null || value === undefined || !isFinite(value)) return "–";
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(digits - 1).replace("e+", "e") : String(Number(value.toPrecision(digits)));
  return text.replaceAll("-", "−");
}
const signed = (value, digits = 2) => (value > 0 ? "+" : value < 0 ? "−" : "") + Math.abs(value).toFixed(digits);
const errorOf = (relativeMse) => 100 * Math.sqrt(Math.max(relativeMse, 0));
const percent = (relativeMse) => short(errorOf(relativeMse)) + " %";
const seconds = (value) => short(value) + " s";

/** Seven colours that colour-blind readers tell apart; dashes and marks tell more than seven curves apart. */
const colour = (index) => `var(--s${index % 7})`;
const dash = (index) => ["", "7 3", "2 3"][Math.floor(index / 7) % 3];
/** Path of a mark around the origin. */
function mark(index, size = 4.5) {
  const s = size, t = size * 1.2;
  return [
    `M${-s},0a${s},${s} 0 1 0 ${2 * s},0a${s},${s} 0 1 0 ${-2 * s},0Z`, `M${-s},${-s}H${s}V${s}H${-s}Z`, `M0,${-t}L${t},0L0,${t}L${-t},0Z`, `M0,${-t}L${t},${s}H${-t}Z`,
    `M0,${t}L${t},${-s}H${-t}Z`, `M${-s},${-s / 3}H${-s / 3}V${-s}H${s / 3}V${-s / 3}H${s}V${s / 3}H${s / 3}V${s}H${-s / 3}V${s / 3}H${-s}Z`, `M${-t},0L0,${-s}L${t},0L0,${s}Z`,
  ][index % 7];
}

/** Every half-precision number, by its bits. */
const halves = new Float32Array(65536).map((_, bits) => {
  const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, mantissa = bits & 1023;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + mantissa / 1024) : 2 ** -24 * mantissa);
});

/** Radiance, three floats a pixel, out of {uri, exponent}: high bytes above, low bytes below. */
async function decode(image) {
  const picture = new Image();
  picture.src = image.uri;
  await picture.decode();
  const width = picture.width, height = picture.height / 2, values = new Float32Array(3 * width * height), scale = 2 ** image.exponent;
  const context = Object.assign(document.createElement("canvas"), {width, height: 2 * height}).getContext("2d", {willReadFrequently: true, colorSpace: "srgb"});
  context.drawImage(picture, 0, 0);
  const bytes = context.getImageData(0, 0, width, 2 * height).data, low = 4 * width * height;
  for (let i = 0; i < width * height; ++i)
    for (let c = 0; c < 3; ++c) values[3 * i + c] = scale * halves[bytes[4 * i + c] << 8 | bytes[low + 4 * i + c]];
  return {width, height, values};
}

const luminance = (v, i) => .2126 * v[i] + .7152 * v[i + 1] + .0722 * v[i + 2];

/** Stops that bring the 95th percentile of the lit pixels to .7, as the renderer's own pictures. */
function automaticExposure(image) {
  const lit = [];
  for (let i = 0; i < image.values.length; i += 3) if (luminance(image.values, i) > 0) lit.push(luminance(image.values, i));
  lit.sort((a, b) => a - b);
  return lit.length ? Math.log2(.7 / lit[Math.floor(.95 * (lit.length - 1))]) : 0;
}

/** The renderer's tone curve: linear to .8, a soft shoulder, sRGB. Looked up by the square root of the value, up to 4. */
const toneSteps = 4096, toneTable = new Uint8ClampedArray(toneSteps + 1).map((_, i) => {
  const v = (2 * i / toneSteps) ** 2, s = v <= .8 ? v : .8 + .2 * -Math.expm1(-(v - .8) / .2);
  return Math.round(255 * (s <= .0031308 ? 12.92 * s : 1.055 * s ** (1 / 2.4) - .055));
});

const relativeStops = [[0, 34, 78], [53, 69, 108], [102, 105, 112], [148, 142, 119], [200, 184, 102], [254, 232, 56]];
const signedStops = [[0, 62, 126], [58, 134, 196], [160, 200, 228], [244, 243, 240], [244, 190, 130], [214, 112, 22], [128, 58, 0]];
/** Colour of t in [0, 1] between stops. */
function between(stops, t) {
  const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1), i = Math.min(Math.floor(at), stops.length - 2), share = at - i;
  return stops[i].map((c, k) => c + share * (stops[i + 1][k] - c));
}
const gradient = (stops) => `linear-gradient(90deg, ${stops.map((s) => `rgb(${s.join(" ")})`).join(", ")})`;

/** 8-bit pixels of an image, of its signed difference or of its relative error, against a reference; `range` is a share. */
function pixelsOf(image, reference, mode, exposure, range, meanOfReference) {
  const result = new ImageData(image.width, image.height), out = result.data, v = image.values, r = reference.values;
  const scale = 2 ** exposure, epsilon = (.05 * meanOfReference) ** 2;
  for (let i = 0, o = 0; i < v.length; i += 3, o += 4) {
    if (mode === "image") {
      for (let c = 0; c < 3; ++c) out[o + c] = v[i + c] > 0 ? toneTable[Math.min(Math.sqrt(scale * v[i + c]) * toneSteps / 2, toneSteps) + .5 | 0] : 0;
    } else {
      let sum = 0;
      for (let c = 0; c < 3; ++c) {
        const difference = v[i + c] - r[i + c];
        sum += mode === "difference" ? difference / (3 * meanOfReference) : difference * difference / (3 * (r[i + c] * r[i + c] + epsilon));
      }
      const rgb = mode === "difference" ? between(signedStops, .5 + .5 * sum / range) : between(relativeStops, Math.sqrt(sum) / range);
      out[o] = rgb[0], out[o + 1] = rgb[1], out[o + 2] = rgb[2];
    }
    out[o + 3] = 255;
  }
  return result;
}

/** Deviates of the blocks of 8 x 8 pixels, as colours from -blockRange to blockRange; no deviates: nothing differs. */
const blockRange = 6;
function blockPixels(image, z) {
  const result = new ImageData(image.width, image.height), columns = Math.floor(image.width / 8), rows = Math.floor(image.height / 8);
  for (let y = 0, o = 0; y < image.height; ++y)
    for (let x = 0; x < image.width; ++x, o += 4) {
      const inside = x < 8 * columns && y < 8 * rows, block = z ? z[Math.floor(y / 8) * columns + Math.floor(x / 8)] : 0;
      const rgb = !inside || block === null ? [128, 128, 128] : between(signedStops, .5 + .5 * block / blockRange);
      result.data.set([...rgb, 255], o);
    }
  return result;
}
