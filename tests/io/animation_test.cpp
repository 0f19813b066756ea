#include "io/animation/animation.hpp"
#include "io/mesh_import.hpp"
#include "messages/error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>

namespace drape::io::animation {
namespace {

namespace fs = std::filesystem;

/// A square and a triangle with a seam of the texture between them.
std::shared_ptr<const FileMesh> smallMesh() {
  auto mesh = std::make_shared<FileMesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}};
  mesh->particle = {0, 1, 2, 3, 4};
  mesh->uvs = {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}, {0.75, 0}, {0.75, 1}, {1, 0.5}};
  mesh->corners = {0, 1, 2, 3, 1, 4, 2};
  mesh->uvCorners = {0, 1, 2, 3, 4, 6, 5};
  mesh->faceEnds = {4, 7};
  return mesh;
}

Clip smallClip(int frames, int objects = 1) {
  Clip clip;
  for (int i = 0; i < objects; ++i) {
    clip.objects.push_back({"cloth" + std::to_string(i), smallMesh()});
  }
  clip.frames = frames;
  clip.rate = 25.0;
  clip.comment = "a test";
  return clip;
}

/// Frame k is bent by k and moved by the number of the object.
Frame frameAt(const Clip& clip, int k) {
  Frame frame;
  for (std::size_t i = 0; i < clip.objects.size(); ++i) {
    Shape shape;
    for (const Vec3& at : clip.objects[i].mesh->positions) {
      shape.positions.push_back(at + Vec3(3.0 * static_cast<double>(i), 0.0, 0.125 * k * at.x() * at.x()));
      shape.normals.push_back(Vec3(-0.25 * k * at.x(), 0.0, 1.0).normalized());
    }
    frame.push_back(std::move(shape));
  }
  return frame;
}

class Animation : public ::testing::Test {
 protected:
  Animation() { fs::create_directories(folder_); }
  ~Animation() override { fs::remove_all(folder_); }

  /// Writes the first `frames` frames of a clip and returns the bytes of the file.
  std::string written(const std::string& name, const Clip& clip, int frames) {
    const auto writer = makeWriter([&](int) { return folder_ / name; }, clip);
    for (int k = 0; k < frames; ++k) {
      writer->add(frameAt(clip, k));
    }
    writer->finish();
    EXPECT_FALSE(fs::exists(folder_ / (name + ".part")));
    return bytesOf(folder_ / name);
  }

  static std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_ =
      fs::temp_directory_path() /
      ("drape_animation_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

template <typename Number>
Number at(const std::string& bytes, std::size_t offset, bool bigEndian = false) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), bytes.data() + offset, sizeof(Number));
  if (bigEndian) {
    std::reverse(raw.begin(), raw.end());
  }
  return std::bit_cast<Number>(raw);
}

void expectPoints(const std::string& bytes, std::size_t offset, bool bigEndian, const std::vector<Vec3>& points) {
  for (const Vec3& point : points) {
    for (const double wanted : point) {
      EXPECT_EQ(at<float>(bytes, offset, bigEndian), static_cast<float>(wanted));
      offset += 4;
    }
  }
}

TEST_F(Animation, objAndPlyReadBackToTheSameMesh) {
  const Clip clip = smallClip(1);
  const Frame wanted = frameAt(clip, 0);
  for (const char* name : {"a.obj", "a.ply"}) {
    (void)written(name, clip, 1);
    const ImportedMesh mesh = importMesh(folder_ / name, {});
    ASSERT_EQ(mesh.file->positions.size(), wanted[0].positions.size()) << name;
    for (std::size_t v = 0; v < wanted[0].positions.size(); ++v) {
      EXPECT_LT((mesh.file->positions[v] - wanted[0].positions[v]).norm(), 1e-6) << name;
    }
    EXPECT_EQ(mesh.file->corners, clip.objects[0].mesh->corners) << name;
    EXPECT_EQ(mesh.file->faceEnds, clip.objects[0].mesh->faceEnds) << name;
  }
  const ImportedMesh obj = importMesh(folder_ / "a.obj", {});
  EXPECT_EQ(obj.file->uvCorners, clip.objects[0].mesh->uvCorners);
  EXPECT_NE(bytesOf(folder_ / "a.obj").find("vn 0 0 1"), std::string::npos);
}

TEST_F(Animation, objHoldsSeveralObjects) {
  const Clip clip = smallClip(1, 2);
  const std::string text = written("a.obj", clip, 1);
  EXPECT_NE(text.find("\no cloth1\n"), std::string::npos);
  const ImportedMesh mesh = importMesh(folder_ / "a.obj", {});
  EXPECT_EQ(mesh.summary.components, 2);
  EXPECT_EQ(mesh.file->positions.size(), 10U);
}

