#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lint/tree/ignore_rules.hpp"

namespace {

using shadefit::lint::IgnoreVerdict;
using shadefit::lint::parse_ignore_rules;

IgnoreVerdict said(const std::string& rules, const std::string& path, bool is_folder) {
  return verdict(parse_ignore_rules(rules), path, is_folder);
}

/// A rule for one path, each byte taken as it is.
std::string rule_for(const std::string& path) {
  std::string rule = "/";
  for (const char c : path) rule += {'\\', c};
  return rule + "\n";
}

bool is_path(const std::string& text) {
  // A carriage return at the end of a line belongs to its end.
  return !text.empty() && text.back() != '\r' && text.size() < 1000 && text.front() != '/' &&
         text.back() != '/' && text.find('\0') == std::string::npos;
}

}  // namespace

// One input is a path in its first line, and the text of a .gitignore. No text is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string whole(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(whole.find('\n'), size);
  const std::string path = whole.substr(0, end), rules = whole.substr(std::min(end + 1, size));
  for (const bool is_folder : {false, true}) said(rules, path, is_folder);
  if (!is_path(path)) return 0;
  // Behind all other rules, one that names the path decides, and so does one that takes it back.
  const std::string named = rules + "\n" + rule_for(path);
  if (said(named, path, false) != IgnoreVerdict::ignored) std::abort();
  if (said(named + "!" + rule_for(path), path, true) != IgnoreVerdict::kept) std::abort();
  if (said(named + "**/*\n", path, false) != IgnoreVerdict::ignored) std::abort();
  return 0;
}
