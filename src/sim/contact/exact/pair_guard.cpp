#include "sim/contact/exact/pair_guard.hpp"

#include "sim/contact/exact/corrections.hpp"
#include "sim/contact/exact/near_pairs.hpp"
#include "sim/contact/exact/pair_contacts.hpp"
#include "sim/model/distances.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace drape::sim::contact {
namespace {

constexpr double guardedSeparation = 0.1;  // that pairs keep, in their thicknesses
constexpr int maxSweepRounds = 6;
constexpr int maxSweepRoundsOfPart = 40;
constexpr int sweepsOfRound = 8;
constexpr int maxSearches = 500;         // in a step; then the guard only moves cloth back
constexpr int maxSweepRoundsInVain = 6;  // rounds in succession that do not reduce the number of pairs too close
constexpr int maxPlaneRounds = 40;
constexpr std::array partsOfMotion{4, 16};  // into which a motion is divided that cannot be guarded at once
constexpr double sweepMargin = 1.1;         // sweeps aim at the required separation times this

std::uint64_t keyOf(const FeaturePair& pair) {
  return (static_cast<std::uint64_t>(pair.first) << 33U) | (static_cast<std::uint64_t>(pair.second) << 1U) |
         (pair.edges ? 1U : 0U);
}

double meanAt(std::span<const double> values, std::span<const int> indices) {
  double sum = 0.0;
  for (const int i : indices) {
    sum += values[i];
  }
  return sum / static_cast<double>(indices.size());
}

/// The share of the first of two numbers >= 0; a half if both are 0.
double shareOf(double first, double second) {
  return first + second > 0.0 ? first / (first + second) : 0.5;
}

/// The number of planes of bodies that free vertices violate.
int violatedPlanes(const PairGuard::Inputs& inputs, std::span<const Vec3> positions) {
  return static_cast<int>(
      std::count_if(inputs.bodyPlanes.begin(), inputs.bodyPlanes.end(), [&](const SeparatingPlane& plane) {
        return inputs.inverseMass[plane.vertex] > 0.0 &&
               plane.height - plane.normal.dot(positions[plane.vertex]) > planeTolerance;
      }));
}

/// Makes the list of near pairs valid for the motion to `positions` [m].
void updateSearch(const PairGuard::Inputs& inputs, PairSearch& search, Workers& workers,
                  std::span<const Vec3> positions) {
  search.update({inputs.model, guardedSeparation * inputs.thickness, inputs.reach, inputs.patches, inputs.threads},
                inputs.start, positions, workers);
}

}  // namespace

/// Finds the pairs that are not separated, and counts those that touch at the start.
void PairGuard::findCrossing(const Inputs& inputs, const PairSearch& search, Workers& workers,
                             std::span<const Vec3> positions) {
  const double required = guardedSeparation * inputs.thickness;
  const auto check = [&](const FeaturePair& pair, std::vector<Guarded>& found) {
    const PairVertices vertices = verticesOf(search.mesh(), pair);
    if (isEntangled(inputs.entangled, vertices)) {
      return;
    }
    const double kept = guardedSeparation * thicknessOfPair(inputs.model, vertices, inputs.thickness);
    const PairInStep inStep = separationInStep(vertices, inputs.start, positions, {required, kept});
    if (inStep.kind != PairInStep::Kind::Separated) {
      found.push_back({vertices, inStep, keyOf(pair)});
    }
  };
  found_.clear();
  collectFromNearPairs(search, {inputs.start, positions, required}, workers, inputs.threads, found_, check);
  touching_ = static_cast<int>(
      std::erase_if(found_, [](const Guarded& pair) { return pair.inStep.kind == PairInStep::Kind::Touching; }));
}

/// Adds the pairs that were found to the guarded ones, each once.
void PairGuard::guardFound() {
  for (const Guarded& each : found_) {
    if (keys_.insert(each.key).second) {
      guarded_.push_back(each);
    }
  }
}

/// Moves the features of all guarded pairs apart that are too close, one pair after the other.
void PairGuard::moveApart(const Inputs& inputs, std::span<Vec3> positions) const {
  for (const Guarded& pair : guarded_) {
    const Vec3 origin = positions[pair.vertices.all[0]];
    const Vec3& normal = pair.inStep.normal;
    const PairExtents extents = extentsOf(pair.vertices, normal, origin, positions);
    const double wanted = sweepMargin * (pair.inStep.separation + roundingOf(pair.vertices, positions));
    const double missing = wanted - (extents.firstLow - extents.secondHigh);
    const double first = meanAt(inputs.inverseMass, pair.vertices.first());
    const double second = meanAt(inputs.inverseMass, pair.vertices.second());
    if (missing <= 0.0 || first + second <= 0.0) {
      continue;
    }
    const double low = extents.firstLow + missing * first / (first + second);
    const double high = extents.secondHigh - missing * second / (first + second);
    for (const int v : pair.vertices.first()) {
      const double below = low - normal.dot(positions[v] - origin);
      positions[v] += (inputs.inverseMass[v] > 0.0 ? std::max(0.0, below) : 0.0) * normal;
    }
    for (const int v : pair.vertices.second()) {
      const double above = normal.dot(positions[v] - origin) - high;
      positions[v] -= (inputs.inverseMass[v] > 0.0 ? std::max(0.0, above) : 0.0) * normal;
    }
  }
  for (const SeparatingPlane& plane : inputs.bodyPlanes) {
    const double below = plane.height - plane.normal.dot(positions[plane.vertex]);
    if (below > 0.0 && inputs.inverseMass[plane.vertex] > 0.0) {
      positions[plane.vertex] += below * plane.normal;
    }
  }
}

