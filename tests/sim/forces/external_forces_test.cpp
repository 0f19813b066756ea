#include "sim/forces/external_forces.hpp"

#include "fabric_cloths.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

TEST(ExternalForces, useThePlatesAirForAFabricAndThePapersForSpringsUnlessTheUserChooses) {
  const auto springs = testing::pinnedSheet(5);
  const auto fabric = testing::asFabric(*springs, testing::woven());
  AirParameters air;
  EXPECT_FALSE(actsAsPlate(*springs, air));
  EXPECT_TRUE(actsAsPlate(*fabric, air));
  air.model = AirModel::Plate;
  EXPECT_TRUE(actsAsPlate(*springs, air));
  air.model = AirModel::Paper;
  EXPECT_FALSE(actsAsPlate(*fabric, air));
}

}  // namespace
}  // namespace drape::sim
