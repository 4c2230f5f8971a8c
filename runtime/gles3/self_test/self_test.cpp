// At start-up: every path skins small meshes, and what comes back is compared with the CPU.
#include "marrow/gles3_self_test.h"

#include "core/builtins.h"
#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/palettes.h"
#include "gles3/self_test/self_test_key.h"
#include "gles3/self_test/self_test_mesh.h"
#include "gles3/self_test/self_test_target.h"
#include "gles3/skinner_state.h"
#include "marrow/palette.h"
#include "marrow/skin.h"

namespace marrow::embedded {
extern const unsigned char shader_self_test_vert[], shader_self_test_frag[];
}

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kParts = 3;  // positions, normals, tangents
constexpr std::uint32_t kTimedFrames = 8;
constexpr std::uint32_t kTimedPasses = 3;
constexpr float kFar = 1e9f;

// All that the test works with.
struct Probe {
  const Api& api;
  const Caps& caps;
  const SelfTestOptions& options;
  Mesh meshes[kProbeShapes];
  Run timed_runs[4];
  Mesh timed;
  Span<ProgramSet> programs;
  Span<Affine> joints, palette;
  Span<float> positions, normals, tangents, coordinates;
  Span<std::uint32_t> words;
  Span<std::byte> skinner;
  ProbeTarget target;

  Probe(const Api& of, const Caps& can, const SelfTestOptions& by) : api(of), caps(can), options(by) {}
};

std::size_t more(std::size_t a, std::size_t b) {
  return a > b ? a : b;
}

SkinnerOptions skinner_options(SkinningPath path, Deformer deformer, std::uint32_t characters) {
  SkinnerOptions out;
  out.path = path;
  out.deformer = deformer;
  out.instances = characters;
  return out;
}

bool is_sane(const SelfTestOptions& o) {
  return o.timed_vertices >= 16 && o.timed_vertices <= 65520 && o.timed_characters > 0 && o.timed_characters <= 256;
}

void lay_out_probe(Memory& memory, Probe& p) {
  std::size_t skinner = 0, coordinates = 0;
  const auto make_room = [&](const Mesh& mesh, std::uint32_t characters) {
    for (std::uint32_t i = 0; i < kPathCount; ++i) {
      const SkinningPath path = static_cast<SkinningPath>(i);
      skinner = more(skinner, skinner_bytes(mesh, skinner_options(path, Deformer::ssd, characters)));
      skinner = more(skinner, skinner_bytes(mesh, skinner_options(path, Deformer::as, characters)));
    }
  };
  for (std::size_t m = 0; m < kProbeShapes; ++m) {
    p.meshes[m] = make_probe_mesh(probe_shape(m), memory);
    make_room(p.meshes[m], kProbeCharacters);
    coordinates = more(coordinates, as_coordinate_count(p.meshes[m].geometry));
  }
  if (p.options.seconds != nullptr && is_sane(p.options)) {
    p.timed = make_probe_mesh(timed_shape(p.options.timed_vertices, p.timed_runs), memory);
    make_room(p.timed, p.options.timed_characters);
  }
  const std::size_t slots = p.meshes[1].geometry.slot_count;
  p.programs = memory.take<ProgramSet>(1);
  p.joints = memory.take<Affine>(kPaletteJoints);
  p.palette = memory.take<Affine>(kPaletteJoints);
  p.positions = memory.take<float>(3 * slots);
  p.normals = memory.take<float>(3 * slots);
  p.tangents = memory.take<float>(4 * slots);
  p.coordinates = memory.take<float>(coordinates);
  p.words = memory.take<std::uint32_t>(4 * slots * kParts * kProbeCharacters);
  p.skinner = memory.take<std::byte>(skinner);
}

// Never NaN.
float larger_difference(float so_far, float a, float b) {
  const float d = a < b ? b - a : a - b;
  if (d <= so_far) return so_far;
  return d < kFar ? d : kFar;
}

float word_as_float(std::uint32_t word) {
  return bit_cast<float>(word);
}

void pose_all(Probe& p, const Mesh& mesh, std::uint32_t frame, std::uint32_t characters, Skinner& s) {
  const Span<Affine> joints(p.joints.data, mesh.joint_count);
  for (std::uint32_t i = 0; i < characters; ++i) {
    pose_probe(frame, i, joints);
    (void)pose(s, i, joints);
  }
}

// Characters in rows from `row` on.
Status draw_points(const Probe& p, const Skinner& s, std::uint32_t part, float row, std::uint32_t characters) {
  const Program& program = program_of(s, p.programs[0], 0);
  p.api.UseProgram(program.id);
  const int location = p.api.GetUniformLocation(program.id, "self_test");
  const bool together = s.options.path == SkinningPath::texture;
  Status status = Status::ok;
  for (std::uint32_t i = 0; i < characters && status == Status::ok; i += together ? characters : 1) {
    const float values[4] = {row + static_cast<float>(i), static_cast<float>(part), static_cast<float>(p.target.width),
                             static_cast<float>(p.target.height)};
    p.api.Uniform4fv(location, 1, values);
    status = draw(p.api, s, p.programs[0], program, i, together ? characters : 1);
  }
  return status;
}

