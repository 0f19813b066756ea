#include "dressing/placement.hpp"

#include "dressing/arm_bend.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace drape::dressing {
namespace {

using sim::contact::Pose;

constexpr double quarterTurn = 0.5 * std::numbers::pi;

Pose turnedAbout(const Vec3& centre, double angle) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(angle, Vec3::UnitY());
  pose.position = centre - pose.rotation * centre;
  return pose;
}

/// The turn that brings the width of a garment along x and its front to that of the body.
Pose turnToFront(const sim::ClothMesh& garment, const BodyParts& parts) {
  constexpr double clearlyDeeper = 1.25;
  const Eigen::AlignedBox3d box = sim::boundsOf(garment.positions);
  double angle = box.sizes().z() > clearlyDeeper * box.sizes().x() ? quarterTurn : 0.0;
  const GarmentOpenings openings({moved(garment.positions, turnedAbout(box.center(), angle)), garment.triangles});
  if (openings.facesBack() != parts.facesBack()) {
    angle += 2.0 * quarterTurn;
  }
  return turnedAbout(box.center(), angle);
}

/// Where the trunk of the body belongs from left to right: at `middle`, or at the lowest hem of a garment whose middle
/// is beside it, as with one sleeve or one strap.
double middleOf(double middle, const GarmentOpenings& openings) {
  constexpr double beside = 0.03;  // [m]
  const Opening* lowest = nullptr;
  for (const Opening& opening : openings.all()) {
    if (opening.kind == OpeningKind::Hem && (lowest == nullptr || opening.centre.y() < lowest->centre.y())) {
      lowest = &opening;
    }
  }
  return lowest != nullptr && std::abs(lowest->centre.x() - middle) > beside ? lowest->centre.x() : middle;
}

/// Whether an opening is in the upper half, where a skirt has none: a sleeve, say, whose other one is open to the neck.
bool hasHighHem(const std::vector<Vec3>& garment, const GarmentOpenings& openings) {
  const double middle = sim::boundsOf(garment).center().y();
  return std::ranges::any_of(openings.all(), [&](const Opening& opening) {
    return opening.kind == OpeningKind::Hem && opening.centre.y() > middle;
  });
}

/// The shift of a garment whose landmarks are known; none if there are none.
std::optional<Vec3> shiftByLandmarks(const std::vector<Vec3>& garment, const GarmentOpenings& openings,
                                     const BodyParts& parts) {
  if (!parts.landmarks()) {
    return std::nullopt;
  }
  const Vec3& bodyNeck = parts.landmarks()->neck;
  if (openings.find(OpeningKind::Hood) != nullptr) {
    constexpr double aboveHead = 0.01;  // [m]
    const Eigen::AlignedBox3d box = sim::boundsOf(garment);
    const Opening* sleeve = openings.find(OpeningKind::LeftSleeve);
    const double middle = sleeve != nullptr ? sleeve->centre.z() : box.center().z();
    return Vec3(bodyNeck.x() - box.center().x(), parts.landmarks()->top + aboveHead - box.max().y(),
                bodyNeck.z() - middle);
  }
  if (const Opening* neck = openings.find(OpeningKind::Neck)) {
    return Vec3(bodyNeck.x() - middleOf(neck->centre.x(), openings), bodyNeck.y() - neck->centre.y(),
                bodyNeck.z() - neck->centre.z());
  }
  const Opening* left = openings.find(OpeningKind::LeftSleeve);
  const Opening* right = openings.find(OpeningKind::RightSleeve);
  if (left != nullptr && right != nullptr) {
    return bodyNeck - 0.5 * (left->centre + right->centre);
  }
  const Opening* waist = openings.find(OpeningKind::Waist);
  return waist != nullptr && !hasHighHem(garment, openings)
             ? std::optional<Vec3>(parts.landmarks()->waist - waist->centre)
             : std::nullopt;
}

Vec3 shiftByBoxes(const std::vector<Vec3>& garment, const GarmentOpenings& openings, const ShrinkingBody& body,
                  const BodyParts& parts) {
  constexpr double above = 0.02;  // [m]
  const Eigen::AlignedBox3d box = sim::boundsOf(garment);
  const Eigen::AlignedBox3d bodyBox = sim::boundsOf(body.frames().front());
  Vec3 target = bodyBox.center();
  target.y() = bodyBox.max().y();
  if (parts.landmarks()) {
    target = parts.landmarks()->neck;
  }
  return target - Vec3(middleOf(box.center().x(), openings), box.max().y() - above, box.center().z());
}

