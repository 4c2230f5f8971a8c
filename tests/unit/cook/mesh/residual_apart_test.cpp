// Residuals beside a codec's streams: the cooker's bits, what is guessed, and what that saves.
#include <cmath>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "cook/geometry/build_geometry.h"
#include "cook/geometry/record.h"
#include "deform/animation_space.h"
#include "deform/cylinder.h"
#include "support/ring.h"
#include "unpack/residual.h"

namespace marrow::cook {
namespace {

using test::AlignedBlock;
using test::Ring;
using test::RingVertex;

// The record's linear blend skinning, with a table beside it that is to be coded.
struct RingInWork {
  RingInWork() : record(test::ring_record()) {
    GeometryNeeds needs{};
    EXPECT_EQ(measure_geometry_record({record.data(), record.size()}, needs), nullptr);
    scratch = std::make_unique<AlignedBlock>(static_cast<std::size_t>(needs.scratch_bytes));
    Status decoded = Status::ok;
    EXPECT_EQ(decode_geometry({record.data(), record.size()}, test::kPlainDecoder[0],
                              {scratch->data(), scratch->size()}, mesh, decoded),
              nullptr);
    work.mesh = mesh.streams;
    work.table.influences = 3;
    for (const RingVertex& v : ring.vertices)
      for (std::size_t j = 0; j < 3; ++j) {
        joints.push_back(v.joints[std::min(j, v.joints.size() - 1)]);
        for (std::size_t c = 0; c < 4; ++c) rows[j].push_back(j < v.residual.size() ? v.residual[j][c] : 0);
      }
    work.table.joints = joints.data();
    for (std::size_t j = 0; j < 3; ++j) work.table.rows[j] = rows[j].data();
    memory = std::make_unique<AlignedBlock>(static_cast<std::size_t>(residual_apart_bytes(work.mesh).freed));
    Memory from{memory->data(), 0, memory->size()};
    EXPECT_EQ(begin_guess(from, work), nullptr);
    while (!work.smoothed.at_end()) EXPECT_EQ(work.smoothed.step(), nullptr);
  }
  Ring ring;
  std::vector<std::byte> record;
  std::unique_ptr<AlignedBlock> scratch, memory;
  GeometryInWork mesh{};
  ResidualInWork work;
  std::vector<std::int32_t> joints, rows[3];
};

TEST(ResidualApart, TheEncoderWritesTheBitsThatTheRuntimesTestsRead) {
  RingInWork ring;
  ASSERT_TRUE(shift_by_guess(ring.work, -1));
  SymbolEncoder encoder;
  const auto models = std::make_unique<ResidualModels>();
  ResidualCodec<SymbolEncoder> codec(ring.work.mesh, ring.work.near, ring.work.smoothed, true, ring.work.table, *models,
                                     encoder);
  for (std::uint32_t v = 0; v < ring.work.mesh.vertex_count; ++v) ASSERT_TRUE(codec.code(v)) << v;
  const std::vector<std::byte> bits = encoder.finish();
  ASSERT_EQ(bits.size(), sizeof test::kRingBits);
  for (std::size_t i = 0; i < bits.size(); ++i) ASSERT_EQ(static_cast<std::uint8_t>(bits[i]), test::kRingBits[i]) << i;
}

// The ring's guess and what deform::smoothed_ssd() makes of the same mesh in double precision, in steps.
TEST(ResidualApart, GuessesWhatSmoothingGives) {
  RingInWork ring;
  for (auto& row : ring.rows) std::fill(row.begin(), row.end(), 0);
  ASSERT_TRUE(shift_by_guess(ring.work, 1));
  deform::SkinnedMesh mesh;
  mesh.joint_count = 3;
  std::vector<std::uint32_t> place;
  for (std::size_t v = 0; v < ring.ring.vertices.size(); ++v) {
    const RingVertex& from = ring.ring.vertices[v];
    if (v % (Ring::kAround + 1) == Ring::kAround) {
      place.push_back(place[v - Ring::kAround]);
      continue;
    }
    place.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(from.position[0], from.position[1], from.position[2]);
    mesh.influences.emplace_back();
    for (std::size_t i = 0; i < from.own.size(); ++i)
      mesh.influences.back().push_back({static_cast<std::uint32_t>(from.own[i]), from.weights[i] / 15.0});
  }
  for (const int v : ring.ring.triangles) mesh.indices.push_back(place[static_cast<std::size_t>(v)]);
  const deform::Coordinates all =
      deform::smoothed_ssd(mesh, deform::Surface(mesh), static_cast<int>(Ring::kIterations), 0.5, 8);
  double farthest = 0, largest = 0;
  std::size_t compared = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    const std::vector<deform::Coordinate>& want = all[place[v]];
    std::set<int> joints;
    for (const deform::Coordinate& c : want) joints.insert(static_cast<int>(c.joint));
    const RingVertex& vertex = ring.ring.vertices[v];
    if (joints != std::set<int>(vertex.joints.begin(), vertex.joints.end())) continue;
    ++compared;
    for (std::size_t j = 0; j < want.size(); ++j) {
      double weight = 0;
      for (const deform::Influence& i : mesh.influences[place[v]])
        if (i.joint == want[j].joint) weight = i.weight;
      const glm::dvec3 d =
          (glm::dvec3(want[j].q) - mesh.positions[place[v]] * want[j].q.w) * 0.25 / double{Ring::kStep};
      const double steps[] = {d.x, d.y, d.z, (want[j].q.w - weight) / double{Ring::kStepOfW}};
      for (std::size_t c = 0; c < 4; ++c) {
        farthest = std::max(farthest, std::abs(steps[c] - ring.rows[j][v * 4 + c]));
        largest = std::max(largest, std::abs(steps[c]));
      }
    }
  }
  EXPECT_GE(compared, 14u);
  EXPECT_GT(largest, 3);
  EXPECT_LE(farthest, 1.01) << "half a step by rounding, half by what the joint before was rounded by";
}

struct CylinderSource {
  deform::SkinnedMesh mesh = deform::cylinder();
  RawPrimitive primitive;
  std::vector<Binding> linear, smoothed;
  MeshGrid grid{glm::dvec3(-8), 0x1p-10};

