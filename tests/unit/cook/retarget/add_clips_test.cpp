// Clips of other files in a cooked file, the whole way: the sample character's own clips, put onto itself.
#include "cook/retarget/add_clips.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "disk/files.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

CookOptions plain(const std::string& more = "") {
  return options_of("--mesh-codec none --images none --clip-codec raw" + more);
}

std::vector<std::string> clip_names(const File& file) {
  std::vector<std::string> out;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) out.emplace_back(file.clip(c).name);
  return out;
}

// How far joints are apart in two clips of a file.
double apart(const File& file, std::uint32_t a, std::uint32_t b) {
  const Skeleton skeleton = file.skeleton(file.clip(a).skeleton);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> pose(skeleton.joint_count), other(skeleton.joint_count);
  double worst = 0;
  for (int i = 0; i <= 20; ++i) {
    const float time_s = file.clip(a).duration_s * static_cast<float>(i) / 20;
    EXPECT_EQ(sample(skeleton, file.clip(a), time_s, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, pose), Status::ok);
    EXPECT_EQ(sample(skeleton, file.clip(b), time_s, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, other), Status::ok);
    for (std::size_t j = 0; j < pose.size(); ++j)
      for (const auto& [row, with] : {std::pair{pose[j].rows[0], other[j].rows[0]},
                                      {pose[j].rows[1], other[j].rows[1]},
                                      {pose[j].rows[2], other[j].rows[2]}})
        worst = std::max(worst, std::abs(double{row[3]} - double{with[3]}));
  }
  return worst;
}

std::uint32_t index_of(const File& file, const std::string& name) {
  const std::vector<std::string> names = clip_names(file);
  const auto found = std::ranges::find(names, name);
  EXPECT_NE(found, names.end()) << name;
  return static_cast<std::uint32_t>(found - names.begin());
}

TEST(AddClips, OntoItselfAClipStaysAsItIs) {
  const CookOptions options = plain(" --retarget " + test::newt_glb() + " --mirror other=walk --mirror again=other");
  const LoadedCook cooked(cook_file(test::newt_glb(), options));
  const LoadedCook before(cook_file(test::newt_glb(), plain()));
  EXPECT_EQ(cooked.file.skeleton(0).joint_count, before.file.skeleton(0).joint_count);
  EXPECT_EQ(cooked.file.clip_count(), 2 * before.file.clip_count() + 2);
  const std::uint32_t walk = index_of(cooked.file, "walk");
  const double found = apart(cooked.file, walk, index_of(cooked.file, "newt.walk"));
  std::printf("the newt's walk on itself: %.4f m apart\n", found);
  EXPECT_LE(found, 0.01);
  EXPECT_LE(apart(cooked.file, walk, index_of(cooked.file, "again")), 1e-5) << "mirrored twice";
  EXPECT_GT(apart(cooked.file, walk, index_of(cooked.file, "other")), 0.01);
}

TEST(AddClips, PacksHaveTheAddedClipsAlone) {
  CookOptions options = plain(" --clips-only --mirror other=walk --retarget " + test::newt_glb());
  std::vector<std::string> expected = clip_names(LoadedCook(cook_file(test::newt_glb(), plain())).file);
  expected.push_back("other");
  const LoadedCook own(cook_file(test::newt_glb(), options));
  EXPECT_EQ(clip_names(own.file), expected);
  EXPECT_EQ(own.file.mesh_count(), 0u);
  options.onto = std::make_shared<Character>(read_character(test::newt_glb()));
  EXPECT_EQ(clip_names(LoadedCook(cook_file(test::newt_glb(), options)).file), expected);
}

TEST(AddClips, CookedFilesAreSourcesToo) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "retarget_source.mrw";
  tools::write_file_atomically(path.string(), std::span<const std::byte>(cook_file(test::newt_glb(), plain()).file));
  CookOptions options = plain();
  options.retarget.clips = {{path.string(), "", {}}};
  const Result result = cook_file(test::newt_glb(), options);
  EXPECT_TRUE(std::ranges::any_of(
      result.reads, [&](const Read& read) { return read.name == std::filesystem::weakly_canonical(path).string(); }));
  const LoadedCook cooked(result);
  EXPECT_LE(apart(cooked.file, index_of(cooked.file, "walk"), index_of(cooked.file, "retarget_source.walk")), 0.01);
  std::filesystem::remove(path);
}

TEST(AddClips, MapsAreWrittenAndRead) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "retarget_map.toml";
  const std::string map = map_of(read_character(test::newt_glb()), read_rig(test::newt_glb()));
  std::ofstream(path) << map;
  CookOptions options = plain();
  options.retarget.clips = {{test::newt_glb(), path.string(), {}}};
  const LoadedCook cooked(cook_file(test::newt_glb(), options));
  EXPECT_LE(apart(cooked.file, index_of(cooked.file, "walk"), index_of(cooked.file, "newt.walk")), 0.01);
  std::ofstream(path) << map << "\"nobody\" = \"noone\"\n";
  try {
    cook_file(test::newt_glb(), options);
    ADD_FAILURE() << "a joint that there is not";
  } catch (const tools::Failure& failure) {
    EXPECT_EQ(failure.code(), tools::Exit::usage);
    EXPECT_EQ(failure.file(), path.string());
    EXPECT_NE(std::string(failure.what()).find("no joint \"nobody\""), std::string::npos) << failure.what();
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace marrow::cook
