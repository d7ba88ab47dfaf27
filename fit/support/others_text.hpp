#pragma once

#include <compare>
#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace shadefit {

/// Text that others wrote: the title of a study, the source of its constants, the name of a file. It may hold
/// anything: quotes, markup, control characters. So it has no formatter and becomes no std::string:
/// reports/io/escape.hpp writes it, escaped for its place. A text is of others if a part of it is.
class OthersText {
 public:
  OthersText() = default;
  OthersText(std::string text) : text_(std::move(text)) {}

  bool empty() const { return text_.empty(); }

  /// For what compares it, reads it or opens it; for messages of errors, which the command escapes; and for
  /// the writers. tests/reports/escape_test.cpp lists the files that may call it.
  const std::string& unescaped() const { return text_; }

  OthersText& operator+=(const OthersText& more) {
    text_ += more.text_;
    return *this;
  }
  friend OthersText operator+(OthersText a, const OthersText& b) { return a += b; }
  template <std::convertible_to<std::string_view> Ours>
  friend OthersText operator+(OthersText a, const Ours& b) {
    return a += std::string(b);
  }
  template <std::convertible_to<std::string_view> Ours>
  friend OthersText operator+(const Ours& a, const OthersText& b) {
    return OthersText(std::string(a)) += b;
  }
  friend auto operator<=>(const OthersText&, const OthersText&) = default;
  friend bool operator==(const OthersText&, const OthersText&) = default;
  template <std::convertible_to<std::string_view> Ours>
  friend bool operator==(const OthersText& a, const Ours& b) {
    return a.text_ == std::string_view(b);
  }

  /// A value of nlohmann::json, whose text `json_text` escapes.
  template <class Json>
  requires requires { typename Json::string_t; }
  friend void to_json(Json& json, const OthersText& text) { json = text.text_; }

 private:
  std::string text_;
};

}  // namespace shadefit
