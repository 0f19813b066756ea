#pragma once

#include "sim/solvers/solver_warning.hpp"
#include "text/sentence.hpp"

#include <string>

namespace drape::messages {

/// The warning as one or two sentences: what is wrong, and a remedy.
[[nodiscard]] text::Sentence inWords(const sim::SolverWarning& warning);

/// A short time as text: "1/240 s". The denominator is rounded up to three digits, so that the printed time is never
/// above the given one.
[[nodiscard]] std::string stepInWords(double seconds);

}  // namespace drape::messages
