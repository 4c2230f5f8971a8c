// A character of several files: a body and its hair, from generated glTF through the whole road, against the reference
// evaluator of one file that has both.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "cook/prepare/match_skeletons.h"
#include "marrow/outfit.h"
#include "road/cooked.h"
#include "road/reference.h"
#include "support/allocations.h"
#include "support/rig.h"
#include "unit/cook/scene_document.h"

namespace marrow::test {
namespace {

constexpr double kMostPosition = 1e-5;  // of the diagonal
constexpr int kMoments = 17;

struct Joint {
  std::string name, parent;
  Vec3 translation;
  Quat rotation;
};

Quat turned(double x, double y, double z, double angle) {
  return axis_angle({x, y, z}, angle);
}

std::vector<Joint> body_joints() {
  return {
      {"hips", "", {0, 1, 0}, turned(0, 1, 0, 0.4)},           {"spine", "hips", {0, 0.25, 0.01}, turned(1, 0, 0, 0.2)},
      {"leg", "hips", {0.1, -0.1, 0}, turned(1, 0, 1, 3)},     {"chest", "spine", {0, 0.25, 0}, turned(0, 1, 1, -0.3)},
      {"arm", "chest", {0.2, 0.15, 0}, turned(0, 0, 1, -1.4)}, {"neck", "chest", {0, 0.25, 0}, turned(1, 0, 0, 0.1)},
      {"hand", "arm", {0, 0.5, 0}, turned(0, 1, 0, 1)},        {"head", "neck", {0, 0.1, 0}, turned(1, 1, 0, -0.2)}};
}
std::vector<Joint> own_joints() {
  return {{"tail", "head", {0, 0.05, -0.1}, turned(1, 0, 0, 2)},
          {"tail tip", "tail", {0, 0.2, 0}, turned(1, 0, 0, 0.3)}};
}

// model_from_joint at rest, of a joint of both; roots stand in the scene itself.
Map rest_of(const std::string& name) {
  for (const std::vector<Joint>& joints : {body_joints(), own_joints()})
    for (const Joint& j : joints) {
      if (j.name != name) continue;
      const Map local = from_trs(j.translation, j.rotation, {1, 1, 1});
      return j.parent.empty() ? local : rest_of(j.parent) * local;
    }
  ADD_FAILURE() << name;
  return {};
}

// Of a rotation and a translation.
Map rigid_inverse(const Map& m) {
  Map out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.rows[r][c] = m.rows[c][r];
    out.rows[r][3] = -(m.rows[0][r] * m.rows[0][3] + m.rows[1][r] * m.rows[1][3] + m.rows[2][r] * m.rows[2][3]);
  }
  return out;
}

std::vector<float> floats(std::initializer_list<double> numbers) {
  return {numbers.begin(), numbers.end()};
}

// A document with some of the joints.
struct Model {
  void joint(const Joint& j, int parent) {
    const int n = d.node(j.name, parent, floats({j.translation[0], j.translation[1], j.translation[2]}));
    d.b.root["nodes"][static_cast<std::size_t>(n)]["rotation"] =
        floats({j.rotation[0], j.rotation[1], j.rotation[2], j.rotation[3]});
    node[j.name] = n;
  }
  void body() {
    for (const Joint& j : body_joints()) joint(j, j.parent.empty() ? -1 : node.at(j.parent));
  }
  void own() {
    for (const Joint& j : own_joints()) joint(j, node.at(j.parent));
  }
  // Thirty vertices about these joints, bound in the rest pose; a joint called otherwise moves none.
  void skin(const std::string& name, const std::vector<std::string>& joints, std::uint64_t seed) {
    Random random(seed);
    std::vector<float> positions, weights, binds;
    std::vector<std::uint8_t> of;
    std::vector<std::uint16_t> indices;
    std::vector<std::uint8_t> followed;
    std::vector<int> nodes;
    for (std::uint8_t i = 0; i < joints.size(); ++i) {
      const bool root = joints[i].ends_with("root");
      const Map bind = root ? Map{} : rigid_inverse(rest_of(joints[i]));
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) binds.push_back(r < 3 ? static_cast<float>(bind.rows[r][c]) : c == 3 ? 1.0F : 0.0F);
      if (!root) followed.push_back(i);
      nodes.push_back(node.at(joints[i]));
    }
    // The same whatever the order of the joints.
    std::ranges::sort(followed, {}, [&](std::uint8_t i) { return joints[i]; });
    for (int v = 0; v < 30; ++v) {
      const auto count = static_cast<std::uint32_t>(followed.size());
      const std::uint32_t first = random.below(count), second = (first + 1 + random.below(count - 1)) % count;
      const Map at = rest_of(joints[followed[first]]);
      for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(at.rows[c][3] + random.between(-0.1, 0.1)));
      const auto weight = static_cast<float>(random.between(0.25, 0.75));
      for (const std::uint8_t j : {followed[first], followed[second], std::uint8_t{0}, std::uint8_t{0}})
        of.push_back(j);
      for (const float w : {weight, 1 - weight, 0.0F, 0.0F}) weights.push_back(w);
      indices.push_back(static_cast<std::uint16_t>(v));
    }
    Json& root = d.b.root;
    const Json attributes = {{"POSITION", d.b.positions(positions)},
                             {"JOINTS_0", d.b.numbers<std::uint8_t>(cook::kU8, "VEC4", 4, of)},
                             {"WEIGHTS_0", d.b.numbers<float>(cook::kF32, "VEC4", 4, weights)}};
    const int list = d.b.numbers<std::uint16_t>(cook::kU16, "SCALAR", 1, indices);
    root["meshes"].push_back({{"name", name}, {"primitives", {{{"attributes", attributes}, {"indices", list}}}}});
    root["skins"].push_back(
        {{"joints", nodes}, {"inverseBindMatrices", d.b.numbers<float>(cook::kF32, "MAT4", 16, binds)}});
    Json& drawn = root["nodes"][static_cast<std::size_t>(d.node(name))];
    drawn["mesh"] = root["meshes"].size() - 1;
    drawn["skin"] = root["skins"].size() - 1;
  }
  void sword() { d.prop(d.node("sword", node.at("hand"), {0.0F, 0.1F, 0.0F})); }
  void body_clip() {
    d.clip("walk");
    d.turn(node.at("hips"), {0, 0.3F, 0.8F});
    d.turn(node.at("neck"), {0, 0.5F, 1});
    d.turn(node.at("arm"), {0, 0.25F, 0.75F, 1});
    d.turn(node.at("hand"), {0, 1});
    d.carry(node.at("leg"), {0, 0.5F});
  }
  void own_clip() { d.turn(node.at("tail"), {0, 0.25F, 0.75F, 1}); }

  std::string write(const std::string& name) {
    const std::string path = ::testing::TempDir() + "marrow_outfits_" + name + ".gltf";
    std::ofstream(path) << d.text();
    return path;
  }
  using Json = cook::Json;
  cook::SceneDocument d;
  std::map<std::string, int> node;
};

