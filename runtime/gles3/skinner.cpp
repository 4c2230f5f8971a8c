// A mesh drawn as many characters, by any skinning path.
#include "marrow/gles3_skinner.h"

#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "gles3/compile.h"
#include "gles3/gl_constants.h"
#include "gles3/label.h"
#include "gles3/mesh/morph.h"
#include "gles3/mesh/pose_examples.h"
#include "gles3/mesh/prepare.h"
#include "gles3/program.h"
#include "gles3/program_set.h"
#include "gles3/skinned.h"
#include "gles3/skinner_state.h"
#include "gles3/texture.h"
#include "marrow/morph.h"
#include "marrow/palette.h"
#include "marrow/skin.h"

namespace marrow::gles3 {
namespace {

bool skins_once(SkinningPath path) {
  return path != SkinningPath::ubo && path != SkinningPath::texture;
}

PrepareOptions prepare_options(const SkinnerOptions& options) {
  const bool on_gpu = options.path != SkinningPath::cpu, as = options.deformer == Deformer::as;
  const bool psd = options.deformer == Deformer::psd;
  return {on_gpu && !as, on_gpu && as, as && on_gpu ? options.as_tangents : Span<const float>(), on_gpu && psd};
}

// A mesh without examples is skinned by SSD instead.
bool has_pose_space(const Mesh& mesh, const SkinnerOptions& options) {
  return options.deformer == Deformer::psd && !mesh.geometry.pose_space.examples.empty();
}

bool has_ring(SkinningPath path) {
  return path == SkinningPath::ubo || path == SkinningPath::feedback || path == SkinningPath::compute;
}

void lay_out_motion(Memory& memory, Skinner& s) {
  SkinnerMotion& m = state_of(s).motion;
  const std::size_t count = s.options.instances;
  m.still = memory.take<std::uint8_t>(count);
  m.reset = memory.take<std::uint8_t>(count);
  if (skins_once(s.options.path)) {
    m.skinned = memory.take<SkinnedMesh>(count);
    return;
  }
  const std::size_t weights = count * s.mesh.geometry.targets.size;
  m.weights = memory.take<float>(weights);
  m.sent_weights = memory.take<float>(weights);
  if (s.options.path == SkinningPath::ubo) m.offsets = memory.take<std::uint32_t>(count);
}

void lay_out(Memory& memory, Skinner& s, Span<std::byte>& morphed) {
  SkinnerState& own = state_of(s);
  const Geometry& g = s.mesh.geometry;
  const std::size_t count = s.options.instances;
  own.palettes = memory.take<Affine>(count * s.mesh.palette_size());
  if (has_pose_space(s.mesh, s.options))
    own.distances = memory.take<Affine>((s.options.path == SkinningPath::cpu ? 1 : count) * distance_matrices(g));
  own.bind = memory.take<Affine>(s.mesh.joint_count);
  own.weights = memory.take<float>(count * g.targets.size);
  own.offsets = memory.take<std::uint32_t>(count);
  own.scratch = memory.take<std::byte>(prepare_scratch_bytes(s.mesh, prepare_options(s.options)));
  if (skins_once(s.options.path)) s.skinned = memory.take<SkinnedMesh>(count);
  if (s.options.motion) lay_out_motion(memory, s);
  if (s.options.path != SkinningPath::cpu) return;
  const std::size_t slots = g.slot_count;
  own.positions = memory.take<float>(3 * slots);
  if (g.normals != nullptr) own.normals = memory.take<float>(3 * slots);
  if (g.normals != nullptr && g.tangents != nullptr) own.tangents = memory.take<float>(4 * slots);
  if (s.options.deformer == Deformer::as) own.coordinates = memory.take<float>(as_coordinate_count(g));
  morphed = memory.take<std::byte>(morphed_bytes(g));
}

ProgramKey drawing_key(const Skinner& s, const ProgramSet& programs, std::uint32_t role) {
  const std::uint8_t features =
      features_read(programs, role, state_of(s).gpu, s.options.deformer, s.options.features, s.options.motion);
  if (skins_once(s.options.path))
    return {Deformer::none, 4, static_cast<std::uint8_t>(features & ~(kMorphs | kSurfaceNormals)),
            Palettes::uniform_block};
  const Palettes palettes = s.options.path == SkinningPath::texture ? Palettes::texture : Palettes::uniform_block;
  return {s.options.deformer, state_of(s).gpu.influences, features, palettes};
}

// Pre-skinning fills all blocks that a SkinnedMesh has, whatever any role reads.
ProgramKey preskin_key(const Skinner& s) {
  const SkinnerState& own = state_of(s);
  int features = own.gpu.features & (kNormals | kTangents | kMorphs);
  if (s.options.deformer == Deformer::as) features |= own.gpu.features & kSurfaceNormals;
  return {s.options.deformer, own.gpu.influences, static_cast<std::uint8_t>(features), Palettes::uniform_block};
}

std::uint32_t preskin_role(SkinningPath path) {
  return pre_skinning(path == SkinningPath::compute ? Preskin::compute : Preskin::feedback);
}

Status build_programs(const Api& api, const Caps& caps, const Skinner& s, ProgramSet& programs) {
  for (std::uint32_t role = 0; role < programs.role_count; ++role) {
    const Status status = need_program(api, caps, programs, drawing_key(s, programs, role), role);
    if (status != Status::ok) return status;
  }
  if (s.options.path != SkinningPath::feedback && s.options.path != SkinningPath::compute) return Status::ok;
  return need_program(api, caps, programs, preskin_key(s), preskin_role(s.options.path));
}

// All GL objects but programs.
Status make_objects(const Api& api, const Caps& caps, Skinner& s) {
  SkinnerState& own = state_of(s);
  const SkinnerOptions& o = s.options;
  Status status = prepare(api, caps, s.mesh, prepare_options(o), own.scratch, own.bind, own.gpu);
  const std::uint32_t joints = o.instances * s.mesh.palette_size();
  if (status == Status::ok && o.path == SkinningPath::texture)
    status = create_palette_texture(api, caps, joints, own.texture);
  if (status == Status::ok && own.gpu.distances != 0)
    status = make_palette_texture(api, caps, o.instances * own.gpu.distances, "marrow: distances of poses",
                                  own.distance_texture);
  if (status == Status::ok && has_ring(o.path)) status = create_palette_ring(api, caps, joints, o.instances, own.ring);
  if (status == Status::ok && o.motion && o.path == SkinningPath::ubo)
    status = create_palette_ring(api, caps, joints, o.instances, own.motion.ring);
  for (const Span<SkinnedMesh> all : {s.skinned, own.motion.skinned})
    for (std::size_t i = 0; i < all.size && status == Status::ok; ++i)
      status = make_skinned(api, own.gpu, label_of(s.mesh), all[i]);
  return status;
}

void destroy_objects(const Api& api, Skinner& s) {
  SkinnerState& own = state_of(s);
  for (const Span<SkinnedMesh> all : {s.skinned, own.motion.skinned})
    for (SkinnedMesh& skinned : all) destroy(api, skinned);
  destroy(api, own.texture);
  destroy(api, own.distance_texture);
  destroy(api, own.motion.ring);
  destroy(api, own.ring);
  destroy(api, own.gpu);
}

Status check_device(const Caps& caps, const Mesh& mesh, const SkinnerOptions& o) {
  if (o.path == SkinningPath::compute && !caps.compute) return Status::unsupported;
  const bool in_block = o.path != SkinningPath::cpu && o.path != SkinningPath::texture;
  return in_block && mesh.palette_size() > kPaletteJoints ? Status::unsupported : Status::ok;
}

// One that was cleared has no memory, whatever its options say.
BadCall check_made(const Skinner& s) {
  MARROW_CHECK(!state_of(s).palettes.empty() && "a skinner from create_skinner(), not destroyed since");
  return {};
}

Span<Affine> palette_of(const Skinner& s, std::uint32_t instance) {
  const std::size_t size = s.mesh.palette_size();
  return {state_of(s).palettes.data + instance * size, size};
}

Span<const float> weights_of(const Skinner& s, std::uint32_t instance) {
  const std::size_t size = s.mesh.geometry.targets.size;
  return {state_of(s).weights.data + instance * size, size};
}

Status skin_on_cpu(const Api& api, Skinner& s, std::uint32_t instance) {
  SkinnerState& own = state_of(s);
  Mesh mesh = s.mesh;
  if (!own.weights.empty()) {
    const Status moved = morph(weights_of(s, instance), own.morphed);
    if (moved != Status::ok) return moved;
    if (!own.coordinates.empty()) (void)morph_coordinates(own.morphed, own.coordinates);
    mesh.geometry = own.morphed.geometry;
  }
  const SkinOutput to{own.positions, own.normals, own.tangents};
  const Span<const Affine> palette = palette_of(s, instance);
  Status status = Status::ok;
  if (!own.distances.empty()) {
    const Span<float> distances(own.distances.data->rows[0], psd_distance_count(mesh.geometry));
    status = psd_distances(mesh.geometry, palette, distances);
    if (status == Status::ok) status = skin_psd(mesh, distances, palette, to);
  } else {
    status = s.options.deformer == Deformer::as    ? skin_as(mesh, own.coordinates, palette, to, s.options.as_tangents)
             : s.options.deformer == Deformer::ssd ? skin_ssd(mesh, palette, to)
                                                   : skin_rigid(mesh, palette, to);
  }
  return status == Status::ok ? upload_skinned(api, s.skinned[instance], to) : status;
}

Status push_palettes(const Api& api, Skinner& s, std::uint32_t count) {
  SkinnerState& own = state_of(s);
  begin_frame(api, own.ring);
  Status status = Status::ok;
  for (std::uint32_t i = 0; i < count && status == Status::ok; ++i)
    status = push_palette(api, own.ring, palette_of(s, i), own.offsets[i]);
  return status;
}

Status upload_palettes(const Api& api, Skinner& s, std::uint32_t count) {
  if (count == 0) return Status::ok;
  api.ActiveTexture(kGlTexture0 + s.options.texture_unit);
  return upload_palettes(api, state_of(s).texture,
                         {state_of(s).palettes.data, std::size_t{count} * s.mesh.palette_size()});
}

Status upload_distances(const Api& api, Skinner& s, std::uint32_t count) {
  SkinnerState& own = state_of(s);
  if (count == 0 || own.gpu.distances == 0) return Status::ok;
  api.ActiveTexture(kGlTexture0 + s.options.texture_unit);
  return upload_palettes(api, own.distance_texture, {own.distances.data, std::size_t{count} * own.gpu.distances});
}

template <class T>
void swap(T& a, T& b) {
  const T was = a;
  a = b;
  b = was;
}

// What the last update() left becomes the frame before.
void take_turns(Skinner& s, std::uint32_t count) {
  SkinnerState& own = state_of(s);
  SkinnerMotion& m = own.motion;
  if (s.options.path == SkinningPath::ubo) {
    swap(own.ring, m.ring);
    swap(own.offsets, m.offsets);
  }
  swap(s.skinned, m.skinned);
  for (std::uint32_t i = 0; i < count; ++i) {
    m.still[i] = i >= s.updated || m.reset[i] != 0;
    m.reset[i] = 0;
  }
  swap(m.weights, m.sent_weights);
  for (std::size_t i = 0; i < m.sent_weights.size; ++i) m.sent_weights[i] = own.weights[i];
}

// Binds the previous frame of characters first … first + count - 1 for the program in use; all or none of them are
// still.
Status bind_motion(const Api& api, const Skinner& s, const ProgramSet& programs, const Program& program,
                   std::uint32_t first, std::uint32_t count) {
  const SkinnerState& own = state_of(s);
  const SkinnerMotion& m = own.motion;
  const bool still = m.still[first] != 0;
  if (s.options.path == SkinningPath::texture) {
    const std::uint32_t joints = s.mesh.palette_size();
    const Status status = bind_previous_palette(api, own.texture, first * joints, count * joints, !still,
                                                s.options.texture_unit + 2, program);
    if (status != Status::ok) return status;
  } else {
    bind_palette(api, still ? own.ring : m.ring, still ? own.offsets[first] : m.offsets[first],
                 programs.palette_binding + 1);
  }
  if (own.gpu.distances != 0) {
    const Status status = bind_previous_distances(api, own.gpu, own.distance_texture, first * own.gpu.distances, !still,
                                                  s.options.texture_unit + 5, program);
    if (status != Status::ok) return status;
  }
  if (m.weights.empty()) return Status::ok;
  const std::size_t targets = s.mesh.geometry.targets.size;
  const Span<const float> weights((still ? m.sent_weights : m.weights).data + first * targets, targets);
  return set_previous_morphs(api, s.mesh, own.gpu, weights, program);
}

// Whether a program fits what drawing will bind for it.
bool may_draw(const Skinner& s, const Program& program) {
  const ProgramState& at = state_of(program);
  if (skins_once(s.options.path)) return true;
  if (at.motion && !s.options.motion) return false;
  if (s.options.path == SkinningPath::texture && (at.reads != Palettes::texture || at.palettes < 0)) return false;
  return (state_of(s).weights.empty() || at.morph_changes >= 0) && (state_of(s).gpu.distances == 0 || at.examples >= 0);
}

// How many characters from `first` on one draw call draws.
std::uint32_t drawn_together(const Skinner& s, const Program& program, std::uint32_t first, std::uint32_t end) {
  if (s.options.path != SkinningPath::texture || !state_of(s).weights.empty()) return 1;
  if (!state_of(program).motion) return end - first;
  const Span<std::uint8_t> still = state_of(s).motion.still;
  std::uint32_t behind = first + 1;
  while (behind < end && still[behind] == still[first]) ++behind;
  return behind - first;
}

Status draw_together(const Api& api, const Skinner& s, const ProgramSet& programs, const Program& program,
                     std::uint32_t first, std::uint32_t count) {
  const SkinnerState& own = state_of(s);
  if (skins_once(s.options.path)) {
    draw(api, own.gpu, s.skinned[first]);
    return Status::ok;
  }
  const std::uint32_t joints = s.mesh.palette_size(), unit = s.options.texture_unit;
  Status status = Status::ok;
  if (s.options.path == SkinningPath::texture) {
    status = bind_palette(api, own.texture, first * joints, joints, unit, program);
  } else {
    bind_palette(api, own.ring, own.offsets[first], programs.palette_binding);
  }
  if (status == Status::ok && !own.weights.empty())
    status = set_morphs(api, s.mesh, own.gpu, weights_of(s, first), unit + 1, program);
  if (status == Status::ok && own.gpu.distances != 0)
    status = bind_examples(api, own.gpu, own.distance_texture, first * own.gpu.distances, unit + 3, program);
  if (status == Status::ok && state_of(program).motion) status = bind_motion(api, s, programs, program, first, count);
  return status == Status::ok ? draw(api, own.gpu, s.options.deformer, program, count) : status;
}

// Pre-skins characters whose palettes are in the ring.
Status skin_on_gpu(const Api& api, Skinner& s, const Program& program, std::uint32_t binding, std::uint32_t count) {
  SkinnerState& own = state_of(s);
  api.UseProgram(program.id);
  Status status = Status::ok;
  for (std::uint32_t i = 0; i < count && status == Status::ok; ++i) {
    bind_palette(api, own.ring, own.offsets[i], binding);
    if (!own.weights.empty())
      status = set_morphs(api, s.mesh, own.gpu, weights_of(s, i), s.options.texture_unit + 1, program);
    if (status == Status::ok && own.gpu.distances != 0)
      status =
          bind_examples(api, own.gpu, own.distance_texture, i * own.gpu.distances, s.options.texture_unit + 3, program);
    if (status == Status::ok) status = preskin(api, own.gpu, s.options.deformer, program, s.skinned[i]);
  }
  return status;
}

}  // namespace

const char* to_string(SkinningPath path) {
  const char* const names[kPathCount] = {"ubo", "texture", "feedback", "compute", "cpu"};
  const auto i = static_cast<std::size_t>(path);
  return i < kPathCount ? names[i] : "";
}

std::size_t skinner_bytes(const Mesh& mesh, const SkinnerOptions& options) {
  Skinner counted;
  counted.mesh = mesh;
  counted.options = options;
  Memory memory;
  Span<std::byte> morphed;
  lay_out(memory, counted, morphed);
  return memory.used;
}

Status create_skinner(const Api& api, const Caps& caps, const Mesh& mesh, const SkinnerOptions& options,
                      ProgramSet& programs, Span<std::byte> memory, Skinner& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(options.instances > 0);
  MARROW_REQUIRE(skins(options.deformer) && options.path <= SkinningPath::cpu);
  MARROW_REQUIRE_GOOD(check_roles(programs));
  const Status possible = check_device(caps, mesh, options);
  if (possible != Status::ok) return possible;
  MARROW_REQUIRE_GOOD(check_mesh(mesh, prepare_options(options)));
  MARROW_REQUIRE(holds(memory, skinner_bytes(mesh, options)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  Skinner made;
  SkinnerState& own = state_of(made);
  made.mesh = mesh;
  made.options = options;
  if (options.deformer == Deformer::psd && !has_pose_space(mesh, options)) made.options.deformer = Deformer::ssd;
  Memory pieces{memory.data};
  Span<std::byte> morphed;
  lay_out(pieces, made, morphed);
  std::memset(memory.data, 0, pieces.used);
  Status status = Status::ok;
  if (!own.coordinates.empty()) status = as_coordinates(mesh.geometry, own.coordinates);
  if (status == Status::ok && options.path == SkinningPath::cpu)
    status = make_morphed(mesh.geometry, morphed, own.morphed);
  if (status == Status::ok) status = make_objects(api, caps, made);
  if (status == Status::ok) status = build_programs(api, caps, made, programs);
  if (status != Status::ok) {
    destroy(api, made);
    return status;
  }
  out = made;
  return Status::ok;
}

void destroy(const Api& api, Skinner& s) {
  if (!s.lost) destroy_objects(api, s);
  s = {};
}

Status pose(Skinner& s, std::uint32_t instance, Span<const Affine> model_from_joint, Span<const float> weights) {
  SkinnerState& own = state_of(s);
  MARROW_REQUIRE_GOOD(check_made(s));
  MARROW_REQUIRE(instance < s.options.instances);
  MARROW_REQUIRE(holds(weights, s.mesh.geometry.targets.size));
  MARROW_REQUIRE(holds(model_from_joint));
  for (std::uint32_t i = 0; i < s.mesh.joint_count; ++i) MARROW_REQUIRE(s.mesh.joints[i] < model_from_joint.size);
  const Span<const Affine> bind = s.options.path == SkinningPath::cpu
                                      ? Span<const Affine>(s.mesh.inverse_bind, s.mesh.joint_count)
                                      : Span<const Affine>(own.bind);
  for (std::size_t t = 0; t < s.mesh.geometry.targets.size; ++t)
    own.weights[instance * s.mesh.geometry.targets.size + t] = weights[t];
  const Span<Affine> palette = palette_of(s, instance);
  const Status status = build_palette({s.mesh.joints, s.mesh.joint_count}, bind, model_from_joint, palette,
                                      s.mesh.helpers, s.mesh.helper_centres);
  if (status != Status::ok || own.distances.empty() || s.options.path == SkinningPath::cpu) return status;
  const std::size_t size = distance_matrices(s.mesh.geometry);
  return pack_distances(s.mesh.geometry, palette, {own.distances.data + instance * size, size});
}

Status reset_motion(Skinner& s, std::uint32_t instance) {
  MARROW_REQUIRE_GOOD(check_made(s));
  MARROW_REQUIRE(s.options.motion && instance < s.options.instances);
  state_of(s).motion.reset[instance] = 1;
  return Status::ok;
}

Status update(const Api& api, Skinner& s, const ProgramSet& programs, std::uint32_t count) {
  MARROW_ZONE;
  SkinnerState& own = state_of(s);
  MARROW_REQUIRE_GOOD(check_made(s));
  if (s.lost) return Status::gl_error;
  MARROW_REQUIRE(count <= s.options.instances);
  if (skins_once(s.options.path))
    for (std::size_t i = 0; i < count * s.mesh.geometry.targets.size; ++i)
      MARROW_REQUIRE(own.weights[i] - own.weights[i] == 0 && "weights are finite");
  const bool by_gpu = s.options.path == SkinningPath::feedback || s.options.path == SkinningPath::compute;
  const Program* const program =
      by_gpu ? find_program(programs, preskin_key(s), preskin_role(s.options.path)) : nullptr;
  MARROW_REQUIRE(!by_gpu || (program != nullptr && "the set that the skinner was created with"));
  if (s.options.motion) take_turns(s, count);
  s.updated = 0;
  Status status = upload_distances(api, s, count);
  if (status != Status::ok) return status;
  switch (s.options.path) {
    case SkinningPath::ubo:
      status = push_palettes(api, s, count);
      break;
    case SkinningPath::texture:
      status = upload_palettes(api, s, count);
      break;
    case SkinningPath::feedback:
    case SkinningPath::compute:
      status = push_palettes(api, s, count);
      if (status == Status::ok) status = skin_on_gpu(api, s, *program, programs.palette_binding, count);
      break;
    case SkinningPath::cpu:
      for (std::uint32_t i = 0; i < count && status == Status::ok; ++i) status = skin_on_cpu(api, s, i);
      break;
  }
  for (std::uint32_t i = 0; i < count && i < own.motion.skinned.size && status == Status::ok; ++i)
    status = set_previous(api, s.skinned[i], own.motion.still[i] != 0 ? s.skinned[i] : own.motion.skinned[i]);
  if (status == Status::ok) s.updated = count;
  return status;
}

const Program& program_of(const Skinner& s, const ProgramSet& programs, std::uint32_t role) {
  return program_or_none(find_program(programs, drawing_key(s, programs, role), role));
}

Status draw(const Api& api, const Skinner& s, const ProgramSet& programs, const Program& program, std::uint32_t first,
            std::uint32_t count) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_made(s));
  if (s.lost) return Status::gl_error;
  MARROW_REQUIRE(first <= s.updated && count <= s.updated - first);
  MARROW_REQUIRE(may_draw(s, program) && "the program from program_of()");
  for (const std::uint32_t end = first + count; first < end; first += count) {
    count = drawn_together(s, program, first, end);
    const Status status = draw_together(api, s, programs, program, first, count);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

void on_context_lost(Skinner& s) {
  SkinnerState& own = state_of(s);
  own.gpu = {};
  own.ring = own.motion.ring = {};
  own.texture = own.distance_texture = {};
  for (const Span<SkinnedMesh> all : {s.skinned, own.motion.skinned})
    for (SkinnedMesh& skinned : all) skinned = {};
  s.updated = 0;
  s.lost = true;
}

Status on_context_restored(const Api& api, const Caps& caps, Skinner& s) {
  MARROW_REQUIRE_GOOD(check_made(s));
  const Status good = s.options.path == SkinningPath::compute && !caps.compute ? Status::unsupported : Status::ok;
  Status status = good == Status::ok ? make_objects(api, caps, s) : good;
  if (status == Status::ok) {
    s.lost = false;
    return status;
  }
  destroy_objects(api, s);
  return status;
}

}  // namespace marrow::gles3
