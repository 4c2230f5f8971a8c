#include "render/figure.h"

#include <algorithm>

#include "common/failure.h"

namespace marrow::tools {
namespace {

gles3::Deformer gpu_deformer(Deformer deformer) {
  switch (deformer) {
    case Deformer::rigid:
      return gles3::Deformer::rigid;
    case Deformer::ssd:
      return gles3::Deformer::ssd;
    case Deformer::as:
      return gles3::Deformer::as;
  }
  return gles3::Deformer::ssd;
}

// White means that a texture would have the say: without one, such meshes get the colour of clay.
glm::vec4 base_colour(const Mesh& mesh, bool textured) {
  const bool white = mesh.base_colour[0] >= 0.99f && mesh.base_colour[1] >= 0.99f && mesh.base_colour[2] >= 0.99f;
  if (white && mesh.geometry.colours == nullptr && !textured) return {0.56f, 0.42f, 0.32f, mesh.base_colour[3]};
  return {mesh.base_colour[0], mesh.base_colour[1], mesh.base_colour[2], mesh.base_colour[3]};
}

// Where the middle of a mesh's bind box is, carried by its first joint.
glm::vec3 carried_centre(const Mesh& mesh, Span<const Affine> scene_from_joint) {
  const Geometry& g = mesh.geometry;
  glm::vec3 p(0);
  for (int c = 0; c < 3; ++c) p[c] = 0.5f * (g.box_min[c] + g.box_max[c]);
  for (const Affine* m : {&mesh.inverse_bind[0], &scene_from_joint[mesh.joints[0]]}) {
    const glm::vec4 q(p, 1);
    for (int c = 0; c < 3; ++c)
      p[c] = glm::dot(glm::vec4(m->rows[c][0], m->rows[c][1], m->rows[c][2], m->rows[c][3]), q);
  }
  return p;
}

void stream(const Gl& gl, GLuint buffer, std::span<const float> values) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  const auto bytes = static_cast<std::ptrdiff_t>(values.size_bytes());
  gl.BufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, bytes, values.data());
}

void attribute(const Gl& gl, GLuint buffer, GLuint location, int size) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace

Figure::Figure(const Gl& gl, const File& file, const Textures* textures, AsNormals normals, std::uint32_t level)
    : gl_(gl), file_(file), textures_(textures), level_(level) {
  tangents_.resize(file.mesh_count());
  if (normals == AsNormals::tangents) tangents_ = tangents_of(file, level);
  std::uint32_t joints = 0;
  std::vector<std::byte> scratch;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i, level);
    Part& part = parts_.emplace_back();
    part.bind.resize(mesh.joint_count);
    gles3::PrepareOptions options;
    options.as_tangents = tangents_[i];
    scratch.resize(std::max(scratch.size(), gles3::prepare_scratch_bytes(mesh, options)));
    marrow::tools::check(gles3::prepare(gl, gl.caps(), mesh, options, scratch, part.bind, part.gpu));
    if (mesh.palette_size() > gles3::kPaletteJoints && !too_large_) too_large_ = i;
    make_streams(mesh, part);
    joints += mesh.palette_size();
  }
  const std::uint32_t meshes = std::max(1u, file.mesh_count());
  marrow::tools::check(gles3::create_palette_ring(gl, gl.caps(), std::max(1u, joints), meshes, ring_));
  marrow::tools::check(gles3::create_palette_texture(gl, gl.caps(), std::max(1u, joints), texture_));
  gl.check("preparing a character");
}

Figure::~Figure() {
  for (Part& part : parts_) {
    gles3::destroy(gl_, part.skinned);
    gles3::destroy(gl_, part.gpu);
  }
  for (auto& [key, program] : preskins_) gles3::destroy(gl_, program);
  gles3::destroy(gl_, ring_);
  gles3::destroy(gl_, texture_);
}

