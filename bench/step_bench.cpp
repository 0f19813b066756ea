// The cost of a step of each method on a sheet of 33 x 33 vertices and 3136 springs, also relative to an iteration of
// XPBD on the same springs; and of a fabric relative to springs.
#include "bench/plain_xpbd.hpp"
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/simd/constraint_lanes.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <string_view>

namespace drape::bench {
namespace {

constexpr int sheet = 33;
constexpr int batch = 50;

template <typename T>
Batch sliced(Method method, const sim::StepParameters& parameters) {
  auto runner = std::make_shared<SliceRunner<T>>(grid(sheet), method, parameters);
  return {batch, [runner] { return batchSeconds(*runner, batch); }};
}

/// The sheet as a fabric. @param bending stiffness in all directions [N m]
ModelPtr fabricGrid(double bending) {
  const ModelPtr springs = grid(sheet);
  sim::fabric::Material material;
  material.stretchWarp = material.stretchWeft = 10.0;
  material.shear = 3.0;
  material.bendWarp = material.bendWeft = material.bendBias = bending;
  return sim::fabric::withFabric(*springs, material,
                                 sim::fabric::warpAlong(Vec3::UnitX(), springs->restPositions, springs->triangles));
}

Batch fabricPass(double bending, const sim::StepParameters& parameters) {
  auto runner = std::make_shared<SliceRunner<float>>(fabricGrid(bending), Method::Verlet, parameters);
  return {batch, [runner] { return batchSeconds(*runner, batch); }};
}

/// Explicit methods need a shorter step than the others.
sim::StepParameters explicitly(sim::StepParameters parameters) {
  parameters.timeStep /= 10.0;
  return parameters;
}

sim::StepParameters threeSweeps() {
  sim::StepParameters parameters = fullStep();
  parameters.jacobi.sweeps = 3;
  return parameters;
}

/// Steps of a solver including the conversion from and to the state in double.
Batch ofSolver(std::string_view name, const sim::StepParameters& parameters, int count) {
  struct Run {
    ModelPtr model;
    sim::StepParameters parameters;
    sim::ClothState start;
    std::unique_ptr<sim::Solver> solver;
  };
  const ModelPtr model = grid(sheet);
  auto run = std::make_shared<Run>(Run{model, parameters, waving(*model), sim::findSolver(name)->make()});
  return {static_cast<double>(count), [run, count] {
            sim::ClothState state = run->start;
            return threadSeconds([&] { run->solver->steps(*run->model, run->parameters, {}, count, state); });
          }};
}

void addKernels(Suite& suite) {
  const auto add = [&](const char* name, std::function<Batch()> make) {
    suite.add({"step", name, "us/step"}, std::move(make));
  };
  add("full step, float", [] { return sliced<float>(Method::OneIteration, fullStep()); });
  add("without air and damping, float", [] { return sliced<float>(Method::OneIteration, stillAir()); });
  add("full step, double", [] { return sliced<double>(Method::OneIteration, fullStep()); });
  add("full step, 3 sweeps, float", [] { return sliced<float>(Method::OneIteration, threeSweeps()); });
  add("Verlet, full", [] { return sliced<float>(Method::Verlet, explicitly(fullStep())); });
  add("Verlet, without air and damping", [] { return sliced<float>(Method::Verlet, explicitly(stillAir())); });
  add("Verlet, membrane, without air and damping", [] { return fabricPass(0.0, explicitly(stillAir())); });
  add("Verlet, membrane and bending, without air and damping", [] { return fabricPass(1e-6, explicitly(stillAir())); });
}

void addConstraints(Suite& suite) {
  const sim::StepParameters parameters = stillAir();
  const auto inverseCompliance =
      static_cast<float>(parameters.timeStep * parameters.timeStep * parameters.material.stiffness);  // h^2 k [kg]
  suite.add({"step", "XPBD, plain", "us/iteration"}, [inverseCompliance]() -> Batch {
    const ModelPtr model = grid(sheet);
    auto xpbd = std::make_shared<PlainXpbd>(*model);
    return {batch, [=, start = waving(*model)] {
              xpbd->load(*model, start);
              return threadSeconds([&] {
                for (int i = 0; i < batch; ++i) {
                  xpbd->iterate(inverseCompliance);
                }
              });
            }};
  });
  suite.add({"step", "XPBD, SIMD", "us/iteration"}, [inverseCompliance]() -> Batch {
    const ModelPtr model = grid(sheet);
    auto lanes = std::make_shared<sim::simd::ConstraintLanes>(*model);
    return {batch, [=, start = waving(*model)] {
              sim::simd::loadVertices(*model, start, *lanes, {0, lanes->vertexCount()});
              return threadSeconds([&] {
                for (int i = 0; i < batch; ++i) {
                  for (int c = 0; c < lanes->colours(); ++c) {
                    const auto colour = lanes->colourBegin.begin() + c;
                    sim::simd::projectSprings(*lanes, inverseCompliance, i == 0, {colour[0], colour[1]});
                  }
                }
              });
            }};
  });
}

void addSolvers(Suite& suite) {
  suite.add({"step", "one_iteration by the solver, 50 at once", "us/step"},
            [] { return ofSolver("one_iteration", fullStep(), batch); });
  suite.add({"step", "one_iteration by the solver, one by one", "us/step"},
            [] { return ofSolver("one_iteration", fullStep(), 1); });
  for (const sim::SolverInfo& info : sim::solverTable()) {
    if (info.name == "one_iteration") {
      continue;
    }
    sim::StepParameters parameters = info.backwardEuler ? fullStep() : explicitly(fullStep());
    std::string label(info.name);
    if (info.name == "pcg") {
      parameters.iteration.tolerance = 1e-3;
      label += ", to 1e-3";
    } else if (info.name == "chebyshev") {
      parameters.iteration.iterations = 5;
      label += ", 5 iterations";
    } else if (std::find(info.settings.begin(), info.settings.end(), "iterations") != info.settings.end()) {
      label += ", " + std::to_string(parameters.iteration.iterations) + " iterations";
    }
    const bool fast = info.name == "verlet" || info.name == "chebyshev";
    const int count = fast ? batch : info.name == "newton" ? 1 : 4;
    suite.add({"step", label, "us/step"},
              [name = info.name, parameters, count] { return ofSolver(name, parameters, count); });
  }
}

}  // namespace

void addStepGroup(Suite& suite) {
  addKernels(suite);
  addConstraints(suite);
  addSolvers(suite);
  using Side = Bound::Side;
  const auto ratio = [&](const char* name, const char* over, const char* under, std::optional<Bound> bound) {
    suite.addRatio({"step", name, std::string("step/") + over, std::string("step/") + under, bound});
  };
  ratio("full step / XPBD, plain", "full step, float", "XPBD, plain", Bound{Side::AtMost, 0.5});
  ratio("full step / XPBD, SIMD", "full step, float", "XPBD, SIMD", Bound{Side::AtMost, 1.5});
  ratio("Verlet / full step", "Verlet, full", "full step, float", Bound{Side::AtMost, 0.45});
  ratio("Verlet / full step, both without air and damping", "Verlet, without air and damping",
        "without air and damping, float", Bound{Side::AtMost, 0.45});
  ratio("membrane / springs", "Verlet, membrane, without air and damping", "Verlet, without air and damping",
        Bound{Side::AtMost, 1.3});
  ratio("membrane and bending / springs", "Verlet, membrane and bending, without air and damping",
        "Verlet, without air and damping", Bound{Side::AtMost, 2.2});
  ratio("double / float", "full step, double", "full step, float", std::nullopt);
}

}  // namespace drape::bench
