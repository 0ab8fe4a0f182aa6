#pragma once

namespace cutwater {

/// From this share of a mode's largest damping on, damping below zero feeds the motion, which then
/// grows for ever. Less is the solver's error where damping nearly vanishes, and is lost in what
/// the other parts of the load take out.
inline constexpr double kNegativeDampingShare = 0.01;

}  // namespace cutwater
