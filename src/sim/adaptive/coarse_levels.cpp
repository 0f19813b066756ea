#include "sim/adaptive/coarse_levels.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace drape {
namespace {

constexpr int fewestGroups = 4;  // a level of fewer vertices is not gathered any further

std::span<const SpringEnd> endsOf(const ClothModel& model, std::size_t vertex) {
  const auto begin = static_cast<std::size_t>(model.springEnds.begin[vertex]);
  const auto end = static_cast<std::size_t>(model.springEnds.begin[vertex + 1]);
  return {model.springEnds.values.data() + begin, end - begin};
}

/// Ring by ring, so that groups lie next to each other and few vertices are left over.
std::vector<std::size_t> ringOrder(const ClothModel& model) {
  std::vector<std::size_t> order;
  std::vector<bool> seen(model.restPositions.size(), false);
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) {
      continue;
    }
    seen[first] = true;
    order.push_back(first);
    for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
      for (const SpringEnd& end : endsOf(model, order[next])) {
        const auto j = static_cast<std::size_t>(end.neighbour);
        if (!seen[j]) {
          seen[j] = true;
          order.push_back(j);
        }
      }
    }
  }
  return order;
}

class Grouping {
 public:
  explicit Grouping(const ClothModel& model) : model_(model), groupOf_(model.restPositions.size(), -1) {
    const std::vector<std::size_t> order = ringOrder(model);
    for (const std::size_t i : order) {
      gatherRing(i);
    }
    const std::vector<int> rings = groupOf_;
    for (const std::size_t i : order) {
      if (rings[i] < 0) {
        const int nearest = nearestGroup(i, rings);
        groupOf_[i] = nearest < 0 ? count_++ : nearest;
      }
    }
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::vector<int> take() { return std::move(groupOf_); }

 private:
  /// A vertex and its neighbours, when none of them has a group yet.
  void gatherRing(std::size_t i) {
    const auto alike = [&](const SpringEnd& end) {
      return model_.pinned[static_cast<std::size_t>(end.neighbour)] == model_.pinned[i];
    };
    const auto ends = endsOf(model_, i);
    const bool taken = groupOf_[i] >= 0 || std::any_of(ends.begin(), ends.end(), [&](const SpringEnd& end) {
                         return alike(end) && groupOf_[static_cast<std::size_t>(end.neighbour)] >= 0;
                       });
    if (taken) {
      return;
    }
    groupOf_[i] = count_;
    for (const SpringEnd& end : ends) {
      if (alike(end)) {
        groupOf_[static_cast<std::size_t>(end.neighbour)] = count_;
      }
    }
    ++count_;
  }

  [[nodiscard]] int nearestGroup(std::size_t i, const std::vector<int>& rings) const {
    int nearest = -1;
    double distance = std::numeric_limits<double>::max();
    for (const SpringEnd& end : endsOf(model_, i)) {
      const auto j = static_cast<std::size_t>(end.neighbour);
      const double length = model_.springs[static_cast<std::size_t>(end.spring)].restLength;
      if (rings[j] >= 0 && model_.pinned[j] == model_.pinned[i] && length < distance) {
        nearest = rings[j];
        distance = length;
      }
    }
    return nearest;
  }

  const ClothModel& model_;
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

CoarseLevel levelAbove(const ClothModel& model) {
  Grouping grouping(model);
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
  while (below->vertexCount() > fewestGroups) {
    CoarseLevel level = levelAbove(*below);
    if (level.cloth->springs.empty() || level.cloth->vertexCount() == below->vertexCount()) {
      break;
    }
    levels.push_back(std::move(level));
    below = levels.back().cloth.get();
  }
  return levels;
}

}  // namespace drape
