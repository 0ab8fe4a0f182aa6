#include "plugin/FloatShape.h"

#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <LinearMath/btConvexHullComputer.h>

#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/forces/floats/FloatShapes.h"
#include "hydro/geometry/MeshIntegrals.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kMostOverlap = 0.01;  // of the volume of all children
constexpr int kSupportDirections = 500;

double metric(btScalar value) { return static_cast<double>(value); }

// A mesh that turns about z, about the axis given: by a cyclic change of axes.
SurfaceMesh alongAxis(SurfaceMesh mesh, int axis) {
  for (Vec3& p : mesh.vertices) {
    if (axis == 0) p = Vec3(p.z(), p.x(), p.y());
    if (axis == 1) p = Vec3(p.y(), p.z(), p.x());
  }
  return mesh;
}

SurfaceMesh placed(SurfaceMesh mesh, const btTransform& pose) {
  const Mat3 turn = fromBullet(pose.getBasis());
  const Vec3 to = fromBullet(pose.getOrigin());
  for (Vec3& p : mesh.vertices) p = turn * p + to;
  return mesh;
}

SurfaceMesh hullOf(const std::vector<Vec3>& points) {
  std::vector<double> numbers;
  for (const Vec3& p : points) numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  btConvexHullComputer hull;
  hull.compute(numbers.data(), static_cast<int>(3 * sizeof(double)),
               static_cast<int>(points.size()), btScalar(0), btScalar(0));
  // Bullet's own vertices are scaled to its precision and back; these are the points themselves.
  SurfaceMesh mesh;
  for (int i = 0; i < hull.vertices.size(); ++i) {
    const int original = hull.original_vertex_index[i];
    mesh.vertices.push_back(original >= 0 ? points[static_cast<std::size_t>(original)]
                                          : fromBullet(hull.vertices[i]));
  }
  for (int i = 0; i < hull.faces.size(); ++i) {
    const auto* first = &hull.edges[hull.faces[i]];
    const int corner = first->getSourceVertex();
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != corner;
         edge = edge->getNextEdgeOfFace())
      mesh.faces.push_back({{corner, edge->getSourceVertex(), edge->getTargetVertex(), -1}});
  }
  return volumeIntegrals(mesh).volume < 0.0 ? turnedOver(mesh) : mesh;
}

SurfaceMesh hullOf(const btPolyhedralConvexShape& shape) {
  std::vector<Vec3> points;
  for (int i = 0; i < shape.getNumVertices(); ++i) {
    btVector3 point;
    shape.getVertex(i, point);
    points.push_back(fromBullet(point));
  }
  return hullOf(points);
}

// Directions on a spiral from pole to pole, evenly.
SurfaceMesh supportHull(const btConvexShape& shape) {
  const double step = kPi * (3.0 - std::sqrt(5.0));
  std::vector<Vec3> points;
  for (int i = 0; i < kSupportDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kSupportDirections, r = std::sqrt(1.0 - z * z);
    const Vec3 direction(r * std::cos(i * step), r * std::sin(i * step), z);
    points.push_back(fromBullet(shape.localGetSupportingVertex(toBullet(direction))));
  }
  return hullOf(points);
}

[[noreturn]] void refuseShape(const btCollisionShape& shape, const std::string& why) {
  throw HydroError(Fault::BadArgument, "collision shape " + std::string(shape.getName()) + ": " +
                                           why + "; give a closed mesh in FloatSettings::mesh");
}

SurfaceMesh convexMesh(const btCollisionShape& shape) {
  switch (shape.getShapeType()) {
    case BOX_SHAPE_PROXYTYPE: {
      const auto& box = static_cast<const btBoxShape&>(shape);
      return floatBox(fromBullet(box.getHalfExtentsWithMargin()));
    }
    case SPHERE_SHAPE_PROXYTYPE:
      return floatBall(metric(static_cast<const btSphereShape&>(shape).getRadius()));
    case CYLINDER_SHAPE_PROXYTYPE: {
      const auto& cylinder = static_cast<const btCylinderShape&>(shape);
      const int axis = cylinder.getUpAxis();
      return alongAxis(floatCylinder(metric(cylinder.getRadius()),
                                     metric(cylinder.getHalfExtentsWithMargin()[axis])),
                       axis);
    }
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return alongAxis(floatCapsule(metric(capsule.getRadius()), metric(capsule.getHalfHeight())),
                       capsule.getUpAxis());
    }
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      return alongAxis(floatCone(metric(cone.getRadius()), metric(cone.getHeight())),
                       cone.getConeUpIndex());
    }
    case UNIFORM_SCALING_SHAPE_PROXYTYPE: {
      const auto& scaled = static_cast<const btUniformScalingShape&>(shape);
      SurfaceMesh mesh = convexMesh(*scaled.getChildShape());
      for (Vec3& p : mesh.vertices) p *= metric(scaled.getUniformScalingFactor());
      return mesh;
    }
    default:
      if (!shape.isConvex() || shape.isConvex2d())
        refuseShape(shape, shape.isConvex2d() || shape.getShapeType() == EMPTY_SHAPE_PROXYTYPE
                               ? "it encloses no volume"
                               : "what it encloses is not known");
      if (shape.isPolyhedral() &&
          static_cast<const btPolyhedralConvexShape&>(shape).getNumVertices() > 0)
        return hullOf(static_cast<const btPolyhedralConvexShape&>(shape));
      return supportHull(static_cast<const btConvexShape&>(shape));
  }
}

void addParts(const btCollisionShape& shape, const btTransform& pose,
              std::vector<SurfaceMesh>& parts) {
  if (!shape.isCompound()) {
    parts.push_back(placed(convexMesh(shape), pose));
    return;
  }
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  for (int i = 0; i < compound.getNumChildShapes(); ++i)
    addParts(*compound.getChildShape(i), pose * compound.getChildTransform(i), parts);
}

}  // namespace

SurfaceMesh meshOf(const btCollisionShape& shape) {
  std::vector<SurfaceMesh> parts;
  addParts(shape, btTransform::getIdentity(), parts);
  if (parts.empty()) refuseShape(shape, "it has no children");
  if (const double overlap = overlapOf(parts); overlap > kMostOverlap) {
    refuseShape(shape, "its children overlap in " + std::to_string(100.0 * overlap) +
                           " % of their volume, which would count twice");
  }
  SurfaceMesh mesh;
  for (const SurfaceMesh& part : parts) mesh = joined(mesh, part);
  return mesh;
}

CUTWATER_PLUGIN_END
