// A colour map that reads alike for colour-blind eyes and in grey: viridis, from its published
// values at nine places. Pure.

const STOPS = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142],
  [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44], [253, 231, 37]];

/** Share 0..1 -> [r, g, b] of 0..255. */
export function viridis(share) {
  const at = Math.min(1, Math.max(0, share)) * (STOPS.length - 1);
  const left = Math.min(STOPS.length - 2, Math.floor(at)), rest = at - left;
  return STOPS[left].map((value, i) => value + rest * (STOPS[left + 1][i] - value));
}

/** The map from left to right as a CSS gradient. */
export const gradient = () => `linear-gradient(to right, ${STOPS.map((stop) =>
  `rgb(${stop.join(",")})`).join(",")})`;

/** {least, most} of what is finite; equal values get a width. */
export function rangeOf(values) {
  let least = Infinity, most = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  if (least > most) return { least: 0, most: 1 };
  return least === most ? { least: least - 0.5, most: most + 0.5 } : { least, most };
}
