#include "io/import_protocol.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>
#include <cstring>

namespace drape::io {
namespace {

ImportReply someReply() {
  ImportReply reply;
  reply.mesh.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}};
  reply.mesh.uvs = {{0, 0.5}, {1, 0}, {0, 1}};
  reply.mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  reply.mesh.facesSkipped = 7;
  return reply;
}

TEST(ImportProtocol, bringsAMeshAcrossUnchanged) {
  const ImportReply reply = decodeReply(encodeReply(someReply()));
  EXPECT_EQ(reply.mesh.positions, someReply().mesh.positions);
  EXPECT_EQ(reply.mesh.uvs, someReply().mesh.uvs);
  EXPECT_EQ(reply.mesh.triangles, someReply().mesh.triangles);
  EXPECT_EQ(reply.mesh.facesSkipped, 7);
  EXPECT_EQ(reply.error, "");
}

TEST(ImportProtocol, bringsTheClipsAcross) {
  ImportReply reply = someReply();
  reply.clips = {{"walk", 1.25}, {"", 3.0}};
  EXPECT_EQ(decodeReply(encodeReply(reply)).clips, reply.clips);
}

TEST(ImportProtocol, bringsAnErrorAcross) {
  ImportReply reply;
  reply.error = "there is no mesh in it.";
  EXPECT_EQ(decodeReply(encodeReply(reply)).error, reply.error);
}

TEST(ImportProtocol, tellsProgressBeforeTheReply) {
  const std::string reply = encodeReply(someReply());
  const std::string output = std::string(1, progressByte(0.0)) + progressByte(0.37) + progressByte(1.0) + reply;
  EXPECT_EQ(progressOf(output[1]), 0.37);
  EXPECT_EQ(progressOf(output[2]), 1.0);
  EXPECT_FALSE(progressOf(reply[0]).has_value());
  EXPECT_EQ(withoutProgress(output), reply);
}

TEST(ImportProtocol, refusesEveryTruncation) {
  const std::string whole = encodeReply(someReply());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW((void)decodeReply(std::string_view(whole).substr(0, size)), messages::InputError) << size << " bytes";
  }
  EXPECT_THROW((void)decodeReply(whole + "x"), messages::InputError);
}

TEST(ImportProtocol, refusesCountsThatDoNotFitTheAnswer) {
  const std::string whole = encodeReply(someReply());
  for (std::size_t field = 0; field < 6; ++field) {
    for (const std::uint64_t value : {~std::uint64_t{0}, std::uint64_t{1} << 61, std::uint64_t{4}}) {
      std::string changed = whole;
      std::memcpy(changed.data() + 8 * field, &value, sizeof(value));
      if (field == 4 && value == 4) {
        continue;  // a valid number of skipped faces
      }
      EXPECT_THROW((void)decodeReply(changed), messages::InputError) << "field " << field;
    }
  }
}

}  // namespace
}  // namespace drape::io
