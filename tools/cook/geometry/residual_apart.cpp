#include "cook/geometry/encode_streams.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "common/aligned_bytes.h"
#include "common/failure.h"
#include "cook/geometry/record.h"
#include "unpack/residual.h"

namespace marrow::cook {
namespace {

// Numbers of streams of one kind, vertex by vertex.
using Columns = std::vector<std::vector<std::int32_t>>;

bool is_of_animation_space(StreamKind kind) {
  return is_skin(kind) || kind == StreamKind::residual;
}

// The joints that have a weight, and their weights but the last.
OwnedStreams linear_blend(const OwnedStreams& s) {
  OwnedStreams out = s;
  const std::size_t width = s.mesh.influences;
  std::vector<std::int32_t>&joints = *out.values_of(StreamKind::joints), &weights = *out.values_of(StreamKind::weights);
  const std::vector<std::int32_t> old_joints = std::move(joints), old_weights = std::move(weights);
  const std::int32_t one = (1 << s.find(StreamKind::weights)->bits) - 1;
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> kept(s.mesh.vertex_count);
  std::size_t most = 1;
  for (std::size_t v = 0; v < kept.size(); ++v) {
    std::int32_t left = one;
    for (std::size_t j = 0; j < width; ++j) {
      const std::int32_t joint = old_joints[v * width + j];
      if (j > 0 && joint == old_joints[v * width + j - 1]) break;
      const bool is_last = j + 1 == width || old_joints[v * width + j + 1] == joint;
      const std::int32_t weight = is_last ? left : old_weights[v * (width - 1) + j];
      left -= weight;
      if (weight > 0) kept[v].emplace_back(joint, weight);
    }
    most = std::max(most, kept[v].size());
  }
  joints.clear();
  weights.clear();
  for (const auto& vertex : kept)
    for (std::size_t j = 0; j < most; ++j) {
      joints.push_back(vertex[std::min(j, vertex.size() - 1)].first);
      if (j + 1 < most) weights.push_back(j + 1 < vertex.size() ? vertex[j].second : 0);
    }
  out.mesh.influences = static_cast<std::uint32_t>(most);
  for (Stream& stream : out.streams) {
    if (stream.kind == StreamKind::joints) stream.components = static_cast<std::uint8_t>(most);
    if (stream.kind == StreamKind::weights) stream.components = static_cast<std::uint8_t>(most - 1);
  }
  out.drop([](const Stream& stream, const auto&) { return stream.kind == StreamKind::residual; });
  return out;
}

// The streams that the file comes to: of animation space by where vertices were, all else as it is now.
OwnedStreams joined(const OwnedStreams& old, const OwnedStreams& now, const RowPlaces& places) {
  OwnedStreams out = now;
  out.streams = old.streams;
  out.values.clear();
  out.mesh.influences = old.mesh.influences;
  out.mesh.apart = {};
  const Rows rows(now);
  std::size_t k = 0;  // of now.streams, which lack residuals
  for (std::size_t i = 0; i < old.streams.size(); ++i) {
    const Stream& s = old.streams[i];
    if (is_of_animation_space(s.kind))
      out.values.push_back(
          numbers_of(s, old.values[i], now.mesh.vertex_count, [&](std::size_t v) { return places.at(rows.of(v)); }));
    else
      out.values.push_back(now.values[k]);
    k += s.kind == StreamKind::residual ? 0u : 1u;
  }
  return out;
}

// What unpacking would have in work, of streams in the same order.
class Work {
 public:
  Work(OwnedStreams& linear, OwnedStreams& full) : full_(full), joints_(*full.values_of(StreamKind::joints)) {
    work_.mesh = linear.view();
    work_.table.influences = full.mesh.influences;
    work_.table.joints = joints_.data();
    rows_.reserve(full.mesh.influences);
    for (std::size_t i = 0; i < full.streams.size(); ++i) {
      if (full.streams[i].kind != StreamKind::residual) continue;
      std::vector<std::int32_t>& row = rows_.emplace_back(full.values[i]);
      for (std::int32_t& n : row) n -= 1 << (full.streams[i].bits - 1);
      work_.table.rows[rows_.size() - 1] = row.data();
    }
    memory_ = tools::AlignedBytes(residual_apart_bytes(work_.mesh).freed);
  }

  // False if joints spread too far.
  bool smooth() {
    Memory memory{memory_.data(), 0, memory_.size()};
    const char* rule = begin_guess(memory, work_);
    if (rule != nullptr) throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", rule);
    while (rule == nullptr && !work_.smoothed.at_end()) rule = work_.smoothed.step();
    return rule == nullptr;
  }
  // False if the guess is so far off that differences do not fit.
  bool take_guess() { return shift_by_guess(work_, -1); }

