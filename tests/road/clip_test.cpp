// Compressed clips keep their promise: every clip of every model, in model space through the whole hierarchy, against
// the source curves by the glTF specification, with the runtime's own decoder, at frames and the quarters between.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cook/gltf/read.h"
#include "cook/scene/views.h"
#include "disk/cook_on_disk.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"
#include "road/cooked.h"
#include "road/models.h"
#include "road/reference.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// A frame, or a quarter of the way to the next, two, three.
float quarter_s(const CodedTracks& coded, std::uint32_t quarter) {
  const float at = coded.time_of(quarter / 4);
  return quarter % 4 == 0 ? at : at + (coded.time_of(quarter / 4 + 1) - at) * static_cast<float>(quarter % 4) / 4;
}

// Matrices are 32-bit floats; the cooker's own figure, which the promise is about, multiplies them in double precision.
constexpr double kFloatSlack = 0.02;
// The cooker's defaults, stated here again: 0.1 mm on a shell of 3 cm, or as much of a skeleton whose unit is not the
// metre as of a person of 2 m.
constexpr double kError = 1e-4, kShell = 0.03, kPerson = 2.0;

// Meshes are not looked at here.
cook::CookOptions without_meshes() {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  return options;
}

double shell_distance(const Map& want, const Affine& got, double shell) {
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = length(Vec3{want.rows[0][axis], want.rows[1][axis], want.rows[2][axis]});
    for (const double sign : {-1.0, 1.0}) {
      Vec3 apart;
      for (std::size_t r = 0; r < 3; ++r) {
        const double turned = (static_cast<double>(got.rows[r][axis]) - want.rows[r][axis]) * sign * shell;
        apart[r] = static_cast<double>(got.rows[r][3]) - want.rows[r][3] + (size > 0 ? turned / size : 0);
      }
      worst = std::max(worst, length(apart));
    }
  }
  return worst;
}

// Of the joints' rest positions.
double diagonal_of(const Skeleton& skeleton, Span<SoaTransform> rest, Span<Affine> scene) {
  std::copy_n(skeleton.rest, skeleton.soa_size(), rest.data);
  EXPECT_EQ(local_to_model(skeleton, rest, scene), Status::ok);
  double squared = 0;
  for (int r = 0; r < 3; ++r) {
    double low = 1e300, high = -1e300;
    for (std::size_t j = 0; j < skeleton.joint_count; ++j) {
      low = std::min(low, static_cast<double>(scene[j].rows[r][3]));
      high = std::max(high, static_cast<double>(scene[j].rows[r][3]));
    }
    squared += (high - low) * (high - low);
  }
  return std::sqrt(squared);
}

// A model's clips compressed, once for all tests.
const cook::BuiltScene& built_once(const std::string& path) {
  static std::map<std::string, cook::BuiltScene> all;
  const auto found = all.find(path);
  if (found != all.end()) return found->second;
  cook::Notes notes;
  return all.emplace(path, cook::build_scene(cook::read_gltf(path), without_meshes(), notes)).first->second;
}

// For each clip the animation that it is of: one becomes a clip a skeleton, in ascending order.
std::vector<std::size_t> animations_of(const cook::BuiltScene& built, const Source& source) {
  std::vector<std::size_t> moving, out;
  for (std::size_t a = 0; a < source.animations.size(); ++a)
    if (!source.animations[a].channels.empty() || !source.animations[a].weights.empty()) moving.push_back(a);
  std::size_t next = 0;
  for (std::size_t c = 0; c < built.clips.size(); ++c) {
    const bool same = c > 0 && built.clips[c].name == built.clips[c - 1].name &&
                      built.clips[c].skeleton > built.clips[c - 1].skeleton;
    if (!same) ++next;
    out.push_back(moving.at(next - 1));
  }
  EXPECT_EQ(next, moving.size());
  return out;
}

// Of the largest skeleton that a clip moves, the unit that the promise is in.
double scale_of(const cook::BuiltScene& built) {
  double largest = 0;
  for (const cook::BuiltClip& clip : built.clips) {
    const Skeleton skeleton = cook::view(built.skeletons[clip.skeleton]);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> scene(skeleton.joint_count);
    largest = std::max(largest, diagonal_of(skeleton, local, scene));
  }
  return largest > 0 && (largest < 0.2 || largest > 20) ? largest / kPerson : 1.0;
}

class Clips : public ::testing::TestWithParam<std::string> {};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uintmax_t kMostBytes = 500'000;  // for memory errors, which small models show as well
#else
constexpr std::uintmax_t kMostBytes = UINTMAX_MAX;
#endif

