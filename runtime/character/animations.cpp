// Which clips of a file or a clip pack the skeletons of a character play together.
#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "marrow/character.h"
#include "marrow/clip_pack.h"

namespace marrow {
namespace {

std::size_t target_count(const File& file) {
  std::size_t count = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) count += file.mesh(m).targets.size;
  return count;
}

struct Pieces {
  Span<Animation> all;
  Span<std::uint32_t> clips, channels;  // animation after animation
};

Pieces lay_out(const File& file, const File& clips, Memory& memory) {
  const std::size_t count = clips.clip_count();
  Pieces out;
  out.all = memory.take<Animation>(count);
  out.clips = memory.take<std::uint32_t>(count * file.skeleton_count());
  out.channels = memory.take<std::uint32_t>(count * target_count(file));
  return out;
}

bool is_free(std::uint32_t skeleton, Span<const std::uint32_t> clip_of_skeleton) {
  return clip_of_skeleton[skeleton] == kNoClip;
}

// The skeleton that clips of a pack's reference move; skeleton_count() if there is none.
std::uint32_t skeleton_of_reference(const File& file, const File& pack, std::uint32_t reference,
                                    Span<const std::uint32_t> clip_of_skeleton) {
  const char* const name = pack.reference(reference).name;
  const std::uint32_t count = file.skeleton_count();
  std::uint32_t first = count;
  for (std::uint32_t s = 0; s < count; ++s) {
    if (!is_free(s, clip_of_skeleton) || bind_clips(pack, reference, file, s) != Status::ok) continue;
    if (std::strcmp(file.skeleton(s).name, name) == 0) return s;
    if (first == count) first = s;
  }
  return first;
}

// The clip of a pack that goes with `clip` for a reference.
std::uint32_t companion(const File& clips, std::uint32_t clip, std::uint32_t owner) {
  const Clip played = clips.clip(clip);
  if (played.skeleton == owner) return clip;
  if (*played.name == '\0') return kNoClip;
  const std::uint32_t found = clips.find_clip(played.name, owner);
  return found < clips.clip_count() ? found : kNoClip;
}

// Of a file's own clips, in one pass however many skeletons there are.
void choose_own_clips(const File& file, std::uint32_t clip, Span<std::uint32_t> out) {
  const Clip played = file.clip(clip);
  out[played.skeleton] = clip;
  for (std::uint32_t i = 0; out.size > 1 && *played.name != '\0' && i < file.clip_count(); ++i) {
    const Clip other = file.clip(i);
    if (is_free(other.skeleton, out) && std::strcmp(other.name, played.name) == 0) out[other.skeleton] = i;
  }
}

void choose_clips(const File& file, const File& clips, std::uint32_t clip, Span<std::uint32_t> out) {
  for (std::uint32_t& chosen : out) chosen = kNoClip;
  if (clips.reference_count() == 0) return choose_own_clips(file, clip, out);
  for (std::uint32_t reference = 0; reference < clips.reference_count(); ++reference) {
    const std::uint32_t chosen = companion(clips, clip, reference);
    if (chosen == kNoClip) continue;
    const std::uint32_t skeleton = skeleton_of_reference(file, clips, reference, out);
    if (skeleton < out.size) out[skeleton] = chosen;
  }
}

Status find_channels(const File& file, const Animation& animation, Span<std::uint32_t> out) {
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    const Span<std::uint32_t> own(out.data, mesh.targets.size);
    out = {out.data + own.size, out.size - own.size};
    for (std::uint32_t& channel : own) channel = kNoChannel;
    const std::uint32_t clip = animation.clip_of_skeleton[mesh.skeleton];
    if (clip == kNoClip || own.empty()) continue;
    const Status status = find_weight_channels(file, mesh, animation.clips, animation.clips.clip(clip), own);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

bool says_anything(const ClipMotion& m) {
  return m.speed_m_s > 0 || !m.events.empty() || !m.phase_marks.empty() || !m.root.empty();
}

// Of the first skeleton that has one with a root, else any, else of the first that plays.
void choose_motion(Animation& animation) {
  int best = -1;
  for (std::uint32_t s = 0; s < animation.clip_of_skeleton.size; ++s) {
    const std::uint32_t clip = animation.clip_of_skeleton[s];
    if (clip == kNoClip) continue;
    const ClipMotion motion = animation.clips.motion(clip);
    const int rank = !motion.root.empty() ? 2 : says_anything(motion) ? 1 : 0;
    if (rank <= best) continue;
    best = rank;
    animation.motion = motion;
    animation.motion_skeleton = s;
  }
}

bool moves_anything(const Animation& animation) {
  for (const std::uint32_t clip : animation.clip_of_skeleton)
    if (clip != kNoClip) return true;
  return false;
}

}  // namespace

std::size_t animations_bytes(const File& file, const File& clips) {
  Memory counted;
  lay_out(file, clips, counted);
  return counted.whole();
}

Status make_animations(const File& file, const File& clips, Span<std::byte> memory, Animations& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(memory, animations_bytes(file, clips)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  if (clips.reference_count() == 0 && clips.sections().data != file.sections().data) return Status::mismatch;
  Memory taken{memory.data};
  const Pieces pieces = lay_out(file, clips, taken);
  const std::size_t skeletons = file.skeleton_count(), targets = target_count(file);
  bool any = pieces.all.empty();
  for (std::uint32_t i = 0; i < pieces.all.size; ++i) {
    const Span<std::uint32_t> chosen(pieces.clips.data + i * skeletons, skeletons);
    const Span<std::uint32_t> channels(pieces.channels.data + i * targets, targets);
    choose_clips(file, clips, i, chosen);
    Animation made{clips.clip(i).name, clips, 0, chosen, channels, {}, 0};
    choose_motion(made);
    for (const std::uint32_t clip : chosen)
      if (clip != kNoClip && clips.clip(clip).duration_s > made.duration_s)
        made.duration_s = clips.clip(clip).duration_s;
    const Status status = find_channels(file, made, channels);
    if (status != Status::ok) return status;
    any = any || moves_anything(made);
    pieces.all[i] = made;
  }
  if (!any) return Status::mismatch;
  out = {pieces.all};
  return Status::ok;
}

const Animation* find_animation(const Animations& animations, const char* name) {
  if (name == nullptr) return nullptr;
  for (std::uint32_t i = 0; i < animations.all.size; ++i) {
    const Animation& animation = animations.all[i];
    if (animation.name == nullptr) continue;  // a game made it
    if (std::strcmp(animation.name, name) == 0 && moves_anything(animation)) return &animation;
  }
  return nullptr;
}

Clip clip_of(const Animation& animation, std::uint32_t skeleton) {
  if (skeleton >= animation.clip_of_skeleton.size) return {};
  return animation.clips.clip(animation.clip_of_skeleton[skeleton]);  // of kNoClip an empty one
}

}  // namespace marrow
