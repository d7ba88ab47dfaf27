#include "reports/code/scene_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "approx/gloss.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "scene/materials/conversions.hpp"
#include "scene/plan/lobes.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/compilers.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using scene::FresnelTerm;
using scene::LobeKind;
using scene::Material;
using scene::Plan;
using scene::PowerTexture;
using scene::Scene;
using scene::Wanted;
using testing::expect_has;
using testing::expect_lacks;
using testing::TemporaryDirectory;

Material shiny(const std::string& name, double reflectance, const scene::Range& power,
               FresnelTerm fresnel = FresnelTerm::schlick, PowerTexture texture = PowerTexture::none) {
  Material made;
  made.name = name;
  made.fresnel = fresnel;
  made.f0.fill({reflectance, reflectance});
  made.power = power;
  made.power_texture = texture;
  return made;
}

struct Case {
  std::string name;
  Scene scene;
  Wanted wanted;
  LobeKind kind;
  std::vector<std::string> functions;  ///< and their arguments
};

/// One of each kind of plan.
std::vector<Case> cases() {
  const auto of = [](std::vector<Material> materials) {
    Scene made;
    made.materials = std::move(materials);
    return made;
  };
  const auto none = FresnelTerm::none;
  const Scene dull = of({shiny("dull", 0.04, {10.5, 10.5}, none), shiny("duller", 0.03, {7, 7}, none)});
  const Scene textured = of({shiny("rough", 0.04, {10.5, 30.5}, none, PowerTexture::roughness)});
  Scene gloss = of({shiny("glossy", 0.5, {2, 2048}, FresnelTerm::schlick, PowerTexture::gloss)});
  gloss.conventions.is_gloss_exponential = true;
  const std::string light = "scene_light n_dot_h n_dot_l", reflectance = "scene_reflectance f0 f90 l_dot_h";
  const std::string of_roughness = "scene_exponent_of_roughness roughness";
  return {
      {"whole", of({shiny("floor", 0.5, {5, 5})}), {}, LobeKind::multiplied, {light, reflectance}},
      {"constant", of({shiny("chalk", 1, {0, 0}, none)}), {}, LobeKind::constant, {"scene_light n_dot_l"}},
      {"one", of({shiny("one", 0.04, {10.5, 10.5}, none)}), {}, LobeKind::exponential, {light}},
      {"several",
       dull,
       {.tolerance = 1.0 / 128},
       LobeKind::exponential,
       {light + " sharpness normalisation"}},
      {"slopes", dull, {.tolerance = 1.0 / 4096}, LobeKind::exponential, {light + " exponent"}},
      {"textured",
       textured,
       {.tolerance = 1.0 / 128},
       LobeKind::exponential,
       {of_roughness, light + " exponent"}},
      {"power", textured, {.tolerance = 1e-6}, LobeKind::power, {of_roughness, light + " exponent"}},
      {"gloss",
       gloss,
       {},
       LobeKind::exponential,
       {"scene_exponent_of_gloss gloss", light + " exponent", reflectance}},
  };
}

std::vector<std::string> heads_of(const std::vector<ShaderFunction>& functions) {
  std::vector<std::string> heads;
  for (const ShaderFunction& function : functions) {
    heads.push_back(function.name);
    for (const std::string& argument : function.arguments) heads.back() += " " + argument;
  }
  return heads;
}

TEST(SceneCode, HasTheFunctionsInUse) {
  for (const Case& c : cases()) {
    const Plan plan = make_plan(c.scene, c.wanted);
    EXPECT_EQ(plan.shading.lobe.kind, c.kind) << c.name << " " << to_text(plan.shading.lobe);
    EXPECT_EQ(heads_of(scene_functions(c.scene, plan)), c.functions) << c.name;
  }
}

TEST(SceneCode, OfASceneWithoutLobesIsAComment) {
  Scene black;
  black.materials = {shiny("black", 0, {50, 50}, FresnelTerm::none)};
  const Plan plan = make_plan(black, {});
  EXPECT_TRUE(scene_functions(black, plan).empty());
  const std::string code = scene_code(black, plan, Language::glsl, "shadefit scene a.mtl --lang glsl");
  EXPECT_TRUE(code.ends_with("\n// No material of this scene needs a specular term.\n")) << code;
  expect_has(code, "\n// shadefit scene a.mtl --lang glsl\n");
}

