#pragma once

#include <string>

/// C code that is compiled while the program runs.
namespace shadefit::bench {

/// Functions in C. The machine's own compiler compiles them, and they stay loaded as long as this object
/// lives.
class CompiledCode {
 public:
  /// Optimised, one number at a time, without fused multiply-adds. The
  /// compiler is the one that the variable CC names, otherwise `cc`. Throws UserError if it cannot compile.
  explicit CompiledCode(const std::string& source);
  ~CompiledCode();
  CompiledCode(const CompiledCode&) = delete;
  CompiledCode& operator=(const CompiledCode&) = delete;

  /// The address of a function or a variable. Throws std::logic_error if the code has none of that name.
  void* at(const std::string& name) const;

 private:
  void* library_;
};

}  // namespace shadefit::bench
