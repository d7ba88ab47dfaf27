#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::snapshot;
using testing::TemporaryDirectory;

constexpr const char* two_materials =
    "newmtl wall\nNs 50\nKs 0 0 0\nillum 2\n"
    "newmtl floor\nNs 1\nKs 0.5 0.5 0.5\nillum 2\n";

TEST(SceneCommand, SaysWhatIsNeeded) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  const Outcome outcome = run_command_line({"scene", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("2 materials, 1 light, tolerance 0.003922 in linear values\n\nterm "))
      << outcome.out;
  expect_has(outcome.out, "skipped for 1 of 2 materials");
  EXPECT_EQ(snapshot(directory.path()).size(), 1U) << "nothing is written unless it is asked for";
}

TEST(SceneCommand, WritesThePlan) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  const Outcome outcome = run_command_line({"scene", file, "--out", directory / "plan", "--lights", "4"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(
      outcome.out.ends_with("\nPlan: " + (directory / "plan") + ": scene.md, scene.csv, scene.json\n"))
      << outcome.out;
  const auto written = nlohmann::json::parse(read_file(directory / "plan/scene.json"));
  EXPECT_EQ(written.at("lights"), 4);
  EXPECT_EQ(written.at("materials").size(), 2U);
  EXPECT_EQ(written.at("materials").at(0).at("lobe"), false);
  EXPECT_LE(written.at("error").get<double>(), written.at("tolerance").get<double>());
  EXPECT_TRUE(read_file(directory / "plan/scene.csv")
                  .starts_with("term,verdict,form,error,reason\nspecular lobe,replace,"));
  EXPECT_TRUE(read_file(directory / "plan/scene.md").starts_with("# What this scene needs\n"));
  const Outcome printed = run_command_line({"scene", file, "--json", "--lights", "4"});
  EXPECT_EQ(printed.out, read_file(directory / "plan/scene.json"));
}

TEST(SceneCommand, CodeIsHeldAgainstItsScene) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a scene.mtl", two_materials);
  const Outcome printed = run_command_line({"scene", file, "--codes", "0.5", "--lang", "glsl"});
  expect_has(printed.out, "\n// shadefit scene '" + file + "' --codes 0.5 --lang glsl\n");
  const std::string code = directory.file("scene.glsl", printed.out);
  const Outcome same = run_command_line({"emit", "--check", code});
  EXPECT_EQ(same.out, code + " is what would be generated now\n") << same.err;
  EXPECT_EQ(same.exit_code, 0);
  directory.file("a scene.mtl", "newmtl floor\nNs 2\nKs 0.5 0.5 0.5\nillum 2\n");
  const Outcome other = run_command_line({"emit", "--check", code});
  EXPECT_EQ(other.exit_code, 1);
  expect_has(other.err, " is out of date: line ");
}

