#include "fit/scalars/hinges.hpp"

#include <string>

#include "fit/truths/albedos.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

bool is_negative_number(const Symbolic& e) {
  return e.kind() == Kind::negate && e.part(0).kind() == Kind::number;
}

void collect_of_function(const Symbolic& e, std::vector<Hinge>& hinges) {
  const std::string& name = e.name();
  const Symbolic& x = e.part(0);
  const Symbolic one = Symbolic::number("1");
  if (name == "min" || name == "max") {
    hinges.push_back({x - e.part(1), false, false});
  } else if (name == "abs" || name == "sign") {
    hinges.push_back({x, false, false, name == "sign"});
  } else if (name == "floor") {
    hinges.push_back({sin(Symbolic::constant("pi") * x), false, false, true});  // zero at whole numbers
  } else if (name == "sqrt") {
    hinges.push_back({x, true, false});
  } else if (name == "asin" || name == "acos") {
    hinges.push_back({one - x, true, false});
    hinges.push_back({one + x, true, false});
  } else if (name == "tan") {
    hinges.push_back({cos(x), true, true});
  } else if (name == "atan2") {
    hinges.push_back({x, false, false, true});  // y changes its sign: a jump where x is negative
  } else if (name == "log" || name == "log2") {
    hinges.push_back({x, true, true});
  } else if (name == "log1p" || name == "log1p_remainder") {
    hinges.push_back({x + one, true, true});
  } else if (find_albedo(name)) {
    // Near 0 an albedo has terms such as c log(c).
    hinges.push_back({x, true, false});
    hinges.push_back({e.part(1), true, false});
  }
}

void collect(const Symbolic& e, std::vector<Hinge>& hinges);

/// What its body is not smooth at, an integral is smooth at, except where that place is an end of the
/// integral.
void collect_of_integral(const Symbolic& e, std::vector<Hinge>& hinges) {
  std::vector<Hinge> of_body;
  collect(e.part(0), of_body);
  for (const std::size_t end : {std::size_t{1}, std::size_t{2}}) {
    collect(e.part(end), hinges);
    for (const Hinge& hinge : of_body) {
      const Symbolic at_end = evaluate<Symbolic>(hinge.part, [&](const std::string& name) {
        return name == e.name() ? e.part(end) : Symbolic::variable(name);
      });
      hinges.push_back({at_end, hinge.is_root, hinge.is_pole});
    }
  }
}

/// The recursion is as deep as the formula, which is limited.
void collect(const Symbolic& e, std::vector<Hinge>& hinges) {
  if (e.kind() == Kind::integral) return collect_of_integral(e, hinges);
  for (const Symbolic& part : e.parts()) collect(part, hinges);
  if (e.kind() == Kind::choice) {
    hinges.push_back({e.part(0) - e.part(1), false, false, true});
  } else if (e.kind() == Kind::divide) {
    hinges.push_back({e.part(1), true, true});
  } else if (e.kind() == Kind::integer_power && e.exponent() < 0) {
    hinges.push_back({e.part(0), true, true});
  } else if (e.kind() == Kind::real_power) {
    hinges.push_back({e.part(0), true, is_negative_number(e.part(1))});
  } else if (e.kind() == Kind::function) {
    collect_of_function(e, hinges);
  }
}

}  // namespace

std::vector<Hinge> hinges_of(const Symbolic& formula) {
  std::vector<Hinge> hinges;
  collect(formula, hinges);
  return hinges;
}

}  // namespace shadefit
