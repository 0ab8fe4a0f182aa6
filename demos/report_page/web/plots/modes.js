// The six modes of motion and what the page writes beside them. Pure.

export const MODES = ["surge", "sway", "heave", "roll", "pitch", "yaw"];
export const DEGREES = 180 / Math.PI;

/** Modes are counted from 0 here: 0 to 2 are displacements, 3 to 5 rotations. */
export const rotates = (mode) => mode > 2;

/** [re, im] of a mode in an array [heading][omega][mode][re, im] or, with heading 0, without it. */
export function complexAt(values, count, heading, i, mode) {
  const at = ((heading * count + i) * 6 + mode) * 2;
  return [values[at], values[at + 1]];
}

/** Phase in degrees, −180 to 180: lead over the crest at G. */
export const phaseDegrees = ([re, im]) => Math.atan2(im, re) * DEGREES;

/** "heave" -> "Heave" */
export const title = (name) => name[0].toUpperCase() + name.slice(1);

/** Unit of a coefficient of the pair "jk": `linear` for two displacements, metres for rotations. */
export function pairUnit(pair, linear) {
  const turns = [...pair].filter((mode) => Number(mode) > 3).length;
  const [top, bottom] = linear.split("/");
  return `${top}${["", "·m", "·m²"][turns]}${bottom ? `/${bottom}` : ""}`;
}
