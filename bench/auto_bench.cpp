// What auto spends on looking after itself: its steps against as many plain substeps of Verlet.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "sim/solver.hpp"
#include "sim/stability.hpp"

#include <cmath>

namespace drape::bench {
namespace {

/// Error estimates come once in so many steps.
constexpr int cycle = 128;

/// A cloth that begins to fall, with as many passes over the springs as Verlet needs, and no more allowed.
struct Task {
  ModelPtr model;
  StepParameters parameters;
  int passes = 0;

  Task(ModelPtr cloth, Precision precision) : model(std::move(cloth)), parameters(stillAir()) {
    parameters.stiffness = 1000.0;
    parameters.precision = precision;
    parameters.errorTolerance = 1e-12;
    passes = static_cast<int>(std::ceil(parameters.timeStep / (0.9 * verletStepLimit(*model, parameters))));
    parameters.work = (passes + 0.5) * static_cast<double>(model->springs.size()) * 1e-6 / parameters.timeStep;
  }
};

Batch byAuto(ModelPtr model, Precision precision) {
  struct Run {
    Task task;
    ClothState state;
    std::unique_ptr<Solver> solver = findSolver("auto")->make();
  };
  auto run = std::make_shared<Run>(Run{Task(std::move(model), precision), {}});
  run->state = stateAtRest(run->task.model->restPositions);
  const auto advance = [run] {
    for (int i = 0; i < cycle; ++i) {
      run->solver->step(*run->task.model, run->task.parameters, {}, run->state);
    }
  };
  advance();  // in which estimates come more often
  return {cycle, [advance] { return threadSeconds(advance); }};
}

Batch byVerlet(ModelPtr model, Precision precision) {
  struct Run {
    Task task;
    ClothState state;
    std::unique_ptr<Solver> solver = findSolver("verlet")->make();
  };
  auto run = std::make_shared<Run>(Run{Task(std::move(model), precision), {}});
  run->state = stateAtRest(run->task.model->restPositions);
  run->task.parameters.timeStep /= run->task.passes;
  return {cycle, [run] {
            return threadSeconds([&] {
              for (int i = 0; i < cycle; ++i) {
                run->solver->steps(*run->task.model, run->task.parameters, {}, run->task.passes, run->state);
              }
            });
          }};
}

void addCloth(Suite& suite, const std::string& name, Precision precision, ModelPtr (*make)()) {
  const std::string own = name + ", auto";
  const std::string plain = name + ", its substeps alone";
  suite.add({"auto", own, "us/step"}, [make, precision] { return byAuto(make(), precision); });
  suite.add({"auto", plain, "us/step"}, [make, precision] { return byVerlet(make(), precision); });
  suite.addRatio(
      {"auto", name + ": auto / its substeps alone", "auto/" + own, "auto/" + plain, Bound{Bound::Side::AtMost, 1.1}});
}

}  // namespace

void addAutoGroup(Suite& suite) {
  addCloth(suite, "33x33, float", Precision::Float, [] { return grid(33); });
  addCloth(suite, "33x33, double", Precision::Double, [] { return grid(33); });
  addCloth(suite, "65x65, float", Precision::Float, [] { return grid(65); });
  // In float auto would go over to double by itself here, because of rounding.
  addCloth(suite, "T-shirt, double", Precision::Double, tshirt);
}

}  // namespace drape::bench
