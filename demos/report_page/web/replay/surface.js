// The surface of the sea: geometry from the texture of heights, and what light does on water.
// Height and slopes are the run's; ripples shorter than its waves, and all colours, are decoration.
import * as THREE from "three";
import { LIGHT_GLSL } from "./light.js";
import { rippleTexture } from "./textures.js";

/// Tiles of ripples [m], each turned a little against the wind.
const TILES = [89, 31, 10.7, 3.9, 1.37, 0.47];
const TURNS = [0.0, 0.45, -0.35, 0.3, -0.5, 0.2];
const SHARES = [0.20, 0.27, 0.33, 0.36, 0.36, 0.30];
export const MAX_BODIES = 4;

const VERTEX = `
uniform highp sampler2D water;
uniform int row;
out vec3 place;
out vec3 drawn; // slopes and faded variance
void main() {
  vec4 w = texelFetch(water, ivec2(gl_VertexID % row, gl_VertexID / row), 0);
  place = vec3(position.xy, w.x);
  drawn = w.yzw;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}`;

const FRAGMENT = `
precision highp float;
${LIGHT_GLSL}
uniform sampler2D ripples;
uniform sampler2D viewSlopes;
uniform vec4 viewWindow;
uniform vec3 viewEye;
uniform float fineEdge;             // where the fine square ends [m]
uniform vec4 layers[${TILES.length}];      // cos/tile, sin/tile, shift x, shift y
uniform vec2 layerSlopes[${TILES.length}]; // slope's standard deviation, turn
uniform int layerCount;
uniform float waveHeight;           // significant, with the ramp [m]
uniform float opacity;
uniform vec2 origin;                // of local axes, within a tile of gusts [m]
uniform int bodies;
uniform vec4 bodyPlaces[${MAX_BODIES}];    // x, y, cos, sin of the bow's bearing
uniform vec4 bodySizes[${MAX_BODIES}];     // half length, half breadth, height, brightness
in vec3 place;
in vec3 drawn;
out vec4 pixel;

/// Slopes and variance of the run's waves at this pixel.
vec3 waveSlopes() {
  vec2 away = place.xy - viewEye.xy;
  float bearing = atan(away.y, away.x);
  float turn = mod(viewWindow.x - bearing + 6.2831853, 6.2831853);
  vec2 uv = vec2(turn / viewWindow.y, atan(viewEye.z, length(away)) / viewWindow.z);
  float far = smoothstep(0.45, 0.95, max(abs(place.x), abs(place.y)) / fineEdge);
  far *= step(uv.x, 1.0) * step(uv.y, 1.0);
  return mix(drawn, texture(viewSlopes, uv).xyz, far);
}

/// Slopes and variance of ripples that no wave of the run stands for.
vec3 rippleSlopes() {
  vec3 sum = vec3(0.0);
  vec2 gust = (place.xy + origin) / 640.0;
  float wide = textureLod(noise, gust, 1.0).r, narrow = textureLod(noise, 3.7 * gust.yx, 1.0).g;
  float wind = 0.45 + 1.0 * wide * (0.5 + narrow);
  for (int i = 0; i < ${TILES.length}; ++i) {
    if (i >= layerCount) break;
    vec4 l = layers[i];
    float s = layerSlopes[i].x * wind;
    if (s <= 0.0) continue;
    vec2 uv = vec2(l.x * place.x + l.y * place.y, l.x * place.y - l.y * place.x) + l.zw;
    vec3 a = texture(ripples, uv).xyz;
    vec2 mean = 8.0 * (a.xy - 0.5);
    vec2 d = normalize(l.xy);
    sum.xy += s * vec2(d.x * mean.x - d.y * mean.y, d.y * mean.x + d.x * mean.y);
    sum.z += s * s * max(0.0, 16.0 * a.z - dot(mean, mean));
  }
  return sum;
}

/// How far a ray from this point goes into a hull, as a share of what would hide all behind it.
float hullInSight(vec3 from, vec3 ray, out float height, out float shade) {
  float hidden = 0.0;
  height = shade = 0.0;
  for (int i = 0; i < ${MAX_BODIES}; ++i) {
    if (i >= bodies) break;
    vec4 b = bodyPlaces[i];
    vec4 size = bodySizes[i];
    vec2 p = from.xy - b.xy;
    p = vec2(b.z * p.x + b.w * p.y, b.z * p.y - b.w * p.x) / size.xy;
    vec2 d = vec2(b.z * ray.x + b.w * ray.y, b.z * ray.y - b.w * ray.x) / size.xy;
    float dd = dot(d, d);
    float t = max(0.0, -dot(p, d) / dd);
    float closest = length(p + t * d);
    float z = from.z + t * ray.z;
    float enter = max(0.0, t - sqrt(max(0.0, 1.0 - closest * closest) / dd));
    float zEnter = from.z + enter * ray.z;
    float h = 1.0 - smoothstep(0.62, 1.04, closest);
    h *= 1.0 - smoothstep(0.75 * size.z, 1.25 * size.z, zEnter);
    if (h > hidden) { hidden = h; height = zEnter / size.z; shade = size.w; }
  }
  return hidden;
}

void main() {
  vec3 toEye = eye - place;
  float distance = length(toEye);
  vec3 v = toEye / distance;
  vec3 wave = waveSlopes();
  vec3 small = rippleSlopes();
  vec2 slope = wave.xy + small.xy;
  float variance = wave.z + small.z + 4e-4;
  vec3 n = normalize(vec3(-slope, 1.0));
  // A facet that looks away from the eye is hidden by others: those in sight lean towards it.
  float facing = dot(n, v);
  if (facing < 0.03) n = normalize(n + (0.03 - facing) * v);
  float nv = max(dot(n, v), 0.03);

  float sigma = sqrt(0.5 * variance);
  float fresnel = 0.02 + 0.98 * pow(1.0 - nv, 5.0 * exp(-2.69 * sigma)) /
                  (1.0 + 22.7 * pow(sigma, 1.5));

  // The reflected sky: rough water sees higher parts of it, and blurred.
  vec3 r = reflect(-v, n);
  r.z = abs(r.z) * (1.0 - 0.3 * sigma) + 0.55 * sigma * (1.0 - nv) + 0.01;
  r = normalize(r);
  vec3 sky = skyColour(r, 2.0 + 9.0 * sigma);
  float height, shade;
  float hull = hullInSight(place, r, height, shade);
  sky = mix(sky, shade * vec3(0.90, 0.93, 1.0) * (0.6 + 0.5 * height), 0.85 * hull);

  // The sun's track (V. Ross et al. 2005): share of facets that mirror the sun into the eye.
  vec3 h = normalize(sun + v);
  vec2 tilt = -h.xy / h.z - slope;
  float tight = max(variance, 2.2e-3);
  float facets = exp(-dot(tilt, tilt) / tight) / (3.14159 * tight);
  float glint = 0.02 + 0.98 * pow(1.0 - max(dot(v, h), 0.0), 5.0);
  vec3 track = SUN_COLOUR * 2.3 * glint * facets / (4.0 * pow(h.z, 4.0) * max(nv, 0.15));
  track *= 1.0 - hull;
  track /= 1.0 + 0.45 * track.r;

  // Light that comes back out of the water: deep, and thin where a crest stands against the sun.
  vec3 sunSide = normalize(vec3(sun.xy, 0.0));
  float against = max(0.0, dot(-v, sunSide));
  float crest = smoothstep(0.0, 0.85, place.z / max(waveHeight, 0.4));
  float lean = clamp(0.5 + 2.2 * dot(slope, -v.xy), 0.0, 1.5);
  vec3 deep = vec3(0.010, 0.034, 0.047);
  vec3 through = vec3(0.014, 0.078, 0.078);
  float glow = crest * crest * (0.10 + 0.9 * against * against * lean);
  glow *= smoothstep(0.0, 1.5, waveHeight) * (1.0 - 0.8 * v.z);
  vec3 body = deep * (0.75 + 0.5 * n.z) + through * glow;
  body *= 0.75 + 0.25 * clamp(0.5 + place.z / max(waveHeight, 1.0), 0.0, 1.0);

  vec3 colour = mix(body, sky, fresnel) + track;
  colour = haze(colour, place);
  pixel = vec4(developed(colour) + dither(gl_FragCoord.xy), opacity);
}`;

