#include <cstdio>
#include <string>

#include "reports/studies/prepare.hpp"

/// Fits, proves and emits the Fresnel pair from its text. Exits with 1 unless the code has the constants.
int main() {
  shadefit::Prepared pair = shadefit::prepare(R"toml(
    schema = 1
    id = "pair"
    over.c = "0:1"
    target.formula = "(1 - c)^5"
    form = [{ id = "pair", formula = "exp2((a c + b) c)" }])toml");
  const shadefit::StudyFit fit = pair.fit();
  const shadefit::CertifiedError proof = pair.certify();
  const std::string code = pair.emit(shadefit::Language::glsl);
  std::printf("a = %.5f, b = %.5f, error in [%g, %g]\n%s", fit.parameters[0], fit.parameters[1], proof.lower,
              proof.upper, code.c_str());
  const bool has_constants = code.find("return exp2((-5.554728 * c - 6.983161) * c)") != code.npos;
  return has_constants && proof.is_reached && proof.lower > 0.0037 && proof.upper < 0.0038 ? 0 : 1;
}
