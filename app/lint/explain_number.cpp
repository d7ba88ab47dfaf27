#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "app/lint/lint_command.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using lint::DigitMatch;
using lint::NumberMatch;

/// In the order of `DigitMatch`.
constexpr std::array<std::string_view, 7> words_of_matches{
    "the same digits",       "more digits",       "digits of its float", "fewer digits",
    "another decimal point", "one digit differs", "one digit differs"};

/// A constant and how it agrees with the number.
struct NamedConstant {
  DigitMatch match;
  std::vector<Cell> cells;
};

NamedConstant named(const lint::KnownSet& set, const NumberMatch& found) {
  const lint::KnownConstant& constant = set.constants[found.place.constant];
  std::string published = constant.printed;
  if (found.variant)
    published = fmt::format("{}, mistyped or replaced: {}", published, set.variants[*found.variant].printed);
  return {found.match,
          {set.id, set.form, constant.is_of_form ? "" : constant.name, published,
           word(words_of_matches.at(static_cast<std::size_t>(found.match))), set.source}};
}

/// The claims of the ledger that print these digits.
void append_claims(const lint::Digits& digits, std::vector<NamedConstant>& constants) {
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      for (const Quantity& quantity : claim.printed) {
        if (lint::digits_of(quantity.value) != digits) continue;
        constants.push_back(
            {DigitMatch::same,
             {word(claim.id), "a claim", word(quantity.name), word(quantity.value),
              word(words_of_matches.front()), fmt::format("{} {}", claim.source.author, claim.source.year)}});
      }
    }
  }
}

/// The constants of one or two digits, which the index does not find: a source is full of such numbers.
void append_short(const lint::KnownConstants& known, const lint::Digits& digits,
                  std::vector<NamedConstant>& constants) {
  if (!constants.empty()) return;
  for (std::size_t set = 0; set < known.sets.size(); ++set) {
    for (std::size_t i = 0; i < known.sets[set].constants.size(); ++i)
      if (lint::digits_of(known.sets[set].constants[i].printed) == digits)
        constants.push_back(named(known.sets[set], {{set, i}}));
  }
}

}  // namespace

std::optional<Outcome> explain_number(const ExplainOptions& options) {
  const auto value = parse_number(options.id);
  if (!value) return std::nullopt;
  const lint::KnownConstants known = known_constants(options.studies);
  const lint::Digits digits = lint::digits_of(options.id);
  std::vector<NamedConstant> constants;
  append_claims(digits, constants);
  for (const NumberMatch& found : known.index.find(digits))
    constants.push_back(named(known.sets[found.place.set], found));
  append_short(known, digits, constants);
  std::ranges::stable_sort(constants, {}, &NamedConstant::match);
  if (constants.empty())
    throw UserError(fmt::format("no published constant that shadefit knows has the number '{}'", options.id));
  // A digit that differs says nothing where another constant has them all.
  const bool is_exact = constants.front().match < DigitMatch::shifted;
  Table table{{"id", "form", "constant", "published", "agrees by", "source"}};
  std::set<std::string> seen;
  const auto is_new = [&](const std::vector<Cell>& cells) {
    return seen.insert(joined(cells, "\n", [](const Cell& cell) { return text(cell, Precision::report); }))
        .second;
  };
  for (NamedConstant& constant : constants)
    if ((!is_exact || constant.match < DigitMatch::shifted) && is_new(constant.cells))
      table.rows.push_back(std::move(constant.cells));
  if (options.json)
    return Outcome{0, json_text({{"schema", 1}, {"number", options.id}, {"constants", write_json(table)}}),
                   ""};
  return Outcome{
      0,
      write_console(table, Precision::report, options.terminal) +
          fmt::format("Next: shadefit explain {}\n", std::get<std::string>(table.rows.front().front())),
      ""};
}

}  // namespace shadefit
