// Evening light: an analytic sky, haze and the tone curve, as GLSL that every shader of the replay
// shares, and the uniforms that go with it. Decoration: nothing of it comes from the run.
import * as THREE from "three";
import { noiseTexture } from "./textures.js";

/// The sun stands low; its bearing is chosen by the scene, so that its track is in view.
export const SUN_HEIGHT = (9 * Math.PI) / 180;

export function makeLight() {
  return {
    sun: { value: new THREE.Vector3(1, 0, 0.16).normalize() },
    noise: { value: noiseTexture() },
    cloudShift: { value: new THREE.Vector2() },
    eye: { value: new THREE.Vector3() },
    exposure: { value: 0.92 },
  };
}

export function aimSun(light, bearing) {
  const c = Math.cos(SUN_HEIGHT);
  light.sun.value.set(c * Math.cos(bearing), c * Math.sin(bearing), Math.sin(SUN_HEIGHT));
}

export const LIGHT_GLSL = `
uniform vec3 sun;
uniform vec3 eye;
uniform sampler2D noise;
uniform vec2 cloudShift;
uniform float exposure;
const vec3 SUN_COLOUR = vec3(1.0, 0.60, 0.30);

/// Clear sky in direction d; below the horizon it is the horizon's.
vec3 clearSky(vec3 d) {
  float h = max(d.z, 0.0);
  float side = 0.5 + 0.5 * dot(normalize(d.xy + 1e-6), normalize(sun.xy));
  side *= side;
  vec3 horizon = mix(vec3(0.29, 0.30, 0.40), vec3(1.05, 0.55, 0.25), side);
  vec3 low = mix(vec3(0.24, 0.29, 0.42), vec3(0.60, 0.42, 0.35), side);
  vec3 zenith = vec3(0.035, 0.075, 0.170);
  vec3 colour = mix(horizon, low, 1.0 - exp(-14.0 * h));
  vec3 middle = mix(vec3(0.105, 0.180, 0.335), vec3(0.175, 0.215, 0.33), side);
  colour = mix(colour, middle, 1.0 - exp(-5.0 * h));
  colour = mix(colour, zenith, 1.0 - exp(-2.2 * h));
  float c = max(dot(d, sun), 0.0);
  colour += SUN_COLOUR * (0.22 * pow(c, 9.0) + 0.50 * pow(c, 110.0));
  return colour;
}

/// Cover of thin cloud in direction d, and how dense it is; blur in levels of the noise texture.
vec2 cloudAt(vec3 d, float blur) {
  vec2 p = d.xy / (d.z + 0.085);
  float a = textureLod(noise, p * vec2(0.017, 0.024) + cloudShift, blur).r;
  float b = textureLod(noise, p * vec2(0.062, 0.083) - 1.7 * cloudShift, blur).g;
  float body = 0.70 * a + 0.36 * b;
  float cover = smoothstep(0.50, 0.66, body) * smoothstep(0.01, 0.07, d.z);
  return vec2(cover, smoothstep(0.54, 0.78, body));
}

vec3 skyColour(vec3 d, float blur) {
  vec3 colour = clearSky(d);
  vec2 cloud = cloudAt(d, blur);
  float c = max(dot(d, sun), 0.0);
  float side = 0.5 + 0.5 * dot(normalize(d.xy + 1e-6), normalize(sun.xy));
  // Edges catch the low sun, bellies are in shade; the farther, the warmer.
  float far = exp(-4.0 * max(d.z, 0.0));
  vec3 lit = mix(vec3(0.33, 0.33, 0.40), vec3(1.05, 0.55, 0.33), far * side * side);
  lit += SUN_COLOUR * 0.9 * pow(c, 14.0);
  vec3 belly = mix(vec3(0.085, 0.100, 0.150), vec3(0.25, 0.185, 0.20), far * side);
  return mix(colour, mix(lit, belly, cloud.y), 0.85 * cloud.x);
}

/// What the air adds between the eye and a point.
vec3 haze(vec3 colour, vec3 place) {
  vec3 ray = place - eye;
  float distance = length(ray);
  float f = 1.0 - exp(-pow(distance / 10000.0, 1.2));
  vec3 level = normalize(vec3(ray.xy, 0.012 * distance));
  return mix(colour, clearSky(level), f);
}

/// Film-like curve (K. Narkowicz's fit of ACES), then sRGB.
vec3 developed(vec3 x) {
  x *= exposure;
  x = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

/// Breaks up bands in smooth skies.
float dither(vec2 pixel) {
  return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}
`;

/// The sky, a triangle behind everything.
export function makeSky(light) {
  const material = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    uniforms: {
      ...light,
      inverseView: { value: new THREE.Matrix4() },
      spread: { value: new THREE.Vector2() },
      depths: { value: 0 },
    },
    vertexShader: `
      uniform mat4 inverseView;
      uniform vec2 spread;
      out vec3 ray;
      void main() {
        ray = mat3(inverseView) * vec3(position.xy * spread, -1.0);
        gl_Position = vec4(position.xy, 1.0, 1.0);
      }`,
    fragmentShader: `
      ${LIGHT_GLSL}
      in vec3 ray;
      uniform float depths;
      out vec4 pixel;
      void main() {
        vec3 d = normalize(ray);
        vec3 colour = skyColour(d, 0.0);
        float c = dot(d, sun);
        colour += vec3(30.0, 19.0, 9.0) * smoothstep(0.99994, 0.99998, c);
        colour += SUN_COLOUR * 2.2 * pow(max(c, 0.0), 1400.0);
        // The last degree above the horizon is air.
        colour = mix(colour, clearSky(normalize(vec3(d.xy, 0.012))),
                     exp(-pow(max(d.z, 0.0) / 0.02, 2.0)));
        // Below see-through water it is deep.
        colour = mix(colour, vec3(0.020, 0.055, 0.075), depths * smoothstep(0.001, -0.004, d.z));
        pixel = vec4(developed(colour) + dither(gl_FragCoord.xy), 1.0);
      }`,
    depthTest: true,
    depthWrite: false,
  });
  material.depthFunc = THREE.LessEqualDepth;
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(
    new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = 5; // after what hides it
  mesh.onBeforeRender = (renderer, scene, camera) => {
    material.uniforms.inverseView.value.copy(camera.matrixWorld);
    const t = Math.tan((camera.fov * Math.PI) / 360);
    material.uniforms.spread.value.set(t * camera.aspect, t);
  };
  return mesh;
}
