// Numbers and units as they are written.
import assert from "node:assert/strict";
import { test } from "node:test";
import { exponentFor, scaledUnit, show, subscript, unitText }
  from "../../demos/report_page/web/plots/format.js";

test("numbers have a true minus sign and few digits", () => {
  assert.equal(show(-0.123456), "−0.1235");
  assert.equal(show(12345.6), "12346");
  assert.equal(show(4595556.76), "4.596·10⁶");
  assert.equal(show(1e-7, 2), "1.0·10⁻⁷");
  assert.equal(show(0), "0");
  assert.equal(show(NaN), "–");
  assert.equal(show(null), "–");
});

test("axes divide by powers of a thousand that the unit names", () => {
  assert.deepEqual([0, 0.5, 9999, 2e4, 3.4e7, 2e-3].map(exponentFor), [0, 0, 0, 3, 6, -3]);
  assert.equal(scaledUnit("kg", 6), "10⁶ kg");
  assert.equal(scaledUnit("m", 0), "m");
  assert.equal(scaledUnit("", -3), "10⁻³");
});

test("units and pairs of modes are set as in print", () => {
  assert.equal(unitText("kg m^2"), "kg·m²");
  assert.equal(unitText("deg"), "°");
  assert.equal(subscript("33"), "₃₃");
});
