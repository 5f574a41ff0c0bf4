// A placement, made (plan.json) or measured (coverage.json): numbers, curve and bound, each sensor, conditions,
// what may go wrong, the way of who explores, other seeds.
import { bars, chart } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { at, column, count, items, number, parsed, table as csv, text } from "./results.js";
import { amount, facts, shaded, share, table, word } from "./tables.js";

const HALF_INTERVAL = 1.96; // half a 95 % interval, in standard errors
const CONDITIONS_MAX = 40; // conditions that are drawn
const COLUMNS_MAX = 24; // conditions that have a column
const REGRET_SHADE = 4; // a regret of a quarter has the deepest shade

const interval = (value, error) => ({ low: value - HALF_INTERVAL * error, high: value + HALF_INTERVAL * error });
const hasTargets = (plan) => number(plan, "targets.points") > 0;
const rowsOf = (list, cells) => list.map((item, i) => [String(i + 1), ...cells(item)]);

// ---- numbers ----

function numbers(plan, isMade) {
  const ofTargets = hasTargets(plan);
  const shareOf = (key, errorKey = "") => Number.isFinite(number(plan, key)) ? format.share(number(plan, key), number(plan, errorKey)) : undefined;
  const amountOf = (key) => Number.isFinite(number(plan, key)) ? format.number(number(plan, key)) : undefined;
  return facts("The placement in numbers", [
    [isMade ? "in sample: the sample that it was chosen by" : "coverage",
      shareOf("coverage.in_sample", isMade ? "coverage.in_sample_standard_error" : "coverage.standard_error")],
    ["held out: an independent sample", shareOf("coverage.held_out", "coverage.held_out_standard_error")],
    [ofTargets ? "of targets on surfaces" : "of light on surfaces", shareOf("coverage.surface", "coverage.surface_standard_error")],
    [ofTargets ? "of targets in the volume" : "of light scattered in media", shareOf("coverage.volume", "coverage.volume_standard_error")],
    ["ceiling: all candidates at once", shareOf("coverage.ceiling")],
    ["upper bound", shareOf("bound.upper")],
    ["gap to the bound", shareOf("bound.gap")],
    ["proven optimal", text(plan, "bound.proven_optimal")],
    ["what the method guarantees", text(plan, "bound.guarantee")],
    ["method", text(plan, "placement.method")],
    ["detection", text(plan, "placement.detection")],
    ["knowledge", text(plan, "placement.knowledge")],
    [ofTargets ? "views of a target that count" : "views of a photon that count", amountOf("placement.redundancy")],
    ["candidates asked for", amountOf("candidates.asked")],
    ["candidates that were usable", amountOf("candidates.usable")],
    ["plans weighed", amountOf("placement.evaluations")],
    ["visibility queries", amountOf("placement.queries")],
    ["rows of sightlines computed", amountOf("placement.looks")],
    ["shadow rays", amountOf("placement.shadow_rays")],
    ["what surfaces have in the coverage", shareOf("weights_used.surface")],
    ["what media have in the coverage", shareOf("weights_used.volume")],
    ...(ofTargets ? [
      ["targets", amountOf("targets.points")],
      ["targets on sides of surfaces", amountOf("targets.surface")],
      ["targets in the volume", amountOf("targets.volume")],
    ] : [
      ["photons emitted", amountOf("photons.emitted")],
      ["photons stored on surfaces", amountOf("photons.surface")],
      ["photons stored in media", amountOf("photons.volume")],
    ]),
  ]);
}

function curve(plan) {
  const list = items(plan, "curve").map((step) => ({
    x: number(step, "count"), coverage: number(step, "coverage"), upper: number(step, "upper"),
  }));
  if (list.length === 0) return nothing;
  return html`<div>
<h3>Coverage curve</h3>
${chart({
    title: "Coverage by number of sensors, and how much more could be had at most (on the map that was chosen by)",
    xTitle: "sensors", yTitle: "coverage", xKind: "whole", yKind: "share",
  }, [
    { name: "coverage", isLine: true, points: list.map((p) => ({ x: p.x, y: p.coverage, low: p.coverage, high: p.upper })) },
    { name: "no plan sees more", isLine: true, points: list.map((p) => ({ x: p.x, y: p.upper })) },
  ])}<details><summary>The curve as a table</summary>
${table("Coverage by number of sensors", ["sensors", "coverage", "upper bound"],
    list.map((p) => [format.number(p.x), share(p.coverage), share(p.upper)]), count(plan, "curve"), "plan.json")}</details>
</div>
`;
}

