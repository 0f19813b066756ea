#pragma once

#include "figure/skeleton.hpp"
#include "sim/contact/bodies/pose.hpp"

#include <array>
#include <span>
#include <vector>

namespace drape::figure {

/// How much each of up to four joints moves a vertex. The weights are above or equal to 0, descend, and add up to 1.
struct SkinWeights {
  static constexpr std::size_t maxJoints = 4;
  std::array<int, maxJoints> joints = {};
  std::array<double, maxJoints> weights = {};

  [[nodiscard]] double of(Joint joint) const;
};

/// Smooth weights: each vertex starts with the joint of the nearest bone, relative to the radius of the body there.
/// The weights then diffuse along the surface, so that the arm does not move the trunk beside it.
/// @param positions in the rest pose [m], one a vertex of the mesh
[[nodiscard]] std::vector<SkinWeights> smoothWeights(std::span<const Vec3> positions,
                                                     std::span<const Triangle> triangles);

/// Moves the vertices with the joints by dual quaternions (Kavan, Collins, Zara and O'Sullivan 2007, Skinning with dual
/// quaternions), which keep the volume of a limb that bends.
/// @param places of the joints in the rest pose [m]  @param poses of the joints
/// @param rest positions of the vertices in the rest pose [m]  @param positions result [m], as many
void moveSkin(const PerJoint<Vec3>& places, const PerJoint<sim::contact::Pose>& poses,
              std::span<const SkinWeights> weights, std::span<const Vec3> rest, std::span<Vec3> positions);

}  // namespace drape::figure
