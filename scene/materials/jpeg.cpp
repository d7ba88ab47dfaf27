#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
// jpeglib.h uses size_t and FILE without including their headers.
#include <jpeglib.h>

#include <jerror.h>

#include <vector>

#include "fit/support/user_error.hpp"
#include "scene/materials/texels.hpp"

namespace shadefit::scene {
namespace {

/// A progressive picture has about ten scans of the whole picture. A file may hold thousands of almost empty
/// scans.
constexpr int most_scans = 64;

/// The state of decoding a picture with libjpeg, and its error.
struct JpegReading {
  std::string_view encoded;
  jpeg_decompress_struct decoder{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf back{};
  std::array<char, JMSG_LENGTH_MAX> error{};

  explicit JpegReading(std::string_view bytes) : encoded(bytes) {}
  ~JpegReading() { jpeg_destroy_decompress(&decoder); }
  JpegReading(const JpegReading&) = delete;
  JpegReading& operator=(const JpegReading&) = delete;
};

JpegReading& reading_of(j_common_ptr decoder) {
  return *static_cast<JpegReading*>(decoder->client_data);
}

[[noreturn]] void end_jpeg_reading(j_common_ptr decoder) {
  JpegReading& reading = reading_of(decoder);
  decoder->err->format_message(decoder, reading.error.data());
  std::longjmp(reading.back, 1);
}

/// Ends at missing data: libjpeg would invent it with only a warning.
void end_at_missing_data(j_common_ptr decoder, int level) {
  constexpr std::array damages{int{JWRN_JPEG_EOF}, int{JWRN_HIT_MARKER}, int{JWRN_HUFF_BAD_CODE},
                               int{JWRN_MUST_RESYNC}};
  const bool is_damage = std::find(damages.begin(), damages.end(), decoder->err->msg_code) != damages.end();
  if (level < 0 && is_damage) end_jpeg_reading(decoder);
}

void end_at_too_many_scans(j_common_ptr decoder) {
  JpegReading& reading = reading_of(decoder);
  if (reading.decoder.input_scan_number <= most_scans) return;
  std::snprintf(reading.error.data(), reading.error.size(), "it has more than %d scans", most_scans);
  std::longjmp(reading.back, 1);
}

// libjpeg leaves the two functions below by longjmp, so they must hold no object with a destructor.

/// Reads the header. False if libjpeg failed.
bool begin_jpeg(JpegReading& reading) {
  if (setjmp(reading.back) != 0) return false;
  jpeg_create_decompress(&reading.decoder);
  reading.decoder.client_data = &reading;
  reading.decoder.progress = &reading.progress;
  jpeg_mem_src(&reading.decoder, reinterpret_cast<const unsigned char*>(reading.encoded.data()),
               reading.encoded.size());
  jpeg_read_header(&reading.decoder, TRUE);
  return true;
}

/// Takes decoded rows: grey, or anything that libjpeg converts to RGB. False if it failed.
bool take_jpeg_rows(JpegReading& reading, std::uint8_t* row, std::span<ChannelCodes> taken) {
  if (setjmp(reading.back) != 0) return false;
  jpeg_decompress_struct& decoder = reading.decoder;
  jpeg_start_decompress(&decoder);
  while (decoder.output_scanline < decoder.output_height) {
    jpeg_read_scanlines(&decoder, &row, 1);
    take_texels(row, decoder.output_width, static_cast<std::size_t>(decoder.output_components), taken);
  }
  jpeg_finish_decompress(&decoder);
  return true;
}

}  // namespace

void take_jpeg(std::string_view encoded, const SizeCheck& check, std::span<ChannelCodes> taken) {
  JpegReading reading(encoded);
  reading.decoder.err = jpeg_std_error(&reading.errors);
  reading.decoder.client_data = &reading;
  reading.errors.error_exit = end_jpeg_reading;
  reading.errors.emit_message = end_at_missing_data;
  reading.progress.progress_monitor = end_at_too_many_scans;
  const auto refuse_jpeg = [&] {
    throw UserError(fmt::format("the JPEG is damaged: {}", reading.error.data()));
  };
  if (!begin_jpeg(reading)) refuse_jpeg();
  check({reading.decoder.image_width, reading.decoder.image_height});
  const bool is_grey = reading.decoder.jpeg_color_space == JCS_GRAYSCALE;
  reading.decoder.out_color_space = is_grey ? JCS_GRAYSCALE : JCS_RGB;
  std::vector<std::uint8_t> row(std::size_t{reading.decoder.image_width} * 3);
  if (!take_jpeg_rows(reading, row.data(), taken)) refuse_jpeg();
}

}  // namespace shadefit::scene
