/* Draws Marrow's characters on Unity's render thread, where its graphics device is OpenGL ES 3.
 *
 *   once a mesh       marrow_unity_open
 *   every frame       marrow_unity_pose; for each camera id = marrow_unity_request, GL.IssuePluginEvent(event, id)
 *   at the end        marrow_unity_close, and GL.IssuePluginEvent(event, 0)
 *
 * Contexts come and go by Unity's device events: what was open is built anew in the next one, in its last pose. All may
 * be called by the main thread; GL is called by the render event alone. */
#ifndef MARROW_UNITY_H
#define MARROW_UNITY_H

#include <marrow/c_gles3.h>

#include "unity.h"

/* What Unity calls by itself when it loads and drops the library. */
UNITY_EXPORT void UNITY_API UnityPluginLoad(const unity_interfaces* interfaces);
UNITY_EXPORT void UNITY_API UnityPluginUnload(void);

/* The ABI of the header that this was compiled with. */
UNITY_EXPORT uint32_t marrow_unity_abi(void);

/* Why nothing can be drawn, and what to do; empty if it can. */
UNITY_EXPORT const char* marrow_unity_unavailable(void);

/* For GL.IssuePluginEvent and CommandBuffer.IssuePluginEvent. */
UNITY_EXPORT unity_render_event marrow_unity_render_event(void);

/* A handle from 1 on; 0: no mesh, no memory, or 256 are open. What `mesh` points to lives until marrow_unity_close. */
UNITY_EXPORT int32_t marrow_unity_open(const mrw_mesh* mesh);

/* Copies a pose, as mrw_gles3_pose() takes it. Errors: bad_argument. */
UNITY_EXPORT mrw_status marrow_unity_pose(int32_t handle, const mrw_affine* model_from_joint, size_t joint_count,
                                          const float* weights, size_t weight_count);

/* The id of an event that draws the mesh, good for the next 1023 requests; 0 if the handle is wrong.
 * clip_from_model: 16 floats, column after column, from glTF's axes to OpenGL's clip space. */
UNITY_EXPORT int32_t marrow_unity_request(int32_t handle, const float* clip_from_model);

/* What came of the last event that drew it; gl_error before the first one. */
UNITY_EXPORT mrw_status marrow_unity_status(int32_t handle);

/* What the driver said of the last text that did not compile. */
UNITY_EXPORT const char* marrow_unity_log(void);

/* Waits for a running event, so memory may go afterwards. Objects of GL go at the next event, whatever its id. */
UNITY_EXPORT void marrow_unity_close(int32_t handle);

#endif
