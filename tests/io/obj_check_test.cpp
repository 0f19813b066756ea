#include "io/obj_check.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

const std::string vertices = "# three corners\nv 0 0 0\nv 1.5 0 0\r\nv 0 +1e-3 0\n";

ObjText check(const std::string& text) {
  return checkObj(text, {});
}

std::string problemOf(const std::string& text) {
  return inputErrorOf([&text] { (void)check(text); });
}

TEST(ObjCheck, keepsWhatAMeshNeedsAndNothingElse) {
  const ObjText obj = check(
      vertices + "  vn 0 0 1\n\tvt 0.5 1 0 # a corner\nmtllib a.mtl\nusemtl red\ns off\n  f 1/1/1 2//1 3 # end\n");
  EXPECT_EQ(obj.text, "v 0 0 0\nv 1.5 0 0\nv 0 +1e-3 0\nvt 0.5 1\nusemtl red\nf 1/1 2 3\n");
  EXPECT_TRUE(obj.warnings.empty());
  EXPECT_EQ(obj.unusedVertices, 0);
}

TEST(ObjCheck, leavesOutColoursAfterTheCoordinates) {
  EXPECT_EQ(check("v 0 0 0 0.1 0.2 0.3\nv 1 0 0 1\nv 0 1 0 1 1\nf 1 2 3\n").text,
            "v 0 0 0\nv 1 0 0 1\nv 0 1 0\nf 1 2 3\n");
}

TEST(ObjCheck, countsNegativeNumbersBackFromTheirLine) {
  EXPECT_EQ(check(vertices + "f -3 -2 -1\n").text, "v 0 0 0\nv 1.5 0 0\nv 0 +1e-3 0\nf 1 2 3\n");
}

TEST(ObjCheck, takesFacesBeforeTheirVertices) {
  EXPECT_NO_THROW((void)check("f 1 2 3\n" + vertices));
  EXPECT_TRUE(contains(problemOf("f 1 2 4\n" + vertices), "line 1: there is no vertex 4, the file has only 3"));
}

TEST(ObjCheck, joinsContinuedLinesAndCountsThem) {
  EXPECT_EQ(check(vertices + "f 1 \\\n 2 \\\n 3\n").text, "v 0 0 0\nv 1.5 0 0\nv 0 +1e-3 0\nf 1 2 3\n");
  EXPECT_TRUE(contains(problemOf(vertices + "f 1 \\\n 2 3\nf 1 2 x\n"), "line 7: 'x'"));
  EXPECT_TRUE(contains(problemOf(vertices + "f 1 2 \\"), "ends in the middle of line 5"));
}

TEST(ObjCheck, namesTheLineOfACoordinateThatIsNoNumber) {
  for (const std::string word : {"nan", "-inf", "1e39", "1.#QNAN", "0x10", "1e5000", "--1", "+-1", "one", "1.5.2"}) {
    EXPECT_TRUE(contains(problemOf(vertices + "v 0 " + word + " 0\nf 1 2 3\n"),
                         "line 5: '" + word + "' is not a finite number"))
        << word;
  }
  EXPECT_TRUE(contains(problemOf(vertices + "v 1,5 0 0\n"), "write a point, not a comma"));
  EXPECT_TRUE(contains(problemOf(vertices + "v 1 2\n"), "line 5: a vertex needs three coordinates"));
  EXPECT_TRUE(contains(problemOf(vertices + "v\n"), "line 5: a vertex needs three coordinates"));
  EXPECT_TRUE(contains(problemOf(vertices + "v 1 2 3 0\n"), "line 5: the weight"));
}

