#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/commands/command_line.hpp"
#include "bench/device/measure_device.hpp"
#include "bench/device/vulkan_device.hpp"
#include "fit/scalars/symbolic.hpp"
#include "reports/io/csv.hpp"
#include "tests/device/drivers.hpp"
#include "tests/temporary_directory.hpp"

/// Times of forms on devices.
namespace shadefit::device {
namespace {

TEST(Turns, AreDoubledUntilADispatchTakesLongEnough) {
  std::vector<long> asked;
  const auto turns_for = [&](double seconds_a_turn, long most) {
    asked.clear();
    return bench::repeats_that_take(0.002, most, [&](long turns) {
      asked.push_back(turns);
      return static_cast<double>(turns) * seconds_a_turn;
    });
  };
  EXPECT_EQ(turns_for(0.0003, 1000), 8);
  EXPECT_EQ(asked, (std::vector<long>{1, 2, 4, 8}));
  EXPECT_EQ(turns_for(0.5, 1000), 1) << "one turn that takes long enough is enough";
  EXPECT_EQ(turns_for(0, 1000), 512) << "no more than the most";
}

TEST(Turns, NoDispatchIsLong) {
  for (const double seconds_a_turn : {1e-9, 1e-6, 3e-5, 1e-3, 0.003}) {
    bench::repeats_that_take(full_device_plan.seconds, 1L << 24, [&](long turns) {
      EXPECT_LT(static_cast<double>(turns) * seconds_a_turn, longest_dispatch);
      return static_cast<double>(turns) * seconds_a_turn;
    });
  }
}

TEST(ShortDispatches, VisitEachItemOnceAndStayShort) {
  // A device that is three times as slow now and then, by a fake clock.
  std::uint64_t next = 0;
  int count = 0;
  in_short_dispatches(10'000'000, most_threads, [&](std::uint64_t from, std::uint64_t n) {
    EXPECT_EQ(from, next);
    next += n;
    const double seconds = static_cast<double>(n) * (from / 1'000'000 % 2 == 0 ? 1e-7 : 3e-7);
    EXPECT_LT(seconds, longest_dispatch) << from;
    ++count;
    return seconds;
  });
  EXPECT_EQ(next, 10'000'000U);
  EXPECT_LT(count, 100);
}

TEST(TimingShader, HoldsTheTextThatEmitWrites) {
  const ShaderFunction function{
      bench::form_name, {"x", "y"}, exp2(Symbolic(Symbolic::variable("x") * Symbolic::variable("y")))};
  const std::array ranges{bench::Range{0, 1}, bench::Range{0, 1}};
  for (const ShaderPrecision precision : shader_precisions) {
    const std::string text =
        shader_code(std::span(&function, 1), Language::glsl, precision, std::array<OthersText, 0>());
    const std::string shader = timing_shader(function, ranges, precision);
    EXPECT_NE(shader.find(text), std::string::npos);
    EXPECT_NE(shader.find("r3 = form(b0 + t * r3, b1 + t * r3);"), std::string::npos) << shader;
  }
}

/// A plan of a second: tests ask whether times are plausible, not what they are.
constexpr bench::TimingPlan short_plan{3, 3e-4};

bench::Trade measured(const bench::Trade& forms) {
  VulkanDevice for_times({.has_buffers_on_device = true}), for_values(DeviceChoice{});
  return measure_on_device(for_times, for_values, forms, short_plan, [](double) {});
}

bool has_half() {
  return vulkan_devices().front().has_half;
}

const bench::TimedForm& row_of(const bench::Trade& trade, std::string_view form, std::string_view precision) {
  return *std::find_if(trade.forms.begin(), trade.forms.end(), [&](const bench::TimedForm& row) {
    return row.form == form && name(row.precision) == precision;
  });
}

class TimesOnDriver : public testing::OnDriver {};

INSTANTIATE_TEST_SUITE_P(Drivers, TimesOnDriver, ::testing::ValuesIn(testing::drivers),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(TimesOnDriver, EveryFormHasATimeAndAnError) {
  const bench::Trade forms = bench::catalogue_forms(forms::catalogue(), {}, bench::Exp2Kinds::library);
  const bench::Trade trade = measured(forms);
  const std::size_t precisions = has_half() ? 2 : 1;
  EXPECT_EQ(trade.forms.size(), 1 + precisions * (1 + forms.forms.size()));
  EXPECT_TRUE(trade.machine.is_graphics());

  std::map<std::array<std::string, 3>, double> on_cpu;
  for (const bench::TimedForm& form : forms.forms)
    on_cpu[{form.target, form.form, form.constants}] = form.max_abs_error.value();
  // The log2 of both drivers errs by up to 3e-7 near 1. A power of 16 multiplies that by 16 ln 2, to 4e-6;
  // twice that is also more than what all other functions add.
  constexpr double slack = 8e-6;
  // A half has a relative error of 2^-11. The phase function reaches 1.9 with g = 0.76, and its root cancels:
  // of the others none has more.
  constexpr double slack_of_half = 0.05;
  for (const bench::TimedForm& row : trade.forms) {
    if (row.target.empty()) continue;
    const std::string name = row.target + " " + row.label + " " + std::string(shadefit::name(row.precision));
    const bool is_half = row.precision == ShaderPrecision::float16;
    // Short rounds beside other programs: a difference of two times may be below 0.
    EXPECT_TRUE(std::isfinite(*row.multiply_adds)) << name << *row.multiply_adds;
    const double cpu = on_cpu.at({row.target, row.form, row.constants});
    EXPECT_NEAR(row.max_abs_error.value(), cpu, is_half ? slack_of_half : slack) << name;
  }
  // Each of these is ten times as long on the CPU; half of that would be a fault of the measurement.
  EXPECT_GT(*row_of(trade, "schlick-pow", "float").multiply_adds,
            2 * *row_of(trade, "schlick", "float").multiply_adds);
  if (!has_half()) return;
  // Where `mediump` were float, the error would be 2e-7.
  EXPECT_GT(row_of(trade, "schlick", "half").max_abs_error, 1e-4);
  EXPECT_LT(row_of(trade, "schlick", "half").max_abs_error, 0x1p-8);
}

TEST_P(TimesOnDriver, TheCommandWritesTables) {
  const testing::TemporaryDirectory directory;
  const auto rows_of = [&](const char* study) {
    const std::string out = directory / study;
    const Outcome outcome = run_command_line(
        {"bench", "--device", "vulkan", "--quick", "--no-plots", study, "--out", out}, keep_going);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(testing::snapshot(out).at("bench.md").find("| multiply-add "), std::string::npos);
    return parse_csv(testing::snapshot(out).at("bench.csv"), "bench.csv").rows;
  };
  constexpr std::size_t target = 0, form = 1, precision = 4, error = 7, device = 11, clock = 13;
  std::set<std::string> forms;
  for (const auto& row : rows_of("acos-linear")) {
    if (row[target] == "acos-linear") forms.insert(row[form]);
    EXPECT_EQ(row[device], vulkan_devices().front().name);
    EXPECT_EQ(row[clock], "processor time of all cores");
  }
  for (const char* wanted : {"target", "linear", "quadratic"}) EXPECT_TRUE(forms.contains(wanted)) << wanted;
  // Errors of a study of rows are those of exact arithmetic, which say nothing of half.
  for (const auto& row : rows_of("three-sheen")) {
    if (row[target].empty()) continue;
    EXPECT_EQ(row[error].empty(), row[precision] == "half") << row[precision];
  }
}

TEST_P(TimesOnDriver, ADeviceThatIsNotThereIsOneLine) {
  const testing::TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome =
      run_command_line({"bench", "--device", "vulkan:7", "--only", "lobe", "--out", out}, keep_going);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(
      outcome.err,
      "shadefit: --device 'vulkan:7': this machine has 1 device that can compute (see 'shadefit help bench')\n");
  EXPECT_TRUE(testing::snapshot(out).empty());
}

}  // namespace
}  // namespace shadefit::device
