// The page's data: blobs and series are read back as they were written.
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { decodeBlob, decodeSeries, readPage } from "../../demos/report_page/web/data.js";

const base64 = (bytes) => Buffer.from(bytes).toString("base64");
const blob = (type, array) => ({ type, n: array.length, data: base64(array.buffer) });

/** As the command writes it: zigzag varints of second differences, raw deflate. */
function series(values, scale) {
  const bytes = [];
  let before = 0n, last = 0n;
  for (const value of values) {
    const q = BigInt(Math.round(value / scale)), d = q - 2n * last + before;
    [before, last] = [last, q];
    for (let z = d >= 0n ? 2n * d : -2n * d - 1n; ; z >>= 7n) {
      bytes.push(Number(z & 127n) | (z > 127n ? 128 : 0));
      if (z <= 127n) break;
    }
  }
  return { n: values.length, scale, data: base64(deflateRawSync(Uint8Array.from(bytes))) };
}

test("blobs of each type are read back", () => {
  for (const [type, array] of [["f32", new Float32Array([1.5, -2])],
    ["f64", new Float64Array([Math.PI, NaN])], ["u32", new Uint32Array([0, 4294967295])]]) {
    assert.deepEqual(decodeBlob(blob(type, array)), array);
  }
  assert.throws(() => decodeBlob({ type: "f32", n: 3, data: base64([0, 0]) }), /3 f32 has 2 bytes/);
  assert.throws(() => decodeBlob({ type: "i8", n: 1, data: "" }), /unknown type "i8"/);
});

test("a series is the very numbers of the CSV, however large its integers", async () => {
  const cases = [[[], 1], [[0.1, 0.2, 0.3, -7.25], 1e-4], [[1e15, -1e15, 3, 4e14], 1],
    [[5e6, 5.1e6, -3e6], 1e5], [[268435455, -268435456, 268435456, 0], 1],
    [Array.from({ length: 5000 }, (_, i) => Math.round(1e6 * Math.sin(i / 7)) / 1e6), 1e-6]];
  for (const [values, scale] of cases) {
    assert.deepEqual([...await decodeSeries(series(values, scale))], values);
  }
});

test("a series with a nan lies there as doubles", async () => {
  const values = new Float64Array([1, NaN, 3]);
  assert.deepEqual(await decodeSeries({ n: 3, values: blob("f64", values) }), values);
});

test("a series that ends early is refused", async () => {
  const short = { ...series([1, 2, 3], 1), n: 2 };
  await assert.rejects(decodeSeries(short), /a series of 2 values ends at byte 2/);
});

test("motions are there at once, forces when they are asked for", async () => {
  const column = (name, values) => ({ name, unit: "m", series: series(values, 0.1) });
  const page = await readPage(JSON.stringify({ format: 1, ship: { hull: {
    points: blob("f32", new Float32Array([1, 2, 3])) } },
  runs: [{ columns: [column("z", [0.1, 0.4]), column("radiation_F3", [7])] }] }));
  assert.deepEqual([...page.ship.hull.points], [1, 2, 3]);
  const [run] = page.runs;
  assert.deepEqual([...run.column("z").values], [0.1, 0.4]);
  const force = run.column("radiation_F3");
  assert.equal(force.values, null);
  assert.deepEqual([...await force.load()], [7]);
  assert.deepEqual([...force.values], [7]);
});

test("the template without data and other formats are refused in one line", async () => {
  await assert.rejects(readPage("/*CUTWATER-DATA*/"), /template.*cutwater report/);
  await assert.rejects(readPage("{"), /damaged, write it again/);
  await assert.rejects(readPage('{"format": 2}'), /format 2; this page reads format 1/);
});
