#include "fit/rounding/lattice.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "approx/scalar.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// 17 significant digits distinguish any two doubles.
constexpr int digits_that_tell_apart = 17;

using BinaryName = std::pair<NumberFormat::Kind, std::string_view>;
constexpr std::array binary_formats{BinaryName{NumberFormat::Kind::half, HalfFormat::name},
                                    BinaryName{NumberFormat::Kind::bfloat16, Bfloat16Format::name},
                                    BinaryName{NumberFormat::Kind::single, FloatFormat::name}};

}  // namespace

std::string to_text(const NumberFormat& format) {
  const auto binary = std::ranges::find(binary_formats, format.kind, &BinaryName::first);
  return binary == binary_formats.end() ? "decimal:" + std::to_string(format.digits)
                                        : std::string(binary->second);
}

NumberFormat parse_number_format(const std::string& option, const std::string& text) {
  const auto binary = std::ranges::find(binary_formats, text, &BinaryName::second);
  if (binary != binary_formats.end()) return {binary->first};
  const std::string_view prefix = "decimal:";
  if (text.starts_with(prefix)) {
    int digits = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, digits);
    if (error != std::errc{} || stop != end || digits < 1 || digits > digits_that_tell_apart)
      throw UserError(option + " '" + text +
                      "': decimal:N takes a whole number N of significant digits from 1 to " +
                      std::to_string(digits_that_tell_apart));
    return {NumberFormat::Kind::decimal, digits};
  }
  throw UserError(option + " '" + text + "' is unknown: it must be one of float, half, bfloat16, decimal:N");
}

NumberFormat parse_evaluated_format(const std::string& option, const std::string& text) {
  for (const auto kind : {NumberFormat::Kind::half, NumberFormat::Kind::single})
    if (text == to_text(NumberFormat{kind})) return {kind};
  throw UserError(option + " '" + text + "' is unknown: it must be one of half, float");
}

std::string DecimalLattice::text(std::int64_t index) const {
  if (index == 0) return "0";
  const std::int64_t i = (index < 0 ? -index : index) - 1;
  const std::int64_t tens = fractions() / 9;
  const int power_of_ten = least_power + static_cast<int>(i / fractions());
  const std::string mantissa = std::to_string(tens + i % fractions());
  // d.ddd times 10^power_of_ten, in plain notation if that is short
  std::string plain;
  if (power_of_ten >= 0 && power_of_ten < digits) {
    const auto whole = static_cast<std::size_t>(power_of_ten) + 1;
    plain = mantissa.substr(0, whole);
    if (whole < mantissa.size()) plain += "." + mantissa.substr(whole);
  } else if (power_of_ten < 0 && power_of_ten >= -4) {
    plain = "0." + std::string(static_cast<std::size_t>(-power_of_ten - 1), '0') + mantissa;
  } else {
    plain = mantissa.substr(0, 1) + (digits > 1 ? "." + mantissa.substr(1) : "") + "e" +
            std::to_string(power_of_ten);
  }
  return (index < 0 ? "-" : "") + plain;
}

double DecimalLattice::value(std::int64_t index) const {
  return constant<double>(text(index));
}

std::int64_t DecimalLattice::nearest(double x) const {
  if (x == 0) return 0;
  std::array<char, 40> buffer{};  // "d.ddd..e-xxx"
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(x),
                                     std::chars_format::scientific, digits - 1);
  const std::string_view scientific(buffer.data(), static_cast<std::size_t>(written.ptr - buffer.data()));
  const auto e = scientific.find('e');
  const int power_of_ten = std::atoi(std::string(scientific.substr(e + 1)).c_str());
  if (power_of_ten > largest_power) return x < 0 ? -(last() + 1) : last() + 1;
  if (power_of_ten < least_power) return 0;
  std::int64_t mantissa = 0;
  for (const char digit : scientific.substr(0, e)) {
    if (digit != '.') mantissa = 10 * mantissa + (digit - '0');
  }
  const std::int64_t index = fractions() * (power_of_ten - least_power) + (mantissa - fractions() / 9) + 1;
  return x < 0 ? -index : index;
}

}  // namespace shadefit
