#include "garment_shapes.hpp"

#include "io/garments/implicit_solid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

namespace drape::scene::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double cell = 0.03;  // [m]

/// The triangles with a kept centre, and their vertices.
sim::ClothMesh part(const io::RawMesh& whole, const std::function<bool(const Vec3&)>& keeps) {
  sim::ClothMesh mesh;
  std::vector<int> number(whole.positions.size(), -1);
  for (const Triangle& triangle : whole.triangles) {
    Vec3 middle = Vec3::Zero();
    for (const int corner : triangle) {
      middle += whole.positions[corner] / 3.0;
    }
    if (!keeps(middle)) {
      continue;
    }
    Triangle kept{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      int& vertex = number[triangle[corner]];
      if (vertex < 0) {
        vertex = static_cast<int>(mesh.positions.size());
        mesh.positions.push_back(whole.positions[triangle[corner]]);
      }
      kept[corner] = vertex;
    }
    mesh.triangles.push_back(kept);
  }
  return mesh;
}

/// Rings of points, each joined to the next.
sim::ClothMesh rings(int count, int around, const std::function<Vec3(double height, double angle)>& place) {
  sim::ClothMesh mesh;
  for (int ring = 0; ring < count; ++ring) {
    for (int i = 0; i < around; ++i) {
      mesh.positions.push_back(place(ring / (count - 1.0), 2.0 * pi * i / around));
    }
  }
  for (int ring = 0; ring + 1 < count; ++ring) {
    for (int i = 0; i < around; ++i) {
      const int a = ring * around + i;
      const int b = ring * around + (i + 1) % around;
      mesh.triangles.push_back({a, a + around, b});
      mesh.triangles.push_back({b, a + around, b + around});
    }
  }
  return mesh;
}

Vec3 armDirection(double side, double degreesBelow) {
  const double angle = degreesBelow * pi / 180.0;
  return {side * std::cos(angle), -std::sin(angle), 0.0};
}

}  // namespace

sim::ClothMesh shirt(const GarmentSizes& sizes) {
  const double top = sizes.height;
  const double hem = sizes.flare * sizes.chest;
  const io::TaperedBar trunk{Vec3(0, -0.2, 0), Vec3(0, top - 0.08, 0), hem, sizes.chest, sizes.depth};
  const auto shoulder = [&](double side) { return Vec3(side * (sizes.chest - 0.07), top - 0.09, 0.0); };
  const auto solid = [&](const Vec3& p) {
    double distance = io::distanceTo(trunk, p);
    for (const double side : {-1.0, 1.0}) {
      const Vec3 along = armDirection(side, sizes.sleeveAngle);
      const io::TaperedBar arm{shoulder(side), shoulder(side) + (sizes.sleeve + 0.3) * along, 0.085, 0.06};
      distance = io::joined(distance, io::distanceTo(arm, p), 0.03);
    }
    return std::max(distance, p.y() - top);  // level at the shoulders
  };
  const double reach = sizes.chest + sizes.sleeve + 0.5;
  const io::RawMesh whole =
      io::surfaceOf(solid, Vec3(-reach, -hem - 0.3, -0.5 - hem), Vec3(reach, top + 0.1, 0.5 + hem), cell);
  return part(whole, [&](const Vec3& p) {
    const Vec3 arm = p - shoulder(p.x() < 0.0 ? -1.0 : 1.0);
    const bool pastCuff = arm.dot(armDirection(p.x() < 0.0 ? -1.0 : 1.0, sizes.sleeveAngle)) > sizes.sleeve + 0.07;
    const double drop = p.z() > 0.0 ? sizes.neckDepth : 0.02;
    const bool inNeck =
        std::abs(p.x()) < sizes.neck && p.y() > top - drop * std::sqrt(1.0 - std::pow(p.x() / sizes.neck, 2));
    const bool inGap = p.z() > 0.0 && std::abs(p.x()) < sizes.frontGap;
    return p.y() > 0.0 && !inGap && !(pastCuff && std::abs(p.x()) > 0.5 * sizes.chest) && !inNeck;
  });
}

