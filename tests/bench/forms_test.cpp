#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "approx/light_sum.hpp"
#include "approx/phase.hpp"
#include "bench/forms/catalogue.hpp"
#include "bench/forms/compiled.hpp"
#include "bench/forms/kernel.hpp"
#include "bench/forms/library_kernels.hpp"
#include "bench/forms/pairing.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"

namespace shadefit::forms {
namespace {

using shadefit::testing::is_close;

constexpr std::size_t size = 1024;

const Catalogue& all() {
  static const Catalogue made = catalogue();
  return made;
}

/// Arrays for every target: cosines in [0, 1] and the ends, for lights unit vectors.
template <class R>
struct Data {
  std::array<std::vector<R>, 3> in;
  std::vector<std::uint8_t> codes;

  explicit Data(const Target& target) {
    for (std::size_t i = 0; i < size; ++i) {
      std::array<double, 3> values{static_cast<double>(i) / (size - 1), 0, 0};
      values[0] = target.from + (target.to - target.from) * values[0];
      if (target.arguments == Arguments::normal_to_lights) values = spread_direction(i);
      for (std::size_t axis = 0; axis < 3; ++axis) in[axis].push_back(static_cast<R>(values[axis]));
      codes.push_back(static_cast<std::uint8_t>(i * 37 % 256));
    }
  }

  /// The target there, by its own formula.
  std::vector<long double> truth(const Target& target) const {
    std::array<std::vector<long double>, 3> wide;
    for (std::size_t axis = 0; axis < 3; ++axis) wide[axis].assign(in[axis].begin(), in[axis].end());
    std::vector<long double> truth(size), parameters;
    for (const double p : parameters_of(target, {})) parameters.push_back(static_cast<long double>(p));
    // the first of a target's forms is the target
    const auto& forms = all().forms;
    const auto own =
        std::find_if(forms.begin(), forms.end(), [&](const auto& f) { return f.target == target.id; });
    for (const LibraryForm& exact : library_forms()) {
      if (exact.form != own->id) continue;
      exact.in_long_double(
          {{wide[0].data(), wide[1].data(), wide[2].data()}, codes.data(), truth.data(), size}, parameters);
    }
    return truth;
  }

