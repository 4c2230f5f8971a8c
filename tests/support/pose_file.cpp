#include "support/pose_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "asset/format.h"
#include "marrow/example_space.h"
#include "marrow/limits.h"
#include "support/aligned.h"

namespace marrow::test {
namespace {

// Not a gtest assertion: the fuzz target uses this file too.
void require(bool ok) {
  if (!ok) std::abort();
}

std::uint64_t hash_text(std::uint64_t state, const char* text) {
  return hash(state, text, std::strlen(text));
}

template <class T>
std::uint64_t hash_all(std::uint64_t state, const std::vector<T>& v) {
  return hash(state, v.data(), v.size() * sizeof(T));
}

std::uint64_t hash_geometry(std::uint64_t state, const Geometry& g) {
  for (std::uint32_t i = 0; i < g.index_count; ++i) {
    const std::uint32_t slot = g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                                                  : static_cast<const std::uint32_t*>(g.indices)[i];
    require(slot < g.slot_count);
  }
  for (const std::uint32_t slot : g.source_slots) require(slot < g.slot_count || slot == kNoSlot);
  if (g.uvs != nullptr) state = hash(state, g.uvs, g.slot_count * std::size_t{8});
  if (g.colours != nullptr) state = hash(state, g.colours, g.slot_count * std::size_t{4});
  return state;
}

// An additive clip is laid on the rest pose; neither kind is taken for the other.
void sample_either(const Skeleton& skeleton, const Clip& clip, float time_s, std::vector<SoaTransform>& local) {
  std::vector<AdditiveTransform> change(local.size());
  require(sample(skeleton, clip, time_s, local) == (clip.additive ? Status::bad_argument : Status::ok));
  require(sample_additive(skeleton, clip, time_s, change) == (clip.additive ? Status::ok : Status::bad_argument));
  if (clip.additive) require(add(skeleton, {change, 1.0f, {}}, local) == Status::ok);
}

std::uint64_t hash_channels(std::uint64_t state, const File& file, const Clip& clip) {
  std::vector<float> values(clip.channels.size);
  for (const Channel& channel : clip.channels) {
    state = hash(hash_text(state, file.text(channel.name)), &channel.rest, sizeof channel.rest);
    require(file.find_channel(clip, file.text(channel.name)) < clip.channels.size);
  }
  for (const float part : {0.0f, 0.4f, 1.0f}) {
    require(sample_channels(clip, part * clip.duration_s, values) == Status::ok);
    state = hash_all(state, values);
  }
  return state;
}

// The mesh's vertices morphed as the clip says, in memory that lives as long as this. A damaged file's weights may
// overflow: then they are refused, and nothing moves.
struct Morphed {
  Morphed(const File& file, const Mesh& mesh, const Clip* clip, float time_s, const std::vector<float>& cycle)
      : block(morphed_bytes(mesh.geometry)), weights(mesh.targets.size) {
    std::vector<std::uint32_t> channels(mesh.targets.size, kNoChannel);
    std::vector<float> values(clip != nullptr ? clip->channels.size : 0);
    if (clip != nullptr) {
      require(find_weight_channels(file, mesh, file, *clip, channels) == Status::ok);
      require(sample_channels(*clip, time_s, values) == Status::ok);
    }
    require(morph_weights(mesh, channels, values, weights) == Status::ok);
    for (std::size_t t = 0; t < weights.size() && !cycle.empty(); ++t) weights[t] = cycle[t % cycle.size()];
    require(make_morphed(mesh.geometry, {block.data(), block.size()}, morphed) == Status::ok);
    bool finite = true;
    for (const float w : weights) finite = finite && w - w == 0.0f;
    require(morph(weights, morphed) == (finite ? Status::ok : Status::bad_argument));
  }
  AlignedBlock block;
  std::vector<float> weights;
  MorphedGeometry morphed;
};
// Clips are played on what they are for, as far as a pack says what that is.
std::uint64_t hash_reference(std::uint64_t state, const File& pack, std::uint32_t index) {
  const SkeletonReference reference = pack.reference(index);
  state = hash_text(hash(state, &reference.hash, sizeof reference.hash), reference.name);
  for (std::uint32_t j = 0; j < reference.joint_count; ++j) state = hash_text(state, pack.text(reference.names[j]));
  constexpr SoaTransform kIdentity = {{}, {{}, {}, {}, {1, 1, 1, 1}}, {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};
  const std::vector<SoaTransform> rest(soa_count(reference.joint_count), kIdentity);
  Skeleton skeleton;
  skeleton.joint_count = reference.joint_count;
  skeleton.rest = rest.data();
  skeleton.parents = reference.parents;
  std::vector<SoaTransform> local(rest.size());
  for (std::uint32_t c = 0; c < pack.clip_count(); ++c) {
    const Clip clip = pack.clip(c);
    require(clip.skeleton < pack.reference_count());
    if (clip.skeleton != index) continue;
    for (const float part : {0.0f, 0.4f, 1.0f}) {
      sample_either(skeleton, clip, part * clip.duration_s, local);
      state = hash_all(state, local);
    }
  }
  return state;
}

// Whatever the file says, they can be had.
void require_tangents(const Mesh& mesh, const std::vector<float>& coordinates) {
  if (mesh.geometry.normals == nullptr) return;
  std::vector<float> tangents(as_tangent_count(mesh.geometry));
  const AsPart part{&mesh, coordinates, tangents};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  require(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}) == Status::ok);
}

}  // namespace

