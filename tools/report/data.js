// What src/report/view_data.c writes into a page, read.
import { Vector3 } from "three";

export const element = (id) => document.getElementById(id);

export function bytes(id) {
  const block = element(id);
  return block ? decoded(block.textContent.trim()) : new Uint8Array(0);
}

// Bytes of a base64 text.
export function decoded(base64) {
  const text = atob(base64);
  const out = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) out[i] = text.charCodeAt(i);
  return out;
}

// Null where there is nothing in space.
export function read() {
  const block = element("view-data"), data = block && JSON.parse(block.textContent);
  if (!data) return null;
  data.middle = data.low.map((v, k) => (v + data.high[k]) / 2);
  return data;
}

// Whole numbers 0..steps between the corners of a box, as metres from its middle.
export function places(raw, box, steps, middle) {
  const whole = new Uint16Array(raw.buffer), out = new Float32Array(whole.length);
  for (let i = 0; i < whole.length; ++i) {
    const k = i % 3;
    out[i] = box.low[k] - middle[k] + (box.high[k] - box.low[k]) * whole[i] / steps;
  }
  return out;
}

// Of a place in the world: numbers stay small, however far off the scene lies.
export const from = (data, place) => new Vector3(...place.map((v, k) => v - data.middle[k]));

export const percent = (share) => share === null ? "an unknown share" : (100 * share).toFixed(2) + " %";
export const count = (n) => n.toLocaleString("en");
// five digits, as the page's tables have
export const number = (v) => v === null ? "?" : String(Number(v.toPrecision(5)));
