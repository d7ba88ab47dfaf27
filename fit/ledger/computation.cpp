#include "fit/ledger/computation.hpp"

#include "fit/ledger/claim_searches.hpp"
#include "fit/ledger/where.hpp"

namespace shadefit {
namespace {

/// A number as the fraction with the smallest denominator up to 4096 that equals it to 1e-12; else as a
/// decimal.
std::string fraction(double value) {
  for (int denominator = 1; denominator <= 4096; ++denominator) {
    const double numerator = std::round(value * denominator);
    if (std::abs(numerator / denominator - value) <= 1e-12)
      return fmt::format("{:.6g}{}", numerator, denominator == 1 ? "" : fmt::format("/{}", denominator));
  }
  return decimal(value, 6);
}

/// T is the scalar of all numbers: double, or Decimal50.
template <class T>
class Computation {
 public:
  using Line = Instructions::Line;

  explicit Computation(const Claim& claim, const std::vector<Told>& found = {})
      : claim_(claim), numbers_(claim) {
    for (const auto& [name, value] : found) {
      const auto* number = std::get_if<double>(&value);
      if (number != nullptr) numbers_.give(name, *number);
      words_[std::string(name)] = number != nullptr ? to_text(*number) : std::get<std::string>(value);
    }
  }

  Finding finding() {
    std::vector<std::optional<Verdict>> verdicts;
    for (const std::string_view line : claim_.instructions.verdicts) {
      verdicts.push_back(verdict(line));
      words_[fmt::format("verdict_{}", verdicts.size() - 1)] =
          verdicts.back() ? name(*verdicts.back()) : "undecided";
    }
    const auto judged = worst(verdicts);
    std::vector<std::string> effects;
    for (const Line& line : claim_.instructions.effects) effects.push_back(effect(line));
    return told(judged, sentences(effects));
  }

  Finding told(std::optional<Verdict> verdict, const std::string& effect) {
    words_["identity"] = verdict == Verdict::confirmed ? "identity" : "no identity";
    return {verdict, text(claim_.computed), text(claim_.evidence), effect};
  }

 private:
  double rounded(std::string_view formula) { return numbers_.rounded(formula); }
  std::string as_text(const T& number) { return to_text(static_cast<double>(number)); }

  /// A text with its holes filled: fit/ledger/told.hpp.
  std::string text(std::string_view with_holes) {
    std::string out;
    while (true) {
      const auto open = with_holes.find('{'), close = with_holes.find('}');
      out += with_holes.substr(0, open);
      if (open == std::string_view::npos) return out;
      out += filled(with_holes.substr(open + 1, close - open - 1));
      with_holes.remove_prefix(close + 1);
    }
  }

  std::string filled(std::string_view hole) {
    if (const auto at = hole.find('#'); at != std::string_view::npos)
      return counted(std::ssize(parse_sweep(given_text(claim_, hole.substr(0, at)))), hole.substr(at + 1));
    if (const auto at = hole.rfind(":."); at != std::string_view::npos)
      return fmt::format(fmt::runtime(fmt::format("{{{}}}", hole.substr(at))), rounded(hole.substr(0, at)));
    const auto found = words(std::string(hole));
    return found ? *found : std::string(given_text(claim_, hole));
  }

  std::optional<std::string> words(const std::string& name) {
    if (const auto found = words_.find(name); found != words_.end()) return found->second;
    if (const auto* bound = numbers_.bound(name)) return as_text(bound->value);
    if (name.ends_with("_name")) {
      if (const auto* bound = numbers_.bound(name.substr(0, name.size() - 5))) return bound->text;
    }
    const Line* line = numbers_.line_of(name);
    if (line == nullptr) return std::nullopt;
    return numbers_.by_definition(*line, [&] { return words_of(*line); });
  }

