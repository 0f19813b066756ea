#include "ui/gizmo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drape::ui {
namespace {

// Lengths on the screen at scale 1 [window units].
constexpr double armLength = 96.0;  // of an arrow, and the radius of a ring
constexpr double armStart = 16.0;   // of an arrow, from the middle
constexpr double squareStart = 26.0;
constexpr double squareEnd = 48.0;
constexpr double middleRadius = 10.0;
constexpr double knobHalf = 7.0;  // of the handle that scales
constexpr double reach = 8.0;     // from a line at which a press takes it

// Sines below which a handle is hidden.
constexpr double minArrow = 0.2;  // between an arrow and the direction of the view
constexpr double minPlane = 0.2;  // between a square and the direction of the view; a ring below it rolls

constexpr int ringPoints = 72;

constexpr double moveStep = 0.01;                     // [m]
constexpr double turnStep = std::numbers::pi / 36.0;  // [rad]
constexpr double scaleStep = 0.1;                     // [-]

constexpr std::array moveHandles{GizmoHandle::MoveView, GizmoHandle::MoveYZ, GizmoHandle::MoveZX, GizmoHandle::MoveXY,
                                 GizmoHandle::MoveX,    GizmoHandle::MoveY,  GizmoHandle::MoveZ};
constexpr std::array turnHandles{GizmoHandle::TurnX, GizmoHandle::TurnY, GizmoHandle::TurnZ};
constexpr std::array scaleHandles{GizmoHandle::Size};

enum class HandleShape { Arrow, Square, Ring, Middle, Knob };

HandleShape shapeOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::MoveX:
    case GizmoHandle::MoveY:
    case GizmoHandle::MoveZ:
      return HandleShape::Arrow;
    case GizmoHandle::MoveYZ:
    case GizmoHandle::MoveZX:
    case GizmoHandle::MoveXY:
      return HandleShape::Square;
    case GizmoHandle::TurnX:
    case GizmoHandle::TurnY:
    case GizmoHandle::TurnZ:
      return HandleShape::Ring;
    case GizmoHandle::Size:
      return HandleShape::Knob;
    default:
      return HandleShape::Middle;
  }
}

/// The two axes at a right angle to one of the axes of the scene.
std::pair<Vec3, Vec3> axesAcross(const Vec3& axis) {
  return {Vec3(axis.z(), axis.x(), axis.y()), Vec3(axis.y(), axis.z(), axis.x())};
}

double distanceToSegment(const Vec2& place, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((place - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (place - from - share * along).norm();
}

bool isInside(const Vec2& place, std::span<const Vec2> polygon) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
        place.x() < (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

double inSteps(double value, double step) {
  return std::round(value / step) * step;
}

std::optional<Vec3> onPlane(const render::Ray& ray, const Vec3& point, const Vec3& normal) {
  constexpr double nearlyParallel = 1e-6;
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < nearlyParallel) {
    return std::nullopt;
  }
  const double distance = (point - ray.origin).dot(normal) / slope;
  return distance > 0.0 ? std::optional<Vec3>(ray.origin + distance * ray.direction) : std::nullopt;
}

/// The point of an axis that is nearest to a ray.
std::optional<Vec3> onAxis(const render::Ray& ray, const Vec3& point, const Vec3& axis) {
  constexpr double nearlyParallel = 1e-6;
  const double cosine = ray.direction.dot(axis);
  const double sineSquared = 1.0 - cosine * cosine;
  if (sineSquared < nearlyParallel) {
    return std::nullopt;
  }
  const Vec3 offset = ray.origin - point;
  const double along = (offset.dot(axis) - cosine * offset.dot(ray.direction)) / sineSquared;
  const Vec3 nearest = point + along * axis;
  return (nearest - ray.origin).dot(ray.direction) > 0.0 ? std::optional<Vec3>(nearest) : std::nullopt;
}

}  // namespace

Vec3 axisOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::MoveX:
    case GizmoHandle::MoveYZ:
    case GizmoHandle::TurnX:
      return Vec3::UnitX();
    case GizmoHandle::MoveY:
    case GizmoHandle::MoveZX:
    case GizmoHandle::TurnY:
      return Vec3::UnitY();
    case GizmoHandle::MoveZ:
    case GizmoHandle::MoveXY:
    case GizmoHandle::TurnZ:
      return Vec3::UnitZ();
    default:
      return Vec3::Zero();
  }
}

