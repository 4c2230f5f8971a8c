// Includes tinygltf the way this program uses it: no images, no file system, the system's JSON library.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_INCLUDE_JSON
#include <nlohmann/json.hpp>

// After the JSON library, which it expects to be there.
#include <tiny_gltf.h>
