// OpenGL ES 3.0 for WebAssembly, by a context of WebGL 2: what gl_imports.h declares. See docs/platforms/web.md.

// Those whose arguments are the same numbers in WebGL.
const kSame = [
  'activeTexture', 'beginTransformFeedback', 'blendFunc', 'blendFuncSeparate', 'blitFramebuffer',
  'checkFramebufferStatus', 'clear', 'colorMask', 'depthMask', 'disable', 'drawArrays', 'drawElements',
  'drawElementsInstanced', 'enable', 'enableVertexAttribArray', 'endTransformFeedback', 'finish', 'frontFace',
  'generateMipmap', 'getError', 'pixelStorei', 'polygonOffset', 'renderbufferStorageMultisample', 'scissor',
  'texParameteri', 'texStorage2D', 'vertexAttribIPointer', 'vertexAttribPointer', 'viewport',
];
// Made and deleted several at a time, as names in memory.
const kMadeInLists = ['Buffer', 'Framebuffer', 'Renderbuffer', 'Sampler', 'Texture', 'VertexArray'];
// Numbers of a uniform's element, and which array they are of.
const kUniforms = { '1fv': [1, 'f32'], '2fv': [2, 'f32'], '3fv': [3, 'f32'], '4fv': [4, 'f32'], '1iv': [1, 'i32'] };
const kMatrices = { Matrix3fv: 9, Matrix4fv: 16 };
// Asked of OpenGL ES, not of WebGL.
const GL_MAJOR_VERSION = 0x821b, GL_MINOR_VERSION = 0x821c, GL_INFO_LOG_LENGTH = 0x8b84, GL_NUM_SAMPLE_COUNTS = 0x9380;
const GL_VENDOR = 0x1f00, GL_RENDERER = 0x1f01, GL_VERSION = 0x1f02;
const kPage = 65536;  // bytes of WebAssembly's memory

// Numbers for WebGL's objects, as OpenGL ES has them; 0 is none.
class Names {
  objects = new Map();
  names = new Map();
  last = 0;
  constructor(gl) { this.gl = gl; }
  // kind: "Buffer". object: null if the context is lost, which has a name as any.
  make(kind, object) {
    this.objects.set(++this.last, { kind, object });
    if (object) this.names.set(object, this.last);
    return this.last;
  }
  of(name) { return this.objects.get(name)?.object ?? null; }
  nameOf(object) { return this.names.get(object) ?? 0; }
  drop(name) {
    const { kind, object } = this.objects.get(name) ?? {};
    if (kind) this.gl[`delete${kind}`](object);
    this.names.delete(object);
    this.objects.delete(name);
  }
  clear() { for (const name of [...this.objects.keys()]) this.drop(name); }
}

// Arrays over all of the memory; others whenever it has grown.
class Heap {
  constructor(exports) { this.exports = exports; }
  get now() {
    const { buffer } = this.exports().memory;
    if (this.seen !== buffer) {
      this.seen = buffer;
      this.arrays = {
        i8: new Int8Array(buffer), i16: new Int16Array(buffer), i32: new Int32Array(buffer),
        u8: new Uint8Array(buffer), u16: new Uint16Array(buffer), u32: new Uint32Array(buffer),
        f32: new Float32Array(buffer),
      };
    }
    return this.arrays;
  }
  // `bytes` not given: until a zero.
  text(ptr, bytes) {
    const { u8 } = this.now, begin = ptr >>> 0;
    return new TextDecoder().decode(u8.slice(begin, bytes >= 0 ? begin + bytes : u8.indexOf(0, begin)));
  }
  // At most `size` bytes with the zero that ends it. Gives the bytes without.
  putText(text, ptr, size) {
    if (size <= 0) return 0;
    const bytes = new TextEncoder().encode(text).subarray(0, size - 1);
    this.now.u8.set(bytes, ptr >>> 0);
    this.now.u8[(ptr >>> 0) + bytes.length] = 0;
    return bytes.length;
  }
  texts(ptr, count, lengths = 0) {
    return Array.from({ length: count }, (_, i) =>
      this.text(this.now.u32[(ptr >>> 2) + i], lengths ? this.now.i32[(lengths >>> 2) + i] : -1));
  }
}

