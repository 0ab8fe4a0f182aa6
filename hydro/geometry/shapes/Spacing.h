#pragma once
#include <functional>
#include <vector>

#include "hydro/Conventions.h"

/// How a line is divided into panel edges. All throw HydroError BadArgument for counts below 1.
namespace cutwater {

/// n + 1 values from 0 to 1 in equal steps.
std::vector<double> uniform(int n);

/// n + 1 values from 0 to 1, closer together at both ends: the spacing goes as 1 − c cos 2πu,
/// 0 ≤ c < 1.
std::vector<double> spacedAtEnds(int n, double c);

/// n + 1 values from 0 to 1, closer together at 0: the spacing goes from 1 − c to 1 + c of the mean
/// as 1 − c cos πu.
std::vector<double> spacedAtStart(int n, double c);

/// n + 1 parameters t in [0, 1] that cut the curve into n parts of equal length.
std::vector<double> equalArcs(int n, const std::function<Vec3(double)>& curve);

/// Parameters t that cut the curve at these fractions of its length, rising from 0 to 1.
std::vector<double> arcsAt(const std::vector<double>& fractions,
                           const std::function<Vec3(double)>& curve);

}  // namespace cutwater
