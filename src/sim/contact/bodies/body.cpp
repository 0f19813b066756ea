#include "sim/contact/bodies/body.hpp"

#include <cmath>
#include <numbers>

namespace drape::sim::contact {
namespace {

constexpr int sectors = 64;  // around the axis of a sphere or a capsule
constexpr int rings = 32;    // from pole to pole

/// A surface of revolution around the y axis with a pole at each end. `ring(k)` returns the radius and the height of
/// ring k, 1 to count - 1, from the top down.
template <typename Ring>
BodySurface revolve(int count, double top, double bottom, const Ring& ring) {
  BodySurface surface;
  surface.positions.emplace_back(0.0, top, 0.0);
  for (int k = 1; k < count; ++k) {
    const auto [radius, height] = ring(k);
    for (int s = 0; s < sectors; ++s) {
      const double angle = 2.0 * std::numbers::pi * s / sectors;
      surface.positions.emplace_back(radius * std::sin(angle), height, radius * std::cos(angle));
    }
  }
  surface.positions.emplace_back(0.0, bottom, 0.0);
  const int last = static_cast<int>(surface.positions.size()) - 1;
  const auto at = [](int k, int s) { return 1 + (k - 1) * sectors + s % sectors; };
  for (int s = 0; s < sectors; ++s) {
    surface.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (int k = 1; k + 1 < count; ++k) {
      surface.triangles.push_back({at(k, s), at(k + 1, s), at(k + 1, s + 1)});
      surface.triangles.push_back({at(k, s), at(k + 1, s + 1), at(k, s + 1)});
    }
    surface.triangles.push_back({at(count - 1, s), last, at(count - 1, s + 1)});
  }
  return surface;
}

BodySurface surface(const PlaneShape& plane) {
  const double a = plane.halfSize;
  return {{{-a, 0.0, -a}, {-a, 0.0, a}, {a, 0.0, a}, {a, 0.0, -a}}, {{0, 1, 2}, {0, 2, 3}}};
}

BodySurface surface(const SphereShape& sphere) {
  const double r = sphere.radius;
  return revolve(rings, r, -r, [r](int k) {
    const double angle = std::numbers::pi * k / rings;
    return std::pair(r * std::sin(angle), r * std::cos(angle));
  });
}

BodySurface surface(const CapsuleShape& capsule) {
  const double r = capsule.radius;
  const double end = capsule.halfLength;
  constexpr int half = rings / 2;
  // The equator appears twice, once at each end of the cylinder.
  return revolve(rings + 1, end + r, -end - r, [r, end](int k) {
    const double angle = std::numbers::pi * (k <= half ? k : k - 1) / rings;
    return std::pair(r * std::sin(angle), r * std::cos(angle) + (k <= half ? end : -end));
  });
}

BodySurface surface(const BoxShape& box) {
  BodySurface result;
  for (int i = 0; i < 8; ++i) {
    const Vec3 sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    result.positions.emplace_back(sign.cwiseProduct(box.half));
  }
  result.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return result;
}

BodySurface surface(const std::shared_ptr<const MeshShape>& mesh) {
  return {mesh->positions, mesh->triangles};
}

}  // namespace

BodySurface surfaceOf(const BodyShape& shape) {
  return std::visit([](const auto& each) { return surface(each); }, shape);
}

Vec3 carriedBy(const BodyStep& body, const CarriedPin& pin, const Vec3& position) {
  Vec3 local = body.start.toLocal(position);
  if (pin.anchor >= 0) {
    const int anchor = pin.anchor;
    local += body.endVertices[anchor] - body.startVertices[anchor];
  }
  return body.end.toWorld(local);
}

}  // namespace drape::sim::contact
