#include "fit/ledger/told.hpp"

#include <algorithm>
#include <stdexcept>

#include "fit/formula/parse_formula.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

class Sentence {
 public:
  Sentence(const Claim& claim, const std::vector<Told>& found) : claim_(claim), found_(found) {}

  /// What stands for a hole.
  std::string filled(std::string_view hole) const {
    if (const auto at = hole.find('#'); at != std::string_view::npos)
      return counted(std::ssize(parse_sweep(given_text(hole.substr(0, at)))), hole.substr(at + 1));
    if (const auto at = hole.rfind(":."); at != std::string_view::npos)
      return fmt::format(fmt::runtime(fmt::format("{{{}}}", hole.substr(at))), value(hole.substr(0, at)));
    const auto* found = find(hole);
    if (found == nullptr) return std::string(given_text(hole));
    const auto* words = std::get_if<std::string>(&found->value);
    return words != nullptr ? *words : to_text(std::get<double>(found->value));
  }

 private:
  const Told* find(std::string_view name) const {
    const auto found = std::ranges::find(found_, name, &Told::name);
    return found == found_.end() ? nullptr : &*found;
  }

  std::string_view given_text(std::string_view name) const {
    for (const Quantities* quantities : {&claim_.inputs, &claim_.printed}) {
      for (std::size_t i = 0; i < quantities->size(); ++i) {
        std::string given((*quantities)[i].name);
        std::ranges::replace(given, ' ', '_');
        if (given == name || (quantities == &claim_.printed && fmt::format("printed_{}", i) == name))
          return (*quantities)[i].value;
      }
    }
    throw std::logic_error(fmt::format("{} tells of '{}', which nothing gives", claim_.id, name));
  }

  double number(std::string_view name) const {
    if (const auto* found = find(name)) return std::get<double>(found->value);
    for (const std::string_view end : {"_first", "_last"}) {
      if (!name.ends_with(end)) continue;
      const auto sweep = parse_sweep(given_text(name.substr(0, name.size() - end.size())));
      return end == "_first" ? sweep.front() : sweep.back();
    }
    return number_of(given_text(name));
  }

  double value(std::string_view formula) const {
    return evaluate<double>(read_formula(formula, {.variables = {}, .takes_parameters = true}).formula,
                            [&](const std::string& name) { return number(name); });
  }

  const Claim& claim_;
  const std::vector<Told>& found_;
};

std::string filled(std::string_view text, const Sentence& sentence) {
  std::string out;
  while (true) {
    const auto open = text.find('{'), close = text.find('}');
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    out += sentence.filled(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

}  // namespace

Finding told_of(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
                std::vector<Told> found) {
  found.emplace_back("identity", verdict == Verdict::confirmed ? "identity" : "no identity");
  const Sentence sentence(claim, found);
  return {verdict, filled(claim.computed, sentence), filled(claim.evidence, sentence), effect};
}

}  // namespace shadefit
