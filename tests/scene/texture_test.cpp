#include "scene/materials/texture.hpp"

#include <gtest/gtest.h>
#include <cstdio>
// jpeglib.h uses size_t and FILE without saying where they come from.
#include <jpeglib.h>

#include <cstdlib>

#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::Picture;
using shadefit::testing::png_header;
using shadefit::testing::png_of;
using shadefit::testing::refusal;

/// Rows of grey or RGB as JPEG of the highest quality.
std::string jpeg_of(unsigned width, unsigned height, int components, std::vector<std::uint8_t> texels,
                    bool is_progressive = false) {
  jpeg_compress_struct encoder{};
  jpeg_error_mgr errors{};
  encoder.err = jpeg_std_error(&errors);
  jpeg_create_compress(&encoder);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &bytes, &size);
  encoder.image_width = width;
  encoder.image_height = height;
  encoder.input_components = components;
  encoder.in_color_space = components == 1 ? JCS_GRAYSCALE : components == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, 100, TRUE);
  if (is_progressive) jpeg_simple_progression(&encoder);
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < height) {
    JSAMPROW row =
        texels.data() + std::size_t{encoder.next_scanline} * width * static_cast<unsigned>(components);
    jpeg_write_scanlines(&encoder, &row, 1);
  }
  jpeg_finish_compress(&encoder);
  jpeg_destroy_compress(&encoder);
  const std::string encoded(reinterpret_cast<char*>(bytes), size);
  std::free(bytes);
  return encoded;
}

/// The least and the largest code of a channel.
std::pair<double, double> codes_of(const std::string& encoded, Channel channel) {
  const Range range = PictureReader().ranges(encoded, {&channel, 1}).front();
  return {255 * range.least, 255 * range.most};
}

std::string refusal_of_picture(const std::string& encoded) {
  return refusal([&] { codes_of(encoded, Channel::red); });
}

using Codes = std::pair<double, double>;

TEST(Texture, TakesEachChannel) {
  const std::string png = png_of({2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 4, 1, 20, 30, 40}});
  EXPECT_EQ(codes_of(png, Channel::red), Codes(1, 1));
  EXPECT_EQ(codes_of(png, Channel::green), Codes(2, 20));
  EXPECT_EQ(codes_of(png, Channel::alpha), Codes(4, 40));
  constexpr std::array both{Channel::blue, Channel::green};
  EXPECT_EQ(PictureReader().ranges(png, both),
            (std::vector<Range>{{3 / 255.0, 30 / 255.0}, {2 / 255.0, 20 / 255.0}}));
}

TEST(Texture, GreyIsEveryColourNoAlphaIsOpaqueAndDepthsAreEightBits) {
  const std::string grey = png_of({2, 2, PNG_COLOR_TYPE_GRAY, {5, 5, 5, 6}});
  const std::string with_alpha = png_of({1, 2, PNG_COLOR_TYPE_GRAY_ALPHA, {5, 9, 6, 10}});
  const std::string deep = png_of({2, 1, PNG_COLOR_TYPE_GRAY, {0xFF, 0xFF, 0x80, 0x80}, 16});
  const std::string bits = png_of({8, 1, PNG_COLOR_TYPE_GRAY, {0b11100000}, 1});
  const std::string palette = png_of({2, 1, PNG_COLOR_TYPE_PALETTE, {3, 4}});
  EXPECT_EQ(codes_of(grey, Channel::red), Codes(5, 6));
  EXPECT_EQ(codes_of(grey, Channel::blue), Codes(5, 6));
  EXPECT_EQ(codes_of(grey, Channel::alpha), Codes(255, 255));
  EXPECT_EQ(codes_of(with_alpha, Channel::green), Codes(5, 6));
  EXPECT_EQ(codes_of(with_alpha, Channel::alpha), Codes(9, 10));
  EXPECT_EQ(codes_of(deep, Channel::red), Codes(128, 255));
  EXPECT_EQ(codes_of(bits, Channel::red), Codes(0, 255));
  EXPECT_EQ(codes_of(palette, Channel::green), Codes(251, 252));
}

// 1 x 1 to 9 x 9: of small ones some passes are empty. Each texel in turn is the one that counts.
TEST(Texture, InterlacedOnesGiveTheSame) {
  for (std::uint32_t width = 1; width <= 9; ++width) {
    for (std::uint32_t height = 1; height <= 9; ++height) {
      for (std::size_t i = 0; i < width * height; ++i) {
        Picture picture{width, height, PNG_COLOR_TYPE_GRAY, std::vector<std::uint8_t>(width * height, 9)};
        picture.is_interlaced = true;
        picture.texels[i] = 200;
        EXPECT_EQ(codes_of(png_of(picture), Channel::red).second, 200) << width << " x " << height;
      }
    }
  }
}

