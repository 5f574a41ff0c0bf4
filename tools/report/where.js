// The section of places: what the view in space needs round its canvas, and the scene from above and from the side
// as drawings: photons as dots, sensors as numbered discs, their ranges as dashed rings.
import { bytes, decoded } from "./data.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";

const WIDTH = 640, TALLEST = 800, MARGIN = 24, SCALE_BAR = 26; // of a drawing; under it
const DOTS_MAX = 4000, NUMBERED_MAX = 99; // photons that are drawn; sensors that have numbers
const STEPS_MAX = 12; // of a timeline that are drawn one beside the other
const LEAST_M = 1; // that a drawing shows
const STEPS = 65535; // of a place between the corners of its box

// ---- what there is ----

const pointName = (data) => data.targets ? "target" : "stored photon";
const any = (data, test) => data.states.some(test);
const onSurfaces = (state) => state.surface_photons > 0, inVolume = (state) => state.photons > state.surface_photons;
const hasSensors = (data) => any(data, (state) => state.sensors.length > 0);
const hasSurfaces = (data) => data.mesh !== undefined || data.balls.length > 0;

// ---- the view's controls ----

const toggle = (value, text, isOn = true) => html`<label><input type="checkbox" value="${value}"${isOn ? html` checked` : nothing}> ${text}</label>
`;

function switches(data) {
  const there = data.media.filter((m) => m.there), of = data.targets ? "targets" : "photons";
  // an even medium says little beside what else there is
  const isAll = !hasSurfaces(data) && !any(data, (state) => state.photons > 0);
  return html`<fieldset class="switches"><legend>Shown</legend>
${hasSurfaces(data) ? toggle("surfaces", "surfaces") : nothing}${
    any(data, onSurfaces) ? toggle("surface-photons", `${of} on surfaces`) : nothing}${
    any(data, inVolume) ? toggle("volume-photons", `${of} in ${data.targets ? "the volume" : "media"}`) : nothing}${
    hasSensors(data) ? html`${toggle("sensors", "sensors")}${toggle("ranges", "ranges and views")}` : nothing}${
    data.has_lamps ? toggle("lamps", "lamps and sun") : nothing}${data.path.length > 0 ? toggle("path", "the path") : nothing}${
    data.readings.length > 0 ? toggle("readings", "readings") : nothing}${toggle("axes", "axes in metres")}${there.length > 0
    ? html`${toggle("cloud", "media as a cloud", isAll || there.some((m) => !m.even))}${
      toggle("level", "media where their extinction is", false)}<label><input type="range" aria-label="extinction" id="view-level" min="2" max="98" step="2" value="50"> <output id="view-level-said"></output></label>
` : nothing}</fieldset>
`;
}

const choices = (data) => html`<div class="switches">
${data.states.length > 1 ? html`<label>shown for <select id="view-state">${data.states.map((state, i) =>
    html`<option value="${i}">${state.name}</option>`)}</select></label>
` : nothing}${hasSensors(data) ? html`<label>picked sensor <select id="view-sensor"></select></label>
` : nothing}<button type="button" value="corner">from a corner</button>
<button type="button" value="above">from above</button>
<button type="button" value="side">from the side</button>
<button type="button" value="nearer" aria-label="nearer">+</button>
<button type="button" value="farther" aria-label="farther">−</button>
</div>
`;

function notes(data) {
  const sum = (key) => data.states.reduce((n, state) => n + state[key], 0), stored = sum("stored"), shown = sum("photons");
  const most = Math.max(0, ...data.media.map((m) => m.most_per_m)), several = data.states.length > 1;
  return html`<p class="note">${shown < stored
    ? `Of ${stored} ${pointName(data)}s${several ? " of all conditions" : ""} ${shown} are here, evenly chosen. ` : ""}${
    data.states.length < data.states_asked ? data.follow ? `${data.states.length} of ${data.states_asked} steps can be chosen. `
      : `The first ${data.states.length} of ${data.states_asked} plans can be chosen. ` : ""}${
    data.mesh?.coarse ? `Of ${data.mesh.asked} triangles ${data.mesh.triangles} are shown: surfaces are coarser here than in the simulation. ` : ""}${
    most > 0 ? `Media: extinction in the first band, at most ${format.number(most)} per m; cells are coarser than in the simulation. ` : ""}${
    hasSensors(data) && data.periodic
      ? "The scene repeats at its sides in x and y: what a sensor sees across a side is drawn where it lies in here. " : ""}${
    data.study ? "Surfaces, lamps and media are those of the study's base scene. " : ""}${
    data.follow ? "Sensors, photons and media are those of each step, surfaces and lamps those of the first. " : ""}<span class="interactive">Drag to turn, scroll to go nearer, with two fingers or the right button to move. With the picture in focus: arrow keys turn, + and − go nearer and away${
    hasSensors(data) ? ", N and P pick the next and previous sensor, Escape none" : ""}.</span></p>
`;
}

