#include "pose/pose.h"

#include <cstring>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/files.h"
#include "common/load_mrw.h"
#include "common/vertex_order.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

// Little-endian float32 x y z a vertex.
std::string to_bin(const File& file, const Character& character, Deformer deformer) {
  std::string out;
  PosedMesh posed;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    character.skin(m, deformer, posed);
    for (const std::uint32_t slot : vertex_order(file.mesh(m).geometry))
      out.append(reinterpret_cast<const char*>(&posed.positions[3 * slot]), 12);
  }
  return out;
}

// Padding slots repeat a real one, but no index names them: numbering by written vertex is enough.
void append_faces(const Geometry& g, const std::vector<std::uint32_t>& order, std::uint32_t first, bool normals,
                  std::string& out) {
  std::vector<std::uint32_t> number(g.slot_count, 0);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = first + i;
  for (std::uint32_t i = 0; i < g.index_count; i += 3) {
    out += 'f';
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t n = number[index_at(g, i + c)];
      out += normals ? fmt::format(" {}//{}", n, n) : fmt::format(" {}", n);
    }
    out += '\n';
  }
}

std::string to_obj(const File& file, const Character& character, Deformer deformer) {
  std::string out;
  PosedMesh posed;
  std::uint32_t first = 1;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    character.skin(m, deformer, posed);
    const std::vector<std::uint32_t> order = vertex_order(mesh.geometry);
    out += fmt::format("o {}\n", *mesh.name != '\0' ? mesh.name : fmt::format("mesh{}", m).c_str());
    for (const std::uint32_t s : order)
      out +=
          fmt::format("v {} {} {}\n", posed.positions[3 * s], posed.positions[3 * s + 1], posed.positions[3 * s + 2]);
    // Normals are numbered with the positions, so a mesh without them still takes its numbers.
    for (const std::uint32_t s : order)
      out += posed.normals.empty() ? std::string("vn 0 0 0\n")
                                   : fmt::format("vn {} {} {}\n", posed.normals[3 * s], posed.normals[3 * s + 1],
                                                 posed.normals[3 * s + 2]);
    append_faces(mesh.geometry, order, first, !posed.normals.empty(), out);
    first += static_cast<std::uint32_t>(order.size());
  }
  return out;
}

}  // namespace

void run_pose(const PoseArguments& a) {
  const std::optional<Deformer> deformer = parse_deformer(a.deformer);
  const bool obj = a.out.ends_with(".obj");
  if (!obj && !a.out.ends_with(".bin"))
    throw Failure(Exit::usage, a.out, "", "unknown format", "the output's name ends with .obj or .bin");
  const LoadedFile loaded = load_mrw(a.in);
  const Chosen chosen = choose(a.in, loaded.file, a.choice);
  Character character(loaded.file);
  character.pose(chosen.play, a.choice.time_s);
  write_file_atomically(a.out,
                        obj ? to_obj(loaded.file, character, *deformer) : to_bin(loaded.file, character, *deformer));
}

}  // namespace marrow::tools
