#include "bench/studies/measure_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <memory>
#include <utility>

#include "bench/studies/compiled_code.hpp"
#include "bench/timing/workload.hpp"
#include "bench/tradeoff/report.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/io/escape.hpp"
#include "reports/studies/study_comparison.hpp"
#include "reports/table/writers.hpp"

namespace shadefit::bench {
namespace {

/// Calls a function for every element of arrays. The type is the same for any number of variables.
using Loop = void (*)(const float* const* in, float* out, long size);

/// A function of the code, and the rows that have its time.
struct TimedFunction {
  ShaderFunction function;
  std::vector<TimedForm> rows;
  std::size_t comparison;
  Operations operations = {};  ///< of a form
};

std::string loop_of(const std::string& function, std::size_t variables) {
  std::string arguments;
  for (std::size_t i = 0; i < variables; ++i) arguments += fmt::format("{}in[{}][i]", i == 0 ? "" : ", ", i);
  return fmt::format(
      "void loop_{}(const float* const* in, float* out, long size) {{\n"
      "  for (long i = 0; i < size; ++i) out[i] = {};\n}}\n",
      function, function == "copy" ? arguments : fmt::format("{}({})", function, arguments));
}

/// C code for the name of its own compiler.
constexpr const char* compiler_code =
    "#ifdef __clang__\nconst char compiler[] = \"clang \" __clang_version__;\n"
    "#else\nconst char compiler[] = \"gcc \" __VERSION__;\n#endif\n";

/// Adds the target itself, if it is a formula that C has.
void add_target(std::vector<TimedFunction>& timed, const StudyComparison& comparison,
                const TimedTarget& target, std::size_t place) {
  if (comparison.study.rows != nullptr) return;
  const Symbolic formula = formulas_of(comparison, comparison.contenders.front()).target;
  if (integral_depth(formula) > 0) return;
  timed.push_back({{fmt::format("target_{}", place), comparison.variables, formula},
                   {row_of(comparison, target)},
                   place});
}

void add_form(std::vector<TimedFunction>& timed, const StudyContender& contender,
              const StudyComparison& comparison, const TimedTarget& target, std::size_t place) {
  if (integral_depth(contender.code) > 0)
    throw UserError(fmt::format("bench has no code for 'integral' in the form '{}'", contender.formula));
  TimedForm row = row_of(contender, target);
  row.max_abs_error = largest_error(formulas_of(comparison, contender), contender.values).magnitude;
  for (TimedFunction& other : timed) {
    if (other.comparison == place && other.rows.front().form == contender.form &&
        other.operations == contender.operations)
      return other.rows.push_back(row);
  }
  timed.push_back({{fmt::format("form_{}", timed.size()), comparison.variables, contender.code},
                   {row},
                   place,
                   contender.operations});
}

std::vector<TimedFunction> timed_functions(const std::vector<TimedTarget>& targets,
                                           const std::vector<StudyComparison>& comparisons) {
  std::vector<TimedFunction> timed;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    add_target(timed, comparisons[i], targets[i], i);
    for (const StudyContender& contender : comparisons[i].contenders)
      add_form(timed, contender, comparisons[i], targets[i], i);
  }
  return timed;
}

std::string code_of(const std::vector<TimedFunction>& timed) {
  std::vector<ShaderFunction> functions;
  std::string loops = loop_of("copy", 1);
  for (const TimedFunction& one : timed) {
    functions.push_back(one.function);
    loops += loop_of(one.function.name, one.function.arguments.size());
  }
  const std::array<OthersText, 1> comment{std::string("Timed by shadefit bench.")};
  return shader_code(functions, Language::c, ShaderPrecision::float32, comment) + compiler_code + loops;
}

/// Points that cover the ranges of the variables evenly but unsorted: an additive recurrence. Its steps are
/// the powers of 1/x with x^(n+1) = x + 1, which generalise the golden ratio (Roberts 2018, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", extremelearning.com.au).
class Places {
 public:
  explicit Places(const StudyComparison& comparison) {
    const std::vector<StudyAxis> axes = formulas_of(comparison, comparison.contenders.front()).axes;
    const std::size_t size = first_cache_bytes / (sizeof(float) * (axes.size() + 1)) / 64 * 64;
    double root = 2;
    for (int i = 0; i < 50; ++i) root = std::pow(1 + root, 1 / static_cast<double>(axes.size() + 1));
    double share = 1;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      share /= root;
      // Each array has another offset in its page, so that loads do not wait for stores.
      auto& in = in_.emplace_back(size, axis * 512);
      for (std::size_t i = 0; i < size; ++i) {
        const double part = std::fmod(share * static_cast<double>(i + 1), 1.0);
        in.data()[i] = static_cast<float>(axes[axis].lower + part * (axes[axis].upper - axes[axis].lower));
      }
      pointers_.push_back(in.data());
    }
    out_ = std::make_unique<Array<float>>(size, in_.size() * 512);
  }

