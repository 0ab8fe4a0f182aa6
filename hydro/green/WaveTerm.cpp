#include "hydro/green/WaveTerm.h"
namespace cutwater {
WaveTerm waveTerm(double, double) { return {}; }
}  // namespace cutwater
