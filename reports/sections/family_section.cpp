#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/catalogue/family.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/citation.hpp"
#include "reports/rows/tables.hpp"

namespace shadefit {
namespace {

std::string number(double value) {
  return text(converged(value), Precision::report);
}

std::vector<const Assessment*> assessments_of(const Refit& refit, const Published& published) {
  std::vector<const Assessment*> found;
  const auto collect = [&](const std::vector<Assessment>& assessments) {
    for (const Assessment& a : assessments) {
      if (a.published == &published) found.push_back(&a);
    }
  };
  collect(refit.derived);
  for (const FitReport& report : refit.fits) collect(report.assessments);
  return found;
}

std::string statement_text(const Published& published) {
  if (published.convention.value) {
    return fmt::format("{} by the convention {}", published.parameter, published.convention.name);
  }
  switch (published.statement) {
    case Statement::mean_of_fits:
      return fmt::format("the mean of the best {} over k = {}", published.parameter, published.exponents);
    case Statement::limit_of_fits:
      return fmt::format("the best {} as k grows", published.parameter);
    case Statement::fit_somewhere:
      return fmt::format("the best {}, for exponents that are not stated", published.parameter);
    case Statement::best_fit:
      break;
  }
  return published.exponents.empty()
             ? fmt::format("the best {}", published.parameter)
             : fmt::format("the best {} at k = {}", published.parameter, published.exponents);
}

/// The exponents for which a number published without its exponent is right, under each measure.
std::string somewhere_sentence(const std::vector<const Assessment*>& found) {
  std::string out = fmt::format(" Verdict: **{}**.", name(found.front()->judgement.verdict));
  for (const Assessment* a : found) {
    out += a->holds_for
               ? fmt::format(
                     " Under the {} measure the best value is the printed one at k = {:.3g} and rounds to it "
                     "from {:.3g} to {:.3g}.",
                     name(a->metric.measure), a->holds_for->exactly, a->holds_for->from, a->holds_for->to)
               : fmt::format(" Under the {} measure it is the best value nowhere.", name(a->metric.measure));
  }
  return out;
}

/// One published number in words: its statement, the result under each measure, and the verdict.
std::string published_paragraph(const Refit& refit, const Published& published) {
  const auto found = assessments_of(refit, published);
  if (found.empty()) return "";
  std::string out = fmt::format("- **`{}`** is printed as **{}**: {} ({}).", published.id, published.printed,
                                statement_text(published), linked(published.source));
  if (published.statement == Statement::fit_somewhere) return out + somewhere_sentence(found) + "\n";
  out += " The fits give";
  for (const Assessment* a : found) {
    out += fmt::format("{} {} under the {} measure", a == found.front() ? "" : ",", number(a->computed),
                       name(a->metric.measure));
  }
  const Judgement& judgement = found.front()->judgement;
  out += fmt::format(". Verdict: **{}**", name(judgement.verdict));
  if (judgement.verdict == Verdict::rounding) {
    out += fmt::format("; off by one in the last printed digit under the {} measure", judgement.objective);
  } else if (judgement.verdict == Verdict::refuted) {
    out += "; no metric tried here gives the printed digits";
  } else if (judgement.objective == published.convention.name) {
    out += fmt::format("; not a best fit: its digits are those of the convention {}, {} = {}",
                       published.convention.name, published.convention.formula,
                       number(*published.convention.value));
  } else {
    out += fmt::format("; the printed digits come out under the {} measure", judgement.objective);
  }
  return out + fmt::format(". Effect: {}.\n", sentence(found.front()->effect, "the curve",
                                                       "the computed number instead of the printed one"));
}

/// The number published as the mean over a sweep, to be used at every exponent; null where there is none.
const Published* published_mean(const Refit& refit) {
  const auto found = std::ranges::find_if(
      refit.numbers, [](const Published* p) { return p->statement == Statement::mean_of_fits; });
  return found == refit.numbers.end() ? nullptr : *found;
}

/// One row per exponent: the best parameter under each measure, the errors under the first one, and the
/// errors of the published mean.
Table sweep_overview(const Refit& refit) {
  const std::string parameter(refit.family->parameters[0]);
  const Published* mean = published_mean(refit);
  Table table{{"k"}};
  for (const Measure measure : measures)
    table.columns.push_back(fmt::format("{} ({})", parameter, name(measure)));
  for (const char* column : {"rms error", "max abs error", "at c"}) {
    table.columns.push_back(fmt::format("{} ({})", column, name(measures.front())));
  }
  if (mean != nullptr)
    table.columns.push_back(fmt::format("max abs error at {} = {}", parameter, mean->printed));
  const std::size_t count = refit.fits.size() / measures.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Fit& first = refit.fits[i].fit;
    auto& row = table.rows.emplace_back(std::vector<Cell>{Number{*first.exponent, 10}});
    for (std::size_t m = 0; m < measures.size(); ++m)
      row.push_back(converged(refit.fits[m * count + i].fit.parameters[0]));
    row.insert(row.end(), {Number{first.rms_error, 4}, Number{first.max_abs_error.magnitude, 4},
                           place(first.max_abs_error.at)});
    if (mean != nullptr) {
      const std::array fixed{constant<double>(mean->printed)};
      row.push_back(Number{refit.family->largest_error(*first.exponent, {}, fixed).magnitude, 4});
    }
  }
  return table;
}

/// The largest error of a fit relative to the reflectance.
Extremum relative_error_of(const Fit& fit) {
  return fit.family->largest_error(setting_of(fit), {.error = Error::relative}, fit.parameters);
}

/// One row per measure.
Table single_overview(const Refit& refit) {
  Table table{{"measure"}};
  for (const std::string& parameter : refit.family->parameters) table.columns.emplace_back(parameter);
  table.columns.insert(table.columns.end(), {"rms error", "max abs error", "max abs error at c",
                                             "max rel error", "max rel error at c", "digits"});
  for (const FitReport& report : refit.fits) {
    const Fit& fit = report.fit;
    auto& row = table.rows.emplace_back(std::vector<Cell>{std::string(name(fit.metric.measure))});
    for (const double p : fit.parameters) row.push_back(converged(p));
    const Extremum relative = relative_error_of(fit);
    row.insert(row.end(),
               {Number{fit.rms_error, 4}, Number{fit.max_abs_error.magnitude, 4}, place(fit.max_abs_error.at),
                Number{relative.magnitude, 4}, place(relative.at), static_cast<long>(fit.digits)});
  }
  return table;
}

/// Mistyped copies in circulation, and their effect on the curve.
std::string variants_section(const Refit& refit) {
  Table table{{"constant", "printed", "found as", "seen in", "effect"}};
  const auto& family = *refit.family;
  const auto best = refit.fits.front().fit;
  for (const Published* number : refit.numbers) {
    const Published& published = *number;
    const auto i = parameter_index(family, published.parameter);
    for (const Variant& variant : published.variants) {
      auto from = best.parameters, to = from;
      from[i] = constant<double>(published.printed);
      to[i] = constant<double>(variant.printed);
      table.rows.push_back({published.id, published.printed, variant.printed, variant.seen_in,
                            sentence(family.effect(setting_of(best), best.metric.domain, from, to))});
    }
  }
  return table.rows.empty() ? "" : "Mistyped copies in circulation:\n\n" + markdown_block(table);
}

/// The law that was derived for a family under a measure, if one was.
std::optional<ApproachLaw<double>> derived_law(const Refit& refit, Measure measure) {
  const auto expansion = peak_expansion(measure);
  if (refit.family->id == "sg-offset") return offset_law(expansion.p, expansion.w);
  if (refit.family->id == "phong-blinn") return factor_law(expansion.p);
  return std::nullopt;
}

/// If a published number is a limit: the derived law and the extrapolation of the fits.
std::string law_section(const Refit& refit) {
  if (std::ranges::none_of(refit.numbers,
                           [](const Published* p) { return p->statement == Statement::limit_of_fits; }))
    return "";
  Table table{{"measure", "limit derived", "limit fitted", "slope derived", "slope fitted"}};
  FitCache fits(*refit.family);
  for (const Measure measure : measures) {
    const auto law = derived_law(refit, measure);
    const auto fitted = law ? extrapolate(fits, {.measure = measure}, 0) : std::nullopt;
    if (!fitted) continue;
    // The extrapolated slope is a difference of parameters over 1e-4: 1e-16 of them is 1e-12, the cubic term
    // 1e-9.
    table.rows.push_back({std::string(name(measure)), converged(law->limit), converged(fitted->limit),
                          converged(law->slope), Number{fitted->slope, 6}});
  }
  if (table.rows.empty()) return "";
  return fmt::format(
      "For large k the best {0} follows {0}(k) = limit + slope / k. The derived values come from "
      "an asymptotic expansion (in approx/), the fitted ones are extrapolated from the fits at k = 1e4, 1e5, "
      "1e6:\n\n{1}",
      refit.family->parameters[0], markdown_block(table));
}

std::string sweep_words(const Refit& refit) {
  const FitReport* worst = &refit.fits.front();
  const FitReport* last = worst;
  for (const FitReport& report : refit.fits) {
    if (report.fit.metric.measure != measures.front()) break;
    if (report.fit.max_abs_error.magnitude > worst->fit.max_abs_error.magnitude) worst = &report;
    last = &report;
  }
  if (worst == last) {
    return fmt::format("The best curve is off by at most {:.3g} at c = {:.3g} (the peak is 1).\n\n",
                       worst->fit.max_abs_error.magnitude, worst->fit.max_abs_error.at.cos_theta);
  }
  return fmt::format(
      "The error of the best curve is largest at k = {}, {:.3g} at c = {:.3g} (the peak is 1), and falls "
      "with k: {:.3g} at k = {}.{}\n\n",
      *worst->fit.exponent, worst->fit.max_abs_error.magnitude, worst->fit.max_abs_error.at.cos_theta,
      last->fit.max_abs_error.magnitude, *last->fit.exponent,
      published_mean(refit) != nullptr
          ? " The last column is the error if the published mean is used at every k."
          : "");
}

std::string single_words(const Refit& refit) {
  const Fit& fit = refit.fits.front().fit;
  const Extremum relative = relative_error_of(fit);
  return fmt::format(
      "Under the {} measure the best curve is off by at most {:.3g} at c = {:.3g}. A shader shows "
      "F = f0 + (1 - f0) f, f0 = {}: the largest relative error of F is {:.3g}, at c = {:.3g}.\n\n",
      name(fit.metric.measure), fit.max_abs_error.magnitude, fit.max_abs_error.at.cos_theta, reference_f0,
      relative.magnitude, relative.at.cos_theta);
}

/// The two formulas as text and as mathematics, and the operations of a shader for each.
Table formulas_table(const Family& family) {
  Table table{{"", "formula", "typeset", "operations"}};
  const auto add = [&](const std::string& name, const Symbolic& formula) {
    table.rows.push_back({name, fmt::format("`{}`", to_text(formula)), fmt::format("${}$", to_latex(formula)),
                          to_text(count_operations(formula))});
  };
  add("target", family.target);
  add("form", family.form);
  return table;
}

std::string figures_section(const std::vector<Figure>& figures, std::string_view family) {
  std::string out;
  for (const Figure& figure : figures) {
    if (figure.family == family)
      out += fmt::format("![{0}](plots/{0}.svg)\n\n{1}\n\n", figure.name, for_markdown(figure.caption));
  }
  return out;
}

}  // namespace

std::string family_section(const Refit& refit, const std::vector<Figure>& figures) {
  const Family& info = *refit.family;
  std::string out = fmt::format("## {} (`{}`)\n\n", info.title, info.id) +
                    markdown_block(formulas_table(*refit.family)) + fmt::format("{}.\n\n", info.variables);
  const bool all_converged =
      std::ranges::all_of(refit.fits, [](const FitReport& r) { return r.fit.status == Status::converged; });
  if (!all_converged) return out + "Not every fit converged: see the verdicts in `fits.csv`.\n\n";
  for (const Published* number : refit.numbers) out += published_paragraph(refit, *number);
  out += "\n";
  if (refit.family->has_exponent()) {
    out += markdown_block(sweep_overview(refit)) + sweep_words(refit) + law_section(refit);
  } else {
    out += markdown_block(single_overview(refit)) + single_words(refit);
  }
  return out + figures_section(figures, info.id) + variants_section(refit);
}

}  // namespace shadefit