Vec2 GizmoPicture::toWindow(const Vec3& point) const {
  return camera_.project(point, static_cast<int>(view_.width), static_cast<int>(view_.height)) + Vec2(view_.x, view_.y);
}

render::Ray GizmoPicture::rayThrough(const Vec2& place) const {
  return camera_.rayThrough(place.x() - view_.x, place.y() - view_.y, static_cast<int>(view_.width),
                            static_cast<int>(view_.height));
}

Vec3 GizmoPicture::directionTo(const Vec3& point) const {
  return camera_.isOrthographic() ? Vec3(-back()) : Vec3((point - camera_.pose().position).normalized());
}

Vec3 GizmoPicture::back() const {
  return (camera_.pose().position - camera_.pose().focalPoint).normalized();
}

double GizmoPicture::unitAt(const Vec3& point) const {
  const Vec2 at = toWindow(point) - Vec2(view_.x, view_.y);
  const auto width = static_cast<int>(view_.width);
  const auto height = static_cast<int>(view_.height);
  constexpr double many = 100.0;
  return (camera_.pointAtDepthOf(point, at.x() + many, at.y(), width, height) -
          camera_.pointAtDepthOf(point, at.x(), at.y(), width, height))
             .norm() /
         many;
}

double Gizmo::lengthIn(const GizmoPicture& picture) const {
  return scale_ * picture.unitAt(middle_);
}

double Gizmo::radius(const GizmoPicture& picture) const {
  return armLength * lengthIn(picture);
}

std::vector<GizmoHandle> Gizmo::handles(const GizmoPicture& picture) const {
  const Vec3 direction = picture.directionTo(middle_);
  if (direction.dot(picture.back()) >= 0.0) {
    return {};  // behind the eye
  }
  const std::span<const GizmoHandle> all = tool_ == PlacingTool::Move   ? std::span<const GizmoHandle>(moveHandles)
                                           : tool_ == PlacingTool::Turn ? std::span<const GizmoHandle>(turnHandles)
                                                                        : std::span<const GizmoHandle>(scaleHandles);
  std::vector<GizmoHandle> shown;
  for (const GizmoHandle handle : all) {
    const double cosine = std::abs(axisOf(handle).dot(direction));
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const HandleShape shape = shapeOf(handle);
    const bool isHidden =
        (shape == HandleShape::Arrow && sine < minArrow) || (shape == HandleShape::Square && cosine < minPlane);
    if (!isHidden) {
      shown.push_back(handle);
    }
  }
  return shown;
}

std::vector<Vec2> Gizmo::outlineOf(GizmoHandle handle, const GizmoPicture& picture) const {
  const double unit = lengthIn(picture);
  const Vec3 axis = axisOf(handle);
  const auto [u, v] = axesAcross(axis);
  const auto at = [&](const Vec3& offset) { return picture.toWindow(middle_ + unit * offset); };
  const Vec2 centre = picture.toWindow(middle_);
  switch (shapeOf(handle)) {
    case HandleShape::Arrow:
      return {at(armStart * axis), at(armLength * axis)};
    case HandleShape::Square:
      return {at(squareStart * (u + v)), at(squareEnd * u + squareStart * v), at(squareEnd * (u + v)),
              at(squareStart * u + squareEnd * v)};
    case HandleShape::Ring: {
      std::vector<Vec2> ring;
      for (int i = 0; i < ringPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / ringPoints;
        ring.push_back(at(armLength * (std::cos(angle) * u + std::sin(angle) * v)));
      }
      return ring;
    }
    case HandleShape::Middle: {
      std::vector<Vec2> circle;
      constexpr int points = 24;
      for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        circle.emplace_back(centre + scale_ * middleRadius * Vec2(std::cos(angle), std::sin(angle)));
      }
      return circle;
    }
    case HandleShape::Knob:
      return {centre, centre + scale_ * armLength * Vec2(std::numbers::sqrt2, -std::numbers::sqrt2) / 2.0};
  }
  return {};
}

