// What a driver can do, and which paths to skin by it can be trusted with: gles3.rs and Gles3.cs must say the same.
#include <stdio.h>

#include <marrow/c_gles3.h>

#include "../c/surfaceless.h"

int main(void) {
  mrw_gles3_api api;
  mrw_gles3_caps caps;
  mrw_gles3_self_test_options options;
  mrw_gles3_self_test test;
  mrw_gles3_path_need need;
  mrw_gles3_skinning_path best;
  mrw_block block;
  size_t bytes;
  void* memory;
  int i;
  if (mrw_gles3_abi() != MRW_GLES3_ABI) return 1;
  open_context();
  if (mrw_gles3_load_api(&api, load_proc, NULL) != MRW_OK || mrw_gles3_query_caps(&api, &caps) != MRW_OK) return 1;
  printf("%u %u %d\n", (unsigned)caps.uniform_block_bytes, (unsigned)caps.texture_size, caps.compute);
  mrw_gles3_self_test_options_init(&options);
  mrw_gles3_path_need_init(&need);
  bytes = mrw_block_bytes(mrw_gles3_self_test_bytes(&options));
  memory = malloc(bytes);
  if (memory == NULL || mrw_block_in(memory, bytes, &block) != MRW_OK) return 1;
  if (mrw_gles3_run_self_test(&api, &caps, &options, block.data, block.size, &test) != MRW_OK ||
      mrw_gles3_choose(&test, &need, &best) != MRW_OK)
    return 1;
  for (i = 0; i < (int)MRW_GLES3_PATH_COUNT; ++i)
    printf("%s %u %.7f\n", mrw_gles3_skinning_path_text((mrw_gles3_skinning_path)i), test.paths[i].verdict,
           (double)test.paths[i].position_error);
  printf("%s\n", mrw_gles3_skinning_path_text(best));
  free(memory);
  close_context();
  return 0;
}
