#include "messages/error.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "scene/seam_matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

namespace drape::scene {
namespace {

/// Two sheets of 5 x 5 vertices, 0.4 m wide: the front with its front towards +z, the back turned away from it.
constexpr const char* twoPieces = R"(
[[cloths]]
name = "front"
grid = "vertical"
position = [0, 1, 0.1]

[[cloths]]
name = "back"
grid = "vertical"
position = [0, 1, -0.1]
rotation = [0, 180, 0]

[settings]
grid.resolution = 5
grid.width = 0.4
grid.height = 0.4
)";

SceneDescription parse(const std::string& text) {
  return parseScene(text, "test", "test.toml", std::filesystem::current_path());
}

std::shared_ptr<const Scene> build(const std::string& text) {
  const SceneDescription description = parse(text);
  return buildScene(description, description.settings);
}

std::string refusal(const std::string& seams, const std::string& pieces = twoPieces) {
  try {
    static_cast<void>(build(pieces + seams));
  } catch (const messages::InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Expects that the scene is refused with a message that has the place and these words.
void expectRefused(const std::string& seams, const std::string& words, const std::string& pieces = twoPieces) {
  const std::string message = refusal(seams, pieces);
  EXPECT_NE(message.find(words), std::string::npos) << message;
  EXPECT_NE(message.find("test.toml:"), std::string::npos) << message;
}

TEST(Seams, joinVerticesByIndex) {
  const auto scene = build(std::string(twoPieces) +
                           "[[seams]]\ncloths = [\"front\", \"back\"]\npairs = [[0, 4], [5, 9]]\nduration = 0.5\n");
  ASSERT_EQ(scene->seams->size(), 1U);
  const sim::Seam& seam = scene->seams->front();
  EXPECT_EQ(seam.pairs, (std::vector<sim::SeamPair>{{0, 29}, {5, 34}}));
  EXPECT_EQ(seam.duration, 0.5);
}

TEST(Seams, joinPartsOfBordersVertexByVertex) {
  const auto scene = build(std::string(twoPieces) +
                           "[[seams]]\nfrom = { cloth = \"front\", vertices = [0, 20] }\n"
                           "to = { cloth = \"back\", nearest = [[-0.2, 1.2, -0.1], [-0.2, 0.8, -0.1]] }\n");
  EXPECT_EQ(scene->seams->front().pairs, (std::vector<sim::SeamPair>{{0, 29}, {5, 34}, {10, 39}, {15, 44}, {20, 49}}))
      << "the left border of the front, and the right one of the back, seen from before it";
  EXPECT_EQ(scene->seams->front().duration, 1.0);
}

TEST(Seams, takeTheLongerWayThroughAThirdPoint) {
  const auto pairsOf = [](const std::string& points) {
    return build(std::string(twoPieces) + "[[seams]]\nfrom = { cloth = \"front\", vertices = " + points +
                 " }\nto = { cloth = \"back\", vertices = " + points + " }\n")
        ->seams->front()
        .pairs.size();
  };
  EXPECT_EQ(pairsOf("[0, 4]"), 5U);
  EXPECT_EQ(pairsOf("[0, 20, 4]"), 13U);
}

TEST(Seams, joinWholeBordersSoThatTheirFrontsAgree) {
  const auto scene = build(std::string(twoPieces) +
                           "[[seams]]\nfrom = { cloth = \"front\", vertices = [0] }\n"
                           "to = { cloth = \"back\", vertices = [4] }\n");
  const std::vector<sim::SeamPair>& pairs = scene->seams->front().pairs;
  ASSERT_EQ(pairs.size(), 16U);
  EXPECT_EQ(pairs.front(), (sim::SeamPair{0, 29}));
  for (const sim::SeamPair& pair : pairs) {
    const Vec3 offset = scene->start.positions[pair.a] - scene->start.positions[pair.b];
    EXPECT_NEAR(offset.norm(), 0.2, 1e-9) << "a vertex of the front and the one behind it";
  }
}

TEST(Seams, runTheOtherWayWhenReversed) {
  const auto pairsOf = [](const std::string& front, const std::string& back, bool isReversed) {
    const auto scene =
        build(std::string(twoPieces) + "[[seams]]\nfrom = { cloth = \"front\", vertices = " + front +
              " }\nto = { cloth = \"back\", vertices = " + back + " }\n" + (isReversed ? "reversed = true\n" : ""));
    const WrittenScene written = writeScene(*scene, unchanged(*scene), std::filesystem::current_path());
    EXPECT_EQ(build(written.text)->seams->front().pairs, scene->seams->front().pairs) << written.text;
    return scene->seams->front().pairs;
  };
  EXPECT_EQ(pairsOf("[0, 20]", "[4, 24]", true), pairsOf("[0, 20]", "[24, 4]", false));
  const auto along = pairsOf("[0]", "[4]", false);
  const auto against = pairsOf("[0]", "[4]", true);
  EXPECT_EQ(against.front(), along.front()) << "both begin at the given vertices";
  EXPECT_EQ(against[1].a, along[1].a);
  EXPECT_EQ(against[1].b, along.back().b);
}

TEST(Seams, leaveTheCommonEndOfADartAlone) {
  const auto scene = build(std::string(twoPieces) +
                           "[[seams]]\nfrom = { cloth = \"front\", vertices = [0, 4] }\n"
                           "to = { cloth = \"front\", vertices = [20, 0] }\nreversed = true\n");
  const std::vector<sim::SeamPair>& pairs = scene->seams->front().pairs;
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_EQ(pairs.front(), (sim::SeamPair{1, 5}));
  EXPECT_EQ(pairs.back(), (sim::SeamPair{4, 20}));
}

TEST(Seams, pairVerticesByTheShareOfTheLength) {
  std::string finer = twoPieces;
  finer.insert(finer.find("\n[settings]"), "settings = { \"grid.resolution\" = 9 }\n");
  const auto scene = build(finer +
                           "[[seams]]\nfrom = { cloth = \"back\", vertices = [8, 80] }\n"
                           "to = { cloth = \"front\", vertices = [0, 20] }\n");
  EXPECT_EQ(scene->seams->front().pairs, (std::vector<sim::SeamPair>{{33, 0}, {51, 5}, {69, 10}, {87, 15}, {105, 20}}))
      << "every second vertex of the finer border";
  const std::vector<std::string>& warnings = scene->summary.warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find(": the sides of this seam have 9 and 5 vertices, so slits stay open"), std::string::npos)
      << warnings[0];
  EXPECT_TRUE(warnings[0].starts_with("test.toml:")) << warnings[0];
}

TEST(Seams, giveEachVertexOneOfItsOwn) {
  // The first path has most of its vertices at its end, the second one at its start.
  std::vector<Vec3> positions;
  BorderPath from;
  BorderPath to;
  for (const double x : {0.0, 0.96, 0.97, 0.98, 1.0}) {
    from.vertices.push_back(static_cast<int>(positions.size()));
    positions.emplace_back(x, 0.0, 0.0);
  }
  for (const double x : {0.0, 0.01, 0.02, 0.03, 0.04, 1.0}) {
    to.vertices.push_back(static_cast<int>(positions.size()));
    positions.emplace_back(x, 1.0, 0.0);
  }
  const std::vector<sim::SeamPair> pairs = matched(from, to, positions);
  ASSERT_EQ(pairs.size(), 5U);
  std::set<int> partners;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].a, from.vertices[i]);
    EXPECT_TRUE(partners.insert(pairs[i].b).second);
    EXPECT_TRUE(i == 0 || pairs[i].b > pairs[i - 1].b);
  }
  EXPECT_EQ(pairs.front().b, to.vertices.front());
  EXPECT_EQ(pairs.back().b, to.vertices.back());
}

