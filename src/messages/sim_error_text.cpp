#include "messages/sim_error_text.hpp"

#include "messages/sentence_error.hpp"
#include "sim/solvers/solver.hpp"

#include <fmt/core.h>

namespace drape::messages {
namespace {

using text::Sentence;

/// "the list of masses has 3 entries for a cloth of 4 vertices".
Sentence wrongCount(const sim::ClothModelError::Numbers& numbers, const Sentence& what, const Sentence& ofWhat) {
  return Sentence("the list of {} has {} entries for a cloth of {} {}", what, numbers.found, numbers.count, ofWhat);
}

std::string inSixDecimals(double value) {
  return fmt::format("{:f}", value);
}

}  // namespace

text::Sentence inWords(const sim::ClothModelError& error) {
  using Fault = sim::ClothModelError::Fault;
  const sim::ClothModelError::Numbers& numbers = error.numbers();
  switch (error.fault()) {
    case Fault::NoTriangle:
      return Sentence("a cloth needs at least one triangle; the mesh has {} vertices and {} triangles", numbers.count,
                      numbers.found);
    case Fault::VertexNotFinite:
      return Sentence("vertex {} of the mesh has a coordinate that is not a finite number", numbers.index);
    case Fault::NoSuchVertex:
      return Sentence("triangle {} names vertex {}, but the mesh has only {} (counted from 0)", numbers.index,
                      numbers.found, numbers.count);
    case Fault::NoSuchPin:
      return Sentence("vertex {} cannot be pinned: the cloth has only {} vertices (counted from 0)", numbers.index,
                      numbers.count);
    case Fault::Mass:
      return Sentence("the mass of a cloth must be positive and finite, not {} kg; set mass or density",
                      inSixDecimals(numbers.value));
    case Fault::VertexMass:
      return Sentence("vertex {} would have a mass of {} kg; it must be positive and finite", numbers.index,
                      inSixDecimals(numbers.value));
    case Fault::Stiffness:
      return Sentence("spring {} would have {} times the cloth's stiffness; it must be finite and not negative",
                      numbers.index, inSixDecimals(numbers.value));
    case Fault::MassCount:
      return wrongCount(numbers, Sentence("masses"), Sentence("vertices"));
    case Fault::StiffnessCount:
      return wrongCount(numbers, Sentence("stiffnesses"), Sentence("springs"));
    case Fault::PinCount:
      return wrongCount(numbers, Sentence("pins"), Sentence("vertices"));
    case Fault::ClothCount:
      return wrongCount(numbers, Sentence("numbers of cloths"), Sentence("vertices"));
    case Fault::Material:
      return Sentence(
          "the fabric is not stable: every stretch and shear modulus must be positive, no bending modulus negative, "
          "the bias bending at least a quarter of warp plus weft, and poisson between -1 and 1");
    case Fault::MaterialsMeet:
      return Sentence("vertex {} has triangles of different materials; only cloths that are not connected can differ",
                      numbers.index);
    case Fault::WarpCount:
      return wrongCount(numbers, Sentence("warp directions"), Sentence("triangles"));
    case Fault::PatternCount:
      return wrongCount(numbers, Sentence("pattern triangles"), Sentence("triangles"));
    case Fault::LengthCount:
      return wrongCount(numbers, Sentence("rest lengths"), Sentence("springs"));
    case Fault::AreaCount:
      return wrongCount(numbers, Sentence("areas"), Sentence("vertices"));
    case Fault::TooManySprings:
      return Sentence("a vertex of the cloth has more than {} springs", numbers.count);
  }
  return Sentence::verbatim(error.what());
}

text::Sentence takesSpringsOnly(std::string_view setting, std::string_view solver) {
  std::string names;
  for (const sim::SolverInfo& info : sim::solverTable()) {
    if (info.takesFabric) {
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
  }
  return Sentence("{} = {} knows springs only. With material.model = fabric choose one of: {}.", setting, solver,
                  names);
}

text::Sentence sentenceOf(const std::exception& error) {
  if (const auto* refusal = dynamic_cast<const SentenceError*>(&error)) {
    return refusal->sentence();
  }
  if (const auto* fault = dynamic_cast<const sim::ClothModelError*>(&error)) {
    return inWords(*fault);
  }
  if (const auto* unknown = dynamic_cast<const sim::UnknownSolver*>(&error)) {
    return Sentence("there is no solver '{}'", unknown->name());
  }
  if (const auto* solver = dynamic_cast<const sim::NoFabricSolver*>(&error)) {
    return takesSpringsOnly("solver", solver->name());
  }
  return Sentence(error.what());
}

std::string messageOf(const std::exception& error) {
  return sentenceOf(error).english();
}

}  // namespace drape::messages
