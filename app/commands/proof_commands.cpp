#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/bounds/family_subject.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/proof/bound_width.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/statement.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "reports/studies/study_proof_rows.hpp"

/// The subcommands `certify` and `verify`, of a family and of a study.
namespace shadefit {
namespace {

/// Options of a fit that a proof of a family does not look at: they count with --form.
void refuse_options_of_fits(const Metric& metric) {
  const Constraints& constraints = metric.constraints;
  const auto refuse = [](const char* option, const std::string& value) {
    throw UserError(fmt::format("{} '{}' belongs to --form, a formula of your own", option, value));
  };
  if (metric.norm != Norm::least_squares) refuse("--norm", std::string(name(metric.norm)));
  if (!metric.weight.empty()) refuse("--weight", metric.weight);
  if (!constraints.held.empty())
    refuse("--fix", constraints.held.front().parameter + "=" + to_text(constraints.held.front().value));
  refuse_minimax_constraints(constraints);
}

/// What `verify` found of a certificate.
struct VerifiedCertificate {
  std::string refused;    ///< the reason; empty: it holds
  std::string statement;  ///< what it proves, on lines of their own
};

VerifiedCertificate verified(const std::string& text, const std::string& file, const ShareDone& done) {
  const auto read = read_study_certificate(text, file);
  const StudyCertificate& certificate = read.certificate;
  const std::string reason = read.refused.empty() ? reason_to_refuse(certificate, done) : read.refused;
  if (!reason.empty()) return {reason, ""};
  const Study& study = certificate.subject.study;
  return {"",
          fmt::format(
              "certificate '{}' holds: the largest {}{} error of {} is in [{}, {}], checked on {} boxes\n",
              printable(file), study.weight == "1" ? "" : "weighted ", name(study.error),
              printable(study.form), certificate.lower, certificate.upper, count_boxes(certificate)) +
              statement_of(certificate)};
}

/// The file of --out, which holds one certificate.
std::optional<OutputFile> certificate_file(const CertifyOptions& options, std::size_t certificates,
                                           const char* advice) {
  if (!options.out) return std::nullopt;
  if (certificates != 1)
    throw UserError(
        fmt::format("--out '{}' takes one certificate, not {}: {}", *options.out, certificates, advice));
  return OutputFile("--out", *options.out, "the certificate");
}

/// The bounds as JSON or as a text, and the certificate for its file.
Outcome proven_outcome(const CertifyOptions& options, const std::optional<OutputFile>& file,
                       const std::string& certificate, const nlohmann::ordered_json& json, std::string text,
                       const std::string& err, const Checkpoint& checkpoint) {
  std::function<void()> put;
  if (file) put = file->prepare(certificate, options.force, checkpoint);
  if (options.fit.json) {
    text = json_text_of_each(json);
  } else if (file) {
    text += fmt::format("\nCertificate: {}\n", printable(*options.out));
  }
  return {err.empty() ? 0 : 1, text, err, put};
}

/// A line for a proof whose bounds, those of `certificate`, are wider than was asked for. `what` names it.
std::string not_reached_line(const std::string& what, const StudyCertificate& certificate, double width) {
  return fmt::format("shadefit: {}: the width {} was not reached: the largest error is in [{}, {}]\n", what,
                     width, certificate.lower, certificate.upper);
}

/// "falls with the angle, non-negative, not at most 1"; what is open has a question mark.
std::string curve_text(const std::vector<std::pair<std::string, Proof>>& properties) {
  return joined(properties, ", ", [](const auto& property) {
    const auto& [words, proof] = property;
    return (proof == Proof::refuted ? "not " : "") + words + (proof == Proof::open ? "?" : "");
  });
}

/// `certify` of a study.
Outcome certify_study_file(const StudyFile& file, const CertifyOptions& options, const Checkpoint& checkpoint,
                           const Progress& progress) {
  if (file.study.rows != nullptr)
    throw UserError(
        fmt::format("certify proves the error over a range: '{}' has rows of measured values alone",
                    file.study.rows->file.unescaped()));
  const std::vector<Study> studies = combinations(file.study, file.given);
  const auto out_file = certificate_file(options, studies.size(), "give one value of each --given");
  std::vector<ProvenStudy> proofs;
  const Checkpoint next = stepping(checkpoint, progress, "certify", studies.size());
  std::string err;
  for (const Study& study : studies) {
    next();
    const auto chosen = chosen_study_subject(file, study, options.parameters, options.fit, checkpoint);
    const double width = options.width.value_or(usual_study_width(study.over.size()));
    proofs.push_back({certify_study(chosen.subject, width, checkpoint), chosen.from});
    const std::string given = given_text(study);
    const auto& [certificate, is_reached] = proofs.back().certified;
    if (!is_reached)
      err += not_reached_line("the proof" + (given.empty() ? "" : " of " + given), certificate, width);
  }
  const StudyCertificate& first = proofs.front().certified.certificate;
  return proven_outcome(options, out_file, certificate_text(first), json_array(proofs, study_proof_json),
                        (file.id.empty() ? "" : file.id + ": ") + for_terminal(proof_headline(first)) + "\n" +
                            write_console(study_proofs_table(proofs), Precision::full, options.fit.terminal) +
                            ends_text(first),
                        err, checkpoint);
}

}  // namespace

Outcome certify_command(const CertifyOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress) {
  if (const auto study = chosen_study(options.fit, checkpoint))
    return certify_study_file(*study, options, checkpoint, progress);
  if (options.fit.id.empty())
    throw UserError(
        "certify needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help certify')");
  refuse_options_of_fits(options.fit.metric);
  const NamedFit named = find_fit(options.fit.id);
  const Family& family = *named.family;
  const double width = options.width.value_or(usual_width);
  const std::vector<Setting> settings = settings_for(family, named.published, options.fit);
  const Metric metric = metric_for(options.fit, family, settings);
  const auto file = certificate_file(options, settings.size(), "name one --exponent");
  std::vector<ProvenStudy> proofs;
  std::vector<std::vector<std::pair<std::string, Proof>>> curves;
  const Checkpoint next = stepping(checkpoint, progress, "certify", settings.size());
  std::string err;
  for (const Setting& setting : settings) {
    next();
    const ChosenSubject chosen =
        chosen_constants(options.parameters, named, setting, metric, options.fit, checkpoint);
    proofs.push_back({certify_study(in_words(chosen.subject), width, checkpoint), chosen.from});
    curves.push_back(prove_curve(chosen.subject, checkpoint));
    const std::string at =
        setting.exponent > 0 ? fmt::format(" at exponent {}", setting.exponent) : std::string();
    const auto& [certificate, is_reached] = proofs.back().certified;
    if (!is_reached) err += not_reached_line(std::string(family.id) + at, certificate, width);
  }
  Table table = study_proofs_table(proofs);
  table.columns.emplace_back("curve");
  nlohmann::ordered_json json = json_array(proofs, study_proof_json);
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    table.rows[i].emplace_back(curve_text(curves[i]));
    json[i]["constant"] = family.id;
    for (const auto& [words, proof] : curves[i]) json[i]["curve"][words] = name(proof);
  }
  const StudyCertificate& first = proofs.front().certified.certificate;
  return proven_outcome(options, file, certificate_text(first), json,
                        fmt::format("{}: {}\n", family.id, for_terminal(proof_headline(first))) +
                            write_console(table, Precision::full, options.fit.terminal),
                        err, checkpoint);
}

Outcome verify_command(const VerifyOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const auto done = bar(checkpoint, progress, "verify");
  const std::string text = read_bounded(options.file, most_certificate_bytes);
  const auto [refused, statement] = verified(text, options.file, done);
  if (refused.empty()) return {0, statement, ""};
  return {
      1, "",
      fmt::format("shadefit: certificate '{}' is refused: {}\n", printable(options.file), one_line(refused))};
}

}  // namespace shadefit
