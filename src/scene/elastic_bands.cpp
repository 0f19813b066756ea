#include "scene/elastic_bands.hpp"

#include "messages/sentence_error.hpp"
#include "scene/border_finder.hpp"
#include "scene/mesh_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace drape::scene {
namespace {

/// The factors on the edges of bands.
using BandEdges = std::map<BandEdge, double>;

BandEdges bandEdgesOf(const ClothPart& cloth) {
  BandEdges edges;
  for (const ElasticBand& band : cloth.bands) {
    for (const BandEdge& edge : edgesOf(band, cloth.firstVertex)) {
      edges[edge] = band.length;
    }
  }
  return edges;
}

/// The border of a band by the indices of the mesh. Throws InputError without the place in the file.
BorderPath borderOf(const BandDescription& band, const BorderFinder& borders) {
  if (band.vertices.empty()) {
    return {.vertices = borders.nearestBorder(band.nearest), .isClosed = true};
  }
  for (const int vertex : band.vertices) {
    if (vertex < 0 || vertex >= borders.vertexCount()) {
      throw messages::SentenceError(text::Sentence("there is no vertex {} in this cloth: its vertices are 0 to {}",
                                                   vertex, borders.vertexCount() - 1));
    }
  }
  return borders.pathThrough(band.vertices);
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

std::vector<BandEdge> edgesOf(const ElasticBand& band, int firstVertex) {
  std::vector<BandEdge> edges;
  const std::size_t count = band.vertices.size();
  for (std::size_t i = 0; i + (band.isClosed ? 0 : 1) < count; ++i) {
    edges.emplace_back(std::minmax(firstVertex + band.vertices[i], firstVertex + band.vertices[(i + 1) % count]));
  }
  return edges;
}

std::vector<ElasticBand> bandsOf(std::span<const BandDescription> descriptions, const sim::ClothMesh& mesh) {
  std::vector<ElasticBand> bands;
  if (descriptions.empty()) {
    return bands;
  }
  const BorderFinder borders(mesh);
  std::set<BandEdge> taken;
  for (const BandDescription& description : descriptions) {
    try {
      const BorderPath border = borderOf(description, borders);
      bands.push_back({border.vertices, description.length, border.isClosed});
      for (const BandEdge& edge : edgesOf(bands.back(), 0)) {
        if (!taken.insert(edge).second) {
          throw messages::SentenceError(text::Sentence("there is an elastic band along this border already"));
        }
      }
    } catch (const messages::InputError& error) {
      if (description.where.empty()) {
        throw;
      }
      throw messages::InputError(placed(description.where, error.what()));
    }
  }
  return bands;
}

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
