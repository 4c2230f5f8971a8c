// Lines for `adb logcat -s marrow`.
#pragma once

#include <android/log.h>

#define LOG_INFO(...) __android_log_print(ANDROID_LOG_INFO, "marrow", __VA_ARGS__)
#define LOG_WARN(...) __android_log_print(ANDROID_LOG_WARN, "marrow", __VA_ARGS__)
#define LOG_ERROR(...) __android_log_print(ANDROID_LOG_ERROR, "marrow", __VA_ARGS__)
