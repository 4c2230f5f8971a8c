#include "unpack/expand.h"

#include <cstring>

#include "core/builtins.h"
#include "unpack/octahedron.h"

namespace marrow {
namespace {

using format::GeometryHeader;
using format::GeometryLayout;

template <class T>
T* at(std::byte* base, std::uint64_t offset) {
  return reinterpret_cast<T*>(base + offset);
}

float value(const Stream& s, std::uint32_t vertex, std::uint32_t component) {
  const std::int32_t v = s.values[std::size_t{vertex} * s.components + component];
  if (s.bits == 0) return bit_cast<float>(v);
  if (is_centred(s.kind)) return static_cast<float>(v - (1 << (s.bits - 1))) * s.step;
  return s.origin[component < 3 ? component : 0] + static_cast<float>(v) * s.step;
}

// What a biased number stands for at 0.
std::int32_t nothing(const Stream& s) {
  return 1 << (s.bits - 1);
}

// Of an influence. Stored relative to the vertex, which the w carry along.
float residual(const Stream& s, const Stream& positions, std::uint32_t vertex, std::uint32_t component) {
  const std::int32_t* const v = s.values + std::size_t{vertex} * 4;
  if (s.bits == 0) return bit_cast<float>(v[component]);
  const float w = static_cast<float>(v[3] - nothing(s)) * s.origin[0];
  if (component == 3) return w;
  return static_cast<float>(v[component] - nothing(s)) * s.step + value(positions, vertex, component) * w;
}

// Of four vertices.
f32x4 raw(const Stream& s, const std::uint32_t (&v)[4], std::uint32_t component) {
  std::int32_t n[4];
  for (int i = 0; i < 4; ++i) n[i] = s.values[std::size_t{v[i]} * s.components + component];
  if (s.bits == 0)
    return lanes(bit_cast<float>(n[0]), bit_cast<float>(n[1]), bit_cast<float>(n[2]), bit_cast<float>(n[3]));
  return lanes(static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2]), static_cast<float>(n[3]));
}

// As value(), of what is not centred.
f32x4 values(const Stream& s, const std::uint32_t (&v)[4], std::uint32_t component) {
  const f32x4 numbers = raw(s, v, component);
  return s.bits == 0 ? numbers : splat(s.origin[component < 3 ? component : 0]) + numbers * splat(s.step);
}

// What lies furthest out.
template <class Number>
void find_range(const std::int32_t* positions, std::uint32_t count, Number (&low)[3], Number (&high)[3]) {
  for (std::size_t i = 0; i < 3; ++i) low[i] = high[i] = bit_cast<Number>(positions[i]);
  for (std::uint32_t v = 1; v < count; ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      const Number x = bit_cast<Number>(positions[std::size_t{v} * 3 + c]);
      low[c] = x < low[c] ? x : low[c];
      high[c] = x > high[c] ? x : high[c];
    }
}

// The least and the greatest number are the least and the greatest position, or the other way round.
void find_box(const Stream& s, std::uint32_t count, float (&low)[3], float (&high)[3]) {
  if (s.bits == 0) {
    find_range(s.values, count, low, high);
    return;
  }
  std::int32_t least[3], greatest[3];
  find_range(s.values, count, least, greatest);
  for (int c = 0; c < 3; ++c) {
    const float a = s.origin[c] + static_cast<float>(least[c]) * s.step;
    const float b = s.origin[c] + static_cast<float>(greatest[c]) * s.step;
    low[c] = b < a ? b : a;
    high[c] = b < a ? a : b;
  }
}

GeometryHeader make_header(const MeshStreams& mesh, const Arrangement& a) {
  GeometryHeader h{};
  h.flags = mesh.flags;
  h.vertex_count = mesh.vertex_count;
  h.block_count = a.block_count;
  h.influence_blocks = a.influence_blocks;
  h.run_count = a.run_count;
  h.set_count = a.set_count;
  h.joint_count = mesh.joint_count;
  h.index_count = 3 * mesh.triangle_count;
  h.source_vertex_count = mesh.source_vertex_count;
  h.mwe_root = mesh.mwe_root;
  find_box(*mesh.find(StreamKind::position), mesh.vertex_count, h.box_min, h.box_max);
  return h;
}

