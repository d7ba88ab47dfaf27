#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

/// The common part of the C++ programs of bench/peers/run. The protocol is the same in every language:
/// PROGRAM SECONDS does each of its tasks in each of its ways, repeated for so long and three times at least,
/// and prints a line for each, with tabs between
///   TASK  WAY  SECONDS OF THE QUICKEST  NAME EXPONENT NUMBER;..
/// where the exponent is `-` for none. The published Fresnel pair is in the environment, as PUBLISHED_A and
/// PUBLISHED_B.
namespace peer_tasks {

struct Number {
  std::string name;
  double value;
  double exponent = 0;  ///< 0 if there is none
};

using Answer = std::vector<Number>;

struct Task {
  std::string id, way;
  std::function<Answer()> run;
};

/// The main function of such a program.
inline int run_all(int argc, char** argv, const std::vector<Task>& tasks) {
  const double budget = argc == 2 ? std::atof(argv[1]) : 0;
  for (const Task& task : tasks) {
    Answer answer;
    double least = 1e9, sum = 0;
    for (int i = 0; i < 3 || sum < budget; ++i) {
      const auto start = std::chrono::steady_clock::now();
      answer = task.run();
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      least = std::min(least, time.count());
      sum += time.count();
    }
    std::printf("%s\t%s\t%.9g\t", task.id.c_str(), task.way.c_str(), least);
    for (const auto& [name, value, exponent] : answer) {
      if (exponent > 0)
        std::printf("%s %.17g %.17g;", name.c_str(), exponent, value);
      else
        std::printf("%s - %.17g;", name.c_str(), value);
    }
    std::puts("");
  }
  return 0;
}

}  // namespace peer_tasks
