// What folds, bends, creases and jumps of a character by each deformer, in its clips and joint by joint: a table.
//   marrow_folds_table MODEL.glb [POSES [frames|clips [volume=V] [DEFORMER…]]]
// A fit has a row as it is learnt, and one with residuals rounded as files have them.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/evenly.h"
#include "common/parallel.h"
#include "compare/study.h"
#include "cook/gltf/read.h"
#include "cook/options/options.h"
#include "deform/elastic/elastic.h"
#include "deform/look/folds.h"
#include "deform/motion/motion_errors.h"
#include "deform/surface.h"

namespace marrow::tools {
namespace {

using deform::Deformer;
using deform::Folds;
using deform::Pose;
using deform::Positions;

struct Row {
  double flipped = 0, bend = 0, creased = 0, off = 0;
  std::vector<double> squares;  // of each pose, what off is of
};

std::string text_of(const Row& r) {
  return fmt::format("{:>8.1f}{:>7.2f}{:>7.2f}{:>7.3f}", r.flipped, r.bend, r.creased, r.off);
}

// Of linear blend skinning's, what that has little of as it is.
std::string text_of(const Row& r, const Row& of_ssd) {
  const auto share = [](double ours, double plain) {
    return plain > 0.005 ? fmt::format("{:.2f}", ours / plain) : fmt::format("({:.2f})", ours);
  };
  std::size_t farther = 0;
  double most = 0;
  for (std::size_t i = 0; i < r.squares.size(); ++i) {
    if (!(r.squares[i] > of_ssd.squares[i] * (1 + 1e-6))) continue;
    ++farther;
    most = std::max(most, std::sqrt(r.squares[i] / of_ssd.squares[i]));
  }
  return fmt::format("{:>8}{:>7}{:>7}{:>7}", share(r.flipped, of_ssd.flipped), share(r.bend, of_ssd.bend),
                     share(r.creased, of_ssd.creased), fmt::format("{:.2f}", r.off / of_ssd.off)) +
         fmt::format("  {} farther by up to {:.2f}", farther, most);
}

// Means over poses, bend in degrees, creased in per cent, how far from the truth in per cent of the diagonal.
Row row_of(const deform::FoldMeter& meter, const std::vector<Pose>& poses, const Deformer& deformer,
           const std::vector<Positions>& from, double diagonal) {
  std::vector<Row> rows(poses.size());
  for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Positions at;
    deformer(poses[i], at);
    const Folds f = meter.of(poses[i], at);
    double squares = 0;
    for (std::size_t v = 0; v < at.size(); ++v) squares += glm::dot(at[v] - from[i][v], at[v] - from[i][v]);
    rows[i] = {
        static_cast<double>(f.flipped), f.bend_rad * f.bend_rad, 100 * f.creased, squares / double(at.size()), {}};
  });
  Row out;
  const auto count = static_cast<double>(poses.size());
  for (const Row& r : rows) {
    out.flipped += r.flipped / count;
    out.bend += r.bend / count;
    out.creased += r.creased / count;
    out.off += r.off / count;
    out.squares.push_back(r.off);
  }
  out.bend = std::sqrt(out.bend) * 180 / std::numbers::pi;
  out.off = 100 * std::sqrt(out.off) / diagonal;
  return out;
}

struct Named {
  std::string name;
  Deformer deformer;
};

Deformer by(std::shared_ptr<const cook::Learnt> learnt) {
  return [learnt, by = deform::animation_space(learnt->coordinates)](const Pose& pose, Positions& to) {
    Pose at = pose;
    deform::append_helpers(learnt->helpers, at);
    by(at, to);
  };
}

// With residuals rounded as files have them, see rounded_residual() of cook/geometry/quantise.cpp.
cook::Learnt rounded(cook::Learnt learnt, const deform::SkinnedMesh& mesh, const cook::LearnOptions& options) {
  const double size = deform::diagonal(mesh), step = cook::residual_step_m(learnt, size, options);
  const glm::dvec4 steps(step, step, step, step / (0.1 * size));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec4 place(mesh.positions[v], 1);
    glm::dvec4 carry(0);
    for (deform::Coordinate& c : learnt.coordinates[v]) {
      const auto at = std::ranges::find(learnt.weights[v], c.joint, &deform::Influence::joint);
      const glm::dvec4 lifted = place * (at == learnt.weights[v].end() ? 0 : at->weight), residual = c.q - lifted;
      const glm::dvec4 from_vertex = residual - glm::dvec4(mesh.positions[v] * residual.w, 0);
      const glm::dvec4 wanted = from_vertex / steps + carry, whole = glm::round(wanted);
      carry = wanted - whole;
      const glm::dvec4 kept = whole * steps;
      c.q = lifted + kept + glm::dvec4(mesh.positions[v] * kept.w, 0);
    }
  }
  return learnt;
}

