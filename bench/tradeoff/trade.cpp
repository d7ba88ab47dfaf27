#include "bench/tradeoff/trade.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "bench/forms/forms.hpp"

namespace shadefit::bench {
namespace {

bool are_alike(const TimedForm& a, const TimedForm& b) {
  return precision_of(a) == precision_of(b) && a.place == b.place;
}

template <class Condition>
const TimedForm* first_where(const std::vector<TimedForm>& rows, const Condition& condition) {
  const auto found = std::find_if(rows.begin(), rows.end(), condition);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

void TimedForm::take(const Samples& samples, const Work& work) {
  real = samples.real;
  cpu = samples.cpu;
  ns = spread_of(real);
  elements = samples.calls * static_cast<long>(work.elements);
}

std::string name(DataPlace place) {
  return place == DataPlace::first_cache ? "L1" : "memory";
}

std::string precision_of(const TimedForm& timed) {
  if (timed.on_device && timed.on_device->is_half) return "half";
  return timed.is_double ? "double" : "float";
}

std::string full_id(const TimedForm& timed) {
  return timed.exp2_degree == 0 ? timed.form : timed.form + "/exp2-" + std::to_string(timed.exp2_degree);
}

bool is_same_kernel(const TimedForm& a, const TimedForm& b) {
  return a.target == b.target && a.form == b.form && a.exp2_degree == b.exp2_degree && a.width == b.width &&
         precision_of(a) == precision_of(b);
}

bool is_same_way(const TimedForm& a, const TimedForm& b) {
  return is_same_kernel(a, b) && a.constants == b.constants && a.place == b.place;
}

const TimedForm* in_memory(const Trade& trade, const TimedForm& timed) {
  return first_where(trade.forms, [&](const TimedForm& other) {
    return is_same_kernel(other, timed) && other.constants == timed.constants &&
           other.place == DataPlace::memory;
  });
}

const TimedForm* reference_of(const Trade& trade, const TimedForm& timed) {
  return first_where(trade.forms, [&](const TimedForm& other) {
    return other.is_reference && other.target == timed.target && other.width == forms::Width::scalar &&
           are_alike(other, timed);
  });
}

void relate(Trade& trade) {
  for (TimedForm& timed : trade.forms) {
    const auto floor_of = [&](std::string_view form) {
      return first_where(trade.copies, [&](const TimedForm& floor) {
        return floor.form == form && floor.width == timed.width && are_alike(floor, timed);
      });
    };
    if (const auto* copy = floor_of(forms::Copy::id)) timed.copies = timed.ns.median / copy->ns.median;
    const auto* additions = timed.on_device ? nullptr : floor_of(forms::MultiplyAdds::id);
    if (additions != nullptr)
      timed.multiply_adds = forms::MultiplyAdds::count * timed.ns.median / additions->ns.median;
    if (const auto* reference = reference_of(trade, timed))
      timed.pows = reference->ns.median / timed.ns.median;
  }
}

std::vector<TimedForm> fastest_of(const Trade& trade, const std::string& target) {
  std::vector<TimedForm> fastest;
  for (const TimedForm& timed : trade.forms) {
    if (timed.target != target || timed.place != DataPlace::first_cache || !timed.max_abs_error) continue;
    const auto same = std::find_if(fastest.begin(), fastest.end(), [&](const TimedForm& known) {
      return known.form == timed.form && known.constants == timed.constants &&
             known.exp2_degree == timed.exp2_degree && precision_of(known) == precision_of(timed);
    });
    if (same == fastest.end()) {
      fastest.push_back(timed);
    } else if (timed.ns.median < same->ns.median) {
      *same = timed;
    }
  }
  return fastest;
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

std::vector<TimedForm> front_of_target(const Trade& trade, const std::string& target) {
  return front_among(fastest_of(trade, target));
}

std::vector<TimedForm> front_among(const std::vector<TimedForm>& forms) {
  std::vector<Offer> offers;
  for (const TimedForm& form : forms) offers.push_back({form.ns.median, *form.max_abs_error});
  std::vector<TimedForm> front;
  for (const std::size_t i : front_of(offers)) front.push_back(forms[i]);
  return front;
}

}  // namespace shadefit::bench
