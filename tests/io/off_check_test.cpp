#include "io/off_check.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

const std::string squareOff = "OFF\n# a square\n4 2 0\n0 0 0\n1 0 0\n\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 3 2\n";

std::string problemOfOff(const std::string& text) {
  return inputErrorOf([&text] { (void)checkOff(text); });
}

TEST(OffCheck, keepsPositionsAndFaces) {
  EXPECT_EQ(checkOff(squareOff).text, "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
  EXPECT_EQ(checkOff("COFF 3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n").text,
            "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

TEST(OffCheck, leavesOutFacesOfTwoCorners) {
  const OffText off = checkOff("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n");
  EXPECT_EQ(off.facesSkipped, 1);
  EXPECT_TRUE(contains(off.text, "OFF\n3 1 0\n"));
}

TEST(OffCheck, reportsATruncationAtEveryByte) {
  for (std::size_t size = 1; size < squareOff.size(); ++size) {
    const std::string cut = squareOff.substr(0, size);
    if (size + 1 < squareOff.size()) {
      EXPECT_FALSE(problemOfOff(cut).empty()) << cut;
    } else {
      EXPECT_EQ(checkOff(cut).warnings.size(), 1U) << cut;
    }
  }
}

TEST(OffCheck, namesTheLineOfAnError) {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  EXPECT_TRUE(contains(problemOfOff(start + "0 nan 0\n3 0 1 2\n"), "line 5: 'nan' is not a finite number"));
  EXPECT_TRUE(contains(problemOfOff(start + "0 1\n3 0 1 2\n"), "line 5: a vertex needs three coordinates"));
  EXPECT_TRUE(contains(problemOfOff(start + "0 1 0\n3 0 1 3\n"), "line 6: there is no vertex 3"));
  EXPECT_TRUE(contains(problemOfOff(start + "0 1 0\n3 0 1 -1\n"), "line 6: '-1' is not the number of a vertex"));
  EXPECT_TRUE(contains(problemOfOff(start + "0 1 0\n4 0 1 2\n"), "line 6: the face has 3 of its 4 corners"));
  EXPECT_TRUE(contains(problemOfOff("OFF\n3 99999 0\n0 0 0\n"), "line 2: it promises 99999 faces"));
}

TEST(OffCheck, saysWhichKindsAreNotRead) {
  EXPECT_TRUE(contains(problemOfOff("OFF BINARY\n3 1 0\n"), "binary OFF"));
  EXPECT_TRUE(contains(problemOfOff("4OFF\n3 1 0\n"), "'4OFF'"));
  EXPECT_TRUE(contains(problemOfOff("v 0 0 0\n"), "it is not an OFF file: it begins with 'v'"));
  EXPECT_TRUE(contains(problemOfOff("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "there are no faces"));
}

TEST(OffCheck, warnsOfElementsBeyondTheHeader) {
  EXPECT_TRUE(checkOff(squareOff + "\n# end\n").warnings.empty());
  EXPECT_TRUE(contains(checkOff(squareOff + "3 0 1 3\n").warnings.at(0), "Line 11 and what follows it are more"));
}

}  // namespace
}  // namespace drape::io
