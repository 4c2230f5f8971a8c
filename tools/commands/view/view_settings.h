// What the panel of `marrow view` sets.
#pragma once

#include <cstdint>

#include "marrow/playback.h"
#include "render/camera.h"
#include "render/look.h"

namespace marrow::tools {

// What surfaces are coloured by.
enum class Colours : std::uint8_t {
  surface,
  distance,  // between two deformers
  weights,   // of a joint
};

struct Settings {
  std::size_t clip = 0;    // of Actor::plays(); 0 is the rest pose
  std::size_t second = 0;  // likewise; 0: none
  float second_weight = 0.5f;
  Playback playback;
  bool playing = true;

  Deformer deformer = Deformer::ssd;
  SkinPath path = SkinPath::ubo;
  AsNormals normals = AsNormals::tangents;
  int lod = 0;

  Colours colours = Colours::surface;
  DeformerPair pair = {Deformer::ssd, Deformer::as};
  std::size_t joint = 0;  // of Actor::joints()
  bool bones = false;

  int coarseness = 1;  // pixels of the window a pixel of the picture, each way
  Orbit orbit;
  bool framed = false;  // false: the camera is to be put where it sees all
};

}  // namespace marrow::tools