/// How bad a place is; lower is better. The fewer triangles of the full body pass through the garment the better, if
/// none of a shrunk body does. Otherwise the centre lines count more than the full body, which pushes cloth outwards
/// when it grows.
class Badness {
 public:
  Badness(const sim::ClothMesh& garment, const ShrinkingBody& body, const BodyParts& parts,
          const GarmentOpenings& openings)
      : body_(body), openings_(openings), bend_(body, parts), wearing_(body, parts, openings, garment.triangles) {}

  /// @param limit larger results need not be exact
  [[nodiscard]] double of(const std::vector<Vec3>& positions, double limit) {
    constexpr double missedOpening = 1e4;
    bend_.aim(openings_, positions);
    const double missed =
        missedOpening * static_cast<double>(wearing_.missed(positions, bend_.withFullLength()).size());
    if (missed >= limit) {
      return missed;
    }
    const double full = pairs(positions, 0);
    double sum = missed + full;
    double minPairs = full;
    for (const auto& [frame, weight] : shrunk()) {
      if (minPairs > 0.0) {
        const double here = pairs(positions, frame);
        sum += weight * here;
        minPairs = std::min(minPairs, here);
      }
    }
    return minPairs > 0.0 ? sum : missed + full;
  }

  /// Whether a shrunk body is inside the garment, and the limbs pass through its openings.
  [[nodiscard]] bool isWorn(const std::vector<Vec3>& positions) {
    bend_.aim(openings_, positions);
    const std::array<std::pair<std::size_t, double>, 3> frames = shrunk();
    return wearing_.missed(positions, bend_.withFullLength()).empty() &&
           (pairs(positions, 0) == 0.0 ||
            std::ranges::any_of(frames, [&](const auto& each) { return pairs(positions, each.first) == 0.0; }));
  }

 private:
  /// Frames of the shrunk body, and the weights of pairs there.
  [[nodiscard]] std::array<std::pair<std::size_t, double>, 3> shrunk() const {
    return {{{body_.thinnest(), 100.0}, {body_.centreLines(), 20.0}, {body_.centreLines() / 2, 2.0}}};
  }
  [[nodiscard]] double pairs(const std::vector<Vec3>& positions, std::size_t frame) const {
    return static_cast<double>(wearing_.pairs(positions, bend_.bent(frame)));
  }

  const ShrinkingBody& body_;
  const GarmentOpenings& openings_;
  ArmBend bend_;
  Wearing wearing_;
};

/// Shifts to try, nearest first: up and down, forwards and backwards.
std::vector<Vec3> shiftsAround(double step, int upwards, int forwards) {
  std::vector<Vec3> shifts;
  for (int y = -upwards; y <= upwards; ++y) {
    for (int z = -forwards; z <= forwards; ++z) {
      shifts.emplace_back(0.0, step * y, step * z);
    }
  }
  std::ranges::stable_sort(shifts, {}, [](const Vec3& shift) { return shift.squaredNorm(); });
  return shifts;
}

/// Shifts to try, nearest first: to the left and to the right.
std::vector<Vec3> lateralShifts(double step, int sidewards) {
  std::vector<Vec3> shifts;
  for (int x = 1; x <= sidewards; ++x) {
    shifts.emplace_back(-step * x, 0.0, 0.0);
    shifts.emplace_back(step * x, 0.0, 0.0);
  }
  return shifts;
}

/// The best of the shifts around a place.
class Search {
 public:
  Search(Badness& badness, std::vector<Vec3> positions, const std::function<void(double)>& progress)
      : badness_(badness), positions_(std::move(positions)), progress_(progress) {}

  /// @param forwards the largest shift to the front and back, in steps of 2 cm
  [[nodiscard]] Vec3 run(int forwards) {
    constexpr double coarse = 0.02;  // [m]
    constexpr double fine = 0.01;    // [m]
    const std::vector<Vec3> wide = shiftsAround(coarse, 4, forwards);
    const std::vector<Vec3> narrow = shiftsAround(fine, 1, 1);
    const std::vector<Vec3> lateral = lateralShifts(coarse, 8);
    total_ = wide.size() + narrow.size() + lateral.size() + narrow.size();
    tryAll(wide);
    tryAll(narrow);
    checkBest();
    if (!isWorn_) {
      // The middle of a garment with one sleeve is not that of the body.
      tryAll(lateral);
      tryAll(narrow);
      checkBest();
    }
    return best_;
  }

  [[nodiscard]] double least() const { return least_; }
  /// Whether the garment is worn in the best place (Badness::isWorn).
  [[nodiscard]] bool isWorn() const { return isWorn_; }

 private:
  void tryAll(const std::vector<Vec3>& shifts) {
    constexpr double perMetre = 100.0;  // a shift must be worth it: one pair a centimetre
    const Vec3 middle = best_;
    for (const Vec3& each : shifts) {
      const Vec3 shift = middle + each;
      const double badness = perMetre * shift.norm() + badness_.of(shiftedBy(shift), least_);
      if (badness < least_) {
        least_ = badness;
        best_ = shift;
      }
      progress_(static_cast<double>(++tried_) / static_cast<double>(total_));
    }
  }

