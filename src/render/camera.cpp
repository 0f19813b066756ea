#include "render/camera.hpp"

#include "scene/framing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::render {
namespace {

constexpr double maxElevation = 89.5 * std::numbers::pi / 180.0;  // [rad]

Vec3 directionFrom(double azimuth, double elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

/// How far an orthographic camera sees, before and behind its position [m].
double depthOf(const scene::CameraPose& pose) {
  constexpr double manyDistances = 30.0;
  constexpr double nearby = 20.0;  // [m]
  return std::max(nearby, manyDistances * scene::viewOffset(pose).norm());
}

Eigen::Matrix4f orthographicMatrix(double halfHeight, double aspect, double depth) {
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
  projection(0, 0) = 1.0 / (halfHeight * aspect);
  projection(1, 1) = 1.0 / halfHeight;
  projection(2, 2) = -1.0 / depth;
  return projection.cast<float>();
}

}  // namespace

CameraBounds boundsFor(const Eigen::AlignedBox3d& box, double groundHeight, const scene::CameraPose& pose) {
  constexpr double clearance = 0.02;     // above the ground, in sizes of the box
  constexpr double sideways = 1.0;       // from the box to the focal point, in sizes of the box
  constexpr double away = 8.0;           // from the focal point, in sizes of the box
  constexpr double smallestSize = 0.02;  // [m]
  const double size = std::max(box.diagonal().norm(), smallestSize);
  CameraBounds bounds;
  bounds.lowest = std::min(groundHeight + clearance * size, pose.position.y());
  const Vec3 margin = Vec3::Constant(sideways * size);
  bounds.focalPoints = Eigen::AlignedBox3d(box.min() - margin, box.max() + margin);
  bounds.focalPoints.min().y() = std::min(std::max(bounds.focalPoints.min().y(), bounds.lowest), box.max().y());
  bounds.focalPoints.extend(pose.focalPoint);
  bounds.maxDistance = std::max(away * size, scene::viewOffset(pose).norm());
  return bounds;
}

void Camera::keepWithin(const CameraBounds& bounds) {
  const Vec3 focalPoint = pose_.focalPoint.cwiseMax(bounds.focalPoints.min()).cwiseMin(bounds.focalPoints.max());
  pose_.position += focalPoint - pose_.focalPoint;
  pose_.focalPoint = focalPoint;
  const Vec3 offset = scene::viewOffset(pose_);
  const double distance = std::min(offset.norm(), bounds.maxDistance);
  if (distance < offset.norm()) {
    pose_.position = pose_.focalPoint + distance * offset.normalized();
  }
  if (pose_.position.y() < bounds.lowest) {
    const double rise = std::clamp((bounds.lowest - focalPoint.y()) / distance, -1.0, 1.0);
    const double elevation = std::clamp(std::asin(rise), -maxElevation, maxElevation);
    pose_.position = pose_.focalPoint + distance * directionFrom(std::atan2(offset.x(), offset.z()), elevation);
  }
}

void Camera::orbit(double yaw, double pitch) {
  const Vec3 offset = scene::viewOffset(pose_);
  const double distance = offset.norm();
  const double horizontal = std::hypot(offset.x(), offset.z());
  const double azimuth = horizontal > 1e-9 ? std::atan2(offset.x(), offset.z()) : 0.0;
  const double elevation = std::atan2(offset.y(), horizontal);
  const double newElevation = std::clamp(elevation + pitch, -maxElevation, maxElevation);
  pose_.position = pose_.focalPoint + distance * directionFrom(azimuth + yaw, newElevation);
}

void Camera::pan(double right, double up) {
  const scene::CameraBasis basis = scene::basisOf(pose_);
  const double viewHeight = 2.0 * scene::viewOffset(pose_).norm() * scene::tanHalfAngle(pose_);
  const Vec3 shift = viewHeight * (right * basis.right + up * basis.up);
  pose_.position += shift;
  pose_.focalPoint += shift;
}

void Camera::zoom(double factor) {
  const Vec3 offset = scene::viewOffset(pose_);
  const double distance = std::clamp(offset.norm() * factor, scene::minViewDistance, scene::maxViewDistance);
  pose_.position = pose_.focalPoint + distance * offset.normalized();
}

void Camera::recentre(const Vec3& focalPoint) {
  pose_.position += focalPoint - pose_.focalPoint;
  pose_.focalPoint = focalPoint;
}

void Camera::lookFrom(Side side) {
  const double distance = scene::viewOffset(pose_).norm();
  const double azimuth = side == Side::Right ? std::numbers::pi / 2.0 : 0.0;
  const double elevation = side == Side::Top ? maxElevation : 0.0;
  pose_.position = pose_.focalPoint + distance * directionFrom(azimuth, elevation);
}

void Camera::frame(const Vec3& min, const Vec3& max, double aspect) {
  pose_ = scene::framed(pose_, min, max, aspect);
}

Eigen::Matrix4f Camera::viewMatrix() const {
  const scene::CameraBasis basis = scene::basisOf(pose_);
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.row(0) << basis.right.transpose(), -basis.right.dot(pose_.position);
  view.row(1) << basis.up.transpose(), -basis.up.dot(pose_.position);
  view.row(2) << basis.back.transpose(), -basis.back.dot(pose_.position);
  return view.cast<float>();
}

double Camera::halfHeight() const {
  return scene::viewOffset(pose_).norm() * scene::tanHalfAngle(pose_);
}

Eigen::Vector4f Camera::eye() const {
  const Vec3 at = pose_.isOrthographic ? scene::viewOffset(pose_) : pose_.position;
  return {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z()),
          pose_.isOrthographic ? 0.0F : 1.0F};
}

