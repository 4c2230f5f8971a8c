// Made by tools/c_api from the descriptions in runtime/c: do not edit.
// The runtime for JavaScript and TypeScript, as C has it: see docs/c.md.

export const ABI: number;
export const GLES3_ABI: number;
export const BLOCK_BOUNDARY: number;
export const UNPACK_STATE_BYTES: number;
export const MAX_EXAMPLE_PARAMETERS: number;
export const MAX_EXAMPLES: number;
export const MAX_JOINTS: number;
export const MAX_INFLUENCES: number;
export const NO_PARENT: number;
export const NO_SLOT: number;
export const MAX_POSE_EXAMPLES: number;
export const NO_MATERIAL: number;
export const NO_IMAGE: number;
export const NO_JOINT: number;
export const MORPHS_POSITIONS: number;
export const MORPHS_NORMALS: number;
export const MORPHS_TANGENTS: number;
export const MAX_SPRING_COLLIDERS: number;
export const NO_CHANNEL: number;
export const MAX_BLEND_WEIGHT: number;
export const REST_THRESHOLD: number;
export const LIMIT_TOLERANCE_RAD: number;
export const WIDEST_SWING_RAD: number;
export const MAX_SPRING_STEP_S: number;
export const MAX_SPRING_STEPS: number;
export const MIN_SPRING_FRAME_S: number;
export const NO_CLIP: number;
export const GLES3_NORMALS: number;
export const GLES3_TANGENTS: number;
export const GLES3_UVS: number;
export const GLES3_COLOURS: number;
export const GLES3_MORPHS: number;
export const GLES3_SURFACE_NORMALS: number;
export const GLES3_MOTION: number;
export const GLES3_POSITION_LOCATION: number;
export const GLES3_WEIGHTS_LOCATION: number;
export const GLES3_JOINTS_LOCATION: number;
export const GLES3_NORMAL_LOCATION: number;
export const GLES3_TANGENT_LOCATION: number;
export const GLES3_UV_LOCATION: number;
export const GLES3_COLOUR_LOCATION: number;
export const GLES3_MORPH_ROW_LOCATION: number;
export const GLES3_EXAMPLE_ROW_LOCATION: number;
export const GLES3_MORPH_TARGETS: number;
export const GLES3_PREVIOUS_LOCATION: number;
export const GLES3_PALETTE_JOINTS: number;
export const GLES3_PALETTE_BLOCK_BYTES: number;
export const GLES3_PALETTE_TEXTURE_WIDTH: number;
export const GLES3_PATH_COUNT: number;
export const GLES3_MOST_ROLES: number;
export const GLES3_MOST_PROGRAMS: number;
export const GLES3_MAX_CROWD_FRAMES: number;
export const GLES3_NO_CROWD_CLIP: number;
export const GLES3_CROWD_INSTANCE_BYTES: number;
export const GLES3_VERDICT_COUNT: number;
export const GLES3_GPU_FAMILY_COUNT: number;
export const GLES3_MOST_POSITION_ERROR: number;
export const GLES3_MOST_NORMAL_ERROR: number;
export const GLES3_ALL_PATHS: number;
export const GLES3_MANY_CHARACTERS: number;
export const GLES3_SAVED_SELF_TEST_BYTES: number;

/**
 * What a call came to.
 */
export const Status: {
  readonly OK: number;
  /**
   * the call is wrong: a span too short, a null pointer, an index out of range
   */
  readonly BAD_ARGUMENT: number;
  /**
   * the data ends before what it announces
   */
  readonly TRUNCATED: number;
  /**
   * not a cooked file
   */
  readonly BAD_MAGIC: number;
  /**
   * cooked for another version of the format
   */
  readonly BAD_VERSION: number;
  /**
   * damaged
   */
  readonly BAD_CHECKSUM: number;
  /**
   * breaks a rule of docs/format.md
   */
  readonly BAD_DATA: number;
  /**
   * legal, but needs what this build or this device lacks
   */
  readonly UNSUPPORTED: number;
  /**
   * the driver refused
   */
  readonly GL_ERROR: number;
  /**
   * both are good, but not made for each other
   */
  readonly MISMATCH: number;
  /**
   * a library that allocates for itself found none
   */
  readonly OUT_OF_MEMORY: number;
};
export type Status = number;

/**
 * What shape the rotations within a JointLimit have.
 */
export const LimitKind: {
  /**
   * turns freely; for joints that have a rate limit alone
   */
  readonly NONE: number;
  /**
   * about one axis, between two angles: knees, elbows, fingers
   */
  readonly HINGE: number;
  /**
   * swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
   */
  readonly CONE: number;
  /**
   * three angles about three axes, each between two: rigs whose limits came so
   */
  readonly EULER: number;
};
export type LimitKind = number;

/**
 * The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
 */
export const AxisOrder: {
  readonly XYZ: number;
  readonly XZY: number;
  readonly YXZ: number;
  readonly YZX: number;
  readonly ZXY: number;
  readonly ZYX: number;
};
export type AxisOrder = number;

/**
 * Which part of a local transform a Track drives.
 */
export const TrackPath: {
  readonly TRANSLATION: number;
  readonly ROTATION: number;
  readonly SCALE: number;
};
export type TrackPath = number;

/**
 * What lies between two keys, as glTF 2.0 defines it.
 */
export const Interpolation: {
  readonly STEP: number;
  readonly LINEAR: number;
  readonly CUBIC_SPLINE: number;
};
export type Interpolation = number;

/**
 * How a material's alpha is meant, as in glTF 2.0.
 */
export const AlphaMode: {
  readonly OPAQUE: number;
  readonly MASK: number;
  readonly BLEND: number;
};
export type AlphaMode = number;

/**
 * What of a material an image gives.
 */
export const TextureRole: {
  readonly BASE_COLOUR: number;
  readonly METALLIC_ROUGHNESS: number;
  readonly NORMAL: number;
  readonly OCCLUSION: number;
  readonly EMISSIVE: number;
  /**
   * KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
   */
  readonly SPECULAR_GLOSSINESS: number;
};
export type TextureRole = number;

/**
 * What lies beyond an image's edge.
 */
export const Wrap: {
  readonly REPEAT: number;
  readonly CLAMP_TO_EDGE: number;
  readonly MIRRORED_REPEAT: number;
};
export type Wrap = number;

/**
 * How an image is magnified.
 */
export const MagFilter: {
  readonly ANY: number;
  readonly NEAREST: number;
  readonly LINEAR: number;
};
export type MagFilter = number;

/**
 * How an image is minified; any: the source leaves it to the game.
 */
export const MinFilter: {
  readonly ANY: number;
  readonly NEAREST: number;
  readonly LINEAR: number;
  readonly NEAREST_MIPMAP_NEAREST: number;
  readonly LINEAR_MIPMAP_NEAREST: number;
  readonly NEAREST_MIPMAP_LINEAR: number;
  readonly LINEAR_MIPMAP_LINEAR: number;
};
export type MinFilter = number;

/**
 * What an image's bytes are.
 */
export const ImageFormat: {
  readonly UNKNOWN: number;
  readonly PNG: number;
  readonly JPEG: number;
  readonly WEBP: number;
  readonly KTX2: number;
  readonly DDS: number;
};
export type ImageFormat = number;

/**
 * What a Property is.
 */
export const PropertyType: {
  readonly NUMBER: number;
  readonly BOOLEAN: number;
  readonly TEXT: number;
};
export type PropertyType = number;

/**
 * Why a joint keeps a clip pack from fitting a skeleton.
 */
export const Misfit: {
  /**
   * the skeleton has no joint of this name
   */
  readonly MISSING: number;
  /**
   * it has, below another joint
   */
  readonly OTHER_PARENT: number;
  /**
   * it has, with another rest pose, which coded tracks are relative to
   */
  readonly OTHER_REST: number;
  /**
   * a joint of the skeleton that the clips were made without
   */
  readonly EXTRA: number;
  /**
   * all joints are there, this one at another place in the order
   */
  readonly OTHER_PLACE: number;
};
export type Misfit = number;

/**
 * What happens at the ends of a clip.
 */
export const PlayMode: {
  /**
   * time stops at the end
   */
  readonly ONCE: number;
  /**
   * time goes on from the other end; the last pose and the first are one moment
   */
  readonly LOOP: number;
  /**
   * time turns round
   */
  readonly PING_PONG: number;
};
export type PlayMode = number;

/**
 * How values run between two keys, and what a key holds. N is Curve::components, u goes 0 … 1 from one key to the next.
 */
export const CurveKind: {
  /**
   * key: value. The earlier key's value
   */
  readonly STEP: number;
  /**
   * key: value. A straight line; for rotations the shorter great arc (slerp)
   */
  readonly LINEAR: number;
  /**
   * key: in-tangent, value, out-tangent; tangents per second, as glTF 2.0 CUBICSPLINE has it
   */
  readonly HERMITE: number;
  /**
   * value, one control point, value, one control point, … value; Bernstein form
   */
  readonly QUADRATIC_BEZIER: number;
  /**
   * value, two control points, value, two control points, … value; Bernstein form
   */
  readonly CUBIC_BEZIER: number;
  /**
   * key: value. Uniform; Catmull and Rom 1974: the tangent at P1 is (P2 - P0) / 2 a key interval
   */
  readonly CATMULL_ROM: number;
  /**
   * key: value. Catmull-Rom with knots √|P2 - P1| apart; Barry and Goldman, SIGGRAPH 1988, and
   * Yuksel, Schaefer and Keyser 2011: no cusps or loops between two keys. Keys less than 1e18 apart
   */
  readonly CENTRIPETAL: number;
};
export type CurveKind = number;

/**
 * How a patch's points shape it.
 */
export const PatchBasis: {
  /**
   * through its inner points: u, v = 0 … 1 lead from point (1, 1) to point (2, 2)
   */
  readonly CATMULL_ROM: number;
  /**
   * through its corners: from point (0, 0) to point (3, 3)
   */
  readonly BEZIER: number;
};
export type PatchBasis = number;

/**
 * R. Penner's easings (Programming Macromedia Flash MX, 2002, chapter 7).
 */
export const Easing: {
  readonly LINEAR: number;
  readonly QUAD: number;
  readonly CUBIC: number;
  readonly QUART: number;
  readonly QUINT: number;
  readonly SINE: number;
  readonly EXPO: number;
  readonly CIRC: number;
  readonly BACK: number;
  readonly ELASTIC: number;
  readonly BOUNCE: number;
};
export type Easing = number;

/**
 * At which end a movement is eased.
 */
export const EaseMode: {
  readonly IN: number;
  readonly OUT: number;
  readonly IN_OUT: number;
};
export type EaseMode = number;

/**
 * How a weight goes from 0 to 1; u = time / duration. curve.h has more shapes.
 */
export const Fade: {
  /**
   * u
   */
  readonly LINEAR: number;
  /**
   * 3 u² - 2 u³: no jump of speed
   */
  readonly SMOOTHSTEP: number;
  /**
   * 6 u⁵ - 15 u⁴ + 10 u³: no jump of acceleration
   */
  readonly SMOOTHERSTEP: number;
};
export type Fade = number;

/**
 * How solve_ik() solves; docs/ik/solvers.md says which is for what.
 */
export const IkMethod: {
  readonly FABRIK: number;
  readonly CCD: number;
  readonly DAMPED_LEAST_SQUARES: number;
  readonly GAUSS_NEWTON: number;
};
export type IkMethod = number;

/**
 * Why a solver stopped.
 */
export const IkStop: {
  /**
   * the error is less than the tolerance
   */
  readonly REACHED: number;
  /**
   * nothing moved any more: the target is out of reach, or goals contradict each other
   */
  readonly STALLED: number;
  /**
   * max_iterations are over
   */
  readonly ITERATIONS: number;
};
export type IkStop = number;

/**
 * How bind-pose normals and tangents get to the deformed surface. M is the 3×3 part of the vertex's blended matrix.
 */
export const NormalTransform: {
  /**
   * Normals through the inverse transpose of M (its cofactors), tangents through M, both unit: exact for any blend that
   * can be inverted, mirrored or unevenly scaled ones too.
   */
  readonly INVERSE_TRANSPOSE: number;
  /**
   * Both through M, their length left as it comes: half the time, for shaders that normalise anyway. Right in direction
   * where M is a rotation, a mirror or an even scale; a blend of rotations is none of these quite. On real clips
   * normals stray by 0.8° on average, by up to 58° inside sharp bends, and come as short as 0.27
   * (docs/benchmarks.md). Tangents are inverse_transpose's up to length.
   */
  readonly BLENDED_MATRIX: number;
};
export type NormalTransform = number;

/**
 * Multi-weights are the CPU's alone: with four influences 192 bytes a vertex, more than attributes hold.
 */
export const Gles3Deformer: {
  /**
   * vertices skinned elsewhere, in float: position, normal, tangent
   */
  readonly NONE: number;
  /**
   * the joint with the largest weight
   */
  readonly RIGID: number;
  readonly SSD: number;
  readonly AS: number;
  /**
   * SSD of what the mesh's pose space has moved, see skin_psd() in skin.h
   */
  readonly PSD: number;
};
export type Gles3Deformer = number;

/**
 * Where a program finds its palettes.
 */
export const Gles3Palettes: {
  /**
   * PaletteRing: one palette a draw call
   */
  readonly UNIFORM_BLOCK: number;
  /**
   * PaletteTexture: of any size; one draw call may draw many characters
   */
  readonly TEXTURE: number;
  /**
   * CrowdMesh, see gles3_crowd.h: likewise, without work on the CPU; not for Deformer::none, psd or kMorphs
   */
  readonly CROWD: number;
};
export type Gles3Palettes = number;

/**
 * What skins vertices ahead of drawing.
 */
export const Gles3Preskin: {
  /**
   * transform feedback, OpenGL ES 3.0
   */
  readonly FEEDBACK: number;
  /**
   * compute shader, 3.1
   */
  readonly COMPUTE: number;
};
export type Gles3Preskin = number;

/**
 * Where vertices are skinned.
 */
export const Gles3SkinningPath: {
  /**
   * vertex shader, every pass; palettes in a uniform block, a draw call a character
   */
  readonly UBO: number;
  /**
   * vertex shader, every pass; palettes in a texture, one draw call for all characters
   */
  readonly TEXTURE: number;
  /**
   * once a frame, by transform feedback
   */
  readonly FEEDBACK: number;
  /**
   * once a frame, by compute shader; OpenGL ES 3.1
   */
  readonly COMPUTE: number;
  /**
   * once a frame, by the CPU
   */
  readonly CPU: number;
};
export type Gles3SkinningPath = number;

/**
 * What the self-test says of a path.
 */
export const Gles3Verdict: {
  readonly USABLE: number;
  /**
   * not among SelfTestOptions::paths
   */
  readonly NOT_TRIED: number;
  /**
   * among SelfTestOptions::crashed
   */
  readonly CRASHED: number;
  /**
   * the caps rule it out
   */
  readonly UNSUPPORTED: number;
  /**
   * the driver refuses its programs or its buffers
   */
  readonly REFUSED: number;
  /**
   * GL reports an error while it skins
   */
  readonly GL_ERROR: number;
  /**
   * its vertices differ from the CPU's
   */
  readonly WRONG: number;
  /**
   * right, but SelfTestOptions::slow times slower than the fastest that skins on the GPU
   */
  readonly SLOW: number;
};
export type Gles3Verdict = number;

/**
 * Chips that want another order of paths where nothing is timed, and other texts of shaders.
 */
export const Gles3GpuFamily: {
  readonly OTHER: number;
  /**
   * Mali-G… and Immortalis: rows of a uniform block cost three times those of a texture, attributes are dear
   */
  readonly MALI_G: number;
  /**
   * Mali-T…: four numbers at a time; the paths as others
   */
  readonly MALI_T: number;
  /**
   * registers enough without branches; the paths as others
   */
  readonly ADRENO: number;
  /**
   * unpacking attributes is dear: a quarter to a third less for animation space as words; the paths as others
   */
  readonly NVIDIA: number;
};
export type Gles3GpuFamily = number;

export type TypedArray = Float32Array | Float64Array | Uint8Array | Uint16Array | Uint32Array | Int16Array;

/** A struct in the memory of WebAssembly. */
export interface View { readonly ptr: number; }
/** Structs or numbers in a row there. Set a field to one, or hand it over as an argument. */
export interface List<T> extends View {
  readonly length: number;
  /** Of structs. */
  at(index: number): T;
  /** Of numbers: a view that lasts until memory grows. */
  readonly array: TypedArray;
}

/**
 * Where a block of data breaks the format, and which rule. `rule` is a static string.
 */
export interface DataError extends View {
  /**
   * what the call returns
   */
  status: Status;
  /**
   * byte in the block
   */
  offset: number;
  /**
   * in English
   */
  rule: string;
}

export interface Block extends View {
  data: number;
  size: number;
}

export interface Bytes extends View {
  data: number;
  size: number;
}

/**
 * One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
 */
export interface MeshDecoder extends View {
  /**
   * as packed files name it
   */
  codec: number;
  /**
   * the codec
   */
  decode: number;
}

/**
 * How much memory unpack() takes.
 */
export interface UnpackSizes extends View {
  /**
   * of the unpacked file
   */
  file_bytes: number;
  /**
   * what unpack() wants: the file and, behind it, room to work in
   */
  memory_bytes: number;
}

/**
 * The same in steps, for a game that loads while it plays: as many a frame as its time allows.
 *
 *   Unpacking loading;
 *   begin_unpack(packed, decoders, memory, loading);
 *   every frame   while (loading.file.empty() && there is time) unpack_step(loading);
 *   then          load(loading.file, file)
 *
 * A plain struct; {} is nothing begun. The packed bytes, the decoders and the memory stay as they are until the last
 * step. Stopping half way is forgetting it: nothing is to be freed.
 */
export interface Unpacking extends View {
  /**
   * empty until the last step is done; then as of unpack()
   */
  file: List<number>;
  /**
   * of total_bytes, for a bar
   */
  done_bytes: number;
  /**
   * of the unpacked file
   */
  total_bytes: number;
  /**
   * unpack_step()'s own
   */
  readonly state: TypedArray;
}

/**
 * Local transforms (parent_from_joint = translate · rotate · scale) of four consecutive joints, one lane a joint.
 * Rotations are unit quaternions. Lanes past the last joint hold the identity.
 */
export interface SoaTransform extends View {
  /**
   * x, y, z; metres
   */
  readonly translation: TypedArray;
  /**
   * x, y, z, w
   */
  readonly rotation: TypedArray;
  /**
   * x, y, z
   */
  readonly scale: TypedArray;
}

/**
 * The change from one pose to another, not a pose: a type of its own, so that one is not taken for the other.
 * translation: difference; rotation: of the parent's axes, w ≥ 0; scale: ratio.
 */
export interface AdditiveTransform extends View {
  /**
   * of four joints
   */
  readonly change: SoaTransform;
}

/**
 * An affine map, three rows of four: out = rows · (x, y, z, 1). What palettes and files hold: 48 bytes a joint.
 */
export interface Affine extends View {
  /**
   * the last column is the translation
   */
  readonly rows: TypedArray;
}

/**
 * The local transform of one joint.
 */
export interface JointTransform extends View {
  /**
   * metres
   */
  readonly translation: TypedArray;
  /**
   * a unit quaternion x, y, z, w
   */
  readonly rotation: TypedArray;
  /**
   * along the joint's axes
   */
  readonly scale: TypedArray;
}

/**
 * An axis of the space.
 */
export interface ExampleParameter extends View {
  /**
   * see File::text; also of the channel that drives it
   */
  name: number;
  /**
   * where nothing drives it
   */
  rest: number;
}

/**
 * Rows have one float a target, and zeros up to a multiple of four.
 */
export interface ExampleSpace extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * at most kMaxExamples
   */
  example_count: number;
  /**
   * at most kMaxExampleParameters
   */
  parameters: List<ExampleParameter>;
  /**
   * that it weighs, ascending, at most kMaxExamples; the same of each mesh
   */
  targets: List<number>;
  /**
   * of the file, ascending
   */
  meshes: List<number>;
  /**
   * a row of constants, then a row a parameter
   */
  linear: List<number>;
  /**
   * a row an example
   */
  radial: List<number>;
  /**
   * an example: its parameters
   */
  places: List<number>;
  /**
   * an example; above 0
   */
  inverse_widths: List<number>;
}

/**
 * Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
 * clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
 * angle_range() in limits.h.
 */
export interface AngleRange extends View {
  /**
   * -1 … 1: -180° … 180°
   */
  middle: number;
  /**
   * 0 … 1; 1: any angle
   */
  half_width: number;
}

/**
 * The most per second, and per second per second; 0: no limit. Of rotations in radians, of points in metres.
 */
export interface RateLimit extends View {
  /**
   * rad/s or m/s
   */
  speed: number;
  /**
   * rad/s² or m/s²
   */
  acceleration: number;
}

/**
 * How far and how fast a joint may turn, as it lies in a cooked file; make one with make_limit(), see limits.h.
 *
 * The limit's own axes are fixed to the joint, and coincide with those of the parent's side at the joint's zero
 * rotation. A local rotation q (parent_from_joint) is seen in them as
 *   t = limit_from_parent · q · joint_from_limit,   limit_from_parent = (zero · joint_from_limit)⁻¹
 * so that t is the identity where q = zero. Angles are positive by the right hand: about x from y to z.
 *
 * hinge: t is a turn about x, by an angle in angles[0].
 * cone: t = swing · twist, the twist, about x, first. The twist is an angle in angles[0]. The swing turns about an axis
 *   in the y-z plane by θ, and (y, z) = tan(θ / 4) · axis lies in the ellipse with the half axes angles[1].half_width
 *   and angles[2].half_width: about y alone it reaches the angle of the first, about z alone that of the second. Below
 *   90° this is within 2.3° of an ellipse in the angles themselves.
 * euler: t is the product of three turns about x, y and z in the order `order`, angles[0] that of the first factor. The
 *   second is within ±90°, where there is one set of angles for each rotation (at ±90° many).
 *
 * A swing of 180° has no twist: all twists are one step away. See clamp_rotation().
 */
export interface JointLimit extends View {
  /**
   * of the skeleton
   */
  joint: number;
  /**
   * which of the shapes above
   */
  kind: LimitKind;
  /**
   * of euler; else xyz
   */
  order: AxisOrder;
  /**
   * unit quaternion
   */
  readonly limit_from_parent: TypedArray;
  /**
   * unit quaternion
   */
  readonly joint_from_limit: TypedArray;
  /**
   * of a cone the middles of the second and third are 0; of a hinge both are 0
   */
  readonly angles: AngleRange[];
  /**
   * of the local rotation, see follow_pose()
   */
  readonly rate: RateLimit;
}

/**
 * A joint that swings, by the bone that goes from it to the next joint of its chain. See springs.h.
 */
export interface SpringJoint extends View {
  /**
   * of the skeleton
   */
  joint: number;
  /**
   * 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
   */
  most_pull: number;
  /**
   * 0 … 15: of small swings about the animated direction, without damping and gravity
   */
  frequency_hz: number;
  /**
   * 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
   */
  damping_ratio: number;
  /**
   * -10 … 10, times SpringFrame::gravity
   */
  gravity: number;
  /**
   * 0 … 50 1/s: by which the air slows the bone's end, and the wind carries it
   */
  drag: number;
  /**
   * ≥ 0, of the sphere about the bone's end that stays out of colliders; world
   */
  radius_m: number;
  /**
   * 0 … 1, of what is shown; the motion itself goes on
   */
  weight: number;
}

/**
 * Joints each of which is somewhere below the one before it. A joint belongs to one chain at most.
 */
export interface SpringChain extends View {
  /**
   * from the chain's root to its end
   */
  joints: List<SpringJoint>;
  /**
   * end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
   */
  readonly tip: TypedArray;
  /**
   * bit i, lowest first: it stays out of SpringFrame::colliders[i]
   */
  colliders: bigint;
}

