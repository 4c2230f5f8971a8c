#include "deform/elastic/rounds.h"

#include <glm/geometric.hpp>

#include "math/f32x4.h"

namespace marrow::deform {
namespace {

constexpr int kRounds = 16;
constexpr float kBeyond = 1.6f;              // of the way to the least energy, as the rotations are not yet there
constexpr int kExact = 2;                    // rounds at the end that go just there
constexpr int kFirstTurns = 30, kTurns = 3;  // steps towards the nearest rotation
constexpr float kAsNeighbours = 2;
constexpr float kLeastVolume = 0.05f;   // below that a cell has lost its way, and volume says nothing
constexpr float kLeastStretch = 1e-3f;  // of a joint's volume

using Columns = std::array<Four, 3>;

// Vectors of four cells.
struct Vectors {
  f32x4 x, y, z;
};
Vectors operator+(const Vectors& a, const Vectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vectors operator-(const Vectors& a, const Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vectors operator*(const Vectors& a, f32x4 s) {
  return {a.x * s, a.y * s, a.z * s};
}
f32x4 dot(const Vectors& a, const Vectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vectors cross(const Vectors& a, const Vectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vectors select(mask4 m, const Vectors& yes, const Vectors& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

// Matrices of four cells, by columns.
struct Matrices {
  Vectors c[3];
};

f32x4 loaded(const Four& from) {
  return load_aligned(from.v);
}

// Column c of four matrices beside each other.
Vectors transposed(f32x4 a, f32x4 b, f32x4 c, f32x4 d) {
  transpose(a, b, c, d);
  return {a, b, c};
}

struct Quaternions {
  f32x4 x, y, z, w;
};

Matrices matrices_of(const Quaternions& q) {
  const f32x4 one = splat(1.0f), x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const f32x4 xx = q.x * x2, yy = q.y * y2, zz = q.z * z2, xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
  const f32x4 wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
  return {
      {{one - (yy + zz), xy + wz, xz - wy}, {xy - wz, one - (xx + zz), yz + wx}, {xz + wy, yz - wx, one - (xx + yy)}}};
}

// Towards the rotation nearest to `a`: Müller, Bender, Chentanez, Macklin, "A robust method to extract the rotational
// part of deformations", MIG 2016; the turn as a quaternion to the first order, made a unit.
void turn_towards(const Matrices& a, int steps, Quaternions& q) {
  for (int i = 0; i < steps; ++i) {
    const Matrices r = matrices_of(q);
    const Vectors arm = cross(r.c[0], a.c[0]) + cross(r.c[1], a.c[1]) + cross(r.c[2], a.c[2]);
    const f32x4 along = absolute(dot(r.c[0], a.c[0]) + dot(r.c[1], a.c[1]) + dot(r.c[2], a.c[2]));
    const Vectors h = arm * (splat(0.5f) / (along + splat(1e-9f)));
    const Quaternions n = {q.x + (h.x * q.w + h.y * q.z - h.z * q.y), q.y + (h.y * q.w + h.z * q.x - h.x * q.z),
                           q.z + (h.z * q.w + h.x * q.y - h.y * q.x), q.w - (h.x * q.x + h.y * q.y + h.z * q.z)};
    const f32x4 over_length = inverse_length(n.x * n.x + n.y * n.y + n.z * n.z + n.w * n.w);
    q = {n.x * over_length, n.y * over_length, n.z * over_length, n.w * over_length};
  }
}

// The matrix of a volume that is next to f, by Newton's steps along the gradient of the volume.
Matrices with_volume(Matrices f, f32x4 volume) {
  for (int i = 0; i < 3; ++i) {
    const Matrices n = {{cross(f.c[1], f.c[2]), cross(f.c[2], f.c[0]), cross(f.c[0], f.c[1])}};
    const f32x4 squares = dot(n.c[0], n.c[0]) + dot(n.c[1], n.c[1]) + dot(n.c[2], n.c[2]);
    const f32x4 far = (dot(f.c[0], n.c[0]) - volume) / (squares + splat(1e-20f));
    for (int c = 0; c < 3; ++c) f.c[c] = f.c[c] - n.c[c] * far;
  }
  return f;
}

// What a round knows of a cell: its gradient, then what that pulls with; and its four modes that are none.
struct Modes {
  Columns gradient;
  std::array<Four, 4> bent;  // xy, xz, yz, xyz
};

class Rounds {
 public:
  Rounds(const Body& body, const Carried& carried)
      : body_(body), cells_(body.cells.size()), turned_(body.cells.size() + 1), turn_(body.cells.size()) {
    for (const glm::dvec3& p : carried.places)
      rig_.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 0}});
    places_ = rig_;
    for (std::size_t c = 0; c < body.cells.size(); ++c) begin(c, carried);
  }

  BodyShape run() {
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t c = 0; c < body_.free; ++c) find_modes(c);
      for (std::size_t c = 0; c < body_.free; c += 4)
        stretches_.empty() ? turn<false>(c, round == 0) : turn<true>(c, round == 0);
      move(round == 0 || round + kExact >= kRounds ? 1.0f : kBeyond);
    }
    return result();
  }

 private:
  // The blend of its corners' turns and stretches.
  void begin(std::size_t c, const Carried& carried) {
    const ElasticCell& cell = body_.cells[c];
    glm::dquat sum(0, 0, 0, 0);
    glm::dmat3 stretch(0);
    for (const std::uint32_t n : cell.nodes) {
      const glm::dquat& q = carried.turns[n];
      sum = glm::dot(q, carried.turns[cell.nodes[0]]) < 0 ? sum - q : sum + q;
      if (!carried.stretches.empty()) stretch += carried.stretches[n] * 0.125;
    }
    const double length = glm::length(sum);
    sum = length > 1e-6 ? sum / length : carried.turns[cell.nodes[0]];
    turn_[c] = {
        {static_cast<float>(sum.x), static_cast<float>(sum.y), static_cast<float>(sum.z), static_cast<float>(sum.w)}};
    const glm::dmat3 r = glm::mat3_cast(sum);
    for (int i = 0; i < 3; ++i) turned_[c][static_cast<std::size_t>(i)] = four(r[i]);
    if (carried.stretches.empty()) return;
    Columns& out = stretches_.emplace_back();
    for (int i = 0; i < 3; ++i) out[static_cast<std::size_t>(i)] = four(stretch[i]);
  }
  static Four four(const glm::dvec3& v) {
    return {{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0}};
  }

  void find_modes(std::size_t c) {
    const ElasticCell& cell = body_.cells[c];
    const auto at = [&](std::size_t k) { return loaded(places_[cell.nodes[k]]); };
    const f32x4 x0 = at(1) - at(0), x1 = at(3) - at(2), x2 = at(5) - at(4), x3 = at(7) - at(6);
    const f32x4 s0 = at(1) + at(0), s1 = at(3) + at(2), s2 = at(5) + at(4), s3 = at(7) + at(6);
    const f32x4 low = s1 - s0, high = s3 - s2, quarter = splat(0.25f);
    Modes& out = cells_[c];
    store(out.gradient[0].v, ((x0 + x1) + (x2 + x3)) * quarter);
    store(out.gradient[1].v, (low + high) * quarter);
    store(out.gradient[2].v, ((s2 - s0) + (s3 - s1)) * quarter);
    store(out.bent[0].v, (x1 - x0) + (x3 - x2));
    store(out.bent[1].v, (x2 + x3) - (x0 + x1));
    store(out.bent[2].v, high - low);
    store(out.bent[3].v, (x3 - x2) - (x1 - x0));
  }

  // Of four cells from c: their gradients times their stretches.
  f32x4 unstretched(std::size_t c, std::size_t column) const {
    const Columns& f = cells_[c].gradient;
    const Four& s = stretches_[c][column];
    return loaded(f[0]) * splat(s.v[0]) + loaded(f[1]) * splat(s.v[1]) + loaded(f[2]) * splat(s.v[2]);
  }

  template <bool Stretched>
  f32x4 wanted(std::size_t c, std::size_t column) const {
    f32x4 sum = splat(0.0f);
    for (const std::uint32_t b : body_.cells[c].beside) sum = sum + loaded(turned_[b][column]);
    const f32x4 own = Stretched ? unstretched(c, column) : loaded(cells_[c].gradient[column]);
    return own + sum * splat(kAsNeighbours);
  }

  template <bool Stretched>
  void turn(std::size_t c, bool is_first) {
    Matrices a;
    for (std::size_t i = 0; i < 3; ++i)
      a.c[i] = transposed(wanted<Stretched>(c, i), wanted<Stretched>(c + 1, i), wanted<Stretched>(c + 2, i),
                          wanted<Stretched>(c + 3, i));
    Quaternions q;
    load_transposed(turn_[c].v, turn_[c + 1].v, turn_[c + 2].v, turn_[c + 3].v, q.x, q.y, q.z, q.w);
    turn_towards(a, is_first ? kFirstTurns : kTurns, q);
    const Matrices r = matrices_of(q);
    for (std::size_t i = 0; i < 3; ++i) put(r.c[i], c, [&](std::size_t k) { return turned_[k][i].v; });
    transpose(q.x, q.y, q.z, q.w);
    store(turn_[c].v, q.x);
    store(turn_[c + 1].v, q.y);
    store(turn_[c + 2].v, q.z);
    store(turn_[c + 3].v, q.w);
    pull<Stretched>(c, r);
  }

  template <class To>
  static void put(Vectors v, std::size_t c, const To& to) {
    f32x4 none = splat(0.0f);
    transpose(v.x, v.y, v.z, none);
    store(to(c), v.x);
    store(to(c + 1), v.y);
    store(to(c + 2), v.z);
    store(to(c + 3), none);
  }

  // In place of the gradient f of four cells: filled / 4 of what is wrong with it, (f - r s) + volume (f - f₁).
  template <bool Stretched>
  void pull(std::size_t c, const Matrices& r) {
    Matrices f, target = r;
    f32x4 volume = splat(1.0f);
    for (std::size_t i = 0; i < 3; ++i)
      f.c[i] = transposed(loaded(cells_[c].gradient[i]), loaded(cells_[c + 1].gradient[i]),
                          loaded(cells_[c + 2].gradient[i]), loaded(cells_[c + 3].gradient[i]));
    if constexpr (Stretched) {
      Matrices s;
      for (std::size_t i = 0; i < 3; ++i)
        s.c[i] = transposed(loaded(stretches_[c][i]), loaded(stretches_[c + 1][i]), loaded(stretches_[c + 2][i]),
                            loaded(stretches_[c + 3][i]));
      for (const int i : {0, 1, 2}) target.c[i] = r.c[0] * s.c[i].x + r.c[1] * s.c[i].y + r.c[2] * s.c[i].z;
      volume = dot(s.c[0], cross(s.c[1], s.c[2]));
    }
    const f32x4 has = dot(f.c[0], cross(f.c[1], f.c[2])), square = volume * volume;
    const mask4 counts = splat(kLeastVolume) * square < has * volume;
    const mask4 is_there = splat(kLeastStretch * kLeastStretch) < square;
    const Matrices next = with_volume(f, volume);
    const f32x4 filled =
        lanes(body_.cells[c].filled, body_.cells[c + 1].filled, body_.cells[c + 2].filled, body_.cells[c + 3].filled) *
        splat(0.25f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vectors full = select(is_there, select(counts, next.c[i], target.c[i]), target.c[i]);
      const Vectors wrong = (f.c[i] - target.c[i]) + (f.c[i] - full) * splat(body_.volume);
      put(wrong * filled, c, [&](std::size_t k) { return cells_[k].gradient[i].v; });
    }
  }

  void add_pull(std::size_t c) {
    const ElasticCell& cell = body_.cells[c];
    const Modes& m = cells_[c];
    const f32x4 bending = splat(cell.filled * kBending), twisting = splat(cell.filled * kTwisting);
    const f32x4 x = loaded(m.gradient[0]), y = loaded(m.gradient[1]), z = loaded(m.gradient[2]);
    const f32x4 xy = loaded(m.bent[0]) * bending, xz = loaded(m.bent[1]) * bending, yz = loaded(m.bent[2]) * bending,
                xyz = loaded(m.bent[3]) * twisting;
    // Signs of y and z in turn: --, +-, -+, ++.
    const f32x4 even[4] = {yz - (y + z), (y - z) - yz, (z - y) - yz, (y + z) + yz};
    const f32x4 odd[4] = {(x + xyz) - (xy + xz), (x - xyz) + (xy - xz), (x - xyz) - (xy - xz), (x + xyz) + (xy + xz)};
    for (std::size_t k = 0; k < 4; ++k) {
      float* const first = pull_[cell.nodes[2 * k]].v;
      store(first, load_aligned(first) + (even[k] - odd[k]));
      float* const second = pull_[cell.nodes[2 * k + 1]].v;
      store(second, load_aligned(second) + (even[k] + odd[k]));
    }
  }

  void move(float step) {
    pull_.assign(places_.size(), Four());
    for (std::size_t c = 0; c < body_.free; ++c) add_pull(c);
    right_.resize(body_.rows);
    for (std::size_t n = 0; n < places_.size(); ++n) {
      if (body_.row[n] == Lattice::kNone) continue;
      const f32x4 away = (loaded(places_[n]) - loaded(rig_[n])) * splat(body_.keep[n]);
      store(right_[body_.row[n]].v, loaded(pull_[n]) + away);
    }
    body_.factor->solve(right_);
    for (std::size_t n = 0; n < places_.size(); ++n)
      if (body_.row[n] != Lattice::kNone)
        store(places_[n].v, loaded(places_[n]) - loaded(right_[body_.row[n]]) * splat(step));
  }

  // Gradients of nodes are means of their cells', by what these fill.
  BodyShape result() {
    BodyShape out;
    out.gradients.resize(places_.size());
    std::vector<float> filled(places_.size(), 0);
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      find_modes(c);
      for (const std::uint32_t n : body_.cells[c].nodes) {
        filled[n] += body_.cells[c].filled;
        for (std::size_t i = 0; i < 3; ++i)
          store(out.gradients[n][i].v,
                loaded(out.gradients[n][i]) + loaded(cells_[c].gradient[i]) * splat(body_.cells[c].filled));
      }
    }
    for (std::size_t n = 0; n < places_.size(); ++n)
      for (Four& column : out.gradients[n]) store(column.v, loaded(column) / splat(filled[n]));
    out.places = std::move(places_);
    return out;
  }

  const Body& body_;
  std::vector<Four> rig_, places_, pull_, right_;  // of nodes, but for the last
  std::vector<Modes> cells_;
  std::vector<Columns> turned_;  // of cells, their rotations; the last is none's
  std::vector<Four> turn_;       // the same as quaternions
  std::vector<Columns> stretches_;
};

}  // namespace

BodyShape find_shape(const Body& body, const Carried& carried) {
  return Rounds(body, carried).run();
}

}  // namespace marrow::deform
