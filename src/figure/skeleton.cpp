#include "figure/skeleton.hpp"

namespace drape::figure {
namespace {

constexpr std::size_t jointsOfArm = 4;
constexpr std::size_t jointsOfLeg = 4;

Vec3 mirrored(const Vec3& point) {
  return {-point.x(), point.y(), point.z()};
}

/// Copies the joints of a limb on the left to the right.
void mirrorLimb(PerJoint<JointInfo>& joints, Joint first, std::size_t count,
                const std::array<std::string_view, 4>& names) {
  for (std::size_t k = 0; k < count; ++k) {
    const JointInfo& left = joints[indexOf(first) + k];
    const Joint parent = k == 0 ? left.parent : onSide(left.parent, Side::Right);
    joints[indexOf(first) + count + k] = {names[k], parent, mirrored(left.rest), mirrored(left.end), left.radius};
  }
}

PerJoint<JointInfo> makeSkeleton() {
  PerJoint<JointInfo> joints;
  const auto set = [&](Joint joint, const JointInfo& info) { joints[indexOf(joint)] = info; };
  set(Joint::Hips, {"hips", Joint::Hips, {0.0, 0.930, -0.004}, {0.0, 0.880, -0.004}, 0.110});
  set(Joint::Spine, {"spine", Joint::Hips, {0.0, 1.030, -0.002}, {0.0, 1.120, 0.0}, 0.090});
  set(Joint::Chest, {"chest", Joint::Spine, {0.0, 1.150, 0.0}, {0.0, 1.330, 0.0}, 0.110});
  set(Joint::Neck, {"neck", Joint::Chest, {0.0, 1.410, -0.004}, {0.0, 1.510, 0.004}, 0.045});
  set(Joint::Head, {"head", Joint::Neck, {0.0, 1.530, 0.006}, {0.0, 1.680, 0.014}, 0.080});
  set(Joint::LeftShoulder, {"left shoulder", Joint::Chest, {0.030, 1.384, 0.0}, {0.160, 1.374, 0.0}, 0.040});
  set(Joint::LeftUpperArm, {"left upper arm", Joint::LeftShoulder, {0.185, 1.364, 0.0}, {0.420, 1.237, 0.0}, 0.038});
  set(Joint::LeftForearm, {"left forearm", Joint::LeftUpperArm, {0.420, 1.237, 0.0}, {0.600, 1.105, 0.030}, 0.030});
  set(Joint::LeftHand, {"left hand", Joint::LeftForearm, {0.600, 1.105, 0.030}, {0.672, 1.040, 0.040}, 0.025});
  set(Joint::LeftThigh, {"left thigh", Joint::Hips, {0.084, 0.880, 0.0}, {0.088, 0.475, 0.012}, 0.080});
  set(Joint::LeftShin, {"left shin", Joint::LeftThigh, {0.088, 0.475, 0.012}, {0.092, 0.080, -0.020}, 0.050});
  set(Joint::LeftFoot, {"left foot", Joint::LeftShin, {0.092, 0.080, -0.020}, {0.096, 0.034, 0.090}, 0.038});
  set(Joint::LeftToes, {"left toes", Joint::LeftFoot, {0.096, 0.034, 0.090}, {0.099, 0.026, 0.150}, 0.028});
  mirrorLimb(joints, Joint::LeftShoulder, jointsOfArm,
             {"right shoulder", "right upper arm", "right forearm", "right hand"});
  mirrorLimb(joints, Joint::LeftThigh, jointsOfLeg, {"right thigh", "right shin", "right foot", "right toes"});
  return joints;
}

}  // namespace

Joint onSide(Joint left, Side side) {
  if (side == Side::Left) {
    return left;
  }
  const std::size_t index = indexOf(left);
  return static_cast<Joint>(index + (index < indexOf(Joint::LeftThigh) ? jointsOfArm : jointsOfLeg));
}

const PerJoint<JointInfo>& skeleton() {
  static const PerJoint<JointInfo> joints = makeSkeleton();
  return joints;
}

PerJoint<Vec3> restPlaces() {
  PerJoint<Vec3> places;
  for (std::size_t j = 0; j < jointCount; ++j) {
    places[j] = skeleton()[j].rest;
  }
  return places;
}

}  // namespace drape::figure
