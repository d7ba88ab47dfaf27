#pragma once

#include <string>

/// C code that is compiled while the program runs.
namespace shadefit::bench {

/// Functions in C, compiled by the machine's own compiler and loaded into this process until the end of this
/// object's life.
class CompiledCode {
 public:
  /// Optimised, one number at a time, operations not fused: as the scalar forms of bench/forms. The compiler
  /// is the one that the variable CC names, else `cc`. Throws UserError if it cannot compile.
  explicit CompiledCode(const std::string& source);
  ~CompiledCode();
  CompiledCode(const CompiledCode&) = delete;
  CompiledCode& operator=(const CompiledCode&) = delete;

  /// A function, or a variable. Throws std::logic_error if the code has none of that name.
  void* at(const std::string& name) const;

 private:
  void* library_;
};

}  // namespace shadefit::bench
