// File::example_space: what shapes.toml says of face.gltf is there, and what is refused of it.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "asset/sections/examples_section.h"
#include "marrow/sample.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

class LoadExamples : public ::testing::Test {
 protected:
  LoadExamples() : block_(test::golden_shapes_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kExamples]) base_ = s.offset;
    EXPECT_EQ(file_.example_space(0, space_), Status::ok);
    layout_ = layout(*reinterpret_cast<const format::ExampleHeader*>(block_.data() + base_));
  }
  // load() takes the file, and example_space() refuses it: at the changed field, or at the section's head.
  template <class T>
  void refuse(std::uint64_t offset, T value, const char* rule) {
    const std::size_t at = base_ + static_cast<std::size_t>(offset);
    test::AlignedBlock changed(block_.data(), block_.size());
    std::memcpy(changed.data() + at, &value, sizeof value);
    test::forge_checksum(changed.data(), changed.size());
    File file;
    ASSERT_EQ(load(changed, file), Status::ok);
    DataError error;
    ExampleSpace out;
    EXPECT_EQ(file.example_space(0, out, &error), error.status) << rule;
    EXPECT_NE(std::string(error.rule).find(rule), std::string::npos) << offset << ": " << error.rule;
    EXPECT_TRUE(error.offset == base_ || (error.offset <= at && at < error.offset + 8)) << rule << error.offset;
    EXPECT_EQ(out.example_count, 0u) << "nothing is written";
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  ExampleSpace space_;
  format::ExampleLayout layout_{};
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadExamples, AreWhatTheSettingsSay) {
  ASSERT_EQ(file_.example_space_count(), 1u);
  EXPECT_STREQ(space_.name, "moods");
  ASSERT_EQ(space_.parameters.size, 2u);
  EXPECT_STREQ(file_.text(space_.parameters[0].name), "mood");
  EXPECT_EQ(space_.parameters[0].rest, 0);
  EXPECT_STREQ(file_.text(space_.parameters[1].name), "head.glow");
  EXPECT_EQ(space_.parameters[1].rest, 0.5f);
  EXPECT_EQ(space_.example_count, 4u);
  ASSERT_EQ(space_.targets.size, 2u);  // smile, blink
  EXPECT_EQ(space_.targets[1], 1u);
  ASSERT_EQ(space_.meshes.size, 1u) << "the mask's targets have other names";
  EXPECT_STREQ(file_.mesh(space_.meshes[0]).name, "face");
  EXPECT_EQ(space_.linear.size, 3u * 4);
  EXPECT_EQ(space_.radial.size, 4u * 4);
  const float places[] = {0, 0, 1, 0, 0, 1, 2, 2};
  ASSERT_EQ(space_.places.size, 8u);
  EXPECT_EQ(std::memcmp(space_.places.data, places, sizeof places), 0);
  ASSERT_EQ(space_.inverse_widths.size, 4u);
  EXPECT_EQ(space_.inverse_widths[0], 1.0f);
  EXPECT_NEAR(space_.inverse_widths[3], 1 / std::sqrt(5.0), 1e-7);  // (2, 2) to (1, 0)
}

TEST_F(LoadExamples, WeighTargetsAtTheExamples) {
  const float wanted[4][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    float weights[3] = {9, 9, 9};
    ASSERT_EQ(evaluate_examples(space_, {space_.places.data + 2 * k, 2}, weights), Status::ok);
    for (std::size_t t = 0; t < 2; ++t) EXPECT_NEAR(weights[t], wanted[k][t], 1e-6) << k;
    EXPECT_EQ(weights[2], 9) << "no target of the space";
  }
}

TEST_F(LoadExamples, FindTheClipsChannels) {
  const Clip clip = file_.clip(0);
  std::uint32_t channels[2] = {};
  ASSERT_EQ(find_example_channels(file_, space_, file_, clip, channels), Status::ok);
  ASSERT_LT(channels[0], clip.channels.size);
  EXPECT_STREQ(file_.text(clip.channels[channels[0]].name), "mood");
  EXPECT_STREQ(file_.text(clip.channels[channels[1]].name), "head.glow");
  ASSERT_EQ(find_example_channels(file_, space_, file_, Clip{}, channels), Status::ok);
  EXPECT_EQ(channels[0], kNoChannel);
  EXPECT_EQ(find_example_channels(file_, space_, file_, clip, {channels, 1}), Status::bad_argument);
}

