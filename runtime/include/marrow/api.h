// What a shared library of Marrow's exports: the functions that a public header marks, and nothing else.
#pragma once

// MARROW_BUILDS_SHARED is CMakeLists.txt's, while it builds shared libraries. A static library marks nothing, so that
// whatever links it exports nothing of Marrow's.
#if !defined(MARROW_BUILDS_SHARED)
#define MARROW_API
#elif defined(_WIN32)
#define MARROW_API __declspec(dllexport)
#else
#define MARROW_API __attribute__((visibility("default")))
#endif