TEST_P(Clips, KeepTheirPromise) {
  if (std::filesystem::file_size(GetParam()) > kMostBytes) GTEST_SKIP() << "thinned under sanitizers";
  const cook::BuiltScene& built = built_once(GetParam());
  const Reference reference(GetParam());
  const std::vector<std::size_t> animations = animations_of(built, reference.source());
  const double scale = scale_of(built);
  double worst = 0;
  std::size_t coded = 0, bytes = 0, compared = 0;
  for (std::size_t c = 0; c < built.clips.size(); ++c) {
    const cook::BuiltSkeleton& joints = built.skeletons[built.clips[c].skeleton];
    const Skeleton skeleton = cook::view(joints);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> scene(skeleton.joint_count);
    const Clip clip = cook::view(built.clips[c], skeleton);
    if (clip.coded.frame_count == 0) continue;
    ++coded;
    bytes += built.clips[c].coded.payload.size();
    const std::uint32_t moments = 4 * (clip.coded.frame_count - 1);
    const std::uint32_t stride = moments > 2000 ? 7 : 1;
    for (std::uint32_t e = 0; e <= moments; e += stride) {
      const float time_s = quarter_s(clip.coded, e);
      ASSERT_EQ(sample(skeleton, clip, time_s, local), Status::ok);
      ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
      const std::vector<Map> want = reference.nodes_at(animations[c], static_cast<double>(time_s));
      for (std::size_t j = 0; j < skeleton.joint_count; ++j, ++compared) {
        const Map& source = want[static_cast<std::size_t>(joints.node_of_joint[j])];
        worst = std::max(worst, shell_distance(source, scene[j], kShell * scale));
      }
    }
  }
  std::printf("%-28s %3zu of %3zu clips coded %8zu B  %8zu joints compared  worst %.4f of the promise\n",
              std::filesystem::path(GetParam()).stem().c_str(), coded, built.clips.size(), bytes, compared,
              coded > 0 ? worst / (kError * scale) : 0.0);
  EXPECT_LE(worst, kError * scale * (1 + kFloatSlack));
  EXPECT_EQ(compared == 0, coded == 0);
  if (std::filesystem::path(GetParam()).stem() == "dance") {
    EXPECT_EQ(coded, 1u) << "at least one, so that this test tests";
  }
}

// Vertices are where the specification has them, at any time of a clip: nobody watches joints.
TEST_P(Clips, KeepTheirPromiseAtTheVertices) {
  if (std::filesystem::file_size(GetParam()) > kMostBytes) GTEST_SKIP() << "thinned under sanitizers";
  const Cooked cooked(GetParam(), without_meshes());
  const Reference reference(GetParam());
  const std::vector<std::size_t> animations = animations_of(built_once(GetParam()), reference.source());
  const double scale = scale_of(built_once(GetParam()));
  const double noise = 2e-6 * reference.diagonal();  // of 32-bit floats, as road_test.cpp has it
  std::mt19937 random(11);
  double worst = 0, stated = 0;
  std::size_t compared = 0;
  for (std::uint32_t c = 0; c < cooked.file().clip_count(); c = next_animation(cooked.file(), c)) {
    stated = std::max(stated, cooked.report()["clips"][c]["max_vertex_error_m"].get<double>());
    for (int i = 0; i < (in_long_form() ? 40 : 6); ++i) {
      const auto time_s = static_cast<float>(static_cast<double>(random()) / 4294967296.0 *
                                             static_cast<double>(cooked.file().clip(c).duration_s));
      const ReferencePose want = reference.at(animations[c], static_cast<double>(time_s));
      const CookedPose got = cooked.pose(c, time_s, Deformer::ssd);
      for (std::size_t v = 0; v < want.positions.size(); ++v) {
        if (!got.used[v] || !reference.comparable(v)) continue;
        worst = std::max(worst, length(minus(got.positions[v], want.positions[v])));
        ++compared;
      }
    }
  }
  std::printf("%-28s %8zu vertices compared  worst %.4f of the promise, %.4f stated\n",
              std::filesystem::path(GetParam()).stem().c_str(), compared, worst / (kError * scale),
              stated / (kError * scale));
  EXPECT_LE(stated, kError * scale);
  EXPECT_LE(worst, 1.1 * std::max(stated, kError * scale) + noise);
}

