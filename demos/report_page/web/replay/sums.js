// The sea summed on the graphics card: heights and slopes at every vertex of the grid, once a frame
// into a float texture; and slopes for the pixels farther out, each wave faded by what a pixel
// sees.
//
// Phases at the origin, which moves with the ship, come from the processor in double precision and
// within half a turn. The shader adds k.(x, y) of local metres, in turns; a fraction of a turn is
// turned into cosine and sine by polynomials, as GLSL does not say how exact its own are.
import * as THREE from "three";
import { rampAt, turnsAt } from "./wave.js";

const COSINE_GLSL = `
/// (cos, sin) of 2 pi f, for f in -1/2 .. 1/2, to 3e-7: from the half angle's series.
vec2 cosineSine(float f) {
  float a = 3.14159265358979 * f;
  float b = a * a;
  float s = a * (1.0 + b * (-1.6666667e-1 + b * (8.3333333e-3 + b * (-1.9841270e-4 +
            b * (2.7557319e-6 + b * -2.5052108e-8)))));
  float c = 1.0 + b * (-0.5 + b * (4.1666667e-2 + b * (-1.3888889e-3 + b * (2.4801587e-5 +
            b * (-2.7557319e-7 + b * 2.0876757e-9)))));
  return vec2(1.0 - 2.0 * s * s, 2.0 * s * c);
}
`;

const HEAD_GLSL = `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D waves; // two texels a component: turns/m in x, in y, turns, amplitude; k, -, -, -
uniform int count;
out vec4 result;
${COSINE_GLSL}
`;

