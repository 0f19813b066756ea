#include "sim/simd/sliced_fabric.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/simd/sliced_fans.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace drape::sim::simd {
namespace {

/// The entries of a slice with the same offset from vertex to neighbour share a slot of consecutive neighbours if there
/// are at least this many. Its other lanes add nothing. All other entries are gathered. The value is an estimate.
constexpr std::size_t minConsecutiveEntries = 6;

/// Keeps one of equal values. @return the index of each given value
template <typename Value>
std::vector<int> shareEqual(std::vector<Value>& values) {
  std::map<Value, int> known;
  std::vector<Value> shared;
  std::vector<int> indices;
  indices.reserve(values.size());
  for (const Value& value : values) {
    const auto [found, isNew] = known.try_emplace(value, static_cast<int>(shared.size()));
    if (isNew) {
      shared.push_back(value);
    }
    indices.push_back(found->second);
  }
  values = std::move(shared);
  return indices;
}

/// The sides of a triangle as its corner sees them: a goes to the next corner, b to the one before, c connects these.
struct SidesAtCorner {
  Eigen::Index a, c, b;
};

SidesAtCorner sidesAt(std::size_t corner) {
  const auto k = static_cast<Eigen::Index>(corner);
  return {k, (k + 1) % 3, (k + 2) % 3};
}

template <typename T>
void setMembrane(const fabric::MembraneTriangle& membrane, const fabric::RestTriangle& rest, std::size_t corner,
                 std::size_t lane, typename SlicedFabric<T>::Corner& at) {
  const Mat3 stiffness = membrane.stiffnessOfSides();
  const auto [a, c, b] = sidesAt(corner);
  at.aa[lane] += static_cast<T>(stiffness(a, a));
  at.ac[lane] += static_cast<T>(stiffness(a, c));
  at.ab[lane] += static_cast<T>(stiffness(a, b));
  at.bc[lane] += static_cast<T>(stiffness(b, c));
  at.bb[lane] += static_cast<T>(stiffness(b, b));
  at.cc[lane] += static_cast<T>(stiffness(c, c));
  // Side b comes back to the corner.
  at.restDot[lane] = static_cast<T>(-rest.sides[corner].dot(rest.sides[(corner + 2) % 3]));
}

template <typename T>
void setStiffening(const fabric::MembraneTriangle& membrane, std::size_t corner, std::size_t lane,
                   std::array<typename SlicedFabric<T>::Stiffening, 2>& at) {
  const auto [a, c, b] = sidesAt(corner);
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const auto [weights, start] = membrane.stiffeningOfSides(direction);
    at[direction].a[lane] = static_cast<T>(weights[a]);
    at[direction].c[lane] = static_cast<T>(weights[c]);
    at[direction].b[lane] = static_cast<T>(weights[b]);
    at[direction].start[lane] = static_cast<T>(start);
  }
}

/// Whether the sides of a triangle at rest are as long as the springs. In a pattern they are not at seams where one
/// piece is eased into the other.
bool fitsSprings(const ClothModel& model, int triangle) {
  constexpr double rounding = 1e-9;
  const Triangle& corners = model.triangles[triangle];
  const fabric::RestTriangle& rest = model.fabric->shape.triangles[triangle];
  for (std::size_t k = 0; k < 3 && rest.area > 0.0; ++k) {
    const int spring = springBetween(model.springEnds, corners[k], corners[(k + 1) % 3]);
    const double length = model.springs[spring].restLength;
    if (std::abs(rest.sides[k].norm() - length) > rounding * length) {
      return false;
    }
  }
  return true;
}

/// The corners, of all slices, whose triangles fit the springs in every lane.
std::vector<bool> fittingCorners(const ClothModel& model, const SliceLayout& layout) {
  std::vector<bool> fit(layout.corners.size(), true);
  if (model.hasPattern) {
    for (const SliceLayout::CornerUse& use : layout.cornerUses) {
      fit[use.corner] = fit[use.corner] && fitsSprings(model, static_cast<int>(use.triangle));
    }
  }
  return fit;
}