TEST(Seams, areRefusedWithAReason) {
  const std::string cloths = "[[seams]]\ncloths = [\"front\", \"back\"]\n";
  expectRefused(cloths + "pairs = [[0, 25]]\n",
                "there is no vertex 25 in the cloth \"back\": its vertices are 0 to 24");
  expectRefused(cloths + "pairs = [[0, 4], [0, 9]]\n", "vertex 0 of the cloth \"front\" is in two pairs");
  expectRefused(cloths + "pairs = [[12, 4]]\n", "vertex 12 of the cloth \"front\" is not on an open border");
  expectRefused(cloths + "pairs = []\n", "at least one pair");
  expectRefused(cloths + "pairs = [[0, -1]]\n", "pairs of vertices");
  expectRefused(cloths + "pairs = [[0, 1, 2]]\n", "pairs of vertices");
  expectRefused(cloths + "pairs = [[0, 4]]\nduration = 0\n", "duration");
  expectRefused("[[seams]]\ncloths = [\"front\", \"sleeve\"]\npairs = [[0, 4]]\n",
                "there is no cloth with the name \"sleeve\"");
  expectRefused("[[seams]]\npairs = [[0, 4]]\n", "name of its cloth");
  expectRefused("[[seams]]\n", "either from and to, or pairs");
  expectRefused("[[seams]]\nfrom = { cloth = \"front\", vertices = [0] }\n", "either from and to, or pairs");
  expectRefused("[[seams]]\nfrom = { cloth = \"front\" }\nto = { cloth = \"back\", vertices = [0] }\n",
                "either vertices or nearest");
  expectRefused(
      "[[seams]]\nfrom = { cloth = \"front\", vertices = [0] }\n"
      "to = { cloth = \"back\", vertices = [0, 4] }\n",
      "one side of this seam is a whole border");
  expectRefused(
      "[[seams]]\nfrom = { cloth = \"front\", vertices = [0, 12] }\n"
      "to = { cloth = \"back\", vertices = [0, 4] }\n",
      "are not on the same open border");
  expectRefused("[[seams]]\ncloths = [\"front\", \"front\"]\npairs = [[3, 3]]\n", "cannot be sewn to itself");
  expectRefused("[[seams]]\ncloths = [\"front\", \"front\"]\npairs = [[0, 1]]\n", "two corners of one triangle");
  expectRefused(cloths + "pairs = [[0, 4]]\n" + cloths + "pairs = [[0, 4]]\n", "join these vertices already");
  expectRefused(cloths + "pairs = [[0, 4]]\nreversed = true\n", "reversed");
}

