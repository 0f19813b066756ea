#include "report/sections/collision_run.hpp"

#include "intersection/intersections.hpp"
#include "report/body_intersections.hpp"
#include "report/timing.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace drape::report::sections {
namespace {

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

/// The durations of the steps of a run [s].
struct StepCosts {
  std::vector<double> steps;
  std::vector<double> bodies;
  std::vector<double> selfs;
  std::vector<double> contacts;

  void add(double step, const sim::StepReport& report) {
    steps.push_back(step);
    bodies.push_back(report.contact.bodySeconds);
    selfs.push_back(report.contact.selfSeconds);
    contacts.push_back(report.secondsOfContact());
  }

  void addTo(CollisionRun& run) const {
    run.steps = static_cast<int>(steps.size());
    run.stepSeconds = meanOf(steps);
    run.bodySeconds = meanOf(bodies);
    run.selfSeconds = meanOf(selfs);
    run.contactSeconds = meanOf(contacts);
    run.longestContact = quantileOf(contacts, 0.99);
    run.longestSelf = quantileOf(selfs, 0.99);
  }
};

/// Counts intersecting triangles at intervals.
class IntersectionCounter {
 public:
  IntersectionCounter(const sim::ClothModel& model, const sim::contact::BodyWorld& world)
      : triangles_(model.triangles), world_(world) {}

  void look(const std::vector<Vec3>& positions, CollisionRun& run) {
    const auto self = static_cast<int>(intersection::intersectingPairs({positions, triangles_}).size());
    const auto bodies = static_cast<int>(pairsWithBodies(positions, triangles_, world_));
    run.pairsWithSelf = std::max(run.pairsWithSelf, self);
    run.pairsWithBodies = std::max(run.pairsWithBodies, bodies);
    ++looks_;
    found_ += self > 0 ? 1 : 0;
    run.shareWithSelf = static_cast<double>(found_) / looks_;
  }

 private:
  const std::vector<Triangle>& triangles_;
  const sim::contact::BodyWorld& world_;
  int looks_ = 0;
  int found_ = 0;
};

bool anyMoves(const std::vector<sim::contact::Body>& bodies, const sim::contact::BodyWorld& world) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].motion.moves() || world.isDeforming(i)) {
      return true;
    }
  }
  return false;
}

/// Measures whether a cloth gains energy, and how fast it moves at the end.
class MotionMeter {
 public:
  MotionMeter(const scene::Scene& scene, const sim::contact::BodyWorld& world, double seconds)
      : model_(*scene.model),
        parameters_(scene.settings.step),
        counted_(!anyMoves(*scene.bodies, world)),
        lastPart_(seconds - 0.2) {
    start_ = energyOf(scene.start);
    scale_ = model_.totalMass() * parameters_.gravity * sim::diagonalOf(model_);
  }

  void look(const sim::ClothState& state, CollisionRun& run) {
    run.energyGained = counted_ ? std::max(run.energyGained, (energyOf(state) - start_) / scale_)
                                : std::numeric_limits<double>::quiet_NaN();
    if (state.time > lastPart_) {
      for (const Vec3& velocity : state.velocities) {
        sum_ += velocity.squaredNorm();
      }
      count_ += static_cast<double>(state.velocities.size());
      run.endSpeed = std::sqrt(sum_ / count_);
    }
  }

 private:
  [[nodiscard]] double energyOf(const sim::ClothState& state) const {
    return sim::energyOf(model_, parameters_, state).total();
  }

  const sim::ClothModel& model_;
  const sim::StepParameters& parameters_;
  bool counted_;
  double lastPart_;     // [s]
  double start_ = 0.0;  // [J]
  double scale_ = 0.0;  // [J]
  double sum_ = 0.0;    // [m^2/s^2]
  double count_ = 0.0;
};

}  // namespace

CollisionRun runCollision(const scene::Scene& scene, double seconds, int countEvery,
                          const std::function<void()>& checkStop) {
  CollisionRun run;
  const sim::StepParameters& parameters = scene.settings.step;
  sim::Stepper stepper(scene.settings.solver.name);
  sim::ClothState state = scene.start;
  sim::contact::BodyWorld world(scene.bodies, state.time);
  sim::StepInputs inputs;
  StepCosts costs;
  IntersectionCounter counter(*scene.model, world);
  MotionMeter meter(scene, world, seconds);
  while (state.time < seconds && run.finite) {
    checkStop();
    sim::StepReport report;
    const double taken = secondsOf([&] {
      world.advance(state.time, parameters.timeStep);
      inputs.bodies = &world.steps();
      report = stepper.step(*scene.model, parameters, inputs, state);
    });
    costs.add(taken, report);
    const sim::contact::ContactReport& contact = report.contact;
    run.contacts = std::max(run.contacts, contact.bodyContacts + contact.selfContacts);
    run.overlapping = std::max(run.overlapping, contact.overlaps);
    run.infeasible = std::max(run.infeasible, contact.infeasible);
    run.finite = sim::isFinite(state);
    meter.look(state, run);
    if (countEvery > 0 && run.finite && static_cast<int>(costs.steps.size()) % countEvery == 0) {
      counter.look(state.positions, run);
    }
  }
  costs.addTo(run);
  return run;
}

}  // namespace drape::report::sections