/// A call of each function, with numbers that are not constants.
std::string calls(const std::vector<ShaderFunction>& functions, const std::string& type) {
  std::string sum = type + "(0)";
  for (const ShaderFunction& function : functions) {
    sum += " + " + function.name + "(";
    for (std::size_t i = 0; i < function.arguments.size(); ++i)
      sum += (i == 0 ? "" : ", ") + type + (i % 2 == 0 ? "(at.x)" : "(at.y)");
    sum += ")";
  }
  return sum;
}

TEST(SceneCode, CompilesAsGlslAndHlsl) {
  const std::string reason = testing::reason_without_shaders();
  if (!reason.empty()) GTEST_SKIP() << reason;
  const TemporaryDirectory directory;
  for (Case c : cases()) {
    for (const auto precision : {scene::PixelPrecision::float32, scene::PixelPrecision::float16}) {
      c.wanted.precision = precision;
      const Plan plan = make_plan(c.scene, c.wanted);
      const auto functions = scene_functions(c.scene, plan);
      const std::string glsl =
          directory.file("a.frag",
                         "#version 450\nprecision highp float;\nlayout(location = 0) in vec2 at;\n"
                         "layout(location = 0) out vec4 colour;\n" +
                             scene_code(c.scene, plan, Language::glsl, "") + "void main() { colour = vec4(" +
                             calls(functions, "float") + "); }\n");
      EXPECT_TRUE(testing::is_shader(glsl, false, directory)) << c.name << read_file(directory / "said");
      const std::string type = precision == scene::PixelPrecision::float32 ? "float" : "min16float";
      const std::string hlsl =
          directory.file("b.frag", scene_code(c.scene, plan, Language::hlsl, "") +
                                       "float4 main(float2 at : TEXCOORD0) : SV_Target {\n  float v = " +
                                       calls(functions, type) + ";\n  return float4(v, v, v, v);\n}\n");
      EXPECT_TRUE(testing::is_shader(hlsl, true, directory)) << c.name << read_file(directory / "said");
    }
  }
}

/// What a program tries: cosines of every size.
constexpr int steps = 96;
float cosine_of_step(int i) {
  return static_cast<float>(i) / steps;
}

/// Values of a function's arguments at a step: powers of its own material.
std::map<std::string, float> arguments_at(const Case& c, const Plan& plan, int i, std::size_t material) {
  const auto power = static_cast<float>(c.scene.materials[material].power.most);
  const double offset = plan.shading.lobe.offset;
  return {{"n_dot_h", cosine_of_step(i)},
          {"n_dot_l", std::min(1.0F, 2 * cosine_of_step(i))},
          {"l_dot_h", cosine_of_step(steps - i)},
          {"f0", 0.25F},
          {"f90", 0.75F},
          {"roughness", cosine_of_step(i)},
          {"gloss", cosine_of_step(i)},
          {"exponent", power},
          {"sharpness", static_cast<float>((power + offset) * scene::natural_slope)},
          {"normalisation", game_normalisation(power)}};
}

float computed(const ShaderFunction& function, const std::map<std::string, float>& arguments) {
  return evaluate<float>(as_generated(function.result, ShaderPrecision::float32),
                         [&](const std::string& name) { return arguments.at(name); });
}

std::string hex_of(float value) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x\n", std::bit_cast<unsigned>(value));
  return text;
}

/// A program that prints the bits of every function for every step, and what they are here.
std::pair<std::string, std::string> program_and_bits(const Case& c, const Plan& plan) {
  std::string program, bits;
  for (const ShaderFunction& function : scene_functions(c.scene, plan)) {
    for (int i = 0; i <= steps; ++i) {
      const auto arguments = arguments_at(c, plan, i, 0);
      std::string list;
      for (const std::string& argument : function.arguments) {
        char text[48];
        std::snprintf(text, sizeof text, "%sgiven(%aF)", list.empty() ? "" : ", ",
                      static_cast<double>(arguments.at(argument)));
        list += text;
      }
      program += "  print(" + function.name + "(" + list + "));\n";
      bits += hex_of(computed(function, arguments));
    }
  }
  return {
      "#include <cstdio>\n#include <cstring>\n#include \"scene.hpp\"\n#include \"scene.hpp\"\n"
      "static void print(float x) {\n  unsigned bits;\n"
      "  std::memcpy(&bits, &x, sizeof bits);\n  std::printf(\"%08x\\n\", bits);\n}\n"
      // or the compiler computes exp2 itself, and rounds it better than the library
      "static float given(volatile float x) { return x; }\nint main() {\n" +
          program + "  return 0;\n}\n",
      bits};
}

