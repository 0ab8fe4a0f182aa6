// Quality gates of the database: what passes, what fails and what to do.
import { h, missing, prose, table } from "./dom.js";
import { show, unitText } from "./format.js";

const VERDICTS = [
  { of: (gate) => gate.passes === false, kind: "fail", text: "✗ fails" },
  { of: (gate) => gate.passes === true, kind: "pass", text: "✓ passes" },
  { of: () => true, kind: "unknown", text: "– not judged" },
];

const verdictOf = (gate) => VERDICTS.findIndex(({ of }) => of(gate));

const shown = (value) => (typeof value === "number" && value !== 0 && Math.abs(value) < 1e5
  && Math.abs(value) >= 1e-4 ? String(Number(value.toPrecision(3))).replace("-", "−")
  : typeof value === "string" ? value : show(value, 3));

function summary(list) {
  const count = (kind) => list.filter((gate) => VERDICTS[verdictOf(gate)].kind === kind).length;
  const failed = count("fail"), unknown = count("unknown");
  const parts = [`${count("pass")} of ${list.length} pass`];
  if (failed) parts.push(`${failed} ${failed === 1 ? "fails" : "fail"}`);
  if (unknown) parts.push(`${unknown} not judged`);
  return `${parts.join(", ")}.`;
}

export function gates(section, page) {
  if (!page.gates.length) {
    section.append(missing("The data has no quality gates."));
    return;
  }
  const sorted = page.gates.slice().sort((a, b) => verdictOf(a) - verdictOf(b));
  section.append(prose(summary(sorted), "p.lead"), table([{ title: "result" }, { title: "gate" },
    { title: "value", kind: "number" }, { title: "limit", kind: "number" },
    { title: "", kind: "unit" }, { title: "what to do" }],
  sorted.map((gate) => {
    const verdict = VERDICTS[verdictOf(gate)];
    return [h(`td.${verdict.kind}`, {}, verdict.text), gate.name, shown(gate.value),
      shown(gate.limit), unitText(gate.unit), prose(gate.advice || "", "span")];
  })));
}
