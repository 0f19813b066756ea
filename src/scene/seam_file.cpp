#include "scene/seam_file.hpp"

#include <fmt/core.h>

#include <string>

namespace drape::scene {
namespace {

BorderDescription readBorder(const TomlReader& reader) {
  reader.allowOnly({"cloth", "vertices", "nearest"});
  BorderDescription border{reader.text("cloth").value_or(""), reader.integers("vertices"), reader.vectors("nearest")};
  const std::size_t points = border.vertices.size() + border.nearest.size();
  if (border.vertices.empty() == border.nearest.empty() || points > 3) {
    reader.fail(
        "a side of a seam needs either vertices or nearest, each a list of the first and the last point of its path "
        "along the border, with a third one between them where the path is the longer way round, or of one point for "
        "the whole border");
  }
  return border;
}

std::string borderText(const BorderDescription& border) {
  std::string points;
  for (const Vec3& point : border.nearest) {
    points += (points.empty() ? "" : ", ") + vectorText(point);
  }
  return fmt::format(
      "{{ {}{} }}", border.cloth.empty() ? "" : "cloth = " + quotedText(border.cloth) + ", ",
      border.vertices.empty() ? "nearest = [" + points + "]" : "vertices = " + listText(border.vertices));
}

}  // namespace

SeamDescription readSeam(const TomlReader& reader) {
  reader.allowOnly({"from", "to", "cloths", "pairs", "duration", "reversed"});
  SeamDescription seam;
  seam.where = reader.place();
  seam.duration = reader.number("duration", minSeamDuration, maxSeamDuration).value_or(seam.duration);
  seam.pairs = reader.pairs("pairs");
  seam.isReversed = reader.flag("reversed").value_or(false);
  const auto from = reader.table("from");
  const auto to = reader.table("to");
  const std::vector<std::string> cloths = reader.texts("cloths");
  const bool hasSides = from.has_value() && to.has_value();
  if (hasSides == reader.has("pairs") || from.has_value() != to.has_value()) {
    reader.fail("a seam needs either from and to, or pairs");
  }
  if (hasSides) {
    if (!cloths.empty()) {
      reader.fail("seams.cloths belongs to pairs; from and to name their own cloth");
    }
    seam.sides = {readBorder(*from), readBorder(*to)};
    return seam;
  }
  if (seam.pairs.empty()) {
    reader.fail("seams.pairs is empty: a seam needs at least one pair of vertices");
  }
  if (seam.isReversed) {
    reader.fail("seams.reversed belongs to from and to; pairs have no direction");
  }
  if (!cloths.empty() && cloths.size() != 2) {
    reader.fail("seams.cloths must be two names: those of the first and the second vertex of each pair");
  }
  for (std::size_t side = 0; side < cloths.size(); ++side) {
    seam.sides[side].cloth = cloths[side];
  }
  return seam;
}

void writeSeam(const SeamDescription& seam, TomlText& toml) {
  toml.table("[[seams]]", true);
  if (seam.pairs.empty()) {
    toml.value("from", borderText(seam.sides[0]));
    toml.value("to", borderText(seam.sides[1]));
    if (seam.isReversed) {
      toml.flag("reversed", true);
    }
  } else {
    if (!seam.sides[0].cloth.empty()) {
      toml.value("cloths", "[" + quotedText(seam.sides[0].cloth) + ", " + quotedText(seam.sides[1].cloth) + "]");
    }
    std::string pairs;
    for (const auto& [first, second] : seam.pairs) {
      pairs += fmt::format("{}[{}, {}]", pairs.empty() ? "" : ", ", first, second);
    }
    toml.value("pairs", "[" + pairs + "]");
  }
  if (seam.duration != SeamDescription{}.duration) {
    toml.number("duration", seam.duration);
  }
}

}  // namespace drape::scene
