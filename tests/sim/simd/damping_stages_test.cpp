#include "sim/simd/damping_stages.hpp"

#include "simd_meshes.hpp"
#include "sliced_stepping.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace drape::sim::simd {
namespace {

using testing::everyKindOfMesh;
using testing::NamedMesh;
using testing::pinnedCloth;
using testing::Turns;

using Vectors = std::vector<Vec3>;

/// A kick that is to be damped.
struct Kick {
  double timedDamping = 0.0;  // h C_d [N s^2/m]
  int stages = 2;
  Vectors before;  // [m/s]
  Vectors gain;    // h a [m/s]
};

Vectors randomVectors(const ClothModel& model, double size, unsigned seed) {
  testing::RandomVectors random(seed);
  Vectors vectors;
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    const Vec3 next = random.next(size);
    vectors.push_back(model.pinned[v] ? Vec3(Vec3::Zero()) : next);
  }
  return vectors;
}

/// h D v for one unit of h C_d.
Vectors dampedPart(const ClothModel& model, const Vectors& v) {
  Vectors part(v.size(), Vec3::Zero());
  for (const Spring& spring : model.springs) {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    part[a] += (v[a] - v[b]) / model.vertexMass[a];
    part[b] += (v[b] - v[a]) / model.vertexMass[b];
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    part[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : part[i];
  }
  return part;
}

/// The recurrence as the paper has it.
Vectors plainStages(const ClothModel& model, const Kick& kick) {
  const double s = kick.stages;
  Vectors older = kick.before;
  Vectors newer = kick.before;
  for (int stage = 1; stage <= kick.stages; ++stage) {
    const double j = stage;
    const double mu = (2.0 * j - 1.0) / j;
    const double nu = (1.0 - j) / j;
    const double rate = (stage == 1 ? 1.0 : mu) * 2.0 / (s * s + s);
    const Vectors damped = dampedPart(model, newer);
    Vectors next = newer;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const Vec3 change = rate * (kick.gain[i] - kick.timedDamping * damped[i]);
      next[i] = stage == 1 ? Vec3(kick.before[i] + change) : Vec3(mu * newer[i] + nu * older[i] + change);
    }
    older = newer;
    newer = next;
  }
  return newer;
}

/// By the vector loops, share by share.
template <typename T>
Vectors stagesOf(const ClothModel& model, const Kick& kick, int members, Turns turns, double kept = 1.0) {
  SlicedCloth<T> cloth(model);
  cloth.prepare(members, 1);
  ClothState state = stateAtRest(model.restPositions);
  state.velocities = kick.before;
  const std::vector<int> order = testing::membersBy(turns, members);
  const auto eachMember = [&](const auto& visit) {
    for (const int member : order) {
      visit(shareOf(cloth.layout, 1, member, members));
    }
  };
  eachMember([&](const StepShare& share) { cloth.load(state, share); });
  for (std::size_t v = 0; v < kick.before.size(); ++v) {
    const Vec3 after = kick.before[v] + kick.gain[v];
    cloth.start.set(static_cast<std::size_t>(cloth.layout.indexOf[v]), static_cast<T>(after.x()),
                    static_cast<T>(after.y()), static_cast<T>(after.z()));
  }
  LaneVectors<T> gain;
  gain.resize(cloth.layout.slices(), false);
  std::vector<SliceNumbers<T>> scales(cloth.layout.slots.size());
  for (std::size_t slot = 0; slot < scales.size(); ++slot) {
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      scales[slot][lane] = cloth.restLength[slot][lane] < T(0) ? T(0) : static_cast<T>(kept);
    }
  }
  const DampingRun<T> run{.timedDamping = static_cast<T>(kick.timedDamping),
                          .stages = kick.stages,
                          .dampingScales = kept < 1.0 ? scales.data() : nullptr,
                          .gain = &gain};
  for (int stage = 1; stage <= kick.stages; ++stage) {
    eachMember([&](const StepShare& share) { dampingStage(cloth, run, stage, share); });
  }
  eachMember([&](const StepShare& share) { cloth.store(state, share); });
  return state.velocities;
}

