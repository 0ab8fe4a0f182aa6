// Motions: RAOs of the six modes over frequency.
import { h, missing } from "./dom.js";
import { Figure } from "./figure.js";
import { complexAt, DEGREES, MODES, rotates } from "./modes.js";

export function motions(section, page) {
  const rao = page.raos[0];
  if (!rao) {
    section.append(missing("The data has no RAOs."));
    return;
  }
  const grid = h("div.grid.three");
  section.append(grid);
  MODES.forEach((name, mode) => {
    new Figure(grid, {
      id: `rao-${name}`, title: name[0].toUpperCase() + name.slice(1),
      x: { label: "ω", unit: "rad/s" }, y: { label: "", unit: rotates(mode) ? "°/m" : "m/m" },
      lines: rao.headingsDeg.filter((_, i) => i % 4 === 0).map((heading) => ({
        label: `${heading}°`, x: rao.omega,
        y: rao.omega.map((_, i) => Math.hypot(...complexAt(rao.values, rao.omega.length,
          rao.headingsDeg.indexOf(heading), i, mode)) * (rotates(mode) ? DEGREES : 1)),
      })),
    });
  });
}
