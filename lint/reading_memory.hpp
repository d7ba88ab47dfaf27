#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/support/memory.hpp"
#include "lint/expression/compare.hpp"
#include "lint/expression/source_expression.hpp"

namespace shadefit::lint {

/// What was read in a text. Each expression is read once, and compared once with a set that outlives this
/// object and with the same numbers.
class ReadingMemory {
 public:
  /// See read_expression().
  std::optional<Symbolic> read(std::string_view text, CommentStyle style) {
    return expressions_.get({style, std::string(text)}, [&] { return read_expression(text, style); });
  }

  /// See match_expression(). The names in the expression do not matter.
  std::optional<ExpressionMatch> match(const Symbolic& expression, const KnownSet& set,
                                       const std::vector<double>& constants,
                                       const std::vector<double>& numbers,
                                       const std::vector<std::size_t>& missing);

 private:
  struct Comparison {
    const KnownSet* set;
    std::string expression;
    std::vector<double> constants, numbers;
    std::vector<std::size_t> missing;
    auto operator<=>(const Comparison&) const = default;
  };
  Memory<std::pair<CommentStyle, std::string>, std::optional<Symbolic>> expressions_;
  Memory<Comparison, std::optional<ExpressionMatch>> matches_;
};

}  // namespace shadefit::lint