  void checkBest() { isWorn_ = badness_.isWorn(shiftedBy(best_)); }

  [[nodiscard]] std::vector<Vec3> shiftedBy(const Vec3& shift) const {
    Pose pose;
    pose.position = shift;
    return moved(positions_, pose);
  }

  Badness& badness_;
  std::vector<Vec3> positions_;
  const std::function<void(double)>& progress_;
  Vec3 best_ = Vec3::Zero();
  double least_ = std::numeric_limits<double>::max();
  bool isWorn_ = false;
  std::size_t tried_ = 0;
  std::size_t total_ = 1;
};

/// Whether a neck opening is at the neck of a person, and not around the hips.
bool isAtNeck(const GarmentOpenings& openings, const BodyParts& parts, double height) {
  constexpr double near = 0.15;  // of the height
  const Opening* neck = openings.find(OpeningKind::Neck);
  return neck == nullptr || !parts.landmarks() ||
         std::abs(neck->centre.y() - parts.landmarks()->neck.y()) < near * height;
}

bool isWornAsInFiles(const sim::ClothMesh& garment, const ShrinkingBody& body, const BodyParts& parts) {
  constexpr double reachBelow = 0.05;  // below the feet, in heights of the body
  const GarmentOpenings openings(garment);
  const Eigen::AlignedBox3d bodyBox = sim::boundsOf(body.frames().front());
  const Eigen::AlignedBox3d box = sim::boundsOf(garment.positions);
  const bool isAboveGround = box.min().y() >= bodyBox.min().y() - reachBelow * bodyBox.sizes().y();
  return openings.facesBack() == parts.facesBack() && isAboveGround && bodyBox.contains(Vec3(box.center())) &&
         isAtNeck(openings, parts, bodyBox.sizes().y()) &&
         Badness(garment, body, parts, openings).isWorn(garment.positions);
}

/// The best place that a rule finds.
struct Candidate {
  Placement placement;
  double badness = 0.0;
  bool isWorn = false;  ///< see Badness::isWorn

  [[nodiscard]] bool isBetterThan(const Candidate& other) const {
    return isWorn != other.isWorn ? isWorn : badness < other.badness;
  }
};

/// The best place by the landmarks, or by the boxes if the rule says so or if there are no landmarks.
Candidate candidateBy(PlacementRule rule, const sim::ClothMesh& garment, const ShrinkingBody& body,
                      const BodyParts& parts, const std::function<void(double)>& progress) {
  Placement result{PlacementRule::Boxes, turnToFront(garment, parts)};
  sim::ClothMesh turned{moved(garment.positions, result.pose), garment.triangles};
  const GarmentOpenings unplaced(turned);
  std::optional<Vec3> shift;
  if (rule != PlacementRule::Boxes) {
    shift = shiftByLandmarks(turned.positions, unplaced, parts);
  }
  result.rule = shift ? PlacementRule::Landmarks : PlacementRule::Boxes;
  result.pose.position += shift ? *shift : shiftByBoxes(turned.positions, unplaced, body, parts);
  turned.positions = moved(garment.positions, result.pose);
  const GarmentOpenings openings(turned);
  Badness badness(turned, body, parts, openings);
  // A cape hangs behind the body, farther than any landmark tells.
  const int forwards = openings.all().empty() ? 10 : 4;
  Search search(badness, turned.positions, progress);
  result.pose.position += search.run(forwards);
  return {result, search.least(), search.isWorn()};
}

}  // namespace

std::vector<Vec3> moved(std::span<const Vec3> positions, const Pose& pose) {
  std::vector<Vec3> result;
  result.reserve(positions.size());
  for (const Vec3& position : positions) {
    result.push_back(pose.toWorld(position));
  }
  return result;
}

Placement place(const sim::ClothMesh& garment, const ShrinkingBody& body, const BodyParts& parts, PlacementRule rule,
                const std::function<void(double)>& progress) {
  if (rule == PlacementRule::File || (rule == PlacementRule::Auto && isWornAsInFiles(garment, body, parts))) {
    return {};
  }
  Candidate best = candidateBy(rule, garment, body, parts, progress);
  if (rule == PlacementRule::Auto && !best.isWorn && best.placement.rule == PlacementRule::Landmarks) {
    const Candidate byBoxes = candidateBy(PlacementRule::Boxes, garment, body, parts, progress);
    best = byBoxes.isBetterThan(best) ? byBoxes : best;
  }
  return best.placement;
}

}  // namespace drape::dressing
