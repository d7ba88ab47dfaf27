#pragma once

// fmt as headers only: a user of shadefit::fit needs no library of fmt. The target fmt::fmt-header-only would
// set its definition for all units that share our precompiled headers. For .cpp files only: a unit must not
// include fmt both with and without this definition.
#ifndef FMT_HEADER_ONLY
#define FMT_HEADER_ONLY
#endif
#include <fmt/format.h>
#include <fmt/ranges.h>
