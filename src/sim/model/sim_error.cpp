#include "sim/model/sim_error.hpp"

#include <array>

namespace drape::sim {
namespace {

/// In the order of ClothModelError::Fault.
constexpr std::array<std::string_view, 18> faultNames{
    "NoTriangle",    "VertexNotFinite", "NoSuchVertex",   "NoSuchPin",   "Mass",       "VertexMass",
    "Stiffness",     "MassCount",       "StiffnessCount", "PinCount",    "ClothCount", "Material",
    "MaterialsMeet", "WarpCount",       "PatternCount",   "LengthCount", "AreaCount",  "TooManySprings"};

std::string listed(ClothModelError::Fault fault, const ClothModelError::Numbers& numbers) {
  return "ClothModelError::" + std::string(faultNames[static_cast<std::size_t>(fault)]) +
         ", index=" + std::to_string(numbers.index) + ", found=" + std::to_string(numbers.found) +
         ", count=" + std::to_string(numbers.count) + ", value=" + std::to_string(numbers.value);
}

}  // namespace

ClothModelError::ClothModelError(Fault fault, const Numbers& numbers)
    : SimError(listed(fault, numbers)), fault_(fault), numbers_(numbers) {}

UnknownSolver::UnknownSolver(std::string_view name)
    : SimError("UnknownSolver, name=" + std::string(name)), name_(name) {}

NoFabricSolver::NoFabricSolver(std::string_view name)
    : SimError("NoFabricSolver, name=" + std::string(name)), name_(name) {}

}  // namespace drape::sim
