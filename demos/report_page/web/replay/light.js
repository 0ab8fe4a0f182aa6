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

export const LIGHT_GLSL = /* glsl */ `
uniform vec3 sun;
uniform vec3 eye;
uniform sampler2D noise;
uniform vec2 cloudShift;
uniform float exposure;
const vec3 SUN_COLOUR = vec3(1.0, 0.66, 0.36);

/// Clear sky in direction d; below the horizon it is the horizon's.
vec3 clearSky(vec3 d) {
  float h = max(d.z, 0.0);
  float side = 0.5 + 0.5 * dot(normalize(d.xy + 1e-6), normalize(sun.xy));
  vec3 horizon = mix(vec3(0.38, 0.37, 0.45), vec3(1.05, 0.62, 0.34), side * side);
  vec3 middle = mix(vec3(0.24, 0.31, 0.46), vec3(0.62, 0.52, 0.50), side * side * 0.9);
  vec3 zenith = vec3(0.075, 0.135, 0.27);
  vec3 colour = mix(horizon, middle, 1.0 - exp(-9.0 * h));
  colour = mix(colour, zenith, 1.0 - exp(-2.3 * h));
  float c = max(dot(d, sun), 0.0);
  colour += SUN_COLOUR * (0.30 * pow(c, 10.0) + 0.55 * pow(c, 90.0));
  return colour;
}

/// Cover of thin cloud in direction d, and how dense it is; blur in levels of the noise texture.
vec2 cloudAt(vec3 d, float blur) {
  vec2 p = d.xy / (d.z + 0.10);
  float a = textureLod(noise, p * vec2(0.020, 0.034) + cloudShift, blur).r;
  float b = textureLod(noise, p * vec2(0.075, 0.110) - 1.7 * cloudShift, blur).g;
  float cover = smoothstep(0.50, 0.80, 0.68 * a + 0.38 * b);
  return vec2(cover * smoothstep(0.015, 0.10, d.z), a * b);
}

vec3 skyColour(vec3 d, float blur) {
  vec3 colour = clearSky(d);
  vec2 cloud = cloudAt(d, blur);
  float c = max(dot(d, sun), 0.0);
  float low = exp(-3.0 * max(d.z, 0.0));
  vec3 lit = mix(vec3(0.36, 0.35, 0.42), vec3(0.98, 0.60, 0.42), low * (0.35 + 0.65 * c));
  lit += SUN_COLOUR * 0.8 * pow(c, 12.0);
  vec3 shade = mix(lit, vec3(0.20, 0.20, 0.27), smoothstep(0.25, 0.62, cloud.y));
  return mix(colour, shade, 0.72 * cloud.x);
}

/// What the air adds between the eye and a point.
vec3 haze(vec3 colour, vec3 place) {
  vec3 ray = place - eye;
  float distance = length(ray);
  float f = 1.0 - exp(-pow(distance / 7500.0, 1.25));
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
    },
    vertexShader: /* glsl */ `
      uniform mat4 inverseView;
      uniform vec2 spread;
      out vec3 ray;
      void main() {
        ray = mat3(inverseView) * vec3(position.xy * spread, -1.0);
        gl_Position = vec4(position.xy, 1.0, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      ${LIGHT_GLSL}
      in vec3 ray;
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
