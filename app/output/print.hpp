#pragma once

#include <string_view>

#include "app/output/interrupt.hpp"

/// Printing that a signal can end even while the reader blocks it.
namespace shadefit {

/// The error or signal that ended the printing of a text.
struct Printed {
  int error = 0;   ///< errno
  int signal = 0;  ///< one of the held signals

  bool is_whole() const { return error == 0 && signal == 0; }
};

/// Writes a text to a descriptor. A held signal that is pending or arrives before the end is taken and ends
/// the printing.
Printed print(int descriptor, std::string_view text, const sigset_t& held);

}  // namespace shadefit
