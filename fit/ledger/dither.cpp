#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/dither.hpp"
#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/finding.hpp"
#include "fit/ledger/march.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/half.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

std::vector<double> dither_matrix(std::string_view text, double x) {
  const auto bad = [&] {
    return std::invalid_argument(fmt::format("not a square matrix with one x: {}", text));
  };
  std::vector<double> entries;
  int letters = 0;
  const auto rows = items_of(text, '/');
  for (const std::string_view row : rows) {
    const auto words = items_of(row, ' ');
    if (words.size() != rows.size()) throw bad();
    for (const std::string_view word : words) {
      letters += word == "x" ? 1 : 0;
      entries.push_back(word == "x" ? x : number_of(word));
    }
  }
  const bool is_power_of_two = (rows.size() & (rows.size() - 1)) == 0;
  if (letters != 1 || !is_power_of_two) throw bad();
  return entries;
}

std::vector<double> missing_from(const std::vector<double>& entries) {
  std::vector<double> missing;
  const auto n = static_cast<double>(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double value = static_cast<double>(k) / n;
    if (std::ranges::find(entries, value) == entries.end()) missing.push_back(value);
  }
  return missing;
}

MarchError march_error(std::vector<double> places) {
  std::ranges::sort(places);
  const auto n = static_cast<double>(places.size());
  const auto cube = [](double t) { return t * t * t; };
  MarchError error;
  double squares = 0, left = 0;
  // For an edge between `left` and `right`, k places lie below it: the error is k/n - e.
  const auto piece = [&](double k, double right) {
    const double at_left = k / n - left, at_right = k / n - right;
    squares += (cube(at_left) - cube(at_right)) / 3;
    error.largest = std::max({error.largest, std::abs(at_left), std::abs(at_right)});
    left = right;
  };
  double k = 0, squared_places = 0, larger_of_pairs = 0;
  for (const double place : places) {
    piece(k, place);
    ++k;
    squared_places += place * place;
    larger_of_pairs += (2 * k - 1) * place;  // it is the larger one in 2k - 1 of the ordered pairs
  }
  piece(k, 1);
  error.rms = std::sqrt(squares);
  error.rms_by_warnock = std::sqrt(1.0 / 3 - (1 - squared_places / n) + (1 - larger_of_pairs / (n * n)));
  return error;
}

std::vector<double> march_places(int steps, const std::vector<double>& offsets) {
  std::vector<double> places;
  for (int i = 0; i < steps; ++i) {
    for (const double offset : offsets) places.push_back((i + offset) / steps);
  }
  return places;
}

double share_made_worse(int fewer, int more) {
  // In units of 1/(fewer more) every jump of either estimate is a whole number.
  const long all = static_cast<long>(fewer) * more;
  long worse = 0;
  for (long cell = 0; cell < all; ++cell) {
    const long estimate_of_fewer = (cell / more + 1) * more, estimate_of_more = (cell / fewer + 1) * fewer;
    worse += estimate_of_more > estimate_of_fewer ? 1 : 0;
  }
  return static_cast<double>(worse) / static_cast<double>(all);
}

namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The value of x in the record's matrix: the only missing entry; nothing if several are missing.
std::optional<double> entry_left_over(std::string_view matrix) {
  const auto missing = missing_from(dither_matrix(matrix, std::numeric_limits<double>::quiet_NaN()));
  return missing.size() == 1 ? std::optional(missing.front()) : std::nullopt;
}

/// The number of entries that equal those of Bayer's matrix of that size.
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

/// The effect of a wrong entry on the matrix: its offsets are shares of a step.
std::string effect_of_entry(std::string_view matrix, double x, double wanted) {
  const std::vector<double> printed = dither_matrix(matrix, x), corrected = dither_matrix(matrix, wanted);
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(printed.size()))));
  Effect effect;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    effect.show(
        corrected[i], printed[i],
        {{"row ", static_cast<double>(i / size + 1)}, {"column ", static_cast<double>(i % size + 1)}});
  }
  return sentence(effect, "a matrix entry (a fraction of a step)", fmt::format("x = {:.6g}", x));
}