// scene.hpp needs nothing else, and computes what is evaluated here, bit for bit, by every compiler at hand.
TEST(SceneCode, ComputesTheBitsThatAreEvaluatedHere) {
  const TemporaryDirectory directory;
  int programs = 0;
  for (const Case& c : cases()) {
    const auto [program, bits] = program_and_bits(c, make_plan(c.scene, c.wanted));
    const std::string source = directory.file("a.cpp", program), binary = directory / "program";
    directory.file("scene.hpp", scene_code(c.scene, make_plan(c.scene, c.wanted), Language::cpp, ""));
    for (const std::string& compiler : testing::cpp_compilers()) {
      ASSERT_TRUE(testing::runs(compiler + " -std=c++17 -O1 -Wall -Wextra -Werror -ffp-contract=off -o '" +
                                    binary + "' '" + source + "' -lm",
                                directory))
          << c.name << compiler << read_file(directory / "said");
      ASSERT_TRUE(testing::runs("'" + binary + "'", directory));
      EXPECT_EQ(read_file(directory / "said"), bits) << c.name << " " << compiler;
      ++programs;
    }
  }
  EXPECT_GE(programs, 8);
}

// The code keeps the promise of its plan: every material, every cosine, in float.
TEST(SceneCode, StaysWithinThePlan) {
  for (const Case& c : cases()) {
    const Plan plan = make_plan(c.scene, c.wanted);
    const auto functions = scene_functions(c.scene, plan);
    const auto light = std::find_if(functions.begin(), functions.end(),
                                    [](const ShaderFunction& f) { return f.name == "scene_light"; });
    for (std::size_t m = 0; m < c.scene.materials.size(); ++m) {
      const Material& material = c.scene.materials[m];
      const double reflectance = scene::largest_reflectance(material);
      for (int i = 0; i <= steps; ++i) {
        auto arguments = arguments_at(c, plan, i, m);
        // of a texture anything between its powers
        const double share = material.is_power_textured() ? (i % 7) / 6.0 : 1;
        const auto single =
            static_cast<float>(material.power.least + share * (material.power.most - material.power.least));
        arguments["exponent"] = single;
        const double power = static_cast<double>(single);
        const double cosine = arguments.at("n_dot_h"), n_dot_l = arguments.at("n_dot_l");
        const double truth = reflectance * (power + 2) / 8 * std::pow(cosine, power) * n_dot_l;
        const double shown = reflectance * static_cast<double>(computed(*light, arguments));
        if (cosine == 0) continue;  // no light, and log2(0) times it
        EXPECT_NEAR(std::min(1.0, shown), std::min(1.0, truth), plan.error) << c.name << " " << cosine;
      }
    }
  }
}

