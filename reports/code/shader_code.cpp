#include "reports/code/shader_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

#include "fit/scalars/half.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/dialects.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/escape.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

const Dialect& dialect_of(Language language) {
  return dialects.at(static_cast<std::size_t>(language));
}

/// The shortest decimal that reads back as x, where reading rounds to the format.
std::string shortest(const Decimal50& x, ShaderPrecision precision) {
  if (precision == ShaderPrecision::float16) {
    const Eigen::half rounded = round_to_half(static_cast<double>(x));
    for (int digits = 1;; ++digits) {
      const std::string text = fmt::format("{:.{}g}", static_cast<float>(rounded), digits);
      if (round_to_half(std::stod(text)) == rounded || digits == 9) return text;
    }
  }
  char text[32];
  return {text, std::to_chars(std::begin(text), std::end(text), static_cast<float>(x)).ptr};
}

bool is_number(const Symbolic& e) {
  return e.kind() == Kind::number;
}

/// x^n, its multiplications written out.
Symbolic multiplied(const Symbolic& x, int n) {
  if (n < 0) return Symbolic::number("1") / multiplied(x, -n);
  if (n == 0) return Symbolic::number("1");
  if (n == 1) return x;
  const Symbolic half = multiplied(x, n / 2), even = half * half;
  return n % 2 == 0 ? even : even * x;
}

/// exp(n x) as exp2((n/ln 2) x), where n is a number: processors have exp2, and the factor is precomputed.
/// The compiler handles any other exp.
std::optional<Symbolic> exp_by_exp2_of_product(const Symbolic& e) {
  if (e.kind() != Kind::function || e.name() != "exp" || e.part(0).kind() != Kind::multiply)
    return std::nullopt;
  const Symbolic& factor = e.part(0).part(0);
  if (!factor.is_of_numbers()) return std::nullopt;
  return exp2(Symbolic((factor / ln2<Symbolic>()) * e.part(0).part(1)));
}

/// The precedence of an expression.
enum class Tightness { sum, product, sign, atom };

/// One function's body.
class Body {
 public:
  Body(const ShaderFunction& function, const Dialect& dialect, ShaderPrecision precision)
      : function_(function), dialect_(dialect), precision_(precision) {}

  std::string code() {
    count(function_.result);
    const std::string result = text(function_.result, Tightness::sum);
    return lines_ + "  return " + result + ";\n";
  }

 private:
  bool is_half() const { return precision_ == ShaderPrecision::float16; }
  std::string_view type() const { return is_half() ? dialect_.half : dialect_.type; }

  void count(const Symbolic& e) {
    if (e.parts().empty()) return;
    if (++uses_[to_text(e)] > 1) return;
    for (const Symbolic& part : e.parts()) count(part);
  }

  std::string literal(const std::string& decimal) const {
    if (decimal.find_first_of("in") != std::string::npos)  // inf or nan
      throw UserError(fmt::format("{}: '{}' is not a number of that precision", function_.name, decimal));
    const bool is_whole = decimal.find_first_of(".e") == std::string::npos;
    return fmt::format("{}{}{}{}", is_half() ? dialect_.half_prefix : "", decimal, is_whole ? ".0" : "",
                       is_half() ? dialect_.half_suffix : dialect_.suffix);
  }

  /// The text of an expression, in parentheses unless its precedence is at least that high. For a reused
  /// expression, the name of the variable that holds it.
  std::string text(const Symbolic& e, Tightness least) {
    if (e.parts().empty()) {
      if (!is_number(e)) return e.name();
      const bool is_signed = e.name().front() == '-';
      return is_signed && least >= Tightness::sign ? "(" + literal(e.name()) + ")" : literal(e.name());
    }
    const std::string key = to_text(e);
    const auto known = names_.find(key);
    if (known != names_.end()) return known->second;
    const auto [written, tightness] = operation(e);
    if (uses_.at(key) == 1) return tightness < least ? "(" + written + ")" : written;
    const std::string name = new_name();
    const bool is_wgsl = dialect_.name == "wgsl";
    lines_ += is_wgsl ? fmt::format("  let {} = {};\n", name, written)
                      : fmt::format("  {}{} {} = {};\n", is_c() ? "const " : "", type(), name, written);
    names_.emplace(key, name);
    return name;
  }

