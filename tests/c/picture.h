// A small picture to draw in, in the context that is current.
#pragma once

#include <stdio.h>

#include <GLES3/gl3.h>

#include "surfaceless.h"

enum { kSide = 128 };

#define PICTURE_FUNCTIONS(X)                             \
  X(PFNGLGENTEXTURESPROC, GenTextures)                   \
  X(PFNGLBINDTEXTUREPROC, BindTexture)                   \
  X(PFNGLTEXIMAGE2DPROC, TexImage2D)                     \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)           \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)           \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D) \
  X(PFNGLVIEWPORTPROC, Viewport)                         \
  X(PFNGLCLEARPROC, Clear)                               \
  X(PFNGLREADPIXELSPROC, ReadPixels)                     \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                     \
  X(PFNGLGETERRORPROC, GetError)

static struct {
#define MEMBER(Type, Name) Type Name;
  PICTURE_FUNCTIONS(MEMBER)
#undef MEMBER
} gl;
static GLuint framebuffer = 0;

static void make_picture(void) {
  GLuint texture = 0;
  void* function;
#define LOAD(Type, Name)            \
  function = load_proc("gl" #Name); \
  if (function == NULL) exit(1);    \
  memcpy(&gl.Name, &function, sizeof gl.Name);
  PICTURE_FUNCTIONS(LOAD)
#undef LOAD
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

static void begin_picture(void) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, kSide, kSide);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

static int covered = 0;  // pixels of the last picture that something was drawn on

// A hash of the picture.
static unsigned end_picture(void) {
  static unsigned char rgba[4 * kSide * kSide];
  unsigned hash = 2166136261u;
  size_t i;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  covered = 0;
  for (i = 0; i < sizeof rgba; ++i) hash = (hash ^ rgba[i]) * 16777619u;
  for (i = 3; i < sizeof rgba; i += 4) covered += rgba[i] != 0;
  if (gl.GetError() != GL_NO_ERROR) exit((fprintf(stderr, "GL tells of an error\n"), 1));
  return hash;
}