  std::vector<R> run(Kernel<R> kernel, const std::vector<double>& parameters) const {
    std::vector<R> out(size), p;
    for (const double x : parameters) p.push_back(static_cast<R>(x));
    kernel({{in[0].data(), in[1].data(), in[2].data()}, codes.data(), out.data(), size}, p);
    return out;
  }
};

/// Whether a kernel uses only basic operations, which are rounded the same everywhere.
bool is_basic(const FormEntry& form, const CompiledForm& compiled) {
  return form.function == Function::none || compiled.exp2_degree > 0;
}

TEST(Kernels, AreTheSameListForEveryWidth) {
  const auto scalar = compiled_forms(Width::scalar);
  EXPECT_EQ(scalar.front().form, "copy");
  for (const Width width : {Width::sse2, Width::avx2, Width::avx512}) {
    const auto other = compiled_forms(width);
    ASSERT_EQ(other.size(), scalar.size());
    for (std::size_t i = 0; i < scalar.size(); ++i) {
      EXPECT_EQ(other[i].form, scalar[i].form);
      EXPECT_EQ(other[i].exp2_degree, scalar[i].exp2_degree);
      EXPECT_NE(other[i].in_float, nullptr);
      EXPECT_EQ(other[i].in_double != nullptr, scalar[i].in_double != nullptr);
    }
  }
}

TEST(Kernels, ServeTheWholeCatalogue) {
  for (const FormEntry& form : all().forms) {
    int versions = 0;
    for (const CompiledForm& compiled : Tables::scalar) versions += compiled.form == form.id;
    EXPECT_EQ(versions, form.function == Function::exp2 ? 6 : 1) << form.id;
    EXPECT_FALSE(form.constants.empty()) << form.id;
  }
  ASSERT_EQ(library_forms().front().form, "copy");
}

TEST(Kernels, HaveWidthsThatTheMachineHas) {
  const auto widths = widths_here();
  ASSERT_GE(widths.size(), 2U);
  EXPECT_EQ(widths[0], Width::scalar);
  EXPECT_EQ(widths[1], Width::sse2);
  for (std::size_t i = 1; i < widths.size(); ++i) EXPECT_LT(widths[i - 1], widths[i]);
  EXPECT_EQ(name(Width::avx512), "AVX-512");
}

TEST(Kernels, Copy) {
  for (const Width width : widths_here()) {
    const Data<float> data(all().targets.front());
    EXPECT_EQ(data.run(compiled_forms(width).front().in_float, {}), data.in[0]) << name(width);
  }
}

template <class R>
void expect_bits(const std::vector<R>& first, const std::vector<R>& second, const std::string& what) {
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_EQ(std::memcmp(&first[i], &second[i], sizeof(R)), 0)
        << what << " at " << i << ": " << first[i] << ", " << second[i];
}

// Without fused operations a register does what one number does, to the bit: what is tabled of the scalar
// forms with a polynomial holds for SSE2.
TEST(Kernels, OfSse2AreTheScalarOnes) {
  int compared = 0;
  for (const FormEntry& form : all().forms) {
    const Target& target = target_of(all(), form.target);
    const Data<float> floats(target);
    const Data<double> doubles(target);
    const std::vector<double> parameters = parameters_of(target, form.constants.front());
    for (std::size_t i = 0; i < Tables::scalar.size(); ++i) {
      const CompiledForm &scalar = Tables::scalar[i], &sse2 = Tables::sse2[i];
      if (scalar.form != form.id || !is_basic(form, scalar)) continue;
      const std::string what = std::string(form.id) + " " + std::to_string(scalar.exp2_degree);
      expect_bits(floats.run(scalar.in_float, parameters), floats.run(sse2.in_float, parameters), what);
      ++compared;
      if (scalar.in_double == nullptr) continue;
      expect_bits(doubles.run(scalar.in_double, parameters), doubles.run(sse2.in_double, parameters), what);
    }
  }
  EXPECT_GT(compared, 60);
}

/// The allowed change by fused multiply-adds and by other functions, in half ulps of the largest result: some
/// sixty roundings, of the sums of 64 lights, of an exponent (the change of the result, t
/// exp(-t) of its relative change, is at most 0.37 of it) or of a difference near the peak of a phase
/// function. In A c - A the product is near A and rounded to half its ulps: A ln 2 of the result's, which is
/// 2048 at a gloss of 255.
double roundings_of(const FormEntry& form) {
  constexpr double largest_power = 2048;
  return form.target == "lobe-gloss" ? 2 * largest_power : 64;
}

template <class R>
void expect_near(const std::vector<R>& expected, const std::vector<R>& found, double roundings,
                 const std::string& what) {
  const double tolerance = roundings * static_cast<double>(std::numeric_limits<R>::epsilon() / 2) *
                           static_cast<double>(*std::max_element(expected.begin(), expected.end()));
  for (std::size_t i = 0; i < size; ++i) {
    ASSERT_LE(std::abs(static_cast<double>(expected[i]) - static_cast<double>(found[i])), tolerance)
        << what << " at " << i << ": " << expected[i] << ", " << found[i];
  }
}

TEST(Kernels, OfEveryWidthAreNearTheScalarOnes) {
  for (const Width width : widths_here()) {
    const auto wide = compiled_forms(width);
    for (const FormEntry& form : all().forms) {
      const Target& target = target_of(all(), form.target);
      const Data<float> floats(target);
      const Data<double> doubles(target);
      const std::vector<double> parameters = parameters_of(target, form.constants.back());
      for (std::size_t i = 0; i < wide.size(); ++i) {
        if (wide[i].form != form.id) continue;
        const CompiledForm& scalar = Tables::scalar[i];
        const std::string what =
            std::string(name(width)) + " " + std::string(form.id) + " " + std::to_string(scalar.exp2_degree);
        expect_near(floats.run(scalar.in_float, parameters), floats.run(wide[i].in_float, parameters),
                    roundings_of(form), what);
        if (scalar.in_double == nullptr) continue;
        expect_near(doubles.run(scalar.in_double, parameters), doubles.run(wide[i].in_double, parameters),
                    roundings_of(form), what);
      }
    }
  }
}

/// The allowed rounding of the highlights, for which there is no proof: 16 lights' exponents, each a sum of
/// four
/// products of at most A = 24, with some 11 roundings in each of two parts of that size.
constexpr double rounding_of_lights = 16 * 24 * 22 * 0x1p-24;

// On every width of the machine, the paired exp2 keeps its proven bound.
TEST(Kernels, OfEveryWidthKeepWhatIsProven) {
  int kept = 0;
  for (const FormEntry& form : all().forms) {
    if (form.target.starts_with("phong") && form.target != "phong-16") continue;
    const Target& target = target_of(all(), form.target);
    const Data<float> data(target);
    const std::vector<long double> truth = data.truth(target);
    for (const Constants* constants : {&form.constants.front(), &form.constants.back()}) {
      const auto pairing = pair_exp2(target, form.id, *constants);
      if (!pairing) continue;
      for (const Width width : widths_here()) {
        for (const CompiledForm& compiled : compiled_forms(width)) {
          if (compiled.form != form.id || compiled.exp2_degree != pairing->degree) continue;
          ++kept;
          const auto out = data.run(compiled.in_float, parameters_of(target, *constants));
          for (std::size_t i = 0; i < size; ++i) {
            const auto error = static_cast<double>(std::fabs(static_cast<long double>(out[i]) - truth[i]));
            ASSERT_LE(error, pairing->total() + pairing->rounding.value_or(rounding_of_lights))
                << name(width) << " " << form.id << " " << constants->id;
          }
        }
      }
    }
  }
  EXPECT_GE(kept, 36) << "nine forms by two sets of constants on two widths at least";
}

/// exp2 itself through a kernel: exp2(-A c) with A = -1.
std::vector<float> exp2_by_kernel(Width width, int degree, std::vector<float> x) {
  x.resize(64, 0.0F);
  std::vector<float> out(x.size());
  for (const CompiledForm& compiled : compiled_forms(width)) {
    if (compiled.form != "fresnel-one-term" || compiled.exp2_degree != degree) continue;
    const std::vector<float> parameters{-1.0F};
    compiled.in_float({{x.data(), nullptr, nullptr}, nullptr, out.data(), x.size()}, parameters);
  }
  return out;
}

// Every width reaches 0 and infinity, keeps NaN, and is exact at whole numbers. Below the least normal number
// its result is between 0 and that number.
TEST(Kernels, KnowTheEndsOfExp2) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const Width width : widths_here()) {
    for (int degree = least_exp2_degree; degree <= largest_exp2_degree; ++degree) {
      const auto out = exp2_by_kernel(
          width, degree,
          {-infinity, -1e30F, -200, -126, -1, 0, 1, 127, 128, 1e30F, infinity, NAN, -126.5F, -126.25F});
      const std::string where = std::string(name(width)) + " " + std::to_string(degree);
      EXPECT_EQ(out[0], 0.0F) << where;
      EXPECT_EQ(out[1], 0.0F) << where;
      EXPECT_EQ(out[2], 0.0F) << where;
      EXPECT_EQ(out[3], 0x1p-126F) << where;
      EXPECT_EQ(out[4], 0.5F) << where;
      EXPECT_EQ(out[5], 1.0F) << where;
      EXPECT_EQ(out[6], 2.0F) << where;
      EXPECT_EQ(out[7], 0x1p127F) << where;
      EXPECT_EQ(out[8], infinity) << where;
      EXPECT_EQ(out[9], infinity) << where;
      EXPECT_EQ(out[10], infinity) << where;
      EXPECT_TRUE(std::isnan(out[11])) << where;
      for (const std::size_t below : {12U, 13U}) {
        EXPECT_GE(out[below], 0.0F) << where;
        EXPECT_LE(out[below], 0x1p-126F) << where;
      }
    }
  }
}

