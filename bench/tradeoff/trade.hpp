#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/forms/kernel.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/statistics.hpp"
#include "bench/timing/timing.hpp"

/// Run time against error: the measurements of every form, and derived values.
namespace shadefit::bench {

/// The location of the arrays that a form reads and writes.
enum class DataPlace {
  first_cache,  ///< both together in the smallest cache
  memory,       ///< in arrays far larger than the last cache
};

/// "L1", "memory".
std::string name(DataPlace place);

/// What only a graphics device has: see bench/device/times/measure_device.hpp. A copy has no such times.
struct DeviceTimes {
  bool is_half = false;
  std::optional<double> dependent_ns = {};             ///< of an evaluation that waits for the one before
  std::optional<double> dependent_multiply_adds = {};  ///< that in multiply-adds that wait for each other
};

/// One measurement for a target: the form, its compilation, the place of its data, and its time.
struct TimedForm {
  std::string target;         ///< its id
  std::string form;           ///< its id
  std::string constants;      ///< the id of its set of constants, on which times do not depend
  std::string label;          ///< a few words for pictures and sentences
  int exp2_degree = 0;        ///< of the polynomial in its exp2; 0: the library's, or none
  bool is_reference = false;  ///< the target's own formula by the library's pow, exp2, sqrt ..
  bool is_double = false;
  forms::Width width = forms::Width::scalar;
  DataPlace place = DataPlace::first_cache;
  Spread ns = {};                       ///< per element
  std::vector<double> real, cpu;        ///< ns per element of every round
  long elements = 0;                    ///< per mean in `real` and `cpu`
  std::optional<double> max_abs_error;  ///< in its precision
  std::optional<double> copies;         ///< its time relative to copying the same array
  std::optional<double> pows;  ///< the time of the scalar reference relative to its own: the speed-up
  /// The time in that of a multiply-add: on the CPU of the same width, precision and place, on a graphics
  /// device in float.
  std::optional<double> multiply_adds;
  std::optional<DeviceTimes> on_device;  ///< of a graphics device; then `width` and `place` mean nothing

  /// Its times: those of a piece of work.
  void take(const Samples& samples, const Work& work);
};

/// The target of forms, and its heading in the report.
struct TimedTarget {
  std::string id;
  std::string title;
};

/// A desired ratio, and the measured one.
struct Goal {
  std::string what;
  double wanted;
  bool at_most;  ///< else at least
  std::optional<double> reached;
  bool is_met() const { return reached && (at_most ? *reached <= wanted : *reached >= wanted); }
};

/// The times of a run. They differ in every run.
struct Trade {
  Machine machine;
  std::vector<forms::Width> widths;  ///< narrowest first
  std::vector<TimedTarget> targets;
  std::vector<TimedForm> copies;  ///< the floor, by width, precision and place: copies and multiply-adds
  std::vector<TimedForm> forms;   ///< by target
  std::vector<Goal> goals;
};

/// "half", "float" or "double".
std::string precision_of(const TimedForm& timed);

/// The form with its exp2, as one name: "sg-game", "sg-game/exp2-3".
std::string full_id(const TimedForm& timed);

/// Whether two rows have the same compiled form and precision, at any place of the data.
bool is_same_kernel(const TimedForm& a, const TimedForm& b);

/// Whether two rows also have the same constants and the same place of the data.
bool is_same_way(const TimedForm& a, const TimedForm& b);

/// The same way with its data in memory, or null.
const TimedForm* in_memory(const Trade& trade, const TimedForm& timed);

/// The form by which the time of another counts: the reference of its target, scalar, of its precision and
/// place. Null if the target has no such reference.
const TimedForm* reference_of(const Trade& trade, const TimedForm& timed);

/// Computes `copies` and `pows` of each form from the times of the others.
void relate(Trade& trade);

/// The ratios that were aimed at, from the times in float with the data in the first cache. A goal with a
/// missing row counts as not reached.
std::vector<Goal> goals_of(const Trade& trade);

/// The fastest width of each form, set of constants, degree and precision of a target, if its error is known,
/// with the data in the first cache.
std::vector<TimedForm> fastest_of(const Trade& trade, const std::string& target);

/// The cost and the error of an offer; less of either is better.
struct Offer {
  double time;
  double error;
};

/// The indices of the offers that no other offer dominates, the fastest and least accurate first. Of equal
/// offers the first is kept. An offer with NaN is never on the front.
std::vector<std::size_t> front_of(const std::vector<Offer>& offers);

/// Those of some forms with errors that are on the front of time and error, the fastest first.
std::vector<TimedForm> front_among(const std::vector<TimedForm>& forms);

/// The forms among `fastest_of` on that front.
std::vector<TimedForm> front_of_target(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