Finding bayer(const Claim& claim) {
  const std::string_view printed = claim.printed[0].value, matrix = claim.inputs.at("matrix");
  const double x = number_of(printed);
  const auto wanted = entry_left_over(matrix);
  const std::vector<double> entries = dither_matrix(matrix, x);
  const auto missing = missing_from(entries);
  const std::string count = std::to_string(entries.size());
  std::string evidence = fmt::format(
      "the matrix has {} of the {} values 0/{} to {}/{}; {} entries are where Bayer's construction puts them",
      entries.size() - missing.size(), count, count, entries.size() - 1, count, entries_of_bayer(entries));
  for (const double value : missing)
    evidence += fmt::format(". {:.6g} ({:.6g}/{}) is missing", value,
                            value * static_cast<double>(entries.size()), count);
  if (!wanted) return {Verdict::refuted, "none", evidence, "none"};
  const std::vector<double> corrected = dither_matrix(matrix, *wanted);
  return {
      judge(printed, {"what the others leave over", *wanted}, {}).verdict, decimal(*wanted, 6),
      fmt::format(
          "{}. The printed entry is x = {}; the only value that the other entries leave is {:.6g}. The mean "
          "offset is {:.6g}, and {:.6g} with the right entry",
          evidence, printed, *wanted, mean_of(entries), mean_of(corrected)),
      effect_of_entry(matrix, x, *wanted)};
}

/// The rms over all pixels, each with its own offset.
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

/// Whether the errors of plain marches decrease for the printed step counts.
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
    parts.push_back(fmt::format("{:.4g} at {:.6g}", error.rms, counts[i]));
    if (!(march_rms(counts[i]) < last)) march.verdict = Verdict::refuted;
    last = march_rms(counts[i]);
    if (i == 0) continue;
    const double share = share_made_worse(static_cast<int>(counts[i - 1]), steps);
    if (share <= worst_share) continue;
    worst_share = share;
    worst_pair = fmt::format("from {:.6g} to {:.6g} steps", counts[i - 1], counts[i]);
  }
  march.sentence = fmt::format(
      "over all positions of a shadow edge the rms error of n plain steps is 1/(n sqrt 3) of the beam: {} "
      "steps, {}{}",
      enumerated(parts),
      march.verdict == Verdict::confirmed ? "smaller with each larger count"
                                          : "not smaller with each larger count",
      worst_share > 0 ? fmt::format(". But going {} makes the error larger for {:.4g} of the edges",
                                    worst_pair, worst_share)
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
  march.sentence = fmt::format(
      "{:.4g} after the blur (plain steps have {:.4g} times that) and {:.4g} before it ({:.4g} times)",
      blurred.rms, rival / blurred.rms, noisy, rival / noisy);
  return march;
}

/// The effect of a march's largest error on a half-lit ray of strength 1.
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
  const std::string corrected_x = fmt::format("x = {:.4g}", *wanted);
  return {
      is_known ? std::optional(worst(verdicts)) : std::nullopt,
      fmt::format("rms {:.6g} plain, {:.6g} dithered, {:.6g} with {}", march_rms(plain), as_printed.rms,
                  corrected.rms, corrected_x),
      told(claim, Told{"falling", falling.sentence}, Told{"plain_steps", plain_steps},
           Told{"plain_rms", march_rms(plain)},
           Told{"dithered_steps", counted(static_cast<long>(dithered), "dithered step")},
           Told{"as_printed", as_printed.sentence}, Told{"corrected_x", corrected_x},
           Told{"corrected", corrected.sentence}),
      sentences({effect_of_march(1 / plain, "a half-lit ray of strength 1",
                                 fmt::format("a march of {}", plain_steps)),
                 effect_of_march(as_printed.largest, "it", "the dithered and blurred march"),
                 effect_of_march(corrected.largest, "it", fmt::format("the same with {}", corrected_x))})};
}

/// The sum of weights at which white loses that many codes.
double weight_that_loses(double codes, double epsilon) {
  const double kept = srgb_decode((255 - codes) / 255);
  return epsilon * kept / (1 - kept);
}

/// The effect of epsilon on white if the taps have that sum of weights: with sum 0 it is black.
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
  return {
      verdict, fmt::format("true for a sum of weights W above {:.4g}", limit),
      told(claim, Told{"loss", 1 - flat}, Told{"codes", 255 - srgb_code(flat)},
           Told{"in_half", half_keeps ? "; in half arithmetic it loses nothing" : ""}, Told{"limit", limit},
           Told{"gap", gap_of(limit)}, Told{"second_limit", weight_that_loses(second_codes, epsilon)},
           Told{"second_gap", gap_of(weight_that_loses(second_codes, epsilon))}),
      sentences(
          {effect_on_white(taps, epsilon, "where depths agree it"),
           epsilon > 0 ? effect_on_white(0, epsilon, "where every tap is beyond a depth edge it") : "none"})};
}

}  // namespace

std::vector<Evaluator> dither_evaluators() {
  return {{"bayer-4x4", bayer}, {"march-steps", march_steps}, {"bilateral-epsilon", bilateral_epsilon}};
}

}  // namespace shadefit