export function makeSurface(grid, sums, light, { layerCount, anisotropy }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(grid.places, 3));
  geometry.setIndex(new THREE.BufferAttribute(grid.indices, 1));
  const ripples = rippleTexture();
  ripples.anisotropy = anisotropy;
  const first = grid.levels[0];
  const vectors = (n, make) => Array.from({ length: n }, make);
  const uniforms = {
    ...light,
    water: { value: sums.texture },
    row: { value: sums.width },
    ripples: { value: ripples },
    viewSlopes: { value: sums.viewTexture },
    viewWindow: { value: sums.viewWindow },
    viewEye: { value: sums.viewEye },
    fineEdge: { value: first.cell * first.outer },
    layers: { value: vectors(TILES.length, () => new THREE.Vector4()) },
    layerSlopes: { value: vectors(TILES.length, () => new THREE.Vector2()) },
    layerCount: { value: 0 },
    waveHeight: { value: 0 },
    opacity: { value: 1 },
    origin: { value: new THREE.Vector2() },
    bodies: { value: 0 },
    bodyPlaces: { value: vectors(MAX_BODIES, () => new THREE.Vector4()) },
    bodySizes: { value: vectors(MAX_BODIES, () => new THREE.Vector4(1, 1, 1, 1)) },
  };
  const material = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT,
    side: THREE.DoubleSide,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = 2;
  return {
    mesh,
    uniforms,
    /// See-through water shows the hull below it.
    setOpacity(share) {
      uniforms.opacity.value = share;
      material.transparent = share < 1;
      material.depthWrite = share >= 1;
      material.needsUpdate = true;
    },
    setRipples: (wind, shortest, t, x, y) =>
      setRipples(uniforms, layerCount, wind, shortest, t, x, y),
    dispose() {
      geometry.dispose();
      material.dispose();
      ripples.dispose();
    },
  };
}

