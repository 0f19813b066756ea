#include "sim/adaptive/coarse_levels.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace drape {
namespace {

constexpr int fewestGroups = 12;  // a level of fewer vertices is not gathered any further

std::span<const SpringEnd> endsOf(const ClothModel& model, std::size_t vertex) {
  const auto begin = static_cast<std::size_t>(model.springEnds.begin[vertex]);
  const auto end = static_cast<std::size_t>(model.springEnds.begin[vertex + 1]);
  return {model.springEnds.values.data() + begin, end - begin};
}

/// One list a vertex: those that an edge of the rim leads to, an edge that a single triangle has.
using RimEnds = std::vector<std::vector<int>>;

RimEnds rimOf(const ClothModel& model) {
  std::vector<std::pair<int, int>> edges;
  for (const Triangle& triangle : model.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      edges.emplace_back(std::minmax({triangle[corner], triangle[(corner + 1) % 3]}));
    }
  }
  std::sort(edges.begin(), edges.end());
  RimEnds rim(model.restPositions.size());
  for (auto same = edges.begin(); same != edges.end();) {
    const auto next = std::find_if(same, edges.end(), [&](const auto& edge) { return edge != *same; });
    if (next - same == 1) {
      rim[static_cast<std::size_t>(same->first)].push_back(same->second);
      rim[static_cast<std::size_t>(same->second)].push_back(same->first);
    }
    same = next;
  }
  return rim;
}

/// The rim of the groups: where the rim below leads from one to another.
RimEnds rimOf(const RimEnds& below, const std::vector<int>& groupOf, std::size_t groups) {
  RimEnds rim(groups);
  for (std::size_t i = 0; i < below.size(); ++i) {
    for (const int j : below[i]) {
      if (groupOf[i] != groupOf[static_cast<std::size_t>(j)]) {
        rim[static_cast<std::size_t>(groupOf[i])].push_back(groupOf[static_cast<std::size_t>(j)]);
      }
    }
  }
  for (std::vector<int>& ends : rim) {
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  }
  return rim;
}

/// Along the rim first, from what is pinned, then inwards ring by ring: groups lie in rows along free edges.
class VisitOrder {
 public:
  VisitOrder(const ClothModel& model, const RimEnds& rim) : model_(model), rim_(rim), seen_(rim.size(), false) {
    begin([&](std::size_t i) { return model.pinned[i]; });
    begin([&](std::size_t i) { return !rim[i].empty(); });
    goInwards(0);
    for (std::size_t i = 0; i < seen_.size(); ++i) {  // what no rim and no pin leads to
      const std::size_t first = order_.size();
      add(i);
      goInwards(first);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  void add(std::size_t i) {
    if (!seen_[i]) {
      seen_[i] = true;
      order_.push_back(i);
    }
  }

  template <typename Is>
  void begin(Is&& is) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (is(i) && !seen_[i]) {
        std::size_t next = order_.size();
        add(i);
        for (; next < order_.size(); ++next) {
          for (const int j : rim_[order_[next]]) {
            add(static_cast<std::size_t>(j));
          }
        }
      }
    }
  }

  void goInwards(std::size_t next) {
    for (; next < order_.size(); ++next) {
      for (const SpringEnd& end : endsOf(model_, order_[next])) {
        add(static_cast<std::size_t>(end.neighbour));
      }
    }
  }

  const ClothModel& model_;
  const RimEnds& rim_;
  std::vector<bool> seen_;
  std::vector<std::size_t> order_;
};