const std::vector<std::string> kBodySkin = {"hips", "spine", "leg", "chest", "arm", "neck", "hand", "head"};
const std::vector<std::string> kHairSkin = {"chest", "neck", "head", "tail", "tail tip"};

std::string write_body() {
  Model m;
  m.body();
  m.skin("body", kBodySkin, 1);
  m.body_clip();
  return m.write("body");
}

// Some joints, in another order, below another root, which is a joint of the skin; and what a hand holds.
std::string write_hair() {
  Model m;
  const int rig = m.d.node("hair rig", -1, {5, 0, 0});
  m.node["hair root"] = m.d.node("hair root", rig, {0, 0, 2});
  std::map<std::string, Joint> joints;
  for (const Joint& j : body_joints()) joints[j.name] = j;
  m.joint(joints["chest"], m.node["hair root"]);
  m.joint(joints["neck"], m.node["chest"]);
  m.joint(joints["head"], m.node["neck"]);
  m.own();
  m.joint(joints["arm"], m.node["chest"]);
  m.joint(joints["hand"], m.node["arm"]);
  m.sword();
  m.skin("hair", {"tail tip", "head", "hair root", "tail", "neck", "chest"}, 2);
  m.d.clip("walk");
  m.d.turn(m.node["chest"], {0, 0.5F});  // the body's own, and not like this
  m.own_clip();
  m.d.clip("jump");
  m.d.turn(m.node["chest"], {0, 0.5F});
  return m.write("hair");
}

