// Pieces of the page: tables, notices and controls.
import { h } from "../element.js";

export { h };

/** Said in the place of what is not in the data: what is missing and what to do. */
export function missing(text) {
  return prose(text, "p.missing");
}

/** Text in which `...` is code. */
export function prose(text, name = "p") {
  return h(name, {}, text.split("`").map((part, i) => (i % 2 ? h("code", {}, part) : part)));
}

/**
 * Table of rows of text; a column of numbers is aligned right, its units left beside it.
 * @param columns [{title, kind: "text" | "number" | "unit"}]
 */
export function table(columns, rows, caption = null) {
  const cell = (tag, kind, content) => h(`${tag}.${kind ?? "text"}`, {}, content);
  return h("div.scroll", {}, h("table", {},
    caption ? h("caption", {}, caption) : null,
    columns.some(({ title }) => title) ? h("thead", {}, h("tr", {}, columns.map((column) => {
      const head = cell("th", column.kind, column.title);
      head.scope = "col";
      return head;
    }))) : null,
    h("tbody", {}, rows.map((row) => h("tr", {}, row.map((value, i) =>
      (value instanceof Element && value.matches("td, th") ? value
        : cell("td", columns[i].kind, value))))))));
}

let count = 0;

/** Labelled list to choose one of: options are [value, text]. */
export function choice(label, options, value, onchange) {
  const id = `control-${++count}`;
  const list = h("select", { id, onchange: () => onchange(list.value) },
    options.map(([key, text]) =>
      h("option", { value: key, selected: String(key) === String(value) }, text)));
  return h("span.control", {}, h("label", { for: id }, label), list);
}

/** Labelled number with a unit; what is no number in the limits is marked and not passed on. */
export function number(label, unit, value, limits, onchange) {
  const id = `control-${++count}`;
  const field = h("input", {
    id, type: "number", value, min: limits.min, max: limits.max, step: limits.step ?? "any",
    title: `${limits.min ?? "-∞"} to ${limits.max ?? "∞"}`,
    oninput: () => {
      // A value between the steps of the arrows is good all the same.
      const { rangeUnderflow, rangeOverflow, badInput } = field.validity;
      const good = field.value !== "" && !rangeUnderflow && !rangeOverflow && !badInput;
      field.setAttribute("aria-invalid", String(!good));
      if (good) onchange(Number(field.value));
    },
  });
  return h("span.control", {}, h("label", { for: id }, label), field, h("span.unit", {}, unit));
}

/** Labelled box to tick. */
export function tick(label, value, onchange) {
  const box = h("input",
    { type: "checkbox", checked: value, onchange: () => onchange(box.checked) });
  return h("label.control.tick", {}, box, label);
}

/** Buttons of which several are on: options are [value, text], `on` a Set that is changed. */
export function chips(label, options, on, onchange) {
  const buttons = options.map(([value, text]) => {
    const button = h("button.chip", {
      type: "button", "aria-pressed": String(on.has(value)),
      onclick: () => {
        if (on.has(value)) on.delete(value);
        else on.add(value);
        button.setAttribute("aria-pressed", String(on.has(value)));
        onchange();
      },
    }, text);
    return button;
  });
  return h("span.control.chips", { role: "group", "aria-label": label },
    h("span.label", {}, label), buttons);
}
