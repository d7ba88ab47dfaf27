#include "bench/tradeoff/trade.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace shadefit::bench {

std::string precision_of(const TimedForm& timed) {
  return timed.is_half ? "half" : "float";
}

std::string full_id(const TimedForm& timed) {
  return timed.exp2_degree == 0 ? timed.form : timed.form + "/exp2-" + std::to_string(timed.exp2_degree);
}

void relate(Trade& trade) {
  for (TimedForm& timed : trade.forms) {
    const auto reference = std::ranges::find_if(trade.forms, [&](const TimedForm& other) {
      return other.is_reference && other.target == timed.target && other.is_half == timed.is_half;
    });
    if (reference != trade.forms.end()) timed.speed_up = reference->ns.median / timed.ns.median;
  }
}

std::vector<TimedForm> shown_forms(const Trade& trade, const std::string& target) {
  std::vector<TimedForm> shown;
  for (const TimedForm& timed : trade.forms) {
    if (timed.target != target) continue;
    const auto same = std::ranges::find_if(shown, [&](const TimedForm& other) {
      return full_id(other) == full_id(timed) && other.is_half == timed.is_half;
    });
    if (trade.shows_all_sets || same == shown.end()) {
      shown.push_back(timed);
    } else if (timed.max_abs_error < same->max_abs_error) {
      *same = timed;
    }
  }
  std::ranges::stable_sort(shown, {},
                           [](const TimedForm& row) { return std::pair(row.ns.median, row.max_abs_error); });
  return shown;
}

std::vector<std::size_t> front_of(const std::vector<Offer>& offers) {
  std::vector<std::size_t> order(offers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) {
    return !(offers[i].time == offers[i].time && offers[i].error == offers[i].error);
  });
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::pair(offers[i].time, offers[i].error); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || offers[i].error < offers[front.back()].error) front.push_back(i);
  }
  return front;
}

std::vector<std::size_t> front_among(const std::vector<TimedForm>& forms) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Offer> offers;
  for (const TimedForm& form : forms)
    offers.push_back({form.ns.median, form.max_abs_error.value_or(unknown)});
  return front_of(offers);
}

}  // namespace shadefit::bench
