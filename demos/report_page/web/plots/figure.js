// A plot with its title, legend, hover values and keyboard: a thin layer over uPlot. Lines may have
// abscissae of their own. Numbers are kept as they are; axes divide by a power of ten that the unit
// names. What is drawn is listed in window.cutwater.plots[id].
import uPlot from "uplot";
import { h } from "./dom.js";
import { exponentFor, greatest, scaledUnit, show } from "./format.js";
import { colour, lineColour } from "./theme.js";

const FONT = "12px system-ui, sans-serif";
const figures = new Set();

addEventListener("themechange", () => figures.forEach((figure) => figure.redraw()));

// On paper, of which no size is known beforehand: two columns on A4, or the whole width.
addEventListener("beforeprint", () => figures.forEach((figure) =>
  figure.fit(figure.spec.wide ? 670 : 330)));
addEventListener("afterprint", () => figures.forEach((figure) => figure.fit(null)));

/** Abscissae of several lines as one: [x, y of line 1, ...]; undefined where one has no point. */
function joined(lines) {
  if (!lines.length) return [[]];
  const same = lines.every(({ x }) => x === lines[0].x);
  return same ? [lines[0].x, ...lines.map(({ y }) => y)]
    : uPlot.join(lines.map(({ x, y }) => [x, y]));
}

// Index of the point of a series that is next to the cursor, as lines skip others' abscissae.
function nearestPoint(plot, series, index) {
  const values = plot.data[series];
  if (series === 0 || values[index] !== undefined) return index;
  for (let away = 1; away < values.length; ++away) {
    if (values[index - away] !== undefined && index >= away) return index - away;
    if (values[index + away] !== undefined) return index + away;
  }
  return index;
}

const powerPoints = (exponent) => (plot, ticks) =>
  ticks.map((tick) => {
    const value = tick / 10 ** exponent;
    return String(Number(value.toPrecision(6))).replace("-", "−");
  });

export class Figure {
  /**
   * @param spec {id, title, note, x: {label, symbol, unit, range, show, ticksWithUnit},
   *   y: {label, unit, range, exponent, incrs, tight, least, include}, height, empty, wide,
   *   legend, marks, bands, lines: [{label, group, x, y, colour, dash, points, width}]}
   *   marks: [{x, label, kind: "limit" | "masked"}] upright lines, {y, label} level ones;
   *   bands: [{from, to}] faint level strips, such as limits;
   *   lines of one `group` share a label in the legend. Of plots with a zoom in common besides
   *   sync: the key of their cursor, onzoom(from, to), zoom(by), all(), onfit().
   */
  constructor(parent, spec) {
    this.spec = spec;
    this.readout = h("output.readout", { "aria-live": "polite" });
    this.legend = h("div.legend");
    this.tooltip = h("div.tooltip", { hidden: true, role: "status" });
    this.unit = h("span.unit");
    this.canvas = h("div.canvas", {
      tabindex: 0, role: "group",
      "aria-label": `${spec.title}. Arrow keys read values, plus and minus zoom, Home shows all.`,
      onkeydown: (event) => this.key(event),
    });
    this.element = h("figure", { id: `figure-${spec.id}` },
      h("figcaption", {}, h("span.name", {}, spec.title), this.unit, this.readout),
      this.legend, this.canvas, spec.note ? h("p.note", {}, spec.note) : null);
    parent.append(this.element);
    this.hidden = new Set();
    figures.add(this);
    this.observer = new ResizeObserver(() => this.fit());
    this.observer.observe(this.element);
    this.setLines(spec.lines ?? [], spec.marks ?? []);
  }

  /** Other lines in the same plot; `registered` is what tests see, if not the lines. */
  setLines(lines, marks = this.spec.marks, registered = lines) {
    this.lines = lines;
    this.spec.marks = marks;
    const most = Math.max(0, ...lines.map(({ y }) => greatest(y)));
    this.exponent = this.spec.y.exponent ?? exponentFor(most);
    this.unit.textContent = this.unitText();
    this.register(registered);
    this.draw();
  }

