#include "bench/device/form_bound.hpp"

#include <gtest/gtest.h>

#include "tests/device/drawn_inputs.hpp"

/// Bounds of forms on a device, without one: a device is imitated, as wrong as `usual_gpu` lets it be.
namespace shadefit::device {
namespace {

/// The float near a real number plus an error in ulps, with which it is not off by more.
float off_by(double real, double ulps, Sequence& sequence) {
  const double ulp = std::exp2(std::floor(std::log2(std::abs(real))) - 23);
  return static_cast<float>(real + (ulps - 0.5) * ulp * sequence.between(-1, 1));
}

struct ImitatedGpu {
  Sequence sequence{3};

  float exp2(float x) { return off_by(std::exp2(static_cast<double>(x)), 4, sequence); }
  float log2(float x) {
    const double real = std::log2(static_cast<double>(x));
    if (0.5F <= x && x <= 2) return static_cast<float>(real + 0x1.ep-22 * sequence.between(-1, 1));
    return off_by(real, 3, sequence);
  }
  float pow(float x, float y) { return exp2(y * log2(x)); }
  float quotient(float x, float y) {
    return off_by(static_cast<double>(x) / static_cast<double>(y), 2.5, sequence);
  }
  float multiply_add(float x, float y, float z) {
    return sequence.next() % 2 == 0 ? std::fma(x, y, z) : x * y + z;
  }
};

Symbolic number(const char* decimal) {
  return Symbolic::number(decimal);
}

/// The largest part of the bound that results use; above 1 where the bound is wrong.
template <class Imitated>
double used_part(const Symbolic& form, const Imitated& imitated) {
  const ShaderFunction function{"form", {"c"}, form};
  DrawnInputs drawn = drawn_cosines();
  const std::vector<double> values = values_at(drawn, function);
  const std::vector<double> bounds = bounds_of(drawn, function, usual_gpu);
  ImitatedGpu gpu;
  double most = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto result = static_cast<double>(imitated(gpu, drawn.arguments[i]));
    const double bound = bounds[drawn.box_of[i]];
    most = std::max(most, std::abs(result - values[i]) / bound);
  }
  return most;
}

TEST(FormBound, HoldsOnAnImitatedDevice) {
  const Symbolic c = Symbolic::variable("c"), one = number("1");
  const double exponential = used_part(
      exp2(Symbolic((number("-5.55473") * c - number("6.98316")) * c)),
      [](ImitatedGpu& gpu, float x) { return gpu.exp2(gpu.multiply_add(-5.55473F, x, -6.98316F) * x); });
  const double power_of_rest = used_part(power(Symbolic(one - c), number("5")),
                                         [](ImitatedGpu& gpu, float x) { return gpu.pow(1 - x, 5); });
  const double quotient =
      used_part(one / (one + c), [](ImitatedGpu& gpu, float x) { return gpu.quotient(1, 1 + x); });
  // At most 1; and the bound is not much larger than it has to be.
  for (const double part : {exponential, power_of_rest, quotient}) {
    EXPECT_LE(part, 1);
    EXPECT_GT(part, 0.5);
  }
}

// NVIDIA's compiler makes multiplications of pow(x, 5). Near 1 they are coarser than exp2(5 log2 x).
TEST(FormBound, HoldsForAWholePowerByMultiplications) {
  const ShaderFunction form{"form", {"c"}, power(Symbolic::variable("c"), number("5"))};
  FormBound<HalfFormat> bound(form, usual_gpu);
  double part = 0;
  for (int i = 1; i <= 1024; ++i) {  // the halves of (1/2, 1]
    const auto c = static_cast<Eigen::half>(0.5F + static_cast<float>(i) / 2048);
    const auto x = static_cast<double>(static_cast<float>(c));
    const Domain place{x, x};
    const Eigen::half product = c * c * c * c * c;
    const double off = std::abs(static_cast<double>(static_cast<float>(product)) - std::pow(x, 5));
    part = std::max(part, off / bound.on(std::span(&place, 1)));
  }
  EXPECT_LE(part, 1);
  EXPECT_GT(part, 0.5);
}

// As an H200 does. Each form with what it may compute of a half: exp2, a root and a quotient.
TEST(FormBound, HoldsWhereHalvesAreCutOff) {
  using Half = NarrowResult<HalfFormat>;
  const Symbolic c = Symbolic::variable("c");
  const auto used = [](const Symbolic& form, const auto& truth) {
    const ShaderFunction function{"form", {"c"}, form};
    FormBound<HalfFormat> bound(function, usual_gpu);
    double part = 0;
    for (int i = 1; i <= 1024; ++i) {  // the halves of (1/2, 1]
      const double x = 0.5 + static_cast<double>(i) / 2048, exact = truth(x);
      const Domain place{x, x};
      part = std::max(
          part, std::abs(static_cast<double>(Half::cut_off(exact)) - exact) / bound.on(std::span(&place, 1)));
    }
    return part;
  };
  for (const double part : {used(exp2(c), [](double x) { return std::exp2(x); }),
                            used(sqrt(c), [](double x) { return std::sqrt(x); }),
                            used(number("1") / c, [](double x) { return 1 / x; })}) {
    EXPECT_LE(part, 1);
    EXPECT_GT(part, 0.5) << "a rounded half would leave the bound twice as large as needed";
  }
}

TEST(FormBound, KnowsNothingOfOtherFunctions) {
  const ShaderFunction form{"form", {"c"}, atan(Symbolic::variable("c"))};
  const Domain box{0.25, 0.26};
  EXPECT_EQ(FormBound(form, usual_gpu).on(std::span(&box, 1)), HUGE_VAL);
}

// Vulkan's 2^-11, and an ulp of the argument for its reduction.
TEST(FormBound, OfAWaveIsAbsolute) {
  const Symbolic c = Symbolic::variable("c");
  const ShaderFunction form{"form", {"c"}, sin(Symbolic(number("64") * c))};
  for (const double at : {0.0, 0.5, 0.99}) {
    const Domain box = narrow_side(at, 0x1p-20);
    const double bound = FormBound(form, usual_gpu).on(std::span(&box, 1));
    EXPECT_GT(bound, 0x1p-11 + 64 * at * float_ulp);
    EXPECT_LT(bound, 1.1 * (0x1p-11 + 64 * at * float_ulp));
  }
}

// Mesa's compiler adds the number of a sum to a term inside: ((a + b) + d) + 1 becomes ((a + 1) + b) + d.
TEST(FormBound, HoldsWhereANumberIsAddedFirst) {
  const Symbolic c = Symbolic::variable("c");
  const Symbolic sum = number("0.001") * c * c * c + number("0.002") * c * c + number("-0.003") * c;
  const auto terms = [](float x) { return std::array{0.001F * x * x * x, 0.002F * x * x, -0.003F * x}; };
  const auto last = [&](ImitatedGpu&, float x) {
    const auto [a, b, d] = terms(x);
    return a + b + d + 1;
  };
  const auto first = [&](ImitatedGpu&, float x) {
    const auto [a, b, d] = terms(x);
    return a + 1 + b + d;
  };
  EXPECT_LE(used_part(sum + number("1"), last), 0.5);
  EXPECT_LE(used_part(sum + number("1"), first), 1);
  EXPECT_GT(used_part(sum + number("1"), first), 0.5);
}

TEST(FormBound, GrowsWithTheErrorsOfTheDevice) {
  const ShaderFunction form{"form", {"c"}, power(Symbolic::variable("c"), number("16"))};
  const Domain box{0.75, 0.7500001};
  GpuModel coarse = usual_gpu;
  coarse.log2_near_one *= 4;
  const double usual = FormBound(form, usual_gpu).on(std::span(&box, 1));
  EXPECT_GT(FormBound(form, coarse).on(std::span(&box, 1)), 3 * usual);
}

TEST(UnitPanels, CoverEveryFloatOnce) {
  const auto panels = unit_panels();
  EXPECT_EQ(panels.front(), 0U);
  EXPECT_EQ(panels.back(), std::bit_cast<std::uint32_t>(1.0F));
  for (std::size_t i = 1; i < panels.size(); ++i) ASSERT_LT(panels[i - 1], panels[i]);
}

}  // namespace
}  // namespace shadefit::device
