#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/exhaustive/float_errors.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "bench/exhaustive/sweep.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/files.hpp"
#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::bench {
namespace {

/// Tests the remaining floats of one sweep.
void go_on(Sweep& sweep, const FloatSubject& subject, unsigned threads, const std::function<void()>& between,
           std::uint32_t batch = usual_batch) {
  const RunningSweep running{&sweep, &subject};
  go_on_together(std::span(&running, 1), threads, between, batch);
}

using shadefit::testing::refusal;
using shadefit::testing::TemporaryDirectory;

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

TEST(FloatSteps, CountsFloatsBetweenKnownPairs) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(float_steps(1, 1), 0U);
  EXPECT_EQ(float_steps(1, std::nextafter(1.0F, 2.0F)), 1U);
  EXPECT_EQ(float_steps(std::nextafter(1.0F, 0.0F), std::nextafter(1.0F, 2.0F)), 2U)
      << "across a power of two";
  EXPECT_EQ(float_steps(0.0F, -0.0F), 0U);
  EXPECT_EQ(float_steps(tiny, -tiny), 2U) << "across zero";
  EXPECT_EQ(float_steps(0, tiny), 1U);
  EXPECT_EQ(
      float_steps(std::numeric_limits<float>::min(), std::nextafter(std::numeric_limits<float>::min(), 0.0F)),
      1U)
      << "the largest subnormal is beside the least normal";
  EXPECT_EQ(float_steps(1, 2), 1U << 23);
  EXPECT_EQ(float_steps(0, 1), 0x3f800000U);
  EXPECT_EQ(float_steps(-1, 1), 2 * 0x3f800000U);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(float_steps(-infinity, infinity), 2 * 0x7f800000U);
}

TEST(Exhaustive, TheWholeHasEveryFloatOfTheUnitInterval) {
  EXPECT_EQ(unit_floats.size(), 1'065'353'217U);
}

/// (1-c)^5 in float by multiplications, with a few inputs that go wrong.
FloatSubject schlick_with_faults() {
  return {[](const float* in, float* out, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
              const float y = 1 - in[i], y2 = y * y;
              out[i] = y2 * y2 * y;
              if (bits(in[i]) % 1000 == 7) out[i] = std::numeric_limits<float>::quiet_NaN();
              if (bits(in[i]) % 1000 == 8) out[i] = 1.5F;
              if (bits(in[i]) % 1000 == 9) out[i] = -out[i];
            }
          },
          [](const float* in, double* out, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(1 - static_cast<double>(in[i]), 5);
          }};
}

/// The same by a simple loop over the floats.
FloatErrors by_hand(const FloatSubject& subject, const Stretch& stretch) {
  FloatErrors found;
  double largest = -1;
  std::int64_t most = -1;
  for (std::uint32_t at = stretch.from; at < stretch.to; ++at) {
    std::array<float, 64> in{}, out{};
    std::array<double, 64> truth{};
    in.fill(std::bit_cast<float>(at));
    subject.form(in.data(), out.data(), in.size());
    subject.truth(in.data(), truth.data(), in.size());
    if (std::isnan(out[0])) {
      ++found.nans;
      continue;
    }
    if (out[0] > 1) ++found.above_one;
    if (out[0] < 0) ++found.below_zero;
    const double error = static_cast<float>(std::abs(out[0] - truth[0]));
    if (error > largest) {
      largest = error;
      found.max_abs_error = static_cast<float>(error);
      found.max_abs_error_at = at;
    }
    // Steps counted by nextafter, if they are few.
    const float wanted = static_cast<float>(truth[0]);
    std::int64_t steps = 0;
    for (float x = out[0]; x != wanted && steps < 1000; ++steps) x = std::nextafter(x, wanted);
    if (steps >= 1000) steps = float_steps(out[0], wanted);
    if (steps > most) {
      most = steps;
      found.max_ulps = static_cast<std::uint32_t>(steps);
      found.max_ulps_at = at;
    }
    std::size_t bin = 0;
    while (steps >> bin != 0) ++bin;
    ++found.ulps.at(bin);
  }
  return found;
}

