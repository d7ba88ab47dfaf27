#pragma once

#include <optional>
#include <string>
#include <vector>

/// Run time against error: the measurements of every form, and derived values.
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

/// The median and the quartiles of samples.
struct Spread {
  double median;
  double lower_quartile, upper_quartile;

  /// The interquartile range: the width of the middle half of the samples.
  double width() const { return upper_quartile - lower_quartile; }
};

/// Median and quartiles of at least one sample, linear between two of them.
Spread spread_of(std::vector<double> samples);

/// A form with one set of its constants, its time and its error.
struct TimedForm {
  std::string target = {};     ///< its id; empty for what there is to compare with: a multiply-add ..
  std::string form = {};       ///< its id
  std::string constants = {};  ///< the id of its set of constants
  std::string label = {};      ///< a few words for tables
  int exp2_degree = 0;         ///< of the polynomial in its exp2; 0: the library's, or none
  bool is_half = false;        ///< else float
  std::optional<double> max_abs_error = {};
  Spread ns = {};                            ///< per element
  std::optional<double> multiply_adds = {};  ///< its time in that of a multiply-add in float
  bool is_unbeaten = false;                  ///< see `mark_unbeaten`
};

/// The target of forms, and its heading in the report.
struct TimedTarget {
  std::string id;
  std::string title;
};

/// The times of a run. They differ in every run.
struct Trade {
  Machine machine = {};
  int rounds = 0;  ///< of which each time is the median
  /// The tables show each set of constants of a form; else the one of least error.
  bool shows_all_sets = true;
  std::vector<TimedTarget> targets = {};
  std::vector<TimedForm> forms = {};  ///< by target; first, without one, a multiply-add
};

/// "half" or "float".
std::string precision_of(const TimedForm& timed);

/// The form with its exp2, as one name: "sg", "sg/exp2-3".
std::string full_id(const TimedForm& timed);

/// Marks the forms that no other beats in both time and error. They are sorted by time, equal ones by error.
/// A form without an error is not marked.
void mark_unbeaten(std::vector<TimedForm>& forms);

/// The forms of a target that its table shows, the fastest first, marked.
std::vector<TimedForm> shown_forms(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
