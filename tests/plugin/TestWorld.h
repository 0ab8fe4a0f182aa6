#pragma once
#include <limits>
#include <random>
#include <string>

#include "demos/scenes/BulletWorld.h"
#include "plugin/BulletTypes.h"

/// What the plugin's tests share. All of it is compiled once for each precision of Bullet.
namespace cutwater::test {

/// True in the build for Bullet in double precision.
inline constexpr bool kDouble = sizeof(btScalar) == sizeof(double);
/// One unit in the last place of a velocity of 1 m/s as Bullet stores it.
inline constexpr double kEpsilon = std::numeric_limits<btScalar>::epsilon();
/// A debug drawer that is asked for lines alone.
struct LineDrawer : btIDebugDraw {
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int,
                        const btVector3&) override {}
  void reportErrorWarning(const char*) override {}
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int) override {}
  int getDebugMode() const override { return DBG_DrawWireframe; }
};

/// For names of results: which Bullet.
inline std::string withPrecision(const std::string& quantity) {
  return quantity + (kDouble ? ", double Bullet" : ", float Bullet");
}

/// The tests' tick [s]; exact in every precision.
inline constexpr btScalar kTick = btScalar(1) / 64;

/// A stock discrete world, as a rule without gravity.
struct TestWorld : BulletWorld {
  explicit TestWorld(double gravity = 0.0) : BulletWorld(gravity) {}
};

/// Linear and angular velocity in E.
inline Vec6 velocityOf(const btRigidBody& body) {
  Vec6 v;
  v << fromBullet(body.getLinearVelocity()), fromBullet(body.getAngularVelocity());
  return v;
}

/// diag(R, R): turns six-vectors from body axes to E.
inline Mat6 turning(const btRigidBody& body) {
  Mat6 turn = Mat6::Zero();
  const Mat3 r = fromBullet(body.getWorldTransform().getBasis());
  turn.topLeftCorner<3, 3>() = r;
  turn.bottomRightCorner<3, 3>() = r;
  return turn;
}

/// A in body axes as seen from E.
inline Mat6 inEarth(const Mat6& a, const btRigidBody& body) {
  return turning(body) * a * turning(body).transpose();
}

/// Symmetric A with A x = l M x for random directions and the six given l.
Mat6 randomAddedMass(const Mat6& mass, const Vec6& ratios, std::mt19937& random);

inline Vec6 randomVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec6::NullaryExpr([&] { return normal(random); });
}

}  // namespace cutwater::test
