#include "render/figure.h"

#include <algorithm>

#include "common/failure.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/palettes.h"

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
    case Deformer::mwe:
      throw Failure(Exit::unsupported, "--deformer mwe", "",
                    "no path of the GPU has multi-weights: they are 192 bytes a vertex, more than attributes hold",
                    "use --path cpu");
    case Deformer::psd:
      return gles3::Deformer::psd;
  }
  return gles3::Deformer::ssd;
}

// Of those that on_gpu() has.
gles3::SkinningPath skinning_path(SkinPath path) {
  return path == SkinPath::texture    ? gles3::SkinningPath::texture
         : path == SkinPath::feedback ? gles3::SkinningPath::feedback
         : path == SkinPath::compute  ? gles3::SkinningPath::compute
                                      : gles3::SkinningPath::ubo;
}

// White means that a texture would have the say: without one, such meshes get the colour of clay.
glm::vec4 base_colour(const Mesh& mesh, bool textured) {
  const bool white = mesh.base_colour[0] >= 0.99f && mesh.base_colour[1] >= 0.99f && mesh.base_colour[2] >= 0.99f;
  if (white && mesh.geometry.colours == nullptr && !textured) return {0.56f, 0.42f, 0.32f, mesh.base_colour[3]};
  return {mesh.base_colour[0], mesh.base_colour[1], mesh.base_colour[2], mesh.base_colour[3]};
}

// Where the middle of a mesh's bind box is, carried by its first joint.
glm::vec3 carried_centre(const Mesh& mesh, Span<const Affine> model_from_joint) {
  const Geometry& g = mesh.geometry;
  glm::vec3 p(0);
  for (int c = 0; c < 3; ++c) p[c] = 0.5f * (g.box_min[c] + g.box_max[c]);
  for (const Affine* m : {&mesh.inverse_bind[0], &model_from_joint[mesh.joints[0]]}) {
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

Figure::Figure(const Gl& gl, gles3::ProgramSet& programs, const File& file, const Textures* textures, AsNormals normals,
               std::uint32_t level)
    : gl_(gl), programs_(programs), file_(file), textures_(textures), level_(level) {
  tangents_.resize(file.mesh_count());
  if (normals == AsNormals::tangents) tangents_ = tangents_of(file, level);
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i, level);
    if (mesh.palette_size() > gles3::kPaletteJoints && !too_large_) too_large_ = i;
    streams_.push_back(make_streams(mesh));
  }
  gl.check("preparing a character");
}

Figure::~Figure() {
  for (auto& [key, skinned] : skinned_) gles3::destroy(gl_, skinned.skinner);
}

Figure::Streams Figure::make_streams(const Mesh& mesh) const {
  const Geometry& g = mesh.geometry;
  Streams out{GlBuffer(gl_), GlBuffer(gl_), GlBuffer(gl_), {}, GlBuffer(gl_), GlVertexArray(gl_)};
  gl_.BindVertexArray(out.array);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, out.indices);
  const std::size_t bytes = std::size_t{g.index_count} * g.index_bytes;
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<std::ptrdiff_t>(bytes), g.indices, GL_STATIC_DRAW);
  attribute(gl_, out.positions, gles3::kPositionLocation, 3);
  if (g.normals != nullptr) attribute(gl_, out.normals, gles3::kNormalLocation, 3);
  if (g.uvs != nullptr) {
    out.uvs = GlBuffer(gl_);
    attribute(gl_, out.uvs, gles3::kUvLocation, 2);
    stream(gl_, out.uvs, {g.uvs, std::size_t{2} * g.slot_count});
  }
  // Always there, so that a heat map has somewhere to put its colours.
  attribute(gl_, out.colours, gles3::kColourLocation, 4);
  gl_.BindVertexArray(0);
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  return out;
}

void Figure::set_look(std::uint32_t index, const Mesh& mesh, Drawable& d) const {
  if (textures_ != nullptr) d.look = textures_->look(index);
  d.base_colour = base_colour(mesh, d.look.texture != 0);
}

// What programs are to read: texture coordinates only where there is a texture.
std::uint8_t Figure::features(std::uint32_t mesh) const {
  const bool textured = textures_ != nullptr && textures_->look(mesh).textured();
  return static_cast<std::uint8_t>(textured ? 255 : 255 & ~gles3::kUvs);
}

void Figure::check_made(Status status) const {
  if (status == Status::gl_error && programs_.log[0] != 0)
    throw Failure(Exit::internal, "shader", "", programs_.log.data,
                  "please report this with the driver: " + gl_.driver());
  marrow::tools::check(status);
}