/// Seeds of which no two are tied, as many as there is room for; every other vertex goes with the nearest seed that it
/// is tied to, along the rim if it lies there.
class Grouping {
 public:
  Grouping(const ClothModel& model, const RimEnds& rim) : model_(model), rim_(rim), seed_(rim.size(), false) {
    const std::vector<std::size_t> order = VisitOrder(model, rim).order();
    std::vector<bool> taken(rim.size(), false);
    for (const std::size_t i : order) {
      if (!taken[i]) {
        seed_[i] = true;
        for (const SpringEnd& end : endsOf(model, i)) {
          taken[static_cast<std::size_t>(end.neighbour)] = true;
        }
      }
    }
    for (const std::size_t i : order) {
      seed_[i] = seed_[i] || seedOf(i) < 0;
    }
    number();
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::vector<int> take() { return std::move(groupOf_); }

 private:
  /// In the order of the vertices, so that a regular cloth has regular groups.
  void number() {
    groupOf_.assign(seed_.size(), -1);
    for (std::size_t i = 0; i < seed_.size(); ++i) {
      if (seed_[i]) {
        groupOf_[i] = count_++;
      }
    }
    for (std::size_t i = 0; i < seed_.size(); ++i) {
      if (!seed_[i]) {
        groupOf_[i] = groupOf_[static_cast<std::size_t>(seedOf(i))];
      }
    }
  }

  /// The seed that a vertex goes with; -1: there is none next to it. Pinned and free ones never go together.
  [[nodiscard]] int seedOf(std::size_t i) const {
    int nearest = -1;
    double distance = std::numeric_limits<double>::max();
    const auto look = [&](int neighbour) {
      const auto j = static_cast<std::size_t>(neighbour);
      const double length = (model_.restPositions[i] - model_.restPositions[j]).norm();
      if (seed_[j] && model_.pinned[j] == model_.pinned[i] && length < distance) {
        nearest = neighbour;
        distance = length;
      }
    };
    std::for_each(rim_[i].begin(), rim_[i].end(), look);
    if (nearest < 0) {
      for (const SpringEnd& end : endsOf(model_, i)) {
        look(end.neighbour);
      }
    }
    return nearest;
  }

  const ClothModel& model_;
  const RimEnds& rim_;
  std::vector<bool> seed_;
  std::vector<int> groupOf_;
  int count_ = 0;
};

/// Between groups whose members are tied to each other, unless both are held.
std::vector<Spring> springsBetween(const ClothModel& model, const std::vector<int>& groupOf, const ClothModel& groups) {
  std::vector<std::pair<int, int>> pairs;
  for (const Spring& spring : model.springs) {
    const int a = groupOf[static_cast<std::size_t>(spring.a)];
    const int b = groupOf[static_cast<std::size_t>(spring.b)];
    const bool held = groups.pinned[static_cast<std::size_t>(a)] && groups.pinned[static_cast<std::size_t>(b)];
    if (a != b && !held) {
      pairs.emplace_back(std::minmax(a, b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Spring> springs;
  for (const auto& [a, b] : pairs) {
    const Vec3 offset =
        groups.restPositions[static_cast<std::size_t>(b)] - groups.restPositions[static_cast<std::size_t>(a)];
    springs.push_back({a, b, offset.norm()});
  }
  return springs;
}

RaggedRows<SpringEnd> endsOfSprings(const std::vector<Spring>& springs, std::size_t vertices) {
  std::vector<std::vector<SpringEnd>> rows(vertices);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    rows[static_cast<std::size_t>(springs[s].a)].push_back({springs[s].b, static_cast<int>(s)});
    rows[static_cast<std::size_t>(springs[s].b)].push_back({springs[s].a, static_cast<int>(s)});
  }
  RaggedRows<SpringEnd> ends;
  ends.begin.push_back(0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end(), [](const SpringEnd& a, const SpringEnd& b) { return a.neighbour < b.neighbour; });
    ends.values.insert(ends.values.end(), row.begin(), row.end());
    ends.begin.push_back(static_cast<int>(ends.values.size()));
  }
  return ends;
}

CoarseLevel levelAbove(const ClothModel& model, const RimEnds& rim) {
  Grouping grouping(model, rim);
  const auto count = static_cast<std::size_t>(grouping.count());
  CoarseLevel level;
  level.groupOf = grouping.take();
  auto groups = std::make_shared<ClothModel>();
  groups->restPositions.assign(count, Vec3::Zero());
  groups->vertexMass.assign(count, 0.0);
  groups->vertexArea.assign(count, 0.0);
  groups->pinned.assign(count, false);
  groups->vertexTriangles.begin.assign(count + 1, 0);
  for (std::size_t i = 0; i < level.groupOf.size(); ++i) {
    const auto g = static_cast<std::size_t>(level.groupOf[i]);
    groups->restPositions[g] += model.vertexMass[i] * model.restPositions[i];
    groups->vertexMass[g] += model.vertexMass[i];
    groups->pinned[g] = model.pinned[i];
  }
  for (std::size_t g = 0; g < count; ++g) {
    groups->restPositions[g] /= groups->vertexMass[g];
  }
  groups->springs = springsBetween(model, level.groupOf, *groups);
  groups->springEnds = endsOfSprings(groups->springs, count);
  level.cloth = std::move(groups);
  return level;
}

}  // namespace

std::vector<CoarseLevel> buildCoarseLevels(const ClothModel& model) {
  std::vector<CoarseLevel> levels;
  const ClothModel* below = &model;
  RimEnds rim = rimOf(model);
  while (below->vertexCount() > fewestGroups) {
    CoarseLevel level = levelAbove(*below, rim);
    if (level.cloth->springs.empty() || level.cloth->vertexCount() == below->vertexCount()) {
      break;
    }
    rim = rimOf(rim, level.groupOf, level.cloth->restPositions.size());
    levels.push_back(std::move(level));
    below = levels.back().cloth.get();
  }
  return levels;
}

}  // namespace drape
