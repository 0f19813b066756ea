#include "app/dressing/dressing_text.hpp"

#include "text/number_text.hpp"

#include <fmt/core.h>
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

bool isArm(BodyPart part) {
  return part == BodyPart::LeftArm || part == BodyPart::RightArm;
}

std::string pairsText(std::size_t pairs) {
  return fmt::format("{} {} of triangles", pairs, pairs == 1 ? "pair" : "pairs");
}

}  // namespace

std::string inWords(const dressing::Fault& fault) {
  if (fault.kind == dressing::FaultKind::MissesOpening) {
    return fmt::format("the {} does not pass through the opening of its sleeve", nameOf(fault.part));
  }
  const std::string_view wall = fault.atSleeve && isArm(fault.part) ? "the sleeve's wall" : "the garment";
  return fmt::format("the {} passes through {} ({})", nameOf(fault.part), wall, pairsText(fault.pairs));
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