TEST(Seams, areRefusedBetweenPins) {
  std::string pinned = twoPieces;
  for (std::size_t at = pinned.find("position ="); at != std::string::npos; at = pinned.find("position =", at + 60)) {
    pinned.insert(at, "pins = { corners = [\"top_left\"] }\n");
  }
  expectRefused("[[seams]]\ncloths = [\"front\", \"back\"]\npairs = [[0, 0]]\n", "are both pinned or frozen", pinned);
}

TEST(Seams, areRefusedBetweenFabrics) {
  std::string fabrics = twoPieces;
  fabrics.insert(fabrics.find("\n[settings]"), "settings = { \"material.preset\" = \"denim\" }\n");
  fabrics += "material.model = \"fabric\"\nmaterial.preset = \"silk\"\n";
  expectRefused("[[seams]]\ncloths = [\"front\", \"back\"]\npairs = [[0, 4]]\n", "different materials", fabrics);
}

TEST(Seams, areWrittenAsTheyWereRead) {
  const auto scene = build(std::string(twoPieces) +
                           "[[seams]]\nfrom = { cloth = \"front\", vertices = [0, 20] }\n"
                           "to = { cloth = \"back\", nearest = [[-0.2, 1.2, -0.1], [-0.2, 0.8, -0.1]] }\n"
                           "[[seams]]\ncloths = [\"front\", \"back\"]\npairs = [[4, 0]]\nduration = 0.25\n");
  const WrittenScene written = writeScene(*scene, unchanged(*scene), std::filesystem::current_path());
  const auto again = build(written.text);
  ASSERT_EQ(again->seams->size(), 2U) << written.text;
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ((*again->seams)[s].pairs, (*scene->seams)[s].pairs);
    EXPECT_EQ((*again->seams)[s].duration, (*scene->seams)[s].duration);
  }
}

TEST(Seams, ofTheBuiltInDressAreItsSidesAndShoulders) {
  const SceneDescription description = openScene("sewing");
  const auto scene = buildScene(description, description.settings);
  ASSERT_EQ(scene->seams->size(), 4U);
  for (const sim::Seam& seam : *scene->seams) {
    for (const sim::SeamPair& pair : seam.pairs) {
      const Vec3 offset = scene->start.positions[pair.a] - scene->start.positions[pair.b];
      EXPECT_LT((offset - Vec3(0.0, 0.0, 0.42)).norm(), 1e-5) << "from the back straight to the front";
    }
  }
  EXPECT_EQ((*scene->seams)[0].pairs.size(), (*scene->seams)[1].pairs.size());
  EXPECT_GT((*scene->seams)[0].pairs.size(), 30U);
  EXPECT_GE((*scene->seams)[2].pairs.size(), 3U);
  EXPECT_TRUE(scene->summary.warnings.empty()) << "all sides have as many vertices as their partners";
}

}  // namespace
}  // namespace drape::scene