// Functions that make, bind and delete objects.
function ofObjects(gl, names, heap) {
  const out = {};
  for (const kind of kMadeInLists) {
    out[`Gen${kind}s`] = (count, ptr) => {
      for (let i = 0; i < count; ++i) heap.now.u32[(ptr >>> 2) + i] = names.make(kind, gl[`create${kind}`]());
    };
    out[`Delete${kind}s`] = (count, ptr) => {
      for (let i = 0; i < count; ++i) names.drop(heap.now.u32[(ptr >>> 2) + i]);
    };
  }
  return Object.assign(out, {
    CreateShader: (type) => names.make('Shader', gl.createShader(type)),
    CreateProgram: () => names.make('Program', gl.createProgram()),
    DeleteShader: (name) => names.drop(name),
    BindBuffer: (target, name) => gl.bindBuffer(target, names.of(name)),
    BindBufferBase: (target, index, name) => gl.bindBufferBase(target, index, names.of(name)),
    BindBufferRange: (target, index, name, offset, size) =>
      gl.bindBufferRange(target, index, names.of(name), offset, size),
    BindFramebuffer: (target, name) => gl.bindFramebuffer(target, names.of(name)),
    BindRenderbuffer: (target, name) => gl.bindRenderbuffer(target, names.of(name)),
    BindSampler: (unit, name) => gl.bindSampler(unit, names.of(name)),
    BindTexture: (target, name) => gl.bindTexture(target, names.of(name)),
    BindVertexArray: (name) => gl.bindVertexArray(names.of(name)),
    FramebufferRenderbuffer: (target, attachment, kind, name) =>
      gl.framebufferRenderbuffer(target, attachment, kind, names.of(name)),
    FramebufferTexture2D: (target, attachment, kind, name, level) =>
      gl.framebufferTexture2D(target, attachment, kind, names.of(name), level),
    SamplerParameteri: (name, what, value) => gl.samplerParameteri(names.of(name), what, value),
  });
}

// Functions that move bytes between memory and the context.
function ofData(gl, heap) {
  const kArrays = {  // that WebGL wants with a type of pixels; 'u32' with those that pack several into 32 bits
    [gl.BYTE]: 'i8', [gl.UNSIGNED_BYTE]: 'u8', [gl.SHORT]: 'i16', [gl.UNSIGNED_SHORT]: 'u16', [gl.HALF_FLOAT]: 'u16',
    [gl.UNSIGNED_SHORT_5_6_5]: 'u16', [gl.UNSIGNED_SHORT_4_4_4_4]: 'u16', [gl.UNSIGNED_SHORT_5_5_5_1]: 'u16',
    [gl.INT]: 'i32', [gl.FLOAT]: 'f32',
  };
  // What stands for the pointer of pixels: an offset if a buffer is bound, or an array and where in it.
  const pixels = (binding, type, ptr) => {
    if (gl.getParameter(binding)) return [ptr];
    if (ptr === 0) return [null];
    const array = heap.now[kArrays[type] ?? 'u32'];
    return [array, (ptr >>> 0) / array.BYTES_PER_ELEMENT];
  };
  return {
    BufferData: (target, size, ptr, usage) =>
      ptr === 0 ? gl.bufferData(target, size, usage) : gl.bufferData(target, heap.now.u8, usage, ptr >>> 0, size),
    // A size of 0 is all of the array, to WebGL.
    BufferSubData: (target, offset, size, ptr) =>
      size !== 0 && gl.bufferSubData(target, offset, heap.now.u8, ptr >>> 0, size),
    TexImage2D: (target, level, internal, width, height, border, format, type, ptr) =>
      gl.texImage2D(target, level, internal, width, height, border, format, type,
        ...pixels(gl.PIXEL_UNPACK_BUFFER_BINDING, type, ptr)),
    TexSubImage2D: (target, level, x, y, width, height, format, type, ptr) =>
      gl.texSubImage2D(target, level, x, y, width, height, format, type,
        ...pixels(gl.PIXEL_UNPACK_BUFFER_BINDING, type, ptr)),
    ReadPixels: (x, y, width, height, format, type, ptr) =>
      gl.readPixels(x, y, width, height, format, type, ...pixels(gl.PIXEL_PACK_BUFFER_BINDING, type, ptr)),
    ClearBufferuiv: (buffer, index, ptr) => gl.clearBufferuiv(buffer, index, heap.now.u32, ptr >>> 2),
    ClearDepthf: (depth) => gl.clearDepth(depth),
    DrawBuffers: (count, ptr) => gl.drawBuffers(Array.from(heap.now.u32.subarray(ptr >>> 2, (ptr >>> 2) + count))),
  };
}

