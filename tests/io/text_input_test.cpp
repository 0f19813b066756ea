#include "io/text_input.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

const std::string sample = "v 0 0 0\nv 1 0 0\n";

/// ASCII as UTF-16 or UTF-32: `width` bytes per character.
std::string wide(const std::string& text, std::size_t width, bool bigEndian) {
  std::string bytes;
  for (const char letter : text) {
    const std::string zeros(width - 1, '\0');
    bytes += bigEndian ? zeros + letter : letter + zeros;
  }
  return bytes;
}

std::string plain(const std::string& bytes) {
  std::string storage;
  return std::string(plainText(bytes, storage));
}

TEST(TextInput, leavesPlainTextWhereItIs) {
  std::string storage;
  EXPECT_EQ(plainText(sample, storage).data(), sample.data());
}

TEST(TextInput, takesOffAByteOrderMark) {
  EXPECT_EQ(plain("\xef\xbb\xbf" + sample), sample);
}

TEST(TextInput, decodesWideLetters) {
  EXPECT_EQ(plain("\xff\xfe" + wide(sample, 2, false)), sample);
  EXPECT_EQ(plain("\xfe\xff" + wide(sample, 2, true)), sample);
  EXPECT_EQ(plain(wide(sample, 2, false)), sample) << "without a mark";
  EXPECT_EQ(plain(wide(sample, 2, true)), sample) << "without a mark";
  EXPECT_EQ(plain(std::string("\xff\xfe\0\0", 4) + wide(sample, 4, false)), sample);
  EXPECT_EQ(plain(std::string("\0\0\xfe\xff", 4) + wide(sample, 4, true)), sample);
}

TEST(TextInput, leavesOutHalfALetterAtTheEnd) {
  EXPECT_EQ(plain("\xff\xfe" + wide(sample, 2, false) + "v"), sample);
}

TEST(TextInput, refusesBytesThatAreNoLetters) {
  const std::string lonelySurrogate("\x00\xdc", 2);
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)plain("\xff\xfe" + wide(sample, 2, false) + lonelySurrogate + "vv"); }),
                       "line 3 contains invalid characters"));
}

TEST(TextInput, endsLinesInOneWay) {
  EXPECT_EQ(plain("a\rb\rc"), "a\nb\nc");
  EXPECT_EQ(plain("a\r\nb\rc\r"), "a \nb\nc\n");
}

TEST(TextInput, takesWordsUpToAComment) {
  std::string_view line = "  one\ttwo #three";
  EXPECT_EQ(takeWord(line), "one");
  EXPECT_EQ(takeWord(line), "two");
  EXPECT_EQ(takeWord(line), "");
}

}  // namespace
}  // namespace drape::io
