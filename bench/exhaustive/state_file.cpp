#include "bench/exhaustive/state_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "fit/support/bounded_file.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/json_document.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/output.hpp"
#include "reports/io/own_fields.hpp"

namespace shadefit::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string pattern(std::uint32_t bits) {
  return fmt::format("0x{:08x}", bits);
}

/// The place of a maximum, as a bit pattern and as a number for readers.
Json place_json(std::uint32_t at) {
  if (at == UINT32_MAX) return nullptr;
  return {{"bits", pattern(at)}, {"c", hex_text(std::bit_cast<float>(at))}};
}

std::uint32_t pattern_of(const OwnFields& fields, const Json& json, const char* key) {
  unsigned bits = 0;
  const std::string text = fields.text_of(json, key);
  if (std::sscanf(text.c_str(), "0x%8x", &bits) != 1 || pattern(bits) != text)
    fields.fail(key, "is not the bit pattern of a float");
  return bits;
}

std::uint32_t place_of(const OwnFields& fields, const char* key) {
  if (fields.field(key).is_null()) return UINT32_MAX;
  return pattern_of(fields, fields.inner(key).field("bits"), key);
}

/// A number that would be rounded is refused by the comparison of the state with its own text.
float float_of(const OwnFields& fields, const Json& json, const char* key) {
  const double value = fields.number_of(json, key);
  if (std::abs(value) > std::numeric_limits<float>::max()) fields.fail(key, "is too large for a float");
  return static_cast<float>(value);
}

Stretch read_stretch(const OwnFields& fields, const char* key) {
  const Json& ends = fields.pair(key);
  const Stretch stretch{pattern_of(fields, ends[0], key), pattern_of(fields, ends[1], key)};
  if (stretch.from > stretch.to) fields.fail(key, "ends before it begins");
  return stretch;
}

SweepIdentity read_identity(const OwnFields& fields) {
  SweepIdentity identity;
  identity.version = fields.text("version");
  identity.form = fields.text("form");
  identity.exp2_degree = fields.whole<int>("exp2_degree");
  identity.set = fields.text("set");
  for (const Json& item : fields.list("constants"))
    identity.constants.push_back(float_of(fields, item, "constants"));
  identity.width = fields.text("width");
  identity.whole = read_stretch(fields, "whole");
  if (!fields.has("device")) return identity;
  identity.device = fields.text("device");
  identity.bound_from = fields.numbers("bound_from");
  return identity;
}

FloatErrors read_errors(const OwnFields& fields) {
  FloatErrors found;
  found.max_abs_error = float_of(fields, fields.field("max_abs_error"), "max_abs_error");
  found.max_abs_error_at = place_of(fields, "max_abs_error_at");
  found.max_ulps = fields.whole<std::uint32_t>("max_ulps");
  found.max_ulps_at = place_of(fields, "max_ulps_at");
  found.nans = fields.whole<std::uint64_t>("nans");
  found.above_one = fields.whole<std::uint64_t>("above_one");
  found.below_zero = fields.whole<std::uint64_t>("below_zero");
  const Json& ulps = fields.list("ulps");
  if (ulps.size() != found.ulps.size()) fields.fail("ulps", "has another number of bins");
  for (std::size_t i = 0; i < ulps.size(); ++i)
    found.ulps[i] = fields.whole_of<std::uint64_t>(ulps[i], "ulps");
  if (!fields.has("device")) return found;
  found.beyond = fields.whole<std::uint64_t>("beyond");
  const Json& places = fields.list("beyond_at");
  if (places.size() > found.beyond_at.size()) fields.fail("beyond_at", "has too many places");
  for (std::size_t i = 0; i < places.size(); ++i)
    found.beyond_at[i] = pattern_of(fields, places[i], "beyond_at");
  if (!std::is_sorted(found.beyond_at.begin(), found.beyond_at.end()))
    fields.fail("beyond_at", "is not in order");
  return found;
}

/// What only a sweep on a graphics device has.
void add_device(Json& json, const Sweep& sweep) {
  Json errors = Json::array(), places = Json::array();
  for (const double error : sweep.identity.bound_from) errors.push_back(hex_text(error));
  for (const std::uint32_t at : sweep.found.beyond_at) {
    if (at != UINT32_MAX) places.push_back(pattern(at));
  }
  json["device"] = sweep.identity.device;
  json["bound_from"] = errors;
  json["beyond"] = sweep.found.beyond;
  json["beyond_at"] = places;
}

Json state_json(const Sweep& sweep) {
  const SweepIdentity& identity = sweep.identity;
  Json constants = Json::array();
  for (const float constant : identity.constants) constants.push_back(hex_text(constant));
  const FloatErrors& found = sweep.found;
  Json json{{"file", sweep_kind},
            {"schema", sweep_schema},
            {"version", identity.version},
            {"form", identity.form},
            {"exp2_degree", static_cast<unsigned>(identity.exp2_degree)},
            {"set", identity.set},
            {"constants", constants},
            {"width", identity.width},
            {"whole", {pattern(identity.whole.from), pattern(identity.whole.to)}},
            {"shard", {sweep.shard.index, sweep.shard.of}},
            {"done", {pattern(sweep.stretch().from), pattern(sweep.next)}},
            {"max_abs_error", hex_text(found.max_abs_error)},
            {"max_abs_error_at", place_json(found.max_abs_error_at)},
            {"max_ulps", found.max_ulps},
            {"max_ulps_at", place_json(found.max_ulps_at)},
            {"ulps", found.ulps},
            {"nans", found.nans},
            {"above_one", found.above_one},
            {"below_zero", found.below_zero}};
  if (!identity.device.empty()) add_device(json, sweep);
  json[digest_field] = digest_of(json);
  return json;
}

}  // namespace

std::string state_text(const Sweep& sweep) {
  return state_json(sweep).dump(1) + "\n";
}

Sweep parse_state(const std::string& text, const std::string& name) {
  const Json json = parse_own_json(text, name);
  const OwnFields fields(json, name);
  fields.require_kind(sweep_kind, sweep_schema);
  fields.require_digest();
  Sweep sweep;
  sweep.identity = read_identity(fields);
  sweep.shard = read_shard(fields);
  const Stretch done = read_stretch(fields, "done"), all = sweep.stretch();
  if (done.from != all.from || done.to > all.to) fields.fail("done", "is not of its shard");
  sweep.next = done.to;
  sweep.found = read_errors(fields);
  const auto& ulps = sweep.found.ulps;
  const auto is_possible = [&](std::uint64_t count) { return count <= done.size(); };
  if (!is_possible(sweep.found.nans) || !is_possible(sweep.found.beyond) ||
      !std::all_of(ulps.begin(), ulps.end(), is_possible) || sweep.found.count() != done.size())
    fields.fail("ulps", "has counts that do not add up to the tested floats");
  fields.require_written_as(state_json(sweep));
  return sweep;
}

void keep_state(const std::filesystem::path& path, const Sweep& sweep) {
  const auto directory = path.parent_path();
  write_files(directory.empty() ? "." : directory, {{path.filename().string(), state_text(sweep)}});
}

NamedSweep read_state(const std::filesystem::path& path) {
  std::string name = fmt::format("state file '{}'", path.string());
  Sweep sweep = parse_state(read_bounded(path, most_state_bytes), name);
  return {std::move(name), std::move(sweep)};
}

}  // namespace shadefit::bench
