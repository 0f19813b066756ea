#include "io/gltf_check.hpp"

#include "glb_file.hpp"
#include "input_error.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <fstream>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

/// A triangle of three positions, in a buffer of 36 bytes.
std::string gltf(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
         uri + R"("}]})";
}

/// A folder with a file of 36 bytes, and one above it.
class GltfBuffers : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "drape-gltf-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    fs::create_directory(root_ / "inner");
    std::ofstream(root_ / "secret.bin") << std::string(36, 'b');
    std::ofstream(root_ / "inner" / "a b.bin") << std::string(36, 'a');
    std::ofstream(root_ / "inner" / "short.bin") << "abc";
    fs::create_symlink(root_ / "secret.bin", root_ / "inner" / "link.bin");
  }
  void TearDown() override { fs::remove_all(root_); }

  std::string problemOf(const std::string& uri) const {
    return inputErrorOf([&] { (void)gltfWithBuffers(gltf(uri), root_ / "inner"); });
  }

  fs::path root_;
};

TEST_F(GltfBuffers, takesInTheBufferBesideTheFile) {
  EXPECT_TRUE(contains(gltfWithBuffers(gltf("a%20b.bin"), root_ / "inner").file, "base64,YWFhYWFh"));
}

TEST_F(GltfBuffers, readsNoFileOfAnotherFolder) {
  const std::string absolute = (root_ / "secret.bin").string();
  for (const std::string& uri : {std::string("../secret.bin"), std::string("..%2Fsecret.bin"), absolute,
                                 "file://" + absolute, std::string("link.bin"), std::string(".."), std::string("."),
                                 std::string(""), std::string("https://example.org/a.bin")}) {
    EXPECT_TRUE(contains(problemOf(uri), "same folder")) << uri << ": " << problemOf(uri);
  }
  EXPECT_TRUE(contains(inputErrorOf([] { (void)gltfWithBuffers(gltf("a.bin"), {}); }), "same folder"));
}

TEST_F(GltfBuffers, namesABufferThatIsMissingOrCutOff) {
  EXPECT_TRUE(contains(problemOf("no.bin"), "'no.bin', which is not beside it"));
  EXPECT_TRUE(contains(problemOf("short.bin"), "its buffer 'short.bin' holds 3 of 36 bytes"));
}

TEST(GltfCheck, namesTheErrorInTheJson) {
  const auto problemOf = [](const std::string& text) {
    return inputErrorOf([&text] { (void)gltfWithBuffers(text, {}); });
  };
  EXPECT_TRUE(contains(problemOf(gltf("a").substr(0, 40)), "its JSON cannot be read"));
  EXPECT_TRUE(contains(problemOf("[1]"), "its JSON is not an object"));
  EXPECT_TRUE(contains(problemOf("solid x\n"), "it does not begin with '{'"));
  EXPECT_TRUE(contains(problemOf("{\n \"a\":}"), "its JSON cannot be read after line 2, column 6"));
  EXPECT_TRUE(contains(problemOf("{}"), "there is no mesh in it"));
  EXPECT_TRUE(contains(problemOf(R"({"meshes":[{}]})"), "no buffers"));
  EXPECT_TRUE(contains(problemOf(R"({"extensionsRequired":["KHR_draco_mesh_compression"],"meshes":[{}]})"),
                       "Export it without compression"));
  EXPECT_TRUE(contains(problemOf(std::string(100000, '[')), "nested deeper"));
}

std::string glb() {
  std::string json = gltf("");
  json.replace(json.find(",\"uri\":\"\""), 9, "");
  return glbFile(json, std::string(36, 'a'));
}

std::string glbProblem(const std::string& bytes) {
  return inputErrorOf([&bytes] { (void)glbWithMesh(bytes); });
}

TEST(GltfCheck, reportsATruncationOfABinaryFileAtEveryByte) {
  const std::string whole = glb();
  EXPECT_EQ(glbWithMesh(whole).file.substr(0, 4), "glTF");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_TRUE(contains(glbProblem(whole.substr(0, size)), "cut off")) << size << " bytes";
  }
}

TEST(GltfCheck, namesTheDamagedPartOfABinaryFile) {
  std::string bytes = glb();
  bytes[13] = '\x7f';
  EXPECT_TRUE(contains(glbProblem(bytes), "its first part is not the JSON"));
  bytes = glb();
  bytes[bytes.size() - 44] = '\x7f';
  EXPECT_TRUE(contains(glbProblem(bytes), "its binary data has 36 of the 127 bytes"));
  bytes = glb();
  bytes[bytes.size() - 40] = 'X';
  EXPECT_TRUE(contains(glbProblem(bytes), "its second part is not the binary data"));
  bytes = glb();
  bytes[4] = '\3';
  EXPECT_TRUE(contains(glbProblem(bytes), "binary glTF of version 3"));
  EXPECT_TRUE(contains(glbProblem("ply\n"), "it does not begin with 'glTF'"));
}

TEST(GltfCheck, namesDamageOfDataInsideTheText) {
  const auto problemOf = [](const std::string& data) {
    return inputErrorOf([&data] { (void)gltfWithBuffers(gltf("data:application/octet-stream;" + data), {}); });
  };
  EXPECT_NO_THROW((void)gltfWithBuffers(gltf("data:application/octet-stream;base64," + std::string(48, 'A')), {}));
  EXPECT_TRUE(contains(problemOf("base64," + std::string(47, 'A')), "not a multiple of 4"));
  EXPECT_TRUE(contains(problemOf("base64,!" + std::string(47, 'A')), "'!', which is no letter of base64"));
  EXPECT_TRUE(contains(problemOf("base64," + std::string(44, 'A')), "holds 33 of 36 bytes"));
  EXPECT_TRUE(contains(problemOf("hello"), "is not written as base64"));
}

}  // namespace
}  // namespace drape::io