  CylinderSource() {
    grid.residual_step = 0x1p-10;
    grid.residual_weight_step = 0x1p-10;
    grid.residual_source = {10, 0.5, true};
    primitive.indices = mesh.indices;
    const deform::Coordinates all = deform::smoothed_ssd(mesh, deform::Surface(mesh), 10, 0.5, 4);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      primitive.positions.emplace_back(mesh.positions[v]);
      Binding &l = linear.emplace_back(), &s = smoothed.emplace_back();
      for (const deform::Influence& i : mesh.influences[v]) {
        l.set.push_back(static_cast<std::uint16_t>(i.joint));
        l.weights.push_back(i.weight);
      }
      for (const deform::Coordinate& c : all[v]) {
        double weight = 0;
        for (const deform::Influence& i : mesh.influences[v])
          if (i.joint == c.joint) weight = i.weight;
        s.set.push_back(static_cast<std::uint16_t>(c.joint));
        s.weights.push_back(weight);
        s.residual.push_back(c.q - glm::dvec4(mesh.positions[v], 1) * weight);
      }
    }
  }
};

TEST(ResidualApart, SmoothingAloneTakesHardlyMoreThanLinearBlendSkinning) {
  const CylinderSource source;
  for (const MeshCodec codec : {MeshCodec::draco, MeshCodec::meshopt}) {
    CookOptions options;
    options.mesh.codec = codec;
    MeshGrid apart = source.grid, among = source.grid;
    among.residual_source = {};
    const auto bytes = [&](const std::vector<Binding>& bindings, const MeshGrid& grid) {
      return static_cast<double>(build_geometry(source.primitive, bindings, 2, grid, options.mesh).record.size());
    };
    const double linear = bytes(source.linear, source.grid);
    EXPECT_LE(bytes(source.smoothed, apart), linear + 50);
    EXPECT_GT(bytes(source.smoothed, among), linear + 1000) << "without knowing what it comes from";
  }
}

}  // namespace
}  // namespace marrow::cook
