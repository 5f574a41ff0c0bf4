// Markup by templates. Whatever stands in a template as a value is text and is escaped, so that no name of
// a scene can become a tag; only what another template made is markup.
const ENTITIES = { "<": "&lt;", ">": "&gt;", "&": "&amp;", '"': "&quot;", "'": "&#39;" };

class Markup {
  constructor(text) {
    this.text = text;
  }
}

const escaped = (text) => String(text)
  .replace(/[<>&"']/g, (c) => ENTITIES[c])
  .replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/g, "\ufffd");

function shown(value) {
  if (value instanceof Markup) return value.text;
  if (Array.isArray(value)) return value.map(shown).join("");
  return value === undefined || value === null || value === false ? "" : escaped(value);
}

export function html(strings, ...values) {
  return new Markup(strings.reduce((out, part, i) => out + shown(values[i - 1]) + part));
}

export const nothing = html``;
