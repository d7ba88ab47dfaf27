#include <cstdio>
#include <string_view>

#include "fit/catalogue/family.hpp"
#include "fit/squares/prepared_study.hpp"

/// Refits the Fresnel pair twice: by its name, and as a study from text. Exits with 1 unless both give the
/// published a = -5.55473.
int main() {
  const shadefit::Fit family = shadefit::find_family("fresnel-quadratic")->fit({}, {});
  shadefit::PreparedStudy pair(
      {.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}});
  const shadefit::StudyFit study = pair.fit({-5, -7});
  const auto is_published = [](shadefit::Status status, double a) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5f", a);
    std::printf("a = %s\n", text);
    return status == shadefit::Status::converged && std::string_view(text) == "-5.55473";
  };
  const bool is_family_right = is_published(family.status, family.parameters[0]);
  return is_published(study.status, study.parameters[0]) && is_family_right ? 0 : 1;
}
