#include "sim/adaptive/contact_island.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace drape::sim::adaptive {
namespace {

constexpr Drift driftOfIsland{.time = 1e-3, .duration = 1e-3};

/// An island of pairs of features with different gaps, in substeps with random kicks.
class RandomIsland {
 public:
  RandomIsland(unsigned seed, double largestGap) : random_(seed), vertices_(100), contacts_(300), near_(300) {
    for (ContactVertex& vertex : vertices_) {
      vertex.inverseMass = numberIn(0.0, 1.0) < 0.1 ? 0.0 : numberIn(0.5, 2.0);
      vertex.mass = 1.0;
      vertex.position = vectorOfSize(0.01);
    }
    for (ImpulseContact& contact : contacts_) {
      set(contact, numberIn(0.0, largestGap));
    }
    std::erase_if(contacts_, [](const ImpulseContact& contact) { return contact.inverseMass == 0.0; });
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v].inverseMass > 0.0) {
        free_.push_back(v);
      }
    }
    island_ = {.contacts = contacts_, .vertices = free_, .near = near_, .hasFeaturePairs = true};
  }

  /// Begins the next substep: moves the vertices and changes their velocities.
  void kick(double speed) {
    for (ContactVertex& vertex : vertices_) {
      vertex.before = vertex.velocity;
      if (vertex.inverseMass > 0.0) {
        vertex.velocity += vectorOfSize(speed);
      }
      vertex.position += driftOfIsland.duration * vertex.velocity;
      vertex.afterKick = vertex.velocity;
    }
  }

  void solve() { solveIsland(island_, vertices_, driftOfIsland); }

  /// The same by complete sweeps. The speeds of these islands are below the limit.
  void solveByCompleteSweeps() {
    const bool isSlow = std::ranges::all_of(
        vertices_, [](const ContactVertex& v) { return v.inverseMass == 0.0 || v.before.norm() < 0.1; });
    for (ImpulseContact& contact : contacts_) {
      contact.minSpeed = minSpeedOf(contact, vertices_, driftOfIsland);
      applyImpulseOf(contact);
    }
    bool changes = true;
    for (sweeps_ = 0; sweeps_ < (isSlow ? 60 : 6) && changes; ++sweeps_) {
      changes = false;
      for (ImpulseContact& contact : contacts_) {
        changes = solveContact(contact, vertices_).hasChanged || changes;
      }
    }
    for (ImpulseContact& contact : contacts_) {
      contact.impulse += contact.normalImpulse * contact.normal + contact.friction;
    }
  }

  [[nodiscard]] const std::vector<ContactVertex>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ImpulseContact>& contacts() const { return contacts_; }
  [[nodiscard]] int sweeps() const { return sweeps_; }
  [[nodiscard]] std::size_t nearCount() const { return island_.nearCount; }

 private:
  double numberIn(double min, double max) { return std::uniform_real_distribution<double>(min, max)(random_); }
  Vec3 vectorOfSize(double size) { return {numberIn(-size, size), numberIn(-size, size), numberIn(-size, size)}; }

  void set(ImpulseContact& contact, double gap) {
    std::vector<std::uint32_t> each(vertices_.size());
    std::iota(each.begin(), each.end(), 0U);
    std::ranges::shuffle(each, random_);
    const double first = numberIn(0.0, 1.0);
    const double second = numberIn(0.0, 1.0);
    contact.weights = {first, 1.0 - first, -second, second - 1.0};
    contact.count = 4;
    contact.isFeaturePair = true;
    contact.normal = vectorOfSize(1.0).normalized();
    contact.staticFriction = 0.5;
    contact.kineticFriction = 0.4;
    contact.restGap = 1e-6F;
    Vec3 offset = Vec3::Zero();
    for (std::size_t c = 0; c < 4; ++c) {
      const ContactVertex& vertex = vertices_[each[c]];
      contact.vertices[c] = each[c];
      contact.inverseMass += contact.weights[c] * contact.weights[c] * vertex.inverseMass;
      offset += contact.weights[c] * vertex.position;
    }
    contact.height = contact.normal.dot(offset) - gap;
  }

  void applyImpulseOf(const ImpulseContact& contact) {
    const Vec3 impulse = contact.normalImpulse * contact.normal + contact.friction;
    for (std::size_t c = 0; c < contact.count; ++c) {
      ContactVertex& vertex = vertices_[contact.vertices[c]];
      if (vertex.inverseMass > 0.0 && contact.normalImpulse > 0.0) {
        vertex.velocity += contact.weights[c] * vertex.inverseMass * impulse;
      }
    }
  }

  std::mt19937 random_;
  std::vector<ContactVertex> vertices_;
  std::vector<ImpulseContact> contacts_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> near_;
  ContactIsland island_;
  int sweeps_ = 0;
};

bool haveTheSameBits(const RandomIsland& left, const RandomIsland& right) {
  return std::ranges::equal(left.vertices(), right.vertices(), {}, &ContactVertex::velocity,
                            &ContactVertex::velocity) &&
         std::ranges::equal(left.contacts(), right.contacts(), {}, &ImpulseContact::impulse, &ImpulseContact::impulse);
}

struct Kicks {
  const char* name;
  double speed;       // [m/s]
  double largestGap;  // [m]
};

void PrintTo(const Kicks& kicks, std::ostream* out) {
  *out << kicks.name;
}

class ContactIslandWithKicks : public ::testing::TestWithParam<Kicks> {};

/// Substeps of random islands.
struct Totals {
  int substeps = 0;
  int sweeps = 0;
  std::size_t nearCount = 0;
  std::size_t contactCount = 0;
};

/// Compares random islands with complete sweeps after each substep.
Totals compareWithCompleteSweeps(const Kicks& kicks) {
  Totals totals;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomIsland island(seed, kicks.largestGap);
    RandomIsland complete(seed, kicks.largestGap);
    for (int substep = 0; substep < 5; ++substep) {
      for (RandomIsland* each : {&island, &complete}) {
        each->kick(kicks.speed);
      }
      island.solve();
      complete.solveByCompleteSweeps();
      EXPECT_TRUE(haveTheSameBits(island, complete)) << "island " << seed << ", substep " << substep;
      ++totals.substeps;
      totals.sweeps += complete.sweeps();
      totals.nearCount += island.nearCount();
      totals.contactCount += island.contacts().size();
    }
  }
  return totals;
}

TEST_P(ContactIslandWithKicks, hasTheBitsOfCompleteSweepsThoughItLeavesContactsOut) {
  const Totals totals = compareWithCompleteSweeps(GetParam());
  EXPECT_GT(totals.sweeps, 3 * totals.substeps);
  EXPECT_LT(totals.nearCount, 3 * totals.contactCount / 4);
}

TEST(ContactIsland, hasTheBitsOfCompleteSweepsWhereManyContactsHaveImpulses) {
  const Totals totals = compareWithCompleteSweeps({"dense", 0.01, 1e-6});
  EXPECT_GT(totals.sweeps, 3 * totals.substeps);
  EXPECT_GT(totals.nearCount, 9 * totals.contactCount / 10);
}

INSTANTIATE_TEST_SUITE_P(Kicks, ContactIslandWithKicks,
                         ::testing::Values(Kicks{"slow", 0.01, 1.5e-4}, Kicks{"fast", 0.3, 4.5e-3}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace drape::sim::adaptive