  /** New numbers in lines of the same number and looks: the plot stays, with its zoom. */
  setData(lines, registered = lines) {
    if (!this.plot || lines.length !== this.lines.length) {
      this.setLines(lines, this.spec.marks, registered);
      return;
    }
    this.lines = lines;
    this.register(registered);
    this.plot.setData(joined(lines), true);
  }

  unitText() {
    const { label, unit } = this.spec.y;
    const scaled = scaledUnit(unit, this.exponent);
    return [label, scaled ? `[${scaled}]` : ""].filter(Boolean).join(" ");
  }

  register(lines) {
    const [x, ...values] = joined(lines);
    window.cutwater.plots[this.spec.id] = {
      title: this.spec.title, x,
      series: lines.map(({ label, about }, i) => ({ label, about, values: values[i] })),
    };
  }

  draw() {
    this.plot?.destroy();
    this.plot = null;
    this.drawLegend();
    if (!this.lines.some(({ x }) => x.length)) {
      this.canvas.replaceChildren(h("p.missing", {}, this.spec.empty ?? "Nothing chosen."));
      return;
    }
    this.canvas.replaceChildren();
    this.plot = new uPlot(this.options(), joined(this.lines), this.canvas);
    this.tooltip.hidden = true;
    this.plot.over.append(this.tooltip);
  }

  options() {
    const { x, y, height = 210 } = this.spec;
    return {
      width: this.width(), height, pxAlign: 0, legend: { show: false }, padding: [10, 24, 0, 0],
      cursor: {
        dataIdx: nearestPoint, points: { size: 7 },
        drag: { x: true, y: false, setScale: !this.spec.onzoom },
        bind: this.spec.all ? { dblclick: () => () => this.spec.all() } : {},
        ...(this.spec.sync ? { sync: { key: this.spec.sync, scales: ["x", null],
          filters: { pub: (type) => type === "mousemove" || type === "mouseleave" } } } : {}),
      },
      scales: {
        x: { time: false, ...(x.range ? { range: x.range } : {}) },
        y: { range: y.range ?? ((plot, low, high) => roundRange(low, high, y)) },
      },
      axes: [x.ticksWithUnit
        ? this.axis({ size: 26, space: 80, values: (plot, ticks) =>
          ticks.map((tick) => `${Number(tick.toPrecision(8))} ${x.unit}`) })
        : this.axis({ label: `${x.label}${x.unit ? ` [${x.unit}]` : ""}`, labelSize: 20,
          labelFont: FONT, size: 30, space: 60 }),
      this.axis({ size: 58, space: height < 180 ? 24 : 34, values: powerPoints(this.exponent),
        incrs: y.incrs })],
      series: [{}, ...this.lines.map((line, i) => this.series(line, i))],
      hooks: {
        drawClear: [(plot) => this.drawBands(plot)], draw: [(plot) => this.drawMarks(plot)],
        setCursor: [(plot) => this.read(plot)],
        setSelect: [(plot) => this.selected(plot)],
      },
    };
  }

  axis(more) {
    return {
      font: FONT, stroke: () => colour("--muted"),
      grid: { stroke: () => colour("--grid"), width: 1 }, ticks: { show: false }, ...more,
    };
  }

  series(line, i) {
    const stroke = () => (typeof line.colour === "string" ? colour(line.colour)
      : lineColour(line.colour ?? i));
    return {
      label: line.label, stroke, width: line.width ?? 1.6, dash: line.dash,
      show: !this.hidden.has(line.group ?? line.label), spanGaps: false,
      paths: line.points ? () => null : undefined,
      points: line.points
        ? { show: true, size: 7, width: 1.6, stroke, fill: () => colour("--paper") }
        : { show: false },
    };
  }

  // One entry a group; a button that hides its lines. A single line needs none.
  drawLegend() {
    const groups = groupsOf(this.lines);
    const entries = groups.map(({ group, line, i }) => h("button", {
      type: "button", "aria-pressed": String(!this.hidden.has(group)), title: "Show or hide",
      onclick: () => this.toggle(group),
    }, swatch(line, i), group));
    this.legend.replaceChildren(...entries);
    this.legend.hidden = groups.length < 2 || this.spec.legend === false;
  }