sim::ClothMesh trousers(double legs) {
  const auto solid = [&](const Vec3& p) {
    double distance =
        io::distanceTo(io::TaperedBar{Vec3(0, legs + 0.05, 0), Vec3(0, legs + 0.5, 0), 0.19, 0.17, 0.65}, p);
    for (const double side : {-1.0, 1.0}) {
      const io::TaperedBar leg{Vec3(side * 0.12, -0.3, 0), Vec3(side * 0.095, legs, 0), 0.07, 0.1};
      distance = io::joined(distance, io::distanceTo(leg, p), 0.02);
    }
    return distance;
  };
  const io::RawMesh whole = io::surfaceOf(solid, Vec3(-0.5, -0.5, -0.4), Vec3(0.5, legs + 0.8, 0.4), 0.02);
  return part(whole, [&](const Vec3& p) { return p.y() > 0.0 && p.y() < legs + 0.25; });
}

sim::ClothMesh briefs() {
  const sim::ClothMesh shorts = trousers(0.2);
  io::RawMesh whole;
  whole.positions = shorts.positions;
  whole.triangles = shorts.triangles;
  return part(whole, [](const Vec3& p) { return p.y() > 0.1 + 1.3 * (std::abs(p.x()) - 0.05); });
}

sim::ClothMesh hoodedRobe() {
  const auto solid = [](const Vec3& p) {
    double distance = io::distanceTo(io::TaperedBar{Vec3(0, -0.2, 0), Vec3(0, 1.3, 0), 0.32, 0.2, 0.7}, p);
    distance =
        io::joined(distance, io::distanceTo(io::TaperedBar{Vec3(0, 1.3, 0), Vec3(0, 1.55, 0), 0.12, 0.11}, p), 0.04);
    distance = io::joined(distance, io::distanceTo(io::Ellipsoid{Vec3(0, 1.6, 0.02), Vec3(0.14, 0.18, 0.16)}, p), 0.04);
    for (const double side : {-1.0, 1.0}) {
      const Vec3 shoulder(side * 0.16, 1.36, 0.0);
      const io::TaperedBar arm{shoulder, shoulder + 0.9 * armDirection(side, 35.0), 0.09, 0.16};
      distance = io::joined(distance, io::distanceTo(arm, p), 0.04);
    }
    return distance;
  };
  const io::RawMesh whole = io::surfaceOf(solid, Vec3(-1.3, -0.6, -0.5), Vec3(1.3, 1.9, 0.5), cell);
  return part(whole, [](const Vec3& p) {
    const double side = p.x() < 0.0 ? -1.0 : 1.0;
    const bool pastCuff =
        (p - Vec3(side * 0.16, 1.36, 0.0)).dot(armDirection(side, 35.0)) > 0.6 && std::abs(p.x()) > 0.35;
    const bool inFace = p.z() > 0.05 && std::abs(p.x()) < 0.09 && std::abs(p.y() - 1.6) < 0.1;
    return p.y() > 0.1 && !pastCuff && !inFace;
  });
}

sim::ClothMesh apron() {
  // A sheet with a hole for the head, whose upper end is bent backwards.
  constexpr double bend = 0.85;  // [m]
  io::RawMesh whole;
  const sim::ClothMesh flat = sheet(0, 1, 0.6, 1.1, 45);
  whole.triangles = flat.triangles;
  for (const Vec3& p : flat.positions) {
    whole.positions.emplace_back(p.x() - 0.3, p.y(), 0.0);
  }
  sim::ClothMesh mesh = part(whole, [&](const Vec3& p) {
    const double halfWidth = p.y() < 0.5 ? 0.28 : 0.13;
    const bool inHole = std::abs(p.x()) < 0.1 && p.y() > bend && p.y() < 1.05;
    return std::abs(p.x()) < halfWidth && !inHole;
  });
  for (Vec3& p : mesh.positions) {
    const double behind = std::max(0.0, p.y() - bend);
    p = Vec3(p.x(), p.y() - 0.3 * behind, 0.14 - 0.6 * p.x() * p.x() - 0.9 * behind);
  }
  return mesh;
}

