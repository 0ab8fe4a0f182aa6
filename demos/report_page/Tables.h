#pragma once
#include <set>
#include <string>

#include "demos/report_page/Json.h"
#include "hydro/database/Coefficients.h"

/// What the commands coefficients, excitation, retardation and rao write, for the page. What a
/// database does not hold is null or nan, with a warning that names `file`.
namespace cutwater::page {

void coefficientsJson(Json& json, const Coefficients& coefficients);
/// At rest.
void excitationJson(Json& json, const Coefficients& coefficients, const std::string& file);
/// K⁰ over as long as it lasts.
void retardationJson(Json& json, const Coefficients& coefficients, const std::string& file);
/// Of the ship on a fixed course and of the free ship, at each of these speeds [m/s].
void raosJson(Json& json, const Coefficients& coefficients, const std::string& file,
              const std::set<double>& speeds);

/// Wave frequencies of all tables of the page [rad/s]: those of the database, parted evenly until
/// they are at least `kFewestWaves`.
inline constexpr std::size_t kFewestWaves = 60;
std::vector<double> waveGrid(const Coefficients& coefficients);
/// Re and im of each mode, in this order.
void append(std::vector<double>& numbers, const CVec6& values);

}  // namespace cutwater::page