// Calls run(first vertex, influences, vertices) and block(four vertices, influences) in the order of the slots.
template <class OnRun, class OnBlock>
void for_each_block(const MeshStreams& mesh, const Arrangement& a, const OnRun& on_run, const OnBlock& on_block) {
  for (std::uint32_t run = 0, first = 0; run < a.run_count; ++run) {
    const std::uint32_t end = a.run_ends[run];
    const std::uint32_t influences = influence_count(mesh, a.order[first]);
    on_run(a.order[first], influences, end - first);
    for (std::uint32_t i = first; i < end; i += 4) {
      std::uint32_t vertices[4];
      for (std::uint32_t lane = 0; lane < 4; ++lane) vertices[lane] = a.order[i + lane < end ? i + lane : end - 1];
      on_block(vertices, influences);
    }
    first = end;
  }
}

// Everything but indices, source slots, morph targets and examples, in one pass over the vertices.
class Writer {
 public:
  Writer(const MeshStreams& mesh, const Arrangement& a, const GeometryLayout& l, std::byte* base)
      : mesh_(mesh),
        a_(a),
        skin_(at<float>(base, l.skin)),
        normals_(at<float>(base, l.normals)),
        tangents_(at<float>(base, l.tangents)),
        residual_(at<float>(base, l.as_residual)),
        multi_weights_(at<float>(base, l.mwe_residual)),
        uvs_(at<float>(base, l.uvs)),
        colours_(at<std::uint8_t>(base, l.colours)),
        runs_(at<Run>(base, l.runs)),
        sets_(at<std::uint16_t>(base, l.sets)) {}

  void write() {
    for_each_block(
        mesh_, a_,
        [&](std::uint32_t vertex, std::uint32_t influences, std::uint32_t count) {
          *runs_++ = {count, influences};
          write_set(vertex, influences);
        },
        [&](const std::uint32_t(&v)[4], std::uint32_t influences) { write_block(v, influences); });
  }

 private:
  void write_set(std::uint32_t vertex, std::uint32_t influences) {
    for (std::uint32_t j = 0; j < influences; ++j)
      *sets_++ = joints_ == nullptr
                     ? std::uint16_t{0}
                     : static_cast<std::uint16_t>(joints_->values[std::size_t{vertex} * joints_->components + j]);
  }

  void write_block(const std::uint32_t (&v)[4], std::uint32_t influences) {
    for (std::uint32_t c = 0; c < 3; ++c) put(values(positions_, v, c), skin_);
    for (std::uint32_t j = 0; j + 1 < influences; ++j) put(values(*weights_, v, j), skin_);
    if (normal_ != nullptr) write_directions(*normal_, v, normals_);
    if (tangent_ != nullptr) {
      write_directions(*tangent_, v, tangents_);
      for (const std::uint32_t vertex : v) *tangents_++ = tangent_sign_->values[vertex] != 0 ? 1.0f : -1.0f;
    }
    if (residuals_ != nullptr)  // a stream an influence, back to back
      for (std::uint32_t j = 0; j < influences; ++j)
        for (std::uint32_t c = 0; c < 4; ++c)
          for (const std::uint32_t vertex : v) *residual_++ = residual(residuals_[j], positions_, vertex, c);
    if (multi_weight_ != nullptr)
      for (std::uint32_t i = 0; i < 12 * influences; ++i)
        for (const std::uint32_t vertex : v) *multi_weights_++ = value(multi_weight_[i / 12], vertex, i % 12);
    for (const std::uint32_t vertex : v) write_slot(vertex);
  }

  static void put(f32x4 four, float*& out) {
    store(out, four);
    out += 4;
  }

