#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/findings/finding.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/utf8.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/temporary_directory.hpp"

/// Hostile text in every field of a study, in names of files, in a table, a scene, a baseline and a pin: each
/// output has the shape that it has with a harmless text, and no character that a terminal does not show.
namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

constexpr const char* harmless = "Nobody 2014, A title";

const std::vector<std::string> hostile{
    "d'Eon 2014",
    "f'.system(\"touch marker\").'",
    "`touch marker` \"; system('touch marker') #",
    "E\n#error \"out\"\r\n*/ int x; /*",
    "a line that goes on \\",
    "a trigraph ?\?/",
    "\x1b[2J\x1b]0;title\a \x07 \x7f",
    "\u009b31m \u0085 \u2028 \u202e reversed \u2066 \U000e0041",
    "<script>alert(1)</script> <img src=x onerror=alert(1)> &lt;",
    "[a](javascript:alert(1)) ![b](http://c) <http://d> www.e.f *g* _h_ `i` ~j~ $k$ @l",
    "| a | b |",
    "# Heading",
    "===",
    "- item",
    "1. item",
    "=HYPERLINK(\"http://a\")",
    "+1, \"quoted\"",
    "@SUM(1)",
    "\\input{/etc/passwd} {a} }b{ %c & d # $e$ ^ ~ _",
    "{/Symbol a} x^2 y_{3} @z &{w} ~v{u}",
    "`c^k` falls, x = 1",
    "${jndi:ldap://a} %s %n {} {0} {:>99999}",
};

/// A text as TOML writes it.
std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out += c == '"' || c == '\\'         ? std::string{'\\', c}
           : byte < 0x20 || byte == 0x7F ? fmt::format("\\u{:04x}", byte)
                                         : std::string(1, c);
  }
  return out + "\"";
}

/// A study with a text in each field that takes any.
std::string study_with(const std::function<std::string()>& any, const std::string& target) {
  const auto text = [&] { return toml_text(any()); };
  return "schema = 1\nid = \"line\"\ntitle = " + text() + "\nabout = " + text() +
         "\n[over]\nx = " + (target.starts_with("table") ? "\"\"" : "\"0:1\"") + "\n[target]\n" + target +
         "\n[[form]]\nid = \"line\"\nformula = \"a + b x\"\n[[form]]\nid = \"slope\"\nformula = \"a x\"\n"
         "[metric]\nnorm = \"least-squares\"\n"
         "[[published]]\nform = \"line\"\nvalues = { a = \"-0.17\", b = \"1.0\" }\nsource = " +
         text() + "\nwhere = [" + text() + ", " + text() +
         "]\nclaim = { max_abs_error = \"0.2\", says = " + text() +
         " }\nvariants = [ { b = \"1.1\", seen = " + text() + " }, { a = \"0.1\", seen = " + text() +
         ", replaced = " + text() + " } ]\n";
}

/// What an output shows of its shape.
using OutputShape = std::string;

void expect_shown(const std::string& out, const std::string& what) {
  for (std::string_view rest = out; !rest.empty();) {
    const auto [length, point] = first_code_point(rest);
    ASSERT_GT(length, 0U) << what << ": no UTF-8";
    ASSERT_TRUE(point == '\n' || !is_unshown(point))
        << what << ": U+" << std::hex << static_cast<unsigned>(point) << " in " << printable(out);
    rest.remove_prefix(length);
  }
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string count_of(const std::string& text, char c) {
  return std::to_string(std::count(text.begin(), text.end(), c)) + c;
}

OutputShape lines_shape(const std::string& out) {
  return count_of(out, '\n');
}

/// The numbers of tags and lines.
OutputShape html_shape(const std::string& out) {
  return count_of(out, '<') + count_of(out, '>') + count_of(out, '\n');
}

/// The lines without what is escaped: of each the mark that it begins with, and its cells.
OutputShape markdown_shape(const std::string& out) {
  std::string shape;
  for (const std::string& line : lines_in(out)) {
    std::string bare;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == '&') {
        i = line.find(';', i);
      } else if (std::string_view("#|<>`*_[]$@").find(line[i]) != std::string_view::npos) {
        bare += line[i];
      }
    }
    const std::size_t sign = std::min(line.find_first_not_of("0123456789"), line.size());
    const std::string next = line.substr(sign, 2);
    const bool is_item = sign == 0 ? next.find_first_of("-+=") == 0 && next.find_first_of("0123456789") != 1
                                   : next == "." || next == ")" || next == ". " || next == ") ";
    shape += bare + (is_item ? "item" : "") + (line.find("://") != std::string::npos ? "link" : "") + "\n";
  }
  return shape;
}

