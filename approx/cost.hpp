#pragma once

#include <array>
#include <string_view>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Instruction counts: what a form costs, counted from the formula itself by the symbolic scalar.
namespace shadefit {

/// `mip_level_of_power` where s + 1 is what is stored: log2(w sqrt(3)) - 1/2 log2(s + 1).
template <class T>
T mip_level_of_successor(const T& width, const T& exponent_plus_one) {
  const T half = integer<T>(1) / integer<T>(2);
  return log2(width * sqrt(integer<T>(3))) - half * log2(exponent_plus_one);
}

/// What a Phong highlight by the spherical Gaussian needs of the view: (A r, -A), r the reflected view
/// vector. Source: Lagarde 2012.
template <class T>
std::array<T, 4> scaled_reflection(const std::array<T, 3>& reflected, const T& base_two) {
  return {base_two * reflected[0], base_two * reflected[1], base_two * reflected[2], -base_two};
}

/// The highlight of a light in the direction l: exp2((A r, -A) . (l, 1)) = exp2(A r.l - A).
template <class T>
T phong_by_exp2(const std::array<T, 4>& scaled, const std::array<T, 3>& light) {
  return exp2(scaled[0] * light[0] + scaled[1] * light[1] + scaled[2] * light[2] + scaled[3]);
}

/// r.l, the cosine of the Phong angle.
template <class T>
T phong_cosine(const std::array<T, 3>& reflected, const std::array<T, 3>& light) {
  return reflected[0] * light[0] + reflected[1] * light[1] + reflected[2] * light[2];
}

/// What a compiler makes of a form: static counts of its machine code.
struct CompiledCost {
  std::string_view form;  ///< as the inputs of the claims name it
  int nvidia_alu;         ///< vector arithmetic, by `nvidia_compiler`
  int nvidia_transcendental;
  int amd_alu;  ///< by `amd_compiler`
  int amd_transcendental;
};

inline constexpr std::string_view nvidia_compiler = "nvcc 13.0.88 -arch=sm_75 --use_fast_math";
inline constexpr std::string_view amd_compiler = "clang 19.1.7 -mcpu=gfx1030 -cl-denorms-are-zero";

/// Own measurement, 2026: kernels of one form each, uniform exponents, the cosine loaded; the instructions of
/// the cubin and of the AMD assembly, without loads, stores, addresses, constants and control flow. NVIDIA's
/// are FMUL, FADD, FFMA, FMNMX, FSETP and FSEL, and MUFU; AMD's the like, and v_exp, v_log.
inline constexpr std::array compiled_costs{
    CompiledCost{"pow", 1, 2, 1, 2},
    CompiledCost{"gaussian", 1, 1, 1, 1},
    CompiledCost{"schlick-pow", 2, 2, 2, 2},
    CompiledCost{"schlick-squaring", 4, 0, 4, 0},
    CompiledCost{"fresnel-one-term", 1, 1, 1, 1},
    CompiledCost{"fresnel-quadratic", 2, 1, 2, 1},
    CompiledCost{"phong-gaussian", 4, 1, 4, 1},
    CompiledCost{"phong-pow", 5, 2, 5, 2},  // with max(r.l, 0)
};

/// The rows of the ledger on this topic. Forms are named as fit/ledger/lobes/shader_forms.cpp names them;
/// printed are both how many instructions there are and which.
inline constexpr std::array cost_claims{
    Claim{.id = "cost-pow",
          .statement = "c^k as exp2(log2(c) k) is three instructions",
          .printed = {{"c^k", "3"}, {"namely", "LOG2 MUL EXP2"}},
          .inputs = {{"c^k", "pow"}},
          .derivation = "The formula run on the symbolic scalar is its own expression; its operations are "
                        "counted, equal parts once, those of numbers alone not at all, a product that feeds "
                        "one sum with it as a multiply-add.",
          .source = sources::lagarde_2012},
    Claim{
        .id = "cost-sg",
        .statement = "the spherical Gaussian exp2(A c - A): with A given, with A = k/ln 2 computed, and with "
                     "an offset x/ln 2 added to a given A",
        .printed = {{"A given", "2"},
                    {"namely", "MAD EXP2"},
                    {"A computed", "3"},
                    {"namely", "MUL MAD EXP2"},
                    {"x added", "3"},
                    {"namely", "ADD MAD EXP2"}},
        .inputs = {{"A given", "gaussian"},
                   {"A computed", "gaussian-of-power"},
                   {"x added", "gaussian-with-offset"}},
        .derivation = "Counted from the expression. A division by ln 2 is a multiplication by a number known "
                      "before; x/ln 2 is one number.",
        .source = sources::lagarde_2012},
    Claim{.id = "cost-gloss-decode",
          .statement = "the gloss decode 2^(10 g + 1), the same with 1/ln 2 in it, and the normalisation "
                       "A ln 2/8 + 1/4",
          .printed = {{"to a power", "2"},
                      {"namely", "MAD EXP2"},
                      {"to a sharpness", "2"},
                      {"namely", "MAD EXP2"},
                      {"normalisation", "1"},
                      {"namely", "MAD"}},
          .inputs = {{"to a power", "gloss-decode"},
                     {"to a sharpness", "gloss-decode-to-sharpness"},
                     {"normalisation", "normalisation-of-sharpness"}},
          .derivation = "Counted from the expression: 1 + log2(1/ln 2) and ln 2/8 are numbers known before.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-saved",
          .statement =
              "the spherical Gaussian saves one instruction over pow once 1/ln 2 is part of the gloss "
              "decode; the one-term Fresnel saves half",
          .printed = {{"saved by the Gaussian", "1"}, {"percent saved by the one-term Fresnel", "50"}},
          .inputs = {{"with pow", "specular-pow"},
                     {"with the Gaussian", "specular-gaussian"},
                     {"Fresnel with pow", "schlick-pow"},
                     {"Fresnel with one term", "fresnel-one-term"},
                     {"whole Fresnel with pow", "reflectance-pow"},
                     {"whole Fresnel with one term", "reflectance-one-term"}},
          .derivation = "The first is the whole code of the post: decode, lobe, normalisation and their "
                        "product. The second is (1-c)^5 alone; the whole term is F0 + (1 - F0) times it.",
          .source = sources::lagarde_2012},
    Claim{
        .id = "cost-power-four",
        .statement = "(1-c)^4 is two instructions on the PS3, whose LOG2 multiplies by 4 for nothing, and "
                     "three by squaring",
        .printed =
            {{"by exp2", "2"}, {"namely", "LOG2 EXP2"}, {"by squaring", "3"}, {"namely", "SUB MUL MUL"}},
        .inputs = {{"by exp2", "power-four-exp2"},
                   {"by squaring", "power-four-squaring"},
                   {"by exp2, 1 - c given", "power-four-exp2-of-complement"},
                   {"free scales of a result", "2 4 8 0.5 0.25 0.125"}},
        .derivation =
            "Counted from the expression: as written, then with the scales that a result has for nothing in "
            "the NV40 family (the PS3's), then with 1 - c given besides. The count by squaring has the "
            "subtraction in it.",
        .source = sources::lagarde_2012},
    Claim{.id = "cost-phong-per-light",
          .statement =
              "with the four-vector (A r, -A) shared by all lights, each further light is a DOT4 and "
              "an EXP2",
          .printed = {{"per light", "2"}, {"namely", "DOT4 EXP2"}},
          .inputs = {{"per light", "phong-gaussian"}, {"with pow", "phong-pow"}, {"lights", "4"}},
          .derivation = "The instructions of that many lights less those of one fewer, the results of all "
                        "lights kept apart; a sum of three products and a term is a DOT4, the clamp of a "
                        "negative r.l left out on both sides.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-fresnel",
          .statement = "(1-c)^5 by pow, exp2(-A c), exp2((a c + b) c), and (1-c)^5 by squaring",
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
          .derivation = "Counted from the expressions; the coefficients are numbers, their signs free.",
          .source = sources::lagarde_2012},
    Claim{.id = "cost-mip",
          .statement = "m = log2(w sqrt 3) - 1/2 log2(s + 1) is one logarithm and one fused multiply-add a "
                       "pixel, log2(w sqrt 3) known before",
          .printed = {{"level", "2"}, {"namely", "LOG2 MAD"}},
          .inputs = {{"level", "mip-level"}, {"level, s + 1 given", "mip-level-of-successor"}},
          .derivation = "Counted from the expression for a map of a known width: the addition inside the "
                        "logarithm is an instruction too, unless s + 1 is what the texture stores.",
          .source = sources::mcguire_2013},
};

}  // namespace shadefit
