// The plans of murk follow (follow.json, moves.csv): coverage with its error and bound against time, sensors that
// moved, what each step took over from the one before; steps, failed steps and moves as tables.
import { chart } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { column, count, items, number, parsed, table as csv, text } from "./results.js";
import { amount, plain, share, table, word } from "./tables.js";

const TIME = "time, s";

const ratio = (part, whole) => whole > 0 ? part / whole : NaN;
const takenOver = (row, kept, made) => ratio(number(row, kept), number(row, kept) + number(row, made));

const line = (name, rows, y) => ({ name, isLine: true, points: rows.map((row) => ({ x: number(row, "t_s"), ...y(row) })) });
const value = (of) => (row) => ({ y: of(row) });

const covered = (rows) => chart({ title: "Coverage of the plan of each step, with its 95 % interval, and the bound of its sample",
  xTitle: TIME, yTitle: "coverage", yKind: "share" }, [
  line("coverage", rows, (row) => {
    const y = number(row, "coverage"), error = 1.96 * number(row, "standard_error");
    return { y, low: y - error, high: y + error };
  }),
  line("upper bound, in sample", rows, value((row) => number(row, "upper"))),
]);

// The first step places all sensors, which is no move.
const moved = (rows) => chart({ title: "Sensors that were moved or added at each step after the first",
  xTitle: TIME, yTitle: "sensors", yKind: "whole" }, [
  { name: "moved or added", points: rows.slice(1).map((row) => ({ x: number(row, "t_s"), y: number(row, "moved") })) },
]);

const kept = (rows) => chart({ title: "Share of the work that each step took over from the step before", xTitle: TIME,
  yTitle: "taken over", yKind: "share" }, [
  line("photons", rows, value((row) => takenOver(row, "photons_kept", "photons_traced"))),
  line("sightlines", rows, value((row) => takenOver(row, "pairs_kept", "pairs_looked"))),
]);

const seconds = (rows) => chart({ title: "Time that each step took", xTitle: TIME, yTitle: "time of the step, s" }, [
  line("time of the step", rows, value((row) => number(row, "seconds"))),
]);

const stepTable = (follow, rows) => table("The steps",
  ["step", "time, s", "coverage", "upper bound", "moved", "photons traced", "taken over", "sightlines tested", "taken over", "seconds"],
  rows.map((row) => [format.number(number(row, "step")), amount(number(row, "t_s")),
    share(number(row, "coverage"), number(row, "standard_error")), share(number(row, "upper")), amount(number(row, "moved")),
    amount(number(row, "photons_traced")), share(takenOver(row, "photons_kept", "photons_traced")),
    amount(number(row, "pairs_looked")), share(takenOver(row, "pairs_kept", "pairs_looked")), amount(number(row, "seconds"))]),
  count(follow, "steps"), "follow.csv");

function failed(rows) {
  const wrong = rows.filter((row) => text(row, "failed"));
  return wrong.length > 0 ? table("Steps that failed, and so have no plan", ["step", "time, s", "<why"], wrong.map((row) =>
    [format.number(number(row, "step")), amount(number(row, "t_s")), word(text(row, "failed"))])) : nothing;
}

const place = (row, of, end) => {
  const at = ["x", "y", "z"].map((axis) => parsed(of(`${end}_${axis}_m`)(row)));
  return plain(at.some(Number.isNaN) ? format.number(NaN) : at.map((v) => format.power(v, 6)).join(", "));
};

function moves(found) {
  if (!found || found.rows.length === 0) return nothing;
  const of = (name) => column(found, name), angle = (row, name) => amount(parsed(of(name)(row)));
  return table("What became of each sensor", ["step", "time, s", "sensor", "<change", "<type", "from x, y, z, m", "to x, y, z, m",
    "heading, degrees", "tilt, degrees"], found.rows.map((row) => [of("step")(row), plain(of("t_s")(row)), plain(of("sensor")(row)),
    word(of("change")(row)), word(of("type")(row)), place(row, of, "from"), place(row, of, "to"), angle(row, "heading_deg"),
    angle(row, "tilt_deg")]), found.inFile, "moves.csv");
}

export function follow({ follow }) {
  if (follow === undefined) return nothing;
  const rows = items(follow, "steps");
  return html`<section id="follow" data-title="Step by step">
<h2>Step by step</h2>
<p class="note">Each step is the scene at one time of its timeline, with a plan of its own. The results of a step lie in
the folder steps, under its number; <code>murk report</code> makes a page of one, such as of steps/0003.</p>
<div class="plans">
${covered(rows)}${moved(rows)}${kept(rows)}${seconds(rows)}</div>
${failed(rows)}${stepTable(follow, rows)}${moves(csv("moves.csv"))}</section>
`;
}
