#include "sim/simd/slice_layout.hpp"

#include "fabric_cloths.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "simd_meshes.hpp"

#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>

namespace drape::sim::simd {
namespace {

using testing::everyKindOfMesh;
using testing::NamedMesh;
using testing::pinnedCloth;

class EveryMesh : public ::testing::TestWithParam<NamedMesh> {
 protected:
  void SetUp() override {
    model_ = pinnedCloth(GetParam().mesh);
    layout_ = buildSliceLayout(*model_);
  }

  /// The permuted index of the neighbour of a lane in a slot.
  [[nodiscard]] int neighbourIn(std::size_t slot, int lane) const {
    const SliceLayout::Slot& s = layout_.slots[slot];
    return s.table < 0 ? s.first + lane : layout_.neighbourTables[s.table][lane];
  }

  /// Calls visit(slice, slot) for every slot.
  template <typename Visit>
  void forEachSlot(Visit&& visit) const {
    for (int slice = 0; slice < layout_.slices(); ++slice) {
      const auto s = static_cast<std::size_t>(slice);
      for (int slot = layout_.slotBegin[s]; slot < layout_.slotBegin[s + 1]; ++slot) {
        visit(slice, static_cast<std::size_t>(slot));
      }
    }
  }

  [[nodiscard]] int vertexAt(int index) const { return layout_.order[index]; }