void forge_checksum(std::byte* block, std::size_t size) {
  if (size < sizeof(format::Header)) return;
  const std::uint64_t sum = format::checksum(block + sizeof(format::Header), size - sizeof(format::Header));
  std::memcpy(block + offsetof(format::Header, checksum), &sum, sizeof sum);
}

std::uint64_t hash(std::uint64_t state, const void* data, std::size_t bytes) {
  const auto* p = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < bytes; ++i) state = (state ^ p[i]) * 1099511628211u;
  return state;
}

PosedMesh pose_mesh(const File& file, std::uint32_t clip_index, float time_s, std::uint32_t mesh_index,
                    Deformer deformer, const std::vector<float>& cycle) {
  Mesh mesh = file.mesh(mesh_index);
  const Skeleton skeleton = file.skeleton(mesh.skeleton);
  if (clip_index < file.clip_count() && file.clip(clip_index).skeleton != mesh.skeleton)
    clip_index = file.find_clip(file.clip(clip_index).name, mesh.skeleton);
  const Clip clip = clip_index < file.clip_count() ? file.clip(clip_index) : Clip{};
  Morphed m(file, mesh, clip_index < file.clip_count() ? &clip : nullptr, time_s, cycle);
  std::vector<SoaTransform> local(skeleton.rest, skeleton.rest + skeleton.soa_size());
  if (clip_index < file.clip_count()) sample_either(skeleton, file.clip(clip_index), time_s, local);
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.palette_size());
  require(local_to_model(skeleton, local, model) == Status::ok);
  require(build_palette(mesh, model, palette) == Status::ok);
  PosedMesh out;
  const std::size_t slots = mesh.geometry.slot_count;
  out.positions.resize(slots * 3);
  if (mesh.geometry.normals != nullptr) out.normals.resize(slots * 3);
  if (mesh.geometry.normals != nullptr && mesh.geometry.tangents != nullptr) out.tangents.resize(slots * 4);
  mesh.geometry = m.morphed.geometry;
  const SkinOutput output{out.positions, out.normals, out.tangents};
  Status status = Status::ok;
  if (deformer == Deformer::as) {
    std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
    require(as_coordinates(m.morphed.bind, coordinates) == Status::ok);
    require_tangents(mesh, coordinates);
    require(morph_coordinates(m.morphed, coordinates) == Status::ok);
    status = skin_as(mesh, coordinates, palette, output);
  } else {
    status = deformer == Deformer::ssd ? skin_ssd(mesh, palette, output) : skin_rigid(mesh, palette, output);
  }
  require(status == Status::ok);
  return out;
}

