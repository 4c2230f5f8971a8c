// Clip packs: files written here byte by byte from docs/format.md, and what does and does not fit what.
#include "marrow/clip_pack.h"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/sample.h"
#include "support/aligned.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using test::AlignedBlock;

struct HandJoint {
  std::string name;
  int parent;
  float rest[10];  // translation, rotation, scale
};

// hips, with a leg and a spine, on which a head.
std::vector<HandJoint> person() {
  return {{"hips", -1, {0, 1, 0, 0, 0, 0, 1, 1, 1, 1}},
          {"leg", 0, {0.25f, -0.5f, 0, 0, 0, 0, 1, 1, 1, 1}},
          {"spine", 0, {0, 0.5f, 0, 0.6f, 0, 0, 0.8f, 1, 1, 1}},
          {"head", 2, {0, 0.25f, 0, 0, 0, 0, 1, 2, 2, 2}}};
}

// docs/format.md, SREF, in the plainest way there is.
std::uint32_t documented_rest_hash(const HandJoint& joint) {
  std::uint32_t hash = 2166136261u;
  for (const float number : joint.rest) {
    unsigned char bytes[4];
    std::memcpy(bytes, &number, 4);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 16777619u;
  }
  return hash;
}

std::uint64_t documented_hash(const std::vector<HandJoint>& joints) {
  std::vector<unsigned char> all;
  for (const HandJoint& joint : joints) {
    all.insert(all.end(), joint.name.begin(), joint.name.end());
    all.push_back(0);
    const unsigned parent = joint.parent < 0 ? 0xFFFFu : static_cast<unsigned>(joint.parent);
    all.push_back(static_cast<unsigned char>(parent & 255u));
    all.push_back(static_cast<unsigned char>(parent >> 8));
    for (const float number : joint.rest) {
      unsigned char bytes[4];
      std::memcpy(bytes, &number, 4);
      all.insert(all.end(), bytes, bytes + 4);
    }
  }
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const unsigned char byte : all) hash = (hash ^ byte) * 0x100000001B3u;
  return hash;
}

