// page_in_browser.mjs CUTWATER DATABASE.h5 FOLDER [make]: opens FOLDER/report.html, the page that
// ./run demo or `make` leaves there, in headless Chromium as a reader does. Its console stays
// silent and nothing is asked of a network. Its plots hold what the CSV files beside it and the
// command say. The sea of its replay is that of the run to a millimetre. Keys and colour schemes
// work. Pictures are left in FOLDER/pictures, with CUTWATER_FULL of the whole page.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Browser, findBrowser } from "./Browser.mjs";

const full = Boolean(process.env.CUTWATER_FULL);
const [cutwater, database, folder] = process.argv.slice(2, 5).map((a) => resolve(a));
const page = join(folder, "report.html");
const pictures = join(folder, "pictures");

const RUN = `database = "${database}"
[bullet]
dt = 0.05
duration = 90.0
[waves]
type = "jonswap"
hs = 3.0
tp = 9.0
spreading = 4
components = 60
[motion]
speed = 5.0
heading_deg = 150.0
keep_speed = true
keep_course = true
`;
const SWEEP = `database = "${database}"
[bullet]
duration = 100.0
[waves]
type = "regular"
omega = [0.6, 0.9]
amplitude = 0.05
[motion]
heading_deg = 135.0
`;

// Why there is none, or false.
function makePage() {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const call = (...words) => execFileSync(cutwater, words, { cwd: folder, stdio: "pipe" });
  writeFileSync(join(folder, "run.toml"), RUN);
  writeFileSync(join(folder, "sweep.toml"), SWEEP);
  call("simulate", "run.toml", "--forces", "-o", "run.csv");
  call("sweep", "sweep.toml", "-o", "sweep.csv");
  try {
    call("report", database, "run.toml", "sweep.toml", "-o", "report.html");
  } catch (error) {
    const said = error.stderr.toString().trim();
    if (/npm/.test(said)) return said;  // the command was built without its page
    throw error;
  }
  return false;
}

/** {name: [numbers]} of a CSV file's text. */
function columns(text) {
  const [head, ...rows] = text.trim().split("\n").map((line) => line.split(","));
  return Object.fromEntries(head.map((name, i) => [name, rows.map((row) => Number(row[i]))]));
}

const fromFile = (name) => columns(readFileSync(join(folder, name), "utf8"));
const fromCommand = (...words) =>
  columns(execFileSync(cutwater, words, { encoding: "utf8", maxBuffer: 1 << 28, stdio: "pipe" }));
const range = (values) => {
  const finite = values.filter(Number.isFinite);
  return finite.reduce((a, b) => Math.max(a, b), -Infinity) -
    finite.reduce((a, b) => Math.min(a, b), Infinity);
};

/** Both lists hold the same numbers but for a share of their range. */
function same(got, expected, share, what) {
  assert.equal(got.length, expected.length, `${what}: length`);
  const bound = share * Math.max(range(expected), 1e-300) + 1e-12;
  for (let i = 0; i < expected.length; ++i) {
    if (Number.isNaN(expected[i]) && got[i] === null) continue;
    if (Math.abs(got[i] - expected[i]) <= bound) continue;
    assert.fail(`${what}: ${got[i]} at ${i}, ${expected[i]} expected`);
  }
}

const plot = (browser, id) => browser.run(`(() => {
  const plot = window.cutwater.plots[${JSON.stringify(id)}];
  if (!plot) return null;
  return { title: plot.title, x: [...plot.x],
    series: plot.series.map((s) => ({ label: s.label, about: s.about, values: [...s.values] })) };
})()`);

/** What holds() says in the end: asked each half second until it says so, for half a minute. */
async function until(holds) {
  for (let i = 0; i < 60; ++i) {
    const said = await holds();
    if (said) return said;
    await new Promise((resolve) => setTimeout(resolve, 500));
  }
  return false;
}

async function open(browser, query = "") {
  const start = Date.now();
  await browser.open(pathToFileURL(page).href + query);
  await browser.run("window.cutwater.ready.then(() => true)");
  return (Date.now() - start) / 1000;
}

