#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/scan/literals.hpp"

/// Numbers that a text gives a name: "#define K 0.04045", "static const float K = 0.04045;".
namespace shadefit::lint {

/// A text with these numbers at the places of their names, and no longer where they are defined.
class TextWithNumbers {
 public:
  const std::string& text() const { return text_; }

  /// Whether a name stood at this place.
  bool is_named(std::size_t offset) const;

  /// How often the number at this place is used by its name.
  std::size_t count_uses(std::size_t offset) const;

  /// The place in the original text: of a named number, where it is defined.
  std::size_t original(std::size_t offset) const;

  /// Adds a part that begins there in the original text.
  void append(std::string_view part, std::size_t original, bool is_named);

 private:
  /// From `begin` on, the text is that from `original` on; a named number is its definition.
  struct Piece {
    std::size_t begin, original;
    bool is_named;
  };
  const Piece& piece_at(std::size_t offset) const;

  std::string text_;
  std::vector<Piece> pieces_;
};

/// Empty if the text names no number that is telling, or uses no such name. A name that is defined twice
/// stays.
std::optional<TextWithNumbers> with_named_numbers(std::string_view text, CommentStyle style,
                                                  const std::vector<Literal>& literals,
                                                  const std::function<bool(const Literal&)>& is_telling);

}  // namespace shadefit::lint
