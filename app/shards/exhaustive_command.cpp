#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "app/options/bench_options.hpp"
#include "app/shards/kept_sweep.hpp"
#include "app/shards/sweeps.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "bench/forms/catalogue.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

/// `bench --exhaustive`: every float through one form.
namespace shadefit {
namespace {

using bench::Sweep;

std::string place_text(std::uint32_t at) {
  if (at == UINT32_MAX) return "";
  const auto c = static_cast<double>(std::bit_cast<float>(at));
  return fmt::format("at c = {} ({:.6g})", hex_text(c), c);
}

/// The device and its bound; nothing for a CPU.
std::string device_text(const Sweep& sweep) {
  if (sweep.identity.device.empty()) return "";
  const auto& e = sweep.identity.bound_from;
  std::string text = fmt::format(
      "on {}\nbound for exp2 within {:.4g} ulp, log2 within {:.4g} and within {:.4g} between 1/2 and 2: "
      "{} results are beyond it\n",
      sweep.identity.device, e.at(0), e.at(1), e.at(2), sweep.found.beyond);
  for (const std::uint32_t at : sweep.found.beyond_at) {
    if (at != UINT32_MAX) text += "  " + place_text(at) + "\n";
  }
  return text;
}

std::string result_text(const Sweep& sweep, const SweptForm& chosen, const Terminal& terminal) {
  const bench::FloatErrors& found = sweep.found;
  std::string text =
      fmt::format("{}{} in {}: {} floats, against {} in double\n", words_of(chosen),
                  chosen.exp2_degree > 0 ? fmt::format(", exp2 of degree {}", chosen.exp2_degree) : "",
                  sweep.identity.device.empty() ? forms::name(chosen.width) : "float", found.count(),
                  chosen.target->text);
  text += fmt::format("max abs error  {:.6g} {}\nmax ulps       {} {}\nNaN {}, above 1 {}, below 0 {}\n{}\n",
                      found.max_abs_error, place_text(found.max_abs_error_at), found.max_ulps,
                      place_text(found.max_ulps_at), found.nans, found.above_one, found.below_zero,
                      device_text(sweep));
  return text + write_console(ulps_table(found.ulps, found.count(), "floats"), Precision::report, terminal);
}

Outcome sweep_one(const BenchOptions& options, const forms::Catalogue& catalogue,
                  const Checkpoint& checkpoint, const Progress& progress) {
  const SweptForm chosen = chosen_by(catalogue, options);
  const auto on = measured_device(options.device, chosen.form->function, checkpoint);
  std::vector<KeptSweep> all{opened(options, options.out, catalogue, chosen, on)};
  if (auto interrupted = sweep_and_keep(all, checkpoint, progress)) return *interrupted;
  const Sweep& sweep = all.front().sweep;
  const std::string text = options.format == FindingFormat::json
                               ? bench::state_text(sweep)
                               : result_text(sweep, chosen, options.terminal) +
                                     fmt::format("\nResult: {}\n", printable(all.front().path.string()));
  return {sweep.found.beyond == 0 ? 0 : 1, text, ""};
}

}  // namespace

Table ulps_table(std::span<const std::uint64_t> ulps, std::uint64_t count, const std::string& numbers) {
  Table table{{"ulps", numbers, "share"}};
  std::size_t last = ulps.size();
  while (last > 1 && ulps[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t low = i == 0 ? 0 : std::uint64_t{1} << (i - 1), high = (std::uint64_t{1} << i) - 1;
    table.rows.push_back(
        {low >= high ? fmt::to_string(low) : fmt::format("{} .. {}", low, high), static_cast<long>(ulps[i]),
         Number{static_cast<double>(ulps[i]) / static_cast<double>(std::max<std::uint64_t>(count, 1)), 4}});
  }
  return table;
}

Outcome exhaustive_command(const BenchOptions& options, const Checkpoint& checkpoint,
                           const Progress& progress) {
  require_directory(options.out);
  if (options.half) return halves_command(options, checkpoint, progress);
  const forms::Catalogue catalogue = forms::catalogue();
  const bool is_all = *options.exhaustive == every_form;
  if (options.all_devices && !is_all)
    throw UserError(fmt::format("--all-devices does not apply with --exhaustive '{}': it must be all",
                                *options.exhaustive));
  const auto sweep = is_all ? sweep_every_form : sweep_one;
  return sweep(options, catalogue, checkpoint, progress);
}

}  // namespace shadefit