// Of one character; what is to come out is the CPU's.
void compare(Probe& p, const Mesh& mesh, Deformer deformer, std::uint32_t frame, std::uint32_t character,
             PathResult& result) {
  const std::size_t slots = mesh.geometry.slot_count;
  const Span<Affine> joints(p.joints.data, mesh.joint_count);
  const SkinOutput to{{p.positions.data, 3 * slots}, {p.normals.data, 3 * slots}, {p.tangents.data, 4 * slots}};
  pose_probe(frame, character, joints);
  Status status = build_palette(mesh, joints, p.palette);
  if (deformer == Deformer::as) {
    if (status == Status::ok) status = as_coordinates(mesh.geometry, p.coordinates);
    if (status == Status::ok) status = skin_as(mesh, p.coordinates, p.palette, to);
  } else if (status == Status::ok) {
    status = skin_ssd(mesh, p.palette, to);
  }
  if (status != Status::ok) result.position_error = kFar;  // the mesh is well formed, so it does not happen
  const float* const expected[kParts] = {p.positions.data, p.normals.data, p.tangents.data};
  for (std::uint32_t part = 0; part < kParts; ++part) {
    const std::uint32_t numbers = part == 2 ? 4 : 3;
    float& error = part == 0 ? result.position_error : result.normal_error;
    const std::uint32_t* row = p.words.data + std::size_t{4} * p.target.width * (part * kProbeCharacters + character);
    for (std::size_t slot = 0; slot < slots; ++slot)
      for (std::uint32_t c = 0; c < numbers; ++c)
        error = larger_difference(error, word_as_float(row[4 * slot + c]), expected[part][numbers * slot + c]);
  }
}

Verdict try_frame(Probe& p, const Mesh& mesh, std::uint32_t frame, Skinner& s, PathResult& result) {
  pose_all(p, mesh, frame, kProbeCharacters, s);
  Status status = update(p.api, s, p.programs[0], kProbeCharacters);
  clear_probe(p.api, 0xFFFFFFFFu);  // a number that is none
  for (std::uint32_t part = 0; part < kParts && status == Status::ok; ++part)
    status = draw_points(p, s, part, static_cast<float>(part * kProbeCharacters), kProbeCharacters);
  read_probe(p.api, p.target, p.words);
  if (status != Status::ok || p.api.GetError() != kGlNoError) return Verdict::gl_error;
  for (std::uint32_t i = 0; i < kProbeCharacters; ++i) compare(p, mesh, s.options.deformer, frame, i, result);
  const bool right = result.position_error <= kMostPositionError && result.normal_error <= kMostNormalError;
  return right ? Verdict::usable : Verdict::wrong;
}

Verdict make_skinner(Probe& p, const Mesh& mesh, const SkinnerOptions& options, Skinner& out) {
  const Status made = create_skinner(p.api, p.caps, mesh, options, p.programs[0], p.skinner, out);
  state_of(out).gpu.primitive = kGlPoints;
  return made == Status::ok ? Verdict::usable : made == Status::unsupported ? Verdict::unsupported : Verdict::refused;
}

Verdict try_mesh(Probe& p, const Mesh& mesh, SkinningPath path, Deformer deformer, PathResult& result) {
  Skinner s;
  Verdict verdict = make_skinner(p, mesh, skinner_options(path, deformer, kProbeCharacters), s);
  if (verdict != Verdict::usable) return verdict;
  for (std::uint32_t frame = 0; frame < kProbeFrames && verdict == Verdict::usable; ++frame)
    verdict = try_frame(p, mesh, frame, s, result);
  destroy(p.api, s);
  return verdict;
}

// A frame of so many passes; fastest: in seconds, of this frame and those before it.
Status time_frame(const Probe& p, Skinner& s, std::uint32_t passes, bool warms_up, double& fastest) {
  const std::uint32_t characters = s.options.instances;
  const double start = p.options.seconds(p.options.user);
  Status status = update(p.api, s, p.programs[0], characters);
  for (std::uint32_t i = 0; i < passes && status == Status::ok; ++i) status = draw_points(p, s, 0, -1000, characters);
  p.api.Finish();
  const double taken = p.options.seconds(p.options.user) - start;
  if (!warms_up && taken < fastest) fastest = taken;
  return status;
}

