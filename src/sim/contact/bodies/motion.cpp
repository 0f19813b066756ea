#include "sim/contact/bodies/motion.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

Eigen::Quaterniond turnBy(const Vec3& axisTimesAngle) {
  const double angle = axisTimesAngle.norm();
  if (angle == 0.0) {
    return Eigen::Quaterniond::Identity();
  }
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axisTimesAngle / angle));
}

/// The slope of one component at a keyframe between two intervals. It is the slope of the chord between the neighbours,
/// limited so that the cubic curve stays within the range of the two values at the ends of either interval: zero where
/// the direction reverses or the value is constant on one side, and at most three times the smaller of the two slopes
/// (Fritsch and Carlson 1980; the bound is that of de Boor and Swartz 1977).
/// @param before, after change of the value over the interval before and after the keyframe
/// @param timeBefore, timeAfter lengths of these intervals [s]
double monotoneSlope(double before, double timeBefore, double after, double timeAfter) {
  constexpr double steepest = 3.0;
  if (!(before * after > 0.0)) {
    return 0.0;
  }
  const double chord = (before + after) / (timeBefore + timeAfter);
  const double bound = steepest * std::min(std::abs(before / timeBefore), std::abs(after / timeAfter));
  return std::clamp(chord, -bound, bound);
}

/// The derivative at keyframe k [1/s]. It is zero at the ends of a motion that does not loop.
template <typename Member>
Vec3 tangent(const BodyMotion& motion, std::size_t k, Member member) {
  const std::vector<Keyframe>& keys = motion.keyframes;
  const std::size_t last = keys.size() - 1;
  const bool atEnd = k == 0 || k == last;
  if (atEnd && !motion.loop) {
    return Vec3::Zero();
  }
  const std::size_t before = atEnd ? last : k;  // the end of the interval before
  const std::size_t after = atEnd ? 0 : k;      // the start of the interval after
  const Vec3 changeBefore = keys[before].*member - keys[before - 1].*member;
  const Vec3 changeAfter = keys[after + 1].*member - keys[after].*member;
  const double timeBefore = keys[before].time - keys[before - 1].time;
  const double timeAfter = keys[after + 1].time - keys[after].time;
  Vec3 slope;
  for (int c = 0; c < 3; ++c) {
    slope[c] = monotoneSlope(changeBefore[c], timeBefore, changeAfter[c], timeAfter);
  }
  return slope;
}

/// Cubic Hermite curve over the interval after keyframe k; s from 0 to 1.
template <typename Member>
Vec3 along(const BodyMotion& motion, std::size_t k, double s, Member member) {
  const Keyframe& from = motion.keyframes[k];
  const Keyframe& to = motion.keyframes[k + 1];
  const double length = to.time - from.time;
  const double rest = 1.0 - s;
  const Vec3 change =
      to.*member - from.*member;  // added to the start, so that equal keyframes give exactly their value
  return from.*member + s * s * (3.0 - 2.0 * s) * change +
         length * s * rest * (rest * tangent(motion, k, member) - s * tangent(motion, k + 1, member));
}

double wrapped(const BodyMotion& motion, double time) {
  const double first = motion.keyframes.front().time;
  const double last = motion.keyframes.back().time;
  if (!motion.loop || last <= first) {
    return std::clamp(time, first, last);
  }
  const double period = last - first;
  const double into = std::fmod(time - first, period);
  return first + (into < 0.0 ? into + period : into);
}

}  // namespace

Pose poseOf(const Vec3& position, const Vec3& rotation) {
  return {turnBy(rotation).normalized(), position};
}

Keyframe keyframeAt(const BodyMotion& motion, double time) {
  const std::vector<Keyframe>& keys = motion.keyframes;
  if (keys.empty()) {
    return {};
  }
  const double at = wrapped(motion, time);
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), at, [](double t, const Keyframe& key) { return t < key.time; });
  if (next == keys.begin()) {
    return keys.front();
  }
  if (next == keys.end()) {
    return keys.back();
  }
  const auto k = static_cast<std::size_t>(next - keys.begin()) - 1;
  const double s = (at - keys[k].time) / (keys[k + 1].time - keys[k].time);
  return {at, along(motion, k, s, &Keyframe::position), along(motion, k, s, &Keyframe::rotation)};
}

Pose poseAt(const BodyMotion& motion, double time) {
  const Keyframe key = keyframeAt(motion, time);
  const Pose own{(turnBy(motion.spin * time) * turnBy(key.rotation)).normalized(), key.position};
  if (!motion.placement) {
    return own;
  }
  return {(motion.placement->rotation * own.rotation).normalized(), motion.placement->toWorld(own.position)};
}

}  // namespace drape::sim::contact
