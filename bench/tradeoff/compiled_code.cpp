#include "bench/tradeoff/compiled_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"
#include "reports/io/scratch_directory.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit::bench {
namespace {

constexpr const char* flags =
    "-std=c11 -O3 -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off -fno-math-errno -fPIC -shared";

std::string compiler_command() {
  const char* chosen = std::getenv("CC");
  return chosen != nullptr && *chosen != '\0' ? chosen : "cc";
}

}  // namespace

CompiledCode::CompiledCode(const std::string& source) {
  const ScratchDirectory scratch;
  const auto file = [&](const char* name) { return scratch.path() / name; };
  write_files(scratch.path(), {{"forms.c", source}});
  const std::string command =
      fmt::format("{} {} -o '{}' '{}' -lm 2>'{}'", compiler_command(), flags, file("forms.so").string(),
                  file("forms.c").string(), file("said").string());
  if (std::system(command.c_str()) != 0) {
    const std::string said = read_file(file("said"));
    throw UserError(fmt::format("the C compiler '{}' (variable CC, else cc) cannot compile the forms: {}",
                                printable(compiler_command()), printable(said.substr(0, said.find('\n')))));
  }
  library_ = ::dlopen(file("forms.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr)
    throw UserError(fmt::format("cannot load the output of the C compiler: {}", printable(::dlerror())));
}

CompiledCode::~CompiledCode() {
  ::dlclose(library_);
}

void* CompiledCode::at(const std::string& name) const {
  void* found = ::dlsym(library_, name.c_str());
  if (found == nullptr) throw std::logic_error("compiled code lacks " + name);
  return found;
}

}  // namespace shadefit::bench