  std::string words_of(const Line& line) {
    const std::string_view kind = line.at(1);
    if (kind == "if") return text(line.at(numbers_.holds(line.at(2)) ? 3 : 4));
    if (kind == "text") return text(line.at(2));
    if (kind == "judged") return std::string(name(verdict(line.at(2)).value()));
    if (kind == "runs") return runs(line.at(2), line.at(3));
    if (kind == "ranges") return ranges(line.at(2), line.at(3));
    if (kind == "fraction") return fraction(rounded(line.at(2)));
    if (kind != "list") return as_text(numbers_.number(std::string(line.at(0))));
    std::vector<std::string> items;
    numbers_.at(line.at(2), [&] { items.push_back(text(line.at(3))); });
    std::erase(items, "");
    return line.size() > 4 ? fmt::format("{}", fmt::join(items, line.at(4))) : enumerated(items);
  }

  /// "0 to 1 and 250 to 255".
  std::string runs(std::string_view places, std::string_view condition) {
    const std::string_view variable = places.substr(0, places.find(' '));
    std::vector<std::string> runs;
    int before = -2, first = 0;
    numbers_.at(places, [&] {
      if (!numbers_.holds(condition)) return;
      const int place = static_cast<int>(numbers_.bound(variable)->value);
      if (place != before + 1) {
        first = place;
        runs.emplace_back();
      }
      before = place;
      runs.back() = fmt::format("{}{}", first, place > first ? fmt::format(" to {}", place) : "");
    });
    return runs.empty() ? "none" : enumerated(runs);
  }

  /// "from c = 0.5 to 1".
  std::string ranges(std::string_view variable, std::string_view formula) {
    std::vector<double> places = search_points();
    places.insert(places.begin(), 0);
    places.push_back(1);
    return ranges_in_words(where_positive(numbers_.function(variable, std::string(formula)), places, 50), 4);
  }

  std::optional<Verdict> verdict(std::string_view line) {
    if (const auto is = line.find(" = "); is != std::string_view::npos)
      return judge(given_text(claim_, line.substr(0, is)), {"", rounded(line.substr(is + 3))}, {}).verdict;
    const auto found = static_cast<int>(rounded(line));
    return found < 0 ? std::nullopt : std::optional(all_verdicts.at(static_cast<std::size_t>(found)));
  }

  /// The coordinates whose labels and formulas stand in a line from a place on.
  Coordinates place(const Line& line, std::size_t first) {
    const auto coordinate = [&](std::size_t i) {
      if (i + 1 >= line.size()) return Coordinate{};
      const auto hole = line.at(i).find("{}");
      return Coordinate{line.at(i).substr(0, hole), rounded(line.at(i + 1)), line.at(i).substr(hole + 2)};
    };
    return {coordinate(first), coordinate(first + 2)};
  }

  std::string effect(const Line& line) {
    const std::string_view kind = line.at(0);
    if (kind == "power") return effect_of_power(rounded(line.at(1)), rounded(line.at(2)), text(line.at(3)));
    if (kind == "factor") return effect_of_factor(rounded(line.at(1)), rounded(line.at(2)), text(line.at(3)));
    if (kind == "none") return "none: " + text(line.at(1));
    Effect effect;
    const auto add = [&](const Coordinate& beside) {
      effect.include(effect_between(numbers_.curve(line.at(1)), numbers_.curve(line.at(2)),
                                    {{}, {.concentration = rounded(line.at(5))}}),
                     beside);
    };
    if (kind == "value") {
      effect.show(rounded(line.at(1)), rounded(line.at(2)), place(line, 5));
    } else if (kind == "each") {
      numbers_.at(line.at(5), [&] { effect.show(rounded(line.at(1)), rounded(line.at(2)), place(line, 6)); });
    } else if (line.size() > 6) {
      numbers_.at(line.at(6), [&] { add(place(line, 7).first); });
    } else {
      add({});
    }
    return sentence(effect, text(line.at(3)), text(line.at(4)));
  }

  const Claim& claim_;
  ClaimNumbers<T> numbers_;
  std::map<std::string, std::string, std::less<>> words_;  ///< of the verdicts and of code
};

}  // namespace

Finding told_of(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
                const std::vector<Told>& found) {
  return Computation<double>(claim, found).told(verdict, effect);
}

Finding computed_by_its_record(const Claim& claim) {
  if (claim.instructions.in_50_digits) return Computation<Decimal50>(claim).finding();
  return Computation<double>(claim).finding();
}

}  // namespace shadefit
