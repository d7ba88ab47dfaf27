#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/code/shader_code.hpp"

/// Run time against error: every form, on this processor or on a graphics device, as the code that `emit`
/// writes for it; its measurements, and derived values.
namespace shadefit::bench {

/// The machine of the times.
struct Machine {
  std::string cpu = {};                ///< its name by the system, or "unknown"
  std::string compiler = {};           ///< of the timed code; empty on a graphics device
  std::string device = "cpu";          ///< what ran the forms: the CPU, or the name of a graphics device
  std::string driver = {};             ///< the driver of that device; empty for the CPU
  std::string clock = "steady clock";  ///< which clock took the times
  bool is_graphics() const { return !driver.empty(); }
};

/// The name of this machine's processor, or "unknown".
std::string this_cpu();

/// Of samples the median, and the interquartile range: the width of the middle half.
struct Spread {
  double median, width;
};

/// Of at least one sample, linear between two of them.
Spread spread_of(std::vector<double> samples);

/// A form with one set of its constants, its error, and once it is measured its time.
struct TimedForm {
  std::string target = {};     ///< its id; empty for what there is to compare with: a multiply-add ..
  std::string form = {};       ///< its id
  std::string constants = {};  ///< the id of its set of constants
  std::string label = {};      ///< a few words for tables
  int exp2_degree = 0;         ///< of the polynomial in its exp2; 0: the library's, or none
  ShaderPrecision precision = ShaderPrecision::float32;
  std::optional<double> max_abs_error = {};
  Spread ns = {};                                             ///< per element
  std::optional<double> multiply_adds = {};                   ///< its time in that of a multiply-add in float
  bool is_unbeaten = false;                                   ///< see `mark_unbeaten`
  ShaderFunction function = {"", {}, Symbolic::number("0")};  ///< what is timed
  std::string shape = {};  ///< forms of one target with the same text here have the same time
};

/// The range of an argument.
struct Range {
  double from, to;
};

/// The floats of each argument, the same number for all.
using Places = std::vector<std::vector<float>>;

/// What forms approximate.
struct TimedTarget {
  std::string id;
  std::string title;               ///< its heading in the report
  std::vector<Range> ranges = {};  ///< of its arguments
  Places places = {};              ///< where its forms are compared with it on a device
  /// The target in double at any places. Empty for measured rows.
  std::function<std::vector<double>(const Places&)> truth = {};
};

/// Forms to time, and once they are measured their times, which differ in every run.
struct Trade {
  Machine machine = {};
  int rounds = 0;  ///< of which each time is the median
  /// The tables show each set of constants of a form; else the one of least error.
  bool shows_all_sets = false;
  std::vector<TimedTarget> targets = {};
  /// By target, those of one shape after each other; once measured, first, without a target, a multiply-add.
  std::vector<TimedForm> forms = {};

  /// Whether a form has the time of the one before it.
  bool is_timed_before(std::size_t i) const {
    return i > 0 && forms[i].target == forms[i - 1].target && forms[i].shape == forms[i - 1].shape;
  }
};

/// The target of a form.
const TimedTarget& target_of(const Trade& trade, const TimedForm& form);

/// The form with its exp2, as one name: "sg", "sg/exp2-3".
std::string full_id(const TimedForm& timed);

/// Marks the forms that no other beats in both time and error. They are sorted by time, equal ones by error.
/// A form without an error is not marked.
void mark_unbeaten(std::vector<TimedForm>& forms);

/// The forms of a target that its table shows, the fastest first, marked.
std::vector<TimedForm> shown_forms(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