TEST_F(Animation, pc2HasTheFramesThatWereWritten) {
  const Clip clip = smallClip(5);
  const std::string bytes = written("a.pc2", clip, 3);
  EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(at<std::int32_t>(bytes, 16), 5);
  EXPECT_EQ(at<std::int32_t>(bytes, 28), 3);
  ASSERT_EQ(bytes.size(), 32U + 3U * 5U * 12U);
  expectPoints(bytes, 32 + 2 * 60, false, frameAt(clip, 2)[0].positions);
}

TEST_F(Animation, mddHasTheFramesThatWereWritten) {
  for (const int frames : {3, 5}) {
    const Clip clip = smallClip(5);
    const std::string bytes = written("a.mdd", clip, frames);
    EXPECT_EQ(at<std::int32_t>(bytes, 0, true), frames);
    EXPECT_EQ(at<std::int32_t>(bytes, 4, true), 5);
    EXPECT_EQ(at<float>(bytes, 8 + 8, true), 2.0F / 25.0F);
    const std::size_t start = 8 + 4 * static_cast<std::size_t>(frames);
    ASSERT_EQ(bytes.size(), start + static_cast<std::size_t>(frames) * 60);
    expectPoints(bytes, start + 60, true, frameAt(clip, 1)[0].positions);
    expectPoints(bytes, start + 120, true, frameAt(clip, 2)[0].positions);
  }
}

TEST_F(Animation, csvHasALineForEachVertexOfEachFrame) {
  const Clip clip = smallClip(2, 2);
  const std::string text = written("a.csv", clip, 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 * 2 * 5);
  EXPECT_NE(text.find("\n1,0.04,cloth1,4,5,0.5,0.5\n"), std::string::npos) << text;
}

/// The numbers of the first list after a place.
std::vector<double> listAfter(const std::string& text, const std::string& place) {
  const std::size_t found = text.find(place);
  EXPECT_NE(found, std::string::npos) << place;
  const std::size_t open = text.find('[', found + place.size());
  const std::string list = text.substr(open, text.find(']', open) - open);
  const std::regex number(R"([-+0-9.e]+)");
  std::vector<double> numbers;
  for (std::sregex_iterator i(list.begin(), list.end(), number), end; i != end; ++i) {
    numbers.push_back(std::stod(i->str()));
  }
  return numbers;
}

TEST_F(Animation, usdHasTheTopologyAndASampleForEachFrame) {
  Clip clip = smallClip(3, 2);
  clip.metresPerUnit = 0.01;
  clip.up = 'z';
  const std::string text = written("a.usda", clip, 3);
  EXPECT_EQ(text.rfind("#usda 1.0\n", 0), 0U);
  EXPECT_NE(text.find("metersPerUnit = 0.01\n    upAxis = \"Z\"\n    startTimeCode = 0\n    endTimeCode = 2\n"),
            std::string::npos);
  const std::string second = text.substr(text.find("def Mesh \"cloth1\""));
  EXPECT_EQ(listAfter(second, "int[] faceVertexCounts ="), (std::vector<double>{4, 3}));
  EXPECT_EQ(listAfter(second, "int[] faceVertexIndices ="), (std::vector<double>{0, 1, 2, 3, 1, 4, 2}));
  EXPECT_EQ(listAfter(second, "primvars:st =").size(), 14U);
  const std::vector<double> points = listAfter(second.substr(second.find("points.timeSamples")), "        2:");
  const Frame wanted = frameAt(clip, 2);
  ASSERT_EQ(points.size(), 15U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_FLOAT_EQ(static_cast<float>(points[i]),
                    static_cast<float>(wanted[1].positions[i / 3][static_cast<Eigen::Index>(i % 3)]));
  }
}

