#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/exhaustive/float_errors.hpp"

/// A test of every float that can be split over machines, stopped and resumed.
namespace shadefit::bench {

/// A part of a sweep: number `index`, counted from 1, of all parts.
struct Shard {
  unsigned index = 1, of = 1;
  bool is_whole() const { return of == 1; }
  bool operator==(const Shard&) const = default;
};

/// "2/4". Throws UserError, naming the option, unless 1 <= i <= n.
Shard parse_shard(const std::string& text);

/// The floats of a shard: equal parts of the whole, to one float.
Stretch stretch_of(const Shard& shard, const Stretch& whole);

/// The identity of a sweep: results of two sweeps can be merged only if all members are equal.
struct SweepIdentity {
  std::string version;  ///< of shadefit
  std::string form;     ///< its id in the catalogue
  int exp2_degree = 0;
  std::vector<float> constants;  ///< in the order of the formula, those of the target first
  std::string width;             ///< the instructions that it ran with
  Stretch whole = unit_floats;
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

/// Tests the remaining floats. `between` is called after each batch, when `sweep` is consistent: it may save
/// the sweep, and end the work by throwing.
void go_on(Sweep& sweep, const FloatSubject& subject, unsigned threads, const std::function<void()>& between,
           std::uint32_t batch = usual_batch);

/// A sweep with the name of its file, for messages.
struct NamedSweep {
  std::string name;
  Sweep sweep;
};

/// Merges the shards; the result equals that of one sweep over everything. Throws UserError, naming the file,
/// unless all belong to `identity`, are finished, and occur once.
Sweep merge(const SweepIdentity& identity, const std::vector<NamedSweep>& shards);

/// Throws UserError, naming the file and the first thing that differs, unless the sweep is of that identity.
void require_identity(const NamedSweep& named, const SweepIdentity& identity);

}  // namespace shadefit::bench
