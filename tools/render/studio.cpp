#include "render/studio.h"

#include <algorithm>
#include <array>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "common/check_status.h"
#include "common/failure.h"
#include "gles3/program.h"

namespace marrow::embedded {
extern const unsigned char shader_surface_vert[], shader_surface_frag[], shader_depth_vert[], shader_depth_frag[],
    shader_backdrop_vert[], shader_backdrop_frag[], shader_show_frag[], shader_studio[];
}

namespace marrow::tools {
namespace {

constexpr int kKeyMapSize = 2048;
constexpr int kSkyMapSize = 1024;
constexpr float kPenumbra = 0.2f;  // of the radius: room round a shadow map, more than the widest softness
constexpr GLint kKeyShadowUnit = 0;
constexpr GLint kKeyDepthUnit = 1;
constexpr GLint kSkyDepthUnit = 2;
constexpr GLint kBaseTextureUnit = 3;
constexpr GLint kEmissiveTextureUnit = 6;  // behind palettes and what is behind them

// Of a blended surface, texels that are all but opaque are drawn as opaque, so that they hide what is behind them
// within the same mesh; only the rest is blended.
constexpr float kAllButOpaque = 0.99f;

// From the upper left, in front.
const glm::vec3 kKeyDirection = glm::normalize(glm::vec3(-0.55f, 0.95f, 0.62f));
const glm::vec3 kSkyDirection(0, 1, 0);

glm::vec3 key_direction(const Shot& shot) {
  if (shot.light_turn_rad == 0) return kKeyDirection;
  return glm::vec3(glm::rotate(glm::mat4(1), shot.light_turn_rad, glm::vec3(0, 1, 0)) * glm::vec4(kKeyDirection, 0));
}

const char* text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

gles3::Program build(const Gl& gl, std::uint8_t features, const gles3::ProgramSource& source) {
  gles3::Program program;
  std::array<char, 1024> log;
  if (gles3::create_program(gl, {gles3::Deformer::none, 4, features}, source, 0, program, log) != Status::ok) {
    throw Failure(Exit::internal, "shader", "", log.data(), "please report this with the driver: " + gl.driver());
  }
  return program;
}

// Clip space → the [0, 1]³ of a texture.
glm::mat4 texture_from(const glm::mat4& clip_from_model) {
  return glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)) * clip_from_model;
}

GlSampler make_sampler(const Gl& gl, GLint filter, GLint compare) {
  GlSampler sampler(gl);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, compare);
  gl.SamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return sampler;
}

GlRenderbuffer make_renderbuffer(const Gl& gl, int samples, GLenum format, int width, int height) {
  GlRenderbuffer buffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

}  // namespace

Studio::Studio(const Gl& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      compare_sampler_(make_sampler(gl, GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE)),
      depth_sampler_(make_sampler(gl, GL_NEAREST, GL_NONE)),
      sampled_framebuffer_(gl),
      resolved_framebuffer_(gl),
      no_vertices_(gl) {
  const std::string studio = text(embedded::shader_studio);
  surface_text_ = studio + text(embedded::shader_surface_frag);
  programs_.roles[kSurface] = {text(embedded::shader_surface_vert), surface_text_.c_str(), {}};
  programs_.role_features[kSurface] = gles3::kNormals | gles3::kColours | gles3::kUvs;
  programs_.roles[kDepth] = {text(embedded::shader_depth_vert), text(embedded::shader_depth_frag), {}};
  programs_.role_features[kDepth] = gles3::kUvs;
  programs_.role_count = 2;
  programs_.log = log_;
  const std::string backdrop = studio + text(embedded::shader_backdrop_frag);
  const char* const whole = text(embedded::shader_backdrop_vert);
  backdrop_ = build(gl, 0, {whole, backdrop.c_str(), {}});
  show_ = build(gl, 0, {whole, text(embedded::shader_show_frag), {}});
  make_shadow_map(key_, kKeyMapSize);
  make_shadow_map(sky_, kSkyMapSize);
  make_white();
  make_targets();
}

void Studio::make_white() {
  const std::array<std::uint8_t, 4> texel{255, 255, 255, 255};
  white_ = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, white_);
  gl_.TexStorage2D(GL_TEXTURE_2D, 1, GL_SRGB8_ALPHA8, 1, 1);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void Studio::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  make_targets();
}

