#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bench/device/form_sweep.hpp"
#include "bench/device/half_errors.hpp"
#include "bench/device/probe.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/support/user_error.hpp"
#include "tests/device/on_device.hpp"

/// The catalogue on a device.
namespace shadefit::device {
namespace {

/// A form of the catalogue with its first set of constants.
struct Chosen {
  forms::Catalogue catalogue = forms::catalogue();
  const forms::FormEntry* form;
  const forms::Target* target;
  explicit Chosen(std::string_view id)
      : form(&*std::find_if(catalogue.forms.begin(), catalogue.forms.end(),
                            [&](const auto& entry) { return entry.id == id; })),
        target(&forms::target_of(catalogue, form->target)) {}
};

/// The forms of the catalogue, each with every set of its constants.
std::vector<bench::FormToTime> forms_of(const forms::Catalogue& catalogue) {
  return bench::catalogue_forms(catalogue, {}, bench::Exp2Kinds::library).forms;
}

// Every float. These are the errors that `usual_gpu` and the documents state.
TEST_F(Device, Exp2AndLog2AreAsWrongAsStatedAtMost) {
  const GpuModel model = model_for(forms::Function::pow, vulkan());
  EXPECT_LE(model.exp2_ulps, usual_gpu.exp2_ulps);
  EXPECT_LE(model.log2_ulps, usual_gpu.log2_ulps);
  EXPECT_LE(model.log2_near_one, usual_gpu.log2_near_one);
  EXPECT_GT(model.exp2_ulps, 0.5) << "no function is better than rounded";
  EXPECT_GT(model.log2_ulps, 0.5);
  EXPECT_GT(model.log2_near_one, 0x1p-26);
}

/// What docs/devices.md states of a device, at most. A driver for the CPU rounds roots and quotients; the
/// truth is a double.
struct Stated {
  double root, quotient, power;
};

Stated stated_of(const DeviceInfo& info) {
  constexpr double rounded = 0.5 + 1e-6;
  if (info.kind == "CPU") return {rounded, rounded, 175};
  return {usual_gpu.root_ulps, usual_gpu.quotient_ulps, 230};
}

// At 1 % of the floats.
TEST_F(Device, TheOtherFunctionsAreAsWrongAsStatedAtMost) {
  const Probe found = probe(vulkan(), ProbeExtent::sample);
  const Stated stated = stated_of(vulkan().info());
  EXPECT_LE(found.root.error, stated.root);
  EXPECT_LE(found.reciprocal.error, stated.quotient);
  EXPECT_LE(found.quotient.error, stated.quotient);
  for (const LargestError& error : {found.root, found.reciprocal, found.quotient}) {
    EXPECT_GT(error.error, 0.49) << "no function is better than rounded";
    EXPECT_GE(error.count, 1'000'000U);
  }
  EXPECT_LE(found.exp2.error, usual_gpu.exp2_ulps);
  EXPECT_LE(found.log2.error, usual_gpu.log2_ulps);
  EXPECT_LE(found.log2_near_one.error, usual_gpu.log2_near_one);
  EXPECT_LE(found.power.error, stated.power);
  EXPECT_GT(found.power.error, 100);
  EXPECT_EQ(against_usual(found).find("coarser"), std::string::npos) << against_usual(found);
  if (vulkan().info().kind != "CPU") return;
  EXPECT_FALSE(found.fuses);
  const bool is_lavapipe = vulkan().info().name.find("llvmpipe") != std::string::npos;
  EXPECT_EQ(found.keeps_small_operands, is_lavapipe);
  EXPECT_EQ(found.keeps_small_results, is_lavapipe);
}

// Every half. A driver for the CPU rounds its floats to half, a GPU may cut them off.
TEST_F(Device, FunctionsInHalfAreRoundedOrCutOff) {
  if (!vulkan().info().has_half) {
    EXPECT_THROW(probe_halves(vulkan()), UserError);
    return;
  }
  const HalfProbe found = probe_halves(vulkan());
  const double narrowing = vulkan().info().kind == "CPU" ? 0.5 : 1;
  const auto most = [&](double ulps_of_float) { return narrowing + ulps_of_float * 0x1p-13; };
  EXPECT_LE(found.exp2.error, most(usual_gpu.exp2_ulps));
  EXPECT_LE(found.log2.error, most(usual_gpu.log2_ulps));
  EXPECT_LE(found.log2_near_one.error, narrowing * 0x1p-11 + usual_gpu.log2_near_one) << "below 1 in size";
  EXPECT_LE(found.root.error, most(usual_gpu.root_ulps));
  EXPECT_LE(found.reciprocal.error, most(usual_gpu.quotient_ulps));
  EXPECT_GT(found.exp2.error, 0.49) << "no half is better than rounded";
  EXPECT_EQ(found.exp2.count, 38'657U) << "the halves from -14 to 16";
  EXPECT_EQ(found.log2.count + found.log2_near_one.count, found.root.count);
  EXPECT_EQ(found.root.count, 30'720U) << "all normal ones";
  EXPECT_EQ(found.reciprocal.count, 28'673U);
}

TEST_F(Device, RunsEveryFormWithinTheBoundInBothLanguages) {
  // exp2(A c - A) has the largest bound: A is up to 2^11/ln 2, and each of its two is off by up to 2^-19 of
  // itself.
  constexpr double vague = 0x1p-7;
  const forms::Catalogue catalogue = forms::catalogue();
  std::map<forms::Arguments, DrawnInputs> drawn;
  std::size_t forms = 0;
  for (const bench::FormToTime& form : forms_of(catalogue)) {
    const forms::Arguments kind = forms::target_of(catalogue, form.row.target).arguments;
    if (!drawn.contains(kind)) drawn.emplace(kind, drawn_for(kind));
    const DrawnInputs& inputs = drawn.at(kind);
    const std::vector<double> values = values_at(inputs, form.function);
    const std::vector<double> bounds = bounds_of(inputs, form.function, usual_gpu);
    // log2 of 0, or of a subnormal number that is flushed to 0, is no number that a bound could have.
    const auto is_vague = [](double bound) { return bound > vague; };
    const bool has_log2_of_zero = form.row.form == "lobe-exp2-log2";
    EXPECT_EQ(std::count_if(bounds.begin(), bounds.end(), is_vague), has_log2_of_zero ? 2 : 0)
        << form.row.label;
    for (const ShaderLanguage language : languages) {
      EXPECT_EQ(beyond(form.function, language, inputs, values, bounds), "")
          << form.row.target << " " << form.row.label << " in " << name_of(language);
    }
    ++forms;
  }
  EXPECT_GT(forms, 70U);
}

/// The form in double is the truth: what is left is the arithmetic in half.
TruthOfCosines in_double(const ShaderFunction& function) {
  return [form = FormInDouble(function)](const float* in, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto c = static_cast<double>(in[i]);
      form(std::array{&c}, out + i, 1);
    }
  };
}

/// The halves whose log2 has no bound, because a device may take a subnormal half as 0. pow(0, p) is 0.
std::size_t without_bound(std::string_view form) {
  constexpr std::size_t subnormals = 1023;
  if (form == "lobe-pow") return subnormals;
  return form == "lobe-exp2-log2" ? subnormals + 1 : 0;
}

// Every half in [0, 1] through every form of one cosine.
TEST_F(Device, RunsEveryHalfWithinTheBound) {
  const forms::Catalogue catalogue = forms::catalogue();
  for (const bench::FormToTime& form : forms_of(catalogue)) {
    if (forms::target_of(catalogue, form.row.target).arguments != forms::Arguments::cosine) continue;
    const TruthOfCosines truth = in_double(form.function);
    if (!vulkan().info().has_half) {
      EXPECT_THROW(errors_in_half(vulkan(), form.function, truth, usual_gpu), UserError);
      continue;
    }
    const bench::FloatErrors found = errors_in_half(vulkan(), form.function, truth, usual_gpu);
    EXPECT_EQ(found.count(), 15361U);
    EXPECT_EQ(found.unbounded, without_bound(form.row.form)) << form.row.label;
    EXPECT_GT(found.max_abs_error, 0x1p-13) << form.row.form << " is better than rounded to half";
    EXPECT_EQ(found.beyond, 0U) << form.row.label;
  }
}

/// The constants with one digit of the k-th number one too large: 0 instead of 9.
forms::Constants with_wrong_digit(forms::Constants constants, std::size_t k, std::size_t place) {
  char& digit = constants.numbers.at(k).printed.at(place);
  digit = digit == '9' ? '0' : static_cast<char>(digit + 1);
  return constants;
}

// Each digit of the published pair.
TEST_F(Device, FindsAWrongDigitInBothLanguages) {
  const Chosen chosen("fresnel-quadratic");
  const forms::Constants& right = chosen.form->constants.front();
  const ShaderFunction form = bench::function_of(*chosen.target, *chosen.form, right);
  const DrawnInputs inputs = drawn_cosines();
  const std::vector<double> values = values_at(inputs, form);
  const std::vector<double> bounds = bounds_of(inputs, form, usual_gpu);
  std::size_t digits = 0;
  for (std::size_t k = 0; k < right.numbers.size(); ++k) {
    for (const std::size_t place : digits_of(right.numbers[k].printed)) {
      const forms::Constants wrong = with_wrong_digit(right, k, place);
      const ShaderFunction other = bench::function_of(*chosen.target, *chosen.form, wrong);
      for (const ShaderLanguage language : languages)
        EXPECT_NE(beyond(other, language, inputs, values, bounds), "")
            << wrong.numbers[k].printed << " in " << name_of(language);
      ++digits;
    }
  }
  EXPECT_GE(digits, 12U);
}

/// A form with one wrong digit of one constant: the fifth, or the last of a shorter one. The bounds hide
/// later digits.
forms::Constants with_wrong_fifth_digit(const forms::Constants& right, std::size_t k) {
  constexpr std::size_t fifth = 4;
  const std::vector<std::size_t> digits = digits_of(right.numbers[k].printed);
  return with_wrong_digit(right, k, digits.at(std::min(fifth, digits.size() - 1)));
}

// Each constant of every form with every set of constants.
TEST_F(Device, FindsAWrongDigitInEveryForm) {
  const forms::Catalogue catalogue = forms::catalogue();
  std::map<forms::Arguments, DrawnInputs> drawn;
  std::set<std::string> found;
  for (const forms::FormEntry& entry : catalogue.forms) {
    const forms::Target& target = forms::target_of(catalogue, entry.target);
    if (bench::is_of_several_lights(target)) continue;
    const forms::Arguments kind = target.arguments;
    if (!drawn.contains(kind)) drawn.emplace(kind, thinned(drawn_for(kind)));
    const DrawnInputs& inputs = drawn.at(kind);
    for (const forms::Constants& right : entry.constants) {
      if (right.numbers.empty()) continue;
      const ShaderFunction form = bench::function_of(target, entry, right);
      const std::vector<double> values = values_at(inputs, form);
      const std::vector<double> bounds = bounds_of(inputs, form, usual_gpu);
      for (std::size_t k = 0; k < right.numbers.size(); ++k) {
        const forms::Constants wrong = with_wrong_fifth_digit(right, k);
        const ShaderFunction other = bench::function_of(target, entry, wrong);
        for (const ShaderLanguage language : languages)
          EXPECT_NE(beyond(other, language, inputs, values, bounds), "")
              << entry.id << " " << right.id << " with " << wrong.numbers[k].printed << " in "
              << name_of(language);
      }
      found.emplace(entry.id);
    }
  }
  for (const char* of_several_arguments : {"gloss-sg", "phong-sg"})
    EXPECT_TRUE(found.contains(of_several_arguments)) << of_several_arguments;
  EXPECT_GE(found.size(), 14U);
}

// The sweep of `bench --exhaustive`: whole stretches, several dispatches, and a bound that is too small.
TEST_F(Device, SweepsFloatsAndNotesThoseBeyondTheBound) {
  const Chosen chosen("lobe-squarings");
  const ShaderFunction form =
      bench::function_of(*chosen.target, *chosen.form, chosen.form->constants.front());
  const auto device = std::make_shared<SweptDevice>(VulkanDevice({.is_watched = true}));
  bench::FloatSubject subject;
  subject.truth = [](const float* in, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(static_cast<double>(in[i]), 16);
  };
  sweep_on_device(subject, device, form, usual_gpu);
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
  for (const std::string& message : device->vulkan.messages())
    ADD_FAILURE() << "validation layer: " << message;
}

TEST_F(Device, RefusesADeviceThatIsNotThere) {
  EXPECT_THROW(VulkanDevice({.place = 99}), UserError);
}

}  // namespace
}  // namespace shadefit::device