// A set of joints, and a pose that already holds what stays: the same bits as of the whole pose.
TEST_P(Clips, InPartsAreTheSame) {
  if (std::filesystem::file_size(GetParam()) > kMostBytes) GTEST_SKIP() << "thinned under sanitizers";
  const cook::BuiltScene& built = built_once(GetParam());
  const auto lane = [](const SoaTransform& t, std::size_t n) {
    std::vector<std::uint32_t> bits(10);
    for (std::size_t i = 0; i < 10; ++i) std::memcpy(&bits[i], reinterpret_cast<const float*>(&t) + 4 * i + n, 4);
    return bits;
  };
  std::mt19937 random(7);
  std::size_t compared = 0, joints_of_clips = 0;
  for (const cook::BuiltClip& one : built.clips) {
    const Skeleton skeleton = cook::view(built.skeletons[one.skeleton]);
    std::vector<SoaTransform> whole(skeleton.soa_size()), kept(skeleton.soa_size()), part(skeleton.soa_size());
    joints_of_clips += skeleton.joint_count;
    const Clip clip = cook::view(one, skeleton);
    std::vector<SoaTransform> frames(sample_cache_bytes(clip) / sizeof(SoaTransform));
    SampleCache cache = {{reinterpret_cast<std::byte*>(frames.data()), frames.size() * sizeof(SoaTransform)}};
    for (int i = 0; i < 5; ++i) {
      const float time_s = clip.duration_s * static_cast<float>(i) / 4;
      ASSERT_EQ(sample(skeleton, clip, time_s, whole), Status::ok);
      ASSERT_EQ(sample_cached(skeleton, clip, time_s, kept, cache), Status::ok);
      std::vector<std::uint32_t> joints((skeleton.joint_count + 31) / 32);
      for (std::uint32_t& word : joints) word = static_cast<std::uint32_t>(random() & (i % 2 == 0 ? random() : ~0U));
      const SoaTransform marker = {{{7, 7, 7, 7}}, {{5, 5, 5, 5}}, {{3, 3, 3, 3}}};
      std::fill(part.begin(), part.end(), marker);
      ASSERT_EQ(sample(skeleton, clip, time_s, part, {.joints = joints}), Status::ok);
      for (std::size_t j = 0; j < skeleton.joint_count; ++j, ++compared) {
        const bool asked = (joints[j / 32] >> (j % 32) & 1U) != 0;
        EXPECT_EQ(lane(kept[j / 4], j % 4), lane(whole[j / 4], j % 4)) << clip.name << " joint " << j;
        EXPECT_EQ(lane(part[j / 4], j % 4), lane(asked ? whole[j / 4] : marker, j % 4)) << clip.name << " joint " << j;
      }
    }
  }
  EXPECT_EQ(compared, 5 * joints_of_clips);
}

TEST(ClipPromise, IsOverriddenByJoint) {
  const std::string path = in_golden("dance.gltf");
  cook::Notes notes;
  constexpr double kLoose = 1e-3, kStrict = 2e-5;
  cook::CookOptions options = without_meshes();
  options.clips.error.push_back({"", kLoose, false});
  options.clips.error.push_back({"j*3", kStrict, false});
  const cook::BuiltScene built = cook::build_scene(cook::read_gltf(path), options, notes);
  const Reference reference(path);
  const cook::BuiltSkeleton& joints = built.skeletons.at(0);
  const Skeleton skeleton = cook::view(joints);
  const Clip clip = cook::view(built.clips.at(0), skeleton);
  ASSERT_GT(clip.coded.frame_count, 1u);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> scene(skeleton.joint_count);
  double worst_there = 0, worst = 0;
  for (std::uint32_t e = 0; e <= 4 * (clip.coded.frame_count - 1); ++e) {
    const float time_s = quarter_s(clip.coded, e);
    ASSERT_EQ(sample(skeleton, clip, time_s, local), Status::ok);
    ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
    const std::vector<Map> want = reference.nodes_at(0, static_cast<double>(time_s));
    for (std::size_t j = 0; j < skeleton.joint_count; ++j) {
      const Map& source = want[static_cast<std::size_t>(joints.node_of_joint[j])];
      const double error = shell_distance(source, scene[j], kShell);
      worst = std::max(worst, error);
      if (joints.joint_names[j] == "joint3") worst_there = std::max(worst_there, error);
    }
  }
  EXPECT_GT(worst_there, 0);
  EXPECT_LE(worst_there, kStrict * (1 + kFloatSlack));
  EXPECT_LE(worst, kLoose * (1 + kFloatSlack));
  EXPECT_GT(worst, 5 * kStrict) << "the others are not held to it";
}

INSTANTIATE_TEST_SUITE_P(Models, Clips, ::testing::ValuesIn(models()), [](const auto& model) {
  std::string name = std::filesystem::path(model.param).stem().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name + "_" + std::to_string(model.index);
});

}  // namespace
}  // namespace marrow::test
