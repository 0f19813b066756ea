#include "compare_images.hpp"
#include "messages/error.hpp"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>

namespace drape::render {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.rgb.push_back(static_cast<std::uint8_t>(x * 7 % 256));
      image.rgb.push_back(static_cast<std::uint8_t>(y * 11 % 256));
      image.rgb.push_back(static_cast<std::uint8_t>((x + y) % 256));
    }
  }
  return image;
}

class ImageFile : public testing::Test {
 protected:
  ImageFile()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("drape_image_") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
  }
  ~ImageFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

TEST_F(ImageFile, PngRoundTripKeepsEveryByte) {
  const Image image = gradient(37, 21);
  writePng(image, file("picture.png"));
  const Image back = readPng(file("picture.png"));
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 21);
  EXPECT_EQ(back.rgb, image.rgb);
}

TEST_F(ImageFile, ErrorsNameTheFile) {
  const auto messageOf = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const messages::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageOf([&] { (void)readPng(file("absent.png")); }).find("absent.png"), std::string::npos);
  EXPECT_NE(messageOf([&] { writePng(gradient(2, 2), file("no/such/folder.png")); }).find("folder.png"),
            std::string::npos);
  std::ofstream(file("text.png")) << "this is not a picture";
  EXPECT_NE(messageOf([&] { (void)readPng(file("text.png")); }).find("text.png"), std::string::npos);
  EXPECT_NE(messageOf([&] { writePng(Image{}, file("empty.png")); }).find("empty.png"), std::string::npos);
}

TEST(CompareImages, CountsPixelsAndTheLargestDifference) {
  const Image a = gradient(10, 10);
  Image b = a;
  EXPECT_EQ(compareImages(a, b).pixels, 0);
  b.rgb[0] = static_cast<std::uint8_t>(b.rgb[0] + 1);
  b.rgb[30] = static_cast<std::uint8_t>(b.rgb[30] + 9);
  b.rgb[31] = static_cast<std::uint8_t>(b.rgb[31] + 3);
  const ImageDifference exact = compareImages(a, b);
  EXPECT_TRUE(exact.sameSize);
  EXPECT_EQ(exact.pixels, 2);
  EXPECT_EQ(exact.largest, 9);
  EXPECT_EQ(compareImages(a, b, 1).pixels, 1);
}

TEST(CompareImages, SeesDifferentSizes) {
  EXPECT_FALSE(compareImages(gradient(10, 10), gradient(10, 11)).sameSize);
  EXPECT_FALSE(compareImages(gradient(20, 5), gradient(10, 10)).sameSize);
}

TEST(DifferencePicture, MarksDifferentPixelsInRed) {
  const Image a = gradient(8, 8);
  Image b = a;
  b.rgb[3 * 9] = static_cast<std::uint8_t>(b.rgb[3 * 9] + 50);
  const Image picture = differencePicture(a, b);
  int red = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const bool isRed = picture.rgb[i] > picture.rgb[i + 1] + 100;
    EXPECT_EQ(isRed, i == 3 * 9);
    red += isRed ? 1 : 0;
  }
  EXPECT_EQ(red, 1);
}

}  // namespace
}  // namespace drape::render
