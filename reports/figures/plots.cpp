#include "reports/figures/figures.hpp"

#include <algorithm>
#include <iterator>

#include "reports/io/writers.hpp"

namespace shadefit {
namespace {

/// The refit of a family, or null if it was not requested or one of its fits did not converge.
const Refit* find_refit(const Results& results, std::string_view family) {
  for (const Refit& refit : results.refits) {
    if (refit.family->id != family) continue;
    const bool is_whole = std::ranges::all_of(
        refit.fits, [](const FitReport& report) { return report.fit.status == Status::converged; });
    return is_whole ? &refit : nullptr;
  }
  return nullptr;
}

}  // namespace

std::vector<Figure> make_figures(const Results& results) {
  std::vector<Figure> figures;
  const auto add = [&](std::vector<Figure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  if (const Refit* refit = find_refit(results, "sg-offset")) add(gaussian_figures(*refit));
  // The figures compare all Fresnel forms and need no fit. They stand at the end of the last Fresnel section.
  const Refit* one_term = find_refit(results, "fresnel-one-term");
  const Refit* quadratic = find_refit(results, "fresnel-quadratic");
  if (const Refit* last = quadratic != nullptr ? quadratic : one_term) {
    add(fresnel_figures(last->family->id));
  }
  if (const Refit* refit = find_refit(results, "phong-blinn")) add(phong_blinn_figures(*refit));
  return figures;
}

std::vector<File> plot_files(const std::vector<Figure>& figures) {
  std::vector<File> files;
  for (const Figure& figure : figures) {
    files.push_back({"plots/" + figure.name + ".csv", write_csv(figure.data, Precision::report)});
    files.push_back({"plots/" + figure.name + ".gnuplot", figure.script});
  }
  return files;
}

}  // namespace shadefit
