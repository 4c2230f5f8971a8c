// Joints and weights of vertices as bits, where a record has them apart from the codec's streams
// (docs/format.md, "Skins apart"): one text for the cooker, which writes them, and for unpacking.
#pragma once

#include <vector>

#include "unpack/entry_set.h"
#include "unpack/streams.h"
#include "unpack/symbol_coder.h"

namespace marrow {

// Weights have fewer bits than a symbol can say.
inline constexpr std::uint32_t kMostWeightBits = 15;

struct SkinModels {
  static constexpr std::uint32_t kSizes = 12;
  BitModel is_like_twin, is_like_first[2][4], is_like_second[2];
  BitModel follows[2][4], is_another[kMaxInfluences];
  SymbolModel distances, weights[kSizes];

  void begin();
};

// Of each vertex earlier ones that it is likely to be like; itself: there is none. A twin stands where the vertex does;
// the others are corners of a triangle whose latest one it is: the first of them the latest that it can be, the second
// as well. Which triangle comes first does not count, as others than Draco order them.
struct SkinBefore {
  std::vector<std::uint32_t> twin, first, second;

  // Triangles name vertices of the mesh.
  explicit SkinBefore(const MeshStreams& mesh);
};

// Coder: SymbolDecoder, or an encoder that has the same functions. An encoder's streams hold what is to be written; a
// decoder's are filled in. The mesh has more than one joint.
template <class Coder>
class SkinCodec {
 public:
  SkinCodec(const MeshStreams& mesh, const SkinBefore& before, SkinModels& models, Coder& coder)
      : mesh_(mesh),
        joints_(mesh.find(StreamKind::joints)->values),
        weights_(mesh.influences > 1 ? mesh.find(StreamKind::weights)->values : nullptr),
        one_(mesh.influences > 1 ? (1 << mesh.find(StreamKind::weights)->bits) - 1 : 1),
        before_(before),
        spread_(mesh.vertex_count),
        models_(models),
        coder_(coder) {}

  // The next vertex's, in their order. False if it is nothing that an encoder writes.
  bool code(std::uint32_t vertex) {
    const std::uint32_t twin = before_.twin[vertex];
    if (twin != vertex && coder_.bit(models_.is_like_twin, Coder::kEncodes && is_same(vertex, twin))) {
      copy(twin, vertex);
      return true;
    }
    first_ = neighbour(vertex, before_.first[vertex]);
    second_ = neighbour(vertex, before_.second[vertex]);
    EntrySet set;
    if (!code_set(vertex, set)) return false;
    write_set(set, mesh_.influences, joints_ + std::size_t{vertex} * mesh_.influences);
    return mesh_.influences == 1 || code_weights(vertex, set);
  }

 private:
  struct Neighbour {
    EntrySet set;
    std::int32_t weights[kMaxInfluences] = {};
    std::uint32_t spread = 0;

    std::int32_t weight_of(std::int32_t joint) const {
      for (std::uint32_t i = 0; i < set.count; ++i)
        if (set.joints[i] == joint) return weights[i];
      return 0;
    }
  };

  std::int32_t* weights_of(std::uint32_t vertex) const {
    return weights_ + std::size_t{vertex} * (mesh_.influences - 1);
  }
  EntrySet set_of(std::uint32_t vertex) const {
    return read_set(joints_ + std::size_t{vertex} * mesh_.influences, mesh_.influences);
  }
  bool is_same(std::uint32_t a, std::uint32_t b) const {
    const std::size_t width = mesh_.influences;
    for (std::size_t j = 0; j < width; ++j)
      if (joints_[a * width + j] != joints_[b * width + j]) return false;
    for (std::size_t j = 0; j + 1 < width; ++j)
      if (weights_of(a)[j] != weights_of(b)[j]) return false;
    return true;
  }
  void copy(std::uint32_t from, std::uint32_t to) {
    const std::size_t width = mesh_.influences;
    for (std::size_t j = 0; j < width; ++j) joints_[to * width + j] = joints_[from * width + j];
    for (std::size_t j = 0; j + 1 < width; ++j) weights_of(to)[j] = weights_of(from)[j];
    spread_[to] = spread_[from];
  }
  // One that follows nothing, if there is none.
  Neighbour neighbour(std::uint32_t vertex, std::uint32_t other) const {
    Neighbour out;
    if (other == vertex) return out;
    out.set = set_of(other);
    out.spread = spread_[other];
    std::int32_t left = one_;
    for (std::uint32_t i = 0; i + 1 < out.set.count; ++i) left -= out.weights[i] = weights_of(other)[i];
    out.weights[out.set.count - 1] = left;
    return out;
  }
  static bool same(const EntrySet& a, const EntrySet& b) {
    bool is = a.count == b.count;
    for (std::uint32_t i = 0; is && i < a.count; ++i) is = a.joints[i] == b.joints[i];
    return is;
  }