void Studio::make_targets() {
  const Gl& gl = gl_;
  // The largest count comes first.
  GLint most_samples = 0;
  gl.GetInternalformativ(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, GL_SAMPLES, 1, &most_samples);
  const int samples = std::min(most_samples, 4);
  samples_ = make_renderbuffer(gl, samples, GL_SRGB8_ALPHA8, width_, height_);
  samples_depth_ = make_renderbuffer(gl, samples, GL_DEPTH_COMPONENT24, width_, height_);
  resolved_ = GlTexture(gl);
  gl.BindTexture(GL_TEXTURE_2D, resolved_);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_SRGB8_ALPHA8, width_, height_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, sampled_framebuffer_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samples_depth_);
  const bool sampled = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolved_, 0);
  if (!sampled || gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
      gl.GetError() != GL_NO_ERROR) {
    throw Failure(Exit::unsupported, "OpenGL ES", "",
                  "no frame buffer of " + std::to_string(width_) + "x" + std::to_string(height_),
                  "ask for a smaller picture");
  }
}

Studio::~Studio() {
  for (auto& [key, program] : plain_) gles3::destroy(gl_, program);
  gles3::destroy(gl_, programs_);
  gles3::destroy(gl_, backdrop_);
  gles3::destroy(gl_, show_);
}

void Studio::make_shadow_map(ShadowMap& map, int size) {
  map.size = size;
  map.depth = GlTexture(gl_);
  map.framebuffer = GlFramebuffer(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, map.depth);
  gl_.TexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, size, size);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.depth, 0);
  const GLenum none = GL_NONE;
  gl_.DrawBuffers(1, &none);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", "no depth texture can be drawn to", "use another driver");
  }
}

const gles3::Program& Studio::program(Role role, const Drawable& d) {
  if (d.skinner != nullptr) return gles3::program_of(*d.skinner, programs_, role);
  if (d.crowd != nullptr) return gles3::crowd_program_of(*d.crowd_mesh, d.crowd_deformer, d.features, programs_, role);
  const auto features = static_cast<std::uint8_t>(d.features & programs_.role_features[role]);
  const auto found = plain_.find({role, features});
  if (found != plain_.end()) return found->second;
  return plain_.emplace(std::pair(role, features), build(gl_, features, programs_.roles[role])).first->second;
}

void Studio::draw(const Drawable& d, const gles3::Program& program) {
  if (d.skinner != nullptr) return check(gles3::draw(gl_, *d.skinner, programs_, program, 0, 1));
  if (d.crowd != nullptr) {
    check(gles3::bind_crowd(gl_, *d.crowd, *d.crowd_mesh, 0, 1, kPaletteUnit, program));
    return check(gles3::draw(gl_, *d.crowd_mesh, d.crowd_deformer, program, 1));
  }
  gl_.BindVertexArray(d.vertex_array);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(d.index_count), d.index_type, nullptr);
}

// Back faces of what has one side alone are not drawn until the next call, or cull_nothing().
void Studio::cull(const Drawable& d) {
  if (d.double_sided) return cull_nothing();
  gl_.Enable(GL_CULL_FACE);
  gl_.FrontFace(d.inside_out ? GL_CW : GL_CCW);
}

void Studio::cull_nothing() {
  gl_.Disable(GL_CULL_FACE);
  gl_.FrontFace(GL_CCW);
}