TEST_F(LoadExamples, RefuseAWrongOne) {
  const float infinite = INFINITY, none = NAN;
  const auto word = [](std::uint32_t w) { return w; };
  refuse(0, word(1u << 30), "name outside the name section");
  refuse(4, word(0), "section size differs");
  refuse(8, std::uint16_t{0}, "section size differs");
  refuse(8, std::uint16_t{9}, "section size differs");
  refuse(10, std::uint16_t{65535}, "section size differs");
  refuse(12, std::uint16_t{0}, "section size differs");
  refuse(14, std::uint16_t{1}, "reserved must be 0");
  refuse(layout_.linear, none, "not finite");
  refuse(layout_.linear + 8, 1.0f, "padding must be 0");
  refuse(layout_.radial + 4, infinite, "not finite");
  refuse(layout_.radial + 12, -1.0f, "padding must be 0");
  refuse(layout_.places, none, "not finite");
  refuse(layout_.widths, infinite, "not finite");
  refuse(layout_.widths + 4, 0.0f, "a width that is not above 0");
  refuse(layout_.widths + 4, -1.0f, "a width that is not above 0");
  refuse(layout_.parameters, word(~0u), "name outside the name section");
  refuse(layout_.parameters + 4, none, "not finite");
  refuse(layout_.targets, word(1), "targets of each mesh, ascending");
  refuse(layout_.targets + 4, word(2), "targets of each mesh, ascending");
  refuse(layout_.meshes, word(2), "meshes of the file, ascending");
  EXPECT_EQ(refused_, 20);
}

// Counts that agree with the size and are out of range: a section made by hand, behind the names of a good file.
TEST_F(LoadExamples, RefuseCountsOutOfRange) {
  const struct {
    format::ExampleHeader header;
    const char* rule;
  } cases[] = {{{0, 1, 0, 1, 1, 0}, "1 to 8 parameters"}, {{0, 1, 9, 1, 1, 0}, "1 to 8 parameters"},
               {{0, 1, 1, 0, 1, 0}, "1 to 64 examples"},  {{0, 1, 1, 65, 1, 0}, "1 to 64 examples"},
               {{0, 1, 1, 1, 0, 0}, "1 to 64 targets"},   {{0, 1, 1, 1, 65, 0}, "1 to 64 targets"},
               {{0, 0, 1, 1, 1, 0}, "a space of no mesh"}};
  for (const auto& c : cases) {
    const std::size_t size = static_cast<std::size_t>(layout(c.header).bytes), names = 1;
    const std::size_t first = 64, second = static_cast<std::size_t>(format::align16(first + size));
    test::AlignedBlock block(second + names);
    const format::Header h{format::kMagic, format::kVersion, static_cast<std::uint32_t>(block.size()), 2, 0, 0};
    const File::Section sections[2] = {{format::kTypes[format::kExamples], 64, static_cast<std::uint32_t>(size), 0},
                                       {format::kTypes[format::kNames], static_cast<std::uint32_t>(second), 1, 0}};
    std::memset(block.data(), 0, block.size());
    std::memcpy(block.data(), &h, sizeof h);
    std::memcpy(block.data() + sizeof h, sections, sizeof sections);
    std::memcpy(block.data() + first, &c.header, sizeof c.header);
    test::forge_checksum(block.data(), block.size());
    File file;
    DataError error;
    ASSERT_EQ(load(block, file, &error), Status::ok) << error.rule;
    ExampleSpace out;
    EXPECT_EQ(file.example_space(0, out, &error), Status::bad_data);
    EXPECT_STREQ(error.rule, c.rule);
  }
}

TEST_F(LoadExamples, ThereIsNone) {
  DataError error;
  EXPECT_EQ(file_.example_space(1, space_, &error), Status::bad_argument);
  EXPECT_STREQ(error.rule, "an index below example_space_count()");
  EXPECT_EQ(File().example_space_count(), 0u);
  EXPECT_EQ(File().example_space(0, space_), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
