#include "reports/rows/proofs.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "fit/proof/bound_width.hpp"
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

Json stationary_json(const FittableFamily& family, const StationaryPoint& point) {
  if (!point.is_proven) return {{"unique", false}, {"reason", point.reason}};
  return {{"unique", true},
          {"minimum", point.is_minimum},
          {"digits", point.digits},
          {"box", json_object(family.parameters, point.unique_in)},
          {"lies_in", json_object(family.parameters, point.lies_in)}};
}

std::string stationary_text(const FittableFamily& family, const StationaryPoint& point) {
  if (!point.is_proven) return "not proven: " + point.reason;
  std::string out = point.is_minimum ? "one minimum" : "one stationary point";
  for (std::size_t i = 0; i < point.lies_in.size(); ++i)
    out += fmt::format(", {} in [{}, {}]", family.parameters[i], point.lies_in[i].first,
                       point.lies_in[i].second);
  return out;
}

}  // namespace

Table proofs_table(const Refit& refit, const std::vector<FitProof>& proofs) {
  const FittableFamily& family = *refit.family;
  Table table;
  if (family.has_exponent()) table.columns.emplace_back("exponent");
  for (const char* column :
       {"max abs error at least", "at most", "at c from", "to", "curve", "least squares"})
    table.columns.emplace_back(column);
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    if (family.has_exponent()) row.push_back(all_of(*refit.fits[i].fit.exponent));
    const FitProof& proof = proofs[i];
    if (proof.max_abs_error) {
      const auto& [certificate, is_reached, curve] = *proof.max_abs_error;
      const Domain places = places_in(certificate);
      row.insert(row.end(), {all_of(certificate.lower), all_of(certificate.upper), all_of(places.lower),
                             all_of(places.upper), curve_text(family, curve)});
    } else {
      row.resize(row.size() + 5);
    }
    row.emplace_back(stationary_text(family, proof.stationary));
  }
  return table;
}

void add_proof_json(Json& fit_json, const FittableFamily& family, const FitProof& proof) {
  Json error, at, curve;
  if (proof.max_abs_error) {
    const Certificate& certificate = proof.max_abs_error->certificate;
    error = {certificate.lower, certificate.upper};
    at = places_json(certificate);
    curve = curve_json(family, proof.max_abs_error->curve);
  }
  fit_json["certified_max_abs_error"] = error;
  fit_json["certified_max_abs_error_at"] = at;
  fit_json["curve"] = curve;
  fit_json["stationary_point"] = stationary_json(family, proof.stationary);
}

std::string not_reached_lines(const Refit& refit, const std::vector<FitProof>& proofs) {
  std::string lines;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    const auto& error = proofs[i].max_abs_error;
    if (!error || error->is_reached) continue;
    const Fit& fit = refit.fits[i].fit;
    lines += fmt::format("shadefit: {}{}: the largest error could not be enclosed to a width of {}\n",
                         refit.family->info.id,
                         fit.exponent ? fmt::format(" at exponent {}", *fit.exponent) : "", usual_width);
  }
  return lines;
}

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
