// build.mjs OUT.html [NODE_MODULES]: bundles the page into one file without network access.
// NODE_MODULES is the folder that `npm ci` made (default: node_modules beside this file). The place
// of the data is left as the marker /*CUTWATER-DATA*/, which `cutwater report` replaces.
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const MARKER = "/*CUTWATER-DATA*/";
const LICENSED = ["uplot", "three"];

function fail(message) {
  console.error(`build.mjs: ${message}`);
  process.exit(1);
}

async function bundleScript(esbuild, modules) {
  const result = await esbuild.build({
    entryPoints: [join(here, "main.js")],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "inline",
    nodePaths: [modules],
    write: false,
  });
  return result.outputFiles[0].text;
}

async function bundleStyle(esbuild, modules) {
  const files = [
    join(modules, "uplot/dist/uPlot.min.css"), join(here, "style.css"),
    join(here, "replay/replay.css"),
  ];
  const text = files.filter(existsSync).map((file) => readFileSync(file, "utf8")).join("\n");
  const result = await esbuild.transform(text, { loader: "css", minify: true, charset: "utf8" });
  return result.code;
}

// The licences of what is bundled, whole, in one comment of the page.
function licences(modules) {
  return LICENSED.map((name) => {
    const { version } = JSON.parse(readFileSync(join(modules, name, "package.json"), "utf8"));
    return `${name} ${version}\n\n${readFileSync(join(modules, name, "LICENSE"), "utf8").trim()}`;
  }).join("\n\n").replaceAll("--", "- -");
}

function fill(template, places) {
  let page = template;
  for (const [place, text] of Object.entries(places)) {
    if (page.split(place).length !== 2) fail(`index.html must have ${place} once`);
    page = page.replace(place, () => text);
  }
  return page;
}

// Whole or not at all: written beside its place, then renamed.
function writeWhole(file, text) {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(`${file}.part`, text);
  renameSync(`${file}.part`, file);
}

const out = process.argv[2] ?? fail("usage: node build.mjs OUT.html [NODE_MODULES]");
const modules = resolve(process.argv[3] ?? join(here, "node_modules"));
if (!existsSync(join(modules, "esbuild"))) {
  fail(`${modules} has no esbuild: run npm ci --ignore-scripts in its folder`);
}
const esbuild = createRequire(join(modules, "esbuild/package.json"))("esbuild");
const page = fill(readFileSync(join(here, "index.html"), "utf8"), {
  "<!--LICENCES-->": `<!--\n${licences(modules)}\n-->`,
  "/*STYLE*/": await bundleStyle(esbuild, modules),
  "/*SCRIPT*/": await bundleScript(esbuild, modules),
});
if (page.split(MARKER).length !== 2) fail(`the page must have ${MARKER} once, also after bundling`);
writeWhole(resolve(out), page);