// Every name and every byte that materials and images lead to.
std::uint64_t hash_looks(std::uint64_t state, const File& file) {
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
    require(file.mesh(m).material_index == kNoMaterial || file.mesh(m).material_index < file.material_count());
  for (std::uint32_t m = 0; m < file.material_count(); ++m) {
    const Material material = file.material(m);
    state = hash_text(state, material.name);
    for (const Texture& t : material.textures) state = hash_text(state, file.image(t.image).name);
  }
  for (std::uint32_t i = 0; i < file.image_count(); ++i) {
    const Image image = file.image(i);
    state = hash_text(hash_text(state, image.name), image.uri);
    for (const std::byte b : image.bytes) state = state * 31 + std::to_integer<std::uint64_t>(b);
  }
  return state;
}

std::uint64_t hash_nodes(std::uint64_t state, const File& file) {
  for (std::uint32_t n = 0; n < file.node_count(); ++n) {
    const Node node = file.node(n);
    state = hash_text(state, node.name);
    require(file.find_node(node.name) <= n);
    if (node.joint != kNoJoint) state = hash_text(state, file.text(file.skeleton(node.skeleton).names[node.joint]));
    require(std::isfinite(node.joint_from_node->rows[2][3]));
    for (const Property& p : node.properties) {
      state = hash_text(state, file.text(p.name));
      require(file.node_property(node, file.text(p.name)) != nullptr);
      if (p.type == PropertyType::text) state = hash_text(state, file.text(p.text));
    }
  }
  return state;
}

// Spaces of example shapes: refused, or evaluated.
std::uint64_t hash_examples(std::uint64_t state, const File& file) {
  for (std::uint32_t i = 0; i < file.example_space_count(); ++i) {
    ExampleSpace space;
    DataError error;
    if (file.example_space(i, space, &error) != Status::ok) {
      require(error.status != Status::ok && error.rule[0] != 0);
      continue;
    }
    state = hash_text(state, space.name);
    std::vector<std::uint32_t> channels(space.parameters.size);
    for (std::uint32_t c = 0; c < file.clip_count(); ++c)
      require(find_example_channels(file, space, file, file.clip(c), channels) == Status::ok);
    std::vector<float> parameters;
    for (const ExampleParameter& p : space.parameters) parameters.push_back(p.rest);
    for (const std::uint32_t m : space.meshes) {
      std::vector<float> weights(file.mesh(m).targets.size);
      for (int step = 0; step < 40; ++step) {
        const Status status = evaluate_examples(space, parameters, weights);
        require(status == Status::ok || status == Status::bad_data);
        state = hash_all(state, weights);
        for (std::size_t p = 0; p < parameters.size(); ++p) parameters[p] += p == 0 ? 0.0625f : -0.03125f;
      }
    }
  }
  return state;
}

// Deformers that few meshes have data for, on a palette that turns and moves every entry a little.
std::uint64_t hash_family(std::uint64_t state, const Mesh& mesh) {
  std::vector<Affine> palette(mesh.palette_size(), Affine{{{0.75f, -0.5f, 0, 1}, {0.5f, 0.75f, 0, 0}, {0, 0, 1, 2}}});
  for (std::size_t j = 0; j < palette.size(); ++j) palette[j].rows[0][1] = static_cast<float>(j % 7) / 8;
  std::vector<float> positions(mesh.geometry.slot_count * 3), distances(psd_distance_count(mesh.geometry));
  if (mesh.geometry.mwe_residual != nullptr) {
    require(skin_mwe(mesh, palette, {positions, {}, {}}) == Status::ok);
    state = hash_all(state, positions);
  }
  if (!mesh.geometry.pose_space.examples.empty()) {
    require(psd_distances(mesh.geometry, palette, distances) == Status::ok);
    require(skin_psd(mesh, distances, palette, {positions, {}, {}}) == Status::ok);
    state = hash_all(hash_all(state, distances), positions);
  }
  return state;
}

