# What the tools are built on: the system's packages where they are found (Debian's names in tools/packages/build.txt),
# the projects' own repositories elsewhere. The runtime depends on none of them.
if(CMAKE_SYSTEM_NAME STREQUAL WASI)
  include(cmake/WasmDependencies.cmake)
  return()
endif()
include(FetchContent)
FetchContent_Declare(nlohmann_json GIT_REPOSITORY https://github.com/nlohmann/json.git GIT_TAG v3.11.2
  FIND_PACKAGE_ARGS NAMES nlohmann_json)
FetchContent_Declare(CLI11 GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git GIT_TAG v2.3.2
  FIND_PACKAGE_ARGS NAMES CLI11)
FetchContent_Declare(fmt GIT_REPOSITORY https://github.com/fmtlib/fmt.git GIT_TAG 9.1.0 FIND_PACKAGE_ARGS NAMES fmt)
FetchContent_Declare(glm GIT_REPOSITORY https://github.com/g-truc/glm.git GIT_TAG 0.9.9.8 FIND_PACKAGE_ARGS NAMES glm)
FetchContent_Declare(TinyGLTF GIT_REPOSITORY https://github.com/syoyo/tinygltf.git GIT_TAG v2.8.1
  FIND_PACKAGE_ARGS)
FetchContent_Declare(tomlplusplus GIT_REPOSITORY https://github.com/marzer/tomlplusplus.git GIT_TAG v3.3.0
  FIND_PACKAGE_ARGS)
FetchContent_Declare(Eigen3 GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git GIT_TAG 3.4.0 FIND_PACKAGE_ARGS)
FetchContent_MakeAvailable(nlohmann_json CLI11 fmt glm TinyGLTF tomlplusplus Eigen3)
# xxHash is used as a header alone.
find_path(XXHASH_INCLUDE_DIR xxhash.h)
if(NOT XXHASH_INCLUDE_DIR)
  FetchContent_Declare(xxhash GIT_REPOSITORY https://github.com/Cyan4973/xxHash.git GIT_TAG v0.8.1 SOURCE_SUBDIR none)
  FetchContent_MakeAvailable(xxhash)
  set(XXHASH_INCLUDE_DIR ${xxhash_SOURCE_DIR} CACHE PATH "Folder of xxhash.h" FORCE)
endif()
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
# Caches on servers; without it the program has folders alone.
find_package(CURL 7.85)
# tinygltf's repository has it too.
find_path(MARROW_STB_INCLUDE stb_image.h PATH_SUFFIXES stb HINTS ${tinygltf_SOURCE_DIR} REQUIRED)
find_package(Threads REQUIRED)