/// Adds the planes of the guarded pairs from index `first`. They lie between the fallback positions, where the motion
/// to the wanted positions needs most of the space. If the fallback positions are too close, because pins or bodies
/// move, the planes require of both features to make space, weighted by their masses.
void PairGuard::addPlanes(const Inputs& inputs, std::size_t first) {
  for (std::size_t i = first; i < guarded_.size(); ++i) {
    const Guarded& pair = guarded_[i];
    // The normal at the start, unless the pair has turned on the way to its fallback positions.
    const Vec3 normal = separationAlong(pair.inStep.normal, pair.vertices, inputs.fallback) < pair.inStep.separation
                            ? gapOf(pair.vertices, inputs.fallback).normal
                            : pair.inStep.normal;
    const PairExtents start = extentsOf(pair.vertices, normal, Vec3::Zero(), inputs.fallback);
    const PairExtents end = extentsOf(pair.vertices, normal, Vec3::Zero(), wanted_);
    const double kept = pair.inStep.separation + roundingOf(pair.vertices, inputs.fallback);
    const double space = start.firstLow - start.secondHigh - kept;
    const double down = std::max(0.0, start.firstLow - end.firstLow);
    const double up = std::max(0.0, end.secondHigh - start.secondHigh);
    const double ofSecond = space > 0.0 ? shareOf(up, down)
                                        : shareOf(meanAt(inputs.inverseMass, pair.vertices.second()),
                                                  meanAt(inputs.inverseMass, pair.vertices.first()));
    for (const int v : pair.vertices.first()) {
      planes_.push_back({v, 0, normal, start.firstLow - space * (1.0 - ofSecond)});
    }
    for (const int v : pair.vertices.second()) {
      planes_.push_back({v, 0, -normal, -(start.secondHigh + space * ofSecond)});
    }
  }
}

/// Finds the pairs that are not separated, and adds them to the guarded ones.
/// @returns true if there are any
bool PairGuard::find(const Inputs& inputs, PairSearch& search, Workers& workers, std::span<const Vec3> positions) {
  ++searches_;
  updateSearch(inputs, search, workers, positions);
  findCrossing(inputs, search, workers, positions);
  guardFound();
  return !found_.empty();
}

/// Whether pairs are too close, and further searches for them are allowed.
bool PairGuard::mayContinue() const {
  return !found_.empty() && searches_ < maxSearches;
}

/// Moves the features of guarded pairs apart, in rounds of sweeps. Where pins or bodies leave no room, the sweeps do
/// not converge and would move vertices far away. So if a vertex moves farther than the limit, all vertices move back.
void PairGuard::sweep(const Inputs& inputs, const Limits& limits, PairSearch& search, Workers& workers,
                      std::span<Vec3> positions) {
  if (!find(inputs, search, workers, positions)) {
    return;
  }
  unswept_.assign(positions.begin(), positions.end());
  std::size_t minFound = found_.size();
  int roundsInVain = 0;
  for (int round = 0; mayContinue() && round < limits.sweepRounds && roundsInVain < maxSweepRoundsInVain; ++round) {
    for (int i = 0; i < sweepsOfRound; ++i) {
      moveApart(inputs, positions);
    }
    if (largestDistance(unswept_, positions) > limits.correction) {
      std::ranges::copy(unswept_, positions.begin());
      round = limits.sweepRounds;
    }
    find(inputs, search, workers, positions);
    roundsInVain = found_.size() < minFound ? 0 : roundsInVain + 1;
    minFound = std::min(minFound, found_.size());
  }
}

