// Marrow in Godot 3: the class MarrowNative, a NativeScript, whose methods are those of common/methods.h.
#include <new>

#include "../common/methods.h"
#include "gdnative.h"

#ifdef _WIN32
#define MARROW_GODOT_EXPORT extern "C" __declspec(dllexport)
#else
#define MARROW_GODOT_EXPORT extern "C" __attribute__((visibility("default")))
#endif

namespace {

using namespace gdnative;
using marrow_godot::Cooked;
using marrow_godot::Kind;
using marrow_godot::kReals;
using marrow_godot::Value;

const Core* core = nullptr;
const NativeScript* scripts = nullptr;
Bind* is_class = nullptr;
Bind* get_bone_count = nullptr;
Bind* set_bone_pose = nullptr;

// Calls the function at a place of Godot's list.
template <typename Result, typename... Arguments>
Result call(Place place, Arguments... arguments) {
  return reinterpret_cast<Result (*)(Arguments...)>(core->functions[place])(arguments...);
}

void call_method(Bind* bind, Object* object, const void** arguments, void* result) {
  call<void>(kMethodCall, bind, object, arguments, result);
}

// ---- From Godot's values, and back.

std::string to_text(const Variant* from) {
  Text text = call<Text>(kVariantAsText, from);
  Characters characters = call<Characters>(kTextUtf8, static_cast<const Text*>(&text));
  const char* const data = call<const char*>(kCharactersData, static_cast<const Characters*>(&characters));
  std::string out = data == nullptr ? "" : data;
  call<void>(kCharactersDestroy, &characters);
  call<void>(kTextDestroy, &text);
  return out;
}

// A PoolByteArray that is read as long as this lives.
struct Bytes {
  Pool pool{};
  Access* access = nullptr;