/// What is outside of quotes.
OutputShape gnuplot_shape(const std::string& script) {
  std::string shape;
  for (const std::string& line : lines_in(script)) {
    if (line.starts_with("#")) {
      EXPECT_FALSE(line.ends_with('\\')) << line;
      continue;
    }
    std::string bare = line;
    for (std::size_t at = 0; (at = bare.find('\'', at)) != std::string::npos; ++at) {
      const std::size_t end = bare.find('\'', at + 1);
      if (end == std::string::npos) return "an open quote: " + line;
      bare.replace(at, end + 1 - at, "Q");
    }
    for (const std::string_view between : {"Q.\"\\047\".Q", "Q.\"\\n\".Q"})
      for (std::size_t at = 0; (at = bare.find(between)) != std::string::npos;)
        bare.replace(at, between.size(), "Q");
    // The lines of the legend follow from the longest label.
    if (bare.starts_with("set key on") || bare.starts_with("  keyentry with lines lc rgb Q")) continue;
    // The height of the legend follows from the longest label.
    std::erase_if(bare, [](char c) { return ('0' <= c && c <= '9') || c == '.'; });
    shape += bare + "\n";
  }
  return shape;
}

/// Code without its comments, of which none goes on.
OutputShape code_shape(const std::string& code) {
  std::string shape;
  for (const std::string& line : lines_in(code)) {
    const bool is_comment = line.starts_with("//");
    if (!is_comment) shape += line + "\n";
    EXPECT_FALSE(is_comment && (line.ends_with('\\') || line.ends_with("?\?/"))) << line;
  }
  return shape;
}

OutputShape csv_shape(const std::string& out) {
  const CsvTable table = parse_csv(out, "out");
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool is_text = table.columns[i] == "from" || table.columns[i] == "source";
      EXPECT_FALSE(is_text && row[i].find_first_of("=+-@") == 0) << row[i];
    }
  }
  return std::to_string(table.columns.size()) + "x" + std::to_string(table.rows.size());
}

/// Cells and braces of LaTeX, entries of BibTeX.
OutputShape latex_shape(const std::string& out) {
  std::string bare;
  int depth = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] == '\\') {
      bare += out.substr(i, 2) == "\\\\" ? "\\\\" : "";
      ++i;
      continue;
    }
    depth += out[i] == '{' ? 1 : out[i] == '}' ? -1 : 0;
    EXPECT_GE(depth, 0) << out;
    const bool is_entry = out[i] == '@' && (i == 0 || out[i - 1] == '\n');
    if (is_entry || std::string_view("&%#^~").find(out[i]) != std::string_view::npos) bare += out[i];
  }
  EXPECT_EQ(depth, 0) << out;
  return bare;
}

using Words = std::vector<std::string>;
using ShapeOf = OutputShape (*)(const std::string&);

/// Runs a command that has to succeed, or to fail by a check.
std::string output_of(const Words& words) {
  const Outcome outcome = run_command_line(words);
  EXPECT_LE(outcome.exit_code, 1) << words.front() << " " << outcome.err;
  expect_shown(outcome.err, words.front() + " on standard error");
  EXPECT_EQ(outcome.err.find("internal error"), std::string::npos) << outcome.err;
  return outcome.out;
}

/// The outputs of a study, each with what tells its shape.
struct NamedOutput {
  std::string name, text;
  ShapeOf shape;
};

std::vector<NamedOutput> outputs_of(const TemporaryDirectory& directory, const std::string& study,
                                    bool is_whole) {
  std::vector<NamedOutput> outputs;
  const auto add = [&](const Words& words, ShapeOf shape) {
    outputs.push_back({words.front() + " " + words.back(), output_of(words), shape});
  };
  const std::string out = directory / "out";
  fs::remove_all(out);
  output_of({"run", study, "--out", out});
  for (const auto& [file, shape] : {std::pair<const char*, ShapeOf>{"report.md", markdown_shape},
                                    {"better.csv", csv_shape},
                                    {"plots/better.gnuplot", gnuplot_shape}}) {
    if (fs::exists(fs::path(out) / file)) outputs.push_back({file, read_file(fs::path(out) / file), shape});
  }
  for (const Language language : languages) {
    if (is_whole || language == Language::c || language == Language::wgsl)
      add({"emit", study, "--lang", std::string(name(language))}, code_shape);
  }
  add({"cite", study}, latex_shape);
  add({"list", study}, [](const std::string& text) { return OutputShape(text.empty() ? "" : "text"); });
  add({"list", study, "--csv"}, csv_shape);
  if (!is_whole) return outputs;
  add({"explain", study}, lines_shape);
  add({"fit", study}, lines_shape);
  add({"better", study}, lines_shape);
  add({"better", study, "--csv"}, csv_shape);
  add({"fit", study, "--latex"}, latex_shape);
  for (const char* verb : {"list", "explain", "fit", "better"}) {
    const std::string printed = output_of({verb, study, "--json"});
    EXPECT_TRUE(nlohmann::json::accept(printed)) << printed;
    outputs.push_back({std::string(verb) + " --json", printed, lines_shape});
  }
  output_of({"run", study, "--html", "--out", directory / "html"});
  for (const char* page : {"index.html", "line.html"})
    outputs.push_back({page, read_file(directory / (std::string("html/") + page)), html_shape});
  outputs.push_back({"gallery.csv", read_file(directory / "html/gallery.csv"), csv_shape});
  return outputs;
}

