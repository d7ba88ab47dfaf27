#pragma once

#include <string>
#include <string_view>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::bench::testing {

inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

inline TimedForm made_up(std::string target, std::string form, int exp2_degree, forms::Width width, double ns,
                         std::optional<double> error) {
  TimedForm timed;
  timed.target = std::move(target);
  timed.form = std::move(form);
  timed.label = timed.form;
  timed.exp2_degree = exp2_degree;
  timed.width = width;
  timed.ns = {ns, ns * 0.95, ns * 1.05};
  timed.real = {ns, ns * 2};
  timed.cpu = {ns / 2, ns / 2};
  timed.elements = 1000;
  timed.max_abs_error = error;
  return timed;
}

/// A lobe with a cheap form under two polynomials, a form that is beaten, and pow; and a target without a
/// reference.
inline Trade made_up_trade() {
  using forms::Width;
  Trade trade;
  trade.machine = {"A CPU, made up", "a compiler", 2, 1 << 25};
  trade.widths = {Width::scalar, Width::avx2};
  trade.targets = {{"lobe", "The lobe c^10"}, {"other", "Another"}};
  const auto add = [&](TimedForm timed) { trade.forms.push_back(std::move(timed)); };
  trade.copies = {made_up("", "copy", 0, Width::scalar, 0.4, {}),
                  made_up("", "copy", 0, Width::avx2, 0.1, {}), made_up("", "copy", 0, Width::avx2, 0.5, {}),
                  made_up("", "multiply-adds", 0, Width::avx2, 1.6, {})};
  trade.copies[2].place = DataPlace::memory;
  add(made_up("lobe", "pow", 0, Width::scalar, 20, 6e-8));
  add(made_up("lobe", "pow", 0, Width::avx2, 2, 6e-8));
  add(made_up("lobe", "pow", 0, Width::avx2, 8, 1e-16));
  trade.forms[0].is_reference = trade.forms[1].is_reference = trade.forms[2].is_reference = true;
  trade.forms[2].is_double = true;
  add(made_up("lobe", "cheap", 3, Width::scalar, 1, 0.02));
  add(made_up("lobe", "cheap", 3, Width::avx2, 0.2, 0.02));
  add(made_up("lobe", "cheap", 5, Width::avx2, 0.3, 0.004));
  add(made_up("lobe", "cheap", 3, Width::avx2, 0.5, 0.02));
  trade.forms[3].label = trade.forms[4].label = trade.forms[6].label = "cheap form, exp2 of degree 3";
  trade.forms[6].place = DataPlace::memory;
  add(made_up("lobe", "bad", 0, Width::avx2, 0.9, 0.1));
  add(made_up("other", "other", 0, Width::avx2, 0.3, 0.1));
  trade.goals = {{"fast", 45, false, 52},
                 {"slow", 45, false, 44},
                 {"near", 1.4, true, 1.4},
                 {"far", 1.4, true, 1.5},
                 {"absent", 2, false, {}}};
  relate(trade);
  return trade;
}

}  // namespace shadefit::bench::testing
