#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands/command_line.hpp"
#include "app/options/bench_options.hpp"
#include "app/terminal/interrupt.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::run_process;
using testing::snapshot;
using testing::TemporaryDirectory;

/// A sweep of few floats: 3000 around 1/2.
constexpr const char* few = "0x3efff000:0x3f000000";

Outcome bench(std::vector<std::string> arguments, const Checkpoint& checkpoint = keep_going) {
  arguments.insert(arguments.begin(), "bench");
  return run_command_line(arguments, checkpoint);
}

std::string refusal(const std::vector<std::string>& arguments) {
  const Outcome outcome = bench(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out.substr(0, 200);
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

// One width of one target takes a second.
TEST(BenchCommand, WritesTimesReportAndPictureData) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome =
      bench({"--quick", "--no-plots", "--only", "schlick", "--width", "sse2", "--out", out, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto parsed = nlohmann::json::parse(outcome.out);
  EXPECT_GT(parsed.at("benchmarks").size(), 100U);
  const auto files = snapshot(out);
  EXPECT_TRUE(files.contains("bench.md"));
  ASSERT_TRUE(files.contains("bench.csv"));
  EXPECT_FALSE(files.contains("plots"));
  const CsvTable csv = parse_csv(files.at("bench.csv"), "bench.csv");
  std::set<std::string> targets, widths, places;
  for (const auto& row : csv.rows) {
    targets.insert(row[0]);
    widths.insert(row[5]);
    places.insert(row[6]);
    EXPECT_GT(std::stod(row[7]), 0) << "a time of " << row[1];
    if (!row[0].empty()) {  // not a floor
      EXPECT_NE(row[9], "") << "copies of " << row[1];
      EXPECT_NE(row[10], "") << "pow of " << row[1];
      EXPECT_NE(row[11], "") << "error of " << row[1];
    }
  }
  EXPECT_EQ(targets, (std::set<std::string>{"", "schlick"}));
  EXPECT_EQ(widths, (std::set<std::string>{"scalar", "SSE2"}));
  EXPECT_EQ(places, (std::set<std::string>{"L1", "memory"}));
}

// Without a limit that another process could reach: a form is at most 100 times as slow as a moment ago.
TEST(BenchCommand, ComparesWithAnOlderRun) {
  const TemporaryDirectory directory;
  const std::vector<std::string> quick{"--quick", "--no-plots", "--only", "schlick",        "--width",
                                       "scalar",  "--force",    "--out",  directory / "out"};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), quick.begin(), quick.end());
    return bench(more);
  };
  const Outcome old = run({"--json"});
  ASSERT_EQ(old.exit_code, 0) << old.err;
  const std::string same = directory.file("same.json", old.out), faster = directory / "faster.json";
  const Outcome good = run({"--compare", same, "--fail-above", "9900%"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_NE(good.out.find(" forms take at most 9900 % longer than in '" + same + "'\n"), std::string::npos);

  const std::string name = "schlick/schlick/float/scalar/L1";
  auto json = nlohmann::json::parse(old.out);
  for (auto& row : json["benchmarks"]) {
    if (row["run_name"] == name) row["real_time"] = row["real_time"].get<double>() / 1e6;
  }
  directory.file("faster.json", json.dump());
  for (const char* format : {"text", "json", "github", "markdown"}) {
    const Outcome bad = run({"--compare", faster, "--fail-above", "9900%", "--format", format});
    EXPECT_EQ(bad.exit_code, 1) << format;
    const bool is_on_error = std::string(format) == "text" || std::string(format) == "json";
    const std::string line = name + " takes ";
    EXPECT_NE((is_on_error ? bad.err : bad.out).find(line), std::string::npos) << bad.out << bad.err;
    EXPECT_EQ(std::count(bad.err.begin(), bad.err.end(), '\n'), is_on_error ? 1 : 0) << bad.err;
  }
  // The times differ, the names do not.
  const auto names = [](const std::string& text) {
    std::vector<std::string> found;
    const auto report = nlohmann::json::parse(text);
    for (const auto& row : report.at("benchmarks")) found.push_back(row.at("name"));
    return found;
  };
  EXPECT_EQ(names(run({"--format", "json"}).out), names(old.out));
  EXPECT_TRUE(run({"--format", "markdown"}).out.starts_with("### schlick: (1 - c)^5\n\n| form "));
}

TEST(BenchCommand, RefusesComparisonsThatCannotBe) {
  const TemporaryDirectory directory;
  EXPECT_EQ(
      refusal({"--format", "github"}),
      "shadefit: --format 'github' needs --compare: without it bench checks nothing (see 'shadefit help bench')\n");
  EXPECT_EQ(refusal({"--fail-above", "10%"}),
            "shadefit: --fail-above requires --compare (see 'shadefit help bench')\n");
  for (const char* share : {"10", "0%", "-1%", "%"})
    EXPECT_NE(refusal({"--compare", "old.json", "--fail-above", share}).find("--fail-above '"),
              std::string::npos);
  EXPECT_EQ(refusal({"--compare", directory.file("other.json", "{}")}),
            "shadefit: '" + (directory / "other.json") +
                "' is not a file of 'shadefit bench --json': it has no list 'benchmarks'\n");
  const std::string other = directory.file(
      "old.json", R"({"benchmarks": [{"aggregate_name": "median", "run_name": "a", "real_time": 1}]})");
  EXPECT_EQ(refusal({"--compare", other, "--quick", "--only", "schlick", "--width", "scalar", "--out",
                     directory / "out"}),
            "shadefit: --compare '" + other +
                "' has no form of this run with its reference (see 'shadefit help bench')\n");
  EXPECT_FALSE(std::filesystem::exists(directory / "out"));
}

// The C compiler of this machine compiles the code that `emit` writes.
TEST(BenchCommand, TimesTheFormsOfAStudy) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome = bench({"hg-schlick", "--quick", "--out", out});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("hg(c, g), c in -1:1, g = 0.6"), std::string::npos) << outcome.out;
  const auto files = snapshot(out);
  ASSERT_TRUE(files.contains("bench.md"));
  ASSERT_TRUE(files.contains("bench.csv"));
  const CsvTable csv = parse_csv(files.at("bench.csv"), "bench.csv");
  std::set<std::string> targets, constants;
  for (const auto& row : csv.rows) {
    targets.insert(row[0]);
    constants.insert(row[2]);
    EXPECT_GT(std::stod(row[7]), 0) << "a time of " << row[1];
  }
  EXPECT_EQ(targets, (std::set<std::string>{"", "hg-schlick-1", "hg-schlick-2", "hg-schlick-3"}));
  EXPECT_TRUE(constants.contains("minimax"));
}

