// See native_activity.h.
#pragma once
#include "looper.h"
#include "native_activity.h"

#ifdef __cplusplus
extern "C" {
#endif
typedef struct AInputEvent AInputEvent;

void AInputQueue_attachLooper(AInputQueue* queue, ALooper* looper, int identifier, ALooper_callbackFunc callback,
                              void* data);
void AInputQueue_detachLooper(AInputQueue* queue);
int32_t AInputQueue_getEvent(AInputQueue* queue, AInputEvent** event);
int32_t AInputQueue_preDispatchEvent(AInputQueue* queue, AInputEvent* event);
void AInputQueue_finishEvent(AInputQueue* queue, AInputEvent* event, int handled);
#ifdef __cplusplus
}
#endif
