#include "approx/dither.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/list.hpp"
#include "fit/ledger/lobes/march.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/half.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The matrix of the record without its x: the entry that the others leave over, or none where they leave
/// several.
std::optional<double> entry_left_over(std::string_view matrix) {
  const auto missing = missing_from(dither_matrix(matrix, std::numeric_limits<double>::quiet_NaN()));
  return missing.size() == 1 ? std::optional(missing.front()) : std::nullopt;
}

/// How many entries are those of Bayer's matrix of that size.
long entries_of_bayer(const std::vector<double>& entries) {
  const auto size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
  long same = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const int at = static_cast<int>(i);
    const double rank = bayer_rank(at / size, at % size, size);
    same += entries[i] == rank / static_cast<double>(entries.size()) ? 1 : 0;
  }
  return same;
}

/// What an entry in the place of another does to the matrix: its offsets are shares of a step.
std::string effect_of_entry(std::string_view matrix, double x, double wanted) {
  const std::vector<double> printed = dither_matrix(matrix, x), corrected = dither_matrix(matrix, wanted);
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(printed.size()))));
  Effect effect;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    effect.show(
        corrected[i], printed[i],
        {{"row ", static_cast<double>(i / size + 1)}, {"column ", static_cast<double>(i % size + 1)}});
  }
  return sentence(effect, "an entry, a share of a step,", "x = " + decimal(x, 6));
}

Finding bayer(const Claim& claim) {
  const std::string_view printed = claim.printed[0].value, matrix = claim.inputs.at("matrix");
  const double x = number_of(printed);
  const auto wanted = entry_left_over(matrix);
  const std::vector<double> entries = dither_matrix(matrix, x);
  const auto missing = missing_from(entries);
  const std::string count = std::to_string(entries.size());
  std::string evidence = std::to_string(entries.size() - missing.size()) + " of the " + count + " values 0/" +
                         count + " to " + std::to_string(entries.size() - 1) + "/" + count + " are there, " +
                         std::to_string(entries_of_bayer(entries)) + " in the places of Bayer's construction";
  for (const double value : missing)
    evidence += ", " + decimal(value, 6) + " (" + decimal(value * static_cast<double>(entries.size()), 6) +
                "/" + count + ") is missing";
  if (!wanted) return {Verdict::refuted, "none", evidence, "none"};
  const std::vector<double> corrected = dither_matrix(matrix, *wanted);
  return {judge(printed, {"what the others leave over", *wanted}, {}).verdict, decimal(*wanted, 6),
          evidence + "; x = " + std::string(printed) + " where the others leave " + decimal(*wanted, 6) +
              " over; the mean offset is " + decimal(mean_of(entries), 6) + ", complete " +
              decimal(mean_of(corrected), 6),
          effect_of_entry(matrix, x, *wanted)};
}

/// The rms of single pixels, each with its own offset, over all of them.
double rms_before_blur(double steps, const std::vector<double>& offsets) {
  double squares = 0;
  for (const double offset : offsets) squares += power(march_rms_at_offset(steps, offset), 2);
  return std::sqrt(squares / static_cast<double>(offsets.size()));
}

struct March {
  std::string sentence;
  bool is_known = true;  ///< both formulas of every rms agree
  double rms = 0;        ///< of the dithered and blurred march
  double largest = 0;    ///< its largest error
  Verdict verdict = Verdict::confirmed;
};

/// Whether the errors of plain marches fall along the printed step counts.
March plain_marches(const std::vector<double>& counts) {
  std::vector<std::string> parts;
  March march;
  double last = std::numeric_limits<double>::infinity(), worst_share = 0;
  std::string worst_pair;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int steps = static_cast<int>(counts[i]);
    const MarchError error = march_error(march_places(steps, {0.0}));
    march.is_known = march.is_known && std::abs(error.rms_by_warnock / error.rms - 1) < 1e-6 &&
                     std::abs(march_rms(counts[i]) / error.rms - 1) < 1e-9;
    parts.push_back(decimal(error.rms, 4) + " at " + decimal(counts[i], 6));
    if (!(march_rms(counts[i]) < last)) march.verdict = Verdict::refuted;
    last = march_rms(counts[i]);
    if (i == 0) continue;
    const double share = share_made_worse(static_cast<int>(counts[i - 1]), steps);
    if (share <= worst_share) continue;
    worst_share = share;
    worst_pair = "from " + decimal(counts[i - 1], 6) + " to " + decimal(counts[i], 6) + " steps";
  }
  march.sentence =
      "the rms error over all edges, 1/(n sqrt 3) of the beam, is " + enumerated(parts) + " steps, " +
      (march.verdict == Verdict::confirmed ? "falling all the way" : "not falling all the way") +
      (worst_share > 0
           ? ", though going " + worst_pair + " makes " + decimal(worst_share, 4) + " of the edges worse"
           : "");
  return march;
}

/// Whether the dithered march of a matrix beats the plain one: after the blur, and before it.
March dithered_march(const std::vector<double>& offsets, double dithered, double plain) {
  const MarchError blurred = march_error(march_places(static_cast<int>(dithered), offsets));
  const double noisy = rms_before_blur(dithered, offsets), rival = march_rms(plain);
  March march;
  march.is_known = std::abs(blurred.rms_by_warnock / blurred.rms - 1) < 1e-6;
  march.rms = blurred.rms;
  march.largest = blurred.largest;
  march.verdict = !(blurred.rms < rival) ? Verdict::refuted
                  : noisy < rival        ? Verdict::confirmed
                                         : Verdict::conditional;
  march.sentence = decimal(blurred.rms, 4) + " blurred and " + decimal(noisy, 4) + " before (" +
                   decimal(rival / blurred.rms, 4) + " and " + decimal(rival / noisy, 4) + " times less)";
  return march;
}

