// File::graph: what graph.toml says is there, and what is refused of it.
#include <cstring>

#include <gtest/gtest.h>

#include "graph/graph_section.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

class LoadGraphs : public ::testing::Test {
 protected:
  LoadGraphs() : block_(test::golden_graph_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kGraphs]) base_ = s.offset;
    EXPECT_EQ(file_.graph(0, graph_), Status::ok);
    layout_ = layout(*reinterpret_cast<const format::GraphHeader*>(block_.data() + base_));
  }
  // load() takes the file, and graph() refuses it: near the changed field, or at the section's head.
  template <class T>
  void refuse(std::uint64_t offset, T value, const char* rule) {
    const std::size_t at = base_ + static_cast<std::size_t>(offset);
    test::AlignedBlock changed(block_.data(), block_.size());
    std::memcpy(changed.data() + at, &value, sizeof value);
    test::forge_checksum(changed.data(), changed.size());
    File file;
    ASSERT_EQ(load(changed, file), Status::ok);
    DataError error;
    Graph out;
    EXPECT_EQ(file.graph(0, out, &error), Status::bad_data) << rule;
    EXPECT_NE(std::string(error.rule).find(rule), std::string::npos) << offset << ": " << error.rule;
    EXPECT_TRUE(error.offset == base_ || (error.offset <= at && at < error.offset + 44)) << rule << error.offset;
    EXPECT_EQ(out.nodes.size, 0u) << "nothing is written";
  }

  test::AlignedBlock block_;
  File file_;
  Graph graph_;
  format::GraphLayout layout_{};
  std::size_t base_ = 0;
};

TEST_F(LoadGraphs, AreWhatTheTextSays) {
  ASSERT_EQ(file_.graph_count(), 1u);
  EXPECT_STREQ(graph_.name, "graph");
  ASSERT_EQ(graph_.parameters.size, 4u);
  EXPECT_STREQ(file_.text(graph_.parameters[0].name), "speed");
  EXPECT_EQ(graph_.parameters[0].most, 2.0f);
  EXPECT_EQ(graph_.parameters[0].seconds, 0.1f);
  EXPECT_EQ(graph_.parameters[3].kind, ParameterKind::trigger);
  EXPECT_EQ(graph_.nodes[0].kind, GraphNodeKind::layer);
  EXPECT_EQ(graph_.layers.size, 3u);
  EXPECT_EQ(graph_.masks.size, 2u);  // that of the one_shot is another
  EXPECT_EQ(graph_.mask_parts.size, 3u);
  EXPECT_EQ(graph_.spaces.size, 2u);
  EXPECT_EQ(graph_.triangles.size, 2u);  // of a square
  EXPECT_EQ(graph_.machines.size, 3u);
  EXPECT_EQ(graph_.given_count, 1u);
  EXPECT_EQ(graph_.conditions.size, 5u);
}

TEST_F(LoadGraphs, OthersAreRefused) {
  refuse(layout_.parameters + 4, std::uint32_t{3}, "a kind of parameter");
  refuse(layout_.parameters + 8, 3.0f, "within its range");
  refuse(layout_.parameters + 20, -1.0f, "a time up to 1e6");
  refuse(layout_.nodes + 4, std::uint32_t{5}, "a kind of node");
  refuse(layout_.nodes + 8, std::uint32_t{1}, "records in their nodes' order");
  refuse(layout_.nodes + 12, std::uint16_t{16}, "lower than 16");
  refuse(layout_.nodes + 14, std::uint16_t{1}, "as many poses");
  refuse(layout_.clips + 4, 65.0f, "a speed within 64");
  refuse(layout_.clips + 8, std::uint32_t{3}, "a mode");
  refuse(layout_.spaces + 0, std::uint32_t{1}, "points of a space");
  refuse(layout_.spaces + 4, std::uint32_t{65}, "points of a space");
  refuse(layout_.spaces + 8, std::uint32_t{2}, "goes by a number");
  refuse(layout_.spaces + 24, std::uint32_t{4}, "match a speed");
  refuse(layout_.points + 0, std::uint32_t{0}, "stand later, and lower");
  refuse(layout_.points + 0, kNoIndex, "stand later, and lower");
  refuse(layout_.points + 4, std::bit_cast<float>(0x7FC00000u), "within 1e12");
  refuse(layout_.triangles + 0, std::uint32_t{4}, "corners are points");
  refuse(layout_.machines + 4, std::uint32_t{65}, "states of a machine");
  refuse(layout_.machines + 8, std::uint32_t{1}, "transitions of a machine");
  refuse(layout_.machines + 16, std::uint32_t{9}, "starts in a state");
  refuse(layout_.states + 4, std::uint32_t{0}, "stand later, and lower");
  refuse(layout_.transitions + 0, std::uint32_t{7}, "from a state to one");
  refuse(layout_.transitions + 8, std::uint32_t{0}, "from a state to one");
  refuse(layout_.transitions + 16, std::uint32_t{17}, "conditions of a transition");
  refuse(layout_.transitions + 20, std::bit_cast<float>(0x7F800000u), "times of a transition");
  refuse(layout_.transitions + 36, std::uint32_t{16}, "times of a transition");
  refuse(layout_.conditions + 0, std::uint32_t{0}, "asks of its parameter");
  refuse(layout_.conditions + 4, std::uint32_t{6}, "asks of its parameter");
  refuse(layout_.layers + 0, std::uint32_t{0}, "stand later, and lower");
  refuse(layout_.layers + 8, std::uint32_t{2}, "no such mask");
  refuse(layout_.layers + 12, std::uint32_t{3}, "a number or a flag");
  refuse(layout_.layers + 16, 1.5f, "a weight from 0 to 1");
  refuse(layout_.masks + 4, std::uint32_t{0}, "parts of a mask");
  refuse(layout_.parts + 0, std::uint32_t{99}, "a role of joints");
  refuse(56, std::uint32_t{2}, "records in their nodes' order");  // given_count
}

}  // namespace
}  // namespace marrow
