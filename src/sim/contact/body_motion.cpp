#include "sim/contact/body_motion.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

Eigen::Quaterniond turnBy(const Vec3& axisTimesAngle) {
  const double angle = axisTimesAngle.norm();
  if (angle == 0.0) {
    return Eigen::Quaterniond::Identity();
  }
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axisTimesAngle / angle));
}

/// The velocity at keyframe k [1/s]: along the chord between its neighbours.
template <typename Member>
Vec3 tangent(const BodyMotion& motion, std::size_t k, Member member) {
  const std::vector<Keyframe>& keys = motion.keyframes;
  const std::size_t last = keys.size() - 1;
  if (k > 0 && k < last) {
    return (keys[k + 1].*member - keys[k - 1].*member) / (keys[k + 1].time - keys[k - 1].time);
  }
  if (!motion.loop) {
    return Vec3::Zero();
  }
  const double around = keys[1].time - keys[0].time + keys[last].time - keys[last - 1].time;
  return (keys[1].*member - keys[0].*member + keys[last].*member - keys[last - 1].*member) / around;
}

/// Cubic Hermite curve over the interval after keyframe k; s from 0 to 1.
template <typename Member>
Vec3 along(const BodyMotion& motion, std::size_t k, double s, Member member) {
  const Keyframe& from = motion.keyframes[k];
  const Keyframe& to = motion.keyframes[k + 1];
  const double length = to.time - from.time;
  const double rest = 1.0 - s;
  return rest * rest * (1.0 + 2.0 * s) * (from.*member) + s * s * (3.0 - 2.0 * s) * (to.*member) +
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

/// The keyframes alone, without the spin.
Keyframe keyAt(const BodyMotion& motion, double time) {
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

}  // namespace

Pose poseOf(const Vec3& position, const Vec3& rotation) {
  return {turnBy(rotation).normalized(), position};
}

Pose poseAt(const BodyMotion& motion, double time) {
  const Keyframe key = keyAt(motion, time);
  return {(turnBy(motion.spin * time) * turnBy(key.rotation)).normalized(), key.position};
}

}  // namespace drape
