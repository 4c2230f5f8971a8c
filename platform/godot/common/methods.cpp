#include "methods.h"

namespace marrow_godot {
namespace {

using Arguments = const Value*;

void open(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.open(in[0].bytes, in[0].byte_count, in[1].text, in[2].whole);
}

void add_clips(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.add_clips(in[0].bytes, in[0].byte_count, in[1].text);
}

void get_error(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.text = cooked.error();
}
void clips(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.texts = cooked.clips();
}
void bones(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.texts = cooked.bones();
}
void parents(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.ints = cooked.parents();
}
void rests(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.reals = cooked.rests();
}
void above(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.reals = cooked.above();
}
void mesh_count(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.whole = cooked.mesh_count();
}

void find_clip(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.find_clip(in[0].text);
}
void duration(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.real = cooked.duration(in[0].whole);
}
void mesh_name(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.text = cooked.mesh_name(in[0].whole);
}

void mesh_reals(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.reals = cooked.mesh_reals(in[0].whole, in[1].text, in[2].whole);
}

void mesh_ints(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.ints = cooked.mesh_ints(in[0].whole, in[1].text, in[2].whole);
}

void sample(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  const float* const pose = cooked.pose(in[0].whole, in[1].real, in[2].whole, in[3].real, in[4].real);
  if (pose != nullptr) out.reals.assign(pose, pose + kReals * cooked.bone_count());
}

bool set_bones(Cooked& cooked, const Engine& engine, void* skeleton, const float* pose) {
  if (pose == nullptr) return false;
  return engine.set_bones(skeleton, pose, cooked.rests().data(), cooked.bone_count()) ||
         cooked.fail("what is to be posed is no skeleton of " + std::to_string(cooked.bone_count()) +
                     " bones: give pose() the one that was made for this file");
}

void pose(Cooked& cooked, const Engine& engine, Arguments in, Value& out) {
  const float* const pose = cooked.pose(in[1].whole, in[2].real, in[3].whole, in[4].real, in[5].real);
  out.whole = set_bones(cooked, engine, in[0].object, pose);
}

void graphs(Cooked& cooked, const Engine&, Arguments, Value& out) {
  out.texts = cooked.graphs();
}
void make_animator(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.make_animator(in[0].text);
}
void free_animator(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.free_animator(in[0].whole);
}
void parameters(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.texts = cooked.parameters(in[0].whole);
}
void parameter_reals(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.reals = cooked.parameter_reals(in[0].whole);
}
void find_parameter(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.find_parameter(in[0].whole, in[1].text);
}
void set_parameter(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.set_parameter(in[0].whole, in[1].whole, in[2].real);
}
void fire(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.fire(in[0].whole, in[1].whole);
}
void update(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.reals = cooked.update(in[0].whole, in[1].real);
}
void events(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.texts = cooked.events(in[0].whole);
}
void state_of(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.text = cooked.state_of(in[0].whole, in[1].text, nullptr);
}
void state_time(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  cooked.state_of(in[0].whole, in[1].text, &out.real);
}

void get_state(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  const mrw_bytes state = cooked.state(in[0].whole);
  out.bytes = static_cast<const std::uint8_t*>(state.data);
  out.byte_count = state.size;
}

void set_state(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  out.whole = cooked.restore(in[0].whole, in[1].bytes, in[1].byte_count);
}

void sample_graph(Cooked& cooked, const Engine&, Arguments in, Value& out) {
  const float* const pose = cooked.pose_graph(in[0].whole);
  if (pose != nullptr) out.reals.assign(pose, pose + kReals * cooked.bone_count());
}

void pose_graph(Cooked& cooked, const Engine& engine, Arguments in, Value& out) {
  out.whole = set_bones(cooked, engine, in[0].object, cooked.pose_graph(in[1].whole));
}

constexpr Argument kClip{"clip", Kind::whole}, kTime{"time_s", Kind::real}, kOther{"other", Kind::whole},
    kOtherTime{"other_s", Kind::real}, kShare{"share", Kind::real}, kMesh{"mesh", Kind::whole},
    kWhat{"what", Kind::text}, kInfluences{"influences", Kind::whole}, kAnimator{"animator", Kind::whole},
    kParameter{"parameter", Kind::whole}, kName{"name", Kind::text}, kMachine{"machine", Kind::text};

constexpr Method kMethods[] = {
    {"open", Kind::truth, 3, {{"bytes", Kind::bytes}, kName, {"skeleton", Kind::whole}}, open},
    {"add_clips", Kind::truth, 2, {{"bytes", Kind::bytes}, kName}, add_clips},
    {"get_error", Kind::text, 0, {}, get_error},
    {"clips", Kind::texts, 0, {}, clips},
    {"find_clip", Kind::whole, 1, {kName}, find_clip},
    {"duration", Kind::real, 1, {kClip}, duration},
    {"bones", Kind::texts, 0, {}, bones},
    {"parents", Kind::ints, 0, {}, parents},
    {"rests", Kind::reals, 0, {}, rests},
    {"above", Kind::reals, 0, {}, above},
    {"sample", Kind::reals, 5, {kClip, kTime, kOther, kOtherTime, kShare}, sample},
    {"pose", Kind::truth, 6, {{"skeleton", Kind::object}, kClip, kTime, kOther, kOtherTime, kShare}, pose},
    {"graphs", Kind::texts, 0, {}, graphs},
    {"make_animator", Kind::whole, 1, {{"graph", Kind::text}}, make_animator},
    {"free_animator", Kind::truth, 1, {kAnimator}, free_animator},
    {"parameters", Kind::texts, 1, {kAnimator}, parameters},
    {"parameter_reals", Kind::reals, 1, {kAnimator}, parameter_reals},
    {"find_parameter", Kind::whole, 2, {kAnimator, kName}, find_parameter},
    {"set_parameter", Kind::truth, 3, {kAnimator, kParameter, {"value", Kind::real}}, set_parameter},
    {"fire", Kind::truth, 2, {kAnimator, kParameter}, fire},
    {"update", Kind::reals, 2, {kAnimator, {"dt_s", Kind::real}}, update},
    {"events", Kind::texts, 1, {kAnimator}, events},
    {"sample_graph", Kind::reals, 1, {kAnimator}, sample_graph},
    {"pose_graph", Kind::truth, 2, {{"skeleton", Kind::object}, kAnimator}, pose_graph},
    {"state_of", Kind::text, 2, {kAnimator, kMachine}, state_of},
    {"state_time", Kind::real, 2, {kAnimator, kMachine}, state_time},
    {"get_state", Kind::bytes, 1, {kAnimator}, get_state},
    {"set_state", Kind::truth, 2, {kAnimator, {"state", Kind::bytes}}, set_state},
    {"mesh_count", Kind::whole, 0, {}, mesh_count},
    {"mesh_name", Kind::text, 1, {kMesh}, mesh_name},
    {"mesh_reals", Kind::reals, 3, {kMesh, kWhat, kInfluences}, mesh_reals},
    {"mesh_ints", Kind::ints, 3, {kMesh, kWhat, kInfluences}, mesh_ints},
};

}  // namespace

Methods methods() {
  return {kMethods, int(sizeof kMethods / sizeof kMethods[0])};
}

}  // namespace marrow_godot
