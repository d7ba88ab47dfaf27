#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/expression/program_text.hpp"
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
      {java, "F f = c -> StrictMath.pow(2, (-5.55473*c @ 6.98316)*c);\n"},
      {java, "F f = (float c) -> (float)Math.pow(2, (-5.55473*c @ 6.98316)*c);\n"},
      {python, "f = lambda c: 2**((-5.55473*c @ 6.98316)*c)\n"},
      {python, "xs = map(lambda c: np.exp2((-5.55473*c @ 6.98316)*c), ys)\n"},
      {rust, "let f = |c: f32| ((-5.55473*c @ 6.98316)*c).exp2();\n"},
      {rust, "let ys = xs.map(|c| ((-5.55473*c @ 6.98316)*c).exp2());\n"},
  });
}

TEST(ReadLanguages, APrefixOrARoundingOfAFunctionHasNoMeaning) {
  using enum SourceLanguage;
  expect_read({
      {csharp, "float F(float c) { return Mathf.Pow(2f, (-5.55473f*c @ 6.98316f)*c); }\n"},
      {csharp, "float F(float c) { return System.MathF.Pow(2f, (-5.55473f*c @ 6.98316f)*c); }\n"},
      {python, "def f(c):\n  return torch.exp2((-5.55473*c @ 6.98316)*c)\n"},
      {python, "def f(c):\n  return jnp.exp2((-5.55473*c @ 6.98316)*c)\n"},
      {python, "def f(c):\n  return tf.math.pow(2.0, (-5.55473*c @ 6.98316)*c)\n"},
      {cuda, "float f(float c) { return __powf(2.0f, (-5.55473f*c @ 6.98316f)*c); }\n"},
      {cuda, "float f(float c) { return __exp2f((-5.55473f*c @ 6.98316f)*c); }\n"},
      {cuda, "float f(float c) { return __exp2f(__fmaf_rn(-5.55473f, c, @6.98316f)*c); }\n"},
      {cuda, "float f(float c) { return __exp2f(__fmul_rn(-5.55473f*c @ 6.98316f, c)); }\n"},
      {c_family, "float f(float c) { return native_exp2((-5.55473f*c @ 6.98316f)*c); }\n"},
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

TEST(ReadLanguages, StringsOfSeveralLinesAreOneProgram) {
  using enum SourceLanguage;
  const auto joined = [](const std::string& text) { return with_joined_strings(text, CommentStyle::c); };
  EXPECT_EQ(joined("s = \"a;\\n\"\n  \"b\\n\";\n"), "s = ;a;   \n   b  ;;\n");
  EXPECT_EQ(joined("f('a' +\n'b')"), "f(;a   \n b;)");
  for (const char* text :
       {"\"a\",\n\"b\"", "\"a\n\"b\"", "\"a\"\n'b'", "\"a\"\n\n\"b\"", "a\n\"", "\"\n", ""})
    EXPECT_EQ(joined(text), text);
  expect_read({
      {c_family,
       "const char* f =\n  \"float p = (-5.55473*c @ 6.98316) * c;\\n\"\n  \"return exp2(p);\\n\";\n"},
      {c_family,
       "const char* f =\n  \"float p = (-5.55473*c // a term\\n\"\n  \"@ 6.98316) * c; /* p */\\n\"\n  \"return exp2(p);\\n\";\n"},
      {javascript, "const f = 'float p = (-5.55473*c @ 6.98316) * c;' +\n  'return exp2(p);';\n"},
      {python, "f = (\"float p = (-5.55473*c @ 6.98316) * c;\\n\"\n     \"return exp2(p);\\n\")\n"},
  });
}

}  // namespace
}  // namespace shadefit::lint
