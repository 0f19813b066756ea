#include "messages/sim_error_text.hpp"

#include "sim/solvers/solver.hpp"

#include <fmt/core.h>

namespace drape::messages {
namespace {

/// "the list of masses has 3 entries for a cloth of 4 vertices".
std::string wrongCount(const sim::ClothModelError::Numbers& numbers, const std::string& what,
                       const std::string& ofWhat) {
  return fmt::format("the list of {} has {} entries for a cloth of {} {}", what, numbers.found, numbers.count, ofWhat);
}

}  // namespace

std::string inWords(const sim::ClothModelError& error) {
  using Fault = sim::ClothModelError::Fault;
  const sim::ClothModelError::Numbers& numbers = error.numbers();
  switch (error.fault()) {
    case Fault::NoTriangle:
      return fmt::format("a cloth needs at least one triangle; the mesh has {} vertices and {} triangles",
                         numbers.count, numbers.found);
    case Fault::VertexNotFinite:
      return fmt::format("vertex {} of the mesh has a coordinate that is not a finite number", numbers.index);
    case Fault::NoSuchVertex:
      return fmt::format("triangle {} names vertex {}, but the mesh has only {} (counted from 0)", numbers.index,
                         numbers.found, numbers.count);
    case Fault::NoSuchPin:
      return fmt::format("vertex {} cannot be pinned: the cloth has only {} vertices (counted from 0)", numbers.index,
                         numbers.count);
    case Fault::Mass:
      return fmt::format("the mass of a cloth must be positive and finite, not {:f} kg; set mass or density",
                         numbers.value);
    case Fault::VertexMass:
      return fmt::format("vertex {} would have a mass of {:f} kg; it must be positive and finite", numbers.index,
                         numbers.value);
    case Fault::Stiffness:
      return fmt::format("spring {} would have {:f} times the cloth's stiffness; it must be finite and not negative",
                         numbers.index, numbers.value);
    case Fault::MassCount:
      return wrongCount(numbers, "masses", "vertices");
    case Fault::StiffnessCount:
      return wrongCount(numbers, "stiffnesses", "springs");
    case Fault::PinCount:
      return wrongCount(numbers, "pins", "vertices");
    case Fault::ClothCount:
      return wrongCount(numbers, "numbers of cloths", "vertices");
    case Fault::Material:
      return "the fabric is not stable: every stretch and shear modulus must be positive, no bending modulus negative, "
             "the bias bending at least a quarter of warp plus weft, and poisson between -1 and 1";
    case Fault::MaterialsMeet:
      return fmt::format(
          "vertex {} has triangles of different materials; only cloths that are not connected can differ",
          numbers.index);
    case Fault::WarpCount:
      return wrongCount(numbers, "warp directions", "triangles");
    case Fault::PatternCount:
      return wrongCount(numbers, "pattern triangles", "triangles");
    case Fault::LengthCount:
      return wrongCount(numbers, "rest lengths", "springs");
    case Fault::AreaCount:
      return wrongCount(numbers, "areas", "vertices");
    case Fault::TooManySprings:
      return fmt::format("a vertex of the cloth has more than {} springs", numbers.count);
  }
  return error.what();
}

std::string takesSpringsOnly(std::string_view setting, std::string_view solver) {
  std::string names;
  for (const sim::SolverInfo& info : sim::solverTable()) {
    if (info.takesFabric) {
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
  }
  return fmt::format("{} = {} knows springs only. With material.model = fabric choose one of: {}.", setting, solver,
                     names);
}

std::string messageOf(const std::exception& error) {
  if (const auto* fault = dynamic_cast<const sim::ClothModelError*>(&error)) {
    return inWords(*fault);
  }
  if (const auto* unknown = dynamic_cast<const sim::UnknownSolver*>(&error)) {
    return "there is no solver '" + unknown->name() + "'";
  }
  if (const auto* solver = dynamic_cast<const sim::NoFabricSolver*>(&error)) {
    return takesSpringsOnly("solver", solver->name());
  }
  return error.what();
}

}  // namespace drape::messages