  bool is_c() const { return !dialect_.before.empty(); }

  std::string new_name() {
    for (;;) {
      const std::string name = "t" + std::to_string(next_name_++);
      if (std::ranges::count(function_.arguments, name) == 0) return name;
    }
  }

  std::pair<std::string, Tightness> operation(const Symbolic& e) {
    switch (e.kind()) {
      case Kind::add:
      case Kind::subtract:
        return {sum(e), Tightness::sum};
      case Kind::multiply:
      case Kind::divide: {
        // the left part first, because its lines come first
        const std::string left = text(e.part(0), Tightness::product);
        const char* sign = e.kind() == Kind::multiply ? " * " : " / ";
        return {left + sign + text(e.part(1), Tightness::sign), Tightness::product};
      }
      case Kind::negate:
        return {"-" + text(e.part(0), Tightness::atom), Tightness::sign};
      case Kind::real_power:
        return {call("pow", {e.part(0), e.part(1)}), Tightness::atom};
      case Kind::choice:
        return choice(e);
      case Kind::function:
        return {call(e.name(), e.parts()), Tightness::atom};
      case Kind::integral:
      case Kind::integer_power:
      case Kind::variable:
      case Kind::number:
      case Kind::constant:
        break;
    }
    throw std::logic_error("not as it is generated: " + to_text(e));
  }

  /// x + (-2) is x - 2, bit for bit.
  std::string sum(const Symbolic& e) {
    const bool adds = e.kind() == Kind::add;
    const std::string left = text(e.part(0), Tightness::sum);
    const Symbolic& right = e.part(1);
    if (is_number(right) && right.name().front() == '-')
      return left + (adds ? " - " : " + ") + literal(right.name().substr(1));
    return left + (adds ? " + " : " - ") + text(right, Tightness::product);
  }

  std::pair<std::string, Tightness> choice(const Symbolic& e) {
    const auto part = [&](std::size_t i) { return text(e.part(i), Tightness::product); };
    const std::string a = part(0), b = part(1), yes = part(2), no = part(3);
    if (dialect_.name == "wgsl")
      return {fmt::format("select({}, {}, {} < {})", no, yes, a, b), Tightness::atom};
    return {fmt::format("({} < {} ? {} : {})", a, b, yes, no), Tightness::atom};
  }

  std::string call(const std::string& function, const std::vector<Symbolic>& arguments) {
    std::string list;
    for (const Symbolic& argument : arguments)
      list += (list.empty() ? "" : ", ") + text(argument, Tightness::sum);
    return library_name(function) + "(" + list + ")";
  }

  std::string library_name(const std::string& function) const {
    if (is_half() && !dialect_.half_functions.empty()) return half_name(function);
    constexpr std::array everywhere{"exp",  "exp2",  "log",  "log2", "sqrt",  "sin",  "cos",
                                    "tan",  "asin",  "acos", "atan", "atan2", "sinh", "cosh",
                                    "tanh", "floor", "abs",  "min",  "max",   "pow"};
    constexpr std::array in_c{"expm1", "log1p", "erf", "erfc"};
    const auto is_in = [&](const auto& list) { return std::ranges::find(list, function) != list.end(); };
    const bool is_there = is_in(everywhere) || (dialect_.has_functions_of_c && is_in(in_c)) ||
                          (dialect_.has_sign && function == "sign");
    if (!is_there)
      throw UserError(fmt::format("{}: '{}' has no {}", function_.name, dialect_.name, function));
    std::string name = function;
    if (name == "min" || name == "max" || name == "abs") name.insert(0, dialect_.before_min);
    if (dialect_.name == "glsl" && name == "atan2") name = "atan";
    return fmt::format("{}{}{}", dialect_.functions, name, dialect_.float_suffix);
  }

