#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/options/outcome.hpp"
#include "bench/forms/float_errors.hpp"
#include "fit/catalogue/surface.hpp"
#include "fit/proof/constants.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/study/study.hpp"
#include "fit/verdicts/verdict.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/findings/finding.hpp"
#include "reports/io/writers.hpp"
#include "scene/plan/plan.hpp"

/// The options of the commands, parsed (app/commands/declare_commands.cpp).
namespace shadefit {

/// Folders of --studies.
using StudyFolders = std::vector<std::string>;

struct ListOptions {
  std::optional<std::string> id;   ///< only the rows whose id contains this text; or the file of a study
  std::optional<Verdict> verdict;  ///< only the claims with this one; computes them
  StudyFolders studies = {};
  bool json = false;
  bool csv = false;
  Terminal terminal = {};
};

struct RunOptions {
  std::optional<std::string> study = {};  ///< a file or an id; empty: everything that is built in
  StudyFolders studies = {};
  std::string out = "out";
  std::vector<std::string> only = {};
  bool no_plots = false;
  bool force = false;  ///< replaces files that shadefit did not write
  Terminal terminal = {};
  bool html = false;  ///< pages of the study, or of all studies
};

/// A fit of one's own, or changes to a study.
struct StudyOptions {
  std::optional<std::string> form = {};  ///< empty: the command is about a built-in family
  std::string target = {};
  std::optional<std::string> word = {};  ///< the id of a form, beside that of its study
  std::string table = {};                ///< a file of rows, instead of a target
  std::string value = "value";           ///< the column of the measured values
  std::vector<StudyRange> over = {};
  bool has_domain = false;                                                   ///< by --range A:B
  std::vector<std::pair<std::string, std::vector<std::string>>> given = {};  ///< each with its values
  std::vector<StudyDefinition> definitions = {};
  std::vector<Held> starts = {};
  std::vector<ParameterBounds> bounds = {};
  std::vector<std::string> parameters = {};  ///< empty: every name that is nothing else
};

/// The form and its target. `fit`, `better`, `certify` and `emit` share these options.
struct FitOptions {
  std::string id = {};
  StudyFolders studies = {};
  std::optional<std::vector<double>> exponents = {};  ///< empty: the record's own sweep
  Metric metric = {};                                 ///< not yet checked against the family
  std::optional<Surface::Formula> target = {};        ///< empty: schlick; for `better` the usual three
  StudyOptions study = {};                            ///< a form of one's own, or changes to a study
  std::optional<double> f0 = {};                      ///< for relative errors of a Fresnel form
  std::optional<double> ior = {};  ///< of the surface; empty: no surface, 1.5 with an exact target
  std::optional<double> extinction = {};
  bool json = false;
  bool csv = false;
  bool latex = false;
  bool certify = false;
  std::optional<NumberFormat> round = {};
  std::optional<NumberFormat> evaluate = {};  ///< half or float
  bool sensitivity = false;
  std::optional<std::string> plot = {};  ///< a file for the picture of the fit
  bool force = false;                    ///< as in `RunOptions`
  std::set<std::string> present = {};    ///< the options on the command line
  std::vector<std::string> words = {};   ///< of the command line, but for its output
  Terminal terminal = {};
};

struct CertifyOptions {
  FitOptions fit = {};
  std::optional<Constants> parameters = {};  ///< as written; empty: the published ones, else fitted
  std::optional<double> width = {};          ///< of the bounds, relative; empty: the usual one
  std::optional<std::string> out = {};       ///< a file for the certificate
};

struct EmitOptions {
  FitOptions fit = {};
  std::optional<Constants> parameters = {};  ///< as in `CertifyOptions`
  std::optional<Language> language = {};     ///< empty with `check`
  ShaderPrecision precision = ShaderPrecision::float32;
  std::optional<std::string> name = {};  ///< of the function; empty: the family's
  std::optional<std::string> out = {};   ///< a file; empty: printed
  bool better = false;                   ///< the set that is better than the published one
  std::vector<std::string> check = {};   ///< generated files
};

struct VerifyOptions {
  std::string file;
};

struct StressOptions {
  std::string out = "out";
  bool force = false;  ///< as in `RunOptions`
  Terminal terminal = {};
};

struct BenchOptions {
  std::optional<std::string> study = {};  ///< the id or the file of a study, instead of the catalogue
  StudyFolders studies = {};              ///< that have it too
  std::string out = "out";
  std::vector<std::string> only = {};  ///< ids of targets
  bool force = false;                  ///< as in `RunOptions`
  bool quick = false;
  bool no_plots = false;
  std::optional<std::string> exhaustive = {};  ///< the id of a form: every float, instead of times
  std::optional<std::string> constants = {};   ///< of that form; the range is for it too
  bench::Stretch range = bench::unit_floats;
  /// The place of a Vulkan device among `device::vulkan_devices`, instead of the CPU.
  std::optional<std::size_t> device = {};
  bool list_devices = false;
  Terminal terminal = {};
};

struct SceneOptions {
  std::vector<std::string> files = {};
  std::optional<double> tolerance = {};  ///< in linear values; empty: 1/255
  std::optional<double> codes = {};      ///< the tolerance in sRGB codes instead
  std::optional<int> lights = {};        ///< empty: as many as the files name, else 1
  scene::PixelPrecision precision = scene::PixelPrecision::float32;
  scene::Conventions conventions = {};    ///< how the files are read
  std::optional<Language> language = {};  ///< prints only the code in it
  std::optional<std::string> out = {};    ///< a directory; empty: print only
  bool json = false;
  bool force = false;                   ///< as in `RunOptions`
  std::vector<std::string> words = {};  ///< of the command that prints the code, without files and --lang
  Terminal terminal = {};
};

struct ExplainOptions {
  std::string id;
  StudyFolders studies = {};
  bool json = false;
  Terminal terminal = {};
};

struct CiteOptions {
  std::optional<std::string> id = {};  ///< also the sources of this claim, constant, family or study
  StudyFolders studies = {};
};

struct CheckOptions {
  std::optional<std::string> study = {};  ///< as in `RunOptions`
  StudyFolders studies = {};
  std::string baseline = "reports/baseline";
  bool all = false;                       ///< also the slow tables
  std::optional<double> fail_above = {};  ///< the relative change that a number may have; empty: none
  findings::FindingFormat format = findings::FindingFormat::text;
  std::set<std::string> present = {};  ///< the options on the command line
  Terminal terminal = {};
};

}  // namespace shadefit
