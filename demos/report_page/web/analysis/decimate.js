// Decimation that keeps every peak: of each pixel's samples the least and the greatest are drawn.
// A pyramid of the places of least and greatest makes it quick for millions of samples. Pure.

const FAN = 32;

/** Of each FAN samples, of FAN of those and so on: the indexes of the least and the greatest. */
export class Pyramid {
  constructor(values) {
    this.values = values;
    this.levels = [];
    let below = null;
    for (let n = Math.ceil(values.length / FAN); n > 1; n = Math.ceil(n / FAN)) {
      below = this.levelAbove(below, n);
      this.levels.push(below);
    }
  }

  levelAbove(below, n) {
    const least = new Int32Array(n), most = new Int32Array(n);
    const count = below ? below.least.length : this.values.length;
    for (let i = 0; i < n; ++i) {
      const found = { least: -1, most: -1 };
      const end = Math.min(count, (i + 1) * FAN);
      for (let j = i * FAN; j < end; ++j) {
        this.take(found, below ? below.least[j] : j, below ? below.most[j] : j);
      }
      least[i] = found.least;
      most[i] = found.most;
    }
    return { least, most };
  }

  // nan is neither least nor greatest.
  take(found, least, most) {
    const { values } = this;
    if (least >= 0 && values[least] === values[least]
        && (found.least < 0 || values[least] < values[found.least])) found.least = least;
    if (most >= 0 && values[most] === values[most]
        && (found.most < 0 || values[most] > values[found.most])) found.most = most;
  }

  /** Indexes {least, most} of the samples from `begin` to before `end`; −1 if all are nan. */
  extremes(begin, end) {
    const found = { least: -1, most: -1 };
    let at = begin;
    while (at < end) {
      let level = 0, width = 1;
      while (level < this.levels.length && at % (width * FAN) === 0 && at + width * FAN <= end) {
        width *= FAN;
        ++level;
      }
      const { least, most } = level ? this.levels[level - 1] : { least: null, most: null };
      this.take(found, least ? least[at / width] : at, most ? most[at / width] : at);
      at += width;
    }
    return found;
  }
}

/**
 * Ascending indexes to draw of the samples from `begin` to before `end` in `pixels` columns: all of
 * them if they are few, else least and greatest of each column. Both ends are among them.
 */
export function decimate(pyramid, begin, end, pixels) {
  const n = end - begin;
  if (n <= 4 * pixels) return Int32Array.from({ length: Math.max(0, n) }, (_, i) => begin + i);
  const indexes = [begin];
  for (let pixel = 0; pixel < pixels; ++pixel) {
    const from = begin + Math.floor(pixel * n / pixels);
    const { least, most } = pyramid.extremes(from, begin + Math.floor((pixel + 1) * n / pixels));
    if (least < 0) indexes.push(from);
    else indexes.push(Math.min(least, most), Math.max(least, most));
  }
  indexes.push(end - 1);
  return Int32Array.from(indexes.filter((index, i) => i === 0 || index > indexes[i - 1]));
}
