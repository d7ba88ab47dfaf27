#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A whole number without a sign, in decimal or 0x..
std::optional<std::uint32_t> parse_bits(std::string_view text) {
  const bool is_hex = text.starts_with("0x");
  if (is_hex) text.remove_prefix(2);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, is_hex ? 16 : 10);
  const bool is_whole = error == std::errc{} && end == text.data() + text.size();
  return is_whole ? std::optional(value) : std::nullopt;
}

/// "A:B" with bit patterns of floats in [0, 1].
bench::Stretch parse_range(const std::string& option, const std::string& text) {
  const auto colon = text.find(':');
  if (colon != std::string::npos) {
    const auto from = parse_bits(text.substr(0, colon)), to = parse_bits(text.substr(colon + 1));
    if (from && to && *from < *to && *to <= bench::unit_floats.to) return {*from, *to};
  }
  throw UserError(
      fmt::format("{} '{}' is not a range of bit patterns: it must be A:B with 0 <= A < B <= {:#x}", option,
                  text, bench::unit_floats.to));
}

/// "vulkan" or "vulkan:N": the place of a graphics device.
std::size_t parse_device(const std::string& option, const std::string& text) {
  if (text == "vulkan") return 0;
  const std::string kind = "vulkan:";
  const auto place = text.starts_with(kind) ? parse_bits(text.substr(kind.size())) : std::nullopt;
  if (place) return *place;
  throw UserError(fmt::format(
      "{} '{}' is not a device: it must be vulkan or vulkan:N, see 'shadefit bench --list-devices'", option,
      text));
}

}  // namespace

void declare_bench(CLI::App& bench, BenchOptions& options) {
  add_out(bench, options.out);
  auto* study = bench
                    .add_option("study", options.study,
                                "the forms of a study or its file, NAME.toml (default: the built-in ones)")
                    ->type_name("STUDY");
  auto* exhaustive = add_value(
      bench, "--exhaustive", options.exhaustive, parse_text, "FORM|all",
      "evaluate this form, or all of one cosine, at every float in [0, 1] and compare with its target in "
      "double");
  exhaustive->excludes(study);
  add_values(bench, "--only", options.only, parse_text, "TARGET", "only these targets")
      ->allow_extra_args()
      ->excludes(exhaustive)
      ->excludes(study);
  bench.add_flag("--quick", options.quick, "fewer and shorter rounds: seconds")->excludes(exhaustive);
  bench.add_flag("--no-plots", options.no_plots, "write no plots, and no data or scripts for them")
      ->excludes(exhaustive);
  add_value(bench, "--constants", options.constants, parse_text, "ID",
            "with --exhaustive: the constants of the form (default: its first)")
      ->needs(exhaustive);
  add_value(bench, "--device", options.device, parse_device, "vulkan[:N]",
            "measure on a graphics device (default: the CPU)");
  bench.add_flag("--list-devices", options.list_devices, "list the graphics devices of this machine");
  add_value(bench, "--range", options.range, parse_range, "A:B",
            fmt::format(
                "with --exhaustive: bit patterns of floats from A up to, not including, B (default: 0:{:#x})",
                bench::unit_floats.to))
      ->needs(exhaustive);
  add_studies(bench, options.studies);
  add_force(bench, options.force);
}

}  // namespace shadefit
