// Polar plots over heading, as SVG: the bow is up, and a point lies where the waves come from.
// Values are read by pointer or by the arrow keys.
import { h } from "./dom.js";
import { degrees, show } from "./format.js";

const SIZE = 420, RADIUS = 160, MIDDLE = SIZE / 2;

function svg(name, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== null) element.setAttribute(key, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** Place of a heading at a distance: 180° (head seas) is up, 90° (from port) is left. */
export function place(headingDeg, distance) {
  const angle = headingDeg * Math.PI / 180;
  return [MIDDLE - distance * Math.sin(angle), MIDDLE - distance * -Math.cos(angle)];
}

/** A round step so that there are three to five rings up to `most`. */
export function ringStep(most) {
  if (!(most > 0)) return 1;
  const decade = 10 ** Math.floor(Math.log10(most / 3));
  return [1, 2, 2.5, 5, 10].map((step) => step * decade).find((step) => most / step <= 5);
}

const ship = () => svg("path", { class: "hull",
  d: `M${MIDDLE} ${MIDDLE - 22}c5 9 6 16 6 24l-1.5 18h-9l-1.5-18c0-8 1-15 6-24z` });

function rings(most, step) {
  const parts = [svg("circle", { class: "ring", cx: MIDDLE, cy: MIDDLE, r: RADIUS })];
  for (let value = step; value <= most * 1.0001; value += step) {
    const radius = RADIUS * value / most, [x, y] = place(112.5, radius);
    parts.push(svg("circle", { class: "ring", cx: MIDDLE, cy: MIDDLE, r: radius }),
      svg("text", { class: "tick", x, y: y + 4 }, String(Number(value.toPrecision(3)))));
  }
  for (let heading = 0; heading < 360; heading += 30) {
    const [x, y] = place(heading, RADIUS), [tx, ty] = place(heading, RADIUS + 17);
    parts.push(svg("line", { class: "ring", x1: MIDDLE, y1: MIDDLE, x2: x, y2: y }));
    const words = { 0: "following 0°", 180: "head 180°" }[heading] ?? degrees(heading);
    parts.push(svg("text", { class: "label", x: tx, y: ty + 4 }, words));
  }
  return parts;
}

function outline(headings, values, most, closed) {
  const points = headings.map((heading, i) =>
    place(heading, RADIUS * Math.min(values[i], most) / most));
  const text = points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`);
  return text.join("") + (closed ? "Z" : "");
}

export class Polar {
  /** @param spec {id, title, unit, most: greatest radius if fixed, fill} */
  constructor(parent, spec) {
    this.spec = spec;
    this.readout = h("output.readout.under", { "aria-live": "polite" });
    this.legend = h("div.legend");
    this.canvas = h("div.polar", {
      tabindex: 0, role: "group",
      "aria-label": `${spec.title}. Arrow keys read values heading by heading.`,
      onkeydown: (event) => this.key(event),
      onpointermove: (event) => this.point(event),
      onpointerleave: () => this.read(-1),
    });
    this.name = h("span.name", {});
    this.unit = h("span.unit", {});
    this.element = h("figure", { id: `figure-${spec.id}` },
      h("figcaption", {}, this.name, this.unit), this.legend, this.canvas, this.readout);
    parent.append(this.element);
  }

  /**
   * @param lines [{label, values, colour, words: text beside each value}]; @param limit a circle;
   * values may be Infinity, which lies on the rim
   */
  set(headings, lines, { title, unit, limit = null, most = null, closed = true }) {
    Object.assign(this, { headings, lines, unitName: unit });
    this.name.textContent = title;
    this.unit.textContent = `[${unit}]`;
    const finite = lines.flatMap(({ values }) => values.filter(Number.isFinite));
    const top = most ?? (Math.max(0, ...finite, limit ?? 0) || 1);
    const step = ringStep(top);
    this.most = most ?? step * Math.ceil(top / step - 1e-9);
    window.cutwater.plots[this.spec.id] = { title, x: headings,
      series: lines.map(({ label, values }) => ({ label, values })) };
    this.legend.replaceChildren(...(lines.length > 1 ? lines.map((line, i) =>
      h("span", {}, this.swatch(line, i), line.label)) : []));
    this.drawing = svg("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, role: "img",
      "aria-label": title }, ...rings(this.most, step), ship(),
    ...lines.map((line, i) => svg("path", { class: this.spec.fill ? "line fill" : "line",
      style: `--c: var(--line${((line.colour ?? i) % 8) + 1})`,
      d: outline(headings, line.values, this.most, closed) })),
    limit === null || limit > this.most ? null : svg("circle", { class: "limit", cx: MIDDLE,
      cy: MIDDLE, r: RADIUS * limit / this.most }));
    this.hand = svg("g", {});
    this.drawing.append(this.hand);
    this.canvas.replaceChildren(this.drawing);
    this.read(-1);
  }

  swatch(line, i) {
    const mark = h("i.stroke", { "aria-hidden": "true" });
    mark.style.setProperty("--swatch", `var(--line${((line.colour ?? i) % 8) + 1})`);
    return mark;
  }

  point(event) {
    const box = this.drawing.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width * SIZE - MIDDLE;
    const y = (event.clientY - box.top) / box.height * SIZE - MIDDLE;
    const heading = (Math.atan2(-x, y) * 180 / Math.PI + 360) % 360;
    const away = (at) => Math.abs(((at - heading + 540) % 360) - 180);
    let nearest = 0;
    this.headings.forEach((at, i) => {
      if (away(at) < away(this.headings[nearest])) nearest = i;
    });
    this.read(nearest);
  }

  key(event) {
    const step = { ArrowRight: -1, ArrowDown: -1, ArrowLeft: 1, ArrowUp: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const n = this.headings.length;
    this.read(((this.at ?? (step > 0 ? -1 : 0)) + step + n) % n);
  }

  read(i) {
    this.at = i < 0 ? null : i;
    this.hand.replaceChildren();
    if (i < 0) {
      this.readout.textContent = "";
      return;
    }
    const values = this.lines.map(({ label, values: v, words }) => {
      const value = Number.isFinite(v[i]) ? `${show(v[i], 3)} ${this.unitName}` : "no limit";
      return [this.lines.length > 1 ? `${label}:` : "", value, words?.[i] ?? ""].join(" ").trim();
    });
    this.readout.textContent = [`heading ${degrees(this.headings[i])}`, ...values].join("\n");
    this.lines.forEach((line, k) => {
      const [cx, cy] = place(this.headings[i],
        RADIUS * Math.min(line.values[i], this.most) / this.most);
      this.hand.append(svg("circle", { class: "hand", cx, cy, r: 4,
        style: `--c: var(--line${((line.colour ?? k) % 8) + 1})` }));
    });
  }
}
