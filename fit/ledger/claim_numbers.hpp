#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/ledger/bound_variables.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/transfer_function.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/binary_logarithm.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {

/// Finds a text in a table without a copy of it.
struct TextHash : std::hash<std::string_view> {
  using is_transparent = void;
};

template <class Value>
using TextTable = std::unordered_map<std::string, Value, TextHash, std::equal_to<>>;

/// The numbers of a claim that is data: fit/ledger/computation.hpp has the notation. T is their scalar,
/// double or Decimal50.
template <class T>
class ClaimNumbers {
 public:
  using Line = Instructions::Line;
  using Visit = std::function<void()>;

  explicit ClaimNumbers(const Claim& claim) : claim_(claim) {
    names_.takes_parameters = names_.takes_integrals = true;
    for (std::size_t i = 0; i < all_verdicts.size(); ++i) {
      std::string verdict(name(all_verdicts[i]));
      std::ranges::replace(verdict, '-', '_');
      given_[verdict] = T(static_cast<double>(i));
    }
    given_["undecided"] = -1;
    for (const Line& line : claim.instructions.definitions) {
      const auto open = line.at(0).find('(');
      const std::string name(line.at(0).substr(0, open));
      if (open == std::string_view::npos) {
        lines_[name] = &line;
        continue;
      }
      FormulaNames names = names_;
      names.variables = items_of(line.at(0).substr(open + 1, line.at(0).size() - open - 2));
      const std::string_view text =
          line.at(1).starts_with('=') ? given_text(claim, line.at(1).substr(1)) : line.at(1);
      names_.definitions.insert_or_assign(name,
                                          Definition{names.variables, read_formula(text, names).formula});
    }
  }

  /// A number that code found.
  void give(std::string_view name, T value) { given_[std::string(name)] = value; }

  /// The definition of that name, or null.
  const Line* line_of(std::string_view name) const {
    const auto found = lines_.find(name);
    return found == lines_.end() ? nullptr : found->second;
  }

  /// Computes what a definition gives. Each may need a number and a text of others: of a longer chain one
  /// needs itself, and std::logic_error is thrown.
  template <class Compute>
  auto by_definition(const Line& line, const Compute& compute) {
    if (++depth_ > 2 * lines_.size())
      throw std::logic_error(fmt::format("{} defines '{}' by itself", claim_.id, line.at(0)));
    auto found = compute();
    --depth_;
    return found;
  }

  T value(std::string_view text) { return value(read(text), text); }
  double rounded(std::string_view text) { return static_cast<double>(value(text)); }
  bool holds(std::string_view condition) { return value(choice(condition)) != 0; }

  /// Where a name that is not bound has its number: in a definition, or in the record.
  struct Origin {
    const Line* line = nullptr;
    const T* given = nullptr;
  };

  /// A formula with the names that it has, and in double a tape of them.
  struct Read {
    Symbolic formula;
    std::vector<std::string> names = {};
    std::vector<Origin> origins = {};  ///< of the names
    std::optional<TapeProgram<double>> tape = {};
  };

  /// The value of a formula that is read already; `text` is what it was read from.
  T value(Read& of, std::string_view text) {
    const auto value_of = [&](const std::string& name) { return number(name); };
    T result;
    if constexpr (std::same_as<T, double>) {
      result = by_tape(of, text);
    } else {
      result = in_50_digits(of.formula, value_of);
    }
    if (!(result - result == 0)) throw std::invalid_argument(fmt::format("'{}' has no value", text));
    return result;
  }
  /// Finds the innermost variable of that name. Returns null where no variable has it.
  const Bound<T>* bound(std::string_view name) { return bound_.find(name); }

  T number(const std::string& name) {
    Origin origin{line_of(name)};
    return number(name, origin);
  }

  /// Visits all places, with their variables bound.
  void at(std::string_view places, const Visit& visit);

  /// A formula as a function of the cosine `c` and of y = 1 - c; other names keep their value.
  auto curve(std::string_view text) {
    std::map<std::string, double> values;
    for (const std::string& name : free_variables(formula(text))) {
      if (name != "c" && name != "y") values[name] = static_cast<double>(number(name));
    }
    return [values, form = formula(text)]<class U>(const Cosine<U>& at) {
      return evaluate<U>(form, [&](const std::string& name) {
        return name == "c" ? at.cos_theta : name == "y" ? at.one_minus_cos : lift<U>(values.at(name));
      });
    };
  }

  /// A formula as a function of a variable.
  std::function<double(double)> function(std::string_view variable, std::string text) {
    Read* of = &read(text);
    return [this, variable, of, text = std::move(text)](double x) {
      double found = 0;
      bound_.with({{std::string(variable), T(x)}}, [&] { found = static_cast<double>(value(*of, text)); });
      return found;
    };
  }

 private:
  T number(const std::string& name, Origin& origin) {
    if (const auto* found = bound(name)) return found->value;
    if (origin.line != nullptr) return found_by(*origin.line).value;
    if (origin.given == nullptr) origin.given = &given(name);
    return *origin.given;
  }

  const T& given(const std::string& name) {
    if (const auto found = given_.find(name); found != given_.end()) return found->second;
    const bool is_end = name.ends_with("_first") || name.ends_with("_last");
    return given_[name] = is_end ? T(given_number(claim_, name)) : constant<T>(given_text(claim_, name));
  }

