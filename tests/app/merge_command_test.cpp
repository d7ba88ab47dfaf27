#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/commands/command_line.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/files.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::run_process;
using testing::snapshot;
using testing::TemporaryDirectory;
using Json = nlohmann::ordered_json;

/// Work that can be divided: the words of a command, but --shard and --out.
struct DividedWork {
  const char* name;
  std::vector<std::string> command;
};

void PrintTo(const DividedWork& work, std::ostream* out) {
  *out << work.name;
}

class Merge : public ::testing::TestWithParam<DividedWork> {
 protected:
  Outcome work(const std::string& out, const std::string& shard = "") const {
    std::vector<std::string> words = GetParam().command;
    words.insert(words.end(), {"--out", directory_ / out});
    if (!shard.empty()) words.insert(words.end(), {"--shard", shard});
    return run_command_line(words);
  }

  /// All shards of three, in the directories 1, 2 and 3.
  void work_in_three() const {
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
      const Outcome outcome = work(std::string(1, *shard), shard);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
  }

  Outcome merge(const std::vector<std::string>& parts, const std::string& out = "merged") const {
    std::vector<std::string> words{"merge"};
    for (const std::string& part : parts) words.push_back(directory_ / part);
    words.insert(words.end(), {"--out", directory_ / out});
    return run_command_line(words);
  }

  /// What `merge` says of parts that it refuses. It writes nothing.
  std::string refusal(const std::vector<std::string>& parts) const {
    const auto before = snapshot(directory_.path());
    const Outcome outcome = merge(parts);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(snapshot(directory_.path()), before);
    std::string line = outcome.err;
    const std::string folder = directory_ / "";
    for (std::size_t at = 0; (at = line.find(folder, at)) != std::string::npos;)
      line.erase(at, folder.size());
    return line;
  }

  /// Changes a part and gives it the digest of its fields.
  void change(const std::string& part, const std::function<void(Json&)>& change) const {
    auto json = Json::parse(read_file(directory_.path() / part / "shard.json"));
    change(json);
    json[digest_field] = digest_of(json);
    directory_.file(part + "/shard.json", json.dump());
  }

  TemporaryDirectory directory_;
};