sim::ClothMesh tube(double height, double hem, double top, double depth) {
  return rings(16, 36, [&](double t, double angle) {
    const double radius = hem + t * (top - hem);
    return Vec3(radius * std::sin(angle), t * height, depth * radius * std::cos(angle));
  });
}

sim::ClothMesh openCape(double gap, double length) {
  constexpr int rows = 24;
  constexpr int columns = 60;
  sim::ClothMesh mesh;
  for (int row = 0; row <= rows; ++row) {
    const double t = static_cast<double>(row) / rows;
    const double radius = 0.1 + 0.35 * std::pow(t, 0.7);
    for (int column = 0; column <= columns; ++column) {
      const double angle = (90.0 + 0.5 * gap + (360.0 - gap) * column / columns) * pi / 180.0;
      mesh.positions.emplace_back(radius * std::cos(angle), length * (1.0 - std::pow(t, 1.3)),
                                  radius * std::sin(angle));
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = row * (columns + 1) + column;
      const int b = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

sim::ClothMesh sock() {
  const auto solid = [](const Vec3& p) {
    const io::TaperedBar leg{Vec3(0, 0.05, 0), Vec3(0, 0.5, 0), 0.045, 0.055};
    const io::TaperedBar foot{Vec3(0, 0.04, 0), Vec3(0, 0.035, 0.16), 0.045, 0.035};
    return io::joined(io::distanceTo(leg, p), io::distanceTo(foot, p), 0.02);
  };
  return part(io::surfaceOf(solid, Vec3(-0.15, -0.1, -0.15), Vec3(0.15, 0.6, 0.3), 0.015),
              [](const Vec3& p) { return p.y() < 0.3; });
}

sim::ClothMesh figure(double armAngle) {
  const auto solid = [&](const Vec3& p) {
    double distance = io::distanceTo(io::TaperedBar{Vec3(0, 0.85, 0), Vec3(0, 1.32, 0), 0.16, 0.18, 0.6}, p);
    distance =
        io::joined(distance, io::distanceTo(io::TaperedBar{Vec3(0, 1.35, 0), Vec3(0, 1.5, 0), 0.06, 0.055}, p), 0.03);
    distance = io::joined(distance, io::distanceTo(io::Ellipsoid{Vec3(0, 1.58, 0.02), Vec3(0.08, 0.12, 0.1)}, p), 0.02);
    for (const double side : {-1.0, 1.0}) {
      const Vec3 shoulder(side * 0.16, 1.38, 0.0);
      const io::TaperedBar arm{shoulder, shoulder + 0.65 * armDirection(side, armAngle), 0.05, 0.035};
      const io::TaperedBar leg{Vec3(side * 0.09, 0.05, 0), Vec3(side * 0.09, 0.85, 0), 0.045, 0.085};
      const io::TaperedBar foot{Vec3(side * 0.09, 0.03, 0), Vec3(side * 0.11, 0.03, 0.16), 0.04, 0.035};
      distance = io::joined(distance, io::distanceTo(arm, p), 0.03);
      distance = io::joined(io::joined(distance, io::distanceTo(leg, p), 0.03), io::distanceTo(foot, p), 0.02);
    }
    return distance;
  };
  return part(io::surfaceOf(solid, Vec3(-1.0, -0.1, -0.4), Vec3(1.0, 1.85, 0.4), cell),
              [](const Vec3&) { return true; });
}

sim::ClothMesh sheet(int across, int along, double width, double height, int resolution) {
  sim::ClothMesh mesh;
  for (int row = 0; row < resolution; ++row) {
    for (int column = 0; column < resolution; ++column) {
      Vec3 place = Vec3::Zero();
      place[across] = width * column / (resolution - 1);
      place[along] = height * row / (resolution - 1);
      mesh.positions.push_back(place);
    }
  }
  for (int row = 0; row + 1 < resolution; ++row) {
    for (int column = 0; column + 1 < resolution; ++column) {
      const int a = row * resolution + column;
      mesh.triangles.push_back({a, a + 1, a + resolution});
      mesh.triangles.push_back({a + 1, a + resolution + 1, a + resolution});
    }
  }
  return mesh;
}

sim::ClothMesh withZUp(sim::ClothMesh mesh) {
  for (Vec3& position : mesh.positions) {
    position = Vec3(position.x(), -position.z(), position.y());
  }
  return mesh;
}

sim::ClothMesh scaled(sim::ClothMesh mesh, double factor) {
  for (Vec3& position : mesh.positions) {
    position *= factor;
  }
  return mesh;
}

std::string objText(const sim::ClothMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const Vec3& position : mesh.positions) {
    text << "v " << position.x() << ' ' << position.y() << ' ' << position.z() << '\n';
  }
  for (const Triangle& triangle : mesh.triangles) {
    text << "f " << triangle[0] + 1 << ' ' << triangle[1] + 1 << ' ' << triangle[2] + 1 << '\n';
  }
  return text.str();
}

std::vector<TestShape> testShapes() {
  GarmentSizes sizes;
  std::vector<TestShape> shapes;
  shapes.push_back({"T-shirt", shirt(sizes)});
  GarmentSizes longSleeves = sizes;
  longSleeves.sleeve = 0.55;
  longSleeves.sleeveAngle = 0.0;
  shapes.push_back({"long sleeves, arms stretched out", shirt(longSleeves)});
  longSleeves.sleeveAngle = 50.0;
  shapes.push_back({"long sleeves, arms down", shirt(longSleeves)});
  GarmentSizes tank = sizes;
  tank.sleeve = -0.02;
  tank.sleeveAngle = 0.0;
  tank.neckDepth = 0.14;
  tank.neck = 0.11;
  shapes.push_back({"tank top", shirt(tank)});
  GarmentSizes dress = sizes;
  dress.height = 1.2;
  dress.flare = 1.6;
  shapes.push_back({"dress", shirt(dress)});
  dress.flare = 2.2;
  dress.depth = 0.9;
  dress.sleeve = -0.02;
  dress.sleeveAngle = 0.0;
  shapes.push_back({"wide dress without sleeves", shirt(dress)});
  GarmentSizes crop = sizes;
  crop.height = 0.4;
  shapes.push_back({"short shirt", shirt(crop)});
  GarmentSizes vest = sizes;
  vest.sleeve = 0.12;
  vest.sleeveAngle = 0.0;
  vest.frontGap = 0.04;
  shapes.push_back({"vest that is open at the front", shirt(vest)});
  vest.sleeve = 0.55;
  vest.sleeveAngle = 40.0;
  shapes.push_back({"cardigan that is open at the front", shirt(vest)});
  GarmentSizes waistcoat = tank;
  waistcoat.neckDepth = 0.3;
  waistcoat.frontGap = 0.02;
  shapes.push_back({"waistcoat that is open at the front", shirt(waistcoat)});
  shapes.push_back({"cape that is open at the front", openCape(40.0, 0.9)});
  shapes.push_back({"short cape that is open at the front", openCape(90.0, 0.5)});
  shapes.push_back({"apron", apron()});
  shapes.push_back({"trousers", trousers(0.75)});
  shapes.push_back({"shorts", trousers(0.2)});
  shapes.push_back({"skirt", tube(0.6, 0.3, 0.14, 0.8)});
  shapes.push_back({"wide skirt", tube(0.45, 0.55, 0.13, 1.0)});
  shapes.push_back({"pencil skirt", tube(0.55, 0.18, 0.15, 0.7)});
  shapes.push_back({"strapless top", tube(0.3, 0.17, 0.19, 0.6)});
  shapes.push_back({"sock", sock()});
  shapes.push_back({"figure, arms stretched out", figure(0.0)});
  shapes.push_back({"figure, arms down", figure(65.0)});
  return shapes;
}

}  // namespace drape::scene::testing
