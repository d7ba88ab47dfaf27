#pragma once

#include "fit/ledger/claim_numbers.hpp"

/// The places and the searches of claims that are data: fit/ledger/computation.hpp has their notation.
namespace shadefit {

template <class T>
void ClaimNumbers<T>::at(std::string_view places, const Visit& visit) {
  const auto comma = places.find(", "), in = places.find(" in ");
  const std::string name(places.substr(0, in));
  const std::string_view range = places.substr(in + 4, comma - in - 4);
  const Visit next =
      comma == std::string_view::npos ? visit : [&, rest = places.substr(comma + 2)] { at(rest, visit); };
  T index = 0;
  if (const auto dots = range.find(" .. "); dots != std::string_view::npos) {
    const T last = value(range.substr(dots + 4));
    for (T i = value(range.substr(0, dots)); i <= last; i += 1) bound_.with({{name, i}}, next);
  } else if (range.starts_with(words_of)) {
    for (const std::string& word : items_of(given_text(claim_, range.substr(words_of.size())), ' ')) {
      if (word == "/") continue;
      const auto read_number = parse_number(word);
      bound_.with({{name, read_number ? T(*read_number) : number(word)}, {name + "_place", index++}}, next);
    }
  } else if (range == "printed") {
    for (const Quantity& printed : claim_.printed)
      bound_.with({{"printed_" + name, constant<T>(printed.value)}, {name, index++}}, next);
  } else if (range == "conventions") {
    for (const TransferFunction& t : conventions_of(claim_))
      bound_.with({{name + "_gamma", T(t.gamma)}, {name + "_codes", T(t.codes)}, {name, index++, t.name}},
                  next);
  } else if (const std::string_view list = given_text(claim_, range);
             list.find(':') != std::string_view::npos) {
    for (const double x : parse_sweep(list)) bound_.with({{name, T(x)}}, next);
  } else {
    for (const std::string& item : items_of(list)) {
      const auto number = parse_number(item.substr(item.rfind(' ') + 1));
      bound_.with({{name, number ? T(*number) : index, item}}, next);
      index += 1;
    }
  }
}

template <class T>
T ClaimNumbers<T>::largest_at(std::string_view places, std::string_view formula) {
  std::optional<T> most;
  Read& of = read(formula);
  at(places, [&] {
    const T now = value(of, formula);
    if (!most || now > *most) most = now;
  });
  return most.value_or(0);
}

/// The place where a formula is largest, as the value of another; of values equal to rounding, the first.
template <class T>
T ClaimNumbers<T>::where_largest(std::string_view places, std::string_view formula, std::string_view place) {
  std::optional<T> most;
  T found = 0;
  Read& of = read(formula);
  at(places, [&] {
    const T now = value(of, formula);
    if (most && now <= *most + T(equal_extrema) * abs(*most)) return;
    most = now;
    found = value(place);
  });
  return found;
}

template <class T>
T ClaimNumbers<T>::searched(const Line& line) {
  const std::string_view kind = line.at(1);
  if (kind == "most") return largest_at(line.at(2), line.at(3));
  if (kind == "place") return where_largest(line.at(2), line.at(3), line.at(4));
  if (kind == "sum" || kind == "count") {
    T sum = 0;
    const std::string text = kind == "sum" ? std::string(line.at(3)) : choice(line.at(3));
    Read& of_place = read(text);
    at(line.at(2), [&] { sum += value(of_place, text); });
    return sum;
  }
  if (kind == "root") {
    const auto holds_at = function(line.at(2), choice(line.at(5)));
    return T(last_by_halving(rounded(line.at(3)), rounded(line.at(4)), 60,
                             [&](double x) { return holds_at(x) != 0; }));
  }
  if (kind == "doubt") return T(found_by(*line_of(line.at(2))).doubt);
  if (kind == "largest") return T(largest_magnitude(curve(line.at(2)), Substitution({}, {})).magnitude);
  if (kind == "largest-at") return T(largest_magnitude(curve(line.at(2)), Substitution({}, {})).at.cos_theta);
  if (kind == "sampled") return T(largest_sampled(function(line.at(2), std::string(line.at(3)))));
  if (kind == "optimum")
    return T(
        find_family(line.at(2))->fit({}, {}).parameters[static_cast<std::size_t>(number_of(line.at(3)))]);
  if (kind == "units")
    return T(static_cast<double>(units_off(given_text(claim_, line.at(2)), rounded(line.at(3)))));
  if (kind == "unit") return T(last_unit(given_text(claim_, line.at(2))));
  if (kind == "in")
    return T(in_format_of(line.at(2), [&]<class Format>() { return in<Format>(line.at(3)); }));
  if (kind == "last")
    return T(in_format_of(line.at(2), [&]<class Format>() { return last_in<Format>(line); }));
  if (kind == "least")
    return T(
        in_format_of(line.at(2), []<class Format>() { return widened(std::numeric_limits<Format>::min()); }));
  if (kind == "greatest")
    return T(
        in_format_of(line.at(2), []<class Format>() { return widened(std::numeric_limits<Format>::max()); }));
  if constexpr (!std::same_as<T, double>) {
    static const RootsOfTwo<T> roots;
    if (kind == "squares") return log2_by_squares(value(line.at(2)));
    if (kind == "roots") return roots.exp2(value(line.at(2)));
  }
  throw std::logic_error(fmt::format("{} computes nothing by '{}'", claim_.id, kind));
}

}  // namespace shadefit
