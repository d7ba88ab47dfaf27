#include "lint/scan/named_numbers.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Whether a text has this word, and not only as a part of another one.
bool has_whole_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_name(text[at - 1])) && (end == text.size() || !is_of_name(text[end]))) return true;
  }
  return false;
}

bool begins_with_hash(std::string_view line) {
  return line.substr(end_of_run(line, 0, is_blank_in_line)).starts_with('#');
}

/// A declaration up to its name: "let k" of "let k: f32", all of "const std::size_t k".
std::string_view without_type(std::string_view declaration) {
  for (std::size_t at = declaration.find(':'); at < declaration.size(); at = declaration.find(':', at + 1)) {
    if (!declaration.substr(at).starts_with("::")) return declaration.substr(0, at);
    ++at;
  }
  return declaration;
}

/// A number that has a name.
struct NamedNumber {
  std::string_view name;
  std::size_t begin, end;  ///< of the number with its sign and its parentheses
  Literal literal;
  bool is_negative;
};

/// Reads the definition whose number is this literal.
std::optional<NamedNumber> definition_of(std::string_view text, CommentStyle style, const Literal& literal) {
  std::size_t begin = literal.offset, end = literal.offset + literal.length;
  const auto skip_blanks = [&] {
    begin = begin_of_run(text, begin, is_blank_in_line);
    end = end_of_run(text, end, [](char c) { return is_blank_in_line(c) || c == '\r'; });
  };
  const bool is_negative = begin > 0 && text[begin - 1] == '-';
  if (is_negative) --begin;
  skip_blanks();
  if (begin > 0 && end < text.size() && text[begin - 1] == '(' && text[end] == ')') {
    --begin;
    ++end;
    skip_blanks();
  }
  const std::size_t number_begin = begin, number_end = end;
  const bool is_assigned = begin > 0 && text[begin - 1] == '=';
  if (is_assigned) --begin;
  begin = begin_of_run(text, begin, is_blank_in_line);
  const std::size_t line = line_begin(text, begin);
  const std::string_view left = text.substr(line, begin - line),
                         named = is_assigned ? without_type(left) : left;
  const std::size_t name_end = begin_of_run(named, named.size(), is_blank_in_line);
  const std::size_t name_begin = begin_of_run(named, name_end, is_of_name);
  if (name_begin == name_end || is_digit(named[name_begin])) return std::nullopt;
  const std::string_view before = named.substr(0, name_begin);
  const bool ends_line = end == text.size() || text[end] == '\n' || text.substr(end).starts_with("//") ||
                         text.substr(end).starts_with("/*");
  const char next = end < text.size() ? text[end] : '\0';
  const auto is_definition = [&] {
    if (!is_assigned) return begins_with_hash(before) && has_whole_word(before, "define") && ends_line;
    constexpr std::array<std::string_view, 4> words{"const", "constexpr", "final", "readonly"};
    const bool is_constant =
        std::ranges::any_of(words, [&](std::string_view word) { return has_whole_word(before, word); });
    const bool is_of_module = style == CommentStyle::hash && before.empty() && (ends_line || next == '#');
    return is_of_module || (is_constant && next == ';');
  };
  if (!is_definition()) return std::nullopt;
  return NamedNumber{named.substr(name_begin, name_end - name_begin), number_begin, number_end, literal,
                     is_negative};
}

/// Puts the numbers at the places of their names.
class NumberNames {
 public:
  NumberNames(std::string_view text, const std::vector<NamedNumber>& definitions) : text_(text) {
    for (const NamedNumber& one : definitions) {
      const auto [place, is_new] = names_.emplace(one.name, one);
      if (!is_new) place->second.name = {};  // defined twice
    }
    for (const auto& [name, one] : names_)
      if (!one.name.empty()) definitions_.push_back(one);
    std::ranges::sort(definitions_, {}, &NamedNumber::begin);
  }

  std::optional<TextWithNumbers> replaced() {
    auto next = definitions_.begin();
    for (std::size_t at = 0; at < text_.size();) {
      if (next != definitions_.end() && at == next->begin) {
        copy(at);
        at = done_ = next->end;
        ++next;
      } else if (is_of_name(text_[at])) {
        const std::size_t end = end_of_run(text_, at, is_of_name);
        use(at, end);
        at = end;
      } else {
        ++at;
      }
    }
    copy(text_.size());
    return is_used_ ? std::optional(std::move(out_)) : std::nullopt;
  }

 private:
  void copy(std::size_t end) { out_.append(text_.substr(done_, end - done_), done_, false); }

  /// Not a member, and not in #ifdef or the definition.
  void use(std::size_t begin, std::size_t end) {
    const auto found = names_.find(text_.substr(begin, end - begin));
    if (found == names_.end() || found->second.name.empty()) return;
    const NamedNumber& number = found->second;
    const bool is_definition = number.name.data() == text_.data() + begin;
    if (is_definition || (begin > 0 && (text_[begin - 1] == '.' || text_[begin - 1] == ':'))) return;
    const std::string_view line = text_.substr(line_begin(text_, begin));
    if (begins_with_hash(line) && !has_whole_word(line.substr(0, line.find('\n')), "define")) return;
    copy(begin);
    done_ = end;
    if (number.is_negative) out_.append("(-", begin, false);
    const std::size_t original = number.literal.offset;
    out_.append(text_.substr(original, number.literal.length), original, true);
    if (number.is_negative) out_.append(")", begin, false);
    is_used_ = true;
  }

  std::string_view text_;
  std::map<std::string_view, NamedNumber> names_;
  std::vector<NamedNumber> definitions_;  ///< by their places
  TextWithNumbers out_;
  std::size_t done_ = 0;  ///< how much of the text is in `out_`
  bool is_used_ = false;
};

}  // namespace

void TextWithNumbers::append(std::string_view part, std::size_t original, bool is_named) {
  pieces_.push_back({text_.size(), original, is_named});
  text_ += part;
}

const TextWithNumbers::Piece& TextWithNumbers::piece_at(std::size_t offset) const {
  return *std::prev(std::ranges::upper_bound(pieces_, offset, {}, &Piece::begin));
}

bool TextWithNumbers::is_named(std::size_t offset) const {
  return piece_at(offset).is_named;
}

std::size_t TextWithNumbers::count_uses(std::size_t offset) const {
  const std::size_t definition = piece_at(offset).original;
  return static_cast<std::size_t>(std::ranges::count_if(
      pieces_, [&](const Piece& piece) { return piece.is_named && piece.original == definition; }));
}

std::size_t TextWithNumbers::original(std::size_t offset) const {
  const Piece& piece = piece_at(offset);
  return piece.original + (offset - piece.begin);
}

std::optional<TextWithNumbers> with_named_numbers(std::string_view text, CommentStyle style,
                                                  const std::vector<Literal>& literals,
                                                  const std::function<bool(const Literal&)>& is_telling) {
  std::vector<NamedNumber> definitions;
  bool has_telling = false;
  for (const Literal& literal : literals) {
    if (literal.is_in_comment) continue;
    const auto definition = definition_of(text, style, literal);
    if (!definition) continue;
    definitions.push_back(*definition);
    has_telling = has_telling || is_telling(literal);
  }
  return has_telling ? NumberNames(text, definitions).replaced() : std::nullopt;
}

}  // namespace shadefit::lint
