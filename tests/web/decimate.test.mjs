// Decimation keeps every peak and costs little.
import assert from "node:assert/strict";
import { test } from "node:test";
import { decimate, Pyramid } from "../../demos/report_page/web/analysis/decimate.js";

// Numbers that look random and are the same everywhere.
function noise(n, seed = 1) {
  let state = seed;
  return Float64Array.from({ length: n }, () => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return state / 2147483648 - 0.5;
  });
}

function plainExtremes(values, begin, end) {
  let least = -1, most = -1;
  for (let i = begin; i < end; ++i) {
    if (values[i] !== values[i]) continue;
    if (least < 0 || values[i] < values[least]) least = i;
    if (most < 0 || values[i] > values[most]) most = i;
  }
  return { least, most };
}

test("least and greatest of any range are those of a plain search", () => {
  for (const n of [1, 31, 32, 33, 1024, 1025, 40000]) {
    const values = noise(n);
    for (let i = 5; i < n; i += 97) values[i] = NaN;
    const pyramid = new Pyramid(values);
    for (const [a, b] of [[0, 1], [0.1, 0.9], [0.31, 0.32], [0.5, 0.5], [0.02, 0.97]]) {
      const begin = Math.floor(a * n), end = Math.ceil(b * n);
      assert.deepEqual(pyramid.extremes(begin, end), plainExtremes(values, begin, end));
    }
  }
});

test("every column of pixels keeps its least and greatest, and a lone peak is drawn", () => {
  const values = noise(100000);
  values[77777] = 9;
  values[12345] = -9;
  const begin = 1003, end = 99871, pixels = 640;
  const drawn = new Set(decimate(new Pyramid(values), begin, end, pixels));
  assert.ok(drawn.has(77777) && drawn.has(12345) && drawn.has(begin) && drawn.has(end - 1));
  assert.ok(drawn.size <= 2 * pixels + 2);
  for (let pixel = 0; pixel < pixels; ++pixel) {
    const from = begin + Math.floor(pixel * (end - begin) / pixels);
    const to = begin + Math.floor((pixel + 1) * (end - begin) / pixels);
    const { least, most } = plainExtremes(values, from, to);
    assert.ok(drawn.has(least) && drawn.has(most));
  }
});

test("indexes ascend, and few samples are all drawn", () => {
  const pyramid = new Pyramid(noise(5000, 7));
  const indexes = decimate(pyramid, 0, 5000, 100);
  for (let i = 1; i < indexes.length; ++i) assert.ok(indexes[i] > indexes[i - 1]);
  assert.deepEqual([...decimate(pyramid, 10, 14, 100)], [10, 11, 12, 13]);
  assert.equal(decimate(pyramid, 10, 10, 100).length, 0);
});

test("a gap of nan stays a gap", () => {
  const values = new Float64Array(10000).fill(NaN);
  values[0] = 1;
  const indexes = decimate(new Pyramid(values), 0, 10000, 50);
  assert.ok(indexes.length >= 50 && [...indexes].slice(1).every((i) => Number.isNaN(values[i])));
});
