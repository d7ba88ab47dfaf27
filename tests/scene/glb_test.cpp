#include "scene/gltf/glb.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::chunk;
using shadefit::testing::glb_of;
using shadefit::testing::refusal;
using shadefit::testing::word;
using namespace std::string_literals;

std::string refusal_of_glb(const std::string& file) {
  return refusal([&] { parse_glb(bytes_of(file)); });
}

TEST(Glb, HasItsChunks) {
  const std::string file = glb_of(chunk("JSON", "{}  ") + chunk("what", "skip") + chunk("BIN\0"s, "1234"));
  const Glb glb = parse_glb(bytes_of(file));
  EXPECT_EQ(glb.json, "{}  ");
  ASSERT_TRUE(glb.binary.has_value());
  EXPECT_EQ(text_of(*glb.binary), "1234");
}

TEST(Glb, NeedsNoBinaryChunkAndEndsWhereItSays) {
  const std::string file = glb_of(chunk("JSON", "{}  "));
  EXPECT_FALSE(parse_glb(bytes_of(file)).binary.has_value());
  const std::string longer = file + "left over";
  EXPECT_EQ(parse_glb(bytes_of(longer)).json, "{}  ");
}

TEST(Glb, RefusesWhatIsNone) {
  const std::string json = chunk("JSON", "{}  ");
  EXPECT_EQ(refusal_of_glb(""), "byte 0: a GLB file begins with 12 bytes, and has 0");
  EXPECT_EQ(refusal_of_glb("glTF1234567"), "byte 0: a GLB file begins with 12 bytes, and has 11");
  EXPECT_EQ(refusal_of_glb("GLTF" + word(2) + word(12)), "byte 0: a GLB file begins with 'glTF'");
  EXPECT_EQ(refusal_of_glb("glTF" + word(1) + word(12)), "byte 4: version 1 of GLB is not 2");
  EXPECT_EQ(refusal_of_glb("glTF" + word(2) + word(13)),
            "byte 8: the length 13 is not within the file's 12 bytes");
  EXPECT_EQ(refusal_of_glb("glTF" + word(2) + word(11)),
            "byte 8: the length 11 is not within the file's 12 bytes");
  EXPECT_EQ(refusal_of_glb(glb_of("")), "byte 12: there is no JSON chunk");
  EXPECT_EQ(refusal_of_glb(glb_of(json + "1234567")), "byte 24: the file ends within a chunk's header");
  EXPECT_EQ(refusal_of_glb(glb_of(word(5) + "JSON{}  ")),
            "byte 12: a chunk of 5 bytes goes past the end, 4 bytes on");
  EXPECT_EQ(refusal_of_glb(glb_of(word(std::numeric_limits<std::uint32_t>::max()) + "JSON{}  ")),
            "byte 12: a chunk of 4294967295 bytes goes past the end, 4 bytes on");
  EXPECT_EQ(refusal_of_glb(glb_of(chunk("BIN\0"s, "1234"))),
            "byte 12: the first chunk, and no other, has to be JSON");
  EXPECT_EQ(refusal_of_glb(glb_of(json + json)), "byte 24: the first chunk, and no other, has to be JSON");
}

}  // namespace
}  // namespace shadefit::scene
