// Images as the page has decoded them.
#pragma once

#include "render/textures.h"

namespace marrow::tools {

class PageImages : public Images {
 public:
  Pixels pixels(std::uint32_t index, int most) override;
};

}  // namespace marrow::tools
