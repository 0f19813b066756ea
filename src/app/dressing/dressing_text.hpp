#pragma once

#include "dressing/dressing.hpp"
#include "dressing/piercing.hpp"
#include "scene/scene.hpp"
#include "text/sentence.hpp"

#include <string>
#include <vector>

namespace drape::app {

/// "the right arm passes through the sleeve's wall (35 pairs of triangles)".
[[nodiscard]] text::Sentence inWords(const dressing::Fault& fault);

/// All of them in one sentence, without a full stop; empty if there are none.
[[nodiscard]] text::Sentence inWords(const std::vector<dressing::Fault>& faults);

/// "12 pairs of triangles with the body and none of the garment with itself", or "no triangles".
[[nodiscard]] text::Sentence inWords(const dressing::Pairs& pairs);

/// How the garment was placed: "placed by neck, sleeves or waist".
[[nodiscard]] text::Sentence inWords(dressing::PlacementRule rule);

/// What dressing does at the moment: "growing the body".
[[nodiscard]] text::Sentence inWords(dressing::Stage stage);

/// A body that passes through the cloth: "The right arm passes through the sleeve's wall: 35 pairs of triangles".
[[nodiscard]] text::Sentence inWords(const dressing::Piercing& piercing, const scene::Scene& scene);

/// Several of them; the first one in full. Without a full stop. @param piercings at least one
[[nodiscard]] text::Sentence inWords(const std::vector<dressing::Piercing>& piercings, const scene::Scene& scene);

/// How a garment that can be worn was placed, and the intersections before and after: "placed as in its file; 12 pairs
/// of triangles ... intersected there, and no triangles at the end".
/// @param isByHand whether the user had placed it, and dressing left it there
[[nodiscard]] text::Sentence summaryOf(const dressing::Dressed& result, bool isByHand = false);

/// Why a garment cannot be worn, in whole sentences. @param garment its name
[[nodiscard]] text::Sentence refusalOf(const dressing::Dressed& result, const text::Sentence& garment);

/// The names of a garment and a body for messages.
struct WearNames {
  text::Sentence garment;  ///< inside a sentence: the name of its file, or "the cloth"
  std::string body;
};

/// Throws InputError if the meshes cannot be dressed: says why and what to do. @param garment, body in the scene [m]
void requireDressable(const WearNames& names, const sim::ClothMesh& garment, const sim::ClothMesh& body);

/// What is wrong and what to do. Empty for Misfit::None.
/// @param garment, body their names  @param garmentSide, bodySide their largest extents [m]
[[nodiscard]] text::Sentence inWords(dressing::Misfit misfit, const text::Sentence& garment, const std::string& body,
                                     double garmentSide, double bodySide);

}  // namespace drape::app
