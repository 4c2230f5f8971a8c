// The road from an artist's file to a cooked one, for options that are values already.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "marrow/cook.h"

namespace marrow::cook {

// cook() of options that have been read.
Result cook_source(const std::string& name, CookOptions options, const Host& host);
// The same of a scene that has been read. What options name is read, where it has not been.
Result cook_scene(RawScene scene, CookOptions options, const Host& host);
Result cook_graphs(CookOptions options, const Host& host);

// What a clip pack or an outfit is for: a cooked file, or one that is cooked plainly. Adds to `reads`. Throws
// tools::Failure as cook(), and as load_mrw() does.
Character read_character(const std::string& name, const Host& host, std::vector<Read>& reads);

// What is written of a scene: from the artist's to the runtime's. Notes what is mended or left out. Throws
// tools::Failure (invalid: nothing to cook; unsupported: a limit of the format; usage: an option fits nothing).
BuiltScene build_scene(RawScene scene, const CookOptions& options, Notes& notes);

}  // namespace marrow::cook
