#include "sim/simd/slice_layout.hpp"

#include "sim/model/sim_error.hpp"
#include "sim/simd/vertex_order.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace drape::sim::simd {
namespace {

/// Minimum number of lanes of a slot of consecutive neighbours. With fewer, gathers are cheaper.
constexpr int minConsecutiveLanes = 10;
constexpr int minCommonCorners = 3;
/// Measured cost of a gathered slot in consecutive ones [-], and the factor by which a mixed slice must be cheaper [-].
constexpr double gatheredCost = 1.6;
constexpr double mixingGain = 0.8;

struct LaneSpring {
  int neighbour = 0;  // permuted index
  int spring = 0;     // index into ClothModel::springs
};

class SliceBuilder {
 public:
  SliceBuilder(const ClothModel& model, SliceLayout& layout, int slice)
      : model_(model), layout_(layout), first_(slice * sliceLanes) {
    for (int lane = 0; lane < sliceLanes && first_ + lane < layout.vertices; ++lane) {
      collect(lane);
    }
  }

  void build() {
    addConsecutiveSlots();
    addGatheredSlots();
    addCorners();
    layout_.slotBegin.push_back(static_cast<int>(layout_.slots.size()));
    layout_.cornerBegin.push_back(static_cast<int>(layout_.corners.size()));
  }

  /// The largest permuted index of a neighbour.
  [[nodiscard]] int lastNeighbour() const {
    int last = first_;
    for (const auto& springs : springs_) {
      for (const LaneSpring& spring : springs) {
        last = std::max(last, spring.neighbour);
      }
    }
    return last;
  }

 private:
  [[nodiscard]] std::size_t vertexAt(int lane) const {
    const int index = first_ + lane;
    return static_cast<std::size_t>(layout_.order[index]);
  }

  void collect(int lane) {
    const std::size_t vertex = vertexAt(lane);
    auto& springs = springs_[lane];
    for (const SpringEnd& springEnd : model_.springEnds[vertex]) {
      springs.push_back({layout_.indexOf[springEnd.neighbour], springEnd.spring});
    }
    orderAsFan(vertex, springs);
    slotOf_[lane].assign(springs.size(), -1);
  }

  /// Sorts neighbours in the order of the triangle fan around a vertex, so that the same two slots form a triangle in
  /// most lanes. Where the fan ends, or the triangles form no fan, the next part starts at the lowest index left.
  void orderAsFan(std::size_t vertex, std::vector<LaneSpring>& springs) const {
    std::sort(springs.begin(), springs.end(),
              [](const LaneSpring& a, const LaneSpring& b) { return a.neighbour < b.neighbour; });
    std::map<int, int> next;
    std::set<int> reached;
    for (const int triangle : model_.vertexTriangles[vertex]) {
      const auto [a, b] = cornerOf(vertex, triangle);
      next.emplace(a, b);
      reached.insert(b);
    }
    std::vector<LaneSpring> fan;
    const auto take = [&](int index) {
      const auto found = std::find_if(springs.begin(), springs.end(),
                                      [&](const LaneSpring& spring) { return spring.neighbour == index; });
      fan.push_back(*found);
      springs.erase(found);
    };
    while (!springs.empty()) {
      const auto open = std::find_if(springs.begin(), springs.end(),
                                     [&](const LaneSpring& spring) { return !reached.contains(spring.neighbour); });
      take(open != springs.end() ? open->neighbour : springs.front().neighbour);
      const auto left = [&](int index) {
        return std::any_of(springs.begin(), springs.end(),
                           [&](const LaneSpring& spring) { return spring.neighbour == index; });
      };
      for (auto step = next.find(fan.back().neighbour); step != next.end() && left(step->second);
           step = next.find(fan.back().neighbour)) {
        take(step->second);
      }
    }
    springs.swap(fan);
  }

  /// The permuted indices of a triangle's other two vertices.
  [[nodiscard]] std::pair<int, int> cornerOf(std::size_t vertex, int triangle) const {
    const Triangle& t = model_.triangles[triangle];
    const std::size_t at = t[0] == static_cast<int>(vertex) ? 0 : t[1] == static_cast<int>(vertex) ? 1 : 2;
    return {layout_.indexOf[t[(at + 1) % 3]], layout_.indexOf[t[(at + 2) % 3]]};
  }

  [[nodiscard]] int newSlot(SliceLayout::Slot slot) {
    layout_.slots.push_back(slot);
    layout_.springs.emplace_back().fill(-1);
    return static_cast<int>(layout_.slots.size()) - 1 - layout_.slotBegin.back();
  }

  void put(int slot, int lane, std::size_t spring) {
    const int at = layout_.slotBegin.back() + slot;
    layout_.springs[at][lane] = springs_[lane][spring].spring;
    slotOf_[lane][spring] = slot;
  }

