#include "hydro/forces/BoxFill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

namespace {

constexpr int kMostSteps = 80;         // of Newton and bisection
constexpr double kSameVolume = 1e-15;  // of the box

struct BasePoint {
  double x, y;
};

// A convex polygon: a rectangle cut by two lines has six corners at most.
struct BasePolygon {
  std::array<BasePoint, 8> corners;
  int count = 0;
};

// What of a polygon has h(x, y) = h0 - hx x - hy y on the side where sign h >= 0.
BasePolygon cutPolygon(const BasePolygon& from, double h0, double hx, double hy, double sign) {
  BasePolygon kept;
  const auto above = [&](const BasePoint& p) { return sign * (h0 - hx * p.x - hy * p.y); };
  for (int i = 0; i < from.count; ++i) {
    const BasePoint& a = from.corners[static_cast<std::size_t>(i)];
    const BasePoint& b = from.corners[static_cast<std::size_t>((i + 1) % from.count)];
    const double ha = above(a), hb = above(b);
    const auto add = [&](const BasePoint& p) {
      kept.corners[static_cast<std::size_t>(kept.count++)] = p;
    };
    if (ha >= 0.0) add(a);
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0)) {
      const double t = ha / (ha - hb);
      add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return kept;
}

// Sums over a base polygon: its area, and ∫h, ∫x h, ∫y h, ∫h²/2 of a column of water h(x, y). The
// edges' midpoints are exact for these, which are quadratic on each triangle.
struct ColumnSums {
  double area = 0.0, volume = 0.0;
  Vec3 moment = Vec3::Zero();

  template <class Height>
  void add(const BasePolygon& polygon, Height height) {
    for (int i = 1; i + 1 < polygon.count; ++i) {
      const BasePoint corners[3] = {polygon.corners[0],
                                    polygon.corners[static_cast<std::size_t>(i)],
                                    polygon.corners[static_cast<std::size_t>(i + 1)]};
      const double twice = (corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
                           (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x);
      const double third = std::abs(twice) / 6.0;
      for (int k = 0; k < 3; ++k) {
        const BasePoint &a = corners[k], &b = corners[(k + 1) % 3];
        const double x = 0.5 * (a.x + b.x), y = 0.5 * (a.y + b.y), h = height(x, y);
        area += third;
        volume += third * h;
        moment += third * Vec3(x * h, y * h, 0.5 * h * h);
      }
    }
  }
};

// The box seen from its deepest corner, the axis nearest to the vertical last: a·x is the height
// over that corner, a ≥ 0, |a| = 1.
struct StandingBox {
  std::array<int, 3> axis;
  Vec3 size, a;

  StandingBox(const Vec3& given, const Vec3& up) {
    int top = 0;
    for (int i = 1; i < 3; ++i) top = std::abs(up[i]) > std::abs(up[top]) ? i : top;
    axis = {(top + 1) % 3, (top + 2) % 3, top};
    for (int i = 0; i < 3; ++i) {
      size[i] = given[axis[static_cast<std::size_t>(i)]];
      a[i] = std::abs(up[axis[static_cast<std::size_t>(i)]]);
    }
  }
  double whole() const { return size.prod(); }
  double top() const { return a.dot(size); }

  // Of the water below the height t. Where the column reaches the lid it is the box's height.
  ColumnSums below(double t) const {
    BasePolygon base;
    base.corners = {{{0.0, 0.0}, {size.x(), 0.0}, {size.x(), size.y()}, {0.0, size.y()}}};
    base.count = 4;
    const double hx = a.x() / a.z(), hy = a.y() / a.z(), h0 = t / a.z(), lid = size.z();
    ColumnSums sums;
    sums.add(cutPolygon(base, h0 - lid, hx, hy, 1.0), [&](double, double) { return lid; });
    sums.area = 0.0;
    sums.add(cutPolygon(cutPolygon(base, h0 - lid, hx, hy, -1.0), h0, hx, hy, 1.0),
             [&](double x, double y) { return std::clamp(h0 - hx * x - hy * y, 0.0, lid); });
    return sums;
  }

  BoxFill seenFromMiddle(const ColumnSums& sums, double t, const Vec3& up) const {
    BoxFill fill;
    fill.volume = sums.volume;
    fill.height = t - 0.5 * top();
    fill.surface = sums.area / a.z();
    const Vec3 mean = sums.volume > 0.0 ? Vec3(sums.moment / sums.volume) : Vec3(Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
      const int to = axis[static_cast<std::size_t>(i)];
      fill.centre[to] = (mean[i] - 0.5 * size[i]) * (up[to] < 0.0 ? -1.0 : 1.0);
    }
    return fill;
  }
};

}  // namespace

BoxFill fillBoxTo(const Vec3& size, double height, const Vec3& up) noexcept {
  const StandingBox box(size, up);
  const double t = std::clamp(height + 0.5 * box.top(), 0.0, box.top());
  BoxFill fill = box.seenFromMiddle(box.below(t), t, up);
  if (t == box.top()) fill.volume = box.whole();
  return fill;
}

BoxFill fillBox(const Vec3& size, double volume, const Vec3& up) noexcept {
  const StandingBox box(size, up);
  const double whole = box.whole();
  const double wanted = volume > 0.0 ? std::min(volume, whole) : 0.0;
  if (wanted == 0.0) return box.seenFromMiddle({}, 0.0, up);
  if (wanted == whole) return fillBoxTo(size, box.top(), up);
  double low = 0.0, high = box.top(), t = high * wanted / whole;
  ColumnSums sums;
  for (int step = 0; step < kMostSteps; ++step) {
    sums = box.below(t);
    const double off = sums.volume - wanted;
    if (std::abs(off) <= kSameVolume * whole) break;
    (off > 0.0 ? high : low) = t;
    const double slope = sums.area / box.a.z();
    const double next = slope > 0.0 ? t - off / slope : low;
    const double before = t;
    t = next > low && next < high ? next : 0.5 * (low + high);
    if (t == before) break;
  }
  BoxFill fill = box.seenFromMiddle(sums, t, up);
  fill.volume = wanted;
  return fill;
}

}  // namespace cutwater
