// Files out of the APK, in place where they lie so that Marrow can read them there.
#pragma once

#include <android/asset_manager.h>

#include "log.h"
#include "memory.h"

// An asset that stays open for as long as its bytes are used.
class Asset {
 public:
  Asset() = default;
  Asset(const Asset&) = delete;
  Asset& operator=(const Asset&) = delete;
  ~Asset() {
    if (asset_ != nullptr) AAsset_close(asset_);
  }

  // Its bytes; none, with a line in the log, if it is not there.
  marrow::Span<const std::byte> open(AAssetManager* manager, const char* name);
  // Whether the bytes lie in the mapped APK: an asset that is compressed there is unpacked to memory.
  bool is_in_place() const { return asset_ != nullptr && !AAsset_isAllocated(asset_); }

 private:
  AAsset* asset_ = nullptr;
};

// The bytes of `name` as marrow::load() wants them: unpacked, and on a boundary of 16 bytes. Where they do not lie so
// in the APK they are copied once into `memory`, and the log says so. None, with a line in the log, if that fails.
marrow::Span<const std::byte> open_cooked_file(AAssetManager* manager, const char* name, Asset& asset, Memory& memory);