  toggle(group) {
    if (!this.hidden.delete(group)) this.hidden.add(group);
    this.draw();
  }

  // Values under the cursor: of one line in the caption, of several in a box beside the cursor.
  read(plot) {
    const { idx } = plot.cursor;
    const rows = idx === null || idx === undefined ? [] : this.rowsAt(plot, idx);
    const alone = rows.length === 1 && groupsOf(this.lines).length === 1;
    this.tooltip.hidden = alone || rows.length === 0;
    this.readout.textContent = "";
    if (!rows.length) return;
    const at = this.abscissa(plot.data[0][idx]);
    if (alone) {
      this.readout.textContent = `${at}   ${rows[0].text}`;
      return;
    }
    this.tooltip.replaceChildren(h("div", {}, at), ...rows.map(({ line, i, text }) => h("div.row",
      {}, swatch(line, i), h("span", {}, line.group ?? line.label), h("b", {}, text))));
    const { width } = plot.over.getBoundingClientRect();
    this.tooltip.classList.toggle("left", plot.cursor.left > width / 2);
  }

  // The range that was dragged over; plots with a window of their own tell it.
  selected(plot) {
    const { left, width } = plot.select;
    if (!this.spec.onzoom || width < 3) return;
    this.spec.onzoom(plot.posToVal(left, "x"), plot.posToVal(left + width, "x"));
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  abscissa(value) {
    const { x } = this.spec;
    return `${x.symbol ?? x.label} ${(x.show ?? show)(value)}${x.unit ? ` ${x.unit}` : ""}`;
  }

  // Each group's value that is next to the cursor, within some pixels of it.
  rowsAt(plot, idx) {
    const { idxs, left } = plot.cursor, found = new Map();
    this.lines.forEach((line, i) => {
      const at = idxs?.[i + 1] ?? idx, value = plot.data[i + 1][at];
      if (value === undefined || value === null || !plot.series[i + 1].show) return;
      const away = Math.abs(plot.valToPos(plot.data[0][at], "x") - left);
      const group = line.group ?? line.label;
      if (away > (line.points ? 8 : 40) || found.get(group)?.away <= away) return;
      const scaled = show(value / 10 ** this.exponent);
      found.set(group, { away, line, i, text: `${scaled} ${scaledUnit(this.spec.y.unit,
        this.exponent)}` });
    });
    return [...found.values()];
  }

  drawBands({ ctx, bbox, valToPos }) {
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.fillStyle = colour("--band");
    ctx.strokeStyle = colour("--rule");
    ctx.lineWidth = devicePixelRatio;
    for (const { from, to } of this.spec.bands ?? []) {
      const [high, low] = [to, from].map((y) => Math.min(bbox.top + bbox.height,
        Math.max(bbox.top, valToPos(y, "y", true))));
      ctx.fillRect(bbox.left, high, bbox.width, low - high);
      ctx.strokeRect(bbox.left - 2, high, bbox.width + 4, low - high);
    }
    ctx.restore();
  }

  drawMarks(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const mark of this.spec.marks ?? []) drawMark(plot, ctx, bbox, mark);
    ctx.restore();
  }

