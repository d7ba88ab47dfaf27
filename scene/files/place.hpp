#pragma once

#include <string>

#include "fit/support/user_error.hpp"

/// Where in a file something is, said with what is wrong there.
namespace shadefit::scene {

/// What `work` returns. A UserError of it is thrown again with the place before it: "'a.gltf': /images/3:
/// ...".
template <class Work>
auto at_place(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw UserError(place + ": " + error.what());
  }
}

}  // namespace shadefit::scene
