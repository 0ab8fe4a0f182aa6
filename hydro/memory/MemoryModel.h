#pragma once

namespace cutwater {

/// How the memory of radiated waves is computed.
enum class MemoryModel {
  Exponential,  ///< a sum of damped oscillations; the default
  Convolution   ///< the convolution itself, slower by a factor of ten or more: for comparison
};

}  // namespace cutwater