async function picturesOf(browser, name, width) {
  const height = await browser.run("document.documentElement.scrollHeight");
  for (let y = 0, i = 0; y < height; y += 1600, ++i) {
    const part = { x: 0, y, width, height: Math.min(1600, height - y) };
    await browser.picture(join(pictures, `${name}_${String(i).padStart(2, "0")}.png`), part);
  }
}

async function checkRuns(browser) {
  const runs = await browser.run(
    "window.cutwater.page.runs.map((r) => ({ name: r.name, kind: r.kind }))");
  assert.ok(runs.some((run) => run.kind === "simulate"), "no run was simulated");
  // A run's plots are made when it is opened.
  await browser.run(`document.querySelectorAll("#runs > details").forEach((details) => {
    details.open = true;
  })`);
  const last = runs.map((run) => run.kind).lastIndexOf("simulate");
  await until(() => plot(browser, `run-${last}-wave`));
  for (const [i, { name, kind }] of runs.entries()) {
    if (kind !== "simulate") continue;
    const csv = fromFile(`${name}.csv`);
    const shown = await browser.run(`Object.keys(window.cutwater.plots).filter((id) =>
      new RegExp("^run-${i}-[a-z_]+$").test(id)).map((id) => id.slice("run-${i}-".length))`);
    const known = shown.filter((column) => column in csv);
    assert.ok(known.length >= 3, `plots of ${name}: ${shown}`);
    for (const column of known) {
      const got = await plot(browser, `run-${i}-${column}`);
      // A millionth: the last digit of the CSV, and the step of the compressed column.
      same(got.x, csv.t, 1e-6, `${name}: t of ${column}`);
      same(got.series[0].values, csv[column], 1e-6, `${name}: ${column}`);
    }
  }
}

async function checkMotions(browser) {
  const heave = await plot(browser, "rao-heave");
  const line = heave.series.find((s) => s.about);
  const { headingDeg, speed, free } = line.about;
  const csv = fromCommand("rao", database, "--speed", String(speed), "--heading",
    String(headingDeg), ...(free ? ["--free"] : []));
  let compared = 0;
  csv.omega.forEach((omega, row) => {
    const at = heave.x.findIndex((x) => Math.abs(x - omega) < 1e-6);
    if (csv.j[row] !== 3 || at < 0 || line.values[at] === null) return;
    // Single precision.
    assert.ok(Math.abs(line.values[at] - csv.amplitude[row]) < 1e-5, `heave at ${omega} rad/s`);
    ++compared;
  });
  assert.ok(compared > 10, `${compared} frequencies of the RAO compared`);
}

async function checkCoefficients(browser) {
  const got = await plot(browser, "A33");
  const csv = fromCommand("coefficients", database, "--speed", "0");
  const rows = csv.omega.map((_, i) => i).filter((i) => csv.j[i] === 3 && csv.k[i] === 3);
  const finite = rows.filter((i) => csv.omega[i] > 0 && Number.isFinite(csv.omega[i]));
  const values = finite.map((i) => {
    const at = got.x.findIndex((x) => Math.abs(x - csv.omega[i]) < 1e-9);
    return got.series[0].values[at];
  });
  same(values, finite.map((i) => csv.A[i]), 1e-6, "A33");
}

// The report's figures are built when they are opened. Figure 17 is B33 over Δ√(g/L).
async function checkReport(browser) {
  await browser.run("document.getElementById('report-figures').open = true");
  let got = null;
  for (let i = 0; i < 60 && got === null; ++i) {
    await new Promise((resolve) => setTimeout(resolve, 500));
    got = await plot(browser, "report-36") && await plot(browser, "report-17");
  }
  assert.ok(got, "the report's figures are not built");
  const { mass, gravity, length } = await browser.run("(({ mass, gravity, length }) => "
    + "({ mass, gravity, length }))(window.cutwater.page.ship)");
  const unit = mass * Math.sqrt(gravity / length), B = await plot(browser, "B33");
  same(got.series[0].values.map((value) => value * unit), B.series[0].values, 1e-9, "Figure 17");
}