TEST(BenchCommand, RefusesStudiesWithoutCode) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out", file = directory / "own.toml";
  EXPECT_NE(refusal({"acos-linear", "--only", "schlick", "--out", out}).find("--only"), std::string::npos);
  EXPECT_NE(refusal({"acos-linar", "--out", out}).find("did you mean 'acos-linear'"), std::string::npos);
  std::ofstream(file) << "schema = 1\nid = \"own\"\n[over]\nx = \"0:1\"\n[target]\nformula = \"exp(x)\"\n"
                         "[[form]]\nid = \"sum\"\nformula = \"a + integral(exp(t), t, 0, x)\"\n";
  EXPECT_EQ(refusal({file, "--out", out}),
            "shadefit: bench has no code for 'integral' in the form 'a + integral(exp(t), t, 0, x)'\n");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(BenchCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refusal({"--only", "schlik"}), "shadefit: unknown target 'schlik': did you mean 'schlick'?\n");
  EXPECT_EQ(
      refusal({"--width", "neon"}),
      "shadefit: --width 'neon' is unknown: it must be one of scalar, sse2, avx2, avx512 (see 'shadefit help bench')\n");
  EXPECT_EQ(refusal({"--out", "--json"}),
            "shadefit: --out '--json' looks like an option: name a value (a path may begin with './')"
            " (see 'shadefit help bench')\n");
  EXPECT_EQ(
      refusal({"--device", "cuda"}),
      "shadefit: --device 'cuda' is not a device: it must be vulkan or vulkan:N, see 'shadefit bench --list-devices'\n");
  EXPECT_EQ(refusal({"--device", "vulkan", "--width", "sse2"}),
            "shadefit: --width excludes --device (see 'shadefit help bench')\n");
  const TemporaryDirectory directory;
  EXPECT_EQ(refusal({"--exhaustive", "sg", "--half"}),
            "shadefit: --half requires --device (see 'shadefit help bench')\n");
  EXPECT_EQ(refusal({"--device", "vulkan", "--only", "phong-64", "--out", directory / "out"}),
            "shadefit: --device has no form for --only 'phong-64': sums of several lights are not measured "
            "there, phong-1 is one light (see 'shadefit help bench')\n");
  const auto here = forms::widths_here();
  if (here.back() != forms::Width::avx512) {
    EXPECT_EQ(refusal({"--width", "avx512"}),
              "shadefit: --width 'avx512' is not of this machine: its widest registers are " +
                  std::string(forms::name(here.back())) + " (see 'shadefit help bench')\n");
  }
}