// Every level of detail, on a palette that moves every entry a little.
std::uint64_t hash_levels(std::uint64_t state, const File& file, std::uint32_t index) {
  for (std::uint32_t level = 1; level <= file.mesh(index).lods.size; ++level) {
    const Mesh mesh = file.mesh(index, level);
    state = hash_family(hash_geometry(state, mesh.geometry), mesh);
    std::vector<Affine> palette(mesh.palette_size(), Affine{{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 2}}});
    for (std::size_t j = 0; j < palette.size(); ++j) palette[j].rows[1][3] = static_cast<float>(j % 7) / 8;
    std::vector<float> positions(mesh.geometry.slot_count * 3), coordinates(as_coordinate_count(mesh.geometry));
    require(as_coordinates(mesh.geometry, coordinates) == Status::ok);
    require(skin_ssd(mesh, palette, {positions, {}, {}}) == Status::ok);
    state = hash_all(state, positions);
    require(skin_as(mesh, coordinates, palette, {positions, {}, {}}) == Status::ok);
    state = hash_all(state, positions);
    for (const MeshTarget& target : mesh.targets) state = hash_text(state, file.text(target.name));
  }
  return state;
}

// What the file says that a mesh reaches, and what its rest pose does.
std::uint64_t hash_bounds(std::uint64_t state, const File& file, std::uint32_t index) {
  const Mesh mesh = file.mesh(index);
  AlignedBlock block(extents_bytes(mesh));
  MeshExtents extents;
  require(make_extents(mesh, {block.data(), block.size()}, extents) == Status::ok);
  const std::vector<Affine> palette(mesh.palette_size(), Affine{{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 2}}});
  Bounds bounds;
  require(palette_bounds(extents, palette, {}, bounds) == Status::ok);
  state = hash(state, &bounds, sizeof bounds);
  for (std::uint32_t c = 0; c <= file.clip_count(); ++c) {
    bounds = file.bounds(c, index);
    state = hash(state, &bounds, sizeof bounds);
  }
  return state;
}

// The rest pose, as far as its limits let it be.
std::uint64_t hash_limits(std::uint64_t state, const Skeleton& skeleton) {
  std::vector<SoaTransform> local(skeleton.rest, skeleton.rest + skeleton.soa_size());
  std::vector<RotationFollower> followers(skeleton.limits.size);
  require(limit_pose(skeleton.limits, local) == Status::ok);
  require(follow_pose(skeleton.limits, followers, 0.1f, local) == Status::ok);
  for (const JointLimit& limit : skeleton.limits) {
    require(limit.joint < skeleton.joint_count && find_limit(skeleton.limits, limit.joint) == &limit);
    for (auto& component : local[limit.joint / 4].rotation) component[limit.joint % 4] += 0.5f;
  }
  require(limit_pose(skeleton.limits, local) == Status::ok);
  require(follow_pose(skeleton.limits, followers, 0.1f, local) == Status::ok);
  return hash_all(state, local);
}

// A character in one piece plays every clip. A damaged file's weights may overflow: then they are refused.
void play_in_one_piece(const File& file) {
  const CharacterOptions options{.layers = 1, .level = 0, .skin = true, .animation_space = true};
  AlignedBlock shared(animations_bytes(file, file)), own(character_bytes(file, options));
  Animations animations;
  Character character;
  const Status made = make_animations(file, file, shared, animations);
  require(made == (file.reference_count() == 0 || file.clip_count() == 0 ? Status::ok : Status::mismatch));
  const Status rest = make_character(file, options, own, character);
  require(rest == Status::ok || rest == Status::bad_argument);
  if (rest != Status::ok) return;
  for (const Animation& animation : animations.all) {
    const AnimationLayer layer{&animation, 0.4f * animation.duration_s, 1};
    require(pose_character(character, {&layer, 1}) == Status::ok);
    const Status finished = finish_character(character);
    require(finished == Status::ok || finished == Status::bad_argument);
  }
}

