#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/exhaustive/float_errors.hpp"

/// A look at every float that may be spread over machines, stopped and gone on with.
namespace shadefit::bench {

/// A part of a whole: the index-th of so many, counted from 1.
struct Shard {
  unsigned index = 1, of = 1;
  bool is_whole() const { return of == 1; }
  bool operator==(const Shard&) const = default;
};

/// "2/4". Throws UserError, naming the option, unless 1 <= i <= n.
Shard parse_shard(const std::string& text);

/// The floats of a shard: equal parts of the whole, to one float.
Stretch stretch_of(const Shard& shard, const Stretch& whole);

/// What is being looked at: results of two sweeps belong together only where all of this is equal.
struct SweepIdentity {
  std::string version;  ///< of shadefit
  std::string form;     ///< its id in the catalogue
  int exp2_degree = 0;
  std::vector<float> constants;  ///< in the order of the formula, those of the target first
  std::string width;             ///< whose instructions it ran with
  Stretch whole = unit_floats;
  bool operator==(const SweepIdentity&) const = default;
};

/// A sweep under way, or done.
struct Sweep {
  SweepIdentity identity;
  Shard shard;
  std::uint32_t next = 0;  ///< the first float that was not looked at
  FloatErrors found = {};

  Stretch stretch() const { return stretch_of(shard, identity.whole); }
  bool is_done() const { return next >= stretch().to; }
};

/// One that has not begun.
Sweep begin_sweep(const SweepIdentity& identity, const Shard& shard);

/// Floats that all threads together look at before anybody may interrupt: some 50 ms on two.
inline constexpr std::uint32_t usual_batch = 1U << 22;

/// Looks at the floats that are left. `between` is called after each batch, when `sweep` is in order: it may
/// keep it, and end the work by throwing.
void go_on(Sweep& sweep, const FloatSubject& subject, unsigned threads, const std::function<void()>& between,
           std::uint32_t batch = usual_batch);

/// A sweep as it was read, and where: the name is for messages.
struct NamedSweep {
  std::string name;
  Sweep sweep;
};

/// The shards as the whole that they are of, the same as one sweep over all of it. Throws UserError, naming
/// the file, unless all are of `identity`, finished, and each is there once.
Sweep merge(const SweepIdentity& identity, const std::vector<NamedSweep>& shards);

/// Throws UserError, naming the file and the first thing that differs, unless the sweep is of that identity.
void require_identity(const NamedSweep& named, const SweepIdentity& identity);

}  // namespace shadefit::bench
