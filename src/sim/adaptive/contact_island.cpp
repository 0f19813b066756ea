#include "sim/adaptive/contact_island.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::sim::adaptive {
namespace {

/// Relative change of an impulse that counts as converged. Friction that has not converged acts like a viscous force:
/// cloth would creep and never come to rest.
constexpr double converged = 0.001;

/// Maximum number of sweeps over the contacts of an island in a substep. Slow layers that lie on each other need more.
constexpr int maxSweeps = 6;
constexpr int maxSweepsOfSlow = 60;
constexpr double slowSpeed = 0.1;  // [m/s]

/// A contact that slips more slowly than this still has the static coefficient. Substeps are so short that rounding and
/// vibrations of stiff cloth move a vertex at rest by as much as its weight does. With the kinetic coefficient it would
/// never come to rest again. The coefficient of real friction falls to the kinetic one in the same range of speeds
/// (Stribeck's curve). Larger: cloth begins to slide later.
constexpr double slowSlip = 5e-3;  // [m/s]

/// Maximum ratio of the speed that contact gives a vertex to the speed of the fastest body or pin [-].
constexpr double speedRatio = 3.0;
constexpr double harmlessSpeed = 2.0;  // the limit is at least this [m/s]

/// The margin over the largest change of a relative velocity in the sweeps before. Larger: longer lists, fewer complete
/// sweeps.
constexpr double marginRatio = 2.0;
/// If a larger share of the contacts of an island has an impulse, its lists contain all contacts: counting the changes
/// of velocity would cost more than the sweeps over the rest.
constexpr double denseShare = 0.4;
constexpr double minMargin = 1e-6;      // [m/s]
constexpr double usableMargin = 0.999;  // the rest is for rounding

Vec3 relativeVelocityOf(const ImpulseContact& contact, std::span<const ContactVertex> vertices) {
  Vec3 relative = -contact.bodyVelocity;
  for (std::size_t c = 0; c < contact.count; ++c) {
    relative += contact.weights[c] * vertices[contact.vertices[c]].velocity;
  }
  return relative;
}

/// Applies an impulse to the vertices of a contact.
/// @tparam counts whether to add to ContactVertex::changes  @return the largest of them [m/s]; 0 if they are not
/// counted
template <bool counts>
double apply(const Vec3& impulse, const ImpulseContact& contact, std::span<ContactVertex> vertices) {
  const double size = counts ? impulse.lpNorm<1>() : 0.0;  // at least the length
  double changes = 0.0;
  for (std::size_t c = 0; c < contact.count; ++c) {
    ContactVertex& vertex = vertices[contact.vertices[c]];
    if (vertex.inverseMass > 0.0) {  // islands of other threads may read pinned vertices
      const double perImpulse = contact.weights[c] * vertex.inverseMass;
      vertex.velocity += perImpulse * impulse;
      if constexpr (counts) {
        vertex.changes += std::abs(perImpulse) * size;
        changes = std::max(changes, vertex.changes);
      }
    }
  }
  return changes;
}

/// @tparam counts see apply()  @param relative velocity of the point relative to the body [m/s]
template <bool counts>
SolvedContact solveAt(const Vec3& relative, ImpulseContact& contact, std::span<ContactVertex> vertices) {
  const double along = contact.normal.dot(relative);
  if (contact.normalImpulse == 0.0 && !(along < contact.minSpeed)) {
    return {};
  }
  const double normal = std::max(0.0, contact.normalImpulse + (contact.minSpeed - along) / contact.inverseMass);
  Vec3 friction = contact.friction - (relative - along * contact.normal) / contact.inverseMass;
  const double size = friction.norm();
  const double sticking = contact.staticFriction * normal;
  if (size > sticking) {
    const bool isSlow = (size - sticking) * contact.inverseMass < slowSlip;
    friction *= (isSlow ? sticking : contact.kineticFriction * normal) / size;
  }
  const Vec3 change = (normal - contact.normalImpulse) * contact.normal + friction - contact.friction;
  const double changes = apply<counts>(change, contact, vertices);
  contact.normalImpulse = normal;
  contact.friction = friction;
  return {change.squaredNorm() > converged * converged * normal * normal, changes};
}

bool isSlow(const ContactIsland& island, std::span<const ContactVertex> vertices) {
  return std::ranges::all_of(island.vertices,
                             [&](std::size_t v) { return vertices[v].before.squaredNorm() < slowSpeed * slowSpeed; });
}

/// The sweeps over the contacts of an island in a substep.
class Sweeps {
 public:
  Sweeps(ContactIsland& island, std::span<ContactVertex> vertices, const Drift& drift)
      : island_(island), vertices_(vertices), drift_(drift) {}

