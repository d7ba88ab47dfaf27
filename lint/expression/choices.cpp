#include <optional>
#include <utility>

#include "lint/expression/statements.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Whether a text begins with a word.
bool begins_with(std::string_view text, std::string_view word) {
  return text.starts_with(word) && (text.size() == word.size() || !is_of_name(text[word.size()]));
}

/// "let y = if x < t": what stands before the word, the condition, and what follows it.
struct Head {
  std::string before, condition, rest;
};

/// After the word `if`.
Head condition_and_rest(std::string_view text, CommentStyle style) {
  text = trimmed(text);
  if (text.starts_with('(')) {
    const std::size_t close = 1 + place_outside(text.substr(1), ")");
    const std::string_view rest = trimmed(text.substr(std::min(close + 1, text.size())));
    // In "(x + 1) < t" they are only a part of the condition.
    if (rest.empty() || !is_one_of(rest.front(), "<>=!&|+-*/.")) {
      const bool has_colon = style == CommentStyle::hash && rest.starts_with(':');
      return {"", std::string(text.substr(1, close - 1)), std::string(rest.substr(has_colon ? 1 : 0))};
    }
  }
  const std::size_t colon = style == CommentStyle::hash ? place_outside(text, ":") : text.size();
  return {"", std::string(text.substr(0, colon)), std::string(text.substr(std::min(colon + 1, text.size())))};
}

std::optional<Head> head_of(std::string_view text, CommentStyle style) {
  text = trimmed(text);
  constexpr std::string_view word = "if";
  if (begins_with(text, word)) return condition_and_rest(text.substr(word.size()), style);
  // Rust: let y = if x < t { a } else { b };
  const std::size_t at = text.find(" if ");
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view before = text.substr(0, at);
  if (!before.ends_with('=') && before != "return") return std::nullopt;
  Head head = condition_and_rest(text.substr(at + word.size() + 1), style);
  head.before = std::string(before) + " ";
  return head;
}

/// The value of a branch: that of "x /= 2" is x / (2).
std::string value_of(const Assignment& assignment) {
  if (assignment.operation == '\0') return "(" + assignment.right + ")";
  return "(" + assignment.name + " " + assignment.operation + " (" + assignment.right + "))";
}

/// Joins statements.
class ChoiceReader {
 public:
  ChoiceReader(std::vector<Statement> statements, CommentStyle style)
      : statements_(std::move(statements)), style_(style) {}

  std::vector<Statement> read() {
    std::vector<Statement> joined;
    while (at_ < statements_.size()) {
      const std::size_t first = at_;
      std::string text = text_at(at_);
      // A chain may have begun further above.
      if (const auto rest = behind_else(text)) text = *rest;
      auto choice = read_choice(text);
      if (choice) {
        joined.push_back({statements_[first].begin, statements_[at_ - 1].end, std::move(*choice)});
      } else {
        at_ = first + 1;
        joined.push_back(std::move(statements_[first]));
      }
    }
    return joined;
  }

 private:
  std::string text_at(std::size_t i) const {
    return std::string(trimmed(with_joined_lines(statements_[i].text)));
  }

  /// Whether a statement is only the blanks between others, and no end of a block.
  bool is_gap(std::size_t i) const {
    return statements_[i].sign != '{' && statements_[i].sign != '}' && text_at(i).empty();
  }

  void skip_gaps() {
    while (at_ < statements_.size() && is_gap(at_)) ++at_;
  }

  /// What follows the word `else`.
  std::optional<std::string> behind_else(std::string_view text) const {
    constexpr std::string_view word = "else", python = "elif";
    if (begins_with(text, python)) return "if" + std::string(text.substr(python.size()));
    if (!begins_with(text, word)) return std::nullopt;
    text = trimmed(text.substr(word.size()));
    if (style_ == CommentStyle::hash && text.starts_with(':')) text.remove_prefix(1);
    return std::string(trimmed(text));
  }

  /// Reads a choice whose first statement, at `at_`, has this text.
  std::optional<std::string> read_choice(std::string_view text) {
    const auto head = head_of(text, style_);
    if (!head || head->condition.empty()) return std::nullopt;
    const auto yes = read_branch(head->rest);
    if (!yes) return std::nullopt;
    const auto first = assignment_of(*yes);
    if (!first) return std::nullopt;
    const auto second = read_other_branch(*head, *yes, *first);
    if (!second || second->name != first->name) return std::nullopt;
    std::string joined = head->before;
    if (joined.empty()) joined = first->name.empty() ? "return " : first->name + " = ";
    return joined + "(" + head->condition + ") ? " + value_of(*first) + " : " + value_of(*second);
  }

  /// The branch behind a condition or an `else`, of one statement: `rest`, if that is not empty, or what
  /// follows.
  std::optional<std::string> read_branch(std::string_view rest) {
    if (begins_with(rest, "if")) return read_choice(rest);
    if (!rest.empty()) {
      const bool is_block = statements_[at_].sign == '{';
      ++at_;
      return is_block ? std::nullopt : std::optional(std::string(rest));
    }
    bool is_block = statements_[at_++].sign == '{';
    if (!is_block) skip_gaps();
    if (at_ >= statements_.size()) return std::nullopt;
    if (!is_block && statements_[at_].sign == '{' && text_at(at_).empty()) {
      is_block = true;
      ++at_;
    }
    if (is_block) return read_block();
    // The text does not show where the branches of an inner one end.
    const std::string text = text_at(at_);
    if (statements_[at_].sign == '{' || text.empty() || begins_with(text, "if")) return std::nullopt;
    ++at_;
    return text;
  }

  /// The only statement up to the closing brace.
  std::optional<std::string> read_block() {
    std::string only;
    for (; at_ < statements_.size(); ++at_) {
      if (statements_[at_].sign == '{') return std::nullopt;
      std::string text = text_at(at_);
      if (!text.empty() && !only.empty()) return std::nullopt;
      if (!text.empty()) only = std::move(text);
      if (statements_[at_].sign != '}') continue;
      ++at_;
      return only.empty() ? std::nullopt : std::optional(std::move(only));
    }
    return std::nullopt;
  }

  /// What is computed if the condition does not hold: by the `else`; after "if (..) return a;" by the next
  /// statement; after "if (..) y = a;" it is the old y.
  std::optional<Assignment> read_other_branch(const Head& head, std::string_view yes,
                                              const Assignment& first) {
    const std::size_t end = at_;
    skip_gaps();
    const std::string next = at_ < statements_.size() ? text_at(at_) : "";
    if (const auto rest = behind_else(next)) {
      const auto no = read_branch(*rest);
      return no ? assignment_of(*no) : std::nullopt;
    }
    if (!head.before.empty()) return std::nullopt;
    if (!first.name.empty()) {
      at_ = end;
      return Assignment{first.name, '\0', first.name};
    }
    if (!begins_with(yes, "return") || next.empty()) return std::nullopt;
    if (begins_with(next, "if")) {
      const auto no = read_choice(next);
      return no ? assignment_of(*no) : std::nullopt;
    }
    // In Rust the last expression of a function is its value.
    const char sign = statements_[at_++].sign;
    if (sign == '{' || (sign != '}' && !begins_with(next, "return"))) return std::nullopt;
    return assignment_of(next);
  }

  std::vector<Statement> statements_;
  CommentStyle style_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Statement> with_choices(std::vector<Statement> statements, CommentStyle style) {
  return ChoiceReader(std::move(statements), style).read();
}

}  // namespace shadefit::lint
