#include "messages/sim_error_text.hpp"

namespace drape {
namespace {

/// "the list of masses has 3 entries for a cloth of 4 vertices".
std::string wrongCount(const ClothModelError::Numbers& numbers, const std::string& what, const std::string& ofWhat) {
  return "the list of " + what + " has " + std::to_string(numbers.found) + " entries for a cloth of " +
         std::to_string(numbers.count) + " " + ofWhat;
}

std::string noTriangle(const ClothModelError::Numbers& numbers) {
  return "a cloth needs at least one triangle; the mesh has " + std::to_string(numbers.count) + " vertices and " +
         std::to_string(numbers.found) + " triangles";
}

std::string noSuchVertex(const ClothModelError::Numbers& numbers) {
  return "triangle " + std::to_string(numbers.index) + " names vertex " + std::to_string(numbers.found) +
         ", but the mesh has only " + std::to_string(numbers.count) + " (counted from 0)";
}

std::string noSuchPin(const ClothModelError::Numbers& numbers) {
  return "vertex " + std::to_string(numbers.index) + " cannot be pinned: the cloth has only " +
         std::to_string(numbers.count) + " vertices (counted from 0)";
}

}  // namespace

std::string inWords(const ClothModelError& error) {
  using Fault = ClothModelError::Fault;
  const ClothModelError::Numbers& numbers = error.numbers();
  switch (error.fault()) {
    case Fault::NoTriangle:
      return noTriangle(numbers);
    case Fault::VertexNotFinite:
      return "vertex " + std::to_string(numbers.index) + " of the mesh has a coordinate that is not a finite number";
    case Fault::NoSuchVertex:
      return noSuchVertex(numbers);
    case Fault::NoSuchPin:
      return noSuchPin(numbers);
    case Fault::Mass:
      return "the mass of a cloth must be positive and finite, not " + std::to_string(numbers.value) +
             " kg; set mass or density";
    case Fault::VertexMass:
      return "vertex " + std::to_string(numbers.index) + " would have a mass of " + std::to_string(numbers.value) +
             " kg; it must be positive and finite";
    case Fault::Stiffness:
      return "spring " + std::to_string(numbers.index) + " would have " + std::to_string(numbers.value) +
             " times the cloth's stiffness; it must be finite and not negative";
    case Fault::MassCount:
      return wrongCount(numbers, "masses", "vertices");
    case Fault::StiffnessCount:
      return wrongCount(numbers, "stiffnesses", "springs");
    case Fault::PinCount:
      return wrongCount(numbers, "pins", "vertices");
    case Fault::TooManySprings:
      return "a vertex of the cloth has more than " + std::to_string(numbers.count) + " springs";
  }
  return error.what();
}

std::string messageOf(const std::exception& error) {
  if (const auto* fault = dynamic_cast<const ClothModelError*>(&error)) {
    return inWords(*fault);
  }
  if (const auto* unknown = dynamic_cast<const UnknownSolver*>(&error)) {
    return "there is no solver '" + unknown->name() + "'";
  }
  return error.what();
}

}  // namespace drape
