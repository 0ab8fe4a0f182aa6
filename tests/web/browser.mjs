// A headless Chromium driven over its debugging pipe by plain node: opens a page from disk, reads
// values, takes pictures. Software WebGL, so that every machine draws the same.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const FLAGS = ["--no-sandbox", "--remote-debugging-pipe", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--hide-scrollbars", "--disable-dev-shm-usage"];

export class Browser {
  /** @param program Chromium's headless shell; @param more further flags */
  constructor(program = "chromium-headless-shell", more = []) {
    this.folder = mkdtempSync(join(tmpdir(), "cutwater-browser-"));
    this.process = spawn(program, [...FLAGS, ...more, `--user-data-dir=${this.folder}`],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.waiting = new Map();
    this.count = 0;
    /** What the page said: console errors and warnings, exceptions. */
    this.messages = [];
    let rest = "";
    this.process.stdio[4].on("data", (data) => {
      const parts = (rest + data).split("\0");
      rest = parts.pop();
      parts.forEach((part) => this.receive(JSON.parse(part)));
    });
    this.gone = new Promise((done) => this.process.on("exit", done));
  }

  receive({ id, method, params, result, error }) {
    if (id) {
      const { resolve, reject } = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) reject(new Error(error.message));
      else resolve(result);
    } else if (method === "Runtime.consoleAPICalled") {
      const text = params.args.map((arg) => arg.value ?? arg.description ?? "").join(" ");
      this.messages.push({ kind: params.type, text });
    } else if (method === "Runtime.exceptionThrown") {
      const { text, exception } = params.exceptionDetails;
      this.messages.push({ kind: "exception", text: exception?.description ?? text });
    }
  }

  send(method, params = {}) {
    const id = ++this.count;
    const message = JSON.stringify({ id, method, params, sessionId: this.session });
    this.process.stdio[3].write(`${message}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  /** Opens a file at a size in pixels and waits until window.cutwater.ready. */
  async open(file, { width = 1280, height = 720, dark = false, query = "" } = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    ({ sessionId: this.session } = await this.send("Target.attachToTarget",
      { targetId, flatten: true }));
    await this.send("Page.enable");
    await this.send("Runtime.enable");
    await this.send("Emulation.setDeviceMetricsOverride",
      { width, height, deviceScaleFactor: 1, mobile: false });
    await this.send("Emulation.setEmulatedMedia",
      { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" },
        { name: "prefers-reduced-motion", value: "reduce" }] });
    await this.send("Page.navigate", { url: pathToFileURL(file).href + query });
    for (let i = 0; i < 600; ++i) {
      const { result } = await this.send("Runtime.evaluate",
        { expression: "document.readyState === 'complete' && Boolean(window.cutwater?.ready)" });
      if (result.value) break;
      await new Promise((done) => setTimeout(done, 50));
    }
    await this.evaluate("window.cutwater.ready");
  }

  /** Value of an expression in the page; promises are awaited. */
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) {
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    }
    return result.value;
  }

  /** PNG of the window, or of the box {x, y, width, height} of the whole page. */
  async picture(file, box = null) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png",
      ...(box ? { clip: { ...box, scale: 1 }, captureBeyondViewport: true } : {}) });
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  async close() {
    this.session = undefined;
    this.send("Browser.close").catch(() => {});
    await this.gone;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}
