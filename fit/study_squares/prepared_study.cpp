#include "fit/study_squares/prepared_study.hpp"

#include "fit/study/require_values.hpp"
#include "fit/study/search.hpp"
#include "fit/study_squares/settle.hpp"

namespace shadefit {

PreparedStudy::PreparedStudy(const Study& study)
    : study_(read_study(study)), error_(study_), rules_(study_, error_) {
  require_values(study_, rules_.nodes(rules_.first()));
  require_dependence(study_, error_.is_open());
}

StudyFit PreparedStudy::fit(const std::vector<double>& start) {
  StudyFit fit;
  // Between kinks that move, sums over few nodes have basins of their own.
  const SampledStudy<double>& sampled =
      rules_.sampled<double>(rules_.has_moving_kinks() ? rules_.last() : rules_.first());
  const auto ends = search_basins(error_, sampled, sampled, {.count = 0, .octaves = 0, .given = {start}});
  if (ends.empty()) {
    fit.why = "the way down from the start leads to a pole, or the form has no finite value there";
  } else if (rules_.has_moving_kinks()) {
    fit = settle_kinks(rules_, ends.front());
  } else {
    // The panels of one optimum serve the others: where they do not, larger rules do.
    if (!has_cut_panels_) rules_.cut_panels(ends.front().parameters);
    has_cut_panels_ = true;
    fit = settle(rules_, ends.front(), nullptr);
  }
  fit.names = study_.parameters;
  return fit;
}

}  // namespace shadefit
