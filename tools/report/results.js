// The results that the page carries, read: JSON values by their paths, CSV files as rows of texts. What is
// missing, or of another kind than a result has, is NaN, undefined or an empty list.
const isMap = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

// What lies under a path such as "coverage.held_out".
export const at = (root, path) => path === "" ? root
  : path.split(".").reduce((value, key) => isMap(value) && Object.hasOwn(value, key) ? value[key] : undefined, root);

export function number(root, path = "") {
  const value = at(root, path);
  return typeof value === "number" && Number.isFinite(value) ? value : NaN;
}

// Of any single value, true and false too.
export function text(root, path = "") {
  const value = at(root, path);
  return ["string", "number", "boolean"].includes(typeof value) ? String(value) : undefined;
}

export const items = (root, path = "") => {
  const value = at(root, path);
  return Array.isArray(value) ? value : [];
};

export const entries = (root, path = "") => {
  const value = at(root, path);
  return isMap(value) ? Object.entries(value) : [];
};

// How many items a list has in its file: the page carries the first ones of a long list.
export const count = (root, path = "") => {
  const list = items(root, path);
  return list.inFile ?? list.length;
};

// A list that was cut stands in the page as its first items and their number in the file.
function revived(key, value) {
  if (!isMap(value) || !Array.isArray(value.first) || typeof value.of !== "number") return value;
  value.first.inFile = value.of;
  return value.first;
}

export const block = (id) => {
  const element = document.getElementById(id);
  return element && JSON.parse(element.textContent, revived);
};

// A number as a CSV file has it; NaN for anything else.
export const parsed = (cell) => /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(cell) && Number.isFinite(Number(cell))
  ? Number(cell) : NaN;

// A CSV file: names of columns and rows by these names. Without scripts the browser shows it as a table;
// with scripts, what stands in <noscript> is text.
export function table(name) {
  const shown = [...document.querySelectorAll("noscript")].map((part) => part.textContent).join("");
  const found = [...new DOMParser().parseFromString(shown, "text/html").querySelectorAll("table")]
    .find((part) => part.dataset.file === name);
  if (!found) return null;
  const cells = (row) => [...row.cells].map((cell) => cell.textContent);
  const [names, ...rows] = [...found.rows].map(cells);
  return { name, names, rows, inFile: Number(found.dataset.rows) };
}

export const column = (csv, name) => {
  const k = csv.names.indexOf(name);
  return (row) => k < 0 ? "" : row[k];
};

export function floats(text) {
  const bytes = Uint8Array.from(atob(text ?? ""), (c) => c.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}
