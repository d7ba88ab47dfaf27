#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "bench/tradeoff/timed_forms.hpp"

/// Compute shaders in GLSL that measure the time of a function, and the times that are subtracted from it.
namespace shadefit::device {

/// The evaluations of a thread in one turn of its loop.
inline constexpr std::uint32_t evaluations_a_turn = 8;

/// The first two push words of a timing shader: the turns, and the bits of the factor of `timing_shader`.
/// The factor is the least normal half: it changes no argument by more than the spacing of halves below 1.
inline constexpr float chain_factor = 0x1p-14F;

/// Evaluates a function, in the text that `emit` writes, `evaluations_a_turn` times per turn. Each argument
/// is b + t r: b is the thread's own point in the range of the argument, t a factor that the compiler does
/// not know, r an earlier result. So the compiler cannot leave out an evaluation, and little memory is
/// written: one word per thread. Four evaluations at a time do not wait for each other: a time is that of the
/// throughput. With no turns it is the empty kernel.
std::string timing_shader(const ShaderFunction& function, std::span<const bench::Range> ranges,
                          ShaderPrecision precision);

/// The function that returns its argument: it gives the time of the chain itself.
ShaderFunction chain_alone();

}  // namespace shadefit::device