  /// The springs of a slice, as (lane, index), by the difference of the permuted indices of their ends.
  using ByOffset = std::map<int, std::vector<std::pair<int, std::size_t>>>;

  void addConsecutiveSlots() {
    ByOffset byOffset;
    for (int lane = 0; lane < sliceLanes; ++lane) {
      const auto& springs = springs_[lane];
      for (std::size_t s = 0; s < springs.size(); ++s) {
        byOffset[springs[s].neighbour - first_ - lane].emplace_back(lane, s);
      }
    }
    std::erase_if(byOffset,
                  [](const auto& entry) { return static_cast<int>(entry.second.size()) < minConsecutiveLanes; });
    if (!paysOff(byOffset)) {
      return;
    }
    for (const auto& [offset, uses] : byOffset) {
      const int slot = newSlot({.first = first_ + offset});
      for (const auto& [lane, spring] : uses) {
        put(slot, lane, spring);
      }
    }
  }

  /// Whether consecutive slots make the slice cheaper. The remaining springs need gathers; the lane with most of them
  /// determines how many. The fan is then split between both kinds of slots, which makes the normals more expensive.
  [[nodiscard]] bool paysOff(const ByOffset& consecutive) const {
    std::array<std::size_t, sliceLanes> left{};
    std::size_t maxSprings = 0;
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      left[lane] = springs_[lane].size();
      maxSprings = std::max(maxSprings, left[lane]);
    }
    for (const auto& [offset, uses] : consecutive) {
      for (const auto& [lane, spring] : uses) {
        --left[lane];
      }
    }
    const std::size_t gathered = *std::max_element(left.begin(), left.end());
    const double mixed = static_cast<double>(consecutive.size()) + gatheredCost * static_cast<double>(gathered);
    return mixed < mixingGain * gatheredCost * static_cast<double>(maxSprings);
  }

  void addGatheredSlots() {
    const int firstGathered = static_cast<int>(layout_.slots.size()) - layout_.slotBegin.back();
    std::vector<int> tables;
    for (int lane = 0; lane < sliceLanes; ++lane) {
      std::size_t used = 0;
      auto& slots = slotOf_[lane];
      for (std::size_t s = 0; s < slots.size(); ++s) {
        if (slots[s] >= 0) {
          continue;
        }
        if (used == tables.size()) {
          tables.push_back(static_cast<int>(layout_.neighbourTables.size()));
          static_cast<void>(newSlot({.table = tables.back()}));
          auto& table = layout_.neighbourTables.emplace_back();
          for (int other = 0; other < sliceLanes; ++other) {
            table[other] = first_ + other;
          }
        }
        auto& table = layout_.neighbourTables[tables[used]];
        table[lane] = springs_[lane][s].neighbour;
        put(firstGathered + static_cast<int>(used), lane, s);
        ++used;
      }
    }
  }

  /// The slot of the spring from a lane's vertex to the vertex of that permuted index.
  [[nodiscard]] int slotTo(int lane, int index) const {
    const auto& springs = springs_[lane];
    const auto found = std::find_if(springs.begin(), springs.end(),
                                    [&](const LaneSpring& spring) { return spring.neighbour == index; });
    return slotOf_[lane][found - springs.begin()];
  }

  struct LaneTriangle {
    int lane = 0;
    int triangle = 0;
  };
  using BySlots = std::map<std::pair<int, int>, std::vector<LaneTriangle>>;

  void addUse(std::size_t corner, const LaneTriangle& use) {
    if (!model_.fabric) {
      return;
    }
    const Triangle& triangle = model_.triangles[use.triangle];
    const auto at = std::find(triangle.begin(), triangle.end(), static_cast<int>(vertexAt(use.lane)));
    layout_.cornerUses.push_back({.corner = corner,
                                  .lane = static_cast<std::size_t>(use.lane),
                                  .triangle = static_cast<std::size_t>(use.triangle),
                                  .cornerOfTriangle = static_cast<std::size_t>(at - triangle.begin())});
  }

  void addCorners() {
    BySlots bySlots;
    for (int lane = 0; lane < sliceLanes && first_ + lane < layout_.vertices; ++lane) {
      const std::size_t vertex = vertexAt(lane);
      for (const int triangle : model_.vertexTriangles[vertex]) {
        const auto [a, b] = cornerOf(vertex, triangle);
        bySlots[{slotTo(lane, a), slotTo(lane, b)}].push_back({lane, triangle});
      }
    }
    std::vector<int> tables;
    std::array<std::size_t, sliceLanes> used{};
    int end = -1;  // the second slot of the last corner
    while (!bySlots.empty()) {
      auto next = bySlots.begin();
      if (model_.fabric) {
        // The kernel of the fabric keeps a side that two corners share, so corners follow each other around a vertex.
        const auto following = bySlots.lower_bound({end, 0});
        next = following != bySlots.end() && following->first.first == end ? following : next;
      }
      addCorner(next->first, next->second, tables, used);
      end = next->first.second;
      bySlots.erase(next);
    }
  }

