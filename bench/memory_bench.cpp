// The memory of a cloth, and the time from the parsed mesh to the first step.
#include "bench/cloths.hpp"
#include "bench/heap.hpp"
#include "bench/suite.hpp"
#include "io/mesh_import.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/solvers/solver.hpp"

namespace drape::bench {
namespace {

constexpr int side = 317;  // 100,489 vertices

/// Memory that remains allocated after `make`, for each vertex [bytes].
template <typename Make>
double bytesPerVertex(int vertices, Make&& make) {
  const double before = heapInUse();
  const auto kept = make();
  return (heapInUse() - before) / vertices;
}

/// A solver after one step, which has allocated all its memory.
double solverBytes(const ModelPtr& model, const sim::StepParameters& parameters) {
  sim::ClothState state = waving(*model);
  return bytesPerVertex(model->vertexCount(), [&] {
    auto solver = sim::findSolver("one_iteration")->make();
    solver->step(*model, parameters, {}, state);
    return solver;
  });
}

void addMemory(Suite& suite) {
  const Bound bound{Bound::Side::AtMost, 200.0};
  const auto add = [&](const char* name, std::optional<Bound> limit, std::function<double()> find) {
    suite.addFigure({"memory", name, "bytes/vertex", limit}, std::move(find));
  };
  add("one_iteration, float, grid 317x317", bound, [] { return solverBytes(grid(side), fullStep()); });
  add("one_iteration, float, irregular sheet 317x317", bound,
      [] { return solverBytes(irregularSheet(side), fullStep()); });
  add("one_iteration, double, grid 317x317", std::nullopt, [] {
    sim::StepParameters parameters = fullStep();
    parameters.precision = sim::Precision::Double;
    return solverBytes(grid(side), parameters);
  });
  add("the mesh with its springs (ClothModel), grid 317x317", std::nullopt, [] {
    const sim::ClothMesh mesh = gridMesh(side);
    return bytesPerVertex(side * side, [&] { return sim::buildClothModel(mesh, 0.1, sim::MassLumping::Uniform, {}); });
  });
  add("the state in double", std::nullopt, [] {
    const ModelPtr model = grid(side);
    return bytesPerVertex(side * side, [&] { return waving(*model); });
  });
}

/// The stages from the parsed file to the first step, on the irregular sheet.
struct Stages {
  io::RawMesh raw;
  sim::ClothMesh mesh;
  ModelPtr model;
};

std::shared_ptr<Stages> stages() {
  auto result = std::make_shared<Stages>();
  result->mesh = irregularMesh(side);
  result->raw.positions = result->mesh.positions;
  result->raw.triangles = result->mesh.triangles;
  result->model = sim::buildClothModel(result->mesh, 0.1, sim::MassLumping::Area, {});
  return result;
}

void firstStep(const sim::ClothModel& model) {
  sim::ClothState state = sim::stateAtRest(model.restPositions);
  sim::findSolver("one_iteration")->make()->step(model, fullStep(), {}, state);
}

void addReadiness(Suite& suite) {
  const auto add = [&](const char* name, std::optional<Bound> bound, void (*work)(const Stages&)) {
    suite.add({"ready", name, "ms", bound}, [work]() -> Batch {
      return {1.0, [work, input = stages()] { return threadSeconds([&] { work(*input); }); }};
    });
  };
  add("weld and check, irregular 100,489 vertices", std::nullopt,
      [](const Stages& input) { static_cast<void>(io::weldMesh(input.raw, "sheet", {})); });
  add("springs and masses (buildClothModel)", std::nullopt, [](const Stages& input) {
    static_cast<void>(sim::buildClothModel(input.mesh, 0.1, sim::MassLumping::Area, {}));
  });
  add("layout for vector instructions (SlicedCloth)", std::nullopt,
      [](const Stages& input) { const sim::simd::SlicedCloth<float> cloth(*input.model); });
  add("layout and first step", std::nullopt, [](const Stages& input) { firstStep(*input.model); });
  add("all of it, from the parsed file to the first step", Bound{Bound::Side::AtMost, 1000.0}, [](const Stages& input) {
    const io::ImportedMesh mesh = io::weldMesh(input.raw, "sheet", {});
    firstStep(*sim::buildClothModel(mesh.cloth, 0.1, sim::MassLumping::Area, {}));
  });
}

}  // namespace

void addMemoryGroup(Suite& suite) {
  addMemory(suite);
  addReadiness(suite);
}

}  // namespace drape::bench
