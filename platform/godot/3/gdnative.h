// What of Godot 3's C interface, GDNative 1.0 and NativeScript 1.0, is used here, declared by hand: its functions are
// a list of pointers in a fixed order, which later releases only add to in lists of their own.
#pragma once
#include <cstddef>
#include <cstdint>

namespace gdnative {

// Values, whose insides are Godot's own.
struct Variant {
  alignas(8) std::uint8_t inside[24];
};
struct Text {
  void* inside;
};
struct Characters {  // what a Text is in UTF-8
  void* inside;
};
struct Pool {  // a PoolByteArray, PoolIntArray, …
  void* inside;
};
using Object = void;
struct Access;
struct Bind;

// Types of a Variant.
enum : int { kNil = 0, kBool = 1, kInt = 2, kReal = 3, kString = 4, kObject = 17, kPoolBytes = 20 };

struct Version {
  unsigned major, minor;
};

struct Extension {
  unsigned type;  // 1: NativeScript
  Version version;
  const Extension* next;
};

using Function = void (*)();

struct Core {
  unsigned type;
  Version version;
  const Extension* next;
  unsigned extension_count;
  const Extension* const* extensions;
  Function functions[744];
};

// Places in Core::functions.
enum Place : int {
  kPoolBytesNew = 155,
  kPoolBytesResize = 164,
  kPoolBytesRead = 165,
  kPoolBytesWrite = 166,
  kPoolBytesSize = 169,
  kPoolBytesDestroy = 170,
  kPoolIntsNew = 171,
  kPoolIntsResize = 180,
  kPoolIntsWrite = 182,
  kPoolIntsDestroy = 186,
  kPoolRealsNew = 187,
  kPoolRealsResize = 196,
  kPoolRealsWrite = 198,
  kPoolRealsDestroy = 202,
  kPoolTextsNew = 203,
  kPoolTextsAppend = 206,
  kPoolTextsDestroy = 218,
  kPoolBytesReadPointer = 268,
  kPoolBytesReadDestroy = 270,
  kPoolBytesWritePointer = 296,
  kPoolBytesWriteDestroy = 298,
  kPoolIntsWritePointer = 300,
  kPoolIntsWriteDestroy = 302,
  kPoolRealsWritePointer = 304,
  kPoolRealsWriteDestroy = 306,
  kVariantType = 507,
  kVariantNewNil = 509,
  kVariantNewBool = 510,
  kVariantNewInt = 512,
  kVariantNewReal = 513,
  kVariantNewText = 514,
  kVariantNewBytes = 530,
  kVariantNewInts = 531,
  kVariantNewReals = 532,
  kVariantNewTexts = 533,
  kVariantAsBool = 537,
  kVariantAsInt = 539,
  kVariantAsReal = 540,
  kVariantAsText = 541,
  kVariantAsObject = 554,
  kVariantAsBytes = 557,
  kVariantDestroy = 570,
  kCharactersData = 572,
  kCharactersDestroy = 573,
  kTextUtf8 = 678,
  kTextFromUtf8 = 681,
  kTextDestroy = 721,
  kMethodBind = 732,
  kMethodCall = 733,
  kPrintError = 741,
};

struct InitOptions {
  bool in_editor;
  std::uint64_t core_api_hash, editor_api_hash, no_api_hash;
  void (*report_version_mismatch)(const Object*, const char*, Version, Version);
  void (*report_loading_error)(const Object*, const char*);
  Object* library;
  const Core* core;
  const Text* active_library_path;
};

struct Create {
  void* (*call)(Object*, void*);
  void* data;
  void (*free)(void*);
};
struct Destroy {
  void (*call)(Object*, void*, void*);
  void* data;
  void (*free)(void*);
};
struct Attributes {
  int rpc;
};
struct Method {
  Variant (*call)(Object*, void* method, void* instance, int count, Variant** arguments);
  void* data;
  void (*free)(void*);
};

struct NativeScript {
  Extension head;
  void (*register_class)(void* library, const char* name, const char* base, Create, Destroy);
  void (*register_tool_class)(void* library, const char* name, const char* base, Create, Destroy);
  void (*register_method)(void* library, const char* type, const char* name, Attributes, Method);
};

}  // namespace gdnative
