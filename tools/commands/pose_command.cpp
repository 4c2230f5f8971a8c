// `marrow pose`: a character at a moment, as numbers.
#include <cstring>
#include <span>
#include <string>

#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/between.h"
#include "commands/command.h"
#include "common/formats.h"
#include "common/vertex_order.h"
#include "disk/files.h"
#include "open/open_model.h"
#include "pose/worn.h"

namespace marrow::tools {
namespace {

struct PoseArguments : ModelArguments {
  std::string out;
  Deformer deformer = Deformer::ssd;
  BetweenArguments between;
};

// A primitive of the source, posed: a mesh or the parts of one.
struct PosedParts {
  std::vector<Mesh> meshes;
  std::vector<Geometry> geometries;
  std::vector<PosedMesh> posed;
};

// Those of what the character wears behind its own.
std::vector<PosedParts> pose_parts(const File& file, const Character& character, Deformer deformer) {
  std::vector<PosedParts> out;
  for (std::uint32_t m = 0; m < file.mesh_count();) {
    PosedParts& parts = out.emplace_back();
    parts.meshes = parts_at(file, m);
    parts.geometries = geometries_of(parts.meshes);
    for (std::size_t i = 0; i < parts.meshes.size(); ++i) character.skin(m++, deformer, parts.posed.emplace_back());
  }
  for (const std::shared_ptr<Worn>& worn : character.worn())
    for (PosedParts& parts : pose_parts(worn->loaded.file, *worn->character, deformer)) out.push_back(std::move(parts));
  return out;
}

// Little-endian float32 x y z a vertex.
std::string to_bin(const File& file, const Character& character, Deformer deformer) {
  std::string out;
  for (const PosedParts& parts : pose_parts(file, character, deformer))
    for (const auto& [part, slot] : vertex_order(parts.geometries))
      out.append(reinterpret_cast<const char*>(&parts.posed[part].positions[std::size_t{3} * slot]), 12);
  return out;
}

void append_faces(std::span<const Geometry> parts, std::uint32_t first, bool normals, std::string& out) {
  const std::vector<std::uint32_t> indices = indices_in_order(parts);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (i % 3 == 0) out += 'f';
    const std::uint32_t n = first + indices[i];
    out += normals ? fmt::format(" {}//{}", n, n) : fmt::format(" {}", n);
    if (i % 3 == 2) out += '\n';
  }
}

std::string to_obj(const File& file, const Character& character, Deformer deformer) {
  std::string out;
  std::uint32_t first = 1, number = 0;
  for (const PosedParts& parts : pose_parts(file, character, deformer)) {
    const std::vector<PartSlot> order = vertex_order(parts.geometries);
    const char* const name = parts.meshes[0].name;
    out += fmt::format("o {}\n", *name != '\0' ? name : fmt::format("mesh{}", number).c_str());
    for (const auto& [part, s] : order) {
      const std::vector<float>& at = parts.posed[part].positions;
      out += fmt::format("v {} {} {}\n", at[3 * s], at[3 * s + 1], at[3 * s + 2]);
    }
    // Normals are numbered with the positions, so a mesh without them still takes its numbers.
    const bool normals = !parts.posed[0].normals.empty();
    for (const auto& [part, s] : order) {
      const std::vector<float>& at = parts.posed[part].normals;
      out +=
          normals ? fmt::format("vn {} {} {}\n", at[3 * s], at[3 * s + 1], at[3 * s + 2]) : std::string("vn 0 0 0\n");
    }
    append_faces(parts.geometries, first, normals, out);
    first += static_cast<std::uint32_t>(order.size());
    number += static_cast<std::uint32_t>(parts.meshes.size());
  }
  return out;
}

// Throws Failure.
void run_pose(const PoseArguments& a) {
  expect_extension(a.out, {".obj", ".bin"});
  expect_writable(a.out);
  const bool obj = has_extension(a.out, ".obj");
  const Model model = open_model(a, Opens::cooked_files);
  const File& file = model.file();
  const Play& play = model.chosen.play;
  expect_deformer(a.file, file, a.deformer);
  Character character(file);
  std::optional<PlayedFrames> frames;
  if (a.between.kind) {
    frames.emplace(file, play, a.between, model.parameters);
    frames->move_to(a.choice.time_s);
    character.set_change([&](auto... to) { frames->change(to...); });
    character.set_weigh([&](auto... to) { frames->weigh(to...); });
  }
  prepare(a, model, character);
  character.pose(play, a.choice.time_s);
  write_file_atomically(a.out, obj ? to_obj(file, character, a.deformer) : to_bin(file, character, a.deformer));
}

}  // namespace

void add_pose(CLI::App& app, int&) {
  static PoseArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("pose", "Write a character's vertices at a moment of a clip");
  add_input(command, a);
  add_outfits(command, a);
  add_choice(command, a);
  add_between(command, a.between);
  add_deformer(command, a.deformer);
  command
      ->add_option("-o,--output", a.out, "P.bin: little-endian float32 x y z a vertex, model space; P.obj: Wavefront")
      ->required()
      ->type_name("P.obj|P.bin");
  command->callback([] { run_pose(a); });
}

}  // namespace marrow::tools
