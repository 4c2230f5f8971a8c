// Compiles tinygltf's implementation, once.
#define TINYGLTF_IMPLEMENTATION
#include <fstream>  // used by the implementation, not included by it

#include "cook/gltf/document/model.h"
