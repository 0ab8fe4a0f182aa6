// How a hull is drawn: evening light on paint that goes by the height above the calm waterline, wet
// where waves have been, the waterline and pressures over it. mesh.js has the faces.
import * as THREE from "three";
import { LIGHT_GLSL } from "./light.js";

const VERTEX = `
in float paint;
in vec2 band;
in float pressure;
out vec3 place;
out vec3 own;
out vec3 normalE;
out vec3 normalB;
out vec2 house;
out float kpa;
flat out int painted;
void main() {
  vec4 p = modelMatrix * vec4(position, 1.0);
  place = p.xyz;
  own = position;
  normalB = normal;
  normalE = mat3(modelMatrix) * normal;
  painted = int(paint + 0.5);
  house = band;
  kpa = pressure;
  gl_Position = projectionMatrix * viewMatrix * p;
}`;

const FRAGMENT = `
precision highp float;
${LIGHT_GLSL}
uniform highp sampler2D water;
uniform int row;
uniform float cell;         // of the fine square [m]
uniform float calm;         // z of calm water in ship axes
uniform float freeboard;    // [m]
uniform float shipLength;
uniform float stern;         // x of its end in ship axes
uniform float breadth;
uniform int colours;        // 0 grey warship, 1 white boat, 2 box, 3 tug
uniform float showLine, showPressure, pressureTop, below;
in vec3 place;
in vec3 own;
in vec3 normalE;
in vec3 normalB;
in vec2 house;
in float kpa;
flat in int painted;
out vec4 pixel;

/// Height of the sea at x, y inside the fine square, between its vertices; far below outside.
float seaAt(vec2 p) {
  vec2 q = p / cell + 0.5 * float(row - 1);
  if (min(q.x, q.y) < 0.0 || max(q.x, q.y) >= float(row - 1)) return -1e4;
  ivec2 i = ivec2(q);
  vec2 f = q - vec2(i);
  float a = texelFetch(water, i, 0).x, b = texelFetch(water, i + ivec2(1, 0), 0).x;
  float c = texelFetch(water, i + ivec2(0, 1), 0).x, d = texelFetch(water, i + ivec2(1, 1), 0).x;
  return mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
}

/// Colour and gloss by the place on the ship.
vec4 paintAt() {
  float z = own.z - calm;
  float scale = max(0.25, 0.012 * shipLength);
  float grain = 0.6 * texture(noise, own.xz * 0.11 / scale).g +
                0.4 * texture(noise, own.xy * 0.05 / scale).b;
  float streak = texture(noise, vec2(own.x * 0.6, own.z * 0.04) / scale).b;
  vec3 c;
  float gloss = 0.25;
  vec3 topsides = colours == 0 ? vec3(0.235, 0.262, 0.285)
                : colours == 1 ? vec3(0.70, 0.70, 0.68) : vec3(0.10, 0.16, 0.26);
  vec3 bottom = colours == 1 ? vec3(0.045, 0.085, 0.15) : vec3(0.22, 0.055, 0.040);
  vec3 boot = colours == 1 ? vec3(0.55, 0.05, 0.04) : vec3(0.018);
  if (painted == 0) {
    float band = 0.085 * freeboard;
    float w = fwidth(z) + 1e-4;
    c = mix(bottom, boot, smoothstep(-w, w, z + 0.6 * band));
    c = mix(c, topsides * (0.92 + 0.14 * grain - 0.10 * smoothstep(0.45, 0.9, streak)),
            smoothstep(-w, w, z - band));
    if (colours == 1) {
      float stripe = smoothstep(-w, w, z - 0.66 * freeboard) -
                     smoothstep(-w, w, z - 0.74 * freeboard);
      c = mix(c, vec3(0.03, 0.07, 0.16), stripe);
    }
    // Seams of plates.
    if (colours != 1) {
      vec2 seam = abs(fract(vec2(own.x / (2.4 * scale), z / (0.9 * scale))) - 0.5);
      vec2 e = fwidth(own.xz) / (vec2(2.4, 0.9) * scale);
      vec2 on = smoothstep(0.5 - vec2(0.006, 0.012) - e, vec2(0.5), seam);
      float seen = clamp(1.0 - 4.0 * max(e.x, e.y), 0.0, 1.0);
      c *= 1.0 - 0.10 * max(on.x, on.y) * seen * step(z, 0.97 * freeboard);
    }
    if (normalB.z > 0.8 && z > 0.3 * freeboard) {
      c = colours == 0 ? vec3(0.115, 0.125, 0.13)
        : colours == 1 ? vec3(0.42, 0.33, 0.22) : vec3(0.16, 0.09, 0.07);
      float plank = smoothstep(0.42, 0.5, abs(fract(own.y / 0.09) - 0.5)) *
                    clamp(1.0 - fwidth(own.y) / 0.05, 0.0, 1.0) * float(colours == 1);
      c *= (0.86 + 0.26 * grain) * (1.0 - 0.35 * plank);
      if (colours == 0) { // a landing circle
        vec2 p = own.xy - vec2(stern + 0.105 * shipLength, 0.0);
        float r = length(p), e = fwidth(r);
        float ring = 1.0 - smoothstep(0.15, 0.15 + e, abs(r - 0.27 * breadth));
        float cross = 1.0 - smoothstep(0.12, 0.12 + e, min(abs(p.x), abs(p.y)));
        cross *= step(r, 0.1 * breadth);
        c = mix(c, vec3(0.42), max(ring, cross) * 0.8);
      }
      gloss = 0.12;
    }
  } else if (painted == 1) {
    c = colours == 0 ? vec3(0.245, 0.272, 0.295) : vec3(0.72, 0.71, 0.68);
    c *= 0.95 + 0.1 * grain;
    float up = house.y > 0.0 ? (own.z - house.x) / house.y : 0.0;
    if (house.y > 0.12 * shipLength && abs(normalB.z) < 0.6 && up > 0.54 && up < 0.90) {
      float along = abs(normalB.y) > abs(normalB.x) ? own.x / (0.085 * shipLength)
                  : own.y / (0.075 * shipLength) + 0.5;
      if (abs(fract(along) - 0.5) < 0.45) { c = vec3(0.012, 0.016, 0.02); gloss = 1.0; }
    }
    // Doors and vents, the size of people.
    bool tall = house.y > 0.0195 * shipLength && house.y < 0.05 * shipLength;
    if (colours == 0 && tall && abs(normalB.z) < 0.5) {
      float along = abs(normalB.y) > abs(normalB.x) ? own.x : own.y + 31.0;
      float cellOf = floor(along / 4.6), at = abs(fract(along / 4.6) - 0.5) * 4.6;
      float high = own.z - house.x;
      float pick = fract(sin(cellOf * 12.9898 + floor(house.x) * 7.7) * 43758.5);
      float e = fwidth(along) + fwidth(high);
      float door = step(0.62, pick) * smoothstep(0.40 + e, 0.40, at);
      door *= step(0.5, high) * step(high, 2.35);
      float vent = step(pick, 0.25) * smoothstep(0.55 + e, 0.55, at);
      vent *= step(1.5, high) * step(high, 2.2);
      c *= 1.0 - 0.45 * max(door, vent) * clamp(1.5 - e, 0.0, 1.0);
    }
    if (house.y > 0.0) c *= mix(0.72, 1.0, smoothstep(0.0, 0.45, (own.z - house.x) / house.y));
    if (normalB.z > 0.8) { c *= colours == 0 ? 0.55 : 0.85; gloss = 0.1; }
  } else if (painted == 2) { c = vec3(0.012, 0.016, 0.020); gloss = 1.0;
  } else if (painted == 3) { c = vec3(0.035);
  } else if (painted == 4) { c = vec3(0.115, 0.125, 0.13) * (0.86 + 0.26 * grain); gloss = 0.1;
  } else if (painted == 5) {
    float rib = 0.5 + 0.5 * sin(own.x * 18.0 / max(0.4, 0.2 * shipLength));
    c = vec3(0.42, 0.12, 0.045) * (0.8 + 0.2 * grain) * (0.88 + 0.12 * rib);
  } else if (painted == 6) { c = colours == 0 ? vec3(0.17, 0.185, 0.2) : vec3(0.45); gloss = 0.4;
  } else { c = vec3(0.75, 0.20, 0.03); }
  return vec4(c, gloss);
}

/// Blue to yellow to red-brown, of growing lightness and then warmth; t in 0..1.
vec3 scaleColour(float t) {
  vec3 a = vec3(0.10, 0.16, 0.42), b = vec3(0.13, 0.48, 0.60), c = vec3(0.55, 0.75, 0.42);
  vec3 d = vec3(0.95, 0.80, 0.30), e = vec3(0.85, 0.30, 0.12);
  t = clamp(t, 0.0, 1.0) * 4.0;
  return t < 1.0 ? mix(a, b, t) : t < 2.0 ? mix(b, c, t - 1.0)
       : t < 3.0 ? mix(c, d, t - 2.0) : mix(d, e, t - 3.0);
}

void main() {
  vec3 n = normalize(normalE);
  vec3 v = normalize(eye - place);
  if (dot(n, v) < 0.0) n = normalize(n - 1.02 * dot(n, v) * v);
  vec4 paint = paintAt();
  vec3 albedo = paint.rgb;
  float gloss = paint.a;
  float sea = seaAt(place.xy);
  float above = place.z - sea;
  // Wet from the last waves, a ragged edge above the water.
  float ragged = texture(noise, own.xy * 0.07 + own.z * 0.02).g;
  float wetTop = 0.08 * freeboard + 0.26 * freeboard * ragged;
  float wet = painted == 0 ? 1.0 - smoothstep(0.3 * wetTop, wetTop, above) : 0.0;
  albedo *= 1.0 - (colours == 1 ? 0.14 : 0.36) * wet;
  gloss = mix(gloss, 0.8, wet);

  float up = 0.5 + 0.5 * n.z;
  vec3 skyLight = mix(vec3(0.075, 0.085, 0.095), vec3(0.30, 0.35, 0.46), up);
  float sunward = 0.5 + 0.5 * dot(normalize(n.xy + 1e-5), normalize(sun.xy));
  skyLight += vec3(0.34, 0.20, 0.12) * sunward * sunward * (1.0 - abs(n.z));
  float ground = mix(0.62, 1.0, smoothstep(-0.1, 0.9, above / max(freeboard, 0.1)));
  if (painted != 0) ground = 1.0;
  float direct = max(dot(n, sun), 0.0);
  vec3 colour = albedo * (1.15 * skyLight * ground + SUN_COLOUR * 2.0 * direct);
  vec3 h = normalize(sun + v);
  float shine = mix(30.0, 260.0, gloss);
  float mirror = pow(max(dot(n, h), 0.0), shine) * step(0.0, dot(n, sun));
  colour += SUN_COLOUR * gloss * 0.22 * (shine + 8.0) / 60.0 * mirror;
  float fresnel = (0.04 + 0.9 * pow(1.0 - max(dot(n, v), 0.0), 5.0)) * gloss;
  vec3 r = reflect(-v, n);
  vec3 mirrored = clearSky(vec3(r.xy, max(r.z, 0.0)));
  mirrored = mix(mirrored, vec3(0.03, 0.06, 0.08), clamp(-3.0 * r.z, 0.0, 1.0));
  colour = mix(colour, mirrored, fresnel);
  // Under water, as far as see-through water shows it.
  colour = mix(colour, colour * vec3(0.45, 0.75, 0.8), below * smoothstep(0.0, -0.05, above));
  colour = haze(colour, place);
  vec3 seen = developed(colour);

  if (showPressure > 0.5 && kpa > 0.0 && painted == 0) {
    float light = 0.86 + 0.14 * dot(n, normalize(v + vec3(0.0, 0.0, 0.6)));
    float t = kpa / pressureTop;
    float steps = abs(fract(10.0 * t + 0.5) - 0.5) / max(fwidth(10.0 * t), 1e-4);
    vec3 c = scaleColour(t) * light;
    c *= 0.80 + 0.20 * clamp(steps, 0.0, 1.0);
    seen = pow(c, vec3(0.8));
  }
  if (showLine > 0.5 && painted == 0) {
    float width = max(1.6 * fwidth(above), 0.0008 * shipLength);
    float line = 1.0 - smoothstep(0.6 * width, width, abs(above));
    seen = mix(seen, vec3(0.35, 0.95, 1.0), line);
  }
  pixel = vec4(seen + dither(gl_FragCoord.xy), 1.0);
}`;

/// The material of a hull and of all that stands on it.
export function hullMaterial(light, sums, grid, ship) {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: THREE.DoubleSide,
    uniforms: {
      ...light,
      water: { value: sums.texture },
      row: { value: sums.width },
      cell: { value: grid.levels[0].cell },
      calm: { value: ship.calm },
      freeboard: { value: ship.freeboard },
      shipLength: { value: ship.length },
      stern: { value: ship.main.low[0] },
      breadth: { value: ship.main.high[1] - ship.main.low[1] },
      colours: { value: ship.colours },
      showLine: { value: 0 },
      showPressure: { value: 0 },
      pressureTop: { value: 100 },
      below: { value: 0 },
    },
  });
}

export function hullGeometry({ position, normal, paint, band }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
  geometry.setAttribute("paint", new THREE.BufferAttribute(paint, 1));
  geometry.setAttribute("band", new THREE.BufferAttribute(band, 2));
  geometry.setAttribute("pressure",
    new THREE.BufferAttribute(new Float32Array(paint.length), 1));
  return geometry;
}