/**
 * A capsule, or a sphere where both ends are one point, that moves with a joint. Its radius is scaled as the joint's
 * space is where that is most.
 */
export interface SpringCollider extends View {
  /**
   * it moves with
   */
  joint: number;
  reserved: number;
  /**
   * in the joint's space
   */
  readonly from: TypedArray;
  /**
   * in the joint's space
   */
  readonly to: TypedArray;
  /**
   * in the joint's space
   */
  radius_m: number;
}

export interface SpringColliderList extends View {
  data: number;
  size: number;
}

/**
 * The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
 * comes before its children and the roots come first.
 */
export interface Skeleton extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * 1 … kMaxJoints
   */
  joint_count: number;
  /**
   * joints 0 … root_count-1 have no parent joint
   */
  root_count: number;
  /**
   * root_count; what stands above each root and never moves
   */
  scene_from_root: number;
  /**
   * soa_count(joint_count); the pose of joints that a clip leaves alone
   */
  rest: number;
  /**
   * joint_count; kNoParent for roots
   */
  parents: number;
  /**
   * joint_count; see File::text
   */
  names: number;
  /**
   * ascending by joint; those that the asset came with
   */
  limits: List<JointLimit>;
}

/**
 * In a clip pack, instead of a skeleton: which one its clips were made for. See clip_pack.h.
 */
export interface SkeletonReference extends View {
  /**
   * the skeleton's
   */
  name: string;
  /**
   * the skeleton's
   */
  joint_count: number;
  /**
   * skeleton_hash() of the skeleton
   */
  hash: bigint;
  /**
   * joint_count; see File::text
   */
  names: number;
  /**
   * joint_count; of each joint's rest pose
   */
  rest_hashes: number;
  /**
   * joint_count; kNoParent for roots
   */
  parents: number;
}

/**
 * One channel of a clip stored without loss: the source's own keys at the source's own times.
 */
export interface Track extends View {
  /**
   * of the skeleton
   */
  joint: number;
  /**
   * what of the joint it drives
   */
  path: TrackPath;
  /**
   * between its keys
   */
  interpolation: Interpolation;
  /**
   * ≥ 1
   */
  key_count: number;
  /**
   * into Clip::times; tracks with the same keys share them
   */
  first_time: number;
  /**
   * Into Clip::values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
   */
  first_value: number;
}

/**
 * Which sub-tracks (rotation, translation or scale of a joint) of a group of four joints move in a clip, and which
 * stay, but not as in the rest pose. Bits 0-3 rotation, 4-7 translation, 8-11 scale; lowest bit first joint.
 */
export interface GroupMasks extends View {
  /**
   * what changes over the clip
   */
  moving: number;
  /**
   * what stays, but not as at rest
   */
  constant: number;
}

/**
 * A number over time, such as a morph target's weight or a property of the game: it moves no joint. Without loss, but
 * that keys on a straight line between others may have been left out (docs/cooking/clips.md).
 */
export interface Channel extends View {
  /**
   * see File::text
   */
  name: number;
  /**
   * the number where no clip drives it
   */
  rest: number;
  /**
   * ≥ 1
   */
  key_count: number;
  /**
   * as in Track
   */
  first_time: number;
  /**
   * into Clip::values; one float a key, three for cubic_spline (in, value, out)
   */
  first_value: number;
  /**
   * between its keys
   */
  interpolation: Interpolation;
  readonly reserved: TypedArray;
}

/**
 * Tracks compressed within a stated error: poses at even steps of time, or at times of their own, in segments, as
 * packed integers relative to the rest pose (docs/format.md). What does not move stands once.
 */
export interface CodedTracks extends View {
  /**
   * 0: the clip has no coded tracks; else ≥ 2
   */
  frame_count: number;
  /**
   * sub-tracks that move
   */
  track_count: number;
  /**
   * sub-tracks that stay, but not as at rest
   */
  constant_count: number;
  /**
   * steps of time a segment; the last may have fewer
   */
  segment_intervals: number;
  /**
   * of frame 0
   */
  start_s: number;
  /**
   * of uneven ones the mean
   */
  frames_per_s: number;
  /**
   * frame_count, ascending; null: even steps
   */
  times_s: number;
  /**
   * one a group of four joints
   */
  masks: number;
  /**
   * bytes into payload
   */
  segment_offsets: number;
  /**
   * their values
   */
  constants: number;
  /**
   * segments of packed integers
   */
  payload: number;
}

/**
 * An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
 */
export interface Clip extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * which skeleton of the file; in a clip pack, which reference
   */
  skeleton: number;
  /**
   * of that skeleton
   */
  joint_count: number;
  /**
   * time of the last key; ≥ 0
   */
  duration_s: number;
  /**
   * for sample_additive(), not for sample()
   */
  additive: boolean;
  /**
   * additive: the pose that changes are taken from; null: the rest pose
   */
  reference: number;
  /**
   * what is compressed
   */
  readonly coded: CodedTracks;
  /**
   * what is stored without loss
   */
  tracks: List<Track>;
  /**
   * numbers that it drives
   */
  channels: List<Channel>;
  /**
   * key times of tracks and channels, seconds
   */
  times_s: number;
  /**
   * keys of tracks and channels
   */
  values: number;
  /**
   * of its bytes and its place in the file, from File::clip(); 0: made by hand
   */
  id: bigint;
}

/**
 * Consecutive vertices that depend on the same joints. Each run starts a new block of four vertices; the slots that
 * fill up its last block repeat its last vertex.
 */
export interface Run extends View {
  /**
   * ≥ 1
   */
  vertex_count: number;
  /**
   * 1 … kMaxInfluences
   */
  influences: number;
}

/**
 * What a morph target adds to the vertices of the blocks that it moves, the others it leaves alone. For each of its
 * blocks and attributes, in this order, a record of twelve integers: dx[4] dy[4] dz[4]; times a step each is a change.
 */
export interface MorphTarget extends View {
  /**
   * into Geometry::target_blocks
   */
  first_block: number;
  /**
   * how many blocks it moves
   */
  block_count: number;
  /**
   * into Geometry::target_records
   */
  first_record: number;
  /**
   * MorphAttributes; 0 if it moves nothing
   */
  attributes: number;
  /**
   * metres, mesh space
   */
  position_step: number;
  /**
   * a unit of its records of normals
   */
  normal_step: number;
  /**
   * a unit of its records of tangents
   */
  tangent_step: number;
  reserved: number;
}

/**
 * What pose-space deformation adds to vertices of the bind pose, see skin_psd() in skin.h: example poses, and for each
 * the deltas of some blocks.
 */
export interface PoseSpace extends View {
  /**
   * width of the Gaussian, a share of 1: sin of half an angle
   */
  sigma: number;
  /**
   * positions alone; empty: none
   */
  examples: List<MorphTarget>;
  /**
   * as Geometry::target_blocks
   */
  blocks: number;
  /**
   * as Geometry::target_records
   */
  records: number;
  /**
   * for each example and palette entry x y z w, up to a positive factor
   */
  rotations: number;
  /**
   * a palette entry: the one that its rotation is relative to, or kNoParent
   */
  parents: number;
}

/**
 * Triangles and bind-pose vertices. Vertices live in *slots*: blocks of four, laid out for the skinning kernels
 * (`k` is the run's influence count). The arrays of blocks begin on 16-byte boundaries.
 */
export interface Geometry extends View {
  /**
   * vertices with padding; a multiple of 4
   */
  slot_count: number;
  /**
   * without padding
   */
  vertex_count: number;
  /**
   * 3 a triangle; counter-clockwise fronts
   */
  index_count: number;
  /**
   * 2 or 4
   */
  index_bytes: number;
  /**
   * how many palette entries the sets refer to
   */
  joint_count: number;
  /**
   * slots
   */
  indices: number;
  /**
   * in the order of the slots
   */
  runs: List<Run>;
  /**
   * for each run its k palette entries, run after run
   */
  sets: number;
  /**
   * a block: x[4] y[4] z[4], then k-1 times w[4]; the last weight is 1 - Σ
   */
  skin: number;
  /**
   * a block: x[4] y[4] z[4]; unit; null if absent
   */
  normals: number;
  /**
   * a block: x[4] y[4] z[4] sign[4]; unit; null if absent
   */
  tangents: number;
  /**
   * a block: k times dx[4] dy[4] dz[4] dw[4]; null: the lift, all zero
   */
  as_residual: number;
  /**
   * a block: k times three rows x[4] y[4] z[4] t[4]; null if absent
   */
  mwe_residual: number;
  /**
   * palette entry whose frame they are meant in
   */
  mwe_root: number;
  /**
   * a slot: u v; null if absent
   */
  uvs: number;
  /**
   * a slot: r g b a, linear; null if absent
   */
  colours: number;
  /**
   * The slot of each vertex of the source, if cooked with --keep-vertex-order; kNoSlot: no triangle uses it, of this
   * part of a primitive in parts.
   */
  source_slots: List<number>;
  /**
   * morph targets, as many as MeshTarget of a mesh
   */
  targets: List<MorphTarget>;
  /**
   * as wide as indices; for each target the blocks it moves, ascending
   */
  target_blocks: number;
  /**
   * twelve a record
   */
  target_records: number;
  /**
   * examples empty: none
   */
  readonly pose_space: PoseSpace;
  /**
   * of the bind positions, mesh space
   */
  readonly box_min: TypedArray;
  /**
   * likewise
   */
  readonly box_max: TypedArray;
}

/**
 * A morph target of a mesh: what it is called and what drives it.
 */
export interface MeshTarget extends View {
  /**
   * see File::text; may be empty
   */
  name: number;
  /**
   * Name of the channel that clips drive its weight by, see find_weight_channels() in morph.h.
   */
  channel: number;
  /**
   * where no clip does
   */
  weight: number;
}

/**
 * An image in a role, channels as glTF 2.0 section 3.9 has them. Base colour, emissive and specular-glossiness images
 * are sRGB (of the last all but alpha), others linear; (0, 0) of the UVs is the image's upper left corner.
 */
export interface Texture extends View {
  /**
   * which image of the file
   */
  image: number;
  /**
   * none twice in a material
   */
  role: TextureRole;
  /**
   * along u and v
   */
  wrap_u: Wrap;
  /**
   * along u and v
   */
  wrap_v: Wrap;
  /**
   * as the source asks
   */
  mag: MagFilter;
  /**
   * as the source asks
   */
  min: MinFilter;
  reserved: number;
}

/**
 * A material as far as Mesh does not say it.
 */
export interface Material extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * opaque: alpha is not looked at
   */
  alpha: AlphaMode;
  /**
   * mask: what is less opaque is not drawn
   */
  alpha_cutoff: number;
  /**
   * KHR_materials_unlit: the base colour is what is seen
   */
  unlit: boolean;
  /**
   * linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
   */
  readonly emissive: TypedArray;
  /**
   * one a role
   */
  textures: List<Texture>;
}

/**
 * A picture by reference, or as the source's own bytes. They are not checked: whoever decodes them must.
 */
export interface Image extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * relative to the source file and percent-encoded, as it stood there; empty if it had none
   */
  uri: string;
  /**
   * unknown: by its bytes or its URI none of the others
   */
  format: ImageFormat;
  /**
   * empty: by reference
   */
  bytes: List<number>;
  /**
   * of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
   */
  fallback: number;
}

/**
 * A number, a truth or a text that an artist gave a node.
 */
export interface Property extends View {
  /**
   * see File::text; of nested ones the path, as in "door/hinges/0"
   */
  name: number;
  /**
   * which of the two members below holds it
   */
  type: PropertyType;
  readonly reserved: TypedArray;
  /**
   * finite; of a boolean 1 or 0
   * see File::text
   */
  number: number;
}

/**
 * A node of the source that is kept although it may be no joint: a socket, a locator. Its place in the scene is
 * scene_from_joint[joint] · joint_from_node, or joint_from_node alone without a joint.
 */
export interface Node extends View {
  /**
   * as the source calls it; never empty
   */
  name: string;
  /**
   * which skeleton of the file
   */
  skeleton: number;
  /**
   * the nearest joint at or above it
   */
  joint: number;
  /**
   * never changes
   */
  joint_from_node: number;
  /**
   * the `extras` of the source
   */
  properties: List<Property>;
}

/**
 * A palette entry that blends those of two joints, for vertices that follow both: see build_palette().
 */
export interface Helper extends View {
  /**
   * palette entries, below Mesh::joint_count, not the same
   */
  first: number;
  /**
   * palette entries, below Mesh::joint_count, not the same
   */
  second: number;
  /**
   * of second; above 0, below 1
   */
  share: number;
}

/**
 * A level of detail: another geometry over the same palette.
 */
export interface MeshLod extends View {
  /**
   * which of the file
   */
  geometry: number;
  /**
   * the farthest that a vertex of the full mesh is from it, in the clips it was made with
   */
  error_m: number;
}

/**
 * A box, and a sphere about the box's centre, about the same vertices. Scene space, metres.
 */
export interface Bounds extends View {
  /**
   * least corner
   */
  readonly box_min: TypedArray;
  /**
   * greatest corner
   */
  readonly box_max: TypedArray;
  /**
   * below 0: empty, or not known
   */
  radius_m: number;
}

/**
 * Geometry bound to joints. A mesh hung rigidly on a node is bound to one joint with weight 1.
 */
export interface Mesh extends View {
  /**
   * as the source calls it; never null
   */
  name: string;
  /**
   * the material's name; never null
   */
  material: string;
  /**
   * which material of the file, if it has more than what stands here
   */
  material_index: number;
  /**
   * which skeleton of the file
   */
  skeleton: number;
  /**
   * meshes with the same number share their geometry
   */
  geometry_index: number;
  /**
   * palette entries that are joints
   */
  joint_count: number;
  /**
   * joint_count; palette entry → joint of the skeleton
   */
  joints: number;
  /**
   * joint_count; joint_from_mesh in the bind pose
   */
  inverse_bind: number;
  /**
   * linear RGBA
   */
  readonly base_colour: TypedArray;
  /**
   * backs are drawn, too
   */
  double_sided: boolean;
  /**
   * One primitive of the source with the mesh before it, for which one palette was too small. Nothing but the source's
   * vertex order needs to know: see Geometry::source_slots.
   */
  is_next_part: boolean;
  /**
   * palette entries behind those of the joints
   */
  helpers: List<Helper>;
  /**
   * three a helper, or none: see build_palette()
   */
  helper_centres: List<number>;
  /**
   * as many as the geometry's
   */
  targets: List<MeshTarget>;
  /**
   * levels 1, 2, …, ever coarser; level 0 is the mesh in full
   */
  lods: List<MeshLod>;
  /**
   * of the level asked for
   */
  readonly geometry: Geometry;
}

/**
 * A cooked file in memory. Cheap to copy; holds pointers into the block, which must outlive it and stay unchanged.
 */
export interface File extends View {
}

/**
 * A joint that is in the way.
 */
export interface JointMisfit extends View {
  /**
   * what is wrong with it
   */
  how: Misfit;
  /**
   * of the pack's reference; `extra`: of the skeleton
   */
  joint: number;
}

/**
 * The state of a playing clip: plain numbers that may be set, copied and stored at will. A clip that is to run
 * backwards once begins with time_s = its duration.
 */
export interface Playback extends View {
  /**
   * in the clip
   */
  time_s: number;
  /**
   * seconds of the clip a second; 0 pauses, below 0 runs backwards
   */
  speed: number;
  /**
   * what happens at the ends
   */
  mode: PlayMode;
  /**
   * ping_pong: on the way back, so time runs against speed
   */
  returning: boolean;
  /**
   * Of the last advance(). loop: how often time went from the clip's end to its start, less how often the other way
   * round; ping_pong: how often time turned; once: 0. Stops at ±2147483647.
   */
  turns: number;
}

/**
 * Which joints are sampled.
 */
export interface SampleOptions extends View {
  /**
   * A level of detail, or any set of joints: joint j is bit j % 32 of word j / 32; at least ⌈joint_count / 32⌉ words.
   * Joints whose bit is 0 keep what `out` holds. Empty: all joints. Every group of four without a joint of the set
   * costs a few operations only.
   */
  joints: List<number>;
}

/**
 * What an instance that plays a clip keeps between two calls of sample_cached(). {} keeps nothing yet. All but `memory`
 * is sample_cached()'s own.
 */
export interface SampleCache extends View {
  /**
   * The caller's, 16-byte aligned: two unpacked frames of the clip, so that times between them are not unpacked again.
   * With less than sample_cache_bytes() of a clip, or none, only what does not move is kept of it.
   */
  memory: List<number>;
  /**
   * where the last call wrote
   */
  out: number;
  /**
   * which clip
   */
  clip: bigint;
  /**
   * that is unpacked; 0xFFFFFFFF: none
   */
  frame: number;
  /**
   * for this clip's frames
   */
  room: boolean;
}

/**
 * Keys, as a view. catmull_rom and centripetal draw a smooth path whatever the times are, but its velocity is
 * continuous only where key intervals are even (or go with √distance, centripetal); for motion that is smooth over
 * uneven keys make a spline. Beyond the first and last key they continue with a mirrored point, so that the path leaves
 * and arrives straight.
 */
export interface Curve extends View {
  /**
   * what lies between keys
   */
  kind: CurveKind;
  /**
   * Values are unit quaternions x, y, z, w; components is 4. Every key and control point is taken with the sign that is
   * nearer to the one before it, and what comes out is normalised; its sign is open, as q and -q are the same rotation.
   * A blend that has no direction gives the earlier key's.
   */
  rotation: boolean;
  /**
   * floats a value: 1 … 4
   */
  components: number;
  /**
   * one a key, strictly increasing; seconds, or whatever the curve runs over
   */
  times_s: List<number>;
  /**
   * curve_value_count() floats
   */
  values: List<number>;
}

/**
 * Arc length: where on a path to be for its speed to be even.
 *
 * The table holds the length of the path up to each of `steps` equal parts of every key interval.
 */
export interface ArcLength extends View {
  /**
   * a key interval, at least 1
   */
  steps: number;
  /**
   * arc_length_count() of them, ascending
   */
  lengths: List<number>;
}

/**
 * The timing function of CSS Easing Functions Level 1: the cubic Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1), y
 * over x.
 */
export interface CubicBezierEase extends View {
  /**
   * CSS "ease"
   */
  x1: number;
  /**
   * CSS "ease"
   */
  y1: number;
  /**
   * CSS "ease"
   */
  x2: number;
  /**
   * CSS "ease"
   */
  y2: number;
}

/**
 * A pose and how much of it.
 */
export interface BlendLayer extends View {
  /**
   * at least skeleton.soa_size()
   */
  pose: List<SoaTransform>;
  /**
   * 0 … kMaxBlendWeight in blend(), 0 … 1 in overlay()
   */
  weight: number;
  /**
   * A factor for each joint's weight, 0 … 1: below 0 and NaN count as 0, above 1 as 1. Empty: 1 for every joint;
   * else at least 4 · skeleton.soa_size() floats, in joint order, so that a group's factors are read at once.
   */
  mask: List<number>;
}

/**
 * A change, and how much of it.
 */
export interface AdditiveLayer extends View {
  /**
   * at least skeleton.soa_size()
   */
  change: List<AdditiveTransform>;
  /**
   * 0 … 1
   */
  weight: number;
  /**
   * as in BlendLayer
   */
  mask: List<number>;
}

/**
 * How far four joints are from the new clip's pose, and how that fades. Each of the nine components of a joint, x y z
 * of the translation, of the rotation vector (axis times angle, in the parent's axes) and of the scale, fades by
 * itself:
 *   offset(t) = (1 - s)⁴ (start + slope s) with s = min(rate t, 1).
 */
export interface InertialOffset extends View {
  /**
   * metres, radians, factors
   */
  readonly start: TypedArray;
  /**
   * over the whole fade
   */
  readonly slope: TypedArray;
  /**
   * 1 / seconds
   */
  readonly rate: TypedArray;
}

/**
 * A transition under way; the memory is the caller's and can be used again for the next one.
 */
export interface Inertia extends View {
  /**
   * at least skeleton.soa_size()
   */
  offsets: List<InertialOffset>;
  /**
   * 0: none, or over
   */
  duration_s: number;
}

/**
 * What was shown in the last two frames, and what the new clip would show.
 */
export interface InertialStart extends View {
  /**
   * shown one frame earlier
   */
  before: List<SoaTransform>;
  /**
   * shown last
   */
  now: List<SoaTransform>;
  /**
   * the new clip at the time of `now`
   */
  target: List<SoaTransform>;
  /**
   * the new clip one frame earlier; empty: taken to stand still
   */
  target_was: List<SoaTransform>;
  /**
   * between the two, > 0; less than 1e-6 counts as that
   */
  frame_s: number;
}

/**
 * A limit as people think of it.
 */
export interface LimitDescription extends View {
  /**
   * its shape
   */
  kind: LimitKind;
  /**
   * of euler
   */
  order: AxisOrder;
  /**
   * the local rotation where all angles are 0: most often the joint's rest
   */
  readonly zero: TypedArray;
  /**
   * the limit's x in the joint's axes: a hinge's axis, or what a cone points along
   */
  readonly axis: TypedArray;
  /**
   * its y, made perpendicular to x
   */
  readonly across: TypedArray;
  /**
   * hinge: the first is the angle. Cone: the first is the twist; of the second and third, swings about y and z, `most`
   * is the half-width, and `least` its negative. Euler: the three angles.
   */
  readonly least_rad: TypedArray;
  /**
   * as least_rad
   */
  readonly most_rad: TypedArray;
  /**
   * 0: none
   */
  readonly rate: RateLimit;
}

/**
 * Limits over time. What follows a target with limited speed and acceleration: plain numbers, one for each rotation or
 * point that follows. A new one, one set to `{}`, and one whose numbers no call has left begins anew: the next call
 * takes its target as it is, at rest.
 */
export interface RotationFollower extends View {
  /**
   * where it is: x y z w
   */
  readonly rotation: TypedArray;
  /**
   * of the last call
   */
  readonly target: TypedArray;
  /**
   * radians a second, about the parent's axes
   */
  readonly velocity: TypedArray;
  /**
   * of the last call
   */
  frame_s: number;
  /**
   * follow_rotation()'s own
   */
  mode: number;
}

/**
 * A point that follows another.
 */
export interface PointFollower extends View {
  /**
   * where it is, metres
   */
  readonly point: TypedArray;
  /**
   * of the last call
   */
  readonly target: TypedArray;
  /**
   * metres a second
   */
  readonly velocity: TypedArray;
  /**
   * of the last call
   */
  frame_s: number;
  /**
   * follow_point()'s own
   */
  mode: number;
}

/**
 * What is asked of a limb: start, middle and end joint, such as hip, knee and ankle.
 */
export interface TwoBone extends View {
  /**
   * where the end joint is to be; scene, metres
   */
  readonly target: TypedArray;
  /**
   * 0 … 1: 0 changes no bit, 1 reaches; between, both turns are blended
   */
  weight: number;
  /**
   * The direction, from the start joint, to whose side the middle joint points; scene. Zero: the side it has in the
   * pose, carried along the shortest way. Less than 0.1 rad off the direction of the target a pole says little, and
   * the answer goes over to a side of 37° from that of the pose: a target that goes over the pole in the plane of the
   * pose swings the limb round, and does not make it jump.
   */
  readonly pole: TypedArray;
  /**
   * turns the limb about the line from start to target, away from the pole; a few turns at most
   */
  twist_rad: number;
  /**
   * About what the middle joint bends, by positive angles; in its local space. Says which way a straight limb bends,
   * and which way it is to bend if the pose has it bent the other way. Zero: as in the pose, and a straight limb
   * towards the pole.
   */
  readonly bend_axis: TypedArray;
  /**
   * The share of the limb's length from which on it stretches ever more slowly, 0 … 1, so that the middle joint does
   * not snap when the target goes out of reach. 1: straight to full stretch, and the target is reached exactly to
   * there; 0.97 is a usual choice.
   */
  soft: number;
  /**
   * ≥ 1: the bones may be this many times as long, if the target is reached no other way
   */
  max_stretch: number;
}