/// What the largest error of a march does to a half-lit ray of strength 1.
std::string effect_of_march(double largest, std::string_view what, const std::string& lead) {
  Effect effect;
  effect.show(0.5, 0.5 + largest, {{"lit share ", 0.5}});
  return sentence(effect, what, lead);
}

Finding march_steps(const Claim& claim) {
  const double plain = number_of(claim.printed.at("plain")),
               dithered = number_of(claim.printed.at("dithered"));
  const std::string_view matrix = claim.inputs.at("matrix"), x = claim.inputs.at("x");
  const auto wanted = entry_left_over(matrix);
  if (!wanted) return {std::nullopt, "none", "the matrix leaves no single entry over", "none"};
  const March falling = plain_marches(numbers_of(claim.printed.at("steps"), ' '));
  const March as_printed = dithered_march(dither_matrix(matrix, number_of(x)), dithered, plain);
  const March corrected = dithered_march(dither_matrix(matrix, *wanted), dithered, plain);
  const std::array verdicts{falling.verdict, as_printed.verdict, corrected.verdict};
  const bool is_known = falling.is_known && as_printed.is_known && corrected.is_known;
  const std::string plain_steps = counted(static_cast<long>(plain), "plain step");
  const std::string corrected_x = "x = " + decimal(*wanted, 4);
  return {is_known ? std::optional(worst(verdicts)) : std::nullopt,
          "rms " + decimal(march_rms(plain), 6) + " plain, " + decimal(as_printed.rms, 6) + " dithered, " +
              decimal(corrected.rms, 6) + " with " + corrected_x,
          falling.sentence + "; against " + decimal(march_rms(plain), 4) + " of " + plain_steps + ", " +
              counted(static_cast<long>(dithered), "dithered step") + " have " + as_printed.sentence +
              " with x = " + std::string(x) + ", and " + corrected.sentence + " with " + corrected_x,
          sentences({effect_of_march(1 / plain, "a half-lit ray of strength 1", "a march of " + plain_steps),
                     effect_of_march(as_printed.largest, "it", "a dithered and blurred one"),
                     effect_of_march(corrected.largest, "it", "such a one with " + corrected_x)})};
}

/// The sum of weights at which white loses so many codes.
double weight_that_loses(double codes, double epsilon) {
  const double kept = srgb_decode((255 - codes) / 255);
  return epsilon * kept / (1 - kept);
}

/// What epsilon does to white whose taps have that sum of weights: one that is 0 leaves black.
std::string effect_on_white(double weight, double epsilon, const std::string& lead) {
  Effect effect;
  effect.show(1, guarded_mean(weight, weight, epsilon), {{"W = ", weight}});
  return sentence(effect, "white", lead);
}

Finding bilateral_epsilon(const Claim& claim) {
  const std::string_view printed = claim.printed[0].value;
  const double epsilon = number_of(printed), taps = given(claim, "taps");
  const double falloff = given(claim, "falloff");
  const double visible_codes = given(claim, "visible codes");
  const double second_codes = given(claim, "second reading");
  const double limit = weight_that_loses(visible_codes, epsilon);
  const auto gap_of = [&](double weight) { return (1 - weight / taps) / falloff; };
  const double flat = guarded_mean(taps, taps, epsilon);
  const Eigen::half half_taps = constant<Eigen::half>(claim.inputs.at("taps"));
  const bool half_keeps =
      guarded_mean(half_taps, half_taps, constant<Eigen::half>(printed)) == integer<Eigen::half>(1);
  const Verdict verdict = limit <= 0     ? Verdict::confirmed
                          : limit < taps ? Verdict::conditional
                                         : Verdict::refuted;
  const std::string black = decimal(1 / falloff, 4);
  return {verdict, decimal(limit, 4),
          "on a flat surface (W = " + decimal(taps, 6) + ") white is darkened by " + decimal(1 - flat, 3) +
              ", " + decimal(255 - srgb_code(flat), 2) + " codes" +
              (half_keeps ? ", in half arithmetic by nothing" : "") + "; it is less than " +
              decimal(visible_codes, 3) + " for W above " + decimal(limit, 4) +
              ", that is while the taps are less than " + decimal(gap_of(limit), 6) +
              " away in depth, and less than " + decimal(second_codes, 3) + " for W above " +
              decimal(weight_that_loses(second_codes, epsilon), 4) + " (" +
              decimal(gap_of(weight_that_loses(second_codes, epsilon)), 6) +
              " away); from there the loss grows up to all of it, and with every tap " + black +
              " or more away W = 0 leaves black",
          sentences({effect_on_white(taps, epsilon, "where depths agree it"),
                     epsilon > 0 ? effect_on_white(0, epsilon, "where every tap is beyond a depth edge it")
                                 : "none"})};
}

}  // namespace

std::span<const Evaluator> dither_evaluators() {
  static constexpr std::array evaluators{Evaluator{"bayer-4x4", bayer}, Evaluator{"march-steps", march_steps},
                                         Evaluator{"bilateral-epsilon", bilateral_epsilon}};
  return evaluators;
}

}  // namespace shadefit