void Studio::draw_depth(const ShadowMap& map, const LightView& view, std::span<const Drawable> drawables) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  gl_.Viewport(0, 0, map.size, map.size);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  for (const Drawable& drawable : drawables) {
    const gles3::Program& with = program(kDepth, drawable);
    gl_.UseProgram(with.id);
    const bool solid = drawable.look.alpha == AlphaMode::opaque;
    set_surface(with.id, drawable, {solid ? -1 : drawable.look.alpha_cutoff, 2});  // blended surfaces have 0.5
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(with.id, "clip_from_model"), 1, GL_FALSE,
                         glm::value_ptr(view.clip_from_model));
    cull(drawable);
    draw(drawable, with);
  }
  cull_nothing();
}

void Studio::set_studio(GLuint id, const Shot& shot) {
  const auto at = [&](const char* name) { return gl_.GetUniformLocation(id, name); };
  const glm::vec3 key = key_direction(shot);
  gl_.Uniform3fv(at("camera_position"), 1, glm::value_ptr(shot.camera.position));
  gl_.Uniform1f(at("scene_radius"), shot.radius);
  gl_.Uniform1f(at("ground_height"), shot.ground_height);
  gl_.Uniform3fv(at("key_direction"), 1, glm::value_ptr(key));
  gl_.UniformMatrix4fv(at("key_from_model"), 1, GL_FALSE, glm::value_ptr(texture_from(key_view_.clip_from_model)));
  gl_.UniformMatrix4fv(at("sky_from_model"), 1, GL_FALSE, glm::value_ptr(texture_from(sky_view_.clip_from_model)));
  gl_.Uniform2fv(at("key_extent"), 1, glm::value_ptr(key_view_.extent));
  gl_.Uniform2fv(at("sky_extent"), 1, glm::value_ptr(sky_view_.extent));
  gl_.Uniform1i(at("key_shadow"), kKeyShadowUnit);
  gl_.Uniform1i(at("key_depth"), kKeyDepthUnit);
  gl_.Uniform1i(at("sky_depth"), kSkyDepthUnit);
}

void Studio::draw_backdrop(const Shot& shot) {
  gl_.Disable(GL_DEPTH_TEST);
  gl_.UseProgram(backdrop_.id);
  set_studio(backdrop_.id, shot);
  const glm::mat4 model_from_clip = glm::inverse(shot.camera.clip_from_model);
  const glm::vec3 centre = shot.box.centre();
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(backdrop_.id, "model_from_clip"), 1, GL_FALSE,
                       glm::value_ptr(model_from_clip));
  gl_.Uniform3fv(gl_.GetUniformLocation(backdrop_.id, "scene_centre"), 1, glm::value_ptr(centre));
  gl_.BindVertexArray(no_vertices_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.Enable(GL_DEPTH_TEST);
}

// Its colour, and of its texels those that are at least as opaque as alpha_range.x and less than alpha_range.y.
void Studio::set_surface(GLuint id, const Drawable& drawable, glm::vec2 alpha_range) {
  gl_.Uniform4fv(gl_.GetUniformLocation(id, "base_colour"), 1, glm::value_ptr(drawable.base_colour));
  gl_.Uniform2fv(gl_.GetUniformLocation(id, "alpha_range"), 1, glm::value_ptr(alpha_range));
  bind_texture(id, "base_texture", kBaseTextureUnit, drawable.look.texture, drawable.look.sampler);
}

void Studio::bind_texture(GLuint id, const char* name, GLint unit, GLuint texture, GLuint sampler) {
  gl_.Uniform1i(gl_.GetUniformLocation(id, name), unit);
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, texture != 0 ? texture : GLuint{white_});
  gl_.BindSampler(static_cast<GLuint>(unit), texture != 0 ? sampler : GLuint{depth_sampler_});
}

void Studio::draw_surface(const Shot& shot, const Drawable& drawable, glm::vec2 alpha_range) {
  const gles3::Program& with = program(kSurface, drawable);
  gl_.UseProgram(with.id);
  set_studio(with.id, shot);
  set_surface(with.id, drawable, alpha_range);
  const Look& look = drawable.look;
  gl_.Uniform3fv(gl_.GetUniformLocation(with.id, "emissive"), 1, glm::value_ptr(look.emissive));
  bind_texture(with.id, "emissive_texture", kEmissiveTextureUnit, look.emissive_texture, look.emissive_sampler);
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(with.id, "clip_from_model"), 1, GL_FALSE,
                       glm::value_ptr(shot.camera.clip_from_model));
  gl_.Uniform1f(gl_.GetUniformLocation(with.id, "shading"), look.unlit ? 0.0f : shot.shading);
  cull(drawable);
  draw(drawable, with);
}

