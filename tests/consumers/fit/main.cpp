#include <cstdio>
#include <string_view>

#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "fit/least_squares/least_squares.hpp"

/// Refits the Fresnel pair twice: by the compiled library and by the headers, instantiated here. Exits with 1
/// unless both give the published a = -5.55473.
int main() {
  const shadefit::Fit compiled = shadefit::find_family("fresnel-quadratic")->fit({}, {});
  const auto instantiated = shadefit::solve_least_squares(shadefit::FresnelQuadratic{}, {});
  const auto is_published = [](shadefit::Status status, double a) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5f", a);
    std::printf("a = %s\n", text);
    return status == shadefit::Status::converged && std::string_view(text) == "-5.55473";
  };
  const bool is_compiled_right = is_published(compiled.status, compiled.parameters[0]);
  return is_published(instantiated.status, instantiated.parameters[0]) && is_compiled_right ? 0 : 1;
}