TEST_F(Animation, glbHasTheMeshAndItsFramesAsMorphTargets) {
  for (const int frames : {1, 2, 4}) {
    const Clip clip = smallClip(4, 2);
    const std::string bytes = written("a.glb", clip, frames);
    ASSERT_EQ(at<std::uint32_t>(bytes, 8), bytes.size());
    const auto jsonSize = at<std::uint32_t>(bytes, 12);
    const auto json = nlohmann::json::parse(bytes.substr(20, jsonSize));
    const std::size_t binary = 20 + jsonSize + 8;
    EXPECT_EQ(binary + json["buffers"][0]["byteLength"].get<std::size_t>(), bytes.size());
    const auto& primitive = json["meshes"][1]["primitives"][0];
    const std::size_t targets = primitive.contains("targets") ? primitive["targets"].size() : 0;
    EXPECT_EQ(targets, static_cast<std::size_t>(frames) - 1);
    if (frames > 1) {
      const auto& accessor = json["accessors"][primitive["targets"].back()["POSITION"].get<int>()];
      const auto offset = json["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"].get<std::size_t>();
      // The last vertex of the mesh; copies of two others follow it.
      EXPECT_EQ(accessor["count"], 7);
      EXPECT_EQ(at<float>(bytes, binary + offset + 4 * 12 + 8), static_cast<float>(0.125 * (frames - 1) * 4.0));
      EXPECT_EQ(accessor["max"][2].get<float>(), static_cast<float>(0.125 * (frames - 1) * 4.0));
      const auto& sampler = json["animations"][0]["samplers"][0];
      EXPECT_EQ(json["accessors"][sampler["output"].get<int>()]["count"], frames * (frames - 1));
    }
    const ImportedMesh mesh = importMesh(folder_ / "a.glb", {});
    EXPECT_EQ(mesh.summary.components, 2);
    EXPECT_EQ(mesh.summary.triangles, 6);
    EXPECT_EQ(mesh.cloth.positions.size(), 10U);
  }
}

TEST_F(Animation, glbKeepsTheOrderOfTheVerticesOfTheFile) {
  Clip clip = smallClip(1);
  auto mesh = std::make_shared<FileMesh>(*smallMesh());
  mesh->corners = {3, 2, 1, 0, 2, 4, 1};  // in another order than the vertices
  mesh->uvCorners = {3, 2, 1, 0, 5, 6, 4};
  mesh->positions.emplace_back(5, 5, 5);  // of no triangle
  mesh->particle.push_back(-1);
  clip.objects[0].mesh = mesh;
  const std::string bytes = written("a.glb", clip, 1);
  const auto jsonSize = at<std::uint32_t>(bytes, 12);
  const auto json = nlohmann::json::parse(bytes.substr(20, jsonSize));
  const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  const auto placeOf = [&](const char* attribute) {
    const auto& accessor = json["accessors"][attributes[attribute].get<int>()];
    return 20 + jsonSize + 8 + json["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"].get<std::size_t>();
  };
  std::vector<Vec3> expected = frameAt(clip, 0)[0].positions;
  expected.push_back(expected[2]);
  expected.push_back(expected[1]);
  expectPoints(bytes, placeOf("POSITION"), false, expected);
  const std::vector<float> us{0.0F, 0.5F, 0.5F, 0.0F, 1.0F, 0.0F, 0.75F, 0.75F};
  for (std::size_t i = 0; i < us.size(); ++i) {
    EXPECT_EQ(at<float>(bytes, placeOf("TEXCOORD_0") + 8 * i), us[i]) << i;
  }
}

TEST_F(Animation, anUnfinishedFileIsRemovedAndTheOldOneStays) {
  std::ofstream(folder_ / "a.pc2") << "old";
  const Clip clip = smallClip(2);
  makeWriter([&](int) { return folder_ / "a.pc2"; }, clip)->add(frameAt(clip, 0));
  EXPECT_EQ(bytesOf(folder_ / "a.pc2"), "old");
  EXPECT_FALSE(fs::exists(folder_ / "a.pc2.part"));
}

TEST_F(Animation, refusesUnknownFormatsAndFoldersThatAreNotThere) {
  const Clip clip = smallClip(1);
  EXPECT_THROW((void)makeWriter([&](int) { return folder_ / "a.xyz"; }, clip), messages::UsageError);
  EXPECT_THROW((void)makeWriter([&](int) { return folder_ / "none"; }, clip), messages::UsageError);
  EXPECT_THROW((void)makeWriter([&](int) { return folder_ / "no" / "a.pc2"; }, clip), messages::InputError);
}

TEST_F(Animation, saysThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP();
  }
  fs::create_symlink("/dev/full", folder_ / "a.pc2.part");
  const Clip clip = smallClip(1);
  const auto writer = makeWriter([&](int) { return folder_ / "a.pc2"; }, clip);
  writer->add(frameAt(clip, 0));
  try {
    writer->finish();
    FAIL() << "a full disk was not noticed";
  } catch (const messages::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder_ / "a.pc2"));
}

}  // namespace
}  // namespace drape::io::animation
