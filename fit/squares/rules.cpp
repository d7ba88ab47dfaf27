#include "fit/squares/rules.hpp"

#include <cmath>
#include <numeric>

namespace shadefit {
namespace {

/// They cut panels.
constexpr std::size_t coarse_rule = 0, fine_rule = 2;

}  // namespace

Rules::Rules(const ReadStudy& study, const StudyError& error) : study_(study), error_(error) {
  if (is_of_rows()) return;
  kinks_ = moving_kinks(study);
  fixed_ = edges_ = edges_of(study);
}

std::size_t Rules::last() const {
  if (is_of_rows()) return first() + 1;
  constexpr double most_nodes = 60000;
  std::size_t result = 0;
  for (std::size_t i = 0; i < fit_rules.size(); ++i) {
    double nodes = 1;
    for (const auto& edges : edges_) nodes *= 2.0 * static_cast<double>((edges.size() - 1) * fit_rules[i]);
    if (nodes <= most_nodes * std::pow(2.0, static_cast<double>(edges_.size()))) result = i;
  }
  return result;
}

void Rules::forget_samples() {
  std::apply([](auto&... kept) { (kept.reset(), ...); }, kept_);
}

void Rules::move_kinks(const std::vector<double>& parameters) {
  if (!has_moving_kinks()) return;
  forget_samples();
  if (study_.axes.size() == 1) {
    std::vector<Symbolic> kinks;
    for (const Symbolic& kink : kinks_) kinks.push_back(at_parameters(study_, kink, parameters));
    edges_.front() = with_zeros(study_.axes.front(), fixed_.front(), kinks);
    return;
  }
  frozen_ = study_;
  frozen_->form = at_parameters(study_, study_.form, parameters);
  if (study_.residual) frozen_->residual = at_parameters(study_, *study_.residual, parameters);
  edges_ = edges_of(*frozen_);
}

bool Rules::cut_panels(const std::vector<double>& parameters) {
  if (edges_.size() != 1) return false;
  const std::vector<StudyEdge> edges = edges_.front();
  std::vector<VectorOf<double>> of_panels;
  for (std::size_t i = 1; i < edges.size(); ++i)
    of_panels.push_back(squares(edges[i - 1], edges[i], parameters, fine_rule));
  const VectorOf<double> whole = std::accumulate(of_panels.begin() + 1, of_panels.end(), of_panels.front());
  edges_.front() = {edges.front()};
  for (std::size_t i = 1; i < edges.size(); ++i)
    cut_panel(edges[i - 1], edges[i], parameters, of_panels[i - 1], whole, 0, edges_.front());
  const bool are_cut = edges_.front().size() > edges.size();
  if (are_cut) forget_samples();
  return are_cut;
}

/// The integrals of error^2 and of the square of each derivative over a panel.
VectorOf<double> Rules::squares(StudyEdge left, StudyEdge right, const std::vector<double>& parameters,
                                std::size_t rule) const {
  const StudyNodes nodes = nodes_of(study_, {{left, right}}, fit_rules[rule]);
  const SampledStudy<double> sampled(error_, nodes);
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  sampled.errors(parameters, errors, &slopes);
  const VectorOf<double> weights = sampled.roots().cwiseAbs2();
  VectorOf<double> result(slopes.cols() + 1);
  result[0] = errors.cwiseAbs2().dot(weights);
  for (Eigen::Index j = 0; j < slopes.cols(); ++j) result[j + 1] = slopes.col(j).cwiseAbs2().dot(weights);
  return result * static_cast<double>(nodes.total);
}

/// `fine` are the squares of the panel, `whole` those of the range.
void Rules::cut_panel(StudyEdge left, StudyEdge right, const std::vector<double>& parameters,
                      const VectorOf<double>& fine, const VectorOf<double>& whole, int depth,
                      std::vector<StudyEdge>& cut) const {
  // A rule of 22 nodes that is right to 1e-6 becomes right to rounding with 38.
  constexpr double agree = 1e-6;
  constexpr int deepest = 20;
  const VectorOf<double> coarse = squares(left, right, parameters, coarse_rule);
  const bool is_resolved = ((coarse - fine).cwiseAbs().array() <= agree * whole.array()).all();
  if (is_resolved || depth == deepest || cut.size() > 40) {
    cut.push_back(right);
    return;
  }
  const StudyEdge middle{left.at + (right.at - left.at) / 2};
  const auto cut_half = [&](StudyEdge from, StudyEdge to) {
    cut_panel(from, to, parameters, squares(from, to, parameters, fine_rule), whole, depth + 1, cut);
  };
  cut_half(left, middle);
  cut_half(middle, right);
}

std::vector<StudyEdge> resolved_edges(const ReadStudy& study, const StudyError& error,
                                      const std::vector<double>& parameters) {
  Rules rules(study, error);
  rules.move_kinks(parameters);
  rules.cut_panels(parameters);
  return rules.edges().front();
}

double rms_error(const Rules& rules, const std::vector<double>& parameters) {
  double square = 0, last = -1;
  for (std::size_t rule = 0; rule < rules.last() && std::abs(square - last) > 1e-12 * square; ++rule) {
    last = square;
    square = rules.sampled<double>(rule).square(parameters);
  }
  return std::sqrt(square);
}

double rms_error(const ReadStudy& study, const StudyError& error, const std::vector<double>& parameters) {
  Rules rules(study, error);
  rules.move_kinks(parameters);
  rules.cut_panels(parameters);
  return rms_error(rules, parameters);
}

}  // namespace shadefit
