#pragma once

#include "sim/contact/body.hpp"
#include "sim/contact/closest_points.hpp"
#include "sim/contact/cloth_features.hpp"
#include "sim/contact/mesh_tree.hpp"
#include "sim/contact/touch.hpp"

#include <optional>
#include <span>
#include <vector>

namespace drape {

/// How near the cloth may come.
struct ContactReach {
  double keep = 0.0;   ///< distance at which vertices of the cloth are stopped [m]
  double inner = 0.0;  ///< the same of its edges and faces: nearer, so that on what is smooth vertices suffice [m]
  double guard = 0.0;  ///< distance that it never falls below [m]
  double push = 0.0;   ///< how much of an overlap is undone in a step [m]
};

/// The cloth as a body sees it: in the body's own frame, in which a rigid body stands still.
struct ClothInBody {
  std::span<const Vec3> base;    ///< where nothing meets the body [m]: where the body carries the start of the step
  std::span<const Vec3> target;  ///< where the cloth is about to go [m]
  std::span<const double> room;  ///< no vertex ends farther than this from its base [m]
  std::span<const Triangle> triangles;
  std::span<const OwnedFeatures> owned;
};

/// A mesh with what is worked out of it once.
struct SearchableMesh {
  explicit SearchableMesh(MeshShape mesh);

  MeshShape shape;
  MeshTree tree;
  std::vector<OwnedFeatures> owned;
  std::vector<std::array<bool, 3>> sharp;  ///< for each triangle which of its sides stick out
};

/// Looks for what is near one body in one step: for every triangle a plane between it and the body, and where vertices,
/// edges and triangles are about to come nearer than they may.
class BodySearch {
 public:
  /// @param index of the body among the step's  @param mesh of a box or a mesh, else nullptr
  BodySearch(const BodyStep& step, int index, const SearchableMesh* mesh, const ContactReach& reach);

  /// Looks at the triangles from begin to end - 1 and adds to `findings`.
  void search(const ClothInBody& cloth, std::size_t begin, std::size_t end, Findings& findings) const;

 private:
  struct Near;
  void searchPlane(const ClothInBody& cloth, std::size_t t, Findings& findings) const;
  void searchRound(const ClothInBody& cloth, std::size_t t, Findings& findings) const;
  void searchMesh(const ClothInBody& cloth, std::size_t t, Findings& findings) const;
  void meetTriangle(const ClothInBody& cloth, std::size_t t, int bodyTriangle, std::array<Near, 3>& vertices,
                    Findings& findings) const;
  void pushOut(const ClothInBody& cloth, std::size_t t, int bodyTriangle, Findings& findings) const;
  void roundTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Vec3& onCore, double keep,
                  Findings& findings) const;
  static Near nearOf(const Corners& base, const Corners& start, const Corners& end, const Vec3& weights,
                     const Vec3& bodyWeights);
  void touchSharp(const ClothInBody& cloth, std::size_t t, int bodyTriangle, Findings& findings) const;

  void addTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Near& near, double keep,
                Findings& findings) const;
  void addBarriers(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                   Findings& findings) const;
  [[nodiscard]] Vec3 moveOf(const Vec3& startPoint, const Vec3& endPoint) const;

  const BodyStep& step_;
  int index_;
  const SearchableMesh* mesh_;
  ContactReach reach_;
  std::span<const Vec3> startVertices_;
  std::span<const Vec3> endVertices_;
  std::array<Vec3, 2> core_{Vec3::Zero(), Vec3::Zero()};  // of a sphere or a capsule
  double radius_ = 0.0;
  bool plane_ = false;
};

}  // namespace drape
