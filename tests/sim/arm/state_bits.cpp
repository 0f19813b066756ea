// Prints a hash of the final state of two cloths for each method, one a line. It must be the same on every processor
// with fused multiply-add. scripts/check-arm compares Arm with the machine that it runs on.
#include "sim/solvers/solver.hpp"
#include "simd/simd_meshes.hpp"
#include "test_meshes.hpp"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace drape::sim {
namespace {

struct Method {
  std::string solver;
  Precision precision;
  int sweeps;
};

std::string hashAfter(const ClothModel& model, const Method& method) {
  constexpr int steps = 20;
  StepParameters parameters = testing::windyStep();
  parameters.jacobi.sweeps = method.sweeps;
  parameters.precision = method.precision;
  ClothState state = testing::shaken(model, 0.003, 3);
  findSolver(method.solver)->make()->steps(model, parameters, {}, steps, state);
  return toHex(stateHash(state));
}

void printHashes(const std::string& cloth, const ClothModel& model) {
  std::vector<Method> methods;
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    methods.push_back({"one_iteration", precision, 1});
    methods.push_back({"one_iteration", precision, 3});
    for (const char* solver : {"chebyshev", "pcg", "verlet", "explicit_euler", "xpbd", "auto"}) {
      methods.push_back({solver, precision, 1});
    }
  }
  for (const Method& method : methods) {
    std::cout << cloth << ' ' << method.solver << ' ' << (method.precision == Precision::Float ? "float" : "double")
              << ' ' << method.sweeps << ": " << hashAfter(model, method) << '\n';
  }
}

}  // namespace
}  // namespace drape::sim

int main() {
  drape::sim::printHashes("grid", *drape::sim::testing::pinnedCloth(drape::sim::testing::sheet(15)));
  drape::sim::printHashes("irregular", *drape::sim::testing::pinnedCloth(drape::sim::testing::renumbered(
                                           drape::sim::testing::unevenSheet(13, 3), 4)));
}