/// Guards the whole motion at once.
PairGuard::Result PairGuard::applyAtOnce(const Inputs& inputs, int sweepRounds, PairSearch& search, Workers& workers,
                                         std::span<Vec3> positions) {
  guarded_.clear();
  keys_.clear();
  const double correction = inputs.obstaclesMove ? largestCorrection(inputs.start, positions, inputs.thickness)
                                                 : std::numeric_limits<double>::infinity();
  sweep(inputs, {sweepRounds, correction}, search, workers, positions);
  if (found_.empty()) {
    return {.touching = touching_, .insideBodies = violatedPlanes(inputs, positions)};
  }
  wanted_.assign(positions.begin(), positions.end());
  bounds_.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    bounds_[v] = (wanted_[v] - inputs.fallback[v]).norm() + correction;
  }
  planes_.assign(inputs.bodyPlanes.begin(), inputs.bodyPlanes.end());
  const auto fallbackOf = [&](int, int vertex) { return inputs.fallback[vertex]; };
  std::size_t planned = 0;
  for (int round = 0; round < maxPlaneRounds && mayContinue() && planned < guarded_.size(); ++round) {
    addPlanes(inputs, planned);
    planned = guarded_.size();
    std::copy(wanted_.begin(), wanted_.end(), positions.begin());
    filter_.apply(planes_, inputs.inverseMass, bounds_, 1, {fallbackOf, fallbackOf}, wanted_, positions);
    find(inputs, search, workers, positions);
  }
  return {static_cast<int>(found_.size()), touching_, violatedPlanes(inputs, positions)};
}

/// Moves the vertices of pairs that are not separated back to their fallback positions. If pairs remain, because bodies
/// carry fallback positions too close to each other, it moves their vertices back to their start.
PairGuard::Result PairGuard::stop(const Inputs& inputs, PairSearch& search, Workers& workers,
                                  std::span<Vec3> positions) {
  for (const std::span<const Vec3> target : {inputs.fallback, inputs.start}) {
    while (!found_.empty() && moveBackFound(inputs, target, positions)) {
      find(inputs, search, workers, positions);
    }
  }
  return {static_cast<int>(found_.size()), touching_, violatedPlanes(inputs, positions)};
}

/// Moves the free vertices of the pairs that were found to their targets.
/// @returns whether one moved
bool PairGuard::moveBackFound(const Inputs& inputs, std::span<const Vec3> target, std::span<Vec3> positions) const {
  bool moved = false;
  for (const Guarded& pair : found_) {
    for (const int v : pair.vertices.all) {
      if (inputs.inverseMass[v] > 0.0 && positions[v] != target[v]) {
        positions[v] = target[v];
        moved = true;
      }
    }
  }
  return moved;
}

/// Guards equal parts of the motion, one after the other. In a short part, pins and bodies move less than the pairs are
/// apart, so that a fallback position near the start of the part is feasible.
PairGuard::Result PairGuard::applyInParts(const Inputs& inputs, int parts, PairSearch& search, Workers& workers,
                                          std::span<Vec3> positions) {
  partStart_.assign(inputs.start.begin(), inputs.start.end());
  partFallback_.resize(positions.size());
  Inputs part = inputs;
  part.patches = nullptr;  // patches are valid at the ends of the step only
  Result result;
  for (int k = 1; k <= parts; ++k) {
    const double remaining = parts - k;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      partFallback_[v] = partStart_[v] + (inputs.fallback[v] - inputs.start[v]) / parts;
      positions[v] = k == parts ? predicted_[v] : partStart_[v] + (predicted_[v] - partStart_[v]) / (remaining + 1.0);
    }
    partPlanes_.assign(inputs.bodyPlanes.begin(), inputs.bodyPlanes.end());
    for (SeparatingPlane& plane : partPlanes_) {
      const double slack = plane.normal.dot(inputs.start[plane.vertex]) - plane.height;
      plane.height += std::min(0.0, slack) * remaining / parts;
    }
    part.start = partStart_;
    part.fallback = partFallback_;
    part.bodyPlanes = partPlanes_;
    Result ofPart = applyAtOnce(part, maxSweepRoundsOfPart, search, workers, positions);
    if (ofPart.crossings > 0 && (parts == partsOfMotion.back() || !mayContinue())) {
      ofPart = stop(part, search, workers, positions);
    }
    result.crossings += ofPart.crossings;
    result.touching = std::max(result.touching, ofPart.touching);
    result.insideBodies = ofPart.insideBodies;
    partStart_.assign(positions.begin(), positions.end());
  }
  return result;
}

std::optional<PairGuard::Result> PairGuard::resultWithoutMotion(const Inputs& inputs, PairSearch& search,
                                                                Workers& workers, std::span<const Vec3> positions) {
  updateSearch(inputs, search, workers, positions);
  findCrossing(inputs, search, workers, positions);
  if (!found_.empty() || violatedPlanes(inputs, positions) > 0) {
    return std::nullopt;
  }
  return Result{.touching = touching_};
}

PairGuard::Result PairGuard::apply(const Inputs& inputs, PairSearch& search, Workers& workers,
                                   std::span<Vec3> positions) {
  predicted_.assign(positions.begin(), positions.end());
  Result result = applyAtOnce(inputs, maxSweepRounds, search, workers, positions);
  for (auto parts = partsOfMotion.begin(); result.crossings + result.insideBodies > 0 && parts != partsOfMotion.end();
       ++parts) {
    result = applyInParts(inputs, *parts, search, workers, positions);
  }
  return result;
}

}  // namespace drape::sim::contact
