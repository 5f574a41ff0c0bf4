// What was counted where: tallies of planes and spheres (tallies.csv), and slices through grids of fluence rate.
import { chart, heat } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { floats, items } from "./results.js";
import { estimate, table, word } from "./tables.js";

const LINES_MAX = 8;
const LOG_RATIO = 30; // largest over middle value from which on colours are by logarithms
const AXES = "xyz";

const six = (value) => String(Number(value.toPrecision(6)));
const interval = (y, error) => ({ y, low: y - 1.96 * error, high: y + 1.96 * error });
const middle = ([low, high], i, n) => low + (i + 0.5) / n * (high - low);

// ---- tallies ----

const direction = (t, k) => t.directions[k] ?? "";

// Tallies of one bin are rows of a table.
const single = (t) => [...floats(t.values)].map((value, i) => [t.name, word(direction(t, Math.floor(i / t.bands_nm.length))),
  word(`${six(t.bands_nm[i % t.bands_nm.length])} nm`), estimate(value, floats(t.errors)[i]), word(t.unit)]);

// Lines along the one axis that has bins: of each direction and band.
function lines(t) {
  const values = floats(t.values), errors = floats(t.errors), [axis] = t.axes, n = axis.bins;
  const all = t.bands_nm.length * t.directions.length;
  const series = Array.from({ length: Math.min(all, LINES_MAX) }, (_, k) => {
    const way = direction(t, Math.floor(k / t.bands_nm.length));
    return {
      name: `${way}${way ? ", " : ""}${six(t.bands_nm[k % t.bands_nm.length])} nm`, isLine: true,
      points: Array.from({ length: n }, (_, i) => ({ x: middle(axis.range, i, n), ...interval(values[k * n + i], errors[k * n + i]) })),
    };
  });
  return chart({
    title: `Tally ${t.name}, with 95 % intervals${all > LINES_MAX ? " (the first 8 lines; all are in tallies.csv)" : ""}`,
    xTitle: axis.title, yTitle: `${t.unit} a bin`,
  }, series);
}

// A map of each direction, summed over angles and bands.
function maps(t) {
  const values = floats(t.values), [x, y] = t.axes, size = [x.bins, y.bins];
  return t.directions.map((way, d) => heat({
    title: `Tally ${t.name}${way ? `, ${way}` : ""}${t.layers > 1 ? ", all bands and angles" : ""}`, xTitle: x.title, yTitle: y.title,
    valueTitle: `${t.unit} a bin`, x: x.range, y: y.range, size, least: 0, isEqual: t.is_place,
    values: values.subarray(d * x.bins * y.bins, (d + 1) * x.bins * y.bins),
  }));
}

const drawnTally = (t) => html`<h3>Tally ${t.name}</h3>
<div class="plans">
${t.kind === "lines" ? lines(t) : maps(t)}</div>
<p class="note">${t.rows} values, ${t.lit} of them lit${t.lit > 0 ? `, half of these known to ${format.power(100 * t.known, 2)} % or better` : ""
}; all are in tallies.csv.</p>
`;

// ---- grids ----

const nameOf = (f) => f.bands > 1 ? `${f.name} at ${six(f.band_nm)} nm` : f.name;

// Whether the largest value is far above the middle of those above 0.
function spansDecades(slices) {
  const lit = slices.flatMap((slice) => [...slice.values].filter((v) => v > 0)).sort((a, b) => a - b);
  return lit.length > 0 && lit.at(-1) > LOG_RATIO * lit[Math.floor(lit.length / 2)];
}

// A grid of one row of cells: a line with its 95 % interval.
function fieldLine(f, slice) {
  const k = slice.size[0] > 1 ? 0 : 1, n = slice.size[0] * slice.size[1], range = [slice.x, slice.y][k], errors = floats(slice.errors);
  return chart({ title: `Fluence rate ${nameOf(f)}, with its 95 % interval`, xTitle: `${AXES[slice.axes[k]]}, m`, yTitle: f.unit }, [{
    name: nameOf(f), isLine: true,
    points: Array.from({ length: n }, (_, i) => ({ x: middle(range, i, n), ...interval(slice.values[i], errors[i]) })),
  }]);
}

function field(f) {
  if (f.note !== undefined) return html`<p class="note">It cannot be shown: ${f.note}.</p>
`;
  const slices = f.slices.map((slice) => ({ ...slice, values: floats(slice.values) })), isLog = spansDecades(slices);
  return html`<div class="plans">
${slices.map((slice) => slice.errors !== undefined ? fieldLine(f, slice) : heat({
    title: `Fluence rate ${nameOf(f)} at ${AXES[slice.axes[2]]} = ${slice.at} m`, xTitle: `${AXES[slice.axes[0]]}, m`,
    yTitle: `${AXES[slice.axes[1]]}, m`, valueTitle: f.unit, x: slice.x, y: slice.y, size: slice.size, values: slice.values,
    least: isLog ? NaN : 0, isLog, isEqual: true,
  }))}</div>
`;
}

const fields = (list, asked) => html`${list.map((f, i) => html`${f.name !== list[i - 1]?.name ? html`<h3>Tally ${f.name}</h3>
` : nothing}${field(f)}`)}${asked > list.length
  ? html`<p class="note">The first ${list.length} of ${asked} fields are drawn; all are in the .vdb files.</p>` : nothing}`;

export function tallies({ tallies, fields: grids, fields_asked: asked }) {
  if (tallies === undefined) return nothing;
  const singles = tallies.filter((t) => t.kind === "values");
  return html`<section id="tallies" data-title="Tallies">
<h2>Tallies</h2>
<p>What was counted where: power through planes, and the light that passes a point from all sides (fluence rate) in grids and spheres. Plots have 95 % intervals.</p>
${singles.length > 0 ? table("Tallies of one bin", ["<tally", "<direction", "<band", "value", "<unit"], singles.flatMap(single))
    : nothing}${tallies.filter((t) => t.kind !== "values").map(drawnTally)}${fields(items(grids), asked)}</section>
`;
}
