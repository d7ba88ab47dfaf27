#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/forms/kernel.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/statistics.hpp"

/// Run time against error: what was measured of every form, and what follows from it.
namespace shadefit::bench {

/// Where the arrays are that a form reads and writes.
enum class Place {
  first_cache,  ///< both at once in the smallest cache
  memory,       ///< in arrays far larger than the last one
};

/// "L1", "memory".
std::string name(Place place);

/// One way of one target: which form, how compiled, where its data were; and how long it took.
struct TimedForm {
  std::string target;         ///< its id
  std::string form;           ///< its id
  std::string constants;      ///< the id of its set of constants, on which times do not depend
  std::string label;          ///< a few words for pictures and sentences
  int exp2_degree = 0;        ///< of the polynomial in its exp2; 0: the library's, or none
  bool is_reference = false;  ///< the target's own formula by the library's pow, exp2, sqrt ..
  bool is_double = false;
  forms::Width width = forms::Width::scalar;
  Place place = Place::first_cache;
  Spread ns = {};                       ///< per element
  std::vector<double> real, cpu;        ///< ns per element of every round
  long elements = 0;                    ///< that each of these is a mean of
  std::optional<double> max_abs_error;  ///< in its precision
  std::optional<double> copies;         ///< its time in those of copying the same array
  std::optional<double> pows;  ///< the time of the scalar reference in its own: how much faster it is
};

/// What a form approximates, and how a report heads it.
struct TimedTarget {
  std::string id;
  std::string title;
};

/// A ratio that was aimed at, and what came out.
struct Goal {
  std::string what;
  double wanted;
  bool at_most;  ///< else at least
  std::optional<double> reached;
  bool is_met() const { return reached && (at_most ? *reached <= wanted : *reached >= wanted); }
};

/// Times of a run. Nothing in it is the same twice.
struct Trade {
  Machine machine;
  std::vector<forms::Width> widths;  ///< narrowest first
  std::vector<TimedTarget> targets;
  std::vector<TimedForm> copies;  ///< the floor, by width, precision and place
  std::vector<TimedForm> forms;   ///< by target
  std::vector<Goal> goals;
};

/// The form with its exp2, as one name: "sg-game", "sg-game/exp2-3".
std::string full_id(const TimedForm& timed);

/// Whether two rows are of one compiled form in one precision, wherever its data are.
bool is_same_kernel(const TimedForm& a, const TimedForm& b);

/// Whether they are of one set of constants, besides, and one place of their data.
bool is_same_way(const TimedForm& a, const TimedForm& b);

/// The same way with its data in memory, or null.
const TimedForm* in_memory(const Trade& trade, const TimedForm& timed);

/// Of the times of a form, its `copies` and its `pows`, from the rest of them.
void relate(Trade& trade);

/// Of each form, set of constants, degree and precision of a target that has an error, its data in the first
/// cache: the fastest width.
std::vector<TimedForm> fastest_of(const Trade& trade, const std::string& target);

/// Those of them that no other beats in time or error, the fastest first.
std::vector<TimedForm> front_of_target(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