  std::shared_ptr<const ClothModel> model_;
  SliceLayout layout_;
};

TEST_P(EveryMesh, standsInAnOrderThatIsAPermutation) {
  ASSERT_EQ(layout_.vertices, model_->vertexCount());
  ASSERT_EQ(layout_.slices(), (model_->vertexCount() + sliceLanes - 1) / sliceLanes);
  std::vector<int> sorted = layout_.order;
  std::sort(sorted.begin(), sorted.end());
  for (int v = 0; v < model_->vertexCount(); ++v) {
    EXPECT_EQ(sorted[v], v);
    EXPECT_EQ(vertexAt(layout_.indexOf[v]), v);
  }
}

TEST_P(EveryMesh, knowsTheTrianglesOfItsCornersIfTheClothIsAFabric) {
  EXPECT_TRUE(layout_.cornerUses.empty()) << "springs need no triangles";
  const SliceLayout ofFabric = buildSliceLayout(*testing::asFabric(*model_, testing::woven()));
  EXPECT_EQ(ofFabric.cornerUses.size(), model_->vertexTriangles.values().size());
}

TEST_P(EveryMesh, hasEverySpringOnceAtEitherEndWithItsNeighbourAndRestLength) {
  const SlicedCloth<double> cloth(*model_);
  std::map<std::pair<int, int>, int> seen;  // spring and the vertex at its end
  forEachSlot([&](int slice, std::size_t slot) {
    for (int lane = 0; lane < sliceLanes; ++lane) {
      const int springIndex = layout_.springs[slot][lane];
      const double rest = cloth.restLength[slot][lane];
      if (springIndex < 0) {
        EXPECT_LT(rest, 0.0);
        continue;
      }
      const int index = slice * sliceLanes + lane;
      ASSERT_LT(index, layout_.vertices) << "no springs beyond the last vertex";
      const Spring& spring = model_->springs[springIndex];
      const int vertex = vertexAt(index);
      const int neighbour = vertexAt(neighbourIn(slot, lane));
      EXPECT_EQ(std::minmax(vertex, neighbour), std::minmax(spring.a, spring.b));
      EXPECT_EQ(rest, spring.restLength);
      ++seen[{springIndex, vertex}];
    }
  });
  EXPECT_EQ(seen.size(), 2 * model_->springs.size());
  for (const auto& [end, count] : seen) {
    EXPECT_EQ(count, 1);
  }
}

TEST_P(EveryMesh, neverLoadsOutsideItsArraysWhereNeighboursAreConsecutive) {
  forEachSlot([&](int, std::size_t slot) {
    for (const int lane : {0, sliceLanes - 1}) {
      EXPECT_GE(neighbourIn(slot, lane), layout_.slots[slot].table < 0 ? -sliceLanes : 0);
      EXPECT_LT(neighbourIn(slot, lane), (layout_.slices() + 2) * sliceLanes);
    }
  });
}

TEST_P(EveryMesh, hasEveryTriangleOnceAtEachOfItsCornersInItsOwnSense) {
  std::map<std::array<int, 3>, int> seen;  // corners, from the one that it stands at
  for (int slice = 0; slice < layout_.slices(); ++slice) {
    const auto s = static_cast<std::size_t>(slice);
    for (int c = layout_.cornerBegin[s]; c < layout_.cornerBegin[s + 1]; ++c) {
      const SliceLayout::Corner& corner = layout_.corners[c];
      for (int lane = 0; lane < sliceLanes; ++lane) {
        if ((corner.lanes >> static_cast<unsigned>(lane) & 1U) == 0U) {
          continue;
        }
        const auto l = static_cast<std::size_t>(lane);
        const bool common = corner.table < 0;
        const auto table = static_cast<std::size_t>(corner.table);
        const int a = common ? corner.slotA : layout_.cornerTables[table].a[l];
        const int b = common ? corner.slotB : layout_.cornerTables[table].b[l];
        const auto slotOf = [&](int slot) { return static_cast<std::size_t>(layout_.slotBegin[s] + slot); };
        EXPECT_GE(layout_.springs[slotOf(a)][l], 0);
        EXPECT_GE(layout_.springs[slotOf(b)][l], 0);
        ++seen[{vertexAt(slice * sliceLanes + lane), vertexAt(neighbourIn(slotOf(a), lane)),
                vertexAt(neighbourIn(slotOf(b), lane))}];
      }
    }
  }
  EXPECT_EQ(seen.size(), 3 * model_->triangles.size());
  for (const Triangle& t : model_->triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ((seen[{t[c], t[(c + 1) % 3], t[(c + 2) % 3]}]), 1);
    }
  }
}

TEST_P(EveryMesh, hasTheBandwidthOfItsSprings) {
  int last = 0;
  int bandwidth = 0;
  for (int slice = 0; slice < layout_.slices(); ++slice) {
    last = std::max(last, slice);
    const auto s = static_cast<std::size_t>(slice);
    for (int slot = layout_.slotBegin[s]; slot < layout_.slotBegin[s + 1]; ++slot) {
      for (int lane = 0; lane < sliceLanes; ++lane) {
        if (layout_.springs[slot][lane] >= 0) {
          const int other = neighbourIn(static_cast<std::size_t>(slot), lane) / sliceLanes;
          last = std::max(last, other);
          EXPECT_GE(layout_.lastNeighbourSlice[other], slice) << "the relation is symmetric";
        }
      }
    }
    EXPECT_EQ(layout_.lastNeighbourSlice[s], last);
    bandwidth = std::max(bandwidth, last - slice);
  }
  EXPECT_EQ(layout_.sliceBandwidth, bandwidth);
}

INSTANTIATE_TEST_SUITE_P(SliceLayout, EveryMesh, ::testing::ValuesIn(everyKindOfMesh()),
                         [](const auto& chosen) { return chosen.param.name; });

TEST(SliceLayout, keepsAGridsOwnOrderAndLoadsMostOfItWithoutTables) {
  const SliceLayout layout = buildSliceLayout(*testing::pinnedSheet(65));
  EXPECT_TRUE(std::is_sorted(layout.order.begin(), layout.order.end()));
  EXPECT_FALSE(layout.irregular());
}

TEST(SliceLayout, bringsNeighboursTogetherThatARandomNumberingTookApart) {
  const auto model = pinnedCloth(testing::renumbered(testing::sheet(65), 9));
  const SliceLayout layout = buildSliceLayout(*model);
  EXPECT_TRUE(layout.irregular());
  EXPECT_LE(layout.sliceBandwidth, 16)
      << "slices; there are 265, and the mesh's own numbering leads across all of them";
}

/// So that a mesh of a million vertices fits beside everything else, and a small one into the cache.
TEST(SlicedCloth, takesAtMost200BytesAVertexInFloat) {
  const std::vector<NamedMesh> meshes{{"65 x 65", testing::sheet(65)},
                                      {"257 x 257", testing::sheet(257)},
                                      {"uneven", testing::unevenSheet(129, 3)},
                                      {"renumbered", testing::renumbered(testing::unevenSheet(129, 3), 4)}};
  for (const NamedMesh& mesh : meshes) {
    const auto model = pinnedCloth(mesh.mesh);
    SlicedCloth<float> cloth(*model);
    cloth.prepare(1, 1);
    const double each = static_cast<double>(cloth.bytes()) / model->vertexCount();
    EXPECT_LE(each, 200.0) << mesh.name;
    EXPECT_GT(each, 48.0) << mesh.name << ": positions, velocities and the sweep alone need that much";
  }
}

}  // namespace
}  // namespace drape::sim::simd
