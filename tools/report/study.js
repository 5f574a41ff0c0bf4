// A study (study.json, table.csv): of each output a plot against the axis with the most values, a line for each
// combination of the others; the rows as tables.
import { chart } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { at, count, items, number, parsed, table as csv, text } from "./results.js";
import { amount, estimate, plain, share, table, word } from "./tables.js";

const PLOTS_MAX = 24, LINES_MAX = 8, OUTPUTS_MAX = 4; // plots; lines of one; outputs of one table, so that it fits a page
// From this ratio on, an axis of positive numbers is drawn by logarithms.
const LOG_RATIO = 20, LOG_RATIO_Y = 50;

const isOfBand = (output) => /_[\d.]+nm$/.test(output); // "density_475nm"
const isShare = (output) => output.startsWith("coverage");

// Columns of table.csv that have their errors behind them, as {name, k}.
const outputsOf = (csv, axes) => csv.names.map((name, k) => ({ name, k }))
  .filter(({ name, k }) => k >= axes && csv.names[k + 1] === `${name}_standard_error`);

// ---- what is drawn against what ----

// "06:30" or "06:30:00" as hours.
function clock(cell) {
  const found = /^(\d\d):(\d\d)(?::(\d\d(?:\.\d+)?))?$/.exec(cell);
  return found ? Number(found[1]) + found[2] / 60 + (found[3] ?? 0) / 3600 : NaN;
}

// Numbers as they are, hours as hours, else the words one after the other.
function placesOf(cells) {
  const words = [...new Set(cells)], values = cells.map(parsed), hours = cells.map(clock);
  const known = values.filter((v) => !Number.isNaN(v)), least = Math.min(...known), most = Math.max(...known);
  const isNumber = known.length === cells.length, isClock = hours.every((v) => !Number.isNaN(v));
  // 0, 0.1, 1, 10: neither as they are nor by logarithms
  const ratio = least === 0 ? most / Math.min(...known.filter((v) => v > 0)) : 0;
  const isUneven = ratio > LOG_RATIO && words.length < ratio / 4;
  if (isUneven || !(isNumber || isClock)) return { x: cells.map((cell) => words.indexOf(cell)), names: words };
  const kind = isNumber ? (least > 0 && most > LOG_RATIO * least ? "log" : "even") : "clock";
  return { x: isNumber ? values : hours, kind };
}

function frameOf(csv, axes, isPaired) {
  const different = (k) => new Set(csv.rows.map((row) => row[k])).size;
  const counts = Array.from({ length: axes }, (_, k) => isPaired ? 0 : different(k));
  const along = Math.max(0, counts.indexOf(Math.max(...counts, 0)));
  const others = Array.from({ length: axes }, (_, k) => k).filter((k) => k !== along && !isPaired), lines = new Map();
  csv.rows.forEach((row, i) => {
    const key = JSON.stringify(others.map((k) => row[k]));
    lines.set(key, [...(lines.get(key) ?? []), i]);
  });
  return { csv, along, others, lines: [...lines.values()], ...placesOf(csv.rows.map((row) => axes > 0 ? row[along] : "1")),
    xTitle: axes > 0 ? csv.names[along] : "" };
}

// ---- plots and tables ----

function unitOf(study, output) {
  for (const row of items(study, "rows")) {
    const unit = text(at(row, "values")?.[output], "unit");
    if (unit !== undefined) return unit === "1" ? "" : unit;
  }
  return "";
}

function outputChart(frame, study, { name, k }) {
  const { csv, lines, others, x } = frame, all = csv.rows.map((row) => parsed(row[k])).filter((v) => !Number.isNaN(v));
  const n = Math.min(lines.length, LINES_MAX), unit = unitOf(study, name), least = Math.min(...all), most = Math.max(...all);
  const series = Array.from({ length: n }, (_, i) => lines[Math.floor(i * lines.length / n)]).map((rows) => ({
    name: others.map((axis) => `${csv.names[axis]} ${csv.rows[rows[0]][axis]}`).join(", ") || name,
    isLine: true,
    points: rows.map((i) => {
      const y = parsed(csv.rows[i][k]), error = 1.96 * (parsed(csv.rows[i][k + 1]) || 0);
      return { x: x[i], y, low: y - error, high: y + error };
    }),
  }));
  return chart({
    title: `${name}, with 95 % intervals${n < lines.length ? ` (${n} of ${lines.length} lines; all are in table.csv)` : ""}`,
    xTitle: frame.xTitle, yTitle: unit ? `${name}, ${unit}` : name, names: frame.names, xKind: frame.kind,
    yKind: isShare(name) ? "share" : least > 0 && most > LOG_RATIO_Y * least ? "log" : "even",
  }, series);
}

function rowTables({ csv }, axes, outputs) {
  const blocks = [];
  for (let i = 0; i < outputs.length; i += OUTPUTS_MAX) blocks.push(outputs.slice(i, i + OUTPUTS_MAX));
  return blocks.map((some) => table("The rows of the study", ["row", ...csv.names.slice(0, axes), ...some.map(({ name }) => name)],
    csv.rows.map((row, i) => [String(i + 1), ...row.slice(0, axes).map(plain),
      ...some.map(({ name, k }) => (isShare(name) ? share : estimate)(parsed(row[k]), parsed(row[k + 1])))]),
    csv.inFile, "table.csv"));
}

// Plots and rows of all light's outputs, or of the bands'.
const outputs = (frame, study, axes, list) => html`<div class="plans">
${list.slice(0, PLOTS_MAX).map((output) => outputChart(frame, study, output))}</div>
${list.length > PLOTS_MAX ? html`<p class="note">${PLOTS_MAX} of ${list.length} outputs are drawn.</p>` : nothing}${rowTables(frame, axes, list)}`;

function drawn(study, csv) {
  const axes = Math.min(count(study, "axes"), csv.names.length), frame = frameOf(csv, axes, text(study, "mode") === "paired");
  const all = outputsOf(csv, axes), bands = all.filter(({ name }) => isOfBand(name));
  return html`${outputs(frame, study, axes, all.filter(({ name }) => !isOfBand(name)))}${bands.length > 0
    ? html`<details><summary>The same band by band</summary>
${outputs(frame, study, axes, bands)}</details>
` : nothing}`;
}

function failed(study) {
  const rows = items(study, "rows").map((row, i) => [String(i + 1), text(row, "failed")]).filter(([, why]) => why !== undefined);
  return rows.length > 0 ? table("Rows that failed", ["row", "<why"], rows.map(([row, why]) => [row, word(why)])) : nothing;
}

function plans(study) {
  const rows = [["mean", "the mean"], ["worst", "the worst row"]].map(([key, name]) => [name, at(study, `plans.${key}`)])
    .filter(([, plan]) => plan !== undefined);
  if (rows.length === 0) return nothing;
  return table("One plan for all rows", ["one plan for", "sensors", "mean", "least", "in row", "upper bound"],
    rows.map(([name, plan]) => [name, amount(count(plan, "sensors")), share(number(plan, "mean.value"), number(plan, "mean.standard_error")),
      share(number(plan, "worst.value"), number(plan, "worst.standard_error")), amount(number(plan, "worst_row")),
      share(number(plan, "upper_bound"))]));
}

export function study({ study }) {
  if (study === undefined) return nothing;
  const found = csv("table.csv");
  return html`<section id="study" data-title="Study">
<h2>The study</h2>
${found ? drawn(study, found) : html`<p>There is no table.csv beside study.json.</p>`}${failed(study)}${plans(study)}</section>
`;
}