  static void write_directions(const Stream& s, const std::uint32_t (&v)[4], float*& out) {
    f32x4 unit[3];
    if (s.bits == 0) {
      for (std::uint32_t c = 0; c < 3; ++c) unit[c] = raw(s, v, c);
    } else {
      from_octahedron(raw(s, v, 0), raw(s, v, 1), s.bits, unit);
    }
    for (const f32x4 axis : unit) put(axis, out);
  }

  void write_slot(std::uint32_t vertex) {
    if (uv_ != nullptr)
      for (std::uint32_t c = 0; c < 2; ++c) *uvs_++ = value(*uv_, vertex, c);
    if (colour_ != nullptr)
      for (std::uint32_t c = 0; c < 4; ++c)
        *colours_++ = static_cast<std::uint8_t>(colour_->values[std::size_t{vertex} * 4 + c]);
  }

  const MeshStreams& mesh_;
  const Arrangement& a_;
  const Stream& positions_ = *mesh_.find(StreamKind::position);
  const Stream* const joints_ = mesh_.find(StreamKind::joints);
  const Stream* const weights_ = mesh_.find(StreamKind::weights);
  const Stream* const normal_ = mesh_.find(StreamKind::normal);
  const Stream* const tangent_ = mesh_.find(StreamKind::tangent);
  const Stream* const tangent_sign_ = mesh_.find(StreamKind::tangent_sign);
  const Stream* const residuals_ = mesh_.find(StreamKind::residual);
  const Stream* const multi_weight_ = mesh_.find(StreamKind::multi_weight);
  const Stream* const uv_ = mesh_.find(StreamKind::uv);
  const Stream* const colour_ = mesh_.find(StreamKind::colour);
  float *skin_, *normals_, *tangents_, *residual_, *multi_weights_, *uvs_;
  std::uint8_t* colours_;
  Run* runs_;
  std::uint16_t* sets_;
};

// What morph targets or examples add, sparse: blocks that a target moves, and records of twelve 16-bit integers.
class RecordWriter {
 public:
  RecordWriter(const MeshStreams& mesh, const Arrangement& a, std::uint32_t index_bytes, StreamKind kind,
               std::uint32_t target_count)
      : mesh_(mesh), a_(a), index_bytes_(index_bytes), kind_(kind), target_count_(target_count) {
    for_each_target([&](std::uint32_t, std::uint32_t first, std::uint32_t end) {
      for_each_moved(first, end, [&](std::uint32_t, const std::uint32_t(&)[4]) {
        ++block_count;
        record_count += end - first;
      });
    });
  }

  std::uint32_t block_count = 0, record_count = 0;

  void write(std::byte* targets, std::byte* blocks, std::byte* records) const {
    std::uint32_t block = 0, record = 0;
    for_each_target([&](std::uint32_t t, std::uint32_t first, std::uint32_t end) {
      MorphTarget target{};
      target.first_block = block;
      target.first_record = record;
      for_each_moved(first, end, [&](std::uint32_t index, const std::uint32_t(&v)[4]) {
        index_bytes_ == 2 ? at<std::uint16_t>(blocks, 0)[block] = static_cast<std::uint16_t>(index)
                          : at<std::uint32_t>(blocks, 0)[block] = index;
        ++block;
        for (std::uint32_t s = first; s < end; ++s)
          write_record(mesh_.streams[s], v, at<std::int16_t>(records, 0) + std::size_t{12} * record++);
      });
      target.block_count = block - target.first_block;
      float* const steps[] = {&target.position_step, &target.normal_step, &target.tangent_step};
      for (std::uint32_t s = first; s < end && target.block_count > 0; ++s) {
        target.attributes |= 1u << mesh_.streams[s].attribute;
        *steps[mesh_.streams[s].attribute] = mesh_.streams[s].step;
      }
      std::memcpy(targets + t * sizeof target, &target, sizeof target);
    });
  }

