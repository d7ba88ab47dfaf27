#pragma once

#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

/// A global search for the parameters of a form, written apart from the library: its own formulas, in double,
/// its own integrals and its own descent, by function values alone.
namespace shadefit::search {

/// A problem drawn at random.
struct Drawn {
  std::string_view family;
  double exponent = 0;  ///< of a lobe
  bool is_exact = false;
  double ior = 0, extinction = 0;  ///< 0: no surface in particular
  double lower = 0, upper = 1;
  std::size_t measure = 0;  ///< cosine, angle, cosine-weighted
  bool is_minimax = false, is_relative = false;
};

/// The problem of that number of a family: the same on every machine. Throws std::logic_error for a family
/// that this file does not know.
Drawn draw(std::string_view family, int number);

/// The command that fits it.
std::string command_of(const Drawn& drawn);

/// A drawn problem at nodes over its domain.
class Problem {
 public:
  explicit Problem(const Drawn& drawn);

  /// The root mean square of the error, or its largest magnitude at the nodes; infinite where the form has a
  /// pole.
  double objective(const std::vector<double>& parameters) const;

  /// The same with the largest magnitude between the nodes.
  double refined_objective(const std::vector<double>& parameters) const;

  /// The least magnitude of the form's denominator over the domain, negative with a pole inside; 1 for a form
  /// without one.
  double distance_to_pole(const std::vector<double>& parameters) const;

  const Drawn& drawn() const { return drawn_; }
  /// The cosine at which the target is half of what it is at its larger end; 1 - c of a lobe.
  double half() const { return half_; }

 private:
  struct Node {
    double angle, cosine, distance;  ///< theta, c, 1 - c
    double share;                    ///< of the measure; 0 at the ends of panels
    double target, scale;            ///< error = scale (form - target)
  };
  Node node_at(double angle, double share) const;
  double error_at(const Node& node, const std::vector<double>& parameters) const;

  Drawn drawn_;
  std::function<double(const std::vector<double>&, double cosine, double distance)> form_;
  std::function<double(double cosine, double distance)> target_;
  double f0_ = 0;
  double half_ = 1;
  std::vector<Node> nodes_;  ///< by rising angle
};

struct Best {
  std::vector<double> parameters;
  double objective;
};

/// The least objective that was found from starts all over the scales of the family, and from `known` where
/// that is not empty.
Best least(const Problem& problem, const std::vector<double>& known, int seed);

}  // namespace shadefit::search
