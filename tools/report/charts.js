/*! d3-scale, d3-shape and the modules that they use
Copyright 2010-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.
*/
// Plots as SVG: lines with bands, points with whiskers, bars, fields in colours.
//
// Scales and ticks are d3-scale's, paths of lines and bands d3-shape's. The page draws vectors itself, because
// they print sharply, follow the page's style sheet from light to dark, and need no inline style, which the
// page's policy forbids. What is drawn is also said in words, for who does not see it; each point says its
// values.
import { scaleLinear, scaleLog } from "d3-scale";
import { area, line } from "d3-shape";
import * as format from "./format.js";
import { html, nothing } from "./html.js";

const WIDTH = 640; // of a plot, in user units, which the page scales
const CHARACTER = 7; // width of one, about
const LEGEND = 20; // height of a row of it
const VALUE_MAX = 1e300; // so that a range of two values is finite
const RANGE_MIN = 1e-290; // what is less is nothing: steps of it would leave the doubles
const TICKS = 5; // that are aimed at
const SERIES_MAX = 8, POINTS_MAX = 2000; // of a series; of more, evenly chosen ones are drawn
const TOLD_MAX = 300; // points of a plot beyond which none says its own values

const isKnown = (value) => Math.abs(value) <= VALUE_MAX;

// ---- axes ----

// kind: "even", "log", "whole" (counts), "share" (0..1, in per cent), "clock" (hours of a day).
export class Axis {
  constructor(from, to, kind = "even") {
    Object.assign(this, { from, to, kind, low: Infinity, high: -Infinity });
  }

  // So that the value, if it has a place, lies on the axis.
  widen(value) {
    if (!Number.isFinite(value) || (this.kind === "log" && !(value > 0))) return;
    this.low = Math.min(this.low, value);
    this.high = Math.max(this.high, value);
  }

  // Room about a single value, and about the ends in shares of the length.
  close(room = 0) {
    const [inside, outside] = this.kind === "log" ? [Math.log10, (v) => 10 ** v] : [Number, Number];
    let low = inside(this.low), high = inside(this.high);
    // a range that adding changes nothing of is none
    if (!(high - low > Math.max(1e-9 * Math.max(Math.abs(low), Math.abs(high)), RANGE_MIN))) {
      const by = this.kind === "whole" || Math.abs(high) < RANGE_MIN ? 0.5 : 0.1 * Math.abs(high);
      low -= by;
      high += by;
    }
    const by = room * (high - low);
    this.low = outside(low - by);
    this.high = outside(high + by);
    return this;
  }

  // What is beyond lies at the end.
  place(value) {
    this.scale ??= (this.kind === "log" ? scaleLog() : scaleLinear())
      .domain([this.low, this.high]).range([this.from, this.to]).clamp(true);
    return this.kind === "log" && !(value > 0) ? this.from : this.scale(value);
  }

  // At round numbers, and the step between them; 0 for logarithms.
  ticks() {
    if (this.kind === "log") {
      const decades = Math.log10(this.high / this.low);
      const lead = (v) => Math.round(v / 10 ** Math.floor(Math.log10(v) + 1e-9));
      const ticks = scaleLog().domain([this.low, this.high]).ticks(8)
        .filter((v) => lead(v) === 1 || (decades <= 3 && [2, 5].includes(lead(v))));
      if (ticks.length >= 2) return { ticks, step: 0 };
    }
    if (this.kind === "clock") return this.clock();
    let ticks = scaleLinear().domain([this.low, this.high]).ticks(TICKS);
    if (this.kind === "whole") ticks = [...new Set(ticks.map((v) => Math.round(v)))].filter((v) => v >= this.low && v <= this.high);
    return { ticks, step: ticks.length > 1 ? ticks[1] - ticks[0] : 0 };
  }

  clock() {
    const step = [0.25, 0.5, 1, 2, 3].find((s) => (this.high - this.low) / s <= 9) ?? 6;
    const ticks = [];
    for (let i = Math.ceil(this.low / step - 1e-9); i * step <= this.high + 1e-9; ++i) ticks.push(i * step);
    return { ticks, step };
  }

