// Two textures that tile: smooth noise for clouds and paint, and the slopes of small ripples.
// Both are made here, from a generator with a seed, so that every page looks alike.
import * as THREE from "three";

function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

/// Value noise of several octaves on an n x n torus, 0..1.
export function tilingNoise(n, firstCells, octaves, seed) {
  const random = generator(seed);
  const sum = new Float32Array(n * n);
  let weight = 1;
  for (let o = 0, cells = firstCells; o < octaves; ++o, cells *= 2, weight *= 0.5) {
    const lattice = Float32Array.from({ length: cells * cells }, random);
    const ease = (f) => f * f * f * (f * (6 * f - 15) + 10);
    for (let y = 0; y < n; ++y) {
      const v = (y * cells) / n;
      const j = Math.floor(v);
      const fy = ease(v - j);
      for (let x = 0; x < n; ++x) {
        const u = (x * cells) / n;
        const i = Math.floor(u);
        const fx = ease(u - i);
        const at = (a, b) => lattice[((b % cells) * cells) + (a % cells)];
        const low = at(i, j) + fx * (at(i + 1, j) - at(i, j));
        const high = at(i, j + 1) + fx * (at(i + 1, j + 1) - at(i, j + 1));
        sum[y * n + x] += weight * (low + fy * (high - low));
      }
    }
  }
  const low = sum.reduce((a, b) => Math.min(a, b));
  const high = sum.reduce((a, b) => Math.max(a, b));
  return sum.map((v) => (v - low) / (high - low));
}

function texture(data, n) {
  const made = new THREE.DataTexture(data, n, n, THREE.RGBAFormat, THREE.UnsignedByteType);
  made.wrapS = made.wrapT = THREE.RepeatWrapping;
  made.magFilter = THREE.LinearFilter;
  made.minFilter = THREE.LinearMipmapLinearFilter;
  made.generateMipmaps = true;
  made.needsUpdate = true;
  return made;
}

export function noiseTexture(n = 256) {
  const layers = [[4, 6, 11], [5, 5, 23], [16, 4, 37]]
    .map(([cells, octaves, seed]) => tilingNoise(n, cells, octaves, seed));
  const data = new Uint8Array(4 * n * n);
  for (let i = 0; i < n * n; ++i) {
    for (let c = 0; c < 3; ++c) data[4 * i + c] = Math.round(255 * layers[c][i]);
    data[4 * i + 3] = 255;
  }
  return texture(data, n);
}

/// Slopes of a tile of ripples that run along +x with some spread: r and g are slope/(8 s) + 1/2
/// with the standard deviation s of both together, b the square of the slope over 16 s^2. Coarser
/// levels of the texture hold means; b less the squares of r and g is then what has been averaged
/// away, which the surface adds to its roughness.
export function rippleTexture(n = 256, waves = 70, seed = 5) {
  const random = generator(seed);
  const sx = new Float32Array(n * n);
  const sy = new Float32Array(n * n);
  for (let w = 0; w < waves; ++w) {
    const size = 3 * 8 ** random(); // waves in a tile
    const turn = (random() + random() + random() - 1.5) * 2.2;
    const p = Math.round(size * Math.cos(turn));
    const q = Math.round(size * Math.sin(turn));
    if (p === 0 && q === 0) continue;
    const slope = 1 / Math.sqrt(Math.hypot(p, q)) / Math.hypot(p, q);
    const phase = 2 * Math.PI * random();
    const sine = Float32Array.from({ length: n }, (_, i) => Math.sin((2 * Math.PI * i) / n));
    const shift = Math.round((phase / (2 * Math.PI)) * n);
    for (let y = 0, k = 0; y < n; ++y) {
      for (let x = 0; x < n; ++x, ++k) {
        const s = slope * sine[(((p * x + q * y + shift) % n) + n) % n];
        sx[k] += p * s;
        sy[k] += q * s;
      }
    }
  }
  let square = 0;
  for (let k = 0; k < n * n; ++k) square += sx[k] * sx[k] + sy[k] * sy[k];
  const s = Math.sqrt(square / (n * n));
  const data = new Uint8Array(4 * n * n);
  const byte = (v) => Math.max(0, Math.min(255, Math.round(255 * v)));
  for (let k = 0; k < n * n; ++k) {
    data[4 * k] = byte(sx[k] / (8 * s) + 0.5);
    data[4 * k + 1] = byte(sy[k] / (8 * s) + 0.5);
    data[4 * k + 2] = byte((sx[k] * sx[k] + sy[k] * sy[k]) / (16 * s * s));
    data[4 * k + 3] = 255;
  }
  return texture(data, n);
}
