// Marrow in Godot 4: the class MarrowNative, a RefCounted, whose methods are those of common/methods.h.
#include <algorithm>
#include <cstring>
#include <new>

#include "../common/methods.h"
#include "gdextension.h"

#ifdef _WIN32
#define MARROW_GODOT_EXPORT extern "C" __declspec(dllexport)
#else
#define MARROW_GODOT_EXPORT extern "C" __attribute__((visibility("default")))
#endif

namespace {

using namespace gdextension;
using marrow_godot::Cooked;
using marrow_godot::Kind;
using marrow_godot::kReals;
using marrow_godot::Value;

Api api;
void* library = nullptr;

// A method of a built-in class, which Godot finds by a hash of its arguments' types.
constexpr std::int64_t kHashOfResize = 848867239, kHashOfSize = 3173160232, kHashOfGetCount = 3905245786,
                       kHashOfSetVector = 1530502735, kHashOfSetRotation = 2823819782;
const void* get_bone_count = nullptr;
const void* set_position = nullptr;
const void* set_rotation = nullptr;
const void* set_scale = nullptr;
void* skeleton_tag = nullptr;

Type type_of(Kind kind) {
  switch (kind) {
    case Kind::truth:
      return kBool;
    case Kind::whole:
      return kInt;
    case Kind::real:
      return kFloat;
    case Kind::text:
      return kString;
    case Kind::bytes:
      return kPackedBytes;
    case Kind::ints:
      return kPackedInts;
    case Kind::reals:
      return kPackedFloats;
    case Kind::texts:
      return kPackedStrings;
    case Kind::object:
      return kObject;
    case Kind::nothing:
      break;
  }
  return kNil;
}

// A value of Godot's, of up to 16 bytes, which are zero for what is empty.
struct Stored {
  alignas(8) std::uint8_t inside[16] = {};
  Type type;