// Of the plan, and of each condition: in sample and held out beside each other.
function samples(plan) {
  if (!Number.isFinite(number(plan, "coverage.held_out"))) return nothing;
  const conditions = items(plan, "conditions").slice(0, CONDITIONS_MAX), all = [at(plan, "coverage"), ...conditions];
  const series = [["in sample", "in_sample", -0.08], ["held out", "held_out", 0.08]].map(([name, key, beside]) => ({
    name,
    points: all.map((one, i) => ({
      x: i + beside, y: number(one, key), ...interval(number(one, key), number(one, `${key}_standard_error`)),
    })),
  }));
  return html`<div>
<h3>In sample against held out</h3>
<p>A plan is chosen to suit one sample, so it looks better on that than it is. The held-out value is the one to quote.</p>
${chart({
    title: "In sample against held out, each with its 95 % interval", xTitle: conditions.length > 0 ? "measured in" : "",
    yTitle: "coverage", yKind: "share", names: ["the plan", ...conditions.map((one) => text(one, "name") ?? "")],
  }, series)}</div>
`;
}

// ---- sensors ----

const place = (item) => [0, 1, 2].map((k) => amount(number(items(item, "position_m")[k])));

function sensorTable(plan, isMatrix, file) {
  const cells = (s) => [...(isMatrix
    ? [amount(number(s, "column")), word(text(s, "name")), amount(number(s, "cost"))]
    : [word(text(s, "type")), ...place(s), amount(number(s, "heading_deg")), amount(number(s, "tilt_deg"))]),
  share(number(s, "covers")), share(number(s, "only_it_covers"))];
  return table(isMatrix ? "The columns" : "The sensors",
    [...(isMatrix ? ["chosen", "column", "<name", "cost"] : ["sensor", "<type", "x m", "y m", "z m", "heading °", "tilt °"]),
      "it covers", "only it covers"], rowsOf(items(plan, "sensors"), cells), count(plan, "sensors"), file);
}

function sensors(plan, isMade) {
  const list = items(plan, "sensors"), n = count(plan, "sensors"), isMatrix = text(plan, "matrix.file") !== undefined;
  const seen = items(plan, "seen_by_at_least").map((v) => number(v)), of = hasTargets(plan) ? "targets" : isMatrix ? "rows" : "light";
  const seenName = (i) => i + 1 < seen.length ? `${i + 1} or more` : `all ${i + 1}`;
  const charts = html`<div class="plans">
${bars({
    title: n > 60 ? "What each sensor covers (the first of them)" : "What each sensor covers",
    axisTitle: `share of the ${isMatrix ? "rows" : of}`, kind: "share", parts: ["only it covers", "it covers, and others do, too"],
    rows: list.map((s, i) => {
      const only = Math.max(number(s, "only_it_covers") || 0, 0), name = text(s, "type") ?? text(s, "name") ?? "";
      return { name: `${i + 1} ${name}`.trimEnd(), values: [only, Math.max((number(s, "covers") || 0) - only, 0)] };
    }),
  })}${bars({
    title: "What so many sensors see at once, by weight, however dimly it is seen",
    axisTitle: `share of the ${isMatrix ? "rows" : of}`, kind: "share",
    rows: seen.map((value, i) => ({ name: seenName(i), values: [value] })),
  })}</div>
`;
  return html`${n > 0 ? html`<h3>${isMatrix ? "Columns" : "Sensors"}</h3>
${sensorTable(plan, isMatrix, isMade ? "plan.json" : "coverage.json")}${charts}` : nothing}${
    seen.length > 0 ? html`<details><summary>The same as a table</summary>
${table("Light seen by at least so many sensors", ["sensors", "see together"],
    seen.map((value, i) => [`${i + 1} or more`, share(value)]), count(plan, "seen_by_at_least"), "seen_by_at_least of the JSON")}</details>
` : nothing}${regions(plan)}`;
}

function regions(plan) {
  const list = items(plan, "regions_of_interest");
  if (list.length === 0) return nothing;
  const ofTargets = Number.isFinite(number(list[0], "targets"));
  return table("Coverage of regions of interest", ["name", "weight", ofTargets ? "targets" : "stored photons", "in sample", "held out"],
    list.map((row) => [text(row, "name"), amount(number(row, "weight")), amount(number(row, ofTargets ? "targets" : "stored_photons")),
      share(number(row, "coverage"), number(row, "standard_error")),
      share(number(row, "held_out"), number(row, "held_out_standard_error"))]), count(plan, "regions_of_interest"), "the JSON");
}

// ---- conditions ----

