#pragma once

namespace cutwater {

/// How the radiated waves are remembered.
enum class MemoryModel {
  Exponential,  ///< a sum of damped oscillations (ExponentialSum.h); the default
  Convolution   ///< the convolution itself (Convolution.h): the oracle, slower by ten and more
};

}  // namespace cutwater
