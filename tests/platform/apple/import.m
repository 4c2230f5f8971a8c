// The module as Objective-C imports it, and as Swift's compiler reads it.
@import Marrow;

mrw_status in_a_module(mrw_playback* playback, mrw_gles3_api* api, mrw_gles3_load_proc load) {
  mrw_playback_init(playback);
  return mrw_abi() == MRW_ABI && mrw_gles3_abi() == MRW_GLES3_ABI ? mrw_gles3_load_api(api, load, NULL) : MRW_MISMATCH;
}