  // A value with as many digits as the step needs; without a step, with all that it has.
  write(value, step = 0) {
    if (this.kind === "clock") {
      const minutes = Math.round(Math.min(Math.max(value, 0), 99) * 60), two = (n) => String(n).padStart(2, "0");
      return `${two(Math.floor(minutes / 60))}:${two(minutes % 60)}`;
    }
    const hundred = this.kind === "share" ? 100 : 1, shown = hundred * value, by = hundred * step, size = Math.abs(shown);
    const decimals = by > 0 ? -Math.floor(Math.log10(by * 1.0001)) : 0;
    // five digits tell ticks apart, but not those of surveyed coordinates
    const tellsApart = !(by > 0 && by < 1e-4 * size);
    const text = size > 0 && ((size >= 99999.5 && tellsApart) || size < 1e-4) ? format.power(shown, 5)
      : by > 0 && decimals <= 8 ? (shown + 0).toFixed(Math.max(decimals, 0)) : String(Number(shown.toPrecision(6)));
    return this.kind === "share" ? `${text} %` : text;
  }
}

const d1 = (value) => value.toFixed(1);

const cut = (text, most, end = false) => {
  const characters = [...text];
  if (characters.length <= most) return text;
  return end ? `…${characters.slice(1 - most).join("")}` : `${characters.slice(0, most - 1).join("")}…`;
};

const figure = (title, height, inside, caption = title) => html`<figure>
<svg viewBox="0 0 ${WIDTH} ${height.toFixed(0)}" role="img" aria-label="${title}">
${inside}</svg>
<figcaption>${caption}</figcaption>
</figure>
`;

// ---- lines and points ----

const BASE = 308, LEFT = 80, RIGHT = 16, TOP = 14; // of a plot: the axis of x, and room about it
const BELOW = 52; // room for ticks and name of that axis
const SLANTED_MAX = 20; // characters of a name on a slant
// Shapes, so that series are told apart without colours.
const MARKS = ["m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0-6.4 0z", "m-3-3h6v6h-6z", "m0-4.2l4 7h-8z",
  "m0-4.4l4.4 4.4l-4.4 4.4l-4.4-4.4z"];

const hasRange = (p) => isKnown(p.low) && isKnown(p.high);

// Axes about all that is drawn.
function fitted(chart, series) {
  const x = new Axis(LEFT + 8, WIDTH - RIGHT - 8, chart.xKind), y = new Axis(BASE, TOP, chart.yKind);
  for (const p of series.flatMap((s) => s.shown)) {
    x.widen(p.x);
    y.widen(p.y);
    if (hasRange(p) && y.kind !== "log") [p.low, p.high].forEach((v) => y.widen(v));
  }
  for (const v of chart.across ?? []) y.widen(v);
  const { low, high } = y;
  y.close(0.06);
  if (y.kind !== "log" && low >= 0 && (low < 0.5 * high || y.low < 0)) y.low = 0;
  if (y.kind === "share" && high <= 1 && y.high > 1) y.high = 1.005;
  x.close();
  if (chart.names) [x.low, x.high] = [-0.5, chart.names.length - 0.5];
  return { x, y };
}

function drawAxes(chart, { x, y }, slanted, below) {
  const yTicks = y.ticks(), xTicks = chart.names ? { ticks: [] } : x.ticks();
  const room = (x.to - x.from) / Math.max(chart.names?.length ?? 1, 1), stride = room < 18 ? Math.ceil(18 / room) : 1;
  const tick = (at, text) => html`<path class="axis" d="M${d1(at)} ${d1(BASE)}v5"/>${slanted
    ? html`<text class="tick" transform="translate(${d1(at + 4)} ${d1(BASE + 16)}) rotate(-40)" text-anchor="end">${text}</text>`
    : html`<text class="tick" x="${d1(at)}" y="${d1(BASE + 19)}" text-anchor="middle">${text}</text>`}
`;
  return html`${yTicks.ticks.map((v) => [v, d1(y.place(v))]).map(([v, at]) => html`<path class="grid" d="M${d1(LEFT)} ${at}H${
    d1(WIDTH - RIGHT)}"/><text class="tick" x="${d1(LEFT - 6)}" y="${d1(Number(at) + 4)}" text-anchor="end">${y.write(v, yTicks.step)}</text>
