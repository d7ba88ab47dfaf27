#include "lint/number_table.hpp"

#include <string>

#include "lint/expression/statements.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Whether this text between two numbers has a comma and otherwise only signs, zeros, brackets and
/// constructors: "), vec3(0, -".
bool is_between_elements(std::string_view text) {
  bool has_comma = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    has_comma = has_comma || text[i] == ',';
    if (is_letter(text[i])) {
      while (i < text.size() && (is_of_name(text[i]) || text[i] == '<' || text[i] == '>')) ++i;
      if (i == text.size() || std::string_view("([{").find(text[i]) == std::string_view::npos) return false;
    } else if (!is_blank(text[i]) &&
               std::string_view(",+-()[]{}0.").find(text[i]) == std::string_view::npos) {
      return false;
    }
  }
  return has_comma;
}

/// The numbers of a text outside of comments.
class List {
 public:
  List(std::string_view text, CommentStyle style, const std::vector<Literal>& literals)
      : text_(text), style_(style), literals_(literals) {}

  /// The next number of the list behind one, or none.
  std::size_t behind(std::size_t literal) const {
    std::size_t next = literal + 1;
    while (next < literals_.size() && literals_[next].is_in_comment) ++next;
    return next < literals_.size() && are_joined(literal, next) ? next : none();
  }

  std::size_t before(std::size_t literal) const {
    std::size_t last = literal;
    do {
      if (last == 0) return none();
      --last;
    } while (literals_[last].is_in_comment);
    return are_joined(last, literal) ? last : none();
  }

  std::size_t none() const { return literals_.size(); }

 private:
  bool are_joined(std::size_t a, std::size_t b) const {
    constexpr std::size_t longest = 400;
    const std::size_t end = literals_[a].offset + literals_[a].length, begin = literals_[b].offset;
    return begin - end <= longest &&
           is_between_elements(without_comments(text_.substr(end, begin - end), style_));
  }

  std::string_view text_;
  CommentStyle style_;
  const std::vector<Literal>& literals_;
};

}  // namespace

bool is_in_table(std::string_view text, CommentStyle style, const std::vector<Literal>& literals,
                 std::size_t first, std::size_t last) {
  const List list(text, style, literals);
  std::size_t count = 1;
  for (std::size_t i = first; i < last; ++count) {
    i = list.behind(i);
    if (i > last) return false;
  }
  for (std::size_t i = list.before(first); i != list.none() && count < least_table; i = list.before(i))
    ++count;
  for (std::size_t i = list.behind(last); i != list.none() && count < least_table; i = list.behind(i))
    ++count;
  return count >= least_table;
}

}  // namespace shadefit::lint
