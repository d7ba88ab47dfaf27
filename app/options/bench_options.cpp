#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// "A:B" with bit patterns of floats in [0, 1], decimal or 0x..
bench::Stretch parse_range(const std::string& option, const std::string& text) {
  const auto bits = [](std::string_view part) -> std::optional<std::uint32_t> {
    const bool is_hex = part.starts_with("0x");
    if (is_hex) part.remove_prefix(2);
    std::uint32_t value = 0;
    const auto [end, error] =
        std::from_chars(part.data(), part.data() + part.size(), value, is_hex ? 16 : 10);
    if (error != std::errc{} || end != part.data() + part.size()) return std::nullopt;
    return value;
  };
  const auto colon = text.find(':');
  if (colon != std::string::npos) {
    const auto from = bits(std::string_view(text).substr(0, colon));
    const auto to = bits(std::string_view(text).substr(colon + 1));
    if (from && to && *from < *to && *to <= bench::unit_floats.to) return {*from, *to};
  }
  throw UserError(
      fmt::format("{} '{}' is not a range of bit patterns: it must be A:B with 0 <= A < B <= {:#x}", option,
                  text, bench::unit_floats.to));
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