gles3::Skinner& Figure::skinner(std::uint32_t mesh, Deformer deformer, SkinPath path) {
  const std::tuple key(mesh, deformer, path);
  if (const auto found = skinned_.find(key); found != skinned_.end()) return found->second.skinner;
  gles3::SkinnerOptions options;
  options.path = skinning_path(path);
  options.deformer = gpu_deformer(deformer);
  options.texture_unit = kPaletteUnit;
  options.features = features(mesh);
  options.as_tangents = tangents_[mesh];
  const Mesh source = file_.mesh(mesh, level_);
  Skinned made{{}, AlignedBytes(gles3::skinner_bytes(source, options))};
  check_made(gles3::create_skinner(gl_, gl_.caps(), source, options, programs_,
                                   {made.memory.data(), made.memory.size()}, made.skinner));
  return skinned_.emplace(key, std::move(made)).first->second.skinner;
}

// Without what holds its vertices.
Drawable Figure::drawable(std::uint32_t index, const Character& character) const {
  const Mesh mesh = file_.mesh(index, level_);
  Drawable d;
  set_look(index, mesh, d);
  d.features = features(index);
  d.double_sided = mesh.double_sided;
  const std::span<const Affine> palette = character.palette(index);
  d.inside_out = turns_inside_out({palette.data(), palette.size()});
  d.centre = carried_centre(mesh, character.model_from_joint(mesh.skeleton));
  return d;
}

std::unique_ptr<BakedPlay> Figure::bake(const std::string& path, const Play& play, Deformer deformer) const {
  if (deformer == Deformer::psd)
    throw Failure(Exit::unsupported, "--deformer psd", "",
                  "crowds have no pose spaces: how near a pose is to their examples is not baked",
                  "use another --path");
  auto baked = std::make_unique<BakedPlay>(gl_, programs_, path, file_, play, level_, tangents_);
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i)
    check_made(
        gles3::create_crowd_programs(gl_, gl_.caps(), baked->mesh(i), gpu_deformer(deformer), features(i), programs_));
  return baked;
}

std::vector<Drawable> Figure::from_crowd(const Character& character, Deformer deformer, const BakedPlay& baked) const {
  std::vector<Drawable> drawables;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    Drawable& d = drawables.emplace_back(drawable(i, character));
    d.crowd = &baked.crowd(i);
    d.crowd_mesh = &baked.mesh(i);
    d.crowd_deformer = gpu_deformer(deformer);
  }
  return drawables;
}

std::vector<Drawable> Figure::on_gpu(const Character& character, Deformer deformer, SkinPath path) {
  if (path == SkinPath::compute && !gl_.caps().compute)
    throw Failure(Exit::unsupported, "--path compute", "", "no compute shaders: " + gl_.driver(), "take another path");
  std::vector<Drawable> drawables;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    gles3::Skinner& with = skinner(i, deformer, path);
    marrow::tools::check(gles3::pose(with, 0, character.model_from_joint(with.mesh.skeleton), character.weights(i)));
    marrow::tools::check(gles3::update(gl_, with, programs_, 1));
    drawables.push_back(drawable(i, character));
    drawables.back().skinner = &with;
  }
  return drawables;
}

std::vector<Drawable> Figure::from_cpu(std::span<const PosedMesh> posed, std::span<const std::vector<float>> colours) {
  std::vector<Drawable> drawables;
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    const Mesh mesh = file_.mesh(i, level_);
    const Geometry& g = mesh.geometry;
    const Streams& to = streams_[i];
    stream(gl_, to.positions, posed[i].positions);
    if (g.normals != nullptr) stream(gl_, to.normals, posed[i].normals);
    std::vector<float> own(std::size_t{4} * g.slot_count, 1.0f);
    for (std::size_t c = 0; g.colours != nullptr && c < own.size(); ++c)
      own[c] = static_cast<float>(g.colours[c]) / 255.0f;
    stream(gl_, to.colours, colours.empty() ? own : colours[i]);
    Drawable d;
    d.vertex_array = to.array;
    d.index_count = g.index_count;
    d.index_type = g.index_bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    int has = gles3::kColours;
    if (g.normals != nullptr) has |= gles3::kNormals;
    d.double_sided = mesh.double_sided;
    d.inside_out = posed[i].inside_out;
    if (colours.empty()) {
      set_look(i, mesh, d);
      has |= features(i) & gles3::kUvs;
    }
    d.features = static_cast<std::uint8_t>(has);
    Box box;
    for (std::size_t v = 0; v < posed[i].positions.size(); v += 3)
      box.add({posed[i].positions[v], posed[i].positions[v + 1], posed[i].positions[v + 2]});
    if (!box.empty()) d.centre = box.centre();
    drawables.push_back(d);
  }
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  return drawables;
}

}  // namespace marrow::tools