  bool code_set(std::uint32_t vertex, EntrySet& set) {
    const EntrySet wanted = Coder::kEncodes ? set_of(vertex) : EntrySet();
    const EntrySet &a = first_.set, &b = second_.set;
    const bool differ = !same(a, b);
    if (a.count > 0) {
      BitModel& model = models_.is_like_first[differ ? 1 : 0][a.count < 4 ? a.count - 1 : 3];
      if (coder_.bit(model, same(wanted, a))) return set = a, true;
      if (b.count > 0 && differ && coder_.bit(models_.is_like_second[b.count < a.count ? 1 : 0], same(wanted, b)))
        return set = b, true;
    }
    for (std::uint32_t i = 0, j = 0; i < a.count || j < b.count;) {
      const bool from_a = j == b.count || (i < a.count && a.joints[i] <= b.joints[j]);
      const std::int32_t joint = from_a ? a.joints[i] : b.joints[j];
      const bool both = from_a && j < b.count && b.joints[j] == joint;
      i += from_a ? 1 : 0;
      j += !from_a || both ? 1 : 0;
      if (set.count == mesh_.influences) continue;
      if (coder_.bit(models_.follows[both ? 1 : 0][importance(joint)], wanted.has(joint))) set.add(joint);
    }
    return code_others(wanted, set);
  }
  // By the larger of its weights.
  std::uint32_t importance(std::int32_t joint) const {
    const std::int64_t a = first_.weight_of(joint), b = second_.weight_of(joint), most = a > b ? a : b;
    return most * 16 < one_ ? 0 : most * 4 < one_ ? 1 : most * 4 < 3 * std::int64_t{one_} ? 2 : 3;
  }
  // Joints that no neighbour follows, each by how far it is from the one before.
  bool code_others(const EntrySet& wanted, EntrySet& set) {
    std::int32_t last = first_.set.joints[0];
    std::uint32_t next = 0;
    while (set.count < mesh_.influences) {
      while (next < wanted.count && set.has(wanted.joints[next])) ++next;
      const bool more = next < wanted.count;
      if (set.count > 0 && !coder_.bit(models_.is_another[set.count], more)) return true;
      const std::int32_t joint = last + code_number(models_.distances, more ? wanted.joints[next] - last : 0);
      if (joint < 0 || joint >= static_cast<std::int32_t>(mesh_.joint_count) || set.has(joint)) return false;
      set.add(joint);
      last = joint;
    }
    return true;
  }

  bool code_weights(std::uint32_t vertex, const EntrySet& set) {
    std::int32_t* const out = weights_of(vertex);
    for (std::uint32_t j = set.count - 1; !Coder::kEncodes && j + 1 < mesh_.influences; ++j) out[j] = 0;
    std::int64_t expected[kMaxInfluences], all = 0;
    std::uint32_t apart[kMaxInfluences];
    for (std::uint32_t k = 0; k < set.count; ++k) {
      const std::int32_t a = first_.weight_of(set.joints[k]), b = second_.weight_of(set.joints[k]);
      all += expected[k] = std::int64_t{a} + b;
      apart[k] = static_cast<std::uint32_t>(a < b ? b - a : a - b);
    }
    std::int32_t left = one_;
    const std::uint32_t near = first_.spread + second_.spread;
    std::uint32_t missed = 0;
    for (std::uint32_t k = 0; k + 1 < set.count; ++k) {
      const std::int64_t guess = all > 0 ? (left * expected[k] + all / 2) / all : left / std::int64_t{set.count - k};
      const std::uint32_t size = bit_length(apart[k] / 2 + near + missed);
      SymbolModel& model = models_.weights[size < SkinModels::kSizes ? size : SkinModels::kSizes - 1];
      const std::int32_t wanted = Coder::kEncodes ? out[k] - static_cast<std::int32_t>(guess) : 0;
      const std::int32_t change = code_number(model, wanted);
      const std::int64_t weight = guess + change;
      if (weight < 0 || weight > left) return false;
      out[k] = static_cast<std::int32_t>(weight);
      left -= out[k];
      all -= expected[k];
      missed = static_cast<std::uint32_t>(change < 0 ? -change : change);
      spread_[vertex] = static_cast<std::uint16_t>(missed < 65535 ? missed : 65535);
    }
    if (set.count == 1) spread_[vertex] = static_cast<std::uint16_t>(near / 2);
    return true;
  }

  // Its length in bits is the symbol; then the sign and what stands behind the first bit.
  std::int32_t code_number(SymbolModel& model, std::int32_t number) {
    const auto wanted = static_cast<std::uint32_t>(number < 0 ? -number : number);
    const std::uint32_t length = coder_.symbol(model, bit_length(wanted)), first = 1u << length >> 1;
    const std::uint32_t behind = coder_.raw_bits(length, (wanted - first) << 1 | (number < 0 ? 1u : 0u));
    const auto out = static_cast<std::int32_t>(first + (behind >> 1));
    return (behind & 1) != 0 ? -out : out;
  }

  const MeshStreams& mesh_;
  std::int32_t *joints_, *weights_;
  std::int32_t one_;
  const SkinBefore& before_;
  std::vector<std::uint16_t> spread_;  // a vertex: by how much its last weight was missed
  SkinModels& models_;
  Coder& coder_;
  Neighbour first_, second_;
};

}  // namespace marrow
