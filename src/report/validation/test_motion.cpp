#include "report/validation/test_motion.hpp"

#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::report::validation {
namespace {

constexpr double stepsOfPeriod = 100.0;

/// The number of substeps of half the stability limit of an explicit method, or of the paper's step if the method is
/// never stable. Other methods keep to the rule.
int substepsOf(const sim::ClothModel& model, const sim::SolverInfo& solver, const sim::StepParameters& parameters,
               SubstepRule rule) {
  constexpr double share = 0.5;
  constexpr double finest = 1.0 / 30000.0;  // [s]
  if (solver.stepLimit == nullptr) {
    const auto warning = rule == SubstepRule::OfWarning ? solver.warning(model, parameters) : std::nullopt;
    return std::max(parameters.substeps, warning ? static_cast<int>(warning->substeps) : 0);
  }
  const double limit = solver.stepLimit(model, parameters);
  const double longest = limit > 0.0 ? share * limit : finest;
  return std::max(parameters.substeps, static_cast<int>(std::ceil(parameters.timeStep / longest)));
}

/// The mean of vectors, weighted by mass.
Vec3 meanOf(const sim::ClothModel& model, const std::vector<Vec3>& vectors) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    sum += model.vertexMass[v] * vectors[v];
  }
  return sum / model.totalMass();
}

}  // namespace

TestMotion::TestMotion(std::shared_ptr<const sim::ClothModel> model, std::string_view solver,
                       const sim::StepParameters& parameters, const std::vector<Vec3>& start,
                       const std::stop_token& stop, SubstepRule rule)
    : model_(std::move(model)), parameters_(parameters), stepper_(solver), state_(sim::stateAtRest(start)) {
  parameters_.substeps = substepsOf(*model_, stepper_.info(), parameters, rule);
  inputs_.stop = stop;
}

void TestMotion::add(sim::contact::Body body) {
  bodies_.push_back(std::move(body));
  bodySteps_.clear();
  for (const sim::contact::Body& one : bodies_) {
    sim::contact::BodyStep still;
    still.body = &one;
    still.start = still.end = sim::contact::poseAt(one.motion, 0.0);
    still.surface = one.surface;
    bodySteps_.push_back(still);
  }
}

void TestMotion::step() {
  sim::checkStop(inputs_);
  inputs_.bodies = bodySteps_.empty() ? nullptr : &bodySteps_;
  stepper_.step(*model_, parameters_, inputs_, state_);
}

void TestMotion::run(double seconds) {
  const auto steps = std::lround(seconds / parameters_.timeStep);
  for (long i = 0; i < steps; ++i) {
    step();
  }
}

Vec3 TestMotion::centre() const {
  return meanOf(*model_, state_.positions);
}

Vec3 TestMotion::velocity() const {
  return meanOf(*model_, state_.velocities);
}

double frequencyOf(const Oscillation& oscillation, std::string_view solver, const std::stop_token& stop,
                   SubstepRule rule) {
  sim::StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.timeStep = oscillation.period / stepsOfPeriod;
  std::vector<Vec3> start = oscillation.equilibrium;
  for (std::size_t v = 0; v < start.size(); ++v) {
    start[v] += oscillation.shape[v];
  }
  TestMotion motion(oscillation.model, solver, parameters, start, stop, rule);
  const auto projection = [&] {
    double sum = 0.0;
    for (std::size_t v = 0; v < start.size(); ++v) {
      sum += oscillation.model->vertexMass[v] *
             oscillation.shape[v].dot(motion.state().positions[v] - oscillation.equilibrium[v]);
    }
    return sum;
  };
  std::vector<double> zeros;  // [s]
  double before = projection();
  constexpr int maxSteps = static_cast<int>(2.0 * stepsOfPeriod);
  for (int i = 0; i < maxSteps && zeros.size() < 3; ++i) {
    motion.step();
    const double now = projection();
    if ((before > 0.0) != (now > 0.0)) {
      zeros.push_back((i + before / (before - now)) * parameters.timeStep);
    }
    before = now;
  }
  return zeros.size() < 3 ? std::numeric_limits<double>::quiet_NaN() : 1.0 / (zeros[2] - zeros[0]);
}

}  // namespace drape::report::validation