 private:
  // Calls f(target, its first stream, the one behind its last).
  template <class F>
  void for_each_target(const F& f) const {
    std::uint32_t first = 0;
    while (first < mesh_.stream_count && mesh_.streams[first].kind != kind_) ++first;
    for (std::uint32_t t = 0; t < target_count_; ++t) {
      std::uint32_t end = first;
      while (end < mesh_.stream_count && mesh_.streams[end].kind == kind_ && mesh_.streams[end].target == t) ++end;
      f(t, first, end);
      first = end;
    }
  }

  // Calls f(block, its vertices) for the blocks that the streams move. A target without streams, which takes a byte of
  // a file, takes no pass over the vertices.
  template <class F>
  void for_each_moved(std::uint32_t first, std::uint32_t end, const F& f) const {
    if (first == end) return;
    std::uint32_t block = 0;
    for_each_block(
        mesh_, a_, [](std::uint32_t, std::uint32_t, std::uint32_t) {},
        [&](const std::uint32_t(&v)[4], std::uint32_t) {
          if (moves(first, end, v)) f(block, v);
          ++block;
        });
  }

  bool moves(std::uint32_t first, std::uint32_t end, const std::uint32_t (&v)[4]) const {
    for (std::uint32_t i = first; i < end; ++i) {
      const Stream& s = mesh_.streams[i];
      for (const std::uint32_t vertex : v)
        for (std::uint32_t c = 0; c < 3; ++c)
          if (s.values[std::size_t{vertex} * 3 + c] != nothing(s)) return true;
    }
    return false;
  }
  static void write_record(const Stream& s, const std::uint32_t (&v)[4], std::int16_t* out) {
    for (std::uint32_t c = 0; c < 3; ++c)
      for (const std::uint32_t vertex : v)
        *out++ = static_cast<std::int16_t>(s.values[std::size_t{vertex} * 3 + c] - nothing(s));
  }

  const MeshStreams& mesh_;
  const Arrangement& a_;
  std::uint32_t index_bytes_;
  StreamKind kind_;
  std::uint32_t target_count_;
};

// What stands behind the arrays: morph targets, then pose-space deformation.
class Appendix {
 public:
  Appendix(const MeshStreams& mesh, const Arrangement& a, const GeometryHeader& h, const GeometryLayout& l)
      : mesh_(mesh),
        targets_(mesh, a, l.index_bytes, StreamKind::target, mesh.target_count),
        deltas_(mesh, a, l.index_bytes, StreamKind::pose_delta, mesh.example_count),
        arrays_end_(l.bytes),
        morph_header_{mesh.target_count, targets_.block_count, targets_.record_count, 0},
        space_header_{mesh.example_count, deltas_.block_count, mesh.sigma, 0},
        morphs_(layout(morph_header_, l)),
        morphs_end_(mesh.target_count > 0 ? morphs_.bytes : l.bytes),
        space_(layout(space_header_, h, morphs_end_)) {}

  std::uint64_t bytes() const { return mesh_.example_count > 0 ? space_.bytes : morphs_end_; }

  void write(std::byte* base) const {
    if (mesh_.target_count > 0) {
      zero(base, arrays_end_, morphs_.header);
      std::memcpy(base + morphs_.header, &morph_header_, sizeof morph_header_);
      targets_.write(base + morphs_.targets, base + morphs_.blocks, base + morphs_.records);
    }
    if (mesh_.example_count == 0) return;
    zero(base, morphs_end_, space_.header);
    std::memcpy(base + space_.header, &space_header_, sizeof space_header_);
    deltas_.write(base + space_.examples, base + space_.blocks, base + space_.records);
    std::memcpy(base + space_.rotations, mesh_.rotations, static_cast<std::size_t>(space_.blocks - space_.rotations));
    std::memcpy(base + space_.parents, mesh_.parents, static_cast<std::size_t>(space_.bytes - space_.parents));
  }

 private:
  static void zero(std::byte* base, std::uint64_t first, std::uint64_t end) {
    std::memset(base + first, 0, static_cast<std::size_t>(end - first));
  }

