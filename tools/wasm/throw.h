// What programs for WebAssembly share: how JavaScript is called, and calls.
#pragma once

#include <cstddef>

#define MARROW_IMPORT(name) __attribute__((import_module("marrow"), import_name(name)))
#define MARROW_EXPORT(name) extern "C" __attribute__((export_name(name)))

extern "C" {
// Throws in JavaScript, which ends the instance: WebAssembly has no exceptions here.
[[noreturn]] MARROW_IMPORT("failed") void marrow_failed(const char* text, std::size_t length, int code);
}
