#include "lint/expression/program_text.hpp"

#include "lint/scan/characters.hpp"

namespace shadefit::lint {

std::string comment_as_program(std::string_view text) {
  std::string out(text);
  bool is_at_start = true;  // of a line, or of a comment
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string_view sign = text.substr(i, 2);
    if (out[i] == '\n') {
      is_at_start = true;
    } else if (sign == "//" || sign == "/*" || sign == "*/") {
      out[i] = ';';
      out[++i] = ' ';
      is_at_start = true;
    } else if (is_at_start && is_one_of(out[i], "*/#!<")) {
      out[i] = ' ';
    } else if (!is_blank(out[i])) {
      is_at_start = false;
    }
  }
  return out;
}

}  // namespace shadefit::lint
