#include "bench/tradeoff/trade.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "bench/timing/machine.hpp"
#include "bench/timing/timing.hpp"
#include "bench/tradeoff/labels.hpp"
#include "bench/tradeoff/report.hpp"
#include "reports/table/writers.hpp"
#include "tests/bench/made_up_trade.hpp"

namespace shadefit::bench {
namespace {

using testing::has;
using testing::made_up_trade;

TEST(Spread, IsOfTheMiddleHalf) {
  const Spread odd = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.lower_quartile, 2);
  EXPECT_EQ(odd.upper_quartile, 4);
  const Spread even = spread_of({4, 1, 3, 2});
  EXPECT_EQ(even.median, 2.5);
  EXPECT_EQ(even.lower_quartile, 1.75);
  EXPECT_EQ(even.width(), 1.5);
  EXPECT_EQ(spread_of({7}).width(), 0);
  EXPECT_THROW(spread_of({}), std::invalid_argument);
}

// One visit of ten was disturbed: neither number moves much.
TEST(Spread, OneSampleOfManyDecidesNothing) {
  const Spread spread = spread_of({1, 1, 1, 1, 1, 1, 1, 1, 1, 1000});
  EXPECT_EQ(spread.median, 1);
  EXPECT_EQ(spread.width(), 0);
}

TEST(Front, HoldsWhatNoOtherBeats) {
  // In the order of time: 2, 0, 3; 1 is slower than 0 and no better, 4 as 3.
  EXPECT_EQ(front_of({{2, 0.1}, {3, 0.1}, {1, 0.5}, {4, 0.01}, {4, 0.02}}),
            (std::vector<std::size_t>{2, 0, 3}));
  EXPECT_EQ(front_of({{1, 1}, {1, 1}}), std::vector<std::size_t>{0}) << "of equal ones the first";
  EXPECT_TRUE(front_of({}).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(front_of({{nan, 0}, {1, nan}, {1, 1}}), std::vector<std::size_t>{2});
}

/// About a microsecond, of which sums are exact.
constexpr double tick = 0x1p-20;

/// A clock that moves with the work.
struct Worked {
  double seconds = 0;
  Clock clock() {
    return [this] { return Instant{seconds, seconds / 2}; };
  }
};

TEST(Timing, ARoundVisitsEveryPieceOnceAndNobodyComesAlwaysAfterTheSame) {
  EXPECT_EQ(visits(0, 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(visits(1, 3), (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_TRUE(visits(0, 0).empty());
}

TEST(Timing, RoundsAreInterleaved) {
  Worked worked;
  std::vector<int> order;  // of pieces of work, calls in a row once
  const auto work = [&](int id, double seconds) {
    return Work{[&worked, &order, id, seconds] {
                  worked.seconds += seconds;
                  if (order.empty() || order.back() != id) order.push_back(id);
                },
                10, id == 0};
  };
  const std::vector<Work> all{work(0, tick), work(1, 4 * tick), work(2, 2 * tick)};
  std::vector<double> shares;
  const auto samples = time_interleaved(all, {.rounds = 4, .seconds = 8 * tick}, worked.clock(),
                                        [&](double share) { shares.push_back(share); });
  // Each is calibrated once; then one round forwards and one backwards.
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 0, 1, 2, 1, 0, 1, 2, 1, 0}));
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].calls, 8);
  EXPECT_EQ(samples[1].calls, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(samples[i].real.size(), 4U);
    // ns an element: 10 elements a call; a last bit or two for the division.
    const double wanted = std::array{1., 4., 2.}.at(i) * tick * 1e9 / 10;
    for (const double ns : samples[i].real) EXPECT_DOUBLE_EQ(ns, wanted);
    for (const double ns : samples[i].cpu) EXPECT_DOUBLE_EQ(ns, wanted / 2);
  }
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(Timing, AWarmPieceIsCalledBeforeTheClockStarts) {
  Worked worked;
  long calls = 0;
  const auto count = [&](bool is_warm) {
    calls = 0;
    const Work work{[&] {
                      ++calls;
                      worked.seconds += tick;
                    },
                    1, is_warm};
    time_interleaved(std::vector{work}, {.rounds = 1, .seconds = 16 * tick}, worked.clock(), [](double) {});
    return calls;
  };
  // To find that 16 calls fill a visit takes 31; then 16, and 3 to warm up.
  EXPECT_EQ(count(false), 31 + 16);
  EXPECT_EQ(count(true), 31 + 16 + 3);
}

TEST(Timing, WhoIsToldHowFarItIsMayEndIt) {
  Worked worked;
  const Work work{[&] { worked.seconds += 1; }, 1};
  EXPECT_THROW(time_interleaved(std::vector{work}, {.rounds = 3, .seconds = 1}, worked.clock(),
                                [](double share) {
                                  if (share > 0.5) throw 7;
                                }),
               int);
}

TEST(Timing, TheClockOfAVisitGoesForward) {
  const Instant before = now(), after = now();
  EXPECT_LE(before.real, after.real);
  EXPECT_LE(before.cpu, after.cpu);
}

TEST(Machine, ReadsItsNameOrSaysThatItIsUnknown) {
  EXPECT_EQ(
      cpu_name("processor\t: 0\nmodel\t\t: 17\nmodel name\t: AMD EPYC 9R14 \nflags : fpu\nmodel name: B\n"),
      "AMD EPYC 9R14");
  EXPECT_EQ(cpu_name(""), "unknown");
  EXPECT_EQ(cpu_name("model name\nmodel name:\nmodel name :  \n"), "unknown");
  EXPECT_FALSE(this_machine().cpu.empty());
  EXPECT_GE(this_machine().threads, 1U);
}

const TimedForm* find_timed(const std::vector<TimedForm>& rows, std::string_view form, DataPlace place) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const TimedForm& row) {
    return row.form == form && row.width == forms::Width::avx2 && row.place == place;
  });
  return found == rows.end() ? nullptr : &*found;
}

