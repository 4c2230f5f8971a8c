// The character in the window of `marrow view`: where it comes from, and its weights as they are painted.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "commands/view/opening.h"
#include "commands/view/view_settings.h"
#include "paint/painting.h"
#include "stage/actor.h"

namespace marrow::tools {

class ViewActor : public Actor {
 public:
  // Of a source, and what choose() made of it by `choice`. Else as Actor.
  ViewActor(const Gl& gl, gles3::ProgramSet& programs, const Choice& choice, Source source, Chosen chosen);

  // Which of plays() --clip chose, or 0.
  std::size_t chosen() const { return chosen_; }
  // Its file has become loaded()'s.
  const Source& source() const { return source_; }

  // Of this file, and of the settings' paint_file. Made when it is first asked for.
  Painting& painting(const ViewSettings& settings);
  // Whether the settings ask for it, and it can be done.
  bool paints(const ViewSettings& settings);
  // Null before.
  Painting* painting() { return painting_ ? &*painting_ : nullptr; }

  std::vector<Drawable> drawables(const ViewSettings& settings, Shot& shot);

 private:
  std::vector<Drawable> painted(const ViewSettings& settings, Shot& shot);

  Source source_;
  std::size_t chosen_ = 0;
  std::optional<Painting> painting_;
};

}  // namespace marrow::tools