std::string write_whole() {
  Model m;
  m.body();
  m.skin("body", kBodySkin, 1);
  m.own();
  m.sword();
  m.skin("hair", kHairSkin, 2);
  m.body_clip();
  m.own_clip();
  return m.write("whole");
}

cook::CookOptions plain() {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.raw = true;
  return options;
}

// Cooked for a body.
Cooked outfit_of(const std::string& path, const Cooked& body) {
  cook::CookOptions options = plain();
  options.onto = std::make_shared<const cook::Character>(cook::view_character("body.mrw", body.file()));
  return Cooked(path, options);
}

// A character of a file and what it plays.
struct Actor {
  explicit Actor(const File& file)
      : shared(animations_bytes(file, file)), own(character_bytes(file, {.animation_space = true})) {
    EXPECT_EQ(make_animations(file, file, shared, animations), Status::ok);
    EXPECT_EQ(make_character(file, {.animation_space = true}, own, character), Status::ok);
  }
  // Appends all vertices in their source's order.
  void append(std::vector<Vec3>& out) const {
    for (const CharacterMesh& m : character.meshes) {
      std::vector<float> positions(std::size_t{3} * m.mesh.geometry.slot_count);
      EXPECT_EQ(skin_ssd(m.mesh, m.palette, {.positions = positions}), Status::ok);
      for (const std::uint32_t slot : m.mesh.geometry.source_slots)
        out.push_back({static_cast<double>(positions[3 * slot]), static_cast<double>(positions[3 * slot + 1]),
                       static_cast<double>(positions[3 * slot + 2])});
    }
  }
  AlignedBlock shared, own;
  Animations animations;
  marrow::Character character;
};

struct Dressed {
  Dressed() : body_file(write_body(), plain()), hair_file(outfit_of(write_hair(), body_file)) {}
  const File& body() const { return body_file.file(); }
  const File& hair() const { return hair_file.file(); }
  Cooked body_file, hair_file;
};

const Dressed& dressed() {
  static const Dressed made;
  return made;
}

TEST(Outfits, StandWhereTheWholeCharacterHasThem) {
  const std::string path = write_whole();
  const Reference reference(path);
  const Cooked whole(path, plain());
  Actor body(dressed().body()), hair(dressed().hair()), one(whole.file());
  AlignedBlock memory(outfit_bytes(dressed().hair()));
  Outfit outfit;
  ASSERT_EQ(make_outfit(dressed().body(), dressed().hair(), memory, outfit), Status::ok);
  const Animation* const walk = find_animation(body.animations, "walk");
  const Animation* const swing = find_animation(hair.animations, "walk");
  ASSERT_NE(walk, nullptr);
  ASSERT_NE(swing, nullptr);
  EXPECT_EQ(find_animation(hair.animations, "jump"), nullptr) << "moves nothing of its own";
  double worst = 0, apart = 0;
  std::size_t compared = 0;
  for (int i = 0; i < kMoments; ++i) {
    const float time_s = static_cast<float>(i) / (kMoments - 1);
    ASSERT_EQ(pose_character(body.character, {{walk, time_s}}), Status::ok);
    ASSERT_EQ(finish_character(body.character), Status::ok);
    ASSERT_EQ(sample_character(hair.character, {{swing, time_s}}), Status::ok);
    ASSERT_EQ(follow_body(outfit, body.character, hair.character), Status::ok);
    ASSERT_EQ(finish_character(hair.character), Status::ok);
    ASSERT_EQ(pose_character(one.character, {{&one.animations.all[0], time_s}}), Status::ok);
    ASSERT_EQ(finish_character(one.character), Status::ok);
    std::vector<Vec3> got, together;
    body.append(got);
    hair.append(got);
    one.append(together);
    const ReferencePose want = reference.at(0, static_cast<double>(time_s));
    ASSERT_EQ(got.size(), want.positions.size());
    ASSERT_EQ(got.size(), together.size());
    for (std::size_t v = 0; v < got.size(); ++v) {
      worst = std::max(worst, length(minus(got[v], want.positions[v])) / reference.diagonal());
      apart = std::max(apart, length(minus(got[v], together[v])) / reference.diagonal());
      ++compared;
    }
  }
  EXPECT_EQ(compared, std::size_t{kMoments} * 64) << "30 of the body, 4 of the sword, 30 of the hair";
  EXPECT_LT(worst, kMostPosition);
  EXPECT_LT(apart, kMostPosition);
  EXPECT_GT(worst, 0);
  std::printf("outfit against the reference %.2g of the diagonal, against all in one file %.2g\n", worst, apart);
}

