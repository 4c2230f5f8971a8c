# What the cooker is built on where nothing is installed: headers, and two libraries that are compiled here.
# MARROW_PACKAGES: a folder that tools/check/cook_wasm.sh fills, with include/, draco/ and meshoptimizer/.
set(MARROW_PACKAGES "" CACHE PATH "Folder of the headers and sources that the cooker needs for WebAssembly")
set(headers ${MARROW_PACKAGES}/include)
foreach(name nlohmann_json::nlohmann_json fmt::fmt glm::glm tomlplusplus::tomlplusplus Eigen3::Eigen)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name} SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/cmake/wasm ${headers})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
set(XXHASH_INCLUDE_DIR ${headers})
set(MARROW_STB_INCLUDE ${headers})