void Studio::draw_surfaces(const Shot& shot, std::span<const Drawable> drawables) {
  std::vector<const Drawable*> blended;
  for (const Drawable& drawable : drawables) {
    const Look& look = drawable.look;
    if (look.alpha == AlphaMode::blend) blended.push_back(&drawable);
    draw_surface(shot, drawable,
                 {look.alpha == AlphaMode::opaque ? -1.0f
                  : look.alpha == AlphaMode::mask ? look.alpha_cutoff
                                                  : kAllButOpaque,
                  2});
  }
  const auto distance = [&](const Drawable* d) { return glm::length(d->centre - shot.camera.position); };
  std::stable_sort(blended.begin(), blended.end(),
                   [&](const auto* a, const auto* b) { return distance(a) > distance(b); });
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthMask(GL_FALSE);
  for (const Drawable* drawable : blended) draw_surface(shot, *drawable, {-1, kAllButOpaque});
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  cull_nothing();
}

Image Studio::shoot(const Shot& shot, std::span<const Drawable> drawables, Strokes* strokes) {
  take(shot, drawables, strokes);
  Image image = read_pixels(gl_, resolved_framebuffer_, width_, height_);
  gl_.check("drawing a picture");
  return image;
}

void Studio::take(const Shot& shot, std::span<const Drawable> drawables, Strokes* strokes) {
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.ClearDepthf(1.0f);
  Box shaded = shot.box;
  shaded.add({shot.box.centre().x, shot.ground_height, shot.box.centre().z});
  key_view_ = frame_box(shaded, key_direction(shot), kPenumbra);
  sky_view_ = frame_box(shaded, kSkyDirection, kPenumbra);
  draw_depth(key_, key_view_, drawables);
  draw_depth(sky_, sky_view_, drawables);

  const std::array<std::pair<GLuint, GLuint>, 3> maps{
      {{key_.depth, compare_sampler_}, {key_.depth, depth_sampler_}, {sky_.depth, depth_sampler_}}};
  for (GLuint unit = 0; unit < maps.size(); ++unit) {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(GL_TEXTURE_2D, maps[unit].first);
    gl_.BindSampler(unit, maps[unit].second);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, sampled_framebuffer_);
  gl_.Viewport(0, 0, width_, height_);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_backdrop(shot);
  draw_surfaces(shot, drawables);
  if (strokes != nullptr) strokes->draw(shot.camera);
  for (const GLint unit : {kKeyShadowUnit, kKeyDepthUnit, kSkyDepthUnit, kBaseTextureUnit, kEmissiveTextureUnit}) {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.BindSampler(static_cast<GLuint>(unit), 0);
  }
  gl_.BindVertexArray(0);
  gl_.UseProgram(0);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, sampled_framebuffer_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.check("drawing");
}

void Studio::show(GLuint framebuffer, int x, int y, int width, int height) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_.Viewport(x, y, width, height);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.UseProgram(show_.id);
  gl_.Uniform1i(gl_.GetUniformLocation(show_.id, "picture"), 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, resolved_);
  gl_.BindVertexArray(no_vertices_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.BindVertexArray(0);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.UseProgram(0);
}

Image read_pixels(const Gl& gl, GLuint framebuffer, int width, int height) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    // GL's first row is the lowest.
    const std::uint8_t* from =
        rgba.data() + 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height - 1 - y);
    for (int x = 0; x < width; ++x) std::copy_n(from + 4 * x, 3, image.pixel(x, y));
  }
  return image;
}

}  // namespace marrow::tools
