// A calibration (fit.json, fit.csv): values with their intervals, residuals, what the readings tell, the search; and a
// prediction (predict.json, fit.csv), which has no search.
import { chart } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { at, column, count, items, number, parsed, table as csv, text } from "./results.js";
import { amount, estimate, facts, plain, shaded, table, word } from "./tables.js";

const INTERVALS_MAX = 40, UNITS_MAX = 6; // values and units of readings that are drawn
const KEYS_MAX = 24; // keys that have a column; more are told by fit.json alone
const LOG_RATIO = 50; // from this ratio on, readings are drawn by logarithms
const HALF_INTERVAL = 1.96; // half a 95 % interval, in standard errors

// With its standard error where the data determine it, else to two digits with its status in words.
function valueOf(parameter) {
  const value = number(parameter, "value"), status = text(parameter, "status");
  return status === "determined" || Number.isNaN(value) ? format.estimate(value, number(parameter, "standard_error"))
    : `${format.power(value, 2)} (${status})`;
}

const keysOf = (fit) => {
  const list = items(fit, "parameters");
  return list.length <= KEYS_MAX ? list.map((p) => text(p, "key") ?? "") : [];
};

function parameters(fit) {
  return table("What was found", ["key", "value", "from (95 %)", "to (95 %)", "start", "<known"],
    items(fit, "parameters").map((p) => [text(p, "key"), plain(valueOf(p)), amount(number(p, "lower")), amount(number(p, "upper")),
      amount(number(p, "start")), word(text(p, "status"))]), count(fit, "parameters"), "fit.json");
}

// Each value's 95 % interval, as shares of the value.
function intervals(fit) {
  const list = items(fit, "parameters").slice(0, INTERVALS_MAX);
  return chart({
    title: "How well each value is known: its 95 % interval, in per cent of the value", xTitle: "", yTitle: "off the value",
    yKind: "share", names: list.map((p) => text(p, "key") ?? ""),
  }, [{
    name: "found",
    points: list.map((p, x) => {
      const ends = ["lower", "upper"].map((key) => number(p, key) / number(p, "value") - 1);
      return { x, y: ends.every(Number.isFinite) ? 0 : NaN, low: Math.min(...ends), high: Math.max(...ends) };
    }),
  }]);
}

// ---- readings ----

function readings(found) {
  const of = (name) => column(found, name), [kind, use, unit] = ["kind", "use", "unit"].map(of);
  const [value, error, predicted, residual] = ["value", "standard_error", "predicted", "residual_in_standard_errors"]
    .map((name) => (row) => parsed(of(name)(row)));
  return found.rows.map((row, i) => ({ row: i + 1, kind: kind(row), use: use(row), unit: unit(row), value: value(row), error: error(row),
    predicted: predicted(row), residual: residual(row) }));
}

function residuals(list, name) {
  const series = [[name, "fit"], ["held out", "hold_out"]].map(([title, use]) => ({
    name: title,
    points: list.filter((r) => r.use === use && !Number.isNaN(r.residual))
      .map((r) => ({ x: r.row, y: r.residual, low: r.residual - HALF_INTERVAL, high: r.residual + HALF_INTERVAL })),
  }));
  return chart({
    title: "Residuals (measured less predicted) in standard errors, each with its 95 % interval; one in twenty may leave the dashed lines by chance",
    xTitle: "row of the data", xKind: "whole", yTitle: "residual / standard error", across: [-HALF_INTERVAL, 0, HALF_INTERVAL],
  }, series.filter((s) => s.points.length > 0));
}

// Measured against predicted, of the readings of one unit: on the line they agree.
function agreement(list, unit) {
  const known = list.filter((r) => !Number.isNaN(r.value) && !Number.isNaN(r.predicted)), all = known.flatMap((r) => [r.value, r.predicted]);
  const least = Math.min(...all), most = Math.max(...all), kind = least > 0 && most > LOG_RATIO * least ? "log" : "even";
  if (known.length === 0) return nothing;
  return chart({ title: "Measured against predicted", xTitle: `predicted, ${unit}`, yTitle: `measured, ${unit}`, xKind: kind, yKind: kind }, [
    { name: "readings, 95 % intervals",
      points: list.map((r) => ({ x: r.predicted, y: r.value, low: r.value - HALF_INTERVAL * r.error, high: r.value + HALF_INTERVAL * r.error })) },
    { name: "where both are the same", isLine: true, points: [{ x: least, y: least }, { x: most, y: most }] },
  ]);
}

function agreements(list) {
  const units = [...new Set(list.map((r) => r.unit))].slice(0, UNITS_MAX);
  return units.map((unit) => agreement(list.filter((r) => r.unit === unit), unit));
}

// name: what readings are called that are not held out.
function readingTables(found, name) {
  const list = readings(found);
  return html`<h3>Residuals</h3>
<div class="plans">
${residuals(list, name)}${agreements(list)}</div>
${table("Measured and predicted", ["row", "<kind", "<use", "measured", "predicted", "<unit", "residual σ"],
    list.map((r) => [String(r.row), word(r.kind), word(r.use), estimate(r.value, r.error), amount(r.predicted), word(r.unit), amount(r.residual)]),
    found.inFile, "fit.csv")}`;
}

