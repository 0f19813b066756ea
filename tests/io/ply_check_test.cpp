#include "io/ply_check.hpp"
#include "input_error.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstring>

namespace drape::io {
namespace {

std::string header(const std::string& format, const std::string& vertices = "3", const std::string& faces = "1") {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string textPly(const std::string& body) {
  return header("ascii") + body;
}

template <typename Number>
std::string bytesOf(Number value, bool bigEndian) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Number));
  return bigEndian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binaryPly(bool bigEndian, int lastIndex = 2, float lastCoordinate = 0.0F) {
  std::string bytes = header(bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, lastCoordinate}) {
    bytes += bytesOf(value, bigEndian);
  }
  bytes += '\3';
  for (const int index : {0, 1, lastIndex}) {
    bytes += bytesOf(index, bigEndian);
  }
  return bytes;
}

PlyBytes checkedPly(const std::string& bytes) {
  static std::string storage;
  return checkPly(bytes, bytes, storage);
}

std::string problemOfPly(const std::string& bytes) {
  return inputErrorOf([&bytes] { (void)checkedPly(bytes); });
}

TEST(PlyCheck, acceptsWholeFilesOfAllThreeFormats) {
  EXPECT_NO_THROW((void)checkedPly(textPly("0 0 0\n1 0 0\n0 +1e-3 0\n3 0 1 2\n")));
  EXPECT_NO_THROW((void)checkedPly(binaryPly(false)));
  EXPECT_NO_THROW((void)checkedPly(binaryPly(true)));
}

TEST(PlyCheck, refusesEveryTruncation) {
  for (const bool bigEndian : {false, true}) {
    const std::string whole = binaryPly(bigEndian);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THROW((void)checkedPly(whole.substr(0, size)), messages::InputError) << size << " bytes";
    }
  }
  const std::string whole = textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW((void)checkedPly(whole.substr(0, size)), messages::InputError) << size << " bytes";
  }
}

TEST(PlyCheck, saysWhichElementIsWrong) {
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 0 0\n")), "vertex 3 of 3 is missing"));
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")), "vertex 2 of 3 has 'nan'"));
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n")), "vertex 2 of 3 has 'x'"));
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 1.#QNAN 0\n0 1 0\n3 0 1 2\n")), "(line 12)"));
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")), "face 1 of 1 uses a vertex"));
  EXPECT_TRUE(contains(problemOfPly(binaryPly(false, -1)), "face 1 of 1 uses a vertex"));
  EXPECT_TRUE(contains(problemOfPly(binaryPly(true, 3)), "face 1 of 1 uses a vertex"));
  EXPECT_TRUE(contains(problemOfPly(binaryPly(true, 2, HUGE_VALF)), "vertex 3 of 3 has a coordinate"));
}

TEST(PlyCheck, warnsOfATextWithoutALineBreakAtTheEnd) {
  EXPECT_TRUE(checkedPly(textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).warnings.empty());
  EXPECT_EQ(checkedPly(textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2")).warnings.size(), 1U);
}

TEST(PlyCheck, saysWhichCoordinateTheVerticesLack) {
  std::string bytes = textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  bytes.replace(bytes.find("float y"), 7, "float w");
  EXPECT_TRUE(contains(problemOfPly(bytes), "its vertices have no 'y'"));
}

TEST(PlyCheck, doesNotBelieveHugeCounts) {
  for (const std::string count : {"4000000000", "18446744073709551615"}) {
    EXPECT_TRUE(contains(problemOfPly(header("binary_little_endian", count) + std::string(100, '\0')), "is missing"));
    EXPECT_TRUE(contains(problemOfPly(header("ascii", "3", count) + "0 0 0 1 0 0 0 1 0 3 0 1 2"), "is missing"));
  }
  EXPECT_TRUE(contains(problemOfPly(header("ascii", "99999999999999999999")), "not a count"));
  EXPECT_TRUE(contains(problemOfPly(header("ascii", "-1")), "not a count"));
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 0 0\n0 1 0\n1e9 0 1 2\n")), "face 1 of 1 is missing"));
}

TEST(PlyCheck, namesTheLineOfAHeaderThatItDoesNotUnderstand) {
  EXPECT_TRUE(contains(problemOfPly("solid x\n"), "first line is not 'ply'"));
  EXPECT_TRUE(contains(problemOfPly("ply\nformat ascii"), "does not end"));
  EXPECT_TRUE(
      contains(problemOfPly("ply\nformat morse 1.0\n"), "line 2 of its header names an unknown format, 'morse'"));
  EXPECT_TRUE(contains(problemOfPly("ply\nproperty float x\n"), "line 2 of its header names a property before"));
  EXPECT_TRUE(contains(problemOfPly("ply\nelement vertex 1\nproperty quad x\n"), "unknown type, 'quad'"));
  EXPECT_TRUE(contains(problemOfPly("ply\nelement face 1\nproperty list float int i\n"), "not a whole number"));
  EXPECT_TRUE(
      contains(problemOfPly("ply\nnonsense\x01\n"), "line 2 of its header has an unknown keyword: 'nonsense?'"));
}

TEST(PlyCheck, saysThatAPointCloudHasNoFaces) {
  EXPECT_TRUE(contains(problemOfPly(header("ascii", "3", "0") + "0 0 0 1 0 0 0 1 0"), "cloud of points"));
}

TEST(PlyCheck, refusesAFaceWithoutCorners) {
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 0 0\n0 1 0\n0\n")), "face 1 of 1 has no corners"));
  std::string bytes = binaryPly(false);
  bytes[bytes.size() - 13] = '\0';
  EXPECT_TRUE(contains(problemOfPly(bytes), "face 1 of 1 has no corners"));
}

TEST(PlyCheck, refusesAFaceOfVeryManyCorners) {
  std::string face = "20001";
  for (int i = 0; i < 20001; ++i) {
    face += " 0";
  }
  EXPECT_TRUE(contains(problemOfPly(textPly("0 0 0\n1 0 0\n0 1 0\n" + face + "\n")), "face 1 of 1 has 20001 corners"));
}

TEST(PlyCheck, warnsOfElementsBeyondTheHeader) {
  EXPECT_TRUE(contains(checkedPly(textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n")).warnings.at(0),
                       "Line 15 and what follows it are more than its header promises"));
  EXPECT_TRUE(
      contains(checkedPly(binaryPly(true) + std::string(13, '\0')).warnings.at(0), "The last 13 bytes are more"));
  EXPECT_TRUE(checkedPly(binaryPly(true) + "\r\n").warnings.empty());
}

TEST(PlyCheck, namesWhatItsHeaderLacks) {
  std::string bytes = textPly("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  bytes.erase(bytes.find("format"), std::string("format ascii 1.0\n").size());
  EXPECT_TRUE(contains(problemOfPly(bytes), "its header has no line 'format'"));
  bytes = binaryPly(false);
  bytes[bytes.find("vertex_indices")] = 'w';
  EXPECT_TRUE(contains(problemOfPly(bytes), "its faces have no list 'vertex_indices'"));
}

}  // namespace
}  // namespace drape::io
