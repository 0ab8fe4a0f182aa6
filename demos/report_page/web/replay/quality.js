// How much is drawn: everything on a graphics card, less where the processor draws.

export const QUALITIES = {
  high: {
    name: "high", antialias: true, pixelRatio: 2, ring: 36, view: { width: 560, height: 320 },
    layers: 5, anisotropy: 8,
  },
  low: {
    name: "low", antialias: false, pixelRatio: 1, ring: 20, view: { width: 360, height: 200 },
    layers: 4, anisotropy: 1,
  },
};

/// Whether WebGL here is drawn by the processor.
function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("this browser has no WebGL 2.");
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}

/// `?quality=low` or `high` in the address wins; otherwise low where the processor draws.
export function chooseQuality(search) {
  const software = isSoftware();
  const asked = new URLSearchParams(search).get("quality");
  const name = asked in QUALITIES ? asked : software ? "low" : "high";
  return { ...QUALITIES[name], asked: asked in QUALITIES, software };
}
