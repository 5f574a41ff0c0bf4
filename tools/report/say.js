// What the view says in words: its colours, and what is picked.
import { Color } from "three";
import { count, number, percent } from "./data.js";
import { cloudShare } from "./media.js";
import { distant, residualColor } from "./parts.js";
import { COLORS } from "./photons.js";

function entry(color, text) {
  const item = document.createElement("span"), chip = document.createElement("i");
  chip.style.background = `#${new Color(color).getHexString()}`;
  item.append(chip, text);
  return item;
}

const share = (n, all) => all > 0 ? ` (${(100 * n / all).toFixed(1)} %)` : "";

function photonEntries(photons, picked) {
  const { counts, n } = photons, out = [];
  const add = (kind, text) => out.push(entry(COLORS[kind], `${text}: ${count(counts[kind])}${share(counts[kind], n)}`));
  if (n === 0) return out;
  if (photons.sensors === 0) add("stored", "stored photon");
  else if (photons.knows(picked)) {
    add("alone", `photon that sensor ${picked + 1} alone sees`);
    add("shared", "that others see as well");
    add("other", "that it does not see");
  } else {
    add("none", "photon that no sensor sees");
    add("one", "that one sees");
    add("more", "that two or more see");
  }
  return out;
}

export function sayKey(box, data, state, photons, picked, medium, hidden) {
  const out = photonEntries(photons, picked);
  if (state.sensors.length > 0) out.push(entry(0xffd400, "sensor, and how far and where it sees"));
  if (!hidden.has("lamps")) {
    const kinds = [...data.lamps.filter((lamp) => !lamp.distant).map(() => "lamp"), ...distant(data).map(({ lamp }) => lamp.type)];
    for (const kind of new Set(kinds)) out.push(entry(0xfff3c4, kind));
  }
  if (data.path.length > 0) out.push(entry(0xff8ad8, "the path"));
  if (data.readings.length > 0) {
    out.push(entry(residualColor(3), "reading 3 standard errors or more above the model"),
      entry(residualColor(0), "as the model says"), entry(residualColor(-3), "as much below it"));
  }
  if (medium.there && !hidden.has("cloud")) {
    const share = cloudShare(medium);
    out.push(entry(0xccd6e6, share < 1
      ? `media, drawn ${(1 / share).toFixed(1)} times thinner than they are` : "media, as they dim what is behind"));
  }
  if (medium.there && !hidden.has("level")) out.push(entry(0xc9a6ff, "where the extinction has the value that is set"));
  box.replaceChildren(...out);
}

// In the user's coordinates.
const place = (data, at) => at.map((v, k) => (v + data.origin[k]).toFixed(2)).join(", ");

function aim(sensor) {
  if (sensor.heading_deg === null) return "";
  return `, looking to ${number(sensor.heading_deg)}° from north${sensor.tilt_deg ? `, tilted ${number(sensor.tilt_deg)}°` : ""}`;
}

function reach(sensor) {
  if (sensor.range_m === null) return " Its range has no limit; it is drawn short.";
  const least = sensor.least_range_m > 0 ? `${number(sensor.least_range_m)} to ` : "";
  return ` Its range is ${least}${number(sensor.range_m)} m.`;
}

export function sayPicked(data, state, photons, picked) {
  if (picked < 0) {
    return state.sensors.length > 0 ? "Pick a sensor, in the view or in the list, to see what it sees."
      : data.readings.length > 0 ? "Pick a reading to see its numbers." : "";
  }
  const sensor = state.sensors[picked];
  const light = sensor.covers === null ? "" : ` sees ${percent(sensor.covers)} of the light, each photon counted by how clearly; ` +
    `${percent(sensor.only)} is seen by no other`;
  const seen = photons.counts.alone + photons.counts.shared;
  const dots = photons.n === 0 ? "" : photons.knows(picked)
    ? ` Of the ${count(photons.n)} photons drawn it sees ${count(seen)}, ${count(photons.counts.alone)} of them alone.`
    : " Which photons it sees is known of the first 32 sensors only.";
  return `Sensor ${picked + 1} (${sensor.type}) at ${place(data, sensor.place)} m${aim(sensor)}${light}.${dots}${reach(sensor)}`;
}

export function sayReading(data, r) {
  const where = r.condition ? `, ${r.condition}` : "", use = r.held_out ? "held out" : "fitted";
  const off = r.residual === null ? "" : `, so the reading is ${number(Math.abs(r.residual))} standard errors ${r.residual > 0 ? "above" : "below"} it`;
  return `Reading of line ${number(r.line)} (${r.kind}${where}, ${use}) at ${place(data, r.place)} m: measured ${number(r.value)} ± ` +
    `${number(r.standard_error)} ${r.unit}; the model says ${number(r.predicted)}${off}.`;
}
