// The ship: particulars, hydrostatics, righting levers, panels.
import { rightingFacts } from "../analysis/righting.js";
import { h, missing, prose, table } from "./dom.js";
import { Figure } from "./figure.js";
import { show, subscript, unitText } from "./format.js";
import { panelView } from "./panels.js";
import { canDraw3d } from "./webgl.js";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

// Names of the command's tables in words; others lose their underscores.
const NAMES = {
  cog_x: "centre of gravity, x", cog_y: "centre of gravity, y",
  cog_z: "centre of gravity, z above calm water", gyradius_roll: "gyradius of roll",
  gyradius_pitch: "gyradius of pitch", gyradius_yaw: "gyradius of yaw",
  lcb: "centre of buoyancy, x", tcb: "centre of buoyancy, y", vcb: "centre of buoyancy, z",
  kb: "centre of buoyancy above the keel, KB", lcf: "centre of flotation, x",
  bm_t: "BM, transverse", bm_l: "BM, lengthwise", gm_t: "GM, transverse", gm_l: "GM, lengthwise",
  draft: "draught",
};

function nameOf(name) {
  if (NAMES[name]) return NAMES[name];
  return /^C\d\d$/.test(name) ? `stiffness C${subscript(name.slice(1))}`
    : String(name).replaceAll("_", " ");
}

// Seven digits; what is 0 but for round-off is 0.
function plain(value) {
  if (Math.abs(value) < 1e-9) return "0";
  return Math.abs(value) >= 1e9 ? show(value, 5) : String(Number(value.toPrecision(7)));
}

// Numbers keep their digits, in groups of three; words stay words.
function shownValue(value) {
  const text = typeof value === "number" ? plain(value) : String(value ?? "");
  if (!NUMBER.test(text)) return h("td.number", {}, text || "–");
  const [whole, ...rest] = text.split(".");
  const grouped = /^[+-]?\d{5,}$/.test(whole) ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return h("td.number", {}, [grouped, ...rest].join(".").replace("-", "−"));
}

function facts(title, rows, otherwise) {
  if (!rows?.length) return h("div", {}, h("h3", {}, title), missing(otherwise));
  return h("div", {}, h("h3", {}, title), table([{}, { kind: "number" }, { kind: "unit" }],
    rows.map(([name, value, unit]) =>
      [nameOf(name), shownValue(value), unitText(unit)])));
}

function righting(place, data) {
  place.append(h("h3", {}, "Righting levers"));
  if (!data?.heelDeg?.length) {
    place.append(missing("The data has no righting levers: they need the hull up to the deck."));
    return;
  }
  const { gm, greatest, vanishingDeg } = rightingFacts(data.heelDeg, data.gz);
  const lines = [{ label: "GZ", x: data.heelDeg, y: data.gz }];
  if (gm !== null) {
    // The tangent at 0 reaches GM at one radian; it is drawn as far as the curve is high.
    const reach = Math.min(180 / Math.PI, 180 / Math.PI * 1.15 * greatest.gz / Math.abs(gm));
    lines.push({ label: `GM ${show(gm, 3)} m, as slope`, x: [0, reach], dash: [6, 4], colour: 1,
      y: [0, gm * reach * Math.PI / 180], width: 1.2 });
  }
  lines.push({ label: `greatest GZ ${show(greatest.gz, 3)} m at ${show(greatest.heelDeg, 3)}°`,
    x: [greatest.heelDeg], y: [greatest.gz], points: true, colour: 2 });
  if (vanishingDeg !== null) {
    lines.push({ label: `vanishes at ${show(vanishingDeg, 3)}°`, x: [vanishingDeg], y: [0],
      points: true, colour: 3 });
  }
  new Figure(place, { id: "righting", title: "GZ over heel", x: { label: "heel", unit: "°" },
    y: { label: "", unit: "m", exponent: 0 }, height: 260, lines, wide: true,
    note: vanishingDeg === null ? "GZ does not vanish in the range computed." : null });
}

function panels(place, data) {
  place.append(h("h3", {}, "Panels"));
  if (!data) {
    place.append(missing("The data has no panels."));
    return;
  }
  if (!canDraw3d()) {
    place.append(missing("The panels are not drawn: this browser has no WebGL 2, or it is switched "
      + "off."));
    return;
  }
  try {
    panelView(place, data);
  } catch (error) {
    console.warn(error);
    place.append(missing(`The panels are not drawn: "${error.message}".`));
  }
}

export function ship(section, page) {
  const { ship: data } = page;
  const levers = h("div"), net = h("div");
  section.append(prose(`${data.name}: lengths in metres, x forward, y to port, z up.`, "p.lead"),
    h("div.grid", {}, facts("Particulars", data.particulars, "The data has no particulars."),
      facts("Hydrostatics", data.hydrostatics, "The data has no hydrostatics.")), levers, net);
  righting(levers, data.righting);
  panels(net, data.panels);
}
