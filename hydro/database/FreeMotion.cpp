#include "hydro/database/FreeMotion.h"

namespace cutwater {

CMat6 ownVelocities(Complex s, const SteadyWay& way) {
  CMat6 N = s * CMat6::Identity();
  N(Surge, Yaw) += way.leeway;
  N(Sway, Yaw) -= way.ahead;
  N(Heave, Pitch) += way.ahead;
  return N;
}

CMat6 waterLoad(Complex s, const SteadyWay& way, const CMat6& water, const Mat6& atRest) {
  const double U = way.ahead, V = way.leeway;
  const CMat6 nu = ownVelocities(s, way);
  CMat6 p = s * water;  // water · ν, of which few elements are not on the diagonal
  p.col(Pitch) += U * water.col(Heave);
  p.col(Yaw) += V * water.col(Surge) - U * water.col(Sway);
  const Vec6 steady = atRest.col(Surge) * U + atRest.col(Sway) * V;
  CMat6 load = s * p;
  // Heading and pitch turn the steady momentum.
  load(Surge, Yaw) -= s * steady[Sway];
  load(Surge, Pitch) += s * steady[Heave];
  load(Sway, Yaw) += s * steady[Surge];
  load(Heave, Pitch) -= s * steady[Surge];
  load(Pitch, Yaw) += s * steady[Roll];
  load(Yaw, Pitch) -= s * steady[Roll];
  // V × R p_F about the level y and about the vertical.
  load.row(Pitch) -=
      U * p.row(Heave) + steady[Heave] * nu.row(Surge) - steady[Surge] * nu.row(Heave);
  load.row(Yaw) += U * p.row(Sway) + steady[Sway] * nu.row(Surge) - steady[Surge] * nu.row(Sway) -
                   V * p.row(Surge);
  load(Yaw, Pitch) -= V * steady[Heave];
  return load;
}

Mat6 freeRestoring(const Mat6& restoring) {
  Mat6 free = restoring;
  for (const int mode : {Surge, Sway, Yaw}) free.col(mode).setZero();
  return free;
}

Vec6 freeStiffness(const Vec6& given) {
  Vec6 free = given;
  for (const int mode : {Surge, Sway, Yaw}) free[mode] = 0.0;
  return free;
}

}  // namespace cutwater