// Functions of shaders, programs and uniforms.
function ofPrograms(gl, names, heap) {
  // Uniforms have numbers of their own in each program, so that it does not matter who has called useProgram().
  const numbers = new Map(), locations = new Map();  // by a program's name, of each text; by number
  let last = -1;
  const uniform = (number) => locations.get(number) ?? null;
  function forget(name) {
    for (const number of numbers.get(name)?.values() ?? []) locations.delete(number);
    numbers.delete(name);
  }
  function numberOf(name, text) {
    if (!numbers.has(name)) numbers.set(name, new Map());
    const known = numbers.get(name);
    if (!known.has(text)) {
      const location = gl.getUniformLocation(names.of(name), text);
      if (location) locations.set(++last, location);
      known.set(text, location ? last : -1);
    }
    return known.get(text);
  }
  const log = (text, size, length, ptr) => {
    const bytes = heap.putText(text ?? '', ptr, size);
    if (length !== 0) heap.now.i32[length >>> 2] = bytes;
  };
  const state = (value, ptr) => { heap.now.i32[ptr >>> 2] = Number(value ?? 0); };
  // With the zero that ends it.
  const logLength = (text) => (text ? new TextEncoder().encode(text).length + 1 : 0);
  const out = {
    AttachShader: (program, shader) => gl.attachShader(names.of(program), names.of(shader)),
    ShaderSource: (shader, count, ptr, lengths) =>
      gl.shaderSource(names.of(shader), heap.texts(ptr, count, lengths).join('')),
    CompileShader: (name) => gl.compileShader(names.of(name)),
    GetShaderiv: (name, what, ptr) => state(what === GL_INFO_LOG_LENGTH
      ? logLength(gl.getShaderInfoLog(names.of(name))) : gl.getShaderParameter(names.of(name), what), ptr),
    GetShaderInfoLog: (name, size, length, ptr) => log(gl.getShaderInfoLog(names.of(name)), size, length, ptr),
    TransformFeedbackVaryings: (program, count, ptr, mode) =>
      gl.transformFeedbackVaryings(names.of(program), heap.texts(ptr, count), mode),
    LinkProgram: (name) => {
      forget(name);
      gl.linkProgram(names.of(name));
    },
    DeleteProgram: (name) => {
      forget(name);
      names.drop(name);
    },
    GetProgramiv: (name, what, ptr) => state(what === GL_INFO_LOG_LENGTH
      ? logLength(gl.getProgramInfoLog(names.of(name))) : gl.getProgramParameter(names.of(name), what), ptr),
    GetProgramInfoLog: (name, size, length, ptr) => log(gl.getProgramInfoLog(names.of(name)), size, length, ptr),
    UseProgram: (name) => gl.useProgram(names.of(name)),
    GetUniformLocation: (name, ptr) => (names.of(name) ? numberOf(name, heap.text(ptr)) : -1),
    GetUniformBlockIndex: (name, ptr) => gl.getUniformBlockIndex(names.of(name), heap.text(ptr)),
    UniformBlockBinding: (name, index, binding) => gl.uniformBlockBinding(names.of(name), index, binding),
    Uniform1i: (location, x) => gl.uniform1i(uniform(location), x),
    Uniform2i: (location, x, y) => gl.uniform2i(uniform(location), x, y),
    Uniform1f: (location, x) => gl.uniform1f(uniform(location), x),
    Uniform4f: (location, x, y, z, w) => gl.uniform4f(uniform(location), x, y, z, w),
  };
  for (const [kind, [width, array]] of Object.entries(kUniforms))
    out[`Uniform${kind}`] = (location, count, ptr) =>
      gl[`uniform${kind}`](uniform(location), heap.now[array], ptr >>> 2, width * count);
  for (const [kind, numbers] of Object.entries(kMatrices))
    out[`Uniform${kind}`] = (location, count, transpose, ptr) =>
      gl[`uniform${kind}`](uniform(location), transpose, heap.now.f32, ptr >>> 2, numbers * count);
  return out;
}

