#pragma once

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/materials/material.hpp"
#include "tests/refusal.hpp"

/// Small scenes and pictures, made where they are wanted.
namespace shadefit::testing {

struct Picture {
  std::uint32_t width, height;
  int colour_type = PNG_COLOR_TYPE_RGB;
  std::vector<std::uint8_t> texels;  ///< row by row; of 16 bits the more significant byte first
  int depth = 8;
  bool is_interlaced = false;
};

/// A picture as PNG. A palette is 256 shades: red is the code, green 255 - code, blue 7.
inline std::string png_of(const Picture& picture) {
  std::string encoded;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &encoded,
      [](png_structp writing, png_bytep bytes, std::size_t number) {
        static_cast<std::string*>(png_get_io_ptr(writing))->append(reinterpret_cast<char*>(bytes), number);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, picture.width, picture.height, picture.depth, picture.colour_type,
               picture.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (int i = 0; i < 256; ++i)
    palette.push_back({static_cast<png_byte>(i), static_cast<png_byte>(255 - i), png_byte{7}});
  if (picture.colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 256);
  png_write_info(png, info);
  const std::size_t row_size = png_get_rowbytes(png, info);
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < picture.height; ++y) png_write_row(png, picture.texels.data() + y * row_size);
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return encoded;
}

/// The header of a PNG that claims a size, and nothing after it.
inline std::string png_header(std::uint32_t width, std::uint32_t height) {
  std::string encoded = png_of({1, 1, PNG_COLOR_TYPE_GRAY, {0}});
  std::string header = encoded.substr(12, 21);  // "IHDR", its 13 bytes and the sum of both
  const auto put = [&](std::size_t offset, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) header[offset + i] = static_cast<char>(number >> (24 - 8 * i) & 0xFF);
  };
  put(4, width);
  put(8, height);
  put(17, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(header.data()), 17)));
  return encoded.substr(0, 12) + header + encoded.substr(33);
}

/// Two by two texels RGB: roughness codes 0, 51, 255, 51 in green, metallic 0, 255, 102, 0 in blue.
inline std::string metallic_roughness_png() {
  return png_of({2, 2, PNG_COLOR_TYPE_RGB, {9, 0, 0, 9, 51, 255, 9, 255, 102, 9, 51, 0}});
}

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t j) -> unsigned {
      return i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0;
    };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t j = 0; j < 4; ++j)
      text.push_back(i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=');
  }
  return text;
}

inline std::string word(std::uint32_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(number >> 8 * i & 0xFF));
  return bytes;
}

inline std::string chunk(std::string_view kind, std::string_view content) {
  return word(static_cast<std::uint32_t>(content.size())) + std::string(kind) + std::string(content);
}

inline std::string glb_of(const std::string& chunks) {
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

/// A document of glTF with these members beside its version.
inline std::string gltf_of(const std::string& members) {
  return R"({"asset":{"version":"2.0"},)" + members + "}";
}

/// One whose only material has these members.
inline std::string gltf_of_material(const std::string& members) {
  return gltf_of(R"("materials":[{)" + members + "}]");
}

/// Members of a material.
inline std::string metal(const std::string& members) {
  return R"("pbrMetallicRoughness":{)" + members + "}";
}
inline std::string khr(const std::string& name, const std::string& members) {
  return R"("extensions":{"KHR_materials_)" + name + R"(":{)" + members + "}}";
}

/// One whose only material has a metallic-roughness texture, read from the image with these members.
inline std::string gltf_of_image(const std::string& image, const std::string& more = "") {
  return gltf_of(R"("materials":[{"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}}],)"
                 R"("textures":[{"source":0}],"images":[{)" +
                 image + "}]" + more);
}

/// What a plan needs of a material, to 12 digits: "F0 0.04, F90 1, n 0 to 30 of roughness; what is unknown;
/// what is remarked". Colours that differ are listed.
inline std::string told(const scene::Material& material) {
  const auto range = [](const scene::Range& r) {
    return r.is_constant() ? fmt::format("{:.12g}", r.most)
                           : fmt::format("{:.12g} to {:.12g}", r.least, r.most);
  };
  const auto& f0 = material.f0;
  std::string text = material.is_unlit ? "unlit, F0 " : "F0 ";
  text += range(f0[0]);
  if (f0[1] != f0[0] || f0[2] != f0[0]) text += " | " + range(f0[1]) + " | " + range(f0[2]);
  text += material.fresnel == scene::FresnelTerm::none ? ", no Fresnel, n"
                                                       : ", F90 " + range(material.f90) + ", n";
  text += " " + range(material.power);
  constexpr const char* of[]{"", " of roughness", " of gloss", " of a power"};
  text += of[static_cast<std::size_t>(material.power_texture)];
  for (const auto* lines : {&material.unknowns, &material.remarks}) {
    for (const std::string& line : *lines) text += "; " + line;
  }
  return text;
}

}  // namespace shadefit::testing
