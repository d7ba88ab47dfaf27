#include <cstddef>
#include <cstdint>
#include <string>

#include "fit/catalogue/read_study_file.hpp"
#include "fit/support/user_error.hpp"

// One input is a study in TOML: read, and then each of its forms, for the first of the given constants.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  try {
    const StudyFile file = read_study_file(std::string(reinterpret_cast<const char*>(data), size), "fuzzed");
    Study study = file.study;
    for (const auto& [name, values] : file.given) study.given.emplace(name, values.front());
    for (const StudyForm& form : file.forms) {
      take_form(study, form);
      read_study(study);
    }
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
