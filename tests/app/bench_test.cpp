#include <gtest/gtest.h>

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
  for (const char* format : {"text", "json", "junit", "github", "markdown"}) {
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
      refusal({"--format", "junit"}),
      "shadefit: --format 'junit' needs --compare: without it bench checks nothing (see 'shadefit help bench')\n");
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
  EXPECT_EQ(refusal({"--shard", "1/2"}),
            "shadefit: --shard requires --exhaustive (see 'shadefit help bench')\n");
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
  for (const char* shard : {"3/2", "0/4", "a/b"}) {
    EXPECT_EQ(
        refused({"--exhaustive", "schlick", "--shard", shard}),
        "shadefit: --shard '" + std::string(shard) +
            "' is not a part of a whole: it must be i/n with 1 <= i <= n (see 'shadefit help bench')\n");
  }
  for (const char* range : {"1:1", "0:0x3f800002", "a:b", "5", "2:1"}) {
    EXPECT_EQ(
        refused({"--exhaustive", "schlick", "--range", range}),
        "shadefit: --range '" + std::string(range) +
            "' is not a range of bit patterns: it must be A:B with 0 <= A < B <= 0x3f800001 (see 'shadefit help bench')\n");
  }
  EXPECT_TRUE(snapshot(directory.path()).empty()) << "nothing was written";
}

TEST(ExhaustiveCommand, AFileOfAnotherSweepIsRefusedAndLeftAlone) {
  const TemporaryDirectory directory;
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--exhaustive", "sg", "--out", directory / "out"});
    return bench(more);
  };
  ASSERT_EQ(run({"--range", few}).exit_code, 0);
  ASSERT_EQ(run({"--range", few, "--shard", "1/2"}).exit_code, 0);
  const auto before = snapshot(directory.path());
  const std::string out = directory / "out/", end = "; name another directory by --out\n";
  EXPECT_EQ(run({"--range", "0x3effff00:0x3f000000"}).err,
            "shadefit: state file '" + out +
                "exhaustive-sg-published-sg-offset-mean.json' is of another range: " +
                "0x3efff000:0x3f000000, not 0x3effff00:0x3f000000" + end);
  EXPECT_EQ(run({"--range", few, "--shard", "2/2"}).err,
            "shadefit: state file '" + out + "shard.json' is of another shard: 1/2, not 2/2" + end);
  EXPECT_EQ(snapshot(directory.path()), before);
}

// The forms of a target share their truth there; the results are those of each alone.
TEST(ExhaustiveCommand, AllIsEachFormWithEachSet) {
  const TemporaryDirectory directory;
  const auto state_in = [&](const char* folder, std::vector<std::string> form) {
    form.insert(form.begin(), {"--range", few, "--out", directory / folder, "--exhaustive"});
    EXPECT_EQ(bench(form).exit_code, 0);
    return snapshot(directory / folder);
  };
  const auto all = state_in("all", {"all"});
  state_in("each", {"schlick"});
  state_in("each", {"fresnel-quadratic", "--constants", "minimax-absolute"});
  for (const auto& [name, bytes] : state_in("each", {"hg-pow"})) EXPECT_EQ(all.at(name), bytes) << name;
  EXPECT_GT(all.size(), 60U);
  const std::string errors = all.at("errors.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(errors.begin(), errors.end(), '\n')), all.size());
  EXPECT_EQ(bench({"--exhaustive", "all", "--constants", "mine", "--out", directory / "all"}).err,
            "shadefit: --exhaustive 'all' does not apply with --constants: it takes every set of every form"
            " (see 'shadefit help bench')\n");
}

TEST(ExhaustiveCommand, AStateThatWasChangedOrCutOffIsRefusedAndLeftAlone) {
  const TemporaryDirectory directory;
  const std::vector<std::string> command{"--exhaustive",           "schlick", "--range", few, "--out",
                                         directory.path().string()};
  ASSERT_EQ(bench(command).exit_code, 0);
  const std::string whole = read_file(directory / "exhaustive-schlick.json");
  std::string changed = whole;
  changed.replace(changed.find("\"nans\": 0"), 9, "\"nans\": 1");
  for (const std::string& bad :
       {whole.substr(0, whole.size() / 2), changed, std::string(), std::string("{}")}) {
    directory.file("exhaustive-schlick.json", bad);
    const Outcome outcome = bench(command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(
        outcome.err.starts_with("shadefit: state file '" + (directory / "exhaustive-schlick.json") + "'"))
        << outcome.err;
    EXPECT_EQ(read_file(directory / "exhaustive-schlick.json"), bad);
  }
}

TEST(ExhaustiveCommand, InterruptedItLeavesAStateThatTheSameCommandGoesOnFrom) {
  const TemporaryDirectory directory;
  // Several batches of floats; a form of multiplications takes a moment for them.
  const std::vector<std::string> command{"--exhaustive", "schlick", "--range", "0x3c000000:0x3e000000",
                                         "--out"};
  const auto with_out = [&](const std::string& out) {
    auto arguments = command;
    arguments.push_back(directory / out);
    return arguments;
  };
  ASSERT_EQ(bench(with_out("whole")).exit_code, 0);
  int calls = 0;
  const Outcome stopped = bench(with_out("resumed"), [&] {
    if (++calls == 4) throw Interrupted{SIGINT};
  });
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_TRUE(stopped.err.starts_with("shadefit: interrupted at ")) << stopped.err;
  EXPECT_TRUE(stopped.err.ends_with(" %: the same command goes on from '" +
                                    (directory / "resumed/exhaustive-schlick.json") + "'\n"))
      << stopped.err;
  EXPECT_NE(snapshot(directory / "resumed"), snapshot(directory / "whole"));
  EXPECT_EQ(bench(with_out("resumed")).exit_code, 0);
  EXPECT_EQ(snapshot(directory / "resumed"), snapshot(directory / "whole"));
}

TEST(ExhaustiveCommand, ASignalEndsTheProcessWithAState) {
  const TemporaryDirectory directory;
  auto finished = run_process({"bench", "--exhaustive", "schlick", "--out", directory.path().string()},
                              [] { testing::leave_pending(SIGTERM, SIG_DFL); });
  EXPECT_EQ(finished.exit_code, 143);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err, "shadefit: interrupted at 0.0 %: the same command goes on from '" +
                              (directory / "exhaustive-schlick.json") + "'\n");
  EXPECT_TRUE(std::filesystem::exists(directory / "exhaustive-schlick.json"));
  finished = run_process({"bench", "--quick", "--out", directory / "out"},
                         [] { testing::leave_pending(SIGINT, SIG_DFL); });
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err, "shadefit: interrupted, nothing was written\n");
  EXPECT_FALSE(std::filesystem::exists(directory / "out"));
}

TEST(ExhaustiveCommand, AFullDiskLeavesTheOldState) {
  const TemporaryDirectory directory;
  const std::vector<std::string> whole{
      "bench", "--exhaustive",           "schlick", "--range", few, "--shard", "1/2",
      "--out", directory.path().string()};
  const auto refused = run_process(whole, [] { testing::limit_file_size(100); });
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err, "shadefit: cannot write '" + (directory / "shard.json") + "': File too large\n");
  EXPECT_TRUE(snapshot(directory.path()).empty());
  // A file with a started sweep is unchanged.
  run_process(whole, [] { testing::leave_pending(SIGINT, SIG_DFL); });
  const auto before = snapshot(directory.path());
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(run_process(whole, [] { testing::limit_file_size(100); }).exit_code, 2);
  EXPECT_EQ(snapshot(directory.path()), before);
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