// The fastest of some frames, each waited for: what else the device does only adds. Points fall outside, so that it is
// skinning that takes the time.
Verdict time_path(Probe& p, SkinningPath path, PathResult& result) {
  const Mesh& mesh = p.timed;
  const std::uint32_t characters = p.options.timed_characters;
  Skinner s;
  const Deformer deformer = p.options.ssd ? Deformer::ssd : Deformer::as;
  Verdict verdict = make_skinner(p, mesh, skinner_options(path, deformer, characters), s);
  if (verdict != Verdict::usable) return verdict;
  pose_all(p, mesh, 0, characters, s);
  double once = kFar, again = kFar;
  Status status = Status::ok;
  // The first ones warm up.
  for (std::uint32_t i = 0; i <= kTimedFrames && status == Status::ok; ++i) {
    status = time_frame(p, s, 1, i == 0, once);
    if (status == Status::ok) status = time_frame(p, s, kTimedPasses, i == 0, again);
  }
  if (status != Status::ok || p.api.GetError() != kGlNoError) verdict = Verdict::gl_error;
  destroy(p.api, s);
  // A clock that goes astray gives no time.
  if (!(once > 0 && once < 1000)) return verdict;
  const double ns = 1e9 / (mesh.geometry.slot_count * characters);
  result.ns_per_vertex = static_cast<float>(ns * once);
  if (again > once && again < 1000) result.ns_per_pass = static_cast<float>(ns * (again - once) / (kTimedPasses - 1));
  return verdict;
}

Verdict try_path(Probe& p, SkinningPath path, PathResult& result) {
  const SelfTestOptions& o = p.options;
  if ((o.paths & bit_of(path)) == 0) return Verdict::not_tried;
  if ((o.crashed & bit_of(path)) != 0) return Verdict::crashed;
  if (path == SkinningPath::compute && !p.caps.compute) return Verdict::unsupported;
  if (o.about_to_try != nullptr) o.about_to_try(o.user, path);
  ProgramSet& programs = p.programs[0];
  programs = {};
  programs.roles[0].vertex = reinterpret_cast<const char*>(embedded::shader_self_test_vert);
  programs.roles[0].fragment = reinterpret_cast<const char*>(embedded::shader_self_test_frag);
  Verdict verdict = Verdict::usable;
  for (std::size_t m = 0; m < kProbeShapes; ++m) {
    if (o.ssd && verdict == Verdict::usable) verdict = try_mesh(p, p.meshes[m], path, Deformer::ssd, result);
    if (o.as && verdict == Verdict::usable) verdict = try_mesh(p, p.meshes[m], path, Deformer::as, result);
  }
  if (o.seconds != nullptr && verdict == Verdict::usable) verdict = time_path(p, path, result);
  p.api.UseProgram(0);
  destroy(p.api, programs);
  return verdict;
}

// Compared are those that skin on the GPU; the CPU's time is the game's to weigh.
void find_slow(const SelfTestOptions& options, SelfTest& test) {
  float fastest = kFar;
  const auto counts = [&](std::uint32_t i) {
    const PathResult& result = test.paths[i];
    return static_cast<SkinningPath>(i) != SkinningPath::cpu && result.verdict == Verdict::usable &&
           result.ns_per_vertex > 0;
  };
  for (std::uint32_t i = 0; i < kPathCount; ++i)
    if (counts(i) && test.paths[i].ns_per_vertex < fastest) fastest = test.paths[i].ns_per_vertex;
  for (std::uint32_t i = 0; i < kPathCount; ++i)
    if (counts(i) && test.paths[i].ns_per_vertex > options.slow * fastest) test.paths[i].verdict = Verdict::slow;
}

// A path that fails may have taken the context along.
Status try_paths(Probe& p, SelfTest& test) {
  if (!can_read_probe(p.api, p.target, p.words)) return Status::gl_error;
  for (std::uint32_t i = 0; i < kPathCount; ++i) {
    PathResult& result = test.paths[i];
    result.verdict = try_path(p, static_cast<SkinningPath>(i), result);
    if (result.verdict != Verdict::usable && !can_read_probe(p.api, p.target, p.words)) return Status::gl_error;
  }
  return Status::ok;
}

}  // namespace

std::size_t self_test_bytes(const SelfTestOptions& options) {
  const Api api;
  const Caps caps;
  Probe counted(api, caps, options);
  Memory memory;
  lay_out_probe(memory, counted);
  return memory.used;
}

Status self_test(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<std::byte> memory,
                 SelfTest& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(options.ssd || options.as);
  MARROW_REQUIRE(options.seconds == nullptr || (options.slow >= 1 && is_sane(options)));
  MARROW_REQUIRE(holds(memory, self_test_bytes(options)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  Probe probe(api, caps, options);
  Memory pieces{memory.data};
  lay_out_probe(pieces, probe);
  ProbeState state;
  take_state(api, state);
  SelfTest test;
  const auto slots = static_cast<std::uint32_t>(probe.meshes[1].geometry.slot_count);
  Status status = make_probe_target(api, slots, kParts * kProbeCharacters, probe.target);
  if (status == Status::ok) status = try_paths(probe, test);
  destroy(api, probe.target);
  put_back(api, state);
  forget_errors(api);
  if (status != Status::ok) return status;
  find_slow(options, test);
  test.family = family_of(api.GetString(kGlRenderer));
  test.key = self_test_key(api, caps, options);
  out = test;
  return Status::ok;
}

}  // namespace marrow::gles3