// Whether a product along a chain may be beyond what a float holds, by the largest that its numbers can come to.
bool may_overflow(const Skeleton& skeleton, const std::vector<SoaTransform>& local, const Mesh& mesh) {
  const auto largest = [](const Affine& map) {
    double out = 0;
    for (const auto& row : map.rows)
      for (const float x : row) out = std::max(out, std::abs(static_cast<double>(x)));
    return out;
  };
  double bind = 0;
  for (std::uint32_t i = 0; i < mesh.joint_count; ++i) bind = std::max(bind, largest(mesh.inverse_bind[i]));
  std::vector<double> all(skeleton.joint_count);
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const double above = j < skeleton.root_count ? largest(skeleton.model_from_root[j]) : all[skeleton.parents[j]];
    double own = 1;
    for (int c = 0; c < 3; ++c) {
      // Rotations of CUBICSPLINE are unit; others have numbers up to 1.01 each.
      own = std::max(own, 9.0 * std::abs(static_cast<double>(local[j / 4].scale[c][j % 4])));
      own = std::max(own, std::abs(static_cast<double>(local[j / 4].translation[c][j % 4])));
    }
    all[j] = 4 * above * own;
    if (all[j] * 4 * bind > 1e38) return true;
  }
  return false;
}

bool has_finite_palettes(const File& file) {
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    const Skeleton skeleton = file.skeleton(mesh.skeleton);
    std::vector<Affine> model(skeleton.joint_count), palette(mesh.palette_size());
    for (std::uint32_t c = 0; c <= file.clip_count(); ++c) {
      if (c < file.clip_count() && file.clip(c).skeleton != mesh.skeleton) continue;
      const std::vector<SoaTransform> rest(skeleton.rest, skeleton.rest + skeleton.soa_size());
      std::vector<SoaTransform> local = rest, blended(local.size());
      if (c < file.clip_count()) sample_either(skeleton, file.clip(c), 0.4f * file.clip(c).duration_s, local);
      // As it is, with itself, and with the rest pose.
      for (int layers = 0; layers < 3; ++layers) {
        const std::vector<BlendLayer> all = {{local, 0.5f, {}},
                                             {layers == 1 ? local : rest, layers > 0 ? 0.5f : 0, {}}};
        if (layers > 0) require(blend(skeleton, all, blended) == Status::ok);
        const std::vector<SoaTransform>& pose = layers > 0 ? blended : local;
        if (may_overflow(skeleton, pose, mesh)) continue;
        require(local_to_model(skeleton, pose, model) == Status::ok);
        require(build_palette(mesh, model, palette) == Status::ok);
        for (const Affine& a : palette)
          for (const auto& row : a.rows)
            for (const float x : row)
              if (!std::isfinite(x)) return false;
      }
    }
  }
  return true;
}

// Of a rig of which all joints are alike.
std::uint64_t hash_pose_maps(std::uint64_t state, const File& file) {
  for (std::uint32_t i = 0; i < file.pose_map_count(); ++i) {
    const PoseMap map = file.pose_map(i);
    const Skeleton skeleton = file.skeleton(map.skeleton);
    require(file.find_pose_map(map.name) <= i);
    SoaTransform four{};
    for (int lane = 0; lane < 4; ++lane) {
      four.rotation[0][lane] = 0.6f;
      four.rotation[3][lane] = 0.8f;
      for (int axis = 0; axis < 3; ++axis) four.translation[axis][lane] = four.scale[axis][lane] = 1;
    }
    const std::vector<SoaTransform> rig(soa_count(map.rig_joint_count), four);
    std::vector<SoaTransform> out(skeleton.soa_size());
    const Status status = retarget_pose(map, rig, skeleton, out);
    require(status == Status::ok || status == Status::bad_argument);  // a place may be beyond what is allowed
    state = hash_all(hash_text(state, map.name), out);
  }
  return state;
}

