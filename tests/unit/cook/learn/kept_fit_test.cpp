// What meshes have learnt, kept: found again it gives the same file, and what is no fit of the mesh gives none.
#include "cook/learn/kept_fit.h"

#include <map>
#include <mutex>

#include <gtest/gtest.h>

#include "disk/disk_files.h"
#include "marrow/cook.h"
#include "support/places.h"

namespace marrow::cook {
namespace {

class KeptFits : public Fits {
 public:
  std::optional<std::string> find(const std::string& key) override {
    const auto at = entries.find(key);
    if (at == entries.end()) return std::nullopt;
    ++found;
    return at->second;
  }
  void keep(const std::string& key, const std::string& bytes) override { entries[key] = bytes; }
  std::map<std::string, std::string> entries;
  int found = 0;
};

Options fit_options(const char* clip_error = "0.1mm") {
  Options out;
  set(out, "as", "fit");
  set(out, "truth", "delta-mush");
  set(out, "clip-error", clip_error);
  return out;
}

Result cook_elbow(Fits* fits, const Options& options) {
  tools::DiskFiles files;
  return cook(test::in_golden("elbow.gltf"), options, {files, nullptr, {}, nullptr, fits});
}

TEST(KeptFit, GivesTheSameFile) {
  KeptFits fits;
  const std::vector<std::byte> want = cook_elbow(nullptr, fit_options()).file;
  EXPECT_EQ(cook_elbow(&fits, fit_options()).file, want);
  EXPECT_EQ(fits.found, 0);
  ASSERT_EQ(fits.entries.size(), 1u);
  EXPECT_EQ(cook_elbow(&fits, fit_options()).file, want);
  EXPECT_EQ(fits.found, 1);
  cook_elbow(&fits, fit_options("1mm"));
  EXPECT_EQ(fits.found, 2) << "clips' errors come later";
  Options helpers = fit_options();
  set(helpers, "helpers", "2");
  cook_elbow(&fits, helpers);
  EXPECT_EQ(fits.found, 2) << "another fit";
  EXPECT_EQ(fits.entries.size(), 2u);
}

TEST(KeptFit, IsLearntAhead) {
  KeptFits fits;
  tools::DiskFiles files;
  const std::string name = test::in_golden("elbow.gltf");
  const Host host{files, nullptr, {}, nullptr, &fits};
  EXPECT_TRUE(look(name, {}, host).fits.empty()) << "without a fit nothing is learnt";
  const Looked looked = look(name, fit_options(), host);
  ASSERT_EQ(looked.fits.size(), 1u);
  EXPECT_GT(looked.fits[0], 0u);
  ASSERT_FALSE(looked.reads.empty());
  EXPECT_EQ(looked.reads[0].name, name);
  learn_fit(name, 1, fit_options(), host);
  EXPECT_TRUE(fits.entries.empty()) << "there is no second";
  learn_fit(name, 0, fit_options(), host);
  EXPECT_EQ(fits.entries.size(), 1u);
  EXPECT_EQ(cook_elbow(&fits, fit_options()).file, cook_elbow(nullptr, fit_options()).file);
  EXPECT_EQ(fits.found, 1);
}

// Bytes of a server are hostile: each cut, each joint out of range, each number that is none.
TEST(KeptFit, WrongBytesAreNone) {
  deform::SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  mesh.joint_count = 2;
  Learnt learnt;
  learnt.coordinates = {{{0, {1, 2, 3, 1}}}, {{0, {1, 2, 3, 0.5}}, {2, {4, 5, 6, 0.5}}}};
  learnt.weights = {{{0, 1}}, {{0, 0.5}, {1, 0.5}}};
  learnt.helpers = {{0, 1, 0.5, {1, 1, 1}, true}};
  learnt.quality = {0.25, 0.125};
  learnt.rms_m = 0.5;
  const std::string bytes = to_bytes(learnt);
  const std::optional<Learnt> again = from_bytes(bytes, mesh);
  ASSERT_TRUE(again);
  EXPECT_EQ(to_bytes(*again), bytes);
  EXPECT_EQ(again->coordinates[1][1].q, glm::dvec4(4, 5, 6, 0.5));
  EXPECT_EQ(again->helpers[0].share, 0.5);
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) EXPECT_FALSE(from_bytes(bytes.substr(0, cut), mesh)) << cut;
  EXPECT_FALSE(from_bytes(bytes + '\0', mesh));
  const auto refused = [&](const std::function<void(Learnt&)>& spoil) {
    Learnt bad = learnt;
    spoil(bad);
    return !from_bytes(to_bytes(bad), mesh);
  };
  EXPECT_TRUE(refused([](Learnt& l) { l.coordinates[1][1].joint = 3; }));
  EXPECT_TRUE(refused([](Learnt& l) { l.coordinates[1][1].joint = 0; })) << "twice";
  EXPECT_TRUE(refused([](Learnt& l) { l.weights[1][1].joint = 1u << 31; }));
  EXPECT_TRUE(refused([](Learnt& l) { l.helpers[0].second = 2; }));
  EXPECT_TRUE(refused([](Learnt& l) { l.weights.pop_back(); }));
  EXPECT_TRUE(refused([](Learnt& l) { l.coordinates[0][0].q.x = NAN; }));
  EXPECT_TRUE(refused([](Learnt& l) { l.rms_m = INFINITY; }));
  int survived = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string bad = bytes;
    bad[at] = static_cast<char>(bad[at] ^ 0x40);
    survived += from_bytes(bad, mesh).has_value();
  }
  EXPECT_GT(survived, 0) << "other numbers are numbers, too";
}

}  // namespace
}  // namespace marrow::cook
