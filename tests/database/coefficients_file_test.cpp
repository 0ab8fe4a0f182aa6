#include <cstring>
#include <fstream>

#include "hydro/database/CutwaterGroup.h"
#include "tests/database/FileTest.h"

// Our own file: every bit comes back, and what is damaged or not ours is refused.
namespace cutwater {
namespace {

namespace fs = std::filesystem;
using test::Edit, test::sampleShip;
using CoefficientsFile = test::FileTest;

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

template <class T>
bool sameBits(const T& a, const T& b) {
  if (a.size() != b.size()) return false;
  const auto bytes = static_cast<std::size_t>(a.size()) * sizeof a.data()[0];
  return bytes == 0 || std::memcmp(a.data(), b.data(), bytes) == 0;
}
template <class T>
bool sameBits(const std::vector<std::vector<T>>& a, const std::vector<std::vector<T>>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!sameBits(a[i], b[i])) return false;
  }
  return true;
}

void expectSame(const EngineParticulars& a, const EngineParticulars& b) {
  EXPECT_EQ(a.maxThrust, b.maxThrust);
  EXPECT_EQ(a.astern, b.astern);
  EXPECT_EQ(a.noThrustSpeed, b.noThrustSpeed);
  EXPECT_EQ(a.timeConstant, b.timeConstant);
  EXPECT_EQ(a.diameter, b.diameter);
  EXPECT_EQ(a.place, b.place);
}

void expectSame(const RudderParticulars& a, const RudderParticulars& b) {
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.place, b.place);
  EXPECT_EQ(a.aspectRatio, b.aspectRatio);
  EXPECT_EQ(a.limit, b.limit);
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.stall, b.stall);
  EXPECT_EQ(a.slipstream, b.slipstream);
  EXPECT_EQ(a.flowStraightening, b.flowStraightening);
}