double largestDifferenceOf(const Vectors& a, const Vectors& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The h C_d at which so many stages are just stable.
double maxDamping(const ClothModel& model, int stages) {
  return stages * (stages + 1) / model.unitDampingRate;
}

TEST(DampingStages, areThoseOfThePaperOnEveryKindOfMeshForAllShares) {
  for (const NamedMesh& mesh : everyKindOfMesh()) {
    const auto model = pinnedCloth(mesh.mesh);
    for (const int stages : {2, 6, 20}) {
      const Kick kick{0.9 * maxDamping(*model, stages), stages, randomVectors(*model, 2.0, 3),
                      randomVectors(*model, 1.0, 5)};
      const Vectors expected = plainStages(*model, kick);
      const Vectors exact = stagesOf<double>(*model, kick, 1, Turns::Forwards);
      EXPECT_LT(largestDifferenceOf(exact, expected), 1e-12) << mesh.name << " " << stages;
      const Vectors single = stagesOf<float>(*model, kick, 1, Turns::Forwards);
      EXPECT_LT(largestDifferenceOf(single, expected), 2e-5) << mesh.name << " " << stages;
      EXPECT_EQ(stagesOf<float>(*model, kick, 3, Turns::Backwards), single) << mesh.name << " " << stages;
    }
  }
}

TEST(DampingStages, scaleTheDampingOfEachSpring) {
  const auto model = pinnedCloth(testing::unevenSheet(13, 3));
  Kick kick{maxDamping(*model, 10), 10, randomVectors(*model, 1.0, 3), randomVectors(*model, 1.0, 5)};
  const Vectors shared = stagesOf<double>(*model, kick, 1, Turns::Forwards, 0.25);
  kick.timedDamping *= 0.25;
  EXPECT_LT(largestDifferenceOf(shared, plainStages(*model, kick)), 1e-12);
}

TEST(DampingStages, takeOnlyMotionAwayUpToTheirBoundAndKeepMomentum) {
  const auto model = buildClothModel(testing::unevenSheet(13, 3), 0.1, MassLumping::Area, {});
  for (const int stages : {2, 10, 100}) {
    Kick kick{maxDamping(*model, stages), stages, randomVectors(*model, 1.0, 7), {}};
    kick.gain.assign(kick.before.size(), Vec3::Zero());
    const Vectors after = stagesOf<double>(*model, kick, 1, Turns::Forwards);
    double before2 = 0.0;
    double after2 = 0.0;
    Vec3 gained = Vec3::Zero();
    for (std::size_t i = 0; i < after.size(); ++i) {
      before2 += model->vertexMass[i] * kick.before[i].squaredNorm();
      after2 += model->vertexMass[i] * after[i].squaredNorm();
      gained += model->vertexMass[i] * (after[i] - kick.before[i]);
    }
    EXPECT_LT(after2, before2) << stages;
    EXPECT_LT(gained.norm(), 1e-13) << stages;
  }
}

TEST(DampingStages, keepCreepAtTheSpeedAtWhichDampingBalancesTheForce) {
  const auto model = pinnedCloth(testing::unevenSheet(13, 3));
  const int stages = 30;
  Kick kick{0.5 * maxDamping(*model, stages), stages, randomVectors(*model, 1.0, 7), {}};
  kick.gain = dampedPart(*model, kick.before);
  for (Vec3& gain : kick.gain) {
    gain *= kick.timedDamping;
  }
  const Vectors after = stagesOf<double>(*model, kick, 1, Turns::Forwards);
  EXPECT_LT(largestDifferenceOf(after, kick.before), 1e-10);
}

TEST(DampingStages, areEvenAndAsFewAsAreStable) {
  for (const double timesRate : {0.0, 1.0, 6.0, 6.1, 20.0, 1e4, 1e6}) {
    const int s = dampingStages(timesRate);
    EXPECT_EQ(s % 2, 0);
    EXPECT_GE(s * (s + 1.0), timesRate);
    EXPECT_TRUE(s == 2 || (s - 2.0) * (s - 1.0) < timesRate) << timesRate;
  }
}

}  // namespace
}  // namespace drape::sim::simd
