#include "reports/studies/study_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit {
namespace {

constexpr int slices_height = 260;

/// Formulas with constants along the first variable; the others are fixed.
struct Slice {
  const ReadStudy* study;
  const std::vector<double>* parameters;
  std::vector<double> fixed;  ///< the values of the variables after the first

  /// A formula at a value of the first variable, or at a measured row.
  double at(const Symbolic& formula, double x, std::size_t row = 0) const {
    return evaluate<double>(formula, [&](const std::string& name) {
      if (study->rows && name == "value") return study->rows->value[row];
      if (study->rows && name == "sigma") return study->rows->sigma[row];
      for (std::size_t i = 0; i < study->axes.size(); ++i) {
        if (study->axes[i].variable == name) return i == 0 ? x : fixed[i - 1];
      }
      const auto found = std::ranges::find(study->parameters, name);
      return parameters->at(static_cast<std::size_t>(found - study->parameters.begin()));
    });
  }

  /// The measured rows that lie on it; of very many some.
  std::vector<std::size_t> rows() const {
    std::vector<std::size_t> found;
    const auto& places = study->rows->places;
    for (std::size_t row = 0; row < study->rows->value.size(); ++row) {
      bool is_on = true;
      for (std::size_t i = 0; i < fixed.size(); ++i) is_on = is_on && places[i + 1][row] == fixed[i];
      if (is_on) found.push_back(row);
    }
    // More points would be hundreds of megabytes.
    constexpr std::size_t most = 100'000, drawn = 20'000;
    if (found.size() <= most) return found;
    std::vector<std::size_t> some;
    for (const std::size_t place : drawn_from(found.size(), drawn)) some.push_back(found[place]);
    return some;
  }
};

void require_drawable(std::size_t variables) {
  if (variables > 2)
    throw UserError(fmt::format("--plot draws one or two variables: the study has {}", variables));
}

/// Four values of the second variable, from one end to the other; of measured rows, values that they have.
std::vector<double> drawn_levels(const ReadStudy& study) {
  const StudyAxis& axis = study.axes.at(1);
  std::vector<double> levels;
  if (study.rows) {
    levels = study.rows->places[1];
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  }
  std::vector<double> drawn;
  for (std::size_t i = 0; i < curve_looks.size(); ++i) {
    const double share = static_cast<double>(i) / (curve_looks.size() - 1);
    if (levels.empty())
      drawn.push_back(axis.lower + (axis.upper - axis.lower) * share);
    else
      drawn.push_back(levels[(levels.size() - 1) * i / (curve_looks.size() - 1)]);
  }
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  return drawn;
}

std::string range_of(const StudyAxis& axis) {
  return fmt::format("set xrange [{:.9g}:{:.9g}]\n", axis.lower, axis.upper);
}

/// "g = 0.5", or the constants of the only fit.
std::string label_of(const FittedStudy& study) {
  if (!study.asked().given.empty()) return given_text(study.asked());
  return equations(study.fit.names, study.fit.parameters, [](double value) { return in_digits(value, 7); });
}

/// The slices of the figure, at most four, with their labels: of each fit, or of the first at several values
/// of the second variable.
std::vector<std::pair<Slice, std::string>> slices_of(const std::vector<FittedStudy>& studies) {
  std::vector<std::pair<Slice, std::string>> slices;
  for (const FittedStudy& study : studies) {
    if (study.fit.status != Status::converged || slices.size() == curve_looks.size()) continue;
    if (study.read.axes.size() == 1) {
      slices.push_back({{&study.read, &study.fit.parameters, {}}, label_of(study)});
      continue;
    }
    for (const double level : drawn_levels(study.read)) {
      const std::string value = in_digits(level, 4);
      slices.push_back({{&study.read, &study.fit.parameters, {level}},
                        fmt::format("{} = {}", study.read.axes[1].variable, value)});
    }
    break;
  }
  return slices;
}

/// What the error curves show: the error that the study minimises. That of a row is its residual.
std::string words_of_error(const Study& asked) {
  if (asked.rows) return curve_in_words("max_abs_error");
  return curve_in_words(asked.weight != "1"              ? "max_weighted_error"
                        : asked.error == Error::relative ? "max_rel_error"
                                                         : "max_abs_error");
}

/// Appends the places where a minimax fit of one variable has its level.
void append_contacts(const FittedStudy& study, const Slice& slice, Table& table) {
  table.columns.emplace_back("contact");
  for (auto& row : table.rows) row.emplace_back();
  const Symbolic error = weighted_error_of(study.read).form;
  for (const AlternationPoint& contact : study.fit.alternation) {
    auto& row = table.rows.emplace_back(table.columns.size());
    row.front() = plotted(contact.at.cos_theta);
    row.back() = plotted(slice.at(error, contact.at.cos_theta));
  }
}

/// The target, the form and the error of each slice. Of measured rows, target and error are known at these
/// only.
std::vector<DrawnCurve> drawn_of(const std::vector<std::pair<Slice, std::string>>& slices) {
  std::vector<DrawnCurve> drawn;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& slice = slices[i].first;
    const bool is_measured = slice.study->rows != nullptr, are_several = slices.size() > 1 && !is_measured;
    const std::string label = for_gnuplot(slices[i].second), number = fmt::to_string(i + 1);
    const auto along = [&](const Symbolic& formula) {
      return [slice, formula](double x) { return slice.at(formula, x); };
    };
    const auto unless_measured = [&](const Symbolic& formula) -> std::function<double(double)> {
      if (!is_measured) return along(formula);
      return [](double) { return NAN; };
    };
    drawn.push_back({{"target_" + number,
                      is_measured   ? "rows"
                      : are_several ? "target, " + label
                                    : "target",
                      are_several ? target_looks.at(i) : Look::target, false, is_measured, !is_measured},
                     unless_measured(slice.study->target)});
    drawn.push_back({{"form_" + number, label, curve_looks.at(i)}, along(slice.study->form)});
    drawn.push_back({{"error_" + number, label, curve_looks.at(i), false, is_measured, !is_measured},
                     unless_measured(weighted_error_of(*slice.study).form)});
  }
  return drawn;
}

