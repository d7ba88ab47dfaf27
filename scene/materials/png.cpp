#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

#include "fit/support/user_error.hpp"
#include "scene/materials/texels.hpp"

namespace shadefit::scene {
namespace {

/// The state of decoding a picture with libpng, and its error.
struct PngReading {
  std::string_view rest;  ///< the unread bytes
  std::array<char, 128> error{};
  png_structp png = nullptr;
  png_infop info = nullptr;
  PictureSize size{};
  std::size_t components = 0;

  explicit PngReading(std::string_view encoded) : rest(encoded) {}
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;
};

[[noreturn]] void end_png_reading(png_structp png, png_const_charp words) {
  auto& reading = *static_cast<PngReading*>(png_get_error_ptr(png));
  std::snprintf(reading.error.data(), reading.error.size(), "%s", words);
  png_longjmp(png, 1);
}

void pass_over_png_warning(png_structp, png_const_charp) {}

void give_png_bytes(png_structp png, png_bytep wanted, std::size_t number) {
  auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
  if (number > reading.rest.size()) png_error(png, "the file ends before the picture does");
  std::memcpy(wanted, reading.rest.data(), number);
  reading.rest.remove_prefix(number);
}

// libpng leaves the two functions below by longjmp, so they must hold no object with a destructor.

/// Reads the size, and requests 8 bits per channel without a palette. False if libpng failed.
bool begin_png(PngReading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_set_read_fn(reading.png, &reading, give_png_bytes);
  png_read_info(reading.png, reading.info);
  png_set_expand(reading.png);
  png_set_scale_16(reading.png);
  png_read_update_info(reading.png, reading.info);
  reading.size = {png_get_image_width(reading.png, reading.info),
                  png_get_image_height(reading.png, reading.info)};
  reading.components = png_get_channels(reading.png, reading.info);
  return true;
}

/// Takes decoded rows. An interlaced picture comes as seven smaller ones; the position of a texel does not
/// matter. False if libpng failed.
bool take_png_rows(PngReading& reading, std::uint8_t* row, std::span<ChannelCodes> taken) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  const bool is_interlaced = png_get_interlace_type(reading.png, reading.info) != PNG_INTERLACE_NONE;
  const auto width = static_cast<png_uint_32>(reading.size.width);
  const auto height = static_cast<png_uint_32>(reading.size.height);
  for (unsigned pass = 0; pass < (is_interlaced ? unsigned{PNG_INTERLACE_ADAM7_PASSES} : 1u); ++pass) {
    const png_uint_32 columns = is_interlaced ? PNG_PASS_COLS(width, pass) : width;
    const png_uint_32 rows = columns == 0 ? 0 : is_interlaced ? PNG_PASS_ROWS(height, pass) : height;
    for (png_uint_32 y = 0; y < rows; ++y) {
      png_read_row(reading.png, row, nullptr);
      take_texels(row, columns, reading.components, taken);
    }
  }
  return true;
}

}  // namespace

void take_png(std::string_view encoded, const SizeCheck& check, std::span<ChannelCodes> taken) {
  PngReading reading(encoded);
  reading.png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, end_png_reading, pass_over_png_warning);
  if (reading.png != nullptr) reading.info = png_create_info_struct(reading.png);
  if (reading.info == nullptr) throw std::bad_alloc();
  const auto refuse = [&] { throw UserError(fmt::format("the PNG is damaged: {}", reading.error.data())); };
  if (!begin_png(reading)) refuse();
  check(reading.size);
  std::vector<std::uint8_t> row(png_get_rowbytes(reading.png, reading.info));
  if (!take_png_rows(reading, row.data(), taken)) refuse();
}

}  // namespace shadefit::scene