`)}${xTicks.ticks.map((v) => tick(x.place(v), x.write(v, xTicks.step)))}${
  // of names as many as there is room for; on a slant the end of a name, which tells more than its beginning
  (chart.names ?? []).map((name, i) => i % stride === 0 ? tick(x.place(i), slanted ? cut(name, SLANTED_MAX, true) : name) : nothing)
  }<path class="axis" d="M${d1(LEFT)} ${d1(TOP)}V${d1(BASE)}H${d1(WIDTH - RIGHT)}"/><text class="name" x="${
    d1((LEFT + WIDTH - RIGHT) / 2)}" y="${d1(BASE + below - 12)}" text-anchor="middle">${chart.xTitle
  }</text><text class="name" transform="translate(14 ${d1((TOP + BASE) / 2)}) rotate(-90)" text-anchor="middle">${chart.yTitle}</text>
${(chart.across ?? []).map((v) => html`<path class="across" d="M${d1(LEFT)} ${d1(y.place(v))}H${d1(WIDTH - RIGHT)}"/>
`)}`;
}

// "held out: 12:00, 3.2 (3.1 to 3.3)"
function told(chart, { x, y }, series, p) {
  const where = chart.names ? chart.names[Math.round(p.x)] ?? "" : x.write(p.x);
  const range = hasRange(p) && p.low < p.high ? ` (${y.write(p.low)} to ${y.write(p.high)})` : "";
  return html`<title>${series.name}: ${where}, ${y.write(p.y)}${range}</title>`;
}

function drawSeries(chart, axes, series, k, isTelling) {
  const { x, y } = axes, px = (p) => x.place(p.x), isThere = (p) => p.isShown;
  const path = series.isLine ? line(px, (p) => y.place(p.y)).defined(isThere).digits(1)(series.chosen) : null;
  // of each run between two gaps one path, as the marks of each run lie together
  return html`${path ? path.split(/(?=M)/).map((d) => html`<path class="line s${k}" d="${d}"/>
`) : nothing}${series.shown.map((p) => html`${!series.isLine && hasRange(p) ? html`<path class="whisker s${k}" d="M${
    d1(px(p))} ${d1(y.place(p.low))}V${d1(y.place(p.high))}"/>` : nothing}<path class="point s${k}" d="M${d1(px(p))} ${d1(y.place(p.y))}${
    MARKS[k % 4]}">${isTelling ? told(chart, axes, series, p) : nothing}</path>
`)}`;
}

function drawBand({ x, y }, series, k) {
  const path = area().x((p) => x.place(p.x)).y0((p) => y.place(p.low)).y1((p) => y.place(p.high))
    .defined((p) => p.isShown && hasRange(p)).digits(1)(series.chosen);
  return path ? path.split(/(?=M)/).map((d) => html`<path class="band s${k}" d="${d}"/>
`) : nothing;
}

// Of each series its points and its extremes.
const described = (chart, y, series) => html`<desc>${chart.yTitle} against ${chart.xTitle}${series.map((s) => {
  const values = s.points.filter((p) => p.isShown).map((p) => p.y), n = values.length;
  const range = n > 0 ? `, from ${y.write(Math.min(...values))} to ${y.write(Math.max(...values))}` : "";
  return `; ${s.name}: ${n} point${n === 1 ? "" : "s"}${range}`;
})}.</desc>
`;

function drawLegend(series, top, columns) {
  return series.map((s, k) => {
    const x = LEFT + (k % columns) * (WIDTH - LEFT) / columns, y = top + LEGEND * Math.floor(k / columns) + 8;
    return html`${s.isLine ? html`<path class="line s${k}" d="M${d1(x)} ${d1(y - 4)}h22"/>` : nothing}<path class="point s${k}" d="M${
      d1(x + 11)} ${d1(y - 4)}${MARKS[k % 4]}"/><text class="tick" x="${d1(x + 28)}" y="${d1(y)}">${s.name}</text>
`;
  });
}

