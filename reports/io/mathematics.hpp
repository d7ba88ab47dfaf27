#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Formulas as people type them, set as mathematics: LaTeX between dollars, for LaTeX and Markdown.
namespace shadefit {

/// Numbers, formulas and relations between commas or semicolons: "A = 1.2e-05, x = 2" as
/// "$A = 1.2\times10^{-5}$, $x = 2$"; nothing for any other text. Names are those of the catalogue, single
/// letters, and `more_names`; any other is a word.
std::optional<std::string> latex_mathematics(const std::string& text,
                                             std::span<const std::string> more_names = {});

/// The same, but any other text is returned as it is.
std::string mathematics(const std::string& text);

/// A statement of the ledger marks its formulas: "`c^k` falls". This is it without the marks: "c^k falls".
std::string without_marks(std::string_view statement);

/// The same with its formulas as mathematics: "$c^{k}$ falls"; `words` changes the text between them. Throws
/// std::invalid_argument, which names the formula that cannot be read.
std::string with_mathematics(std::string_view statement, std::string (*words)(const std::string&) = nullptr);

}  // namespace shadefit
