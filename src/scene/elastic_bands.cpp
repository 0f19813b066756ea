#include "scene/elastic_bands.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace drape::scene {
namespace {

/// The factors on the edges of bands, by their vertices in ascending order.
using BandEdges = std::map<std::pair<int, int>, double>;

BandEdges bandEdgesOf(const ClothPart& cloth) {
  BandEdges edges;
  for (const ElasticBand& band : cloth.bands) {
    for (std::size_t i = 0; i < band.vertices.size(); ++i) {
      const int a = cloth.firstVertex + band.vertices[i];
      const int b = cloth.firstVertex + band.vertices[(i + 1) % band.vertices.size()];
      edges[std::minmax(a, b)] = band.length;
    }
  }
  return edges;
}

/// Scales a triangle along the direction of one of its sides.
void scaleAlong(std::size_t side, double factor, sim::fabric::RestTriangle& triangle) {
  const Vec2 direction = triangle.sides[side].normalized();
  for (Vec2& each : triangle.sides) {
    each += (factor - 1.0) * each.dot(direction) * direction;
  }
  triangle.area *= factor;
}

}  // namespace

bool haveBands(std::span<const ClothPart> cloths) {
  return std::ranges::any_of(cloths, [](const ClothPart& cloth) { return !cloth.bands.empty(); });
}

void applyBands(std::span<const ClothPart> cloths, const sim::ClothModel& model,
                std::vector<sim::fabric::RestTriangle>& rest) {
  for (const ClothPart& cloth : cloths) {
    const BandEdges edges = bandEdgesOf(cloth);
    for (int t = cloth.firstTriangle; t < cloth.firstTriangle + cloth.triangleCount; ++t) {
      const Triangle& corners = model.triangles[t];
      for (std::size_t side = 0; side < 3; ++side) {
        const auto found = edges.find(std::minmax(corners[side], corners[(side + 1) % 3]));
        if (found != edges.end() && rest[t].area > 0.0) {
          scaleAlong(side, found->second, rest[t]);
          rest[t].isBand = true;
          break;
        }
      }
    }
  }
}

std::shared_ptr<const sim::ClothModel> withBandSprings(const sim::ClothModel& model,
                                                       std::span<const ClothPart> cloths) {
  if (!haveBands(cloths)) {
    return model.shared_from_this();
  }
  const std::shared_ptr<const sim::ClothModel> plain = sim::withMeshSizes(model);
  std::vector<double> lengths;
  std::ranges::transform(plain->springs, std::back_inserter(lengths), &sim::Spring::restLength);
  for (const ClothPart& cloth : cloths) {
    for (const auto& [ends, factor] : bandEdgesOf(cloth)) {
      lengths[sim::springBetween(plain->springEnds, ends.first, ends.second)] *= factor;
    }
  }
  return sim::withRestSizes(*plain, lengths, plain->vertexArea);
}

}  // namespace drape::scene