// chart: {title, xTitle, yTitle, xKind, yKind, names of x = 0, 1, .., across: values that lines are drawn at}.
// series: {name, points of {x, y, low, high}, isLine}; where a value is not finite a line breaks; low and high
// make a band about a line, whiskers of points. Nothing where no point is finite.
export function chart(chart, all) {
  const isShown = (p) => isKnown(p.x) && isKnown(p.y) && !(chart.xKind === "log" && !(p.x > 0)) && !(chart.yKind === "log" && !(p.y > 0));
  const series = all.slice(0, SERIES_MAX).map((s) => {
    const points = s.points.map((p) => ({ ...p, isShown: isShown(p) })), step = Math.floor(points.length / POINTS_MAX) + 1;
    const chosen = points.filter((_, i) => i % step === 0);
    return { ...s, points, chosen, shown: chosen.filter((p) => p.isShown) };
  });
  const n = series.reduce((sum, s) => sum + s.shown.length, 0);
  if (n === 0) return nothing;
  const axes = fitted(chart, series);
  const longest = Math.max(0, ...(chart.names ?? []).map((name) => [...name].length));
  const slanted = longest > 0 && CHARACTER * longest > (axes.x.to - axes.x.from) / chart.names.length - 4;
  const below = BELOW + (slanted ? 0.7 * CHARACTER * Math.min(longest, SLANTED_MAX) : 0);
  const columns = series.some((s) => CHARACTER * s.name.length > 240) ? 1 : 2;
  const rows = series.length > 1 ? Math.ceil(series.length / columns) : 0;
  // the first one lies on top
  const drawn = series.map((s, k) => drawSeries(chart, axes, s, k, n <= TOLD_MAX)).reverse();
  return figure(chart.title, BASE + below + LEGEND * rows, html`${described(chart, axes.y, series)}${
    drawAxes(chart, axes, slanted, below)}${series.map((s, k) => s.isLine ? drawBand(axes, s, k) : nothing)}${drawn}${
    rows > 0 ? drawLegend(series, BASE + below, columns) : nothing}`);
}

// ---- bars ----

const BARS_MAX = 60, NAME_MAX = 30; // rows; characters of a name
const BAR = { top: 6, row: 24, high: 15, right: 92, below: 48, character: 7.8 };

// bars: {title, axisTitle, kind, parts: names of the legend or none, rows: [{name, values, low, high}]}. Of
// several parts none is negative. Nothing where no value is finite.
export function bars({ title, axisTitle, kind, parts, rows: all }) {
  const rows = all.slice(0, BARS_MAX).map((row) => {
    const values = row.values.map((v) => row.values.length === 1 || v > 0 ? v : 0);
    const whole = row.values.some(Number.isFinite) ? values.reduce((a, b) => a + b, 0) : NaN;
    return { ...row, values, whole: isKnown(whole) ? whole : NaN };
  });
  if (!rows.some((row) => Number.isFinite(row.whole))) return nothing;
  const longest = Math.min(NAME_MAX, Math.max(4, ...rows.map((row) => [...row.name].length)));
  const left = 14 + BAR.character * longest, base = BAR.top + BAR.row * rows.length, right = WIDTH - BAR.right;
  const axis = new Axis(left, right, kind);
  axis.widen(0);
  const isRange = (row) => hasRange(row) && Number.isFinite(row.whole);
  for (const row of rows) {
    axis.widen(row.whole);
    if (isRange(row)) [row.low, row.high].forEach((v) => axis.widen(v));
  }
  const { ticks, step } = axis.close().ticks();
  const drawRow = (row, i) => {
    const y = BAR.top + BAR.row * i + (BAR.row - BAR.high) / 2;
    let begin = 0, after = left;
    const drawn = Number.isNaN(row.whole) ? [] : row.values.map((value, k) => {
      const from = axis.place(begin), end = axis.place(begin += value);
      after = Math.max(end, left);
      return row.values.length > 1 && !(value > 0) ? nothing : html`<rect class="bar s${k}" x="${d1(Math.min(from, end))}" y="${
        d1(y)}" width="${d1(Math.abs(end - from))}" height="${BAR.high}"/>`;
    });
    const error = isRange(row) ? html`<path class="error" d="M${d1(axis.place(row.low))} ${d1(y + BAR.high / 2)}H${d1(axis.place(row.high))}"/>` : nothing;
    if (isRange(row)) after = Math.max(after, axis.place(row.high));
    return html`<text class="name" x="${d1(left - 8)}" y="${d1(y + 12)}" text-anchor="end">${cut(row.name, NAME_MAX)}</text>${drawn}${
      error}<text class="tick" x="${d1(after + 6)}" y="${d1(y + 12)}">${kind === "share" ? format.share(row.whole) : format.number(row.whole)}</text>
`;
  };
  const legend = (parts ?? []).map((name, k) => {
    const x = 14 + (k % 2) * WIDTH / 2, y = base + BAR.below + LEGEND * Math.floor(k / 2);
    return html`<rect class="bar s${k}" x="${d1(x)}" y="${d1(y)}" width="14" height="12"/><text class="tick" x="${d1(x + 20)}" y="${d1(y + 11)}">${name}</text>
`;
  });
  return figure(title, base + BAR.below + LEGEND * Math.ceil(legend.length / 2), html`${ticks.map((v) => html`<path class="grid" d="M${
    d1(axis.place(v))} ${d1(BAR.top)}V${d1(base)}"/><text class="tick" x="${d1(axis.place(v))}" y="${d1(base + 17)}" text-anchor="middle">${
    axis.write(v, step)}</text>
