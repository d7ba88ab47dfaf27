#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "reports/studies/study_proof_rows.hpp"

/// The subcommands `certify` and `verify`.
namespace shadefit {

Outcome certify_command(const CertifyOptions& options, const Watched& work) {
  const StudyFile file = chosen_study(options.fit, work.checkpoint);
  if (file.study.rows != nullptr)
    throw UserError(
        fmt::format("certify proves the error over a range: '{}' has rows of measured values alone",
                    file.study.rows->file.unescaped()));
  const std::vector<Study> studies = combinations(file.study, file.given);
  if (options.out && studies.size() > 1)
    throw UserError(fmt::format("--out '{}' takes one certificate, not {}: give one value of each --given",
                                *options.out, studies.size()));
  const auto out =
      options.out ? std::optional(output_file("--out", *options.out, "the certificate")) : std::nullopt;
  std::vector<ProvenStudy> proofs;
  const Checkpoint next = stepping(work, "certify", studies.size());
  std::string err;
  for (const Study& study : studies) {
    next();
    const auto chosen = chosen_study_subject(file, study, options.parameters, options.fit, work.checkpoint);
    const double width = options.width.value_or(usual_study_width(study.over.size()));
    proofs.push_back({certify_study(chosen.subject, width, work.checkpoint), chosen.from});
    const std::string given = given_text(study);
    const auto& [certificate, is_reached] = proofs.back().certified;
    if (!is_reached)
      err += fmt::format(
          "shadefit: the proof{}: the width {} was not reached: the largest error is in [{}, {}]\n",
          given.empty() ? "" : " of " + given, width, certificate.lower, certificate.upper);
  }
  const StudyCertificate& first = proofs.front().certified.certificate;
  std::function<void()> put;
  if (out) put = prepare_output_file(*out, certificate_text(first), options.fit.force, work.checkpoint);
  if (options.fit.json)
    return {err.empty() ? 0 : 1, json_text_of_each(json_array(proofs, study_proof_json)), err, put};
  std::string text = (file.id.empty() ? "" : file.id + ": ") + for_terminal(proof_headline(first)) + "\n" +
                     write_console(study_proofs_table(proofs), Precision::full, options.fit.terminal) +
                     ends_text(first);
  if (out) text += fmt::format("\nCertificate: {}\n", printable(*options.out));
  return {err.empty() ? 0 : 1, text, err, put};
}

Outcome verify_command(const VerifyOptions& options, const Watched& work) {
  const std::string file = printable(options.file);
  const auto [certificate, refused] =
      read_study_certificate(read_bounded(options.file, most_certificate_bytes), options.file);
  const std::string reason = refused.empty() ? reason_to_refuse(certificate, bar(work, "verify")) : refused;
  if (!reason.empty())
    return {1, "", fmt::format("shadefit: certificate '{}' is refused: {}\n", file, one_line(reason))};
  const Study& study = certificate.subject.study;
  return {0,
          fmt::format(
              "certificate '{}' holds: the largest {}{} error of {} is in [{}, {}], checked on {} boxes\n",
              file, study.weight == "1" ? "" : "weighted ", name(study.error), printable(study.form),
              certificate.lower, certificate.upper, count_boxes(certificate)) +
              statement_of(certificate),
          ""};
}

}  // namespace shadefit
