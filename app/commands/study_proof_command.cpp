#include <fmt/format.h>

#include "app/commands/study_commands.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/utf8.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "reports/studies/study_proof_rows.hpp"
#include "reports/table/writers.hpp"

/// `certify` and `verify` of a study.
namespace shadefit {
Outcome certify_study_command(const StudyFile& file, const CertifyOptions& options,
                              const Checkpoint& checkpoint, const Progress& progress) {
  if (file.study.rows != nullptr)
    throw UserError(
        fmt::format("certify proves the error over a range: '{}' has rows of measured values alone",
                    file.study.rows->file.unescaped()));
  const std::vector<Study> studies = combinations(file.study, file.given);
  if (options.out && studies.size() != 1)
    throw UserError(fmt::format("--out '{}' takes one certificate, not {}: give one value of each --given",
                                *options.out, studies.size()));
  const auto out_file =
      options.out ? std::optional(OutputFile(*options.out, "the certificate")) : std::nullopt;

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
  std::function<void()> put;
  if (out_file) put = out_file->prepare(certificate_text(first), options.force, checkpoint);

  std::string out;
  if (options.fit.json) {
    out = json_text_of_each(json_array(proofs, study_proof_json));
  } else {
    out = (file.id.empty() ? "" : file.id + ": ") + for_terminal(proof_headline(first)) + "\n" +
          write_console(study_proofs_table(proofs), Precision::full, options.fit.terminal) + ends_text(first);
    if (options.out) out += fmt::format("\nCertificate: {}\n", printable(*options.out));
  }
  return {err.empty() ? 0 : 1, out, err, put};
}

VerifiedCertificate verify_study(const std::string& text, const std::string& file, const ShareDone& done) {
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

}  // namespace shadefit
