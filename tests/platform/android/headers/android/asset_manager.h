// See native_activity.h.
#pragma once
#include "native_activity.h"

#ifdef __cplusplus
extern "C" {
#endif
typedef struct AAsset AAsset;
enum { AASSET_MODE_BUFFER = 3 };

AAsset* AAssetManager_open(AAssetManager* manager, const char* name, int mode);
const void* AAsset_getBuffer(AAsset* asset);
long AAsset_getLength(AAsset* asset);
int AAsset_isAllocated(AAsset* asset);
void AAsset_close(AAsset* asset);
#ifdef __cplusplus
}
#endif
