// Codes as bits which joints a vertex follows in animation space beside its own, and its residual. The cooker, which
// writes them, and unpacking share this source.
#pragma once

#include "unpack/entry_set.h"
#include "unpack/neighbours.h"
#include "unpack/smoothed.h"
#include "unpack/symbol_coder.h"

namespace marrow {

// The numbers of a vertex: x, y, z, w of each joint of its set.
using ResidualRows = std::int32_t[kMaxInfluences][4];

// Models of whole numbers, by how large they are expected to be.
struct NumberModels {
  static constexpr std::uint32_t kSizes = 12, kLengths = 16, kMostLength = 24;
  BitModel is_some[kSizes], is_negative, is_longer[kSizes][kLengths], second[kMostLength + 1];
};

struct ResidualModels {
  BitModel is_like_leader, is_as_guessed[2][4];
  BitModel carried[8][4][kMaxInfluences + 1];  // by weight, by neighbours that follow it, by room
  BitModel of_neighbour[4][kMaxInfluences + 1], is_another[2];
  NumberModels numbers[2][3];  // x, y, z or w; of the last joint, the first or others
};

// What is coded for all vertices: their sets, and their residuals less the guess.
struct ResidualTable {
  std::uint32_t influences = 1;
  std::int32_t* joints = nullptr;           // influences a vertex; the last repeats
  std::int32_t* rows[kMaxInfluences] = {};  // an influence: four a vertex

  EntrySet set_of(std::uint32_t vertex) const {
    return read_set(joints + std::size_t{vertex} * influences, influences);
  }
  void write_set(std::uint32_t vertex, const EntrySet& set) const {
    marrow::write_set(set, influences, joints + std::size_t{vertex} * influences);
  }
};

// The guess at a vertex's residual, in steps, from what its leader carries: d_j = (c_j - W_j / W Σ c) / W and δ_j = W_j
// / W - v_j. c_j is the weighted offset of joint j, W_j its carried weight, v_j the vertex's own weight of it, and W =
// Σ W_j over the joints of the set. Joints that are not carried count as 0.
class ResidualGuess {
 public:
  // step_of_w: the step of residuals' w. step_in_positions: the step of their x, y, z, in steps of positions. A step
  // that is 0 or not finite makes the guess useless.
  ResidualGuess(const Smoothed& smoothed, float step_of_w, double step_in_positions)
      : smoothed_(&smoothed), of_w_(1.0 / static_cast<double>(step_of_w)), of_d_(1.0 / step_in_positions) {}

  void operator()(std::uint32_t leader, const EntrySet& set, ResidualRows& out) const {
    const Smoothed::Joints joints = smoothed_->of(leader);
    std::int32_t weights[kMaxInfluences] = {}, own[kMaxInfluences] = {};
    double offsets[kMaxInfluences][3] = {}, offset[3] = {};
    std::int64_t weight = 0;
    for (std::uint32_t k = 0; k < set.count; ++k) {
      for (std::uint32_t i = 0; i < joints.all; ++i) {
        const Carried& carried = joints.carried[i];
        if (carried.joint != set.joints[k]) continue;
        weights[k] = carried.weight;
        if (i < joints.own) own[k] = smoothed_->own_weight(leader, i);
        for (int c = 0; c < 3; ++c) offset[c] += offsets[k][c] = static_cast<double>(carried.offset[c]);
      }
      weight += weights[k];
    }
    double carry[4] = {};  // each joint's rounding error goes to the next: if joints move alike, it hardly shows
    const double all = static_cast<double>(weight > 0 ? weight : 1), one = static_cast<double>(smoothed_->one());
    for (std::uint32_t k = 0; k < set.count; ++k) {
      const double share = static_cast<double>(weights[k]) / all;
      for (int c = 0; c < 3; ++c) out[k][c] = whole((offsets[k][c] - share * offset[c]) / all * of_d_, carry[c]);
      out[k][3] = whole((share - static_cast<double>(own[k]) / one) * of_w_, carry[3]);
    }
  }

