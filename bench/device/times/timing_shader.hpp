#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "reports/code/shader_code.hpp"

/// Compute shaders in GLSL that measure the time of a function, and what stands beside it.
namespace shadefit::device {

/// How the evaluations of a thread depend on one another.
enum class Chain {
  dependent,    ///< each waits for the result of the one before: the time from input to result
  independent,  ///< four at a time do not wait for each other: the time that a stream of them takes
};

/// The evaluations of a thread in one turn of its loop.
inline constexpr std::uint32_t evaluations_a_turn = 8;

/// The first two push words of a timing shader: the turns, and the bits of the factor of `timing_shader`.
/// The factor is the least normal half: it changes no argument by more than the spacing of halves below 1.
inline constexpr float chain_factor = 0x1p-14F;

/// The range of an argument.
struct Range {
  double from, to;
};

/// Evaluates a function, in the text that `emit` writes, `evaluations_a_turn` times a turn. Each of its
/// arguments is b + t r: b is the thread's own place in the range of the argument, t a factor that the
/// compiler does not know, r the result of an evaluation before. So no evaluation can be left out, and little
/// memory is written: one word a thread. With no turns it is the empty kernel.
std::string timing_shader(const ShaderFunction& function, std::span<const Range> ranges,
                          ShaderPrecision precision, Chain chain);

/// Copies words from the input to the output. The push words are the number of words and that of threads.
std::string copying_shader();
/// Writes to each word of both buffers, so that there is memory behind them. The same push words.
std::string filling_shader();

/// The function that returns its argument: a chain of it takes the time that the chain itself takes.
ShaderFunction chain_alone();

/// `forms::MultiplyAdds`: each multiply-add waits for the one before.
ShaderFunction multiply_add_chain();

}  // namespace shadefit::device
