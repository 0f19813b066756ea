#include "io/gltf_content.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

namespace drape::io {
namespace {

using Json = nlohmann::json;

/// A triangle of three positions and three numbers of corners.
Json triangle() {
  return Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":7}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "buffers":[{"byteLength":42}]})");
}

std::vector<std::string> bufferWith(std::uint16_t corner, float coordinate) {
  const std::array<float, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, coordinate};
  const std::array<std::uint16_t, 3> corners{0, 1, corner};
  std::string bytes(sizeof(positions) + sizeof(corners), '\0');
  std::memcpy(bytes.data(), positions.data(), sizeof(positions));
  std::memcpy(bytes.data() + sizeof(positions), corners.data(), sizeof(corners));
  return {bytes};
}

std::string problemOf(const Json& document, std::uint16_t corner = 2, float coordinate = 0.0F) {
  // Numbers from C++ count as signed ones until they are read from a text.
  const Json read = Json::parse(document.dump());
  return inputErrorOf([&] { (void)meshPartsOf(read, bufferWith(corner, coordinate)); });
}

/// The problem after the value at this place was replaced.
std::string problemWith(const char* place, const Json& value) {
  Json document = triangle();
  document[Json::json_pointer(place)] = value;
  return problemOf(document);
}

TEST(GltfContent, keepsOnlyWhatAMeshIsMadeOf) {
  Json document = triangle();
  document["materials"] = 5;
  document["nodes"][0]["skin"] = "damaged";
  const Json parts = meshPartsOf(document, bufferWith(2, 0.0F));
  EXPECT_FALSE(parts.contains("materials"));
  EXPECT_EQ(parts["nodes"].dump(), R"([{"mesh":0}])");
  EXPECT_EQ(parts["meshes"][0]["primitives"][0].dump(), R"({"attributes":{"POSITION":0},"indices":1})");
}

/// The triangle with a skin of one joint, and a node that makes it 100 times as large.
Json skinnedTriangle() {
  Json document = triangle();
  document["nodes"] = Json::parse(R"([{"mesh":0,"skin":0,"scale":[100,100,100]},{"children":[2]},
                                      {"translation":[0,2,0]}])");
  document["scenes"][0]["nodes"] = {0, 1};
  document["skins"] = Json::parse(R"([{"joints":[2],"inverseBindMatrices":2}])");
  document["accessors"].push_back(Json::parse(R"({"bufferView":2,"componentType":5126,"count":1,"type":"MAT4"})"));
  document["bufferViews"].push_back(Json::parse(R"({"buffer":0,"byteOffset":44,"byteLength":64})"));
  return document;
}

std::vector<std::string> bufferWithBind() {
  std::vector<std::string> buffers = bufferWith(2, 0.0F);
  const std::array<float, 16> inverseBind{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1};
  buffers[0].resize(44 + sizeof(inverseBind), '\0');
  std::memcpy(buffers[0].data() + 44, inverseBind.data(), sizeof(inverseBind));
  return buffers;
}

TEST(GltfContent, placesASkinnedMeshWhereItsJointsDoAndIgnoresItsNode) {
  const Json document = Json::parse(skinnedTriangle().dump());
  const Json parts = meshPartsOf(document, bufferWithBind());
  EXPECT_FALSE(parts["nodes"][0].contains("mesh"));
  ASSERT_EQ(parts["nodes"].size(), 4U);
  EXPECT_EQ(parts["nodes"][3]["mesh"], 0);
  EXPECT_EQ(parts["nodes"][3]["matrix"], Json::parse("[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]"));
  EXPECT_EQ(parts["scenes"][0]["nodes"], Json::parse("[0,1,3]"));
}

TEST(GltfContent, leavesASkinnedMeshAtItsNodeWhereBothAgreeOrTheSkinIsDamaged) {
  Json document = skinnedTriangle();
  document["nodes"][0].erase("scale");
  EXPECT_EQ(meshPartsOf(Json::parse(document.dump()), bufferWithBind())["nodes"][0]["mesh"], 0);
  for (const char* damage : {"/skins/0/joints/0", "/skins/0/inverseBindMatrices", "/accessors/2/bufferView"}) {
    document = skinnedTriangle();
    document[Json::json_pointer(damage)] = 77;
    EXPECT_EQ(meshPartsOf(Json::parse(document.dump()), bufferWithBind())["nodes"][0]["mesh"], 0) << damage;
  }
}

TEST(GltfContent, refusesMissingCornersAndBadCoordinates) {
  EXPECT_TRUE(contains(problemOf(triangle(), 3), "a face uses vertex 3, and its mesh has only 3"));
  EXPECT_TRUE(contains(problemOf(triangle(), 2, NAN), "vertex 2 of meshes[0].primitives[0] has a coordinate"));
}

TEST(GltfContent, namesANumberThatIsNone) {
  EXPECT_TRUE(contains(problemWith("/accessors/0/count", "x"), "accessors[0].count is not a whole number"));
  EXPECT_TRUE(contains(problemWith("/accessors/0/count", -1), "accessors[0].count is not a whole number"));
  EXPECT_TRUE(contains(problemWith("/nodes", 5), "nodes is not a list"));
  EXPECT_TRUE(contains(problemWith("/nodes/0", nullptr), "nodes[0] is not an object"));
  EXPECT_TRUE(contains(problemWith("/nodes/0/scale", Json::array({1})), "nodes[0].scale is not a list of 3 numbers"));
}

TEST(GltfContent, namesMissingParts) {
  EXPECT_TRUE(contains(problemWith("/accessors/0/bufferView", 9), "accessors[0] names bufferViews[9]"));
  EXPECT_TRUE(contains(problemWith("/accessors/0/count", 4294967295), "more than bufferViews[0] holds"));
  EXPECT_TRUE(contains(problemWith("/bufferViews/1/byteLength", 7), "ends at byte 43 of a buffer of 42"));
  EXPECT_TRUE(contains(problemWith("/scene", 4), "there are only 1"));
  EXPECT_TRUE(contains(problemWith("/scenes", Json::array()), "it has no scene"));
  EXPECT_TRUE(contains(problemWith("/scenes/0/nodes", Json::array()), "no node of its scene uses a mesh"));
  EXPECT_TRUE(contains(problemWith("/asset/version", "3.0"), "glTF of version '3.0'"));
  EXPECT_TRUE(contains(problemWith("/accessors/0/type", "VEC2"), "are not three float numbers each"));
}

TEST(GltfContent, refusesNodesThatAreNoTree) {
  EXPECT_TRUE(contains(problemWith("/nodes/0/children", Json::array({0})), "nodes[0] belongs to two nodes"));
  Json document = triangle();
  document["nodes"] = Json::parse(R"([{"children":[1,1]},{"mesh":0}])");
  EXPECT_TRUE(contains(problemOf(document), "nodes[1] belongs to two nodes"));
  for (int i = 0; i < 2000; ++i) {
    document["nodes"][static_cast<std::size_t>(i)] = Json{{"children", Json::array({i + 1})}};
  }
  document["nodes"].push_back(Json{{"mesh", 0}});
  EXPECT_TRUE(contains(problemOf(document), "nested deeper than 1000"));
}

}  // namespace
}  // namespace drape::io