 private:
  // The nearest integer; 0 for numbers that are out of range or NaN.
  static std::int32_t whole(double x, double& carry) {
    constexpr double kMost = 1 << 22;
    if (!(x > -kMost && x < kMost)) return 0;
    x += carry;
    const auto out = static_cast<std::int32_t>(x < 0 ? x - 0.5 : x + 0.5);
    carry = x - static_cast<double>(out);
    return out;
  }

  const Smoothed* smoothed_;
  double of_w_, of_d_;
};

// Coder: SymbolDecoder, or an encoder that has the same functions. An encoder's table holds what is to be written; a
// decoder's is filled in.
template <class Coder>
class ResidualCodec {
 public:
  ResidualCodec(const MeshStreams& mesh, const MeshNeighbours& near, const Smoothed& smoothed, bool is_smoothed,
                const ResidualTable& table, ResidualModels& models, Coder& coder)
      : mesh_(mesh),
        near_(near),
        smoothed_(smoothed),
        mean_divisor_(is_smoothed ? 2 : 1),
        table_(table),
        models_(models),
        coder_(coder) {}

  // Codes one vertex; vertices come in order. False if the bits are none that an encoder writes.
  bool code(std::uint32_t vertex) {
    const std::uint32_t leader = near_.leader[vertex];
    for (std::uint32_t j = 0; !Coder::kEncodes && j < table_.influences; ++j)
      for (int c = 0; c < 4; ++c) row(j, vertex)[c] = 0;
    if (leader != vertex && coder_.bit(models_.is_like_leader, Coder::kEncodes && is_same(vertex, leader))) {
      copy(leader, vertex);
      return true;
    }
    find_earlier(vertex, leader);
    EntrySet set;
    if (!code_set(vertex, leader, set)) return false;
    table_.write_set(vertex, set);
    return code_rows(vertex, set);
  }

 private:
  static constexpr std::uint32_t kMostEarlier = 8, kMostTried = 24, kNumberBits = 24;

  std::int32_t* row(std::uint32_t influence, std::uint32_t vertex) const {
    return table_.rows[influence] + std::size_t{vertex} * 4;
  }
  bool is_same(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t j = 0; j < table_.influences; ++j) {
      if (table_.joints[std::size_t{a} * table_.influences + j] !=
          table_.joints[std::size_t{b} * table_.influences + j])
        return false;
      for (int c = 0; c < 4; ++c)
        if (row(j, a)[c] != row(j, b)[c]) return false;
    }
    return true;
  }
  void copy(std::uint32_t from, std::uint32_t to) const {
    table_.write_set(to, table_.set_of(from));
    for (std::uint32_t j = 0; j < table_.influences; ++j)
      for (int c = 0; c < 4; ++c) row(j, to)[c] = row(j, from)[c];
  }

