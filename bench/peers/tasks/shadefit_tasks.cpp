// The tasks of bench/peers/run with the library of shadefit: least squares. The others are in
// shadefit_other_tasks.cpp.
#include "bench/peers/tasks/shadefit_tasks.hpp"

#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/support/sweep.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Task;

/// A family uniform in the cosine, at each exponent.
Task task_of(const std::string& id, const std::string& family_id, const std::vector<double>& exponents) {
  return {id, "from nothing", [family = shadefit::find_family(family_id), exponents] {
            Answer answer;
            for (const double k : exponents) {
              const shadefit::Fit fit = family->fit(k, {});
              for (std::size_t p = 0; p < fit.parameters.size(); ++p)
                answer.push_back({std::string(family->parameters[p]), fit.parameters[p], k});
            }
            return answer;
          }};
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Task> tasks{
      task_of("T1", "fresnel-quadratic", {0}), task_of("T2", "sg-offset", shadefit::parse_sweep("3:15:1")),
      task_of("T2-large", "sg-offset", shadefit::parse_sweep("100,1000,10000,1000000")),
      task_of("T3", "phong-blinn", shadefit::parse_sweep("2,4,8,16,32,64,128,256,512,1024,2048"))};
  for (const Task& task : peer_tasks::other_tasks()) tasks.push_back(task);
  return peer_tasks::run_all(argc, argv, tasks);
}
