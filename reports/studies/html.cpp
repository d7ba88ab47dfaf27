#include "reports/studies/html.hpp"

#include <fmt/format.h>

#include <variant>
#include <vector>

#include "reports/io/escape.hpp"

namespace shadefit {
namespace {

/// Colours by role, for light and dark mode. Tables scroll on a narrow screen.
constexpr std::string_view style = R"(
:root { color-scheme: light dark; --text: #1c1c1c; --back: #ffffff; --soft: #5a5a5a; --line: #d6d6d6; --link: #0b57b0;
  --good: #1a6b34; --part: #8a3a9e; --bad: #b3261e; --one: #b3261e; --two: #0b57b0; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e6e6; --back: #161616; --soft: #a6a6a6; --line: #3a3a3a; --link: #8ab8ff;
  --good: #7fd397; --part: #d9a3e8; --bad: #ff8a80; --one: #ff8a80; --two: #8ab8ff; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--text); background: var(--back); margin: 0 auto; padding: 1rem; max-width: 80rem; overflow-wrap: break-word; }
a { color: var(--link); }
h1 { font-size: 1.5rem; line-height: 1.25; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.facts { list-style: none; padding: 0; } .facts li { margin: .15rem 0; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; padding: .35rem .7rem; border-bottom: 1px solid var(--line); vertical-align: top; }
.number { text-align: right; font-variant-numeric: tabular-nums; } td.number { white-space: nowrap; } td.long { min-width: 14rem; }
body:has(.sortable) { max-width: 116rem; } .sortable :is(td, th) { padding-inline: .45rem; } body:has(.sortable) :is(p, ul) { max-width: 80rem; } .sortable td.long { min-width: 10rem; }
.sortable :is(td, th):first-child { position: sticky; left: 0; background: var(--back); }
@media (min-width: 40rem) { .sortable td:first-child { white-space: nowrap; } }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; text-align: inherit; }
th[aria-sort] button::after { content: "\a0\2195"; color: var(--soft); }
th[aria-sort=ascending] button::after { content: "\a0\2191"; } th[aria-sort=descending] button::after { content: "\a0\2193"; }
input, select { font: inherit; color: inherit; background: var(--back); border: 1px solid var(--soft); border-radius: .25rem; padding: .3rem .5rem; }
input[type=search] { width: min(100%, 24rem); }
pre { background: color-mix(in srgb, var(--text) 6%, var(--back)); padding: .7rem; overflow-x: auto; font-size: .85rem; }
.code > button { font: inherit; font-size: .85rem; padding: .25rem .75rem; } .code pre { margin-top: .5rem; }
.soft { color: var(--soft); } .confirmed { color: var(--good); } .partly { color: var(--part); } .refuted { color: var(--bad); }
svg { width: 100%; max-width: 45rem; height: auto; } svg text { font: 12px system-ui, sans-serif; fill: var(--soft); }
@media (max-width: 40rem) { svg text { font-size: 20px; } }
.axis { stroke: var(--line); } polyline { fill: none; stroke-width: 2; }
.curve-1 { stroke: var(--one); } .curve-2 { stroke: var(--two); stroke-dasharray: 6 3; }
.over { fill: var(--two); } .under { fill: var(--one); } .frame { fill: none; stroke: var(--line); }
.key-1 { color: var(--one); } .key-2 { color: var(--two); }
)";

/// Search, sort and copy. Everything is readable without this.
constexpr std::string_view page_script = R"(
for (const table of document.querySelectorAll('table.sortable')) {
  const body = table.tBodies[0];
  table.tHead.addEventListener('click', event => {
    const head = event.target.closest('th');
    if (!head) return;
    const rising = head.getAttribute('aria-sort') !== 'ascending';
    for (const other of table.querySelectorAll('th')) other.setAttribute('aria-sort', 'none');
    head.setAttribute('aria-sort', rising ? 'ascending' : 'descending');
    const key = row => row.cells[head.cellIndex].textContent;
    const number = text => text === 'exact' ? 0 : Number(text);
    const compare = (a, b) => {
      if (key(a) === '' || key(b) === '') return (key(a) === '') - (key(b) === '');  // empty cells come last
      const x = number(key(a)), y = number(key(b));
      if (isNaN(x) && isNaN(y)) return (rising ? 1 : -1) * key(a).localeCompare(key(b));
      return isNaN(x) ? 1 : isNaN(y) ? -1 : rising ? x - y : y - x;
    };
    const rows = [...body.rows].sort(compare);
    body.append(...rows);
  });
}
const search = document.querySelector('input[type=search]');
if (search) search.addEventListener('input', () => {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const row of document.querySelector('table.sortable').tBodies[0].rows) {
    row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
    if (!row.hidden) ++shown;
  }
  document.querySelector('#shown').textContent = shown + ' shown';
});
const language = document.querySelector('select');
if (language) {
  const show = () => {
    for (const code of document.querySelectorAll('.code')) code.hidden = code.dataset.language !== language.value;
  };
  language.addEventListener('change', show);
  show();
}
for (const code of document.querySelectorAll('.code')) {
  code.querySelector('button').addEventListener('click', async event => {
    try {
      await navigator.clipboard.writeText(code.querySelector('pre').textContent);
      event.target.textContent = 'copied';
    } catch {  // without https a browser may refuse
      getSelection().selectAllChildren(code.querySelector('pre'));
      event.target.textContent = 'selected';
    }
  });
}
)";

