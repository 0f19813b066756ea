#pragma once

#include "report/validation/validation_case.hpp"

/// The functions of the validation cases, grouped by file. The table of case_table.cpp lists them.
namespace drape::report::validation {

// membrane_cases.cpp
[[nodiscard]] Comparison endLoadModulus(const CaseMesh& mesh);
[[nodiscard]] Comparison endLoadPoisson(const CaseMesh& mesh);
[[nodiscard]] Comparison ownWeight(const CaseMesh& mesh);
[[nodiscard]] Comparison pictureFrame(const CaseMesh& mesh);
[[nodiscard]] Comparison biasExtension(const CaseMesh& mesh);
[[nodiscard]] Comparison hangingStrip(const CaseMesh& mesh);

// bending_cases.cpp
[[nodiscard]] Comparison heavyElasticaSmall(const CaseMesh& mesh);
[[nodiscard]] Comparison heavyElasticaMedium(const CaseMesh& mesh);
[[nodiscard]] Comparison heavyElasticaLarge(const CaseMesh& mesh);
[[nodiscard]] Comparison heavyElasticaHanging(const CaseMesh& mesh);
[[nodiscard]] Comparison peirceWarp(const CaseMesh& mesh);  // the subject is a preset
[[nodiscard]] Comparison peirceWeft(const CaseMesh& mesh);
[[nodiscard]] Comparison buckling(const CaseMesh& mesh);
[[nodiscard]] Comparison twist(const CaseMesh& mesh);

// strip_cases.cpp
[[nodiscard]] Comparison lateralBuckling(const CaseMesh& mesh);
[[nodiscard]] Comparison stickSlip(const CaseMesh& mesh);

// frequency_cases.cpp; the subject is a solver
[[nodiscard]] Comparison membraneMode11(const CaseMesh& mesh);
[[nodiscard]] Comparison membraneMode22(const CaseMesh& mesh);
[[nodiscard]] Comparison stripMode(const CaseMesh& mesh);
[[nodiscard]] Comparison substeppedStripMode(const CaseMesh& mesh);  // with the substeps of the solver's warning

// motion_cases.cpp; the subject is a solver
[[nodiscard]] Comparison inclineSticks(const CaseMesh& mesh);
[[nodiscard]] Comparison inclineSlides(const CaseMesh& mesh);
[[nodiscard]] Comparison terminalVelocity(const CaseMesh& mesh);
[[nodiscard]] Comparison fallDistance(const CaseMesh& mesh);
[[nodiscard]] Comparison froudeOfTumbling(const CaseMesh& mesh);

// drape_cases.cpp; the subject is a preset
[[nodiscard]] Comparison cusick(const CaseMesh& mesh);
[[nodiscard]] Comparison remeshedDisc(const CaseMesh& mesh);
[[nodiscard]] Comparison remeshedCape(const CaseMesh& mesh);

// garment_cases.cpp; the subject is a preset
[[nodiscard]] Comparison remeshedSkirt(const CaseMesh& mesh);

}  // namespace drape::report::validation
