#include "reports/rows/tables.hpp"

#include <fmt/format.h>

#include "fit/catalogue/family.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {
namespace {

/// The published number, its difference from the fit, and the verdict; empty if nothing was published.
struct PublishedCells {
  Cell published, deviation, verdict, source;
};

PublishedCells published_cells(const Assessment* assessment) {
  if (assessment == nullptr) return {};
  const double printed = constant<double>(assessment->published->printed);
  return {word(assessment->published->printed),
          difference(assessment->computed - printed, assessment->computed),
          word(name(assessment->judgement.verdict)), word(citation(assessment->published->source))};
}

/// The error of the curve as published: all the parameters that the same source prints together.
Cell error_as_published(const Refit& refit, const FitReport& report, const Assessment* assessment) {
  if (assessment == nullptr) return {};
  auto parameters = report.fit.parameters;
  const auto take = [&](const Published& number) {
    parameters[parameter_index(*refit.family, number.parameter)] = constant<double>(number.printed);
  };
  for (const Assessment& other : report.assessments)
    if (other.published->source.place == assessment->published->source.place) take(*other.published);
  take(*assessment->published);
  return converged(
      refit.family->largest_error(setting_of(report.fit), {.domain = report.fit.metric.domain}, parameters)
          .magnitude);
}

std::vector<Cell> row_start(const Refit& refit, const std::string& parameter,
                            std::optional<double> exponent) {
  return {word(refit.family->id), parameter, exponent ? Cell(Number{*exponent, 10}) : Cell()};
}

void append(std::vector<Cell>& row, std::initializer_list<Cell> cells) {
  row.insert(row.end(), cells);
}

void append_metric(std::vector<Cell>& row, const Refit& refit, const Metric& metric) {
  append(row, {to_text(refit.family->target), to_text(refit.family->form), to_text(metric.domain),
               word(name(metric.measure)), word(name(metric.norm))});
}

void add_fit_row(FitsTable& out, const Refit& refit, const FitReport& report, std::size_t parameter,
                 const Assessment* assessment) {
  const Fit& fit = report.fit;
  const bool is_answer = fit.status == Status::converged;
  const auto cells = published_cells(assessment);
  auto row = row_start(refit, std::string(refit.family->parameters[parameter]), fit.exponent);
  append(row, {cells.published, is_answer ? converged(fit.parameters[parameter]) : Cell(), cells.deviation,
               is_answer ? cells.verdict : word(name(fit.status))});
  append_metric(row, refit, fit.metric);
  if (is_answer)
    append(row,
           {converged(fit.rms_error), converged(fit.max_abs_error.magnitude), place(fit.max_abs_error.at),
            error_as_published(refit, report, assessment), static_cast<long>(fit.digits)});
  row.resize(out.table.columns.size() - 1);
  row.push_back(cells.source);
  out.table.rows.push_back(row);
  out.origins.push_back({&refit, &report, parameter});
}

/// "x_mean", "x_limit"; a number published without its exponent is "x" at the exponent where it is exact.
std::string derived_parameter(const Published& published) {
  const std::string parameter(published.parameter);
  if (published.statement == Statement::mean_of_fits) return parameter + "_mean";
  return published.statement == Statement::limit_of_fits ? parameter + "_limit" : parameter;
}

void add_derived_row(FitsTable& out, const Refit& refit, const Assessment& assessment) {
  const auto cells = published_cells(&assessment);
  const auto& range = assessment.holds_for;
  auto row = row_start(refit, derived_parameter(*assessment.published),
                       range ? std::optional(range->exactly) : std::nullopt);
  append(row, {cells.published, converged(assessment.computed), cells.deviation, cells.verdict});
  append_metric(row, refit, assessment.metric);
  append(row, {{}, {}, {}, {}, {}, cells.source});
  out.table.rows.push_back(row);
  out.origins.push_back({&refit, nullptr, 0});
}

/// The metric that gives a published number, and for which exponents.
std::string under(const Assessment& assessment) {
  const auto& range = assessment.holds_for;
  if (!range) return assessment.judgement.objective;
  return fmt::format("{}, k = {:.3g} to {:.3g}", assessment.judgement.objective, range->from, range->to);
}

}  // namespace

