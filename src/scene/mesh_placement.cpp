#include "scene/mesh_placement.hpp"

namespace drape::scene {
namespace {

/// Undoes turnedUpright.
Vec3 turnedBack(const Vec3& p, const std::string& up) {
  if (up == "z") {
    return {p.x(), -p.z(), p.y()};
  }
  if (up == "x") {
    return {p.y(), -p.x(), p.z()};
  }
  if (up == "-y") {
    return {p.x(), -p.y(), -p.z()};
  }
  if (up == "-z") {
    return {p.x(), p.z(), -p.y()};
  }
  return p;
}

}  // namespace

Vec3 turnedUpright(const Vec3& p, const std::string& up) {
  if (up == "z") {
    return {p.x(), p.z(), -p.y()};
  }
  if (up == "x") {
    return {-p.y(), p.x(), p.z()};
  }
  if (up == "-y") {
    return {p.x(), -p.y(), -p.z()};
  }
  if (up == "-z") {
    return {p.x(), -p.z(), p.y()};
  }
  return p;
}

Vec3 MeshPlacement::toFile(const Vec3& inScene) const {
  return turnedBack(pose.toLocal(inScene), up) / (scale * metresPerUnit);
}

Vec3 MeshPlacement::toScene(const Vec3& inFile) const {
  return pose.toWorld(turnedUpright((scale * metresPerUnit) * inFile, up));
}

Vec3 MeshPlacement::directionInFile(const Vec3& inScene) const {
  return turnedBack(pose.rotation.conjugate() * inScene, up);
}

}  // namespace drape::scene
