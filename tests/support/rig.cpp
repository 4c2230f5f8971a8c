#include "support/rig.h"

#include <algorithm>

namespace marrow::test {
namespace {

void put(SoaTransform& out, std::size_t lane, const TestJoint& j) {
  for (std::size_t i = 0; i < 3; ++i) out.translation[i][lane] = static_cast<float>(j.translation[i]);
  for (std::size_t i = 0; i < 4; ++i) out.rotation[i][lane] = static_cast<float>(j.rotation[i]);
  for (std::size_t i = 0; i < 3; ++i) out.scale[i][lane] = static_cast<float>(j.scale[i]);
}

// One block: `width` rows of four lanes.
using Rows = std::vector<double>;
void add_block(std::vector<float>& out, const Rows (&lanes)[4]) {
  for (std::size_t i = 0; i < lanes[0].size(); ++i)
    for (const Rows& lane : lanes) out.push_back(static_cast<float>(lane[i]));
}

}  // namespace

TestSkeleton::TestSkeleton(const std::vector<TestJoint>& joints_, const std::vector<Map>& above_roots)
    : joints(joints_), above(above_roots), rest(soa_count(joints_.size())), names(joints_.size(), 0) {
  for (std::size_t i = 0; i < rest.size() * 4; ++i)
    put(rest[i / 4], i % 4, i < joints.size() ? joints[i] : TestJoint{});
  for (const TestJoint& j : joints) parents.push_back(j.parent < 0 ? kNoJoint : static_cast<std::uint16_t>(j.parent));
  above.resize(static_cast<std::size_t>(std::count(parents.begin(), parents.end(), kNoJoint)));
  for (const Map& m : above) roots.push_back(to_affine(m));
}

Skeleton TestSkeleton::view() const {
  Skeleton s;
  s.name = "test";
  s.joint_count = static_cast<std::uint32_t>(joints.size());
  s.root_count = static_cast<std::uint32_t>(roots.size());
  s.model_from_root = roots.data();
  s.rest = rest.data();
  s.parents = parents.data();
  s.names = names.data();
  return s;
}

void TestClip::add(std::uint16_t joint, TrackPath path, Interpolation interpolation, const std::vector<float>& times_s,
                   const std::vector<float>& values_) {
  tracks.push_back({joint, path, interpolation, static_cast<std::uint32_t>(times_s.size()),
                    static_cast<std::uint32_t>(times.size()), static_cast<std::uint32_t>(values.size())});
  times.insert(times.end(), times_s.begin(), times_s.end());
  values.insert(values.end(), values_.begin(), values_.end());
  duration_s = std::max(duration_s, times_s.back());
}

Clip TestClip::view() const {
  Clip c;
  c.name = "test";
  c.duration_s = duration_s;
  c.tracks = tracks;
  c.times_s = times.data();
  c.values = values.data();
  return c;
}

TestMesh::TestMesh(const std::vector<TestRun>& runs_, const std::vector<Map>& inverse_bind_, bool residuals)
    : source(runs_), bind_inverse(inverse_bind_) {
  for (const TestRun& run : source) {
    first_slot.push_back(slot_count);
    runs.push_back({static_cast<std::uint32_t>(run.vertices.size()), static_cast<std::uint32_t>(run.set.size())});
    sets.insert(sets.end(), run.set.begin(), run.set.end());
    for (std::size_t first = 0; first < run.vertices.size(); first += 4) {
      Rows skin_rows[4], normal_rows[4], tangent_rows[4], residual_rows[4];
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const TestVertex& v = run.vertices[std::min(first + lane, run.vertices.size() - 1)];
        skin_rows[lane].assign(v.position.begin(), v.position.end());
        skin_rows[lane].insert(skin_rows[lane].end(), v.weights.begin(), v.weights.end() - 1);
        normal_rows[lane].assign(v.normal.begin(), v.normal.end());
        tangent_rows[lane] = {v.tangent[0], v.tangent[1], v.tangent[2], v.sign};
        for (const auto& d : v.residual) residual_rows[lane].insert(residual_rows[lane].end(), d.begin(), d.end());
      }
      add_block(skin, skin_rows);
      add_block(normals, normal_rows);
      add_block(tangents, tangent_rows);
      if (residuals) add_block(residual, residual_rows);
      slot_count += 4;
    }
    vertex_count += static_cast<std::uint32_t>(run.vertices.size());
  }
  for (std::size_t i = 0; i < bind_inverse.size(); ++i) {
    inverse_bind.push_back(to_affine(bind_inverse[i]));
    joints.push_back(static_cast<std::uint16_t>(i));
  }
}

Mesh TestMesh::view() const {
  Mesh m;
  m.name = "test";
  m.joint_count = static_cast<std::uint32_t>(joints.size());
  m.joints = joints.data();
  m.inverse_bind = inverse_bind.data();
  Geometry& g = m.geometry;
  g.slot_count = slot_count;
  g.vertex_count = vertex_count;
  g.joint_count = m.joint_count;
  g.runs = runs;
  g.sets = sets.data();
  g.skin = skin.data();
  g.normals = normals.data();
  g.tangents = tangents.data();
  g.as_residual = residual.empty() ? nullptr : residual.data();
  return m;
}

Affine to_affine(const Map& m) {
  Affine a;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) a.rows[r][c] = static_cast<float>(m.rows[r][c]);
  return a;
}

Map to_map(const Affine& a) {
  Map m;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) m.rows[r][c] = static_cast<double>(a.rows[r][c]);
  return m;
}

TestJoint joint_of(const SoaTransform* pose, std::size_t joint) {
  const SoaTransform& soa = pose[joint / 4];
  const std::size_t lane = joint % 4;
  TestJoint j;
  for (std::size_t i = 0; i < 3; ++i) j.translation[i] = static_cast<double>(soa.translation[i][lane]);
  for (std::size_t i = 0; i < 4; ++i) j.rotation[i] = static_cast<double>(soa.rotation[i][lane]);
  for (std::size_t i = 0; i < 3; ++i) j.scale[i] = static_cast<double>(soa.scale[i][lane]);
  return j;
}

Quat Random::rotation() {
  Quat q{};
  for (double& c : q) c = between(-1, 1);
  q[3] += q[3] < 0 ? -0.01 : 0.01;  // never zero
  return normalised(q);
}

Mesh with_box(const TestMesh& source) {
  Mesh mesh = source.view();
  std::fill_n(mesh.geometry.box_min, 3, 1e30f);
  std::fill_n(mesh.geometry.box_max, 3, -1e30f);
  for (const TestRun& run : source.source) {
    for (const TestVertex& v : run.vertices) {
      for (std::size_t c = 0; c < 3; ++c) {
        mesh.geometry.box_min[c] = std::min(mesh.geometry.box_min[c], static_cast<float>(v.position[c]));
        mesh.geometry.box_max[c] = std::max(mesh.geometry.box_max[c], static_cast<float>(v.position[c]));
      }
    }
  }
  return mesh;
}

}  // namespace marrow::test
