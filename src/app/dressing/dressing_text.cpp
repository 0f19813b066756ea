#include "app/dressing/dressing_text.hpp"

#include "messages/error.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/bounds.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace drape::app {
namespace {

using dressing::BodyPart;
using text::Sentence;

/// The part as the subject of a sentence.
Sentence nameOf(BodyPart part) {
  switch (part) {
    case BodyPart::Head:
      return Sentence("the head");
    case BodyPart::Trunk:
      return Sentence("the trunk");
    case BodyPart::LeftArm:
      return Sentence("the left arm");
    case BodyPart::RightArm:
      return Sentence("the right arm");
    case BodyPart::LeftLeg:
      return Sentence("the left leg");
    case BodyPart::RightLeg:
      return Sentence("the right leg");
    case BodyPart::Whole:
      break;
  }
  return Sentence("the body");
}

/// The same at the start of a sentence.
Sentence capitalisedNameOf(BodyPart part) {
  switch (part) {
    case BodyPart::Head:
      return Sentence("The head");
    case BodyPart::Trunk:
      return Sentence("The trunk");
    case BodyPart::LeftArm:
      return Sentence("The left arm");
    case BodyPart::RightArm:
      return Sentence("The right arm");
    case BodyPart::LeftLeg:
      return Sentence("The left leg");
    case BodyPart::RightLeg:
      return Sentence("The right leg");
    case BodyPart::Whole:
      break;
  }
  return Sentence("The body");
}

Sentence wallOf(const dressing::Fault& fault) {
  return Sentence(fault.atSleeve ? "the sleeve's wall" : "the garment");
}

bool isInside(const dressing::Dressed& result) {
  return !result.faults.empty() && result.faults.front().kind == dressing::FaultKind::InsideBody;
}

/// What a garment lacks that is closed where head and arms come out.
Sentence adviceOnOpenings(const dressing::Dressed& result) {
  if (isInside(result)) {
    return Sentence("It is too small for this body; is the unit of both files right?");
  }
  if (result.openings > 1) {
    return {};
  }
  return Sentence(
      result.openings == 0
          ? "It has no opening for neck, arms, waist and legs; is it closed where it should be open?"
          : "It has only one opening for neck, arms, waist and legs; is it closed where it should be open?");
}

Sentence pairsText(std::size_t pairs) {
  return Sentence(text::plural(static_cast<long long>(pairs), "{} pair of triangles", "{} pairs of triangles"), pairs);
}

/// @param subject the part of the body
Sentence faultOf(const dressing::Fault& fault, const Sentence& subject) {
  if (fault.kind == dressing::FaultKind::InsideBody) {
    return Sentence("the garment is inside the body");
  }
  if (fault.kind == dressing::FaultKind::MissesOpening) {
    return Sentence(dressing::isSleeve(fault.opening) ? "{} does not pass through the opening of its sleeve"
                    : dressing::isLeg(fault.opening)  ? "{} does not pass through the opening of its trouser leg"
                    : fault.opening == dressing::OpeningKind::Waist
                        ? "{} does not pass through the waist of the garment"
                        : "{} does not pass through the neck of the garment",
                    subject);
  }
  return Sentence("{} passes through {} ({})", subject, wallOf(fault), pairsText(fault.pairs));
}

}  // namespace

Sentence inWords(const dressing::Fault& fault) {
  return faultOf(fault, nameOf(fault.part));
}

Sentence inWords(const std::vector<dressing::Fault>& faults) {
  Sentence words;
  for (const dressing::Fault& fault : faults) {
    words.append(", ", inWords(fault));
  }
  return words;
}

Sentence inWords(const dressing::Pairs& pairs) {
  if (pairs.all() == 0) {
    return Sentence("no triangles");
  }
  return Sentence("{} of the garment with the body and {} with itself", pairsText(pairs.body), pairs.self);
}

Sentence inWords(dressing::PlacementRule rule) {
  switch (rule) {
    case dressing::PlacementRule::Landmarks:
      return Sentence("placed by neck, sleeves or waist");
    case dressing::PlacementRule::Boxes:
      return Sentence("placed by its size");
    case dressing::PlacementRule::Auto:
    case dressing::PlacementRule::File:
      break;
  }
  return Sentence("placed as in its file");
}

Sentence inWords(dressing::Stage stage) {
  switch (stage) {
    case dressing::Stage::Shrinking:
      return Sentence("shrinking the body");
    case dressing::Stage::Placing:
      return Sentence("placing the garment");
    case dressing::Stage::Growing:
      return Sentence("growing the body");
    case dressing::Stage::Settling:
      break;
  }
  return Sentence("settling the garment");
}