TEST(ObjCheck, takesNumbersThatAreTooSmallOrVeryLong) {
  EXPECT_NO_THROW((void)check("v 1e-400 -1E-60 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_TRUE(contains(check("v 12345678901234567890123 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").text, "v 1.23456789"));
}

TEST(ObjCheck, namesTheLineOfAMissingCorner) {
  EXPECT_TRUE(contains(problemOf(vertices + "f 1 2 4\n"), "line 5: there is no vertex 4"));
  EXPECT_TRUE(contains(problemOf(vertices + "f 1 2 -4\n"), "line 5: there is no vertex -4, only 3 come before it"));
  EXPECT_TRUE(contains(problemOf(vertices + "f 0 1 2\n"), "line 5: vertex 0 does not exist: OBJ counts from 1"));
  EXPECT_TRUE(contains(problemOf(vertices + "f 1/1 2/1 3/1\n"), "line 5: there is no texture coordinate 1"));
  EXPECT_TRUE(contains(problemOf(vertices + "f 1 2 99999999999999999999\n"), "line 5: there is no vertex"));
}

TEST(ObjCheck, namesTheLineOfACornerThatIsNoNumber) {
  for (const std::string word : {"a", "1.5", "1/x/2", "1/1/x", "/1", "1e1", "3,4"}) {
    EXPECT_TRUE(contains(problemOf(vertices + "vt 0 0\nf 1 2 " + word + "\n"), "line 6: '" + word + "'")) << word;
  }
  EXPECT_NO_THROW((void)check(vertices + "f 1// 2/ 3\n")) << "what is meant is clear";
  EXPECT_TRUE(contains(problemOf(vertices + "f\n"), "line 5: a face needs"));
}

TEST(ObjCheck, countsPointsLinesAndUnusedVertices) {
  const ObjText obj = check(vertices + "v 5 5 5\nl 1 2 3\np 1\nf 1 2\nf 1 2 3\n");
  EXPECT_EQ(obj.facesSkipped, 4);
  EXPECT_EQ(obj.unusedVertices, 1);
}

TEST(ObjCheck, saysThatThereAreNoFaces) {
  EXPECT_TRUE(contains(problemOf(vertices), "there are no faces in it."));
  EXPECT_TRUE(contains(problemOf(vertices + "l 1 2\n"), "no faces in it but lines and points"));
  EXPECT_TRUE(contains(problemOf("solid cube\nfacet\n"), "it is not an OBJ file: line 1 begins with 'solid'"));
}

TEST(ObjCheck, warnsOfWordsThatObjDoesNotKnow) {
  const ObjText obj = check(vertices + "x 1 2 3\ny\nf 1 2 3\n");
  ASSERT_EQ(obj.warnings.size(), 1U);
  EXPECT_EQ(obj.warnings[0], "Line 5 begins with 'x', which OBJ does not know (and 1 more such): left out.");
}

TEST(ObjCheck, replacesTextureCoordinatesThatAreNoNumbers) {
  const ObjText obj = check(vertices + "vt -nan(ind) 0.5\nvt 1.#QNAN 1.#QNAN\nvt 1\nf 1/1 2/2 3/3\n");
  EXPECT_TRUE(contains(obj.text, "vt 0 0.5\nvt 0 0\nvt 1 0\n")) << obj.text;
  ASSERT_EQ(obj.warnings.size(), 1U);
  EXPECT_TRUE(contains(obj.warnings[0], "Line 5 has '-nan(ind)' as a texture coordinate"));
}

TEST(ObjCheck, reportsATruncationAtEveryByte) {
  const std::string whole =
      "o shirt\n" + vertices + "v 0.25 12.5 -3\nvt 0.5 0.5\nvt 1 0.25\nf 1/1 2/2 3/1\nf 2/2 4/1 3/1\n";
  const std::size_t firstFace = whole.find("f 1/1");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const std::string cut = whole.substr(0, size);
    if (size < firstFace + 11) {
      EXPECT_FALSE(problemOf(cut).empty()) << cut;
    } else if (cut.back() != '\n') {
      try {
        EXPECT_FALSE(check(cut).warnings.empty()) << cut;
      } catch (const messages::InputError& error) {
        EXPECT_TRUE(contains(error.what(), "ends in the middle of line 10")) << error.what();
      }
    } else {
      EXPECT_EQ(check(cut).unusedVertices, 1) << "a vertex whose face is missing is told";
    }
  }
}

TEST(ObjCheck, acceptsACommentWithoutALineBreakAtTheEnd) {
  EXPECT_TRUE(check(vertices + "f 1 2 3\n# end").warnings.empty());
}

TEST(ObjCheck, refusesZeroBytes) {
  EXPECT_TRUE(contains(problemOf(vertices + std::string("f 1 2 3\n\0\0\0", 11)), "line 6 contains a zero byte"));
}

TEST(ObjCheck, keepsStrayBytesAndLongWordsOutOfTheMessage) {
  EXPECT_TRUE(contains(problemOf("v \x1b[31m\x07 0 0\n"), "line 1: '?[31m?' is not a finite number"));
  EXPECT_LT(problemOf("v " + std::string(5000, 'x') + " 0 0\n").size(), 200U);
}

TEST(ObjCheck, findsAVertexByItsPlace) {
  EXPECT_EQ(nameObjVertex(vertices + "v 1e5 0 0\n", Vec3(100000, 0, 0)), "vertex 4 (line 5)");
}

TEST(ObjCheck, canBeCancelled) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)checkObj(vertices + "f 1 2 3\n", ImportWatch{{}, source.get_token()}), Cancelled);
}

TEST(ObjCheck, refusesAFaceOfVeryManyCorners) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 20001; ++i) {
    text += " 1";
  }
  EXPECT_TRUE(
      contains(inputErrorOf([&text] { (void)checkObj(text + "\n", {}); }), "line 4: the face has 20001 corners"));
}

}  // namespace
}  // namespace drape::io