Vec2 Gizmo::gripOf(GizmoHandle handle, const GizmoPicture& picture) const {
  const std::vector<Vec2> outline = outlineOf(handle, picture);
  switch (shapeOf(handle)) {
    case HandleShape::Arrow:
      return 0.15 * outline.front() + 0.85 * outline.back();
    case HandleShape::Square:
      return 0.5 * (outline[0] + outline[2]);
    case HandleShape::Knob:
      return outline.back();
    case HandleShape::Middle:
      return picture.toWindow(middle_);
    case HandleShape::Ring:
      break;
  }
  // Rings cross each other; a press takes this one where it is nearest.
  for (const Vec2& point : outline) {
    if (handleAt(point, picture) == handle) {
      return point;
    }
  }
  return outline.front();
}

double Gizmo::distanceTo(GizmoHandle handle, const Vec2& place, const GizmoPicture& picture) const {
  const std::vector<Vec2> outline = outlineOf(handle, picture);
  const HandleShape shape = shapeOf(handle);
  if (shape == HandleShape::Arrow) {
    return distanceToSegment(place, outline.front(), outline.back());
  }
  if (shape == HandleShape::Knob) {
    return std::max(0.0, (place - outline.back()).lpNorm<Eigen::Infinity>() - scale_ * knobHalf);
  }
  if (shape != HandleShape::Ring && isInside(place, outline)) {
    return 0.0;
  }
  double distance = HUGE_VAL;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    distance = std::min(distance, distanceToSegment(place, outline[i], outline[(i + 1) % outline.size()]));
  }
  return shape == HandleShape::Ring ? distance : distance + 0.5 * scale_ * reach;
}

GizmoHandle Gizmo::handleAt(const Vec2& place, const GizmoPicture& picture) const {
  GizmoHandle nearest = GizmoHandle::None;
  double smallest = scale_ * reach;
  for (const GizmoHandle handle : handles(picture)) {
    const double distance = distanceTo(handle, place, picture);
    if (distance < smallest) {
      smallest = distance;
      nearest = handle;
    }
  }
  return nearest;
}

GizmoDrag::GizmoDrag(const Gizmo& gizmo, GizmoHandle handle, const Vec2& at, const GizmoPicture& picture)
    : handle_(handle), middle_(gizmo.middle()), normal_(axisOf(handle)), axis_(normal_) {
  const bool isEdge = std::abs(normal_.dot(picture.directionTo(middle_))) < minPlane;
  if (shapeOf(handle) == HandleShape::Ring && isEdge) {
    rollRadius_ = gizmo.radius(picture);
    normal_ = picture.back();
  } else if (normal_.isZero()) {
    normal_ = picture.back();
  }
  taken_ = pointUnder(at, picture);
}

/// The point of the axis or of the plane under the mouse.
std::optional<Vec3> GizmoDrag::pointUnder(const Vec2& at, const GizmoPicture& picture) const {
  const render::Ray ray = picture.rayThrough(at);
  return shapeOf(handle_) == HandleShape::Arrow ? onAxis(ray, middle_, normal_) : onPlane(ray, middle_, normal_);
}

/// Takes the angle that is nearest to the present one, so that a drag can turn by more than half a turn.
void GizmoDrag::turnTo(const Vec3& point) {
  if (rollRadius_ > 0.0) {
    // The nearest point of the ring moves across the view by this vector for each radian and each metre of its radius.
    const Vec3 across = axis_.cross(normal_).normalized();
    turned_ = (point - *taken_).dot(across) / rollRadius_;
    return;
  }
  const Vec3 from = *taken_ - middle_;
  const Vec3 to = point - middle_;
  const double angle = std::atan2(from.cross(to).dot(normal_), from.dot(to));
  constexpr double whole = 2.0 * std::numbers::pi;
  turned_ = angle + whole * std::round((turned_ - angle) / whole);
}

GizmoChange GizmoDrag::to(const Vec2& at, const GizmoPicture& picture, bool snaps) {
  const std::optional<Vec3> point = pointUnder(at, picture);
  const HandleShape shape = shapeOf(handle_);
  if (point && taken_) {
    if (shape == HandleShape::Ring) {
      turnTo(*point);
    } else if (shape == HandleShape::Knob) {
      factor_ = (*point - middle_).norm() / (*taken_ - middle_).norm();
    } else {
      moved_ = *point - *taken_;
    }
  }
  GizmoChange change{moved_, axis_, turned_, factor_};
  if (snaps) {
    for (double& part : change.move) {
      part = inSteps(part, moveStep);
    }
    change.angle = inSteps(change.angle, turnStep);
    change.factor = std::max(scaleStep, inSteps(change.factor, scaleStep));
  }
  return change;
}

}  // namespace drape::ui