void expectSame(const Coefficients& a, const Coefficients& b) {
  EXPECT_EQ(a.ship.drag.crossFlow, b.ship.drag.crossFlow);
  EXPECT_EQ(a.ship.drag.formFactor, b.ship.drag.formFactor);
  ASSERT_EQ(a.ship.engine.has_value(), b.ship.engine.has_value());
  ASSERT_EQ(a.ship.rudder.has_value(), b.ship.rudder.has_value());
  if (a.ship.engine) expectSame(*a.ship.engine, *b.ship.engine);
  if (a.ship.rudder) expectSame(*a.ship.rudder, *b.ship.rudder);
  EXPECT_EQ(a.ship.name, b.ship.name);
  EXPECT_TRUE(sameBits(a.ship.hull.vertices, b.ship.hull.vertices));
  EXPECT_TRUE(sameBits(a.ship.hull.faces, b.ship.hull.faces));
  EXPECT_TRUE(sameBits(a.ship.wetSurface.vertices, b.ship.wetSurface.vertices));
  EXPECT_TRUE(sameBits(a.ship.wetSurface.faces, b.ship.wetSurface.faces));
  EXPECT_EQ(a.ship.symmetric, b.ship.symmetric);
  EXPECT_EQ(a.ship.mass, b.ship.mass);
  EXPECT_TRUE(sameBits(a.ship.cog, b.ship.cog));
  EXPECT_TRUE(sameBits(a.ship.gyradii, b.ship.gyradii));
  EXPECT_TRUE(sameBits(a.ship.file.rotation, b.ship.file.rotation));
  EXPECT_EQ(a.ship.file.metresPerUnit, b.ship.file.metresPerUnit);
  EXPECT_TRUE(sameBits(a.ship.file.origin, b.ship.file.origin));
  EXPECT_EQ(a.ship.volume, b.ship.volume);
  EXPECT_TRUE(sameBits(a.ship.centreOfBuoyancy, b.ship.centreOfBuoyancy));
  EXPECT_TRUE(sameBits(a.ship.restoring, b.ship.restoring));
  EXPECT_EQ(a.ship.density, b.ship.density);
  EXPECT_EQ(a.ship.gravity, b.ship.gravity);
  EXPECT_TRUE(sameBits(a.ship.supplementary.damping, b.ship.supplementary.damping));
  EXPECT_TRUE(sameBits(a.ship.supplementary.stiffness, b.ship.supplementary.stiffness));
  EXPECT_EQ(a.ship.supplementary.rollDampingQuadratic, b.ship.supplementary.rollDampingQuadratic);
  EXPECT_EQ(a.provenance.code, b.provenance.code);
  EXPECT_EQ(a.provenance.version, b.provenance.version);
  EXPECT_EQ(a.provenance.meshHash, b.provenance.meshHash);
  EXPECT_EQ(a.provenance.settings, b.provenance.settings);
  EXPECT_TRUE(sameBits(a.omega, b.omega));
  EXPECT_TRUE(sameBits(a.waveOmega, b.waveOmega));
  for (const auto quantity : {&Coefficients::addedMass, &Coefficients::damping,
                              &Coefficients::addedMassX, &Coefficients::dampingX}) {
    EXPECT_TRUE(sameBits((a.*quantity).values, (b.*quantity).values));
    EXPECT_TRUE(sameBits((a.*quantity).atZero, (b.*quantity).atZero));
    EXPECT_TRUE(sameBits((a.*quantity).atInfinity, (b.*quantity).atInfinity));
  }
  EXPECT_TRUE(sameBits(a.headings, b.headings));
  EXPECT_TRUE(sameBits(a.froudeKrylov, b.froudeKrylov));
  EXPECT_TRUE(sameBits(a.diffraction, b.diffraction));
  EXPECT_TRUE(sameBits(a.conditionEven, b.conditionEven));
  EXPECT_TRUE(sameBits(a.conditionOdd, b.conditionOdd));
  EXPECT_TRUE(sameBits(a.masked, b.masked));
  EXPECT_EQ(a.conditionLimitEven, b.conditionLimitEven);
  EXPECT_EQ(a.conditionLimitOdd, b.conditionLimitOdd);
  EXPECT_EQ(a.forwardSpeed, b.forwardSpeed);
  EXPECT_TRUE(sameBits(a.diffractionTable.speeds, b.diffractionTable.speeds));
  EXPECT_TRUE(sameBits(a.diffractionTable.headings, b.diffractionTable.headings));
  EXPECT_TRUE(sameBits(a.diffractionTable.waveOmega, b.diffractionTable.waveOmega));
  EXPECT_TRUE(sameBits(a.diffractionTable.values, b.diffractionTable.values));
  for (const auto list : {&Coefficients::adjoint, &Coefficients::adjointX}) {
    ASSERT_EQ((a.*list).size(), (b.*list).size());
    for (std::size_t i = 0; i < (a.*list).size(); ++i)
      EXPECT_TRUE(sameBits((a.*list)[i], (b.*list)[i]));
    EXPECT_TRUE(sameBits((a.*list).atZero, (b.*list).atZero));
    EXPECT_TRUE(sameBits((a.*list).atInfinity, (b.*list).atInfinity));
  }
}

TEST_F(CoefficientsFile, GivesBackEveryBit) {
  std::string warning = "unset";
  writeCoefficients(sampleShip(), path());
  expectSame(sampleShip(), readCoefficients(path(), &warning));
  EXPECT_EQ(warning, "");
  EXPECT_EQ(files(), 1u);  // no temporary file
}

