#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/app/refusal.hpp"
#include "tests/process.hpp"
#include "tests/scene/samples.hpp"
#include "tests/temporary_directory.hpp"

/// Hostile scenes: the command refuses or reads them with little memory and time.
namespace shadefit {
namespace {

using testing::expect_has;
using testing::run_process;
using testing::TemporaryDirectory;

/// A process with its libraries takes 60 MiB of addresses; a sanitizer reserves terabytes.
void limit_memory() {
#if defined(__SANITIZE_ADDRESS__)
  constexpr bool is_sanitized = true;
#elif defined(__has_feature)
  constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
  constexpr bool is_sanitized = false;
#endif
  if (is_sanitized) return;
  const rlimit limit{400 << 20, 400 << 20};
  ::setrlimit(RLIMIT_AS, &limit);
}

/// Seconds of processor time, after which the system ends the process: each takes a tenth of a second, under
/// a sanitizer a few.
void limit_all() {
  limit_memory();
  constexpr rlimit time{20, 20};
  ::setrlimit(RLIMIT_CPU, &time);
}

/// The message for a refused file.
std::string refusal_of(const std::string& file) {
  const auto finished = run_process({"scene", file}, limit_all);
  EXPECT_EQ(finished.exit_code, 2) << file;
  EXPECT_EQ(finished.out, "") << file;
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  return finished.err;
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(HostileScene, DepthAndNumber) {
  const TemporaryDirectory directory;
  const std::string head = R"({"asset":{"version":"2.0"},"materials":)";
  const std::string deep = directory.file("deep.gltf", std::string(8 << 20, '['));
  EXPECT_EQ(refusal_of(deep), "shadefit: '" + deep + "': JSON is deeper than 64 values in each other\n");
  const std::string many = directory.file("many.gltf", head + "[{}" + repeated(",{}", 70000) + "]}");
  EXPECT_EQ(refusal_of(many), "shadefit: '" + many + "': /materials: there are 70001, more than 65536\n");
  const std::string more = directory.file("more.mtl", repeated("newmtl a\n", 70000));
  expect_has(refusal_of(more), "65536");
  const std::string wide = directory.file("wide.gltf", head + "[0" + repeated(",0", 16 << 20) + "]}");
  expect_has(refusal_of(wide), "wide.gltf");
}

// A chunk that claims two missing gigabytes; lengths beyond the end.
TEST(HostileScene, ChunksPastTheEnd) {
  const TemporaryDirectory directory;
  const std::string chunk = testing::word(0x7fffffff) + "JSON";
  const std::string file = directory.file("a.glb", testing::glb_of(chunk));
  expect_has(refusal_of(file), "byte 12");
  directory.file("a.glb", "glTF" + testing::word(2) + testing::word(0xffffffff) + chunk);
  expect_has(refusal_of(file), "byte 8");
}

// The header of a picture of ten thousand million pixels, and nothing else, is refused by its size. One of 16
// million is read row by row.
TEST(HostileScene, Pictures) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.gltf", testing::gltf_of_image(R"("uri":"a.png")"));
  directory.file("a.png", testing::png_header(100000, 100000));
  expect_has(refusal_of(file), "100000 x 100000");
  constexpr std::uint32_t side = 4096;
  directory.file("a.png", testing::png_of({side, side, PNG_COLOR_TYPE_GRAY,
                                           std::vector<std::uint8_t>(std::size_t{side} * side, 128)}));
  EXPECT_EQ(run_process({"scene", file}, limit_all).exit_code, 0);
}

// Texts of 30 MB, where the command itself takes the file's size a few times.
TEST(HostileScene, LongTexts) {
  const TemporaryDirectory directory;
  const std::string is_long(30 << 20, 'x');
  const auto of_factor = [](const std::string& value) {
    return testing::gltf_of_material(R"("pbrMetallicRoughness":{"roughnessFactor":)" + value + "}");
  };
  const auto file_of = [&](const std::string& content) { return directory.file("a.gltf", content); };
  EXPECT_LT(refusal_of(file_of(of_factor("\"" + is_long + "\""))).size(), 1000U);
  EXPECT_LT(refusal_of(file_of(testing::gltf_of_image(R"("uri":")" + is_long + "\""))).size(), 1000U);
  const auto accepted = [&](const std::string& file) {
    const auto finished = run_process({"scene", file}, limit_all);
    EXPECT_EQ(finished.exit_code, 0) << finished.err.substr(0, 1000);
    EXPECT_LT(finished.out.size(), 10000U);
  };
  accepted(file_of(testing::gltf_of_image(R"("uri":"http://)" + is_long + "\"")));
  accepted(file_of(testing::gltf_of_material(R"("name":")" + is_long + "\"")));
  EXPECT_LT(refusal_of(directory.file("a.mtl", "newmtl a\nNs " + is_long + "\n")).size(), 1000U);
  EXPECT_LT(refusal_of(directory.file("b.mtl", "newmtl a\nKs 1 1 1\nmap_Ns " + is_long + "\n")).size(),
            1000U);
}

// Each with its own texture and powers; common data of materials are stored once.
TEST(HostileScene, ManyTexturedMaterials) {
  const TemporaryDirectory directory;
  std::string materials;
  constexpr int count = 30000;
  for (int i = 0; i < count; ++i) {
    materials += std::string(i == 0 ? "" : ",") + R"({"pbrMetallicRoughness":{"roughnessFactor":)" +
                 std::to_string(0.2 + 0.5 * i / count) + R"(,"metallicRoughnessTexture":{"index":0}}})";
  }
  const std::string file =
      directory.file("a.gltf", testing::gltf_of(R"("textures":[{}],"materials":[)" + materials + "]"));
  EXPECT_EQ(run_process({"scene", file}, limit_all).exit_code, 0);
}

}  // namespace
}  // namespace shadefit