Sentence inWords(const dressing::Piercing& piercing, const scene::Scene& scene) {
  if (piercing.faults.size() == 1 && piercing.faults.front().part == BodyPart::Whole) {
    const Vec3& at = piercing.centre;
    return Sentence("The body '{}' passes through the cloth near {} m: {}", (*scene.bodies)[piercing.body].name,
                    fmt::format("({:.2f}, {:.2f}, {:.2f})", at.x(), at.y(), at.z()), pairsText(piercing.pairs));
  }
  if (piercing.faults.size() == 1) {
    const dressing::Fault& fault = piercing.faults.front();
    return Sentence("{} passes through {}: {}", capitalisedNameOf(fault.part), wallOf(fault), pairsText(fault.pairs));
  }
  constexpr std::size_t longestList = 2;
  const std::size_t named = std::min(longestList, piercing.faults.size());
  const std::size_t others = piercing.faults.size() - named;
  Sentence words;
  for (std::size_t i = 0; i < named; ++i) {
    const dressing::Fault& fault = piercing.faults[i];
    words.append(", ", faultOf(fault, i == 0 ? capitalisedNameOf(fault.part) : nameOf(fault.part)));
  }
  if (others > 0) {
    words.append(", ", Sentence(text::plural(static_cast<long long>(others), "and so does {} other part",
                                             "and so do {} other parts"),
                                others));
  }
  return words;
}

Sentence inWords(const std::vector<dressing::Piercing>& piercings, const scene::Scene& scene) {
  Sentence words = inWords(piercings.front(), scene);
  if (const std::size_t others = piercings.size() - 1; others > 0) {
    words.append("; ",
                 Sentence(text::plural(static_cast<long long>(others), "{} other body passes through the cloth too",
                                       "{} other bodies pass through the cloth too"),
                          others));
  }
  return words;
}

Sentence summaryOf(const dressing::Dressed& result, bool isByHand) {
  const Sentence place = isByHand && result.placement.rule == dressing::PlacementRule::File
                             ? Sentence("from where you placed it")
                             : inWords(result.placement.rule);
  Sentence words("{}; {} intersected there, and {} at the end", place, inWords(result.before), inWords(result.after));
  words.append(": ", inWords(result.faults));
  if (result.stretch > sim::tooTight) {
    words.append("; ",
                 Sentence("where it is tightest the garment is stretched by {} %, so it is too small or its unit is "
                          "another one",
                          static_cast<int>(std::lround(100.0 * result.stretch))));
  }
  if (result.isOpenCape) {
    words.append("; ", Sentence("its neckline is open: pin or sew its ends together, or it may slide off"));
  }
  return result.filledHoles > 0
             ? words.append("; ", Sentence("holes of the body that were filled: {}", result.filledHoles))
             : words;
}

Sentence refusalOf(const dressing::Dressed& result, const Sentence& garment) {
  Sentence words("The body cannot wear {}: even where the body is a thin line, {}.", garment, inWords(result.faults));
  return words.append(" ", adviceOnOpenings(result));
}

void requireDressable(const WearNames& names, const sim::ClothMesh& garment, const sim::ClothMesh& body) {
  constexpr std::size_t maxTriangles = io::maxMovingTriangles;
  if (body.triangles.size() > maxTriangles) {
    throw messages::InputError(fmt::format("{}: the body has {} triangles, and the limit is {}. Reduce the mesh first",
                                           names.body, body.triangles.size(), maxTriangles));
  }
  const auto side = [](const std::vector<Vec3>& positions) { return sim::boundsOf(positions).sizes().maxCoeff(); };
  const dressing::Misfit misfit = dressing::misfitOf(garment, body);
  if (misfit != dressing::Misfit::None) {
    throw messages::InputError(
        inWords(misfit, names.garment, names.body, side(garment.positions), side(body.positions)).english());
  }
}

Sentence inWords(dressing::Misfit misfit, const Sentence& garment, const std::string& body, double garmentSide,
                 double bodySide) {
  switch (misfit) {
    case dressing::Misfit::OpenBody:
      return Sentence("{}: the body has holes that are too large to be filled, so it has no inside. Close them first",
                      body);
    case dressing::Misfit::NoVolume:
      return Sentence("{}: the body has no volume, or its triangles are inside out. Turn its faces outwards first",
                      body);
    case dressing::Misfit::GarmentTooLarge:
    case dressing::Misfit::GarmentTooSmall:
      return Sentence(
          "The body cannot wear {}: it is {} long, and the body {}. Give the unit of the garment "
          "(--set unit=cm) or --scale",
          garment, text::formatLength(garmentSide), text::formatLength(bodySide));
    case dressing::Misfit::None:
      break;
  }
  return {};
}

}  // namespace drape::app