TEST(Texture, ReadsJpeg) {
  EXPECT_EQ(codes_of(jpeg_of(8, 8, 1, std::vector<std::uint8_t>(64, 128)), Channel::green), Codes(128, 128));
  EXPECT_EQ(codes_of(jpeg_of(16, 8, 3, std::vector<std::uint8_t>(16 * 8 * 3, 200)), Channel::blue),
            Codes(200, 200));
}

TEST(Texture, IsRefusedByItsSizeBeforeItIsDecoded) {
  // What follows the header is a picture of one texel: whoever decoded it would say that it is damaged.
  EXPECT_EQ(refusal_of_picture(png_header(8193, 8192)),
            "the picture has 8193 x 8192 pixels, more than 67108864 together");
  EXPECT_EQ(refusal_of_picture(png_header(1000000, 1000000)),
            "the picture has 1000000 x 1000000 pixels, more than 67108864 together");
  EXPECT_EQ(refusal_of_picture(png_header(8192, 8192)), "the PNG is damaged: Not enough image data");
  std::string jpeg = jpeg_of(8, 8, 1, std::vector<std::uint8_t>(64, 128));
  const std::size_t frame = jpeg.find("\xFF\xC0");
  for (std::size_t i = 5; i < 9; i += 2) jpeg[frame + i] = '\xFF', jpeg[frame + i + 1] = '\0';
  EXPECT_EQ(refusal_of_picture(jpeg), "the picture has 65280 x 65280 pixels, more than 67108864 together");
}

TEST(Texture, PicturesOfASceneAreBoundedTogether) {
  const std::string four = png_of({2, 2, PNG_COLOR_TYPE_GRAY, {5, 5, 5, 6}});
  PictureReader reader(10);
  constexpr std::array red{Channel::red};
  reader.ranges(four, red);
  reader.ranges(four, red);
  EXPECT_EQ(refusal([&] { reader.ranges(four, red); }),
            "with its 2 x 2 pixels the pictures of the scene have more than may be read together");
}

TEST(Texture, DamagedOnesAreRefused) {
  EXPECT_EQ(refusal_of_picture("GIF89a"), "the picture is neither PNG nor JPEG");
  const std::string png = png_of({2, 2, PNG_COLOR_TYPE_GRAY, {5, 5, 5, 6}});
  EXPECT_EQ(refusal_of_picture(png.substr(0, 8)),
            "the PNG is damaged: the file ends before the picture does");
  EXPECT_EQ(refusal_of_picture(png.substr(0, 45)),
            "the PNG is damaged: the file ends before the picture does");
  std::string wrong_sum = png;
  wrong_sum[17] = 3;
  EXPECT_EQ(refusal_of_picture(wrong_sum), "the PNG is damaged: IHDR: CRC error");
  const std::string jpeg = jpeg_of(8, 8, 1, std::vector<std::uint8_t>(64, 128));
  EXPECT_EQ(refusal_of_picture(jpeg.substr(0, 20)), "the JPEG is damaged: Premature end of JPEG file");
  EXPECT_EQ(refusal_of_picture(jpeg.substr(0, jpeg.size() - 3)),
            "the JPEG is damaged: Premature end of JPEG file");
  std::string wrong_table = jpeg;
  wrong_table[wrong_table.find("\xFF\xC4") + 5] = '\xFF';
  EXPECT_EQ(refusal_of_picture(wrong_table), "the JPEG is damaged: Bogus Huffman table definition");
  EXPECT_EQ(refusal_of_picture(jpeg_of(8, 8, 4, std::vector<std::uint8_t>(256, 128))),
            "the JPEG is damaged: Unsupported color conversion request");
}

// Behind the last scan the same one again, as often as wanted: a few bytes each, and all of the picture's
// work.
TEST(Texture, ScansOfAJpegAreBounded) {
  const std::string jpeg = jpeg_of(8, 8, 1, std::vector<std::uint8_t>(64, 200), true);
  EXPECT_EQ(codes_of(jpeg, Channel::red), Codes(200, 200));
  const std::size_t last = jpeg.rfind("\xFF\xDA"), end = jpeg.rfind("\xFF\xD9");
  std::string scans;
  for (int i = 0; i < 100; ++i) scans += jpeg.substr(last, end - last);
  EXPECT_EQ(refusal_of_picture(jpeg.substr(0, end) + scans + jpeg.substr(end)),
            "the JPEG is damaged: it has more than 64 scans");
}

}  // namespace
}  // namespace shadefit::scene