TEST(Trade, RelatesTimesToTheCopyAndTheScalarReferenceOfItsOwnKind) {
  const Trade trade = made_up_trade();
  const TimedForm& cheap = *find_timed(trade.forms, "cheap", DataPlace::first_cache);
  EXPECT_DOUBLE_EQ(*cheap.copies, 0.2 / 0.1) << "the copy in AVX2";
  EXPECT_DOUBLE_EQ(*cheap.pows, 20 / 0.2) << "the scalar pow of the same precision and place";
  const TimedForm& far = *find_timed(trade.forms, "cheap", DataPlace::memory);
  EXPECT_DOUBLE_EQ(*far.copies, 1);
  EXPECT_FALSE(far.pows) << "no pow was timed in memory";
  const TimedForm& of_other = *find_timed(trade.forms, "other", DataPlace::first_cache);
  EXPECT_FALSE(of_other.pows) << "its target has no reference";
}

TEST(Trade, AFrontHoldsEachFormAtItsFastestWidth) {
  const auto front = front_of_target(made_up_trade(), "lobe");
  std::vector<std::string> names;
  for (const TimedForm& timed : front)
    names.push_back(full_id(timed) + " " + std::string(forms::name(timed.width)));
  EXPECT_EQ(names,
            (std::vector<std::string>{"cheap/exp2-3 AVX2", "cheap/exp2-5 AVX2", "pow AVX2", "pow AVX2"}));
  EXPECT_FALSE(front[2].is_double);
  EXPECT_TRUE(front[3].is_double);
}

TEST(Trade, AdviceNamesErrorFormTimeAndBound) {
  const std::string text = advice(made_up_trade(), "lobe");
  EXPECT_TRUE(text.starts_with(
      "- An error of 0.02 allowed: cheap form, exp2 of degree 3 in float (AVX2), 0.2 ns an element; "
      "100 x as fast as the scalar loop of the library, 10 x as fast as its widest form; "
      "bound by its arithmetic (2.0 x a copy), in memory by the memory.\n"))
      << text;
  EXPECT_TRUE(
      has(text,
          "\n- An error of 6e-08 allowed: pow in float (AVX2), 2 ns an element; the library's own functions; "
          "bound by its arithmetic (20 x a copy).\n"))
      << text;
  // A form that takes at most 1.25 copies is limited by its data.
  Trade trade = made_up_trade();
  for (TimedForm& timed : trade.forms) timed.ns.median /= 2;
  relate(trade);
  EXPECT_TRUE(has(advice(trade, "lobe"), "bound by loads and stores (1.0 x a copy)"));
  EXPECT_EQ(advice(trade, "nothing"), "Nothing was measured.\n");
}

