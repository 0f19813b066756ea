#include "scene/seam_builder.hpp"

#include "messages/sentence_error.hpp"
#include "messages/sim_error_text.hpp"
#include "scene/border_finder.hpp"
#include "scene/mesh_file.hpp"
#include "sim/fabric/weld.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace drape::scene {
namespace {

using text::Sentence;

/// Builds one seam.
class SeamBuilder {
 public:
  SeamBuilder(const sim::ClothMesh& mesh, std::span<const ClothPart> cloths, const sim::ClothModel& model)
      : mesh_(mesh), cloths_(cloths), model_(model), borders_(mesh, [this](int vertex) { return named(vertex); }) {}
  SeamBuilder(const SeamBuilder&) = delete;  // borders_ points to it
  SeamBuilder& operator=(const SeamBuilder&) = delete;

  [[nodiscard]] sim::Seam build(const SeamDescription& seam, std::vector<std::string>* notes) const {
    try {
      sim::Seam result{.pairs = seam.pairs.empty() ? pairsOfSides(seam, notes) : pairsByIndex(seam),
                       .duration = seam.duration};
      check(result.pairs);
      return result;
    } catch (const messages::InputError& error) {
      if (seam.where.empty()) {
        throw;
      }
      throw messages::InputError(placed(seam.where, error.what()));
    }
  }

 private:
  [[nodiscard]] const ClothPart& clothNamed(const std::string& name) const {
    if (name.empty() && cloths_.size() > 1) {
      fail(Sentence("this scene has several cloths, so each side of a seam needs the name of its cloth"));
    }
    const auto found =
        std::ranges::find_if(cloths_, [&](const ClothPart& cloth) { return name.empty() || cloth.name == name; });
    if (found == cloths_.end()) {
      fail(Sentence("there is no cloth with the name \"{}\"", name));
    }
    return *found;
  }

  /// "vertex 12 of the cloth "front"".
  [[nodiscard]] Sentence named(int vertex) const {
    const ClothPart& cloth = clothWith(vertex, cloths_);
    const int index = vertex - cloth.firstVertex;
    return cloth.name.empty() ? Sentence("vertex {}", index)
                              : Sentence("vertex {} of the cloth \"{}\"", index, cloth.name);
  }

  /// A vertex of a cloth by its index in the file, as a vertex of the model.
  [[nodiscard]] static int vertexOf(const ClothPart& cloth, int index) {
    if (index < 0 || index >= cloth.vertexCount) {
      fail(cloth.name.empty()
               ? Sentence("there is no vertex {} in this cloth: its vertices are 0 to {}", index, cloth.vertexCount - 1)
               : Sentence("there is no vertex {} in the cloth \"{}\": its vertices are 0 to {}", index, cloth.name,
                          cloth.vertexCount - 1));
    }
    return cloth.firstVertex + index;
  }

  [[nodiscard]] std::vector<sim::SeamPair> pairsByIndex(const SeamDescription& seam) const {
    const ClothPart& first = clothNamed(seam.sides[0].cloth);
    const ClothPart& second = clothNamed(seam.sides[1].cloth);
    std::vector<sim::SeamPair> pairs;
    for (const auto& [a, b] : seam.pairs) {
      pairs.push_back({vertexOf(first, a), vertexOf(second, b)});
      static_cast<void>(borders_.borderWith(pairs.back().a));
      static_cast<void>(borders_.borderWith(pairs.back().b));
    }
    return pairs;
  }

  [[nodiscard]] std::vector<sim::SeamPair> pairsOfSides(const SeamDescription& seam,
                                                        std::vector<std::string>* notes) const {
    const std::vector<int> first = pointsOf(seam.sides[0]);
    const std::vector<int> second = pointsOf(seam.sides[1]);
    if ((first.size() == 1) != (second.size() == 1)) {
      fail(
          Sentence("one side of this seam is a whole border and the other one a part of a border; give both one point, "
                   "or both two"));
    }
    const BorderPath from = borders_.pathThrough(first, false);
    BorderPath to = borders_.pathThrough(second, !seam.isReversed);
    if (seam.isReversed && !to.isClosed) {
      std::ranges::reverse(to.vertices);
    }
    if (notes != nullptr && from.vertices.size() != to.vertices.size()) {
      notes->push_back(placed(
          seam.where, fmt::format("the sides of this seam have {} and {} vertices, so slits stay open at the vertices "
                                  "without a partner. Give both sides equally many vertices.",
                                  from.vertices.size(), to.vertices.size())));
    }
    std::vector<sim::SeamPair> pairs = matched(from, to, mesh_.positions);
    dropCommonEnds(pairs);
    return pairs;
  }