  ~Bytes() {
    if (access == nullptr) return;
    call<void>(kPoolBytesReadDestroy, access);
    call<void>(kPoolBytesDestroy, &pool);
  }
  void read(const Variant* from, Value& out) {
    pool = call<Pool>(kVariantAsBytes, from);
    access = call<Access*>(kPoolBytesRead, static_cast<const Pool*>(&pool));
    out.bytes = call<const std::uint8_t*>(kPoolBytesReadPointer, static_cast<const Access*>(access));
    out.byte_count = std::size_t(call<int>(kPoolBytesSize, static_cast<const Pool*>(&pool)));
  }
};

// Whether Godot turns a value of this type into the kind without a loss.
bool fits(int type, Kind kind) {
  switch (kind) {
    case Kind::real:
      return type == kReal || type == kInt;
    case Kind::whole:
      return type == kInt || type == kReal;
    case Kind::text:
      return type == kString;
    case Kind::bytes:
      return type == kPoolBytes;
    case Kind::object:
      return type == kObject || type == kNil;
    default:
      return false;
  }
}

bool read(const Variant* from, Kind kind, Value& out, Bytes& bytes) {
  const int type = call<int>(kVariantType, from);
  if (!fits(type, kind)) return false;
  if (kind == Kind::real) out.real = call<double>(kVariantAsReal, from);
  if (kind == Kind::whole) out.whole = call<std::int64_t>(kVariantAsInt, from);
  if (kind == Kind::text) out.text = to_text(from);
  if (kind == Kind::bytes) bytes.read(from, out);
  if (kind == Kind::object && type == kObject) out.object = call<Object*>(kVariantAsObject, from);
  return true;
}

struct PoolPlaces {
  Place make, resize, write, pointer, end, to_variant, destroy;
};
constexpr PoolPlaces kBytes{kPoolBytesNew,          kPoolBytesResize, kPoolBytesWrite,  kPoolBytesWritePointer,
                            kPoolBytesWriteDestroy, kVariantNewBytes, kPoolBytesDestroy};
constexpr PoolPlaces kInts{kPoolIntsNew,          kPoolIntsResize, kPoolIntsWrite,  kPoolIntsWritePointer,
                           kPoolIntsWriteDestroy, kVariantNewInts, kPoolIntsDestroy};
constexpr PoolPlaces kReals32{kPoolRealsNew,          kPoolRealsResize, kPoolRealsWrite,  kPoolRealsWritePointer,
                              kPoolRealsWriteDestroy, kVariantNewReals, kPoolRealsDestroy};

template <typename Number>
void write_pool(const Number* from, std::size_t count, const PoolPlaces& places, Variant& out) {
  Pool pool;
  call<void>(places.make, &pool);
  call<void>(places.resize, &pool, int(count));
  Access* const access = call<Access*>(places.write, &pool);
  Number* const to = call<Number*>(places.pointer, static_cast<const Access*>(access));
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
  call<void>(places.end, access);
  call<void>(places.to_variant, &out, static_cast<const Pool*>(&pool));
  call<void>(places.destroy, &pool);
}

void write_texts(const std::vector<std::string>& from, Variant& out) {
  Pool pool;
  call<void>(kPoolTextsNew, &pool);
  for (const std::string& each : from) {
    Text text = call<Text>(kTextFromUtf8, each.c_str());
    call<void>(kPoolTextsAppend, &pool, static_cast<const Text*>(&text));
    call<void>(kTextDestroy, &text);
  }
  call<void>(kVariantNewTexts, &out, static_cast<const Pool*>(&pool));
  call<void>(kPoolTextsDestroy, &pool);
}

Variant write(const Value& from, Kind kind) {
  Variant out;
  switch (kind) {
    case Kind::truth:
      call<void>(kVariantNewBool, &out, from.whole != 0);
      break;
    case Kind::whole:
      call<void>(kVariantNewInt, &out, from.whole);
      break;
    case Kind::real:
      call<void>(kVariantNewReal, &out, from.real);
      break;
    case Kind::bytes:
      write_pool(from.bytes, from.byte_count, kBytes, out);
      break;
    case Kind::ints:
      write_pool(from.ints.data(), from.ints.size(), kInts, out);
      break;
    case Kind::reals:
      write_pool(from.reals.data(), from.reals.size(), kReals32, out);
      break;
    case Kind::texts:
      write_texts(from.texts, out);
      break;
    case Kind::text: {
      Text text = call<Text>(kTextFromUtf8, from.text.c_str());
      call<void>(kVariantNewText, &out, static_cast<const Text*>(&text));
      call<void>(kTextDestroy, &text);
      break;
    }
    default:
      call<void>(kVariantNewNil, &out);
  }
  return out;
}

// ---- Poses. Godot 3 wants them as changes of the rest: rest⁻¹ · local, three rows of a basis and an origin.

void multiply(const float* a, const float* b, float* out) {  // quaternions x y z w
  out[0] = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
  out[1] = a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0];
  out[2] = a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3];
  out[3] = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
}

void to_rows(const float* q, float rows[3][3]) {
  const float x = q[0], y = q[1], z = q[2], w = q[3];
  rows[0][0] = 1 - 2 * (y * y + z * z), rows[0][1] = 2 * (x * y - w * z), rows[0][2] = 2 * (x * z + w * y);
  rows[1][0] = 2 * (x * y + w * z), rows[1][1] = 1 - 2 * (x * x + z * z), rows[1][2] = 2 * (y * z - w * x);
  rows[2][0] = 2 * (x * z - w * y), rows[2][1] = 2 * (y * z + w * x), rows[2][2] = 1 - 2 * (x * x + y * y);
}

