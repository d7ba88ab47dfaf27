#include "scene/gltf/mtl_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "fit/support/lines.hpp"
#include "fit/support/user_error.hpp"
#include "scene/materials/messages.hpp"

namespace shadefit::scene {
namespace {

/// A line with its place in the file, for error messages.
struct MtlLine {
  const std::string& file;
  std::size_t number;
  Words words;

  [[noreturn]] void refuse(const std::string& rule) const {
    throw UserError(fmt::format("'{}', line {}: {}: {}", file, number, words.key, rule));
  }
};

/// Removes and returns the first word of the values.
std::string_view next_word(std::string_view& values) {
  const Words words = words_of_line(values);
  values = words.values;
  return words.key.starts_with('#') ? std::string_view() : words.key;
}

/// Parses a word as a number. As in C, it may begin with +.
std::errc read_number(std::string_view word, double& number) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, number);
  return end == last ? error : std::errc::invalid_argument;
}

double number_in(const MtlLine& line, std::string_view word, double most) {
  double number = 0;
  const std::errc error = read_number(word, number);
  if (error == std::errc::invalid_argument) line.refuse(fmt::format("'{}' is not a number", shortened(word)));
  if (error != std::errc() || !std::isfinite(number))
    line.refuse(fmt::format("'{}' is not a finite number of double precision", shortened(word)));
  if (number < 0 || number > most) {
    line.refuse(std::isinf(most) ? fmt::format("{} is negative", shortened(word))
                                 : fmt::format("{} is not in [0, {}]", shortened(word), most));
  }
  return number;
}

/// The numbers of a line: one, or three for a colour.
std::vector<double> numbers_in(const MtlLine& line, bool is_colour, double most) {
  std::vector<double> numbers;
  std::string_view values = line.words.values;
  for (auto word = next_word(values); !word.empty(); word = next_word(values)) {
    if (numbers.size() == 3) line.refuse("it has more than three numbers");
    numbers.push_back(number_in(line, word, most));
  }
  const bool is_right = numbers.size() == 1 || (is_colour && numbers.size() == 3);
  if (!is_right) line.refuse(is_colour ? "it must have one number or three" : "it must have one number");
  return numbers;
}

double number_of(const MtlLine& line, double most) {
  return numbers_in(line, false, most).front();
}

std::array<double, 3> colour_of(const MtlLine& line) {
  const auto numbers = numbers_in(line, true, std::numeric_limits<double>::infinity());
  return {numbers.front(), numbers[numbers.size() / 2], numbers.back()};
}

int illumination_of(const MtlLine& line) {
  const double number = number_of(line, 1000);
  if (number != std::floor(number)) line.refuse("it must be a whole number");
  return static_cast<int>(number);
}

/// The most words that follow an option of a map: a first word, then numbers. 0: there is no such option.
int words_of_option(std::string_view name) {
  constexpr std::array of_one{"-imfchan", "-blendu", "-blendv", "-bm",   "-boost",
                              "-cc",      "-clamp",  "-texres", "-type", "-colorspace"};
  if (name == "-o" || name == "-s" || name == "-t") return 3;
  if (name == "-mm") return 2;
  return std::ranges::find(of_one, name) != of_one.end() ? 1 : 0;
}

ScalarMap map_of(std::string_view values) {
  ScalarMap map;
  for (;;) {
    const Words option = words_of_line(values);
    const int most_words = words_of_option(option.key);
    if (most_words == 0) break;
    values = option.values;
    for (int i = 0; i < most_words; ++i) {
      const Words word = words_of_line(values);
      double ignored = 0;
      if (i > 0 && read_number(word.key, ignored) == std::errc::invalid_argument) break;
      if (option.key == "-imfchan") {
        map.channel = word.key == "g" ? Channel::green : word.key == "b" ? Channel::blue : Channel::red;
      }
      values = word.values;
    }
  }
  map.name = values;
  return map;
}

/// Stores the values of a line in its material.
void take_line(const MtlLine& line, MtlEntry& material) {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  const std::string_view key = line.words.key;
  const auto names_a_map = [&] { return !map_of(line.words.values).name.empty(); };
  if (key == "Ns") material.shininess = number_of(line, no_limit);
  if (key == "Ni") material.index_of_refraction = number_of(line, no_limit);
  if (key == "Pr") material.roughness = number_of(line, 1);
  if (key == "Pm") material.metallic = number_of(line, 1);
  if (key == "Kd") material.diffuse = colour_of(line);
  if (key == "Ks") material.specular = colour_of(line);
  if (key == "illum") material.illumination = illumination_of(line);
  if (key == "map_Ns") material.shininess_map = map_of(line.words.values);
  if (key == "map_Ka") material.ambient_map = map_of(line.words.values);
  if (key == "map_Pr") material.roughness_map = map_of(line.words.values);
  if (key == "map_Pm") material.metallic_map = map_of(line.words.values);
  if (key == "map_Ks") material.has_specular_map = names_a_map();
  if (key == "map_Kd") material.has_diffuse_map = names_a_map();
  if (key == "map_Ke") material.has_emission_map = names_a_map();
  if (key == "map_d") material.has_opacity_map = names_a_map();
  if (key == "norm" || key == "bump" || key == "map_bump" || key == "map_Bump")
    material.has_normal_map = names_a_map();
  if (key == "Ke") material.emission = colour_of(line);
  if (key == "Tr") material.opacity = 1 - number_of(line, no_limit);
  if (key == "d") {
    const Words option = words_of_line(line.words.values);
    const std::string_view number = option.key == "-halo" ? option.values : line.words.values;
    material.opacity = number_of({line.file, line.number, {key, number}}, no_limit);
  }
  // clear coat, sheen, anisotropy
  if (key == "Pc" || key == "aniso") {
    if (number_of(line, no_limit) > 0) material.left_out.emplace(key);
  }
  if (key == "Ps" && colour_of(line) != std::array<double, 3>{}) material.left_out.emplace(key);
}

}  // namespace

Words words_of_line(std::string_view line) {
  const std::string_view text = trimmed(line);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  return {text.substr(0, end), trimmed(text.substr(end))};
}

std::vector<MtlEntry> parse_mtl(std::string_view text, const std::string& file, std::size_t most) {
  std::vector<MtlEntry> materials;
  MtlEntry before_all{};  // lines before the first material are checked but not used
  std::size_t number = 0;
  while (!text.empty()) {
    const MtlLine line{file, ++number, words_of_line(next_line(text))};
    if (line.words.key.find('\0') != std::string_view::npos ||
        line.words.values.find('\0') != std::string_view::npos) {
      throw UserError(fmt::format("'{}', line {}: there is a zero byte: this is not text", file, number));
    }
    if (line.words.key == "newmtl") {
      if (line.words.values.empty()) line.refuse("the material has no name");
      if (materials.size() == most) line.refuse(fmt::format("there are more than {} materials", most));
      materials.push_back({.name = shortened(line.words.values), .line = number});
    } else {
      take_line(line, materials.empty() ? before_all : materials.back());
    }
  }
  return materials;
}

}  // namespace shadefit::scene