// ---- what they tell ----

function correlations(fit) {
  const keys = keysOf(fit), matrix = items(fit, "correlation");
  if (keys.length < 2 || matrix.length !== keys.length) return nothing;
  return html`<h3>Correlations</h3>
<p>From -1 to 1; the deeper the shade, the more the readings tell of both together only.</p>
${table("Correlations of the values", ["key", ...keys], keys.map((key, i) => [key, ...keys.map((_, k) => {
    const value = number(items(matrix[i])[k]);
    return shaded(i === k ? 0 : value || 0, Math.abs(value) <= 1 ? value.toFixed(3) : format.number(value));
  })]))}`;
}

// What a map by keys holds.
const byKey = (map, keys, isShaded) => keys.map((key) => {
  const value = number(map?.[key]);
  return shaded(isShaded ? value || 0 : 0, format.number(value));
});

function directions(fit) {
  const keys = keysOf(fit), list = items(fit, "identifiability.directions");
  if (keys.length < 2 || list.length === 0) return nothing;
  return html`<h3>What the readings tell</h3>
<p>Combinations of the values (of their logarithms, where they are positive), from the best known to the worst: how much of each value is in it, and how well it is known.</p>
${table("Directions", ["direction", ...keys, "standard error", "<determined"], list.map((one, i) => [String(i + 1),
    ...byKey(at(one, "direction"), keys, true), amount(number(one, "standard_error")), word(text(one, "determined"))]))}`;
}

function next(fit) {
  const proposed = at(fit, "next"), list = items(proposed, "places");
  if (list.length === 0) return nothing;
  return html`<h3>What to measure next</h3>
<p>Readings of ${text(proposed, "kind")} that would tell most of what is not known yet, in ${text(proposed, "unit")}; the gain is of information, in units of the natural logarithm.</p>
${table("Proposed places", ["place", "x m", "y m", "z m", "gain", "predicted", "standard error"], list.map((one, i) => [String(i + 1),
    ...[0, 1, 2].map((k) => amount(number(items(one, "position_m")[k]))),
    ...["gain", "predicted", "standard_error"].map((key) => amount(number(one, key)))]))}`;
}

function starts(fit) {
  const keys = keysOf(fit), list = items(fit, "starts");
  if (keys.length === 0 || list.length === 0) return nothing;
  return html`<h3>The search</h3>
${table("Where each search began and ended", ["start", ...keys, "chi²", "light traced", "<converged", "<why it ended"],
    list.flatMap((one, i) => [
      [`${i + 1} from`, ...byKey(at(one, "from"), keys), plain(""), plain(""), plain(""), plain("")],
      [`${i + 1} to`, ...byKey(at(one, "to"), keys), amount(number(one, "chi2")), amount(number(one, "traces")),
        word(text(one, "converged")), word(text(one, "why"))],
    ]), 2 * count(fit, "starts"), "fit.json")}`;
}

function numbers(fit) {
  const of = (key) => format.number(number(fit, key)), said = (key) => text(fit, key) ?? "–";
  return facts("The fit in numbers", [
    ["chi²", of("chi2")],
    ["degrees of freedom", of("degrees_of_freedom")],
    ["chance of so large a chi² or a larger one", of("p_value")],
    ["accepted (chance of at least 1e-4)", said("accepted")],
    ["converged", said("converged")],
    ["why it ended", said("why")],
    ["times that light was traced", of("traces")],
    ["iterations", of("iterations")],
    ["evaluations", of("evaluations")],
    ["rows held out", of("hold_out.rows")],
    ["their root mean square residual", `${of("hold_out.rms_in_standard_errors")} standard errors`],
    ["data", said("data.file")],
  ]);
}

export function fit({ fit, predict }) {
  if (fit === undefined) return nothing;
  const found = csv("fit.csv");
  return html`<section id="calibration" data-title="Calibration">
<h2>The calibration</h2>
<div class="beside">
${parameters(fit)}${intervals(fit)}</div>
${predict !== undefined ? html`<p>The folder has a prediction, too. The readings of fit.csv, which the later of both runs wrote, are shown there.</p>`
  : found ? readingTables(found, "fitted") : html`<p>There is no fit.csv beside fit.json.</p>`}${correlations(fit)}${directions(fit)}${
    next(fit)}${starts(fit)}${numbers(fit)}</section>
`;
}

// With --predict the values are those of a finished fit; else they are those of the scene, and none are listed.
export function prediction({ predict }) {
  if (predict === undefined) return nothing;
  const found = csv("fit.csv"), values = items(predict, "parameters");
  return html`<section id="prediction" data-title="Prediction">
<h2>The prediction</h2>
${values.length > 0 ? table("The values of the fit", ["key", "value"], values.map((p) => [text(p, "key"), amount(number(p, "value"))]),
    count(predict, "parameters"), "predict.json") : nothing}${found ? readingTables(found, "readings")
    : html`<p>There is no fit.csv beside predict.json.</p>`}${facts("The prediction in numbers", [
    ["readings", format.number(number(predict, "data.rows"))],
    ["data", text(predict, "data.file") ?? "–"],
    ["times that light was traced", format.number(number(predict, "traces"))],
  ])}</section>
`;
}
