// Numbers as the page shows them, in the form that the page's sentences have (src/report/html.c).
const NONE = "–", SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const WHOLE_MAX = 1e10; // whole numbers below it are written out

const exponent = (e) => `10${e < 0 ? "⁻" : ""}${[...String(Math.abs(e))].map((d) => SUPERSCRIPT[d]).join("")}`;

// To so many digits; very large and very small numbers as 2.5·10¹³.
export function power(value, digits) {
  const [mantissa, e] = value.toExponential(digits - 1).split("e").map(Number);
  if (e >= -4 && e < digits) return String(Number(value.toPrecision(digits)));
  return (mantissa === 1 ? "" : `${mantissa}·`) + exponent(e);
}

export function number(value) {
  if (!Number.isFinite(value)) return NONE;
  return Number.isInteger(value) && Math.abs(value) < WHOLE_MAX ? String(value) : power(value, 5);
}

// Decimals that two digits of an error need; negative: the error ends before the point.
function decimalsOf(error) {
  const e = Math.floor(Math.log10(error));
  return 1 - e - (error / 10 ** e >= 9.95 ? 1 : 0); // .0996 is .10 to two digits
}

// With its standard error, to two digits of it: 1.235 ± 0.023, (8.90 ± 0.15)·10¹⁴.
export function estimate(value, error) {
  if (!(Number.isFinite(value) && Number.isFinite(error) && error > 0)) return number(value);
  const e = Math.floor(Math.log10(Math.max(Math.abs(value), error))), isPower = e >= 6 || e < -4;
  const unit = isPower ? 10 ** e : 1, small = error / unit, decimals = small > 0 ? decimalsOf(small) : 99;
  if (!(unit > 0 && decimals <= 12)) return `${power(value, 5)} ± ${power(error, 2)}`;
  const ten = 10 ** Math.max(-decimals, 0), shown = Math.max(decimals, 0);
  const [a, b] = [value / unit, small].map((v) => (decimals < 0 ? ten * Math.round(v / ten) : v).toFixed(shown));
  return isPower ? `(${a} ± ${b})·${exponent(e)}` : `${a} ± ${b}`;
}

// A share 0..1 in per cent.
export function share(value, error = NaN) {
  if (!Number.isFinite(value)) return NONE;
  const shown = (100 * value).toFixed(2);
  return Number.isFinite(error) ? `${shown} ± ${(100 * error).toFixed(2)} %` : `${shown} %`;
}

export const counted = (n, one, more) => `${number(n)} ${n === 1 ? one : more}`;
