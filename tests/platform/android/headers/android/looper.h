// See native_activity.h.
#pragma once

#ifdef __cplusplus
extern "C" {
#endif
typedef struct ALooper ALooper;
typedef int (*ALooper_callbackFunc)(int file, int events, void* data);
enum { ALOOPER_POLL_CALLBACK = -2, ALOOPER_EVENT_INPUT = 1 };

ALooper* ALooper_forThread(void);
int ALooper_addFd(ALooper* looper, int file, int identifier, int events, ALooper_callbackFunc callback, void* data);
int ALooper_removeFd(ALooper* looper, int file);
#ifdef __cplusplus
}
#endif
