// The tasks of bench/peers/run with the library of shadefit: least squares. The others are in
// shadefit_other_tasks.cpp: in one translation unit gcc inlines less (see bench/solver/minimax.cpp).
#include "bench/peers/tasks/shadefit_tasks.hpp"

#include <string>

#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/sweep.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Task;

/// A family uniform in the cosine, at each exponent.
template <class F>
Task task_of(const std::string& id, const std::vector<F>& families, const std::vector<double>& exponents) {
  return {id, "from nothing", [=] {
            Answer answer;
            for (std::size_t i = 0; i < families.size(); ++i) {
              const auto optimum = shadefit::solve_least_squares(families[i], {});
              for (std::size_t p = 0; p < optimum.parameters.size(); ++p)
                answer.push_back({std::string(F::parameters[p]), optimum.parameters[p], exponents[i]});
            }
            return answer;
          }};
}

template <class F>
Task sweep_of(const std::string& id, const std::string& sweep) {
  const std::vector<double> exponents = shadefit::parse_sweep(sweep);
  std::vector<F> families;
  for (const double k : exponents) families.push_back(F{{k}});
  return task_of(id, families, exponents);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Task> tasks{task_of<shadefit::FresnelQuadratic>("T1", {{}}, {0}),
                          sweep_of<shadefit::SgOffset>("T2", "3:15:1"),
                          sweep_of<shadefit::SgOffset>("T2-large", "100,1000,10000,1000000"),
                          sweep_of<shadefit::PhongBlinn>("T3", "2,4,8,16,32,64,128,256,512,1024,2048")};
  for (const Task& task : peer_tasks::other_tasks()) tasks.push_back(task);
  return peer_tasks::run_all(argc, argv, tasks);
}
