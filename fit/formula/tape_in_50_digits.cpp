#include "fit/formula/tape_in_50_digits.hpp"

namespace shadefit {

template void TapeProgram<Decimal50>::run(std::span<const Decimal50>);

}  // namespace shadefit