/// Appends the measured rows on each slice, below its columns of `drawn_of`.
void append_rows_of(const std::vector<std::pair<Slice, std::string>>& slices, Table& table) {
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& slice = slices[i].first;
    if (!slice.study->rows) continue;
    for (const std::size_t measured : slice.rows()) {
      const double x = slice.study->rows->places[0][measured], value = slice.study->rows->value[measured];
      auto& row = table.rows.emplace_back(table.columns.size());
      row[0] = plotted(x);
      row[1 + 3 * i] = plotted(value);
      row[3 + 3 * i] = plotted(slice.at(slice.study->form, x) - value);
    }
  }
}

}  // namespace

Figure study_figure(const std::vector<FittedStudy>& studies) {
  const ReadStudy& first = studies.front().read;
  require_drawable(first.axes.size());
  const auto slices = slices_of(studies);
  if (slices.empty()) throw UserError("--plot has nothing to draw: no fit converged");
  const StudyAxis& axis = first.axes.front();
  const std::vector<DrawnCurve> drawn = drawn_of(slices);
  Table table = table_for({axis.variable}, drawn);
  append_rows(table, {}, drawn, even_places(axis.lower, axis.upper, 2 * plot_steps));
  append_rows_of(slices, table);
  Panel curves{.title = for_gnuplot(study_headline(studies.front())),
               .y_label = "value",
               .settings = range_of(axis),
               .abscissa = axis.variable};
  Panel errors{.x_label = for_gnuplot(axis.variable),
               .y_label = words_of_error(studies.front().asked()),
               .settings = range_of(axis),
               .abscissa = axis.variable};
  for (std::size_t i = 0; i < drawn.size(); ++i)
    (i % 3 == 2 ? errors : curves).curves.push_back(drawn[i].curve);
  const FittedStudy& study = studies.front();
  if (studies.size() == 1 && first.axes.size() == 1 && study.fit.level) {
    append_contacts(study, slices.front().first, table);
    const std::string level = in_digits(*study.fit.level, 4);
    errors.levels = {{level, "level " + level}, {"-" + level, ""}};
    errors.curves.push_back({"contact", "contacts", Look::second, false, true, false});
  }
  errors.settings += "set yrange " + range_around(table, errors.curves) + "\n";
  const Plot plot{.name = "fit",
                  .about = "A fit, and its error.",
                  .columns = 1,
                  .panel_height = slices_height,
                  .panels = {curves, errors}};
  return figure_of(plot, "", plot.about, table);
}

