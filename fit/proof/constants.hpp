#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

/// The constants of a proven form, as text.
namespace shadefit {

/// Names and values. A printed value is a decimal text; it need not be a double, so the proof encloses it. A
/// fitted value is a hexadecimal double.
using Constants = std::vector<std::pair<std::string, std::string>>;

/// One line that says why these are not the constants of a form, or an empty text. They must be the names
/// that are `known`, in this order. `form` is for the message: "the form".
std::string fault_of_constants(const Constants& given, std::span<const std::string> known,
                               const std::string& form);

/// The constants in the order of the names that are `known`; others at the end.
Constants in_order(Constants given, std::span<const std::string> known);

}  // namespace shadefit
