#include "fit/errors/effect.hpp"

#include <algorithm>
#include <limits>

#include "fit/support/decimal.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

void keep_larger(Change& largest, const Change& other) {
  if (other.magnitude > largest.magnitude * (1 + equal_extrema)) largest = other;
}

Change beside(Change change, const Coordinate& coordinate) {
  change.at.second = coordinate;
  return change;
}

std::string words(const Coordinate& coordinate) {
  constexpr double longest = 1e7;  // a larger whole number is hard to read in full
  const bool is_whole = std::round(coordinate.value) == coordinate.value && coordinate.value < longest;
  return std::string(coordinate.before) + decimal(coordinate.value, is_whole ? 7 : 3) +
         std::string(coordinate.after);
}

/// "0.48 ulps", "1 ulp"; whole numbers below a thousand in full.
std::string counted_share(double value, std::string_view noun) {
  const std::string number = decimal(value, value >= 100 && value < 1000 ? 3 : 2);
  return number + " " + std::string(noun) + (number == "1" ? "" : "s");
}

std::string relative_words(const Effect& effect) {
  if (!effect.reaches_visible) return "none, as no value reaches 1/255";
  if (effect.relative.magnitude == 0) return "0 for values from 1/255 on";
  return decimal(effect.relative.magnitude, 2) + " at " + words(effect.relative.at);
}

/// Capitalises the first letter of a part that starts with a word: "exp(-1)" and "x = 1" are not changed.
std::string capitalised(std::string part) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto end = std::ranges::find_if_not(part, is_small);
  const bool is_word = end - part.begin() > 1 && (end == part.end() || *end == ' ' || *end == ',');
  if (is_word) part.front() = static_cast<char>(part.front() - 'a' + 'A');
  return part;
}

}  // namespace

void Effect::show(double before, double after, const Coordinates& at) {
  const double step = std::abs(after - before);
  if (!std::isfinite(step)) {
    absolute = {std::numeric_limits<double>::infinity(), at};
    return;
  }
  keep_larger(absolute, {step, at});
  if (std::abs(before) >= visible) {
    reaches_visible = true;
    keep_larger(relative, {step / std::abs(before), at});
  }
  half_ulps = std::max(half_ulps, step / ulp_of_half(before));
  srgb_codes = std::max(srgb_codes, std::abs(srgb_code(after) - srgb_code(before)));
}

void Effect::include(const Effect& other, const Coordinate& coordinate) {
  const bool has_coordinate = !coordinate.before.empty();
  keep_larger(absolute, has_coordinate ? beside(other.absolute, coordinate) : other.absolute);
  keep_larger(relative, has_coordinate ? beside(other.relative, coordinate) : other.relative);
  reaches_visible = reaches_visible || other.reaches_visible;
  half_ulps = std::max(half_ulps, other.half_ulps);
  srgb_codes = std::max(srgb_codes, other.srgb_codes);
}

double change_of_one_code() {
  // The change in codes is proportional to the grey times the slope of the encoding. That is largest at
  // white.
  const auto beyond = [](double change) { return srgb_code(1.0) - srgb_code(1 - change) - 1; };
  return root_between(beyond, 0, 0.5, 45);
}

std::string words(const Coordinates& place) {
  return words(place.first) + (place.second.before.empty() ? "" : ", " + words(place.second));
}

std::string sentence(const Effect& effect, std::string_view what, std::string_view lead) {
  if (effect.absolute.magnitude == 0) return "none";
  const std::string start =
      std::string(lead) + (lead.empty() ? "" : " ") + "moves " + std::string(what) + " ";
  const std::string place = words(effect.absolute.at);
  if (!std::isfinite(effect.absolute.magnitude))
    return start + "beyond the range of a double (at " + place + ")";
  return start + "by up to " + counted_share(effect.srgb_codes, "code") +
         " of 8-bit sRGB (absolute: " + decimal(effect.absolute.magnitude, 2) + " at " + place +
         "; relative: " + relative_words(effect) + "; half float: " + counted_share(effect.half_ulps, "ulp") +
         ")";
}

std::string sentences(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) {
    if (part.empty() || part == "none") continue;
    out += out.empty() ? part : ". " + capitalised(part);
  }
  return out.empty() ? "none" : out;
}

}  // namespace shadefit
