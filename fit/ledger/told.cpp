#include "fit/ledger/told.hpp"

#include <algorithm>
#include <stdexcept>

#include "fit/formula/parse_formula.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// What stands for a hole.
std::string filled_hole(std::string_view hole, const Claim& claim, const Holes& holes) {
  if (const auto at = hole.find('#'); at != std::string_view::npos)
    return counted(std::ssize(parse_sweep(given_text(claim, hole.substr(0, at)))), hole.substr(at + 1));
  if (const auto at = hole.rfind(":."); at != std::string_view::npos)
    return fmt::format(fmt::runtime(fmt::format("{{{}}}", hole.substr(at))), holes.value(hole.substr(0, at)));
  const auto words = holes.words(std::string(hole));
  return words ? *words : std::string(given_text(claim, hole));
}

}  // namespace

std::string_view given_text(const Claim& claim, std::string_view name) {
  for (const auto& [kind, quantities] : {std::pair{"input", &claim.inputs}, {"printed", &claim.printed}}) {
    for (std::size_t i = 0; i < quantities->size(); ++i) {
      std::string given((*quantities)[i].name);
      std::ranges::replace(given, ' ', '_');
      if (given == name || fmt::format("{}_{}", kind, i) == name) return (*quantities)[i].value;
    }
  }
  throw std::logic_error(fmt::format("{} tells of '{}', which nothing gives", claim.id, name));
}

double given_number(const Claim& claim, std::string_view name) {
  for (const std::string_view end : {"_first", "_last"}) {
    if (!name.ends_with(end)) continue;
    const auto sweep = parse_sweep(given_text(claim, name.substr(0, name.size() - end.size())));
    return end == "_first" ? sweep.front() : sweep.back();
  }
  return number_of(given_text(claim, name));
}

std::string filled(std::string_view text, const Claim& claim, const Holes& holes) {
  std::string out;
  while (true) {
    const auto open = text.find('{'), close = text.find('}');
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    out += filled_hole(text.substr(open + 1, close - open - 1), claim, holes);
    text.remove_prefix(close + 1);
  }
}

Finding told_of(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
                std::vector<Told> found) {
  found.emplace_back("identity", verdict == Verdict::confirmed ? "identity" : "no identity");
  const auto find = [&](const std::string& name) {
    const auto told = std::ranges::find(found, name, &Told::name);
    return told == found.end() ? nullptr : &told->value;
  };
  const Holes holes{[&](const std::string& name) -> std::optional<std::string> {
                      const auto* value = find(name);
                      if (value == nullptr) return std::nullopt;
                      const auto* words = std::get_if<std::string>(value);
                      return words != nullptr ? *words : to_text(std::get<double>(*value));
                    },
                    [&](std::string_view formula) {
                      return evaluate<double>(
                          read_formula(formula, {.variables = {}, .takes_parameters = true}).formula,
                          [&](const std::string& name) {
                            const auto* value = find(name);
                            return value != nullptr ? std::get<double>(*value) : given_number(claim, name);
                          });
                    }};
  return {verdict, filled(claim.computed, claim, holes), filled(claim.evidence, claim, holes), effect};
}

}  // namespace shadefit