TEST_F(CoefficientsFile, HoldsAShipWithoutTheOptionalParts) {
  Coefficients c = sampleShip();
  c.ship.name.clear();
  c.ship.hull = {};
  c.provenance.settings.clear();
  c.addedMassX = {};
  c.dampingX = {};
  for (auto* vectors : {&c.adjoint, &c.adjointX}) *vectors = {};
  c.diffractionTable = {};
  c.masked.clear();
  c.conditionLimitEven.clear();
  c.conditionLimitOdd.clear();
  c.conditionOdd.clear();
  c.headings.clear();
  c.froudeKrylov.clear();
  c.diffraction.clear();
  c.waveOmega.clear();
  writeCoefficients(c, path());
  expectSame(c, readCoefficients(path()));
}

TEST_F(CoefficientsFile, FailedWriteLeavesTheOldFileAndNothingElse) {
  writeCoefficients(sampleShip(), path());
  const std::string before = bytesOf(path());
  Coefficients bad = sampleShip();
  bad.damping[2](1, 1) = std::nan("");
  try {
    writeCoefficients(bad, path());
    FAIL() << "NaN was written";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    EXPECT_NE(std::string(error.what()).find("damping"), std::string::npos) << error.what();
  }
  // Fails late, in the middle of the file.
  EXPECT_THROW(writeCoefficients(sampleShip(), path(), {0.1, {Mat6::Constant(HUGE_VAL)}}),
               HydroError);
  EXPECT_EQ(bytesOf(path()), before);
  EXPECT_EQ(files(), 1u);
  EXPECT_THROW(writeCoefficients(sampleShip(), path("no/such/folder.h5")), HydroError);
  fs::create_directory(path("taken"));  // a folder is in the way: the rename fails
  EXPECT_THROW(writeCoefficients(sampleShip(), path("taken")), HydroError);
  EXPECT_EQ(files(), 2u);
}

// One flipped bit, anywhere in the file, is refused; in the seal's own letters it makes a file
// without a seal, whose content is checked all the same.
TEST_F(CoefficientsFile, DamagedFileIsRefused) {
  writeCoefficients(sampleShip(), path());
  const std::string whole = bytesOf(path());
  const std::size_t letters = whole.size() - 24;
  std::vector<std::size_t> places;
  for (std::size_t at = 0; at < letters; at += whole.size() / 50) places.push_back(at);
  for (std::size_t at = letters; at < whole.size(); ++at) places.push_back(at);
  for (std::size_t at : places) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
    put(path("damaged.h5"), bytes);
    if (at >= letters && at < letters + 8) {
      expectSame(sampleShip(), readCoefficients(path("damaged.h5")));
    } else {
      EXPECT_EQ(faultOf(path("damaged.h5")), Fault::FileMalformed) << "byte " << at;
    }
  }
}

TEST_F(CoefficientsFile, TruncatedFileIsRefused) {
  writeCoefficients(sampleShip(), path());
  const std::string whole = bytesOf(path());
  for (std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{600}, whole.size() / 2, whole.size() - 25}) {
    put(path("short.h5"), whole.substr(0, length));
    EXPECT_EQ(faultOf(path("short.h5")), Fault::FileMalformed) << length;
  }
}

TEST_F(CoefficientsFile, ChangedNumberIsRefusedWhereverItStands) {
  for (const char* name :
       {"cutwater/omega", "cutwater/ship/mass", "body1/hydro_coeffs/added_mass/all",
        "body1/hydro_coeffs/excitation/components/re/1_1"}) {
    writeCoefficients(sampleShip(), path());
    Edit(path()).set(name, 1.5);
    EXPECT_EQ(faultOf(path()), Fault::FileMalformed) << name;
  }
}

TEST_F(CoefficientsFile, NewerVersionIsRefused) {
  writeCoefficients(sampleShip(), path());
  Edit(path()).version(kFormatVersion + 1);
  EXPECT_EQ(faultOf(path()), Fault::VersionNotSupported);
}

// Its adjoint vectors held another quantity.
TEST_F(CoefficientsFile, FirstVersionIsRefused) {
  writeCoefficients(sampleShip(), path());
  Edit(path()).version(1);
  EXPECT_EQ(faultOf(path()), Fault::VersionNotSupported);
}

