#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "approx/dither.hpp"
#include "fit/ledger/march.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {

std::vector<double> dither_matrix(std::string_view text, double x) {
  std::vector<double> entries;
  for (const std::string_view row : items_of(text, '/')) {
    for (const std::string_view word : items_of(row, ' '))
      entries.push_back(word == "x" ? x : number_of(word));
  }
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

/// The value of x in the record's matrix: the only missing entry; nothing if several are missing.
std::optional<double> entry_left_over(std::string_view matrix) {
  const auto missing = missing_from(dither_matrix(matrix, std::numeric_limits<double>::quiet_NaN()));
  return missing.size() == 1 ? std::optional(missing.front()) : std::nullopt;
}

Finding bayer(const Claim& claim) {
  const std::string_view matrix = claim.inputs.at("matrix");
  const double x = number_of(claim.printed[0].value);
  const auto left = entry_left_over(matrix);
  if (!left) return {Verdict::refuted, "none", "the other entries leave no single value", "none"};
  const std::vector<double> entries = dither_matrix(matrix, x), corrected = dither_matrix(matrix, *left);
  const auto size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
  int of_bayer = 0, place = 0;  // entries that equal those of Bayer's matrix; the place of x
  for (int i = 0; i < size * size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    of_bayer += entries[at] * size * size == bayer_rank(i / size, i % size, size) ? 1 : 0;
    if (entries[at] != corrected[at]) place = i;
  }
  const std::string effect =
      effect_of_value(*left, x, {{"row ", place / size + 1.0}, {"column ", place % size + 1.0}},
                      "a matrix entry (a fraction of a step)", fmt::format("x = {:.6g}", x));
  return told(claim, judge(claim.printed[0].value, {"", *left}, {}).verdict, effect,
              Told{"present", entries.size() - missing_from(entries).size()}, Told{"all", entries.size()},
              Told{"of_bayer", of_bayer}, Told{"left", *left},
              Told{"sum", std::accumulate(entries.begin(), entries.end(), 0.0)});
}

/// The rms errors of plain marches with these step counts.
struct PlainMarches {
  bool is_known = true;             ///< both formulas and the closed form agree
  bool fall = true;                 ///< with each larger count
  std::vector<std::string> errors;  ///< "0.1155 at 5"
  double worst_share = 0;           ///< of the edges for which the next count has a larger error
  std::string worst_pair;           ///< "from 5 to 10 steps": there

  explicit PlainMarches(const std::vector<double>& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const int steps = static_cast<int>(counts[i]);
      const MarchError error = march_error(march_places(steps, {0.0}));
      is_known = is_known && std::abs(error.rms_by_warnock / error.rms - 1) < 1e-6 &&
                 std::abs(march_rms(counts[i]) / error.rms - 1) < 1e-9;
      errors.push_back(fmt::format("{:.4g} at {}", error.rms, steps));
      if (i == 0) continue;
      fall = fall && counts[i - 1] < counts[i];
      const double share = share_made_worse(static_cast<int>(counts[i - 1]), steps);
      if (share <= worst_share) continue;
      worst_share = share;
      worst_pair = fmt::format("from {:.6g} to {} steps", counts[i - 1], steps);
    }
  }
};

/// The dithered march of a matrix against the plain one: after the blur, and before it, where each pixel has
/// its own offset.
struct DitheredMarch {
  MarchError blurred;
  double noisy, rival;

  DitheredMarch(const std::vector<double>& offsets, double steps, double plain)
      : blurred(march_error(march_places(static_cast<int>(steps), offsets))), rival(march_rms(plain)) {
    double squares = 0;
    for (const double offset : offsets) squares += power(march_rms_at_offset(steps, offset), 2);
    noisy = std::sqrt(squares / static_cast<double>(offsets.size()));
  }
  bool is_known() const { return std::abs(blurred.rms_by_warnock / blurred.rms - 1) < 1e-6; }
  Verdict verdict() const { return verdict_of(std::max(blurred.rms, noisy) < rival, blurred.rms < rival); }
  std::string words() const {
    return fmt::format(
        "{:.4g} after the blur (plain steps have {:.4g} times that) and {:.4g} before it ({:.4g} times)",
        blurred.rms, rival / blurred.rms, noisy, rival / noisy);
  }
};

/// The effect of a march's largest error on a half-lit ray of strength 1.
std::string effect_of_march(double largest, std::string_view what, const std::string& lead) {
  return effect_of_value(0.5, 0.5 + largest, {{"lit share ", 0.5}}, what, lead);
}

Finding march_steps(const Claim& claim) {
  const double plain = number_of(claim.printed.at("plain")),
               dithered = number_of(claim.printed.at("dithered"));
  const std::string_view matrix = claim.inputs.at("matrix");
  const auto right = entry_left_over(matrix);
  if (!right) return {std::nullopt, "none", "the matrix leaves no single entry over", "none"};
  const PlainMarches falling(numbers_of(claim.printed.at("steps"), ' '));
  const DitheredMarch as_printed(dither_matrix(matrix, given(claim, "x")), dithered, plain);
  const DitheredMarch corrected(dither_matrix(matrix, *right), dithered, plain);
  const std::array verdicts{verdict_of(falling.fall), as_printed.verdict(), corrected.verdict()};
  const bool is_known = falling.is_known && as_printed.is_known() && corrected.is_known();
  const std::string effect = sentences(
      {effect_of_march(1 / plain, "a half-lit ray of strength 1",
                       fmt::format("a march of {:.6g} plain steps", plain)),
       effect_of_march(as_printed.blurred.largest, "it", "the dithered and blurred march"),
       effect_of_march(corrected.blurred.largest, "it", fmt::format("the same with x = {:.4g}", *right))});
  return told(claim, is_known ? std::optional(worst(verdicts)) : std::nullopt, effect,
              Told{"errors", enumerated(falling.errors)},
              Told{"smaller", falling.fall ? "smaller" : "not smaller"},
              Told{"worst_pair", falling.worst_pair}, Told{"worst_share", falling.worst_share},
              Told{"plain_rms", march_rms(plain)}, Told{"rms", as_printed.blurred.rms},
              Told{"as_printed", as_printed.words()}, Told{"right", *right},
              Told{"right_rms", corrected.blurred.rms}, Told{"corrected", corrected.words()});
}

}  // namespace

std::vector<Evaluator> dither_evaluators() {
  return {{"bayer-4x4", bayer}, {"march-steps", march_steps}};
}

}  // namespace shadefit
