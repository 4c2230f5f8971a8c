// What is drawn: a character that walks, by marrow::gles3::Skinner.
#pragma once

#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

#include "assets.h"

// The file, and what lives as long as the app does; a context is there only between restore() and lose().
class Scene {
 public:
  // Reads the character and the ramp of light. false, with a line in the log, if there is no character.
  bool load(AAssetManager* manager);
  // Puts all of it on the current context, which is new; false, with a line in the log, if that cannot be.
  bool restore();
  // The context is gone with all that was in it.
  void lose();

  bool advance(float dt_s);
  bool draw(int width, int height);

  // Where in its clip the character is: what an app that is killed in the background keeps.
  double time_s() const { return playback_.time_s; }
  void set_time_s(double time_s) { playback_.time_s = time_s; }

 private:
  static constexpr std::size_t kMostMeshes = 8;
  static constexpr int kRampTexels = 64;

  bool make_skinners();
  void make_ramp();
  void draw_mesh(std::size_t index, const float (&clip_from_model)[16]);

  Memory memory_;
  Asset file_, ramp_;
  marrow::Span<const std::byte> ramp_bytes_;
  marrow::Animations animations_;
  const marrow::Animation* walk_ = nullptr;
  marrow::Playback playback_;
  marrow::Character body_;
  marrow::gles3::Api gl_;
  marrow::gles3::Caps caps_;
  marrow::gles3::ProgramSet programs_;
  marrow::gles3::Skinner skinners_[kMostMeshes];
  bool has_skinners_ = false;
  unsigned ramp_texture_ = 0;
  char driver_log_[512] = "";
};