// On a graphics device the same form in half is another way, with an error of its own.
TEST(Trade, HalfAndFloatAreWaysOfTheirOwn) {
  Trade trade;
  trade.machine.driver = "a driver";
  for (const bool is_half : {false, true}) {
    TimedForm timed =
        testing::made_up("lobe", "sg", 0, forms::Width::scalar, is_half ? 1 : 2, is_half ? 0.01 : 0.008);
    timed.on_device.emplace().is_half = is_half;
    trade.forms.push_back(timed);
  }
  EXPECT_EQ(precision_of(trade.forms[0]), "float");
  EXPECT_EQ(precision_of(trade.forms[1]), "half");
  EXPECT_FALSE(is_same_way(trade.forms[0], trade.forms[1]));
  EXPECT_EQ(front_of_target(trade, "lobe").size(), 2U);
  const std::string csv = write_csv(bench_table(trade), Precision::report);
  EXPECT_TRUE(has(csv, "\nlobe,sg,,0,half,,,1,0.1,")) << "no width and no place\n" << csv;
  // The figure compares what shaders compute in float.
  const Figure figure = pareto_figure(trade, {"lobe", "The lobe"});
  EXPECT_EQ(figure.data.rows.size(), 1U);
  EXPECT_FALSE(has(figure.caption, "L1"));
}

TEST(Trade, TheTableOfTimesHasTheColumnsThatOthersRelyOn) {
  const std::string csv = write_csv(bench_table(made_up_trade()), Precision::report);
  EXPECT_TRUE(csv.starts_with(
      "target,form,constants,exp2_degree,precision,width,place,ns_per_element,spread,copies,"
      "times_faster_than_pow,max_abs_error,cpu,compiler,device,driver,clock,multiply_adds,dependent_ns,"
      "dependent_multiply_adds\n"))
      << csv.substr(0, 200);
  EXPECT_TRUE(
      has(csv,
          "\nlobe,cheap,,3,float,AVX2,L1,0.2,0.02,2,100,0.02,\"A CPU, made up\",a compiler,cpu,,steady "
          "clock,2,,\n"));
  EXPECT_TRUE(
      has(csv, "\n,copy,,0,float,AVX2,L1,0.1,0.01,,,,\"A CPU, made up\",a compiler,cpu,,steady clock,,,\n"));
}

TEST(Trade, TheReportHasWordsTablesPicturesAndGoals) {
  const Trade trade = made_up_trade();
  const std::string report = bench_report(trade, bench_figures(trade), true);
  for (const char* part : {"# What to use when", "## The lobe c^10", "- An error of 0.02 allowed",
                           "| cheap form, exp2 of degree 3 ", "](plots/pareto-lobe.svg)", "# Goals",
                           "A CPU, made up, compiled by a compiler; widths: scalar, AVX2."})
    EXPECT_TRUE(has(report, part)) << part;
  EXPECT_TRUE(report.ends_with("|\n"));
  EXPECT_FALSE(has(bench_report(trade, {}, false), "plots/"));
  const std::string goals = write_csv(goals_table(trade), Precision::report);
  EXPECT_EQ(goals,
            "ratio,wanted,reached,met\nfast,>= 45,52,yes\nslow,>= 45,44,no\nnear,<= 1.4,1.4,yes\n"
            "far,<= 1.4,1.5,no\nabsent,>= 2,,not measured\n");
}

