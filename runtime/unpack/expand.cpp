#include "unpack/expand.h"

#include <cstring>

#include "core/builtins.h"
#include "core/step.h"
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

// The biased number that stands for 0.
std::int32_t nothing(const Stream& s) {
  return 1 << (s.bits - 1);
}

// A component of an influence's residual. x, y and z are stored less w times the vertex's position.
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

// value() of four vertices, for streams that are not centred.
f32x4 values(const Stream& s, const std::uint32_t (&v)[4], std::uint32_t component) {
  const f32x4 numbers = raw(s, v, component);
  return s.bits == 0 ? numbers : splat(s.origin[component < 3 ? component : 0]) + numbers * splat(s.step);
}

// The least and the greatest number on each axis.
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

// The least and the greatest number give the ends of the box; a negative step swaps them.
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

GeometryHeader make_header(const MeshStreams& mesh, const Arrangement& a, const WritingInWork& w) {
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
  std::memcpy(h.box_min, w.box_min, sizeof h.box_min);
  std::memcpy(h.box_max, w.box_max, sizeof h.box_max);
  return h;
}

// Four vertices of a run, from `i` on in the order of the slots. Past the run's end its last vertex repeats.
void take_block(const Arrangement& a, std::uint32_t i, std::uint32_t end, std::uint32_t (&vertices)[4]) {
  for (std::uint32_t lane = 0; lane < 4; ++lane) vertices[lane] = a.order[i + lane < end ? i + lane : end - 1];
}

// Calls block(four vertices) in the order of the slots.
template <class OnBlock>
void for_each_block(const Arrangement& a, const OnBlock& on_block) {
  for (std::uint32_t run = 0, i = 0; run < a.run_count; ++run) {
    const std::uint32_t end = a.run_ends[run];
    for (; i < end; i += 4) {
      std::uint32_t vertices[4];
      take_block(a, i, end, vertices);
      on_block(vertices);
    }
    i = end;
  }
}

// Points w at the places of the first vertices.
void begin_vertices(const GeometryLayout& l, std::byte* base, WritingInWork& w) {
  w.skin = at<float>(base, l.skin);
  w.normals = at<float>(base, l.normals);
  w.tangents = at<float>(base, l.tangents);
  w.residual = at<float>(base, l.as_residual);
  w.multi_weights = at<float>(base, l.mwe_residual);
  w.uvs = at<float>(base, l.uvs);
  w.colours = at<std::uint8_t>(base, l.colours);
  w.runs = at<Run>(base, l.runs);
  w.sets = at<std::uint16_t>(base, l.sets);
}

// Everything but indices, source slots, morph targets and examples, in one pass over the vertices.
class Writer {
 public:
  Writer(const MeshStreams& mesh, const Arrangement& a, const WritingInWork& w) : mesh_(mesh), a_(a), w_(w) {}

  // Goes on until `left` is used up. Returns whether everything is written.
  bool write(std::uint32_t& left, WritingInWork& work) {
    while (w_.run < a_.run_count && left > 0) {
      const std::uint32_t begin = w_.run > 0 ? a_.run_ends[w_.run - 1] : 0, end = a_.run_ends[w_.run];
      const std::uint32_t influences = influence_count(mesh_, a_.order[begin]);
      if (w_.at == begin) {
        *w_.runs++ = {end - begin, influences};
        write_set(a_.order[begin], influences);
      }
      const std::uint32_t cost =
          4 + (residuals_ != nullptr ? 2 * influences : 0) + (multi_weight_ != nullptr ? 6 * influences : 0);
      for (; w_.at < end && left > 0; w_.at += 4) {
        std::uint32_t vertices[4];
        take_block(a_, w_.at, end, vertices);
        write_block(vertices, influences);
        use_up(cost, left);
      }
      if (w_.at < end) break;
      w_.at = end;
      ++w_.run;
    }
    work = w_;
    return w_.run == a_.run_count;
  }

 private:
  void write_set(std::uint32_t vertex, std::uint32_t influences) {
    for (std::uint32_t j = 0; j < influences; ++j)
      *w_.sets++ = joints_ == nullptr
                       ? std::uint16_t{0}
                       : static_cast<std::uint16_t>(joints_->values[std::size_t{vertex} * joints_->components + j]);
  }

