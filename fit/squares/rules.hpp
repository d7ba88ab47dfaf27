#pragma once

#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include "fit/quadrature/fit_rules.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"

/// The quadrature rules of a study, from a small one to a large one.
namespace shadefit {

/// The nodes of one rule after the other, each sampled when it is needed. A rule is an index of `fit_rules`.
/// One thread uses it at a time.
class Rules {
 public:
  /// Refers to both.
  Rules(const ReadStudy& study, const StudyError& error);

  /// Whether the nodes are measured rows, which all rules share.
  bool is_of_rows() const { return study_.rows != nullptr; }

  /// The rule of the search.
  std::size_t first() const { return search_rule(study_); }

  /// The last rule whose nodes are few enough.
  std::size_t last() const;

  StudyNodes nodes(std::size_t rule) const {
    return nodes_of(frozen_ ? *frozen_ : study_, edges_, fit_rules[rule]);
  }

  template <class T>
  SampledStudy<T> sampled(const StudyNodes& nodes) const {
    return SampledStudy<T>(error_, nodes);
  }
  /// It is kept until the panels change or another rule is asked for.
  template <class T>
  const SampledStudy<T>& sampled(std::size_t rule) const {
    auto& kept = std::get<std::optional<Sampled<T>>>(kept_);
    if (!kept || kept->rule != rule) kept.emplace(Sampled<T>{rule, sampled<T>(nodes(rule))});
    return kept->study;
  }

  const std::vector<std::vector<StudyEdge>>& edges() const { return edges_; }

  /// Whether the form has kinks that its parameters move: max(a x, b) at x = b/a.
  bool has_moving_kinks() const { return !kinks_.empty(); }

  /// Splits the range at the kinks of the form at these parameters.
  void move_kinks(const std::vector<double>& parameters);

  /// Cuts the panels of a single axis until two small rules agree on the squares of the error and its
  /// derivatives: a lobe needs narrow panels at its peak. Returns whether any was cut.
  bool cut_panels(const std::vector<double>& parameters);

 private:
  template <class T>
  struct Sampled {
    std::size_t rule;
    SampledStudy<T> study;
  };

  void forget_samples();
  VectorOf<double> squares(StudyEdge left, StudyEdge right, const std::vector<double>& parameters,
                           std::size_t rule) const;
  void cut_panel(StudyEdge left, StudyEdge right, const std::vector<double>& parameters,
                 const VectorOf<double>& fine, const VectorOf<double>& whole, int depth,
                 std::vector<StudyEdge>& cut) const;

  const ReadStudy& study_;
  const StudyError& error_;
  std::vector<Symbolic> kinks_ = {};                ///< those that parameters move
  std::optional<ReadStudy> frozen_ = std::nullopt;  ///< of several variables, at the parameters of the kinks
  std::vector<std::vector<StudyEdge>> fixed_ = {}, edges_ = {};
  mutable std::tuple<std::optional<Sampled<double>>, std::optional<Sampled<long double>>> kept_ = {};
};

/// The edges of the single variable of a study, with cuts between them: small rules agree on each panel on
/// the squares of the error and of its derivatives at these parameters.
std::vector<StudyEdge> resolved_edges(const ReadStudy& study, const StudyError& error,
                                      const std::vector<double>& parameters);

/// sqrt(integral of density * error^2 / integral of density) at these parameters, by rules of rising size
/// until two agree to 1e-12. The panels are those of the rules.
double rms_error(const Rules& rules, const std::vector<double>& parameters);

/// The same by panels for these parameters. `error` is that of the study.
double rms_error(const ReadStudy& study, const StudyError& error, const std::vector<double>& parameters);

}  // namespace shadefit
