// Holds platform/godot/3/gdnative.h against Godot's own headers, of 3.1 or later. Compiles, or not.
#include <gdnative_api_struct.gen.h>

#include "../../../../platform/godot/3/gdnative.h"

#define PLACE(ours, name)                                                                            \
  static_assert(offsetof(gdnative::Core, functions) + gdnative::ours * sizeof(gdnative::Function) == \
                    offsetof(godot_gdnative_core_api_struct, godot_##name),                          \
                #name)
PLACE(kPoolBytesNew, pool_byte_array_new);
PLACE(kPoolBytesResize, pool_byte_array_resize);
PLACE(kPoolBytesWrite, pool_byte_array_write);
PLACE(kPoolBytesRead, pool_byte_array_read);
PLACE(kPoolBytesSize, pool_byte_array_size);
PLACE(kPoolBytesDestroy, pool_byte_array_destroy);
PLACE(kPoolIntsNew, pool_int_array_new);
PLACE(kPoolIntsResize, pool_int_array_resize);
PLACE(kPoolIntsWrite, pool_int_array_write);
PLACE(kPoolIntsDestroy, pool_int_array_destroy);
PLACE(kPoolRealsNew, pool_real_array_new);
PLACE(kPoolRealsResize, pool_real_array_resize);
PLACE(kPoolRealsWrite, pool_real_array_write);
PLACE(kPoolRealsDestroy, pool_real_array_destroy);
PLACE(kPoolTextsNew, pool_string_array_new);
PLACE(kPoolTextsAppend, pool_string_array_append);
PLACE(kPoolTextsDestroy, pool_string_array_destroy);
PLACE(kPoolBytesReadPointer, pool_byte_array_read_access_ptr);
PLACE(kPoolBytesReadDestroy, pool_byte_array_read_access_destroy);
PLACE(kPoolBytesWritePointer, pool_byte_array_write_access_ptr);
PLACE(kPoolBytesWriteDestroy, pool_byte_array_write_access_destroy);
PLACE(kPoolIntsWritePointer, pool_int_array_write_access_ptr);
PLACE(kPoolIntsWriteDestroy, pool_int_array_write_access_destroy);
PLACE(kPoolRealsWritePointer, pool_real_array_write_access_ptr);
PLACE(kPoolRealsWriteDestroy, pool_real_array_write_access_destroy);
PLACE(kVariantType, variant_get_type);
PLACE(kVariantNewNil, variant_new_nil);
PLACE(kVariantNewBool, variant_new_bool);
PLACE(kVariantNewInt, variant_new_int);
PLACE(kVariantNewReal, variant_new_real);
PLACE(kVariantNewText, variant_new_string);
PLACE(kVariantNewBytes, variant_new_pool_byte_array);
PLACE(kVariantNewInts, variant_new_pool_int_array);
PLACE(kVariantNewReals, variant_new_pool_real_array);
PLACE(kVariantNewTexts, variant_new_pool_string_array);
PLACE(kVariantAsInt, variant_as_int);
PLACE(kVariantAsReal, variant_as_real);
PLACE(kVariantAsText, variant_as_string);
PLACE(kVariantAsObject, variant_as_object);
PLACE(kVariantAsBytes, variant_as_pool_byte_array);
PLACE(kCharactersData, char_string_get_data);
PLACE(kCharactersDestroy, char_string_destroy);
PLACE(kTextUtf8, string_utf8);
PLACE(kTextFromUtf8, string_chars_to_utf8);
PLACE(kTextDestroy, string_destroy);
PLACE(kMethodBind, method_bind_get_method);
PLACE(kMethodCall, method_bind_ptrcall);
PLACE(kPrintError, print_error);
static_assert(sizeof(gdnative::Core) == sizeof(godot_gdnative_core_api_struct));

#define FIELD(ours, field, theirs, its) \
  static_assert(offsetof(gdnative::ours, field) == offsetof(theirs, its), #ours "::" #field)
FIELD(Core, type, godot_gdnative_core_api_struct, type);
FIELD(Core, extension_count, godot_gdnative_core_api_struct, num_extensions);
FIELD(Core, extensions, godot_gdnative_core_api_struct, extensions);
FIELD(InitOptions, core, godot_gdnative_init_options, api_struct);
FIELD(InitOptions, library, godot_gdnative_init_options, gd_native_library);
FIELD(NativeScript, register_tool_class, godot_gdnative_ext_nativescript_api_struct,
      godot_nativescript_register_tool_class);
FIELD(NativeScript, register_method, godot_gdnative_ext_nativescript_api_struct, godot_nativescript_register_method);
FIELD(Method, call, godot_instance_method, method);
FIELD(Method, data, godot_instance_method, method_data);
FIELD(Create, call, godot_instance_create_func, create_func);
FIELD(Destroy, call, godot_instance_destroy_func, destroy_func);

#define SIZE(ours, theirs) static_assert(sizeof(gdnative::ours) == sizeof(theirs), #ours)
SIZE(Variant, godot_variant);
SIZE(Text, godot_string);
SIZE(Characters, godot_char_string);
SIZE(Pool, godot_pool_real_array);
SIZE(Method, godot_instance_method);
SIZE(Create, godot_instance_create_func);
SIZE(Destroy, godot_instance_destroy_func);
SIZE(Attributes, godot_method_attributes);
static_assert(sizeof(godot_transform) == 12 * sizeof(float) && sizeof(godot_bool) == 1 && sizeof(godot_int) == 4);

#define VALUE(ours, theirs) static_assert(int(gdnative::ours) == int(GODOT_VARIANT_TYPE_##theirs), #ours)
VALUE(kNil, NIL);
VALUE(kBool, BOOL);
VALUE(kInt, INT);
VALUE(kReal, REAL);
VALUE(kString, STRING);
VALUE(kObject, OBJECT);
VALUE(kPoolBytes, POOL_BYTE_ARRAY);
static_assert(int(GDNATIVE_EXT_NATIVESCRIPT) == 1 && int(GODOT_METHOD_RPC_MODE_DISABLED) == 0);