// A cooked file in the making: sections, then the names that they refer to.
class HandFile {
 public:
  std::uint32_t name(const std::string& text) {
    const auto at = static_cast<std::uint32_t>(names_.size());
    names_.append(text).push_back('\0');
    return at;
  }
  void begin(const char* type) { sections_.push_back({type, {}}); }
  template <class T>
  void put(T value) {
    std::string& bytes = sections_.back().second;
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void skeleton(const std::vector<HandJoint>& joints) {
    std::uint32_t roots = 0;
    for (const HandJoint& j : joints) roots += j.parent < 0;
    begin("SKEL");
    for (const std::uint32_t n : {name("person"), static_cast<std::uint32_t>(joints.size()), roots, 0u}) put(n);
    for (std::uint32_t r = 0; r < roots; ++r)
      for (const float f : {1.f, 0.f, 0.f, 9.f, 0.f, 1.f, 0.f, 9.f, 0.f, 0.f, 1.f, 9.f}) put(f);
    for (std::size_t group = 0; group < joints.size(); group += 4)
      for (std::size_t number = 0; number < 10; ++number)
        for (std::size_t lane = 0; lane < 4; ++lane)
          put(group + lane < joints.size() ? joints[group + lane].rest[number] : number >= 6 ? 1.0f : 0.0f);
    for (const HandJoint& j : joints) put(name(j.name));
    for (const HandJoint& j : joints) put(static_cast<std::uint16_t>(j.parent));
  }
  void reference(const std::vector<HandJoint>& joints) {
    begin("SREF");
    put(name("person"));
    put(static_cast<std::uint32_t>(joints.size()));
    put(documented_hash(joints));
    for (const HandJoint& j : joints) put(name(j.name));
    for (const HandJoint& j : joints) put(documented_rest_hash(j));
    for (const HandJoint& j : joints) put(static_cast<std::uint16_t>(j.parent));
  }
  // Moves `joint` to (1, 2, 3).
  void clip(std::uint32_t skeleton, std::uint16_t joint) {
    begin("CLIP");
    for (const std::uint32_t n : {name("walk"), skeleton}) put(n);
    put(0.0f);
    for (const std::uint32_t n : {1u, 1u, 3u, 0u, 0u}) put(n);
    put(joint);
    put(std::uint8_t{0});
    put(std::uint8_t{1});
    for (const std::uint32_t n : {1u, 0u, 0u}) put(n);
    for (const float f : {0.f, 1.f, 2.f, 3.f}) put(f);
  }

  AlignedBlock finish() {
    begin("NAME");
    names_.push_back('\0');
    sections_.back().second = names_;
    std::string out = "MRRW";
    const auto append = [&](std::uint64_t value, std::size_t bytes) {
      out.append(reinterpret_cast<const char*>(&value), bytes);
    };
    std::size_t end = 32 + 16 * sections_.size();
    std::string body;
    for (const std::uint64_t field : {1u, 0u}) append(field, 4);
    append(sections_.size(), 4);
    append(0, 8);
    append(0, 8);
    for (const auto& [type, bytes] : sections_) {
      const std::size_t offset = (end + 15) / 16 * 16;
      body.append(offset - end, '\0').append(bytes);
      out.append(type);
      for (const std::size_t field : {offset, bytes.size(), std::size_t{0}}) append(field, 4);
      end = offset + bytes.size();
    }
    out += body;
    const auto size = static_cast<std::uint32_t>(out.size());
    std::memcpy(out.data() + 8, &size, 4);
    test::forge_checksum(reinterpret_cast<std::byte*>(out.data()), out.size());
    return {out.data(), out.size()};
  }

 private:
  std::vector<std::pair<std::string, std::string>> sections_;
  std::string names_ = std::string(1, '\0');
};

AlignedBlock character_of(const std::vector<HandJoint>& joints) {
  HandFile file;
  file.skeleton(joints);
  return file.finish();
}

AlignedBlock pack_of(const std::vector<HandJoint>& joints, std::uint16_t joint = 3) {
  HandFile file;
  file.reference(joints);
  file.clip(0, joint);
  return file.finish();
}

struct Bound {
  Status status;
  std::vector<std::pair<Misfit, std::string>> misfits;
};

// A pack for `wanted` beside a character that is `there`.
Bound fit(const std::vector<HandJoint>& wanted, const std::vector<HandJoint>& there) {
  const AlignedBlock pack_block = pack_of(wanted, 0), character_block = character_of(there);
  File pack, character;
  EXPECT_EQ(load(pack_block, pack), Status::ok);
  EXPECT_EQ(load(character_block, character), Status::ok);
  std::vector<JointMisfit> misfits(16);
  std::size_t count = 99;
  Bound out{bind_clips(pack, 0, character, 0, misfits, &count), {}};
  EXPECT_LE(count, misfits.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& joints = misfits[i].how == Misfit::extra ? there : wanted;
    out.misfits.emplace_back(misfits[i].how, joints.at(misfits[i].joint).name);
  }
  EXPECT_EQ(bind_clips(pack, 0, character, 0), out.status);
  std::size_t again = 0;
  EXPECT_EQ(bind_clips(pack, 0, character, 0, {}, &again), out.status);
  EXPECT_EQ(again, count) << "without room for them";
  return out;
}

using Misfits = std::vector<std::pair<Misfit, std::string>>;

TEST(ClipPack, TheHashIsTheDocumentedOne) {
  const AlignedBlock block = character_of(person());
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  EXPECT_EQ(skeleton_hash(file, 0), documented_hash(person()));
  // FNV-1a's published test vector for "foobar", so that the documented form above is what its name says.
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : std::string("foobar")) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  EXPECT_EQ(hash, 0x85944171F73967E8u);
}

TEST(ClipPack, LoadsWithoutASkeletonAndPlaysOnItsCharacter) {
  const AlignedBlock pack_block = pack_of(person()), character_block = character_of(person());
  File pack, character;
  ASSERT_EQ(load(pack_block, pack), Status::ok);
  ASSERT_EQ(load(character_block, character), Status::ok);
  EXPECT_EQ(pack.skeleton_count(), 0u);
  ASSERT_EQ(pack.reference_count(), 1u);
  EXPECT_EQ(character.reference_count(), 0u);
  const SkeletonReference reference = pack.reference(0);
  EXPECT_STREQ(reference.name, "person");
  EXPECT_EQ(reference.joint_count, 4u);
  EXPECT_EQ(reference.hash, documented_hash(person()));
  EXPECT_STREQ(pack.text(reference.names[3]), "head");
  EXPECT_EQ(reference.parents[3], 2u);
  EXPECT_EQ(reference.rest_hashes[2], documented_rest_hash(person()[2]));
  ASSERT_EQ(bind_clips(pack, 0, character, 0), Status::ok);
  const Clip clip = pack.clip(pack.find_clip("walk", 0));
  EXPECT_EQ(clip.joint_count, 4u);
  const Skeleton skeleton = character.skeleton(0);
  std::vector<SoaTransform> local(skeleton.soa_size());
  ASSERT_EQ(sample(skeleton, clip, 0, local), Status::ok);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(local[0].translation[axis][3], static_cast<float>(axis + 1));
  EXPECT_EQ(local[0].rotation[0][2], 0.6f) << "the character's own rest pose";
  EXPECT_EQ(local[0].scale[0][3], 2.0f);
}