TEST(Outfits, HaveTheBodysJointsAndTheirOwn) {
  const File &hair = dressed().hair(), &body = dressed().body();
  ASSERT_EQ(hair.skeleton_count(), 1u);
  const Skeleton own = hair.skeleton(0), there = body.skeleton(0);
  ASSERT_EQ(own.joint_count, there.joint_count + 2);
  std::vector<std::uint16_t> joints(own.joint_count);
  ASSERT_EQ(bind_outfit(hair, 0, body, 0, joints), Status::ok);
  for (std::uint32_t j = 0; j < own.joint_count; ++j) {
    const std::string name = hair.text(own.names[j]);
    const bool is_own = name.starts_with("tail");
    EXPECT_EQ(joints[j] == kNoJoint, is_own) << name;
    if (is_own) continue;
    EXPECT_EQ(name, body.text(there.names[joints[j]]));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(own.rest[j / 4].translation[axis][j % 4], there.rest[joints[j] / 4].translation[axis][joints[j] % 4],
                  1e-6F);
  }
  for (const auto& warning : dressed().hair_file.report().at("warnings"))
    EXPECT_EQ(warning.at("rule"), "clips-of-body") << warning;
}

TEST(Outfits, WithoutJointsOfTheirOwnHaveTheBodysSkeleton) {
  Model m;
  m.body();
  m.skin("shirt", {"chest", "arm", "spine"}, 3);
  const Cooked shirt = outfit_of(m.write("shirt"), dressed().body_file);
  std::vector<std::uint16_t> joints(8);
  ASSERT_EQ(bind_outfit(shirt.file(), 0, dressed().body(), 0, joints), Status::ok);
  for (std::uint16_t j = 0; j < 8; ++j) EXPECT_EQ(joints[j], j);
  EXPECT_EQ(shirt.file().skeleton(0).joint_count, 8u);
}

TEST(Outfits, JointsAreTheSameBitsAsPosedAlone) {
  const File& hair = dressed().hair();
  const Skeleton own = hair.skeleton(0);
  std::vector<std::uint16_t> joints(own.joint_count);
  ASSERT_EQ(bind_outfit(hair, 0, dressed().body(), 0, joints), Status::ok);
  std::vector<SoaTransform> local(own.soa_size());
  ASSERT_EQ(sample(own, hair.clip(0), 0.3f, local), Status::ok);
  std::vector<Affine> alone(own.joint_count), body(own.joint_count), followed(own.joint_count);
  ASSERT_EQ(local_to_model(own, local, alone), Status::ok);
  for (std::uint32_t j = 0; j < own.joint_count; ++j)
    if (joints[j] != kNoJoint) body[joints[j]] = alone[j];
  const std::size_t before = allocation_count();
  ASSERT_EQ(follow_body(own, joints, body, local, followed), Status::ok);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(std::memcmp(followed.data(), alone.data(), alone.size() * sizeof(Affine)), 0);
}

using Misfits = std::vector<std::pair<Misfit, std::string>>;

Misfits misfits_of(const File& outfit, const File& body) {
  std::vector<std::uint16_t> joints(outfit.skeleton(0).joint_count);
  std::vector<JointMisfit> found(16);
  std::size_t count = 0;
  EXPECT_EQ(bind_outfit(outfit, 0, body, 0, joints, found, &count), Status::mismatch);
  EXPECT_EQ(bind_outfit(outfit, 0, body, 0, joints), Status::mismatch) << "without asking for reasons";
  AlignedBlock memory(outfit_bytes(outfit));
  Outfit made;
  EXPECT_EQ(make_outfit(body, outfit, memory, made), Status::mismatch);
  EXPECT_TRUE(made.skeletons.empty());
  Misfits out;
  for (std::size_t i = 0; i < count; ++i) {
    const File& of = found[i].how == Misfit::extra ? body : outfit;
    out.emplace_back(found[i].how, of.text(of.skeleton(0).names[found[i].joint]));
  }
  return out;
}