// Names that could leave the comment, or the command that is read from it.
TEST(SceneCommand, NamesStayInTheirComment) {
  const TemporaryDirectory directory;
  for (const std::string name : {"q'uote.mtl", "a' --out 'b.mtl", "back\\slash.mtl"}) {
    const std::string file = directory.file(name, two_materials);
    const Outcome code = run_command_line({"scene", file, "--lang", "glsl"});
    EXPECT_EQ(code.exit_code, 0) << code.err;
    const std::string written = directory.file("out.glsl", code.out);
    const Outcome same = run_command_line({"emit", "--check", written});
    EXPECT_EQ(same.exit_code, 0) << name << same.err;
    std::string windows;
    for (const char c : code.out) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    directory.file("out.glsl", windows);
    EXPECT_EQ(run_command_line({"emit", "--check", written}).exit_code, 0) << name;
  }
  for (const std::string name :
       {"a\nint evil;\n.mtl", "cr\rx.mtl", "bidi\xE2\x80\xAE.mtl", "ls\xE2\x80\xA8.mtl"}) {
    const Outcome outcome = run_command_line({"scene", directory.file(name, two_materials), "--lang", "c"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    expect_has(outcome.err, "cannot stand in a comment of code");
  }
}

// A shell runs the recorded line as that call, for every name of the file, and starts nothing else.
TEST(SceneCommand, TheRecordedCommandIsAShells) {
  const TemporaryDirectory directory;
  const std::string shadefit = directory.file("bin/shadefit", "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
  std::filesystem::permissions(shadefit, std::filesystem::perms::owner_all);
  for (const std::string name :
       {"$(touch${IFS}x).mtl", "`touch x`.mtl", "a;touch x.mtl", "a&b|c>d<e.mtl", "*?[a].mtl", "{a,b}.mtl",
        "~x.mtl", "#a.mtl", "!a.mtl", "a\"b.mtl", "a\\.mtl", "a=b.mtl", "\xC3\xA9.mtl"}) {
    const std::string file = directory.file("scene/" + name, two_materials);
    const Outcome code = run_command_line({"scene", file, "--lang", "glsl"});
    ASSERT_EQ(code.exit_code, 0) << code.err;
    const std::size_t begin = code.out.find("// shadefit ") + 3;
    const std::string line = code.out.substr(begin, code.out.find('\n', begin) - begin);
    const std::string script = directory.file(
        "call.sh", "cd '" + (directory / "scene") + "'\nPATH='" + (directory / "bin") + "' \n" + line + "\n");
    const auto before = snapshot(directory / "scene");
    ASSERT_EQ(std::system(("sh '" + script + "' > '" + (directory / "said") + "'").c_str()), 0) << line;
    EXPECT_EQ(read_file(directory / "said"), "scene\n" + file + "\n--lang\nglsl\n") << line;
    EXPECT_EQ(snapshot(directory / "scene"), before) << line;
  }
}

TEST(SceneCommand, NamesAreTextInThePlan) {
  const TemporaryDirectory directory;
  const std::string file = directory.file(
      "a.mtl",
      "newmtl <img/src=x/onerror=y>[a](http://b.c)![d](e)|*f*_g_`h`<!--www.i.j\nNs 20\nKs 1 1 1\nillum 2\n"
      "map_Ks <b>[k](https://l.m).png\n");
  EXPECT_EQ(run_command_line({"scene", file, "--out", directory / "plan"}).exit_code, 0);
  const std::string plan = read_file(directory / "plan/scene.md");
  for (const char* part :
       {"<img", "<b>", "<!--", "a](", "d](", "k](", "://b", "://l", "www.", "*f*", "_g_", "`h`"})
    expect_lacks(plan, part);
  expect_has(plan, "&lt;img/src=x/onerror=y&gt;\\[a\\]");
}

TEST(SceneCommand, ListsTheFeatures) {
  const TemporaryDirectory directory;
  const std::string a = directory.file("scenes/a.mtl", two_materials);
  const std::string b = directory.file(
      "scenes/b.gltf", R"({"asset":{"version":"2.0"},"materials":[{"name":"mirror","doubleSided":true}]})");
  const Outcome text = run_command_line({"scene", directory / "scenes", "--features"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out,
            "3 materials, 3 sets of 2 features: double sided, specular\n\n1 material: no feature\n  wall (" +
                a + ")\n\n1 material: double sided\n  mirror (" + b + ")\n\n1 material: specular\n  floor (" +
                a + ")\n");
  const auto json = nlohmann::json::parse(run_command_line({"scene", a, b, "--features", "--json"}).out);
  EXPECT_EQ(json.at("features"), nlohmann::json::array({"double sided", "specular"}));
  EXPECT_EQ(json.at("sets").size(), 3U);
  EXPECT_EQ(json.at("sets").at(0).at("materials"), 1);
  EXPECT_EQ(json.at("materials").at(2).at("name"), "mirror");
  EXPECT_EQ(json.at("materials").at(2).at("features"), nlohmann::json::array({"double sided"}));
  for (const char* option : {"--lang", "--out"}) {
    const Outcome refused = run_command_line({"scene", a, "--features", option, "glsl"});
    EXPECT_EQ(refused.exit_code, 2);
    expect_has(refused.err, " excludes ");
  }
}

TEST(SceneCommand, ExitsOneBeyondTheTolerance) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", "newmtl mirror\nNs 1000000\nKs 1 1 1\nillum 2\n");
  const Outcome outcome = run_command_line({"scene", file, "--precision", "half"});
  EXPECT_EQ(outcome.exit_code, 1);
  expect_has(outcome.out, " of 0.003922: NOT within the tolerance.\n");
}

TEST(SceneCommand, BadInput) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  const std::string of_languages =
      "is unknown: it must be one of glsl, hlsl, c, cpp, wgsl, msl, cuda, opencl";
  for (const auto& [option, value, rule] : std::vector<std::tuple<std::string, std::string, std::string>>{
           {"--tolerance", "0", "must be greater than 0 and at most 1"},
           {"--tolerance", "1/0", "must be greater than 0 and at most 1"},
           {"--tolerance", "2", "must be greater than 0 and at most 1"},
           {"--min-roughness", "0", "must be greater than 0 and at most 1"},
           {"--min-roughness", "1.5", "must be greater than 0 and at most 1"},
           {"--lights", "0", "must be a whole number from 1 to 1000000"},
           {"--lights", "1.5", "must be a whole number from 1 to 1000000"},
           {"--codes", "256", "must be greater than 0 and at most 255"},
           {"--precision", "double", "is unknown: it must be one of float, half"},
           {"--alpha", "cubed", "is unknown: it must be one of roughness, roughness-squared"},
           {"--lang", "cg", of_languages}})
    expect_refusal({"scene", file, option, value}, option + " '" + value + "' " + rule);
  expect_refusal({"scene", file, "--precision", "half", "--lang", "c"},
                 "--precision 'half' does not apply to --lang 'c': it has no half");
  const std::string empty = directory.file("empty.mtl", "");
  expect_refusal({"scene", empty}, "'" + empty + "' holds no material");
}

TEST(SceneCommand, TheLeastRoughnessIsRecorded) {
  const TemporaryDirectory directory;
  const std::string file = directory.file(
      "a.gltf", R"({"asset":{"version":"2.0"},"materials":[{"name":"a","pbrMetallicRoughness":)"
                R"({"roughnessFactor":0.01}},{"name":"b"}],"meshes":[{"primitives":[{"material":0}]}]})");
  const Outcome plain = run_command_line({"scene", file});
  expect_has(plain.out, ": --min-roughness takes it for more\n");
  expect_has(plain.out, "\nNote: 'b': nothing is drawn with it, and it is not counted\n");
  const Outcome floored = run_command_line({"scene", file, "--min-roughness", "0.045"});
  expect_has(floored.out, "\nNote: a roughness below 0.045 is taken for it\n");
  const Outcome code = run_command_line({"scene", file, "--min-roughness", "0.045", "--lang", "glsl"});
  expect_has(code.out, " --min-roughness 0.045 --lang glsl\n");
  EXPECT_NE(code.out, run_command_line({"scene", file, "--lang", "glsl"}).out);
  EXPECT_EQ(run_command_line({"emit", "--check", directory.file("a.glsl", code.out)}).exit_code, 0);
  const auto printed = nlohmann::json::parse(run_command_line({"scene", file, "--json"}).out);
  EXPECT_EQ(printed.at("unused"), nlohmann::json::array({"b"}));
  EXPECT_EQ(printed.at("materials").size(), 1U);
}

}  // namespace
}  // namespace shadefit