  void write_block(const std::uint32_t (&v)[4], std::uint32_t influences) {
    for (std::uint32_t c = 0; c < 3; ++c) put(values(positions_, v, c), w_.skin);
    for (std::uint32_t j = 0; j + 1 < influences; ++j) put(values(*weights_, v, j), w_.skin);
    if (normal_ != nullptr) write_directions(*normal_, v, w_.normals);
    if (tangent_ != nullptr) {
      write_directions(*tangent_, v, w_.tangents);
      for (const std::uint32_t vertex : v) *w_.tangents++ = tangent_sign_->values[vertex] != 0 ? 1.0f : -1.0f;
    }
    if (residuals_ != nullptr)  // a stream an influence, back to back
      for (std::uint32_t j = 0; j < influences; ++j)
        for (std::uint32_t c = 0; c < 4; ++c)
          for (const std::uint32_t vertex : v) *w_.residual++ = residual(residuals_[j], positions_, vertex, c);
    if (multi_weight_ != nullptr)
      for (std::uint32_t i = 0; i < 12 * influences; ++i)
        for (const std::uint32_t vertex : v) *w_.multi_weights++ = value(multi_weight_[i / 12], vertex, i % 12);
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
      for (std::uint32_t c = 0; c < 2; ++c) *w_.uvs++ = value(*uv_, vertex, c);
    if (colour_ != nullptr)
      for (std::uint32_t c = 0; c < 4; ++c)
        *w_.colours++ = static_cast<std::uint8_t>(colour_->values[std::size_t{vertex} * 4 + c]);
  }

  const MeshStreams& mesh_;
  const Arrangement& a_;
  WritingInWork w_;
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
};

// What morph targets or examples add, sparse: blocks that a target moves, and records of twelve 16-bit integers.
class RecordWriter {
 public:
  RecordWriter(const MeshStreams& mesh, const Arrangement& a, StreamKind kind, std::uint32_t target_count)
      : mesh_(mesh), a_(a), kind_(kind), target_count_(target_count) {}

  // Goes on until `left` is used up. Returns whether everything is counted.
  bool count(TargetsInWork& at, std::uint32_t& left) const {
    return for_some_targets(at, left, [&](std::uint32_t end) {
      for_each_moved(at.stream, end, [&](std::uint32_t, const std::uint32_t(&)[4]) {
        ++at.blocks;
        at.records += end - at.stream;
      });
    });
  }
  bool write(std::uint32_t index_bytes, std::byte* targets, std::byte* blocks, std::byte* records, TargetsInWork& at_,
             std::uint32_t& left) const {
    return for_some_targets(at_, left, [&](std::uint32_t end) {
      MorphTarget target{};
      target.first_block = at_.blocks;
      target.first_record = at_.records;
      for_each_moved(at_.stream, end, [&](std::uint32_t index, const std::uint32_t(&v)[4]) {
        index_bytes == 2 ? at<std::uint16_t>(blocks, 0)[at_.blocks] = static_cast<std::uint16_t>(index)
                         : at<std::uint32_t>(blocks, 0)[at_.blocks] = index;
        ++at_.blocks;
        for (std::uint32_t s = at_.stream; s < end; ++s)
          write_record(mesh_.streams[s], v, at<std::int16_t>(records, 0) + std::size_t{12} * at_.records++);
      });
      target.block_count = at_.blocks - target.first_block;
      float* const steps[] = {&target.position_step, &target.normal_step, &target.tangent_step};
      for (std::uint32_t s = at_.stream; s < end && target.block_count > 0; ++s) {
        target.attributes |= 1u << mesh_.streams[s].attribute;
        *steps[mesh_.streams[s].attribute] = mesh_.streams[s].step;
      }
      std::memcpy(targets + at_.target * sizeof target, &target, sizeof target);
    });
  }

