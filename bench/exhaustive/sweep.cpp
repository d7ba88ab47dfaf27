#include "bench/exhaustive/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::bench {
namespace {

std::optional<unsigned> whole_number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string text(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.of);
}

std::string text(const Stretch& stretch) {
  return fmt::format("0x{:08x}:0x{:08x}", stretch.from, stretch.to);
}

std::string text(const std::vector<float>& constants) {
  std::vector<std::string> parts;
  for (const float constant : constants) parts.push_back(hex_text(constant));
  return fmt::format("({})", fmt::join(parts, ", "));
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = whole_number(std::string_view(text).substr(0, slash));
    const auto of = whole_number(std::string_view(text).substr(slash + 1));
    if (index && of && 1 <= *index && *index <= *of) return {*index, *of};
  }
  throw UserError(
      fmt::format("--shard '{}' is not a part of a whole: it must be i/n with 1 <= i <= n", text));
}

Stretch stretch_of(const Shard& shard, const Stretch& whole) {
  const auto end_of = [&](std::uint64_t part) {
    return whole.from + static_cast<std::uint32_t>(whole.size() * part / shard.of);
  };
  return {end_of(shard.index - 1), end_of(shard.index)};
}

Sweep begin_sweep(const SweepIdentity& identity, const Shard& shard) {
  return {identity, shard, stretch_of(shard, identity.whole).from, {}};
}

void go_on(Sweep& sweep, const FloatSubject& subject, unsigned threads, const std::function<void()>& between,
           std::uint32_t batch) {
  const std::uint32_t end = sweep.stretch().to;
  while (sweep.next < end) {
    const auto to =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(end, std::uint64_t{sweep.next} + batch));
    include(sweep.found, errors_on(subject, Stretch{sweep.next, to}, threads));
    sweep.next = to;
    between();
  }
}

void require_identity(const NamedSweep& named, const SweepIdentity& identity) {
  const SweepIdentity& its = named.sweep.identity;
  const auto require_equal = [&](const char* what, const std::string& found, const std::string& wanted) {
    if (found == wanted) return;
    throw UserError(fmt::format("state file '{}' is of another {}: {}, not {}; name another by --state",
                                named.name, what, found, wanted));
  };
  require_equal("version", its.version, identity.version);
  require_equal("form", its.form, identity.form);
  require_equal("degree of exp2", fmt::to_string(its.exp2_degree), fmt::to_string(identity.exp2_degree));
  require_equal("set of constants", text(its.constants), text(identity.constants));
  require_equal("width", its.width, identity.width);
  require_equal("range", text(its.whole), text(identity.whole));
}

Sweep merge(const SweepIdentity& identity, const std::vector<NamedSweep>& shards) {
  if (shards.empty()) throw UserError("--merge has no files: name the state files of all shards");
  const unsigned of = shards.front().sweep.shard.of;
  std::map<unsigned, std::string> names;
  Sweep whole = begin_sweep(identity, {});
  for (const NamedSweep& named : shards) {
    require_identity(named, identity);
    const Shard& shard = named.sweep.shard;
    if (shard.of != of) {
      throw UserError(fmt::format("state file '{}' is shard {}, '{}' one of {}: all must be of one whole",
                                  named.name, text(shard), shards.front().name, of));
    }
    if (!named.sweep.is_done()) {
      throw UserError(
          fmt::format("state file '{}', shard {}, is not finished: its own command goes on with it",
                      named.name, text(shard)));
    }
    const auto [place, is_new] = names.emplace(shard.index, named.name);
    if (!is_new) {
      throw UserError(fmt::format("state file '{}' is shard {}, which '{}' is already", named.name,
                                  text(shard), place->second));
    }
    include(whole.found, named.sweep.found);
  }
  for (unsigned index = 1; index <= of; ++index) {
    if (!names.contains(index)) throw UserError(fmt::format("--merge: shard {}/{} is missing", index, of));
  }
  whole.next = identity.whole.to;
  return whole;
}

}  // namespace shadefit::bench
