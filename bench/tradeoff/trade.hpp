#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/tradeoff/machine.hpp"
#include "bench/tradeoff/statistics.hpp"

/// Run time against error: the measurements of every form, and derived values.
namespace shadefit::bench {

/// A form with one set of its constants, its time and its error.
struct TimedForm {
  std::string target = {};     ///< its id; empty for what there is to compare with: a multiply-add ..
  std::string form = {};       ///< its id
  std::string constants = {};  ///< the id of its set of constants
  std::string label = {};      ///< a few words for tables
  int exp2_degree = 0;         ///< of the polynomial in its exp2; 0: the library's, or none
  bool is_reference = false;   ///< the target's own formula
  bool is_half = false;        ///< else float
  std::optional<double> max_abs_error = {};
  Spread ns = {};                            ///< per element
  std::optional<double> multiply_adds = {};  ///< its time in that of a multiply-add in float
  std::optional<double> speed_up = {};       ///< the time of its target's own formula in its own
  // On a graphics device: of an evaluation that waits for the one before.
  std::optional<double> dependent_ns = {};
  std::optional<double> dependent_multiply_adds = {};  ///< in multiply-adds that wait for each other
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
  bool shows_all_sets =
      true;  ///< the tables show each set of constants of a form; else the one of least error
  std::vector<TimedTarget> targets = {};
  std::vector<TimedForm> forms = {};  ///< by target; first, without one, a multiply-add
};

/// "half" or "float".
std::string precision_of(const TimedForm& timed);

/// The form with its exp2, as one name: "sg", "sg/exp2-3".
std::string full_id(const TimedForm& timed);

/// Computes `speed_up` of each form from the times of the others.
void relate(Trade& trade);

/// The forms of a target that its table shows, the fastest first.
std::vector<TimedForm> shown_forms(const Trade& trade, const std::string& target);

/// The cost and the error of an offer; less of either is better.
struct Offer {
  double time;
  double error;
};

/// The indices of the offers that no other offer dominates, the fastest and least accurate first. Of equal
/// offers the first is kept. An offer with NaN is never on the front.
std::vector<std::size_t> front_of(const std::vector<Offer>& offers);

/// The places of the forms that no other of them beats in both time and error. A form without an error is
/// never among them.
std::vector<std::size_t> front_among(const std::vector<TimedForm>& forms);

}  // namespace shadefit::bench