  static constexpr std::string_view words_of = "words of ";

  /// A condition as a formula: 1 where it holds.
  static std::string choice(std::string_view condition) { return std::string(condition) + " ? 1 : 0"; }

  const Symbolic& formula(std::string_view text) { return read(text).formula; }

  Read& read(std::string_view text) {
    if (const auto found = formulas_.find(text); found != formulas_.end()) return found->second;
    Read of{read_formula(text, names_).formula};
    const auto names = free_variables(of.formula);
    of.names.assign(names.begin(), names.end());
    for (const std::string& name : of.names) of.origins.push_back({line_of(name)});
    return formulas_.emplace(std::string(text), std::move(of)).first->second;
  }

  /// A tape computes both sides of a choice. Where a definition on one of them has no value, the other may
  /// have one: then the tree of the formula computes that alone.
  double by_tape(Read& of, std::string_view text) {
    std::vector<double> values;
    try {
      for (std::size_t i = 0; i < of.names.size(); ++i) values.push_back(number(of.names[i], of.origins[i]));
    } catch (const std::invalid_argument&) {
      if (text.find('?') == std::string_view::npos) throw;
      return evaluate<double>(of.formula, [&](const std::string& name) { return number(name); });
    }
    if (!of.tape) of.tape.emplace(tape_of(of.formula, of.names), std::span<const double>{});
    of.tape->run(values);
    return of.tape->output(0);
  }

  struct Found {
    T value = 0;
    double doubt = 0;                                 ///< of an integral
    std::size_t outermost = BoundVariables<T>::none;  ///< of the bound variables that it needs
  };

  /// What a definition gives for the bound variables. It is kept if it needs none of them, or takes long.
  Found found_by(const Line& line) {
    if (const auto kept = constants_.find(&line); kept != constants_.end()) return kept->second;
    std::vector<Bound<T>> variables;
    const bool takes_long = line.size() > 2 && line.at(1) != "in";
    if (takes_long) {
      const auto kept = kept_.find({&line, bound_.all()});
      if (kept != kept_.end()) {
        bound_.use(kept->second.outermost);
        return kept->second;
      }
      variables = bound_.all();
    }
    Found found;
    const std::size_t outermost = bound_.used_by([&] {
      found = by_definition(line, [&]() -> Found {
        if (line.at(1) != "integral") return {line.size() > 2 ? searched(line) : value(line.at(1))};
        const Integral both = integral(line);
        return {T(both.value), both.error};
      });
    });
    found.outermost = outermost;
    if (outermost == BoundVariables<T>::none) {
      constants_.emplace(&line, found);
    } else if (takes_long) {
      kept_.emplace(std::pair(&line, variables), found);
    }
    return found;
  }

  T largest_at(std::string_view places, std::string_view formula);
  T where_largest(std::string_view places, std::string_view formula, std::string_view place);

  /// By the first rule, with the doubt of both.
  Integral integral(const Line& line) {
    constexpr double tolerance = 1e-13;
    const std::size_t other = line.size() > 6 ? 6 : 3;
    const Integral first = gauss_kronrod(function(line.at(2), std::string(line.at(5))), rounded(line.at(3)),
                                         rounded(line.at(4)), tolerance);
    const Integral second = tanh_sinh(function(line.at(2), std::string(line.at(other + 2))),
                                      rounded(line.at(other)), rounded(line.at(other + 1)), tolerance);
    return {first.value, first.error + second.error + std::abs(first.value - second.value)};
  }

  /// A format by its name, or by a variable that is bound to that.
  template <class Call>
  auto in_format_of(std::string_view name, const Call& call) {
    const auto* variable = bound(name);
    return in_format(variable != nullptr ? variable->text : name, call);
  }

  /// The value of a formula with every operation rounded to a format.
  template <class Format>
  double in(std::string_view text) {
    Read& of = read(text);
    std::vector<Format> values;
    for (std::size_t i = 0; i < of.names.size(); ++i)
      values.push_back(rounded_to<Format>(static_cast<double>(number(of.names[i], of.origins[i]))));
    return widened(evaluate<Format>(of.formula, [&](const std::string& name) {
      return values[static_cast<std::size_t>(std::ranges::find(of.names, name) - of.names.begin())];
    }));
  }

  template <class Format>
  double last_in(const Line& line) {
    return last_that_holds<Format>(rounded(line.at(4)), rounded(line.at(5)), [&](Format x) {
      double found = 0;
      bound_.with({{std::string(line.at(3)), T(widened(x))}}, [&] { found = in<Format>(line.at(6)); });
      return found >= 0 && std::isfinite(found);
    });
  }

  T searched(const Line& line);

  const Claim& claim_;
  FormulaNames names_;
  TextTable<const Line*> lines_;
  TextTable<Read> formulas_;
  std::unordered_map<const Line*, Found> constants_;
  std::map<std::pair<const Line*, std::vector<Bound<T>>>, Found> kept_;
  TextTable<T> given_;     ///< numbers of the record, of code, and those of verdicts
  std::size_t depth_ = 0;  ///< of the definitions that are being computed
  BoundVariables<T> bound_;
};

}  // namespace shadefit