void Figure::make_streams(const Mesh& mesh, Part& part) {
  const Geometry& g = mesh.geometry;
  part.indices = GlBuffer(gl_);
  part.positions = GlBuffer(gl_);
  part.normals = GlBuffer(gl_);
  part.colours = GlBuffer(gl_);
  part.array = GlVertexArray(gl_);
  gl_.BindVertexArray(part.array);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices);
  const std::size_t bytes = std::size_t{g.index_count} * g.index_bytes;
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<std::ptrdiff_t>(bytes), g.indices, GL_STATIC_DRAW);
  attribute(gl_, part.positions, gles3::kPositionLocation, 3);
  if (g.normals != nullptr) attribute(gl_, part.normals, gles3::kNormalLocation, 3);
  if (g.uvs != nullptr) {
    part.uvs = GlBuffer(gl_);
    attribute(gl_, part.uvs, gles3::kUvLocation, 2);
    stream(gl_, part.uvs, {g.uvs, std::size_t{2} * g.slot_count});
  }
  // Always there, so that a heat map has somewhere to put its colours.
  attribute(gl_, part.colours, gles3::kColourLocation, 4);
  gl_.BindVertexArray(0);
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
}

void Figure::set_look(std::uint32_t index, const Mesh& mesh, Drawable& d) const {
  if (textures_ != nullptr) d.look = textures_->look(index);
  if (d.look.texture != 0) d.program.features |= gles3::kUvs;
  d.base_colour = base_colour(mesh, d.look.texture != 0);
}

// Without a palette.
Drawable Figure::unposed(std::uint32_t index, const gles3::GpuMesh& gpu, const Character& character,
                         Deformer deformer) const {
  const Mesh mesh = file_.mesh(index, level_);
  Drawable d;
  d.vertex_array = deformer == Deformer::as ? gpu.as_array : gpu.ssd_array;
  d.index_count = gpu.index_count;
  d.index_type = gpu.index_type;
  const int features = gpu.features & (gles3::kNormals | gles3::kColours | gles3::kMorphs | gles3::kSurfaceNormals);
  d.program = {gpu_deformer(deformer), gpu.influences, static_cast<std::uint8_t>(features)};
  d.coordinate_scale = gpu.coordinate_scale;
  d.morph_weights.assign(character.weights(index).begin(), character.weights(index).end());
  d.mesh = mesh;
  d.gpu = &gpu;
  set_look(index, mesh, d);
  d.centre = carried_centre(mesh, character.scene_from_joint(mesh.skeleton));
  return d;
}

// Its palette goes behind `palettes`.
Drawable Figure::posed(std::uint32_t index, const Character& character, Deformer deformer,
                       std::vector<Affine>& palettes) {
  Drawable d = unposed(index, parts_[index].gpu, character, deformer);
  const std::size_t first = palettes.size();
  palettes.resize(first + d.mesh.palette_size());
  const Span<const std::uint16_t> joints(d.mesh.joints, d.mesh.joint_count);
  marrow::tools::check(build_palette(joints, parts_[index].bind, character.scene_from_joint(d.mesh.skeleton),
                                     {palettes.data() + first, d.mesh.palette_size()}, d.mesh.half_joints));
  d.first_matrix = static_cast<std::uint32_t>(first);
  return d;
}

std::unique_ptr<BakedPlay> Figure::bake(const std::string& path, const Play& play) const {
  return std::make_unique<BakedPlay>(gl_, path, file_, play, level_, tangents_);
}

std::vector<Drawable> Figure::from_crowd(const Character& character, Deformer deformer, const BakedPlay& baked) const {
  std::vector<Drawable> drawables;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    Drawable& d = drawables.emplace_back(unposed(i, baked.mesh(i).gpu, character, deformer));
    d.program.palettes = gles3::Palettes::crowd;
    d.morph_weights.clear();
    d.crowd = &baked.crowd(i);
    d.crowd_mesh = &baked.mesh(i);
  }
  return drawables;
}

