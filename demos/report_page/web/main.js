// Begins the page: reads the data, builds one section after the other, says what failed.
import { readPage } from "./data.js";
import { coefficients } from "./plots/coefficients.js";
import { h, missing } from "./plots/dom.js";
import { gates } from "./plots/gates.js";
import { motions } from "./plots/motions.js";
import { reportFigures } from "./plots/report.js";
import { runs } from "./plots/runs.js";
import { seaway } from "./plots/seaway.js";
import { ship } from "./plots/ship.js";
import { startTheme } from "./plots/theme.js";
import { canDraw3d } from "./plots/webgl.js";
import { createReplay } from "./replay/replay.js";

const SECTIONS = [
  ["ship", "The ship", ship],
  ["gates", "Quality gates", gates],
  ["motions", "Motions", motions],
  ["seaway", "In a seaway", seaway],
  ["runs", "Runs", runs],
  ["coefficients", "Coefficients", coefficients],
  ["report", "The report's figures", reportFigures],
];

const breathe = () => new Promise((done) => setTimeout(done));

async function startReplay(page) {
  const view = document.getElementById("replay-view");
  const say = (why) => {
    view.style.aspectRatio = "auto";
    view.replaceChildren(missing(`The replay is missing: ${why} Everything else works.`));
  };
  if (!canDraw3d()) {
    say("this browser has no WebGL 2, or it is switched off.");
    return;
  }
  try {
    window.cutwater.replay = await createReplay(view, page);
  } catch (error) {
    console.warn(error);
    say(`it stopped with "${error.message}".`);
  }
}

async function buildSection([id, title, build], page, main) {
  const section = h("section", { id, "aria-labelledby": `${id}-title` },
    h("h2", { id: `${id}-title` }, title));
  main.append(section);
  try {
    await build(section, page);
  } catch (error) {
    console.error(error);
    section.append(missing(`This section stopped with "${error.message}".`));
  }
  await breathe();
}

// Marks in the index the section that is on the screen.
function followScroll(links) {
  const seen = new Map();
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) seen.set(entry.target.id, entry.isIntersecting);
    const first = links.find(({ hash }) => seen.get(hash.slice(1)));
    for (const link of links) link.setAttribute("aria-current", String(link === first));
  }, { rootMargin: "-25% 0px -65% 0px" });
  for (const { hash } of links) observer.observe(document.getElementById(hash.slice(1)));
}

function buildIndex() {
  const links = [["replay", "Replay"], ...SECTIONS].map(([id, title]) =>
    h("a", { href: `#${id}` }, title));
  document.getElementById("index").append(...links);
  return links;
}

async function start() {
  startTheme(document.getElementById("theme"));
  const main = document.getElementById("main");
  try {
    const page = await readPage(document.getElementById("cutwater-data").textContent);
    window.cutwater.page = page;
    document.title = `${page.title} – Cutwater report`;
    document.getElementById("title").textContent = page.title;
    document.getElementById("foot").append(`Written by cutwater report ${page.version}.`);
    const links = buildIndex();
    const replay = startReplay(page);
    for (const section of SECTIONS) await buildSection(section, page, main);
    followScroll(links);
    await replay;
  } catch (error) {
    console.error(error);
    main.replaceChildren(missing(error.message));
  }
}

window.cutwater = { plots: {}, ready: null };
window.cutwater.ready = start();