/**
 * Unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
 */
export interface TwoBoneTurns extends View {
  /**
   * of the start joint
   */
  readonly start: TypedArray;
  /**
   * of the middle joint
   */
  readonly mid: TypedArray;
  /**
   * for the translations of all joints from below start down to end; 1: unless max_stretch > 1
   */
  stretch: number;
  /**
   * The target is within reach: at weight 1 the end comes to it within 1e-4 of the limb's length.
   */
  reached: boolean;
}

/**
 * The scene matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
 */
export interface TwoBoneJoints extends View {
  /**
   * hip, shoulder
   */
  start: number;
  /**
   * knee, elbow
   */
  mid: number;
  /**
   * ankle, wrist
   */
  end: number;
}

/**
 * Joints of a skeleton; other joints may lie between them.
 */
export interface TwoBoneLimb extends View {
  /**
   * hip, knee and ankle
   */
  start: number;
  /**
   * hip, knee and ankle
   */
  mid: number;
  /**
   * hip, knee and ankle
   */
  end: number;
}

/**
 * What is asked of a joint that looks or points at something: an eye, a head, a gun.
 */
export interface Aim extends View {
  /**
   * scene, metres
   */
  readonly target: TypedArray;
  /**
   * 0 … 1: 0 changes no bit, 1 aims
   */
  weight: number;
  /**
   * The scene direction to whose side of the target's direction `up` is turned. Zero: nothing is; the shortest way to
   * the target is taken. Less than 0.1 rad off the target's direction it says little, as a TwoBone's pole.
   */
  readonly pole: TypedArray;
  /**
   * turns about the direction of the target, on top; a few turns at most
   */
  twist_rad: number;
  /**
   * what is to go through the target; in the joint's local space
   */
  readonly forward: TypedArray;
  /**
   * local; not along forward. Of no use without a pole
   */
  readonly up: TypedArray;
  /**
   * where forward begins: an eye before the head's joint; local
   */
  readonly offset: TypedArray;
}

/**
 * What aim() gives.
 */
export interface AimTurn extends View {
  /**
   * a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
   */
  readonly turn: TypedArray;
  /**
   * The target can be seen: at weight 1 the ray from the offset along forward goes through it. It cannot where the
   * target is nearer to the joint than the ray ever gets, or than the offset, or where forward has no length.
   */
  reached: boolean;
}

/**
 * Where a point of a joint shall be, how the joint shall be turned, or both. What counts of a goal is its weights: 0
 * and it does not, of twice the weight and it gives way half as far where goals contradict each other.
 */
export interface IkGoal extends View {
  /**
   * of the skeleton
   */
  joint: number;
  /**
   * 0 first; what is less urgent never disturbs what is more so. Jacobian methods only
   */
  priority: number;
  /**
   * the point of the joint that shall reach `position`; the joint's space, metres
   */
  readonly offset: TypedArray;
  /**
   * scene space, metres
   */
  readonly position: TypedArray;
  /**
   * of the joint's axes, in scene space: a unit quaternion x, y, z, w
   */
  readonly rotation: TypedArray;
  /**
   * 0 … 100
   */
  position_weight: number;
  /**
   * metres a radian: the distance that is as bad as being turned wrong by a radian
   */
  rotation_weight: number;
}

/**
 * What is asked of a pose.
 */
export interface IkProblem extends View {
  /**
   * at least one that counts
   */
  goals: List<IkGoal>;
  /**
   * that may turn: ascending, so that parents come first. Others are stiff
   */
  joints: List<number>;
  /**
   * one of each of `joints`: 0 turns freely … 1 not at all; empty: all are free
   */
  stiffness: List<number>;
  /**
   * Joints ascending, as in a skeleton; those of joints that do not turn are left out.
   */
  limits: List<JointLimit>;
  /**
   * Where a chain with one goal shall bend to, as a knee forward: the middle of its joints faces this point as nearly
   * as a turn about the line from the first joint to the goal lets it. Of weight 0 … 1. FABRIK and CCD only.
   * scene space, metres
   */
  readonly pole: TypedArray;
  /**
   * 0: no pole
   */
  pole_weight: number;
  /**
   * By how many metres joints[0] is moved as easily as a joint is turned by a radian: the pelvis of a full body. 0: it
   * stays. Jacobian methods only.
   */
  root_travel_m: number;
}

/**
 * How it is solved.
 */
export interface IkOptions extends View {
  /**
   * see docs/ik/solvers.md
   */
  method: IkMethod;
  /**
   * How many poses to start from at most, as long as the goals are not reached: the one that there is, then others in
   * which joints are turned at random, by `seed`. For sets of limits in which one start ends in a corner. More than 1
   * costs as many times as much where goals are out of reach, and the result may jump as goals move.
   */
  starts: number;
  /**
   * the most there are
   */
  max_iterations: number;
  /**
   * an error (see IkReport) of less ends the iteration
   */
  tolerance_m: number;
  /**
   * of the Jacobian methods: more is calmer and slower
   */
  damping: number;
  /**
   * of `starts` and of solve_ik_genetic: the same seed, the same result
   */
  seed: number;
  /**
   * 0 leaves every bit as it was; between, rotations lie between
   */
  weight: number;
  /**
   * Of FABRIK and CCD with one goal: where it is beyond reach, the bones from the first joint that turns to the goal's
   * become longer, by up to this factor; and shorter, by up to as much, where it is too near for them. 1: they keep
   * their lengths. Changes local translations of the joints on the way.
   */
  stretch: number;
}

/**
 * How a solver ended.
 */
export interface IkReport extends View {
  /**
   * √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
   */
  error_m: number;
  /**
   * that it took
   */
  iterations: number;
  /**
   * why it took no more
   */
  why: IkStop;
}

/**
 * A leg. Other joints may lie between these: a hind leg of three bones is hip, knee and paw, and what is between keeps
 * its angle.
 */
export interface Foot extends View {
  /**
   * joints of the skeleton
   */
  hip: number;
  /**
   * joints of the skeleton
   */
  knee: number;
  /**
   * joints of the skeleton
   */
  ankle: number;
  /**
   * what stands on the ground, in the ankle's space: below the ball of the foot, say
   */
  readonly sole: TypedArray;
  /**
   * of the knee; see TwoBone
   */
  readonly bend_axis: TypedArray;
  /**
   * 0 … 1
   */
  weight: number;
}

/**
 * Two legs or more. The clips have been made for level ground, through the scene's origin.
 */
export interface Feet extends View {
  /**
   * two or more
   */
  feet: List<Foot>;
  /**
   * moved up and down, with all that hangs on it, the hips too; none: stays
   */
  pelvis: number;
  /**
   * ≥ 0: by how much at most it goes down, or up; world
   */
  lower_m: number;
  /**
   * 0 … 1: it goes down, too, where a leg would be longer than this share of its bones
   */
  reach: number;
  /**
   * 0 … 1.5: by how much at most a foot leans with the ground
   */
  slope_rad: number;
  /**
   * > 0: the time in which all but 2 % of a step in the ground, or of a release, is over
   */
  ease_s: number;
}

/**
 * What the game knows of a foot in this frame; world.
 */
export interface FootGround extends View {
  /**
   * false: as if the ground were level at the height of the scene's origin
   */
  hit: boolean;
  /**
   * of a ray along `up` through foot_sole(), or anywhere on the plane that it hit
   */
  readonly point: TypedArray;
  /**
   * of any length; steeper than 80°: no hit
   */
  readonly normal: TypedArray;
  /**
   * the sole stays at its place until this is false again
   */
  planted: boolean;
}

/**
 * The motion of one foot: plain numbers. A new one, one set to `{}`, and one whose numbers are out of hand begins where
 * the animation has the foot. World; on a moving platform, let the world be the platform.
 */
export interface FootMotion extends View {
  /**
   * of the sole, as shown last
   */
  readonly place: TypedArray;
  /**
   * of the sole from its target
   */
  readonly offset: TypedArray;
  /**
   * of the sole from its target
   */
  readonly offset_speed: TypedArray;
  /**
   * of the ground's normal that the foot leans by from the ground's own
   */
  readonly lean: TypedArray;
  /**
   * of the ground's normal that the foot leans by from the ground's own
   */
  readonly lean_speed: TypedArray;
  /**
   * the ground, last
   */
  readonly point: TypedArray;
  /**
   * the ground, last
   */
  readonly normal: TypedArray;
  /**
   * level: of the ankle's axis `axis` when it was planted
   */
  readonly heading: TypedArray;
  /**
   * about up, from the animated to the planted heading
   */
  readonly turn: TypedArray;
  /**
   * how much of it is left
   */
  turn_share: number;
  /**
   * how much of it is left
   */
  turn_share_speed: number;
  /**
   * whether it is planted, and was begun
   */
  axis: number;
  /**
   * whether it is planted, and was begun
   */
  planted: number;
  /**
   * whether it is planted, and was begun
   */
  begun: number;
  /**
   * whether its ray found ground
   */
  hit: number;
  /**
   * whether the leg was long enough
   */
  reached: number;
}

/**
 * What place_feet() is told of a frame.
 */
export interface FeetFrame extends View {
  /**
   * since the last frame
   */
  dt_s: number;
  /**
   * Where the character stands: a turn, one scale above 0, a shift.
   */
  readonly world_from_scene: Affine;
  /**
   * a unit vector; world
   */
  readonly up: TypedArray;
  /**
   * feet begin anew, none is planted where it was
   */
  teleported: boolean;
  /**
   * 0 … 1, times each foot's; the motion goes on
   */
  weight: number;
}

/**
 * Chains of one character. To keep or to copy a motion, copy the memory.
 */
export interface Springs extends View {
  /**
   * four bones each
   */
  groups: number;
  /**
   * a chain each
   */
  roots: number;
  /**
   * joints whose matrices springs change
   */
  below: number;
  /**
   * of each of them
   */
  group_count: number;
  /**
   * likewise
   */
  root_count: number;
  /**
   * likewise
   */
  below_count: number;
  /**
   * of the skeleton
   */
  joint_count: number;
  /**
   * time of frames that were too short
   */
  saved_s: number;
}

/**
 * What simulate_springs() is told of a frame.
 */
export interface SpringFrame extends View {
  /**
   * since the last frame
   */
  dt_s: number;
  /**
   * Where the character stands: a turn, one scale, a shift. Motion in the world is felt, by this and by the pose.
   */
  readonly world_from_scene: Affine;
  /**
   * m/s², world
   */
  readonly gravity: TypedArray;
  /**
   * m/s, world; acts by `drag`
   */
  readonly wind: TypedArray;
  /**
   * at most kMaxSpringColliders
   */
  colliders: List<SpringCollider>;
  /**
   * chains whose first joint moves further than this in one frame are moved along …
   */
  teleport_m: number;
  /**
   * … and so are all if this is set
   */
  teleported: boolean;
  /**
   * 0 … 1, times each joint's
   */
  weight: number;
}

/**
 * An instance's vertices, in the caller's memory. Copies are views of the same vertices.
 */
export interface MorphedGeometry extends View {
  /**
   * as the bind geometry, but that skin, normals and tangents are the instance's own
   */
  readonly geometry: Geometry;
  /**
   * as the file has it
   */
  readonly bind: Geometry;
  /**
   * a block's first float in the skin; one more for the end
   */
  offsets: number;
  /**
   * a bit a block: differs from the bind pose
   */
  moved: number;
  /**
   * a bit a block: written since morph_coordinates()
   */
  changed: number;
  /**
   * one, MorphAttributes: what differs in the blocks moved
   */
  attributes: number;
}

/**
 * A line to draw; scene space.
 */
export interface DebugLine extends View {
  /**
   * its ends, metres
   */
  readonly from: TypedArray;
  /**
   * its ends, metres
   */
  readonly to: TypedArray;
  /**
   * r g b a
   */
  readonly colour: TypedArray;
}

/**
 * Room for lines in the caller's memory. The calls below append to it.
 */
export interface DebugLines extends View {
  /**
   * the caller's
   */
  room: List<DebugLine>;
  /**
   * of lines that are there, from the front
   */
  count: number;
  /**
   * for which there was no room
   */
  left_out: number;
}

/**
 * The vertices of the bind pose that a palette entry has a weight in, as a box in mesh space.
 */
export interface JointReach extends View {
  /**
   * the box's middle
   */
  readonly centre: TypedArray;
  /**
   * ≥ 0; below 0: nothing follows this entry
   */
  readonly half: TypedArray;
}

/**
 * What a morph target (or an example of pose-space deformation) adds to vertices at weight 1: a box about all changes
 * and about 0, in mesh space.
 */
export interface MorphReach extends View {
  /**
   * ≤ 0
   */
  readonly least: TypedArray;
  /**
   * ≥ 0
   */
  readonly most: TypedArray;
}

/**
 * Views into the caller's memory.
 */
export interface Reach extends View {
  /**
   * one a palette entry, helpers behind
   */
  joints: List<JointReach>;
  /**
   * one a morph target
   */
  targets: List<MorphReach>;
  /**
   * the sum of what all examples may add
   */
  readonly pose_space: MorphReach;
}

/**
 * Where skinned vertices go: the caller's memory, slot after slot.
 */
export interface SkinOutput extends View {
  /**
   * 3 a slot; required
   */
  positions: List<number>;
  /**
   * 3 a slot; leave empty to skip
   */
  normals: List<number>;
  /**
   * 4 a slot: xyz, then the handedness, turned where the blend mirrors. (SSD and animation space with blended_matrix
   * ask the run's last joint, not the blend: only a vertex between mirrored and unmirrored joints can tell.) Needs
   * normals. Leave empty to skip.
   */
  tangents: List<number>;
  /**
   * of tangents, too
   */
  normal_transform: NormalTransform;
}

/**
 * A mesh in animation space, for as_tangents().
 */
export interface AsPart extends View {
  /**
   * cooked with animation space
   */
  mesh: number;
  /**
   * from as_coordinates()
   */
  coordinates: List<number>;
  /**
   * as_tangent_count() floats, to be written
   */
  tangents: List<number>;
}

/**
 * What the skeletons of a character play together: a clip each, or none. Plain pointers, which a game may fill itself.
 */
export interface Animation extends View {
  /**
   * that they are from: the character's file, or a clip pack
   */
  readonly clips: File;
  /**
   * of the longest
   */
  duration_s: number;
  /**
   * One a skeleton of the character: which clip it plays; kNoClip: it rests.
   */
  clip_of_skeleton: List<number>;
  /**
   * One a morph target of the character, mesh after mesh: from find_weight_channels() with the clip that the mesh's
   * skeleton plays.
   */
  channels: List<number>;
}

/**
 * All animations of a file, by name.
 */
export interface Animations extends View {
  /**
   * One a clip, with the index that the clip has: the clip, and of each other skeleton the first with the same name.
   * A clip without a name has nothing to do with others.
   */
  all: List<Animation>;
}

/**
 * What a character is made for.
 */
export interface CharacterOptions extends View {
  /**
   * that are blended at once, at most; at least 1
   */
  layers: number;
  /**
   * of detail, as in File::mesh
   */
  level: number;
  /**
   * on the CPU; false: neither palettes nor morphed vertices, a gles3::Skinner has them
   */
  skin: boolean;
  /**
   * skin by skin_as(), too
   */
  animation_space: boolean;
}

/**
 * A skeleton and its pose in both forms. What changes one between pose_character() and finish_character() must keep
 * the other alike; all calls of stage 3½ do.
 */
export interface CharacterSkeleton extends View {
  /**
   * of the file
   */
  readonly skeleton: Skeleton;
  /**
   * skeleton.soa_size()
   */
  local: List<SoaTransform>;
  /**
   * skeleton.joint_count
   */
  scene_from_joint: List<Affine>;
  /**
   * sample_character()'s own, one a layer: a pose, and what is kept of the clip that it is of.
   */
  sampled: List<SoaTransform>;
  /**
   * as `sampled`
   */
  caches: List<SampleCache>;
}

/**
 * A mesh, ready for skin_ssd(mesh, palette, …) or skin_as(mesh, coordinates, palette, …) after finish_character().
 */
export interface CharacterMesh extends View {
  /**
   * of the level asked for; with `skin` its geometry is this character's own, morphed
   */
  readonly mesh: Mesh;
  /**
   * of morph targets
   */
  weights: List<number>;
  /**
   * empty without `skin`
   */
  palette: List<Affine>;
  /**
   * empty without `skin` and `animation_space`
   */
  coordinates: List<number>;
  /**
   * with `skin`
   */
  readonly morphed: MorphedGeometry;
  /**
   * what it lies in
   */
  vertices: List<number>;
  /**
   * in Animation::channels
   */
  first_target: number;
}

/**
 * Views into the caller's memory. A copy is the same character.
 */
export interface Character extends View {
  /**
   * as it was given
   */
  readonly file: File;
  /**
   * as they were given
   */
  readonly options: CharacterOptions;
  /**
   * all of the file, in its order
   */
  skeletons: List<CharacterSkeleton>;
  /**
   * all of the file, in its order
   */
  meshes: List<CharacterMesh>;
  /**
   * of morph targets, of all meshes
   */
  target_count: number;
  /**
   * Scratch, of the largest skeleton.
   */
  blended: List<BlendLayer>;
  /**
   * of the same size
   */
  change: List<AdditiveTransform>;
}

/**
 * An animation at a time, and how much of it.
 */
export interface AnimationLayer extends View {
  /**
   * made for the character's file
   */
  animation: number;
  /**
   * see playback.h
   */
  time_s: number;
  /**
   * 0 … kMaxBlendWeight
   */
  weight: number;
}

/**
 * Of one skeleton of an outfit: what it follows.
 */
export interface OutfitSkeleton extends View {
  /**
   * of the body's character
   */
  body_skeleton: number;
  /**
   * one a joint of the outfit; see bind_outfit()
   */
  body_joints: List<number>;
}

/**
 * What characters of one file, hair or clothes, follow of a body of another. Serves any number of them.
 */
export interface Outfit extends View {
  /**
   * one a skeleton of the outfit
   */
  skeletons: List<OutfitSkeleton>;
}

/**
 * Told of every GL error by the call that caused it: for debugging, as each call is then between two of glGetError.
 * One an Api and thread.
 */
export interface Gles3ErrorWatch extends View {
  /**
   * call: "glBindBuffer", a static string. May be null.
   * what `report` gets
   */
  report: number;
  /**
   * call: "glBindBuffer", a static string. May be null.
   * what `report` gets
   */
  user: number;
  /**
   * what the Api's GetError has yet to tell, as it would without a watch
   */
  pending: number;
  /**
   * the driver's glGetError
   */
  get_error: number;
}

/**
 * The driver's entry points.
 */
export interface Gles3Api extends View {
}

/**
 * What the context can do. The defaults are the least that GLES 3.0 allows; tests force them on any driver.
 */
export interface Gles3Caps extends View {
  /**
   * that one block may have
   */
  uniform_block_bytes: number;
  /**
   * power of two
   */
  uniform_offset_alignment: number;
  /**
   * of four numbers each
   */
  vertex_attributes: number;
  /**
   * along each side
   */
  texture_size: number;
  /**
   * OpenGL ES 3.1 or newer, and its functions
   */
  compute: boolean;
}

/**
 * Byte offsets in one vertex of each stream. Offsets of what is absent are unused.
 */
export interface Gles3VertexLayout extends View {
  /**
   * the most of any vertex, 4 to 8
   */
  influences: number;
  /**
   * 1 or 2
   */
  joint_bytes: number;
  /**
   * the stream of SSD
   */
  ssd_stride: number;
  /**
   * the stream of SSD
   */
  ssd_weights: number;
  /**
   * the stream of SSD
   */
  ssd_joints: number;
  /**
   * in SSD's stream; 0: there is none
   */
  example_row: number;
  /**
   * the stream of animation space
   */
  as_stride: number;
  /**
   * the stream of animation space
   */
  as_tangents: number;
  /**
   * the stream of animation space
   */
  as_joints: number;
  /**
   * there are tangents, and room for them
   */
  surface_normals: boolean;
  /**
   * the stream that all deformers share
   */
  surface_stride: number;
  /**
   * the stream that all deformers share
   */
  normal: number;
  /**
   * the stream that all deformers share
   */
  tangent: number;
  /**
   * the stream that all deformers share
   */
  uv: number;
  /**
   * the stream that all deformers share
   */
  colour: number;
  /**
   * unorm16×2, otherwise f32×2
   */
  uv_unorm: boolean;
}

/**
 * A mesh on the GPU. Vertices are the geometry's slots, so indices are used as they are.
 *
 *   stream     what a vertex has in it               as
 *   SSD        position                              snorm16×3
 *              weight of the second influence        snorm16
 *              weights of the others                 unorm16×2, ×4 or ×6; the first has what they leave of 1
 *              joints                                u8×4, or ×8; u16 above 256 entries
 *              PrepareOptions::psd: first change     u32; of vertices that no example moves 0
 *   AS         coordinates, an influence             snorm16×4; their w sum to 32767, or less: see coordinate_scale
 *              kSurfaceNormals: both tangents of it  snorm16×4 each; their w sum to 0
 *              joints                                as SSD's
 *   surface    normal                                octahedral snorm16×2
 *              tangent                               octahedral snorm16×2, the sign in y
 *              texture coordinates                   unorm16×2, or f32×2
 *              colour                                unorm8×4
 *   morphs     row of the morph texture              u32; of vertices that no target moves 0
 *
 *   bytes a vertex    SSD    AS    AS, kSurfaceNormals    surface, normals alone
 *   4 influences       16    36                    100                         4
 *   5                  24    48                    128                         4
 *   6                  24    56                    152                         4
 *   8                  28    72                    200                         4
 *
 * The morph texture, RGBA16I, holds 8 B for each attribute, target and vertex that any target moves. That of examples
 * holds 8 B for each example and vertex that it moves.
 */
export interface Gles3GpuMesh extends View {
  /**
   * vertex array objects; 0 where not asked for. Rigid uses this one too.
   */
  ssd_array: number;
  /**
   * of animation space
   */
  as_array: number;
  /**
   * the streams above, a buffer each
   */
  ssd_buffer: number;
  /**
   * of animation space
   */
  as_buffer: number;
  /**
   * 0 for a mesh of bare positions
   */
  surface_buffer: number;
  /**
   * 0 for a mesh without morph targets
   */
  morph_buffer: number;
  /**
   * likewise
   */
  morph_texture: number;
  /**
   * 0 without PrepareOptions::psd, or examples
   */
  example_texture: number;
  /**
   * of all three vertex arrays
   */
  index_buffer: number;
  /**
   * three a triangle
   */
  index_count: number;
  /**
   * GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
   */
  index_type: number;
  /**
   * what the indices draw: GL_TRIANGLES
   */
  primitive: number;
  /**
   * as Geometry::slot_count
   */
  slot_count: number;
  /**
   * matrices in its palette
   */
  joint_count: number;
  /**
   * all vertex buffers together
   */
  vertex_bytes: number;
  /**
   * the most of any vertex, 4 to 8
   */
  influences: number;
  /**
   * kNormals | …
   */
  features: number;
  /**
   * texels a vertex: positions, normals, tangents
   */
  morph_per_row: number;
  /**
   * the texture's width is 1 << morph_shift
   */
  morph_shift: number;
  /**
   * of a target
   */
  morph_texels: number;
  /**
   * 1 / half-extent, see prepare()
   */
  morph_unit: number;
  /**
   * of changes, in half-extents
   */
  example_step: number;
  /**
   * distance_matrices() of the mesh, where it has examples here
   */
  distances: number;
  /**
   * of them, a palette entry
   */
  distance_texels: number;
  /**
   * Coordinates are stored divided by this; 1 unless a fitted weight lies outside [-1, 1].
   */
  coordinate_scale: number;
  /**
   * of its vertex buffers
   */
  readonly layout: Gles3VertexLayout;
}

/**
 * What prepare() puts on the GPU.
 */