  void addCorner(const std::pair<int, int>& slots, const std::vector<LaneTriangle>& uses, std::vector<int>& tables,
                 std::array<std::size_t, sliceLanes>& used) {
    if (static_cast<int>(uses.size()) >= minCommonCorners) {
      SliceLayout::Corner corner{.slotA = static_cast<std::uint16_t>(slots.first),
                                 .slotB = static_cast<std::uint16_t>(slots.second)};
      for (const LaneTriangle& use : uses) {
        corner.lanes = static_cast<std::uint16_t>(corner.lanes | (1U << static_cast<unsigned>(use.lane)));
        addUse(layout_.corners.size(), use);
      }
      layout_.corners.push_back(corner);
      return;
    }
    for (const LaneTriangle& use : uses) {
      const int lane = use.lane;
      const std::size_t row = used[lane]++;
      if (row == tables.size()) {
        tables.push_back(static_cast<int>(layout_.corners.size()));
        layout_.corners.push_back({.table = static_cast<int>(layout_.cornerTables.size())});
        layout_.cornerTables.emplace_back();
      }
      addUse(static_cast<std::size_t>(tables[row]), use);
      auto& corner = layout_.corners[tables[row]];
      auto& table = layout_.cornerTables[corner.table];
      corner.lanes = static_cast<std::uint16_t>(corner.lanes | (1U << static_cast<unsigned>(lane)));
      table.a[lane] = static_cast<std::uint16_t>(slots.first);
      table.b[lane] = static_cast<std::uint16_t>(slots.second);
    }
  }

  const ClothModel& model_;
  SliceLayout& layout_;
  int first_;
  std::array<std::vector<LaneSpring>, sliceLanes> springs_;
  std::array<std::vector<int>, sliceLanes> slotOf_;
};

template <typename T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

/// Frees unused capacity.
void trim(SliceLayout& layout) {
  layout.slotBegin.shrink_to_fit();
  layout.slots.shrink_to_fit();
  layout.neighbourTables.shrink_to_fit();
  layout.cornerBegin.shrink_to_fit();
  layout.corners.shrink_to_fit();
  layout.cornerTables.shrink_to_fit();
  layout.lastNeighbourSlice.shrink_to_fit();
}

}  // namespace

std::size_t SliceLayout::bytes() const {
  return bytesOf(order) + bytesOf(indexOf) + bytesOf(slotBegin) + bytesOf(slots) + bytesOf(springs) +
         bytesOf(neighbourTables) + bytesOf(cornerBegin) + bytesOf(corners) + bytesOf(cornerTables) +
         bytesOf(cornerUses) + bytesOf(lastNeighbourSlice);
}

void finishBandwidth(SliceLayout& layout) {
  // Slices finish in order, so the values must not decrease.
  for (std::size_t s = 1; s < layout.lastNeighbourSlice.size(); ++s) {
    layout.lastNeighbourSlice[s] = std::max(layout.lastNeighbourSlice[s], layout.lastNeighbourSlice[s - 1]);
  }
  for (int s = 0; s < layout.slices(); ++s) {
    layout.sliceBandwidth = std::max(layout.sliceBandwidth, layout.lastNeighbourSlice[s] - s);
  }
}

SliceLayout buildSliceLayout(const ClothModel& model) {
  SliceLayout layout;
  layout.vertices = model.vertexCount();
  layout.order = stepOrder(model);
  layout.indexOf.resize(layout.order.size());
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    layout.indexOf[layout.order[k]] = static_cast<int>(k);
  }
  layout.isModelOrder = std::is_sorted(layout.order.begin(), layout.order.end());
  layout.slotBegin.push_back(0);
  layout.cornerBegin.push_back(0);
  const int slices = (layout.vertices + sliceLanes - 1) / sliceLanes;
  for (int slice = 0; slice < slices; ++slice) {
    SliceBuilder builder(model, layout, slice);
    builder.build();
    layout.lastNeighbourSlice.push_back(std::max(slice, builder.lastNeighbour() / sliceLanes));
    const int slots = layout.slotBegin[slice + 1] - layout.slotBegin[slice];
    layout.maxSlots = std::max(layout.maxSlots, slots);
  }
  finishBandwidth(layout);
  constexpr int maxSprings = std::numeric_limits<std::uint16_t>::max();
  if (layout.maxSlots > maxSprings) {
    throw ClothModelError(ClothModelError::Fault::TooManySprings, {.count = maxSprings});
  }
  trim(layout);
  return layout;
}

}  // namespace drape::sim::simd
