#include "bench/tradeoff/trade.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "bench/tradeoff/measure.hpp"
#include "bench/tradeoff/report.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "bench/tradeoff/timing.hpp"
#include "reports/io/writers.hpp"
#include "tests/bench/exp2_choices.hpp"

namespace shadefit::bench {
namespace {

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

TimedForm made_up(std::string target, std::string form, int exp2_degree, double ns,
                  std::optional<double> error) {
  return {.target = std::move(target),
          .form = form,
          .label = form,
          .exp2_degree = exp2_degree,
          .max_abs_error = error,
          .ns = {ns, ns * 0.1},
          .multiply_adds = ns / 0.1};
}

/// A lobe with a cheap form under two polynomials and with two sets of constants, a form that is beaten, and
/// pow; and another target.
Trade made_up_trade() {
  Trade trade{.machine = {"A CPU, made up", "a compiler"},
              .rounds = 21,
              .shows_all_sets = false,
              .targets = {{"lobe", "The lobe c^10"}, {"other", "Another"}},
              .forms = {made_up("", "multiply-add", 0, 0.1, {}), made_up("lobe", "pow", 0, 20, 6e-8),
                        made_up("lobe", "cheap", 3, 0.2, 0.03), made_up("lobe", "cheap", 3, 0.2, 0.02),
                        made_up("lobe", "cheap", 5, 0.3, 0.004), made_up("lobe", "bad", 0, 0.9, 0.1),
                        made_up("other", "other", 0, 0.3, 0.1)}};
  trade.forms[3].constants = "best";
  return trade;
}

TEST(Spread, IsOfTheMiddleHalf) {
  const Spread odd = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.width, 2);
  const Spread even = spread_of({4, 1, 3, 2});
  EXPECT_EQ(even.median, 2.5);
  EXPECT_EQ(even.width, 1.5);
  EXPECT_EQ(spread_of({7}).width, 0);
  EXPECT_EQ(spread_of({1, 1, 1, 1, 1, 1, 1, 1, 1, 1000}).width, 0) << "one visit of ten was disturbed";
}

TEST(Unbeaten, IsWhatNoOtherBeats) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto marks = [](const std::vector<std::optional<double>>& errors) {
    std::vector<TimedForm> forms;
    for (const auto& error : errors) forms.push_back({.max_abs_error = error});
    mark_unbeaten(forms);
    std::string found;
    for (const TimedForm& form : forms) found += form.is_unbeaten ? '+' : '-';
    return found;
  };
  EXPECT_EQ(marks({0.5, 0.1, 0.1, 0.01, 0.02}), "++-+-") << "of equal ones the first";
  EXPECT_EQ(marks({std::nullopt, nan, 1, 0}), "--++");
  EXPECT_EQ(marks({}), "");
}

/// About a microsecond, of which sums are exact.
constexpr double tick = 0x1p-20;

TEST(Timing, RoundsAreInterleaved) {
  std::vector<int> order;  // of pieces of work, runs in a row once
  std::vector<long> repeats(3);
  const auto work = [&](std::size_t id, double seconds) {
    return Work{[&, id, seconds](long count) {
                  repeats[id] += count;
                  if (order.empty() || order.back() != static_cast<int>(id))
                    order.push_back(static_cast<int>(id));
                  return static_cast<double>(count) * seconds;
                },
                10};
  };
  const std::vector<Work> all{work(0, tick), work(1, 4 * tick), work(2, 2 * tick)};
  std::vector<double> shares;
  const auto samples = time_interleaved(all, {.rounds = 4, .seconds = 8 * tick},
                                        [&](double share) { shares.push_back(share); });
  // Each is calibrated once; then one round forwards and one backwards.
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 0, 1, 2, 1, 0, 1, 2, 1, 0}));
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].repeats, 8);
  EXPECT_EQ(samples[1].repeats, 2);
  // To find that 8 repeats fill a visit takes 15; then 8 in each round.
  EXPECT_EQ(repeats[0], 15 + 4 * 8);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(samples[i].ns.size(), 4U);
    // ns an element: 10 elements a repeat; a last bit or two for the division.
    const double wanted = std::array{1., 4., 2.}.at(i) * tick * 1e9 / 10;
    for (const double ns : samples[i].ns) EXPECT_DOUBLE_EQ(ns, wanted);
  }
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(Timing, WhoIsToldHowFarItIsMayEndIt) {
  const Work work{[](long count) { return static_cast<double>(count); }, 1};
  EXPECT_THROW(time_interleaved(std::vector{work}, {.rounds = 3, .seconds = 1},
                                [](double share) {
                                  if (share > 0.5) throw 7;
                                }),
               int);
}