const VERTEX_GLSL = `
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;

/// Height, slopes, and the variance of slope that has been faded out.
const GRID_GLSL = `
${HEAD_GLSL}
uniform sampler2D places;
void main() {
  vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < count; ++i) {
    vec4 w = texelFetch(waves, ivec2(2 * i, 0), 0);
    float turns = w.z - (w.x * place.x + w.y * place.y);
    vec2 cs = w.w * cosineSine(turns - round(turns));
    float share = 1.0;
    if (place.z > 0.0) {
      float k = texelFetch(waves, ivec2(2 * i + 1, 0), 0).x;
      share = smoothstep(3.0, 7.0, 6.2831853 / (k * place.z));
    }
    vec2 slope = 6.2831853 * w.xy * w.w;
    sum += vec4(share * cs.x, share * 6.2831853 * w.xy * cs.y,
                0.5 * (1.0 - share * share) * dot(slope, slope));
  }
  result = sum;
}`;

/// Slopes over bearing and depression below the horizon, as seen from `eye`; variance as above.
const VIEW_GLSL = `
${HEAD_GLSL}
uniform vec2 size;
uniform vec3 eye;      // z: height above calm water
uniform vec4 window;   // bearing of the left edge, width; deepest depression seen [rad]
void main() {
  vec2 uv = gl_FragCoord.xy / size;
  float bearing = window.x - uv.x * window.y;
  float down = max(1.5e-4, window.z * uv.y);
  float d = eye.z / tan(down);
  vec2 along = vec2(cos(bearing), sin(bearing));
  vec2 place = eye.xy + d * along;
  float deep = (d * d + eye.z * eye.z) / eye.z * window.z / size.y;
  float wide = d * window.y / size.x;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < count; ++i) {
    vec4 w = texelFetch(waves, ivec2(2 * i, 0), 0);
    vec2 k = 6.2831853 * w.xy;
    float a = dot(k, along) * deep;
    float b = (k.x * along.y - k.y * along.x) * wide;
    float share = exp(-0.16 * (a * a + b * b));
    float turns = w.z - dot(w.xy, place);
    float s = w.w * cosineSine(turns - round(turns)).y;
    sum += vec3(share * k * s, 0.5 * (1.0 - share * share) * w.w * w.w * dot(k, k));
  }
  result = vec4(sum, 1.0);
}`;

function fullScreen(fragmentShader, uniforms) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(
    new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader: VERTEX_GLSL, fragmentShader, uniforms,
    depthTest: false, depthWrite: false,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene();
  scene.add(mesh);
  return { scene, material, geometry };
}

const floatTexture = (data, width, height) => {
  const made = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
  made.minFilter = made.magFilter = THREE.NearestFilter;
  made.needsUpdate = true;
  return made;
};

/// grid: of makeGrid; view: {width, height} of the second texture.
export function makeSums(renderer, grid, view) {
  const width = grid.row;
  const vertices = grid.places.length / 3;
  const rows = Math.ceil(vertices / width) + 1; // the last row is for vertices laid by hand
  if (Math.max(width, rows) > renderer.capabilities.maxTextureSize) {
    throw new Error(`the grid of the sea needs a texture of ${width} x ${rows}`);
  }
  const placeData = new Float32Array(4 * width * rows);
  for (let i = 0; i < vertices; ++i) placeData.set(grid.places.subarray(3 * i, 3 * i + 3), 4 * i);
  const places = floatTexture(placeData, width, rows);
  const target = new THREE.WebGLRenderTarget(width, rows, {
    type: THREE.FloatType, format: THREE.RGBAFormat, depthBuffer: false,
    minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
  });
  const viewTarget = new THREE.WebGLRenderTarget(view.width, view.height, {
    type: THREE.HalfFloatType, format: THREE.RGBAFormat, depthBuffer: false,
    minFilter: THREE.LinearFilter, magFilter: THREE.LinearFilter,
  });
  const shared = { waves: { value: null }, count: { value: 0 } };
  const onGrid = fullScreen(GRID_GLSL, { ...shared, places: { value: places } });
  const onView = fullScreen(VIEW_GLSL, {
    ...shared,
    size: { value: new THREE.Vector2(view.width, view.height) },
    eye: { value: new THREE.Vector3() },
    window: { value: new THREE.Vector4() },
  });
  const camera = new THREE.Camera();
  let data = new Float32Array(0);
  let turns = new Float64Array(0);

  const pass = (into, what) => {
    renderer.setRenderTarget(into);
    renderer.render(what.scene, camera);
    renderer.setRenderTarget(null);
  };

  return {
    texture: target.texture,
    viewTexture: viewTarget.texture,
    viewWindow: onView.material.uniforms.window.value,
    viewEye: onView.material.uniforms.eye.value,
    width, rows,
    /// The sea at t with the origin of local axes at x, y of the earth.
    setSea(sea, t, x, y) {
      if (data.length !== 8 * Math.max(1, sea.size)) {
        data = new Float32Array(8 * Math.max(1, sea.size));
        shared.waves.value?.dispose();
        const made = floatTexture(data, 2 * Math.max(1, sea.size), 1);
        for (const p of [onGrid, onView]) p.material.uniforms.waves.value = made;
        shared.waves.value = made;
        turns = new Float64Array(sea.size);
      }
      const r = rampAt(sea, t);
      turnsAt(sea, t, x, y, turns);
      for (let i = 0; i < sea.size; ++i) {
        data[8 * i] = sea.kx[i] / (2 * Math.PI);
        data[8 * i + 1] = sea.ky[i] / (2 * Math.PI);
        data[8 * i + 2] = turns[i];
        data[8 * i + 3] = r * sea.amplitude[i];
        data[8 * i + 4] = sea.k[i];
      }
      shared.waves.value.needsUpdate = true;
      for (const p of [onGrid, onView]) p.material.uniforms.count.value = sea.size;
    },
    drawGrid: () => pass(target, onGrid),
    drawView: () => pass(viewTarget, onView),
    /// [zeta, slope x, slope y, faded variance] of a vertex laid at local x, y, read back from the
    /// texture that the surface is drawn from.
    probe(x, y) {
      const texel = width * (rows - 1);
      placeData.set([x, y, 0, 0], 4 * texel);
      places.needsUpdate = true;
      pass(target, onGrid);
      const out = new Float32Array(4);
      renderer.readRenderTargetPixels(target, 0, rows - 1, 1, 1, out);
      return out;
    },
    /// Four numbers for each vertex of the fine square, as last drawn.
    readFine() {
      const out = new Float32Array(4 * width * width);
      renderer.readRenderTargetPixels(target, 0, 0, width, width, out);
      return out;
    },
    dispose() {
      for (const p of [onGrid, onView]) {
        p.material.dispose();
        p.geometry.dispose();
      }
      for (const t of [places, target, viewTarget, shared.waves.value]) t?.dispose();
    },
  };
}