 private:
  // Calls f(end) for targets from at.target on, where `end` is the stream behind the target's last.
  template <class F>
  bool for_some_targets(TargetsInWork& at, std::uint32_t& left, const F& f) const {
    if (at.target == 0)
      for (at.stream = 0; at.stream < mesh_.stream_count && mesh_.streams[at.stream].kind != kind_;) ++at.stream;
    for (; at.target < target_count_ && left > 0; ++at.target) {
      std::uint32_t end = at.stream;
      while (end < mesh_.stream_count && mesh_.streams[end].kind == kind_ && mesh_.streams[end].target == at.target)
        ++end;
      f(end);
      use_up(1 + std::uint64_t{end - at.stream} * mesh_.vertex_count / 4, left);
      at.stream = end;
    }
    return at.target == target_count_;
  }

  // Calls f(block, its vertices) for the blocks that the streams move. A target without streams takes one byte in a
  // file, so it must not cost a pass over the vertices.
  template <class F>
  void for_each_moved(std::uint32_t first, std::uint32_t end, const F& f) const {
    if (first == end) return;
    std::uint32_t block = 0;
    for_each_block(a_, [&](const std::uint32_t(&v)[4]) {
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
  StreamKind kind_;
  std::uint32_t target_count_;
};

// What stands behind the arrays: morph targets, then pose-space deformation.
class Appendix {
 public:
  Appendix(const MeshStreams& mesh, const GeometryHeader& h, const GeometryLayout& l, const WritingInWork& w)
      : mesh_(mesh),
        index_bytes_(l.index_bytes),
        arrays_end_(l.bytes),
        morph_header_{mesh.target_count, w.block_count, w.record_count, 0},
        space_header_{mesh.example_count, w.delta_count, mesh.sigma, 0},
        morphs_(layout(morph_header_, l)),
        morphs_end_(mesh.target_count > 0 ? morphs_.bytes : l.bytes),
        space_(layout(space_header_, h, morphs_end_)) {}

  std::uint64_t bytes() const { return mesh_.example_count > 0 ? space_.bytes : morphs_end_; }

  // Each goes on until `left` is used up, and returns whether everything is written.
  bool write_targets(const RecordWriter& targets, TargetsInWork& at, std::uint32_t& left, std::byte* base) const {
    if (mesh_.target_count == 0) return true;
    zero(base, arrays_end_, morphs_.header);
    std::memcpy(base + morphs_.header, &morph_header_, sizeof morph_header_);
    return targets.write(index_bytes_, base + morphs_.targets, base + morphs_.blocks, base + morphs_.records, at, left);
  }
  bool write_deltas(const RecordWriter& deltas, TargetsInWork& at, std::uint32_t& left, std::byte* base) const {
    if (mesh_.example_count == 0) return true;
    zero(base, morphs_end_, space_.header);
    std::memcpy(base + space_.header, &space_header_, sizeof space_header_);
    if (!deltas.write(index_bytes_, base + space_.examples, base + space_.blocks, base + space_.records, at, left))
      return false;
    std::memcpy(base + space_.rotations, mesh_.rotations, static_cast<std::size_t>(space_.blocks - space_.rotations));
    std::memcpy(base + space_.parents, mesh_.parents, static_cast<std::size_t>(space_.bytes - space_.parents));
    return true;
  }

 private:
  static void zero(std::byte* base, std::uint64_t first, std::uint64_t end) {
    std::memset(base + first, 0, static_cast<std::size_t>(end - first));
  }

  const MeshStreams& mesh_;
  std::uint32_t index_bytes_;
  std::uint64_t arrays_end_;
  format::MorphHeader morph_header_;
  format::PoseSpaceHeader space_header_;
  format::MorphLayout morphs_;
  std::uint64_t morphs_end_;
  format::PoseSpaceLayout space_;
};

void write_indices(const MeshStreams& mesh, const Arrangement& a, const GeometryLayout& l, std::uint32_t from,
                   std::uint32_t end, std::byte* base) {
  auto* const narrow = reinterpret_cast<std::uint16_t*>(base + l.indices);
  auto* const wide = reinterpret_cast<std::uint32_t*>(base + l.indices);
  for (std::uint32_t i = from; i < end; ++i) {
    const std::uint32_t slot = a.slot_of_vertex[mesh.indices[i]];
    l.index_bytes == 2 ? narrow[i] = static_cast<std::uint16_t>(slot) : wide[i] = slot;
  }
}

// Whether any number is negative, or `end` or more. It does not stop early, so that compilers vectorise it.
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

const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, ArrangingInWork& work, Arrangement& out,
                             std::uint32_t& left) {
  if (work.place == ArrangingInWork::Place::beginning) {
    if (const char* const rule = check_streams(mesh)) return rule;
    std::uint64_t numbers = std::uint64_t{3} * mesh.triangle_count;
    for (std::uint32_t i = 0; i < mesh.stream_count; ++i)
      numbers += std::uint64_t{mesh.vertex_count} * mesh.streams[i].components;
    use_up(numbers / 16, left);
  }
  return arrange(mesh, scratch, work, out, left) ? nullptr : "memory_bytes too small";
}

const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, Arrangement& out) {
  if (const char* const rule = check_streams(mesh)) return rule;
  return arrange(mesh, scratch, out) ? nullptr : "memory_bytes too small";
}

const char* write_geometry(const MeshStreams& mesh, const Arrangement& a, WritingInWork& w, Span<std::byte> out,
                           std::uint32_t& bytes, std::uint32_t& left) {
  using Place = WritingInWork::Place;
  const RecordWriter targets(mesh, a, StreamKind::target, mesh.target_count),
      deltas(mesh, a, StreamKind::pose_delta, mesh.example_count);
  if (w.place == Place::counting) {
    if (!targets.count(w.targets, left)) return nullptr;
    w.place = Place::counting_deltas;
  }
  if (w.place == Place::counting_deltas) {
    if (!deltas.count(w.deltas, left)) return nullptr;
    w.block_count = w.targets.blocks;
    w.record_count = w.targets.records;
    w.delta_count = w.deltas.blocks;
    w.targets = w.deltas = {};
    find_box(*mesh.find(StreamKind::position), mesh.vertex_count, w.box_min, w.box_max);
    use_up(mesh.vertex_count / 8, left);
  }
  const GeometryHeader h = make_header(mesh, a, w);
  const GeometryLayout l = layout(h);
  const Appendix appendix(mesh, h, l, w);
  std::byte* const base = out.data;
  if (w.place == Place::counting_deltas) {
    if (appendix.bytes() > out.size) return "file_bytes too small";
    std::memcpy(base, &h, sizeof h);
    bytes = static_cast<std::uint32_t>(appendix.bytes());
    begin_vertices(l, base, w);
    w.place = Place::vertices;
  }
  while (left > 0 && w.place != Place::done) {
    bool done = false;
    if (w.place == Place::vertices) {
      done = Writer(mesh, a, w).write(left, w);
    } else if (w.place == Place::targets) {
      done = appendix.write_targets(targets, w.targets, left, base);
    } else if (w.place == Place::deltas) {
      done = appendix.write_deltas(deltas, w.deltas, left, base);
    } else {
      const bool indices = w.place == Place::indices;
      const std::uint32_t count = indices ? 3 * mesh.triangle_count : mesh.source_vertex_count,
                          end = step_end(w.at, count, left);
      auto* const slots = reinterpret_cast<std::uint32_t*>(base + l.source_slots);
      if (indices) write_indices(mesh, a, l, w.at, end, base);
      for (std::uint32_t i = w.at; !indices && i < end; ++i)
        slots[i] = mesh.source_map[i] == kNoSlot ? kNoSlot : a.slot_of_vertex[mesh.source_map[i]];
      use_up(end - w.at, left);
      w.at = end;
      done = end == count;
    }
    if (!done) continue;
    w.at = 0;
    w.place = static_cast<Place>(static_cast<std::uint8_t>(w.place) + 1);
  }
  return nullptr;
}

const char* write_geometry(const MeshStreams& mesh, const Arrangement& a, Span<std::byte> out, std::uint32_t& bytes) {
  WritingInWork work;
  while (work.place != WritingInWork::Place::done) {
    std::uint32_t left = UINT32_MAX;
    if (const char* const rule = write_geometry(mesh, a, work, out, bytes, left)) return rule;
  }
  return nullptr;
}

}  // namespace marrow
