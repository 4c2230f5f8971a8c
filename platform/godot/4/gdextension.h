// What of Godot 4's C interface, as it is since 4.1, is used here, declared by hand. Functions are asked for by name.
#pragma once
#include <cstddef>
#include <cstdint>

namespace gdextension {

// Types of a Variant.
enum Type : int {
  kNil = 0,
  kBool = 1,
  kInt = 2,
  kFloat = 3,
  kString = 4,
  kStringName = 21,
  kObject = 24,
  kPackedBytes = 29,
  kPackedInts = 30,
  kPackedFloats = 32,
  kPackedStrings = 34,
};

using Function = void (*)();
using GetFunction = Function (*)(const char* name);

struct Initialization {
  int minimum_level;  // 2: scene
  void* userdata;
  void (*initialize)(void* userdata, int level);
  void (*deinitialize)(void* userdata, int level);
};

struct Property {  // NOLINT(clang-analyzer-optin.performance.Padding): the order is Godot's
  Type type;
  void* name;        // StringName
  void* class_name;  // StringName
  std::uint32_t hint;
  void* hint_string;    // String
  std::uint32_t usage;  // 2: stored, 4: in the editor
};

struct CallError {
  int error;
  std::int32_t argument;
  std::int32_t expected;
};
enum : int { kInvalidArgument = 2, kTooMany = 3, kTooFew = 4 };

// Of 4.1; what later releases added is in structs of other names.
struct Class {
  std::uint8_t is_virtual, is_abstract;
  Function set, get, get_property_list, free_property_list, property_can_revert, property_get_revert;
  Function notification, to_string, reference, unreference;
  void* (*create)(void* userdata);
  void (*free)(void* userdata, void* instance);
  Function get_virtual, get_rid;
  void* userdata;
};

struct ClassMethod {
  void* name;  // StringName
  void* userdata;
  void (*call)(void* userdata, void* instance, const void* const* variants, std::int64_t count, void* result,
               CallError* error);
  void (*pointer_call)(void* userdata, void* instance, const void* const* values, void* result);
  std::uint32_t flags;  // 1: an ordinary method
  std::uint8_t has_result;
  Property* result;
  int result_metadata;
  std::uint32_t argument_count;
  Property* arguments;
  int* argument_metadata;
  std::uint32_t default_count;
  void** defaults;
};

using Constructor = void (*)(void* to, const void* const* arguments);
using Destructor = void (*)(void* value);
using BuiltIn = void (*)(void* self, const void* const* arguments, void* result, int count);
using FromValue = void (*)(void* variant, void* value);
using ToValue = void (*)(void* value, void* variant);

// The functions, by the names that Godot has for them.
struct Api {
  int (*variant_get_type)(const void* variant);
  FromValue (*get_variant_from_type_constructor)(int type);
  ToValue (*get_variant_to_type_constructor)(int type);
  Constructor (*variant_get_ptr_constructor)(int type, std::int32_t index);
  Destructor (*variant_get_ptr_destructor)(int type);
  BuiltIn (*variant_get_ptr_builtin_method)(int type, const void* name, std::int64_t hash);
  void (*string_new_with_utf8_chars)(void* to, const char* text);
  std::int64_t (*string_to_utf8_chars)(const void* string, char* to, std::int64_t most);
  const std::uint8_t* (*packed_byte_array_operator_index_const)(const void* array, std::int64_t index);
  std::uint8_t* (*packed_byte_array_operator_index)(void* array, std::int64_t index);
  std::int32_t* (*packed_int32_array_operator_index)(void* array, std::int64_t index);
  float* (*packed_float32_array_operator_index)(void* array, std::int64_t index);
  void* (*packed_string_array_operator_index)(void* array, std::int64_t index);
  void* (*classdb_get_class_tag)(const void* name);
  const void* (*classdb_get_method_bind)(const void* type, const void* method, std::int64_t hash);
  void* (*classdb_construct_object)(const void* name);
  void (*classdb_register_extension_class)(void* library, const void* name, const void* parent, const Class* type);
  void (*classdb_register_extension_class_method)(void* library, const void* type, const ClassMethod* method);
  void (*classdb_register_extension_class_property)(void* library, const void* type, const Property* property,
                                                    const void* setter, const void* getter);
  void (*classdb_unregister_extension_class)(void* library, const void* name);
  void (*object_set_instance)(void* object, const void* type, void* instance);
  void* (*object_cast_to)(const void* object, void* tag);
  void (*object_method_bind_ptrcall)(const void* method, void* object, const void* const* arguments, void* result);
  void (*print_error)(const char* text, const char* function, const char* file, std::int32_t line,
                      std::uint8_t in_editor);
};

}  // namespace gdextension