`)}<path class="axis" d="M${d1(axis.place(0))} ${d1(BAR.top)}V${d1(base)}"/><text class="name" x="${d1((left + right) / 2)}" y="${
    d1(base + 38)}" text-anchor="middle">${axisTitle}</text>
${rows.map(drawRow)}${legend}`, all.length > rows.length ? `${title} (the first ${rows.length} of ${all.length})` : title);
}

// ---- fields ----

const HEAT = { top: 12, below: 52, legendX: 540, legend: 16, widest: 430, tallest: 380, least: 40, levels: 32 };
// Viridis at eighths (Smith and van der Walt, matplotlib, 2015; public domain by CC0), even in lightness, also
// for who sees few colours.
const VIRIDIS = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129],
  [92, 200, 99], [170, 220, 50], [253, 231, 37]];

function color(level) {
  const at = 8 * level / (HEAT.levels - 1), i = Math.min(Math.floor(at), 7);
  return `#${VIRIDIS[i].map((v, k) => Math.round(v + (at - i) * (VIRIDIS[i + 1][k] - v)).toString(16).padStart(2, "0")).join("")}`;
}

// Each colour is one path of level strokes, a run of equal cells each: a few bytes a cell.
function drawCells(levels, [nx, ny]) {
  const path = Array.from({ length: HEAT.levels }, () => "");
  for (let j = 0; j < ny; ++j) {
    for (let i = 0; i < nx;) {
      const level = levels[j * nx + i];
      let end = i + 1;
      while (end < nx && levels[j * nx + end] === level) ++end;
      if (level !== null) path[level] += `M${i} ${j}.5h${end - i}`;
      i = end;
    }
  }
  return path.map((d, level) => d ? html`<path stroke="${color(level)}" d="${d}"/>
` : nothing);
}

function heatTicks(axis, size, isUp, base) {
  const { ticks, step } = axis.ticks(), stride = isUp ? (size < 18 * ticks.length ? 3 : 1) : (size < 40 * ticks.length ? 2 : 1);
  return ticks.filter((_, i) => i % stride === 0).map((v) => [d1(axis.place(v)), axis.write(v, step)]).map(([at, text]) => isUp
    ? html`<path class="axis" d="M${d1(LEFT)} ${at}h-5"/><text class="tick" x="${d1(LEFT - 8)}" y="${d1(Number(at) + 4)}" text-anchor="end">${text}</text>
` : html`<path class="axis" d="M${at} ${d1(base)}v5"/><text class="tick" x="${at}" y="${d1(base + 19)}" text-anchor="middle">${text}</text>
`);
}

