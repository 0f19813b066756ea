#pragma once

#include "dressing/body_parts.hpp"
#include "dressing/garment_openings.hpp"
#include "intersection/intersections.hpp"

#include <map>
#include <span>
#include <vector>

namespace drape::dressing {

/// What is wrong with a garment on a body.
enum class FaultKind {
  PassesWall,    ///< a part of the body passes through the triangles of the garment
  InsideBody,    ///< the garment is inside the body
  MissesOpening  ///< a part of the body does not pass through the opening that is for it
};

/// A part of a body and what is wrong with the garment there.
struct Fault {
  FaultKind kind = FaultKind::PassesWall;
  BodyPart part = BodyPart::Whole;
  bool atSleeve = false;  ///< of an arm only: some of the triangles are nearest to the opening of a sleeve
  std::size_t pairs = 0;  ///< of triangles that intersect; 0 for an opening
  OpeningKind opening = OpeningKind::Hem;  ///< that is missed
};

/// Tests how a garment lies on a body, with the exact intersection test.
class Wearing {
 public:
  /// The arguments must outlive it.
  Wearing(const ShrinkingBody& body, const BodyParts& parts, const GarmentOpenings& openings,
          std::span<const Triangle> garment);

  /// The number of pairs of triangles of garment and body that intersect. @param positions of the garment [m]
  [[nodiscard]] std::size_t pairs(std::span<const Vec3> positions, std::size_t frame) const {
    return pairs(positions, body_.frames()[frame]);
  }
  /// The same for any shape of the body [m].
  [[nodiscard]] std::size_t pairs(std::span<const Vec3> positions, const std::vector<Vec3>& body) const;

  /// The openings for neck, waist, arms and legs through which nothing of the right part of the body passes.
  [[nodiscard]] std::vector<const Opening*> missed(std::span<const Vec3> positions,
                                                   const std::vector<Vec3>& body) const;

  /// Where parts of the body pass through the triangles of the garment, one entry a part. An arm that meets a sleeve
  /// and the rest of the garment is at the sleeve. @param positions of the garment [m]  @param pairs that intersect
  /// there
  [[nodiscard]] std::vector<Fault> wallFaults(std::span<const Vec3> positions,
                                              std::span<const intersection::TrianglePair> pairs) const;

  /// Everything that is wrong, by part of the body. A sleeve or a trouser leg that is longer than its limb is right.
  /// @param limbs the body with arms and legs of their full length: what
  /// passes through the openings [m]
  [[nodiscard]] std::vector<Fault> faults(std::span<const Vec3> positions, std::size_t frame,
                                          const std::vector<Vec3>& limbs) const;

 private:
  [[nodiscard]] std::vector<intersection::TrianglePair> intersecting(std::span<const Vec3> positions,
                                                                     const std::vector<Vec3>& body) const;
  [[nodiscard]] bool passes(const Opening& opening, std::span<const Vec3> positions,
                            const std::vector<Vec3>& body) const;
  [[nodiscard]] BodyPart partFor(OpeningKind kind) const;
  [[nodiscard]] bool endsBefore(const Opening& opening, std::span<const Vec3> positions,
                                const std::vector<Vec3>& limbs) const;
  [[nodiscard]] bool isAtSleeve(int triangle, std::span<const Vec3> positions) const;

  const ShrinkingBody& body_;
  const BodyParts& parts_;
  const GarmentOpenings& openings_;
  std::span<const Triangle> garment_;
  std::map<BodyPart, std::vector<Triangle>> trianglesOf_;
  std::map<BodyPart, std::vector<Triangle>> shoulders_;  // by arm: the trunk beside it
};

}  // namespace drape::dressing