// Of any normal, light and viewer: a normal map may turn a normal away from the viewer, and from the light.
// Where it does not, n.l is as it is.
TEST(SceneCode, StaysWithinThePlanForNormalsThatTurnAway) {
  std::mt19937 random(18);
  std::normal_distribution<double> normal;
  using Vector = std::array<double, 3>;
  const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto unit = [&](Vector v) {
    const double length = std::sqrt(dot(v, v));
    for (double& x : v) x /= length;
    return v;
  };
  const auto direction = [&] { return unit({normal(random), normal(random), normal(random)}); };
  for (const Case& c : cases()) {
    const Plan plan = make_plan(c.scene, c.wanted);
    const auto functions = scene_functions(c.scene, plan);
    const auto light = std::find_if(functions.begin(), functions.end(),
                                    [](const ShaderFunction& f) { return f.name == "scene_light"; });
    const Material& material = c.scene.materials.front();
    const double reflectance = scene::largest_reflectance(material);
    int turned_away = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vector n = direction(), l = direction(), v = direction();
      const Vector h = unit({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
      auto arguments = arguments_at(c, plan, 0, 0);
      arguments["n_dot_h"] = static_cast<float>(std::max(0.0, dot(n, h)));
      arguments["n_dot_l"] = static_cast<float>(std::max(0.0, dot(n, l)));
      const double share = material.is_power_textured() ? (i % 7) / 6.0 : 1;
      arguments["exponent"] =
          static_cast<float>(material.power.least + share * (material.power.most - material.power.least));
      const auto power = static_cast<double>(arguments.at("exponent"));
      const double cosine = arguments.at("n_dot_h"), n_dot_l = arguments.at("n_dot_l");
      const bool is_seen = dot(n, v) >= 0;
      const double seen =
          is_seen || plan.shading.lobe.kind == LobeKind::constant ? n_dot_l : std::min(n_dot_l, 2 * cosine);
      const double truth = reflectance * (power + 2) / 8 * std::pow(cosine, power) * seen;
      const double shown = reflectance * static_cast<double>(computed(*light, arguments));
      // the arguments are rounded: n.l may be above 2 n.h by so much
      ASSERT_NEAR(std::min(1.0, shown), std::min(1.0, truth), plan.error + 1e-7) << c.name << " " << cosine;
      if (!is_seen && n_dot_l > 0) ++turned_away;
    }
    EXPECT_GT(turned_away, 500) << c.name;
  }
}

TEST(SceneCode, DecodesTheLeastRoughness) {
  for (Case c : cases()) {
    c.scene.conventions.min_roughness = 0.3;
    c.scene.conventions.is_gloss_exponential = false;
    const Plan plan = make_plan(c.scene, c.wanted);
    for (const ShaderFunction& function : scene_functions(c.scene, plan)) {
      if (!function.name.starts_with("scene_exponent")) continue;
      const bool is_gloss = function.arguments[0] == "gloss";
      for (const float roughness : {0.0F, 0.25F, 0.5F}) {
        const float stored = is_gloss ? 1 - roughness : roughness;
        const double power = scene::power_of_roughness(static_cast<double>(roughness), c.scene.conventions);
        EXPECT_NEAR(static_cast<double>(computed(function, {{function.arguments[0], stored}})), power,
                    1e-5 * power);
      }
    }
  }
}

// The decoded powers are those that the plan was made for.
TEST(SceneCode, DecodesAsTheReadersDo) {
  for (const Case& c : cases()) {
    const Plan plan = make_plan(c.scene, c.wanted);
    for (const ShaderFunction& function : scene_functions(c.scene, plan)) {
      if (!function.name.starts_with("scene_exponent")) continue;
      for (int i = 1; i < steps; ++i) {
        const double stored = static_cast<double>(cosine_of_step(i));
        const bool is_gloss = function.arguments[0] == "gloss";
        const double power = is_gloss ? scene::power_of_gloss(stored, c.scene.conventions)
                                      : scene::power_of_roughness(stored, c.scene.conventions);
        const double decoded = static_cast<double>(computed(function, arguments_at(c, plan, i, 0)));
        // ten roundings, and 2 is taken from a number that may be next to it
        EXPECT_NEAR(decoded, std::min(power, scene::most_power), 1e-6 * (power + 2)) << stored;
      }
    }
  }
}

// 0 times log2(0) is not a number.
TEST(SceneCode, IsANumberWhereAPowerMayBeZero) {
  Scene rough;
  rough.materials = {shiny("rough", 0.04, {0, 10.5}, FresnelTerm::none, PowerTexture::roughness)};
  const Plan plan = make_plan(rough, {.tolerance = 1e-6});
  ASSERT_EQ(plan.shading.lobe.kind, LobeKind::power);
  const auto functions = scene_functions(rough, plan);
  const float value = computed(functions.back(), {{"n_dot_h", 0.0F}, {"n_dot_l", 0.0F}, {"exponent", 0.0F}});
  EXPECT_EQ(value, 0);
}

// The largest half is 65504: the code does not keep the plan then, but it compiles.
TEST(SceneCode, OfAPowerThatNoHalfIs) {
  Scene mirror;
  mirror.materials = {shiny("mirror", 1, {1e9, 1e9}, FresnelTerm::none)};
  const Plan plan = make_plan(mirror, {.precision = scene::PixelPrecision::float16});
  EXPECT_FALSE(plan.is_within());
  const std::string code = scene_code(mirror, plan, Language::hlsl, "");
  expect_lacks(code, "inf");
  expect_has(code, "NOT within the tolerance");
}

TEST(SceneCode, HalfIsNotForC) {
  const Case c = cases().front();
  Wanted wanted = c.wanted;
  wanted.precision = scene::PixelPrecision::float16;
  const Plan plan = make_plan(c.scene, wanted);
  EXPECT_THROW(scene_code(c.scene, plan, Language::cpp, ""), UserError);
  expect_has(scene_code(c.scene, plan, Language::wgsl, ""), "enable f16;");
}

}  // namespace
}  // namespace shadefit
