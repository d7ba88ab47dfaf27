#include "bench/exhaustive/state_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "fit/support/bounded_file.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/json_document.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"

namespace shadefit::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind_of_file = "shadefit exhaustive";

std::string pattern(std::uint32_t bits) {
  return fmt::format("0x{:08x}", bits);
}

/// Where a maximum is, for a machine and for a reader.
Json place_json(std::uint32_t at) {
  if (at == UINT32_MAX) return nullptr;
  return {{"bits", pattern(at)}, {"c", hex_text(std::bit_cast<float>(at))}};
}

[[noreturn]] void refuse(const std::string& name, const std::string& rule) {
  throw UserError(fmt::format("state file '{}' {}", name, rule));
}

/// The fields of an object, named in errors.
class Fields {
 public:
  Fields(const Json& json, std::string name) : json_(json), name_(std::move(name)) {}

  const Json& field(const char* key) const {
    if (!json_.is_object() || !json_.contains(key)) fail(key, "is missing");
    return json_.at(key);
  }
  std::string text(const char* key) const {
    if (!field(key).is_string()) fail(key, "is no text");
    return field(key).get<std::string>();
  }
  std::uint64_t count(const char* key) const { return count_of(field(key), key); }
  std::uint64_t count_of(const Json& json, const char* key) const {
    if (!json.is_number_unsigned()) fail(key, "is no count");
    return json.get<std::uint64_t>();
  }
  const Json& list(const char* key) const {
    if (!field(key).is_array()) fail(key, "is no list");
    return field(key);
  }
  float number_of(const Json& json, const char* key) const {
    const auto value = json.is_string() ? parse_hex(json.get<std::string>()) : std::nullopt;
    const bool is_float = value && std::abs(*value) <= std::numeric_limits<float>::max() &&
                          static_cast<double>(static_cast<float>(*value)) == *value;
    if (!is_float) fail(key, "is no hexadecimal float");
    return static_cast<float>(*value);
  }
  float number(const char* key) const { return number_of(field(key), key); }
  std::uint32_t pattern_of(const Json& json, const char* key) const {
    unsigned bits = 0;
    const std::string text = json.is_string() ? json.get<std::string>() : "";
    if (std::sscanf(text.c_str(), "0x%8x", &bits) != 1 || pattern(bits) != text)
      fail(key, "is no bit pattern of a float");
    return bits;
  }
  std::uint32_t place(const char* key) const {
    if (field(key).is_null()) return UINT32_MAX;
    return pattern_of(Fields(field(key), name_).field("bits"), key);
  }
  [[noreturn]] void fail(const char* key, const std::string& rule) const {
    refuse(name_, fmt::format("has a field '{}' that {}", key, rule));
  }

 private:
  const Json& json_;
  std::string name_;
};

Stretch read_stretch(const Fields& fields, const char* key) {
  const Json& ends = fields.list(key);
  if (ends.size() != 2) fields.fail(key, "is no pair");
  const Stretch stretch{fields.pattern_of(ends[0], key), fields.pattern_of(ends[1], key)};
  if (stretch.from > stretch.to) fields.fail(key, "ends before it begins");
  return stretch;
}

SweepIdentity read_identity(const Fields& fields) {
  SweepIdentity identity;
  identity.version = fields.text("version");
  identity.form = fields.text("form");
  identity.exp2_degree = static_cast<int>(fields.count("exp2_degree"));
  for (const Json& item : fields.list("constants"))
    identity.constants.push_back(fields.number_of(item, "constants"));
  identity.width = fields.text("width");
  identity.whole = read_stretch(fields, "whole");
  return identity;
}

FloatErrors read_errors(const Fields& fields) {
  FloatErrors found;
  found.max_abs_error = fields.number("max_abs_error");
  found.max_abs_error_at = fields.place("max_abs_error_at");
  found.max_ulps = static_cast<std::uint32_t>(fields.count("max_ulps"));
  found.max_ulps_at = fields.place("max_ulps_at");
  found.nans = fields.count("nans");
  found.above_one = fields.count("above_one");
  found.below_zero = fields.count("below_zero");
  const Json& ulps = fields.list("ulps");
  if (ulps.size() != found.ulps.size()) fields.fail("ulps", "has another number of bins");
  for (std::size_t i = 0; i < ulps.size(); ++i) found.ulps[i] = fields.count_of(ulps[i], "ulps");
  return found;
}

Json state_json(const Sweep& sweep) {
  const SweepIdentity& identity = sweep.identity;
  Json constants = Json::array();
  for (const float constant : identity.constants) constants.push_back(hex_text(constant));
  const FloatErrors& found = sweep.found;
  Json json{{"file", kind_of_file},
            {"schema", sweep_schema},
            {"version", identity.version},
            {"form", identity.form},
            {"exp2_degree", static_cast<unsigned>(identity.exp2_degree)},
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
  json[digest_field] = digest_of(json);
  return json;
}

}  // namespace

std::string state_text(const Sweep& sweep) {
  return state_json(sweep).dump(1) + "\n";
}

Sweep parse_state(const std::string& text, const std::string& name) {
  const Json json = parse_own_json(text, fmt::format("state file '{}'", name));
  if (!json.is_object() || !json.contains("file") || json.at("file") != kind_of_file)
    refuse(name, fmt::format("is none: its field 'file' does not say '{}'", kind_of_file));
  const Fields fields(json, name);
  if (const auto schema = fields.count("schema"); schema != sweep_schema)
    refuse(name, fmt::format("is of schema {}: this shadefit reads schema {}", schema, sweep_schema));
  if (const std::string stated = fields.text(digest_field), digest = digest_of(json); stated != digest)
    refuse(name, fmt::format("was changed: its digest is {}, that of its fields is {}", stated, digest));
  Sweep sweep;
  sweep.identity = read_identity(fields);
  const Json& shard = fields.list("shard");
  if (shard.size() != 2) fields.fail("shard", "is no pair");
  const auto index = fields.count_of(shard[0], "shard"), of = fields.count_of(shard[1], "shard");
  if (index < 1 || index > of || of > UINT32_MAX) fields.fail("shard", "is no part of a whole");
  sweep.shard = {static_cast<unsigned>(index), static_cast<unsigned>(of)};
  const Stretch done = read_stretch(fields, "done"), all = sweep.stretch();
  if (done.from != all.from || done.to > all.to) fields.fail("done", "is not of its shard");
  sweep.next = done.to;
  sweep.found = read_errors(fields);
  const auto& ulps = sweep.found.ulps;
  const auto is_possible = [&](std::uint64_t count) { return count <= done.size(); };
  if (!is_possible(sweep.found.nans) || !std::all_of(ulps.begin(), ulps.end(), is_possible) ||
      sweep.found.count() != done.size())
    fields.fail("ulps", "has not as many counts as floats are done");
  Json written = state_json(sweep);
  written[digest_field] = json.at(digest_field);
  if (const std::string key = first_difference(json, written); !key.empty())
    refuse(name, fmt::format("has a field '{}' that shadefit does not write, or not so", key));
  return sweep;
}

void keep_state(const std::filesystem::path& path, const Sweep& sweep) {
  const auto directory = path.parent_path();
  write_files(directory.empty() ? "." : directory, {{path.filename().string(), state_text(sweep)}});
}

NamedSweep read_state(const std::filesystem::path& path) {
  return {path.string(), parse_state(read_bounded(path, most_state_bytes), path.string())};
}

}  // namespace shadefit::bench
