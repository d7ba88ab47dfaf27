#include "bench/peers/truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "approx/fresnel.hpp"
#include "approx/normalisation.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit::side_by_side {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// The rows of a file of references with `constant`, any name, one of the exponents and `kind` in the first
/// cells, and `rest` in the other cells that identify a fit.
Truth read(const std::filesystem::path& path, const std::string& constant, const std::string& kind,
           const std::string& rest, const std::vector<std::string>& exponents) {
  Truth truth;
  for (const auto& row : rows_of(path)) {
    const bool has_rest = row.size() == 6;
    if (row[0] != constant || row[1] == "level" || row[3] != kind) continue;
    if (has_rest && row[4] != rest) continue;
    if (std::find(exponents.begin(), exponents.end(), row[2]) == exponents.end()) continue;
    truth[answer_name(row[1], row[2])] = row.back();
  }
  const std::size_t parameters = exponents.front().empty() ? 2 : 1;
  if (truth.size() != exponents.size() * parameters)
    throw std::runtime_error(path.string() + " lacks references of " + constant);
  return truth;
}

/// The parameters of a study.
Truth parameters_of(const std::filesystem::path& path, const std::string& study) {
  Truth truth;
  for (const auto& row : rows_of(path)) {
    const bool is_parameter = row[0] == study && row[1] != "rms" && row[1] != "largest";
    if (is_parameter) truth[answer_name(row[1], "")] = row[2];
  }
  if (truth.empty()) throw std::runtime_error(path.string() + " lacks " + study);
  return truth;
}

/// The largest |error| of the published pair: a root of the error's slope, by Newton from the place that
/// every tool finds. One more step changes no shown digit.
std::string largest_error() {
  const auto number = [](const Published& record) { return constant<Decimal50>(record.printed); };
  const Decimal50 a = number(fresnel_published[2]), b = number(fresnel_published[3]),
                  ln2 = Scalar<Decimal50>::ln2();
  Decimal50 c("0.055");
  for (int i = 0; i < 12; ++i) {
    const Decimal50 form = exp(ln2 * (a * c + b) * c), rest = 1 - c, inner = ln2 * (2 * a * c + b);
    const Decimal50 slope = form * inner + 5 * rest * rest * rest * rest;
    const Decimal50 bend = form * (inner * inner + 2 * ln2 * a) - 20 * rest * rest * rest;
    c -= slope / bend;
  }
  const Decimal50 rest = 1 - c;
  return abs(Decimal50(exp(ln2 * (a * c + b) * c) - rest * rest * rest * rest * rest)).str(50);
}

template <class Lobe>
void append_constants(Truth& truth) {
  for (const char* alpha : {"0.1", "1", "2", "8", "64", "2048", "100000", "1000000"})
    truth[answer_name(std::string(Lobe::record.id), alpha)] =
        Decimal50(Lobe::constant(Decimal50(alpha))).str(50);
}

}  // namespace

std::string answer_name(const std::string& parameter, const std::string& exponent) {
  if (exponent.empty() || exponent == "-") return parameter + " -";
  std::ostringstream text;
  text.precision(15);
  text << parameter << ' ' << std::strtod(exponent.c_str(), nullptr);
  return text.str();
}

std::vector<Task> tasks(const std::filesystem::path& references) {
  const auto fits = references / "fits.csv", integrals = references / "integrals.csv",
             minimax = references / "minimax.csv";
  std::vector<std::string> sweep, powers;
  for (int k = 3; k <= 15; ++k) sweep.push_back(std::to_string(k));
  for (int rho = 2; rho <= 2048; rho *= 2) powers.push_back(std::to_string(rho));
  Truth constants;
  append_constants<PhongLobe>(constants);
  append_constants<PhongBrdfLobe>(constants);
  append_constants<BlinnPhongLobe>(constants);
  append_constants<BlinnPhongBrdfLobe>(constants);
  const std::string by_hand =
      "a root of the gradient that its user works out by hand, from one start or bracket, by one rule that is taken on "
      "trust; ours starts three times, polishes, and asks another rule in long double";
  const std::string scaled = by_hand + "; the scaled variable and its cut are ours too";
  return {
      {.id = "T1",
       .title = "the Fresnel pair by least squares, exp2((a c + b) c) for (1-c)^5",
       .is_fit = true,
       .start = "a = b = -5",
       .why = by_hand,
       .truth = read(fits, "fresnel-quadratic", "cosine", "", {""})},
      {.id = "T2",
       .title = "the Gaussian's offset, exp((k+x)(c-1)) for c^k, k = 3..15, 13 fits",
       .is_fit = true,
       .start = "x = 0.5",
       .why = scaled,
       .truth = read(fits, "sg-offset", "cosine", "", sweep)},
      {.id = "T2-large",
       .title = "the same at k = 100, 1e3, 1e4, 1e6, four fits",
       .is_fit = true,
       .start = "x = 0.5",
       .why = scaled,
       .truth = read(fits, "sg-offset", "cosine", "", {"100", "1000", "10000", "1000000"})},
      {.id = "T3",
       .title = "Phong by Blinn-Phong, cos(theta/2)^(x rho) for cos(theta)^rho, rho = 2, 4 .. 2048, 11 fits",
       .is_fit = true,
       .start = "x = 3",
       .why = scaled,
       .truth = read(integrals, "phong-blinn", "cosine", "0:1", powers)},
      {.id = "T4-absolute",
       .title = "the Fresnel pair by its largest error",
       .is_fit = true,
       .start = "the published pair",
       .truth = read(minimax, "fresnel-quadratic", "absolute", "", {""})},
      {.id = "T4-relative",
       .title = "the Fresnel pair by the largest relative error of F, f0 = 0.04",
       .is_fit = true,
       .start = "the published pair",
       .truth = read(minimax, "fresnel-quadratic", "relative", "", {""})},
      {.id = "T5",
       .title = "the largest error of the published pair",
       .truth = {{"level -", largest_error()}}},
      {.id = "T6",
       .title = "normalisation constants, four integrals at each of 8 exponents, 0.1 .. 1e6",
       .truth = constants},
      {.id = "T7",
       .title = "a rational form of two variables with eight parameters, for exp(-x - y/2) + x y/2",
       .start = "a = 1, the others 0",
       .truth = parameters_of(references / "studies.csv", "plane-rational")}};
}

double correct_digits(const std::string& answer, const std::string& truth) {
  char* end = nullptr;
  const double rounded = std::strtod(answer.c_str(), &end);
  if (end == answer.c_str() || *end != '\0' || !std::isfinite(rounded)) return 0;
  const Decimal50 right(truth), error = abs(Decimal50((Decimal50(answer) - right) / right));
  if (error == 0) return 40;
  return std::clamp(static_cast<double>(-log10(error)), 0.0, 40.0);
}

}  // namespace shadefit::side_by_side