TEST(Catalogue, HasTheConstantsOfTheRecords) {
  const FormEntry* quadratic = nullptr;
  for (const FormEntry& form : all().forms) {
    if (form.id == "fresnel-quadratic") quadratic = &form;
  }
  ASSERT_NE(quadratic, nullptr);
  EXPECT_EQ(quadratic->constants.front().id, "published-fresnel-quadratic-a");
  EXPECT_EQ(quadratic->constants.front().numbers.at(1).printed, "-6.98316");
  // the published pair is least squares, uniform in the cosine
  EXPECT_EQ(quadratic->constants.at(1).id, "least-squares-cosine");
  EXPECT_EQ(quadratic->constants.at(1).numbers.at(0).printed, "-5.554727813");
  EXPECT_EQ(quadratic->constants.at(1).numbers.at(0).value, -5.554727813);
  EXPECT_EQ(quadratic->constants.back().id, "minimax-exp2-2");
  EXPECT_EQ(quadratic->constants.back().numbers.at(0).printed, "-5.404911418");
  EXPECT_EQ(quadratic->constants.back().numbers.at(1).printed, "-7.032870633");
  EXPECT_EQ(parameters_of(target_of(all(), "phong-16"), {}).size(), 1 + 3 * 16U);
  EXPECT_THROW(target_of(all(), "none"), std::logic_error);
}

