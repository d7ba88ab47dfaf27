#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Instruction counts.
namespace shadefit {

/// fit/ledger/lobes/shader_forms.cpp has the forms of these names. The sources print both the number of
/// instructions and their kinds.
inline constexpr std::array cost_claims{
    Claim{.id = "cost-pow",
          .statement = "`c^k` as `exp2(log2(c) k)` is three instructions",
          .printed = {{"c^k", "3"}, {"namely", "LOG2 MUL EXP2"}},
          .inputs = {{"c^k", "pow"}},
          .derivation =
              "The formula runs on the symbolic scalar, which gives its expression. The operations of the "
              "expression are counted. Equal parts count once, operations on numbers alone do not count, and "
              "a product that feeds one sum makes a multiply-add with it.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-sg",
          .statement =
              "the spherical Gaussian `exp2(A c - A)`: with `A` given, with `A = k/ln 2` computed, and with "
              "an offset `x/ln 2` added to a given `A`",
          .printed = {{"A given", "2"},
                      {"namely", "MAD EXP2"},
                      {"A computed", "3"},
                      {"namely", "MUL MAD EXP2"},
                      {"x added", "3"},
                      {"namely", "ADD MAD EXP2"}},
          .inputs = {{"A given", "gaussian"},
                     {"A computed", "gaussian-of-power"},
                     {"x added", "gaussian-with-offset"}},
          .derivation =
              "Counted from the expression. A division by ln 2 is a multiplication by a constant; x/ln 2 is "
              "one constant.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-gloss-decode",
          .statement = "the gloss decode `2^(10 g + 1)`, the same with `1/ln 2` in it, and the normalisation "
                       "`A ln 2/8 + 1/4`",
          .printed = {{"to a power", "2"},
                      {"namely", "MAD EXP2"},
                      {"to a sharpness", "2"},
                      {"namely", "MAD EXP2"},
                      {"normalisation", "1"},
                      {"namely", "MAD"}},
          .inputs = {{"to a power", "gloss-decode"},
                     {"to a sharpness", "gloss-decode-to-sharpness"},
                     {"normalisation", "normalisation-of-sharpness"}},
          .derivation = "Counted from the expression: 1 + log2(1/ln 2) and ln 2/8 are constants.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-saved",
          .statement =
              "the spherical Gaussian saves one instruction over pow once `1/ln 2` is part of the gloss "
              "decode; the one-term Fresnel saves half",
          .printed = {{"saved by the Gaussian", "1"}, {"percent saved by the one-term Fresnel", "50"}},
          .inputs = {{"with pow", "specular-pow"},
                     {"with the Gaussian", "specular-gaussian"},
                     {"Fresnel with pow", "schlick-pow"},
                     {"Fresnel with one term", "fresnel-one-term"},
                     {"whole Fresnel with pow", "reflectance-pow"},
                     {"whole Fresnel with one term", "reflectance-one-term"}},
          .derivation =
              "The first is the whole code of the post: decode, lobe, normalisation and their product. The "
              "second is only (1-c)^5; the whole term is F0 + (1 - F0) (1-c)^5.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-power-four",
          .statement =
              "`(1-c)^4` is two instructions on the PS3, whose LOG2 multiplies by 4 for free, and three by "
              "squaring",
          .printed =
              {{"by exp2", "2"}, {"namely", "LOG2 EXP2"}, {"by squaring", "3"}, {"namely", "SUB MUL MUL"}},
          .inputs = {{"by exp2", "power-four-exp2"},
                     {"by squaring", "power-four-squaring"},
                     {"by exp2, 1 - c given", "power-four-exp2-of-complement"},
                     {"free scales of a result", "2 4 8 0.5 0.25 0.125"}},
          .derivation =
              "Counted from the expression: first as written, then with the scales of a result that are free "
              "on the NV40 family (the PS3's), then with 1 - c given too. The count by squaring includes the "
              "subtraction.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-phong-per-light",
          .statement =
              "with the four-vector (`A r`, `-A`) shared by all lights, each further light is a DOT4 and an "
              "EXP2",
          .printed = {{"per light", "2"}, {"namely", "DOT4 EXP2"}},
          .inputs = {{"per light", "phong-gaussian"}, {"with pow", "phong-pow"}, {"lights", "4"}},
          .derivation =
              "The instructions of so many lights minus those of one light fewer; the results of the lights "
              "stay separate. A sum of three products and a term is a DOT4. The clamp of a negative r.l is "
              "left out on both sides.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-fresnel",
          .statement = "`(1-c)^5` by pow, `exp2(-A c)`, `exp2((a c + b) c)`, and `(1-c)^5` by squaring",
          .printed = {{"pow", "4"},
                      {"namely", "SUB LOG2 MUL EXP2"},
                      {"one term", "2"},
                      {"namely", "MUL EXP2"},
                      {"quadratic", "3"},
                      {"namely", "MAD MUL EXP2"},
                      {"by squaring", "4"},
                      {"namely", "SUB MUL MUL MUL"}},
          .inputs = {{"pow", "schlick-pow"},
                     {"one term", "fresnel-one-term"},
                     {"quadratic", "fresnel-quadratic"},
                     {"by squaring", "schlick-squaring"}},
          .derivation =
              "Counted from the expressions. The coefficients are constants, and their signs are free.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-mip",
          .statement =
              "`m = log2(w sqrt 3) - 1/2 log2(s + 1)` is one logarithm and one fused multiply-add per "
              "pixel, with `log2(w sqrt 3)` precomputed",
          .printed = {{"level", "2"}, {"namely", "LOG2 MAD"}},
          .inputs = {{"level", "mip-level"}, {"level, s + 1 given", "mip-level-of-successor"}},
          .derivation =
              "Counted from the expression for a map of known width. The addition inside the logarithm is an "
              "instruction too, unless the texture stores s + 1.",
          .source = sources::mcguire_2013},
};

}  // namespace shadefit
