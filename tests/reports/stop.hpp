#pragma once

namespace shadefit::testing {

/// The exception of these tests' checkpoints, of a type that is unknown to the tested code.
struct Stop {};

}  // namespace shadefit::testing