  key(event) {
    const plot = this.plot;
    if (!plot) return;
    const step = event.shiftKey ? 10 : 1;
    const { min, max } = plot.scales.x;
    const zoomed = (by) => {
      if (this.spec.zoom) {
        this.spec.zoom(by);
        return;
      }
      const middle = plot.cursor.idx == null ? (min + max) / 2 : plot.data[0][plot.cursor.idx];
      plot.setScale("x", { min: middle - (middle - min) * by, max: middle + (max - middle) * by });
    };
    const actions = {
      ArrowRight: () => this.moveCursor(step), ArrowLeft: () => this.moveCursor(-step),
      "+": () => zoomed(0.5), "=": () => zoomed(0.5), "-": () => zoomed(2),
      Home: () => this.showAll(), Escape: () => plot.setCursor({ left: -10, top: -10 }),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    actions[event.key]();
    event.preventDefault();
  }

  showAll() {
    if (this.spec.all) this.spec.all();
    else this.plot.setData(this.plot.data, true);
  }

  moveCursor(by) {
    const { plot } = this;
    const x = plot.data[0];
    const from = plot.cursor.idx ?? plot.valToIdx(plot.scales.x.min);
    const index = Math.min(x.length - 1, Math.max(0, from + by));
    plot.setCursor({ left: plot.valToPos(x[index], "x"), top: plot.over.clientHeight / 2 });
  }

  width() {
    return Math.max(160, Math.floor(this.printWidth ?? this.element.clientWidth));
  }

  /** To the width of its place; on paper to a given one. */
  fit(printWidth = this.printWidth) {
    this.printWidth = printWidth;
    const width = this.width();
    if (this.plot && width !== this.plot.width) {
      this.plot.setSize({ width, height: this.plot.height });
      this.spec.onfit?.();
    }
  }

  redraw() {
    this.plot?.redraw();
  }

  destroy() {
    this.observer.disconnect();
    this.plot?.destroy();
    this.element.remove();
    figures.delete(this);
    delete window.cutwater.plots[this.spec.id];
  }
}

/** First line of each group: [{group, line, i}]. */
function groupsOf(lines) {
  const groups = new Map();
  lines.forEach((line, i) => {
    const group = line.group ?? line.label;
    if (!groups.has(group)) groups.set(group, { group, line, i });
  });
  return [...groups.values()];
}

/** A legend of its own for several plots with the same lines. */
export function legendOf(lines) {
  return h("div.legend", {}, groupsOf(lines).map(({ group, line, i }) =>
    h("span", {}, swatch(line, i), group)));
}

function swatch(line, i) {
  const mark = h(line.points ? "i.dot" : "i.stroke", { "aria-hidden": "true" });
  mark.style.setProperty("--swatch", `var(${typeof line.colour === "string" ? line.colour
    : `--line${((line.colour ?? i) % 8) + 1}`})`);
  if (line.dash) mark.style.borderTopStyle = line.dash[0] > 3 ? "dashed" : "dotted";
  return mark;
}

// Whole steps at both ends; 0 is in the range unless `tight`.
function roundRange(low, high, { tight = false, least = 0, include = [] }) {
  if (low === null || high === null) return [0, 1];
  low = Math.min(low, ...include);
  high = Math.max(high, ...include);
  let from = tight ? low : Math.min(0, low);
  let to = tight ? high : Math.max(0, high);
  const span = Math.max(to - from, least, Math.abs(to) * 1e-6) || 1;
  if (from !== 0 || tight) from -= 0.06 * span;
  if (to !== 0 || tight) to += 0.06 * span;
  if (to - from < least) {
    const middle = (from + to) / 2;
    return [middle - least / 2, middle + least / 2];
  }
  return from === to ? [from - 1, to + 1] : [from, to];
}

function drawMark(plot, ctx, bbox, mark) {
  const ratio = devicePixelRatio;
  ctx.strokeStyle = ctx.fillStyle = colour(mark.colour ?? "--muted");
  ctx.lineWidth = ratio;
  ctx.setLineDash(mark.kind === "masked" ? [2 * ratio, 3 * ratio] : [6 * ratio, 4 * ratio]);
  const level = mark.y !== undefined;
  const at = Math.round(plot.valToPos(level ? mark.y : mark.x, level ? "y" : "x", true));
  ctx.beginPath();
  ctx.moveTo(level ? bbox.left : at, level ? at : bbox.top);
  ctx.lineTo(level ? bbox.left + bbox.width : at, level ? at : bbox.top + bbox.height);
  ctx.stroke();
  if (!mark.label) return;
  ctx.font = `${11 * ratio}px system-ui, sans-serif`;
  if (level) {
    ctx.textAlign = "right";
    ctx.fillText(mark.label, bbox.left + bbox.width - 4 * ratio, at - 4 * ratio);
    return;
  }
  const right = at > bbox.left + bbox.width / 2;
  ctx.textAlign = right ? "right" : "left";
  ctx.fillText(mark.label, at + (right ? -4 : 4) * ratio, bbox.top + 12 * ratio);
}
