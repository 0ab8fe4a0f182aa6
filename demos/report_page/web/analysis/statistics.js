// Mean, standard deviation and periods of a record. Pure.

/** {mean, deviation, least, most} of values from `begin` to before `end`; nan is left out. */
export function statistics(values, begin = 0, end = values.length) {
  let n = 0, mean = 0, squares = 0, least = Infinity, most = -Infinity;
  for (let i = begin; i < end; ++i) {
    const value = values[i];
    if (!(value === value)) continue;
    const away = value - mean;
    mean += away / ++n;
    squares += away * (value - mean);
    if (value < least) least = value;
    if (value > most) most = value;
  }
  if (!n) return { n, mean: NaN, deviation: NaN, least: NaN, most: NaN };
  return { n, mean, deviation: Math.sqrt(squares / n), least, most };
}

/** Values from `begin` to before `end` less the straight line of least squares through them. */
export function withoutTrend(values, begin = 0, end = values.length) {
  const n = end - begin, middle = (n - 1) / 2;
  let mean = 0, slope = 0;
  for (let i = 0; i < n; ++i) mean += values[begin + i] / n;
  for (let i = 0; i < n; ++i) slope += (i - middle) * (values[begin + i] - mean);
  slope /= Math.max(1, n * (n * n - 1) / 12);
  return Float64Array.from({ length: n }, (_, i) =>
    values[begin + i] - mean - slope * (i - middle));
}

/** Mean time between upward crossings of the mean; nan if there are less than two. */
export function crossingPeriod(values, dt) {
  const { mean } = statistics(values);
  let first = NaN, last = NaN, n = 0;
  for (let i = 1; i < values.length; ++i) {
    const before = values[i - 1] - mean, after = values[i] - mean;
    if (!(before < 0 && after >= 0)) continue;
    last = i - 1 + before / (before - after);
    if (n++ === 0) first = last;
  }
  return n > 1 ? dt * (last - first) / (n - 1) : NaN;
}

/** Index of the first x ≥ value in ascending numbers. */
export function firstFrom(x, value) {
  let low = 0, high = x.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (x[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