  std::vector<std::byte> encode() {
    SymbolEncoder encoder;
    auto models = std::make_unique<ResidualModels>();
    ResidualCodec<SymbolEncoder> codec(work_.mesh, work_.near, work_.smoothed, work_.mesh.apart.iterations > 0,
                                       work_.table, *models, encoder);
    for (std::uint32_t v = 0; v < work_.mesh.vertex_count; ++v)
      if (!codec.code(v)) throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", "no residual");
    return encoder.finish();
  }

  // Takes the guess itself wherever no number is more than a step from it; but on a border, where other meshes may
  // have the same vertex. Of differences; gives the streams what they come to.
  void follow_guess() {
    const ResidualTable& table = work_.table;
    for (std::uint32_t v = 0; v < work_.mesh.vertex_count; ++v) {
      bool is_near = work_.near.is_inside[work_.near.leader[v]] != 0;
      for (std::uint32_t j = 0; j < table.influences; ++j)
        for (std::size_t c = 0; c < 4; ++c) is_near = is_near && std::abs(table.rows[j][std::size_t{v} * 4 + c]) <= 1;
      for (std::uint32_t j = 0; is_near && j < table.influences; ++j)
        std::fill_n(table.rows[j] + std::size_t{v} * 4, 4, 0);
    }
    shift_by_guess(work_, 1);
    std::int32_t most = 0;
    for (const auto& row : rows_)
      for (const std::int32_t n : row) most = std::max(most, std::abs(n));
    const auto bits = static_cast<std::uint32_t>(1 + bit_length(static_cast<std::uint64_t>(most)));
    std::size_t j = 0;
    for (std::size_t i = 0; i < full_.streams.size(); ++i) {
      if (full_.streams[i].kind != StreamKind::residual) continue;
      full_.streams[i].bits = static_cast<std::uint8_t>(bits);
      full_.values[i] = rows_[j++];
      for (std::int32_t& n : full_.values[i]) n += 1 << (bits - 1);
    }
  }

 private:
  OwnedStreams& full_;
  std::vector<std::int32_t> joints_;
  Columns rows_;
  ResidualInWork work_;
  tools::AlignedBytes memory_;
};

ResidualApart settings_of(const OwnedStreams& s, const ResidualSource& source) {
  ResidualApart out;
  const Stream& residual = *s.find(StreamKind::residual);
  out.influences = s.mesh.influences;
  out.iterations = static_cast<std::uint32_t>(source.iterations);
  out.share = static_cast<std::uint32_t>(std::lround(source.step * Smoothed::kWholeStep));
  out.step_of_w = residual.origin[0];
  out.step = residual.step;
  return out;
}

}  // namespace

std::optional<PackedApart> pack_apart(OwnedStreams& streams, const ResidualSource& source,
                                      const std::function<std::vector<std::byte>(OwnedStreams&)>& encode) {
  const Stream *const residual = streams.find(StreamKind::residual), *const weights = streams.find(StreamKind::weights);
  if (residual == nullptr || residual->bits == 0 || weights == nullptr || streams.find(StreamKind::joints) == nullptr ||
      streams.find(StreamKind::multi_weight) != nullptr)
    return {};
  PackedApart out;
  out.streams = linear_blend(streams);
  if (out.streams.mesh.influences < 2) return {};
  out.streams.mesh.apart = settings_of(streams, source);
  OwnedStreams full = streams;
  if (source.is_all && source.iterations > 0) {
    Work work(out.streams, full);
    if (work.smooth() && work.take_guess()) work.follow_guess();
  }
  const Rows before(out.streams);
  const RowPlaces places = places_of(before, Rows(full), out.streams.mesh.vertex_count);
  if (places.empty()) return {};
  out.encoded = encode(out.streams);
  full = joined(full, out.streams, places);
  bool is_encoded = false;
  for (const std::uint32_t iterations : {out.streams.mesh.apart.iterations, 0u}) {
    ResidualApart attempt = out.streams.mesh.apart;
    attempt.iterations = iterations;
    OwnedStreams linear = out.streams;
    linear.mesh.apart = attempt;
    Work work(linear, full);
    if (!work.smooth() || !work.take_guess()) continue;
    std::vector<std::byte> bits = work.encode();
    if (is_encoded && bits.size() >= out.streams.residual_bits.size()) continue;
    out.streams.residual_bits = std::move(bits);
    out.streams.mesh.apart = attempt;
    is_encoded = true;
  }
  if (!is_encoded) return {};
  streams = std::move(full);
  return out;
}

}  // namespace marrow::cook
