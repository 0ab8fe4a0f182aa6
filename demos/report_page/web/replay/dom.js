// Small helpers for the controls: text that is written only when it changes, times as a clock shows
// them.

export function setText(node, value) {
  if (node.textContent !== value) node.textContent = value;
}

/// t [s] as m:ss.s, or h:mm:ss.s.
export function clock(t) {
  const s = Math.abs(t);
  const h = Math.floor(s / 3600);
  const m = Math.floor((s % 3600) / 60);
  const rest = (s % 60).toFixed(1).padStart(4, "0");
  const text = h > 0 ? `${h}:${String(m).padStart(2, "0")}:${rest}` : `${m}:${rest}`;
  return t < 0 ? `−${text}` : text;
}
