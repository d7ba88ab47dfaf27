#pragma once

#include <string_view>

#include "app/terminal/interrupt.hpp"

/// Printing that a signal can end, however long the reader keeps it waiting.
namespace shadefit {

/// What ended the printing of a text.
struct Printed {
  int error = 0;   ///< errno
  int signal = 0;  ///< of those that are held

  bool is_whole() const { return error == 0 && signal == 0; }
};

/// Writes a text to a descriptor. A held signal that waits or comes before the end is taken and ends it.
Printed print(int descriptor, std::string_view text, const HeldSignals& signals);

}  // namespace shadefit