  Work work(Loop loop) {
    return {[=, this] {
              loop(pointers_.data(), out_->data(), static_cast<long>(out_->size()));
              keep(out_->data());
            },
            out_->size()};
  }

 private:
  std::vector<Array<float>> in_;
  std::vector<const float*> pointers_;
  std::unique_ptr<Array<float>> out_;
};

}  // namespace

TimedTarget timed_target(const std::string& id, const std::vector<StudyComparison>& comparisons,
                         const StudyComparison& comparison) {
  if (comparison.contenders.empty())
    throw UserError("no fit of '" + id + "' converged, and nothing was published: there is nothing to time");
  return {comparisons.size() == 1 ? id : fmt::format("{}-{}", id, &comparison - comparisons.data() + 1),
          for_terminal(target_of(comparison))};
}

TimedForm row_of(const StudyComparison& comparison, const TimedTarget& target) {
  TimedForm row;
  row.target = target.id;
  row.form = "target";
  row.label = "the target: " + comparison.study.target;
  row.is_reference = true;
  return row;
}

TimedForm row_of(const StudyContender& contender, const TimedTarget& target) {
  const std::string& origin = contender.origin.unescaped();
  TimedForm row;
  row.target = target.id;
  row.form = contender.form;
  row.constants = origin;
  // "linear, minimax" for a fit, "cubic, Unity Technologies" for a published set.
  row.label =
      contender.form + ", " + (contender.published == nullptr ? origin : origin.substr(0, origin.find(',')));
  return row;
}

Trade measure_study(const std::string& id, const std::vector<StudyComparison>& comparisons,
                    const TimingPlan& plan, const Clock& clock, const std::function<void(double)>& between) {
  Trade trade;
  for (const StudyComparison& comparison : comparisons)
    trade.targets.push_back(timed_target(id, comparisons, comparison));
  const std::vector<TimedFunction> timed = timed_functions(trade.targets, comparisons);
  between(0);
  const CompiledCode code(code_of(timed));
  const auto loop = [&](const std::string& name) { return reinterpret_cast<Loop>(code.at("loop_" + name)); };
  std::deque<Places> places;  // work points to them
  for (const StudyComparison& comparison : comparisons) places.emplace_back(comparison);
  std::vector<Work> work{places.front().work(loop("copy"))};
  for (const TimedFunction& one : timed) work.push_back(places[one.comparison].work(loop(one.function.name)));
  const std::vector<Samples> samples = time_interleaved(work, plan, clock, between);

  trade.machine = this_machine();
  trade.machine.compiler = static_cast<const char*>(code.at("compiler"));
  trade.widths = {forms::Width::scalar};
  TimedForm& copy = trade.copies.emplace_back();
  copy.form = copy.label = "copy";
  copy.take(samples.front(), work.front());
  for (std::size_t i = 0; i < timed.size(); ++i) {
    for (const TimedForm& row : timed[i].rows)
      trade.forms.emplace_back(row).take(samples[i + 1], work[i + 1]);
  }
  relate(trade);
  return trade;
}

Table study_times(const Trade& trade, const std::string& target) {
  Table table{{"form", "max abs error", "ns", "spread", "x copy", "x faster than the target"}, {}};
  std::vector<TimedForm> rows;
  std::copy_if(trade.forms.begin(), trade.forms.end(), std::back_inserter(rows),
               [&](const TimedForm& timed) { return timed.target == target; });
  std::ranges::stable_sort(rows, {},
                           [](const TimedForm& row) { return std::pair(row.ns.median, row.max_abs_error); });
  for (const TimedForm& timed : rows) {
    table.rows.push_back({OthersText(timed.label),
                          timed.max_abs_error ? Cell{Number{*timed.max_abs_error, 4}} : Cell{},
                          measured(timed.ns.median), measured(timed.ns.width()), measured(timed.copies),
                          measured(timed.pows)});
  }
  return table;
}

std::vector<File> study_bench_files(const Trade& trade) {
  std::string text = fmt::format(
      "# Run time against error\n\n"
      "{}, compiled by {}. Each form is the C code that `emit` writes, in float, one number at a time.\n"
      "The times are medians of {} rounds, each of which visits every form once, on one core, with the data in L1;\n"
      "`spread` is the interquartile range. `x copy`: in times of copying the array.\n"
      "Errors are those of exact arithmetic; times are this machine's, of this day.\n\n",
      trade.machine.cpu, trade.machine.compiler, trade.forms.front().real.size());
  for (const TimedTarget& target : trade.targets)
    text +=
        fmt::format("## {}\n\n{}", for_markdown(target.title), markdown_block(study_times(trade, target.id)));
  text.pop_back();  // sections end in an empty line, the file does not
  return {{"bench.md", text}, {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
}

}  // namespace shadefit::bench
