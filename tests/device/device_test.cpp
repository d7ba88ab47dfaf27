#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "bench/device/form_sweep.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/symbolic.hpp"
#include "tests/device/on_device.hpp"

/// The catalogue on a device.
namespace shadefit::device {
namespace {

TEST_F(Device, RunsEveryFormWithinTheBoundInBothLanguages) {
  // exp2(A c - A) has the largest bound: A is up to 2^11/ln 2, and each of its two is off by up to 2^-19 of
  // itself.
  constexpr double vague = 0x1p-7;
  const std::vector<forms::Target> catalogue = forms::catalogue();
  std::map<forms::Arguments, DrawnInputs> drawn;
  const bench::Trade all = bench::catalogue_forms(catalogue, {}, bench::Exp2Kinds::library);
  EXPECT_GT(all.forms.size(), 70U);
  for (const bench::TimedForm& form : all.forms) {
    const auto kind = std::ranges::find(catalogue, form.target, &forms::Target::id)->arguments;
    if (!drawn.contains(kind)) drawn.emplace(kind, drawn_for(kind));
    const DrawnInputs& inputs = drawn.at(kind);
    const std::vector<double> values = values_at(inputs, form.function);
    const std::vector<double> bounds = bounds_of(inputs, form.function, usual_gpu);
    // log2 of 0, or of a subnormal number that is flushed to 0, is no number that a bound could have.
    const auto is_vague = [](double bound) { return bound > vague; };
    const bool has_log2_of_zero = form.form == "lobe-exp2-log2";
    EXPECT_EQ(std::count_if(bounds.begin(), bounds.end(), is_vague), has_log2_of_zero ? 2 : 0) << form.label;
    for (const Language language : languages) {
      EXPECT_EQ(beyond(form.function, language, inputs, values, bounds), "")
          << form.target << " " << form.label << " in " << name(language);
    }
  }
}

// Each function alone.
TEST_F(Device, FunctionsAreAsWrongAsAssumedAtMost) {
  const auto number = [](const char* decimal) { return Symbolic::number(decimal); };
  const Symbolic c = Symbolic::variable("c"), one = number("1");
  const Symbolic above_one = one + number("8") * c;
  const DrawnInputs inputs = drawn_cosines();
  for (const Symbolic& result : {exp2(Symbolic(number("-16") * c)), Symbolic::function("log2", {above_one}),
                                 sqrt(c), one / above_one, power(above_one, number("2.4")), sin(c)}) {
    const ShaderFunction function{"form", {"c"}, result};
    EXPECT_EQ(beyond(function, Language::glsl, inputs, values_at(inputs, function),
                     bounds_of(inputs, function, usual_gpu)),
              "");
  }
}

/// The halves whose log2 has no bound, because a device may take a subnormal half as 0. pow(0, p) is 0.
std::size_t without_bound(std::string_view form) {
  constexpr std::size_t subnormals = 1023;
  if (form == "lobe-pow") return subnormals;
  return form == "lobe-exp2-log2" ? subnormals + 1 : 0;
}

std::vector<std::pair<forms::Target, forms::FormEntry>> forms_of_one_cosine() {
  std::vector<std::pair<forms::Target, forms::FormEntry>> all;
  for (const forms::Target& target : forms::catalogue()) {
    if (target.arguments != forms::Arguments::cosine) continue;
    for (const forms::FormEntry& form : target.forms) all.emplace_back(target, form);
  }
  return all;
}

// Every half in [0, 1] through every form of one cosine, each with its last set of constants.
TEST_F(Device, RunsEveryHalfWithinTheBound) {
  if (!vulkan().info().has_half) return;
  std::vector<float> halves;
  for (std::uint16_t bits = 0; bits <= 0x3c00; ++bits)
    halves.push_back(static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits)));
  for (const auto& [target, form] : forms_of_one_cosine()) {
    const ShaderFunction function = bench::function_of(target, form, form.constants.back());
    Evaluator evaluator(vulkan(), compiler_, function, ShaderPrecision::float16);
    const auto results = evaluator.of(halves);
    const std::vector<double> cosines(halves.begin(), halves.end());
    const std::vector<double> real =
        shadefit::values_at(tape_of_code(function, ShaderPrecision::float16), std::span(&cosines, 1), {});
    FormBound<HalfFormat> bound(function, usual_gpu);
    std::size_t unbounded = 0, beyond = 0;
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const Domain place{cosines[i], cosines[i]};
      const double most = bound.on(std::span(&place, 1));
      if (!std::isfinite(most)) {
        ++unbounded;
      } else if (!(std::abs(static_cast<double>(results[i]) - real[i]) <= most)) {
        ++beyond;
      }
    }
    EXPECT_EQ(unbounded, without_bound(form.id)) << form.id;
    EXPECT_EQ(beyond, 0U) << form.id;
  }
}

// The sweep of `bench --exhaustive`: whole stretches, several dispatches, and a bound that is too small.
TEST_F(Device, SweepsFloatsAndNotesThoseBeyondTheBound) {
  const ShaderFunction form{"form", {"c"}, power(Symbolic::variable("c"), 16)};
  bench::FloatSubject subject;
  subject.truth = [](const float* in, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(static_cast<double>(in[i]), 16);
  };
  sweep_on_device(subject, vulkan(), form, usual_gpu);
  const bench::Stretch stretch{0x3f000000, 0x3f000000 + (1U << 20) + 7};
  const bench::FloatErrors found = bench::errors_on(subject, stretch);
  EXPECT_EQ(found.count(), stretch.size());
  EXPECT_EQ(found.beyond, 0U);
  EXPECT_GT(found.max_ulps, 0U);
  EXPECT_LT(found.max_ulps, 16U);
  const auto bound = subject.bound;
  subject.bound = [&](const float* in, double* middle, double* radius, std::size_t count) {
    bound(in, middle, radius, count);
    std::fill_n(radius, count, 0.0);
  };
  const bench::FloatErrors none = bench::errors_on(subject, stretch);
  EXPECT_GT(none.beyond, 100U);
  EXPECT_TRUE(std::is_sorted(none.beyond_at.begin(), none.beyond_at.end()));
  EXPECT_LT(none.beyond_at.back(), stretch.to);
}

}  // namespace
}  // namespace shadefit::device
