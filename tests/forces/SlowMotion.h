#pragma once
#include "hydro/forces/ForceGenerator.h"

namespace cutwater::test {

/// What a part sees of a ship in calm water that moves like this.
inline TickInput moving(double ahead, double leeway, double turn, double step = 0.02) {
  TickInput now;
  now.step = now.lastStep = step;
  now.speed = ahead;
  now.leeway = leeway;
  now.turnRate = turn;
  return now;
}

}  // namespace cutwater::test
