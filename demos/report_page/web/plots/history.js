// Time histories with one zoom for all plots of a run. What is drawn is decimated to the pixels of
// the plot, keeping every peak; what tests see are the run's own numbers.
import { decimate, Pyramid } from "../analysis/decimate.js";
import { firstFrom } from "../analysis/statistics.js";
import { h } from "./dom.js";
import { Figure } from "./figure.js";
import { seconds } from "./format.js";

/** The range of time that all plots of a run show; who listens is told of a new one. */
export class Window {
  constructor(t) {
    this.t = t;
    this.all = [t[0], t[t.length - 1]];
    [this.from, this.to] = this.all;
    this.listeners = new Set();
  }

  set(from, to) {
    const [least, most] = this.all;
    const width = Math.min(Math.max(to - from, 20 * (this.t[1] - this.t[0])), most - least);
    const begin = Math.min(Math.max(from, least), most - width);
    if (begin === this.from && begin + width === this.to) return;
    [this.from, this.to] = [begin, begin + width];
    this.tell();
  }

  tell() {
    for (const listener of this.listeners) listener();
  }

  zoom(by, middle = (this.from + this.to) / 2) {
    this.set(middle - (middle - this.from) * by, middle + (this.to - middle) * by);
  }

  move(share) {
    const way = share * (this.to - this.from);
    this.set(this.from + way, this.to + way);
  }

  showAll() {
    this.set(...this.all);
  }
}

/** Buttons of a window, and what it shows. */
export function windowControls(window) {
  const words = h("span.label", { "aria-live": "polite" });
  const say = () => {
    words.textContent = `${seconds(window.from)} to ${seconds(window.to)} s`;
  };
  window.listeners.add(say);
  say();
  const button = (text, label, onclick) =>
    h("button.quiet", { type: "button", "aria-label": label, title: label, onclick }, text);
  return h("div.controls", {}, h("span.label", {}, "Shown"), words,
    h("span.control", {}, button("◀", "Earlier", () => window.move(-0.5)),
      button("▶", "Later", () => window.move(0.5)), button("+", "Zoom in", () => window.zoom(0.5)),
      button("−", "Zoom out", () => window.zoom(2)),
      button("all", "Show the whole run", () => window.showAll())),
    h("span.label", {}, "Drag over a plot to zoom, double-click to see all."));
}

/** A plot of one column over time. */
export class History {
  /** @param spec {id, title, unit, tight, height}; t and values of equal length */
  constructor(parent, spec, window, t, values) {
    Object.assign(this, { window, t, values, pyramid: new Pyramid(values) });
    this.figure = new Figure(parent, {
      id: spec.id, title: spec.title, height: spec.height ?? 130, wide: true, sync: window.key,
      x: { symbol: "t", unit: "s", ticksWithUnit: true, range: () => [window.from, window.to],
        show: (time) => String(Number(time.toFixed(3))) },
      y: { label: "", unit: spec.unit, tight: true, exponent: spec.exponent },
      all: () => window.showAll(), onzoom: (from, to) => window.set(from, to),
      zoom: (by, middle) => window.zoom(by, middle), onfit: () => this.draw(),
    });
    this.update = () => this.draw();
    window.listeners.add(this.update);
    this.draw();
  }

  draw() {
    const { window, t, values } = this;
    const begin = Math.max(0, firstFrom(t, window.from) - 1);
    const end = Math.min(t.length, firstFrom(t, window.to) + 2);
    const indexes = decimate(this.pyramid, begin, end, this.figure.width());
    const line = { label: this.figure.spec.title, width: 1.2,
      x: Float64Array.from(indexes, (i) => t[i]),
      y: Array.from(indexes, (i) => (values[i] === values[i] ? values[i] : null)) };
    this.figure.setData([line], [{ ...line, x: t, y: values }]);
  }

  destroy() {
    this.window.listeners.delete(this.update);
    this.figure.destroy();
  }
}