  const MeshStreams& mesh_;
  RecordWriter targets_, deltas_;
  std::uint64_t arrays_end_;
  format::MorphHeader morph_header_;
  format::PoseSpaceHeader space_header_;
  format::MorphLayout morphs_;
  std::uint64_t morphs_end_;
  format::PoseSpaceLayout space_;
};

void write_indices(const MeshStreams& mesh, const Arrangement& a, const GeometryLayout& l, std::byte* base) {
  auto* const narrow = reinterpret_cast<std::uint16_t*>(base + l.indices);
  auto* const wide = reinterpret_cast<std::uint32_t*>(base + l.indices);
  for (std::uint32_t i = 0; i < 3 * mesh.triangle_count; ++i) {
    const std::uint32_t slot = a.slot_of_vertex[mesh.indices[i]];
    l.index_bytes == 2 ? narrow[i] = static_cast<std::uint16_t>(slot) : wide[i] = slot;
  }
}

// Whether any of them is negative, or `end` or more. Looks at all, which compilers do four at a time.
template <class Number>
bool any_from(const Number* numbers, std::size_t count, std::uint32_t end) {
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < count; ++i) bad |= static_cast<std::uint32_t>(numbers[i]) >= end ? 1u : 0u;
  return bad != 0;
}

}  // namespace

std::uint64_t expand_scratch_bytes(const MeshStreams& mesh) {
  return arrange_scratch_bytes(mesh.vertex_count);
}

const char* check_streams(const MeshStreams& mesh) {
  if (any_from(mesh.indices, 3 * std::size_t{mesh.triangle_count}, mesh.vertex_count))
    return "a triangle has no such vertex";
  for (std::uint32_t i = 0; i < mesh.source_vertex_count; ++i)
    if (mesh.source_map[i] >= mesh.vertex_count && mesh.source_map[i] != kNoSlot)
      return "a source vertex has become none";
  for (std::uint32_t i = 0; i < mesh.stream_count; ++i) {
    const Stream& s = mesh.streams[i];
    const std::size_t count = std::size_t{mesh.vertex_count} * s.components;
    if (s.kind == StreamKind::joints && any_from(s.values, count, mesh.joint_count))
      return "a palette entry beyond joint_count";
    if (is_centred(s.kind) && s.bits != 0 && any_from(s.values, count, 1u << s.bits)) return "a change beyond its bits";
  }
  const Stream* const weights = mesh.find(StreamKind::weights);
  if (weights == nullptr || weights->bits == 0) return nullptr;
  const std::uint32_t most = (1u << weights->bits) - 1;
  std::uint32_t bad = 0;
  const std::int32_t* w = weights->values;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    std::uint64_t sum = 0;
    for (std::uint32_t j = 0; j < weights->components; ++j) sum += static_cast<std::uint32_t>(*w++);
    bad |= sum > most ? 1u : 0u;
  }
  return bad == 0 ? nullptr : "weights that sum to more than one";
}

const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, Arrangement& out) {
  if (const char* const rule = check_streams(mesh)) return rule;
  return arrange(mesh, scratch, out) ? nullptr : "memory_bytes too small";
}

const char* write_geometry(const MeshStreams& mesh, const Arrangement& a, Span<std::byte> out, std::uint32_t& bytes) {
  const GeometryHeader h = make_header(mesh, a);
  const GeometryLayout l = layout(h);
  const Appendix appendix(mesh, a, h, l);
  if (appendix.bytes() > out.size) return "file_bytes too small";
  std::memcpy(out.data, &h, sizeof h);
  Writer(mesh, a, l, out.data).write();
  auto* const source_slots = reinterpret_cast<std::uint32_t*>(out.data + l.source_slots);
  for (std::uint32_t i = 0; i < mesh.source_vertex_count; ++i)
    source_slots[i] = mesh.source_map[i] == kNoSlot ? kNoSlot : a.slot_of_vertex[mesh.source_map[i]];
  write_indices(mesh, a, l, out.data);
  appendix.write(out.data);
  bytes = static_cast<std::uint32_t>(appendix.bytes());
  return nullptr;
}

}  // namespace marrow