// Learnt from what is not held out, as --as fit --truth TRUTH does.
std::shared_ptr<const cook::Learnt> fitted(const Study& study, const std::string& truth,
                                           const cook::LearnOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto learnt =
      std::make_shared<const cook::Learnt>(cook::learn(study.source, study.rounds.front().train, options));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::size_t entries = 0;
  for (const auto& vertex : learnt->coordinates) entries += vertex.size();
  fmt::print(
      "fit-{}: learnt in {:.1f} s; {} helpers, {:.2f} entries a vertex; {:.3f} of linear blend skinning's error "
      "by cross-validation, {:.1f} % worse\n",
      truth, took.count(), learnt->helpers.size(),
      static_cast<double>(entries) / static_cast<double>(learnt->coordinates.size()), learnt->quality.share,
      100 * learnt->quality.worse_share);
  return learnt;
}

cook::LearnOptions fit_to(const std::string& truth) {
  cook::Options given;
  given["as"] = {{"fit", {"--as", ""}}};
  given["truth"] = {{truth, {"--truth", ""}}};
  return cook::to_options(given).learn;
}

std::vector<Named> deformers(const Study& study, int count, char** names) {
  const deform::SkinnedMesh& mesh = study.source.mesh;
  std::vector<Named> out = {{"ssd", deform::ssd(mesh)}, {"dqs", deform::dual_quaternions(mesh)}};
  for (int i = 0; i < count; ++i) {
    const std::string name = names[i];
    if (name == "cor") out.push_back({name, deform::centres_of_rotation(mesh)});
    if (name == "dm") out.push_back({name, deform::delta_mush(mesh)});
    if (name == "dm-dqs") out.push_back({name, deform::delta_mush(mesh, {}, out[1].deformer)});
    if (name.starts_with("fit-")) {
      const cook::LearnOptions options = fit_to(name.substr(4));
      const auto learnt = fitted(study, name.substr(4), options);
      out.push_back({name, by(learnt)});
      out.push_back({"rounded", by(std::make_shared<const cook::Learnt>(rounded(*learnt, mesh, options)))});
    }
    if (name == "elastic") out.push_back({name, study.source.elastic});
    if (!name.starts_with("elastic") || name == "elastic") continue;
    deform::ElasticOptions options;
    options.volume = std::atof(name.c_str() + 7);
    const auto begin = std::chrono::steady_clock::now();
    const auto made = std::make_shared<deform::Elastic>(mesh, options);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const deform::Body& body = made->body();
    double rig = 0;
    for (const double share : made->rig_shares()) rig += share / static_cast<double>(mesh.positions.size());
    const double side = body.lattice.side / deform::diagonal(mesh);
    fmt::print("{}: made in {:.2f} s; {} cells of 1/{:.0f}, {} free; {} nodes, {} free; {} entries; by rig {:.1f} %\n",
               name, took.count(), body.lattice.cells.size(), 1 / side, body.free, body.lattice.nodes.size(), body.rows,
               body.factor->entries(), 100 * rig);
    out.push_back({name, [made](const Pose& pose, Positions& to) { made->pose(pose, to); }});
  }
  return out;
}

void print_rings(const Study& study, const std::vector<Named>& all) {
  std::vector<deform::MotionPose> twists;
  for (const deform::MotionPose& p : study.motion.poses)
    if (p.kind == deform::MotionKind::twist && std::abs(p.angle_rad) > 2.9) twists.push_back(p);
  std::vector<Deformer> only;
  for (const Named& n : all) only.push_back(n.deformer);
  const auto errors = deform::motion_errors(study.source.mesh, twists, all.front().deformer, only);
  for (std::size_t d = 0; d < all.size(); ++d) {
    std::vector<double> rings;
    for (const deform::MotionErrors& e : errors)
      if (e.is_usable && e.of[d].ring_over_bind) rings.push_back(*e.of[d].ring_over_bind);
    std::ranges::sort(rings);
    double mean = 0;
    for (const double r : rings) mean += r / static_cast<double>(rings.size());
    if (!rings.empty())
      fmt::print("  {:<12} rings in twists of 170°: narrowest {:.2f}, lowest tenth {:.2f}, mean of narrowest {:.2f}\n",
                 all[d].name, rings.front(), rings[rings.size() / 10], mean);
  }
}

