#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/trade.hpp"
#include "fit/better/better_study.hpp"
#include "reports/code/shader_code.hpp"

/// The forms that are timed: those of the catalogue or of a study.
namespace shadefit::bench {

/// The floats of a grid over the ranges with their ends, with so many steps in each.
Places grid_over(const std::vector<Range>& ranges, const std::vector<std::size_t>& steps);

/// The name of each function.
inline constexpr const char* form_name = "form";

/// Sums of several lights, which repeat the forms of one light.
bool is_of_several_lights(const forms::Target& target);

/// The function that `emit` would write for a form of the catalogue: all constants are numbers. Its arguments
/// are c, or c and code, or the x, y and z of a normal. The target is not of several lights.
ShaderFunction function_of(const forms::Target& target, const forms::FormEntry& form,
                           const forms::Constants& constants);

/// Which exp2 the forms of the catalogue have.
enum class Exp2Kinds {
  library,      ///< that of the library, as on a device
  polynomials,  ///< that one, and each polynomial in place of it
};

/// The forms of the catalogue for these targets, or for all of them. Forms of several lights are left out:
/// they are sums of one light. Errors are the largest in float on a dense grid, against the target in double.
Trade catalogue_forms(const std::vector<forms::Target>& catalogue, const std::vector<std::string>& targets,
                      Exp2Kinds exp2);

/// The forms of a study and its targets. Errors are those of exact arithmetic. Throws UserError for a form
/// that has no code in that language, and if there is nothing to time because no fit converged and nothing
/// was published.
Trade study_forms(const std::string& id, const std::vector<StudyComparison>& comparisons, Language language);

/// Multiply-adds, each of which waits for the one before: the unit of every time. A polynomial of degree 16
/// by Horner's rule, from [0, 1] to [0, 1].
ShaderFunction multiply_add_chain();
inline constexpr int multiply_adds_of_chain = 16;

/// The largest |value - truth|, or infinity if a value is NaN.
double largest_error(std::span<const float> values, std::span<const double> truth);

}  // namespace shadefit::bench
