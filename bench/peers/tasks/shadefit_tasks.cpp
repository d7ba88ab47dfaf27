// The tasks of bench/peers/run with the library of shadefit, in the process: least squares. The others are in
// shadefit_other_tasks.cpp: in one translation unit gcc inlines less (see bench/solver/minimax.cpp).
#include "bench/peers/tasks/shadefit_tasks.hpp"

#include <string>

#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/sweep.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Standing;
using peer_tasks::Variant;

template <class F, class Optimum>
void add(Answer& answer, const Optimum& optimum, double exponent) {
  if (optimum.status != shadefit::Status::converged) answer.remark("a fit did not converge");
  for (std::size_t i = 0; i < optimum.parameters.size(); ++i)
    answer.add(std::string(F::parameters[i]), optimum.parameters[i], exponent);
}

/// A family uniform in the cosine at each exponent, from nothing, and with nodes and samples made outside the
/// timed part.
template <class F>
void append(std::vector<Variant>& variants, const std::string& task, const std::vector<F>& families,
            const std::vector<double>& exponents, const std::string& command) {
  variants.push_back({task, "from nothing", Standing::judged,
                      [families, exponents] {
                        Answer answer;
                        for (std::size_t i = 0; i < families.size(); ++i)
                          add<F>(answer, shadefit::solve_least_squares(families[i], {}), exponents[i]);
                        return answer;
                      },
                      command});
  std::vector<shadefit::LeastSquares<F>> ready;
  for (const F& family : families) ready.push_back({family, {}});
  variants.push_back({task, "nodes and samples ready", Standing::listed,
                      [ready, exponents] {
                        Answer answer;
                        for (std::size_t i = 0; i < ready.size(); ++i)
                          add<F>(answer, ready[i].solve(), exponents[i]);
                        return answer;
                      },
                      command});
}

template <class F>
void append_sweep(std::vector<Variant>& variants, const std::string& task, const std::string& sweep) {
  const std::vector<double> exponents = shadefit::parse_sweep(sweep);
  std::vector<F> families;
  for (const double k : exponents) families.push_back(F{{k}});
  append(variants, task, families, exponents,
         "fit " + std::string(F::info.id) + " --exponent " + sweep + " --json");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Variant> variants;
  append<shadefit::FresnelQuadratic>(variants, "T1", {{}}, {0}, "fit fresnel-quadratic --json");
  append_sweep<shadefit::SgOffset>(variants, "T2", "3:15:1");
  append_sweep<shadefit::SgOffset>(variants, "T2-large", "100,1000,10000,1000000");
  append_sweep<shadefit::PhongBlinn>(variants, "T3", "2,4,8,16,32,64,128,256,512,1024,2048");
  for (const Variant& v : peer_tasks::other_tasks()) variants.push_back(v);
  return peer_tasks::run_program(argc, argv, "shadefit", variants);
}
