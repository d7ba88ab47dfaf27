#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/exhaustive/float_errors.hpp"
#include "reports/io/shard.hpp"

/// A test of every float that can be split over machines, stopped and resumed.
namespace shadefit::bench {

/// The floats of a shard: equal parts of the whole, to one float.
Stretch stretch_of(const Shard& shard, const Stretch& whole);

/// The identity of a sweep: results of two sweeps can be merged only if all members are equal.
struct SweepIdentity {
  std::string version;  ///< of shadefit
  std::string form;     ///< its id in the catalogue
  int exp2_degree = 0;
  std::string set;               ///< the id of the constants; empty for a form without any
  std::vector<float> constants;  ///< in the order of the formula, those of the target first
  std::string width;             ///< the instructions that it ran with
  Stretch whole = unit_floats;
  std::string device = {};  ///< the graphics device; empty: the CPU
  std::vector<double> bound_from =
      {};  ///< the errors of the device's functions, from which the bound follows
  bool operator==(const SweepIdentity&) const = default;
};

/// A running or finished sweep.
struct Sweep {
  SweepIdentity identity;
  Shard shard;
  std::uint32_t next = 0;  ///< the first untested float
  FloatErrors found = {};

  Stretch stretch() const { return stretch_of(shard, identity.whole); }
  bool is_done() const { return next >= stretch().to; }
};

/// A sweep that has not begun.
Sweep begin_sweep(const SweepIdentity& identity, const Shard& shard);

/// The floats that all threads together test between two checks for an interruption: about 50 ms on two
/// threads.
inline constexpr std::uint32_t usual_batch = 1U << 22;

/// A sweep and what it compares.
struct RunningSweep {
  Sweep* sweep;
  const FloatSubject* subject;
};

/// Tests the remaining floats of several sweeps of one stretch, batch by batch, so that they can share what a
/// batch needs. `between` is called after each batch, when the sweeps are consistent: it may save them, and
/// end the work by throwing.
void go_on_together(std::span<const RunningSweep> all, unsigned threads, const std::function<void()>& between,
                    std::uint32_t batch = usual_batch);

/// A sweep with the name of its file as in messages: "state file 'a.json'".
struct NamedSweep {
  std::string name;
  Sweep sweep;
};

/// The identity for messages.
WorkIdentity identity_in_words(const SweepIdentity& identity);

/// The name of the file of the whole: "exhaustive-sg-published-sg-offset-mean-exp2-3.json".
std::string file_of(const SweepIdentity& identity);

/// Merges the shards, at least one; the result equals that of one sweep over everything. Throws UserError
/// like `require_whole`.
Sweep merge(const std::vector<NamedSweep>& shards, const std::string& version);

}  // namespace shadefit::bench