TEST_F(CoefficientsFile, StatusAndReasonComeBack) {
  Coefficients c = sampleShip();
  c.status = CoefficientStatus::Finished;
  c.addedMassInfDirect = c.addedMass.atInfinity;
  writeCoefficients(c, path());
  EXPECT_EQ(readCoefficients(path()).status, CoefficientStatus::Finished);
  c.addedMassInfDirect.setZero();
  c.status = CoefficientStatus::Unfinished;
  c.unfinishedBecause = "steps of 0.2 rad/s are too coarse";
  writeCoefficients(c, path());
  const Coefficients back = readCoefficients(path());
  EXPECT_EQ(back.status, CoefficientStatus::Unfinished);
  EXPECT_EQ(back.unfinishedBecause, c.unfinishedBecause);
}

// A status that the numbers contradict, or a reason without its status.
TEST_F(CoefficientsFile, AStatusThatCannotBeIsRefused) {
  for (const auto& [status, reason] : {std::pair{CoefficientStatus::Finished, ""},
                                       {CoefficientStatus::Unfinished, ""},
                                       {CoefficientStatus::Given, "too coarse"}}) {
    Coefficients c = sampleShip();
    c.addedMassInfDirect.setZero();
    c.status = status;
    c.unfinishedBecause = reason;
    EXPECT_THROW(writeCoefficients(c, path()), HydroError) << reason;
  }
  EXPECT_EQ(files(), 0u);
}

// A time domain that reads K and f from the file must not find any.
TEST_F(CoefficientsFile, UnfinishedDatabasesHoldNoImpulseResponses) {
  Coefficients c = sampleShip();
  writeCoefficients(c, path());
  EXPECT_TRUE(hdf5::Reader(path()).has("body1/hydro_coeffs/excitation/impulse_response_fun/f"));
  c.status = CoefficientStatus::Unfinished;
  c.unfinishedBecause = "one frequency";
  writeCoefficients(c, path());
  EXPECT_FALSE(hdf5::Reader(path()).has("body1/hydro_coeffs/excitation/impulse_response_fun/f"));
}

TEST_F(CoefficientsFile, SizesThatDoNotMatchAreRefused) {
  const auto refused = [&](auto&& change, const char* word) {
    Coefficients c = sampleShip();
    change(c);
    try {
      writeCoefficients(c, path());
      ADD_FAILURE() << word << " was written";
    } catch (const HydroError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused([](Coefficients& c) { c.adjointX.values.pop_back(); }, "adjoint_x");
  refused([](Coefficients& c) { c.adjoint.atInfinity.conservativeResize(6, 1); }, "adjoint_inf");
  refused([](Coefficients& c) { c.masked[1] = 2; }, "masked");
  refused([](Coefficients& c) { c.masked.pop_back(); }, "masked");
  refused([](Coefficients& c) { c.diffractionTable.values.pop_back(); }, "diffraction_table");
  refused([](Coefficients& c) { c.diffractionTable.waveOmega[2] = 0.4; }, "wave_omega");
  refused([](Coefficients& c) { c.conditionLimitEven[1].first = 0.0; }, "condition_limit_even");
  refused([](Coefficients& c) { c.adjointX.atZero(2, 1) = Complex(0.0, HUGE_VAL); },
          "adjoint_x_zero");
}

TEST_F(CoefficientsFile, MissingFileAndOtherFilesAreRefused) {
  EXPECT_EQ(faultOf(path("none.h5")), Fault::FileNotReadable);
  EXPECT_EQ(faultOf(folder_.string()), Fault::FileNotReadable);
  put(path("text.h5"), "omega,A,B\n");
  EXPECT_EQ(faultOf(path("text.h5")), Fault::FileMalformed);
  H5Fclose(H5Fcreate(path("empty.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(faultOf(path("empty.h5")), Fault::FormatNotSupported);
}

}  // namespace
}  // namespace cutwater
