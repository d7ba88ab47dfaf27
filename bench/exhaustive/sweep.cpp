#include "bench/exhaustive/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fit/support/hex_float.hpp"
#include "reports/io/joined.hpp"

namespace shadefit::bench {
namespace {

std::string text(const Stretch& stretch) {
  return fmt::format("0x{:08x}:0x{:08x}", stretch.from, stretch.to);
}

template <class Number>
std::string text(const std::vector<Number>& numbers) {
  return "(" + joined(numbers, ", ", hex_text) + ")";
}

}  // namespace

Stretch stretch_of(const Shard& shard, const Stretch& whole) {
  const auto end_of = [&](std::uint64_t part) {
    return whole.from + static_cast<std::uint32_t>(whole.size() * part / shard.of);
  };
  return {end_of(shard.index - 1), end_of(shard.index)};
}

Sweep begin_sweep(const SweepIdentity& identity, const Shard& shard) {
  return {identity, shard, stretch_of(shard, identity.whole).from, {}};
}

void go_on_together(std::span<const RunningSweep> all, unsigned threads, const std::function<void()>& between,
                    std::uint32_t batch) {
  const std::uint32_t end = all.front().sweep->stretch().to;
  for (;;) {
    // The sweeps that are behind catch up first.
    std::uint32_t from = end, to = end;
    for (const RunningSweep& one : all) from = std::min(from, one.sweep->next);
    if (from == end) return;
    for (const RunningSweep& one : all)
      if (one.sweep->next > from) to = std::min(to, one.sweep->next);
    to = static_cast<std::uint32_t>(std::min<std::uint64_t>(to, std::uint64_t{from} + batch));
    for (const RunningSweep& one : all) {
      if (one.sweep->next != from) continue;
      include(one.sweep->found, errors_on(*one.subject, Stretch{from, to}, threads));
      one.sweep->next = to;
    }
    between();
  }
}

WorkIdentity identity_in_words(const SweepIdentity& identity) {
  return {{version_field, identity.version},
          {"form", identity.form},
          {"degree of exp2", fmt::to_string(identity.exp2_degree)},
          {"set of constants", identity.set + " " + text(identity.constants)},
          {"width", identity.width},
          {"device", identity.device.empty() ? "none" : identity.device},
          {"bound from", text(identity.bound_from)},
          {"range", text(identity.whole)}};
}

std::string file_of(const SweepIdentity& identity) {
  return fmt::format("exhaustive-{}{}{}{}.json", identity.form,
                     identity.set.empty() ? "" : "-" + identity.set,
                     identity.exp2_degree > 0 ? fmt::format("-exp2-{}", identity.exp2_degree) : "",
                     identity.device.empty() ? "" : "-vulkan");
}

Sweep merge(const std::vector<NamedSweep>& shards, const std::string& version) {
  std::vector<Part> parts;
  for (const auto& [name, sweep] : shards)
    parts.push_back({name, identity_in_words(sweep.identity), sweep.shard, sweep.is_done()});
  require_whole(parts, version);
  Sweep whole = begin_sweep(shards.front().sweep.identity, {});
  for (const NamedSweep& shard : shards) include(whole.found, shard.sweep.found);
  whole.next = whole.identity.whole.to;
  return whole;
}

}  // namespace shadefit::bench
