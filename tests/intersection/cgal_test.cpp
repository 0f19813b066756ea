#include "intersection/triangle_pair.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <array>
#include <random>

namespace drape::intersection::testing {
namespace {

using Vec3 = Eigen::Vector3d;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Corners = std::array<Vec3, 3>;

Kernel::Triangle_3 exact(const Corners& t) {
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

Facet facetOf(const Corners& t) {
  return {t[0], t[1], t[2]};
}

/// Pairs of triangles whose coordinates have few different values, so that they often touch.
class Pairs {
 public:
  Corners next() { return {corner(), corner(), corner()}; }

 private:
  Vec3 corner() { return {value(), value(), value()}; }
  double value() { return 0.1 * step_(random_) + 0.7; }
  std::mt19937 random_{17};
  std::uniform_int_distribution<int> step_{0, 6};
};

TEST(Cgal, agreesOnWhichTrianglesIntersect) {
  Pairs pairs;
  int met = 0;
  int asked = 0;
  while (asked < 4000) {
    const Corners a = pairs.next();
    const Corners b = pairs.next();
    if (exact(a).is_degenerate() || exact(b).is_degenerate()) {
      continue;  // CGAL does not accept these
    }
    ++asked;
    const bool expected = CGAL::do_intersect(exact(a), exact(b));
    met += expected ? 1 : 0;
    ASSERT_EQ(meet(facetOf(a), facetOf(b)), expected) << asked;
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(met, 3500);
}

/// Whether the intersection of two triangles is more than a point.
bool shareMoreThanAPoint(const Corners& a, const Corners& b) {
  const auto common = CGAL::intersection(exact(a), exact(b));
  return common && boost::get<Kernel::Point_3>(&*common) == nullptr;
}

TEST(Cgal, agreesOnWhichTrianglesIntersectBeyondASharedCorner) {
  Pairs pairs;
  int met = 0;
  int asked = 0;
  while (asked < 2000) {
    const Corners a = pairs.next();
    Corners b = pairs.next();
    b[0] = a[0];
    if (exact(a).is_degenerate() || exact(b).is_degenerate()) {
      continue;
    }
    ++asked;
    const bool expected = shareMoreThanAPoint(a, b);
    met += expected ? 1 : 0;
    ASSERT_EQ(meetBeyondCorner(facetOf(a), facetOf(b)), expected) << asked;
  }
  EXPECT_GT(met, 200);
  EXPECT_LT(met, 1800);
}

}  // namespace
}  // namespace drape::intersection::testing