void expect_same_shape(const std::vector<NamedOutput>& outputs, const std::vector<NamedOutput>& plain) {
  ASSERT_EQ(outputs.size(), plain.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    expect_shown(outputs[i].text, outputs[i].name);
    EXPECT_EQ(outputs[i].shape(outputs[i].text), plain[i].shape(plain[i].text)) << outputs[i].name << "\n"
                                                                                << printable(outputs[i].text);
  }
}

std::string constant_text() {
  return harmless;
}

class HostileText : public ::testing::Test {
 protected:
  std::string study(const std::function<std::string()>& any,
                    const std::string& target = "formula = \"x^2\"") {
    return directory_.file("line.toml", study_with(any, target));
  }

  TemporaryDirectory directory_;
};

TEST_F(HostileText, KeepsTheShapeOfEachOutput) {
  const EnvironmentVariable path("PATH", "/nowhere");  // no gnuplot
  const auto plain = outputs_of(directory_, study(constant_text), true);
  for (const NamedOutput& output : plain)
    EXPECT_EQ(output.text.find("\\x"), std::string::npos) << output.name;
  std::size_t next = 0;
  const auto any = [&] { return hostile[next++ % hostile.size()]; };
  // Each field gets each text in turn.
  const std::size_t fields = 8;
  for (std::size_t turn = 0; turn * fields < hostile.size(); ++turn) {
    next = turn * fields;
    expect_same_shape(outputs_of(directory_, study(any), true), plain);
  }
}

TEST_F(HostileText, AtRandom) {
  const EnvironmentVariable path("PATH", "/nowhere");
  const char* asked = std::getenv("SHADEFIT_HOSTILE_CASES");
  const int cases = asked == nullptr ? 50 : std::stoi(asked);
  const auto plain = outputs_of(directory_, study(constant_text), false);
  std::mt19937 random(53);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const std::vector<std::string> pieces{
      "'", "\"", "\\", "`",      "$",      "\n",     "\r",     "\t",     "<",   ">",   "&",  "|",
      "#", "*",  "_",  "[",      "]",      "(",      ")",      "{",      "}",   "@",   "^",  "~",
      "=", "+",  "-",  "1.",     " ",      ",",      ";",      "%",      "/*",  "*/",  "//", "?\?/",
      "a", "é",  "−",  "\u202e", "\u2028", "\u0085", "\x1b[m", "\u200b", "://", "www."};
  const auto any = [&] {
    std::string text;
    for (std::size_t length = 1 + below(12); length > 0; --length)
      text += below(6) == 0 ? hostile[below(hostile.size())] : pieces[below(pieces.size())];
    return text;
  };
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    expect_same_shape(outputs_of(directory_, study(any), false), plain);
    if (HasFailure()) break;
  }
}

