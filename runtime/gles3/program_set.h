// The programs that skinners share.
#pragma once

#include "core/check.h"
#include "gles3/program.h"
#include "gles3/skinned.h"

namespace marrow::gles3 {

// The most programs of a ProgramSet.
inline constexpr std::uint32_t kMostPrograms = 192;

struct ProgramSetEntry {
  ProgramKey key = {};     // what it was built for
  std::uint32_t role = 0;  // from kMostRoles on: kMostRoles + Preskin, pre-skinning; kMostRoles + 2, blending of crowds
  Program program = {};    // as it was built
};

struct ProgramSetState {
  std::uint32_t count = 0;                      // of entries
  ProgramSetEntry entries[kMostPrograms] = {};  // what was compiled
};
static_assert(sizeof(ProgramSetState) == sizeof(ProgramSet::state) && alignof(ProgramSetState) == 4);
static_assert(std::is_trivially_copyable_v<ProgramSetState>);

inline ProgramSetState& state_of(ProgramSet& programs) {
  return *reinterpret_cast<ProgramSetState*>(programs.state);
}
inline const ProgramSetState& state_of(const ProgramSet& programs) {
  return *reinterpret_cast<const ProgramSetState*>(programs.state);
}

inline constexpr std::uint32_t pre_skinning(Preskin method) {
  return kMostRoles + static_cast<std::uint32_t>(method);
}

// The program that blends the poses of crowds.
inline constexpr std::uint32_t kBlendingRole = kMostRoles + 2;
inline constexpr ProgramKey kBlendingKey = {Deformer::none, 4, 0, Palettes::uniform_block};

// Checks that there are roles, all with texts, and no more entries than fit.
BadCall check_roles(const ProgramSet& programs);

// Null if there is none.
const Program* find_program(const ProgramSet& programs, const ProgramKey& key, std::uint32_t role);

inline const Program& program_or_none(const Program* found) {
  static constexpr Program kNone;
  return found != nullptr ? *found : kNone;
}

// The features that a role's program reads: those that the mesh has, the role reads and the game wants. Features that
// skinning itself needs are always among them. motion: whether the previous frame is kept.
std::uint8_t features_read(const ProgramSet& programs, std::uint32_t role, const GpuMesh& mesh, Deformer deformer,
                           std::uint8_t wanted, bool motion);

// Compiles it unless it is there. Errors: unsupported (the set is full, no compute shaders); bad_argument; gl_error.
Status need_program(const Api& api, const Caps& caps, ProgramSet& programs, const ProgramKey& key, std::uint32_t role);

}  // namespace marrow::gles3
