#include "app/options/bench_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A width that this machine supports.
forms::Width parse_width(const std::string& option, const std::string& text) {
  using forms::Width;
  const Choices<Width> all{
      {"scalar", Width::scalar}, {"sse2", Width::sse2}, {"avx2", Width::avx2}, {"avx512", Width::avx512}};
  const Width width = parse_choice(all)(option, text);
  const auto here = forms::widths_here();
  if (std::ranges::find(here, width) == here.end())
    throw UserError(fmt::format("{} '{}' is not of this machine: its widest registers are {}", option, text,
                                forms::name(here.back())));
  return width;
}

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

/// Adds the options for a comparison with an older run.
void add_comparison(CLI::App& bench, BenchOptions& options, CLI::Option* exhaustive) {
  auto* compare = add_value(bench, "--compare", options.compare, parse_text, "OLD.json",
                            "exit 1 if a form is slower than in OLD.json, an earlier --json; each time is "
                            "divided by that of its target's reference in the same run")
                      ->excludes(exhaustive);
  add_value(bench, "--fail-above", options.fail_above, parse_percentage, "P%",
            "with --compare: how much longer a form may take")
      ->default_str("10%")
      ->needs(compare);
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
  bench.add_option("--only", options.only, "only these targets")
      ->type_name("TARGET")
      ->excludes(exhaustive)
      ->excludes(study);
  bench.add_flag("--quick", options.quick, "fewer and shorter rounds: seconds")->excludes(exhaustive);
  auto* json = bench
                   .add_flag_callback(
                       "--json", [&options] { options.format = FindingFormat::json; },
                       "print the times as Google Benchmark does")
                   ->excludes(exhaustive);
  add_finding_format(bench, options.format, false)->excludes(json)->excludes(exhaustive);
  add_comparison(bench, options, exhaustive);
  bench.add_flag("--no-plots", options.no_plots, "write no plots, and no data or scripts for them")
      ->excludes(exhaustive);
  auto* width =
      add_value(
          bench, "--width", options.width, parse_width, "scalar|sse2|avx2|avx512",
          "the vector registers to time, besides scalar (default: all); with --exhaustive the ones to use "
          "(default: sse2)")
          ->excludes(study);
  add_value(bench, "--constants", options.constants, parse_text, "ID",
            "with --exhaustive: the constants of the form (default: its first)")
      ->needs(exhaustive);
  const auto parse_degree = [](const std::string& option, const std::string& text) {
    constexpr int most = 99;
    return parse_whole(option, text, 0, most);
  };
  auto* degree =
      add_value(
          bench, "--exp2-degree", options.exp2_degree, parse_degree, "N",
          "with --exhaustive: the degree of the polynomial for its exp2 (default: the exp2 of the library)")
          ->needs(exhaustive);
  auto* device = add_value(bench, "--device", options.device, parse_device, "vulkan[:N]",
                           "measure on a graphics device (default: the CPU)")
                     ->excludes(width)
                     ->excludes(degree);
  bench.add_flag("--list-devices", options.list_devices, "list the graphics devices of this machine");
  bench.add_flag("--probe", options.probe, "measure the errors of the device's exp2, log2 and others")
      ->needs(device)
      ->excludes(exhaustive)
      ->excludes(study);
  auto* half = bench
                   .add_flag("--half", options.half,
                             "with --exhaustive and --device: every half in [0, 1], and arithmetic in half")
                   ->needs(exhaustive)
                   ->needs(device);
  add_value(bench, "--range", options.range, parse_range, "A:B",
            fmt::format(
                "with --exhaustive: bit patterns of floats from A up to, not including, B (default: 0:{:#x})",
                bench::unit_floats.to))
      ->needs(exhaustive)
      ->excludes(half);
  add_studies(bench, options.studies);
  add_force(bench, options.force);
}

}  // namespace shadefit