  // Finds the neighbours that have been coded already.
  void find_earlier(std::uint32_t vertex, std::uint32_t leader) {
    earlier_count_ = 0;
    const std::uint32_t* const all = near_.all + near_.first[leader];
    for (std::uint32_t i = 0; i < near_.count[leader] && earlier_count_ < kMostEarlier; ++i)
      if (all[i] < vertex) {
        earlier_[earlier_count_] = all[i];
        sets_[earlier_count_++] = table_.set_of(all[i]);
      }
  }
  // How many of the earlier neighbours follow the joint: 1 none, 2 some, 3 all. 0 if there are no earlier neighbours.
  std::uint32_t followed(std::int32_t joint) const {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < earlier_count_; ++i) count += sets_[i].has(joint) ? 1u : 0u;
    return earlier_count_ == 0 ? 0 : count == 0 ? 1 : count < earlier_count_ ? 2 : 3;
  }

  bool code_set(std::uint32_t vertex, std::uint32_t leader, EntrySet& set) {
    const Smoothed::Joints joints = smoothed_.of(leader);
    const EntrySet wanted = Coder::kEncodes ? table_.set_of(vertex) : EntrySet();
    for (std::uint32_t j = 0; j < joints.own; ++j) {
      if (set.has(joints.carried[j].joint)) return false;
      set.add(joints.carried[j].joint);
    }
    std::int32_t tried[kMostTried];
    std::uint32_t tried_count = 0;
    const auto room = [&] { return table_.influences - set.count; };
    const auto offer = [&](std::int32_t joint, BitModel& model) {
      tried[tried_count++] = joint;
      if (coder_.bit(model, wanted.has(joint))) set.add(joint);
    };
    for (std::uint32_t j = joints.own; j < joints.all && room() > 0; ++j) {
      const Carried& it = joints.carried[j];
      const std::uint32_t length = bit_length(static_cast<std::uint32_t>(it.weight));
      const std::uint32_t size = length > packed::kMaxWeightBits ? 0 : packed::kMaxWeightBits - length;
      offer(it.joint, models_.carried[size < 7 ? size : 7][followed(it.joint)][room()]);
    }
    for (std::uint32_t i = 0; i < earlier_count_; ++i)
      for (std::uint32_t j = 0; j < sets_[i].count && room() > 0 && tried_count < kMostTried; ++j) {
        const std::int32_t joint = sets_[i].joints[j];
        bool is_new = !set.has(joint);
        for (std::uint32_t k = 0; k < tried_count; ++k) is_new = is_new && tried[k] != joint;
        if (is_new) offer(joint, models_.of_neighbour[followed(joint)][room()]);
      }
    return code_others(wanted, set);
  }

  // Joints that nothing hinted at.
  bool code_others(const EntrySet& wanted, EntrySet& set) {
    BitModel& model = models_.is_another[earlier_count_ > 0 ? 1 : 0];
    while (set.count < table_.influences && coder_.bit(model, set.count < wanted.count)) {
      std::int32_t next = 0;
      for (std::uint32_t j = 0; j < wanted.count; ++j)
        if (!set.has(wanted.joints[j])) next = wanted.joints[j];
      std::int32_t joint = 0;
      for (std::uint32_t bit = bit_length(mesh_.joint_count - 1); bit-- > 0;)
        joint |= (coder_.even_bit((next >> bit & 1) != 0) ? 1 : 0) << bit;
      if (static_cast<std::uint32_t>(joint) >= mesh_.joint_count || set.has(joint)) return false;
      set.add(joint);
    }
    return true;
  }

  // Totals over earlier neighbours. size: in sixteenths, of x, y, z together and of w. sum: of x, y, z and w.
  struct Seen {
    std::int64_t size[2] = {}, sum[4] = {};
    std::int64_t count = 0;
  };
  static void see(const std::int32_t* numbers, Seen& seen) {
    std::int64_t sum = 0;
    for (int c = 0; c < 3; ++c) sum += size_of(numbers[c]);
    seen.size[0] += sum / 3;
    seen.size[1] += size_of(numbers[3]);
    for (int c = 0; c < 4; ++c) seen.sum[c] += numbers[c];
    ++seen.count;
  }
  static std::int64_t size_of(std::int32_t x) { return 16 * std::int64_t{x < 0 ? -x : x}; }

  bool code_rows(std::uint32_t vertex, const EntrySet& set) {
    Seen all, of_joint[kMaxInfluences];
    std::uint32_t zeros = 0;
    for (std::uint32_t i = 0; i < earlier_count_; ++i) {
      bool is_zero = true;
      for (std::uint32_t j = 0; j < sets_[i].count; ++j) {
        const std::int32_t* const numbers = row(j, earlier_[i]);
        for (int c = 0; c < 4; ++c) is_zero = is_zero && numbers[c] == 0;
        see(numbers, all);
        for (std::uint32_t k = 0; k < set.count; ++k)
          if (set.joints[k] == sets_[i].joints[j]) see(numbers, of_joint[k]);
      }
      zeros += is_zero ? 1 : 0;
    }
    bool as_guessed = Coder::kEncodes;
    for (std::uint32_t j = 0; Coder::kEncodes && j < set.count; ++j)
      for (int c = 0; c < 4; ++c) as_guessed = as_guessed && row(j, vertex)[c] == 0;
    const std::uint32_t near = earlier_count_ == 0 ? 0 : zeros == earlier_count_ ? 1 : zeros == 0 ? 2 : 3;
    as_guessed = coder_.bit(models_.is_as_guessed[set.count > 1 ? 1 : 0][near], as_guessed);
    return as_guessed || code_numbers(vertex, set, all, of_joint);
  }

  bool code_numbers(std::uint32_t vertex, const EntrySet& set, const Seen& all,
                    const Seen (&of_joint)[kMaxInfluences]) {
    std::int64_t here[2] = {}, here_count[2] = {};
    std::int32_t sum[4] = {};
    for (std::uint32_t k = 0; k < set.count; ++k) {
      const bool is_last = k + 1 == set.count && k > 0;
      const Seen& seen = of_joint[k];
      for (int c = 3; c >= 0; --c) {
        const int kind = c == 3 ? 1 : 0;
        // The last joint is expected to make the sum 0, the others to be like their neighbours.
        const std::int32_t guess = is_last ? -sum[c] : mean(seen.sum[c], seen.count * mean_divisor_);
        std::int64_t size = 0, shares = 0;
        const auto expect = [&](std::int64_t total, std::int64_t count, std::int64_t share) {
          size += share * (total / count);
          shares += share;
        };
        if (!is_last && seen.count > 0) expect(seen.size[kind], seen.count, 2);
        if (!is_last && seen.count == 0 && all.count > 0) expect(all.size[kind], all.count, 1);
        if (here_count[kind] > 0) expect(here[kind], here_count[kind], 2);
        NumberModels& models = models_.numbers[kind][is_last ? 0 : k == 0 ? 1 : 2];
        std::int32_t& number = row(k, vertex)[c];
        number = guess + code_number(models, shares > 0 ? bucket(size / shares) : NumberModels::kSizes - 1,
                                     Coder::kEncodes ? number - guess : 0);
        if (number >> kNumberBits != 0 && number >> kNumberBits != -1) return false;
        here[kind] += size_of(number);
        ++here_count[kind];
        sum[c] += number;
      }
    }
    return true;
  }
  static std::int32_t mean(std::int64_t sum, std::int64_t count) {
    return count == 0 ? 0 : static_cast<std::int32_t>((sum < 0 ? sum - count / 2 : sum + count / 2) / count);
  }
  static std::uint32_t bucket(std::int64_t size) {
    constexpr std::int64_t kEnds[] = {1, 4, 8, 13, 19, 28, 42, 64, 110, 220};
    std::uint32_t out = 0;
    while (out + 2 < NumberModels::kSizes && size >= kEnds[out]) ++out;
    return out;
  }

  // Codes whether the number is 0, its sign, its length in unary (ones, then a zero), and the bits behind the first.
  std::int32_t code_number(NumberModels& models, std::uint32_t size, std::int32_t number) {
    if (!coder_.bit(models.is_some[size], number != 0)) return 0;
    const bool negative = coder_.bit(models.is_negative, number < 0);
    const auto wanted = static_cast<std::uint32_t>(negative ? -number : number);
    std::uint32_t length = 0;
    while (length < NumberModels::kMostLength &&
           coder_.bit(models.is_longer[size][length < NumberModels::kLengths ? length : NumberModels::kLengths - 1],
                      wanted >> length > 1))
      ++length;
    std::uint32_t out = 1;
    for (std::uint32_t bit = length; bit-- > 0;) {
      const bool wants = (wanted >> bit & 1) != 0;
      out = out << 1 |
            ((bit + 1 == length ? coder_.bit(models.second[length], wants) : coder_.even_bit(wants)) ? 1u : 0u);
    }
    return negative ? -static_cast<std::int32_t>(out) : static_cast<std::int32_t>(out);
  }

  const MeshStreams& mesh_;
  const MeshNeighbours& near_;
  const Smoothed& smoothed_;
  std::int64_t mean_divisor_;
  ResidualTable table_;
  ResidualModels& models_;
  Coder& coder_;
  std::uint32_t earlier_[kMostEarlier], earlier_count_ = 0;
  EntrySet sets_[kMostEarlier];
};

}  // namespace marrow