const view = (data) => html`<div id="view">
<div class="interactive">
${choices(data)}${switches(data)}</div>
<canvas id="view-canvas" tabindex="0" role="img" aria-label="The scene in space; the drawings and tables say the same"></canvas>
<p class="legend" id="view-key"></p>
<p class="picked" id="view-picked" role="status"></p>
${notes(data)}</div>
`;

// ---- drawings ----

// Places of the first state's photons that are drawn, in the scene's own coordinates.
function dotsOf(data) {
  const [state] = data.states, whole = new Uint16Array(bytes("photon-places-0").buffer), seen = bytes("photon-seen-0");
  const step = Math.floor(state.photons / DOTS_MAX) + 1, first = state.sensors.length > 0 ? 0 : 1; // 1: nobody looked
  return Array.from({ length: Math.ceil(state.photons / step) }, (_, i) => i * step).map((i) => ({
    place: [0, 1, 2].map((k) => state.low[k] + (state.high[k] - state.low[k]) * whole[3 * i + k] / STEPS),
    seen: Math.min(seen[i] + (seen[i] > 2 ? 0 : first), 2),
  }));
}

// A projection onto two axes that holds all photons, sensors and the domain, if it is known; null where there is
// nothing to draw.
function projection(data, axes) {
  const [state] = data.states, corners = [...(state.photons > 0 ? [state.low, state.high] : []),
    ...state.sensors.map((s) => s.place), ...(data.domain ? [data.domain.low, data.domain.high] : [])];
  const [[left, right], [bottom, top]] = axes.map((k) => [Math.min, Math.max].map((f) => f(...corners.map((c) => c[k]))));
  const wide = right - left, tall = top - bottom, room = Math.max(wide, tall, LEAST_M);
  if (state.photons + state.sensors.length === 0 || !(wide >= 0 && wide < Infinity && tall < Infinity)) return null;
  const scale = Math.min((WIDTH - 2 * MARGIN) / Math.max(wide, 1e-3 * room), (TALLEST - 2 * MARGIN) / Math.max(tall, 1e-3 * room), WIDTH / room);
  const height = 2 * MARGIN + tall * scale, begin = left - ((WIDTH - 2 * MARGIN) / scale - wide) / 2;
  return { scale, height, x: (place) => MARGIN + (place[axes[0]] - begin) * scale, y: (place) => height - MARGIN - (place[axes[1]] - bottom) * scale };
}

const d1 = (value) => value.toFixed(1);

function drawSensors(p, sensors) {
  const isNumbered = sensors.length <= NUMBERED_MAX, at = sensors.map((s) => [d1(p.x(s.place)), d1(p.y(s.place)), (s.range_m ?? 0) * p.scale]);
  return html`${at.map(([x, y, range]) => isNumbered && range > 0 && range < 4 * WIDTH
    ? html`<circle class="range" cx="${x}" cy="${y}" r="${d1(range)}"/>
` : nothing)}${at.map(([x, y], i) => html`<circle class="sensor" cx="${x}" cy="${y}" r="${isNumbered ? 10 : 4}"/>${isNumbered
    ? html`<text class="number" x="${x}" y="${d1(Number(y) + 4.5)}" text-anchor="middle">${i + 1}</text>` : nothing}
`)}`;
}

// 1, 2 or 5 times a power of ten metres, about a fifth of the picture.
function drawScale(p) {
  const rough = WIDTH / 5 / p.scale, ten = 10 ** Math.floor(Math.log10(rough)), m = rough / ten;
  const length = ten * (m < 2 ? 1 : m < 5 ? 2 : 5);
  return html`<path class="axis" d="M${d1(MARGIN)} ${d1(p.height + 4)}v6h${d1(length * p.scale)}v-6"/><text class="tick" x="${
    d1(MARGIN + length * p.scale + 8)}" y="${d1(p.height + 12)}">${format.power(length, 6)} m</text>
`;
}