  explicit Stored(Type its_type) : type(its_type) {}
  Stored(const Stored&) = delete;
  Stored& operator=(const Stored&) = delete;
  ~Stored() {
    if (type >= kString && type != kObject) api.variant_get_ptr_destructor(type)(inside);
  }
  explicit Stored(const char* text) : type(kString) { api.string_new_with_utf8_chars(inside, text); }
};

// A StringName.
struct Name : Stored {
  explicit Name(const char* text) : Stored(kStringName) {
    const Stored string(text);
    const void* const from[] = {string.inside};
    api.variant_get_ptr_constructor(kStringName, 2)(inside, from);
  }
};

void call_built_in(Type type, const char* method, std::int64_t hash, void* self, const void* argument, void* result) {
  const Name name(method);
  const void* const arguments[] = {argument};
  const BuiltIn function = api.variant_get_ptr_builtin_method(type, name.inside, hash);
  if (function != nullptr) function(self, arguments, result, argument == nullptr ? 0 : 1);
}

// ---- From Godot's values, and back.

void read(const void* from, Kind kind, Value& out) {
  switch (kind) {
    case Kind::whole:
      out.whole = *static_cast<const std::int64_t*>(from);
      break;
    case Kind::real:
      out.real = *static_cast<const double*>(from);
      break;
    case Kind::object:
      out.object = *static_cast<void* const*>(from);
      break;
    case Kind::text:
      out.text.resize(std::size_t(api.string_to_utf8_chars(from, nullptr, 0)));
      api.string_to_utf8_chars(from, out.text.data(), std::int64_t(out.text.size()));
      break;
    case Kind::bytes: {
      std::int64_t size = 0;
      call_built_in(kPackedBytes, "size", kHashOfSize, const_cast<void*>(from), nullptr, &size);
      out.byte_count = std::size_t(size);
      out.bytes = size == 0 ? nullptr : api.packed_byte_array_operator_index_const(from, 0);
      break;
    }
    default:
      break;
  }
}

// Makes room in an empty array; how many elements it has then.
std::int64_t resize(Type type, void* array, std::size_t size) {
  std::int64_t wanted = std::int64_t(size), error = 0;
  if (size > 0) call_built_in(type, "resize", kHashOfResize, array, &wanted, &error);
  return error == 0 ? wanted : 0;
}

// Into a value that is empty.
void write(const Value& from, Kind kind, void* out) {
  const Type type = type_of(kind);
  if (kind == Kind::truth) *static_cast<std::uint8_t*>(out) = from.whole != 0;
  if (kind == Kind::whole) *static_cast<std::int64_t*>(out) = from.whole;
  if (kind == Kind::real) *static_cast<double*>(out) = from.real;
  if (kind == Kind::text) api.string_new_with_utf8_chars(out, from.text.c_str());
  if (kind == Kind::bytes && resize(type, out, from.byte_count) > 0)
    std::memcpy(api.packed_byte_array_operator_index(out, 0), from.bytes, from.byte_count);
  if (kind == Kind::ints && resize(type, out, from.ints.size()) > 0)
    std::copy(from.ints.begin(), from.ints.end(), api.packed_int32_array_operator_index(out, 0));
  if (kind == Kind::reals && resize(type, out, from.reals.size()) > 0)
    std::copy(from.reals.begin(), from.reals.end(), api.packed_float32_array_operator_index(out, 0));
  if (kind == Kind::texts && resize(type, out, from.texts.size()) > 0)
    for (std::size_t i = 0; i < from.texts.size(); ++i)  // what stands there is empty
      api.string_new_with_utf8_chars(api.packed_string_array_operator_index(out, std::int64_t(i)),
                                     from.texts[i].c_str());
}

// ---- Poses.

bool set_bones(void* object, const float* pose, const float*, std::size_t bone_count) {
  void* const skeleton = object == nullptr ? nullptr : api.object_cast_to(object, skeleton_tag);
  if (skeleton == nullptr || set_position == nullptr || set_rotation == nullptr || set_scale == nullptr) return false;
  std::int64_t count = 0;
  api.object_method_bind_ptrcall(get_bone_count, skeleton, nullptr, &count);
  if (count != std::int64_t(bone_count)) return false;
  for (std::int64_t bone = 0; bone < count; ++bone, pose += kReals) {
    const void* const position[] = {&bone, pose};
    const void* const rotation[] = {&bone, pose + 3};
    const void* const scale[] = {&bone, pose + 7};
    api.object_method_bind_ptrcall(set_position, skeleton, position, nullptr);
    api.object_method_bind_ptrcall(set_rotation, skeleton, rotation, nullptr);
    api.object_method_bind_ptrcall(set_scale, skeleton, scale, nullptr);
  }
  return true;
}

constexpr marrow_godot::Engine kEngine{set_bones};

// ---- The class.

constexpr const char kClassName[] = "MarrowNative";

void* create(void*) {
  Cooked* const cooked = new (std::nothrow) Cooked;
  if (cooked == nullptr) return nullptr;
  void* const object = api.classdb_construct_object(Name("RefCounted").inside);
  api.object_set_instance(object, Name(kClassName).inside, cooked);
  return object;
}

void destroy(void*, void* instance) {
  delete static_cast<Cooked*>(instance);
}

void call_by_pointers(void* userdata, void* instance, const void* const* from, void* out) {
  const auto& method = *static_cast<const marrow_godot::Method*>(userdata);
  Value arguments[marrow_godot::kMostArguments], result;
  for (int i = 0; i < method.argument_count; ++i) read(from[i], method.arguments[i].kind, arguments[i]);
  method.call(*static_cast<Cooked*>(instance), kEngine, arguments, result);
  const Type type = type_of(method.result);
  if (type >= kString) {  // what stands there is a value of Godot's: make it empty
    api.variant_get_ptr_destructor(type)(out);
    std::memset(out, 0, type == kString ? sizeof(void*) : 2 * sizeof(void*));
  }
  write(result, method.result, out);
}

// Whether a variant is of the kind; an int will do for a real.
bool fits(int type, Kind kind) {
  return type == type_of(kind) || (kind == Kind::real && type == kInt) || (kind == Kind::object && type == kNil);
}

// An argument of a call by variants, as long as the value points into it.
bool read_variant(const void* from, Kind kind, std::unique_ptr<Stored>& held, Value& out) {
  const int type = api.variant_get_type(from);
  if (!fits(type, kind)) return false;
  if (type == kNil) return true;
  held = std::make_unique<Stored>(Type(type));
  api.get_variant_to_type_constructor(type)(held->inside, const_cast<void*>(from));
  const bool is_int = kind == Kind::real && type == kInt;
  read(held->inside, is_int ? Kind::whole : kind, out);
  if (is_int) out.real = double(out.whole);
  return true;
}

void call_by_variants(void* userdata, void* instance, const void* const* from, std::int64_t count, void* out,
                      CallError* error) {
  const auto& method = *static_cast<const marrow_godot::Method*>(userdata);
  if (count != method.argument_count) {
    *error = {count < method.argument_count ? kTooFew : kTooMany, method.argument_count, method.argument_count};
    return;
  }
  Value arguments[marrow_godot::kMostArguments], result;
  std::unique_ptr<Stored> held[marrow_godot::kMostArguments];
  for (std::int32_t i = 0; i < count; ++i) {
    if (read_variant(from[i], method.arguments[i].kind, held[i], arguments[i])) continue;
    *error = {kInvalidArgument, i, type_of(method.arguments[i].kind)};
    return;
  }
  method.call(*static_cast<Cooked*>(instance), kEngine, arguments, result);
  Stored value(type_of(method.result));
  write(result, method.result, value.inside);
  api.get_variant_from_type_constructor(value.type)(out, value.inside);
}

void register_method(const Name& type, const marrow_godot::Method& method) {
  const Name name(method.name), none("");
  const Stored hint("");
  const auto property = [&](Kind kind, const Name& its_name) {
    return Property{type_of(kind),
                    const_cast<std::uint8_t*>(its_name.inside),
                    const_cast<std::uint8_t*>(none.inside),
                    0,
                    const_cast<std::uint8_t*>(hint.inside),
                    6};
  };
  Property result = property(method.result, none), arguments[marrow_godot::kMostArguments];
  std::vector<std::unique_ptr<Name>> names;
  int metadata[marrow_godot::kMostArguments] = {};
  for (int i = 0; i < method.argument_count; ++i) {
    names.push_back(std::make_unique<Name>(method.arguments[i].name));
    arguments[i] = property(method.arguments[i].kind, *names.back());
  }
  ClassMethod info{};
  info.name = const_cast<std::uint8_t*>(name.inside);
  info.userdata = const_cast<marrow_godot::Method*>(&method);
  info.call = call_by_variants;
  info.pointer_call = call_by_pointers;
  info.flags = 1;
  info.has_result = 1;
  info.result = &result;
  info.argument_count = std::uint32_t(method.argument_count);
  info.arguments = arguments;
  info.argument_metadata = metadata;
  api.classdb_register_extension_class_method(library, type.inside, &info);
}

const void* bind(const Name& type, const char* method, std::int64_t hash) {
  const void* const found = api.classdb_get_method_bind(type.inside, Name(method).inside, hash);
  if (found == nullptr)
    api.print_error((std::string("marrow: this Godot has another Skeleton3D.") + method +
                     ": characters will not move; take a release of Marrow for it")
                        .c_str(),
                    "bind", __FILE__, __LINE__, 1);
  return found;
}

void initialize(void*, int level) {
  if (level != 2) return;
  const Name skeleton("Skeleton3D"), type(kClassName), parent("RefCounted"), error("error"), getter("get_error");
  skeleton_tag = api.classdb_get_class_tag(skeleton.inside);
  get_bone_count = bind(skeleton, "get_bone_count", kHashOfGetCount);
  set_position = bind(skeleton, "set_bone_pose_position", kHashOfSetVector);
  set_rotation = bind(skeleton, "set_bone_pose_rotation", kHashOfSetRotation);
  set_scale = bind(skeleton, "set_bone_pose_scale", kHashOfSetVector);
  Class info{};
  info.create = create;
  info.free = destroy;
  api.classdb_register_extension_class(library, type.inside, parent.inside, &info);
  const marrow_godot::Methods methods = marrow_godot::methods();
  for (int i = 0; i < methods.count; ++i) register_method(type, methods.all[i]);
  const Name none("");
  const Stored hint("");
  const Property property{kString, const_cast<std::uint8_t*>(error.inside), const_cast<std::uint8_t*>(none.inside),
                          0,       const_cast<std::uint8_t*>(hint.inside),  4};
  api.classdb_register_extension_class_property(library, type.inside, &property, none.inside, getter.inside);
}

void deinitialize(void*, int level) {
  if (level == 2) api.classdb_unregister_extension_class(library, Name(kClassName).inside);
}

template <typename Pointer>
bool find(GetFunction get, const char* name, Pointer& out) {
  out = reinterpret_cast<Pointer>(get(name));
  return out != nullptr;
}

}  // namespace

