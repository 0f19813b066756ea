#include "sim/simd/fabric_damper.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace drape::sim::simd {
namespace {

/// The stages do not damp rates at their limit, and stretched cloth has higher rates than its rest shape.
constexpr double rateMargin = 1.25;

/// Cloth that is stretched further gets as many times the stages at most.
constexpr int maxRefinement = 8;

/// Rounding may raise the kinetic energy by this fraction.
constexpr double roundingGain = 1e-5;

bool isAtRest(std::span<const PinVelocity> pins, const ClothState& state) {
  const auto rests = [](const Vec3& velocity) { return velocity.isZero(0.0); };
  return std::ranges::all_of(state.velocities, rests) && std::ranges::all_of(pins, rests, &PinVelocity::velocity);
}

/// The kinetic energy of the whole cloth at the speed of the fastest pin [J]. Pins that move can add this much.
double energyAtSpeedOf(std::span<const PinVelocity> pins, const ClothModel& model) {
  double squared = 0.0;
  for (const PinVelocity& pin : pins) {
    squared = std::max(squared, pin.velocity.squaredNorm());
  }
  return 0.5 * model.totalMass() * squared;
}

/// Largest 2 k_i / m_i of the free vertices [1/s^2]: an upper estimate of the highest frequency squared.
/// @param stiffness of each vertex, times its relative damping [N/m]
double highestRate(const ClothModel& model, std::span<const double> stiffness) {
  double highest = 0.0;
  for (std::size_t v = 0; v < stiffness.size(); ++v) {
    highest = std::max(highest, model.pinned[v] ? 0.0 : 2.0 * stiffness[v] / model.vertexMass[v]);
  }
  return highest;
}

/// The stiffness of the membrane at each vertex times the relative damping [N/m].
std::vector<double> dampedStiffness(const ClothModel& model) {
  std::vector<double> stiffness = fabric::membraneStiffness(model);
  std::ranges::transform(stiffness, fabric::relativeStretchDamping(model), stiffness.begin(), std::multiplies<>());
  return stiffness;
}

/// The stages for a damping time over a time step, and the time that they allow.
template <typename T>
DampingRun<T> runOf(DampedPart part, double timeStep, double dampingTime, double rate) {
  const double number = rateMargin * timeStep * dampingTime * rate;
  constexpr double stagesAllow = FabricDamper::maxStages * (FabricDamper::maxStages + 1.0);
  const double allowed = std::min(1.0, stagesAllow / number);
  return {.part = part,
          .timedDamping = static_cast<T>(allowed * timeStep * dampingTime),
          .stages = dampingStages(allowed * number)};
}

/// Adds the change of the velocities that one thread computed. In double, because a velocity that does not change
/// must keep its bits.
template <typename T>
void addChange(const ClothModel& model, const SlicedCloth<T>& cloth, const StepShare& share, ClothState& state) {
  const int end = std::min(share.end * sliceLanes, cloth.layout.vertices);
  for (int index = share.begin * sliceLanes; index < end; ++index) {
    const auto vertex = static_cast<std::size_t>(cloth.layout.order[index]);
    if (model.pinned[vertex]) {
      continue;
    }
    Vec3& velocity = state.velocities[vertex];
    const Vec3 before = velocity.template cast<T>().template cast<double>();
    const Vec3 after = Eigen::Matrix<T, 3, 1>(cloth.velocity.x.data()[index], cloth.velocity.y.data()[index],
                                              cloth.velocity.z.data()[index])
                           .template cast<double>();
    velocity += after - before;
  }
}

/// The weights of the springs in the slots of a layout.
template <typename T>
std::vector<SliceNumbers<T>> slotWeights(const ClothModel& model, const SlicedCloth<T>& cloth,
                                         std::span<const double> weights) {
  const SliceLayout& layout = cloth.layout;
  std::vector<SliceNumbers<T>> slots(layout.slots.size());
  for (int index = 0; index < layout.vertices; ++index) {
    const int slice = index / sliceLanes;
    const int lane = index % sliceLanes;
    for (int s = layout.slotBegin[slice]; s < layout.slotBegin[slice + 1]; ++s) {
      const auto slot = static_cast<std::size_t>(s);
      if (cloth.restLength[slot][lane] < T(0)) {
        continue;
      }
      const int table = layout.slots[slot].table;
      const int neighbour =
          layout.order[table < 0 ? layout.slots[slot].first + lane : layout.neighbourTables[table][lane]];
      slots[slot][lane] = static_cast<T>(weights[springBetween(model.springEnds, layout.order[index], neighbour)]);
    }
  }
  return slots;
}

/// The damping of bending, with directions that are still to be set.
template <typename T>
SlicedBendingDamping<T> slicedBending(const ClothModel& model, const fabric::BendingDamping& damping,
                                      const SlicedCloth<T>& cloth) {
  const int slices = cloth.layout.slices();
  SlicedBendingDamping<T> bending;
  bending.weights = slotWeights(model, cloth, damping.weights);
  bending.inverseAreas.resize(slices);
  bending.directions.resize(slices, false);
  bending.rates.resize(slices, cloth.layout.irregular());
  for (int index = 0; index < cloth.layout.vertices; ++index) {
    bending.inverseAreas.data()[index] = static_cast<T>(damping.inverseAreas[cloth.layout.order[index]]);
  }
  return bending;
}

/// Sets the directions of the vertices from `begin` to before `end`, by the order of the model, in which its data lie.
template <typename T>
void setDirections(const ClothModel& model, const fabric::BendingDamping& damping, std::span<const Vec3> positions,
                   const SliceLayout& layout, int begin, int end, LaneVectors<T>& lanes) {
  for (int v = begin; v < end; ++v) {
    const Eigen::Matrix<T, 3, 1> own = fabric::bendingDirection(model, damping, positions, v).template cast<T>();
    lanes.set(static_cast<std::size_t>(layout.indexOf[v]), own.x(), own.y(), own.z());
  }
}

}  // namespace

