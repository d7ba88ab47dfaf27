#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

/// The common part of the C++ programs of bench/peers/run: named variants of tasks, timed, with answers as
/// lines. The protocol is the same in every language:
///
///   PROGRAM --list                  version TEXT, then a line a variant: TASK <tab> VARIANT <tab>
///   judged|listed
///                                   [<tab> arguments of the command whose process stands for it]
///   PROGRAM TASK VARIANT SECONDS    does the task once and prints `value NAME EXPONENT NUMBER` (`-` for no
///                                   exponent) and `note TEXT`; with SECONDS > 0 repeats it for so long,
///                                   three times at least, and prints `seconds` of the quickest
/// `expert` is judged too: a method that needs a derivation by hand or own nodes. The published Fresnel pair
/// is in the record; other languages find it in the environment, as PUBLISHED_A and PUBLISHED_B
/// (peers/main.cpp).
namespace peer_tasks {

struct Answer {
  struct Value {
    std::string name;
    double exponent;  ///< 0 if there is none
    double value;
  };
  std::vector<Value> values;
  std::vector<std::string> notes;

  void add(const std::string& name, double value, double exponent = 0) {
    values.push_back({name, exponent, value});
  }
  /// A note is printed once for all its fits.
  void remark(const std::string& text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
  }
};

enum class Standing { judged, expert, listed };

struct Variant {
  std::string task, name;
  Standing standing;
  std::function<Answer()> run;
  std::string command = {};  ///< empty if the program itself is the process
};

inline double seconds_of(const std::function<Answer()>& run) {
  const auto start = std::chrono::steady_clock::now();
  const Answer answer = run();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

inline void print(const Answer& answer) {
  for (const auto& [name, exponent, value] : answer.values) {
    if (exponent > 0)
      std::printf("value %s %.17g %.17g\n", name.c_str(), exponent, value);
    else
      std::printf("value %s - %.17g\n", name.c_str(), value);
  }
  for (const std::string& note : answer.notes) std::printf("note %s\n", note.c_str());
}

/// The main function of such a program. Exit code 2 for an unknown task.
inline int run_program(int argc, char** argv, const std::string& version,
                       const std::vector<Variant>& variants) {
  if (argc == 2 && argv[1] == std::string("--list")) {
    constexpr const char* names[] = {"judged", "expert", "listed"};
    std::printf("version %s\n", version.c_str());
    for (const Variant& v : variants) {
      std::printf("%s\t%s\t%s%s%s\n", v.task.c_str(), v.name.c_str(), names[static_cast<int>(v.standing)],
                  v.command.empty() ? "" : "\t", v.command.c_str());
    }
    return 0;
  }
  for (const Variant& v : variants) {
    if (argc != 4 || v.task != argv[1] || v.name != argv[2]) continue;
    print(v.run());
    double least = HUGE_VAL, sum = 0;
    const double budget = std::atof(argv[3]);
    for (int i = 0; budget > 0 && (i < 3 || sum < budget); ++i) {
      const double seconds = seconds_of(v.run);
      least = std::min(least, seconds);
      sum += seconds;
    }
    if (budget > 0) std::printf("seconds %.9g\n", least);
    return 0;
  }
  std::fprintf(stderr, "usage: %s --list, or TASK VARIANT SECONDS as it lists them\n", argv[0]);
  return 2;
}

}  // namespace peer_tasks
