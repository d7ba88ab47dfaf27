#include "lint/reading_memory.hpp"

#include <map>

namespace shadefit::lint {
namespace {

/// The text of an expression with names by the order of their places: two expressions that differ in their
/// names alone have one text.
std::string text_without_names(const Symbolic& expression) {
  std::map<std::string, std::string> names;
  return to_text(evaluate<Symbolic>(expression, [&](const std::string& name) {
    const auto [place, is_new] = names.emplace(name, "");
    if (is_new) place->second = "v" + std::to_string(names.size());
    return Symbolic::variable(place->second);
  }));
}

}  // namespace

std::optional<ExpressionMatch> ReadingMemory::match(const Symbolic& expression, const KnownSet& set,
                                                    const std::vector<double>& constants,
                                                    const std::vector<double>& numbers,
                                                    const std::vector<std::size_t>& missing) {
  return matches_.get({&set, text_without_names(expression), constants, numbers, missing},
                      [&] { return match_expression(expression, set, constants, numbers, missing); });
}

}  // namespace shadefit::lint
