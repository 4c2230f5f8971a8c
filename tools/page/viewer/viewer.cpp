// What src/viewer.ts calls. An instance shows one file; what fails ends it.
#include <cstdlib>
#include <memory>
#include <string>

#include "page/viewer/about.h"
#include "page/viewer/page_images.h"
#include "page/viewer/show.h"
#include "render/heat.h"
#include "wasm/throw.h"

namespace marrow::tools {
namespace {

std::string path;
LoadedFile loaded;
std::unique_ptr<Show> shown;
std::string text;  // of the last call that gives one
float numbers[3];

// Names of a file may be no UTF-8.
const char* told(const nlohmann::ordered_json& json) {
  text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return text.c_str();
}

const float* three(glm::vec3 from) {
  for (int i = 0; i < 3; ++i) numbers[i] = from[i];
  return numbers;
}

}  // namespace
}  // namespace marrow::tools

using namespace marrow::tools;  // NOLINT: a program of one file

MARROW_EXPORT("take_memory") void* take_memory(std::size_t size) {
  return std::malloc(size);
}

// Loads a file. bytes: of take_memory(), which this gives back. Its images as JSON: {name, uri, at, size}, of one that
// is in the file where its bytes are in memory.
MARROW_EXPORT("load")
const char* load_file(const char* name, std::size_t name_length, std::byte* bytes, std::size_t size) {
  AlignedBytes own(std::span<const std::byte>(bytes, size));
  std::free(bytes);
  path.assign(name, name_length);
  loaded = load_mrw(path, std::move(own));
  nlohmann::ordered_json images = nlohmann::ordered_json::array();
  for (std::uint32_t i = 0; i < loaded.file.image_count(); ++i) {
    const marrow::Image image = loaded.file.image(i);
    images.push_back({{"name", image.name},
                      {"uri", image.uri},
                      {"at", reinterpret_cast<std::uintptr_t>(image.bytes.data)},
                      {"size", image.bytes.size}});
  }
  return told(images);
}

// Begins to show it: asks for its images, by "image".
MARROW_EXPORT("show") void show_file() {
  PageImages images;
  shown = std::make_unique<Show>(path, std::move(loaded), images);
}

// Begins to show it in a half of its own, in the pose of what is shown. 0: it is another character.
MARROW_EXPORT("show_plain") int show_plain() {
  PageImages images;
  return shown->add_plain(std::move(loaded), images) ? 1 : 0;
}

MARROW_EXPORT("about") const char* about_file() {
  return told(about(shown->actor()));
}

MARROW_EXPORT("set") void set(const char* json, std::size_t length) {
  shown->set(nlohmann::json::parse(json, json + length));
}

MARROW_EXPORT("frame") const char* frame(float dt_s, int width, int height) {
  return told(shown->frame(dt_s, width, height));
}

MARROW_EXPORT("places") const float* places() {
  return shown->places().data();
}

MARROW_EXPORT("turn") void turn(float dx, float dy) {
  shown->turn(dx, dy);
}

MARROW_EXPORT("move") void move(float dx, float dy, float height) {
  shown->move(dx, dy, height);
}

MARROW_EXPORT("zoom") void zoom(float steps) {
  shown->zoom(steps);
}

MARROW_EXPORT("joint_at") const float* joint_at(std::uint32_t joint) {
  return three(shown->joint_at(joint));
}

MARROW_EXPORT("drag_goal") const float* drag_goal(std::uint32_t goal, float dx, float dy, float height) {
  return three(shown->drag_goal(goal, dx, dy, height));
}

MARROW_EXPORT("heat_colour") const float* heat(float t) {
  const Rgb rgb = heat_colour(t);
  return three({rgb[0], rgb[1], rgb[2]});
}
