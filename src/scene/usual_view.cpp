#include "scene/usual_view.hpp"

#include "scene/framing.hpp"
#include "scene/ground.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace drape::scene {
namespace {

constexpr double usualAspect = 16.0 / 9.0;
constexpr double boxScale = 1.15;    // margin, since cloth swings beyond its start box
constexpr double largestBody = 4.0;  // diagonal of a body that is shown, in those of the cloth
constexpr double longestFall = 4.0;  // that is shown, in diagonals of the cloth

Eigen::AlignedBox3d boundsAtStart(const sim::contact::Body& body) {
  const sim::contact::Pose pose = sim::contact::poseAt(body.motion, 0.0);
  Eigen::AlignedBox3d box;
  for (const Vec3& position : sim::contact::surfaceOf(body.shape).positions) {
    box.extend(pose.toWorld(position));
  }
  return box;
}

/// The lowest height that the cloth reaches [m]; infinite if it falls for ever.
double lowestHeight(const ViewedThings& things) {
  const double hanging = lowestHang(things.start, things.pins);
  return things.description.ground ? std::max(hanging, things.groundHeight) : hanging;
}

}  // namespace

CameraPose usualView(const ViewedThings& things) {
  if (things.description.camera) {
    return *things.description.camera;
  }
  Eigen::AlignedBox3d box = sim::boundsOf(things.start);
  const double diagonal = box.diagonal().norm();
  if (const double lowest = lowestHeight(things); std::isfinite(lowest)) {
    const double shown = std::max(lowest, box.min().y() - longestFall * diagonal);
    box.min().y() = std::min(box.min().y(), shown);
  }
  for (const sim::contact::Body& body : things.bodies) {
    if (!body.drawn) {
      continue;
    }
    const Eigen::AlignedBox3d ofBody = boundsAtStart(body);
    if (things.description.parts.dressed || ofBody.diagonal().norm() <= largestBody * diagonal) {
      box.extend(ofBody);
    }
  }
  const Vec3 half = 0.5 * boxScale * box.sizes();
  return framed({Vec3(0.35, 0.2, 1.0), Vec3::Zero(), CameraPose{}.viewAngle}, box.center() - half, box.center() + half,
                usualAspect);
}

}  // namespace drape::scene