void from_rest(const float* rest, const float* local, float out[12]) {
  const float inverse[4] = {-rest[3], -rest[4], -rest[5], rest[6]};
  float turn[4], change[3][3], back[3][3];
  multiply(inverse, local + 3, turn);
  to_rows(turn, change);
  to_rows(inverse, back);
  for (int row = 0; row < 3; ++row) {
    float moved = 0;
    for (int i = 0; i < 3; ++i) moved += back[row][i] * (local[i] - rest[i]);
    out[9 + row] = moved / rest[7 + row];
    for (int i = 0; i < 3; ++i) out[3 * row + i] = change[row][i] * local[7 + i] / rest[7 + row];
  }
}

bool set_bones(void* skeleton, const float* pose, const float* rests, std::size_t bone_count) {
  if (skeleton == nullptr) return false;
  Text name = call<Text>(kTextFromUtf8, "Skeleton");
  const void* of_name[] = {&name};
  bool is_skeleton = false;
  call_method(is_class, skeleton, of_name, &is_skeleton);
  call<void>(kTextDestroy, &name);
  std::int64_t count = 0;
  const void* none[] = {nullptr};
  if (is_skeleton) call_method(get_bone_count, skeleton, none, &count);
  if (!is_skeleton || count != std::int64_t(bone_count)) return false;
  for (std::int64_t bone = 0; bone < count; ++bone) {
    float transform[12];
    from_rest(rests + kReals * bone, pose + kReals * bone, transform);
    const void* arguments[] = {&bone, transform};
    call_method(set_bone_pose, skeleton, arguments, nullptr);
  }
  return true;
}

constexpr marrow_godot::Engine kEngine{set_bones};

// ---- The class.

void* create(Object*, void*) {
  return new (std::nothrow) Cooked;
}
void destroy(Object*, void*, void* instance) {
  delete static_cast<Cooked*>(instance);
}

Variant call_from_script(Object*, void* data, void* instance, int count, Variant** from) {
  const auto& method = *static_cast<const marrow_godot::Method*>(data);
  Cooked& cooked = *static_cast<Cooked*>(instance);
  Value arguments[marrow_godot::kMostArguments], result;
  Bytes bytes;
  bool good = count == method.argument_count;
  for (int i = 0; good && i < count; ++i) good = read(from[i], method.arguments[i].kind, arguments[i], bytes);
  if (good)
    method.call(cooked, kEngine, arguments, result);
  else {
    std::string wanted;
    for (int i = 0; i < method.argument_count; ++i)
      wanted += std::string(i == 0 ? "" : ", ") + method.arguments[i].name;
    cooked.fail(std::string("MarrowNative.") + method.name + " is to be called with (" + wanted + ")");
    call<void>(kPrintError, cooked.error().c_str(), method.name, __FILE__, int(__LINE__));
  }
  return write(result, method.result);
}

Bind* bind(const char* type, const char* name) {
  return call<Bind*>(kMethodBind, type, name);
}

}  // namespace

MARROW_GODOT_EXPORT void godot_gdnative_init(const InitOptions* options) {
  core = options->core;
  for (unsigned i = 0; i < core->extension_count; ++i)
    if (core->extensions[i]->type == 1) scripts = reinterpret_cast<const NativeScript*>(core->extensions[i]);
  is_class = bind("Object", "is_class");
  get_bone_count = bind("Skeleton", "get_bone_count");
  set_bone_pose = bind("Skeleton", "set_bone_pose");
}

MARROW_GODOT_EXPORT void godot_nativescript_init(void* library) {
  if (scripts == nullptr) return;
  scripts->register_tool_class(library, "MarrowNative", "Reference", {create, nullptr, nullptr},
                               {destroy, nullptr, nullptr});
  const marrow_godot::Methods methods = marrow_godot::methods();
  for (int i = 0; i < methods.count; ++i) {
    void* const data = const_cast<marrow_godot::Method*>(&methods.all[i]);
    scripts->register_method(library, "MarrowNative", methods.all[i].name, {0}, {call_from_script, data, nullptr});
  }
}

MARROW_GODOT_EXPORT void godot_gdnative_terminate(void*) {
  core = nullptr;
  scripts = nullptr;
}
