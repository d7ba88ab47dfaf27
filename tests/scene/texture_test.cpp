#include "scene/materials/texture.hpp"

#include <gtest/gtest.h>
#include <cstdio>
// jpeglib.h uses size_t and FILE without saying where they come from.
#include <jpeglib.h>

#include <cstdlib>
#include <numeric>

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

Histogram counts_of(const std::string& encoded, Channel channel) {
  return PictureReader().histograms(bytes_of(encoded), {&channel, 1}).front();
}

std::string refusal_of_picture(const std::string& encoded) {
  return refusal([&] { counts_of(encoded, Channel::red); });
}

Histogram counted(std::initializer_list<std::pair<std::size_t, std::uint32_t>> counts) {
  Histogram histogram{};
  for (const auto& [code, count] : counts) histogram[code] = count;
  return histogram;
}

TEST(Texture, IsKnownByItsFirstBytes) {
  EXPECT_EQ(picture_format(bytes_of(png_of({1, 1, PNG_COLOR_TYPE_GRAY, {0}}))), PictureFormat::png);
  EXPECT_EQ(picture_format(bytes_of(jpeg_of(1, 1, 1, {0}))), PictureFormat::jpeg);
  EXPECT_EQ(picture_format(bytes_of("RIFF....WEBP")), PictureFormat::other);
  EXPECT_EQ(picture_format(bytes_of("")), PictureFormat::other);
  EXPECT_EQ(refusal_of_picture("GIF89a"), "the picture is neither PNG nor JPEG");
}

TEST(Texture, CountsEachChannel) {
  const std::string png = png_of({2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 4, 1, 20, 30, 40}});
  EXPECT_EQ(counts_of(png, Channel::red), counted({{1, 2}}));
  EXPECT_EQ(counts_of(png, Channel::green), counted({{2, 1}, {20, 1}}));
  EXPECT_EQ(counts_of(png, Channel::alpha), counted({{4, 1}, {40, 1}}));
  constexpr std::array both{Channel::blue, Channel::green};
  const auto histograms = PictureReader().histograms(bytes_of(png), both);
  ASSERT_EQ(histograms.size(), 2u);
  EXPECT_EQ(histograms[0], counted({{3, 1}, {30, 1}}));
  EXPECT_EQ(histograms[1], counted({{2, 1}, {20, 1}}));
}

TEST(Texture, GreyIsEveryColourNoAlphaIsOpaqueAndDepthsAreEightBits) {
  const std::string grey = png_of({2, 2, PNG_COLOR_TYPE_GRAY, {5, 5, 5, 6}});
  const std::string with_alpha = png_of({1, 2, PNG_COLOR_TYPE_GRAY_ALPHA, {5, 9, 6, 10}});
  const std::string deep = png_of({2, 1, PNG_COLOR_TYPE_GRAY, {0xFF, 0xFF, 0x80, 0x80}, 16});
  const std::string bits = png_of({8, 1, PNG_COLOR_TYPE_GRAY, {0b11100000}, 1});
  const std::string palette = png_of({2, 1, PNG_COLOR_TYPE_PALETTE, {3, 4}});
  EXPECT_EQ(counts_of(grey, Channel::red), counted({{5, 3}, {6, 1}}));
  EXPECT_EQ(counts_of(grey, Channel::blue), counted({{5, 3}, {6, 1}}));
  EXPECT_EQ(counts_of(grey, Channel::alpha), counted({{255, 4}}));
  EXPECT_EQ(counts_of(with_alpha, Channel::green), counted({{5, 1}, {6, 1}}));
  EXPECT_EQ(counts_of(with_alpha, Channel::alpha), counted({{9, 1}, {10, 1}}));
  EXPECT_EQ(counts_of(deep, Channel::red), counted({{255, 1}, {128, 1}}));
  EXPECT_EQ(counts_of(bits, Channel::red), counted({{0, 5}, {255, 3}}));
  EXPECT_EQ(counts_of(palette, Channel::green), counted({{252, 1}, {251, 1}}));
}

// 1 x 1 to 9 x 9: of small ones some passes are empty.
TEST(Texture, InterlacedOnesCountTheSame) {
  for (std::uint32_t width = 1; width <= 9; ++width) {
    for (std::uint32_t height = 1; height <= 9; ++height) {
      std::vector<std::uint8_t> texels(width * height);
      std::iota(texels.begin(), texels.end(), std::uint8_t{0});
      Picture picture{width, height, PNG_COLOR_TYPE_GRAY, texels};
      const Histogram plain = counts_of(png_of(picture), Channel::red);
      picture.is_interlaced = true;
      EXPECT_EQ(counts_of(png_of(picture), Channel::red), plain) << width << " x " << height;
    }
  }
}

TEST(Texture, ReadsJpeg) {
  EXPECT_EQ(counts_of(jpeg_of(8, 8, 1, std::vector<std::uint8_t>(64, 128)), Channel::green),
            counted({{128, 64}}));
  const Histogram blue =
      counts_of(jpeg_of(16, 8, 3, std::vector<std::uint8_t>(16 * 8 * 3, 200)), Channel::blue);
  EXPECT_EQ(blue, counted({{200, 128}}));
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
  reader.histograms(bytes_of(four), red);
  reader.histograms(bytes_of(four), red);
  EXPECT_EQ(refusal([&] { reader.histograms(bytes_of(four), red); }),
            "with its 2 x 2 pixels the pictures of the scene have more than may be read together");
}

TEST(Texture, DamagedOnesAreRefused) {
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
  EXPECT_EQ(counts_of(jpeg, Channel::red), counted({{200, 64}}));
  const std::size_t last = jpeg.rfind("\xFF\xDA"), end = jpeg.rfind("\xFF\xD9");
  std::string scans;
  for (int i = 0; i < 100; ++i) scans += jpeg.substr(last, end - last);
  EXPECT_EQ(refusal_of_picture(jpeg.substr(0, end) + scans + jpeg.substr(end)),
            "the JPEG is damaged: it has more than 64 scans");
}

}  // namespace
}  // namespace shadefit::scene