export interface Gles3PrepareOptions extends View {
  /**
   * also what rigid draws from
   */
  ssd: boolean;
  /**
   * neither: for vertices skinned on the CPU
   */
  as: boolean;
  /**
   * From as_tangents() of this mesh: then animation space draws the deformed surface's own normals, and `features` has
   * kSurfaceNormals. Empty, or of a mesh with morph targets or without normals: normals through the blend.
   */
  as_tangents: List<number>;
  /**
   * With `ssd`: what Deformer::psd draws from, too; nothing more of a mesh without examples.
   */
  psd: boolean;
}

/**
 * What a program is compiled for: of the mesh's features those that it is to read. With kMorphs it draws only meshes
 * that have targets; set_morphs() before each. With kMotion it skins twice: by the palettes of this frame, and of the
 * frame before, positions alone. Those, bound for each draw call like the others, are
 *   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by bind_palette()
 *   in a texture         bind_previous_palette(); of crowds bind_crowd() does it
 *   skinned elsewhere    set_previous(), see gles3_skinned.h
 * and with kMorphs set_previous_morphs().
 */
export interface Gles3ProgramKey extends View {
  /**
   * by which vertices are skinned
   */
  deformer: Gles3Deformer;
  /**
   * 4 to 8: that of the mesh or more
   */
  influences: number;
  /**
   * kNormals | …, that it reads
   */
  features: number;
  /**
   * where they are
   */
  palettes: Gles3Palettes;
}

/**
 * The role's own texts, ESSL 3.00 without #version, zero-terminated. The vertex text comes after the skinning text
 * (shaders/skin.glsl), which ends where main() is to begin; the fragment text after the same #version and defines.
 *
 *   void main() {
 *     MarrowVertex v = marrow_skin();
 *     gl_Position = clip_from_scene * vec4(v.position, 1.0);
 *   }
 *
 * What both texts may ask, as numbers in #if: MARROW_NORMAL, MARROW_TANGENT, MARROW_UV, MARROW_COLOUR: 1 if the program
 * was built to read it (ProgramKey::features); MARROW_MOTION: likewise; MARROW_PALETTES: 2 in programs for crowds.
 * What the vertex text may use:
 *   MarrowVertex marrow_skin()       once; { vec3 position; vec3 normal; vec4 tangent; vec3 previous_position; } in
 *                                    scene space, normal and tangent of unit length, tangent.w the handedness; what is
 *                                    not read is 0, but previous_position is then the position
 *   vec2 in_uv, vec4 in_colour       attributes, where MARROW_UV, MARROW_COLOUR are 1
 *   vec4 marrow_instance_colour()    of an instance of a crowd; else white
 * Names that begin with marrow_, MARROW_, Marrow or in_ are Marrow's; all others the game's, uniforms, too: set those
 * after UseProgram(program.id), by Api or by any other loader.
 */
export interface Gles3ProgramSource extends View {
  /**
   * as above
   */
  vertex: string;
  /**
   * as above
   */
  fragment: string;
  /**
   * for transform feedback, interleaved; empty otherwise
   */
  feedback_varyings: List<number>;
}

/**
 * A program of the driver and where its uniforms are. Filled in by Marrow.
 */
export interface Gles3Program extends View {
  /**
   * for UseProgram(); 0: none
   */
  id: number;
  /**
   * where it reads palettes
   */
  reads: Gles3Palettes;
  /**
   * built with kMotion
   */
  motion: boolean;
  /**
   * Locations of uniforms.
   * of attributes; here and below -1: there is none
   */
  coordinate_scale: number;
  /**
   * Locations of uniforms.
   * of attributes; here and below -1: there is none
   */
  joint_bits: number;
  /**
   * of palettes in a texture
   */
  palettes: number;
  /**
   * of palettes in a texture
   */
  first_row: number;
  /**
   * of crowds
   */
  instances: number;
  /**
   * of crowds
   */
  crowd: number;
  /**
   * of pre-skinning by compute shaders
   */
  vertex_layout: number;
  /**
   * of morph targets
   */
  morph_changes: number;
  /**
   * of morph targets
   */
  morph_targets: number;
  /**
   * of morph targets
   */
  morph_count: number;
  /**
   * of morph targets
   */
  morph_shift: number;
  /**
   * of morph targets
   */
  morph_per_row: number;
  /**
   * of the frame before
   */
  previous_palettes: number;
  /**
   * of the frame before
   */
  previous_targets: number;
  /**
   * of the frame before
   */
  previous_count: number;
  /**
   * of pose spaces
   */
  examples: number;
  /**
   * of pose spaces
   */
  example_step: number;
  /**
   * of pose spaces
   */
  distances: number;
  /**
   * of pose spaces
   */
  distance_row: number;
  /**
   * of pose spaces
   */
  previous_distances: number;
}

/**
 * One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
 * contents are orphaned, so the CPU never waits for the GPU.
 */
export interface Gles3PaletteRing extends View {
  /**
   * a uniform buffer; 0: none
   */
  buffer: number;
  /**
   * of offsets, bytes
   */
  alignment: number;
  /**
   * bytes that palettes may use
   */
  capacity: number;
  /**
   * bytes, since begin_frame()
   */
  used: number;
}

/**
 * All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Of three, each is written every third
 * frame, so that the driver has no reason to wait for what it still draws from, or to copy it.
 */
export interface Gles3PaletteTexture extends View {
  /**
   * 0: none
   */
  readonly textures: TypedArray;
  /**
   * which was written last
   */
  current: number;
  /**
   * matrices
   */
  capacity: number;
  /**
   * that are there
   */
  count: number;
  /**
   * that were there in the frame before
   */
  previous_count: number;
}

/**
 * Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
 * positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them. Texture coordinates, colours
 * and indices are the mesh's, which must be there as long.
 */
export interface Gles3SkinnedMesh extends View {
  /**
   * vertex array object
   */
  array: number;
  /**
   * of the vertices
   */
  buffer: number;
  /**
   * the mesh's
   */
  slot_count: number;
  /**
   * kNormals, kTangents, kUvs, kColours: what programs with Deformer::none may read
   */
  features: number;
}

/**
 * One of a set, filled in by Marrow.
 */
export interface Gles3ProgramSetEntry extends View {
  /**
   * what it was built for
   */
  readonly key: Gles3ProgramKey;
  /**
   * kMostRoles + Preskin: pre-skinning; and 2: blending of crowds
   */
  role: number;
  /**
   * as it was built
   */
  readonly program: Gles3Program;
}

/**
 * The programs of a context: each role for each kind of mesh, compiled once. A game fills in the first five members.
 */
export interface Gles3ProgramSet extends View {
  /**
   * Texts that live as long as the set. (GCC 12 takes no shorter initialiser.)
   */
  readonly roles: Gles3ProgramSource[];
  /**
   * of `roles`, that are used
   */
  role_count: number;
  /**
   * Of what a mesh has, what each role's texts read: a shadow's none, or kUvs where it has holes. kMotion: whether they
   * read previous_position of skinners and crowds that keep it.
   */
  readonly role_features: TypedArray;
  /**
   * uniform buffer binding of the palettes
   */
  palette_binding: number;
  /**
   * what the driver says of a text that does not compile
   */
  log: List<number>;
  /**
   * what was compiled
   */
  readonly entries: Gles3ProgramSetEntry[];
  /**
   * of entries
   */
  count: number;
}

/**
 * How a mesh is skinned, and for how many characters.
 */
export interface Gles3SkinnerOptions extends View {
  /**
   * choose() in gles3_self_test.h names the best
   */
  path: Gles3SkinningPath;
  /**
   * rigid, ssd, as or psd, which is ssd for a mesh without examples
   */
  deformer: Gles3Deformer;
  /**
   * characters, at most
   */
  instances: number;
  /**
   * Palettes in a texture; morph targets take the next one, with `motion` palettes of the frame before the third.
   * A pose space takes the fourth and fifth, with `motion` the sixth.
   */
  texture_unit: number;
  /**
   * what programs are to read of what the mesh has and their role reads
   */
  features: number;
  /**
   * From as_tangents() of this mesh, in the caller's memory for as long as the skinner; see PrepareOptions.
   */
  as_tangents: List<number>;
  /**
   * For motion vectors: keeps what the update() before left on the GPU, and programs of roles that read kMotion have
   * MarrowVertex::previous_position from it. The uniform buffer binding behind ProgramSet::palette_binding is taken,
   * too. Nothing more goes up; what it costs: docs/performance.md, "Motion vectors".
   */
  motion: boolean;
}

/**
 * What skinners with SkinnerOptions::motion keep of the update() before: two of each, which take turns.
 */
export interface Gles3SkinnerMotion extends View {
}

/**
 * A mesh as many characters. Filled in by create_skinner(), to be read only.
 */
export interface Gles3Skinner extends View {
}

/**
 * What is baked, and how it ends.
 */
export interface Gles3CrowdSource extends View {
  /**
   * not an additive one
   */
  readonly clip: Clip;
  /**
   * its last pose is followed by its first; otherwise it stays in the last
   */
  loops: boolean;
}

/**
 * Where a clip's frames are: steps + 1 of them, at even steps of time; of one that loops the last is the first again.
 */
export interface Gles3CrowdClip extends View {
  /**
   * of the clip
   */
  duration_s: number;
  /**
   * of the crowd's frames
   */
  first_frame: number;
  /**
   * 1 … 65535
   */
  steps: number;
  /**
   * as its source's
   */
  loops: boolean;
}

/**
 * Baked clips of one skeleton: a matrix each frame and joint, as local_to_model() writes them.
 */
export interface Gles3CrowdFrames extends View {
  /**
   * in the order of their sources
   */
  clips: List<Gles3CrowdClip>;
  /**
   * frame after frame
   */
  character_from_joint: List<Affine>;
  /**
   * of the skeleton
   */
  joint_count: number;
  /**
   * of all clips
   */
  frame_count: number;
}

/**
 * At start_s of the crowd's clock the clip is at phase_s, before and afterwards wherever `speed` takes it.
 */
export interface Gles3CrowdPlay extends View {
  /**
   * of CrowdFrames::clips
   */
  clip: number;
  /**
   * of a clip that does not loop within 0 … duration_s, else the nearer end
   */
  phase_s: number;
  /**
   * seconds of the clip a second; may be negative
   */
  speed: number;
  /**
   * seconds
   */
  start_s: number;
}

/**
 * One of a crowd. Any instance is exact up to 36 hours from each of its times; by then set it again, with later ones.
 */
export interface Gles3CrowdInstance extends View {
  /**
   * where it stands
   */
  readonly scene_from_character: Affine;
  /**
   * must have a clip
   */
  readonly a: Gles3CrowdPlay;
  /**
   * kNoCrowdClip: a alone
   */
  readonly b: Gles3CrowdPlay;
  /**
   * until then a alone
   */
  blend_start_s: number;
  /**
   * and b alone so much later
   */
  blend_s: number;
  /**
   * marrow_instance_colour() in the vertex shader
   */
  readonly colour: TypedArray;
}

/**
 * A mesh as crowds draw it: its palette in every frame (RGBA32F), and the palettes of the instances as they are now
 * (RGBA32UI, the bits of floats, for GLES 3.0 renders to no floats). A texel is a row of a matrix, a line 2048 texels.
 */
export interface Gles3CrowdMesh extends View {
  /**
   * what draw() takes
   */
  readonly gpu: Gles3GpuMesh;
  /**
   * palettes of all frames
   */
  frames_texture: number;
  /**
   * palettes of the instances
   */
  blended_texture: number;
  /**
   * around the blended texture
   */
  framebuffer: number;
  /**
   * With motion alone: as they were in the frame before. begin_frame() has the two take turns.
   */
  previous_texture: number;
  /**
   * around the previous texture
   */
  previous_framebuffer: number;
  /**
   * matrices of a palette
   */
  joints: number;
  /**
   * of its frames
   */
  frame_count: number;
  /**
   * instances
   */
  capacity: number;
  /**
   * as create_crowd_mesh() was asked
   */
  motion: boolean;
  /**
   * between on_context_lost() and on_context_restored()
   */
  lost: boolean;
  /**
   * What it is put on the next context from.
   */
  readonly mesh: Mesh;
  /**
   * as they were given
   */
  readonly options: Gles3PrepareOptions;
  /**
   * as they were given
   */
  readonly frames: Gles3CrowdFrames;
  /**
   * what palettes are built with
   */
  bind: List<Affine>;
  /**
   * of prepare(), and of palettes on their way up
   */
  scratch: List<number>;
}

/**
 * Instances, in a texture: 128 B each, 256 a line. The caller's memory holds the same bytes for the next context.
 */
export interface Gles3Crowd extends View {
  /**
   * of records
   */
  texture: number;
  /**
   * instances, at most
   */
  capacity: number;
  /**
   * that have been set
   */
  count: number;
  /**
   * of the frames that they play
   */
  frame_count: number;
  /**
   * between on_context_lost() and on_context_restored()
   */
  lost: boolean;
  /**
   * as the texture has them
   */
  records: List<number>;
}

/**
 * What one path did.
 */
export interface Gles3PathResult extends View {
  /**
   * whether to use it
   */
  verdict: Gles3Verdict;
  /**
   * The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin;
   * and of unit normals and tangents. Quantised vertices differ by some 0.0001 and 0.0002. Above
   * kMostPositionError and kMostNormalError the path is wrong: numbers of 16 bits are off by more. Never NaN.
   */
  position_error: number;
  /**
   * of normals and tangents
   */
  normal_error: number;
  /**
   * to skin and draw once; 0: not timed
   */
  ns_per_vertex: number;
  /**
   * a vertex, of each pass that draws it again
   */
  ns_per_pass: number;
}

/**
 * What self_test() found.
 */
export interface Gles3SelfTest extends View {
  /**
   * by SkinningPath
   */
  readonly paths: Gles3PathResult[];
  /**
   * by GL_RENDERER
   */
  family: Gles3GpuFamily;
  /**
   * of driver, caps, options and this library's shader texts
   */
  key: bigint;
}

/**
 * What is tried, and how it is timed.
 */
export interface Gles3SelfTestOptions extends View {
  /**
   * bit_of() of those to try
   */
  paths: number;
  /**
   * Paths during which the process came to its end: they are not tried again. See about_to_try.
   */
  crashed: number;
  /**
   * the deformers that the game uses
   */
  ssd: boolean;
  /**
   * animation space
   */
  as: boolean;
  /**
   * Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
   */
  seconds: number;
  /**
   * times the fastest path's time
   */
  slow: number;
  /**
   * What is timed: characters of a mesh of so many vertices, of up to four influences, by SSD if `ssd`. State what the
   * game draws most of. 16 … 65 520 vertices, of which a multiple of 16 is taken; 1 … 256 characters.
   */
  timed_vertices: number;
  /**
   * of that mesh
   */
  timed_characters: number;
  /**
   * Called before a path is tried. A game that wants to outlive a driver that crashes stores which, durably, and
   * forgets it once self_test() has returned. What it finds stored at its next start goes into `crashed`, together
   * with what has been there before.
   * what the two functions above get
   */
  about_to_try: number;
  /**
   * Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
   */
  user: number;
}

/**
 * What a mesh is to be drawn for.
 */
export interface Gles3PathNeed extends View {
  /**
   * that draw it in a frame: colour, depth, shadows
   */
  passes: number;
  /**
   * in one Skinner
   */
  characters: number;
  /**
   * Mesh::palette_size()
   */
  joints: number;
}

export interface Structs {
  DataError: DataError;
  Block: Block;
  Bytes: Bytes;
  MeshDecoder: MeshDecoder;
  UnpackSizes: UnpackSizes;
  Unpacking: Unpacking;
  SoaTransform: SoaTransform;
  AdditiveTransform: AdditiveTransform;
  Affine: Affine;
  JointTransform: JointTransform;
  ExampleParameter: ExampleParameter;
  ExampleSpace: ExampleSpace;
  AngleRange: AngleRange;
  RateLimit: RateLimit;
  JointLimit: JointLimit;
  SpringJoint: SpringJoint;
  SpringChain: SpringChain;
  SpringCollider: SpringCollider;
  SpringColliderList: SpringColliderList;
  Skeleton: Skeleton;
  SkeletonReference: SkeletonReference;
  Track: Track;
  GroupMasks: GroupMasks;
  Channel: Channel;
  CodedTracks: CodedTracks;
  Clip: Clip;
  Run: Run;
  MorphTarget: MorphTarget;
  PoseSpace: PoseSpace;
  Geometry: Geometry;
  MeshTarget: MeshTarget;
  Texture: Texture;
  Material: Material;
  Image: Image;
  Property: Property;
  Node: Node;
  Helper: Helper;
  MeshLod: MeshLod;
  Bounds: Bounds;
  Mesh: Mesh;
  File: File;
  JointMisfit: JointMisfit;
  Playback: Playback;
  SampleOptions: SampleOptions;
  SampleCache: SampleCache;
  Curve: Curve;
  ArcLength: ArcLength;
  CubicBezierEase: CubicBezierEase;
  BlendLayer: BlendLayer;
  AdditiveLayer: AdditiveLayer;
  InertialOffset: InertialOffset;
  Inertia: Inertia;
  InertialStart: InertialStart;
  LimitDescription: LimitDescription;
  RotationFollower: RotationFollower;
  PointFollower: PointFollower;
  TwoBone: TwoBone;
  TwoBoneTurns: TwoBoneTurns;
  TwoBoneJoints: TwoBoneJoints;
  TwoBoneLimb: TwoBoneLimb;
  Aim: Aim;
  AimTurn: AimTurn;
  IkGoal: IkGoal;
  IkProblem: IkProblem;
  IkOptions: IkOptions;
  IkReport: IkReport;
  Foot: Foot;
  Feet: Feet;
  FootGround: FootGround;
  FootMotion: FootMotion;
  FeetFrame: FeetFrame;
  Springs: Springs;
  SpringFrame: SpringFrame;
  MorphedGeometry: MorphedGeometry;
  DebugLine: DebugLine;
  DebugLines: DebugLines;
  JointReach: JointReach;
  MorphReach: MorphReach;
  Reach: Reach;
  SkinOutput: SkinOutput;
  AsPart: AsPart;
  Animation: Animation;
  Animations: Animations;
  CharacterOptions: CharacterOptions;
  CharacterSkeleton: CharacterSkeleton;
  CharacterMesh: CharacterMesh;
  Character: Character;
  AnimationLayer: AnimationLayer;
  OutfitSkeleton: OutfitSkeleton;
  Outfit: Outfit;
  Gles3ErrorWatch: Gles3ErrorWatch;
  Gles3Api: Gles3Api;
  Gles3Caps: Gles3Caps;
  Gles3VertexLayout: Gles3VertexLayout;
  Gles3GpuMesh: Gles3GpuMesh;
  Gles3PrepareOptions: Gles3PrepareOptions;
  Gles3ProgramKey: Gles3ProgramKey;
  Gles3ProgramSource: Gles3ProgramSource;
  Gles3Program: Gles3Program;
  Gles3PaletteRing: Gles3PaletteRing;
  Gles3PaletteTexture: Gles3PaletteTexture;
  Gles3SkinnedMesh: Gles3SkinnedMesh;
  Gles3ProgramSetEntry: Gles3ProgramSetEntry;
  Gles3ProgramSet: Gles3ProgramSet;
  Gles3SkinnerOptions: Gles3SkinnerOptions;
  Gles3SkinnerMotion: Gles3SkinnerMotion;
  Gles3Skinner: Gles3Skinner;
  Gles3CrowdSource: Gles3CrowdSource;
  Gles3CrowdClip: Gles3CrowdClip;
  Gles3CrowdFrames: Gles3CrowdFrames;
  Gles3CrowdPlay: Gles3CrowdPlay;
  Gles3CrowdInstance: Gles3CrowdInstance;
  Gles3CrowdMesh: Gles3CrowdMesh;
  Gles3Crowd: Gles3Crowd;
  Gles3PathResult: Gles3PathResult;
  Gles3SelfTest: Gles3SelfTest;
  Gles3SelfTestOptions: Gles3SelfTestOptions;
  Gles3PathNeed: Gles3PathNeed;
}

export class Marrow {
  /** Compiles the bytes of marrow.wasm, or takes a module. Throws if it is of another ABI. */
  static load(wasm: BufferSource | WebAssembly.Module): Promise<Marrow>;
  /** A struct as C++ has it by default, and with these values; zeros where there is no default. */
  make<K extends keyof Structs>(name: K, values?: Partial<Structs[K]>): Structs[K];
  /** A list of zeros, or of structs as by make(); of bytes on a boundary of 16. */
  list<K extends keyof Structs>(name: K, length: number): List<Structs[K]>;
  list(type: 'f32' | 'u8' | 'u16' | 'u32' | 'byte', length: number): List<number>;
  /** A list of these bytes. */
  bytes(from: Uint8Array): List<number>;
  /** The struct at a pointer. */
  view<K extends keyof Structs>(name: K, ptr: number): Structs[K];
  /** Gives back what make() and list() made. */
  free(made: View): void;
  /** Throws an Error with the text of the status, unless it is ok. */
  must(status: Status): void;
  /** Is told of bad calls; null: nobody. */
  onCallError(handler: ((name: string, condition: string) => void) | null): void;