TEST(Exhaustive, FindsWhatALoopByHandFinds) {
  const FloatSubject subject = schlick_with_faults();
  // Before and after a block's end, one float alone, none, the end of the whole.
  for (const Stretch& stretch : {Stretch{bits(0.5F) - 1500, bits(0.5F) + 1700},
                                 {bits(0.25F), bits(0.25F) + 1},
                                 {bits(0.25F), bits(0.25F)},
                                 {bits(0.25F), bits(0.25F) + 1024},
                                 {unit_floats.to - 3000, unit_floats.to},
                                 {0, 2100}}) {
    const FloatErrors wanted = by_hand(subject, stretch), found = errors_on(subject, stretch);
    EXPECT_EQ(found, wanted) << stretch.from;
    EXPECT_EQ(found.count(), stretch.size());
    for (const unsigned threads : {1U, 2U, 3U, 7U}) EXPECT_EQ(errors_on(subject, stretch, threads), wanted);
  }
}

TEST(Exhaustive, OfEqualMaximaTheSmallestInputIsKeptWhateverTheOrder) {
  FloatErrors low, high, both;
  low.max_ulps = high.max_ulps = 3;
  low.max_ulps_at = 10;
  high.max_ulps_at = 20;
  include(both, high);
  include(both, low);
  EXPECT_EQ(both.max_ulps_at, 10U);
  include(both, FloatErrors{});
  EXPECT_EQ(both.max_ulps_at, 10U);
}

TEST(Exhaustive, WhatAThreadThrowsIsThrown) {
  FloatSubject subject = schlick_with_faults();
  subject.truth = [](const float* in, double*, std::size_t) {
    if (bits(in[0]) > 5000) throw std::runtime_error("no truth");
  };
  EXPECT_THROW(errors_on(subject, Stretch{0, 10000}, 2), std::runtime_error);
}

TEST(Shard, ShardsAreTheWholeEachFloatOnce) {
  for (const Stretch& whole : {unit_floats, Stretch{5, 12}, Stretch{5, 5}}) {
    for (const unsigned of : {1U, 2U, 3U, 7U, 64U}) {
      std::uint32_t next = whole.from;
      for (unsigned index = 1; index <= of; ++index) {
        const Stretch part = stretch_of({index, of}, whole);
        EXPECT_EQ(part.from, next);
        EXPECT_LE(part.size(), whole.size() / of + 1);
        next = part.to;
      }
      EXPECT_EQ(next, whole.to);
    }
  }
}

