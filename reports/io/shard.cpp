#include "reports/io/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

std::optional<unsigned> number_of_parts(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = number_of_parts(std::string_view(text).substr(0, slash));
    const auto of = number_of_parts(std::string_view(text).substr(slash + 1));
    if (index && of && 1 <= *index && *index <= *of) return {*index, *of};
  }
  throw UserError(
      fmt::format("--shard '{}' is not a part of a whole: it must be i/n with 1 <= i <= n", text));
}

std::string text_of(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.of);
}

Shard read_shard(const OwnFields& fields) {
  const auto& numbers = fields.pair("shard");
  const Shard shard{fields.whole_of<unsigned>(numbers[0], "shard"),
                    fields.whole_of<unsigned>(numbers[1], "shard")};
  if (shard.index < 1 || shard.index > shard.of) fields.fail("shard", "is not i, n with 1 <= i <= n");
  return shard;
}

std::string difference(const WorkIdentity& found, const WorkIdentity& wanted) {
  for (std::size_t i = 0; i < std::max(found.size(), wanted.size()); ++i) {
    const auto value = [i](const WorkIdentity& of) { return i < of.size() ? of[i].second : "none"; };
    const std::string is = value(found), should_be = value(wanted);
    if (is != should_be)
      return fmt::format("another {}: {}, not {}", (i < wanted.size() ? wanted : found)[i].first, is,
                         should_be);
  }
  return "";
}

void require_whole(const std::vector<Part>& parts, const std::string& version) {
  const Part& first = parts.front();
  WorkIdentity wanted = first.identity;
  for (auto& [name, value] : wanted)
    if (name == version_field) value = version;
  std::map<unsigned, std::string> files;
  for (const Part& part : parts) {
    if (const std::string other = difference(part.identity, wanted); !other.empty())
      throw UserError(fmt::format("{} is of {}", part.file, other));
    const std::string shard = text_of(part.shard);
    if (part.shard.of != first.shard.of)
      throw UserError(fmt::format("{} is shard {}, {} one of {}: all parts must come from the same command",
                                  part.file, shard, first.file, first.shard.of));
    if (!part.is_done)
      throw UserError(
          fmt::format("{}, shard {}, is not finished: its own command goes on with it", part.file, shard));
    const auto [place, is_new] = files.emplace(part.shard.index, part.file);
    if (!is_new)
      throw UserError(fmt::format("{} is shard {}, which {} is already", part.file, shard, place->second));
  }
  for (unsigned index = 1; index <= first.shard.of; ++index)
    if (!files.contains(index))
      throw UserError(fmt::format("shard {} is missing", text_of({index, first.shard.of})));
}

}  // namespace shadefit
