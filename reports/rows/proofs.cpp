#include "reports/rows/proofs.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "reports/io/joined.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// The range of cosines that contains the place of the largest error.
Domain places_in(const Certificate& certificate) {
  return {cosines_of(certificate.places.front()).lower, cosines_of(certificate.places.back()).upper};
}

/// What was proven, refuted or left open, in words, with the name of each property.
std::array<std::pair<std::string, Proof>, 3> properties(const FittableFamily& family,
                                                        const CurveProof& proof) {
  return {{{std::string(name(family.info.curve.trend)) + " with the angle", proof.trend},
           {"non-negative", proof.non_negative},
           {"at most 1", proof.at_most_one}}};
}

std::string curve_text(const FittableFamily& family, const CurveProof& proof) {
  std::vector<std::string> parts;
  for (const auto& [property, state] : properties(family, proof)) {
    if (state == Proof::proven) parts.push_back(property);
    if (state == Proof::refuted) parts.push_back("not " + property);
    if (state == Proof::open) parts.push_back(property + "?");
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

Json curve_json(const FittableFamily& family, const CurveProof& proof) {
  Json json = Json::object();
  for (const auto& [property, state] : properties(family, proof)) {
    if (state != Proof::none) json[property] = name(state);
  }
  return json;
}

Json places_json(const Certificate& certificate) {
  return json_array(certificate.places, [](const Box& box) -> Json {
    const Domain c = cosines_of(box);
    return {c.lower, c.upper};
  });
}

}  // namespace

Table certificates_table(const FittableFamily& family, const std::vector<CertifiedForm>& forms) {
  Table table;
  if (family.has_exponent()) table.columns.emplace_back("exponent");
  for (const auto parameter : family.parameters) table.columns.emplace_back(parameter);
  for (const char* column : {"from", "max error at least", "at most", "at c from", "to", "boxes", "curve"})
    table.columns.emplace_back(column);
  for (const auto& [certified, from] : forms) {
    const Certificate& certificate = certified.certificate;
    std::vector<Cell>& row = table.rows.emplace_back();
    if (family.has_exponent()) row.push_back(all_of(certificate.subject.setting.exponent));
    for (const auto& [name, value] : certificate.subject.parameters) row.emplace_back(value);
    const Domain places = places_in(certificate);
    const auto boxes_of_side = [](const std::vector<double>& ends) {
      return ends.empty() ? 0 : static_cast<long>(ends.size()) - 1;
    };
    row.insert(row.end(),
               {std::string(from), all_of(certificate.lower), all_of(certificate.upper), all_of(places.lower),
                all_of(places.upper), boxes_of_side(certificate.horizon) + boxes_of_side(certificate.peak),
                curve_text(family, certified.curve)});
  }
  return table;
}

Json write_certified_json(const CertifiedForm& form) {
  const Certificate& certificate = form.certified.certificate;
  const Subject& subject = certificate.subject;
  const FittableFamily& family = *find_family(subject.family);
  return {{"schema", 1},
          {"constant", subject.family},
          {"exponent", family.has_exponent() ? Json(subject.setting.exponent) : Json()},
          {"parameters", json_object(subject.parameters)},
          {"parameters_from", form.from},
          {"target", certificate.target},
          {"form", certificate.form},
          {"error", name(subject.error)},
          {"domain", {subject.domain.lower, subject.domain.upper}},
          {"certified_max_error", {certificate.lower, certificate.upper}},
          {"certified_max_error_at", places_json(certificate)},
          {"curve", curve_json(family, form.certified.curve)}};
}

}  // namespace shadefit