  abi(): number;
  gles3_abi(): number;
  /**
   * One word or two in English, never null.
   */
  status_text(status: Status): string;
  /**
   * The handler of now; null: nobody is told. Thread-safe.
   */
  get_call_error_handler(): number;
  /**
   * How many bytes of any alignment hold a block of `bytes`.
   */
  block_bytes(bytes: number): number;
  /**
   * Whether a block may begin there.
   */
  is_on_boundary(first: View | number | null): boolean;
  /**
   * What lies behind the first boundary in `memory`; empty if there is none.
   */
  block_in(memory: List<number> | null, out: Block | null): Status;
  /**
   * Whether these are the first bytes of a packed file. Anything else is for load() to judge.
   */
  is_packed(bytes: List<number> | null): boolean;
  /**
   * How much memory unpacking takes: what the records need by their counts, and bad_data if the header claims anything
   * else, or a clip or bounds more than their bytes can hold. A mesh's counts are the file's claim, which a codec's few
   * bytes may bear out, so whoever reads files of strangers should set a limit. Errors: bad_magic, bad_version,
   * bad_checksum, truncated, bad_data. Cost: the checksum.
   * May be null: error.
   */
  find_unpack_sizes(packed: List<number> | null, out: UnpackSizes | null, error: DataError | null): Status;
  /**
   * Unpacks into `memory` (16-byte aligned, at least memory_bytes) and makes `file` its front part, which is for load()
   * to check, the decoded counts, indices and joints with it. What lies behind `file` is free again.
   *
   * packed may come from anywhere: nothing is read outside of it or written outside of memory. Errors: as unpack_sizes();
   * bad_data; unsupported if a mesh's codec is not among `decoders` (DataError::rule names it); out_of_memory, by Draco;
   * bad_argument. On failure
   * `file` is unchanged and memory holds garbage. Vertices come out grouped and ordered for skinning, triangles in the
   * order of the codec. Thread-safe on different outputs. Cost: docs/benchmarks.md; Draco allocates while it decodes,
   * nothing else does.
   * May be null: error.
   */
  unpack(packed: List<number> | null, decoders: List<MeshDecoder> | null, memory: List<number> | null, file: Bytes | null, error: DataError | null): Status;
  /**
   * Checks the header and the records' counts. Errors: as unpack_sizes(), and bad_argument; then nothing is begun.
   * Cost: the checksum.
   * May be null: error.
   */
  begin_unpack(packed: List<number> | null, decoders: List<MeshDecoder> | null, memory: List<number> | null, out: Unpacking | null, error: DataError | null): Status;
  /**
   * Goes on with one record, or with one of a mesh's stages: decoding, where animation space has a residual smoothing it
   * and decoding that, ordering and writing; then with the file's checksum. A step stops when it has done so much, a few
   * milliseconds whatever the file holds, and the next one goes on there; but for what a codec's library does in one call.
   * meshoptimizer's decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them. Draco's
   * decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
   *
   * Errors: as unpack(); nothing is in work afterwards. bad_argument: nothing is in work. May run on any thread, on one
   * at a time.
   * May be null: error.
   */
  unpack_step(unpacking: Unpacking | null, error: DataError | null): Status;
  /**
   * How many SoaTransforms hold a pose of `joint_count` joints.
   */
  soa_count(joint_count: number): number;
  /**
   * Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
   * is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
   */
  get_joint(local: List<SoaTransform> | null, joint: number, out: JointTransform | null): Status;
  /**
   * Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
   * is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
   */
  set_joint(local: List<SoaTransform> | null, joint: number, transform: JointTransform | null): Status;
  /**
   * Whether a limit keeps these rules, as those of make_limit() and load() do.
   */
  is_valid(limit: JointLimit | null): boolean;
  /**
   * Validates a cooked file (docs/format.md) and makes `out` a view of it.
   *
   * The block must be 16-byte aligned (bad_argument otherwise; block.h helps) and may come from anywhere: nothing is
   * read outside it, whatever it holds, and after `ok` nothing that it holds can make another stage read or write out of
   * bounds. Numbers of matrices, translations and scales are at most 1e12, and rotations units, so that the product of
   * what is above a root, a joint and an inverse bind is finite; those of long chains of huge scales need not be. Names
   * are at most 2047 bytes. `out` is written only on success. `error`, if not null, gets the place and the broken rule on
   * failure. Cost: one pass over the block; no allocation. Thread-safe.
   * May be null: error.
   */
  load(block: List<number> | null, out: File | null, error: DataError | null): Status;
  /**
   * How many of each there are.
   */
  file_skeleton_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_reference_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_clip_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_mesh_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_material_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_image_count(file: File | null): number;
  /**
   * How many of each there are.
   */
  file_node_count(file: File | null): number;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_skeleton(file: File | null, index: number, out: Skeleton | null): Status;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_reference(file: File | null, index: number, out: SkeletonReference | null): Status;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_clip(file: File | null, index: number, out: Clip | null): Status;
  /**
   * level: of detail, 0 in full; beyond the mesh's last it is its last. All levels share one palette.
   */
  file_mesh(file: File | null, index: number, level: number, out: Mesh | null): Status;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_material(file: File | null, index: number, out: Material | null): Status;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_image(file: File | null, index: number, out: Image | null): Status;
  /**
   * An index that is not below the count gives what is empty. Cost: a few loads.
   */
  file_node(file: File | null, index: number, out: Node | null): Status;
  /**
   * About all that the mesh's vertices do while the clip plays from its rest pose, at every level of detail, by every
   * deformer that it was cooked for. Empty if the clip does not move the mesh's skeleton, and in files without bounds.
   * Codes of 8 bits, rounded outwards: a face may be 1/64 of the box's farthest coordinate beyond the vertices. A clip
   * pack has none: palette_bounds() in bounds.h. Cost: a look at every clip and mesh; once a load.
   */
  file_bounds(file: File | null, clip: number, mesh: number, out: Bounds | null): Status;
  /**
   * Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
   * colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
   */
  file_spring_count(file: File | null, skeleton: number): number;
  /**
   * Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
   * colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
   */
  file_spring(file: File | null, skeleton: number, index: number, out: SpringChain | null): Status;
  /**
   * Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
   * colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
   */
  file_spring_colliders(file: File | null, skeleton: number, out: SpringColliderList | null): Status;
  /**
   * Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
   * holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
   * with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
   */
  file_example_space_count(file: File | null): number;
  /**
   * Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
   * holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
   * with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
   * May be null: error.
   */
  file_example_space(file: File | null, index: number, out: ExampleSpace | null, error: DataError | null): Status;
  /**
   * Index of the first skeleton with this name, or skeleton_count(). Here and below a null pointer names nothing.
   */
  file_find_skeleton(file: File | null, name: string | null): number;
  /**
   * The first joint of `skeleton`, a skeleton of this file, with this name, or skeleton.joint_count. Once a load, not a
   * frame.
   */
  file_find_joint(file: File | null, skeleton: Skeleton | null, name: string | null): number;
  /**
   * Index of the first mesh with this name, or mesh_count(). A mesh of several materials is one a material, all of the
   * same name.
   */
  file_find_mesh(file: File | null, name: string | null): number;
  /**
   * Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
   * of several skeletons is a clip each, with the same name and duration.
   */
  file_find_clip(file: File | null, name: string | null): number;
  /**
   * Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
   * of several skeletons is a clip each, with the same name and duration.
   */
  file_find_clip_of(file: File | null, name: string | null, skeleton: number): number;
  /**
   * Index of the first channel of `clip`, a clip of this file, with this name, or clip.channels.size. Once a load, not
   * a frame.
   */
  file_find_channel(file: File | null, clip: Clip | null, name: string | null): number;
  /**
   * Index of the first node with this name, or node_count().
   */
  file_find_node(file: File | null, name: string | null): number;
  /**
   * The property of `node`, a node of this file, with this name; null if there is none.
   */
  file_node_property(file: File | null, node: Node | null, name: string | null): Property | null;
  /**
   * A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
   * zero-terminated, never null.
   */
  file_text(file: File | null, name: number): string;
  /**
   * A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
   * zero-terminated, never null.
   */
  property_text(property: Property | null): number;
  /**
   * How many groups of four joints a local pose has.
   */
  skeleton_soa_size(skeleton: Skeleton | null): number;
  /**
   * How many matrices build_palette() writes.
   */
  mesh_palette_size(mesh: Mesh | null): number;
  /**
   * Whether nothing is known or in it.
   */
  bounds_is_empty(bounds: Bounds | null): boolean;
  /**
   * A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
   * Of a skeleton that is not there it is the hash of no joints. Cost: one pass over the skeleton.
   */
  skeleton_hash(file: File | null, skeleton: number): bigint;
  /**
   * Whether the clips that a pack has for one of its references may move a skeleton of another file. After `ok`,
   * sample(skeleton, pack.clip(i), …) does for every clip whose Clip::skeleton is `reference` what it would do for the
   * skeleton's own. Once a load, not a frame. (Sampling an unfit clip is safe: joints out of range are refused, and
   * within it the pose is nonsense.)
   *
   * misfits: gets the first ones, as many as it holds; misfit_count, if not null, how many there are. Both may be left
   * out. What stands above the roots may differ: it does not concern clips.
   * Errors: mismatch if the skeletons are not the same; bad_argument if an index is out of range. Cost: one pass over the
   * skeleton if it fits; else a search by name a joint. No allocation. Thread-safe.
   * May be null: misfits_there.
   */
  bind_clips(pack: File | null, reference: number, character: File | null, skeleton: number, misfits: List<JointMisfit> | null, misfits_there: View | number | null): Status;
  /**
   * Whether an outfit fits a body, and which joint of the body each of its joints is.
   *
   * body_joints: at least the outfit's joint_count; gets the number of the body's joint, ascending, or kNoJoint for what
   * only the outfit has. It fits if all joints of the body are there, in their order and each below the same parent, and
   * if each joint of its own hangs on another joint. Rest poses may differ, as may what stands above the roots: the same
   * clothes fit a taller body. Where all joints are the body's own, body_joints[j] is j.
   *
   * misfits: as of bind_clips(), where `joint` is of the outfit and `extra` one that the outfit lacks, of the body;
   * `missing`: a root that the body lacks.
   * Errors: mismatch if it does not fit, where body_joints holds nothing of use; bad_argument if an index is out of range
   * or a span too short. Cost: a comparison of names a joint if it fits; else a search by name. No allocation.
   * Thread-safe.
   * May be null: misfits_there.
   */
  bind_outfit(outfit: File | null, skeleton: number, body: File | null, body_skeleton: number, body_joints: List<number> | null, misfits: List<JointMisfit> | null, misfits_there: View | number | null): Status;
  /**
   * The outfit's scene-space joints in the body's pose: joints of the body are copied, the outfit's own stand at `local`
   * below their parents. Poses are the same bits as if local_to_model() had posed them all.
   *
   * skeleton: the outfit's. body_joints: as bind_outfit() gives it. local: at least skeleton.soa_size(), of which joints
   * of the body are not read. scene_from_joint: at least skeleton.joint_count; does not overlap the body's.
   * Errors: bad_argument if a span is too short, a joint out of range, or a root none of the body's.
   * Cost: 48 bytes are copied a joint of the body; the others cost what local_to_model() does. Where body_joints[j] is
   * always j, build_palette() and gles3::pose() may as well take the body's joints themselves, without a copy.
   * Thread-safe on different outputs.
   */
  follow_body(skeleton: Skeleton | null, body_joints: List<number> | null, body_scene_from_joint: List<Affine> | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null): Status;
  /**
   * Moves `playback` on by dt_s seconds times its speed, in a clip of `duration_s`. Whatever lies beyond an end counts,
   * however many times over: a loop loses no time and shows none twice, and so does a turn. Afterwards time_s is in
   * 0 … duration_s, and below duration_s in a loop; an end that is reached exactly is passed or turned at only when time
   * moves on. Events at a clip's times are due where time_s was before, where it is now, and `turns` say. A time_s
   * outside the clip counts as one that has just run there; a duration of 0 makes it 0, without a turn.
   *
   * Errors: bad_argument if time_s, speed, dt_s or duration_s is not finite, or duration_s is below 0; nothing is
   * changed.
   *
   * Error: dt_s · speed is exact; to add it to the time rounds once, by at most 2⁻⁵³ (time_s + |dt_s · speed|) before and
   * 2⁻⁵³ duration_s more where a loop passes its start backwards; finding the place of a time beyond an end is exact. So
   * after 10⁷ steps of a clip of 10 s time is off by less than 2·10⁻⁸ s. Cost: a few operations; the logarithm of the
   * turns where there are many. The same bits everywhere; thread-safe on different playbacks.
   */
  advance(playback: Playback | null, duration_s: number, dt_s: number): Status;
  /**
   * The time to sample: time_s as a float, which never goes beyond the clip.
   */
  clip_time(playback: Playback | null): number;
  /**
   * Whether a clip that plays once has reached the end towards which it runs; it stays true then. A clip at speed 0 runs
   * towards none.
   */
  finished(playback: Playback | null, duration_s: number): boolean;
  /**
   * Evaluates `clip` at `time_s`, clamped to each track's first and last key, as glTF 2.0 defines its interpolations:
   * STEP, LINEAR (spherical along the shortest arc for rotations) and CUBICSPLINE (Hermite, rotations normalised). Coded
   * tracks are blended between their two nearest frames, rotations on the sphere; they keep the cooker's --clip-error.
   *
   * out: at least skeleton.soa_size() elements, caller's memory; joints that the clip leaves alone get their rest pose.
   * Errors: bad_argument if `out` or the set of joints is too short, the clip belongs to a skeleton with other joints or
   * is additive, or time_s is not a number. Rotations differ from exact spherical interpolation by at most 1e-6 rad plus
   * float rounding. Cost: a binary search a distinct key-time list and a few dozen operations a track, wherever time_s
   * is. Stateless; thread-safe on different outputs.
   * May be null: options.
   */
  sample(skeleton: Skeleton | null, clip: Clip | null, time_s: number, out: List<SoaTransform> | null, options: SampleOptions | null): Status;
  /**
   * Bytes of SampleCache::memory for this clip: 160 for each four joints that turn, move or change their size, once for
   * each of the three.
   */
  sample_cache_bytes(clip: Clip | null): number;
  /**
   * sample() of all joints for an instance that plays on: writes the same bits, and leaves out what the call before with
   * this cache did already. That another clip, skeleton or `out` was given than in that call is found by itself: a clip
   * of a File by Clip::id, one that is made by hand by where its tracks lie.
   *
   * out: as of sample(), and nobody else writes to it as long as the cache is in use, not to joints that move either:
   * what rests between two frames is not written again. For a pose that is changed afterwards copy it, or let blend()
   * read it. cache: one for each `out`; `= {memory}` forgets, as is needed if `out` was written by others. Errors: as
   * sample(), and bad_argument if the cache's memory is not on a boundary of 16 bytes; then it forgets nothing. Cost: in
   * the worst case that of sample() and a copy of the frames; playing at 60 Hz over keys at 30 Hz about half.
   */
  sample_cached(skeleton: Skeleton | null, clip: Clip | null, time_s: number, out: List<SoaTransform> | null, cache: SampleCache | null): Status;
  /**
   * Evaluates a clip cooked as additive (`marrow cook --additive`): out = what turns its reference pose into the pose
   * that sample() would give of an ordinary clip, for add(). Laid on the reference with weight 1 it gives that pose,
   * within the cooker's --clip-error; joints that the clip leaves alone do not change, where the reference is the rest
   * pose in them.
   *
   * out: at least skeleton.soa_size() elements, caller's memory. Errors: as sample(), and bad_argument if the clip is not
   * additive. Cost: sample() and make_additive(). Stateless; thread-safe on different outputs.
   */
  sample_additive(skeleton: Skeleton | null, clip: Clip | null, time_s: number, out: List<AdditiveTransform> | null): Status;
  /**
   * Evaluates the clip's channels at `time_s` as above: out[i] is the value of clip.channels[i].
   *
   * out: at least clip.channels.size floats. Which channel is which: File::find_channel; numbers that the clip does not
   * drive have no channel, and keep what the game gives them. An additive clip's channels are values all the same, no
   * changes. Errors: bad_argument if `out` is too short or time_s is not
   * a number. Cost: a binary search a distinct key-time list and a few operations a channel.
   */
  sample_channels(clip: Clip | null, time_s: number, out: List<number> | null): Status;
  /**
   * How many floats `key_count` keys of `components` hold.
   */
  curve_value_count(kind: CurveKind, components: number, key_count: number): number;
  /**
   * Whether a curve keeps the rules above: call it once for keys that come from outside. Errors: bad_argument if `kind`
   * is unknown, there is no key, components is not 1 … 4 (4 for rotations) or values are missing; bad_data if times do
   * not increase strictly, a number is not finite, a value or control point beyond 1e18, or a tangent over the longest
   * interval, or a rotation key's squared length is off 1 by more than 1e-3. Cost: once over the keys.
   */
  check_curve(curve: Curve | null): Status;
  /**
   * The value at `time_s`, clamped to the first and last key; one key is a constant.
   *
   * out: at least curve.components floats. Errors: bad_argument as in check_curve(), if `out` is too short, or time_s is
   * not a number. Keys that check_curve() refuses with bad_data are safe but give garbage; of others values are finite.
   * At a key's time the value is exactly the key's (rotations: but for normalisation and sign). Cost: a binary search and
   * some dozen operations.
   */
  evaluate_curve(curve: Curve | null, time_s: number, out: List<number> | null): Status;
  /**
   * The derivative of evaluate_curve() by time, a second. At an inner key: of what follows; before the first and after
   * the last key: 0. Arguments, errors and cost as there; also unsupported for rotations, and
   * bad_data, with nothing written, if it is not finite, as keys are so far apart in so little time.
   */
  curve_velocity(curve: Curve | null, time_s: number, out: List<number> | null): Status;
  /**
   * Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
   *
   * keys: kind linear. out: curve_value_count(hermite, …) floats, which with the same times are a curve of kind hermite;
   * it does not overlap the keys. natural_spline: the second derivative is zero at both ends. clamped_spline: the first
   * derivative at the ends is given, `components` floats a second each. One key: tangents 0, or those given.
   * Rotations are written with signs that make neighbours nearest; then the spline runs through the four components.
   * Errors: as check_curve(keys); bad_argument also if kind is not linear or a span is too short; bad_data also if keys
   * are so close in time or so far in value that a tangent is not finite. After bad_data `out` may hold garbage. Method:
   * tridiagonal system of the tangents, diagonally dominant, solved by elimination without pivots (de Boor, A Practical
   * Guide to Splines, chapter IV) in `out` alone. Cost: twice over the keys.
   */
  natural_spline(keys: Curve | null, out: List<number> | null): Status;
  /**
   * Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
   *
   * keys: kind linear. out: curve_value_count(hermite, …) floats, which with the same times are a curve of kind hermite;
   * it does not overlap the keys. natural_spline: the second derivative is zero at both ends. clamped_spline: the first
   * derivative at the ends is given, `components` floats a second each. One key: tangents 0, or those given.
   * Rotations are written with signs that make neighbours nearest; then the spline runs through the four components.
   * Errors: as check_curve(keys); bad_argument also if kind is not linear or a span is too short; bad_data also if keys
   * are so close in time or so far in value that a tangent is not finite. After bad_data `out` may hold garbage. Method:
   * tridiagonal system of the tangents, diagonally dominant, solved by elimination without pivots (de Boor, A Practical
   * Guide to Splines, chapter IV) in `out` alone. Cost: twice over the keys.
   */
  clamped_spline(keys: Curve | null, first_velocity: List<number> | null, last_velocity: List<number> | null, out: List<number> | null): Status;
  /**
   * A Bézier curve of any degree at u, by de Casteljau's algorithm.
   *
   * points: degree + 1 points of `components` floats (1 … 4). scratch: at least points.size floats, overlapping nothing.
   * out: at least `components`. u outside [0, 1] extrapolates. Errors: bad_argument if there is no point, points.size is
   * no multiple of components, a span is too short, or u is not finite; bad_data if the result is not finite.
   * Cost: degree · (degree + 1) / 2 interpolations.
   */
  bezier(points: List<number> | null, components: number, u: number, scratch: List<number> | null, out: List<number> | null): Status;
  /**
   * The same for unit quaternions, each taken with the sign nearer to the one before; normalised. bad_data also if the
   * result has no direction, or is too long to be squared.
   */
  bezier_rotation(quaternions: List<number> | null, u: number, scratch: List<number> | null, out: List<number> | null): Status;
  /**
   * A bicubic patch over 4 × 4 points: the tensor product of two cubics.
   *
   * points: 16 · components floats, component by component within a point, points along u first, then v. out: at least
   * `components` (1 … 4). Errors: bad_argument if a span is too short, the basis is unknown, or u or v is not finite;
   * bad_data, with nothing written, if the result is not finite.
   * Cost: 20 blends of four points.
   */
  bicubic_patch(basis: PatchBasis, points: List<number> | null, components: number, u: number, v: number, out: List<number> | null): Status;
  /**
   * How many floats the table of a curve has.
   */
  arc_length_count(key_count: number, steps: number): number;
  /**
   * Measures `curve` once. out: arc_length_count() floats; the last is the length of all, in the unit of the values.
   * Errors: as evaluate_curve(); unsupported for rotations (slerp is even as it is) and for kind step; bad_argument if
   * `steps` is 0 or `out` too short; bad_data if a length is not finite. Three-point Gauss quadrature a step: exact for
   * linear, and else of the order steps⁻⁶ where the path does not stop inside a step. Cost: 3 square roots a step.
   */
  build_arc_length(curve: Curve | null, steps: number, out: List<number> | null): Status;
  /**
   * The time at which `curve` has gone `distance`, clamped to the path; where the path rests, the end of the rest.
   * Between two entries the length is taken as linear, so the point found is off along the path by at most
   * A / (8 steps²), A being the largest second derivative by u in that key interval, plus rounding: twice the steps,
   * a quarter of the error. Errors: bad_argument if the table is too short for this curve or `distance` is not a number.
   * Cost: a binary search.
   */
  time_at_distance(curve: Curve | null, table: ArcLength | null, distance: number, time_s: View | number | null): Status;
  /**
   * From 0 at u = 0 to 1 at u = 1, both exactly; u is clamped, and what is not a number counts as 0. back and elastic
   * overshoot. out(u) = 1 - in(1 - u), in_out is the one, then the other at half size. As in Penner's, expo and elastic
   * leave 0 (out: reach 1) with a jump of 1e-3 or less; back's overshoot is 1.70158, 1.525 times that for in_out;
   * elastic's period is 0.3, 0.45 for in_out. Within 1e-6 of the closed forms. Unknown enumerators: linear.
   */
  ease(easing: Easing, mode: EaseMode, u: number): number;
  /**
   * y at x = u, with u clamped to [0, 1]. The point lies on the curve within 3e-7 in x (4e-7 (1 + |y1| + |y2|) in y):
   * where the curve is steep, y is as uncertain as x is. Errors: bad_argument unless x1 and x2 are in [0, 1], y1 and y2
   * finite and u a number. Newton's method within a shrinking bracket. Cost: about 5 steps, at most 40.
   */
  ease_by_curve(curve: CubicBezierEase | null, u: number, out: View | number | null): Status;
  /**
   * out = Σ w x / Σ w for each joint, with w = weight · mask: translations and scales are averaged, rotations are summed
   * as quaternions and normalised. Rotations must be unit quaternions, of which no sum can be 0 then.
   *
   * Hemisphere: a layer's quaternion is negated where it points away from the sum of the layers before it, so the result
   * is that of the shorter arcs for two layers and does not cancel for any number; its sign is arbitrary. Where Σ w is
   * below `threshold`, the rest pose joins in with the weight that is missing, so no layers at all give the rest pose. A
   * single layer without a mask is copied bit for bit. Layers of weight 0 are not read; without masks, neither are those
   * below 1e-12 of the sum or of `threshold`. Finite for poses with translations and scales up to 1e15.
   *
   * layers: any number; out: at least skeleton.soa_size(), and may be the pose of a layer. threshold: 1e-6 …
   * kMaxBlendWeight.
   * Errors: bad_argument if a span is too short, or a weight or the threshold is out of its range or not a number.
   * Cost: 14 multiply-adds a layer and joint, a square root and a division, four joints at once.
   */
  blend(skeleton: Skeleton | null, layers: List<BlendLayer> | null, out: List<SoaTransform> | null, threshold: number): Status;
  /**
   * Replaces a part of `pose`: goes from pose to layer.pose by w = weight · mask, on the shorter arc. Where w is 0 the
   * pose keeps its bits, where it is 1 it gets the layer's bits, whatever the other joints do.
   * Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
   */
  overlay(skeleton: Skeleton | null, layer: BlendLayer | null, pose: List<SoaTransform> | null): Status;
  /**
   * out = what turns `reference` into `pose`: differences of translations, pose · reference⁻¹ of rotations, ratios of
   * scales (1 where the reference is less than 1e-20). Rotations must be unit quaternions. Clips cooked as additive hold
   * their reference and yield changes by themselves: sample_additive(). Errors: bad_argument if a span is too short.
   */
  make_additive(skeleton: Skeleton | null, pose: List<SoaTransform> | null, reference: List<SoaTransform> | null, out: List<AdditiveTransform> | null): Status;
  /**
   * Lays w = weight · mask of a change on `pose`: translation + w Δ; rotation multiplied from the left by the normalised
   * mean of identity and change; scale · (1 + w (ratio - 1)). Where w is 0 the pose keeps its bits.
   * Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
   */
  add(skeleton: Skeleton | null, layer: AdditiveLayer | null, pose: List<SoaTransform> | null): Status;
  /**
   * The new clip's weight, `time_s` after the fade began: exactly 0 at or before 0 and for what is not a number, exactly
   * 1 from duration_s on (at once if that is not above 0).
   */
  fade_weight(shape: Fade, time_s: number, duration_s: number): number;
  /**
   * blend() of two poses: from at weight 0, to at weight 1, both bit for bit.
   * from, to, out: at least skeleton.soa_size(); out may be either of the poses.
   * Errors: bad_argument if a span is too short or the weight not in 0 … 1.
   */
  cross_fade(skeleton: Skeleton | null, from: List<SoaTransform> | null, to: List<SoaTransform> | null, weight: number, out: List<SoaTransform> | null): Status;
  /**
   * Captures the offset and its velocity; from then on only the new clip is sampled, and apply_inertia() gives what is
   * shown.
   *
   * Inertialisation: D. Bollo, GDC 2018. Each component is the quintic with the offset's value and velocity at the start,
   * and value, velocity, acceleration and jerk 0 at the end, in the factored form above. A component on its way to zero
   * that would pass it before duration_s ends sooner, 5 start / -velocity after the beginning, so no offset
   * changes its sign. Other than there, x, y and z are not reduced to a length on a fixed axis, so the whole velocity
   * is carried over and not only its part along the offset. The growth of a turn is limited so that it stays below a
   * whole one; a turn of more than a quarter in one frame is not carried over faithfully.
   * Rotations must be unit quaternions, translations and scales at most 1e15: then all is finite, here and below. To
   * begin anew in the middle of a transition, pass the poses that were shown. Errors: bad_argument if a span is too
   * short, or frame_s or duration_s is not above 0 and finite, or duration_s is above 1e6. Cost: two logarithms of
   * quaternions a joint, four joints at a time; no allocation.
   */
  begin_inertia(skeleton: Skeleton | null, start: InertialStart | null, duration_s: number, inertia: Inertia | null): Status;
  /**
   * pose: in, the new clip's pose `time_s` after the beginning; out, what is to be shown. From duration_s on, and before
   * any begin_inertia(), the pose keeps its bits. Times below 0 count as 0.
   * Errors: bad_argument if a span is too short or time_s not a number.
   * Cost: nine quintics and one exponential a joint, four joints at a time.
   */
  apply_inertia(skeleton: Skeleton | null, inertia: Inertia | null, time_s: number, pose: List<SoaTransform> | null): Status;
  /**
   * scene_from_joint = scene_from_root · Π parent_from_joint, from the root down; scene_from_root is what the source has
   * above the skeleton and never moves, so the matrices are in the source's scene space.
   *
   * local: at least skeleton.soa_size(); out: at least skeleton.joint_count; they do not overlap.
   * Errors: bad_argument if a span is too short.
   * Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint: 70 instructions on x86-64, 49
   * on AArch64. Thread-safe on different outputs.
   */
  local_to_model(skeleton: Skeleton | null, local: List<SoaTransform> | null, out: List<Affine> | null): Status;
  /**
   * The same for the first `joint_count` joints only, to the same bits: a level of detail. Joints are breadth-first, so
   * whatever the count, parents are among them. The others' matrices are left as they are.
   *
   * local: at least soa_count(joint_count); out: at least joint_count. Errors: bad_argument also if there are fewer
   * joints.
   */
  local_to_model_first(skeleton: Skeleton | null, local: List<SoaTransform> | null, joint_count: number, out: List<Affine> | null): Status;
  /**
   * The same for `joint` and all that hangs below it only, after a change of their local transforms: by inverse
   * kinematics, say. `out` holds the matrices of the whole skeleton; all others keep their bits.
   *
   * local: at least skeleton.soa_size(); out: at least skeleton.joint_count. Errors: bad_argument also if there is no
   * such joint. Cost: what local_to_model does for these joints, groups that a generation of them cuts as whole ones, and
   * one comparison for each other joint from `joint` to the last generation.
   */
  local_to_model_below(skeleton: Skeleton | null, local: List<SoaTransform> | null, joint: number, out: List<Affine> | null): Status;
  /**
   * Angles least_rad … most_rad; all of them if that is a turn or more.
   * Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
   */
  make_angle_range(least_rad: number, most_rad: number, out: AngleRange | null): Status;
  /**
   * `out` is written only on success.
   * Errors: bad_argument if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least is
   * above most, an angle is beyond ±2π, a swing not in 0 … kWidestSwing_rad or not symmetric, the second angle of an
   * euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is none of the above.
   */
  make_limit(description: LimitDescription | null, joint: number, out: JointLimit | null): Status;
  /**
   * local: in, a rotation x y z w; out, one inside the limit, in the same hemisphere and of unit length.
   *
   * What is inside, or outside by no more than kLimitTolerance_rad, keeps its bits, so a second call changes nothing.
   * What comes out is inside within the same tolerance.
   *
   * Outside it is the nearest rotation for a hinge; for a cone the nearest swing, and of the twists the nearest with it;
   * for euler boxes one round of exact searches along each angle from the clamped angles. docs/ik/limits.md has how near
   * that is. The nearest rotation jumps where one side of the range is as far as the other. So that the result moves
   * continuously, over the last quarter of the way from the limit to there it moves through the middle of the range: of a
   * turn about an axis to the angle opposite the middle, of a swing to 180°, where in its place the twist is lost; and of
   * euler angles to ±90° of the second, where the third and the first are one. Distances are as tangents of a quarter of
   * the angle. A range of all angles is a circle, to which nothing leads continuously: it jumps at a swing of 180°, and
   * an euler limit whose second angle reaches ±90° jumps there, by no more than twice what the rotation is outside.
   *
   * Errors: bad_argument if the rotation has no length or is not finite; nothing is written.
   * Cost: 5 to 15 products of quaternions and a few square roots, inside 3; no trigonometry. Thread-safe.
   */
  clamp_rotation(limit: JointLimit | null, local: View | number | null): Status;
  /**
   * By how many radians clamp_rotation() would turn the rotation; 0 for what keeps its bits, and for what it refuses.
   */
  limit_excess(limit: JointLimit | null, local: View | number | null): number;
  /**
   * clamp_rotation() for each limit's joint; all other joints keep their bits, and so do rotations that are not finite.
   * local: of a skeleton that has all the joints. Errors: bad_argument if it has not; nothing is written.
   * Cost: clamp_rotation() a limit. Thread-safe on different poses.
   */
  limit_pose(limits: List<JointLimit> | null, local: List<SoaTransform> | null): Status;
  /**
   * The limit of a joint, or null. Precondition: the limits' joints ascend, as in a Skeleton. Cost: a binary search.
   */
  find_limit(limits: List<JointLimit> | null, joint: number): JointLimit | null;
  /**
   * Moves `state` for dt_s towards a target that went straight from where it was in the last call to `target`; the result
   * is state.rotation or state.point.
   *
   * A follower that is on its target stays on it, to the bit, as long as the target keeps within the limits. Else it goes
   * the quickest way there that they allow, and brakes in time: towards a target at rest it neither passes it nor swings
   * about it, unless it is too fast already or comes from aside. Braking uses nine tenths of the acceleration; the last
   * part, of 0.9 acceleration / 120² s⁻², is approached as exp(-120 t / s). Without a limit of acceleration it goes with
   * the speed until it is there; without any limit it is on its target.
   * Rotations go the shorter way round, along the great circle if they come from rest. Where their target passes aside
   * they may exceed the acceleration by a few hundredths.
   *
   * The path is the same at any frame rate but for how its target is sampled: time goes in even steps of at most 1/960 s,
   * each with constant acceleration. At rates that divide 960 Hz paths to a target at rest agree to rounding, at others
   * from 15 to 240 Hz within the larger of 1e-4 rad (m) and 0.1 % of the way; moving targets: docs/ik/limits.md.
   *
   * dt_s of 0 changes nothing; what is above 0.25 s counts as 0.25 s, and less than a nanosecond as that. So all that a
   * follower keeps is finite.
   * Errors: bad_argument if a number is not finite, dt_s or a limit below 0, a limit from 1e18 on, a target from 1e15 m
   * on, the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a logarithm of a
   * quaternion; else a square root or two each step. No trigonometry of a library; the same bits everywhere. Thread-safe
   * on different states.
   */
  follow_rotation(state: RotationFollower | null, target: View | number | null, dt_s: number, limit: RateLimit | null): Status;
  /**
   * Moves `state` for dt_s towards a target that went straight from where it was in the last call to `target`; the result
   * is state.rotation or state.point.
   *
   * A follower that is on its target stays on it, to the bit, as long as the target keeps within the limits. Else it goes
   * the quickest way there that they allow, and brakes in time: towards a target at rest it neither passes it nor swings
   * about it, unless it is too fast already or comes from aside. Braking uses nine tenths of the acceleration; the last
   * part, of 0.9 acceleration / 120² s⁻², is approached as exp(-120 t / s). Without a limit of acceleration it goes with
   * the speed until it is there; without any limit it is on its target.
   * Rotations go the shorter way round, along the great circle if they come from rest. Where their target passes aside
   * they may exceed the acceleration by a few hundredths.
   *
   * The path is the same at any frame rate but for how its target is sampled: time goes in even steps of at most 1/960 s,
   * each with constant acceleration. At rates that divide 960 Hz paths to a target at rest agree to rounding, at others
   * from 15 to 240 Hz within the larger of 1e-4 rad (m) and 0.1 % of the way; moving targets: docs/ik/limits.md.
   *
   * dt_s of 0 changes nothing; what is above 0.25 s counts as 0.25 s, and less than a nanosecond as that. So all that a
   * follower keeps is finite.
   * Errors: bad_argument if a number is not finite, dt_s or a limit below 0, a limit from 1e18 on, a target from 1e15 m
   * on, the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a logarithm of a
   * quaternion; else a square root or two each step. No trigonometry of a library; the same bits everywhere. Thread-safe
   * on different states.
   */
  follow_point(state: PointFollower | null, target: View | number | null, dt_s: number, limit: RateLimit | null): Status;
  /**
   * follow_rotation() for the joints whose limit has a rate: in, the pose's rotations are the targets; out, what follows.
   * All others keep their bits. To stay inside the limits call limit_pose() before, for the targets, and after, for the
   * way there may lead outside.
   * states: one a limit. Errors: bad_argument if there are too few, a joint is beyond the pose, or dt_s is below 0 or not
   * finite; nothing is written. Joints whose rotation is not finite keep it.
   */
  follow_pose(limits: List<JointLimit> | null, states: List<RotationFollower> | null, dt_s: number, local: List<SoaTransform> | null): Status;
  /**
   * Method: the law of cosines in half-angles from lengths, (s - x)(s + x) and (x - m)(x + m), s and m the sum and the
   * difference of the lengths; then the shortest arc to the target and a turn about it, in one quaternion.
   * Of a bone of no length the rest is still done; nothing becomes infinite. A target at the start joint folds the limb.
   * The turns are about the axes of the matrices. Where a joint's own scale mirrors it, its turn's x changes sign if just
   * one of that scale's y and z is negative, y by z and x, z by x and y; the whole call does so.
   * Errors: bad_argument, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
   * large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
   * Cost: 400 instructions on x86-64, 326 on AArch64; about as much again where the limb is nearly straight or bent the
   * wrong way, the target more than 140° off or near the pole, or there is a twist.
   */
  turn_two_bone(joints: TwoBoneJoints | null, goal: TwoBone | null, out: TwoBoneTurns | null): Status;
  /**
   * Four limbs at once, to the same numbers, at 60 % of the instructions each. Fill up with copies.
   * Errors: as above, for all four if one is bad.
   */
  turn_two_bone_x4(joints: View | number | null, goals: View | number | null, out: View | number | null): Status;
  /**
   * The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
   * 0. reached: may be null; see TwoBoneTurns. Errors: as above, and bad_argument if a span is too short or the joints
   * are not a chain; nothing is written. Cost: the kernel's, and local_to_model_below(start).
   * Where the limb changes its shape as it turns, by uneven scale above it or of its start joint, it is bent by secants
   * and then turned: three to five times the cost, at most twelve. The target is met nevertheless; reached says if not.
   * May be null: reached.
   */
  solve_two_bone(skeleton: Skeleton | null, limb: TwoBoneLimb | null, goal: TwoBone | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, reached: View | number | null): Status;
  /**
   * Method: the point where the ray is as far from the joint as the target is turned onto it by the shortest arc and a
   * turn about it, in one quaternion.
   * Errors: bad_argument, and nothing is written, for numbers that are not finite (or too large to be squared), or a
   * weight outside 0 … 1.
   * Cost: 219 instructions on x86-64, 180 on AArch64.
   */
  turn_aim(joint: Affine | null, goal: Aim | null, out: AimTurn | null): Status;
  /**
   * The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
   * 0. reached: may be null. Errors: as above, and bad_argument if a span is too short or there is no such joint; nothing
   * is written. Cost: the kernel's, and local_to_model_below(joint).
   * May be null: reached.
   */
  solve_aim(skeleton: Skeleton | null, joint: number, goal: Aim | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, reached: View | number | null): Status;
  /**
   * The same for a chain that shares the turn, such as spine, neck and head: joints from the lowest up to the one that
   * looks, each below the one before it, whose forward, up and offset are meant; it does what the others leave.
   * falloff: each joint's share of the turn, of what the next one has; 1: all alike, 0: the last alone.
   * Errors: as above, and bad_argument if `joints` is empty or not a chain, or falloff not in 0 … 1.
   * May be null: reached.
   */
  solve_look_at(skeleton: Skeleton | null, joints: List<number> | null, goal: Aim | null, falloff: number, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, reached: View | number | null): Status;
  /**
   * Bytes of scratch memory that solve_ik needs; 0 of a problem without goals or joints that could be read.
   * May be null: options.
   */
  ik_scratch_bytes(skeleton: Skeleton | null, problem: IkProblem | null, options: IkOptions | null): number;
  /**
   * Turns the joints so that the goals are reached, or as nearly as may be, starting from the pose that is there.
   *
   * local: at least skeleton.soa_size(), parent_from_joint; changed: rotations of problem.joints, and the translation of
   * joints[0] if it may travel. scene_from_joint: at least skeleton.joint_count, of this pose (local_to_model); brought
   * up to date for what hangs below the joints that turn. scratch: at least ik_scratch_bytes(), of any alignment. report:
   * may be null.
   * A rotation in scene space is the product of the rotations from the root down; scale has no part in it.
   * Errors, and nothing is written: bad_argument if a span is too short, an index out of range, `joints` not ascending,
   * there are more than kMaxJoints goals, or a goal that no joint turns, a number not finite, a weight or a stiffness out
   * of range, or the pose not finite on the way to a goal.
   * Cost: docs/ik.md. Thread-safe on different poses and scratch.
   * May be null: options, report.
   */
  solve_ik(skeleton: Skeleton | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, problem: IkProblem | null, options: IkOptions | null, scratch: List<number> | null, report: IkReport | null): Status;
  /**
   * The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
   * memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
   * others.
   * May be null: options, report.
   */
  solve_ik_chain(skeleton: Skeleton | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, problem: IkProblem | null, options: IkOptions | null, scratch: List<number> | null, report: IkReport | null): Status;
  /**
   * The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
   * memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
   * others.
   * May be null: options, report.
   */
  solve_ik_body(skeleton: Skeleton | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, problem: IkProblem | null, options: IkOptions | null, scratch: List<number> | null, report: IkReport | null): Status;
  /**
   * The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
   * the result jumps as goals move. A function of its own, so that what does not call it does not link it.
   *
   * A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
   * the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
   * with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
   * keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
   * docs/ik.md: tens of microseconds a generation.
   */
  ik_genetic_scratch_bytes(skeleton: Skeleton | null, problem: IkProblem | null): number;
  /**
   * The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
   * the result jumps as goals move. A function of its own, so that what does not call it does not link it.
   *
   * A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
   * the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
   * with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
   * keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
   * docs/ik.md: tens of microseconds a generation.
   * May be null: options, report.
   */
  solve_ik_genetic(skeleton: Skeleton | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, problem: IkProblem | null, options: IkOptions | null, scratch: List<number> | null, report: IkReport | null): Status;
  /**
   * Where a ray for a foot is to go through: its sole as animated, in the world.
   * Errors: bad_argument if the span is too short, there is no such joint, or the place is not finite or beyond 1e6.
   */
  foot_sole(foot: Foot | null, world_from_scene: Affine | null, scene_from_joint: List<Affine> | null, sole_world: View | number | null): Status;
  /**
   * Places the feet: turns hips, knees and ankles, shifts the pelvis, and brings the matrices of what hangs below up to
   * date. Call it after local_to_model(), and cast the rays before it, from the same pose.
   *
   * local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count. ground, motion: one a foot.
   *
   * The sole's target is its animated place, lifted by the height of the ground's plane there; the foot leans with the
   * plane about its sole. What is planted keeps its place across `up`, and its heading; along `up` it moves as animated,
   * so that a heel can rise. A step in the ground (another plane than in the last frame), and on release the way to the
   * target, are an offset from the target that dies away as a critically damped spring at rest does, with the speed
   * that it had: exact whatever the frame rate, and without a jump in place or speed. The pelvis moves by the lowest
   * sole's ground, and as much further down as the legs need to reach. Ankles keep their animated attitude but for lean
   * and heading. See docs/ik/feet.md.
   *
   * Errors: bad_argument if a span is too short, joints are not as they should be, or a number is not finite, out of its
   * range or beyond 1e6; nothing is written.
   * Cost: local_to_model_below() of the pelvis, if that moves, of each hip and each ankle; one solve_two_bone() a foot,
   * up to three where joints are scaled unevenly: 6700 instructions a foot on x86-64, the skeleton having 27 joints. No
   * allocation; thread-safe on different motions and poses.
   */
  place_feet(skeleton: Skeleton | null, feet: Feet | null, frame: FeetFrame | null, ground: List<FootGround> | null, motion: List<FootMotion> | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null): Status;
  /**
   * What make_springs needs: 352 bytes for four bones, 272 a chain, 2 a joint of the skeleton; 0 without chains.
   */
  springs_bytes(skeleton: Skeleton | null, chains: List<SpringChain> | null): number;
  /**
   * Lays springs out in `memory`, which they use from then on, at rest in whatever pose comes first.
   *
   * memory: at least springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
   * Errors: bad_argument if a setting is out of its range, a joint is not in the skeleton or not below the one before it,
   * a chain has no bone, or the memory does not do; nothing is written.
   */
  make_springs(skeleton: Skeleton | null, chains: List<SpringChain> | null, memory: List<number> | null, out: Springs | null): Status;
  /**
   * New settings for the same joints, in the midst of motion. Errors: as make_springs, or not the same joints.
   */
  set_springs(skeleton: Skeleton | null, chains: List<SpringChain> | null, springs: Springs | null): Status;
  /**
   * The next frame begins at rest in its pose.
   */
  reset_springs(springs: Springs | null): void;
  /**
   * Moves the springs on by a frame and bends `local` by them; the matrices of what hangs below are brought up to date.
   *
   * local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count; local_to_model() has made
   * the one from the other. Springs never read what they have written: give them the animated pose of every frame.
   *
   * Model. A bone is a damped pendulum about its joint: for its direction d in the world, a unit vector of velocity u,
   *   du/dt = [ω² t + 2 ζ ω dt'/dt + (gravity - A) / L + drag (wind - V) / L] - (2 ζ ω + drag) u,
   * of which the part along d is borne by the bone, whose length L never changes. t is the animated direction, turned
   * with the bones above it as they swing; t' the same without what those do; V and A are velocity and acceleration of
   * the chain's first joint, from a parabola through its last three places. The first two terms together turn the bone no
   * harder than SpringJoint::most_pull, if that is set: a load that is more makes it yield. The pull ω² t is in
   * proportion to the sine of the angle: as much as a linear spring's for small ones, nothing at half a turn. A bone
   * feels those above it, they do not feel it; so of equal bones in a chain the lower swings 1 / (2 ζ) as far at the
   * common frequency, less than the upper from ζ = ½ on. A turn of the joint is the shortest that takes the bone there. A
   * chain below another's joint is carried by it, but does not feel its swing.
   *
   * Method. Equal steps of at most 1/60 s: kick, drift on a great circle, kick (Störmer-Verlet), half of the damping
   * before and half after. Drift and kicks have the strengths with which small swings have the exact frequency and decay,
   * whatever the step; so a path does not depend on the frame rate but for how the animation's frames cut its curves. The
   * energy |u|²/2 - F·d is held down to the work done, so that it never grows without input.
   * What hangs on a bone turns by the nearest rotation to its parent's that takes the one direction to the other, which
   * is a projection (P. Davenport's matrix; see G. Wahba, SIAM Review 7(3), 1965) and costs one product of matrix and
   * vector a joint.
   *
   * Scales that are not one scale, above a joint: directions are then approximate, lengths still kept. A bone shorter
   * than a micrometre stays as it is. A weight of 0 leaves the bits of a joint, and, all 0, those of the matrices.
   * Errors: bad_argument if a span is too short, the skeleton has another count of joints, a number is not finite or out
   * of its range, or there are more than kMaxSpringColliders; nothing is written.
   * Cost: at 60 frames/s 726 instructions a joint on x86-64; with colliders 110 more, and 110 for each. No allocation;
   * thread-safe on different springs and poses.
   */
  simulate_springs(skeleton: Skeleton | null, frame: SpringFrame | null, springs: Springs | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null): Status;
  /**
   * For each target of `mesh` the index of the channel of `clip` that drives its weight, or kNoChannel. The mesh is of
   * `file`, the clip of `clips`, the same or a clip pack. out: at least mesh.targets.size; errors: bad_argument. Cost:
   * compares names; once a load.
   */
  find_weight_channels(file: File | null, mesh: Mesh | null, clips: File | null, clip: Clip | null, out: List<number> | null): Status;
  /**
   * The weights of a moment: of each target its channel's value, or its default without. channels: from
   * find_weight_channels(); values: from sample_channels() of the same clip; empty spans: all defaults.
   * out: at least mesh.targets.size. Errors: bad_argument (`out` or `channels` too short, a channel outside the values).
   */
  morph_weights(mesh: Mesh | null, channels: List<number> | null, values: List<number> | null, out: List<number> | null): Status;
  /**
   * Bytes that make_morphed() needs; 0 for a geometry without targets, which is its own morphed geometry.
   */
  morphed_bytes(geometry: Geometry | null): number;
  /**
   * The bind pose. memory: at least morphed_bytes(), 16-byte aligned (bad_argument otherwise); `out` keeps pointers into
   * it and into `geometry`'s block. Cost: a copy of the vertices; once an instance.
   */
  make_morphed(geometry: Geometry | null, memory: List<number> | null, out: MorphedGeometry | null): Status;
  /**
   * Moves the vertices by `weights`, one a target; whatever they were moved by before is undone. Targets with weight 0
   * cost nothing. Errors: bad_argument (too few weights, or one that is not finite: nothing is written).
   * Cost: in proportion to the vertices (blocks of four) that targets with another weight move, and the call before
   * moved. Instructions a vertex, x86-64, g++ 12 -O3: 9 a target for positions, 15 with normals, 21 with tangents; and,
   * however many targets move it, 8, 20 or 29 to undo and normalise.
   */
  morph(weights: List<number> | null, morphed: MorphedGeometry | null): Status;
  /**
   * Brings animation-space coordinates up to date with the last morph(): q_j.xyz += (q_j)_w Δ and so Σ_j q_j += Δ, where
   * Δ is how far a vertex is from its bind pose. Δ goes through the blend that normals go through; as_coordinates() of
   * the morphed geometry is the same where no residual changes a weight.
   *
   * coordinates: as_coordinates() of the bind geometry, given to every call since. Errors: bad_argument (too short).
   * Cost: 60 instructions a vertex with four influences and a residual, of those written by morph() since the last call.
   */
  morph_coordinates(morphed: MorphedGeometry | null, coordinates: List<number> | null): Status;
  /**
   * For each parameter the index of the channel of `clip` that has its name, or kNoChannel. The space is of `file`, the
   * clip of `clips`, the same or a clip pack. out: at least space.parameters.size. Errors: bad_argument. Cost: compares
   * names; once a load.
   */
  find_example_channels(file: File | null, space: ExampleSpace | null, clips: File | null, clip: Clip | null, out: List<number> | null): Status;
  /**
   * Weights of the space's targets at a point of it; others are left as they are.
   *   weight_t(p) = linear_t · (1, p) + Σ_k radial_kt R(|p - place_k| · inverse_width_k)
   *   R(x) = 2/3 - x² + x³/2 below 1, (2 - x)³/6 below 2, 0 beyond: the cubic B-spline
   * At an example's place its own target has weight 1 and all others 0, but for rounding. Far from all examples weights
   * are linear: they leave 0 … 1, so clamp parameters where a shape must not be exaggerated.
   * parameters: finite, at least space.parameters.size; weights: one a target of the mesh. Errors: bad_argument (also for
   * a space by hand whose spans are too short, or with a target beyond the weights); bad_data if a weight is not finite:
   * nothing is written. The same bits on every processor.
   * Method: P.-P. Sloan, C. Rose, M. Cohen, "Shape by example", I3D 2001, section 3: cardinal functions.
   * Cost: instructions an example, each with a target of its own, x86-64, g++ 12 -O3: in spaces of 2 parameters 91 of 8
   * examples, 69 of 64; of 6 parameters 142 and 131. It grows with the examples that are near.
   */
  evaluate_examples(space: ExampleSpace | null, parameters: List<number> | null, weights: List<number> | null): Status;
  /**
   * A line from each joint's parent to the joint, and the joint's axes x, y, z in red, green, blue: `axis_m` long
   * whatever its scale; 0: none. scene_from_joint: at least skeleton.joint_count. At most 4 lines a joint.
   * Errors, of all that follow: bad_argument if a span is too short, a joint is not in the skeleton, or a length is below
   * 0 or not finite; nothing is appended.
   */
  joint_lines(skeleton: Skeleton | null, scene_from_joint: List<Affine> | null, axis_m: number, lines: DebugLines | null): Status;
  /**
   * What each limit lets the joint do, about the joint, `size_m` large. local: the pose that scene_from_joint is of.
   * A hinge: the arc along which its y moves. A cone: the rim along which its x moves at most, and four spokes. Euler
   * angles: three arcs in the colours of their axes, each with the other angles at the middle. Then where the joint is
   * now, in green inside the limit and red outside of it. Limits that is_valid() refuses are passed over. At most 51
   * lines a limit.
   */
  limit_lines(skeleton: Skeleton | null, limits: List<JointLimit> | null, local: List<SoaTransform> | null, scene_from_joint: List<Affine> | null, size_m: number, lines: DebugLines | null): Status;
  /**
   * A cross at each goal's position, or, where its rotation counts, the axes it asks for; and a line to it from the point
   * of the joint that is to be there. Green within `tolerance_m`, else red. At most 4 lines a goal.
   */
  goal_lines(skeleton: Skeleton | null, goals: List<IkGoal> | null, scene_from_joint: List<Affine> | null, size_m: number, tolerance_m: number, lines: DebugLines | null): Status;
  /**
   * The bones of each chain, and its tip. scene_from_joint: after simulate_springs(). At most a line a joint.
   */
  spring_lines(skeleton: Skeleton | null, chains: List<SpringChain> | null, scene_from_joint: List<Affine> | null, lines: DebugLines | null): Status;
  /**
   * Each collider as great circles about its ends, and lines between them: 48 lines a sphere, 100 a capsule.
   */
  collider_lines(skeleton: Skeleton | null, colliders: List<SpringCollider> | null, scene_from_joint: List<Affine> | null, lines: DebugLines | null): Status;
  /**
   * The box's edges and the sphere's three great circles: 60 lines; none if it is empty.
   */
  bounds_lines(bounds: Bounds | null, lines: DebugLines | null): Status;
  /**
   * out[i] = scene_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
   *
   * joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path brings its own
   * bind that also undoes quantisation). out: at least as many and one a helper. Every joint must be below
   * scene_from_joint.size, what helpers name below joints.size and not the same.
   * Errors: bad_argument if a span is too short, a joint out of range or a share not between 0 and 1.
   *
   * helpers: written behind the joints' entries: entry joints.size + h blends the entries `first` and `second`, the
   * latter at `share`. Of either entry's matrix, a stretch and then a turn, the turns are blended as quaternions, the
   * shorter way, and the stretches linearly. Where the origin of the joint `second` goes is what dual quaternions make of
   * where both take it (L. Kavan et al., Geometric skinning with approximate dual quaternion blending, 2008). Between a
   * joint and its parent that is a turn about the joint. centres: none, or three numbers a helper: a place, as the joint
   * `second` sees it, that goes to the mean, by shares, of where both take it (B. Le, J. Hodgins, Real-time skeletal
   * skinning with optimized centers of rotation, 2016). Half a turn goes round the axis that points to the positive side
   * along the largest of its components. Where an entry mirrors, its stretch does. Where one has lost its volume, or is
   * not finite, the two are blended as numbers.
   *
   * The same palette serves SSD and animation space (docs/decisions.md, "One palette").
   * Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64; a helper 198 on x86-64, about a
   * centre 248. Four helpers share their work: where one of them has entries whose stretches differ, all four cost 385.
   * Thread-safe on different outputs; out overlaps none of the inputs.
   */
  build_palette_of_joints(joints: List<number> | null, bind: List<Affine> | null, scene_from_joint: List<Affine> | null, out: List<Affine> | null, helpers: List<Helper> | null, centres: List<number> | null): Status;
  /**
   * The palette of a mesh.
   */
  build_palette(mesh: Mesh | null, scene_from_joint: List<Affine> | null, out: List<Affine> | null): Status;
  /**
   * Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
   * are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
   * not finite do not.
   */
  turns_inside_out(map: Affine | null): boolean;
  /**
   * The same of what follows a palette: whether more of its matrices mirror than not. For culling of meshes that are not
   * double_sided; a game whose characters are never mirrored, nor hung on what is, need not ask. An instance of a crowd
   * turns if either this or its scene_from_character does, not if both do: see gles3_crowd.h. Cost: a determinant a
   * matrix.
   */
  palette_turns_inside_out(palette: List<Affine> | null): boolean;
  /**
   * Bytes that make_reach() needs: 24 a palette entry and 24 a morph target, up to a multiple of 16.
   */
  reach_bytes(mesh: Mesh | null): number;
  /**
   * Looks at every vertex once. The result serves all characters with this mesh, at any level of detail whose vertices
   * are among those of `mesh`.
   *
   * mesh: of a file, not of a character whose vertices are morphed. memory: at least reach_bytes(), 16-byte aligned;
   * `out` keeps pointers into it. Errors: bad_argument (the memory). Cost: once a load.
   */
  make_reach(mesh: Mesh | null, memory: List<number> | null, out: Reach | null): Status;
  /**
   * The box of the mesh and a sphere about the box's centre, in the palette's space.
   *
   * palette: of the mesh, reach.joints.size entries. weights: of its morph targets, any finite numbers; empty: none is
   * active. Without a vertex `out` is empty (Bounds::is_empty()). Errors: bad_argument (a span too short, a weight that
   * is not finite); `out` is not written. Method: the box of a transformed box is its centre, transformed, and its half
   * sides through the absolute values of the matrix (J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems,
   * 1990); a union of those. The sphere's radius is the distance to the farthest corner of any of them. Cost: 119
   * instructions a palette entry, x86-64, in two passes. No allocation, thread-safe.
   */
  palette_bounds(reach: Reach | null, palette: List<Affine> | null, weights: List<number> | null, out: Bounds | null): Status;
  /**
   * Each vertex follows the joint with its largest weight.
   *   position = M_j (v, 1)
   * palette: mesh.palette_size() entries. Errors, here and below: bad_argument if a span is too short, if the geometry
   * follows more entries than the mesh has, and so is another one's, if normals or tangents are asked of a mesh without,
   * or if the geometry's floats do not stand on 16-byte boundaries.
   * Cost: positions 50 / 32; with exact normals 78 / 49.
   */
  skin_rigid(mesh: Mesh | null, palette: List<Affine> | null, out: SkinOutput | null): Status;
  /**
   * Skeletal subspace deformation, also called linear blend skinning.
   *   position = (Σ_j w_j M_j) (v, 1)
   * Cost: positions 38 / 29; with normals through the blended matrix 47 / 34, and tangents 59 / 42; through the inverse
   * transpose 66 / 47 and 83 / 56. That is 12 multiply-adds an influence but the last, 9 for the position, 9 for a normal
   * or tangent through the matrix, 27 multiplications and a square root and a division for a normal through its inverse
   * transpose.
   */
  skin_ssd(mesh: Mesh | null, palette: List<Affine> | null, out: SkinOutput | null): Status;
  /**
   * How many floats as_coordinates() writes: 3 a slot, and 4 for each influence but the last.
   */
  as_coordinate_count(geometry: Geometry | null): number;
  /**
   * Animation-space coordinates of every slot, from lift and residual: q_j = (w_j v + d_j, w_j + δ_j), Σ_j (q_j)_w = 1.
   * In the notation of Merry, Marais and Gain (ACM TOG 25(4), 2006) p_j = B_j⁻¹ q_j; B_j⁻¹ stands in the palette here.
   *
   * As with the weights of SSD, the last influence is what the others leave: a block holds the sum Σ_j q_j as
   * x[4] y[4] z[4] (its w is 1), then x[4] y[4] z[4] w[4] of each q_j but the last.
   * out: as_coordinate_count() floats. Done once a mesh, not a frame.
   */
  as_coordinates(geometry: Geometry | null, out: List<number> | null): Status;
  /**
   * How many floats as_tangents() writes of a mesh: twice as_coordinate_count().
   */
  as_tangent_count(geometry: Geometry | null): number;
  /**
   * Bytes of scratch memory that as_tangents() wants: about 32 a slot and 4 an index.
   */
  as_tangent_scratch_bytes(parts: List<AsPart> | null): number;
  /**
   * Two tangents of the surface at every slot as animation-space vectors, as in Merry, Marais and Gain:
   *   t = Σ_k c_k (p_k - p) over the vertex's neighbours k, so t = Σ_j M_j τ_j with τ_j = Σ_k c_k (q_kj - q_j),
   *   Σ_j (τ_j)_w = 0
   * They are derivatives along two directions, means over the triangles weighed by area; in the bind pose, where
   * residuals leave that in place, perpendicular unit vectors with t₀ × t₁ the mesh's normal, t₀ along its tangent if it
   * has one. What the triangles do not explain of them goes through the blend: all, if they have no area. An entry
   * that a neighbour follows and the vertex does not counts as the sum of the vertex's own that blends the same joints at
   * the same shares, or comes closest; joints that none of those blends count as that which the neighbour follows most.
   *
   * parts: the meshes that make up a surface, such as the primitives of one mesh of the source; slots in one place with
   * the same weights and normals less than 25° apart, in whichever part, are one vertex, so that seams do not show.
   * scratch: as_tangent_scratch_bytes(), on a 4-byte boundary, free again afterwards. Errors: bad_argument if a mesh has
   * no normals or a span is too short. Done once, not a frame: some 11 000 instructions a vertex, beside helpers 23 000.
   */
  as_tangents(parts: List<AsPart> | null, scratch: List<number> | null): Status;
  /**
   * Animation space.
   *   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
   *            = M_last Σ_j q_j + Σ_{j<last} (M_j - M_last) q_j
   * Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
   * coordinates: from as_coordinates() of this geometry.
   * Cost: positions 40 / 31; with normals through the blended matrix 73 / 56, and tangents 85 / 62; through the inverse
   * transpose 92 / 69 and 108 / 77. That is 12 multiply-adds an influence but the last and 9 for the sum; with normals 9
   * more an influence but the last.
   *
   * tangents: from as_tangents() of this geometry, or empty. With them normals are the deformed surface's own,
   * t₀' × t₁' with t' = Σ_j M_j τ_j, and tangents t₀', unit, whatever out.normal_transform says; turned round where the
   * run's last joint mirrors. They know nothing of morph targets. Cost, x86-64: 140, and with tangents 151.
   */
  skin_as(mesh: Mesh | null, coordinates: List<number> | null, palette: List<Affine> | null, out: SkinOutput | null, tangents: List<number> | null): Status;
  /**
   * Multi-weight enveloping: Wang and Phillips, "Multi-weight enveloping: least-squares approximation techniques for skin
   * animation", SCA 2002. Twelve weights an influence, one for each element of its matrix:
   *   position = R Σ_j (Ω_j ∘ R⁻¹ M_j) (v, 1)        Ω_j = w_j + Geometry::mwe_residual, ∘ element by element
   * Elements mean something in one frame only; R is that of the palette entry Geometry::mwe_root: the rotation next to
   * its matrix's first two columns (Gram and Schmidt) and its translation. So the result moves with the character.
   * Normals and tangents go through the 3×3 part of the blend, R Σ_j Ω_j ∘ R⁻¹ M_j, which is SSD's where the residual is
   * zero. With blended_matrix it is that blend that is asked whether it mirrors.
   *
   * Errors: also bad_argument for a geometry without mwe_residual. Cost, x86-64: positions 82; with normals through the
   * blended matrix 110, through the inverse transpose 127. It reads 192 bytes of residual a block and influence, so with
   * four influences nine times as much as SSD.
   */
  skin_mwe(mesh: Mesh | null, palette: List<Affine> | null, out: SkinOutput | null): Status;
  /**
   * How many floats psd_distances() writes: one for each palette entry and example, and one more an entry; 0 without
   * examples.
   */
  psd_distance_count(geometry: Geometry | null): number;
  /**
   * How far a pose is from the examples, joint by joint: what skin_psd() weighs a vertex. Of palette entry j and example
   * k, D_jk = 1 - (q_j · q_jk)² = sin²(half the angle between), with q_j the rotation of M_j relative to its parent's,
   * rotations as in skin_mwe(); 0 for an entry without a parent.
   * out, for each palette entry: -D_jk / 2σ² for each k, then the same of the bind pose. Once a mesh and frame. Errors:
   * bad_argument if a span is too short.
   * Cost: 34 instructions a palette entry and example, x86-64.
   */
  psd_distances(geometry: Geometry | null, palette: List<Affine> | null, out: List<number> | null): Status;
  /**
   * Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000, with distances
   * weighted a vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
   *   position = (Σ_j w_j M_j) (v + (1 - φ_bind) Σ_k φ_k d_k, 1)        d_k: Geometry::pose_space
   *   φ_k = exp(-Σ_j w_j D_jk / 2σ²)
   * where the factor makes nothing of the bind pose. Normals and tangents go through the blend, as SSD's.
   * distances: from psd_distances() of this geometry and palette. Errors: also bad_argument if they are too few. A
   * geometry without examples is SSD's.
   * Cost, x86-64: positions 49, with normals through the blended matrix 61, through the inverse transpose 74; and 30 a
   * vertex for each example that moves its block.
   */
  skin_psd(mesh: Mesh | null, distances: List<number> | null, palette: List<Affine> | null, out: SkinOutput | null): Status;
  /**
   * Bytes that make_animations() needs: for each clip an Animation, 4 a skeleton and 4 a morph target. A multiple of 16.
   */
  animations_bytes(file: File | null, clips: File | null): number;
  /**
   * Makes animations of clips of `file`, the character's, or of a clip pack. A pack's reference goes with the skeleton of
   * its name if it fits that, else with the first that it fits and no reference before it has; see bind_clips(). If it
   * fits none, its clips are left out: no skeleton plays them.
   *
   * memory: at least animations_bytes(), 16-byte aligned; `out` keeps pointers into it and into both files' blocks.
   * Errors: bad_argument (the memory); mismatch (`clips` is another file but no pack, or a pack none of whose clips fits
   * a skeleton). Cost: compares names; once a load.
   */
  make_animations(file: File | null, clips: File | null, memory: List<number> | null, out: Animations | null): Status;
  /**
   * The first with this name that moves anything; null if there is none. Cost: compares names.
   */
  find_animation(animations: Animations | null, name: string | null): Animation | null;
  /**
   * Bytes that make_character() needs: a multiple of 16, so that the blocks of a crowd may stand back to back.
   * May be null: options.
   */
  character_bytes(file: File | null, options: CharacterOptions | null): number;
  /**
   * A character in its rest pose, finished.
   *
   * `file`'s block must outlive it. memory: at least character_bytes(), 16-byte aligned.
   * Errors: bad_argument (the memory, no layers, a default weight that is not finite). Cost: a copy of the vertices of
   * meshes with morph targets, and as_coordinates().
   * May be null: options.
   */
  make_character(file: File | null, options: CharacterOptions | null, memory: List<number> | null, out: Character | null): Status;
  /**
   * Samples and blends: local poses of all skeletons and weights of all morph targets become means of the layers, as
   * blend() has it; without layers all rest. A clip that is cooked as additive counts as its changes laid on their
   * reference.
   *
   * Errors: bad_argument (more layers than the options say, an animation that is null or not made for this file, a weight
   * out of range, a time that is not a number); a part of the character may have been written then.
   * Cost: sample() and blend() of each skeleton, sample_channels() of what drives morph targets.
   */
  sample_character(character: Character | null, layers: List<AnimationLayer> | null): Status;
  /**
   * Brings scene_from_joint of all skeletons up to date with `local`.
   */
  character_to_model(character: Character | null): Status;
  /**
   * Both: poses that inverse kinematics, feet and springs can go on with. Errors: as sample_character().
   */
  pose_character(character: Character | null, layers: List<AnimationLayer> | null): Status;
  /**
   * Adds an expression of a face or its like to the weights of morph targets, as often as there are expressions: what the
   * animation makes of them less what they are by default, times `weight`. A weight that no channel drives keeps its
   * bits, and so do poses. Between pose_character() and finish_character().
   *
   * Errors: bad_argument (an animation that is null or not made for this file, a weight out of range, a time that is not
   * a number); nothing is written. Cost: sample_channels() of what drives morph targets.
   */
  add_expression(character: Character | null, expression: AnimationLayer | null): Status;
  /**
   * Palettes from scene_from_joint, and vertices morphed by `weights`; nothing without `skin`.
   * Errors: bad_argument (a weight that is not finite). Cost: build_palette(), morph() and morph_coordinates() of each
   * mesh.
   */
  finish_character(character: Character | null): Status;
  /**
   * Bytes that make_outfit() needs: 24 a skeleton and 2 a joint, on boundaries of 16. A multiple of 16.
   */
  outfit_bytes(outfit: File | null): number;
  /**
   * Finds for each skeleton of an outfit the one of the body that it follows: of its name if it fits that, else the first
   * that it fits. An outfit is cooked with `--skeleton BODY`; outfit.h says when it fits.
   *
   * memory: at least outfit_bytes(), 16-byte aligned; `out` keeps pointers into it. Several outfits may follow one body.
   * Errors: bad_argument (the memory); mismatch if a skeleton fits none, and bind_outfit() says which joints are in the
   * way. Cost: compares names; once a load.
   */
  make_outfit(body: File | null, outfit: File | null, memory: List<number> | null, out: Outfit | null): Status;
  /**
   * Brings scene_from_joint of an outfit's skeletons to the body's pose: call it when the body is posed, and then
   * finish_character(). Joints that only the outfit has stand at its `local`, which the outfit keeps from frame to frame.
   * So where its clips or springs move them, a frame is
   *
   *   sample_character(outfit, …); follow_body(…); springs; finish_character(outfit)
   *
   * where sample_character without layers puts them back to rest. `local` of joints of the body is neither read nor
   * written. Morph targets are the outfit's own: its clips move them, or the game writes CharacterMesh::weights.
   *
   * worn: made from the outfit's file. Errors: bad_argument if `outfit` was made for other files. Cost: follow_body() of
   * outfit.h for each skeleton.
   */
  character_follow_body(outfit: Outfit | null, body: Character | null, worn: Character | null): Status;
  /**
   * Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader.
   * Errors: bad_argument without a loader; unsupported if it returns null for a function of OpenGL ES 3.0, whose name is
   * put in `missing` (static string). Those of 3.1 stay null where there are none. `api` is written only on success.
   *
   * ObjectLabel is there with GL_KHR_debug or OpenGL ES 3.2. Then GL objects are labelled as they are made, for RenderDoc
   * and drivers' tools ("newt: surface"); set to null, they are not. GetGraphicsResetStatus is there with
   * GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
   * May be null: missing.
   */
  gles3_load_api(api: Gles3Api | null, load_proc: View | number | null, missing: View | number | null): Status;
  /**
   * Whether the graphics processor was reset and the context is lost with all that is in it: to be asked once a frame.
   * Then call on_context_lost() for each object that has it, destroy the context, make another, and call
   * on_context_restored(). True only where GetGraphicsResetStatus is there and the context was created to lose itself on
   * a reset (EGL_LOSE_CONTEXT_ON_RESET, as marrow::egl::HeadlessContext asks for); other contexts never tell, and
   * platforms have ways of their own (EGL_CONTEXT_LOST of eglSwapBuffers). GL may tell each reset only once.
   */
  gles3_context_was_reset(api: Gles3Api | null): boolean;
  /**
   * Has every GL error reported that a call through `api` or a copy of it causes, with the call's name, to a watch that
   * lives as long as they; null: no more. Results stay what they are, as GetError still tells each check of an error. For
   * debugging: without a watch a call costs a comparison more, with one two calls of glGetError.
   * May be null: watch.
   */
  gles3_watch_errors(api: Gles3Api | null, watch: Gles3ErrorWatch | null): void;
  /**
   * Errors: unsupported below OpenGL ES 3.0; gl_error.
   */
  gles3_query_caps(api: Gles3Api | null, caps: Gles3Caps | null): Status;
  /**
   * Bytes of scratch memory that prepare() wants: the largest of its vertex buffers, with `psd` and all changes.
   * May be null: options.
   */
  gles3_prepare_scratch_bytes(mesh: Mesh | null, options: Gles3PrepareOptions | null): number;
  /**
   * Uploads a mesh, and writes the bind matrices to build its palettes with:
   *   bind[i] = inverse_bind[i] · [h·I | c]
   * c is the middle of the bind box, h one half-extent for all axes: attributes hold (v - c) / h in [-1, 1]³ and the
   * shader need not undo it. The same palette serves rigid, SSD and AS. In animation space the stored coordinate of an
   * influence is (w (v - c) + d - δ c, (w + δ) h) / h; where residuals need more room, h grows for the whole mesh.
   *
   * bind: at least mesh.joint_count, the caller's to keep. scratch: at least prepare_scratch_bytes(), 4-byte aligned,
   * free again afterwards. Errors: bad_argument (a mesh without vertices or with another one's geometry, a span too
   * short); unsupported (more morph targets or examples than a texture of 2048 × 2048 holds); gl_error (out of memory:
   * nothing is left allocated). `out` and `bind` are written only on success. Leaves GL_ARRAY_BUFFER, the vertex array
   * and, of a mesh with morph targets or, with `psd`, examples, the active unit's 2D texture at 0. Error of the formats:
   * docs/performance.md. Cost: a few passes over the vertices; once a mesh.
   * May be null: options.
   */
  gles3_prepare(api: Gles3Api | null, caps: Gles3Caps | null, mesh: Mesh | null, options: Gles3PrepareOptions | null, scratch: List<number> | null, bind: List<Affine> | null, out: Gles3GpuMesh | null): Status;
  /**
   * Deletes the GL objects and clears the struct.
   */
  gles3_destroy_mesh(api: Gles3Api | null, mesh: Gles3GpuMesh | null): void;
  /**
   * Compiles and links; the palette block is tied to uniform buffer binding `palette_binding`, with kMotion that of the
   * frame before to the next binding.
   * Errors: bad_argument (a text missing, influences other than 4 to 8, what crowds cannot); gl_error, with the driver's
   * words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a frame.
   */
  gles3_build_program(api: Gles3Api | null, key: Gles3ProgramKey | null, source: Gles3ProgramSource | null, palette_binding: number, out: Gles3Program | null, log: List<number> | null): Status;
  /**
   * Deletes the program and clears the struct.
   */
  gles3_destroy_program(api: Gles3Api | null, program: Gles3Program | null): void;
  /**
   * Room for palettes of `joints` matrices altogether in `palettes` pieces.
   * Errors: bad_argument (zero); unsupported (caps of less than OpenGL ES 3.0); gl_error. Leaves GL_UNIFORM_BUFFER at 0.
   */
  gles3_create_palette_ring(api: Gles3Api | null, caps: Gles3Caps | null, joints: number, palettes: number, out: Gles3PaletteRing | null): Status;
  /**
   * Deletes the buffer and clears the struct.
   */
  gles3_destroy_palette_ring(api: Gles3Api | null, ring: Gles3PaletteRing | null): void;
  /**
   * Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
   */
  gles3_begin_frame(api: Gles3Api | null, ring: Gles3PaletteRing | null): void;
  /**
   * Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
   * ring. Errors: bad_argument (empty, or more than kPaletteJoints); unsupported (the ring is full until begin_frame).
   */
  gles3_push_palette(api: Gles3Api | null, ring: Gles3PaletteRing | null, palette: List<Affine> | null, offset: View | number | null): Status;
  /**
   * Ties the palette at `offset` to uniform buffer binding `binding`.
   */
  gles3_bind_palette(api: Gles3Api | null, ring: Gles3PaletteRing | null, offset: number, binding: number): void;
  /**
   * Room for `joints` matrices: 48 B each, three times.
   * Errors: bad_argument (zero); unsupported (more than a texture of the caps' size holds: 1.39 million in 2048²);
   * gl_error. Leaves the active unit's 2D texture at 0.
   */
  gles3_create_palette_texture(api: Gles3Api | null, caps: Gles3Caps | null, joints: number, out: Gles3PaletteTexture | null): Status;
  /**
   * Deletes the textures and clears the struct.
   */
  gles3_destroy_palette_texture(api: Gles3Api | null, texture: Gles3PaletteTexture | null): void;
  /**
   * Once a frame, all palettes: whole ones after each other, those of one mesh's instances together, and build_palette()
   * may write right there. 48 bytes a matrix go up, and nothing else. Errors: bad_argument (empty); unsupported (more
   * than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0.
   */
  gles3_upload_palettes(api: Gles3Api | null, texture: Gles3PaletteTexture | null, palettes: List<Affine> | null): Status;
  /**
   * `program`, which must be in use and read palettes from a texture, draws with the palette that begins at matrix
   * `first` of what was uploaded, its instance i with the one `joints` · i behind it. Leaves `texture_unit` active and
   * the texture bound to it. Errors: bad_argument (a program of another kind, a palette that reaches beyond what was
   * uploaded).
   */
  gles3_bind_texture_palette(api: Gles3Api | null, texture: Gles3PaletteTexture | null, first: number, joints: number, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * The palettes of the frame before, which are there still, for a program with kMotion that draws from bind_palette() of
   * the same arguments. kept: false for characters without a frame before; their palettes of this frame are bound then,
   * and nothing moves. Leaves `texture_unit` active and the texture bound to it; nothing is bound for a program whose
   * text does not read previous_position. Errors: bad_argument (a program of another kind, a palette that reaches beyond
   * what was uploaded then).
   */
  gles3_bind_previous_palette(api: Gles3Api | null, texture: Gles3PaletteTexture | null, first: number, joints: number, kept: boolean, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * Sets by which weights, one a target, `program`, which must be in use, morphs: as morph() does on the CPU, in
   * animation space through the same blend as normals. Of more than kMorphTargets weights other than 0 those count that
   * move most. Leaves `texture_unit` active and the mesh's texture bound to it. Errors: bad_argument (a mesh without
   * targets, a program without kMorphs, too few weights, one that is not finite).
   */
  gles3_set_morphs(api: Gles3Api | null, mesh: Mesh | null, gpu: Gles3GpuMesh | null, weights: List<number> | null, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * The weights of the frame before, for a program with kMotion, after set_morphs(). Errors: as there.
   */
  gles3_set_previous_morphs(api: Gles3Api | null, mesh: Mesh | null, gpu: Gles3GpuMesh | null, weights: List<number> | null, program: Gles3Program | null): Status;
  /**
   * Room that pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and four
   * examples. 0 without examples.
   */
  gles3_distance_matrices(geometry: Geometry | null): number;
  /**
   * How far a pose is from the examples, as Deformer::psd reads it: psd_distances() in another order. It goes up with
   * those of other characters as palettes do, by upload_palettes() into a PaletteTexture of its own, on every path.
   * palette: built with the bind matrices of prepare(), or those of the mesh; no matter which. out: distance_matrices().
   * Errors: bad_argument (no examples, a span too short). Cost: that of psd_distances().
   */
  gles3_pack_distances(geometry: Geometry | null, palette: List<Affine> | null, out: List<Affine> | null): Status;
  /**
   * `program`, which must be in use and of Deformer::psd, deforms by the mesh's examples and by distances that begin at
   * matrix `first` of what was uploaded, its instance i by those GpuMesh::distances · i behind. Leaves `texture_unit` and
   * the next one taken, the latter active. Errors: bad_argument (a mesh without examples, a program of another kind,
   * distances that reach beyond what was uploaded).
   */
  gles3_bind_examples(api: Gles3Api | null, mesh: Gles3GpuMesh | null, distances: Gles3PaletteTexture | null, first: number, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * The distances of the frame before, for a program with kMotion, after bind_examples(). kept and errors: as in
   * bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
   */
  gles3_bind_previous_distances(api: Gles3Api | null, mesh: Gles3GpuMesh | null, distances: Gles3PaletteTexture | null, first: number, kept: boolean, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * Draws all triangles, of as many characters as there are instances: more than one with palettes in a texture alone.
   * `program` must be in use, its palette bound. Leaves the vertex array at 0. Which sides are drawn is the game's to
   * say: as glTF has it, GL_CULL_FACE is enabled unless Mesh::double_sided, and fronts are GL_CCW, but GL_CW where
   * turns_inside_out() of the palette, see palette.h. So characters that mirror take a draw call of their own.
   * Errors: bad_argument if the mesh was not prepared for this deformer.
   */
  gles3_draw_mesh(api: Gles3Api | null, mesh: Gles3GpuMesh | null, deformer: Gles3Deformer, program: Gles3Program | null, instances: number): Status;
  /**
   * Errors: gl_error (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER and the vertex
   * array at 0.
   */
  gles3_create_skinned(api: Gles3Api | null, mesh: Gles3GpuMesh | null, out: Gles3SkinnedMesh | null): Status;
  /**
   * Deletes the GL objects and clears the struct.
   */
  gles3_destroy_skinned(api: Gles3Api | null, mesh: Gles3SkinnedMesh | null): void;
  /**
   * What skin_ssd() and their like have written. The old contents are orphaned, so the CPU never waits for the GPU.
   * Errors: bad_argument (a span of another size than the mesh has; normals or tangents may be empty, then they are
   * undefined). Leaves GL_ARRAY_BUFFER at 0.
   */
  gles3_upload_skinned(api: Gles3Api | null, mesh: Gles3SkinnedMesh | null, vertices: SkinOutput | null): Status;
  /**
   * A program for preskin(), of the key's deformer, palettes, and of its features kNormals, kTangents, kMorphs and
   * kSurfaceNormals. Those must be the mesh's.
   * Errors: bad_argument (a key of Deformer::none, of a crowd, or with influences other than 4 to 8); unsupported
   * (compute, without caps.compute); gl_error, with the driver's words in `log`. `out` is written only on success. Cost:
   * a compile.
   */
  gles3_build_preskin(api: Gles3Api | null, caps: Gles3Caps | null, key: Gles3ProgramKey | null, method: Gles3Preskin, palette_binding: number, out: Gles3Program | null, log: List<number> | null): Status;
  /**
   * Skins every slot once into `to`, with the palette that is bound. `program` must be in use. By transform feedback it
   * leaves the vertex array, the default transform feedback object's bindings 0 … 2 and GL_TRANSFORM_FEEDBACK_BUFFER at
   * 0, and GL_RASTERIZER_DISCARD off; by compute shader GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3 at 0.
   * Errors: bad_argument (a mesh that was not prepared for this deformer, a program of another kind).
   */
  gles3_preskin_mesh(api: Gles3Api | null, mesh: Gles3GpuMesh | null, deformer: Gles3Deformer, program: Gles3Program | null, to: Gles3SkinnedMesh | null): Status;
  /**
   * Programs with kMotion take from `previous` where the vertices of `mesh` were in the frame before: another SkinnedMesh
   * of the same GpuMesh, skinned then; or `mesh` itself, of what has no frame before. To be said again whenever it
   * changes, so each frame where two take turns. Errors: bad_argument (of another number of slots). Leaves
   * GL_ARRAY_BUFFER and the vertex array at 0.
   */
  gles3_set_previous(api: Gles3Api | null, mesh: Gles3SkinnedMesh | null, previous: Gles3SkinnedMesh | null): Status;
  /**
   * Draws all triangles with the program in use, one with Deformer::none. Leaves the vertex array at 0.
   */
  gles3_draw_skinned(api: Gles3Api | null, mesh: Gles3GpuMesh | null, skinned: Gles3SkinnedMesh | null): void;
  /**
   * "ubo", …
   */
  gles3_skinning_path_text(path: Gles3SkinningPath): string;
  /**
   * Deletes all programs. Skinners that use the set must go first.
   */
  gles3_destroy_programs(api: Gles3Api | null, programs: Gles3ProgramSet | null): void;
  /**
   * Bytes of memory that create_skinner() wants.
   */
  gles3_skinner_bytes(mesh: Mesh | null, options: Gles3SkinnerOptions | null): number;
  /**
   * Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: pose() each
   * before the first update(). Compiles what `programs` lacks for it.
   *
   * mesh: its geometry must live as long as the skinner, so that it can be put on the next context. memory: at least
   * skinner_bytes(), 16-byte aligned, the skinner's until destroy().
   * Errors: bad_argument (a span too short, no instances, Deformer::none, no role); unsupported (a path that the caps or
   * the number of joints rule out, a full program set); gl_error (nothing is left allocated but programs). `out` is
   * written only on success.
   */
  gles3_create_skinner(api: Gles3Api | null, caps: Gles3Caps | null, mesh: Mesh | null, options: Gles3SkinnerOptions | null, programs: Gles3ProgramSet | null, memory: List<number> | null, out: Gles3Skinner | null): Status;
  /**
   * Deletes the GL objects and clears the struct; the memory is the caller's again.
   */
  gles3_destroy_skinner(api: Gles3Api | null, skinner: Gles3Skinner | null): void;
  /**
   * Character `instance` takes this pose at the next update(). weights: one a morph target. Calls no GL: may run on
   * another thread than the context's, different instances on different threads.
   * Errors: bad_argument (no such instance, a span too short, a skinner that was destroyed).
   */
  gles3_pose(skinner: Gles3Skinner | null, instance: number, scene_from_joint: List<Affine> | null, weights: List<number> | null): Status;
  /**
   * Of a skinner with options.motion: to the next update() the character has no frame before, so its vertices do not
   * move: for one that appears, or is put elsewhere at once. Characters that the update() before left out have none
   * anyway. May be called where pose() may. Errors: bad_argument (no such instance, a skinner without motion or that was
   * destroyed).
   */
  gles3_reset_motion(skinner: Gles3Skinner | null, instance: number): Status;
  /**
   * Once a frame, after posing: sends up the palettes of characters 0 … count - 1, or skins them. 48 bytes a joint go up
   * and nothing else, with a pose space 16 more for every four examples, of which the bind pose is one; on path cpu the
   * vertices.
   * Errors: bad_argument (more than there are, a weight that is not finite, a skinner that was destroyed); gl_error (the
   * context is lost).
   */
  gles3_update(api: Gles3Api | null, skinner: Gles3Skinner | null, programs: Gles3ProgramSet | null, count: number): Status;
  /**
   * The program of a role for this mesh, never null: use it and set the game's own uniforms before draw().
   */
  gles3_program_of(skinner: Gles3Skinner | null, programs: Gles3ProgramSet | null, role: number): Gles3Program | null;
  /**
   * Draws characters first … first + count - 1 with `program`, which is program_of() of a role and in use.
   * Errors: bad_argument (not all of them updated, a skinner that was destroyed); gl_error (the context is lost).
   */
  gles3_draw(api: Gles3Api | null, skinner: Gles3Skinner | null, programs: Gles3ProgramSet | null, program: Gles3Program | null, first: number, count: number): Status;
  /**
   * After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
   * on_context_restored() update() and draw() refuse. The set first or last, as one likes.
   */
  gles3_programs_on_context_lost(programs: Gles3ProgramSet | null): void;
  /**
   * After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
   * on_context_restored() update() and draw() refuse. The set first or last, as one likes.
   */
  gles3_skinner_on_context_lost(skinner: Gles3Skinner | null): void;
  /**
   * Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
   * create_skinner(); then it may be tried again.
   */
  gles3_programs_on_context_restored(api: Gles3Api | null, caps: Gles3Caps | null, programs: Gles3ProgramSet | null): Status;
  /**
   * Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
   * create_skinner(); then it may be tried again.
   */
  gles3_skinner_on_context_restored(api: Gles3Api | null, caps: Gles3Caps | null, skinner: Gles3Skinner | null): Status;
  /**
   * How many frames it takes to bake clips at `rate_hz` or a little more, a whole number of steps each; 30 a second are
   * enough for most motion. out: at least as many as sources.
   * Errors: bad_argument (no sources, a rate that is not finite or not above 0, an additive clip, a span too short);
   * unsupported (more than 65535 steps of a clip, or kMaxCrowdFrames). Written only on success.
   */
  gles3_plan_crowd(sources: List<Gles3CrowdSource> | null, rate_hz: number, out: List<Gles3CrowdClip> | null, frame_count: View | number | null): Status;
  /**
   * Samples them. scratch: at least skeleton.soa_size(); matrices: at least frame_count × joint_count, the caller's to
   * keep, as are the clips, which must be those that plan_crowd() wrote for these sources; 48 B a joint and frame.
   * Errors: bad_argument (a span too short, a clip of another skeleton, clips that are not a plan).
   */
  gles3_bake_crowd(skeleton: Skeleton | null, sources: List<Gles3CrowdSource> | null, clips: List<Gles3CrowdClip> | null, scratch: List<SoaTransform> | null, matrices: List<Affine> | null, out: Gles3CrowdFrames | null): Status;
  /**
   * Where a joint of an instance is: linear between two neighbouring frames and between two clips, like the palettes that
   * are drawn, so that what is put there stays on the surface. What helpers of a palette do between frames and clips
   * is linear in the drawing too.
   * Errors: bad_argument (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
   * scene_from_character beyond 1e12).
   */
  gles3_crowd_joint(frames: Gles3CrowdFrames | null, instance: Gles3CrowdInstance | null, time_s: number, joint: number, scene_from_joint: Affine | null): Status;
  /**
   * The same of all joints; out: at least frames.joint_count.
   */
  gles3_crowd_pose(frames: Gles3CrowdFrames | null, instance: Gles3CrowdInstance | null, time_s: number, scene_from_joint: List<Affine> | null): Status;
  /**
   * What a texture of the caps' size holds, of palettes of `joints` matrices: frames of a mesh, and instances likewise.
   */
  gles3_crowd_palettes_that_fit(caps: Gles3Caps | null, joints: number): number;
  /**
   * Bytes of memory that create_crowd_mesh() wants: 48 B a joint, and the larger of 0.1 MB and prepare_scratch_bytes().
   * May be null: options.
   */
  gles3_crowd_mesh_bytes(mesh: Mesh | null, options: Gles3PrepareOptions | null): number;
  /**
   * Puts a mesh, by prepare(), and its palettes of all frames on the GPU. A level of detail is a CrowdMesh of its own.
   *
   * The mesh's geometry, the frames and options.as_tangents must live as long as the CrowdMesh, so that they can be put
   * on the next context. capacity: instances that are drawn in a frame, at most. memory: at least crowd_mesh_bytes(),
   * 16-byte aligned, the CrowdMesh's until destroy(). Errors: bad_argument (no capacity, no frames, memory too short or
   * askew, a joint that the frames lack); unsupported (a mesh with morph targets; more frames or instances than
   * crowd_palettes_that_fit()); gl_error (nothing is left allocated). `out` is written only on success. Leaves changed
   * what prepare() does, the active unit's 2D texture and GL_FRAMEBUFFER at 0; GL_PIXEL_UNPACK_BUFFER must be 0. Cost:
   * the vertices, and 48 B a matrix and frame, go up, once.
   * motion: keeps the palettes of the frame before as well, 48 B a joint and instance, and programs of roles that read
   * kMotion have MarrowVertex::previous_position from them.
   * May be null: options.
   */
  gles3_create_crowd_mesh(api: Gles3Api | null, caps: Gles3Caps | null, mesh: Mesh | null, options: Gles3PrepareOptions | null, frames: Gles3CrowdFrames | null, capacity: number, memory: List<number> | null, out: Gles3CrowdMesh | null, motion: boolean): Status;
  /**
   * Deletes the GL objects and clears the struct; the memory is the caller's again.
   */
  gles3_destroy_crowd_mesh(api: Gles3Api | null, mesh: Gles3CrowdMesh | null): void;
  /**
   * Room for `capacity` instances. memory: kCrowdInstanceBytes each, 4-byte aligned, the crowd's until destroy().
   * Errors: bad_argument (zero, memory too short or askew); unsupported (more than 256 × the caps' texture size:
   * 524 288); gl_error. Leaves the active unit's 2D texture at 0.
   */
  gles3_create_crowd(api: Gles3Api | null, caps: Gles3Caps | null, capacity: number, memory: List<number> | null, out: Gles3Crowd | null): Status;
  /**
   * Deletes the texture and clears the struct; the memory is the caller's again.
   */
  gles3_destroy_crowd(api: Gles3Api | null, crowd: Gles3Crowd | null): void;
  /**
   * Sets the instances from `first` on: any of those that there are, or more right behind them. While the context is lost
   * they are kept, and there once it is restored. Errors: bad_argument (a gap before `first`, frames other than those of
   * the instances before, an instance as crowd_joint() refuses it); unsupported (more than the capacity). Nothing is
   * changed then. Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and 128 B an
   * instance, in at most three pieces; where the GPU still draws from the texture the driver may wait or copy it.
   */
  gles3_set_instances(api: Gles3Api | null, crowd: Gles3Crowd | null, frames: Gles3CrowdFrames | null, first: number, instances: List<Gles3CrowdInstance> | null): Status;
  /**
   * The program for blend_crowd(). Errors: gl_error, with the driver's words in `log`. Cost: a compile.
   */
  gles3_build_crowd_program(api: Gles3Api | null, out: Gles3Program | null, log: List<number> | null): Status;
  /**
   * The same and, for a kind of mesh, each role's program that reads palettes of crowds, in a set: what it lacks is
   * compiled. The set brings them back after a loss of the context. deformer: one that the mesh was prepared for.
   * features: what programs are to read of what the mesh has. Errors: bad_argument (Deformer::none, no role);
   * unsupported (a full set); gl_error, with the driver's words in programs.log.
   */
  gles3_build_crowd_programs(api: Gles3Api | null, caps: Gles3Caps | null, mesh: Gles3CrowdMesh | null, deformer: Gles3Deformer, features: number, programs: Gles3ProgramSet | null): Status;
  /**
   * What was built with the same arguments, never null.
   */
  gles3_crowd_program_of(mesh: Gles3CrowdMesh | null, deformer: Gles3Deformer, features: number, programs: Gles3ProgramSet | null, role: number): Gles3Program | null;
  /**
   * What was built with the same arguments, never null.
   */
  gles3_blending_program_of(programs: Gles3ProgramSet | null): Gles3Program | null;
  /**
   * With motion: once a frame, before blend_crowd(). What was blended is now the frame before. No call to GL.
   */
  gles3_begin_crowd_frame(mesh: Gles3CrowdMesh | null): void;
  /**
   * With motion: what the frame before is of instances that were not blended in it, or not where they are now: those that
   * have been set since to play or stand elsewhere at once. It is as they are set now, at time_s: that of the frame
   * before, and they move as their clips do; this frame's, and they stand still. Instances beside them stay as they are.
   * Otherwise as blend_crowd(). Errors: as there; bad_argument too of a mesh without motion.
   */
  gles3_blend_previous_crowd(api: Gles3Api | null, crowd: Gles3Crowd | null, mesh: Gles3CrowdMesh | null, first: number, count: number, time_s: number, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * Writes the palettes of `count` instances from `first` on, as they are at time_s of the crowd's clock, placed in the
   * scene: one triangle, a fragment a row of a matrix; once a frame, however often they are drawn then. `program`, from
   * build_crowd_program(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and GL_RASTERIZER_DISCARD must be off and no
   * colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport as large as the texture, `texture_unit`
   * and the one behind it bound and the latter active. Errors: bad_argument (a program of another kind, instances that
   * are not there, frames other than the mesh's, a time that is not finite); unsupported (more instances than the mesh
   * has capacity for); gl_error (the context is lost).
   */
  gles3_blend_crowd(api: Gles3Api | null, crowd: Gles3Crowd | null, mesh: Gles3CrowdMesh | null, first: number, count: number, time_s: number, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * The next draw() with `count` instances draws those from `first` on, as they were blended. `program`, which must be in
   * use, reads palettes of crowds. Binds two texture units as blend_crowd() does, with kMotion the one behind them, too.
   * Errors: as there.
   */
  gles3_bind_crowd(api: Gles3Api | null, crowd: Gles3Crowd | null, mesh: Gles3CrowdMesh | null, first: number, count: number, texture_unit: number, program: Gles3Program | null): Status;
  /**
   * After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
   * on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
   */
  gles3_crowd_mesh_on_context_lost(mesh: Gles3CrowdMesh | null): void;
  /**
   * After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
   * on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
   */
  gles3_crowd_on_context_lost(crowd: Gles3Crowd | null): void;
  /**
   * Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
   * creation does. Errors: as creation, but for its arguments; then it may be tried again.
   */
  gles3_crowd_mesh_on_context_restored(api: Gles3Api | null, caps: Gles3Caps | null, mesh: Gles3CrowdMesh | null): Status;
  /**
   * Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
   * creation does. Errors: as creation, but for its arguments; then it may be tried again.
   */
  gles3_crowd_on_context_restored(api: Gles3Api | null, caps: Gles3Caps | null, crowd: Gles3Crowd | null): Status;
  /**
   * "usable", or why a path is ruled out, in a few words; "" for a value that is none.
   */
  gles3_verdict_text(verdict: Gles3Verdict): string;
  /**
   * Bytes of memory that self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as the defaults.
   */
  gles3_self_test_bytes(options: Gles3SelfTestOptions | null): number;
  /**
   * Tries the paths, in the order of SkinningPath. memory: at least self_test_bytes(), 16-byte aligned, free again
   * afterwards. Errors: bad_argument (no deformer, options beyond what they may be, memory too short or askew); gl_error
   * (the context is lost, or nothing can be read back from it; then nothing is known of any path). `out` is written only
   * on success; no GL object is left.
   *
   * Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
   * framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
   * GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
   * binding 0 and what preskin() says.
   * Cost: some twenty programs compiled, and a wait for each frame; only where nothing is stored.
   */
  gles3_run_self_test(api: Gles3Api | null, caps: Gles3Caps | null, options: Gles3SelfTestOptions | null, memory: List<number> | null, out: Gles3SelfTest | null): Status;
  /**
   * Of the usable paths of the GPU the one that was fastest: ns_per_vertex + (passes - 1) · ns_per_pass. cpu is taken
   * where there is no other, as its time is not the GPU's. Of those within 5 % of each other, and of all where one has
   * not been timed, the first in this order:
   *
   *                                one pass                           several passes
   *   up to 7 characters           ubo texture compute feedback cpu   compute feedback ubo texture cpu
   *   kManyCharacters and more     texture ubo compute feedback cpu   texture compute feedback ubo cpu
   *   GpuFamily::mali_g            texture compute feedback ubo cpu   the same
   *
   * More than kPaletteJoints leave texture and cpu. Why so: docs/decisions.md, "Which path".
   * Errors: unsupported (none is usable). `out` is written only on success.
   */
  gles3_choose(test: Gles3SelfTest | null, need: Gles3PathNeed | null, out: View | number | null): Status;
  /**
   * Writes kSavedSelfTestBytes. Errors: bad_argument (`out` too short).
   */
  gles3_save(test: Gles3SelfTest | null, out: List<number> | null): Status;
  /**
   * The result in bytes that save() has written, if it still holds. Errors: truncated, bad_magic, bad_version,
   * bad_checksum, bad_data; mismatch (another driver, version of it, library, or other caps or options): then test anew,
   * and with another driver without what had crashed. `out` is written only on success.
   */
  gles3_restore(api: Gles3Api | null, caps: Gles3Caps | null, options: Gles3SelfTestOptions | null, saved: List<number> | null, out: Gles3SelfTest | null): Status;
}