// The largest jump from frame to frame at 60 Hz, over linear blend skinning's.
void print_jumps(const Study& study, const std::vector<Named>& all, std::size_t most) {
  const auto frames = cook::frames_in_a_row(study.source, study.built, most);
  if (frames.empty()) return;
  std::vector<double> largest;
  for (const Named& n : all) {
    std::vector<double> jumps(frames.size());
    for_each_in_parallel(frames.size(), [&](std::size_t i) {
      std::array<Positions, 3> at;
      for (std::size_t k = 0; k < 3; ++k) n.deformer(frames[i][k], at[k]);
      jumps[i] = deform::largest_jump(study.source.mesh, frames[i], at);
    });
    largest.push_back(*std::ranges::max_element(jumps));
    fmt::print("  {:<12} largest jump at {} moments: {:.2f} of ssd's\n", n.name, frames.size(),
               largest.back() / largest.front());
  }
}

void print_rows(const Study& study, const std::vector<Named>& all, std::size_t most) {
  const deform::SkinnedMesh& mesh = study.source.mesh;
  const deform::FoldMeter meter(mesh);
  std::vector<Pose> clips, joints;
  for (const HeldPose& p : evenly(study.rounds.front().held, most)) clips.push_back(p.pose);
  for (const deform::MotionPose& p : evenly(study.motion.poses, most)) joints.push_back(p.pose());
  const auto truth = [&](const std::vector<Pose>& poses) {
    std::vector<Positions> out(poses.size());
    for_each_in_parallel(poses.size(), [&](std::size_t i) { study.source.elastic(poses[i], out[i]); });
    return out;
  };
  const std::vector<Positions> in_clips = truth(clips), by_joint = truth(joints);
  fmt::print("{:<14}{} of clips: flips, bend °, crease %, % off elastic | {} of single joints\n", "", clips.size(),
             joints.size());
  std::vector<std::pair<Row, Row>> rows;
  for (const Named& n : all) {
    const double diagonal = deform::diagonal(mesh);
    rows.emplace_back(row_of(meter, clips, n.deformer, in_clips, diagonal),
                      row_of(meter, joints, n.deformer, by_joint, diagonal));
    fmt::print("  {:<12}{} |{}\n", n.name, text_of(rows.back().first), text_of(rows.back().second));
  }
  for (std::size_t d = 1; d < all.size(); ++d)
    fmt::print("  {:<12}{} |{}  of ssd's\n", all[d].name, text_of(rows[d].first, rows[0].first),
               text_of(rows[d].second, rows[0].second));
}

void print_table(const std::string& file, std::size_t most, Holdout holdout, int count, char** names) {
  cook::LearnOptions options;
  options.animation_space = cook::AnimationSpace::fit;
  options.truth = cook::Truth::elastic;
  for (int i = 0; i < count; ++i)
    if (const std::string name = names[i]; name.starts_with("volume="))
      options.elastic.volume = std::atof(name.c_str() + 7);
  Study study = study_scene(cook::read_gltf(file), holdout, options);
  cook::Notes notes;
  drop_unusable_poses(options, study, notes);
  for (const auto& note : notes.warnings) fmt::print("{}\n", note.text);
  const deform::SkinnedMesh& mesh = study.source.mesh;
  fmt::print("{}: {}, {} vertices, {} triangles, {} joints\n", file, study.name, mesh.positions.size(),
             mesh.indices.size() / 3, mesh.joint_count);
  const std::vector<Named> all = deformers(study, count, names);
  print_rows(study, all, most);
  print_rings(study, all);
  print_jumps(study, all, most);
}

}  // namespace
}  // namespace marrow::tools

int main(int count, char** arguments) {
  using marrow::tools::Holdout;
  if (count < 2) return 2;
  const std::size_t most = count > 2 ? static_cast<std::size_t>(std::atoi(arguments[2])) : 40;
  const bool clips = count > 3 && std::string(arguments[3]) == "clips";
  marrow::tools::print_table(arguments[1], most, clips ? Holdout::clips : Holdout::frames, count - 4, arguments + 4);
}
