// Numbers and units as people read them. Pure.

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const SUBSCRIPT = "₀₁₂₃₄₅₆₇₈₉";

const digitsIn = (text, digits) => String(text).replace(/\d/g, (d) => digits[d])
  .replace("-", "⁻");

/** "33" -> "₃₃" */
export const subscript = (text) => digitsIn(text, SUBSCRIPT);

/** Greatest |value|, 0 of none; what is not finite is left out. */
export function greatest(values) {
  let most = 0;
  for (const value of values) {
    const size = Math.abs(value);
    if (size > most && size < Infinity) most = size;
  }
  return most;
}

/** Exponent of three (…, −3, 0, 3, 6 …) by which an axis up to `most` is divided. */
export function exponentFor(most) {
  if (!(most > 0) || (most >= 0.01 && most < 10000)) return 0;
  return 3 * Math.floor(Math.log10(most) / 3);
}

/** "kg" and 6 -> "10⁶ kg" */
export function scaledUnit(unit, exponent) {
  if (!exponent) return unit;
  return `10${digitsIn(exponent, SUPERSCRIPT)}${unit ? ` ${unit}` : ""}`;
}

/** A number with about `digits` significant digits, with a true minus sign; "–" of what is none. */
export function show(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(Number(value))) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  let text;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, power] = Number(value).toExponential(digits - 1).split("e");
    text = `${mantissa}·10${digitsIn(Number(power), SUPERSCRIPT)}`;
  } else {
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    text = Number(value).toFixed(Math.min(decimals, 8));
  }
  return text.replace("-", "−");
}

/** Units in the form in which the page writes them. */
export function unitText(unit) {
  return (unit ?? "").replace(/\bdeg\b/g, "°").replace(/\^2/g, "²").replace(/\^3/g, "³")
    .replace(/\^4/g, "⁴").replace(/ (?=[a-zA-Z])/g, "·");
}

/** An angle in degrees without needless zeros: "150°", "22.5°". */
export const degrees = (angle) => `${Number(angle.toFixed(1))}°`.replace("-", "−");

/** A time to a hundredth of a second, without needless zeros. */
export const seconds = (time) => String(Number(time.toFixed(2)));
