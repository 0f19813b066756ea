#include "sim/stepping/sewn_cloth.hpp"

#include "sim/contact/self/self_contact.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/solvers/self_collision.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim {
namespace {

/// In the distances at which contact keeps the two sides apart, with room for what is between them [-].
constexpr double weldedAt = 2.0;
constexpr double weldedAtOfHash = 1.25;
constexpr double weldedAtWithoutContact = 0.002;  // [m]

/// The time until which an open seam keeps the pieces without weight, in its durations [-].
constexpr double maxDelay = 2.0;

bool isClosed(const Seam& seam, double distance, std::span<const Vec3> positions) {
  return std::ranges::all_of(seam.pairs, [&](const SeamPair& pair) {
    return (positions[pair.a] - positions[pair.b]).squaredNorm() <= distance * distance;
  });
}

/// The seams between the leaders, without pairs that are already one vertex.
Seam betweenLeaders(const Seam& seam, std::span<const int> leaders) {
  Seam result{.pairs = {}, .duration = seam.duration, .start = seam.start};
  for (const SeamPair& pair : seam.pairs) {
    const SeamPair joined{leaders[pair.a], leaders[pair.b]};
    if (joined.a != joined.b) {
      result.pairs.push_back(joined);
    }
  }
  return result;
}

/// Moves the vertices that are welded together to their centre of mass, or to the pinned one of them. They get their
/// mean velocity.
void joinWelded(const ClothModel& pieces, std::span<const int> leaders, ClothState& state) {
  const std::vector<Vec3> positions = fabric::meansOfWelded(pieces, leaders, state.positions);
  const std::vector<Vec3> velocities = fabric::meansOfWelded(pieces, leaders, state.velocities);
  for (std::size_t v = 0; v < leaders.size(); ++v) {
    if (!pieces.pinned[v]) {
      state.positions[v] = positions[v];
      state.velocities[v] = velocities[v];
    }
  }
}

/// Forgets what a state knows about triangles that have changed.
void forgetMesh(ClothState& state) {
  state.selfContact = nullptr;
  state.hasNoSelfIntersection = false;
  state.history.timeStep = 0.0;
}

}  // namespace

void SewnCloth::use(std::shared_ptr<const ClothModel> pieces, std::shared_ptr<const std::vector<Seam>> seams) {
  pieces_ = std::move(pieces);
  seams_ = std::move(seams);
  update(std::vector<char>(seams_ ? seams_->size() : 0, 0));
}

void SewnCloth::change(std::shared_ptr<const ClothModel> pieces) {
  if (seams_ && !seams_->empty()) {
    static_cast<void>(fabric::withWelds(*pieces, leadersOf(*seams_, pieces->pinned)));
  }
  pieces_ = std::move(pieces);
  update(isWelded_);
}

void SewnCloth::sew(std::shared_ptr<const ClothModel> pieces, std::shared_ptr<const std::vector<Seam>> seams,
                    ClothState& state) {
  if (seams && !seams->empty()) {
    static_cast<void>(fabric::withWelds(*pieces, leadersOf(*seams, pieces->pinned)));
  }
  // The vertices of a seam that opens go on with their leaders.
  carry(state);
  spread<Vec3>(state.velocities);
  pieces_ = std::move(pieces);
  seams_ = std::move(seams);
  update(weldsOf(state));
  carry(state);
  forgetMesh(state);
}

std::vector<char> SewnCloth::weldsOf(const ClothState& state) const {
  std::vector<char> welds(seams_ ? seams_->size() : 0);
  for (std::size_t s = 0; s < welds.size(); ++s) {
    welds[s] = sim::isWelded((*seams_)[s], state.positions) ? 1 : 0;
  }
  return welds;
}

void SewnCloth::update(std::vector<char> isWelded) {
  isWelded_ = std::move(isWelded);
  std::vector<Seam> welded;
  for (std::size_t s = 0; s < isWelded_.size(); ++s) {
    if (isWelded_[s] != 0) {
      welded.push_back((*seams_)[s]);
    }
  }
  leaders_ = welded.empty() ? std::vector<int>() : leadersOf(welded, pieces_->pinned);
  model_ = leaders_.empty() ? pieces_ : fabric::withWelds(*pieces_, leaders_);
  open_.clear();
  for (std::size_t s = 0; s < isWelded_.size(); ++s) {
    if (isWelded_[s] == 0) {
      open_.push_back(leaders_.empty() ? (*seams_)[s] : betweenLeaders((*seams_)[s], leaders_));
    }
  }
}

std::vector<int> SewnCloth::weldedTo(int vertex) const {
  if (leaders_.empty()) {
    return {vertex};
  }
  std::vector<int> all;
  for (int v = 0; v < static_cast<int>(leaders_.size()); ++v) {
    if (leaders_[v] == leaders_[vertex]) {
      all.push_back(v);
    }
  }
  return all;
}

StepParameters SewnCloth::acting(StepParameters parameters, double time) const {
  const bool closes = std::ranges::any_of(
      open_, [&](const Seam& seam) { return !seam.pairs.empty() && time < seam.start + maxDelay * seam.duration; });
  parameters.gravity = closes ? 0.0 : parameters.gravity;
  return parameters;
}

void SewnCloth::follow(const ClothState& state) {
  std::vector<char> welded = weldsOf(state);
  if (welded != isWelded_) {
    update(std::move(welded));
  }
}

bool SewnCloth::weld(double weldDistance, ClothState& state) {
  std::vector<char> welded = isWelded_;
  for (std::size_t s = 0; s < welded.size(); ++s) {
    welded[s] = welded[s] != 0 || isClosed((*seams_)[s], weldDistance, state.positions) ? 1 : 0;
  }
  const bool changes = welded != isWelded_;
  if (changes) {
    carry(state);
    spread<Vec3>(state.velocities);
    update(std::move(welded));
    joinWelded(*pieces_, leaders_, state);
    forgetMesh(state);
  }
  carry(state);
  return changes;
}

void SewnCloth::carry(ClothState& state) const {
  for (std::size_t v = 0; v < leaders_.size(); ++v) {
    if (leaders_[v] != static_cast<int>(v)) {
      state.positions[v] = state.positions[leaders_[v]];
      state.velocities[v] = Vec3::Zero();
    }
  }
}

double weldDistanceOf(const ClothModel& model, const contact::ContactParameters& contact, const SolverInfo& solver) {
  switch (actingSelfCollision(contact.self, &solver)) {
    case contact::SelfCollision::Hash:
      return weldedAtOfHash * contact::selfThicknessOf(model, contact);
    case contact::SelfCollision::Exact:
      return weldedAt * contact.thickness;
    default:
      return weldedAtWithoutContact;
  }
}

}  // namespace drape::sim