function conditions(plan) {
  const list = items(plan, "conditions");
  if (list.length === 0) return nothing;
  return html`<h3>Conditions</h3>
${table("The plan in each condition",
    ["condition", "weight", "photons emitted", "stored on surfaces", "in media", "in sample", "held out"],
    list.map((row) => [text(row, "name"),
      ...["weight", "photons.emitted", "photons.surface", "photons.volume"].map((key) => amount(number(row, key))),
      ...["in_sample", "held_out"].map((key) => share(number(row, key), number(row, `${key}_standard_error`)))]),
    count(plan, "conditions"), "plan.json")}${regret(plan, list)}`;
}

// Dark conditions, which come last, are no columns.
function regret(plan, list) {
  const plans = items(plan, "regret.plans");
  const columns = Math.min(COLUMNS_MAX, list.length, Math.max(0, ...plans.map((one) => items(one, "coverage").length)));
  if (columns === 0) return nothing;
  const of = (one, key, c) => number(items(one, key)[c]);
  return html`<h4>Plans made for one condition, used in another</h4>
<p>Each row is a plan, each column a condition; shown is what the plan covers there. The deeper the shade, the more the plan that was made for this condition covers beyond it (its regret).</p>
${table("Coverage by plan and condition", ["made for", ...list.slice(0, columns).map((row) => text(row, "name") ?? ""), "mean", "worst"],
    plans.map((one) => [text(one, "made_for"),
      ...list.slice(0, columns).map((_, c) => shaded(-REGRET_SHADE * of(one, "regret", c) || 0,
        format.share(of(one, "coverage", c), of(one, "standard_error", c)))),
      ...["mean", "worst"].map((key) => share(number(one, key), number(one, `${key}_standard_error`)))]))}`;
}

// ---- when something goes wrong ----

function losses(plan, list) {
  const isHeldOut = Number.isFinite(number(plan, "coverage.held_out")), key = isHeldOut ? "held_out" : "in_sample";
  return bars({
    title: `Coverage lost where one sensor fails, ${isHeldOut ? "held out" : "in sample"}`, axisTitle: "coverage lost", kind: "share",
    rows: list.map((one) => ({
      name: `without ${format.number(number(one, "sensor"))}`, values: [number(plan, `coverage.${key}`) - number(one, key)],
    })),
  });
}

function jitterChart(jitter) {
  const of = (key) => number(jitter, key), mean = of("mean");
  return chart({
    title: `Coverage where sensors stand up to ${format.power(of("jitter_m") || 0, 4)} m and ${
      format.power(of("jitter_deg") || 0, 4)}° off, by ${format.number(of("draws"))} draws, with 95 % intervals`,
    xTitle: "", yTitle: "coverage", yKind: "share", names: ["as planned", "mean", "worst twentieth begins"],
  }, [{
    name: "coverage",
    points: [{ x: 0, y: of("as_planned") }, { x: 1, y: mean, ...interval(mean, of("mean_standard_error")) },
      { x: 2, y: of("quantile_5"), low: of("quantile_5_lower"), high: of("quantile_5_upper") }],
  }]);
}

function jitterTable(jitter) {
  const of = (key) => number(jitter, key);
  return facts("Not quite in place", [
    ["off by at most", `${format.number(of("jitter_m"))} m`],
    ["turned by at most", `${format.number(of("jitter_deg"))} °`],
    ["draws", format.number(of("draws"))],
    ["as planned", format.share(of("as_planned"))],
    ["mean", format.share(of("mean"), of("mean_standard_error"))],
    ["in 19 of 20 draws at least", format.share(of("quantile_5"))],
    ["which is surely (95 %) at least", format.share(of("quantile_5_lower"))],
    ["and at most", format.share(of("quantile_5_upper"))],
    ["draws of a place that stayed", format.number(of("unmoved"))],
  ]);
}

function links(robust) {
  const range = number(robust, "link_range_m"), groups = number(robust, "link_groups"), straight = number(robust, "plain_link_range_m");
  const list = items(robust, "links");
  if (!Number.isFinite(groups)) return nothing;
  return html`<h4>Links between sensors</h4>
<p>${Number.isFinite(range) ? `All sensors are joined by open ways when each link may be ${format.number(range)} m long.`
    : `Open ways join the sensors to ${format.counted(groups, "group", "groups")} only, however long the links.`}${
    Number.isFinite(straight) ? ` Were all ways open, ${format.number(straight)} m would do.` : ""}</p>
${list.length > 0 ? table("The links that join them", ["from sensor", "to sensor", "m"],
    list.map((link) => [format.number(number(link, "from")), amount(number(link, "to")), amount(number(link, "length_m"))]),
    count(robust, "links"), "plan.json") : nothing}`;
}