TEST(Trade, ATableShowsTheBestConstantsOrAllOfThemTheFastestFirst) {
  Trade trade = made_up_trade();
  const auto names = [&] {
    std::vector<std::string> found;
    for (const TimedForm& timed : shown_forms(trade, "lobe"))
      found.push_back(full_id(timed) + " " + timed.constants);
    return found;
  };
  EXPECT_EQ(names(), (std::vector<std::string>{"cheap/exp2-3 best", "cheap/exp2-5 ", "bad ", "pow "}));
  trade.shows_all_sets = true;
  EXPECT_EQ(names().size(), 5U);
}

TEST(Trade, TheTableOfATargetMarksTheFront) {
  const std::string csv = write_csv(times_table(made_up_trade(), "lobe"), Precision::report);
  EXPECT_EQ(csv,
            "form,precision,max abs error,ns,spread,MADs,unbeaten\n"
            "cheap,float,0.02,0.2,0.02,2,yes\n"
            "cheap,float,0.004,0.3,0.03,3,yes\n"
            "bad,float,0.1,0.9,0.09,9,\n"
            "pow,float,6e-08,20,2,200,yes\n");
}

TEST(Trade, TheFileOfTimesHasTheColumnsThatOthersRelyOn) {
  const std::string csv = write_csv(bench_table(made_up_trade()), Precision::report);
  EXPECT_TRUE(csv.starts_with(
      "target,form,constants,exp2_degree,precision,ns_per_element,spread,max_abs_error,multiply_adds,cpu,"
      "compiler,device,driver,clock\n"
      ",multiply-add,,0,float,0.1,0.01,,1,\"A CPU, made up\",a compiler,cpu,,steady clock\n"))
      << csv;
  EXPECT_TRUE(has(csv, "\nlobe,cheap,best,3,float,0.2,0.02,0.02,2,\"A CPU, made up\"")) << csv;
}

TEST(Trade, OnADeviceHalfIsARowOfItsOwn) {
  Trade trade = made_up_trade();
  trade.machine = {.cpu = "A CPU", .device = "A GPU", .driver = "a driver"};
  trade.forms[3].precision = ShaderPrecision::float16;
  const std::string csv = write_csv(times_table(trade, "lobe"), Precision::report);
  EXPECT_TRUE(has(csv, "\ncheap,half,0.02,0.2,0.02,2,")) << csv;
  EXPECT_TRUE(has(csv, "\ncheap,float,0.03,0.2,0.02,2,")) << csv;
  EXPECT_TRUE(has(bench_files(trade, {}).front().content, "A GPU, driver a driver, on A CPU"));
  // The figure compares what shaders compute in float.
  const Figure figure = bench_figures(trade).front();
  for (const auto& row : figure.data.rows) EXPECT_FALSE(text(row[1], Precision::report) == "0.02");
}

TEST(Trade, TheReportHasTablesAndPictures) {
  const Trade trade = made_up_trade();
  const std::string report = bench_files(trade, bench_figures(trade)).front().content;
  for (const char* part : {"## The lobe c^10", "| cheap ", "](plots/pareto-lobe.svg)", "| multiply-add ",
                           "A CPU, made up, compiled by a compiler.", "21 rounds"})
    EXPECT_TRUE(has(report, part)) << part << report;
  EXPECT_FALSE(has(bench_files(trade, {}).front().content, "plots/"));
}

