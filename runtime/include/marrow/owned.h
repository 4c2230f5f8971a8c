// Files and characters that own their memory, for programs that may allocate and may end where something is wrong: a
// game's first day, tools, tests.
//
//   OwnedFile file;             must(make_owned(bytes, file))         a file and its animations
//   OwnedCharacter a, b;        must(make_owned(file, {}, a))         any number of characters of it
//
// Each is what it owns, so that every call of the runtime takes it. They may be moved, not copied, as views point into
// their memory; a file stays as long as its characters. Header only: the library itself has no allocation.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "marrow/marrow.h"

namespace marrow {

// A block of memory on a boundary of 16 bytes.
class OwnedBlock {
 public:
  // Of no bytes.
  OwnedBlock() = default;
  // Of at least so many zero bytes. Cost: an allocation.
  explicit OwnedBlock(std::size_t bytes) : memory_(block_bytes(bytes)) {}
  // Leaves `other` empty.
  OwnedBlock(OwnedBlock&& other) = default;
  // As that.
  OwnedBlock& operator=(OwnedBlock&& other) = default;

  // Where the bytes are. They stay there when the block is moved.
  Span<std::byte> span() { return block_in({memory_.data(), memory_.size()}); }

 private:
  std::vector<std::byte> memory_;
};

// A file that owns its bytes, with its animations.
struct OwnedFile : File {
  Animations animations = {};   // of the file's own clips
  DataError error = {};         // of the last make_owned() that failed
  OwnedBlock block;             // what the file is a view of
  OwnedBlock animations_block;  // what `animations` are views of
};

// A character that owns its poses and palettes.
struct OwnedCharacter : Character {
  OwnedBlock block;  // what it is views of
};

// An animator that owns what it is in, and what it is bound to.
struct OwnedAnimator : Animator {
  GraphBinding bound = {};  // its graph, its file and its clips
  GraphMisfit misfit = {};  // of the last make_owned() that failed
  OwnedBlock bound_block;   // what `bound` is views of
  OwnedBlock block;         // what it is views of itself
};

// Ends the program, with a line on stderr, where a call failed.
inline void must(Status status) {
  if (status == Status::ok) return;
  std::fprintf(stderr, "marrow: %s\n", to_string(status));
  std::exit(EXIT_FAILURE);
}

// load() and make_animations() of what `out.block` begins with.
inline Status load_owned(Span<const std::byte> bytes, OwnedFile& out) {
  const Status status = load(bytes, out, &out.error);
  if (status != Status::ok) return status;
  out.animations_block = OwnedBlock(animations_bytes(out, out));
  return make_animations(out, out, out.animations_block.span(), out.animations);
}

// A file that is not packed, and its animations. bytes: copied.
// Errors: those of load() and make_animations(); OwnedFile::error says where. Cost: theirs, a copy, two allocations.
inline Status make_owned(Span<const std::byte> bytes, OwnedFile& out) {
  out.block = OwnedBlock(bytes.size);
  std::copy(bytes.begin(), bytes.end(), out.block.span().begin());
  return load_owned({out.block.span().data, bytes.size}, out);
}
// As streams and texts have them.
inline Status make_owned(Span<const char> bytes, OwnedFile& out) {
  return make_owned({reinterpret_cast<const std::byte*>(bytes.data), bytes.size}, out);
}

// A file that may be packed. decoders: of the codecs that it may be packed by. Link marrow::unpack, which comes with
// marrow::draco and marrow::meshopt. Errors: those of unpack(), too. Cost: unpack()'s and the above, without the copy.
inline Status make_owned(Span<const std::byte> bytes, Span<const MeshDecoder> decoders, OwnedFile& out) {
  if (!is_packed(bytes)) return make_owned(bytes, out);
  UnpackSizes sizes;
  Status status = unpack_sizes(bytes, sizes, &out.error);
  if (status != Status::ok) return status;
  out.block = OwnedBlock(sizes.memory_bytes);
  Span<const std::byte> file;
  status = unpack(bytes, decoders, out.block.span(), file, &out.error);
  return status == Status::ok ? load_owned(file, out) : status;
}
// As streams and texts have them.
inline Status make_owned(Span<const char> bytes, Span<const MeshDecoder> decoders, OwnedFile& out) {
  return make_owned({reinterpret_cast<const std::byte*>(bytes.data), bytes.size}, decoders, out);
}

// A character of `file`, which stays where it is. Errors: those of make_character(). Cost: its, and an allocation.
inline Status make_owned(const OwnedFile& file, const CharacterOptions& options, OwnedCharacter& out) {
  out.block = OwnedBlock(character_bytes(file, options));
  return make_character(file, options, out.block.span(), out);
}

// An animator of a file's first graph and its own clips, for characters of it. It stays where it is, as does the file.
// Errors: mismatch if the file has no graph; those of File::graph(), bind_graph() and make_animator(). Cost: theirs,
// and two allocations.
inline Status make_owned(const OwnedFile& file, const AnimatorOptions& options, OwnedAnimator& out) {
  Graph graph;
  if (file.graph_count() == 0) return Status::mismatch;
  Status status = file.graph(0, graph);
  if (status != Status::ok) return status;
  out.bound_block = OwnedBlock(graph_binding_bytes(graph, file));
  status = bind_graph(file, graph, file, {&file.animations, 1}, out.bound_block.span(), out.bound, &out.misfit);
  if (status != Status::ok) return status;
  out.block = OwnedBlock(animator_bytes(out.bound, options));
  return make_animator(out.bound, options, out.block.span(), out);
}

}  // namespace marrow