TEST(Outfits, OfAnotherBodyAreRefused) {
  const auto body_with = [&](const std::function<void(std::vector<Joint>&)>& change) {
    Model m;
    std::vector<Joint> joints = body_joints();
    change(joints);
    for (const Joint& j : joints) m.joint(j, j.parent.empty() ? -1 : m.node.at(j.parent));
    std::vector<int> all;
    for (const auto& [name, node] : m.node) all.push_back(node);
    m.d.skin("other", all);
    m.d.clip("all");
    for (const auto& [name, node] : m.node) m.d.turn(node, {0, 1});
    return Cooked(m.write("other"), plain());
  };
  const File& hair = dressed().hair();
  const Cooked longer = body_with([](std::vector<Joint>& j) { j.push_back({"toe", "leg", {0, 1, 0}, {0, 0, 0, 1}}); });
  EXPECT_EQ(misfits_of(hair, longer.file()), (Misfits{{Misfit::extra, "toe"}}));
  const Cooked renamed = body_with([](std::vector<Joint>& j) { j[0].name = j[1].parent = j[2].parent = "pelvis"; });
  EXPECT_EQ(misfits_of(hair, renamed.file()), (Misfits{{Misfit::extra, "pelvis"},
                                                       {Misfit::other_parent, "spine"},
                                                       {Misfit::other_parent, "leg"},
                                                       {Misfit::missing, "hips"}}));
  const Cooked moved = body_with([](std::vector<Joint>& j) { j[4].parent = "spine"; });
  EXPECT_EQ(misfits_of(hair, moved.file()), (Misfits{{Misfit::other_parent, "arm"}}));
  const Cooked swapped = body_with([](std::vector<Joint>& j) { std::swap(j[4], j[5]); });
  EXPECT_EQ(misfits_of(hair, swapped.file()), (Misfits{{Misfit::other_place, "arm"}}));
  const Cooked taller = body_with([](std::vector<Joint>& j) { j[1].translation[1] = 2; });
  std::vector<std::uint16_t> joints(hair.skeleton(0).joint_count);
  EXPECT_EQ(bind_outfit(hair, 0, taller.file(), 0, joints), Status::ok) << "the same clothes fit";
  EXPECT_EQ(misfits_of(Cooked(write_hair(), plain()).file(), dressed().body()).size(), 7u)
      << "cooked for itself: five joints and a root are not the body's, and one has no parent of it";
}

TEST(Outfits, MorphTargetsAreSetByTheGame) {
  Model m;
  m.body();
  m.skin("scarf", {"chest", "neck"}, 4);
  std::vector<float> up;
  for (int v = 0; v < 30; ++v) up.insert(up.end(), {0, 0.5F, 0});
  m.d.b.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", m.d.b.positions(up)}}};
  const Cooked scarf = outfit_of(m.write("scarf"), dressed().body_file);
  Actor body(dressed().body()), worn(scarf.file());
  AlignedBlock memory(outfit_bytes(scarf.file()));
  Outfit outfit;
  ASSERT_EQ(make_outfit(dressed().body(), scarf.file(), memory, outfit), Status::ok);
  std::vector<Vec3> before, after;
  for (std::vector<Vec3>* to : {&before, &after}) {
    worn.character.meshes[0].weights[0] = to == &before ? 0.0F : 1.0F;
    ASSERT_EQ(follow_body(outfit, body.character, worn.character), Status::ok);
    ASSERT_EQ(finish_character(worn.character), Status::ok);
    worn.append(*to);
  }
  // At rest a vertex of the bind pose is where it is.
  for (std::size_t v = 0; v < before.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[v][c] - before[v][c], c == 1 ? 0.5 : 0.0, 1e-4);
}

}  // namespace
}  // namespace marrow::test