// False: this Godot lacks a function.
MARROW_GODOT_EXPORT std::uint8_t marrow_godot_init(GetFunction get, void* its_library, Initialization* out) {
  library = its_library;
#define MARROW_FIND(name) find(get, #name, api.name)
  const bool all =
      MARROW_FIND(variant_get_type) && MARROW_FIND(get_variant_from_type_constructor) &&
      MARROW_FIND(get_variant_to_type_constructor) && MARROW_FIND(variant_get_ptr_constructor) &&
      MARROW_FIND(variant_get_ptr_destructor) && MARROW_FIND(variant_get_ptr_builtin_method) &&
      MARROW_FIND(string_new_with_utf8_chars) && MARROW_FIND(string_to_utf8_chars) &&
      MARROW_FIND(packed_byte_array_operator_index_const) && MARROW_FIND(packed_byte_array_operator_index) &&
      MARROW_FIND(packed_int32_array_operator_index) && MARROW_FIND(packed_float32_array_operator_index) &&
      MARROW_FIND(packed_string_array_operator_index) && MARROW_FIND(classdb_get_class_tag) &&
      MARROW_FIND(classdb_get_method_bind) && MARROW_FIND(classdb_construct_object) &&
      MARROW_FIND(classdb_register_extension_class) && MARROW_FIND(classdb_register_extension_class_method) &&
      MARROW_FIND(classdb_register_extension_class_property) && MARROW_FIND(classdb_unregister_extension_class) &&
      MARROW_FIND(object_set_instance) && MARROW_FIND(object_cast_to) && MARROW_FIND(object_method_bind_ptrcall) &&
      MARROW_FIND(print_error);
#undef MARROW_FIND
  *out = {2, nullptr, initialize, deinitialize};
  return all ? 1 : 0;
}
