// Where the light went (ledger.json, or that of each condition).
import { bars } from "./charts.js";
import * as format from "./format.js";
import { html, nothing } from "./html.js";
import { at, count, entries, items, number, text } from "./results.js";
import { amount, facts, share, table } from "./tables.js";

const BANDS_MAX = 16, ABSORBERS_MAX = 200;
const WAYS = [["absorbed_surfaces_w", "absorbed by surfaces", "absorbed_by_material_w"],
  ["absorbed_media_w", "absorbed by media", "absorbed_by_medium_w"],
  ["escaped_w", "escaped"], ["lost_w", "lost to rounding and limits"]];
const WAY_NAMES = WAYS.map(([, name]) => name);

// Of {"total": .., "bands": [..]}: the band, or the total for -1.
const watts = (of, band) => band < 0 ? number(of, "total") : number(items(of, "bands")[band]);

const shares = (ledger, band = -1) => {
  const emitted = watts(at(ledger, "emitted_w"), band);
  return WAYS.map(([key]) => emitted > 0 ? watts(at(ledger, key), band) / emitted : NaN);
};

const ways = (title, rows) => bars({ title, rows, axisTitle: "share of what was emitted", kind: "share", parts: WAY_NAMES });

function balance(ledger, names) {
  const emitted = at(ledger, "emitted_w"), all = number(emitted, "total");
  const row = (name, of) => [name, amount(number(of, "total")), share(all > 0 ? number(of, "total") / all : NaN),
    ...names.map((_, b) => amount(watts(of, b)))];
  // what is named in the scene and met by no photon is left out
  const absorbers = (key) => entries(ledger, key).slice(0, ABSORBERS_MAX).filter(([, of]) => number(of, "total") !== 0)
    .map(([name, of]) => row(`of that by ${name}`, of));
  return table("Energy balance", ["where", "W", "of what was emitted", ...names.map((name) => `${name}, W`)],
    [row("emitted", emitted), ...WAYS.flatMap(([key, name, by]) => [row(name, at(ledger, key)), ...(by ? absorbers(by) : [])])]);
}

function photons(ledger) {
  const of = (key) => format.number(number(ledger, key));
  return facts("Photons", [
    ["left the lights", of("photons_emitted")],
    ["collisions in media", of("collisions")],
    ["given up after too many events", of("lost.events")],
    ["given up after too many wraps", of("lost.wraps")],
    ["lost to rounding", of("lost.numerical")],
  ]);
}

// A bar for each condition; the ledger of each is a file of its own.
const byCondition = (plan, ledgers) => html`${ways("Where the light went, by condition", items(plan, "conditions")
  .map((one) => text(one, "name") ?? "").map((name) => ({ name, values: shares(Object.hasOwn(ledgers, name) ? ledgers[name] : undefined) })))}
<p>In watts, and by what absorbed it, it is in the file ledger-NAME.json of each condition.</p>`;

function byBand(ledger, bandsNm) {
  const bands = Math.min(count(ledger, "emitted_w.bands"), BANDS_MAX);
  const names = Array.from({ length: bands }, (_, b) => b < bandsNm.length ? `${Number(bandsNm[b].toPrecision(6))} nm` : `band ${b + 1}`);
  const several = bands > 1 ? names : [];
  return html`${ways(bands > 1 ? "Where the light went, by band" : "Where the light went",
    [{ name: "all light", values: shares(ledger) }, ...several.map((name, b) => ({ name, values: shares(ledger, b) }))])}${
    balance(ledger, several)}${photons(ledger)}`;
}

export function light({ plan, ledger, ledgers, bands_nm: bandsNm }) {
  if (ledger === undefined && count(plan, "conditions") === 0) return nothing;
  return html`<section id="light" data-title="Light">
<h2>Where the light went</h2>
${ledger === undefined ? byCondition(plan, ledgers) : byBand(ledger, bandsNm)}</section>
`;
}