TEST(ExhaustiveCommand, RefusesWhatItDoesNotKnow) {
  const TemporaryDirectory directory;
  const auto refused = [&](std::vector<std::string> arguments) {
    for (const char* more : {"--out", ""}) arguments.push_back(*more != '\0' ? more : directory / "out");
    return refusal(arguments);
  };
  EXPECT_EQ(refused({"--exhaustive", "schlik"}),
            "shadefit: unknown form of one cosine 'schlik': did you mean 'schlick'?\n");
  EXPECT_EQ(refused({"--exhaustive", "phong-sg"}),
            "shadefit: --exhaustive 'phong-sg' is not a form of one cosine: it reads a normal of each element"
            " (see 'shadefit help bench')\n");
  EXPECT_EQ(
      refused({"--exhaustive", "gloss-sg"}),
      "shadefit: --exhaustive 'gloss-sg' is not a form of one cosine: it reads a gloss too of each element"
      " (see 'shadefit help bench')\n");
  EXPECT_EQ(refused({"--exhaustive", "fresnel-fourth", "--constants", "mine"}).substr(0, 63),
            "shadefit: --constants 'mine' is not a set of fresnel-fourth: it");
  EXPECT_EQ(
      refused({"--exhaustive", "schlick", "--exp2-degree", "3"}),
      "shadefit: --exp2-degree '3' is not compiled for schlick: it must be one of 0 (see 'shadefit help bench')\n");
  EXPECT_EQ(refused({"--exhaustive", "schlick", "--quick"}),
            "shadefit: --exhaustive excludes --quick (see 'shadefit help bench')\n");
  for (const char* range : {"1:1", "0:0x3f800002", "a:b", "5", "2:1"}) {
    EXPECT_EQ(
        refused({"--exhaustive", "schlick", "--range", range}),
        "shadefit: --range '" + std::string(range) +
            "' is not a range of bit patterns: it must be A:B with 0 <= A < B <= 0x3f800001 (see 'shadefit help bench')\n");
  }
  EXPECT_TRUE(snapshot(directory.path()).empty()) << "nothing was written";
}

TEST(ExhaustiveCommand, AllIsEachFormWithEachSet) {
  const TemporaryDirectory directory;
  ASSERT_EQ(bench({"--exhaustive", "all", "--range", few, "--out", directory / "all"}).exit_code, 0);
  const CsvTable rows = parse_csv(read_file(directory / "all/errors.csv"), "errors.csv");
  EXPECT_GT(rows.rows.size(), 60U);
  const std::vector<std::vector<std::string>> each{
      {"schlick"}, {"fresnel-quadratic", "--constants", "minimax-absolute"}, {"hg-pow"}};
  for (std::vector<std::string> form : each) {
    form.insert(form.begin(), {"--range", few, "--exhaustive"});
    const Outcome alone = bench(form);
    EXPECT_EQ(alone.exit_code, 0) << alone.err;
    const auto row = std::ranges::find_if(rows.rows, [&](const auto& of_all) {
      return of_all[0] == form[3] && (form.size() < 6 || of_all[1] == form[5]);
    });
    ASSERT_NE(row, rows.rows.end());
    EXPECT_NE(alone.out.find("max abs error  " + (*row)[3] + " at c = " + (*row)[4]), std::string::npos)
        << alone.out;
  }
  EXPECT_EQ(bench({"--exhaustive", "all", "--constants", "mine", "--out", directory / "all"}).err,
            "shadefit: --exhaustive 'all' does not apply with --constants: it takes every set of every form"
            " (see 'shadefit help bench')\n");
}

TEST(ExhaustiveCommand, ASignalEndsTheProcessAndNothingIsWritten) {
  const TemporaryDirectory directory;
  const std::vector<std::vector<std::string>> commands{
      {"bench", "--exhaustive", "all", "--out", directory / "out"},
      {"bench", "--quick", "--out", directory / "out"}};
  for (const auto& command : commands) {
    const auto finished = run_process(command, [] { testing::leave_pending(SIGINT, SIG_DFL); });
    EXPECT_EQ(finished.exit_code, 130);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, "shadefit: interrupted, nothing was written\n");
    EXPECT_FALSE(std::filesystem::exists(directory / "out"));
  }
}

TEST(Progress, ALineHasABarAPercentageAndWhatIsLeft) {
  EXPECT_EQ(progress_line("bench", 0, 0), "bench [..............................] 0 %");
  EXPECT_EQ(progress_line("bench", 0.5, 7), "bench [###############...............] 50 %, 7 s left");
  EXPECT_EQ(progress_line("bench", 1, 7), "bench [##############################] 100 %, 0 s left");
  EXPECT_EQ(progress_line("bench", 0.999, 1).substr(38), " 99 %, 1 s left") << "100 % is the whole";
}

TEST(Progress, IsSilentWhereThereIsNoTerminal) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const Progress progress = terminal_progress(pipe[1]);
  progress("something");
  progress("");
  ::close(pipe[1]);
  EXPECT_EQ(testing::read_all(pipe[0]), "");
}

}  // namespace
}  // namespace shadefit