SweepIdentity identity() {
  return {"0.1.0", "schlick", 3, "mine", {0.75F, -5.5F}, "sse2", {bits(0.5F), bits(0.5F) + 10'000}};
}

Sweep done(const Shard& shard = {}, const SweepIdentity& of = identity()) {
  Sweep sweep = begin_sweep(of, shard);
  go_on(sweep, schlick_with_faults(), 1, [] {});
  return sweep;
}

TEST(Sweep, IsTheSameInOneGoInShardsAndResumed) {
  const std::string whole = state_text(done());
  for (const unsigned of : {1U, 2U, 5U}) {
    std::vector<NamedSweep> shards;
    // In any order.
    for (unsigned index = of; index >= 1; --index) shards.push_back({"file", done({index, of})});
    EXPECT_EQ(state_text(merge(shards, "0.1.0")), whole) << of;
  }
  Sweep sweep = begin_sweep(identity(), {});
  int stops = 0;
  while (!sweep.is_done()) {
    try {
      go_on(
          sweep, schlick_with_faults(), 2, [] { throw 7; }, 1000);
    } catch (int) {
      ++stops;
    }
    // As read back from a file.
    sweep = parse_state(state_text(sweep), "file");
  }
  EXPECT_EQ(stops, 10);
  EXPECT_EQ(state_text(sweep), whole);
}

// With the truth computed once for both, and where one of them was stopped earlier than the other.
TEST(Sweep, SeveralTogetherAreTheSameAsEachAlone) {
  FloatSubject right = schlick_with_faults();
  right.form = [](const float* in, float* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(1 - in[i], 5.0F);
  };
  Sweep alone = begin_sweep(identity(), {});
  go_on(alone, right, 1, [] {});
  std::atomic<std::size_t> truths = 0;
  FloatSubject faulty = schlick_with_faults();
  faulty.truth = [&truths, truth = faulty.truth](const float* in, double* out, std::size_t count) {
    truths += count;
    truth(in, out, count);
  };
  Sweep one = begin_sweep(identity(), {}), other = one;
  EXPECT_THROW(go_on(
                   one, schlick_with_faults(), 1, [] { throw 7; }, 1500),
               int);
  share_truth(std::vector{&faulty, &right});
  go_on_together(
      std::vector<RunningSweep>{{&one, &faulty}, {&other, &right}}, 2, [] {}, 1000);
  EXPECT_EQ(state_text(one), state_text(done()));
  EXPECT_EQ(state_text(other), state_text(alone));
  EXPECT_LT(truths, 3 * identity().whole.size() / 2) << "not once for each";
}

TEST(Sweep, MergingRefusesWhatIsMissingDoubledForeignOrUnfinished) {
  const NamedSweep first{"one", done({1, 3})}, second{"two", done({2, 3})}, third{"three", done({3, 3})};
  const auto refused = [&](const std::vector<NamedSweep>& shards, const std::string& version = "0.1.0") {
    return refusal([&] { merge(shards, version); });
  };
  EXPECT_EQ(refused({first, second, third}), "");
  EXPECT_EQ(refused({first, third}), "shard 2/3 is missing");
  EXPECT_EQ(refused({first, second}), "shard 3/3 is missing");
  EXPECT_EQ(refused({first, second, {"again", first.sweep}, third}),
            "again is shard 1/3, which one is already");
  EXPECT_EQ(refused({first, {"half", done({2, 2})}}),
            "half is shard 2/2, one one of 3: all parts must come from the same command");
  EXPECT_EQ(refused({first, second, {"begun", begin_sweep(identity(), {3, 3})}}),
            "begun, shard 3/3, is not finished: its own command goes on with it");
  EXPECT_EQ(refused({first, second, third}, "0.2.0"), "one is of another version: 0.1.0, not 0.2.0");
}

TEST(Sweep, WhatIsOfAnotherFormOrVersionIsNamed) {
  const auto refused = [&](const std::function<void(SweepIdentity&)>& change) {
    SweepIdentity other = identity();
    change(other);
    return refusal([&] { merge({{"one", done({1, 2})}, {"two", done({2, 2}, other)}}, "0.1.0"); });
  };
  EXPECT_EQ(refused([](SweepIdentity&) {}), "");
  EXPECT_EQ(refused([](SweepIdentity& i) { i.version = "0.2.0"; }),
            "two is of another version: 0.2.0, not 0.1.0");
  EXPECT_EQ(refused([](SweepIdentity& i) { i.form = "sg"; }), "two is of another form: sg, not schlick");
  EXPECT_EQ(refused([](SweepIdentity& i) { i.exp2_degree = 4; }),
            "two is of another degree of exp2: 4, not 3");
  EXPECT_EQ(refused([](SweepIdentity& i) { i.constants[1] = 1; }),
            "two is of another set of constants: mine (0x1.8p-1, 0x1p+0), not mine (0x1.8p-1, -0x1.6p+2)");
  EXPECT_EQ(
      refused([](SweepIdentity& i) { i.set = "yours"; }),
      "two is of another set of constants: yours (0x1.8p-1, -0x1.6p+2), not mine (0x1.8p-1, -0x1.6p+2)");
  EXPECT_EQ(refused([](SweepIdentity& i) { i.width = "avx2"; }), "two is of another width: avx2, not sse2");
  EXPECT_EQ(refused([](SweepIdentity& i) {
              i.whole = {0, 16};
            }),
            "two is of another range: 0x00000000:0x00000010, not 0x3f000000:0x3f002710");
}

TEST(Sweep, ItsFileIsNamedAfterFormConstantsAndDegree) {
  SweepIdentity sweep = identity();
  EXPECT_EQ(file_of(sweep), "exhaustive-schlick-mine-exp2-3.json");
  sweep.set = "";
  sweep.exp2_degree = 0;
  EXPECT_EQ(file_of(sweep), "exhaustive-schlick.json");
}

TEST(StateFile, ReadsBackWhatItWrote) {
  const Sweep sweep = done({2, 3}), begun = begin_sweep(identity(), {});
  for (const Sweep& s : {sweep, begun}) {
    const Sweep read = parse_state(state_text(s), "file");
    EXPECT_EQ(read.identity, s.identity);
    EXPECT_EQ(read.shard, s.shard);
    EXPECT_EQ(read.next, s.next);
    EXPECT_EQ(read.found, s.found);
  }
}

// Every thousandth result leaves the bound; of all of them the first eight are kept, in one go or in parts.
TEST(StateFile, OfADeviceSaysWhatIsBeyondTheBound) {
  SweepIdentity on_device = identity();
  on_device.device = "a device, its driver";
  on_device.bound_from = {3.5, 0x1p-21};
  FloatSubject subject = schlick_with_faults();
  std::vector<Stretch> prepared;
  subject.prepare = [&](const Stretch& stretch) { prepared.push_back(stretch); };
  subject.bound = [](const float* in, double* middle, double* radius, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      middle[i] = std::pow(1 - static_cast<double>(in[i]), 5);
      radius[i] = bits(in[i]) % 1000 == 5 ? -1 : 2;
    }
  };
  Sweep sweep = begin_sweep(on_device, {});
  go_on(
      sweep, subject, 2, [] {}, 3000);
  EXPECT_GT(prepared.size(), 1U);
  EXPECT_EQ(prepared.front().from, sweep.stretch().from);
  std::vector<std::uint32_t> beyond;
  for (std::uint32_t at = sweep.stretch().from; at < sweep.stretch().to; ++at) {
    if (at % 1000 == 5 || at % 1000 == 7) beyond.push_back(at);  // beyond the bound, or no number
  }
  EXPECT_EQ(sweep.found.beyond, beyond.size());
  EXPECT_TRUE(std::equal(sweep.found.beyond_at.begin(), sweep.found.beyond_at.end(), beyond.begin()));
  const Sweep read = parse_state(state_text(sweep), "file");
  EXPECT_EQ(read.identity, sweep.identity);
  EXPECT_EQ(read.found, sweep.found);
  EXPECT_EQ(file_of(on_device), "exhaustive-schlick-mine-exp2-3-vulkan.json");
  EXPECT_EQ(refusal([&] {
              merge({{"one", done({1, 2})}, {"two", done({2, 2}, on_device)}}, "0.1.0");
            }),
            "two is of another device: a device, its driver, not none");
}

TEST(StateFile, EveryByteThatIsChangedOrCutOffIsSeen) {
  const std::string text = state_text(done());
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_TRUE(
        refusal([&] { parse_state(text.substr(0, i), "state file 'f'"); }).starts_with("state file 'f'") ||
        i + 1 == text.size())
        << "cut at " << i;
    if (std::isspace(static_cast<unsigned char>(text[i]))) continue;
    std::string changed = text;
    changed[i] = changed[i] == '1' ? '2' : '1';
    EXPECT_TRUE(refusal([&] { parse_state(changed, "state file 'f'"); }).starts_with("state file 'f'"))
        << "changed at " << i;
  }
}

