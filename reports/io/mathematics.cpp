#include "reports/io/mathematics.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fit/formula/parse_formula.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// The names that are variables and parameters, not words.
using NameList = std::vector<std::string_view>;

/// A text and what stands for it.
using Replacement = std::pair<std::string_view, std::string_view>;

/// Cosines, exponents and parameters of the catalogue.
NameList catalogue_names() {
  return {"a", "b", "c", "d", "g", "k", "n", "s", "x", "A"};
}

/// Also those of the statements of the ledger.
NameList statement_names() {
  NameList names = catalogue_names();
  for (const std::string_view name :
       {"e",      "f",      "h",     "m",        "r",       "t",      "v",        "w",
        "y",      "z",      "D",     "F",        "M",       "alpha",  "phi",      "rho",
        "theta",  "Lambda", "f0",    "F0",       "F_i",     "F_o",    "G1",       "theta_v",
        "c_diff", "albedo", "color", "constant", "diffuse", "levels", "specular", "weight"})
    names.push_back(name);
  return names;
}

/// What a statement writes as papers do, and the same for `parse_formula`: it refuses what can be read in two
/// ways, and has no vectors.
constexpr std::array<Replacement, 15> readings{{{"ln 2", "ln2"},
                                                {"sqrt 3", "sqrt(3)"},
                                                {"sinh k", "sinh(k)"},
                                                {"1/2 log2", "(1/2) log2"},
                                                {"w 2^-m", "w*2^(-m)"},
                                                {"2tc", "2 t c"},
                                                {"cos^", "cosine^"},
                                                {"tan^", "tangent^"},
                                                {"D(m)", "density"},
                                                {"(n.h)", "nh"},
                                                {"(n.l)", "nl"},
                                                {"(n.m)", "nm"},
                                                {"(r.v)", "rv"},
                                                {"v.m", "vm"},
                                                {"v.n", "vn"}}};

/// The names that only `readings` has, in LaTeX.
constexpr std::array<Replacement, 9> read_names{{{"cosine", "\\cos"},
                                                 {"tangent", "\\tan"},
                                                 {"density", "D(m)"},
                                                 {"nh", "\\left(n \\cdot h\\right)"},
                                                 {"nl", "\\left(n \\cdot l\\right)"},
                                                 {"nm", "\\left(n \\cdot m\\right)"},
                                                 {"rv", "\\left(r \\cdot v\\right)"},
                                                 {"vm", "v \\cdot m"},
                                                 {"vn", "v \\cdot n"}}};

std::string latex_number(const std::string& s) {
  const auto e = s.find_first_of("eE");
  if (e == std::string::npos) return s;
  std::string power = s.substr(e + 1);
  const bool is_negative = power.starts_with('-');
  power.erase(0, std::min(power.find_first_not_of("+-0"), power.size() - 1));
  return s.substr(0, e) + "\\times10^{" + (is_negative ? "-" : "") + power + "}";
}

/// The LaTeX of a number or a formula such as "c^k", without the dollars. Throws std::invalid_argument.
std::string latex_formula(const std::string& s, const NameList& names) {
  return parse_number(s) ? latex_number(s) : to_latex(parse_formula(s, names));
}

/// The same of an interval, "[0, 1]", and of a rounded value, which `parse_formula` takes to pieces.
std::string latex_side(const std::string& s, const NameList& names) {
  if (s.starts_with("round(") && s.ends_with(')'))
    return "\\operatorname{round}\\left(" + latex_formula(s.substr(6, s.size() - 7), names) + "\\right)";
  const std::size_t comma = s.find(',');
  if (!s.starts_with('[') || !s.ends_with(']') || comma == std::string::npos) return latex_formula(s, names);
  const std::size_t second = s.find_first_not_of(' ', comma + 1);
  return "\\left[" + latex_formula(s.substr(1, comma - 1), names) + ", " +
         latex_formula(s.substr(second, s.size() - 1 - second), names) + "\\right]";
}

/// The signs between the sides of a relation.
constexpr std::array<Replacement, 7> relations{{{" = ", " = "},
                                                {" == ", " = "},
                                                {" != ", " \\ne "},
                                                {" <= ", " \\le "},
                                                {" > ", " > "},
                                                {" ~ ", " \\approx "},
                                                {" in ", " \\in "}}};

/// A formula or a relation: "k = 12", "c^k ~ exp((k + x) (c - 1))". Throws std::invalid_argument.
std::string latex_relation(const std::string& s, const NameList& names) {
  std::string out;
  for (std::size_t from = 0;;) {
    const auto place = [&](const Replacement& relation) { return s.find(relation.first, from); };
    const auto* next = std::ranges::min_element(
        relations, [&](const Replacement& a, const Replacement& b) { return place(a) < place(b); });
    const std::size_t to = std::min(place(*next), s.size());
    out += latex_side(s.substr(from, to - from), names);
    if (to == s.size()) return out;
    out += next->second;
    from = to + next->first.size();
  }
}

/// A formula of a statement, or a range of whole numbers, "k = 3..15", without the dollars.
std::string latex_of_statement(std::string formula) {
  for (const auto& [written, read] : readings) boost::replace_all(formula, written, read);
  NameList names = statement_names();
  for (const auto& [name, latex] : read_names) names.push_back(name);
  const std::size_t dots = formula.find("..");
  std::string out = latex_relation(formula.substr(0, dots), names);
  if (dots != std::string::npos) out += ", \\ldots, " + latex_relation(formula.substr(dots + 2), names);
  for (const auto& [name, latex] : read_names)
    boost::replace_all(out, "\\mathrm{" + std::string(name) + "}", latex);
  return out;
}

/// The texts between marks: words, formula, words, and so on.
std::vector<std::string> parts_of_statement(std::string_view statement) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t at = statement.find('`');
    parts.emplace_back(statement.substr(0, at));
    if (at == std::string_view::npos) return parts;
    statement.remove_prefix(at + 1);
  }
}

}  // namespace

std::optional<std::string> latex_mathematics(const std::string& text,
                                             std::span<const std::string> more_names) {
  NameList names = catalogue_names();
  names.insert(names.end(), more_names.begin(), more_names.end());
  std::string out;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min({text.find(", ", from), text.find("; ", from), text.size()});
    try {
      out += "$" + latex_relation(text.substr(from, to - from), names) + "$";
    } catch (const std::invalid_argument&) {
      return {};
    }
    if (to == text.size()) return out;
    out += text.substr(to, 2);
    from = to + 2;
  }
}

std::string mathematics(const std::string& text) {
  return latex_mathematics(text).value_or(text);
}

std::string without_marks(std::string_view statement) {
  std::string out(statement);
  std::erase(out, '`');
  return out;
}

std::string with_mathematics(std::string_view statement, std::string (*words)(const std::string&)) {
  const std::vector<std::string> parts = parts_of_statement(statement);
  if (parts.size() % 2 == 0)
    throw std::invalid_argument("statement '" + std::string(statement) + "': expected ` in pairs");
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i % 2 == 0) {
      out += words != nullptr ? words(parts[i]) : parts[i];
      continue;
    }
    // GitHub opens mathematics after a space alone: a parenthesis moves in.
    const bool is_in_parentheses = out.ends_with('(');
    if (is_in_parentheses) out.pop_back();
    out += (is_in_parentheses ? "$(" : "$") + latex_of_statement(parts[i]) + "$";
  }
  return out;
}

}  // namespace shadefit