TEST(Catalogue, SpreadsDirections) {
  double least = 2;
  for (std::size_t i = 0; i < most_lights; ++i) {
    const auto a = spread_direction(i);
    EXPECT_NEAR(a[0] * a[0] + a[1] * a[1] + a[2] * a[2], 1, 1e-15);
    EXPECT_GT(a[2], 0);
    for (std::size_t j = 0; j < i; ++j) {
      const auto b = spread_direction(j);
      least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  // 64 discs of that radius would cover a quarter of the hemisphere's 2 pi
  EXPECT_GT(least, 0.05);
}

// Schlick's phase function is a density, and the form with a square root is Henyey and Greenstein's.
TEST(PhaseFunctions, AreDensities) {
  for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.76}) {
    const double k = schlick_phase_parameter(g, 1.55, 0.55);
    const auto density = [&](double c) { return 2 * std::numbers::pi * schlick_phase(c, k); };
    EXPECT_NEAR(tanh_sinh(density, -1, 1, 1e-12).value, 1, 1e-10) << g;
  }
  EXPECT_EQ(schlick_phase_parameter(1.0, 1.55, 0.55), 1);
  for (const char* g : {"-0.9", "0.1", "0.76"}) {
    for (const char* c : {"-1", "-0.2", "0.5", "1"}) {
      const Decimal50 C(c), G(g);
      EXPECT_TRUE(is_close("", henyey_greenstein_by_sqrt(C, G), henyey_greenstein(C, G), 1e-45));
    }
  }
}

// (A l, -A).(n, 1) is A (n.l - 1).
TEST(LightSum, IsTheGaussianOfTheCosine) {
  const std::array<Decimal50, 3> n{Decimal50("0.48"), Decimal50("0.6"), Decimal50("0.64")};
  const std::array<Decimal50, 3> l{Decimal50("0.36"), Decimal50("0.48"), Decimal50("0.8")};
  const Decimal50 base_two("14.5"), cosine = lit_cosine(n, l);
  EXPECT_TRUE(is_close("", highlight_by_exp2(n, scaled_light(l, base_two)),
                       gaussian_lobe_base_two(cosine, base_two), 1e-45));
  EXPECT_EQ(lit_cosine(n, {Decimal50(0), Decimal50(-1), Decimal50(0)}), 0);
}

}  // namespace
}  // namespace shadefit::forms