/// Whether all lanes of a slice have the same corners, and the springs give the rest lengths of their triangles.
bool hasCommonCorners(const SliceLayout& layout, const std::vector<bool>& fit, int slice) {
  for (int c = layout.cornerBegin[slice]; c < layout.cornerBegin[slice + 1]; ++c) {
    if (layout.corners[static_cast<std::size_t>(c)].table >= 0 || !fit[c]) {
      return false;
    }
  }
  return true;
}

template <typename T>
void setModuli(const fabric::Material& material, std::size_t lane, typename SlicedFabric<T>::Moduli& moduli) {
  const Mat3 stretch = fabric::stretchMatrix(material);
  moduli.warp[lane] = static_cast<T>(stretch(0, 0));
  moduli.weft[lane] = static_cast<T>(stretch(1, 1));
  moduli.across[lane] = static_cast<T>(stretch(0, 1));
  moduli.shear[lane] = static_cast<T>(stretch(2, 2));
  moduli.stiffeningStrain[lane] = static_cast<T>(material.stiffeningStrain);
  moduli.stiffeningWarp[lane] = static_cast<T>(material.stiffeningWarp);
  moduli.stiffeningWeft[lane] = static_cast<T>(material.stiffeningWeft);
  moduli.stiffens = moduli.stiffens || material.stiffens();
}

/// The moduli of all slices. A lane without a vertex, or with one that has no triangle, has the first material.
template <typename T>
std::vector<typename SlicedFabric<T>::Moduli> moduliOfSlices(const ClothModel& model, const SliceLayout& layout) {
  const fabric::TriangleMaterials& materials = model.fabric->materials;
  const bool isOne = materials.list().size() == 1;
  std::vector<typename SlicedFabric<T>::Moduli> moduli(isOne ? 1 : static_cast<std::size_t>(layout.slices()));
  for (std::size_t slice = 0; slice < moduli.size(); ++slice) {
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      const std::size_t index = slice * sliceLanes + lane;
      const bool hasVertex = !isOne && index < static_cast<std::size_t>(layout.vertices);
      const auto triangles = hasVertex ? model.vertexTriangles[layout.order[index]] : std::span<const int>();
      setModuli<T>(triangles.empty() ? materials.list().front() : materials[triangles.front()], lane, moduli[slice]);
    }
  }
  return moduli;
}

/// The relative damping of stretch in the lanes of a layout. Empty if all are 1.
template <typename T>
std::vector<SliceNumbers<T>> relativeDampings(const ClothModel& model, const SliceLayout& layout) {
  const std::vector<double> dampings = fabric::relativeStretchDamping(model);
  if (std::ranges::all_of(dampings, [](double damping) { return damping == 1.0; })) {
    return {};
  }
  std::vector<SliceNumbers<T>> lanes(static_cast<std::size_t>(layout.slices()));
  for (int index = 0; index < layout.vertices; ++index) {
    lanes[index / sliceLanes][index % sliceLanes] = static_cast<T>(dampings[layout.order[index]]);
  }
  return lanes;
}

/// Sets the numbers of the corners in the slices that have common ones.
template <typename T>
void setCommonCorners(const ClothModel& model, const SliceLayout& layout, SlicedFabric<T>& sliced) {
  using Stiffenings = std::array<typename SlicedFabric<T>::Stiffening, 2>;
  const fabric::Fabric& fabric = *model.fabric;
  std::vector<std::pair<typename SlicedFabric<T>::Corner, Stiffenings>> numbers(layout.corners.size());
  std::vector<bool> common(layout.corners.size(), false);
  for (int slice = 0; slice < layout.slices(); ++slice) {
    for (int c = layout.cornerBegin[slice]; c < layout.cornerBegin[slice + 1]; ++c) {
      common[c] = sliced.hasCommonCorners[slice] != 0;
    }
  }
  for (const SliceLayout::CornerUse& use : layout.cornerUses) {
    if (common[use.corner]) {
      const fabric::MembraneTriangle& membrane = fabric.membrane[use.triangle];
      auto& [corner, stiffening] = numbers[use.corner];
      setMembrane<T>(membrane, fabric.shape.triangles[use.triangle], use.cornerOfTriangle, use.lane, corner);
      setStiffening<T>(membrane, use.cornerOfTriangle, use.lane, stiffening);
    }
  }
  sliced.cornerOf = shareEqual(numbers);
  for (const auto& [corner, stiffening] : numbers) {
    sliced.corners.push_back(corner);
    if (fabric.materials.stiffen()) {
      sliced.stiffening.push_back(stiffening);
    }
  }
}

