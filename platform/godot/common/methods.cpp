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

void pose(Cooked& cooked, const Engine& engine, Arguments in, Value& out) {
  const float* const pose = cooked.pose(in[1].whole, in[2].real, in[3].whole, in[4].real, in[5].real);
  if (pose == nullptr) return;
  out.whole = engine.set_bones(in[0].object, pose, cooked.rests().data(), cooked.bone_count()) ||
              cooked.fail("what is to be posed is no skeleton of " + std::to_string(cooked.bone_count()) +
                          " bones: give pose() the one that was made for this file");
}

constexpr Argument kClip{"clip", Kind::whole}, kTime{"time_s", Kind::real}, kOther{"other", Kind::whole},
    kOtherTime{"other_s", Kind::real}, kShare{"share", Kind::real}, kMesh{"mesh", Kind::whole},
    kWhat{"what", Kind::text}, kInfluences{"influences", Kind::whole};

constexpr Method kMethods[] = {
    {"open", Kind::truth, 3, {{"bytes", Kind::bytes}, {"name", Kind::text}, {"skeleton", Kind::whole}}, open},
    {"add_clips", Kind::truth, 2, {{"bytes", Kind::bytes}, {"name", Kind::text}}, add_clips},
    {"get_error", Kind::text, 0, {}, get_error},
    {"clips", Kind::texts, 0, {}, clips},
    {"find_clip", Kind::whole, 1, {{"name", Kind::text}}, find_clip},
    {"duration", Kind::real, 1, {kClip}, duration},
    {"bones", Kind::texts, 0, {}, bones},
    {"parents", Kind::ints, 0, {}, parents},
    {"rests", Kind::reals, 0, {}, rests},
    {"above", Kind::reals, 0, {}, above},
    {"sample", Kind::reals, 5, {kClip, kTime, kOther, kOtherTime, kShare}, sample},
    {"pose", Kind::truth, 6, {{"skeleton", Kind::object}, kClip, kTime, kOther, kOtherTime, kShare}, pose},
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