// The texture that the surface is drawn from, at the place of the ship, against the CSV.
async function checkSea(browser) {
  const csv = fromFile("run.csv");
  const names = await browser.run("window.cutwater.page.runs.map((r) => r.name)");
  assert.ok(names.includes("run"), `runs of the page: ${names}`);
  await browser.run(`(() => {
    const { scenes, scene } = window.cutwater.replay.debug;
    return scene(scenes.findIndex((title) => title.startsWith("run")));
  })()`);
  const seconds = [];
  for (const share of [0.15, 0.4, 0.75, 0.98]) {
    const row = Math.floor(share * csv.t.length);
    const start = Date.now();
    await browser.run(`window.cutwater.replay.seek(${csv.t[row]})`);
    const height = await browser.run(
      `window.cutwater.replay.debug.surfaceAt(${csv.x[row]}, ${csv.y[row]})`);
    seconds.push((Date.now() - start) / 1000);
    assert.ok(Math.abs(height - csv.wave[row]) < 1e-3,
      `wave at t = ${csv.t[row]}: ${height} drawn, ${csv.wave[row]} in the CSV`);
    const worst = await browser.run("window.cutwater.replay.debug.worstVertex(500)");
    assert.ok(worst < 1e-3, `a vertex is ${worst} m off the formula`);
  }
  return seconds;
}

let skip = findBrowser() ? false : "no Chromium";
if (process.argv[5] === "make" && !skip) skip = makePage();

test("the page in a browser", { skip }, async (t) => {
  mkdirSync(pictures, { recursive: true });
  const browser = await Browser.start({ width: 1280, height: 720 });
  t.after(() => browser.close());
  const loaded = await open(browser);
  t.diagnostic(`ready after ${loaded} s`);

  await t.test("plots hold what the CSV files say", () => checkRuns(browser));
  await t.test("motions are the command's", () => checkMotions(browser));
  await t.test("coefficients are the command's", () => checkCoefficients(browser));
  await t.test("the report's figures are in its units", () => checkReport(browser));
  await t.test("the drawn sea is the run's", async () => {
    const seconds = await checkSea(browser);
    t.diagnostic(`a seek and its picture: ${seconds.map((s) => s.toFixed(1)).join(", ")} s`);
    await browser.picture(join(pictures, "replay.png"));
  });
  await t.test("keys play and pause", async () => {
    await browser.run("document.querySelector('#replay-view canvas').focus()");
    await browser.run("window.cutwater.replay.seek(10)");
    await browser.press(" ", "Space");
    const plays = await until(() => browser.run("window.cutwater.replay.time() > 10"));
    await browser.press(" ", "Space");
    assert.ok(plays, "it does not play");
  });
  await t.test("light, dark and narrow", async () => {
    if (full) await picturesOf(browser, "light", 1280);
    await browser.prefer(true);
    if (full) await picturesOf(browser, "dark", 1280);
    await browser.resize(700, 900);
    // Plots follow the width of the window, a little later.
    await until(() => browser.run("document.documentElement.scrollWidth <= 700"));
    const wide = await browser.run("document.documentElement.scrollWidth");
    if (full) await picturesOf(browser, "narrow", 700);
    assert.ok(wide <= 700, `${wide} pixels wide on a screen of 700`);
  });
  await t.test("nothing is complained of", () => assert.deepEqual(browser.complaints, []));
});

test("without WebGL a line says why", { skip }, async (t) => {
  const browser = await Browser.start({ webgl: false });
  t.after(() => browser.close());
  await open(browser);
  const text = await browser.run("document.getElementById('replay-view').textContent");
  assert.match(text, /replay is missing/);
  assert.ok(await browser.run("Object.keys(window.cutwater.plots).length > 20"));
  assert.deepEqual(browser.complaints, []);
});
