#pragma once

namespace shadefit::testing {

/// What a checkpoint of these tests throws: of no kind that the code under test could know.
struct Stop {};

}  // namespace shadefit::testing
