#include "hydro/forces/RadiationForce.h"

#include "hydro/memory/RetardationFunction.h"

namespace cutwater {

RadiationForce::RadiationForce(const Coefficients& coefficients, double step)
    : memory_(RetardationMatrix(coefficients), step) {}

}  // namespace cutwater
