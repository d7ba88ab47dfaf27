#pragma once

#include <filesystem>

namespace shadefit::testing {

/// Stands in a folder while it lives.
class StandIn {
 public:
  explicit StandIn(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~StandIn() { std::filesystem::current_path(before_); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

 private:
  std::filesystem::path before_;
};

}  // namespace shadefit::testing
