#include "bench/tradeoff/measure.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "approx/exp2_polynomial.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"
#include "reports/io/scratch_directory.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit::bench {
namespace {

/// Calls a function for every element of arrays. The type is the same for any number of variables.
using Loop = void (*)(const float* const* in, float* out, long size);

/// A form, and the loop that calls it.
std::string code_of(const TimedForm& form) {
  std::string arguments;
  for (std::size_t i = 0; i < form.function.arguments.size(); ++i)
    arguments += fmt::format("{}in[{}][i]", i == 0 ? "" : ", ", i);
  const std::string code =
      shader_code(std::span(&form.function, 1), Language::c, ShaderPrecision::float32, {}) +
      fmt::format(
          "void loop_{0}(const float* const* in, float* out, long size) {{\n"
          "  for (long i = 0; i < size; ++i) out[i] = {0}({1});\n}}\n",
          form.function.name, arguments);
  if (form.exp2_degree == 0) return code;
  return fmt::format("#define exp2f exp2_degree_{}\n{}#undef exp2f\n", form.exp2_degree, code);
}

std::string code_of(const Trade& trade) {
  // The name of the compiler is its own.
  std::string code =
      "#ifdef __clang__\nconst char compiler[] = \"clang \" __clang_version__;\n"
      "#else\nconst char compiler[] = \"gcc \" __VERSION__;\n#endif\n";
  for (int degree = least_exp2_degree; degree <= largest_exp2_degree; ++degree) code += exp2_in_c(degree);
  for (std::size_t i = 0; i < trade.forms.size(); ++i)
    if (!trade.is_timed_before(i)) code += code_of(trade.forms[i]);
  return code;
}

/// A loop over arrays that fit into the first cache together. Their points lie in the ranges of the
/// arguments, unsorted.
Work work_of(Loop loop, const std::vector<Range>& ranges) {
  // Half of 32 KiB, the smallest cache of x86-64 processors of the last decade, so that other data fit too.
  constexpr std::size_t bytes = 16 * 1024;
  const std::size_t size = bytes / (sizeof(float) * (ranges.size() + 1)) / 64 * 64;
  // Each array has another offset in its page; otherwise loads would wait for stores.
  const std::size_t stride = (size + 1023) / 1024 * 1024 + 128;
  const auto memory = std::make_shared<std::vector<float>>((ranges.size() + 1) * stride);
  float* array = memory->data();
  std::vector<const float*> in;
  std::minstd_rand random;
  for (const Range& range : ranges) {
    std::uniform_real_distribution within(range.from, range.to);
    std::generate_n(array, size, [&] { return static_cast<float>(within(random)); });
    in.push_back(array);
    array += stride;
  }
  const auto run = [memory, in, out = array, size, loop](long calls) {
    const auto start = std::chrono::steady_clock::now();
    for (long i = 0; i < calls; ++i) {
      loop(in.data(), out, static_cast<long>(size));
      // Keeps the compiler from removing unused results: for the compiler, this reads all of the memory.
      asm volatile("" : : "r"(out) : "memory");
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  return {[run](long calls) {
            run(calls / 8 + 1);  // an eighth of a visit restores caches and branch prediction
            return run(calls);
          },
          static_cast<double>(size)};
}

}  // namespace

std::string exp2_in_c(int degree) {
  using Limits = ExponentLimits<float>;
  std::vector<Symbolic> coefficients;
  const Exp2Coefficients& polynomial = exp2_of_degree(exp2_for_float, degree);
  for (const std::string_view printed : std::span(polynomial.printed).first(static_cast<std::size_t>(degree)))
    coefficients.push_back(Symbolic::number(printed));
  const ShaderFunction near_zero{
      fmt::format("near_zero_{}", degree), {"r"}, exp2_near_zero(Symbolic::variable("r"), coefficients)};
  return shader_code(std::span(&near_zero, 1), Language::c, ShaderPrecision::float32, {}) +
         fmt::format(
             "static inline float exp2_degree_{0}(float x) {{\n"
             "  const float above = x < {1}.0f ? {1}.0f : x, within = {2}.0f < above ? {2}.0f : above;\n"
             "  const float shifted = within + {3}.0f;\n"
             "  union {{ float number; unsigned bits; }} whole, result;\n"
             "  whole.number = shifted;\n"
             "  result.number = near_zero_{0}(within - (shifted - {3}.0f));\n"
             "  result.bits += whole.bits << {4};\n"
             "  return result.number;\n}}\n",
             degree, static_cast<int>(Limits::least), static_cast<int>(Limits::largest),
             static_cast<int>(Limits::rounder), Limits::mantissa_bits);
}

std::shared_ptr<void> compiled_code(const std::string& source) {
  constexpr const char* flags =
      "-std=c11 -O3 -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off -fno-math-errno -fPIC -shared";
  const char* chosen = std::getenv("CC");
  const std::string compiler = chosen != nullptr && *chosen != '\0' ? chosen : "cc";
  const ScratchDirectory scratch;
  const auto file = [&](const char* name) { return (scratch.path() / name).string(); };
  write_files(scratch.path(), {{"forms.c", source}});
  const std::string command = fmt::format("{} {} -o '{}' '{}' -lm 2>'{}'", compiler, flags, file("forms.so"),
                                          file("forms.c"), file("said"));
  if (std::system(command.c_str()) != 0) {
    const std::string said = read_file(file("said"));
    throw UserError(fmt::format("the C compiler '{}' (variable CC, else cc) cannot compile the forms: {}",
                                printable(compiler), printable(said.substr(0, said.find('\n')))));
  }
  void* const library = ::dlopen(file("forms.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw UserError(fmt::format("cannot load the output of the C compiler: {}", printable(::dlerror())));
  return {library, ::dlclose};
}

Trade measure(Trade trade, const TimingPlan& plan, const std::function<void(double)>& between) {
  std::vector<TimedForm>& forms = trade.forms;
  forms.insert(forms.begin(),
               {.form = "multiply-add", .label = "multiply-add", .function = multiply_add_chain()});
  for (std::size_t i = 0; i < forms.size(); ++i) forms[i].function.name = fmt::format("form_{}", i);
  between(0);
  const std::shared_ptr<void> code = compiled_code(code_of(trade));
  std::vector<Work> work;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (trade.is_timed_before(i)) continue;
    void* const loop = ::dlsym(code.get(), ("loop_" + forms[i].function.name).c_str());
    work.push_back(work_of(reinterpret_cast<Loop>(loop),
                           i == 0 ? std::vector{Range{0, 1}} : target_of(trade, forms[i]).ranges));
  }
  const std::vector<Samples> samples = time_interleaved(work, plan, between);

  trade.machine = {this_cpu(), static_cast<const char*>(::dlsym(code.get(), "compiler"))};
  trade.rounds = plan.rounds;
  auto next = samples.begin();
  for (std::size_t i = 0; i < forms.size(); ++i)
    forms[i].ns = trade.is_timed_before(i) ? forms[i - 1].ns : spread_of((next++)->ns);
  Spread& unit = forms.front().ns;
  unit = {unit.median / multiply_adds_of_chain, unit.width / multiply_adds_of_chain};
  for (TimedForm& form : forms) form.multiply_adds = form.ns.median / unit.median;
  return trade;
}

}  // namespace shadefit::bench