// Each for a second, in steps of several lengths, all that a game can set being set at times.
std::uint64_t hash_graphs(std::uint64_t state, const File& file) {
  if (file.graph_count() == 0 || file.clip_count() == 0 || file.reference_count() > 0) return state;
  AlignedBlock shared(animations_bytes(file, file));
  Animations animations;
  if (make_animations(file, file, shared, animations) != Status::ok) return state;
  for (std::uint32_t i = 0; i < file.graph_count(); ++i) {
    Graph graph;
    DataError error;
    if (file.graph(i, graph, &error) != Status::ok) {
      require(error.status != Status::ok && error.rule[0] != 0);
      continue;
    }
    AlignedBlock bound(graph_binding_bytes(graph, file));
    GraphBinding binding;
    GraphMisfit misfit;
    if (bind_graph(file, graph, file, {&animations, 1}, bound, binding, &misfit) != Status::ok) {
      require(misfit.rule[0] != 0);
      continue;
    }
    const CharacterOptions options{.layers = graph.nodes[0].poses, .skin = false};
    AlignedBlock own(animator_bytes(binding, {})), posed(character_bytes(file, options));
    Animator animator;
    Character character;
    require(make_animator(binding, {}, own, animator) == Status::ok);
    require(make_character(file, options, posed, character) == Status::ok);
    for (std::uint32_t frame = 0; frame < 24; ++frame) {
      const std::uint32_t p = frame % 5;
      if (p < graph.parameters.size && frame % 3 == 0) {
        static_cast<void>(set_number(animator, p, static_cast<float>(frame) / 12));
        static_cast<void>(set_flag(animator, p, frame % 2 == 0));
        static_cast<void>(fire(animator, p));
      }
      AnimatorStep step;
      const Status status = update_animator(animator, frame == 20 ? 1e6f : 0.04f, step);
      require(status == Status::ok || status == Status::bad_data);
      if (status != Status::ok || pose_character(character, animator) != Status::ok) break;
      const Span<SoaTransform> local = character.skeletons[0].pose.local;
      state = hash_all(state, std::vector<std::byte>(animator.state.begin(), animator.state.end()));
      state = hash_all(state, std::vector<SoaTransform>(local.begin(), local.end()));
    }
  }
  return state;
}

std::uint64_t exercise(const File& file) {
  play_in_one_piece(file);
  std::uint64_t state = kHashStart;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Skeleton skeleton = file.skeleton(s);
    state = hash_text(state, skeleton.name);
    if (!skeleton.limits.empty()) state = hash_limits(state, skeleton);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) state = hash_text(state, file.text(skeleton.names[j]));
  }
  for (std::uint32_t r = 0; r < file.reference_count(); ++r) state = hash_reference(state, file, r);
  state = hash_looks(state, file);
  state = hash_nodes(state, file);
  state = hash_examples(state, file);
  state = hash_pose_maps(state, file);
  state = hash_graphs(state, file);
  require(file.find_clip("no clip has such a name") <= file.clip_count());
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) state = hash_channels(state, file, file.clip(c));
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    state = hash_text(hash_text(state, mesh.name), mesh.material);
    state = hash_family(hash_geometry(state, mesh.geometry), mesh);
    state = hash_levels(state, file, m);
    state = hash_bounds(state, file, m);
    for (const MeshTarget& target : mesh.targets)
      state = hash_text(hash_text(state, file.text(target.name)), file.text(target.channel));
    for (std::uint32_t c = 0; c <= file.clip_count(); ++c) {
      const float duration_s = c < file.clip_count() ? file.clip(c).duration_s : 0.0f;
      for (const float part : {0.0f, 0.4f, 1.0f}) {
        for (const Deformer d : {Deformer::rigid, Deformer::ssd, Deformer::as}) {
          const PosedMesh posed = pose_mesh(file, c, part * duration_s, m, d);
          state = hash_all(hash_all(hash_all(state, posed.positions), posed.normals), posed.tangents);
        }
      }
    }
  }
  return state;
}

}  // namespace marrow::test
