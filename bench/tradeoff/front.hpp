#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

/// The Pareto front of many offers.
namespace shadefit::bench {

/// The cost and the error of an offer; less of either is better.
struct Offer {
  double time;
  double error;
};

/// The indices of the offers that no other offer dominates, the fastest and least accurate first. Of equal
/// offers the first is kept. An offer with NaN is never on the front.
inline std::vector<std::size_t> front_of(const std::vector<Offer>& offers) {
  std::vector<std::size_t> order(offers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) {
    return !(offers[i].time == offers[i].time && offers[i].error == offers[i].error);
  });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return offers[i].time != offers[j].time ? offers[i].time < offers[j].time
                                            : offers[i].error < offers[j].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || offers[i].error < offers[front.back()].error) front.push_back(i);
  }
  return front;
}

}  // namespace shadefit::bench
