// Graphs of behaviour and their animators.
#include <gtest/gtest.h>

#include "marrow/owned.h"
#include "support/golden.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// A file with a graph, and an animator and a character of it.
struct Behaving {
  Behaving() {
    const AlignedBlock golden = golden_graph_copy();
    EXPECT_EQ(make_owned(Span<const std::byte>(golden.data(), golden.size()), file), Status::ok);
    EXPECT_EQ(file.graph(0, graph), Status::ok);
    EXPECT_EQ(make_owned(file, {}, animator), Status::ok) << animator.misfit.rule << animator.misfit.name;
    EXPECT_EQ(make_owned(file, {.layers = 16}, character), Status::ok);
    EXPECT_EQ(update_animator(animator, 0.1f, step), Status::ok);
  }
  OwnedFile file;
  Graph graph;
  OwnedAnimator animator;
  OwnedCharacter character;
  AnimatorStep step;
};

const Behaving& whole() {
  static const Behaving made;
  return made;
}

// An index of one kind of record changed, or a number.
Graph graph_of(Misuse& m, std::vector<GraphNode>& nodes, std::vector<GraphLayer>& layers) {
  Graph g = whole().graph;
  nodes.assign(g.nodes.begin(), g.nodes.end());
  layers.assign(g.layers.begin(), g.layers.end());
  nodes[1].record = m.index(nodes[1].record);
  nodes[2].kind = m.kind(nodes[2].kind);
  layers[0].pose = m.index(layers[0].pose);
  layers[1].weight = m.number(0.5f);
  g.nodes = nodes;
  g.layers = layers;
  return g;
}

Animator animator_of(Misuse& m, Behaving& of) {
  return m.truth(true) ? static_cast<const Animator&>(of.animator) : Animator{};
}

}  // namespace

std::vector<MisuseRow> rows_of_animators() {
  return {
      {"graph_count", MISUSED(m.either(whole().file, OwnedFile{}).graph_count())},
      {"graph",
       [](Misuse& m) {
         Graph out;
         m.returned(m.either<File>(whole().file, File{}).graph(m.truth(true) ? 0 : m.index(0), out));
       }},
      {"event_id", MISUSED(event_id("left_foot"))},
      {"graph_binding_bytes", MISUSED(graph_binding_bytes(whole().graph, m.either<File>(whole().file, File{})))},
      {"bind_graph",
       [](Misuse& m) {
         std::vector<GraphNode> nodes;
         std::vector<GraphLayer> layers;
         const Graph graph = graph_of(m, nodes, layers);
         const Animations all = m.either(whole().file.animations, Animations{});
         const std::size_t bytes = graph_binding_bytes(graph, whole().file);
         GraphBinding& out = m.one(GraphBinding{});
         m.may_fail();
         m.returned(bind_graph(whole().file, graph, whole().file, {&all, 1}, m.memory(bytes), out));
       }},
      {"animator_bytes", MISUSED(animator_bytes(whole().animator.bound, {m.truth(true), m.index(4) % 64}))},
      {"make_animator",
       [](Misuse& m) {
         const AnimatorOptions options{m.truth(true), m.index(4) % 64, m.index(1), m.number(0.1f)};
         Animator& out = m.one(Animator{});
         const std::size_t bytes = animator_bytes(whole().animator.bound, options);
         m.returned(make_animator(m.either(whole().animator.bound, GraphBinding{}), options, m.memory(bytes), out));
       }},
      {"find_parameter", MISUSED(find_parameter(m.either(whole().animator.bound, GraphBinding{}), m.pointer("speed")))},
      {"find_graph_node",
       MISUSED(find_graph_node(m.either(whole().animator.bound, GraphBinding{}), m.pointer("body")))},
      {"find_state",
       MISUSED(find_state(m.either(whole().animator.bound, GraphBinding{}), m.index(3), m.pointer("moves")))},
      {"set_number",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         m.returned(set_number(a, m.index(0), m.number(0.5f)));
       }},
      {"set_flag",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         m.returned(set_flag(a, m.index(2), m.truth(true)));
       }},
      {"fire",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         m.returned(fire(a, m.index(3)));
       }},
      {"value_of",
       [](Misuse& m) {
         Behaving of;
         (void)value_of(animator_of(m, of), m.index(3));
         m.returned_ok();
       }},
      {"state_of",
       [](Misuse& m) {
         Behaving of;
         float seconds = 0;
         (void)state_of(animator_of(m, of), m.index(1), m.pointer(&seconds));
         m.returned_ok();
       }},
      {"update_animator",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         AnimatorStep& out = m.one(AnimatorStep{});
         m.returned(update_animator(a, m.number(0.1f), out));
       }},
      {"restore_animator",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         const Span<std::byte> state = whole().animator.state;
         m.may_fail();
         m.returned(restore_animator(a, m.in(Span<const std::byte>(state.data, state.size))));
       }},
      {"sample_character",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         m.returned(sample_character(of.character, a));
       }},
      {"pose_character",
       [](Misuse& m) {
         Behaving of;
         Animator a = animator_of(m, of);
         const std::vector<SoaTransform> local(whole().character.skeletons[0].pose.local.begin(),
                                               whole().character.skeletons[0].pose.local.end());
         const GivenPose given{m.in(local, Length::exact_or_none)};
         m.returned(pose_character(of.character, a, {&given, 1}));
       }},
  };
}

}  // namespace marrow::test