// Surfaces in the plane of a drawing, as one path; and what says where the plane is.
function wallsOf(data, p, axes) {
  const section = (data.sections ?? []).find((one) => !axes.includes(one.axis));
  if (!section || section.count === 0) return { path: nothing, said: "" };
  const ends = new Float32Array(decoded(section.lines).buffer), place = [0, 0, 0], points = [];
  for (let i = 0; i < ends.length; i += 2) {
    axes.forEach((axis, k) => { place[axis] = data.domain.low[axis] + ends[i + k]; });
    points.push(`${i % 4 ? "L" : "M"}${d1(p.x(place))} ${d1(p.y(place))}`);
  }
  const at = format.power(section.at_m + data.origin[section.axis], 9);
  return { path: html`<path class="wall" d="${points.join("")}"/>
`, said: `; walls cut at ${"xyz"[section.axis]} = ${at} m${section.count < section.asked ? `, the longest ${section.count} of ${section.asked} lines` : ""}` };
}

// The sensors of some steps of a timeline, from above, and which of them stand where none stood in the picture before.
function steps(data) {
  const n = Math.min(data.states.length, STEPS_MAX), p = projection(data, [0, 1]);
  if (!data.follow || n < 2 || !p) return nothing;
  const chosen = Array.from({ length: n }, (_, i) => data.states[Math.floor(i * (data.states.length - 1) / (n - 1))]);
  const walls = wallsOf(data, p, [0, 1]), at = (sensor) => sensor.place.join(" ");
  return html`<p class="key"><span class="place"></span>sensor<span class="one"></span>sensor where none stood in the picture before</p>
<div class="steps">
${chosen.map((state, i) => {
    const before = new Set((chosen[i - 1] ?? state).sensors.map(at));
    return html`<figure>
<svg viewBox="0 0 ${WIDTH} ${p.height.toFixed(0)}" role="img" aria-label="The sensors of ${state.name}, from above">
${walls.path}${state.sensors.map((sensor) => html`<circle class="${before.has(at(sensor)) ? "sensor" : "sensor new"}" cx="${
      d1(p.x(sensor.place))}" cy="${d1(p.y(sensor.place))}" r="14"/>
`)}</svg>
<figcaption>${state.name}</figcaption>
</figure>
`;
  })}</div>
`;
}

function drawing(data, dots, name, axes) {
  const p = projection(data, axes);
  if (!p) return nothing;
  const walls = wallsOf(data, p, axes);
  const paths = [0, 1, 2].map((seen) => dots.filter((dot) => dot.seen === seen).map(({ place }) => `M${d1(p.x(place))} ${d1(p.y(place))}h0`).join(""));
  const domain = data.domain && [p.x(data.domain.low), p.y(data.domain.high), p.x(data.domain.high), p.y(data.domain.low)];
  return html`<figure>
<svg viewBox="0 0 ${WIDTH} ${(p.height + SCALE_BAR).toFixed(0)}" role="img" aria-label="${name}">
${domain ? html`<rect class="domain" x="${d1(domain[0])}" y="${d1(domain[1])}" width="${d1(domain[2] - domain[0])}" height="${d1(domain[3] - domain[1])}"/>
` : nothing}<g class="photons">
${paths.map((d, seen) => html`<path class="seen${seen}" d="${d}"/>
`)}</g>
${walls.path}${drawSensors(p, data.states[0].sensors)}${drawScale(p)}</svg>
<figcaption>${name}${walls.said}</figcaption>
</figure>
`;
}

// Of the drawings alone: the view in space has its own key, for its dark ground.
function key(data) {
  const [{ sensors, photons }] = data.states, name = pointName(data);
  if (sensors.length + photons === 0) return nothing;
  return html`<p class="key">${sensors.length > 0 ? html`<span class="place"></span>sensor, range dashed`
    : html`<span class="one"></span>${name}`}${sensors.length > 0 && photons > 0
    ? html`<span class="unseen"></span>${name} that none sees<span class="one"></span>seen by one<span class="more"></span>by more` : nothing}</p>
`;
}

// note: why something is not shown; may be empty. data: the view's, null where there is nothing in space.
export function where(data, note) {
  if (!data && !note) return nothing;
  const dots = data ? dotsOf(data) : [];
  return html`<section id="where" data-title="Where they are">
<h2>Where they are</h2>
${note ? html`<p class="note">${note}</p>
` : nothing}${data ? html`${view(data)}${dots.length > 0
    ? html`<p class="note">${dots.length} of the ${data.states[0].stored} ${pointName(data)}s are drawn below, evenly chosen.</p>
` : nothing}${key(data)}<div class="plans">
${drawing(data, dots, "From above: x to the right, y up", [0, 1])}${drawing(data, dots, "From the side: x to the right, z up", [0, 2])}</div>
${steps(data)}` : nothing}</section>
`;
}
