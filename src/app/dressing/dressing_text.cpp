#include "app/dressing/dressing_text.hpp"

#include "messages/error.hpp"
#include "sim/model/bounds.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace drape::app {
namespace {

using dressing::BodyPart;

std::string_view nameOf(BodyPart part) {
  switch (part) {
    case BodyPart::Head:
      return "head";
    case BodyPart::Trunk:
      return "trunk";
    case BodyPart::LeftArm:
      return "left arm";
    case BodyPart::RightArm:
      return "right arm";
    case BodyPart::LeftLeg:
      return "left leg";
    case BodyPart::RightLeg:
      return "right leg";
    case BodyPart::Whole:
      break;
  }
  return "body";
}

std::string_view wallOf(const dressing::Fault& fault) {
  return fault.atSleeve ? "the sleeve's wall" : "the garment";
}

std::string capitalised(std::string sentence) {
  if (!sentence.empty()) {
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  }
  return sentence;
}

/// What a garment lacks that is closed where head and arms come out.
std::string adviceOnOpenings(const dressing::Dressed& result) {
  if (result.openings > 1) {
    return "";
  }
  return fmt::format(" It has {} for neck, arms, waist and legs; is it closed where it should be open?",
                     result.openings == 0 ? "no opening" : "only one opening");
}

std::string pairsText(std::size_t pairs) {
  return fmt::format("{} {} of triangles", pairs, pairs == 1 ? "pair" : "pairs");
}

}  // namespace

std::string inWords(const dressing::Fault& fault) {
  if (fault.kind == dressing::FaultKind::MissesOpening) {
    return fmt::format("the {} does not pass through the opening of its sleeve", nameOf(fault.part));
  }
  return fmt::format("the {} passes through {} ({})", nameOf(fault.part), wallOf(fault), pairsText(fault.pairs));
}

std::string inWords(const std::vector<dressing::Fault>& faults) {
  std::string text;
  for (const dressing::Fault& fault : faults) {
    text += (text.empty() ? "" : ", ") + inWords(fault);
  }
  return text;
}

std::string inWords(const dressing::Pairs& pairs) {
  if (pairs.all() == 0) {
    return "no triangles";
  }
  return fmt::format("{} of the garment with the body and {} with itself", pairsText(pairs.body), pairs.self);
}

std::string inWords(dressing::PlacementRule rule) {
  switch (rule) {
    case dressing::PlacementRule::Landmarks:
      return "placed by neck, sleeves or waist";
    case dressing::PlacementRule::Boxes:
      return "placed by its size";
    case dressing::PlacementRule::Auto:
    case dressing::PlacementRule::File:
      break;
  }
  return "placed as in its file";
}

std::string inWords(dressing::Stage stage) {
  switch (stage) {
    case dressing::Stage::Shrinking:
      return "shrinking the body";
    case dressing::Stage::Placing:
      return "placing the garment";
    case dressing::Stage::Growing:
      return "growing the body";
    case dressing::Stage::Settling:
      break;
  }
  return "settling the garment";
}

std::string inWords(const dressing::Piercing& piercing, const scene::Scene& scene) {
  if (piercing.faults.size() == 1 && piercing.faults.front().part == BodyPart::Whole) {
    const Vec3& at = piercing.centre;
    return fmt::format("The body '{}' passes through the cloth near ({:.2f}, {:.2f}, {:.2f}) m: {}",
                       (*scene.bodies)[piercing.body].name, at.x(), at.y(), at.z(), pairsText(piercing.pairs));
  }
  if (piercing.faults.size() == 1) {
    const dressing::Fault& fault = piercing.faults.front();
    return fmt::format("The {} passes through {}: {}", nameOf(fault.part), wallOf(fault), pairsText(fault.pairs));
  }
  constexpr std::size_t longestList = 2;
  const std::size_t named = std::min(longestList, piercing.faults.size());
  const std::size_t others = piercing.faults.size() - named;
  const std::vector<dressing::Fault> first(piercing.faults.begin(),
                                           piercing.faults.begin() + static_cast<std::ptrdiff_t>(named));
  std::string text = capitalised(inWords(first));
  if (others > 0) {
    text += others == 1 ? ", and so does 1 other part" : fmt::format(", and so do {} other parts", others);
  }
  return text;
}

std::string inWords(const std::vector<dressing::Piercing>& piercings, const scene::Scene& scene) {
  std::string text = inWords(piercings.front(), scene);
  if (piercings.size() > 1) {
    text += fmt::format("; {} other {} through the cloth too", piercings.size() - 1,
                        piercings.size() == 2 ? "body passes" : "bodies pass");
  }
  return text;
}

std::string summaryOf(const dressing::Dressed& result) {
  const std::string faults = inWords(result.faults);
  return fmt::format("{}; {} intersected there, and {} at the end{}", inWords(result.placement.rule),
                     inWords(result.before), inWords(result.after), faults.empty() ? "" : ": " + faults);
}

std::string refusalOf(const dressing::Dressed& result, const std::string& garment) {
  return fmt::format("{} does not go on the body: even where the body is a thin line, {}.{}", garment,
                     inWords(result.faults), adviceOnOpenings(result));
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
        inWords(misfit, names.garment, names.body, side(garment.positions), side(body.positions)));
  }
}

std::string inWords(dressing::Misfit misfit, const std::string& garment, const std::string& body, double garmentSide,
                    double bodySide) {
  switch (misfit) {
    case dressing::Misfit::OpenBody:
      return body + ": the body has holes, so it has no inside. Close them first";
    case dressing::Misfit::NoVolume:
      return body + ": the body has no volume, or its triangles are inside out. Turn its faces outwards first";
    case dressing::Misfit::GarmentTooLarge:
    case dressing::Misfit::GarmentTooSmall:
      return fmt::format(
          "{} is {} long and the body {}, so it cannot be worn. Give the unit of the garment "
          "(--set unit=cm) or --scale",
          garment, text::formatLength(garmentSide), text::formatLength(bodySide));
    case dressing::Misfit::None:
      break;
  }
  return "";
}

}  // namespace drape::app