std::vector<Drawable> Figure::on_gpu(const Character& character, Deformer deformer, SkinPath path) {
  std::vector<Drawable> drawables;
  std::vector<Affine> palettes;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) drawables.push_back(posed(i, character, deformer, palettes));
  if (path == SkinPath::texture) {
    if (!palettes.empty()) marrow::tools::check(gles3::upload_palettes(gl_, texture_, palettes));
    for (Drawable& d : drawables) {
      d.program.palettes = gles3::Palettes::texture;
      d.palette_texture = &texture_;
    }
    return drawables;
  }
  gles3::begin_frame(gl_, ring_);
  for (Drawable& d : drawables)
    marrow::tools::check(
        gles3::push_palette(gl_, ring_, {palettes.data() + d.first_matrix, d.mesh.palette_size()}, d.palette_offset));
  if (path == SkinPath::ubo) return drawables;
  const gles3::Preskin method = path == SkinPath::compute ? gles3::Preskin::compute : gles3::Preskin::feedback;
  for (std::size_t i = 0; i < drawables.size(); ++i) preskin(parts_[i], method, drawables[i]);
  return drawables;
}

// `d` draws afterwards what was skinned.
void Figure::preskin(Part& part, gles3::Preskin method, Drawable& d) {
  if (part.skinned.array == 0) marrow::tools::check(gles3::create_skinned(gl_, part.gpu, part.skinned));
  gles3::ProgramKey key = d.program;
  key.features = static_cast<std::uint8_t>(part.gpu.features & ~(gles3::kUvs | gles3::kColours));
  const auto [at, is_new] = preskins_.try_emplace({method, key.deformer, key.influences, key.features});
  if (is_new) {
    std::vector<char> log(1024);
    const Status status = gles3::build_preskin(gl_, gl_.caps(), key, method, kPaletteBinding, at->second, log);
    if (status == Status::unsupported)
      throw Failure(Exit::unsupported, "--path compute", "", "no compute shaders: " + gl_.driver(),
                    "take another path");
    if (status != Status::ok)
      throw Failure(Exit::internal, "shader", "", log.data(), "please report this with the driver: " + gl_.driver());
  }
  gl_.UseProgram(at->second.id);
  gles3::bind_palette(gl_, ring_, d.palette_offset, kPaletteBinding);
  if (!d.morph_weights.empty())
    marrow::tools::check(gles3::set_morphs(gl_, d.mesh, part.gpu, d.morph_weights, kMorphUnit, at->second));
  marrow::tools::check(gles3::preskin(gl_, part.gpu, key.deformer, at->second, part.skinned));
  d.vertex_array = part.skinned.array;
  d.program = {gles3::Deformer::none, 4,
               static_cast<std::uint8_t>(d.program.features & (gles3::kNormals | gles3::kUvs | gles3::kColours))};
  d.morph_weights.clear();
}

std::vector<Drawable> Figure::from_cpu(std::span<const PosedMesh> posed, std::span<const std::vector<float>> colours) {
  std::vector<Drawable> drawables;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    const Mesh mesh = file_.mesh(i, level_);
    const Geometry& g = mesh.geometry;
    const Part& part = parts_[i];
    stream(gl_, part.positions, posed[i].positions);
    if (g.normals != nullptr) stream(gl_, part.normals, posed[i].normals);
    std::vector<float> own(std::size_t{4} * g.slot_count, 1.0f);
    for (std::size_t c = 0; g.colours != nullptr && c < own.size(); ++c)
      own[c] = static_cast<float>(g.colours[c]) / 255.0f;
    stream(gl_, part.colours, colours.empty() ? own : colours[i]);
    Drawable d;
    d.vertex_array = part.array;
    d.index_count = g.index_count;
    d.index_type = g.index_bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    const int features = (g.normals != nullptr ? gles3::kNormals : 0) | gles3::kColours;
    d.program = {gles3::Deformer::none, 4, static_cast<std::uint8_t>(features)};
    if (colours.empty()) set_look(i, mesh, d);
    Box box;
    for (std::size_t v = 0; v < posed[i].positions.size(); v += 3)
      box.add({posed[i].positions[v], posed[i].positions[v + 1], posed[i].positions[v + 2]});
    if (!box.empty()) d.centre = box.centre();
    drawables.push_back(d);
  }
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  return drawables;
}

std::uint64_t Figure::gpu_vertex_bytes() const {
  std::uint64_t bytes = 0;
  for (const Part& part : parts_) bytes += part.gpu.vertex_bytes;
  return bytes;
}

}  // namespace marrow::tools