/// Ripples of a wind {speed [m/s], bearing [rad]} at time t, where the origin of local axes is at
/// x, y of the earth. Those as long as the run's own waves, `shortest` [m], are left out.
function setRipples(uniforms, most, wind, shortest, t, x, y) {
  const total = Math.sqrt(0.003 + 0.00512 * wind.speed); // C. Cox and W. Munk 1954
  const layers = [];
  TILES.forEach((tile, i) => {
    const middle = tile / 7; // the length of its middle waves
    const shorter = Math.min(1, Math.max(0, 1.6 - middle / Math.max(0.3, shortest)));
    if (shorter > 0.05) layers.push({ tile, turn: TURNS[i], slope: SHARES[i] * total * shorter });
  });
  const count = Math.min(most, layers.length);
  uniforms.layerCount.value = count;
  layers.slice(0, count).forEach(({ tile, turn, slope }, i) => {
    const angle = wind.bearing + turn;
    const [c, s] = [Math.cos(angle) / tile, Math.sin(angle) / tile];
    const speed = Math.sqrt((9.81 * tile) / 7 / (2 * Math.PI));
    const u = c * x + s * y - (speed / tile) * t;
    const w = c * y - s * x;
    uniforms.layers.value[i].set(c, s, u - Math.floor(u), w - Math.floor(w));
    uniforms.layerSlopes.value[i].set(slope, turn);
  });
  const gusts = 640;
  uniforms.origin.value.set(x - gusts * Math.floor(x / gusts), y - gusts * Math.floor(y / gusts));
}
