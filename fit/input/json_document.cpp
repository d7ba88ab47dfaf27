#include "fit/input/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Builds a document from the events of the library's parser. The library's own builder has no limits without
/// a callback, and with one it takes quadratic time on arrays.
template <class Json>
class JsonBuilder {
 public:
  /// Every message begins with `file`.
  JsonBuilder(std::string_view text, std::string file, bool (*is_kept)(std::string_view),
              std::size_t most_members)
      : text_(text), file_(std::move(file)), is_kept_(is_kept), most_members_(most_members) {}

  Json document() {
    // For the library a byte 0 is the end of the text.
    if (const auto zero = text_.find('\0'); zero != std::string_view::npos) refuse_at(zero + 1, "a byte 0");
    Json::sax_parse(text_.begin(), text_.end(), this);
    return std::move(root_);
  }

  // The events of the parser. Each returns whether to go on.

  bool null() { return take(nullptr); }
  bool boolean(bool value) { return take(value); }
  bool number_integer(typename Json::number_integer_t value) { return take(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) { return take(value); }
  bool number_float(typename Json::number_float_t value, const std::string&) { return take(value); }
  bool string(std::string& value) { return take(std::move(value)); }
  bool binary(typename Json::binary_t&) { return false; }  // never in a text
  bool start_object(std::size_t) { return begin(Json::object()); }
  bool end_object() { return end(); }
  bool start_array(std::size_t) { return begin(Json::array()); }
  bool end_array() { return end(); }

  bool key(std::string& name) {
    if (is_skipping_) return true;
    is_skipping_ = !is_kept_(name);
    skipped_at_ = depth_;
    if (is_skipping_) return true;
    auto& object = open_.back()->template get_ref<typename Json::object_t&>();
    const auto [member, is_new] = object.emplace(name, nullptr);
    if (!is_new) throw UserError(fmt::format("{}: JSON has two members '{}' in one object", file_, name));
    if (object.size() > most_members_)
      throw UserError(fmt::format("{}: JSON has more than {} members in one object", file_, most_members_));
    member_ = &member->second;
    return true;
  }

  /// Called with the number of bytes that were read.
  [[noreturn]] bool parse_error(std::size_t byte, const std::string&,
                                const nlohmann::detail::exception& error) {
    constexpr int number_overflow = 406;
    refuse_at(byte, error.id == number_overflow ? "a number is too large"
                    : byte > text_.size()       ? "the JSON ends early"
                                                : "malformed JSON");
  }

 private:
  [[noreturn]] void refuse_at(std::size_t byte, const std::string& words) const {
    const std::string_view before = text_.substr(0, byte > 0 ? byte - 1 : 0);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    throw UserError(
        fmt::format("{}, line {}, column {}: {}", file_, lines + 1, before.size() - line_begin + 1, words));
  }

  /// Puts a value into its place.
  Json* put(Json value) {
    if (++values_ > most_json_values)
      throw UserError(fmt::format("{}: JSON has more than {} values", file_, most_json_values));
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
      throw UserError(fmt::format("{}: JSON is deeper than {} values in each other", file_, most_json_depth));
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
  std::string file_;
  bool (*is_kept_)(std::string_view);
  std::size_t most_members_;
  Json root_;
  std::vector<Json*> open_;  ///< arrays and objects that have not ended yet; only the last one changes
  Json* member_ = nullptr;   ///< the place for the value of the last key
  int depth_ = 0, skipped_at_ = 0;
  bool is_skipping_ = false;  ///< inside a member that is not kept; its object is at depth `skipped_at_`
  std::size_t values_ = 0;
};

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& file,
                          bool (*is_kept)(std::string_view key)) {
  return JsonBuilder<nlohmann::json>(text, fmt::format("'{}'", file), is_kept,
                                     std::numeric_limits<std::size_t>::max())
      .document();
}

nlohmann::ordered_json parse_own_json(std::string_view text, const std::string& file) {
  const auto all = [](std::string_view) { return true; };
  return JsonBuilder<nlohmann::ordered_json>(text, file, all, most_own_members).document();
}

}  // namespace shadefit
