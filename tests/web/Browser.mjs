// A headless Chromium driven over its debugging pipe, with nothing but node: opens a page, runs
// expressions in it, keeps what it says on its console, takes pictures.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";

const NAMES = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];

/** Path of the first browser that is installed, or null. */
export function findBrowser() {
  for (const name of NAMES) {
    for (const folder of (process.env.PATH ?? "").split(delimiter)) {
      if (existsSync(join(folder, name))) return join(folder, name);
    }
  }
  return null;
}

// As root a sandbox is not possible; the drawing is done by the processor.
const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--hide-scrollbars",
  "--disable-dev-shm-usage",
  "--remote-debugging-pipe",
];
const WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const NO_WEBGL = ["--disable-gpu", "--disable-3d-apis"];

export class Browser {
  #process;
  #profile;
  #next = 1;
  #waiting = new Map();
  #rest = Buffer.alloc(0);
  #session;
  #listeners = new Map();
  /** Errors and warnings of the console, exceptions, failed loads: {kind, text}. */
  complaints = [];

  /** Starts a browser with one empty page of this size [pixels]. */
  static async start({ width = 1280, height = 720, dark = false, webgl = true } = {}) {
    const path = findBrowser();
    if (path === null) throw new Error("no Chromium: apt-get install chromium-headless-shell");
    const browser = new Browser();
    browser.#profile = mkdtempSync(join(tmpdir(), "cutwater-browser-"));
    const drawing = webgl ? WEBGL : NO_WEBGL;
    const flags = [...FLAGS, ...drawing, `--user-data-dir=${browser.#profile}`, "about:blank"];
    browser.#process = spawn(path, flags, {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    browser.#process.stdio[4].on("data", (bytes) => browser.#receive(bytes));
    browser.#process.on("exit", () => browser.#end(new Error("the browser ended")));
    await browser.#attach();
    await browser.resize(width, height);
    await browser.prefer(dark);
    return browser;
  }

  async #attach() {
    const { targetInfos } = await this.send("Target.getTargets");
    const page = targetInfos.find((target) => target.type === "page");
    const { sessionId } = await this.send("Target.attachToTarget", {
      targetId: page.targetId,
      flatten: true,
    });
    this.#session = sessionId;
    this.#on("Runtime.exceptionThrown", ({ exceptionDetails }) => {
      const text = exceptionDetails.exception?.description ?? exceptionDetails.text;
      this.complaints.push({ kind: "exception", text });
    });
    this.#on("Runtime.consoleAPICalled", ({ type, args }) => {
      if (type !== "error" && type !== "warning" && type !== "assert") return;
      const text = args.map((a) => a.value ?? a.description ?? "").join(" ");
      this.complaints.push({ kind: type, text });
    });
    this.#on("Log.entryAdded", ({ entry }) => {
      if (entry.level !== "error") return;
      this.complaints.push({ kind: entry.source, text: `${entry.text} ${entry.url ?? ""}` });
    });
    this.#on("Network.requestWillBeSent", ({ request }) => {
      if (/^(file|data|blob):/.test(request.url)) return;
      this.complaints.push({ kind: "network", text: request.url });
    });
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(`${domain}.enable`);
  }

  #on(method, listener) {
    this.#listeners.set(method, [...(this.#listeners.get(method) ?? []), listener]);
  }

  #once(method) {
    return new Promise((resolve) => {
      const listener = (parameters) => {
        const others = this.#listeners.get(method).filter((l) => l !== listener);
        this.#listeners.set(method, others);
        resolve(parameters);
      };
      this.#on(method, listener);
    });
  }

  #receive(bytes) {
    this.#rest = Buffer.concat([this.#rest, bytes]);
    for (let end; (end = this.#rest.indexOf(0)) >= 0; ) {
      const message = JSON.parse(this.#rest.subarray(0, end).toString());
      this.#rest = this.#rest.subarray(end + 1);
      this.#take(message);
    }
  }

  #take(message) {
    if (message.id === undefined) {
      for (const listener of this.#listeners.get(message.method) ?? []) listener(message.params);
      return;
    }
    const { resolve, reject } = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    if (message.error) {
      reject(new Error(message.error.message));
    } else {
      resolve(message.result);
    }
  }

  #end(error) {
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }

  /** One command of the debugging protocol; its answer. */
  send(method, params = {}) {
    const id = this.#next++;
    const message = { id, method, params };
    if (this.#session) message.sessionId = this.#session;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#process.stdio[3].write(JSON.stringify(message) + "\0");
    });
  }

  async resize(width, height) {
    await this.send("Emulation.setDeviceMetricsOverride", {
      width,
      height,
      deviceScaleFactor: 1,
      mobile: false,
    });
  }

  /** The colour scheme that the reader prefers. */
  async prefer(dark) {
    const features = [
      { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
      { name: "prefers-reduced-motion", value: "reduce" },  // the replay waits until asked
    ];
    await this.send("Emulation.setEmulatedMedia", { features });
  }

  /** Opens an address and waits until it has loaded. */
  async open(url) {
    const loaded = this.#once("Page.loadEventFired");
    const { errorText } = await this.send("Page.navigate", { url });
    if (errorText) throw new Error(`${url}: ${errorText}`);
    await loaded;
  }

  /** The value of an expression in the page, awaited; throws what it throws. */
  async run(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (!exceptionDetails) return result.value;
    throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
  }

  /** A picture of what is seen, or of a part of the page: {x, y, width, height} in its pixels. */
  async picture(file, part = null) {
    const clip = part === null ? {} : { clip: { ...part, scale: 1 }, captureBeyondViewport: true };
    const { data } = await this.send("Page.captureScreenshot", { format: "png", ...clip });
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  async press(key, code = key) {
    for (const type of ["keyDown", "keyUp"])
      await this.send("Input.dispatchKeyEvent", { type, key, code });
  }

  async close() {
    const ended = new Promise((resolve) => this.#process.once("exit", resolve));
    const late = setTimeout(() => this.#process.kill("SIGKILL"), 5000);
    this.#session = undefined;
    this.send("Browser.close").catch(() => {});
    await ended;
    clearTimeout(late);
    for (const pipe of this.#process.stdio.slice(3)) pipe.destroy();
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