/// An entry of the bending matrix in the row of a lane's vertex.
struct LaneEntry {
  std::size_t lane;
  int neighbour;  // permuted index
  double entry;   // [N/m]
};

/// Builds the bending slots of one slice after the other.
template <typename T>
class BendingBuilder {
 public:
  BendingBuilder(const fabric::VertexMatrix& matrix, SliceLayout& layout) : matrix_(matrix), layout_(layout) {
    bending_.slotBegin.push_back(0);
    for (int slice = 0; slice < layout.slices(); ++slice) {
      addSlice(slice);
      bending_.slotBegin.push_back(static_cast<int>(bending_.slots.size()));
    }
  }

  [[nodiscard]] typename SlicedFabric<T>::Bending take() {
    bending_.entriesOf = shareEqual(bending_.entries);
    return std::move(bending_);
  }

 private:
  void addSlice(int slice) {
    const int first = slice * sliceLanes;
    std::map<int, std::vector<LaneEntry>> byOffset;
    for (int lane = 0; lane < sliceLanes && first + lane < layout_.vertices; ++lane) {
      const int vertex = layout_.order[first + lane];
      for (fabric::VertexMatrix::InnerIterator entry(matrix_, vertex); entry; ++entry) {
        if (static_cast<int>(entry.col()) != vertex) {
          const int neighbour = layout_.indexOf[entry.col()];
          byOffset[neighbour - first - lane].push_back({static_cast<std::size_t>(lane), neighbour, entry.value()});
          layout_.lastNeighbourSlice[slice] = std::max(layout_.lastNeighbourSlice[slice], neighbour / sliceLanes);
        }
      }
    }
    std::array<std::vector<LaneEntry>, sliceLanes> gathered;
    for (const auto& [offset, entries] : byOffset) {
      if (entries.size() >= minConsecutiveEntries) {
        addSlot({.first = first + offset}, entries);
        continue;
      }
      for (const LaneEntry& entry : entries) {
        gathered[entry.lane].push_back(entry);
      }
    }
    addGathered(first, gathered);
  }

  void addSlot(const SliceLayout::Slot& slot, const std::vector<LaneEntry>& entries) {
    bending_.slots.push_back(slot);
    SliceNumbers<T>& numbers = bending_.entries.emplace_back();
    numbers.fill(T(0));
    for (const LaneEntry& entry : entries) {
      numbers[entry.lane] = static_cast<T>(-entry.entry);
    }
  }

  void addGathered(int first, const std::array<std::vector<LaneEntry>, sliceLanes>& gathered) {
    std::size_t rows = 0;
    for (const std::vector<LaneEntry>& entries : gathered) {
      rows = std::max(rows, entries.size());
    }
    for (std::size_t row = 0; row < rows; ++row) {
      std::vector<LaneEntry> entries;
      SliceLayout::NeighbourTable& table = bending_.tables.emplace_back();
      for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
        const bool present = row < gathered[lane].size();
        table[lane] = present ? gathered[lane][row].neighbour : first + static_cast<int>(lane);
        if (present) {
          entries.push_back(gathered[lane][row]);
        }
      }
      addSlot({.table = static_cast<int>(bending_.tables.size()) - 1}, entries);
    }
  }

  const fabric::VertexMatrix& matrix_;
  SliceLayout& layout_;
  typename SlicedFabric<T>::Bending bending_;
};

