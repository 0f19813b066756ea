#include "scene/seam_builder.hpp"

#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "scene/boundary_loops.hpp"
#include "scene/seam_matching.hpp"
#include "sim/fabric/weld.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace drape::scene {
namespace {

/// Builds one seam.
class SeamBuilder {
 public:
  SeamBuilder(const SeamDescription& seam, const JoinedCloths& joined, const sim::ClothModel& model)
      : seam_(seam), joined_(joined), model_(model) {}

  [[nodiscard]] sim::Seam build() {
    sim::Seam result{.pairs = seam_.pairs.empty() ? pairsOfSides() : pairsByIndex(), .duration = seam_.duration};
    std::map<int, int> partners;
    for (const sim::SeamPair& pair : result.pairs) {
      check(pair);
      for (const auto& [vertex, partner] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
        if (!partners.emplace(vertex, partner).second) {
          fail(fmt::format("{} is in two pairs of this seam", named(vertex)));
        }
      }
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw messages::InputError((seam_.where.empty() ? "" : seam_.where + ": ") + problem);
  }

  [[nodiscard]] const ClothPart& clothNamed(const std::string& name) const {
    if (name.empty() && joined_.cloths.size() > 1) {
      fail("this scene has several cloths, so each side of a seam needs the name of its cloth");
    }
    const auto found = std::ranges::find_if(joined_.cloths,
                                            [&](const ClothPart& cloth) { return name.empty() || cloth.name == name; });
    if (found == joined_.cloths.end()) {
      fail("there is no cloth with the name \"" + name + "\"");
    }
    return *found;
  }

  /// "vertex 12 of the cloth "front"".
  [[nodiscard]] std::string named(int vertex) const {
    const auto cloth = std::ranges::find_if(joined_.cloths, [&](const ClothPart& each) {
      return vertex >= each.firstVertex && vertex < each.firstVertex + each.vertexCount;
    });
    const std::string own = "vertex " + std::to_string(vertex - cloth->firstVertex);
    return cloth->name.empty() ? own : own + " of the cloth \"" + cloth->name + "\"";
  }

  /// A vertex of a cloth by its index in the file, as a vertex of the model.
  [[nodiscard]] int vertexOf(const ClothPart& cloth, int index) const {
    if (index >= cloth.vertexCount) {
      fail(fmt::format("there is no vertex {}{}: it has {}, counted from 0", index,
                       cloth.name.empty() ? " in this cloth" : " in the cloth \"" + cloth.name + "\"",
                       cloth.vertexCount));
    }
    return cloth.firstVertex + index;
  }

  [[nodiscard]] std::vector<sim::SeamPair> pairsByIndex() const {
    const ClothPart& first = clothNamed(seam_.sides[0].cloth);
    const ClothPart& second = clothNamed(seam_.sides[1].cloth);
    std::vector<sim::SeamPair> pairs;
    for (const auto& [a, b] : seam_.pairs) {
      pairs.push_back({vertexOf(first, a), vertexOf(second, b)});
      for (const int vertex : {pairs.back().a, pairs.back().b}) {
        if (borderWith(vertex) == nullptr) {
          fail(named(vertex) + " is not on an open border, so it cannot be sewn");
        }
      }
    }
    return pairs;
  }

  [[nodiscard]] std::vector<sim::SeamPair> pairsOfSides() const {
    if (isWhole(seam_.sides[0]) != isWhole(seam_.sides[1])) {
      fail(
          "one side of this seam is a whole border and the other one a part of a border; give both one point, or both "
          "two");
    }
    return matched(pathOf(seam_.sides[0], false), pathOf(seam_.sides[1], true), joined_.mesh.positions);
  }

  [[nodiscard]] static bool isWhole(const BorderDescription& side) {
    return side.vertices.size() + side.nearest.size() == 1;
  }

  [[nodiscard]] BorderPath pathOf(const BorderDescription& side, bool isSecond) const {
    const std::vector<int> points = pointsOf(side);
    const BoundaryLoop* border = borderWith(points.front());
    if (border == nullptr) {
      fail(named(points.front()) + " is not on an open border, so it cannot be sewn");
    }
    if (points.size() == 1) {
      return wholeBorder(border->vertices, joined_.mesh, points.front(), isSecond);
    }
    const auto between = points.size() == 3 ? std::optional(points[1]) : std::nullopt;
    const auto path = pathAlong(border->vertices, joined_.mesh.positions, points.front(), points.back(), between);
    if (!path) {
      fail(fmt::format("{} and {} are not on the same open border", named(points.front()), named(points.back())));
    }
    if (path->vertices.size() < 2) {
      fail("the path of this seam starts and ends at " + named(points.front()) +
           "; give two points, or one for the whole border");
    }
    return *path;
  }

  [[nodiscard]] std::vector<int> pointsOf(const BorderDescription& side) const {
    const ClothPart& cloth = clothNamed(side.cloth);
    std::vector<int> points;
    for (const int index : side.vertices) {
      points.push_back(vertexOf(cloth, index));
    }
    for (const Vec3& point : side.nearest) {
      points.push_back(nearestOnBorder(cloth, point));
    }
    return points;
  }

  [[nodiscard]] int nearestOnBorder(const ClothPart& cloth, const Vec3& point) const {
    int nearest = -1;
    double distance = std::numeric_limits<double>::max();
    for (const BoundaryLoop& border : pieces_.loops) {
      for (const int vertex : border.vertices) {
        const double own = (joined_.mesh.positions[vertex] - point).squaredNorm();
        const bool isOfCloth = vertex >= cloth.firstVertex && vertex < cloth.firstVertex + cloth.vertexCount;
        if (isOfCloth && own < distance) {
          distance = own;
          nearest = vertex;
        }
      }
    }
    if (nearest < 0) {
      fail("this cloth has no open border, so it cannot be sewn");
    }
    return nearest;
  }

  [[nodiscard]] const BoundaryLoop* borderWith(int vertex) const {
    const auto found = std::ranges::find_if(pieces_.loops, [&](const BoundaryLoop& border) {
      return std::ranges::find(border.vertices, vertex) != border.vertices.end();
    });
    return found == pieces_.loops.end() ? nullptr : &*found;
  }

  void check(const sim::SeamPair& pair) const {
    if (pair.a == pair.b) {
      fail(named(pair.a) + " cannot be sewn to itself");
    }
    if (model_.pinned[pair.a] && model_.pinned[pair.b]) {
      fail(fmt::format("{} and {} are both pinned, so that they cannot be drawn together", named(pair.a),
                       named(pair.b)));
    }
  }

  const SeamDescription& seam_;
  const JoinedCloths& joined_;
  const sim::ClothModel& model_;
  ClothPieces pieces_ = findPieces(joined_.mesh);
};

/// Checks that all seams together can be welded.
void requireWeldable(std::span<const sim::Seam> seams, const std::string& where, const sim::ClothModel& model) {
  const std::vector<int> leaders = sim::leadersOf(seams, model.pinned);
  for (const auto& [a, b, c] : model.triangles) {
    if (leaders[a] == leaders[b] || leaders[b] == leaders[c] || leaders[c] == leaders[a]) {
      throw messages::InputError(where +
                                 ": the seams join two corners of one triangle. Sew other vertices, or refine "
                                 "the mesh there");
    }
  }
  try {
    messages::withInputErrors([&] { return sim::fabric::withWelds(model, leaders); });
  } catch (const messages::InputError& error) {
    throw messages::InputError(where + ": these cloths cannot be sewn together: " + error.what());
  }
}

}  // namespace

std::vector<sim::Seam> seamsOf(std::span<const SeamDescription> seams, const JoinedCloths& joined,
                               const sim::ClothModel& model) {
  std::vector<sim::Seam> built;
  for (const SeamDescription& seam : seams) {
    built.push_back(SeamBuilder(seam, joined, model).build());
    requireWeldable(built, seam.where, model);
  }
  return built;
}

}  // namespace drape::scene
