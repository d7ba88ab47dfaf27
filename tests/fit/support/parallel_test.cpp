#include "fit/support/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace shadefit {
namespace {

/// The text of the exception.
std::string failure_of(std::size_t count, const PieceOfWork& work, const InParallel& how) {
  try {
    for_each_in_parallel(count, work, how);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

[[noreturn]] void fail_at(std::size_t place) {
  throw std::runtime_error("place " + std::to_string(place));
}

/// A piece of work without an end of its own.
[[noreturn]] void never_end(const Checkpoint& checkpoint) {
  for (;;) checkpoint();
}

TEST(Parallel, DoesEachPlaceOnceOnAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 3U, 40U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::size_t> times(count), expected(count, 1);
      std::size_t before = 0, checked = 0;  // plain numbers: one thread at a time counts
      for_each_in_parallel(
          count,
          [&](std::size_t place, const Checkpoint& checkpoint) {
            ++times[place];
            checkpoint();
          },
          {.before_each = [&] { ++before; }, .checkpoint = [&] { ++checked; }, .threads = threads});
      EXPECT_EQ(times, expected) << threads << " threads";
      EXPECT_EQ(before, count);
      EXPECT_EQ(checked, count);
    }
  }
}

TEST(Parallel, OneThreadIsALoop) {
  for (const unsigned threads : {0U, 1U}) {
    std::vector<std::size_t> places;
    for_each_in_parallel(3,
                         [&, caller = std::this_thread::get_id()](std::size_t place, const Checkpoint&) {
                           EXPECT_EQ(std::this_thread::get_id(), caller);
                           places.push_back(place);
                         },
                         {.threads = threads});
    EXPECT_EQ(places, (std::vector<std::size_t>{0, 1, 2}));
  }
}

TEST(Parallel, TwoThreadsWorkAtTheSameTime) {
  std::latch both{2};
  for_each_in_parallel(2, [&](std::size_t, const Checkpoint&) { both.arrive_and_wait(); }, {.threads = 2});
}

TEST(Parallel, ThrowsTheExceptionOfTheFirstPlaceEvenIfItFailsLast) {
  std::latch all_others{3};
  const auto work = [&](std::size_t place, const Checkpoint& checkpoint) {
    if (place == 0) {
      all_others.wait();
      for (int i = 0; i < 1000; ++i) checkpoint();  // they have failed, but do not end it
    } else {
      all_others.arrive_and_wait();
    }
    fail_at(place);
  };
  EXPECT_EQ(failure_of(4, work, {.threads = 4}), "place 0");
}

TEST(Parallel, AFailureEndsThePlacesBehindIt) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    std::atomic<std::size_t> begun = 0;
    const auto work = [&](std::size_t place, const Checkpoint& checkpoint) {
      ++begun;
      if (place == 0) fail_at(place);
      never_end(checkpoint);
    };
    EXPECT_EQ(failure_of(1000, work, {.threads = threads}), "place 0");
    EXPECT_LE(begun, threads);
  }
}

/// As the interruptions of the command line, no std::exception.
struct Stop {
  int signal;
};

TEST(Parallel, AnExceptionOfTheCheckpointEndsAll) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    int calls = 0;
    const auto stop = [&] {
      if (++calls == 100) throw Stop{2};  // only once, as a signal is taken by one thread
    };
    const auto work = [](std::size_t, const Checkpoint& checkpoint) { never_end(checkpoint); };
    try {
      for_each_in_parallel(1000, work, {.checkpoint = stop, .threads = threads});
      FAIL();
    } catch (const Stop& stopped) {
      EXPECT_EQ(stopped.signal, 2);
    }
    EXPECT_EQ(calls, 100);
  }
}

TEST(Parallel, AnExceptionBeforeAPlaceEndsAll) {
  int calls = 0;
  std::atomic<std::size_t> begun = 0;
  const auto stop = [&] {
    if (++calls == 3) throw Stop{2};
  };
  const auto work = [&](std::size_t, const Checkpoint& checkpoint) {
    if (++begun == 2) never_end(checkpoint);
  };
  EXPECT_THROW(for_each_in_parallel(1000, work, {.before_each = stop, .threads = 2}), Stop);
  EXPECT_EQ(begun, 2U);
}

}  // namespace
}  // namespace shadefit
