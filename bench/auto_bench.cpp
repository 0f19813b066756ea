// What auto spends on looking after itself: its steps against as many plain substeps of Verlet.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "sim/solver.hpp"
#include "sim/stability.hpp"

#include <cmath>

namespace drape::bench {
namespace {

/// Error estimates come once in so many steps.
constexpr int cycle = 64;

/// Just stable for Verlet: as many passes over the springs as the cloth needs, and no more allowed.
struct Task {
  ModelPtr model;
  StepParameters parameters;
  int passes = 0;

  explicit Task(ModelPtr cloth) : model(std::move(cloth)), parameters(stillAir()) {
    parameters.stiffness = 1000.0;
    parameters.precision = Precision::Float;
    parameters.errorTolerance = 1e-12;
    passes = static_cast<int>(std::ceil(parameters.timeStep / (0.9 * verletStepLimit(*model, parameters))));
    parameters.work = (passes + 0.5) * static_cast<double>(model->springs.size()) * 1e-6 / parameters.timeStep;
  }
};

Batch byAuto(ModelPtr model) {
  struct Run {
    Task task;
    ClothState state;
    std::unique_ptr<Solver> solver = findSolver("auto")->make();
  };
  auto run = std::make_shared<Run>(Run{Task(std::move(model)), {}});
  run->state = waving(*run->task.model);
  const auto advance = [run] {
    for (int i = 0; i < cycle; ++i) {
      run->solver->step(*run->task.model, run->task.parameters, {}, run->state);
    }
  };
  advance();  // in which estimates come more often
  return {cycle, [advance] { return threadSeconds(advance); }};
}

Batch byVerlet(ModelPtr model) {
  struct Run {
    Task task;
    ClothState state;
    std::unique_ptr<Solver> solver = findSolver("verlet")->make();
  };
  auto run = std::make_shared<Run>(Run{Task(std::move(model)), {}});
  run->state = waving(*run->task.model);
  run->task.parameters.timeStep /= run->task.passes;
  return {cycle, [run] {
            return threadSeconds([&] {
              for (int i = 0; i < cycle; ++i) {
                run->solver->steps(*run->task.model, run->task.parameters, {}, run->task.passes, run->state);
              }
            });
          }};
}

void addCloth(Suite& suite, const std::string& name, ModelPtr (*make)()) {
  const std::string own = name + ", auto";
  const std::string plain = name + ", its substeps alone";
  suite.add({"auto", own, "us/step"}, [make] { return byAuto(make()); });
  suite.add({"auto", plain, "us/step"}, [make] { return byVerlet(make()); });
  suite.addRatio(
      {"auto", name + ": auto / its substeps alone", "auto/" + own, "auto/" + plain, Bound{Bound::Side::AtMost, 1.1}});
}

}  // namespace

void addAutoGroup(Suite& suite) {
  addCloth(suite, "33x33", [] { return grid(33); });
  addCloth(suite, "65x65", [] { return grid(65); });
  addCloth(suite, "T-shirt", tshirt);
}

}  // namespace drape::bench