function robustness(plan) {
  const robust = at(plan, "robustness"), jitter = at(robust, "jitter"), list = items(robust, "drop_one.without");
  if (typeof robust !== "object" || robust === null || Array.isArray(robust)) return nothing;
  const hasJitter = Number.isFinite(number(jitter, "mean"));
  return html`<h3>When something goes wrong</h3>
<div class="plans">
${list.length > 1 ? losses(plan, list) : nothing}${hasJitter ? jitterChart(jitter) : nothing}</div>
${hasJitter ? jitterTable(jitter) : nothing}${links(robust)}`;
}

// ---- who explores, and other seeds ----

function exploring(plan) {
  const explore = at(plan, "explore"), steps = items(explore, "steps");
  if (steps.length === 0) return nothing;
  // both begin with nothing
  const against = (title, xTitle, xKind, x) => chart({ title, xTitle, xKind, yTitle: "coverage, in sample", yKind: "share" }, [{
    name: "coverage", isLine: true, points: [{ x: 0, y: 0 }, ...steps.map((step, i) => ({ x: x(step, i), y: number(step, "coverage") }))],
  }]);
  return html`<h3>Exploring</h3>
<p>${format.number(number(explore, "path_m"))} m were gone, and ${format.number(number(explore, "places_seen"))} of ${
    format.number(number(explore, "places"))} places seen on the way. What ended it: ${text(explore, "ended_by")}.</p>
<div class="plans">
${against("Coverage by sensors set up on the way", "step", "whole", (step, i) => i + 1)}${
    against("Coverage along the way that was gone", "way gone, m", "even", (step) => number(step, "path_m"))}</div>
${table("Step by step", ["step", "sensor", "gain", "coverage", "way gone m", "places seen", "queries", "shadow rays"],
    rowsOf(steps, (step) => [amount(number(step, "sensor")), share(number(step, "gain")), share(number(step, "coverage")),
      ...["path_m", "places_seen", "queries", "shadow_rays"].map((key) => amount(number(step, key)))]),
    count(explore, "steps"), "explore.csv")}`;
}

// Each run's values beside each other, about its seed.
function seedChart(runs) {
  const series = [["held out", "held_out", "held_out_standard_error"], ["in sample", "in_sample"],
    ["the plan, on this run's map", "plan", "plan_standard_error"], ["upper bound", "upper"]];
  const of = (row, name) => name ? parsed(column(runs, name)(row)) : NaN;
  return chart({
    title: "The whole job with other seeds; where errors are known, with 95 % intervals",
    xTitle: "seed", yTitle: "coverage", xKind: "whole", yKind: "share",
  }, series.map(([name, key, error], k) => ({
    name,
    points: runs.rows.map((row) => ({ x: of(row, "seed") + 0.08 * (k - 1.5), y: of(row, key), ...interval(of(row, key), of(row, error)) })),
  })));
}

function otherSeeds(plan) {
  const repeat = at(plan, "repeat"), of = (key) => number(repeat, key), runs = csv("repeat.csv");
  if (!Number.isFinite(of("runs"))) return nothing;
  const spread = (name, key, cell) => [name, ...["median", "minimum", "maximum"].map((part) => cell(of(`${key}.${part}`)))];
  return html`<h3>With other seeds</h3>
<p>${format.number(of("runs"))} of ${format.number(of("asked"))} runs were done; the plan is the first one's. On maps that did not choose it it covers ${
    format.share(of("plan.coverage"), of("plan.standard_error"))}.${Number.isFinite(of("gap.lower"))
    ? ` The best plan there is covers more than it by ${format.share(of("gap.value"))} at most, by the mean of the bounds (95 %: ${
      format.share(of("gap.lower"))} to ${format.share(of("gap.upper"))}).` : ""}</p>
<div class="beside">
${table("Over all seeds", ["", "median", "least", "most"], [spread("held out", "held_out", share), spread("in sample", "in_sample", share),
    spread("upper bound", "upper", share), spread("sensors", "sensors", amount)])}${runs ? seedChart(runs) : nothing}</div>
`;
}

export function placement({ plan, coverage }) {
  const of = plan ?? coverage, isMade = plan !== undefined;
  if (of === undefined) return nothing;
  return html`<section id="placement" data-title="Placement">
<h2>${isMade ? "The placement" : "What the sensors see"}</h2>
<div class="beside">
${numbers(of, isMade)}${curve(of)}${samples(of)}</div>
${sensors(of, isMade)}${conditions(of)}${robustness(of)}${exploring(of)}${otherSeeds(of)}</section>
`;
}
