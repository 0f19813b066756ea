// The cost of the energy guard, the error estimates and the coarse levels of `auto`: its steps compared with the same
// number of plain substeps of Verlet.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/forces/stability.hpp"
#include "sim/solvers/solver.hpp"

#include <cmath>

namespace drape::bench {
namespace {

/// Number of steps between two error estimates.
constexpr int cycle = 128;

/// A cloth that starts to fall, with a budget of as many force evaluations as Verlet needs.
struct Task {
  ModelPtr model;
  sim::StepParameters parameters;
  int evaluations = 0;

  Task(ModelPtr cloth, sim::Precision precision) : model(std::move(cloth)), parameters(stillAir()) {
    parameters.material.stiffness = 1000.0;
    parameters.precision = precision;
    parameters.automatic.errorTolerance = 1e-12;
    evaluations = static_cast<int>(std::ceil(parameters.timeStep / (0.9 * sim::verletStepLimit(*model, parameters))));
    parameters.automatic.costBudget =
        (evaluations + 0.5) * static_cast<double>(model->springs.size()) * 1e-6 / parameters.timeStep;
  }
};

Batch byAuto(Task task) {
  struct Run {
    Task task;
    sim::ClothState state;
    std::unique_ptr<sim::Solver> solver = sim::findSolver("auto")->make();
  };
  auto run = std::make_shared<Run>(Run{std::move(task), {}});
  run->state = sim::stateAtRest(run->task.model->restPositions);
  const auto advance = [run] {
    for (int i = 0; i < cycle; ++i) {
      run->solver->step(*run->task.model, run->task.parameters, {}, run->state);
    }
  };
  advance();  // the first steps, in which estimates are more frequent
  return {cycle, [advance] { return threadSeconds(advance); }};
}

Batch byVerlet(Task task) {
  struct Run {
    Task task;
    sim::ClothState state;
    std::unique_ptr<sim::Solver> solver = sim::findSolver("verlet")->make();
  };
  auto run = std::make_shared<Run>(Run{std::move(task), {}});
  run->state = sim::stateAtRest(run->task.model->restPositions);
  run->task.parameters.timeStep /= run->task.evaluations;
  return {cycle, [run] {
            return threadSeconds([&] {
              for (int i = 0; i < cycle; ++i) {
                run->solver->steps(*run->task.model, run->task.parameters, {}, run->task.evaluations, run->state);
              }
            });
          }};
}

void addCloth(Suite& suite, const std::string& name, sim::Precision precision, ModelPtr (*make)()) {
  const std::string own = name + ", auto";
  const std::string plain = name + ", its substeps alone";
  suite.add({"auto", own, "us/step"}, [make, precision] { return byAuto(Task(make(), precision)); });
  suite.add({"auto", plain, "us/step"}, [make, precision] { return byVerlet(Task(make(), precision)); });
  suite.addRatio(
      {"auto", name + ": auto / its substeps alone", "auto/" + own, "auto/" + plain, Bound{Bound::Side::AtMost, 1.1}});
}

/// Ten substeps a step, with clamped springs and coarse levels.
void addLevels(Suite& suite, const std::string& name, int resolution) {
  constexpr int substeps = 10;
  const auto softened = [resolution] {
    Task task(grid(resolution), sim::Precision::Float);
    task.parameters.material.stiffness = 1e5;
    task.parameters.automatic.soften = true;
    task.evaluations = substeps;
    task.parameters.automatic.costBudget = (sim::adaptive::costWithLevels * substeps + 0.5) *
                                           static_cast<double>(task.model->springs.size()) * 1e-6 /
                                           task.parameters.timeStep;
    return task;
  };
  const auto plain = [resolution] {
    Task task(grid(resolution), sim::Precision::Float);
    task.parameters.material.stiffness = 10.0;  // stable with ten substeps; an evaluation costs the same
    task.evaluations = substeps;
    return task;
  };
  const std::string own = name + ", 10 with levels";
  const std::string others = name + ", 10 plain substeps";
  suite.add({"auto", own, "us/step"}, [softened] { return byAuto(softened()); });
  suite.add({"auto", others, "us/step"}, [plain] { return byVerlet(plain()); });
  suite.addRatio({"auto", name + ": with levels / plain", "auto/" + own, "auto/" + others});
}

}  // namespace

void addAutoGroup(Suite& suite) {
  addCloth(suite, "33x33, float", sim::Precision::Float, [] { return grid(33); });
  addCloth(suite, "33x33, double", sim::Precision::Double, [] { return grid(33); });
  addCloth(suite, "65x65, float", sim::Precision::Float, [] { return grid(65); });
  addLevels(suite, "33x33, 1e5 N/m", 33);
  // With float, auto would use double here because of rounding.
  addCloth(suite, "T-shirt, double", sim::Precision::Double, tshirt);
}

}  // namespace drape::bench