  /// The sides of a dart have a common end, which needs no seam.
  static void dropCommonEnds(std::vector<sim::SeamPair>& pairs) {
    if (pairs.size() > 1 && pairs.front().a == pairs.front().b) {
      pairs.erase(pairs.begin());
    }
    if (pairs.size() > 1 && pairs.back().a == pairs.back().b) {
      pairs.pop_back();
    }
  }

  [[nodiscard]] std::vector<int> pointsOf(const BorderDescription& side) const {
    const ClothPart& cloth = clothNamed(side.cloth);
    std::vector<int> points;
    for (const int index : side.vertices) {
      points.push_back(vertexOf(cloth, index));
    }
    for (const Vec3& point : side.nearest) {
      points.push_back(borders_.nearestVertex(point, cloth.firstVertex, cloth.vertexCount));
    }
    if (points.empty()) {
      fail(Sentence("a side of a seam needs at least one point"));
    }
    return points;
  }

  void check(const std::vector<sim::SeamPair>& pairs) const {
    std::map<int, int> partners;
    for (const sim::SeamPair& pair : pairs) {
      if (pair.a == pair.b) {
        fail(Sentence("{} cannot be sewn to itself", named(pair.a)));
      }
      if (model_.pinned[pair.a] && model_.pinned[pair.b]) {
        fail(Sentence("{} and {} are both pinned or frozen, so that they cannot be drawn together", named(pair.a),
                      named(pair.b)));
      }
      for (const auto& [vertex, partner] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
        if (!partners.emplace(vertex, partner).second) {
          fail(Sentence("{} is in two pairs of this seam", named(vertex)));
        }
      }
    }
  }

  [[noreturn]] static void fail(const Sentence& problem) { throw messages::SentenceError(problem); }

  const sim::ClothMesh& mesh_;
  std::span<const ClothPart> cloths_;
  const sim::ClothModel& model_;
  BorderFinder borders_;
};

/// Checks that all seams together can be welded, and that the last one of them joins something.
void requireWeldable(std::span<const sim::Seam> seams, const std::string& where, const sim::ClothModel& model) {
  const auto fail = [&](const Sentence& problem) {
    if (where.empty()) {
      throw messages::SentenceError(problem);
    }
    throw messages::InputError(placed(where, problem.english()));
  };
  const std::vector<int> leaders = sim::leadersOf(seams, model.pinned);
  const std::vector<int> before = sim::leadersOf(seams.first(seams.size() - 1), model.pinned);
  if (std::ranges::all_of(seams.back().pairs,
                          [&](const sim::SeamPair& pair) { return before[pair.a] == before[pair.b]; })) {
    fail(Sentence("other seams join these vertices already"));
  }
  for (const auto& [a, b, c] : model.triangles) {
    if (leaders[a] == leaders[b] || leaders[b] == leaders[c] || leaders[c] == leaders[a]) {
      fail(Sentence("the seams join two corners of one triangle. Sew other vertices, or refine the mesh there"));
    }
  }
  try {
    static_cast<void>(sim::fabric::withWelds(model, leaders));
  } catch (const sim::ClothModelError& error) {
    fail(Sentence("these cloths cannot be sewn together: {}", messages::inWords(error)));
  }
}

}  // namespace

std::vector<sim::Seam> seamsOf(std::span<const SeamDescription> seams, const sim::ClothMesh& mesh,
                               std::span<const ClothPart> cloths, const sim::ClothModel& model,
                               std::vector<sim::Seam> before, std::vector<std::string>* notes) {
  if (seams.empty()) {
    return before;
  }
  const SeamBuilder builder(mesh, cloths, model);
  for (const SeamDescription& seam : seams) {
    before.push_back(builder.build(seam, notes));
    requireWeldable(before, seam.where, model);
  }
  return before;
}

}  // namespace drape::scene
