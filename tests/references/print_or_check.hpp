#pragma once

#include <fstream>
#include <iostream>
#include <sstream>

/// The main function that the programs of reference values share.
namespace shadefit::references {

/// Without arguments prints the values; with `--check FILE` compares FILE with what is computed, prints what
/// is new where a byte differs, and returns 1 then.
template <class Write>
int print_or_check(int argc, char** argv, const Write& write_references) {
  if (argc == 1) {
    write_references(std::cout);
    return 0;
  }
  std::ostringstream computed;
  write_references(computed);
  std::ifstream file(argv[argc - 1]);
  std::ostringstream stored;
  stored << file.rdbuf();
  const bool same = computed.str() == stored.str();
  std::cout << (same ? "the stored references are what this program computes\n" : computed.str());
  return same ? 0 : 1;
}

}  // namespace shadefit::references
