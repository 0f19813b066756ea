#include "io/gltf_check.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <fstream>

namespace drape {
namespace {

namespace fs = std::filesystem;

std::string gltf(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"meshes":[{}],"buffers":[{"byteLength":5,"uri":")" + uri + R"("}]})";
}

/// A folder with a file of five bytes, and one above it.
class GltfBuffers : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "drape-gltf-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    fs::create_directory(root_ / "inner");
    std::ofstream(root_ / "secret.bin") << "12345";
    std::ofstream(root_ / "inner" / "a b.bin") << "abcde";
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
  EXPECT_TRUE(contains(gltfWithBuffers(gltf("a%20b.bin"), root_ / "inner"), "base64,YWJjZGU=\""));
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
  EXPECT_TRUE(contains(problemOf("short.bin"), "its buffer 'short.bin' holds 3 of 5 bytes"));
}

TEST(GltfCheck, namesWhatIsWrongWithTheJson) {
  const auto problemOf = [](const std::string& text) {
    return inputErrorOf([&text] { (void)gltfWithBuffers(text, {}); });
  };
  EXPECT_TRUE(contains(problemOf(gltf("a").substr(0, 40)), "its JSON cannot be read"));
  EXPECT_TRUE(contains(problemOf("[1]"), "its JSON is not an object"));
  EXPECT_TRUE(contains(problemOf("{}"), "there is no mesh in it"));
  EXPECT_TRUE(contains(problemOf(R"({"meshes":[{}]})"), "no buffers"));
  EXPECT_TRUE(contains(problemOf(R"({"extensionsRequired":["KHR_draco_mesh_compression"],"meshes":[{}]})"),
                       "Export it without compression"));
  EXPECT_TRUE(contains(problemOf(std::string(100000, '[')), "nested deeper"));
}

TEST(GltfCheck, tellsOfATruncationOfABinaryFileAtEveryByte) {
  const std::string json = R"({"meshes":[{}]}  )";
  std::string glb =
      std::string("glTF\2\0\0\0", 8) + '\x25' + std::string(3, '\0') + '\x11' + std::string(3, '\0') + "JSON" + json;
  ASSERT_EQ(glb.size(), 37U);
  EXPECT_NO_THROW(checkGlb(glb));
  for (std::size_t size = 1; size < glb.size(); ++size) {
    EXPECT_TRUE(contains(inputErrorOf([&] { checkGlb(glb.substr(0, size)); }), "cut off")) << size << " bytes";
  }
  glb[12] = '\x7f';
  EXPECT_TRUE(contains(inputErrorOf([&] { checkGlb(glb); }), "is damaged"));
  EXPECT_TRUE(contains(inputErrorOf([&] { checkGlb("ply\n"); }), "it does not begin with 'glTF'"));
}

}  // namespace
}  // namespace drape