TEST_F(HostileText, MakesNoFileByGnuplot) {
  if (!find_gnuplot()) GTEST_SKIP() << "without gnuplot: package gnuplot-nox";
  const fs::path before = fs::current_path();
  fs::current_path(directory_.path());
  for (const std::string& text : {hostile[0], hostile[1], hostile[2], hostile[3], hostile[4], hostile[19]}) {
    const std::string file = study([&] { return text; });
    for (const Words& words :
         {Words{"run", file, "--out", "out"}, Words{"better", file, "--plot", "a.svg"}}) {
      Words forced = words;
      forced.emplace_back("--force");
      const Outcome outcome = run_command_line(forced);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    for (const char* picture : {"out/plots/better.svg", "a.svg"}) {
      const std::string svg = fs::exists(picture) ? read_file(picture) : "";
      EXPECT_TRUE(svg.find("</svg>") != std::string::npos) << picture << " of " << printable(text);
      EXPECT_EQ(svg.find("<script"), std::string::npos) << picture;
    }
    for (const auto& entry : fs::recursive_directory_iterator("."))
      EXPECT_NE(entry.path().filename(), "marker") << printable(text);
  }
  fs::current_path(before);
}

TEST_F(HostileText, InNamesOfTables) {
  const EnvironmentVariable path("PATH", "/nowhere");
  const std::string rows = "x,value\n0,0\n0.25,0.06\n0.5,0.25\n0.75,0.56\n1,1\n";
  directory_.file("rows.csv", rows);
  const auto plain = outputs_of(directory_, study(constant_text, "table = \"rows.csv\""), true);
  for (const std::string& text : {std::string("'.system('touch marker').'"), std::string("\x1b[2J\u202e\\"),
                                  std::string("<script>|$@[a](b)*_`")}) {
    directory_.file(text, rows);
    expect_same_shape(outputs_of(directory_, study(constant_text, "table = " + toml_text(text)), true),
                      plain);
  }
}

// A text that is an id, a name or a formula is refused, in one line.
TEST_F(HostileText, IsNoNameAndNoFormula) {
  const std::string plain = study_with(constant_text, "formula = \"x^2\"");
  for (const char* field :
       {"id = \"line\"\ntitle", "id = \"line\"\nformula", "x = \"0:1\"", "\"a + b x\"", "\"x^2\"",
        "form = \"line\"\nvalues", "{ a = ", "\"-0.17\"", "\"0.2\"", "\"1.1\"", "\"least-squares\""}) {
    for (const std::string& text : hostile) {
      std::string changed = plain;
      const std::string_view what = field;
      const std::string word = toml_text(text);
      const std::size_t at = changed.find(what);
      ASSERT_NE(at, std::string::npos) << what;
      const std::size_t begin = what.front() == '"'   ? at
                                : what.front() == '{' ? at + 2
                                                      : changed.find('=', at) + 2;
      const std::size_t end = what.front() == '{' ? begin + 1 : changed.find('"', begin + 1) + 1;
      changed.replace(begin, end - begin, word);
      const Outcome outcome = run_command_line({"explain", directory_.file("line.toml", changed)});
      EXPECT_EQ(outcome.exit_code, 2) << what << " " << printable(text);
      EXPECT_EQ(lines_shape(outcome.err), "1\n") << outcome.err;
      expect_shown(outcome.err, field);
    }
  }
}

TEST_F(HostileText, OfSourceTreesScenesAndBaselines) {
  const std::string name = "\x1b[2J\u202e<img>|\n::error::[a](b).glsl";
  const std::string tree = directory_ / "tree";
  directory_.file("tree/" + name,
                  "float f(float c) { return exp2((-5.55472 * c - 6.98316) * c); }\n"
                  "float g = 1.0; // shadefit: ignore \x1b[2J <b> | [a](b)\n"
                  "float h = 5.55472; // shadefit: \x1b[2J\u202e<b>.a\n");
  const std::string scene = directory_.file(
      "a.mtl", "newmtl \x1b[2J\u202e<b>|[a](javascript:b)$@\\\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n");
  const std::string study_file = study(constant_text);
  const EnvironmentVariable path("PATH", "/nowhere");
  output_of({"run", study_file, "--out", directory_ / "out"});
  std::string baseline = read_file(directory_ / "out/better.csv");
  baseline.replace(baseline.find("Nobody"), 6, "\u202e<b>[a](b)$@");
  directory_.file("out/better.csv", baseline);
  const auto expect_bare = [](const std::string& out, const std::string& what) {
    expect_shown(out, what);
    EXPECT_EQ(out.find("\n::error::["), std::string::npos) << what;
  };
  for (const findings::FindingFormat format : findings::finding_formats) {
    const std::string word(findings::name(format));
    for (const Words& words :
         {Words{"lint", tree, "--all"}, Words{"check", study_file, "--baseline", directory_ / "out"}}) {
      Words in_format = words;
      in_format.insert(in_format.end(), {"--format", word});
      const std::string out = output_of(in_format);
      expect_bare(out, words.front() + " " + word);
      if (format == findings::FindingFormat::markdown) {
        EXPECT_EQ(out.find("<b>"), std::string::npos) << out;
        EXPECT_EQ(out.find("<img>"), std::string::npos) << out;
      }
    }
  }
  for (const Words& more :
       {Words{}, Words{"--json"}, Words{"--lang", "c"}, Words{"--out", directory_ / "plan"}}) {
    Words words{"scene", scene};
    words.insert(words.end(), more.begin(), more.end());
    expect_bare(output_of(words), "scene");
  }
  for (const auto& entry : fs::directory_iterator(directory_ / "plan")) {
    const std::string text = read_file(entry.path());
    if (entry.path().extension() == ".md") {
      EXPECT_EQ(text.find("<b>"), std::string::npos) << text;
    }
    expect_bare(text, entry.path().string());
  }
}

}  // namespace
}  // namespace shadefit
