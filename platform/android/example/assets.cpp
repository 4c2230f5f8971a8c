#include "assets.h"

#include <marrow/file.h>
#include <marrow/unpack.h>

#include <cstring>

marrow::Span<const std::byte> Asset::open(AAssetManager* manager, const char* name) {
  asset_ = AAssetManager_open(manager, name, AASSET_MODE_BUFFER);
  if (asset_ == nullptr) {
    LOG_ERROR("%s: not among the APK's assets; put it into src/main/assets and build again", name);
    return {};
  }
  const void* const bytes = AAsset_getBuffer(asset_);
  const long size = AAsset_getLength(asset_);
  if (bytes == nullptr || size <= 0) {
    LOG_ERROR("%s: Android cannot read it from the APK; is it empty, or was the download cut off?", name);
    return {};
  }
  return {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)};
}

namespace {

marrow::Span<const std::byte> unpack_file(const char* name, marrow::Span<const std::byte> packed, Memory& memory) {
  marrow::UnpackSizes sizes;
  marrow::DataError error;
  marrow::Span<const std::byte> file;
  // A file that the game ships: of a stranger's a limit would stand here, see unpack_sizes().
  marrow::Status status = unpack_sizes(packed, sizes, &error);
  if (status == marrow::Status::ok) status = unpack(packed, {}, memory.take(sizes.memory_bytes), file, &error);
  if (status == marrow::Status::unsupported)
    LOG_ERROR("%s: %s; cook it with --mesh-codec none, or link a codec", name, error.rule);
  else if (status != marrow::Status::ok)
    LOG_ERROR("%s: byte %u: %s; cook it again", name, static_cast<unsigned>(error.offset), error.rule);
  return status == marrow::Status::ok ? file : marrow::Span<const std::byte>{};
}

}  // namespace

marrow::Span<const std::byte> open_cooked_file(AAssetManager* manager, const char* name, Asset& asset, Memory& memory) {
  const marrow::Span<const std::byte> bytes = asset.open(manager, name);
  if (bytes.empty()) return {};
  const unsigned size = static_cast<unsigned>(bytes.size);
  if (marrow::is_packed(bytes)) {
    LOG_INFO("%s: %u bytes, unpacked", name, size);
    return unpack_file(name, bytes, memory);
  }
  if (marrow::is_on_boundary(bytes.data)) {
    LOG_INFO("%s: %u bytes, used in place%s", name, size, asset.is_in_place() ? "" : ", in memory of Android's");
    return bytes;
  }
  LOG_WARN("%s: %u bytes, copied, as it begins on no multiple of 16 in the APK: %s", name, size,
           asset.is_in_place() ? "see align_apk.py" : "it is compressed there, see noCompress");
  const marrow::Span<std::byte> copy = memory.take(bytes.size);
  if (copy.size < bytes.size) {
    LOG_ERROR("%s: no memory for %u bytes", name, size);
    return {};
  }
  std::memcpy(copy.data, bytes.data, bytes.size);
  return {copy.data, bytes.size};
}