TEST(ClipPack, WhatStandsAboveTheRootsDoesNotMatter) {
  EXPECT_EQ(fit(person(), person()).status, Status::ok);
  AlignedBlock moved = character_of(person());
  File file;
  ASSERT_EQ(load(moved, file), Status::ok);
  const std::uint64_t before = skeleton_hash(file, 0);
  const std::size_t root = file.sections()[0].offset + 16;
  const float two = 2;
  std::memcpy(moved.data() + root, &two, 4);
  EXPECT_EQ(skeleton_hash(file, 0), before);
}

TEST(ClipPack, SaysWhichJointDoesNotFitAndHow) {
  std::vector<HandJoint> other = person();
  other[1].name = "tail";
  EXPECT_EQ(fit(person(), other).status, Status::mismatch);
  EXPECT_EQ(fit(person(), other).misfits, (Misfits{{Misfit::missing, "leg"}, {Misfit::extra, "tail"}}));

  other = person();
  other[3].parent = 1;
  EXPECT_EQ(fit(person(), other).misfits, (Misfits{{Misfit::other_parent, "head"}}));

  other = person();
  other[2].rest[1] = 0.5f + 0x1p-24f;  // the next float
  EXPECT_EQ(fit(person(), other).misfits, (Misfits{{Misfit::other_rest, "spine"}}));

  other = person();
  other.pop_back();
  EXPECT_EQ(fit(person(), other).misfits, (Misfits{{Misfit::missing, "head"}}));
  EXPECT_EQ(fit(other, person()).misfits, (Misfits{{Misfit::extra, "head"}}));

  other = {person()[0], person()[2], person()[1], person()[3]};
  other[3].parent = 1;
  EXPECT_EQ(fit(person(), other).misfits, (Misfits{{Misfit::other_place, "leg"}, {Misfit::other_place, "spine"}}));

  other = {person()[0]};
  EXPECT_EQ(fit(person(), other).misfits,
            (Misfits{{Misfit::missing, "leg"}, {Misfit::missing, "spine"}, {Misfit::missing, "head"}}));
}

TEST(ClipPack, MisfitsAreCutToTheRoomForThem) {
  const AlignedBlock pack_block = pack_of(person()), character_block = character_of({person()[0]});
  File pack, character;
  ASSERT_EQ(load(pack_block, pack), Status::ok);
  ASSERT_EQ(load(character_block, character), Status::ok);
  std::vector<JointMisfit> two(2);
  std::size_t count = 0;
  EXPECT_EQ(bind_clips(pack, 0, character, 0, two, &count), Status::mismatch);
  EXPECT_EQ(count, 3u);
  EXPECT_EQ(two[1].joint, 2u);
}

TEST(ClipPack, BadCallsAreRefused) {
  const AlignedBlock pack_block = pack_of(person()), character_block = character_of(person());
  File pack, character;
  ASSERT_EQ(load(pack_block, pack), Status::ok);
  ASSERT_EQ(load(character_block, character), Status::ok);
  EXPECT_EQ(bind_clips(pack, 1, character, 0), Status::bad_argument);
  EXPECT_EQ(bind_clips(pack, 0, character, 1), Status::bad_argument);
  EXPECT_EQ(bind_clips(character, 0, character, 0), Status::bad_argument);
  EXPECT_EQ(bind_clips(pack, 0, pack, 0), Status::bad_argument);
}

TEST(ClipPack, SamplingTheWrongSkeletonIsRefusedOrHarmless) {
  const AlignedBlock pack_block = pack_of(person(), 3), short_block = character_of({person()[0], person()[1]});
  File pack, character;
  ASSERT_EQ(load(pack_block, pack), Status::ok);
  ASSERT_EQ(load(short_block, character), Status::ok);
  std::vector<SoaTransform> local(1);
  EXPECT_EQ(sample(character.skeleton(0), pack.clip(0), 0, local), Status::bad_argument);
}

TEST(ClipPack, SkeletonsAndReferencesDoNotMix) {
  HandFile both;
  both.skeleton(person());
  both.reference(person());
  const AlignedBlock block = both.finish();
  File file;
  DataError error;
  EXPECT_EQ(load(block, file, &error), Status::bad_data);
  EXPECT_STREQ(error.rule, "skeletons or references, not both");
}

TEST(ClipPack, ClipsNameAReferenceThatIsThere) {
  for (const std::uint32_t skeleton : {1u, 2u, 0xFFFFFFFFu}) {
    HandFile pack;
    pack.reference(person());
    pack.clip(skeleton, 0);
    const AlignedBlock block = pack.finish();
    File file;
    EXPECT_EQ(load(block, file), Status::bad_data) << skeleton;
  }
  HandFile outside;
  outside.reference(person());
  outside.clip(0, 4);
  const AlignedBlock block = outside.finish();
  File file;
  EXPECT_EQ(load(block, file), Status::bad_data) << "a track behind the last joint";
}

}  // namespace
}  // namespace marrow