  /// Of a language whose functions of half have names of their own.
  std::string half_name(const std::string& function) const {
    std::istringstream names{std::string(dialect_.half_functions)};
    for (std::string pair; names >> pair;) {
      if (pair.starts_with(function + "=")) return pair.substr(function.size() + 1);
    }
    throw UserError(fmt::format("{}: '{}' has no {} of half", function_.name, dialect_.name, function));
  }

  const ShaderFunction& function_;
  const Dialect& dialect_;
  ShaderPrecision precision_;
  std::map<std::string, int> uses_;           ///< by text
  std::map<std::string, std::string> names_;  ///< of expressions with their own line
  std::string lines_;
  int next_name_ = 0;
};

std::string head(const ShaderFunction& function, const Dialect& dialect, std::string_view type) {
  std::string arguments;
  const bool is_wgsl = dialect.name == "wgsl";
  for (const std::string& argument : function.arguments) {
    arguments += arguments.empty() ? "" : ", ";
    arguments += is_wgsl ? fmt::format("{}: {}", argument, type) : fmt::format("{} {}", type, argument);
  }
  return is_wgsl ? fmt::format("fn {}({}) -> {}", function.name, arguments, type)
                 : fmt::format("{}{} {}({})", dialect.before, type, function.name, arguments);
}

/// A header that may be included twice. The guard contains a digest of the code. So two headers with the same
/// function names but different constants give a compiler error; otherwise the second would be skipped
/// silently.
std::string guarded(const std::string& body, std::string name) {
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::string guard = fmt::format("SHADEFIT_{:08X}_{}", crc_of(body), name);
  return fmt::format("\n#ifndef {0}\n#define {0}\n{1}\n#endif\n", guard, body);
}

}  // namespace

std::string_view name(Language language) {
  return dialect_of(language).name;
}

std::string_view name(ShaderPrecision precision) {
  return precision == ShaderPrecision::float32 ? "float" : "half";
}

Symbolic as_generated(const Symbolic& e, ShaderPrecision precision) {
  if (e.is_of_numbers()) return Symbolic::number(shortest(in_50_digits(e), precision));
  if (e.kind() == Kind::variable) return e;
  if (e.kind() == Kind::integer_power) return multiplied(as_generated(e.part(0), precision), e.exponent());
  if (const auto by_exp2 = exp_by_exp2_of_product(e)) return as_generated(*by_exp2, precision);
  std::vector<Symbolic> parts;
  for (const Symbolic& part : e.parts()) parts.push_back(as_generated(part, precision));
  return e.kind() == Kind::function ? Symbolic::function(e.name(), std::move(parts))
                                    : Symbolic::operation(e.kind(), std::move(parts));
}

std::string shader_code(std::span<const ShaderFunction> functions, Language language,
                        ShaderPrecision precision, std::span<const OthersText> comment) {
  const Dialect& dialect = dialect_of(language);
  const bool is_half = precision == ShaderPrecision::float16;
  if (is_half && dialect.half.empty())
    throw UserError(
        fmt::format("--precision 'half' does not apply to --lang '{}': it has no half", dialect.name));
  std::string code;
  for (const OthersText& line : comment)
    code += line.empty() ? "//\n" : fmt::format("// {}\n", for_comment(line));
  std::string body;
  const std::string_view prologue = is_half ? dialect.prologue_half : dialect.prologue;
  if (!prologue.empty()) body += fmt::format("\n{}", prologue);
  for (const ShaderFunction& function : functions) {
    body += "\n";
    for (const std::string& line : function.comment) body += fmt::format("// {}\n", for_comment(line));
    ShaderFunction generated = function;
    generated.result = as_generated(function.result, precision);
    body += fmt::format("{} {{\n{}}}\n", head(function, dialect, is_half ? dialect.half : dialect.type),
                        Body(generated, dialect, precision).code());
  }
  return code + (dialect.has_guard && !functions.empty() ? guarded(body, functions.front().name) : body);
}

}  // namespace shadefit