/// The class of a text that begins with a verdict; otherwise empty.
std::string_view class_of_verdict(std::string_view words) {
  if (words.starts_with("confirmed") || words.starts_with("rounding")) return "confirmed";
  if (words.starts_with("other-objective") || words.starts_with("undecidable")) return "partly";
  return words.starts_with("refuted") ? "refuted" : "";
}

bool is_number(const Cell& cell) {
  return std::holds_alternative<Number>(cell) || std::holds_alternative<long>(cell);
}

/// For each column, whether it has a number.
std::vector<bool> columns_with_numbers(const Table& table) {
  std::vector<bool> has_numbers(table.columns.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) has_numbers[i] = has_numbers[i] || is_number(row[i]);
  return has_numbers;
}

/// ` class="..."` of a cell with these words; otherwise empty. Long texts get a wide column.
std::string class_of_cell(std::string_view words, bool in_a_column_of_numbers) {
  constexpr std::size_t most_in_a_narrow_column = 24;
  if (words.size() > most_in_a_narrow_column)
    return fmt::format(" class=\"{}{}long\"", class_of_verdict(words),
                       class_of_verdict(words).empty() ? "" : " ");
  const std::string_view name = in_a_column_of_numbers ? "number" : class_of_verdict(words);
  return name.empty() ? "" : fmt::format(" class=\"{}\"", name);
}

}  // namespace

std::string html_page(const OthersText& title, std::string_view body) {
  return fmt::format(
      "<!doctype html><!-- shadefit -->\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\">\n<style>{}</style>\n</head>\n<body>\n{}<script>{}</script>\n</body>\n</html>\n",
      for_html(title), style, body, page_script);
}

std::string html_table(const Table& table, bool is_index) {
  std::string out = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"table\"><table{}>\n<thead><tr>",
      is_index ? " class=\"sortable\"" : "");
  const std::vector<bool> has_numbers = columns_with_numbers(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string name = for_html(table.columns[i]);
    out += fmt::format("<th scope=\"col\"{}{}>{}</th>", has_numbers[i] ? " class=\"number\"" : "",
                       is_index ? " aria-sort=\"none\"" : "",
                       is_index ? "<button type=\"button\">" + name + "</button>" : name);
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto* others = std::get_if<OthersText>(&row[i]);
      const std::string words = for_html(others != nullptr ? *others : text(row[i], Precision::report));
      const std::string inside =
          is_index && i == 0 ? fmt::format("<a href=\"{0}.html\">{0}</a>", words) : words;
      out += fmt::format("<td{}>{}</td>", class_of_cell(words, has_numbers[i]), inside);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace shadefit