  /// Applies the impulses that the contacts have from the substep before.
  void applyImpulses() {
    for (const std::uint32_t i : listed()) {
      const ImpulseContact& contact = island_.contacts[i];
      if (contact.normalImpulse > 0.0) {
        apply<false>(contact.normalImpulse * contact.normal + contact.friction, contact, vertices_);
      }
    }
  }

  /// @return whether an impulse has changed noticeably
  bool sweep() {
    if (isListValid_) {
      return sweepOverListed();
    }
    beginCompleteSweep();
    return sweepOverAll(0);
  }

  /// Adds the impulses of the substep to those of the step. Then it prepares for the next substep.
  void finish() {
    std::size_t impulses = 0;
    for (const std::uint32_t i : listed()) {
      ImpulseContact& contact = island_.contacts[i];
      contact.impulse += contact.normalImpulse * contact.normal + contact.friction;
      impulses += contact.normalImpulse > 0.0 ? 1 : 0;
    }
    island_.isDense = static_cast<double>(impulses) > denseShare * static_cast<double>(island_.contacts.size());
    island_.margin = marginRatio * std::max(largestChange_, relativeChange());
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> listed() const { return island_.near.first(island_.nearCount); }

  /// Upper bound of the change of a relative velocity since the last complete sweep began [m/s]: two sides move.
  [[nodiscard]] double relativeChange() const { return 2.0 * change_; }

  void beginCompleteSweep() {
    largestChange_ = std::max(largestChange_, relativeChange());
    island_.margin = std::max({island_.margin, marginRatio * largestChange_, minMargin});
    for (const std::uint32_t v : island_.vertices) {
      vertices_[v].changes = 0.0;
    }
    change_ = 0.0;
    maxChange_ = usableMargin * island_.margin / 2.0;
    isListValid_ = true;
    island_.nearCount = 0;
  }

  bool sweepOverListed() {
    bool changes = false;
    for (std::size_t k = 0; k < island_.nearCount; ++k) {
      const std::uint32_t i = island_.near[k];
      ImpulseContact& contact = island_.contacts[i];
      changes = solve(contact, relativeVelocityOf(contact, vertices_)) || changes;
      if (!isListValid_) {
        island_.nearCount = k + 1;
        return sweepOverAll(i + 1) || changes;
      }
    }
    return changes;
  }

  /// Solves the contacts from `first` on, and lists those that have an impulse or are near to one.
  bool sweepOverAll(std::size_t first) {
    bool changes = false;
    for (std::size_t i = first; i < island_.contacts.size(); ++i) {
      ImpulseContact& contact = island_.contacts[i];
      const double minSpeed = minSpeedOf(contact, vertices_, drift_);
      const Vec3 relative = relativeVelocityOf(contact, vertices_);
      if (!island_.isDense && contact.normalImpulse == 0.0 &&
          contact.normal.dot(relative) - minSpeed > island_.margin) {
        continue;
      }
      contact.minSpeed = minSpeed;
      island_.near[island_.nearCount++] = static_cast<std::uint32_t>(i);
      changes = solve(contact, relative) || changes;
    }
    return changes;
  }

  /// @return whether the impulse has changed noticeably
  bool solve(ImpulseContact& contact, const Vec3& relative) {
    if (island_.isDense) {
      return solveAt<false>(relative, contact, vertices_).hasChanged;
    }
    const SolvedContact solved = solveAt<true>(relative, contact, vertices_);
    change_ = std::max(change_, solved.changes);
    isListValid_ = isListValid_ && change_ < maxChange_;
    return solved.hasChanged;
  }

  ContactIsland& island_;
  std::span<ContactVertex> vertices_;
  const Drift& drift_;
  bool isListValid_ = false;
  double change_ = 0.0;         // of the velocity of a vertex since the last complete sweep began, at most [m/s]
  double maxChange_ = 0.0;      // with which the list is valid [m/s]
  double largestChange_ = 0.0;  // of a relative velocity between complete sweeps of this substep [m/s]
};

/// The maximum of the bodies and the pins [m^2/s^2]; 0 if none moves.
double squaredSpeedOfObstacles(const ContactIsland& island, std::span<const ContactVertex> vertices) {
  double squared = 0.0;
  for (const ImpulseContact& contact : island.contacts) {
    const bool isWithBody = std::accumulate(contact.weights.begin(), contact.weights.end(), 0.0) > 0.5;
    squared = std::max(squared, isWithBody ? contact.bodyVelocity.squaredNorm() : 0.0);
    for (std::size_t c = 0; c < contact.count; ++c) {
      const ContactVertex& vertex = vertices[contact.vertices[c]];
      squared = std::max(squared, vertex.inverseMass > 0.0 ? 0.0 : vertex.afterKick.squaredNorm());
    }
  }
  return squared;
}

/// Bodies or pins that close like scissors would push vertices out of the gap at any speed. So contact may not give a
/// vertex a higher speed than `harmlessSpeed`, the speed of the fastest vertex before, or `speedRatio` times that of
/// the fastest body or pin, whichever is the highest. Contact that does not increase the kinetic energy of the island
/// has no limit, since it only passes on the motion of the cloth. Neither has contact without moving bodies and pins,
/// which adds no energy.
void limitSpeeds(const ContactIsland& island, std::span<ContactVertex> vertices) {
  double before = 0.0;  // squared
  double after = 0.0;   // squared
  double gained = 0.0;  // twice the kinetic energy
  for (const std::size_t v : island.vertices) {
    const double squaredBefore = vertices[v].afterKick.squaredNorm();
    const double squaredAfter = vertices[v].velocity.squaredNorm();
    before = std::max(before, squaredBefore);
    after = std::max(after, squaredAfter);
    gained += vertices[v].mass * (squaredAfter - squaredBefore);
  }
  if (after <= before || gained <= 0.0) {
    return;
  }
  const double ofObstacles = squaredSpeedOfObstacles(island, vertices);
  const double limit = std::max({before, speedRatio * speedRatio * ofObstacles, harmlessSpeed * harmlessSpeed});
  if (ofObstacles == 0.0 || after <= limit) {
    return;
  }
  for (const std::size_t v : island.vertices) {
    const double squared = vertices[v].velocity.squaredNorm();
    if (squared > limit) {
      vertices[v].velocity *= std::sqrt(limit / squared);
    }
  }
  for (ImpulseContact& contact : island.contacts) {
    contact.normalImpulse = 0.0;
    contact.friction = Vec3::Zero();
  }
}

}  // namespace

double minSpeedOf(const ImpulseContact& contact, std::span<const ContactVertex> vertices, const Drift& drift) {
  const double ofBody = contact.normal.dot(contact.bodyVelocity);
  double gapAtEnd = -contact.height - ofBody * drift.time;
  double along = -ofBody;
  for (std::size_t c = 0; c < contact.count; ++c) {
    const ContactVertex& vertex = vertices[contact.vertices[c]];
    gapAtEnd += contact.weights[c] * contact.normal.dot(vertex.position);
    along += contact.weights[c] * contact.normal.dot(vertex.afterKick);
  }
  const double gap = gapAtEnd - drift.duration * along;
  return gap > contact.restGap ? -gap / drift.duration : 0.0;
}

SolvedContact solveContact(ImpulseContact& contact, std::span<ContactVertex> vertices) {
  return solveAt<false>(relativeVelocityOf(contact, vertices), contact, vertices);
}

void solveIsland(ContactIsland& island, std::span<ContactVertex> vertices, const Drift& drift) {
  Sweeps sweeps(island, vertices, drift);
  sweeps.applyImpulses();
  const int count = island.hasFeaturePairs && isSlow(island, vertices) ? maxSweepsOfSlow : maxSweeps;
  for (int i = 0; i < count && sweeps.sweep();) {
    ++i;
  }
  sweeps.finish();
  limitSpeeds(island, vertices);
}

}  // namespace drape::sim::adaptive
