#pragma once

#include <string>

#include "fit/support/user_error.hpp"

/// Adds the place in a file to an error message.
namespace shadefit::scene {

/// Returns the result of `work`. Rethrows its UserError with the place in front: "'a.gltf': /images/3: ...".
template <class Work>
auto at_place(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw UserError(place + ": " + error.what());
  }
}

}  // namespace shadefit::scene
