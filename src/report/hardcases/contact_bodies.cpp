#include "report/hardcases/contact_bodies.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace drape::report::hardcases {
namespace {

using sim::contact::MeshShape;

constexpr double fullTurn = 2.0 * std::numbers::pi;  // [rad]

std::shared_ptr<MeshShape> shapeOf(sim::ClothMesh mesh) {
  auto shape = std::make_shared<MeshShape>();
  shape->positions = std::move(mesh.positions);
  shape->triangles = std::move(mesh.triangles);
  return shape;
}

/// The first vertex of each point of a profile. A point on the axis has one vertex, others one for each sector.
std::vector<int> firstVertices(const std::vector<ProfilePoint>& profile, int sectors) {
  std::vector<int> first{0};
  for (const ProfilePoint& point : profile) {
    first.push_back(first.back() + (point.radius > 0.0 ? sectors : 1));
  }
  return first;
}

}  // namespace

sim::contact::Body bodyAt(const std::string& name, sim::contact::BodyShape shape, const Vec3& position,
                          const Vec3& rotation) {
  return movingBody(name, std::move(shape), {{0.0, position, rotation}});
}

sim::contact::Body movingBody(const std::string& name, sim::contact::BodyShape shape,
                              std::vector<sim::contact::Keyframe> keyframes) {
  sim::contact::Body body;
  body.name = name;
  body.shape = std::move(shape);
  body.motion.keyframes = std::move(keyframes);
  return body;
}

sim::ClothMesh revolved(const std::vector<ProfilePoint>& profile, int sectors, bool closed) {
  sim::ClothMesh mesh;
  const std::vector<int> first = firstVertices(profile, sectors);
  for (const ProfilePoint& point : profile) {
    for (int s = 0; s < (point.radius > 0.0 ? sectors : 1); ++s) {
      const double angle = fullTurn * s / sectors;
      mesh.positions.emplace_back(point.radius * std::sin(angle), point.height, point.radius * std::cos(angle));
    }
  }
  const auto at = [&](std::size_t point, int sector) {
    return first[point] + (profile[point].radius > 0.0 ? sector % sectors : 0);
  };
  const std::size_t rings = profile.size() - (closed ? 0 : 1);
  for (std::size_t from = 0; from < rings; ++from) {
    const std::size_t to = (from + 1) % profile.size();
    for (int s = 0; s < sectors; ++s) {
      if (profile[to].radius > 0.0) {
        mesh.triangles.push_back({at(from, s), at(to, s), at(to, s + 1)});
      }
      if (profile[from].radius > 0.0) {
        mesh.triangles.push_back({at(from, s), at(to, s + 1), at(from, s + 1)});
      }
    }
  }
  return mesh;
}

std::shared_ptr<const MeshShape> torusShape(double ring, double tube) {
  constexpr int around = 16;
  constexpr int sectors = 48;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i < around; ++i) {
    const double angle = -fullTurn * i / around;
    profile.push_back({ring + tube * std::cos(angle), tube * std::sin(angle)});
  }
  return shapeOf(revolved(profile, sectors, true));
}

std::shared_ptr<const MeshShape> spikeShape(double radius, double height) {
  constexpr int sectors = 24;
  return shapeOf(revolved({{0.0, height}, {radius, 0.0}, {0.0, 0.0}}, sectors, false));
}

std::shared_ptr<const MeshShape> bladeShape(double length, double height, double width) {
  const double x = 0.5 * length;
  const double z = 0.5 * width;
  auto shape = std::make_shared<MeshShape>();
  shape->positions = {{-x, 0.0, -z}, {-x, 0.0, z}, {-x, height, 0.0}, {x, 0.0, -z}, {x, 0.0, z}, {x, height, 0.0}};
  shape->triangles = {{0, 1, 2}, {3, 5, 4}, {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}, {0, 3, 4}, {0, 4, 1}};
  return shape;
}

std::shared_ptr<const MeshShape> hollowSphereShape(const std::vector<double>& radii, double frameTime) {
  constexpr int rings = 16;
  constexpr int sectors = 24;
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= rings; ++k) {
    const double angle = 0.5 * fullTurn * k / rings;
    profile.push_back({k == 0 || k == rings ? 0.0 : std::sin(angle), std::cos(angle)});
  }
  auto shape = shapeOf(revolved(profile, sectors, false));
  shape->triangles.pop_back();
  for (const double radius : radii) {
    shape->frames.push_back(shape->positions);
    for (Vec3& position : shape->frames.back()) {
      position *= radius;
    }
  }
  shape->positions = shape->frames.front();
  shape->frameTime = frameTime;
  return shape;
}

void append(sim::ClothMesh& mesh, const sim::ClothMesh& other) {
  const auto first = static_cast<int>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace drape::report::hardcases