FitsTable fits_table(const std::vector<Refit>& refits) {
  FitsTable out;
  out.table.columns = {"constant",  "parameter",     "exponent",         "published",
                       "fitted",    "deviation",     "verdict",          "target",
                       "form",      "domain",        "measure",          "norm",
                       "rms_error", "max_abs_error", "max_abs_error_at", "published_max_abs_error",
                       "digits",    "source"};
  for (const Refit& refit : refits) {
    for (const FitReport& report : refit.fits) {
      for (std::size_t i = 0; i < refit.family->parameters.size(); ++i) {
        bool is_published = false;
        for (const Assessment& assessment : report.assessments) {
          if (assessment.published->parameter != refit.family->parameters[i]) continue;
          add_fit_row(out, refit, report, i, &assessment);
          is_published = true;
        }
        if (!is_published) add_fit_row(out, refit, report, i, nullptr);
      }
    }
    for (const Assessment& assessment : refit.derived) add_derived_row(out, refit, assessment);
  }
  return out;
}

Table normalisation_table(const std::vector<NormalisationCheck>& checks) {
  Table table{{"constant", "exponent", "closed_form", "integral", "relative_difference", "estimated_error",
               "verdict"}};
  for (const auto& check : checks) {
    const bool is_good = check.estimated_error <= normalisation_tolerance;
    const std::string_view verdict = check.verdict ? name(*check.verdict) : name(Status::not_converged);
    // A stand-in that is close has other digits: that confirms no number.
    const bool is_close = check.record->closeness > 0 && check.verdict == Verdict::confirmed;
    table.rows.push_back({word(check.record->id), check.exponent ? Cell(Number{*check.exponent, 10}) : Cell(),
                          converged(check.closed_form), converged(check.integral),
                          above_floor(check.relative_difference, normalisation_tolerance),
                          Number{is_good ? normalisation_tolerance : check.estimated_error, 2},
                          word(is_close ? "close" : verdict)});
  }
  return table;
}

Table summary_table(const Results& results) {
  Table table{{"constant", "printed", "computed", "verdict", "under", "digits of the fit"}};
  // A published number is judged under the first measure first; that assessment is its verdict.
  const auto add = [&](const Assessment& assessment, Cell digits) {
    if (assessment.metric.measure != measures.front()) return;
    table.rows.push_back({word(assessment.published->id), word(assessment.published->printed),
                          converged(assessment.judgement.value), word(name(assessment.judgement.verdict)),
                          word(under(assessment)), digits});
  };
  for (const Refit& refit : results.refits) {
    for (const Assessment& assessment : refit.derived) add(assessment, {});
    for (const FitReport& report : refit.fits) {
      for (const Assessment& assessment : report.assessments)
        add(assessment, static_cast<long>(report.fit.digits));
    }
  }
  // The integrals belong to the claim with the same id.
  const auto judged = [&](const Normalisation& record, Verdict of_integrals) {
    for (const JudgedClaim& claim : results.claims) {
      if (claim.claim->id == record.id) return claim.finding.verdict.value_or(of_integrals);
    }
    return of_integrals;
  };
  for (const Normalisation& record : normalisations) {
    long confirmed = 0, all = 0;
    for (const auto& check : results.normalisations) {
      if (check.record->id != record.id) continue;
      ++all;
      confirmed += check.verdict == Verdict::confirmed;
    }
    if (all == 0) continue;
    table.rows.push_back(
        {word(record.id),
         word(record.printed),
         record.closeness == 0 ? fmt::format("{} of {} integrals agree", confirmed, all)
                               : fmt::format("{} of {} within {}", confirmed, all, record.closeness),
         word(name(judged(record, confirmed == all ? Verdict::confirmed : Verdict::refuted))),
         std::string("v = n"),
         {}});
  }
  return table;
}

}  // namespace shadefit
