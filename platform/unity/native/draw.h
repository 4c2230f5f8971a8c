/* Draws meshes by marrow's skinners in the context that is current. All but open_drawn and free_drawn belong to the
 * render thread. */
#ifndef MARROW_UNITY_DRAW_H
#define MARROW_UNITY_DRAW_H

#include <marrow/c_gles3.h>

typedef struct drawn_mesh {
  mrw_mesh mesh;
  void* memory; /* as it was allocated */
  mrw_block block;
  mrw_gles3_skinner skinner;
  bool made; /* the skinner is one, in this context or in one that is gone */
} drawn_mesh;

bool open_drawn(drawn_mesh* out, const mrw_mesh* mesh);
void free_drawn(drawn_mesh* drawn);

/* Makes what the mesh needs in this context, if it is not there. */
mrw_status begin_drawn(drawn_mesh* drawn);
mrw_status pose_drawn(drawn_mesh* drawn, const mrw_affine* joints, size_t joint_count, const float* weights,
                      size_t weight_count);
mrw_status draw(drawn_mesh* drawn, const float* clip_from_model);
void delete_drawn(drawn_mesh* drawn);

/* The context is gone, with all that was in it: calls no GL. */
void forget_context(void);
void forget_drawn_context(drawn_mesh* drawn);

const char* compile_log(void);

#endif