TEST(Pareto, ThePictureJoinsTheFrontAndNamesIt) {
  const Trade trade = made_up_trade();
  const Figure figure = bench_figures(trade).front();
  EXPECT_EQ(figure.name, "pareto-lobe");
  const std::string csv = write_csv(figure.data, Precision::report);
  EXPECT_EQ(csv,
            "ns,front,form,name\n0.2,0.02,,cheap/exp2-3\n0.3,0.004,,cheap/exp2-5\n"
            "0.9,,0.1,bad\n20,6e-08,,pow\n");
  EXPECT_TRUE(has(figure.script, "set logscale x 2\nset logscale y\n"));
  EXPECT_TRUE(has(figure.script, "set label 'cheap/exp2-3' at first 0.2, first 0.02"));
  EXPECT_FALSE(has(figure.script, "set label 'bad'"));
  Trade without = trade;
  for (TimedForm& form : without.forms) form.max_abs_error.reset();
  EXPECT_TRUE(bench_figures(without).empty());
}

TEST(Pareto, DrawsTheProcessorsNameAsItIs) {
  Trade trade = made_up_trade();
  trade.machine.cpu = "Intel(R) Xeon(R) CPU @ 2.20GHz";
  EXPECT_TRUE(has(bench_figures(trade).front().script, R"(on Intel(R) Xeon(R) CPU \@ 2.20GHz' off)"));
}

TEST(LargestError, IsInfiniteWhereAValueIsNoNumber) {
  const std::array<double, 3> truth{1, 2, 3};
  EXPECT_EQ(largest_error(std::array{1.F, 2.5F, 2.75F}, truth), 0.5);
  EXPECT_EQ(largest_error(std::array{1.F, std::numeric_limits<float>::quiet_NaN(), 3.F}, truth),
            std::numeric_limits<double>::infinity());
}

TEST(MultiplyAdds, AreWhatTheirNameSays) {
  const Operations operations = count_operations(multiply_add_chain().result);
  EXPECT_EQ(operations.multiply_add, multiply_adds_of_chain);
  EXPECT_EQ(operations.total(), multiply_adds_of_chain);
  // The sum of its coefficients is 1: a chain of them stays in [0, 1].
  EXPECT_EQ(evaluate<double>(multiply_add_chain().result, [](const std::string&) { return 1.0; }), 1);
}

TEST(CatalogueForms, AreAllOnesOfOneLight) {
  const auto catalogue = forms::catalogue();
  const Trade all = catalogue_forms(catalogue, {}, Exp2Kinds::library),
              some = catalogue_forms(catalogue, {"schlick"}, Exp2Kinds::library);
  EXPECT_EQ(all.targets.size(), 5U);
  EXPECT_GT(all.forms.size(), 70U);
  ASSERT_EQ(some.targets.size(), 1U);
  for (const TimedForm& form : all.forms) EXPECT_TRUE(form.max_abs_error) << form.label;
}

// The polynomials in C compute the bits that they have in C++.
TEST(Measure, Exp2InCIsThatOfTheForms) {
  std::vector<float> in;
  for (float x = -130; x < 130; x += 0.37F) in.push_back(x);
  in.insert(in.end(), {-200, -127, -126.5F, 0.5F, 1e30F, -1e30F});
  shadefit::testing::for_each_degree<float>([&]<class P>(P) {
    const std::string name = "exp2_degree_" + std::to_string(P::record.degree);
    const std::shared_ptr<void> code =
        compiled_code(exp2_in_c(P::record.degree) + "float call(float x);\nfloat call(float x) { return " +
                      name + "(x); }\n");
    const auto call = reinterpret_cast<float (*)(float)>(::dlsym(code.get(), "call"));
    for (const float x : in) EXPECT_EQ(call(x), exp2_polynomial<P>(x)) << name << " of " << x;
  });
}

TEST(Measure, EveryFormHasATime) {
  const auto catalogue = forms::catalogue();
  const Trade forms = catalogue_forms(catalogue, {"schlick"}, Exp2Kinds::polynomials);
  const Trade trade = measure(forms, {2, 1e-6}, [](double) {});
  ASSERT_EQ(trade.forms.size(), 1 + forms.forms.size());
  for (const TimedForm& row : trade.forms) {
    EXPECT_GT(row.ns.median, 0) << row.label;
    EXPECT_GT(*row.multiply_adds, 0) << row.label;
  }
  EXPECT_EQ(trade.rounds, 2);
  EXPECT_NE(trade.machine.compiler, "");
  EXPECT_NE(trade.machine.cpu, "");
}

}  // namespace
}  // namespace shadefit::bench
