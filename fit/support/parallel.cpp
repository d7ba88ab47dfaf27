#include "fit/support/parallel.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace shadefit {
namespace {

/// Ends a piece of work of which nobody needs the result. Only `SharedWork` throws and catches it.
struct Unneeded {};

/// Hands out the places, and keeps the exception of the first that failed.
class SharedWork {
 public:
  SharedWork(std::size_t count, const PieceOfWork& work, const InParallel& how)
      : work_(work), how_(how), end_(count) {}

  /// What each thread does: takes places until there is none.
  void take_part() {
    while (const auto place = take()) {
      try {
        work_(*place, [this, at = *place] { check(at); });
      } catch (const Unneeded&) {
      } catch (...) {
        const std::scoped_lock lock(mutex_);
        fail(*place);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::optional<std::size_t> take() {
    const std::scoped_lock lock(mutex_);
    if (next_ >= end_) return std::nullopt;
    call(how_.before_each);
    return next_ < end_ ? std::optional(next_++) : std::nullopt;
  }

  void check(std::size_t place) {
    const std::scoped_lock lock(mutex_);
    if (place < end_) call(how_.checkpoint);
    if (place >= end_) throw Unneeded{};
  }

  /// An exception of the checkpoint ends all places. Needs the lock.
  void call(const Checkpoint& checkpoint) {
    try {
      checkpoint();
    } catch (...) {
      fail(0);
    }
  }

  /// Keeps the current exception, unless an earlier place has failed. Needs the lock.
  void fail(std::size_t place) {
    if (place >= end_) return;
    end_ = place;
    error_ = std::current_exception();
  }

  const PieceOfWork& work_;
  const InParallel& how_;
  std::mutex mutex_;
  std::size_t next_ = 0, end_;  ///< the places from next_ to end_ - 1 wait
  std::exception_ptr error_;
};

}  // namespace

unsigned cores() {
  static const unsigned count = std::max(1U, std::thread::hardware_concurrency());  // reads a file: 5 us
  return count;
}

void for_each_in_parallel(std::size_t count, const PieceOfWork& work, const InParallel& how) {
  SharedWork shared(count, work, how);
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = 1; i < std::min<std::size_t>(how.threads, count); ++i)
        others.emplace_back([&shared] { shared.take_part(); });
    } catch (const std::system_error&) {  // the machine has no more threads: those that run do the work
    }
    shared.take_part();
  }
  shared.rethrow();
}

}  // namespace shadefit
