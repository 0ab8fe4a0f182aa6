#include <limits>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/database/ForwardSpeed.h"

namespace cutwater::command {

namespace {

// x-derivatives as solved, or as Tuck's form has them, T times the quantity; a file in the report's
// form without them has none.
OverFrequency<Mat6> slopes(const Coefficients& c, const OverFrequency<Mat6>& solved,
                           const OverFrequency<Mat6>& quantity) {
  if (!solved.empty() || c.forwardSpeed == ForwardSpeedForm::Report) return solved;
  OverFrequency<Mat6> found = quantity;
  const Mat6 T = tuckMatrix();
  found.forEach([&](Mat6& m) { m = (T * m).eval(); });
  return found;
}

// dA_dx and dB_dx of one frequency, null where not computed.
struct Slopes {
  const Mat6 *addedMass, *damping;
};

void append(Csv& csv, double omega, const SpeedCoefficients& moving, const Slopes& slopes) {
  const auto value = [](const Mat6* matrix, int j, int k) {
    return matrix ? (*matrix)(j, k) : std::numeric_limits<double>::quiet_NaN();
  };
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 6; ++k) {
      csv.row({omega, j + 1.0, k + 1.0, moving.addedMass(j, k), moving.damping(j, k),
               value(slopes.addedMass, j, k), value(slopes.damping, j, k)});
    }
  }
}

}  // namespace

void coefficients(const std::string& database, const SpeedOptions& moving, const std::string& out) {
  const Coefficients c = readDatabase(database, moving);
  const ForwardSpeedForm form = moving.form(c);
  const OverFrequency<Mat6> addedMassX = slopes(c, c.addedMassX, c.addedMass),
                            dampingX = slopes(c, c.dampingX, c.damping);
  const bool known = !addedMassX.empty();
  if (!known) warn(database + ": holds no x-derivatives: dA_dx and dB_dx are nan");
  const Mat6 zero = Mat6::Zero();
  Csv csv("omega,j,k,A,B,dA_dx,dB_dx");
  const auto add = [&](double omega, const Mat6& addedMass, const Mat6& damping) {
    append(csv, omega, atSpeed(c, omega, moving.speed, form),
           known ? Slopes{&addedMass, &damping} : Slopes{nullptr, nullptr});
  };
  naming(database, [&] {
    add(0.0, addedMassX.atZero, zero);
    for (std::size_t i = 0; i < c.omega.size(); ++i)
      add(c.omega[i], known ? addedMassX[i] : zero, known ? dampingX[i] : zero);
    add(std::numeric_limits<double>::infinity(), addedMassX.atInfinity, zero);
  });
  csv.write(out);
}

}  // namespace cutwater::command