/// Adds the rest moments at the vertices of a slice.
template <typename T>
void addMoments(const fabric::RestMoments& moments, const SliceLayout& layout, int slice,
                std::vector<typename SlicedFabric<T>::RestMoment>& rows) {
  const int first = slice * sliceLanes;
  const std::size_t begin = rows.size();
  typename SlicedFabric<T>::RestMoment none;
  for (SliceLayout::NeighbourTable& table : none.others) {
    std::iota(table.begin(), table.end(), first);
  }
  for (int lane = 0; lane < sliceLanes && first + lane < layout.vertices; ++lane) {
    const auto own = moments.at(static_cast<std::size_t>(layout.order[first + lane]));
    rows.resize(std::max(rows.size(), begin + own.size()), none);
    for (std::size_t m = 0; m < own.size(); ++m) {
      auto& row = rows[begin + m];
      row.modulus[lane] = static_cast<T>(own[m].modulus);
      for (std::size_t other = 0; other < 3; ++other) {
        row.others[other][lane] = layout.indexOf[own[m].others[other]];
      }
    }
  }
}

/// Sets the rest moments, and extends the bandwidth to the vertices that they need.
template <typename T>
void setMoments(const fabric::RestMoments& moments, SliceLayout& layout, SlicedFabric<T>& sliced) {
  sliced.momentBegin.push_back(0);
  for (int slice = 0; slice < layout.slices(); ++slice) {
    addMoments<T>(moments, layout, slice, sliced.moments);
    for (std::size_t m = sliced.momentBegin.back(); m < sliced.moments.size(); ++m) {
      for (const SliceLayout::NeighbourTable& table : sliced.moments[m].others) {
        layout.lastNeighbourSlice[slice] =
            std::max(layout.lastNeighbourSlice[slice], *std::ranges::max_element(table) / sliceLanes);
      }
    }
    sliced.momentBegin.push_back(static_cast<int>(sliced.moments.size()));
  }
  finishBandwidth(layout);
}

}  // namespace

template <typename T>
std::size_t SlicedFabric<T>::bytes() const {
  std::size_t sum = hasCommonCorners.capacity() + cornerOf.capacity() * sizeof(int) +
                    corners.capacity() * sizeof(Corner) + stiffening.capacity() * sizeof(std::array<Stiffening, 2>) +
                    spokeBegin.capacity() * sizeof(int) + spokes.capacity() * sizeof(SliceLayout::Slot) +
                    spokeTables.capacity() * sizeof(SliceLayout::NeighbourTable) + sectors.capacity() * sizeof(Sector) +
                    moduli.capacity() * sizeof(Moduli) + relativeDamping.capacity() * sizeof(SliceNumbers<T>) +
                    momentBegin.capacity() * sizeof(int) + moments.capacity() * sizeof(RestMoment);
  if (bending) {
    sum += (bending->slotBegin.capacity() + bending->entriesOf.capacity()) * sizeof(int) +
           bending->slots.capacity() * sizeof(SliceLayout::Slot) +
           bending->tables.capacity() * sizeof(SliceLayout::NeighbourTable) +
           bending->entries.capacity() * sizeof(SliceNumbers<T>);
  }
  return sum;
}

template <typename T>
SlicedFabric<T> buildSlicedFabric(const ClothModel& model, SliceLayout& layout) {
  const fabric::Fabric& fabric = *model.fabric;
  SlicedFabric<T> sliced;
  sliced.moduli = moduliOfSlices<T>(model, layout);
  sliced.relativeDamping = relativeDampings<T>(model, layout);
  const std::vector<bool> fit = fittingCorners(model, layout);
  sliced.spokeBegin.push_back(0);
  for (int slice = 0; slice < layout.slices(); ++slice) {
    const bool common = hasCommonCorners(layout, fit, slice);
    sliced.hasCommonCorners.push_back(common ? 1 : 0);
    if (!common) {
      addFansOfSlice(model, layout, slice, sliced);
    }
    sliced.spokeBegin.push_back(static_cast<int>(sliced.spokes.size()));
  }
  setCommonCorners(model, layout, sliced);
  if (fabric.bends()) {
    sliced.bending = BendingBuilder<T>(fabric.bending, layout).take();
    finishBandwidth(layout);
  }
  if (!fabric.restMoments.empty()) {
    setMoments<T>(fabric.restMoments, layout, sliced);
  }
  return sliced;
}

template struct SlicedFabric<float>;
template struct SlicedFabric<double>;
template SlicedFabric<float> buildSlicedFabric(const ClothModel& model, SliceLayout& layout);
template SlicedFabric<double> buildSlicedFabric(const ClothModel& model, SliceLayout& layout);

}  // namespace drape::sim::simd
