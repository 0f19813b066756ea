#include "io/stl_check.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstring>

namespace drape::io {
namespace {

const std::string textStl =
    "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "x\n";

std::string binaryStl(std::uint32_t promised, int present, float last = 1.0F) {
  std::string bytes(84, ' ');
  std::memcpy(bytes.data() + 80, &promised, sizeof(promised));
  for (int i = 0; i < present; ++i) {
    const std::array<float, 12> numbers{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, last, 0};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
    bytes.append(2, '\0');
  }
  return bytes;
}

StlBytes checkedStl(const std::string& bytes) {
  static std::string storage;
  return checkStl(bytes, bytes, storage);
}

std::string problemOfStl(const std::string& bytes) {
  return inputErrorOf([&bytes] { (void)checkedStl(bytes); });
}

TEST(StlCheck, acceptsWholeFiles) {
  EXPECT_TRUE(contains(std::string(checkedStl(textStl).bytes), "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"));
  const std::string binary = binaryStl(2, 2);
  EXPECT_EQ(checkedStl(binary).bytes, binary);
}

TEST(StlCheck, takesABinaryFileThatBeginsWithSolid) {
  std::string bytes = binaryStl(2, 2);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(checkedStl(bytes).bytes, bytes);
}

TEST(StlCheck, leavesOutConclusionsTheLastTriangle) {
  const std::string bytes = binaryStl(2, 2) + "made by hand";
  EXPECT_EQ(checkedStl(bytes).bytes.size(), 84U + 100U);
}

TEST(StlCheck, warnsOfTrianglesThatTheHeaderDoesNotPromise) {
  EXPECT_TRUE(checkedStl(binaryStl(2, 2) + "made by hand").warnings.empty());
  EXPECT_TRUE(
      contains(checkedStl(binaryStl(1, 3)).warnings.at(0), "The last 100 bytes are more than its header promises"));
}

TEST(StlCheck, needsNeitherNormalsNorShortNames) {
  std::string bytes = textStl;
  bytes.replace(bytes.find("0 0 1"), 5, "x nan");
  bytes.replace(0, 7, "solid " + std::string(100000, 'x'));
  const std::string written(checkedStl(bytes).bytes);
  EXPECT_EQ(written, checkedStl(textStl).bytes);
}

TEST(StlCheck, refusesACornerOutsideOfAFacet) {
  std::string bytes = textStl;
  bytes.erase(bytes.find("facet"), std::string("facet normal 0 0 1\n").size());
  EXPECT_TRUE(contains(problemOfStl(bytes), "line 3: a vertex stands outside of a facet"));
}

TEST(StlCheck, refusesEveryTruncation) {
  const std::string binary = binaryStl(2, 2);
  for (std::size_t size = 1; size < binary.size(); ++size) {
    EXPECT_TRUE(contains(problemOfStl(binary.substr(0, size)), "cut off")) << size << " bytes";
  }
  // The name after the last "endsolid" may be missing.
  for (std::size_t size = 6; size < textStl.find("endsolid x") + 8; ++size) {
    EXPECT_TRUE(contains(problemOfStl(textStl.substr(0, size)), "cut off") ||
                contains(problemOfStl(textStl.substr(0, size)), "there are no faces"))
        << size << " bytes";
  }
}

TEST(StlCheck, namesTheLineOfADamagedByte) {
  std::string bytes = textStl;
  bytes[bytes.find("vertex 1")] = '\x07';
  EXPECT_TRUE(contains(problemOfStl(bytes), "line 5: '?ertex' is not a word of an STL file"));
  bytes = textStl;
  bytes[bytes.find("1 0 0")] = 'x';
  EXPECT_TRUE(contains(problemOfStl(bytes), "line 5: 'x' is not a finite number"));
  EXPECT_TRUE(contains(problemOfStl("solid x\nfacet\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n"),
                       "line 6: the facet before it has 1 corners"));
}

TEST(StlCheck, namesTheTriangleOfACoordinateThatIsNotFinite) {
  EXPECT_TRUE(contains(problemOfStl(binaryStl(2, 2, NAN)), "triangle 1 of 2 has a coordinate"));
}

TEST(StlCheck, saysThatThereAreNoFaces) {
  EXPECT_TRUE(contains(problemOfStl(binaryStl(0, 0)), "there are no faces"));
  EXPECT_TRUE(contains(problemOfStl("solid empty\nendsolid empty\n"), "there are no faces"));
}

}  // namespace
}  // namespace drape::io
