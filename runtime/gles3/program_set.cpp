// Once a kind of mesh: its programs, compiled when first asked for and again after a loss of the context.
#include "gles3/program_set.h"

#include "gles3/crowd/crowd.h"

namespace marrow::gles3 {
namespace {

bool same(const ProgramKey& a, const ProgramKey& b) {
  return a.deformer == b.deformer && a.influences == b.influences && a.features == b.features &&
         a.palettes == b.palettes;
}

Status build(const Api& api, const Caps& caps, const ProgramSet& set, ProgramSetEntry& entry) {
  if (entry.role < kMostRoles)
    return create_program(api, entry.key, set.roles[entry.role], set.palette_binding, entry.program, set.log);
  if (entry.role == kBlendingRole) return create_crowd_program(api, entry.program, set.log);
  const auto method = static_cast<Preskin>(entry.role - kMostRoles);
  return create_preskin(api, caps, entry.key, method, set.palette_binding, entry.program, set.log);
}

}  // namespace

BadCall check_roles(const ProgramSet& programs) {
  MARROW_CHECK(programs.role_count > 0 && programs.role_count <= kMostRoles);
  MARROW_CHECK(state_of(programs).count <= kMostPrograms && holds(programs.log));
  for (std::uint32_t role = 0; role < programs.role_count; ++role)
    MARROW_CHECK(programs.roles[role].vertex != nullptr && programs.roles[role].fragment != nullptr);
  return {};
}

const Program* find_program(const ProgramSet& programs, const ProgramKey& key, std::uint32_t role) {
  const ProgramSetState& all = state_of(programs);
  for (std::uint32_t i = 0; i < all.count; ++i) {
    const ProgramSetEntry& entry = all.entries[i];
    if (entry.role == role && same(entry.key, key)) return &entry.program;
  }
  return nullptr;
}

std::uint8_t features_read(const ProgramSet& programs, std::uint32_t role, const GpuMesh& mesh, Deformer deformer,
                           std::uint8_t wanted, bool motion) {
  if (role >= kMostRoles) return 0;
  const int read = wanted & programs.role_features[role];
  int features = (mesh.features & read & ~kSurfaceNormals) | (motion ? read & kMotion : 0);
  features |= mesh.features & kMorphs;
  // With more than four influences kSurfaceNormals also decides how coordinates are read.
  if (deformer == Deformer::as && ((features & (kNormals | kTangents)) != 0 || mesh.influences > 4))
    features |= mesh.features & kSurfaceNormals;
  return static_cast<std::uint8_t>(features);
}

Status need_program(const Api& api, const Caps& caps, ProgramSet& programs, const ProgramKey& key, std::uint32_t role) {
  if (find_program(programs, key, role) != nullptr) return Status::ok;
  ProgramSetState& all = state_of(programs);
  if (all.count == kMostPrograms) return Status::unsupported;
  ProgramSetEntry& entry = all.entries[all.count];
  entry = {};
  entry.key = key;
  entry.role = role;
  const Status status = build(api, caps, programs, entry);
  if (status == Status::ok) ++all.count;
  return status;
}

void destroy(const Api& api, ProgramSet& programs) {
  ProgramSetState& all = state_of(programs);
  for (std::uint32_t i = 0; i < all.count; ++i) destroy(api, all.entries[i].program);
  all.count = 0;
}

void on_context_lost(ProgramSet& programs) {
  ProgramSetState& all = state_of(programs);
  for (std::uint32_t i = 0; i < all.count; ++i) all.entries[i].program = {};
}

Status on_context_restored(const Api& api, const Caps& caps, ProgramSet& programs) {
  ProgramSetState& all = state_of(programs);
  for (std::uint32_t i = 0; i < all.count; ++i) {
    ProgramSetEntry& entry = all.entries[i];
    if (entry.program.id != 0) continue;  // from an attempt before
    const Status status = build(api, caps, programs, entry);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

}  // namespace marrow::gles3