Figure better_study_figure(const StudyComparison& comparison) {
  require_drawable(comparison.variables.size());
  std::vector<const StudyContender*> shown;
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.published != nullptr && shown.size() + 1 < curve_looks.size()) shown.push_back(&contender);
  }
  const StudyContender* published = first_published(comparison);
  const StudyContender* best = published != nullptr ? better_at_the_same_cost(comparison, *published)
                               : comparison.contenders.empty() ? nullptr
                                                               : &comparison.contenders.front();
  if (best != nullptr) shown.push_back(best);
  if (shown.empty()) throw UserError("--plot has nothing to draw: no fit converged");
  const std::string& variable = comparison.variables.front();
  Table table{{variable}};
  const auto& measured = comparison.study.rows;
  Panel panel{.title = for_gnuplot(measured ? measured->file : comparison.study.target),
              .x_label = for_gnuplot(variable),
              .y_label = curve_in_words(comparison.error),
              .abscissa = variable};
  // Of two variables: at the value of the second where the first curve has its largest error.
  std::vector<double> fixed(shown.front()->max_error.at.begin() + 1, shown.front()->max_error.at.end());
  if (!fixed.empty())
    panel.title +=
        for_gnuplot(fmt::format("   at {} = {}", comparison.variables[1], in_digits(fixed.front(), 4)));
  std::vector<ReadStudy> read;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    read.push_back(formulas_of(comparison, *shown[i]));
    const std::string column = fmt::format("error_{}", i + 1);
    table.columns.push_back(column);
    panel.curves.push_back({column,
                            for_gnuplot(shown[i]->form + ": " +
                                        (shown[i]->published != nullptr ? short_source(shown[i]->origin)
                                                                        : "best, " + shown[i]->origin)),
                            curve_looks.at(i)});
  }
  const StudyAxis& axis = read.front().axes.front();
  // Measured rows are the only places where the error is known.
  const bool is_measured = read.front().rows != nullptr;
  const Slice first{&read.front(), &shown.front()->values, fixed};
  const auto rows = is_measured ? first.rows() : std::vector<std::size_t>{};
  std::vector<double> places =
      is_measured ? std::vector<double>{} : even_places(axis.lower, axis.upper, 2 * plot_steps);
  for (const std::size_t row : rows) places.push_back(read.front().rows->places[0][row]);
  for (std::size_t place = 0; place < places.size(); ++place) {
    auto& cells = table.rows.emplace_back(std::vector<Cell>{plotted(places[place])});
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const Slice slice{&read[i], &shown[i]->values, fixed};
      cells.push_back(
          plotted(slice.at(weighted_error_of(read[i]).form, places[place], is_measured ? rows[place] : 0)));
    }
  }
  panel.settings = range_of(axis) + "set yrange " + range_around(table, panel.curves) + "\n";
  const Plot plot{.name = "better",
                  .about = fmt::format("Errors of the published constants and of the best curve, for {}.",
                                       comparison.study.target),
                  .columns = 1,
                  .panel_height = slices_height + 100,
                  .panels = {panel}};
  return figure_of(plot, "", plot.about, table);
}

}  // namespace shadefit
