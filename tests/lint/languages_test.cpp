#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/lint_tree.hpp"
#include "tests/lint/all_known.hpp"

/// How languages write functions and operations. A wrong operation is found in each, and a right one passes.
namespace shadefit::lint {
namespace {

/// A program in which @ is the sign of the second constant of exp2((-5.55473 c - 6.98316) c).
struct WithSign {
  SourceLanguage language;
  std::string text;
};

void expect_read(const std::vector<WithSign>& programs) {
  for (const WithSign& program : programs) {
    const auto verdict_with = [&](const char* sign) {
      std::string text = program.text;
      return verdict_in(text.replace(text.find('@'), 1, sign), program.language);
    };
    EXPECT_EQ(verdict_with("-"), "fresnel-quadratic right") << program.text;
    EXPECT_EQ(verdict_with("+"), "fresnel-quadratic wrong") << program.text;
  }
}

TEST(ReadLanguages, TheValueOfAFunctionWithoutANameIsRead) {
  using enum SourceLanguage;
  expect_read({
      {javascript, "const f = c => Math.pow(2, (-5.55473*c @ 6.98316)*c);\n"},
      {javascript, "const f = (c) =>\n  2 ** ((-5.55473*c @ 6.98316)*c)\n"},
      {typescript, "export const f = (c: number): number => Math.pow(2, (-5.55473*c @ 6.98316)*c);\n"},
      {javascript, "const all = xs.map(c => Math.pow(2, (-5.55473*c @ 6.98316)*c));\n"},
      {csharp, "static float F(float c) => MathF.Pow(2f, (-5.55473f*c @ 6.98316f)*c);\n"},
  });
}

TEST(ReadLanguages, APrefixOfAFunctionHasNoMeaning) {
  using enum SourceLanguage;
  expect_read({
      {csharp, "float F(float c) { return Mathf.Pow(2f, (-5.55473f*c @ 6.98316f)*c); }\n"},
      {csharp, "float F(float c) { return System.MathF.Pow(2f, (-5.55473f*c @ 6.98316f)*c); }\n"},
      {python, "def f(c):\n  return torch.exp2((-5.55473*c @ 6.98316)*c)\n"},
      {python, "def f(c):\n  return jnp.exp2((-5.55473*c @ 6.98316)*c)\n"},
      {python, "def f(c):\n  return tf.math.pow(2.0, (-5.55473*c @ 6.98316)*c)\n"},
  });
}

TEST(ReadLanguages, APlusMayComeFirst) {
  // The polynomial of AgX as most programs have it.
  const auto grade = [](const std::string& sign) {
    return verdict_in(
        "vec3 f(vec3 x) {\n  vec3 x2 = x * x;\n  vec3 x4 = x2 * x2;\n  return + 15.5 * x4 * x2\n" +
            ("         " + sign + " 40.14 * x4 * x\n") +
            "         + 31.96 * x4\n         - 6.868 * x2 * x\n         + 0.4298 * x2\n"
            "         + 0.1191 * x\n         - 0.00232;\n}\n",
        SourceLanguage::glsl);
  };
  EXPECT_EQ(grade("-"), "agx-sextic right");
  EXPECT_EQ(grade("+"), "agx-sextic wrong");
}

/// "id grade", with ": slip" of an operation, of each site. All have to be in comments.
Words notes_in(const std::string& text) {
  Words words;
  for (const LintedSite& site : lint_text(text)) {
    EXPECT_TRUE(site.is_in_comment) << text;
    words.push_back(site.id + " " + std::string(name(site.grade)) +
                    (site.slip.empty() ? "" : ": " + site.slip));
  }
  return words;
}

TEST(Comments, MayHaveAFormula) {
  const Words wrong{"fresnel-quadratic wrong"};
  EXPECT_EQ(notes_in("// exp2((-5.55473 * c - 6.8316) * c)\n"), wrong);
  EXPECT_EQ(notes_in("/* The term:\n * f = exp2((-5.55473 * c - 6.8316) * c)\n */\n"), wrong);
  EXPECT_EQ(notes_in("// exp2((-5.55473 * c - 6.98316) * c)\n"), Words{"fresnel-quadratic right"});
  EXPECT_EQ(notes_in("// exp2((-5.55473 * c + 6.98316) * c)\n"),
            Words{"fresnel-quadratic wrong: a c - b for a c + b"});
}

}  // namespace
}  // namespace shadefit::lint
