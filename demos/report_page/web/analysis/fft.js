// Fast Fourier transform of a power of two of complex numbers. Pure.

/** X_k = Σ_n (re_n + i im_n) e^{−2πikn/N}, in place; N = re.length, a power of two. */
export function fft(re, im) {
  const n = re.length;
  if (n & (n - 1)) throw new Error(`fft: ${n} is no power of two`);
  reverseBits(re, im, n);
  for (let size = 2; size <= n; size *= 2) {
    const half = size / 2;
    for (let k = 0; k < half; ++k) {
      const c = Math.cos(2 * Math.PI * k / size), s = -Math.sin(2 * Math.PI * k / size);
      for (let a = k; a < n; a += size) {
        const b = a + half;
        const x = c * re[b] - s * im[b], y = s * re[b] + c * im[b];
        re[b] = re[a] - x;
        im[b] = im[a] - y;
        re[a] += x;
        im[a] += y;
      }
    }
  }
}

function reverseBits(re, im, n) {
  for (let i = 1, j = 0; i < n; ++i) {
    let bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      [re[i], re[j]] = [re[j], re[i]];
      [im[i], im[j]] = [im[j], im[i]];
    }
  }
}
