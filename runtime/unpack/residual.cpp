#include "unpack/residual.h"

#include <new>

#include "core/step.h"
#include "unpack/arrange.h"
#include "unpack/expand.h"

namespace marrow {
namespace {

// Their sizes in memory_bytes, for any size of pointers.
constexpr std::size_t kWorkBytes = 768, kModelsBytes = 12288;
static_assert(sizeof(ResidualInWork) <= kWorkBytes && sizeof(ResidualModels) <= kModelsBytes);

// Takes memory for the decoded streams: joints and weights that replace the codec's, and one residual per influence.
void take_streams(const MeshStreams& mesh, Memory& memory, ResidualTable& out, std::int32_t*& weights) {
  const std::uint64_t count = mesh.vertex_count;
  out.influences = mesh.apart.influences;
  out.joints = memory.take<std::int32_t>(count * out.influences).data;
  weights = memory.take<std::int32_t>(count * (out.influences - 1)).data;
  for (std::uint32_t j = 0; j < out.influences; ++j) out.rows[j] = memory.take<std::int32_t>(count * 4).data;
}

Stream& stream_of(MeshStreams& mesh, StreamKind kind) {
  return mesh.streams[mesh.find(kind) - mesh.streams];
}

// Writes a vertex's weights to the places of their joints in the larger set that it follows in animation space.
void spread_weights(const MeshStreams& mesh, const ResidualTable& table, std::uint32_t v, std::int32_t* out) {
  const Stream &joints = *mesh.find(StreamKind::joints), &weights = *mesh.find(StreamKind::weights);
  const std::uint32_t own = influence_count(mesh, v);
  const EntrySet set = table.set_of(v);
  std::int32_t left = (1 << weights.bits) - 1;
  std::int32_t* const to = out + std::size_t{v} * (table.influences - 1);
  for (std::uint32_t j = 0; j + 1 < table.influences; ++j) to[j] = 0;
  for (std::uint32_t i = 0; i < own; ++i) {
    const std::int32_t given = i + 1 < own ? weights.values[std::size_t{v} * weights.components + i] : left;
    left -= given;
    for (std::uint32_t j = 0; j + 1 < set.count; ++j)
      if (set.joints[j] == joints.values[std::size_t{v} * joints.components + i]) to[j] = given;
  }
}

// Biases residuals as streams hold them: not negative.
void bias_residual(const ResidualTable& table, std::uint32_t v) {
  for (std::uint32_t j = 0; j < table.influences; ++j)
    for (std::size_t c = 0; c < 4; ++c) table.rows[j][std::size_t{v} * 4 + c] += 1 << (kResidualBits - 1);
}

void replace_streams(const ResidualTable& table, std::int32_t* weights, MeshStreams& mesh) {
  Stream &joints = stream_of(mesh, StreamKind::joints), &of_weights = stream_of(mesh, StreamKind::weights);
  joints.components = static_cast<std::uint8_t>(table.influences);
  joints.values = table.joints;
  of_weights.components = static_cast<std::uint8_t>(table.influences - 1);
  of_weights.values = weights;
  mesh.influences = table.influences;
  for (std::uint32_t j = 0; j < table.influences; ++j) {
    Stream& s = mesh.streams[mesh.stream_count++];
    s = {};
    s.kind = StreamKind::residual;
    s.components = 4;
    s.bits = kResidualBits;
    s.target = j;
    s.origin[0] = mesh.apart.step_of_w;
    s.step = mesh.apart.step;
    s.values = table.rows[j];
  }
}

// Does one step of finding neighbours. After the last one smoothing begins.
const char* find_guess(Memory& memory, ResidualInWork& work) {
  std::uint32_t left = kStepNumbers;
  const ResidualApart& apart = work.mesh.apart;
  bool fits = find_neighbours(work.mesh, memory, work.finding, work.near, left);
  if (fits && work.finding.place == NeighboursInWork::Place::done) {
    fits = work.smoothed.begin(work.mesh, work.near, apart.iterations, apart.share, memory);
    work.place = ResidualInWork::Place::smoothing;
  }
  return fits ? nullptr : "memory_bytes too small";
}

}  // namespace

bool read_residual_apart(ByteReader& reader, MeshStreams& mesh) {
  constexpr std::uint32_t kMostIterations = 1000;
  ResidualApart& apart = mesh.apart;
  apart.iterations = reader.take_varint();
  apart.share = reader.take<std::uint16_t>();
  apart.step_of_w = reader.take<float>();
  apart.step = reader.take<float>();
  apart.bits = reader.take_bytes(reader.take_varint());
  const auto is_step = [](float x) { return x > 1e-30f && x < 1e30f; };
  return apart.iterations <= kMostIterations && apart.share <= Smoothed::kWholeStep && is_step(apart.step_of_w) &&
         is_step(apart.step);
}

ResidualBytes residual_apart_bytes(const MeshStreams& mesh) {
  Memory kept, freed;
  ResidualTable table;
  std::int32_t* weights = nullptr;
  take_streams(mesh, kept, table, weights);
  freed.take<std::byte>(kWorkBytes);
  freed.take<std::byte>(kModelsBytes);
  freed.take<std::byte>(neighbours_bytes(mesh.vertex_count, mesh.triangle_count));
  freed.take<std::byte>(Smoothed::bytes(mesh, mesh.apart.iterations));
  return {kept.whole(), freed.whole()};
}

const char* begin_guess(Memory& memory, ResidualInWork& work) {
  if (const char* const rule = check_streams(work.mesh)) return rule;
  while (work.place == ResidualInWork::Place::neighbours)
    if (const char* const rule = find_guess(memory, work)) return rule;
  return nullptr;
}

bool shift_by_guess(const ResidualInWork& work, std::int32_t sign) {
  return shift_by_guess(work, sign, 0, work.mesh.vertex_count);
}

bool shift_by_guess(const ResidualInWork& work, std::int32_t sign, std::uint32_t from, std::uint32_t end) {
  constexpr std::int32_t kMost = 1 << (kResidualBits - 1);
  const ResidualApart& apart = work.mesh.apart;
  const double step_in_positions =
      static_cast<double>(apart.step) / static_cast<double>(work.mesh.find(StreamKind::position)->step);
  const ResidualGuess guess(work.smoothed, apart.step_of_w, step_in_positions);
  bool fits = true;
  for (std::uint32_t v = from; v < end; ++v) {
    const EntrySet set = work.table.set_of(v);
    ResidualRows guessed;
    guess(work.near.leader[v], set, guessed);
    for (std::uint32_t j = 0; j < set.count; ++j)
      for (std::size_t c = 0; c < 4; ++c) {
        std::int32_t& number = work.table.rows[j][std::size_t{v} * 4 + c];
        number += sign * guessed[j][c];
        fits = fits && number >= -kMost && number < kMost;
      }
  }
  return fits;
}

const char* begin_residual_apart(const MeshStreams& mesh, Memory& memory, ResidualInWork*& out) {
  ResidualTable table;
  std::int32_t* weights = nullptr;
  take_streams(mesh, memory, table, weights);
  const std::size_t kept_end = memory.used;
  const Span<std::byte> place = memory.take<std::byte>(kWorkBytes);
  if (memory.failed) return "memory_bytes too small";
  out = new (place.data) ResidualInWork;
  out->mesh = mesh;
  out->table = table;
  out->weights = weights;
  out->kept_end = kept_end;
  return check_streams(mesh);
}

const char* unpack_residual_apart(ResidualInWork& work, Memory& memory, MeshStreams& mesh, bool& done) {
  using Place = ResidualInWork::Place;
  if (work.place == Place::neighbours) return find_guess(memory, work);
  if (work.place == Place::smoothing) {
    if (!work.smoothed.at_end()) return work.smoothed.step();
    const Span<std::byte> models = memory.take<std::byte>(kModelsBytes);
    if (memory.failed) return "memory_bytes too small";
    work.models = new (models.data) ResidualModels;
    work.decoder = SymbolDecoder(work.mesh.apart.bits);
    work.place = Place::decoding;
  }
  std::uint32_t left = kStepNumbers;
  const std::uint32_t count = mesh.vertex_count;
  if (work.place == Place::decoding) {
    ResidualCodec<SymbolDecoder> codec(work.mesh, work.near, work.smoothed, work.mesh.apart.iterations > 0, work.table,
                                       *work.models, work.decoder);
    for (; work.at < count && left > 0; ++work.at) {
      if (!codec.code(work.at)) return "a residual that is none";
      use_up(32 + work.near.count[work.near.leader[work.at]] / 8, left);
    }
    if (work.at == count && !work.decoder.at_end()) return "a residual of more or fewer bytes";
  } else {
    const bool guessing = work.place == Place::guessing;
    const std::uint32_t end = step_end(work.at, count, kStepNumbers / 16);
    if (guessing && !shift_by_guess(work, 1, work.at, end)) return "a change beyond its bits";
    for (; work.at < end; ++work.at) {
      if (guessing) continue;
      spread_weights(work.mesh, work.table, work.at, work.weights);
      bias_residual(work.table, work.at);
    }
  }
  if (work.at < count) return nullptr;
  work.at = 0;
  work.place = static_cast<Place>(static_cast<std::uint8_t>(work.place) + 1);
  done = work.place == Place::done;
  if (!done) return nullptr;
  replace_streams(work.table, work.weights, mesh);
  memory.used = work.kept_end;
  return nullptr;
}

}  // namespace marrow
