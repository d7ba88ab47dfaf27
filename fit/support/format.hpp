#pragma once

// fmt by its headers alone: who links shadefit::fit needs no library of fmt. Defined here and not by the
// target fmt::fmt-header-only, whose definition would have to hold for all that share our precompiled
// headers. For .cpp files only: what includes this before or after fmt itself has to agree on it.
#ifndef FMT_HEADER_ONLY
#define FMT_HEADER_ONLY
#endif
#include <fmt/format.h>
