// How a character on the stage is shown: what plays, how it is deformed, coloured and turned, from where it is seen.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "marrow/playback.h"
#include "marrow/springs.h"
#include "pose/reach.h"
#include "render/camera.h"
#include "render/manner.h"

namespace marrow::tools {

// What surfaces are coloured by.
enum class Colours : std::uint8_t {
  surface,
  distance,  // between two deformers
  weights,   // of a joint
  uv,        // a checker on the texture coordinates
};

// What is drawn over the picture, and among the figures.
struct Overlays {
  bool bones = false, names = false, axes = false, trail = false, steps = false;
  bool grid = false, wireframe = false, normals = false;
  int ghosts = 0;      // before and after each
  int ghost_step = 4;  // frames
};

inline constexpr Named<bool Overlays::*> kOverlays[] = {
    {"bones", &Overlays::bones},         {"names", &Overlays::names},    {"axes", &Overlays::axes},
    {"trail", &Overlays::trail},         {"steps", &Overlays::steps},    {"grid", &Overlays::grid},
    {"wireframe", &Overlays::wireframe}, {"normals", &Overlays::normals}};

// A joint turned by hand, after the clip has posed it.
struct Turn {
  std::size_t joint = 0;  // of Actor::joints()
  glm::vec3 degrees{0};   // about the parent's x, then y, then z axis
};

struct Settings {
  std::size_t clip = 0;    // of Actor::plays(); 0 is the rest pose
  std::size_t second = 0;  // likewise; 0: none
  float second_weight = 0.5f;
  Playback playback;
  bool playing = true;
  float rate_hz = 0;  // of frames; 0: the clip's own

  std::size_t parameter = 0;  // of a graph: the number that keys change

  Deformer deformer = Deformer::ssd;
  SkinPath path = SkinPath::ubo;
  AsNormals normals = AsNormals::blended;
  int lod = 0;

  Colours colours = Colours::surface;
  DeformerPair pair = {Deformer::ssd, Deformer::as};
  std::size_t joint = 0;    // of Actor::joints()
  bool picked = false;      // whether that is the user's choice
  bool show_joint = false;  // to be scrolled to in the tree, once
  Overlays overlays;

  std::vector<Turn> turns;
  ReachArguments reach;
  bool limits = false;
  bool springs = false;                  // below the chosen joint
  SpringJoint spring;                    // as all of its chain are
  std::map<std::size_t, float> weights;  // of morph targets of all meshes, in place of the clip's

  std::map<std::string, float> parameters;  // of example shapes, in place of the clip's

  int coarseness = 1;  // pixels of the window a pixel of the picture, each way
  Orbit orbit;
  bool framed = false;  // false: the camera is to be put where it sees all
};

}  // namespace marrow::tools
