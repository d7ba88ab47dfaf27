#include "scene/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "fit/user_error.hpp"

namespace shadefit::scene {
namespace {

using Json = nlohmann::json;

/// Makes a document of what the library's parser tells. Its own builder with a callback looks through all of
/// an array after each of its elements, and without one bounds nothing.
class JsonBuilder {
 public:
  JsonBuilder(std::string_view text, const std::string& file, bool (*is_kept)(std::string_view))
      : text_(text), file_(file), is_kept_(is_kept) {}

  Json document() { return std::move(root_); }

  // What the parser calls: each returns whether to go on.

  bool null() { return take(nullptr); }
  bool boolean(bool value) { return take(value); }
  bool number_integer(Json::number_integer_t value) { return take(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return take(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return take(value); }
  bool string(std::string& value) { return take(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }  // in no text
  bool start_object(std::size_t) { return begin(Json::object()); }
  bool end_object() { return end(); }
  bool start_array(std::size_t) { return begin(Json::array()); }
  bool end_array() { return end(); }

  bool key(std::string& name) {
    if (is_skipping_) return true;
    is_skipping_ = !is_kept_(name);
    skipped_at_ = depth_;
    if (!is_skipping_) member_ = &(*open_.back())[name];
    return true;
  }

  /// Called at the last byte that was read, counted from 1 on.
  bool parse_error(std::size_t byte, const std::string&, const Json::exception& error) {
    constexpr int number_overflow = 406;
    refuse_at(byte, error.id == number_overflow ? "a number is too large" : "malformed JSON");
  }

 private:
  [[noreturn]] void refuse_at(std::size_t byte, const std::string& words) const {
    const std::string_view before = text_.substr(0, byte > 0 ? byte - 1 : 0);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    throw UserError(
        fmt::format("'{}', line {}, column {}: {}", file_, lines + 1, before.size() - line_begin + 1, words));
  }

  /// Puts a value where it belongs.
  Json* put(Json value) {
    if (++values_ > most_json_values)
      throw UserError(fmt::format("'{}': JSON has more than {} values", file_, most_json_values));
    if (open_.empty()) return &(root_ = std::move(value));
    if (!open_.back()->is_array()) return &(*member_ = std::move(value));
    open_.back()->push_back(std::move(value));
    return &open_.back()->back();
  }

  bool take(Json value) {
    if (!is_skipping_) put(std::move(value));
    is_skipping_ = is_skipping_ && depth_ > skipped_at_;
    return true;
  }

  bool begin(Json container) {
    if (++depth_ > most_json_depth)
      throw UserError(
          fmt::format("'{}': JSON is deeper than {} values in each other", file_, most_json_depth));
    if (!is_skipping_) open_.push_back(put(std::move(container)));
    return true;
  }

  bool end() {
    --depth_;
    if (!is_skipping_) open_.pop_back();
    is_skipping_ = is_skipping_ && depth_ > skipped_at_;
    return true;
  }

  std::string_view text_;
  const std::string& file_;
  bool (*is_kept_)(std::string_view);
  Json root_;
  std::vector<Json*>
      open_;  ///< what has begun and not ended; of each but the last nothing moves before that ends
  Json* member_ = nullptr;  ///< where the value of the last key goes
  int depth_ = 0, skipped_at_ = 0;
  bool is_skipping_ = false;  ///< within a member that is not kept, whose object lies `skipped_at_` deep
  std::size_t values_ = 0;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file, bool (*is_kept)(std::string_view key)) {
  JsonBuilder builder(text, file, is_kept);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.document();
}

}  // namespace shadefit::scene