TEST(Pareto, ThePictureJoinsTheFrontAndNamesIt) {
  const Trade trade = made_up_trade();
  const Figure figure = pareto_figure(trade, trade.targets.front());
  EXPECT_EQ(figure.name, "pareto-lobe");
  const std::string csv = write_csv(figure.data, Precision::report);
  EXPECT_TRUE(
      csv.starts_with("ns,front,form,reference,name,width\n"
                      "0.2,0.02,,,cheap/exp2-3,AVX2\n0.3,0.004,,,cheap/exp2-5,AVX2\n"))
      << csv;
  EXPECT_TRUE(has(csv, "\n0.9,,0.1,,bad,AVX2\n")) << "what is beaten is off the front: " << csv;
  EXPECT_TRUE(has(csv, "\n20,,,6e-08,pow,scalar\n")) << csv;
  EXPECT_TRUE(has(figure.script, "set logscale xy"));
  EXPECT_TRUE(has(figure.script, "set label 'cheap/exp2-3' at graph"));
  EXPECT_TRUE(has(figure.script, "set label 'bad' at graph"))
      << "the best of a form is named off the front too";
  EXPECT_TRUE(has(figure.script, "set label 'pow (scalar)' at graph"));
  EXPECT_FALSE(has_pareto_figure(trade, {"nothing", ""}));
}

// gnuplot raises one character after a ^, and takes the space behind it.
TEST(ParetoFigure, RaisesWholeExponents) {
  const Trade trade = testing::made_up_trade();
  const auto title_of = [&](const std::string& title) {
    TimedTarget target = trade.targets.front();
    target.title = title;
    const std::string script = pareto_figure(trade, target).script;
    const std::size_t start = script.find("set title '") + 11;
    return script.substr(start, script.find(", on ", start) - start);
  };
  EXPECT_EQ(title_of("c^(2^(d g + f)), g a code"), "c^{2^{d g + f}}, g a code");
  EXPECT_EQ(title_of("max(n.l, 0)^k over all"), "max(n.l, 0)^{k} over all");
  EXPECT_EQ(title_of("(1 - g^2)/(4 pi (1 + g^2)^1.5)"), "(1 - g^{2})/(4 pi (1 + g^{2})^{1.5})");
  EXPECT_EQ(title_of("c"), "c");
}

TEST(ParetoFigure, DrawsTheProcessorsNameAsItIs) {
  Trade trade = testing::made_up_trade();
  trade.machine.cpu = "Intel(R) Xeon(R) CPU @ 2.20GHz";
  EXPECT_TRUE(
      has(pareto_figure(trade, trade.targets.front()).script, R"(on Intel(R) Xeon(R) CPU \@ 2.20GHz' off)"));
}

struct Rectangle {
  double left, right, top, bottom;
};

TEST(Labels, KeepOffEachOtherOffPointsAndInside) {
  // A dozen points in a corner a label wide, and some without names around them.
  std::vector<Pixel> points;
  std::vector<std::string> names;
  for (int i = 0; i < 12; ++i) {
    points.push_back({20 + 9.0 * i, 20 + 7.0 * (i * 5 % 12)});
    names.push_back("a form of some name " + std::to_string(i));
  }
  points.push_back({200, 30});
  points.push_back({150, 60});
  const Pixel size{798, 470};
  const auto labels = place_labels(points, names, size);
  ASSERT_EQ(labels.size(), names.size());
  std::vector<Rectangle> boxes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Pixel& at = labels[i].middle_left;
    boxes.push_back({at.x, at.x + letter_width * static_cast<double>(names[i].size()), at.y - line_height / 2,
                     at.y + line_height / 2});
    const Rectangle& box = boxes.back();
    EXPECT_TRUE(box.left >= 0 && box.right <= size.x && box.top >= 0 && box.bottom <= size.y) << names[i];
    for (const Pixel& p : points)
      EXPECT_FALSE(p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom) << names[i];
    for (std::size_t j = 0; j < i; ++j) {
      const Rectangle& other = boxes[j];
      EXPECT_FALSE(box.left < other.right && other.left < box.right && box.top < other.bottom &&
                   other.top < box.bottom)
          << names[i] << " over " << names[j];
    }
  }
}

}  // namespace
}  // namespace shadefit::bench