Eigen::Matrix4f Camera::projectionMatrix(double aspect) const {
  if (pose_.isOrthographic) {
    return orthographicMatrix(halfHeight(), aspect, depthOf(pose_));
  }
  // The clipping planes scale with the distance: near views are not cut, and far views keep their depth precision.
  const double near = std::clamp(0.02 * scene::viewOffset(pose_).norm(), 0.001, 0.1);
  const double far = 5000.0 * near;
  const double slope = scene::tanHalfAngle(pose_);
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 1.0 / (slope * aspect);
  projection(1, 1) = 1.0 / slope;
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2.0 * far * near / (far - near);
  projection(3, 2) = -1.0;
  return projection.cast<float>();
}

Ray Camera::rayThrough(double x, double y, int width, int height) const {
  const scene::CameraBasis basis = scene::basisOf(pose_);
  const double slope = scene::tanHalfAngle(pose_);
  const double aspect = static_cast<double>(width) / height;
  const double right = (2.0 * x / width - 1.0) * slope * aspect;
  const double up = (1.0 - 2.0 * y / height) * slope;
  if (pose_.isOrthographic) {
    const double distance = scene::viewOffset(pose_).norm();
    return {pose_.position + distance * (right * basis.right + up * basis.up) + depthOf(pose_) * basis.back,
            -basis.back};
  }
  return {pose_.position, (right * basis.right + up * basis.up - basis.back).normalized()};
}

Vec2 Camera::project(const Vec3& point, int width, int height) const {
  const scene::CameraBasis basis = scene::basisOf(pose_);
  const Vec3 offset = point - pose_.position;
  const double depth = std::max(-offset.dot(basis.back), 1e-9);
  const double scale = 0.5 * height / (pose_.isOrthographic ? halfHeight() : scene::tanHalfAngle(pose_) * depth);
  return {0.5 * width + scale * offset.dot(basis.right), 0.5 * height - scale * offset.dot(basis.up)};
}

Vec3 Camera::pointAtDepthOf(const Vec3& reference, double x, double y, int width, int height) const {
  const scene::CameraBasis basis = scene::basisOf(pose_);
  const Ray ray = rayThrough(x, y, width, height);
  const double depth = (ray.origin - reference).dot(basis.back);
  return ray.origin + ray.direction * (depth / -ray.direction.dot(basis.back));
}

}  // namespace drape::render
