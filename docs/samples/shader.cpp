// The manual's sea in a shader: its waves as four floats each, and the shader's own text compiled
// here as C++ and compared with the sea that moves the ships, after a day.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "hydro/waves/Spectrum.h"

namespace {

// What of GLSL the text needs.
struct vec2 {
  float x, y;
  vec2& operator+=(vec2 other) {
    x += other.x;
    y += other.y;
    return *this;
  }
};
struct vec4 {
  vec2 xy;
  float z, w;
};
vec2 operator*(vec2 v, float f) { return {v.x * f, v.y * f}; }
float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
using std::cos, std::sin;

int waveCount = 0;
std::array<vec4, 200> waves;

#define vec2(a, b) \
  vec2 { float(a), float(b) }
#include "docs/samples/sea.glsl"
#undef vec2

//! [waves]
// What the shader needs of a sea at a time, about the camera. The phases are reduced in double
// precision, each frame, so that floats are good to a fraction of a millimetre after days.
std::vector<std::array<float, 4>> forShader(const cutwater::SeaState& sea, double time,
                                            double cameraX, double cameraY) {
  std::vector<std::array<float, 4>> all;
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const cutwater::WaveComponent& wave = sea.components()[i];
    const double k = sea.waveNumber(i);
    const double kx = k * std::cos(wave.heading), ky = -k * std::sin(wave.heading);
    const double phase = wave.omega * time - kx * cameraX - ky * cameraY + wave.phase;
    all.push_back({float(kx), float(ky), float(sea.growth(i, time) * wave.amplitude),
                   float(std::remainder(phase, 2.0 * cutwater::kPi))});
  }
  return all;
}
//! [waves]

}  // namespace

int main() {
  const cutwater::SeaState sea =
      cutwater::makeSeaState({.hs = 3.0, .tp = 9.0}, {.spreading = 4.0, .components = 200});
  const double time = 86400.0, x = 20000.0, y = -7000.0;
  for (const auto& [kx, ky, amplitude, phase] : forShader(sea, time, x, y))
    waves[static_cast<std::size_t>(waveCount++)] = {{kx, ky}, amplitude, phase};
  double worst = 0.0, steepest = 0.0;
  for (int i = -20; i <= 20; ++i) {
    const float dx = 5.0f * static_cast<float>(i), dy = 3.0f * static_cast<float>(i % 7);
    const double exact = sea.elevation(time, x + double(dx), y + double(dy));
    worst = std::max(worst, std::abs(double(seaHeight({dx, dy})) - exact));
    const double beside = sea.elevation(time, x + double(dx) + 1e-4, y + double(dy));
    steepest = std::max(steepest, std::abs(double(seaSlope({dx, dy}).x) - (beside - exact) / 1e-4));
  }
  std::printf("the shader's sea is right to %.1e m, its slope to %.1e\n", worst, steepest);
  // Within 100 m of the camera k x stays below 15, which floats hold to 1e-6; amplitudes add by
  // their squares to 1 m.
  return worst < 1e-5 && steepest < 1e-4 ? 0 : 1;
}