// What the context is and what state it is in.
function ofState(gl, names, heap) {
  const texts = new Map();
  let free = 0, end = 0;
  // Texts stay where they are: in pages of memory that nobody else has.
  function kept(text) {
    if (!texts.has(text)) {
      const bytes = new TextEncoder().encode(text).length + 1;
      if (end - free < bytes) {
        const { memory } = heap.exports();
        free = memory.grow(Math.ceil(bytes / kPage)) * kPage;
        end = memory.buffer.byteLength;
      }
      texts.set(text, free);
      free += heap.putText(text, free, bytes) + 1;
    }
    return texts.get(text);
  }
  function textOf(what) {
    const more = gl.getExtension('WEBGL_debug_renderer_info');
    switch (what) {
      case GL_VERSION: return `OpenGL ES 3.0 (${gl.getParameter(gl.VERSION)})`;
      case GL_RENDERER: return gl.getParameter(more?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) ?? '';
      case GL_VENDOR: return gl.getParameter(more?.UNMASKED_VENDOR_WEBGL ?? gl.VENDOR) ?? '';
      default: return '';  // extensions: those of OpenGL ES are not there, whatever WebGL has
    }
  }
  const integer = (value) => (typeof value === 'object' && value ? names.nameOf(value) : Number(value ?? 0));
  return {
    GetString: (what) => kept(textOf(what)),
    GetIntegerv: (what, ptr) => {
      const value = what === GL_MAJOR_VERSION ? 3 : what === GL_MINOR_VERSION ? 0 : gl.getParameter(what);
      const many = Array.isArray(value) || ArrayBuffer.isView(value) ? Array.from(value) : [value];
      heap.now.i32.set(many.map(integer), ptr >>> 2);
    },
    GetInternalformativ: (target, format, what, size, ptr) => {
      const samples = Array.from(gl.getInternalformatParameter(target, format, gl.SAMPLES) ?? []);
      const values = what === GL_NUM_SAMPLE_COUNTS ? [samples.length] : samples;
      heap.now.i32.set(values.slice(0, Math.max(size, 0)), ptr >>> 2);
    },
  };
}

// imports: what WebAssembly imports as module "gl", by OpenGL ES's names. object(name): the context's own, as a WebGLProgram,
// or null. release(): deletes every object made through them, or forgets those of a context that was lost.
// context: a WebGL2RenderingContext. exports: a function that gives the instance's exports, for its memory.
export function glImports(context, exports) {
  const names = new Names(context), heap = new Heap(exports), imports = {};
  for (const name of kSame) imports[`gl${name[0].toUpperCase()}${name.slice(1)}`] = context[name].bind(context);
  const others = [ofObjects(context, names, heap), ofData(context, heap), ofPrograms(context, names, heap),
    ofState(context, names, heap)];
  for (const [name, call] of others.flatMap(Object.entries)) imports[`gl${name}`] = call;
  return { imports, object: (name) => names.of(name), release: () => names.clear() };
}
