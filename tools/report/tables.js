// Tables in a box that scrolls, also by keyboard.
import * as format from "./format.js";
import { html, nothing } from "./html.js";

export const ROWS_MAX = 200; // that a table of the page shows; all are in the files

// Cells of a row: a text that is set from the left, a number, a share, an estimate, a number on a shade -1..1.
export const word = (value) => html`<td class="text">${value}</td>`;
export const plain = (value) => html`<td>${value}</td>`;
export const amount = (value) => plain(format.number(value));
export const share = (value, error) => plain(format.share(value, error));
export const estimate = (value, error) => plain(format.estimate(value, error));
export function shaded(shade, text) {
  const step = Math.ceil(6 * Math.min(Math.abs(shade), 1));
  return step > 0 ? html`<td class="${shade < 0 ? "minus" : "plus"}${step}">${text}</td>` : plain(text);
}

// A key may be broken behind its dots, underscores and slashes.
const broken = (head) => head.split(/(?<=[._/])(?=.)/).map((part, i) => i > 0 ? html`<wbr>${part}` : html`${part}`);

// A head that begins with '<' stands over a column of texts; the mark is not shown.
const heading = (head) => head.startsWith("<") ? html`<th scope="col" class="text">${broken(head.slice(1))}</th>`
  : html`<th scope="col">${broken(head)}</th>`;

// rows: [first cell, other cells...]; all: how many there are, and the file that has them.
export function table(caption, heads, rows, all = rows.length, file = "") {
  const shown = rows.slice(0, ROWS_MAX);
  return html`<div class="table" tabindex="0" role="region" aria-label="${caption}">
<table>
<caption>${caption}</caption>
${heads.length > 0 ? html`<thead><tr>${heads.map(heading)}</tr></thead>` : nothing}
<tbody>${shown.map(([head, ...cells]) => html`<tr><th scope="row">${head}</th>${cells}</tr>
`)}</tbody>
</table>
</div>
${all > shown.length && file ? html`<p class="note">The first ${shown.length} of ${all} rows; all are in ${file}.</p>` : nothing}`;
}

// Rows of a name and a text; those without a text are left out.
export const facts = (caption, rows) => table(caption, [], rows.filter(([, value]) => value !== undefined)
  .map(([name, value]) => [name, word(value)]));
