// What was cooked, packed or not, as the runtime sees it.
#pragma once

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "common/unpack_mrw.h"
#include "cook/cook.h"
#include "cook/write.h"
#include "marrow/file.h"

namespace marrow::cook {

struct LoadedCook {
  explicit LoadedCook(const CookResult& result) : report(result.report) {
    bytes = format::kPackedMagic == magic(result.file) ? tools::unpacked(result.file, "")
                                                       : tools::AlignedBytes{std::span<const std::byte>(result.file)};
    EXPECT_EQ(load({bytes.data(), bytes.size()}, file), Status::ok);
  }
  static std::uint32_t magic(const std::vector<std::byte>& file) {
    std::uint32_t out = 0;
    std::memcpy(&out, file.data(), sizeof out);
    return out;
  }

  nlohmann::ordered_json report;
  tools::AlignedBytes bytes;
  File file;
};

}  // namespace marrow::cook
