#include "dressing/dressing.hpp"

#include "dressing/arm_bend.hpp"
#include "dressing/closed_body.hpp"
#include "dressing/inside.hpp"
#include "intersection/intersections.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/bounds.hpp"
#include "sim/model/enclosed_volume.hpp"

#include <algorithm>
#include <utility>

namespace drape::dressing {
namespace {

using sim::contact::Pose;

double largestSide(const std::vector<Vec3>& positions) {
  return sim::boundsOf(positions).sizes().maxCoeff();
}

/// The turn and shift by hand, after a placement.
Pose byHand(const Pose& placed, const std::vector<Vec3>& start, const DressingOptions& options) {
  const Vec3 centre = sim::boundsOf(moved(start, placed)).center();
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(options.turn, Vec3::UnitY()) * placed.rotation;
  pose.position = centre + Eigen::AngleAxisd(options.turn, Vec3::UnitY()) * (placed.position - centre) + options.move;
  return pose;
}

Placement placedBy(const DressingOptions& options, const sim::ClothMesh& garment, const ShrinkingBody& body,
                   const BodyParts& parts) {
  return place(garment, body, parts, options.rule, [&](double share) { options.progress(Stage::Placing, share); });
}

/// Whether more than a few vertices of the garment are inside the body, by a sample of them.
bool isInside(const ShrinkingBody& body, std::size_t frame, const std::vector<Vec3>& positions) {
  constexpr double largestShare = 0.05;
  constexpr std::size_t sampled = 500;
  std::vector<Vec3> points;
  const std::size_t step = 1 + positions.size() / sampled;
  for (std::size_t v = 0; v < positions.size(); v += step) {
    points.push_back(positions[v]);
  }
  return shareInside(points, body.frames()[frame], body.triangles()) > largestShare;
}

/// The least shrunk frame through which no triangle of the garment passes, and which the garment is not inside; the
/// thinnest one if there is none. Limbs bend as they shrink, so a tight garment may fit the full body and not the
/// thinnest one.
std::size_t freeFrame(const Wearing& wearing, const ShrinkingBody& body, const std::vector<Vec3>& positions) {
  std::size_t frame = 0;
  while (frame < body.thinnest() && (wearing.pairs(positions, frame) > 0 || isInside(body, frame, positions))) {
    ++frame;
  }
  return frame;
}

class Dresser {
 public:
  /// @param limbs the body with limbs of their full length, see Wearing::faults
  Dresser(const sim::ClothModel& model, const DressingOptions& options, const Wearing& wearing,
          const ShrinkingBody& body, std::vector<Vec3> limbs)
      : model_(model), options_(options), wearing_(wearing), body_(body), limbs_(std::move(limbs)) {}

  void run(std::vector<Vec3> positions, Dressed& result) const {
    result.before = pairsOf(positions);
    const std::size_t frame = freeFrame(wearing_, body_, positions);
    result.placedFaults = wearing_.faults(positions, frame, limbs_);
    result.shrunk = body_.wayTo(frame);
    result.positions = positions;
    result.after = result.before;
    const bool isFree = wearing_.pairs(positions, frame) == 0;
    result.fits = isFree && !isInside(body_, frame, positions);
    if (!result.fits) {
      result.faults = isFree ? std::vector<Fault>{{.kind = FaultKind::InsideBody}} : result.placedFaults;
      return;
    }
    Fitting fitting(model_, std::move(positions), body_, frame, options_.step);
    while (!fitting.isGrown()) {
      fitting.step();
      options_.progress(Stage::Growing, std::min(1.0, fitting.time() / fitting.growthTime()));
    }
    settle(fitting);
    result.positions = fitting.positions();
    result.after = pairsOf(result.positions);
    result.stretch = sim::strainOfTightest(model_, result.positions);
    result.faults = wearing_.faults(result.positions, 0, body_.frames().front());
  }

 private:
  [[nodiscard]] Pairs pairsOf(const std::vector<Vec3>& positions) const {
    return {wearing_.pairs(positions, 0), intersection::intersectingPairs({positions, model_.triangles}).size()};
  }

  /// Continues with the full body until no pair is left, and the cloth has its distance to body and itself.
  void settle(Fitting& fitting) const {
    constexpr int stepsBetweenChecks = 15;
    const double begin = fitting.time();
    do {
      for (int step = 0; step < stepsBetweenChecks; ++step) {
        fitting.step();
      }
      options_.progress(Stage::Settling, std::min(1.0, (fitting.time() - begin) / options_.maxSettleTime));
    } while (fitting.time() - begin < options_.maxSettleTime && pairsOf(fitting.positions()).all() > 0);
  }

  const sim::ClothModel& model_;
  const DressingOptions& options_;
  const Wearing& wearing_;
  const ShrinkingBody& body_;
  std::vector<Vec3> limbs_;
};

}  // namespace

Misfit misfitOf(const sim::ClothMesh& garment, const sim::ClothMesh& body) {
  const double garmentSide = largestSide(garment.positions);
  const double bodySide = largestSide(body.positions);
  constexpr double smallestVolume = 1e-5;  // of the cube around the body [-]
  const ClosedBody closed = closedBody(body);
  if (closed.addedArea > largestHoles) {
    return Misfit::OpenBody;
  }
  if (!(sim::enclosedVolume(closed.mesh.positions, closed.mesh.triangles) >
        smallestVolume * bodySide * bodySide * bodySide)) {
    return Misfit::NoVolume;
  }
  if (garmentSide > largestRatio * bodySide) {
    return Misfit::GarmentTooLarge;
  }
  return garmentSide < smallestRatio * bodySide ? Misfit::GarmentTooSmall : Misfit::None;
}

Placement placeOn(const sim::ClothModel& model, const std::vector<Vec3>& start, const sim::ClothMesh& body,
                  const DressingOptions& options) {
  options.progress(Stage::Shrinking, 0.0);
  const ShrinkingBody shrinking(body);
  Placement placement = placedBy(options, {start, model.triangles}, shrinking, BodyParts(shrinking));
  placement.pose = byHand(placement.pose, start, options);
  return placement;
}

Dressed dress(const sim::ClothModel& model, const std::vector<Vec3>& start, const sim::ClothMesh& body,
              const DressingOptions& options) {
  Dressed result;
  options.progress(Stage::Shrinking, 0.0);
  ClosedBody closed = closedBody(body);
  result.filledHoles = closed.holes;
  const ShrinkingBody shrinking(std::move(closed.mesh));
  const BodyParts parts(shrinking);
  const sim::ClothMesh garment{start, model.triangles};
  result.placement = placedBy(options, garment, shrinking, parts);
  result.placement.pose = byHand(result.placement.pose, start, options);
  std::vector<Vec3> positions = moved(start, result.placement.pose);
  const GarmentOpenings openings({positions, model.triangles});
  result.openings = static_cast<int>(openings.all().size());
  const Opening* neck = openings.find(OpeningKind::Neck);
  result.isOpenCape = neck != nullptr && neck->hasGap && openings.find(OpeningKind::LeftSleeve) == nullptr;
  ArmBend bend(shrinking, parts);
  bend.aim(openings, positions);
  const ShrinkingBody bent = bend.bentBody();
  const Wearing wearing(bent, parts, openings, model.triangles);
  Dresser(model, options, wearing, bent, bend.withFullLength()).run(std::move(positions), result);
  return result;
}

}  // namespace drape::dressing