TEST_P(Merge, HasTheBytesOfOneGo) {
  ASSERT_EQ(work("whole").exit_code, 0);
  work_in_three();
  // In any order, and a file is as good as its directory.
  const Outcome outcome = merge({"3", "1/shard.json", "2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("Whole: " + (directory_ / "merged/"))) << outcome.out;
  EXPECT_EQ(snapshot(directory_ / "merged"), snapshot(directory_ / "whole"));
  EXPECT_EQ(merge({"1", "2", "3"}).exit_code, 0);
  ASSERT_EQ(work("one", "1/1").exit_code, 0);
  EXPECT_EQ(merge({"one"}, "merged-one").exit_code, 0);
  EXPECT_EQ(snapshot(directory_ / "merged-one"), snapshot(directory_ / "whole"));
}

TEST_P(Merge, MoreShardsThanWorkAreAllowed) {
  ASSERT_EQ(work("whole").exit_code, 0);
  std::vector<std::string> parts;
  for (int i = 1; i <= 7; ++i) {
    parts.push_back(std::to_string(i));
    ASSERT_EQ(work(parts.back(), parts.back() + "/7").exit_code, 0);
  }
  EXPECT_EQ(merge(parts).exit_code, 0);
  EXPECT_EQ(snapshot(directory_ / "merged"), snapshot(directory_ / "whole"));
}

TEST_P(Merge, RefusesWhatIsMissingOrDoubled) {
  work_in_three();
  EXPECT_EQ(refusal({"1", "3"}), "shadefit: shard 2/3 is missing\n");
  EXPECT_EQ(refusal({"2", "1"}), "shadefit: shard 3/3 is missing\n");
  EXPECT_EQ(refusal({"1", "2", "3", "2"}),
            "shadefit: shard file '2/shard.json' is shard 2/3, which shard file '2/shard.json' is already\n");
  ASSERT_EQ(work("half", "2/2").exit_code, 0);
  EXPECT_EQ(
      refusal({"1", "half"}),
      "shadefit: shard file 'half/shard.json' is shard 2/2, shard file '1/shard.json' one of 3: all parts "
      "must come from the same command\n");
  EXPECT_EQ(refusal({"1", "2", "4"}), "shadefit: cannot read '4': there is no such file\n");
  std::filesystem::create_directory(directory_ / "4");
  EXPECT_EQ(refusal({"1", "2", "4"}), "shadefit: cannot read '4/shard.json': there is no such file\n");
}

TEST_P(Merge, RefusesAnotherVersion) {
  work_in_three();
  const std::string ours = Json::parse(read_file(directory_ / "1/shard.json"))["version"];
  change("2", [](Json& json) { json["version"] = "9.9"; });
  EXPECT_EQ(refusal({"1", "2", "3"}),
            "shadefit: shard file '2/shard.json' is of another version: 9.9, not " + ours + "\n");
  for (const char* part : {"1", "3"}) change(part, [](Json& json) { json["version"] = "9.9"; });
  EXPECT_EQ(refusal({"1", "2", "3"}),
            "shadefit: shard file '1/shard.json' is of another version: 9.9, not " + ours + "\n");
}

TEST_P(Merge, RefusesADamagedPart) {
  work_in_three();
  const std::string text = read_file(directory_ / "2/shard.json");
  for (const std::string& damaged : {std::string(), text.substr(0, text.size() / 2), std::string("{}"),
                                     std::string("[1]"), "x" + text, text + "x"}) {
    directory_.file("2/shard.json", damaged);
    EXPECT_TRUE(refusal({"1", "2", "3"}).starts_with("shadefit: shard file '2/shard.json'")) << damaged;
    EXPECT_TRUE(refusal({"2", "1", "3"}).starts_with("shadefit: shard file '2/shard.json'")) << damaged;
  }
  std::string digit = text;
  const std::size_t at = digit.find_first_of("0123456789", digit.size() * 2 / 3);
  digit[at] = digit[at] == '1' ? '2' : '1';
  directory_.file("2/shard.json", digit);
  EXPECT_NE(refusal({"1", "2", "3"}).find("the field 'digest' is "), std::string::npos);
  directory_.file("2/shard.json", text);
  change("2", [](Json& json) { json["schema"] = 99; });
  EXPECT_NE(refusal({"1", "2", "3"}).find("is of version 99: this shadefit reads version "),
            std::string::npos);
  directory_.file("2/shard.json", text);
  change("2", [](Json& json) { json["more"] = 1; });
  EXPECT_EQ(
      refusal({"1", "2", "3"}),
      "shadefit: shard file '2/shard.json': the field 'more' is unknown, or not as shadefit writes it\n");
  directory_.file("2/shard.json", text);
  change("2", [](Json& json) { json["file"] = "shadefit other"; });
  EXPECT_EQ(refusal({"2"}),
            "shadefit: shard file '2/shard.json' is not a part of divided work: it says 'shadefit other'\n");
}

TEST_P(Merge, LeavesTheFilesOfOthersAlone) {
  work_in_three();
  ASSERT_EQ(work("whole").exit_code, 0);
  const std::string file = snapshot(directory_ / "whole").begin()->first;
  directory_.file("merged/" + file, "mine");
  EXPECT_NE(refusal({"1", "2", "3"}).find("merged/" + file), std::string::npos);
}

/// A task that is killed leaves no whole part. The same command makes it.
TEST_P(Merge, AKilledTaskCanBeRunAgain) {
  ASSERT_EQ(work("whole").exit_code, 0);
  work_in_three();
  std::filesystem::remove_all(directory_ / "2");
  std::vector<std::string> words = GetParam().command;
  words.insert(words.end(), {"--out", directory_ / "2", "--shard", "2/3"});
  const auto killed = run_process(words, [] { testing::leave_pending(SIGTERM, SIG_DFL); });
  EXPECT_EQ(killed.exit_code, 128 + SIGTERM) << killed.err;
  EXPECT_EQ(merge({"1", "2", "3"}).exit_code, 2);
  EXPECT_EQ(run_process(words, [] {}).exit_code, 0);
  EXPECT_EQ(merge({"1", "2", "3"}).exit_code, 0);
  EXPECT_EQ(snapshot(directory_ / "merged"), snapshot(directory_ / "whole"));
}

INSTANTIATE_TEST_SUITE_P(Of, Merge,
                         ::testing::Values(DividedWork{"Sweep",
                                                       {"bench", "--exhaustive", "sg", "--exp2-degree", "3",
                                                        "--range", "0x3efff000:0x3f000000"}},
                                           DividedWork{"Gallery",
                                                       {"run", "--html", "--only", "acos-linear", "cie-y",
                                                        "exp2-quintic", "planck-x", "sqrt-rational"}}),
                         ::testing::PrintToStringParamName());

/// Every form is a list of sweeps; a part of it has a part of each.
TEST(MergeEveryForm, HasTheBytesOfOneGo) {
  const TemporaryDirectory directory;
  const auto work = [&](const char* out, std::vector<std::string> shard = {}) {
    std::vector<std::string> words{"bench", "--exhaustive", "all", "--range", "0x3efff000:0x3f000000",
                                   "--out", directory / out};
    words.insert(words.end(), shard.begin(), shard.end());
    return run_command_line(words);
  };
  const auto merge = [&](const char* second) {
    return run_command_line({"merge", directory / "1", directory / second, "--out", directory / "merged"});
  };
  ASSERT_EQ(work("whole").exit_code, 0);
  EXPECT_NE(work("1", {"--shard", "1/2"}).out.find("Part 1/2 of "), std::string::npos);
  ASSERT_EQ(work("2", {"--shard", "2/2"}).exit_code, 0);
  const Outcome outcome = merge("2");
  EXPECT_EQ(outcome.out, "Whole: " + (directory / "merged/errors.csv") + "\n") << outcome.err;
  EXPECT_EQ(snapshot(directory / "merged"), snapshot(directory / "whole"));
  EXPECT_TRUE(merge("1").err.find("is shard 1/2, which") != std::string::npos) << merge("1").err;
  std::filesystem::remove(directory / "2/exhaustive-schlick.json");
  EXPECT_EQ(merge("2").err, "shadefit: '" + (directory / "2") + "' has other sweeps than '" +
                                (directory / "1") + "': all parts must come from the same command\n");
}

/// A gallery with a study whose file can change.
class MergeStudies : public ::testing::Test {
 protected:
  Outcome run(const std::string& out, const std::string& shard) const {
    return run_command_line({"run", "--html", "--studies", directory_ / "studies", "--only", "line", "sin-pi",
                             "--shard", shard, "--out", directory_ / out});
  }
  void put_study(const std::string& best, const std::string& row = "1,2") const {
    directory_.file(
        "studies/line.toml",
        "schema = 1\nid = \"line\"\n[over]\nx = \"\"\n[target]\ntable = \"rows.csv\"\n[[form]]\nid = \"" +
            best + "\"\nformula = \"a x + b\"\n");
    directory_.file("studies/rows.csv", "x,value\n0,1\n" + row + "\n2,2.5\n");
  }
  std::string refusal() const {
    return run_command_line({"merge", directory_ / "1", directory_ / "2", "--out", directory_ / "merged"})
        .err;
  }
  TemporaryDirectory directory_;
};

TEST_F(MergeStudies, OfOtherFilesOrTablesAreRefused) {
  put_study("line");
  const Outcome first = run("1", "1/2");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(run("2", "2/2").exit_code, 0);
  EXPECT_EQ(refusal(), "");
  put_study("other");
  ASSERT_EQ(run("2", "2/2").exit_code, 0);
  EXPECT_NE(refusal().find("/2/shard.json' is of another study: line "), std::string::npos) << refusal();
  put_study("line", "1,2.125");
  ASSERT_EQ(run("2", "2/2").exit_code, 0);
  EXPECT_NE(refusal().find("/2/shard.json' is of another study: line "), std::string::npos) << refusal();
  // Another list of studies.
  ASSERT_EQ(
      run_command_line({"run", "--html", "--only", "sin-pi", "--shard", "2/2", "--out", directory_ / "2"})
          .exit_code,
      0);
  EXPECT_NE(refusal().find("/2/shard.json' is of another study: sin-pi "), std::string::npos) << refusal();
}

/// Whoever makes a part on purpose cannot write outside --out with it.
TEST_F(MergeStudies, APartThatWasMadeUpIsRefused) {
  put_study("line");
  ASSERT_EQ(run("1", "1/1").exit_code, 0);
  const auto part = Json::parse(read_file(directory_ / "1/shard.json"));
  const auto said = [&](const std::function<void(Json&)>& change) {
    auto json = part;
    change(json);
    json[digest_field] = digest_of(json);
    directory_.file("1/shard.json", json.dump());
    const Outcome outcome = run_command_line({"merge", directory_ / "1", "--out", directory_ / "merged"});
    EXPECT_EQ(outcome.exit_code, 2);
    const std::size_t rule = outcome.err.find("the field");
    return rule == std::string::npos ? outcome.err : outcome.err.substr(rule);
  };
  EXPECT_EQ(said([](Json& json) { json["studies"][0]["id"] = json["judged"][0]["id"] = "../line"; }),
            "the field 'id' has a '/'\n");
  EXPECT_EQ(said([](Json& json) { json["judged"][0]["id"] = "other"; }),
            "the field 'judged' has other studies than its shard\n");
  EXPECT_EQ(said([](Json& json) { json["judged"].erase(1); }),
            "the field 'judged' has other studies than its shard\n");
  EXPECT_EQ(said([](Json& json) {
              json["shard"] = {3, 2};
            }),
            "the field 'shard' is not i, n with 1 <= i <= n\n");
  EXPECT_EQ(said([](Json& json) { json["judged"][0]["is_published"] = 1; }),
            "the field 'is_published' is not true or false\n");
  EXPECT_EQ(said([](Json& json) { json["judged"][1]["rows"] = {1}; }),
            "the field 'rows' has a row that is not a list of 14 cells\n");
  const auto cell = [&](const Json& value) {
    return said([&](Json& json) {
      Json row = Json::array();
      for (int i = 0; i < 14; ++i) row.push_back(value);
      json["judged"][1]["rows"] = Json::array({row});
    });
  };
  EXPECT_EQ(cell(true), "the field 'rows' has a cell that shadefit does not write\n");
  EXPECT_EQ(cell(0.5), "the field 'rows' has a cell that shadefit does not write\n");
  EXPECT_EQ(cell(Json::array({"x", 4})), "the field 'rows' holds 'x', which is not a number\n");
  EXPECT_EQ(cell(Json::array({0.5, 4})), "the field 'rows' is not a text\n");
  EXPECT_EQ(cell(Json::array({"0.5", -1})), "the field 'rows' is not a whole number from 0 to 2147483647\n");
  for (const char* other : {"0.50", "0.5x", "0.123456"})
    EXPECT_EQ(cell(Json::array({other, 4})), "the field 'judged' is unknown, or not as shadefit writes it\n");
  EXPECT_FALSE(std::filesystem::exists(directory_ / "merged"));
}

TEST(RunHtml, TakesSomeStudies) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  ASSERT_EQ(
      run_command_line({"run", "cie-y", "--html", "--only", "planck-x", "cie-y", "--out", out}).exit_code, 0);
  const auto files = snapshot(out);
  EXPECT_EQ(files.size(), 4U) << "index.html, gallery.csv and two pages";
  EXPECT_TRUE(files.contains("cie-y.html") && files.contains("planck-x.html"));
  EXPECT_EQ(run_command_line({"run", "--html", "--only", "planck-xx", "--out", out}).err,
            "shadefit: unknown study 'planck-xx': did you mean 'planck-x'?\n");
  EXPECT_EQ(run_command_line({"run", "--shard", "1/2", "--out", out}).err,
            "shadefit: --shard requires --html (see 'shadefit help run')\n");
  EXPECT_EQ(
      run_command_line({"run", "--html", "--shard", "2/1", "--out", out}).err,
      "shadefit: --shard '2/1' is not a part of a whole: it must be i/n with 1 <= i <= n (see 'shadefit help run')\n");
  EXPECT_EQ(snapshot(out), files);
}

}  // namespace
}  // namespace shadefit
