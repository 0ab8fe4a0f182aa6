// Height of the sea at a point, in metres, about the camera: `at` is x, y in the sea's axes less
// the camera's. Each wave is (k cos b, -k sin b, amplitude, phase at the camera): see the manual.
float seaHeight(vec2 at) {
  float height = 0.0;
  for (int i = 0; i < waveCount; ++i) {
    height += waves[i].z * cos(waves[i].w - dot(waves[i].xy, at));
  }
  return height;
}

// Its slopes, for the normal (-slope.x, -slope.y, 1).
vec2 seaSlope(vec2 at) {
  vec2 slope = vec2(0.0, 0.0);
  for (int i = 0; i < waveCount; ++i) {
    slope += waves[i].xy * (waves[i].z * sin(waves[i].w - dot(waves[i].xy, at)));
  }
  return slope;
}