FabricDamper::Constants FabricDamper::constantsOf(const ClothModel& model) {
  Constants constants{.membraneRate = highestRate(model, dampedStiffness(model)), .bending = std::nullopt};
  if (model.fabric->bends() && model.fabric->materials.maxBendDamping() > 0.0) {
    constants.bending = fabric::bendingDampingOf(model);
  }
  return constants;
}

template <typename T>
std::vector<DampingRun<T>> FabricDamper::runsOf(const ClothModel& model, const Constants& constants, double timeStep,
                                                Sliced<T>& sliced) {
  const fabric::TriangleMaterials& materials = model.fabric->materials;
  std::vector<DampingRun<T>> runs;
  if (const double time = materials.maxStretchDamping(); time > 0.0) {
    runs.push_back(runOf<T>(DampedPart::Membrane, timeStep, time, constants.membraneRate));
  }
  if (constants.bending) {
    const SlicedCloth<T>& cloth = sliced.cloths.get(model);
    SlicedBendingDamping<T>& bending =
        sliced.bending.get(model, [&](const ClothModel& own) { return slicedBending(own, *constants.bending, cloth); });
    runs.push_back(runOf<T>(DampedPart::Bending, timeStep, materials.maxBendDamping(), constants.bending->highestRate));
    runs.back().bending = &bending;
  }
  return runs;
}

double FabricDamper::damp(const ClothModel& model, const CommonParameters& parameters,
                          std::span<const PinVelocity> pins, ClothState& state) {
  if (!model.fabric->materials.damp() || isAtRest(pins, state)) {
    return 0.0;
  }
  const double energy = kineticEnergy(model, state);
  const double pinsEnergy = energyAtSpeedOf(pins, model);
  before_ = state.velocities;
  for (int refinement = 1;; refinement *= 2) {
    if (parameters.precision == Precision::Float) {
      run(model, parameters, refinement, pins, single_, state);
    } else {
      run(model, parameters, refinement, pins, double_, state);
    }
    const double change = kineticEnergy(model, state) - energy;
    if (std::isfinite(change) && change <= roundingGain * energy + pinsEnergy) {
      return change;
    }
    state.velocities = before_;
    if (refinement >= maxRefinement) {
      return 0.0;  // no damping is better than damping that adds energy
    }
  }
}

template <typename T>
void FabricDamper::run(const ClothModel& model, const CommonParameters& parameters, int refinement,
                       std::span<const PinVelocity> pins, Sliced<T>& sliced, ClothState& state) {
  const Constants& constants = constants_.get(model, constantsOf);
  SlicedCloth<T>& cloth = sliced.cloths.get(model);
  std::vector<DampingRun<T>> runs = runsOf(model, constants, parameters.timeStep, sliced);
  for (DampingRun<T>& run : runs) {
    run.stages *= refinement;
  }
  const int threads = usefulThreads(cloth.layout, cloth.fabric.has_value(), parameters.threads);
  cloth.chooseOrigin(state);
  team_.run(threads, [&](int member) {
    const StepShare share = shareOf(cloth.layout, 1, member, threads);
    cloth.load(state, share);
    for (const DampingRun<T>& run : runs) {
      if (run.bending != nullptr) {
        const int vertices = cloth.layout.vertices;
        setDirections(model, *constants.bending, state.positions, cloth.layout, vertices * member / threads,
                      vertices * (member + 1) / threads, run.bending->directions);
      }
    }
    for (const auto& [vertex, velocity] : pins) {
      const int index = cloth.layout.indexOf[vertex];
      if (share.contains(index)) {
        const Eigen::Matrix<T, 3, 1> own = velocity.template cast<T>();
        cloth.velocity.set(static_cast<std::size_t>(index), own.x(), own.y(), own.z());
      }
    }
    team_.arriveAndWait();
    for (const DampingRun<T>& run : runs) {
      for (int stage = 1; stage <= run.stages; ++stage) {
        if (run.part == DampedPart::Bending) {
          bendingRates(cloth, run, stage, share);
          team_.arriveAndWait();
        }
        dampingStage(cloth, run, stage, share);
        team_.arriveAndWait();
      }
    }
    addChange(model, cloth, share, state);
  });
}

}  // namespace drape::sim::simd
