// How far deformers are from the truth, and what they cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/contestants.h"
#include "gpu_cost/vertex_cost.h"

namespace marrow::tools {

// What the eye finds wrong, whatever the truth says, in poses held out; see deform::Folds.
struct SurfaceLook {
  double flipped = 0;   // triangles a pose, the mean
  double bend_deg = 0;  // the root of the mean square over poses
  double creased = 0;   // the mean share
  // The largest jump between frames at 60 a second over SSD's, see largest_jumps(). None: of no clip.
  std::optional<double> jump_of_ssd;
};

// Whether one figure is more than another, written with so many decimals: what nobody can read is no difference.
bool reads_more(double a, double b, int decimals);
inline constexpr int kFlippedDecimals = 1, kBendDecimals = 2, kCreasedDecimals = 2;  // a pose; degrees; per cent

// Lengths in metres.
struct DeformerRow {
  std::string deformer;
  double train_rms = 0, train_max = 0, held_rms = 0, held_max = 0;
  double worse_share = 0;  // of held-out poses in which the RMS error is above SSD's
  double volume = 1;       // over the truth's, in held-out poses, on average
  double crease_deg = 0;   // how sharply some edge is folded beyond the bind pose; the mean over held-out poses
  SurfaceLook look;
  double normal_deg = 0;  // between the normals it shades with and those of the mesh it makes, where joints meet
  double blended_normal_deg = 0;  // the same if all went through the blended matrix, as is cheaper
  // Of the cooked file; 0: cannot be cooked, or is no better than SSD in its clips and not shipped.
  double bytes_per_vertex = 0;                        // of geometry
  double ns_per_vertex = 0;                           // of the runtime's kernel on this machine, positions
  double instructions_per_vertex = 0;                 // of the same; 0 also where they cannot be counted
  std::uint32_t influences = 0, palette_entries = 0;  // of the cooked mesh, at most
  double displacements_per_vertex = 0;                // what EigenSkin adds to SSD; 0: none
  VertexCost gpu;                                     // with normals; 0 also of kernels that no GPU path has
  double train_s = 0;                                 // to learn it, the mean over rounds
  // For pictures and charts, of the first round: a held-out pose's RMS error.
  std::vector<double> error_of_pose;
};

// A moment in which the truth itself folds.
struct TruthFold {
  std::string clip;  // empty: a pose of none
  double time_s = 0;
  std::uint32_t joint = 0;  // that most of what is flipped follows
  std::size_t flipped = 0, plain_flipped = 0;
};

struct DeformerComparison {
  std::vector<DeformerRow> rows;
  SurfaceLook truth;
  // Of each clip the moment in which the truth folds most, if it does; the worst first.
  std::vector<TruthFold> truth_folds;
  std::size_t folding = 0;  // poses held out in which it does
  double diagonal_m = 0;
  std::size_t trained = 0, held = 0;  // poses of all rounds
  std::vector<Trained> trained_in_first_round;
};

// progress: of deformers and rounds.
DeformerComparison compare_deformers(const Study& study, const cook::LearnOptions& options, int eigen_fields,
                                     const deform::Progress& progress = {});

}  // namespace marrow::tools