// heat: {title, xTitle, yTitle, valueTitle, x, y: ends of the field, size: cells along x and y, values: x fastest, y
// upwards, NaN where nothing is known, least: of the legend, or NaN, isLog: cells that are not above 0 are left blank,
// isEqual: both axes are lengths, drawn to one scale}. Nothing where no cell is finite.
export function heat({ title, xTitle, yTitle, valueTitle, x, y, size, values, least = NaN, isLog, isEqual }) {
  const [nx, ny] = size, isShown = (v) => isKnown(v) && !(isLog && !(v > 0));
  const wide = Math.abs(x[1] - x[0]), tall = Math.abs(y[1] - y[0]);
  const cells = [...values].slice(0, nx * ny), shown = cells.filter(isShown);
  if (shown.length === 0 || !(wide > 0 && wide <= VALUE_MAX && tall > 0 && tall <= VALUE_MAX)) return nothing;
  const value = new Axis(0, HEAT.levels, isLog ? "log" : "even");
  for (const v of [...shown, least]) value.widen(v);
  value.close();
  let width = HEAT.widest, height = ny === 1 ? HEAT.least : 0.75 * HEAT.widest;
  if (isEqual) {
    const scale = Math.min(HEAT.widest / wide, HEAT.tallest / tall);
    [width, height] = [wide, tall].map((v) => Math.max(scale * v, HEAT.least));
  }
  const across = new Axis(LEFT, LEFT + width), up = new Axis(HEAT.top + height, HEAT.top);
  for (const k of [0, 1]) {
    across.widen(x[k]);
    up.widen(y[k]);
  }
  const levels = cells.map((v) => isShown(v) ? Math.min(Math.floor(Math.max(value.place(v), 0)), HEAT.levels - 1) : null);
  // the smallest and the largest value, and where that is
  const largest = shown.reduce((a, b) => Math.max(a, b)), cell = cells.indexOf(largest), blank = cells.length - shown.length;
  const spot = [[x, cell % nx, nx], [y, Math.floor(cell / nx), ny]]
    .map(([ends, k, n]) => format.number(ends[0] + (k + 0.5) / n * (ends[1] - ends[0])));
  const said = `${nx} x ${ny} cells${blank > 0 ? `, ${blank} of them blank: nothing there` : ""}; from ${
    format.number(shown.reduce((a, b) => Math.min(a, b)))} to ${format.number(largest)} ${valueTitle}, which is at ${spot.join(", ")}.`;
  const base = HEAT.top + height, legendTall = Math.max(height, 120);
  const legend = Object.assign(new Axis(HEAT.top + legendTall, HEAT.top, value.kind), { low: value.low, high: value.high });
  const steps = legend.ticks();
  return figure(title, HEAT.top + Math.max(height + HEAT.below, 140), html`<desc>${said}</desc>
<rect class="blank" x="${d1(LEFT)}" y="${d1(HEAT.top)}" width="${d1(width)}" height="${d1(height)}"/>
<g transform="translate(${d1(LEFT)} ${d1(base)}) scale(${Number((width / nx).toPrecision(5))} ${
  Number((-height / ny).toPrecision(5))})" shape-rendering="crispEdges">
${drawCells(levels, size)}</g>
${heatTicks(across.close(), width, false, base)}<text class="name" x="${d1(Math.max(LEFT + width / 2, LEFT + 40))}" y="${
  d1(base + 40)}" text-anchor="middle">${xTitle}</text>
${heatTicks(up.close(), height, true, base)}<text class="name" transform="translate(14 ${d1(HEAT.top + height / 2)}) rotate(-90)" text-anchor="middle">${yTitle}</text>
${Array.from({ length: HEAT.levels }, (_, level) => html`<rect x="${d1(HEAT.legendX)}" y="${
    (HEAT.top + legendTall * (HEAT.levels - 1 - level) / HEAT.levels).toFixed(2)}" width="${d1(HEAT.legend)}" height="${
    (legendTall / HEAT.levels + 0.3).toFixed(2)}" shape-rendering="crispEdges" fill="${color(level)}"/>`)}${
  steps.ticks.map((v) => html`<text class="tick" x="${d1(HEAT.legendX + HEAT.legend + 5)}" y="${d1(legend.place(v) + 4)}">${
    legend.write(v, steps.step)}</text>
`)}<text class="name" transform="translate(${d1(HEAT.legendX - 8)} ${d1(HEAT.top + legendTall / 2)}) rotate(-90)" text-anchor="middle">${valueTitle}</text>
`, `${title}: ${said}`);
}