TEST(StateFile, RefusalsNameWhatIsWrong) {
  const std::string text = state_text(done());
  const auto refused = [](const std::string& content) {
    return refusal([&] { parse_state(content, "state file 'f'"); });
  };
  EXPECT_EQ(refused(""), "state file 'f', line 1, column 1: the JSON ends early");
  EXPECT_NE(refused(text.substr(0, 300)).find(": the JSON ends early"), std::string::npos);
  EXPECT_EQ(refused("hello"), "state file 'f', line 1, column 1: malformed JSON");
  EXPECT_EQ(refused("[1]"), "state file 'f': the field 'file' is missing");
  // With a new digest, the rules of the fields still refuse it.
  const auto changed = [&](const char* key, const nlohmann::ordered_json& value) {
    auto json = nlohmann::ordered_json::parse(text);
    json[key] = value;
    json[digest_field] = digest_of(json);
    return refused(json.dump());
  };
  EXPECT_EQ(changed("schema", 3), "state file 'f' is of version 3: this shadefit reads version 2");
  EXPECT_EQ(changed("nans", 11),
            "state file 'f': the field 'ulps' has counts that do not add up to the tested floats");
  EXPECT_EQ(changed("shard", {4, 3}), "state file 'f': the field 'shard' is not i, n with 1 <= i <= n");
  EXPECT_EQ(changed("shard", {2, 3}), "state file 'f': the field 'done' is not of its shard");
  EXPECT_EQ(changed("ulps", {1}), "state file 'f': the field 'ulps' has another number of bins");
  EXPECT_EQ(
      changed("constants", {"1"}),
      "state file 'f': the field 'constants' holds '1', which is not a hexadecimal double as shadefit prints it");
  EXPECT_EQ(changed("whole", {"0x10", "0x20"}),
            "state file 'f': the field 'whole' is not the bit pattern of a float");
  EXPECT_EQ(changed("version", nullptr), "state file 'f': the field 'version' is not a text");
  // Texts that would be rounded, cut off, or overlooked.
  const auto not_so = [](const char* key) {
    return fmt::format("state file 'f': the field '{}' is unknown, or not as shadefit writes it", key);
  };
  EXPECT_EQ(changed("constants", {"0x1.00000000001p+0"}), not_so("constants"));
  EXPECT_EQ(changed("exp2_degree", (std::uint64_t{1} << 32)),
            "state file 'f': the field 'exp2_degree' is not a whole number from 0 to 2147483647");
  EXPECT_EQ(changed("max_ulps", (std::uint64_t{1} << 32)),
            "state file 'f': the field 'max_ulps' is not a whole number from 0 to 4294967295");
  EXPECT_EQ(changed("x", 1), not_so("x"));
  auto json = nlohmann::ordered_json::parse(text);
  auto place = json.at("max_abs_error_at");
  place["c"] = "0x1p-1";
  EXPECT_EQ(changed("max_abs_error_at", place), not_so("max_abs_error_at"));
  auto counts = json.at("ulps");
  counts[0] = counts[0].get<std::uint64_t>() + (std::uint64_t{1} << 63);
  counts[1] = counts[1].get<std::uint64_t>() + (std::uint64_t{1} << 63);
  EXPECT_EQ(changed("ulps", counts),
            "state file 'f': the field 'ulps' has counts that do not add up to the tested floats")
      << "their sum wraps to the right one";
  EXPECT_NE(refused(text + std::string("\0", 1)).find(": a byte 0"), std::string::npos);
  EXPECT_EQ(refused("{\"x\":" + std::string(70000, '[') + std::string(70000, ']') + "," + text.substr(1)),
            "state file 'f': JSON is deeper than 64 values in each other");
  json["nans"] = 11;
  EXPECT_TRUE(refused(json.dump()).starts_with("state file 'f': the field 'digest' is "));
}

TEST(StateFile, StaysAsItWasWhereANewOneCannotBeWritten) {
  const TemporaryDirectory directory;
  const std::string path = directory / "state.json";
  keep_state(path, done({1, 2}));
  EXPECT_EQ(read_state(path).sweep.shard, (Shard{1, 2}));
  keep_state(path, done({2, 2}));
  EXPECT_EQ(read_state(path).sweep.shard, (Shard{2, 2}));
  EXPECT_THROW(keep_state(path + "/below", done()), UserError);
  EXPECT_EQ(read_state(path).sweep.shard, (Shard{2, 2}));
  EXPECT_THROW(read_state(directory / "none"), UserError);
  std::filesystem::resize_file(path, std::uintmax_t{1} << 30);
  EXPECT_EQ(refusal([&] { read_state(path); }),
            "cannot read '" + path + "': it has 1073741824 bytes, more than 65536");
}

}  // namespace
}  // namespace shadefit::bench
