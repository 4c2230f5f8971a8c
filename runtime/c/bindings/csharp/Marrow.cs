// Made by tools/c_api from the descriptions in runtime/c: do not edit.
// The runtime for C#, as C has it: see docs/c.md. bool is a byte here, so that all structs are blittable. New() makes a
// struct as C++ has it by default. Structs that C++ puts on 16 bytes go into memory of Marrow.Block().
using System;
using System.Runtime.InteropServices;

namespace MarrowRuntime {

/// <summary>
/// What a call came to.
/// </summary>
public enum Status : byte {
    Ok = 0,
    /// <summary>
    /// the call is wrong: a span too short, a null pointer, an index out of range
    /// </summary>
    BadArgument = 1,
    /// <summary>
    /// the data ends before what it announces
    /// </summary>
    Truncated = 2,
    /// <summary>
    /// not a cooked file
    /// </summary>
    BadMagic = 3,
    /// <summary>
    /// cooked for another version of the format
    /// </summary>
    BadVersion = 4,
    /// <summary>
    /// damaged
    /// </summary>
    BadChecksum = 5,
    /// <summary>
    /// breaks a rule of docs/format.md
    /// </summary>
    BadData = 6,
    /// <summary>
    /// legal, but needs what this build or this device lacks
    /// </summary>
    Unsupported = 7,
    /// <summary>
    /// the driver refused
    /// </summary>
    GlError = 8,
    /// <summary>
    /// both are good, but not made for each other
    /// </summary>
    Mismatch = 9,
    /// <summary>
    /// a library that allocates for itself found none
    /// </summary>
    OutOfMemory = 10,
}

/// <summary>
/// Where a block of data breaks the format, and which rule. `rule` is a static string.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct DataError {
    /// <summary>
    /// what the call returns
    /// </summary>
    public Status status;
    /// <summary>
    /// byte in the block
    /// </summary>
    public uint offset;
    /// <summary>
    /// in English
    /// </summary>
    public byte* rule;
    public static DataError New() {
        DataError made;
        Marrow.DataErrorInit(&made);
        return made;
    }
}

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void CallErrorHandler(byte* function, byte* condition);

[StructLayout(LayoutKind.Sequential)]
public unsafe struct Block {
    public void* data;
    public UIntPtr size;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct Bytes {
    public void* data;
    public UIntPtr size;
    public static Bytes New() {
        Bytes made;
        Marrow.BytesInit(&made);
        return made;
    }
}

/// <summary>
/// One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MeshDecoder {
    /// <summary>
    /// as packed files name it
    /// </summary>
    public uint codec;
    /// <summary>
    /// the codec
    /// </summary>
    public IntPtr decode;
}

/// <summary>
/// How much memory unpack() takes.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct UnpackSizes {
    /// <summary>
    /// of the unpacked file
    /// </summary>
    public uint file_bytes;
    /// <summary>
    /// what unpack() wants: the file and, behind it, room to work in
    /// </summary>
    public uint memory_bytes;
}

/// <summary>
/// The same in steps, for a game that loads while it plays: as many a frame as its time allows.
///
///   Unpacking loading;
///   begin_unpack(packed, decoders, memory, loading);
///   every frame   while (loading.file.empty() &amp;&amp; there is time) unpack_step(loading);
///   then          load(loading.file, file)
///
/// A plain struct; {} is nothing begun. The packed bytes, the decoders and the memory stay as they are until the last
/// step. Stopping half way is forgetting it: nothing is to be freed.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Unpacking {
    /// <summary>
    /// empty until the last step is done; then as of unpack()
    /// </summary>
    public void* file;
    public UIntPtr file_bytes;
    /// <summary>
    /// of total_bytes, for a bar
    /// </summary>
    public uint done_bytes;
    /// <summary>
    /// of the unpacked file
    /// </summary>
    public uint total_bytes;
    /// <summary>
    /// unpack_step()'s own
    /// </summary>
    public fixed byte state[512];
    public static Unpacking New() {
        Unpacking made;
        Marrow.UnpackingInit(&made);
        return made;
    }
}

/// <summary>
/// Local transforms (parent_from_joint = translate · rotate · scale) of four consecutive joints, one lane a joint.
/// Rotations are unit quaternions. Lanes past the last joint hold the identity.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 160)]
public unsafe struct SoaTransform {
    /// <summary>
    /// x, y, z; metres
    /// </summary>
    public fixed float translation[12];
    /// <summary>
    /// x, y, z, w
    /// </summary>
    public fixed float rotation[16];
    /// <summary>
    /// x, y, z
    /// </summary>
    public fixed float scale[12];
}

/// <summary>
/// The change from one pose to another, not a pose: a type of its own, so that one is not taken for the other.
/// translation: difference; rotation: of the parent's axes, w ≥ 0; scale: ratio.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 160)]
public unsafe struct AdditiveTransform {
    /// <summary>
    /// of four joints
    /// </summary>
    public SoaTransform change;
}

/// <summary>
/// An affine map, three rows of four: out = rows · (x, y, z, 1). What palettes and files hold: 48 bytes a joint.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 48)]
public unsafe struct Affine {
    /// <summary>
    /// the last column is the translation
    /// </summary>
    public fixed float rows[12];
}

/// <summary>
/// The local transform of one joint.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct JointTransform {
    /// <summary>
    /// metres
    /// </summary>
    public fixed float translation[3];
    /// <summary>
    /// a unit quaternion x, y, z, w
    /// </summary>
    public fixed float rotation[4];
    /// <summary>
    /// along the joint's axes
    /// </summary>
    public fixed float scale[3];
    public static JointTransform New() {
        JointTransform made;
        Marrow.JointTransformInit(&made);
        return made;
    }
}

/// <summary>
/// An axis of the space.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct ExampleParameter {
    /// <summary>
    /// see File::text; also of the channel that drives it
    /// </summary>
    public uint name;
    /// <summary>
    /// where nothing drives it
    /// </summary>
    public float rest;
}

/// <summary>
/// Rows have one float a target, and zeros up to a multiple of four.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct ExampleSpace {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// at most kMaxExamples
    /// </summary>
    public uint example_count;
    /// <summary>
    /// at most kMaxExampleParameters
    /// </summary>
    public ExampleParameter* parameters;
    public UIntPtr parameter_count;
    /// <summary>
    /// that it weighs, ascending, at most kMaxExamples; the same of each mesh
    /// </summary>
    public uint* targets;
    public UIntPtr target_count;
    /// <summary>
    /// of the file, ascending
    /// </summary>
    public uint* meshes;
    public UIntPtr mesh_count;
    /// <summary>
    /// a row of constants, then a row a parameter
    /// </summary>
    public float* linear;
    public UIntPtr linear_count;
    /// <summary>
    /// a row an example
    /// </summary>
    public float* radial;
    public UIntPtr radial_count;
    /// <summary>
    /// an example: its parameters
    /// </summary>
    public float* places;
    public UIntPtr place_count;
    /// <summary>
    /// an example; above 0
    /// </summary>
    public float* inverse_widths;
    public UIntPtr inverse_width_count;
}

/// <summary>
/// What shape the rotations within a JointLimit have.
/// </summary>
public enum LimitKind : byte {
    /// <summary>
    /// turns freely; for joints that have a rate limit alone
    /// </summary>
    None = 0,
    /// <summary>
    /// about one axis, between two angles: knees, elbows, fingers
    /// </summary>
    Hinge = 1,
    /// <summary>
    /// swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
    /// </summary>
    Cone = 2,
    /// <summary>
    /// three angles about three axes, each between two: rigs whose limits came so
    /// </summary>
    Euler = 3,
}

/// <summary>
/// The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
/// </summary>
public enum AxisOrder : byte {
    Xyz = 0,
    Xzy = 1,
    Yxz = 2,
    Yzx = 3,
    Zxy = 4,
    Zyx = 5,
}

/// <summary>
/// Which part of a local transform a Track drives.
/// </summary>
public enum TrackPath : byte {
    Translation = 0,
    Rotation = 1,
    Scale = 2,
}

/// <summary>
/// What lies between two keys, as glTF 2.0 defines it.
/// </summary>
public enum Interpolation : byte {
    Step = 0,
    Linear = 1,
    CubicSpline = 2,
}

/// <summary>
/// How a material's alpha is meant, as in glTF 2.0.
/// </summary>
public enum AlphaMode : byte {
    Opaque = 0,
    Mask = 1,
    Blend = 2,
}

/// <summary>
/// What of a material an image gives.
/// </summary>
public enum TextureRole : byte {
    BaseColour = 0,
    MetallicRoughness = 1,
    Normal = 2,
    Occlusion = 3,
    Emissive = 4,
    /// <summary>
    /// KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
    /// </summary>
    SpecularGlossiness = 5,
}

/// <summary>
/// What lies beyond an image's edge.
/// </summary>
public enum Wrap : byte {
    Repeat = 0,
    ClampToEdge = 1,
    MirroredRepeat = 2,
}

/// <summary>
/// How an image is magnified.
/// </summary>
public enum MagFilter : byte {
    Any = 0,
    Nearest = 1,
    Linear = 2,
}

/// <summary>
/// How an image is minified; any: the source leaves it to the game.
/// </summary>
public enum MinFilter : byte {
    Any = 0,
    Nearest = 1,
    Linear = 2,
    NearestMipmapNearest = 3,
    LinearMipmapNearest = 4,
    NearestMipmapLinear = 5,
    LinearMipmapLinear = 6,
}

/// <summary>
/// What an image's bytes are.
/// </summary>
public enum ImageFormat : byte {
    Unknown = 0,
    Png = 1,
    Jpeg = 2,
    Webp = 3,
    Ktx2 = 4,
    Dds = 5,
}

/// <summary>
/// What a Property is.
/// </summary>
public enum PropertyType : byte {
    Number = 0,
    Boolean = 1,
    Text = 2,
}

/// <summary>
/// Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
/// clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
/// angle_range() in limits.h.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct AngleRange {
    /// <summary>
    /// -1 … 1: -180° … 180°
    /// </summary>
    public float middle;
    /// <summary>
    /// 0 … 1; 1: any angle
    /// </summary>
    public float half_width;
}

/// <summary>
/// The most per second, and per second per second; 0: no limit. Of rotations in radians, of points in metres.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct RateLimit {
    /// <summary>
    /// rad/s or m/s
    /// </summary>
    public float speed;
    /// <summary>
    /// rad/s² or m/s²
    /// </summary>
    public float acceleration;
    public static RateLimit New() {
        RateLimit made;
        Marrow.RateLimitInit(&made);
        return made;
    }
}

/// <summary>
/// How far and how fast a joint may turn, as it lies in a cooked file; make one with make_limit(), see limits.h.
///
/// The limit's own axes are fixed to the joint, and coincide with those of the parent's side at the joint's zero
/// rotation. A local rotation q (parent_from_joint) is seen in them as
///   t = limit_from_parent · q · joint_from_limit,   limit_from_parent = (zero · joint_from_limit)⁻¹
/// so that t is the identity where q = zero. Angles are positive by the right hand: about x from y to z.
///
/// hinge: t is a turn about x, by an angle in angles[0].
/// cone: t = swing · twist, the twist, about x, first. The twist is an angle in angles[0]. The swing turns about an axis
///   in the y-z plane by θ, and (y, z) = tan(θ / 4) · axis lies in the ellipse with the half axes angles[1].half_width
///   and angles[2].half_width: about y alone it reaches the angle of the first, about z alone that of the second. Below
///   90° this is within 2.3° of an ellipse in the angles themselves.
/// euler: t is the product of three turns about x, y and z in the order `order`, angles[0] that of the first factor. The
///   second is within ±90°, where there is one set of angles for each rotation (at ±90° many).
///
/// A swing of 180° has no twist: all twists are one step away. See clamp_rotation().
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct JointLimit {
    /// <summary>
    /// of the skeleton
    /// </summary>
    public ushort joint;
    /// <summary>
    /// which of the shapes above
    /// </summary>
    public LimitKind kind;
    /// <summary>
    /// of euler; else xyz
    /// </summary>
    public AxisOrder order;
    /// <summary>
    /// unit quaternion
    /// </summary>
    public fixed float limit_from_parent[4];
    /// <summary>
    /// unit quaternion
    /// </summary>
    public fixed float joint_from_limit[4];
    /// <summary>
    /// of a cone the middles of the second and third are 0; of a hinge both are 0
    /// </summary>
    public AngleRange angles0;
    public AngleRange angles1;
    public AngleRange angles2;
    /// <summary>
    /// of the local rotation, see follow_pose()
    /// </summary>
    public RateLimit rate;
    public static JointLimit New() {
        JointLimit made;
        Marrow.JointLimitInit(&made);
        return made;
    }
}

/// <summary>
/// A joint that swings, by the bone that goes from it to the next joint of its chain. See springs.h.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SpringJoint {
    /// <summary>
    /// of the skeleton
    /// </summary>
    public ushort joint;
    /// <summary>
    /// 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
    /// </summary>
    public ushort most_pull;
    /// <summary>
    /// 0 … 15: of small swings about the animated direction, without damping and gravity
    /// </summary>
    public float frequency_hz;
    /// <summary>
    /// 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
    /// </summary>
    public float damping_ratio;
    /// <summary>
    /// -10 … 10, times SpringFrame::gravity
    /// </summary>
    public float gravity;
    /// <summary>
    /// 0 … 50 1/s: by which the air slows the bone's end, and the wind carries it
    /// </summary>
    public float drag;
    /// <summary>
    /// ≥ 0, of the sphere about the bone's end that stays out of colliders; world
    /// </summary>
    public float radius_m;
    /// <summary>
    /// 0 … 1, of what is shown; the motion itself goes on
    /// </summary>
    public float weight;
    public static SpringJoint New() {
        SpringJoint made;
        Marrow.SpringJointInit(&made);
        return made;
    }
}

/// <summary>
/// Joints each of which is somewhere below the one before it. A joint belongs to one chain at most.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SpringChain {
    /// <summary>
    /// from the chain's root to its end
    /// </summary>
    public SpringJoint* joints;
    public UIntPtr joint_count;
    /// <summary>
    /// end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
    /// </summary>
    public fixed float tip[3];
    /// <summary>
    /// bit i, lowest first: it stays out of SpringFrame::colliders[i]
    /// </summary>
    public ulong colliders;
    public static SpringChain New() {
        SpringChain made;
        Marrow.SpringChainInit(&made);
        return made;
    }
}

/// <summary>
/// A capsule, or a sphere where both ends are one point, that moves with a joint. Its radius is scaled as the joint's
/// space is where that is most.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SpringCollider {
    /// <summary>
    /// it moves with
    /// </summary>
    public ushort joint;
    public ushort reserved;
    /// <summary>
    /// in the joint's space
    /// </summary>
    public fixed float from[3];
    /// <summary>
    /// in the joint's space
    /// </summary>
    public fixed float to[3];
    /// <summary>
    /// in the joint's space
    /// </summary>
    public float radius_m;
    public static SpringCollider New() {
        SpringCollider made;
        Marrow.SpringColliderInit(&made);
        return made;
    }
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct SpringColliderList {
    public SpringCollider* data;
    public UIntPtr size;
}

/// <summary>
/// The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
/// comes before its children and the roots come first.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Skeleton {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// 1 … kMaxJoints
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// joints 0 … root_count-1 have no parent joint
    /// </summary>
    public uint root_count;
    /// <summary>
    /// root_count; what stands above each root and never moves
    /// </summary>
    public Affine* scene_from_root;
    /// <summary>
    /// soa_count(joint_count); the pose of joints that a clip leaves alone
    /// </summary>
    public SoaTransform* rest;
    /// <summary>
    /// joint_count; kNoParent for roots
    /// </summary>
    public ushort* parents;
    /// <summary>
    /// joint_count; see File::text
    /// </summary>
    public uint* names;
    /// <summary>
    /// ascending by joint; those that the asset came with
    /// </summary>
    public JointLimit* limits;
    public UIntPtr limit_count;
}

/// <summary>
/// In a clip pack, instead of a skeleton: which one its clips were made for. See clip_pack.h.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SkeletonReference {
    /// <summary>
    /// the skeleton's
    /// </summary>
    public byte* name;
    /// <summary>
    /// the skeleton's
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// skeleton_hash() of the skeleton
    /// </summary>
    public ulong hash;
    /// <summary>
    /// joint_count; see File::text
    /// </summary>
    public uint* names;
    /// <summary>
    /// joint_count; of each joint's rest pose
    /// </summary>
    public uint* rest_hashes;
    /// <summary>
    /// joint_count; kNoParent for roots
    /// </summary>
    public ushort* parents;
}

/// <summary>
/// One channel of a clip stored without loss: the source's own keys at the source's own times.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Track {
    /// <summary>
    /// of the skeleton
    /// </summary>
    public ushort joint;
    /// <summary>
    /// what of the joint it drives
    /// </summary>
    public TrackPath path;
    /// <summary>
    /// between its keys
    /// </summary>
    public Interpolation interpolation;
    /// <summary>
    /// ≥ 1
    /// </summary>
    public uint key_count;
    /// <summary>
    /// into Clip::times; tracks with the same keys share them
    /// </summary>
    public uint first_time;
    /// <summary>
    /// Into Clip::values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
    /// </summary>
    public uint first_value;
}

/// <summary>
/// Which sub-tracks (rotation, translation or scale of a joint) of a group of four joints move in a clip, and which
/// stay, but not as in the rest pose. Bits 0-3 rotation, 4-7 translation, 8-11 scale; lowest bit first joint.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct GroupMasks {
    /// <summary>
    /// what changes over the clip
    /// </summary>
    public ushort moving;
    /// <summary>
    /// what stays, but not as at rest
    /// </summary>
    public ushort constant;
}

/// <summary>
/// A number over time, such as a morph target's weight or a property of the game: it moves no joint. Without loss, but
/// that keys on a straight line between others may have been left out (docs/cooking/clips.md).
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Channel {
    /// <summary>
    /// see File::text
    /// </summary>
    public uint name;
    /// <summary>
    /// the number where no clip drives it
    /// </summary>
    public float rest;
    /// <summary>
    /// ≥ 1
    /// </summary>
    public uint key_count;
    /// <summary>
    /// as in Track
    /// </summary>
    public uint first_time;
    /// <summary>
    /// into Clip::values; one float a key, three for cubic_spline (in, value, out)
    /// </summary>
    public uint first_value;
    /// <summary>
    /// between its keys
    /// </summary>
    public Interpolation interpolation;
    public fixed byte reserved[3];
}

/// <summary>
/// Tracks compressed within a stated error: poses at even steps of time, or at times of their own, in segments, as
/// packed integers relative to the rest pose (docs/format.md). What does not move stands once.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct CodedTracks {
    /// <summary>
    /// 0: the clip has no coded tracks; else ≥ 2
    /// </summary>
    public uint frame_count;
    /// <summary>
    /// sub-tracks that move
    /// </summary>
    public uint track_count;
    /// <summary>
    /// sub-tracks that stay, but not as at rest
    /// </summary>
    public uint constant_count;
    /// <summary>
    /// steps of time a segment; the last may have fewer
    /// </summary>
    public uint segment_intervals;
    /// <summary>
    /// of frame 0
    /// </summary>
    public float start_s;
    /// <summary>
    /// of uneven ones the mean
    /// </summary>
    public float frames_per_s;
    /// <summary>
    /// frame_count, ascending; null: even steps
    /// </summary>
    public float* times_s;
    /// <summary>
    /// one a group of four joints
    /// </summary>
    public GroupMasks* masks;
    /// <summary>
    /// bytes into payload
    /// </summary>
    public uint* segment_offsets;
    /// <summary>
    /// their values
    /// </summary>
    public void* constants;
    /// <summary>
    /// segments of packed integers
    /// </summary>
    public void* payload;
}

/// <summary>
/// An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Clip {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// which skeleton of the file; in a clip pack, which reference
    /// </summary>
    public uint skeleton;
    /// <summary>
    /// of that skeleton
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// time of the last key; ≥ 0
    /// </summary>
    public float duration_s;
    /// <summary>
    /// for sample_additive(), not for sample()
    /// </summary>
    public byte additive;
    /// <summary>
    /// additive: the pose that changes are taken from; null: the rest pose
    /// </summary>
    public SoaTransform* reference;
    /// <summary>
    /// what is compressed
    /// </summary>
    public CodedTracks coded;
    /// <summary>
    /// what is stored without loss
    /// </summary>
    public Track* tracks;
    public UIntPtr track_count;
    /// <summary>
    /// numbers that it drives
    /// </summary>
    public Channel* channels;
    public UIntPtr channel_count;
    /// <summary>
    /// key times of tracks and channels, seconds
    /// </summary>
    public float* times_s;
    /// <summary>
    /// keys of tracks and channels
    /// </summary>
    public float* values;
    /// <summary>
    /// of its bytes and its place in the file, from File::clip(); 0: made by hand
    /// </summary>
    public ulong id;
}

/// <summary>
/// Consecutive vertices that depend on the same joints. Each run starts a new block of four vertices; the slots that
/// fill up its last block repeat its last vertex.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Run {
    /// <summary>
    /// ≥ 1
    /// </summary>
    public uint vertex_count;
    /// <summary>
    /// 1 … kMaxInfluences
    /// </summary>
    public uint influences;
}

/// <summary>
/// What a morph target adds to the vertices of the blocks that it moves, the others it leaves alone. For each of its
/// blocks and attributes, in this order, a record of twelve integers: dx[4] dy[4] dz[4]; times a step each is a change.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MorphTarget {
    /// <summary>
    /// into Geometry::target_blocks
    /// </summary>
    public uint first_block;
    /// <summary>
    /// how many blocks it moves
    /// </summary>
    public uint block_count;
    /// <summary>
    /// into Geometry::target_records
    /// </summary>
    public uint first_record;
    /// <summary>
    /// MorphAttributes; 0 if it moves nothing
    /// </summary>
    public uint attributes;
    /// <summary>
    /// metres, mesh space
    /// </summary>
    public float position_step;
    /// <summary>
    /// a unit of its records of normals
    /// </summary>
    public float normal_step;
    /// <summary>
    /// a unit of its records of tangents
    /// </summary>
    public float tangent_step;
    public uint reserved;
}

/// <summary>
/// What pose-space deformation adds to vertices of the bind pose, see skin_psd() in skin.h: example poses, and for each
/// the deltas of some blocks.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct PoseSpace {
    /// <summary>
    /// width of the Gaussian, a share of 1: sin of half an angle
    /// </summary>
    public float sigma;
    /// <summary>
    /// positions alone; empty: none
    /// </summary>
    public MorphTarget* examples;
    public UIntPtr example_count;
    /// <summary>
    /// as Geometry::target_blocks
    /// </summary>
    public void* blocks;
    /// <summary>
    /// as Geometry::target_records
    /// </summary>
    public short* records;
    /// <summary>
    /// for each example and palette entry x y z w, up to a positive factor
    /// </summary>
    public short* rotations;
    /// <summary>
    /// a palette entry: the one that its rotation is relative to, or kNoParent
    /// </summary>
    public ushort* parents;
}

/// <summary>
/// Triangles and bind-pose vertices. Vertices live in *slots*: blocks of four, laid out for the skinning kernels
/// (`k` is the run's influence count). The arrays of blocks begin on 16-byte boundaries.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Geometry {
    /// <summary>
    /// vertices with padding; a multiple of 4
    /// </summary>
    public uint slot_count;
    /// <summary>
    /// without padding
    /// </summary>
    public uint vertex_count;
    /// <summary>
    /// 3 a triangle; counter-clockwise fronts
    /// </summary>
    public uint index_count;
    /// <summary>
    /// 2 or 4
    /// </summary>
    public uint index_bytes;
    /// <summary>
    /// how many palette entries the sets refer to
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// slots
    /// </summary>
    public void* indices;
    /// <summary>
    /// in the order of the slots
    /// </summary>
    public Run* runs;
    public UIntPtr run_count;
    /// <summary>
    /// for each run its k palette entries, run after run
    /// </summary>
    public ushort* sets;
    /// <summary>
    /// a block: x[4] y[4] z[4], then k-1 times w[4]; the last weight is 1 - Σ
    /// </summary>
    public float* skin;
    /// <summary>
    /// a block: x[4] y[4] z[4]; unit; null if absent
    /// </summary>
    public float* normals;
    /// <summary>
    /// a block: x[4] y[4] z[4] sign[4]; unit; null if absent
    /// </summary>
    public float* tangents;
    /// <summary>
    /// a block: k times dx[4] dy[4] dz[4] dw[4]; null: the lift, all zero
    /// </summary>
    public float* as_residual;
    /// <summary>
    /// a block: k times three rows x[4] y[4] z[4] t[4]; null if absent
    /// </summary>
    public float* mwe_residual;
    /// <summary>
    /// palette entry whose frame they are meant in
    /// </summary>
    public uint mwe_root;
    /// <summary>
    /// a slot: u v; null if absent
    /// </summary>
    public float* uvs;
    /// <summary>
    /// a slot: r g b a, linear; null if absent
    /// </summary>
    public byte* colours;
    /// <summary>
    /// The slot of each vertex of the source, if cooked with --keep-vertex-order; kNoSlot: no triangle uses it, of this
    /// part of a primitive in parts.
    /// </summary>
    public uint* source_slots;
    public UIntPtr source_slot_count;
    /// <summary>
    /// morph targets, as many as MeshTarget of a mesh
    /// </summary>
    public MorphTarget* targets;
    public UIntPtr target_count;
    /// <summary>
    /// as wide as indices; for each target the blocks it moves, ascending
    /// </summary>
    public void* target_blocks;
    /// <summary>
    /// twelve a record
    /// </summary>
    public short* target_records;
    /// <summary>
    /// examples empty: none
    /// </summary>
    public PoseSpace pose_space;
    /// <summary>
    /// of the bind positions, mesh space
    /// </summary>
    public fixed float box_min[3];
    /// <summary>
    /// likewise
    /// </summary>
    public fixed float box_max[3];
}

/// <summary>
/// A morph target of a mesh: what it is called and what drives it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MeshTarget {
    /// <summary>
    /// see File::text; may be empty
    /// </summary>
    public uint name;
    /// <summary>
    /// Name of the channel that clips drive its weight by, see find_weight_channels() in morph.h.
    /// </summary>
    public uint channel;
    /// <summary>
    /// where no clip does
    /// </summary>
    public float weight;
}

/// <summary>
/// An image in a role, channels as glTF 2.0 section 3.9 has them. Base colour, emissive and specular-glossiness images
/// are sRGB (of the last all but alpha), others linear; (0, 0) of the UVs is the image's upper left corner.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Texture {
    /// <summary>
    /// which image of the file
    /// </summary>
    public ushort image;
    /// <summary>
    /// none twice in a material
    /// </summary>
    public TextureRole role;
    /// <summary>
    /// along u and v
    /// </summary>
    public Wrap wrap_u;
    /// <summary>
    /// along u and v
    /// </summary>
    public Wrap wrap_v;
    /// <summary>
    /// as the source asks
    /// </summary>
    public MagFilter mag;
    /// <summary>
    /// as the source asks
    /// </summary>
    public MinFilter min;
    public byte reserved;
}

/// <summary>
/// A material as far as Mesh does not say it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Material {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// opaque: alpha is not looked at
    /// </summary>
    public AlphaMode alpha;
    /// <summary>
    /// mask: what is less opaque is not drawn
    /// </summary>
    public float alpha_cutoff;
    /// <summary>
    /// KHR_materials_unlit: the base colour is what is seen
    /// </summary>
    public byte unlit;
    /// <summary>
    /// linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
    /// </summary>
    public fixed float emissive[3];
    /// <summary>
    /// one a role
    /// </summary>
    public Texture* textures;
    public UIntPtr texture_count;
}

/// <summary>
/// A picture by reference, or as the source's own bytes. They are not checked: whoever decodes them must.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Image {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// relative to the source file and percent-encoded, as it stood there; empty if it had none
    /// </summary>
    public byte* uri;
    /// <summary>
    /// unknown: by its bytes or its URI none of the others
    /// </summary>
    public ImageFormat format;
    /// <summary>
    /// empty: by reference
    /// </summary>
    public void* bytes;
    public UIntPtr byte_count;
    /// <summary>
    /// of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
    /// </summary>
    public uint fallback;
}

/// <summary>
/// A number, a truth or a text that an artist gave a node.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Property {
    /// <summary>
    /// see File::text; of nested ones the path, as in "door/hinges/0"
    /// </summary>
    public uint name;
    /// <summary>
    /// which of the two members below holds it
    /// </summary>
    public PropertyType type;
    public fixed byte reserved[3];
    /// <summary>
    /// finite; of a boolean 1 or 0
    /// see File::text
    /// </summary>
    public double number;
}

/// <summary>
/// A node of the source that is kept although it may be no joint: a socket, a locator. Its place in the scene is
/// scene_from_joint[joint] · joint_from_node, or joint_from_node alone without a joint.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Node {
    /// <summary>
    /// as the source calls it; never empty
    /// </summary>
    public byte* name;
    /// <summary>
    /// which skeleton of the file
    /// </summary>
    public uint skeleton;
    /// <summary>
    /// the nearest joint at or above it
    /// </summary>
    public ushort joint;
    /// <summary>
    /// never changes
    /// </summary>
    public Affine* joint_from_node;
    /// <summary>
    /// the `extras` of the source
    /// </summary>
    public Property* properties;
    public UIntPtr property_count;
}

/// <summary>
/// A palette entry that blends those of two joints, for vertices that follow both: see build_palette().
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Helper {
    /// <summary>
    /// palette entries, below Mesh::joint_count, not the same
    /// </summary>
    public ushort first;
    /// <summary>
    /// palette entries, below Mesh::joint_count, not the same
    /// </summary>
    public ushort second;
    /// <summary>
    /// of second; above 0, below 1
    /// </summary>
    public float share;
    public static Helper New() {
        Helper made;
        Marrow.HelperInit(&made);
        return made;
    }
}

/// <summary>
/// A level of detail: another geometry over the same palette.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MeshLod {
    /// <summary>
    /// which of the file
    /// </summary>
    public uint geometry;
    /// <summary>
    /// the farthest that a vertex of the full mesh is from it, in the clips it was made with
    /// </summary>
    public float error_m;
}

/// <summary>
/// A box, and a sphere about the box's centre, about the same vertices. Scene space, metres.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Bounds {
    /// <summary>
    /// least corner
    /// </summary>
    public fixed float box_min[3];
    /// <summary>
    /// greatest corner
    /// </summary>
    public fixed float box_max[3];
    /// <summary>
    /// below 0: empty, or not known
    /// </summary>
    public float radius_m;
}

/// <summary>
/// Geometry bound to joints. A mesh hung rigidly on a node is bound to one joint with weight 1.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Mesh {
    /// <summary>
    /// as the source calls it; never null
    /// </summary>
    public byte* name;
    /// <summary>
    /// the material's name; never null
    /// </summary>
    public byte* material;
    /// <summary>
    /// which material of the file, if it has more than what stands here
    /// </summary>
    public uint material_index;
    /// <summary>
    /// which skeleton of the file
    /// </summary>
    public uint skeleton;
    /// <summary>
    /// meshes with the same number share their geometry
    /// </summary>
    public uint geometry_index;
    /// <summary>
    /// palette entries that are joints
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// joint_count; palette entry → joint of the skeleton
    /// </summary>
    public ushort* joints;
    /// <summary>
    /// joint_count; joint_from_mesh in the bind pose
    /// </summary>
    public Affine* inverse_bind;
    /// <summary>
    /// linear RGBA
    /// </summary>
    public fixed float base_colour[4];
    /// <summary>
    /// backs are drawn, too
    /// </summary>
    public byte double_sided;
    /// <summary>
    /// One primitive of the source with the mesh before it, for which one palette was too small. Nothing but the source's
    /// vertex order needs to know: see Geometry::source_slots.
    /// </summary>
    public byte is_next_part;
    /// <summary>
    /// palette entries behind those of the joints
    /// </summary>
    public Helper* helpers;
    public UIntPtr helper_count;
    /// <summary>
    /// three a helper, or none: see build_palette()
    /// </summary>
    public float* helper_centres;
    public UIntPtr helper_centre_count;
    /// <summary>
    /// as many as the geometry's
    /// </summary>
    public MeshTarget* targets;
    public UIntPtr target_count;
    /// <summary>
    /// levels 1, 2, …, ever coarser; level 0 is the mesh in full
    /// </summary>
    public MeshLod* lods;
    public UIntPtr lod_count;
    /// <summary>
    /// of the level asked for
    /// </summary>
    public Geometry geometry;
}

/// <summary>
/// A cooked file in memory. Cheap to copy; holds pointers into the block, which must outlive it and stay unchanged.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct File {
    public void* block;
    public void* sections;
    public UIntPtr section_count;
    public fixed uint numbers[26];
    public static File New() {
        File made;
        Marrow.FileInit(&made);
        return made;
    }
}

/// <summary>
/// Why a joint keeps a clip pack from fitting a skeleton.
/// </summary>
public enum Misfit : byte {
    /// <summary>
    /// the skeleton has no joint of this name
    /// </summary>
    Missing = 0,
    /// <summary>
    /// it has, below another joint
    /// </summary>
    OtherParent = 1,
    /// <summary>
    /// it has, with another rest pose, which coded tracks are relative to
    /// </summary>
    OtherRest = 2,
    /// <summary>
    /// a joint of the skeleton that the clips were made without
    /// </summary>
    Extra = 3,
    /// <summary>
    /// all joints are there, this one at another place in the order
    /// </summary>
    OtherPlace = 4,
}

/// <summary>
/// A joint that is in the way.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct JointMisfit {
    /// <summary>
    /// what is wrong with it
    /// </summary>
    public Misfit how;
    /// <summary>
    /// of the pack's reference; `extra`: of the skeleton
    /// </summary>
    public uint joint;
}

/// <summary>
/// What happens at the ends of a clip.
/// </summary>
public enum PlayMode : byte {
    /// <summary>
    /// time stops at the end
    /// </summary>
    Once = 0,
    /// <summary>
    /// time goes on from the other end; the last pose and the first are one moment
    /// </summary>
    Loop = 1,
    /// <summary>
    /// time turns round
    /// </summary>
    PingPong = 2,
}

/// <summary>
/// The state of a playing clip: plain numbers that may be set, copied and stored at will. A clip that is to run
/// backwards once begins with time_s = its duration.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Playback {
    /// <summary>
    /// in the clip
    /// </summary>
    public double time_s;
    /// <summary>
    /// seconds of the clip a second; 0 pauses, below 0 runs backwards
    /// </summary>
    public float speed;
    /// <summary>
    /// what happens at the ends
    /// </summary>
    public PlayMode mode;
    /// <summary>
    /// ping_pong: on the way back, so time runs against speed
    /// </summary>
    public byte returning;
    /// <summary>
    /// Of the last advance(). loop: how often time went from the clip's end to its start, less how often the other way
    /// round; ping_pong: how often time turned; once: 0. Stops at ±2147483647.
    /// </summary>
    public int turns;
    public static Playback New() {
        Playback made;
        Marrow.PlaybackInit(&made);
        return made;
    }
}

/// <summary>
/// Which joints are sampled.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SampleOptions {
    /// <summary>
    /// A level of detail, or any set of joints: joint j is bit j % 32 of word j / 32; at least ⌈joint_count / 32⌉ words.
    /// Joints whose bit is 0 keep what `out` holds. Empty: all joints. Every group of four without a joint of the set
    /// costs a few operations only.
    /// </summary>
    public uint* joints;
    public UIntPtr joint_count;
    public static SampleOptions New() {
        SampleOptions made;
        Marrow.SampleOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// What an instance that plays a clip keeps between two calls of sample_cached(). {} keeps nothing yet. All but `memory`
/// is sample_cached()'s own.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SampleCache {
    /// <summary>
    /// The caller's, 16-byte aligned: two unpacked frames of the clip, so that times between them are not unpacked again.
    /// With less than sample_cache_bytes() of a clip, or none, only what does not move is kept of it.
    /// </summary>
    public void* memory;
    public UIntPtr memory_bytes;
    /// <summary>
    /// where the last call wrote
    /// </summary>
    public SoaTransform* @out;
    /// <summary>
    /// which clip
    /// </summary>
    public ulong clip;
    /// <summary>
    /// that is unpacked; 0xFFFFFFFF: none
    /// </summary>
    public uint frame;
    /// <summary>
    /// for this clip's frames
    /// </summary>
    public byte room;
    public static SampleCache New() {
        SampleCache made;
        Marrow.SampleCacheInit(&made);
        return made;
    }
}

/// <summary>
/// How values run between two keys, and what a key holds. N is Curve::components, u goes 0 … 1 from one key to the next.
/// </summary>
public enum CurveKind : byte {
    /// <summary>
    /// key: value. The earlier key's value
    /// </summary>
    Step = 0,
    /// <summary>
    /// key: value. A straight line; for rotations the shorter great arc (slerp)
    /// </summary>
    Linear = 1,
    /// <summary>
    /// key: in-tangent, value, out-tangent; tangents per second, as glTF 2.0 CUBICSPLINE has it
    /// </summary>
    Hermite = 2,
    /// <summary>
    /// value, one control point, value, one control point, … value; Bernstein form
    /// </summary>
    QuadraticBezier = 3,
    /// <summary>
    /// value, two control points, value, two control points, … value; Bernstein form
    /// </summary>
    CubicBezier = 4,
    /// <summary>
    /// key: value. Uniform; Catmull and Rom 1974: the tangent at P1 is (P2 - P0) / 2 a key interval
    /// </summary>
    CatmullRom = 5,
    /// <summary>
    /// key: value. Catmull-Rom with knots √|P2 - P1| apart; Barry and Goldman, SIGGRAPH 1988, and
    /// Yuksel, Schaefer and Keyser 2011: no cusps or loops between two keys. Keys less than 1e18 apart
    /// </summary>
    Centripetal = 6,
}

/// <summary>
/// How a patch's points shape it.
/// </summary>
public enum PatchBasis : byte {
    /// <summary>
    /// through its inner points: u, v = 0 … 1 lead from point (1, 1) to point (2, 2)
    /// </summary>
    CatmullRom = 0,
    /// <summary>
    /// through its corners: from point (0, 0) to point (3, 3)
    /// </summary>
    Bezier = 1,
}

/// <summary>
/// R. Penner's easings (Programming Macromedia Flash MX, 2002, chapter 7).
/// </summary>
public enum Easing : byte {
    Linear = 0,
    Quad = 1,
    Cubic = 2,
    Quart = 3,
    Quint = 4,
    Sine = 5,
    Expo = 6,
    Circ = 7,
    Back = 8,
    Elastic = 9,
    Bounce = 10,
}

/// <summary>
/// At which end a movement is eased.
/// </summary>
public enum EaseMode : byte {
    In = 0,
    Out = 1,
    InOut = 2,
}

/// <summary>
/// Keys, as a view. catmull_rom and centripetal draw a smooth path whatever the times are, but its velocity is
/// continuous only where key intervals are even (or go with √distance, centripetal); for motion that is smooth over
/// uneven keys make a spline. Beyond the first and last key they continue with a mirrored point, so that the path leaves
/// and arrives straight.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Curve {
    /// <summary>
    /// what lies between keys
    /// </summary>
    public CurveKind kind;
    /// <summary>
    /// Values are unit quaternions x, y, z, w; components is 4. Every key and control point is taken with the sign that is
    /// nearer to the one before it, and what comes out is normalised; its sign is open, as q and -q are the same rotation.
    /// A blend that has no direction gives the earlier key's.
    /// </summary>
    public byte rotation;
    /// <summary>
    /// floats a value: 1 … 4
    /// </summary>
    public uint components;
    /// <summary>
    /// one a key, strictly increasing; seconds, or whatever the curve runs over
    /// </summary>
    public float* times_s;
    public UIntPtr time_count;
    /// <summary>
    /// curve_value_count() floats
    /// </summary>
    public float* values;
    public UIntPtr value_count;
    public static Curve New() {
        Curve made;
        Marrow.CurveInit(&made);
        return made;
    }
}

/// <summary>
/// Arc length: where on a path to be for its speed to be even.
///
/// The table holds the length of the path up to each of `steps` equal parts of every key interval.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct ArcLength {
    /// <summary>
    /// a key interval, at least 1
    /// </summary>
    public uint steps;
    /// <summary>
    /// arc_length_count() of them, ascending
    /// </summary>
    public float* lengths;
    public UIntPtr length_count;
    public static ArcLength New() {
        ArcLength made;
        Marrow.ArcLengthInit(&made);
        return made;
    }
}

/// <summary>
/// The timing function of CSS Easing Functions Level 1: the cubic Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1), y
/// over x.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct CubicBezierEase {
    /// <summary>
    /// CSS "ease"
    /// </summary>
    public float x1;
    /// <summary>
    /// CSS "ease"
    /// </summary>
    public float y1;
    /// <summary>
    /// CSS "ease"
    /// </summary>
    public float x2;
    /// <summary>
    /// CSS "ease"
    /// </summary>
    public float y2;
    public static CubicBezierEase New() {
        CubicBezierEase made;
        Marrow.CubicBezierEaseInit(&made);
        return made;
    }
}

/// <summary>
/// A pose and how much of it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct BlendLayer {
    /// <summary>
    /// at least skeleton.soa_size()
    /// </summary>
    public SoaTransform* pose;
    public UIntPtr pose_count;
    /// <summary>
    /// 0 … kMaxBlendWeight in blend(), 0 … 1 in overlay()
    /// </summary>
    public float weight;
    /// <summary>
    /// A factor for each joint's weight, 0 … 1: below 0 and NaN count as 0, above 1 as 1. Empty: 1 for every joint;
    /// else at least 4 · skeleton.soa_size() floats, in joint order, so that a group's factors are read at once.
    /// </summary>
    public float* mask;
    public UIntPtr mask_count;
    public static BlendLayer New() {
        BlendLayer made;
        Marrow.BlendLayerInit(&made);
        return made;
    }
}

/// <summary>
/// A change, and how much of it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct AdditiveLayer {
    /// <summary>
    /// at least skeleton.soa_size()
    /// </summary>
    public AdditiveTransform* change;
    public UIntPtr change_count;
    /// <summary>
    /// 0 … 1
    /// </summary>
    public float weight;
    /// <summary>
    /// as in BlendLayer
    /// </summary>
    public float* mask;
    public UIntPtr mask_count;
    public static AdditiveLayer New() {
        AdditiveLayer made;
        Marrow.AdditiveLayerInit(&made);
        return made;
    }
}

/// <summary>
/// How a weight goes from 0 to 1; u = time / duration. curve.h has more shapes.
/// </summary>
public enum Fade : byte {
    /// <summary>
    /// u
    /// </summary>
    Linear = 0,
    /// <summary>
    /// 3 u² - 2 u³: no jump of speed
    /// </summary>
    Smoothstep = 1,
    /// <summary>
    /// 6 u⁵ - 15 u⁴ + 10 u³: no jump of acceleration
    /// </summary>
    Smootherstep = 2,
}

/// <summary>
/// How far four joints are from the new clip's pose, and how that fades. Each of the nine components of a joint, x y z
/// of the translation, of the rotation vector (axis times angle, in the parent's axes) and of the scale, fades by
/// itself:
///   offset(t) = (1 - s)⁴ (start + slope s) with s = min(rate t, 1).
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 432)]
public unsafe struct InertialOffset {
    /// <summary>
    /// metres, radians, factors
    /// </summary>
    public fixed float start[36];
    /// <summary>
    /// over the whole fade
    /// </summary>
    public fixed float slope[36];
    /// <summary>
    /// 1 / seconds
    /// </summary>
    public fixed float rate[36];
}

/// <summary>
/// A transition under way; the memory is the caller's and can be used again for the next one.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Inertia {
    /// <summary>
    /// at least skeleton.soa_size()
    /// </summary>
    public InertialOffset* offsets;
    public UIntPtr offset_count;
    /// <summary>
    /// 0: none, or over
    /// </summary>
    public float duration_s;
    public static Inertia New() {
        Inertia made;
        Marrow.InertiaInit(&made);
        return made;
    }
}

/// <summary>
/// What was shown in the last two frames, and what the new clip would show.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct InertialStart {
    /// <summary>
    /// shown one frame earlier
    /// </summary>
    public SoaTransform* before;
    public UIntPtr before_count;
    /// <summary>
    /// shown last
    /// </summary>
    public SoaTransform* now;
    public UIntPtr now_count;
    /// <summary>
    /// the new clip at the time of `now`
    /// </summary>
    public SoaTransform* target;
    public UIntPtr target_count;
    /// <summary>
    /// the new clip one frame earlier; empty: taken to stand still
    /// </summary>
    public SoaTransform* target_was;
    public UIntPtr target_was_count;
    /// <summary>
    /// between the two, &gt; 0; less than 1e-6 counts as that
    /// </summary>
    public float frame_s;
    public static InertialStart New() {
        InertialStart made;
        Marrow.InertialStartInit(&made);
        return made;
    }
}

/// <summary>
/// A limit as people think of it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct LimitDescription {
    /// <summary>
    /// its shape
    /// </summary>
    public LimitKind kind;
    /// <summary>
    /// of euler
    /// </summary>
    public AxisOrder order;
    /// <summary>
    /// the local rotation where all angles are 0: most often the joint's rest
    /// </summary>
    public fixed float zero[4];
    /// <summary>
    /// the limit's x in the joint's axes: a hinge's axis, or what a cone points along
    /// </summary>
    public fixed float axis[3];
    /// <summary>
    /// its y, made perpendicular to x
    /// </summary>
    public fixed float across[3];
    /// <summary>
    /// hinge: the first is the angle. Cone: the first is the twist; of the second and third, swings about y and z, `most`
    /// is the half-width, and `least` its negative. Euler: the three angles.
    /// </summary>
    public fixed float least_rad[3];
    /// <summary>
    /// as least_rad
    /// </summary>
    public fixed float most_rad[3];
    /// <summary>
    /// 0: none
    /// </summary>
    public RateLimit rate;
    public static LimitDescription New() {
        LimitDescription made;
        Marrow.LimitDescriptionInit(&made);
        return made;
    }
}

/// <summary>
/// Limits over time. What follows a target with limited speed and acceleration: plain numbers, one for each rotation or
/// point that follows. A new one, one set to `{}`, and one whose numbers no call has left begins anew: the next call
/// takes its target as it is, at rest.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct RotationFollower {
    /// <summary>
    /// where it is: x y z w
    /// </summary>
    public fixed float rotation[4];
    /// <summary>
    /// of the last call
    /// </summary>
    public fixed float target[4];
    /// <summary>
    /// radians a second, about the parent's axes
    /// </summary>
    public fixed float velocity[3];
    /// <summary>
    /// of the last call
    /// </summary>
    public float frame_s;
    /// <summary>
    /// follow_rotation()'s own
    /// </summary>
    public uint mode;
    public static RotationFollower New() {
        RotationFollower made;
        Marrow.RotationFollowerInit(&made);
        return made;
    }
}

/// <summary>
/// A point that follows another.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct PointFollower {
    /// <summary>
    /// where it is, metres
    /// </summary>
    public fixed float point[3];
    /// <summary>
    /// of the last call
    /// </summary>
    public fixed float target[3];
    /// <summary>
    /// metres a second
    /// </summary>
    public fixed float velocity[3];
    /// <summary>
    /// of the last call
    /// </summary>
    public float frame_s;
    /// <summary>
    /// follow_point()'s own
    /// </summary>
    public uint mode;
    public static PointFollower New() {
        PointFollower made;
        Marrow.PointFollowerInit(&made);
        return made;
    }
}

/// <summary>
/// What is asked of a limb: start, middle and end joint, such as hip, knee and ankle.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 64)]
public unsafe struct TwoBone {
    /// <summary>
    /// where the end joint is to be; scene, metres
    /// </summary>
    public fixed float target[3];
    /// <summary>
    /// 0 … 1: 0 changes no bit, 1 reaches; between, both turns are blended
    /// </summary>
    public float weight;
    /// <summary>
    /// The direction, from the start joint, to whose side the middle joint points; scene. Zero: the side it has in the
    /// pose, carried along the shortest way. Less than 0.1 rad off the direction of the target a pole says little, and
    /// the answer goes over to a side of 37° from that of the pose: a target that goes over the pole in the plane of the
    /// pose swings the limb round, and does not make it jump.
    /// </summary>
    public fixed float pole[3];
    /// <summary>
    /// turns the limb about the line from start to target, away from the pole; a few turns at most
    /// </summary>
    public float twist_rad;
    /// <summary>
    /// About what the middle joint bends, by positive angles; in its local space. Says which way a straight limb bends,
    /// and which way it is to bend if the pose has it bent the other way. Zero: as in the pose, and a straight limb
    /// towards the pole.
    /// </summary>
    public fixed float bend_axis[3];
    /// <summary>
    /// The share of the limb's length from which on it stretches ever more slowly, 0 … 1, so that the middle joint does
    /// not snap when the target goes out of reach. 1: straight to full stretch, and the target is reached exactly to
    /// there; 0.97 is a usual choice.
    /// </summary>
    public float soft;
    /// <summary>
    /// ≥ 1: the bones may be this many times as long, if the target is reached no other way
    /// </summary>
    public float max_stretch;
    public static TwoBone New() {
        byte* room = stackalloc byte[80];
        TwoBone* made = (TwoBone*)(((ulong)room + 15) / 16 * 16);
        Marrow.TwoBoneInit(made);
        return *made;
    }
}

/// <summary>
/// Unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 48)]
public unsafe struct TwoBoneTurns {
    /// <summary>
    /// of the start joint
    /// </summary>
    public fixed float start[4];
    /// <summary>
    /// of the middle joint
    /// </summary>
    public fixed float mid[4];
    /// <summary>
    /// for the translations of all joints from below start down to end; 1: unless max_stretch &gt; 1
    /// </summary>
    public float stretch;
    /// <summary>
    /// The target is within reach: at weight 1 the end comes to it within 1e-4 of the limb's length.
    /// </summary>
    public byte reached;
}

/// <summary>
/// The scene matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct TwoBoneJoints {
    /// <summary>
    /// hip, shoulder
    /// </summary>
    public Affine* start;
    /// <summary>
    /// knee, elbow
    /// </summary>
    public Affine* mid;
    /// <summary>
    /// ankle, wrist
    /// </summary>
    public Affine* end;
    public static TwoBoneJoints New() {
        TwoBoneJoints made;
        Marrow.TwoBoneJointsInit(&made);
        return made;
    }
}

/// <summary>
/// Joints of a skeleton; other joints may lie between them.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct TwoBoneLimb {
    /// <summary>
    /// hip, knee and ankle
    /// </summary>
    public uint start;
    /// <summary>
    /// hip, knee and ankle
    /// </summary>
    public uint mid;
    /// <summary>
    /// hip, knee and ankle
    /// </summary>
    public uint end;
    public static TwoBoneLimb New() {
        TwoBoneLimb made;
        Marrow.TwoBoneLimbInit(&made);
        return made;
    }
}

/// <summary>
/// What is asked of a joint that looks or points at something: an eye, a head, a gun.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 80)]
public unsafe struct Aim {
    /// <summary>
    /// scene, metres
    /// </summary>
    public fixed float target[3];
    /// <summary>
    /// 0 … 1: 0 changes no bit, 1 aims
    /// </summary>
    public float weight;
    /// <summary>
    /// The scene direction to whose side of the target's direction `up` is turned. Zero: nothing is; the shortest way to
    /// the target is taken. Less than 0.1 rad off the target's direction it says little, as a TwoBone's pole.
    /// </summary>
    public fixed float pole[3];
    /// <summary>
    /// turns about the direction of the target, on top; a few turns at most
    /// </summary>
    public float twist_rad;
    /// <summary>
    /// what is to go through the target; in the joint's local space
    /// </summary>
    public fixed float forward[3];
    /// <summary>
    /// local; not along forward. Of no use without a pole
    /// </summary>
    public fixed float up[3];
    /// <summary>
    /// where forward begins: an eye before the head's joint; local
    /// </summary>
    public fixed float offset[3];
    public static Aim New() {
        byte* room = stackalloc byte[96];
        Aim* made = (Aim*)(((ulong)room + 15) / 16 * 16);
        Marrow.AimInit(made);
        return *made;
    }
}

/// <summary>
/// What aim() gives.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 32)]
public unsafe struct AimTurn {
    /// <summary>
    /// a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
    /// </summary>
    public fixed float turn[4];
    /// <summary>
    /// The target can be seen: at weight 1 the ray from the offset along forward goes through it. It cannot where the
    /// target is nearer to the joint than the ray ever gets, or than the offset, or where forward has no length.
    /// </summary>
    public byte reached;
}

/// <summary>
/// How solve_ik() solves; docs/ik/solvers.md says which is for what.
/// </summary>
public enum IkMethod : byte {
    Fabrik = 0,
    Ccd = 1,
    DampedLeastSquares = 2,
    GaussNewton = 3,
}

/// <summary>
/// Why a solver stopped.
/// </summary>
public enum IkStop : byte {
    /// <summary>
    /// the error is less than the tolerance
    /// </summary>
    Reached = 0,
    /// <summary>
    /// nothing moved any more: the target is out of reach, or goals contradict each other
    /// </summary>
    Stalled = 1,
    /// <summary>
    /// max_iterations are over
    /// </summary>
    Iterations = 2,
}

/// <summary>
/// Where a point of a joint shall be, how the joint shall be turned, or both. What counts of a goal is its weights: 0
/// and it does not, of twice the weight and it gives way half as far where goals contradict each other.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct IkGoal {
    /// <summary>
    /// of the skeleton
    /// </summary>
    public ushort joint;
    /// <summary>
    /// 0 first; what is less urgent never disturbs what is more so. Jacobian methods only
    /// </summary>
    public byte priority;
    /// <summary>
    /// the point of the joint that shall reach `position`; the joint's space, metres
    /// </summary>
    public fixed float offset[3];
    /// <summary>
    /// scene space, metres
    /// </summary>
    public fixed float position[3];
    /// <summary>
    /// of the joint's axes, in scene space: a unit quaternion x, y, z, w
    /// </summary>
    public fixed float rotation[4];
    /// <summary>
    /// 0 … 100
    /// </summary>
    public float position_weight;
    /// <summary>
    /// metres a radian: the distance that is as bad as being turned wrong by a radian
    /// </summary>
    public float rotation_weight;
    public static IkGoal New() {
        IkGoal made;
        Marrow.IkGoalInit(&made);
        return made;
    }
}

/// <summary>
/// What is asked of a pose.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct IkProblem {
    /// <summary>
    /// at least one that counts
    /// </summary>
    public IkGoal* goals;
    public UIntPtr goal_count;
    /// <summary>
    /// that may turn: ascending, so that parents come first. Others are stiff
    /// </summary>
    public ushort* joints;
    public UIntPtr joint_count;
    /// <summary>
    /// one of each of `joints`: 0 turns freely … 1 not at all; empty: all are free
    /// </summary>
    public float* stiffness;
    public UIntPtr stiffness_count;
    /// <summary>
    /// Joints ascending, as in a skeleton; those of joints that do not turn are left out.
    /// </summary>
    public JointLimit* limits;
    public UIntPtr limit_count;
    /// <summary>
    /// Where a chain with one goal shall bend to, as a knee forward: the middle of its joints faces this point as nearly
    /// as a turn about the line from the first joint to the goal lets it. Of weight 0 … 1. FABRIK and CCD only.
    /// scene space, metres
    /// </summary>
    public fixed float pole[3];
    /// <summary>
    /// 0: no pole
    /// </summary>
    public float pole_weight;
    /// <summary>
    /// By how many metres joints[0] is moved as easily as a joint is turned by a radian: the pelvis of a full body. 0: it
    /// stays. Jacobian methods only.
    /// </summary>
    public float root_travel_m;
    public static IkProblem New() {
        IkProblem made;
        Marrow.IkProblemInit(&made);
        return made;
    }
}

/// <summary>
/// How it is solved.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct IkOptions {
    /// <summary>
    /// see docs/ik/solvers.md
    /// </summary>
    public IkMethod method;
    /// <summary>
    /// How many poses to start from at most, as long as the goals are not reached: the one that there is, then others in
    /// which joints are turned at random, by `seed`. For sets of limits in which one start ends in a corner. More than 1
    /// costs as many times as much where goals are out of reach, and the result may jump as goals move.
    /// </summary>
    public byte starts;
    /// <summary>
    /// the most there are
    /// </summary>
    public ushort max_iterations;
    /// <summary>
    /// an error (see IkReport) of less ends the iteration
    /// </summary>
    public float tolerance_m;
    /// <summary>
    /// of the Jacobian methods: more is calmer and slower
    /// </summary>
    public float damping;
    /// <summary>
    /// of `starts` and of solve_ik_genetic: the same seed, the same result
    /// </summary>
    public uint seed;
    /// <summary>
    /// 0 leaves every bit as it was; between, rotations lie between
    /// </summary>
    public float weight;
    /// <summary>
    /// Of FABRIK and CCD with one goal: where it is beyond reach, the bones from the first joint that turns to the goal's
    /// become longer, by up to this factor; and shorter, by up to as much, where it is too near for them. 1: they keep
    /// their lengths. Changes local translations of the joints on the way.
    /// </summary>
    public float stretch;
    public static IkOptions New() {
        IkOptions made;
        Marrow.IkOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// How a solver ended.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct IkReport {
    /// <summary>
    /// √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
    /// </summary>
    public float error_m;
    /// <summary>
    /// that it took
    /// </summary>
    public uint iterations;
    /// <summary>
    /// why it took no more
    /// </summary>
    public IkStop why;
}

/// <summary>
/// A leg. Other joints may lie between these: a hind leg of three bones is hip, knee and paw, and what is between keeps
/// its angle.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Foot {
    /// <summary>
    /// joints of the skeleton
    /// </summary>
    public uint hip;
    /// <summary>
    /// joints of the skeleton
    /// </summary>
    public uint knee;
    /// <summary>
    /// joints of the skeleton
    /// </summary>
    public uint ankle;
    /// <summary>
    /// what stands on the ground, in the ankle's space: below the ball of the foot, say
    /// </summary>
    public fixed float sole[3];
    /// <summary>
    /// of the knee; see TwoBone
    /// </summary>
    public fixed float bend_axis[3];
    /// <summary>
    /// 0 … 1
    /// </summary>
    public float weight;
    public static Foot New() {
        Foot made;
        Marrow.FootInit(&made);
        return made;
    }
}

/// <summary>
/// Two legs or more. The clips have been made for level ground, through the scene's origin.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Feet {
    /// <summary>
    /// two or more
    /// </summary>
    public Foot* feet;
    public UIntPtr foot_count;
    /// <summary>
    /// moved up and down, with all that hangs on it, the hips too; none: stays
    /// </summary>
    public uint pelvis;
    /// <summary>
    /// ≥ 0: by how much at most it goes down, or up; world
    /// </summary>
    public float lower_m;
    /// <summary>
    /// 0 … 1: it goes down, too, where a leg would be longer than this share of its bones
    /// </summary>
    public float reach;
    /// <summary>
    /// 0 … 1.5: by how much at most a foot leans with the ground
    /// </summary>
    public float slope_rad;
    /// <summary>
    /// &gt; 0: the time in which all but 2 % of a step in the ground, or of a release, is over
    /// </summary>
    public float ease_s;
    public static Feet New() {
        Feet made;
        Marrow.FeetInit(&made);
        return made;
    }
}

/// <summary>
/// What the game knows of a foot in this frame; world.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct FootGround {
    /// <summary>
    /// false: as if the ground were level at the height of the scene's origin
    /// </summary>
    public byte hit;
    /// <summary>
    /// of a ray along `up` through foot_sole(), or anywhere on the plane that it hit
    /// </summary>
    public fixed float point[3];
    /// <summary>
    /// of any length; steeper than 80°: no hit
    /// </summary>
    public fixed float normal[3];
    /// <summary>
    /// the sole stays at its place until this is false again
    /// </summary>
    public byte planted;
    public static FootGround New() {
        FootGround made;
        Marrow.FootGroundInit(&made);
        return made;
    }
}

/// <summary>
/// The motion of one foot: plain numbers. A new one, one set to `{}`, and one whose numbers are out of hand begins where
/// the animation has the foot. World; on a moving platform, let the world be the platform.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct FootMotion {
    /// <summary>
    /// of the sole, as shown last
    /// </summary>
    public fixed float place[3];
    /// <summary>
    /// of the sole from its target
    /// </summary>
    public fixed float offset[3];
    /// <summary>
    /// of the sole from its target
    /// </summary>
    public fixed float offset_speed[3];
    /// <summary>
    /// of the ground's normal that the foot leans by from the ground's own
    /// </summary>
    public fixed float lean[3];
    /// <summary>
    /// of the ground's normal that the foot leans by from the ground's own
    /// </summary>
    public fixed float lean_speed[3];
    /// <summary>
    /// the ground, last
    /// </summary>
    public fixed float point[3];
    /// <summary>
    /// the ground, last
    /// </summary>
    public fixed float normal[3];
    /// <summary>
    /// level: of the ankle's axis `axis` when it was planted
    /// </summary>
    public fixed float heading[3];
    /// <summary>
    /// about up, from the animated to the planted heading
    /// </summary>
    public fixed float turn[4];
    /// <summary>
    /// how much of it is left
    /// </summary>
    public float turn_share;
    /// <summary>
    /// how much of it is left
    /// </summary>
    public float turn_share_speed;
    /// <summary>
    /// whether it is planted, and was begun
    /// </summary>
    public byte axis;
    /// <summary>
    /// whether it is planted, and was begun
    /// </summary>
    public byte planted;
    /// <summary>
    /// whether it is planted, and was begun
    /// </summary>
    public byte begun;
    /// <summary>
    /// whether its ray found ground
    /// </summary>
    public byte hit;
    /// <summary>
    /// whether the leg was long enough
    /// </summary>
    public byte reached;
    public static FootMotion New() {
        FootMotion made;
        Marrow.FootMotionInit(&made);
        return made;
    }
}

/// <summary>
/// What place_feet() is told of a frame.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 96)]
public unsafe struct FeetFrame {
    /// <summary>
    /// since the last frame
    /// </summary>
    public float dt_s;
    fixed byte padding1[12];
    /// <summary>
    /// Where the character stands: a turn, one scale above 0, a shift.
    /// </summary>
    public Affine world_from_scene;
    /// <summary>
    /// a unit vector; world
    /// </summary>
    public fixed float up[3];
    /// <summary>
    /// feet begin anew, none is planted where it was
    /// </summary>
    public byte teleported;
    /// <summary>
    /// 0 … 1, times each foot's; the motion goes on
    /// </summary>
    public float weight;
    public static FeetFrame New() {
        byte* room = stackalloc byte[112];
        FeetFrame* made = (FeetFrame*)(((ulong)room + 15) / 16 * 16);
        Marrow.FeetFrameInit(made);
        return *made;
    }
}

public struct SpringGroup {}

public struct SpringRoot {}

public struct JointRange {}

/// <summary>
/// Chains of one character. To keep or to copy a motion, copy the memory.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Springs {
    /// <summary>
    /// four bones each
    /// </summary>
    public SpringGroup* groups;
    /// <summary>
    /// a chain each
    /// </summary>
    public SpringRoot* roots;
    /// <summary>
    /// joints whose matrices springs change
    /// </summary>
    public JointRange* below;
    /// <summary>
    /// of each of them
    /// </summary>
    public uint group_count;
    /// <summary>
    /// likewise
    /// </summary>
    public uint root_count;
    /// <summary>
    /// likewise
    /// </summary>
    public uint below_count;
    /// <summary>
    /// of the skeleton
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// time of frames that were too short
    /// </summary>
    public float saved_s;
    public static Springs New() {
        Springs made;
        Marrow.SpringsInit(&made);
        return made;
    }
}

/// <summary>
/// What simulate_springs() is told of a frame.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SpringFrame {
    /// <summary>
    /// since the last frame
    /// </summary>
    public float dt_s;
    fixed byte padding1[12];
    /// <summary>
    /// Where the character stands: a turn, one scale, a shift. Motion in the world is felt, by this and by the pose.
    /// </summary>
    public Affine world_from_scene;
    /// <summary>
    /// m/s², world
    /// </summary>
    public fixed float gravity[3];
    /// <summary>
    /// m/s, world; acts by `drag`
    /// </summary>
    public fixed float wind[3];
    /// <summary>
    /// at most kMaxSpringColliders
    /// </summary>
    public SpringCollider* colliders;
    public UIntPtr collider_count;
    /// <summary>
    /// chains whose first joint moves further than this in one frame are moved along …
    /// </summary>
    public float teleport_m;
    /// <summary>
    /// … and so are all if this is set
    /// </summary>
    public byte teleported;
    /// <summary>
    /// 0 … 1, times each joint's
    /// </summary>
    public float weight;
    fixed byte padding[12];
    public static SpringFrame New() {
        byte* room = stackalloc byte[144];
        SpringFrame* made = (SpringFrame*)(((ulong)room + 15) / 16 * 16);
        Marrow.SpringFrameInit(made);
        return *made;
    }
}

/// <summary>
/// An instance's vertices, in the caller's memory. Copies are views of the same vertices.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MorphedGeometry {
    /// <summary>
    /// as the bind geometry, but that skin, normals and tangents are the instance's own
    /// </summary>
    public Geometry geometry;
    /// <summary>
    /// as the file has it
    /// </summary>
    public Geometry bind;
    /// <summary>
    /// a block's first float in the skin; one more for the end
    /// </summary>
    public uint* offsets;
    /// <summary>
    /// a bit a block: differs from the bind pose
    /// </summary>
    public uint* moved;
    /// <summary>
    /// a bit a block: written since morph_coordinates()
    /// </summary>
    public uint* changed;
    /// <summary>
    /// one, MorphAttributes: what differs in the blocks moved
    /// </summary>
    public uint* attributes;
}

/// <summary>
/// A line to draw; scene space.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct DebugLine {
    /// <summary>
    /// its ends, metres
    /// </summary>
    public fixed float from[3];
    /// <summary>
    /// its ends, metres
    /// </summary>
    public fixed float to[3];
    /// <summary>
    /// r g b a
    /// </summary>
    public fixed byte colour[4];
    public static DebugLine New() {
        DebugLine made;
        Marrow.DebugLineInit(&made);
        return made;
    }
}

/// <summary>
/// Room for lines in the caller's memory. The calls below append to it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct DebugLines {
    /// <summary>
    /// the caller's
    /// </summary>
    public DebugLine* room;
    public UIntPtr room_count;
    /// <summary>
    /// of lines that are there, from the front
    /// </summary>
    public UIntPtr count;
    /// <summary>
    /// for which there was no room
    /// </summary>
    public UIntPtr left_out;
    public static DebugLines New() {
        DebugLines made;
        Marrow.DebugLinesInit(&made);
        return made;
    }
}

/// <summary>
/// The vertices of the bind pose that a palette entry has a weight in, as a box in mesh space.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct JointReach {
    /// <summary>
    /// the box's middle
    /// </summary>
    public fixed float centre[3];
    /// <summary>
    /// ≥ 0; below 0: nothing follows this entry
    /// </summary>
    public fixed float half[3];
}

/// <summary>
/// What a morph target (or an example of pose-space deformation) adds to vertices at weight 1: a box about all changes
/// and about 0, in mesh space.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct MorphReach {
    /// <summary>
    /// ≤ 0
    /// </summary>
    public fixed float least[3];
    /// <summary>
    /// ≥ 0
    /// </summary>
    public fixed float most[3];
}

/// <summary>
/// Views into the caller's memory.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Reach {
    /// <summary>
    /// one a palette entry, helpers behind
    /// </summary>
    public JointReach* joints;
    public UIntPtr joint_count;
    /// <summary>
    /// one a morph target
    /// </summary>
    public MorphReach* targets;
    public UIntPtr target_count;
    /// <summary>
    /// the sum of what all examples may add
    /// </summary>
    public MorphReach pose_space;
}

/// <summary>
/// How bind-pose normals and tangents get to the deformed surface. M is the 3×3 part of the vertex's blended matrix.
/// </summary>
public enum NormalTransform : byte {
    /// <summary>
    /// Normals through the inverse transpose of M (its cofactors), tangents through M, both unit: exact for any blend that
    /// can be inverted, mirrored or unevenly scaled ones too.
    /// </summary>
    InverseTranspose = 0,
    /// <summary>
    /// Both through M, their length left as it comes: half the time, for shaders that normalise anyway. Right in direction
    /// where M is a rotation, a mirror or an even scale; a blend of rotations is none of these quite. On real clips
    /// normals stray by 0.8° on average, by up to 58° inside sharp bends, and come as short as 0.27
    /// (docs/benchmarks.md). Tangents are inverse_transpose's up to length.
    /// </summary>
    BlendedMatrix = 1,
}

/// <summary>
/// Where skinned vertices go: the caller's memory, slot after slot.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct SkinOutput {
    /// <summary>
    /// 3 a slot; required
    /// </summary>
    public float* positions;
    public UIntPtr position_count;
    /// <summary>
    /// 3 a slot; leave empty to skip
    /// </summary>
    public float* normals;
    public UIntPtr normal_count;
    /// <summary>
    /// 4 a slot: xyz, then the handedness, turned where the blend mirrors. (SSD and animation space with blended_matrix
    /// ask the run's last joint, not the blend: only a vertex between mirrored and unmirrored joints can tell.) Needs
    /// normals. Leave empty to skip.
    /// </summary>
    public float* tangents;
    public UIntPtr tangent_count;
    /// <summary>
    /// of tangents, too
    /// </summary>
    public NormalTransform normal_transform;
    public static SkinOutput New() {
        SkinOutput made;
        Marrow.SkinOutputInit(&made);
        return made;
    }
}

/// <summary>
/// A mesh in animation space, for as_tangents().
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct AsPart {
    /// <summary>
    /// cooked with animation space
    /// </summary>
    public Mesh* mesh;
    /// <summary>
    /// from as_coordinates()
    /// </summary>
    public float* coordinates;
    public UIntPtr coordinate_count;
    /// <summary>
    /// as_tangent_count() floats, to be written
    /// </summary>
    public float* tangents;
    public UIntPtr tangent_count;
    public static AsPart New() {
        AsPart made;
        Marrow.AsPartInit(&made);
        return made;
    }
}

/// <summary>
/// What the skeletons of a character play together: a clip each, or none. Plain pointers, which a game may fill itself.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Animation {
    /// <summary>
    /// that they are from: the character's file, or a clip pack
    /// </summary>
    public File clips;
    /// <summary>
    /// of the longest
    /// </summary>
    public float duration_s;
    /// <summary>
    /// One a skeleton of the character: which clip it plays; kNoClip: it rests.
    /// </summary>
    public uint* clip_of_skeleton;
    public UIntPtr clip_of_skeleton_count;
    /// <summary>
    /// One a morph target of the character, mesh after mesh: from find_weight_channels() with the clip that the mesh's
    /// skeleton plays.
    /// </summary>
    public uint* channels;
    public UIntPtr channel_count;
}

/// <summary>
/// All animations of a file, by name.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Animations {
    /// <summary>
    /// One a clip, with the index that the clip has: the clip, and of each other skeleton the first with the same name.
    /// A clip without a name has nothing to do with others.
    /// </summary>
    public Animation* all;
    public UIntPtr all_count;
}

/// <summary>
/// What a character is made for.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct CharacterOptions {
    /// <summary>
    /// that are blended at once, at most; at least 1
    /// </summary>
    public uint layers;
    /// <summary>
    /// of detail, as in File::mesh
    /// </summary>
    public uint level;
    /// <summary>
    /// on the CPU; false: neither palettes nor morphed vertices, a gles3::Skinner has them
    /// </summary>
    public byte skin;
    /// <summary>
    /// skin by skin_as(), too
    /// </summary>
    public byte animation_space;
    public static CharacterOptions New() {
        CharacterOptions made;
        Marrow.CharacterOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// A skeleton and its pose in both forms. What changes one between pose_character() and finish_character() must keep
/// the other alike; all calls of stage 3½ do.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct CharacterSkeleton {
    /// <summary>
    /// of the file
    /// </summary>
    public Skeleton skeleton;
    /// <summary>
    /// skeleton.soa_size()
    /// </summary>
    public SoaTransform* local;
    public UIntPtr local_count;
    /// <summary>
    /// skeleton.joint_count
    /// </summary>
    public Affine* scene_from_joint;
    public UIntPtr scene_from_joint_count;
    /// <summary>
    /// sample_character()'s own, one a layer: a pose, and what is kept of the clip that it is of.
    /// </summary>
    public SoaTransform* sampled;
    public UIntPtr sampled_count;
    /// <summary>
    /// as `sampled`
    /// </summary>
    public SampleCache* caches;
    public UIntPtr cache_count;
}

/// <summary>
/// A mesh, ready for skin_ssd(mesh, palette, …) or skin_as(mesh, coordinates, palette, …) after finish_character().
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct CharacterMesh {
    /// <summary>
    /// of the level asked for; with `skin` its geometry is this character's own, morphed
    /// </summary>
    public Mesh mesh;
    /// <summary>
    /// of morph targets
    /// </summary>
    public float* weights;
    public UIntPtr weight_count;
    /// <summary>
    /// empty without `skin`
    /// </summary>
    public Affine* palette;
    public UIntPtr palette_count;
    /// <summary>
    /// empty without `skin` and `animation_space`
    /// </summary>
    public float* coordinates;
    public UIntPtr coordinate_count;
    /// <summary>
    /// with `skin`
    /// </summary>
    public MorphedGeometry morphed;
    /// <summary>
    /// what it lies in
    /// </summary>
    public void* vertices;
    public UIntPtr vertices_bytes;
    /// <summary>
    /// in Animation::channels
    /// </summary>
    public uint first_target;
}

/// <summary>
/// Views into the caller's memory. A copy is the same character.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Character {
    /// <summary>
    /// as it was given
    /// </summary>
    public File file;
    /// <summary>
    /// as they were given
    /// </summary>
    public CharacterOptions options;
    /// <summary>
    /// all of the file, in its order
    /// </summary>
    public CharacterSkeleton* skeletons;
    public UIntPtr skeleton_count;
    /// <summary>
    /// all of the file, in its order
    /// </summary>
    public CharacterMesh* meshes;
    public UIntPtr mesh_count;
    /// <summary>
    /// of morph targets, of all meshes
    /// </summary>
    public uint target_count;
    /// <summary>
    /// Scratch, of the largest skeleton.
    /// </summary>
    public BlendLayer* blended;
    public UIntPtr blended_count;
    /// <summary>
    /// of the same size
    /// </summary>
    public AdditiveTransform* change;
    public UIntPtr change_count;
}

/// <summary>
/// An animation at a time, and how much of it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct AnimationLayer {
    /// <summary>
    /// made for the character's file
    /// </summary>
    public Animation* animation;
    /// <summary>
    /// see playback.h
    /// </summary>
    public float time_s;
    /// <summary>
    /// 0 … kMaxBlendWeight
    /// </summary>
    public float weight;
    public static AnimationLayer New() {
        AnimationLayer made;
        Marrow.AnimationLayerInit(&made);
        return made;
    }
}

/// <summary>
/// Of one skeleton of an outfit: what it follows.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct OutfitSkeleton {
    /// <summary>
    /// of the body's character
    /// </summary>
    public uint body_skeleton;
    /// <summary>
    /// one a joint of the outfit; see bind_outfit()
    /// </summary>
    public ushort* body_joints;
    public UIntPtr body_joint_count;
}

/// <summary>
/// What characters of one file, hair or clothes, follow of a body of another. Serves any number of them.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Outfit {
    /// <summary>
    /// one a skeleton of the outfit
    /// </summary>
    public OutfitSkeleton* skeletons;
    public UIntPtr skeleton_count;
}

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void Gles3ErrorReport(void* user, byte* call, uint error);

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate uint Gles3GetError();

/// <summary>
/// Told of every GL error by the call that caused it: for debugging, as each call is then between two of glGetError.
/// One an Api and thread.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3ErrorWatch {
    /// <summary>
    /// call: "glBindBuffer", a static string. May be null.
    /// what `report` gets
    /// </summary>
    public IntPtr report;
    /// <summary>
    /// call: "glBindBuffer", a static string. May be null.
    /// what `report` gets
    /// </summary>
    public void* user;
    /// <summary>
    /// what the Api's GetError has yet to tell, as it would without a watch
    /// </summary>
    public uint pending;
    /// <summary>
    /// the driver's glGetError
    /// </summary>
    public IntPtr get_error;
    public static Gles3ErrorWatch New() {
        Gles3ErrorWatch made;
        Marrow.Gles3ErrorWatchInit(&made);
        return made;
    }
}

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void* Gles3LoadProc(byte* name);

/// <summary>
/// The driver's entry points.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3Api {
    public fixed ulong words[222];
}

/// <summary>
/// Multi-weights are the CPU's alone: with four influences 192 bytes a vertex, more than attributes hold.
/// </summary>
public enum Gles3Deformer : byte {
    /// <summary>
    /// vertices skinned elsewhere, in float: position, normal, tangent
    /// </summary>
    None = 0,
    /// <summary>
    /// the joint with the largest weight
    /// </summary>
    Rigid = 1,
    Ssd = 2,
    As = 3,
    /// <summary>
    /// SSD of what the mesh's pose space has moved, see skin_psd() in skin.h
    /// </summary>
    Psd = 4,
}

/// <summary>
/// Where a program finds its palettes.
/// </summary>
public enum Gles3Palettes : byte {
    /// <summary>
    /// PaletteRing: one palette a draw call
    /// </summary>
    UniformBlock = 0,
    /// <summary>
    /// PaletteTexture: of any size; one draw call may draw many characters
    /// </summary>
    Texture = 1,
    /// <summary>
    /// CrowdMesh, see gles3_crowd.h: likewise, without work on the CPU; not for Deformer::none, psd or kMorphs
    /// </summary>
    Crowd = 2,
}

/// <summary>
/// What the context can do. The defaults are the least that GLES 3.0 allows; tests force them on any driver.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3Caps {
    /// <summary>
    /// that one block may have
    /// </summary>
    public uint uniform_block_bytes;
    /// <summary>
    /// power of two
    /// </summary>
    public uint uniform_offset_alignment;
    /// <summary>
    /// of four numbers each
    /// </summary>
    public uint vertex_attributes;
    /// <summary>
    /// along each side
    /// </summary>
    public uint texture_size;
    /// <summary>
    /// OpenGL ES 3.1 or newer, and its functions
    /// </summary>
    public byte compute;
    public static Gles3Caps New() {
        Gles3Caps made;
        Marrow.Gles3CapsInit(&made);
        return made;
    }
}

/// <summary>
/// Byte offsets in one vertex of each stream. Offsets of what is absent are unused.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3VertexLayout {
    /// <summary>
    /// the most of any vertex, 4 to 8
    /// </summary>
    public uint influences;
    /// <summary>
    /// 1 or 2
    /// </summary>
    public uint joint_bytes;
    /// <summary>
    /// the stream of SSD
    /// </summary>
    public uint ssd_stride;
    /// <summary>
    /// the stream of SSD
    /// </summary>
    public uint ssd_weights;
    /// <summary>
    /// the stream of SSD
    /// </summary>
    public uint ssd_joints;
    /// <summary>
    /// in SSD's stream; 0: there is none
    /// </summary>
    public uint example_row;
    /// <summary>
    /// the stream of animation space
    /// </summary>
    public uint as_stride;
    /// <summary>
    /// the stream of animation space
    /// </summary>
    public uint as_tangents;
    /// <summary>
    /// the stream of animation space
    /// </summary>
    public uint as_joints;
    /// <summary>
    /// there are tangents, and room for them
    /// </summary>
    public byte surface_normals;
    /// <summary>
    /// the stream that all deformers share
    /// </summary>
    public uint surface_stride;
    /// <summary>
    /// the stream that all deformers share
    /// </summary>
    public uint normal;
    /// <summary>
    /// the stream that all deformers share
    /// </summary>
    public uint tangent;
    /// <summary>
    /// the stream that all deformers share
    /// </summary>
    public uint uv;
    /// <summary>
    /// the stream that all deformers share
    /// </summary>
    public uint colour;
    /// <summary>
    /// unorm16×2, otherwise f32×2
    /// </summary>
    public byte uv_unorm;
    public static Gles3VertexLayout New() {
        Gles3VertexLayout made;
        Marrow.Gles3VertexLayoutInit(&made);
        return made;
    }
}

/// <summary>
/// A mesh on the GPU. Vertices are the geometry's slots, so indices are used as they are.
///
///   stream     what a vertex has in it               as
///   SSD        position                              snorm16×3
///              weight of the second influence        snorm16
///              weights of the others                 unorm16×2, ×4 or ×6; the first has what they leave of 1
///              joints                                u8×4, or ×8; u16 above 256 entries
///              PrepareOptions::psd: first change     u32; of vertices that no example moves 0
///   AS         coordinates, an influence             snorm16×4; their w sum to 32767, or less: see coordinate_scale
///              kSurfaceNormals: both tangents of it  snorm16×4 each; their w sum to 0
///              joints                                as SSD's
///   surface    normal                                octahedral snorm16×2
///              tangent                               octahedral snorm16×2, the sign in y
///              texture coordinates                   unorm16×2, or f32×2
///              colour                                unorm8×4
///   morphs     row of the morph texture              u32; of vertices that no target moves 0
///
///   bytes a vertex    SSD    AS    AS, kSurfaceNormals    surface, normals alone
///   4 influences       16    36                    100                         4
///   5                  24    48                    128                         4
///   6                  24    56                    152                         4
///   8                  28    72                    200                         4
///
/// The morph texture, RGBA16I, holds 8 B for each attribute, target and vertex that any target moves. That of examples
/// holds 8 B for each example and vertex that it moves.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3GpuMesh {
    /// <summary>
    /// vertex array objects; 0 where not asked for. Rigid uses this one too.
    /// </summary>
    public uint ssd_array;
    /// <summary>
    /// of animation space
    /// </summary>
    public uint as_array;
    /// <summary>
    /// the streams above, a buffer each
    /// </summary>
    public uint ssd_buffer;
    /// <summary>
    /// of animation space
    /// </summary>
    public uint as_buffer;
    /// <summary>
    /// 0 for a mesh of bare positions
    /// </summary>
    public uint surface_buffer;
    /// <summary>
    /// 0 for a mesh without morph targets
    /// </summary>
    public uint morph_buffer;
    /// <summary>
    /// likewise
    /// </summary>
    public uint morph_texture;
    /// <summary>
    /// 0 without PrepareOptions::psd, or examples
    /// </summary>
    public uint example_texture;
    /// <summary>
    /// of all three vertex arrays
    /// </summary>
    public uint index_buffer;
    /// <summary>
    /// three a triangle
    /// </summary>
    public uint index_count;
    /// <summary>
    /// GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
    /// </summary>
    public uint index_type;
    /// <summary>
    /// what the indices draw: GL_TRIANGLES
    /// </summary>
    public uint primitive;
    /// <summary>
    /// as Geometry::slot_count
    /// </summary>
    public uint slot_count;
    /// <summary>
    /// matrices in its palette
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// all vertex buffers together
    /// </summary>
    public uint vertex_bytes;
    /// <summary>
    /// the most of any vertex, 4 to 8
    /// </summary>
    public byte influences;
    /// <summary>
    /// kNormals | …
    /// </summary>
    public byte features;
    /// <summary>
    /// texels a vertex: positions, normals, tangents
    /// </summary>
    public byte morph_per_row;
    /// <summary>
    /// the texture's width is 1 &lt;&lt; morph_shift
    /// </summary>
    public byte morph_shift;
    /// <summary>
    /// of a target
    /// </summary>
    public uint morph_texels;
    /// <summary>
    /// 1 / half-extent, see prepare()
    /// </summary>
    public float morph_unit;
    /// <summary>
    /// of changes, in half-extents
    /// </summary>
    public float example_step;
    /// <summary>
    /// distance_matrices() of the mesh, where it has examples here
    /// </summary>
    public uint distances;
    /// <summary>
    /// of them, a palette entry
    /// </summary>
    public uint distance_texels;
    /// <summary>
    /// Coordinates are stored divided by this; 1 unless a fitted weight lies outside [-1, 1].
    /// </summary>
    public float coordinate_scale;
    /// <summary>
    /// of its vertex buffers
    /// </summary>
    public Gles3VertexLayout layout;
    public static Gles3GpuMesh New() {
        Gles3GpuMesh made;
        Marrow.Gles3GpuMeshInit(&made);
        return made;
    }
}

/// <summary>
/// What prepare() puts on the GPU.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3PrepareOptions {
    /// <summary>
    /// also what rigid draws from
    /// </summary>
    public byte ssd;
    /// <summary>
    /// neither: for vertices skinned on the CPU
    /// </summary>
    public byte @as;
    /// <summary>
    /// From as_tangents() of this mesh: then animation space draws the deformed surface's own normals, and `features` has
    /// kSurfaceNormals. Empty, or of a mesh with morph targets or without normals: normals through the blend.
    /// </summary>
    public float* as_tangents;
    public UIntPtr as_tangent_count;
    /// <summary>
    /// With `ssd`: what Deformer::psd draws from, too; nothing more of a mesh without examples.
    /// </summary>
    public byte psd;
    public static Gles3PrepareOptions New() {
        Gles3PrepareOptions made;
        Marrow.Gles3PrepareOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// What a program is compiled for: of the mesh's features those that it is to read. With kMorphs it draws only meshes
/// that have targets; set_morphs() before each. With kMotion it skins twice: by the palettes of this frame, and of the
/// frame before, positions alone. Those, bound for each draw call like the others, are
///   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by bind_palette()
///   in a texture         bind_previous_palette(); of crowds bind_crowd() does it
///   skinned elsewhere    set_previous(), see gles3_skinned.h
/// and with kMorphs set_previous_morphs().
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3ProgramKey {
    /// <summary>
    /// by which vertices are skinned
    /// </summary>
    public Gles3Deformer deformer;
    /// <summary>
    /// 4 to 8: that of the mesh or more
    /// </summary>
    public byte influences;
    /// <summary>
    /// kNormals | …, that it reads
    /// </summary>
    public byte features;
    /// <summary>
    /// where they are
    /// </summary>
    public Gles3Palettes palettes;
    public static Gles3ProgramKey New() {
        Gles3ProgramKey made;
        Marrow.Gles3ProgramKeyInit(&made);
        return made;
    }
}

/// <summary>
/// The role's own texts, ESSL 3.00 without #version, zero-terminated. The vertex text comes after the skinning text
/// (shaders/skin.glsl), which ends where main() is to begin; the fragment text after the same #version and defines.
///
///   void main() {
///     MarrowVertex v = marrow_skin();
///     gl_Position = clip_from_scene * vec4(v.position, 1.0);
///   }
///
/// What both texts may ask, as numbers in #if: MARROW_NORMAL, MARROW_TANGENT, MARROW_UV, MARROW_COLOUR: 1 if the program
/// was built to read it (ProgramKey::features); MARROW_MOTION: likewise; MARROW_PALETTES: 2 in programs for crowds.
/// What the vertex text may use:
///   MarrowVertex marrow_skin()       once; { vec3 position; vec3 normal; vec4 tangent; vec3 previous_position; } in
///                                    scene space, normal and tangent of unit length, tangent.w the handedness; what is
///                                    not read is 0, but previous_position is then the position
///   vec2 in_uv, vec4 in_colour       attributes, where MARROW_UV, MARROW_COLOUR are 1
///   vec4 marrow_instance_colour()    of an instance of a crowd; else white
/// Names that begin with marrow_, MARROW_, Marrow or in_ are Marrow's; all others the game's, uniforms, too: set those
/// after UseProgram(program.id), by Api or by any other loader.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3ProgramSource {
    /// <summary>
    /// as above
    /// </summary>
    public byte* vertex;
    /// <summary>
    /// as above
    /// </summary>
    public byte* fragment;
    /// <summary>
    /// for transform feedback, interleaved; empty otherwise
    /// </summary>
    public byte** feedback_varyings;
    public UIntPtr feedback_varying_count;
    public static Gles3ProgramSource New() {
        Gles3ProgramSource made;
        Marrow.Gles3ProgramSourceInit(&made);
        return made;
    }
}

/// <summary>
/// A program of the driver and where its uniforms are. Filled in by Marrow.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3Program {
    /// <summary>
    /// for UseProgram(); 0: none
    /// </summary>
    public uint id;
    /// <summary>
    /// where it reads palettes
    /// </summary>
    public Gles3Palettes reads;
    /// <summary>
    /// built with kMotion
    /// </summary>
    public byte motion;
    /// <summary>
    /// Locations of uniforms.
    /// of attributes; here and below -1: there is none
    /// </summary>
    public int coordinate_scale;
    /// <summary>
    /// Locations of uniforms.
    /// of attributes; here and below -1: there is none
    /// </summary>
    public int joint_bits;
    /// <summary>
    /// of palettes in a texture
    /// </summary>
    public int palettes;
    /// <summary>
    /// of palettes in a texture
    /// </summary>
    public int first_row;
    /// <summary>
    /// of crowds
    /// </summary>
    public int instances;
    /// <summary>
    /// of crowds
    /// </summary>
    public int crowd;
    /// <summary>
    /// of pre-skinning by compute shaders
    /// </summary>
    public int vertex_layout;
    /// <summary>
    /// of morph targets
    /// </summary>
    public int morph_changes;
    /// <summary>
    /// of morph targets
    /// </summary>
    public int morph_targets;
    /// <summary>
    /// of morph targets
    /// </summary>
    public int morph_count;
    /// <summary>
    /// of morph targets
    /// </summary>
    public int morph_shift;
    /// <summary>
    /// of morph targets
    /// </summary>
    public int morph_per_row;
    /// <summary>
    /// of the frame before
    /// </summary>
    public int previous_palettes;
    /// <summary>
    /// of the frame before
    /// </summary>
    public int previous_targets;
    /// <summary>
    /// of the frame before
    /// </summary>
    public int previous_count;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public int examples;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public int example_step;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public int distances;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public int distance_row;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public int previous_distances;
    public static Gles3Program New() {
        Gles3Program made;
        Marrow.Gles3ProgramInit(&made);
        return made;
    }
}

/// <summary>
/// One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
/// contents are orphaned, so the CPU never waits for the GPU.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3PaletteRing {
    /// <summary>
    /// a uniform buffer; 0: none
    /// </summary>
    public uint buffer;
    /// <summary>
    /// of offsets, bytes
    /// </summary>
    public uint alignment;
    /// <summary>
    /// bytes that palettes may use
    /// </summary>
    public uint capacity;
    /// <summary>
    /// bytes, since begin_frame()
    /// </summary>
    public uint used;
    public static Gles3PaletteRing New() {
        Gles3PaletteRing made;
        Marrow.Gles3PaletteRingInit(&made);
        return made;
    }
}

/// <summary>
/// All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Of three, each is written every third
/// frame, so that the driver has no reason to wait for what it still draws from, or to copy it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3PaletteTexture {
    /// <summary>
    /// 0: none
    /// </summary>
    public fixed uint textures[3];
    /// <summary>
    /// which was written last
    /// </summary>
    public uint current;
    /// <summary>
    /// matrices
    /// </summary>
    public uint capacity;
    /// <summary>
    /// that are there
    /// </summary>
    public uint count;
    /// <summary>
    /// that were there in the frame before
    /// </summary>
    public uint previous_count;
    public static Gles3PaletteTexture New() {
        Gles3PaletteTexture made;
        Marrow.Gles3PaletteTextureInit(&made);
        return made;
    }
}

/// <summary>
/// What skins vertices ahead of drawing.
/// </summary>
public enum Gles3Preskin : byte {
    /// <summary>
    /// transform feedback, OpenGL ES 3.0
    /// </summary>
    Feedback = 0,
    /// <summary>
    /// compute shader, 3.1
    /// </summary>
    Compute = 1,
}

/// <summary>
/// Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
/// positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them. Texture coordinates, colours
/// and indices are the mesh's, which must be there as long.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3SkinnedMesh {
    /// <summary>
    /// vertex array object
    /// </summary>
    public uint array;
    /// <summary>
    /// of the vertices
    /// </summary>
    public uint buffer;
    /// <summary>
    /// the mesh's
    /// </summary>
    public uint slot_count;
    /// <summary>
    /// kNormals, kTangents, kUvs, kColours: what programs with Deformer::none may read
    /// </summary>
    public byte features;
    public static Gles3SkinnedMesh New() {
        Gles3SkinnedMesh made;
        Marrow.Gles3SkinnedMeshInit(&made);
        return made;
    }
}

/// <summary>
/// Where vertices are skinned.
/// </summary>
public enum Gles3SkinningPath : byte {
    /// <summary>
    /// vertex shader, every pass; palettes in a uniform block, a draw call a character
    /// </summary>
    Ubo = 0,
    /// <summary>
    /// vertex shader, every pass; palettes in a texture, one draw call for all characters
    /// </summary>
    Texture = 1,
    /// <summary>
    /// once a frame, by transform feedback
    /// </summary>
    Feedback = 2,
    /// <summary>
    /// once a frame, by compute shader; OpenGL ES 3.1
    /// </summary>
    Compute = 3,
    /// <summary>
    /// once a frame, by the CPU
    /// </summary>
    Cpu = 4,
}

/// <summary>
/// One of a set, filled in by Marrow.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3ProgramSetEntry {
    /// <summary>
    /// what it was built for
    /// </summary>
    public Gles3ProgramKey key;
    /// <summary>
    /// kMostRoles + Preskin: pre-skinning; and 2: blending of crowds
    /// </summary>
    public uint role;
    /// <summary>
    /// as it was built
    /// </summary>
    public Gles3Program program;
}

/// <summary>
/// The programs of a context: each role for each kind of mesh, compiled once. A game fills in the first five members.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3ProgramSet {
    /// <summary>
    /// Texts that live as long as the set. (GCC 12 takes no shorter initialiser.)
    /// </summary>
    public Gles3ProgramSource roles0;
    public Gles3ProgramSource roles1;
    public Gles3ProgramSource roles2;
    public Gles3ProgramSource roles3;
    /// <summary>
    /// of `roles`, that are used
    /// </summary>
    public uint role_count;
    /// <summary>
    /// Of what a mesh has, what each role's texts read: a shadow's none, or kUvs where it has holes. kMotion: whether they
    /// read previous_position of skinners and crowds that keep it.
    /// </summary>
    public fixed byte role_features[4];
    /// <summary>
    /// uniform buffer binding of the palettes
    /// </summary>
    public uint palette_binding;
    /// <summary>
    /// what the driver says of a text that does not compile
    /// </summary>
    public byte* log;
    public UIntPtr log_bytes;
    /// <summary>
    /// what was compiled
    /// </summary>
    public fixed uint entries[4608];
    /// <summary>
    /// of entries
    /// </summary>
    public uint count;
    public static Gles3ProgramSet New() {
        Gles3ProgramSet made;
        Marrow.Gles3ProgramSetInit(&made);
        return made;
    }
}

/// <summary>
/// How a mesh is skinned, and for how many characters.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3SkinnerOptions {
    /// <summary>
    /// choose() in gles3_self_test.h names the best
    /// </summary>
    public Gles3SkinningPath path;
    /// <summary>
    /// rigid, ssd, as or psd, which is ssd for a mesh without examples
    /// </summary>
    public Gles3Deformer deformer;
    /// <summary>
    /// characters, at most
    /// </summary>
    public uint instances;
    /// <summary>
    /// Palettes in a texture; morph targets take the next one, with `motion` palettes of the frame before the third.
    /// A pose space takes the fourth and fifth, with `motion` the sixth.
    /// </summary>
    public uint texture_unit;
    /// <summary>
    /// what programs are to read of what the mesh has and their role reads
    /// </summary>
    public byte features;
    /// <summary>
    /// From as_tangents() of this mesh, in the caller's memory for as long as the skinner; see PrepareOptions.
    /// </summary>
    public float* as_tangents;
    public UIntPtr as_tangent_count;
    /// <summary>
    /// For motion vectors: keeps what the update() before left on the GPU, and programs of roles that read kMotion have
    /// MarrowVertex::previous_position from it. The uniform buffer binding behind ProgramSet::palette_binding is taken,
    /// too. Nothing more goes up; what it costs: docs/performance.md, "Motion vectors".
    /// </summary>
    public byte motion;
    public static Gles3SkinnerOptions New() {
        Gles3SkinnerOptions made;
        Marrow.Gles3SkinnerOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// What skinners with SkinnerOptions::motion keep of the update() before: two of each, which take turns.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3SkinnerMotion {
    /// <summary>
    /// path ubo
    /// </summary>
    public Gles3PaletteRing ring;
    /// <summary>
    /// in the ring, a character each
    /// </summary>
    public uint* offsets;
    public UIntPtr offset_count;
    /// <summary>
    /// of paths that skin once a frame
    /// </summary>
    public Gles3SkinnedMesh* skinned;
    public UIntPtr skinned_count;
    /// <summary>
    /// of morph targets
    /// </summary>
    public float* weights;
    public UIntPtr weight_count;
    /// <summary>
    /// of the last update()
    /// </summary>
    public float* sent_weights;
    public UIntPtr sent_weight_count;
    /// <summary>
    /// a character each: 1 if it had no update() before its last
    /// </summary>
    public byte* still;
    public UIntPtr still_count;
    /// <summary>
    /// 1 if the next update() is to be its first
    /// </summary>
    public byte* reset;
    public UIntPtr reset_count;
}

/// <summary>
/// A mesh as many characters. Filled in by create_skinner(), to be read only.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3Skinner {
    /// <summary>
    /// as it was given
    /// </summary>
    public Mesh mesh;
    /// <summary>
    /// as they were given
    /// </summary>
    public Gles3SkinnerOptions options;
    /// <summary>
    /// its vertices on the GPU
    /// </summary>
    public Gles3GpuMesh gpu;
    /// <summary>
    /// path ubo, feedback and compute
    /// </summary>
    public Gles3PaletteRing ring;
    /// <summary>
    /// path texture
    /// </summary>
    public Gles3PaletteTexture texture;
    /// <summary>
    /// of pose spaces
    /// </summary>
    public Gles3PaletteTexture distance_texture;
    /// <summary>
    /// characters that the last update() brought up
    /// </summary>
    public uint updated;
    /// <summary>
    /// between on_context_lost() and on_context_restored()
    /// </summary>
    public byte lost;
    /// <summary>
    /// In the caller's memory.
    /// what palettes are built with
    /// </summary>
    public Affine* bind;
    public UIntPtr bind_count;
    /// <summary>
    /// characters after each other
    /// </summary>
    public Affine* palettes;
    public UIntPtr palette_count;
    /// <summary>
    /// of pose spaces, characters after each other; path cpu: one character's
    /// </summary>
    public Affine* distances;
    public UIntPtr distance_count;
    /// <summary>
    /// of morph targets, characters after each other
    /// </summary>
    public float* weights;
    public UIntPtr weight_count;
    /// <summary>
    /// in the ring, a character each
    /// </summary>
    public uint* offsets;
    public UIntPtr offset_count;
    /// <summary>
    /// a character each, of paths that skin once a frame
    /// </summary>
    public Gles3SkinnedMesh* skinned;
    public UIntPtr skinned_count;
    /// <summary>
    /// with SkinnerOptions::motion
    /// </summary>
    public Gles3SkinnerMotion motion;
    /// <summary>
    /// path cpu: one character's
    /// </summary>
    public float* positions;
    public UIntPtr position_count;
    /// <summary>
    /// path cpu: one character's
    /// </summary>
    public float* normals;
    public UIntPtr normal_count;
    /// <summary>
    /// path cpu: one character's
    /// </summary>
    public float* tangents;
    public UIntPtr tangent_count;
    /// <summary>
    /// path cpu: one character's
    /// </summary>
    public float* coordinates;
    public UIntPtr coordinate_count;
    /// <summary>
    /// path cpu: one character's
    /// </summary>
    public MorphedGeometry morphed;
    /// <summary>
    /// of prepare(), kept for the next context
    /// </summary>
    public void* scratch;
    public UIntPtr scratch_bytes;
}

/// <summary>
/// What is baked, and how it ends.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3CrowdSource {
    /// <summary>
    /// not an additive one
    /// </summary>
    public Clip clip;
    /// <summary>
    /// its last pose is followed by its first; otherwise it stays in the last
    /// </summary>
    public byte loops;
    public static Gles3CrowdSource New() {
        Gles3CrowdSource made;
        Marrow.Gles3CrowdSourceInit(&made);
        return made;
    }
}

/// <summary>
/// Where a clip's frames are: steps + 1 of them, at even steps of time; of one that loops the last is the first again.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3CrowdClip {
    /// <summary>
    /// of the clip
    /// </summary>
    public float duration_s;
    /// <summary>
    /// of the crowd's frames
    /// </summary>
    public uint first_frame;
    /// <summary>
    /// 1 … 65535
    /// </summary>
    public uint steps;
    /// <summary>
    /// as its source's
    /// </summary>
    public byte loops;
    public static Gles3CrowdClip New() {
        Gles3CrowdClip made;
        Marrow.Gles3CrowdClipInit(&made);
        return made;
    }
}

/// <summary>
/// Baked clips of one skeleton: a matrix each frame and joint, as local_to_model() writes them.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3CrowdFrames {
    /// <summary>
    /// in the order of their sources
    /// </summary>
    public Gles3CrowdClip* clips;
    public UIntPtr clip_count;
    /// <summary>
    /// frame after frame
    /// </summary>
    public Affine* character_from_joint;
    public UIntPtr character_from_joint_count;
    /// <summary>
    /// of the skeleton
    /// </summary>
    public uint joint_count;
    /// <summary>
    /// of all clips
    /// </summary>
    public uint frame_count;
    public static Gles3CrowdFrames New() {
        Gles3CrowdFrames made;
        Marrow.Gles3CrowdFramesInit(&made);
        return made;
    }
}

/// <summary>
/// At start_s of the crowd's clock the clip is at phase_s, before and afterwards wherever `speed` takes it.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3CrowdPlay {
    /// <summary>
    /// of CrowdFrames::clips
    /// </summary>
    public uint clip;
    /// <summary>
    /// of a clip that does not loop within 0 … duration_s, else the nearer end
    /// </summary>
    public float phase_s;
    /// <summary>
    /// seconds of the clip a second; may be negative
    /// </summary>
    public float speed;
    /// <summary>
    /// seconds
    /// </summary>
    public double start_s;
    public static Gles3CrowdPlay New() {
        Gles3CrowdPlay made;
        Marrow.Gles3CrowdPlayInit(&made);
        return made;
    }
}

/// <summary>
/// One of a crowd. Any instance is exact up to 36 hours from each of its times; by then set it again, with later ones.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 128)]
public unsafe struct Gles3CrowdInstance {
    /// <summary>
    /// where it stands
    /// </summary>
    public Affine scene_from_character;
    /// <summary>
    /// must have a clip
    /// </summary>
    public Gles3CrowdPlay a;
    /// <summary>
    /// kNoCrowdClip: a alone
    /// </summary>
    public Gles3CrowdPlay b;
    /// <summary>
    /// until then a alone
    /// </summary>
    public double blend_start_s;
    /// <summary>
    /// and b alone so much later
    /// </summary>
    public float blend_s;
    /// <summary>
    /// marrow_instance_colour() in the vertex shader
    /// </summary>
    public fixed float colour[4];
    public static Gles3CrowdInstance New() {
        byte* room = stackalloc byte[144];
        Gles3CrowdInstance* made = (Gles3CrowdInstance*)(((ulong)room + 15) / 16 * 16);
        Marrow.Gles3CrowdInstanceInit(made);
        return *made;
    }
}

/// <summary>
/// A mesh as crowds draw it: its palette in every frame (RGBA32F), and the palettes of the instances as they are now
/// (RGBA32UI, the bits of floats, for GLES 3.0 renders to no floats). A texel is a row of a matrix, a line 2048 texels.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3CrowdMesh {
    /// <summary>
    /// what draw() takes
    /// </summary>
    public Gles3GpuMesh gpu;
    /// <summary>
    /// palettes of all frames
    /// </summary>
    public uint frames_texture;
    /// <summary>
    /// palettes of the instances
    /// </summary>
    public uint blended_texture;
    /// <summary>
    /// around the blended texture
    /// </summary>
    public uint framebuffer;
    /// <summary>
    /// With motion alone: as they were in the frame before. begin_frame() has the two take turns.
    /// </summary>
    public uint previous_texture;
    /// <summary>
    /// around the previous texture
    /// </summary>
    public uint previous_framebuffer;
    /// <summary>
    /// matrices of a palette
    /// </summary>
    public uint joints;
    /// <summary>
    /// of its frames
    /// </summary>
    public uint frame_count;
    /// <summary>
    /// instances
    /// </summary>
    public uint capacity;
    /// <summary>
    /// as create_crowd_mesh() was asked
    /// </summary>
    public byte motion;
    /// <summary>
    /// between on_context_lost() and on_context_restored()
    /// </summary>
    public byte lost;
    /// <summary>
    /// What it is put on the next context from.
    /// </summary>
    public Mesh mesh;
    /// <summary>
    /// as they were given
    /// </summary>
    public Gles3PrepareOptions options;
    /// <summary>
    /// as they were given
    /// </summary>
    public Gles3CrowdFrames frames;
    /// <summary>
    /// what palettes are built with
    /// </summary>
    public Affine* bind;
    public UIntPtr bind_count;
    /// <summary>
    /// of prepare(), and of palettes on their way up
    /// </summary>
    public void* scratch;
    public UIntPtr scratch_bytes;
    public static Gles3CrowdMesh New() {
        Gles3CrowdMesh made;
        Marrow.Gles3CrowdMeshInit(&made);
        return made;
    }
}

/// <summary>
/// Instances, in a texture: 128 B each, 256 a line. The caller's memory holds the same bytes for the next context.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3Crowd {
    /// <summary>
    /// of records
    /// </summary>
    public uint texture;
    /// <summary>
    /// instances, at most
    /// </summary>
    public uint capacity;
    /// <summary>
    /// that have been set
    /// </summary>
    public uint count;
    /// <summary>
    /// of the frames that they play
    /// </summary>
    public uint frame_count;
    /// <summary>
    /// between on_context_lost() and on_context_restored()
    /// </summary>
    public byte lost;
    /// <summary>
    /// as the texture has them
    /// </summary>
    public void* records;
    public UIntPtr records_bytes;
    public static Gles3Crowd New() {
        Gles3Crowd made;
        Marrow.Gles3CrowdInit(&made);
        return made;
    }
}

/// <summary>
/// What the self-test says of a path.
/// </summary>
public enum Gles3Verdict : byte {
    Usable = 0,
    /// <summary>
    /// not among SelfTestOptions::paths
    /// </summary>
    NotTried = 1,
    /// <summary>
    /// among SelfTestOptions::crashed
    /// </summary>
    Crashed = 2,
    /// <summary>
    /// the caps rule it out
    /// </summary>
    Unsupported = 3,
    /// <summary>
    /// the driver refuses its programs or its buffers
    /// </summary>
    Refused = 4,
    /// <summary>
    /// GL reports an error while it skins
    /// </summary>
    GlError = 5,
    /// <summary>
    /// its vertices differ from the CPU's
    /// </summary>
    Wrong = 6,
    /// <summary>
    /// right, but SelfTestOptions::slow times slower than the fastest that skins on the GPU
    /// </summary>
    Slow = 7,
}

/// <summary>
/// Chips that want another order of paths where nothing is timed, and other texts of shaders.
/// </summary>
public enum Gles3GpuFamily : byte {
    Other = 0,
    /// <summary>
    /// Mali-G… and Immortalis: rows of a uniform block cost three times those of a texture, attributes are dear
    /// </summary>
    MaliG = 1,
    /// <summary>
    /// Mali-T…: four numbers at a time; the paths as others
    /// </summary>
    MaliT = 2,
    /// <summary>
    /// registers enough without branches; the paths as others
    /// </summary>
    Adreno = 3,
    /// <summary>
    /// unpacking attributes is dear: a quarter to a third less for animation space as words; the paths as others
    /// </summary>
    Nvidia = 4,
}

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate double Gles3Clock(void* user);

[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void Gles3AboutToTry(void* user, Gles3SkinningPath path);

/// <summary>
/// What one path did.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3PathResult {
    /// <summary>
    /// whether to use it
    /// </summary>
    public Gles3Verdict verdict;
    /// <summary>
    /// The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin;
    /// and of unit normals and tangents. Quantised vertices differ by some 0.0001 and 0.0002. Above
    /// kMostPositionError and kMostNormalError the path is wrong: numbers of 16 bits are off by more. Never NaN.
    /// </summary>
    public float position_error;
    /// <summary>
    /// of normals and tangents
    /// </summary>
    public float normal_error;
    /// <summary>
    /// to skin and draw once; 0: not timed
    /// </summary>
    public float ns_per_vertex;
    /// <summary>
    /// a vertex, of each pass that draws it again
    /// </summary>
    public float ns_per_pass;
    public static Gles3PathResult New() {
        Gles3PathResult made;
        Marrow.Gles3PathResultInit(&made);
        return made;
    }
}

/// <summary>
/// What self_test() found.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3SelfTest {
    /// <summary>
    /// by SkinningPath
    /// </summary>
    public Gles3PathResult paths0;
    public Gles3PathResult paths1;
    public Gles3PathResult paths2;
    public Gles3PathResult paths3;
    public Gles3PathResult paths4;
    /// <summary>
    /// by GL_RENDERER
    /// </summary>
    public Gles3GpuFamily family;
    /// <summary>
    /// of driver, caps, options and this library's shader texts
    /// </summary>
    public ulong key;
    public static Gles3SelfTest New() {
        Gles3SelfTest made;
        Marrow.Gles3SelfTestInit(&made);
        return made;
    }
}

/// <summary>
/// What is tried, and how it is timed.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3SelfTestOptions {
    /// <summary>
    /// bit_of() of those to try
    /// </summary>
    public uint paths;
    /// <summary>
    /// Paths during which the process came to its end: they are not tried again. See about_to_try.
    /// </summary>
    public uint crashed;
    /// <summary>
    /// the deformers that the game uses
    /// </summary>
    public byte ssd;
    /// <summary>
    /// animation space
    /// </summary>
    public byte @as;
    /// <summary>
    /// Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
    /// </summary>
    public IntPtr seconds;
    /// <summary>
    /// times the fastest path's time
    /// </summary>
    public float slow;
    /// <summary>
    /// What is timed: characters of a mesh of so many vertices, of up to four influences, by SSD if `ssd`. State what the
    /// game draws most of. 16 … 65 520 vertices, of which a multiple of 16 is taken; 1 … 256 characters.
    /// </summary>
    public uint timed_vertices;
    /// <summary>
    /// of that mesh
    /// </summary>
    public uint timed_characters;
    /// <summary>
    /// Called before a path is tried. A game that wants to outlive a driver that crashes stores which, durably, and
    /// forgets it once self_test() has returned. What it finds stored at its next start goes into `crashed`, together
    /// with what has been there before.
    /// what the two functions above get
    /// </summary>
    public IntPtr about_to_try;
    /// <summary>
    /// Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
    /// </summary>
    public void* user;
    public static Gles3SelfTestOptions New() {
        Gles3SelfTestOptions made;
        Marrow.Gles3SelfTestOptionsInit(&made);
        return made;
    }
}

/// <summary>
/// What a mesh is to be drawn for.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Gles3PathNeed {
    /// <summary>
    /// that draw it in a frame: colour, depth, shadows
    /// </summary>
    public uint passes;
    /// <summary>
    /// in one Skinner
    /// </summary>
    public uint characters;
    /// <summary>
    /// Mesh::palette_size()
    /// </summary>
    public uint joints;
    public static Gles3PathNeed New() {
        Gles3PathNeed made;
        Marrow.Gles3PathNeedInit(&made);
        return made;
    }
}

public static unsafe class Marrow {
#if (UNITY_IOS || UNITY_TVOS || UNITY_VISIONOS || UNITY_WEBGL) && !UNITY_EDITOR
    /// <summary>What all functions here are imported from: the program itself.</summary>
    public const string Library = "__Internal";
#else
    /// <summary>What all functions here are imported from: libmarrow_c.so, marrow_c.dll, …</summary>
    public const string Library = "marrow_c";
#endif

    /// <summary>What Abi() must give.</summary>
    public const uint AbiNumber = 0x322cf8d7;
    /// <summary>What Gles3Abi() must give.</summary>
    public const uint Gles3AbiNumber = 0x163cddea;

    /// <summary>
    /// Bytes: where blocks begin at multiples of.
    /// </summary>
    public const int BlockBoundary = 16;
    /// <summary>
    /// Bytes of Unpacking's state.
    /// </summary>
    public const int UnpackStateBytes = 512;
    /// <summary>
    /// What a space has at most.
    /// </summary>
    public const uint MaxExampleParameters = 8;
    /// <summary>
    /// What a space has at most.
    /// and targets
    /// </summary>
    public const uint MaxExamples = 64;
    /// <summary>
    /// Limits that every valid file keeps; sizes of caller's memory can be bounded by them.
    /// </summary>
    public const uint MaxJoints = 32767;
    /// <summary>
    /// The most palette entries that a vertex follows.
    /// </summary>
    public const uint MaxInfluences = 8;
    /// <summary>
    /// In Skeleton::parents: a root.
    /// </summary>
    public const ushort NoParent = 0xFFFF;
    /// <summary>
    /// In Geometry::source_slots: a vertex of no triangle.
    /// </summary>
    public const uint NoSlot = 0xFFFFFFFF;
    /// <summary>
    /// The most examples of a PoseSpace.
    /// </summary>
    public const uint MaxPoseExamples = 32;
    /// <summary>
    /// In Mesh::material_index: no more than what stands in the Mesh.
    /// </summary>
    public const uint NoMaterial = 0xFFFFFFFF;
    /// <summary>
    /// In place of an image: none.
    /// </summary>
    public const uint NoImage = 0xFFFFFFFF;
    /// <summary>
    /// In Node::joint and elsewhere: none.
    /// </summary>
    public const ushort NoJoint = 0xFFFF;
    /// <summary>
    /// Which attributes a morph target changes.
    /// </summary>
    public const uint MorphsPositions = 1;
    /// <summary>
    /// Which attributes a morph target changes.
    /// </summary>
    public const uint MorphsNormals = 2;
    /// <summary>
    /// Which attributes a morph target changes.
    /// </summary>
    public const uint MorphsTangents = 4;
    /// <summary>
    /// as many as SpringChain::colliders has bits
    /// </summary>
    public const int MaxSpringColliders = 64;
    /// <summary>
    /// In place of a channel: none.
    /// </summary>
    public const uint NoChannel = 0xFFFFFFFF;
    /// <summary>
    /// The largest weight of a layer; results stay far from the limits of float.
    /// </summary>
    public const float MaxBlendWeight = 1e6f;
    /// <summary>
    /// Below this sum of weights a joint is filled up with its rest pose.
    /// </summary>
    public const float RestThreshold = 0.1f;
    /// <summary>
    /// Rotations no farther outside than this keep their bits.
    /// </summary>
    public const float LimitToleranceRad = 1e-5f;
    /// <summary>
    /// The widest swing of a cone: 170°.
    /// </summary>
    public const float WidestSwingRad = 2.9670597f;
    /// <summary>
    /// frames are cut into equal steps no longer than this …
    /// </summary>
    public const float MaxSpringStepS = 1.0f / 60;
    /// <summary>
    /// … and time beyond so many is left out
    /// </summary>
    public const int MaxSpringSteps = 8;
    /// <summary>
    /// shorter frames are saved up
    /// </summary>
    public const float MinSpringFrameS = 0.001f;
    /// <summary>
    /// In Animation: the skeleton plays nothing.
    /// </summary>
    public const uint NoClip = 0xFFFFFFFF;
    /// <summary>
    /// Which attributes a mesh has and a program reads.
    /// </summary>
    public const uint Gles3Normals = 1;
    /// <summary>
    /// A mesh has tangents, a program reads them; here and below as above.
    /// </summary>
    public const uint Gles3Tangents = 2;
    /// <summary>
    /// Texture coordinates.
    /// </summary>
    public const uint Gles3Uvs = 4;
    /// <summary>
    /// Colours of vertices.
    /// </summary>
    public const uint Gles3Colours = 8;
    /// <summary>
    /// Morph targets.
    /// </summary>
    public const uint Gles3Morphs = 16;
    /// <summary>
    /// In animation space normals and tangents are the deformed surface's own, by as_tangents(): see PrepareOptions.
    /// </summary>
    public const uint Gles3SurfaceNormals = 32;
    /// <summary>
    /// A program's alone, none of a mesh: where each vertex was in the frame before, for motion vectors.
    /// </summary>
    public const uint Gles3Motion = 64;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// animation space: 0 … 7 are the coordinates
    /// </summary>
    public const uint Gles3PositionLocation = 0;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// and 2
    /// </summary>
    public const uint Gles3WeightsLocation = 1;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// and 9; on Mali-G up to eight here, two in a number
    /// </summary>
    public const uint Gles3JointsLocation = 8;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// octahedral
    /// </summary>
    public const uint Gles3NormalLocation = 10;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// octahedral, and the handedness
    /// </summary>
    public const uint Gles3TangentLocation = 11;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// in_uv
    /// </summary>
    public const uint Gles3UvLocation = 12;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// in_colour
    /// </summary>
    public const uint Gles3ColourLocation = 13;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// row of the morph texture
    /// </summary>
    public const uint Gles3MorphRowLocation = 14;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// row of the texture of examples
    /// </summary>
    public const uint Gles3ExampleRowLocation = 15;
    /// <summary>
    /// Morph targets that a vertex shader adds at a time: a quarter of the uniforms that GLES 3.0 promises.
    /// </summary>
    public const uint Gles3MorphTargets = 64;
    /// <summary>
    /// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
    /// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
    /// Deformer::none with kMotion: the position of the frame before
    /// </summary>
    public const uint Gles3PreviousLocation = 1;
    /// <summary>
    /// Matrices in the uniform block of the programs: as many as fit the smallest block that GLES 3.0 allows.
    /// </summary>
    public const uint Gles3PaletteJoints = 341;
    /// <summary>
    /// Bytes of that block.
    /// </summary>
    public const uint Gles3PaletteBlockBytes = 16368;
    /// <summary>
    /// Texels a row of the texture: what GLES 3.0 promises.
    /// </summary>
    public const uint Gles3PaletteTextureWidth = 2048;
    /// <summary>
    /// How many values SkinningPath has.
    /// </summary>
    public const uint Gles3PathCount = 5;
    /// <summary>
    /// The most roles of a ProgramSet.
    /// </summary>
    public const uint Gles3MostRoles = 4;
    /// <summary>
    /// The most programs of a ProgramSet.
    /// </summary>
    public const uint Gles3MostPrograms = 192;
    /// <summary>
    /// Frames of one crowd: what fits the smallest textures, of meshes with one joint.
    /// </summary>
    public const uint Gles3MaxCrowdFrames = 1048576;
    /// <summary>
    /// Nothing to play.
    /// </summary>
    public const uint Gles3NoCrowdClip = 4294967295;
    /// <summary>
    /// Bytes of memory an instance for create_crowd().
    /// </summary>
    public const int Gles3CrowdInstanceBytes = 128;
    /// <summary>
    /// How many values Verdict has.
    /// </summary>
    public const uint Gles3VerdictCount = 8;
    /// <summary>
    /// How many values GpuFamily has.
    /// </summary>
    public const uint Gles3GpuFamilyCount = 5;
    /// <summary>
    /// The most that PathResult::position_error may be, metres.
    /// </summary>
    public const float Gles3MostPositionError = 0.001f;
    /// <summary>
    /// The most that PathResult::normal_error may be.
    /// </summary>
    public const float Gles3MostNormalError = 0.005f;
    /// <summary>
    /// All paths, as bits.
    /// </summary>
    public const uint Gles3AllPaths = 31;
    /// <summary>
    /// From so many characters on choose() prefers palettes in a texture.
    /// </summary>
    public const uint Gles3ManyCharacters = 8;
    /// <summary>
    /// A result as bytes that a game stores. Errors: bad_argument (too short).
    /// </summary>
    public const int Gles3SavedSelfTestBytes = 128;
    [DllImport(Library, EntryPoint = "mrw_abi", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint Abi();
    [DllImport(Library, EntryPoint = "mrw_gles3_abi", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint Gles3Abi();
    [DllImport(Library, EntryPoint = "mrw_data_error_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void DataErrorInit(DataError* @out);
    /// <summary>
    /// One word or two in English, never null.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_status_text", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte* StatusText(Status status);
    /// <summary>
    /// From now on `handler` is told of every call that returns Status::bad_argument, on the thread of that call and before
    /// it returns. null: nobody is told. Returns the handler before.
    ///
    /// The runtime itself never logs. Without a call of this nobody is told in a build with NDEBUG, and in one without a
    /// line goes to stderr. A library built with MARROW_CALL_ERRORS=OFF, as it is by default for MinSizeRel, holds no names
    /// and no conditions, and tells nobody whatever is set here.
    ///
    /// Bad data in a file is no bad call: see DataError.
    /// Thread-safe; the handler must be so too, and the one before may still be running on other threads. It may call
    /// anything of Marrow, may set another handler, and may stop the program.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_set_call_error_handler", CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr SetCallErrorHandler(IntPtr handler);
    /// <summary>
    /// The handler of now; null: nobody is told. Thread-safe.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_get_call_error_handler", CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr GetCallErrorHandler();
    /// <summary>
    /// How many bytes of any alignment hold a block of `bytes`.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_block_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr BlockBytes(UIntPtr bytes);
    /// <summary>
    /// Whether a block may begin there.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_is_on_boundary", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte IsOnBoundary(void* first);
    /// <summary>
    /// What lies behind the first boundary in `memory`; empty if there is none.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_block_in", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BlockIn(void* memory, UIntPtr memory_bytes, Block* @out);
    [DllImport(Library, EntryPoint = "mrw_bytes_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void BytesInit(Bytes* @out);
    /// <summary>
    /// Whether these are the first bytes of a packed file. Anything else is for load() to judge.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_is_packed", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte IsPacked(void* bytes, UIntPtr byte_count);
    /// <summary>
    /// How much memory unpacking takes: what the records need by their counts, and bad_data if the header claims anything
    /// else, or a clip or bounds more than their bytes can hold. A mesh's counts are the file's claim, which a codec's few
    /// bytes may bear out, so whoever reads files of strangers should set a limit. Errors: bad_magic, bad_version,
    /// bad_checksum, truncated, bad_data. Cost: the checksum.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_find_unpack_sizes", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FindUnpackSizes(void* packed, UIntPtr packed_bytes, UnpackSizes* @out, DataError* error);
    /// <summary>
    /// Unpacks into `memory` (16-byte aligned, at least memory_bytes) and makes `file` its front part, which is for load()
    /// to check, the decoded counts, indices and joints with it. What lies behind `file` is free again.
    ///
    /// packed may come from anywhere: nothing is read outside of it or written outside of memory. Errors: as unpack_sizes();
    /// bad_data; unsupported if a mesh's codec is not among `decoders` (DataError::rule names it); out_of_memory, by Draco;
    /// bad_argument. On failure
    /// `file` is unchanged and memory holds garbage. Vertices come out grouped and ordered for skinning, triangles in the
    /// order of the codec. Thread-safe on different outputs. Cost: docs/benchmarks.md; Draco allocates while it decodes,
    /// nothing else does.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_unpack", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Unpack(void* packed, UIntPtr packed_bytes, MeshDecoder* decoders, UIntPtr decoder_count, void* memory, UIntPtr memory_bytes, Bytes* file, DataError* error);
    [DllImport(Library, EntryPoint = "mrw_unpacking_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void UnpackingInit(Unpacking* @out);
    /// <summary>
    /// Checks the header and the records' counts. Errors: as unpack_sizes(), and bad_argument; then nothing is begun.
    /// Cost: the checksum.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_begin_unpack", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BeginUnpack(void* packed, UIntPtr packed_bytes, MeshDecoder* decoders, UIntPtr decoder_count, void* memory, UIntPtr memory_bytes, Unpacking* @out, DataError* error);
    /// <summary>
    /// Goes on with one record, or with one of a mesh's stages: decoding, where animation space has a residual smoothing it
    /// and decoding that, ordering and writing; then with the file's checksum. A step stops when it has done so much, a few
    /// milliseconds whatever the file holds, and the next one goes on there; but for what a codec's library does in one call.
    /// meshoptimizer's decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them. Draco's
    /// decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
    ///
    /// Errors: as unpack(); nothing is in work afterwards. bad_argument: nothing is in work. May run on any thread, on one
    /// at a time.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_unpack_step", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status UnpackStep(Unpacking* unpacking, DataError* error);
    /// <summary>
    /// For unpack(). Draco allocates while it decodes and frees all of it again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_draco_decoder", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status DracoDecoder(MeshDecoder* @out);
    /// <summary>
    /// For unpack(). Allocates nothing.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_meshopt_decoder", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MeshoptDecoder(MeshDecoder* @out);
    [DllImport(Library, EntryPoint = "mrw_joint_transform_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void JointTransformInit(JointTransform* @out);
    /// <summary>
    /// How many SoaTransforms hold a pose of `joint_count` joints.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_soa_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr SoaCount(UIntPtr joint_count);
    /// <summary>
    /// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
    /// is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_get_joint", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status GetJoint(SoaTransform* local, UIntPtr local_count, uint joint, JointTransform* @out);
    /// <summary>
    /// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
    /// is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_set_joint", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SetJoint(SoaTransform* local, UIntPtr local_count, uint joint, JointTransform* transform);
    [DllImport(Library, EntryPoint = "mrw_rate_limit_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void RateLimitInit(RateLimit* @out);
    [DllImport(Library, EntryPoint = "mrw_joint_limit_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void JointLimitInit(JointLimit* @out);
    [DllImport(Library, EntryPoint = "mrw_spring_joint_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SpringJointInit(SpringJoint* @out);
    [DllImport(Library, EntryPoint = "mrw_spring_chain_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SpringChainInit(SpringChain* @out);
    [DllImport(Library, EntryPoint = "mrw_spring_collider_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SpringColliderInit(SpringCollider* @out);
    [DllImport(Library, EntryPoint = "mrw_helper_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void HelperInit(Helper* @out);
    /// <summary>
    /// Whether a limit keeps these rules, as those of make_limit() and load() do.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_is_valid", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte IsValid(JointLimit* limit);
    [DllImport(Library, EntryPoint = "mrw_file_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FileInit(File* @out);
    /// <summary>
    /// Validates a cooked file (docs/format.md) and makes `out` a view of it.
    ///
    /// The block must be 16-byte aligned (bad_argument otherwise; block.h helps) and may come from anywhere: nothing is
    /// read outside it, whatever it holds, and after `ok` nothing that it holds can make another stage read or write out of
    /// bounds. Numbers of matrices, translations and scales are at most 1e12, and rotations units, so that the product of
    /// what is above a root, a joint and an inverse bind is finite; those of long chains of huge scales need not be. Names
    /// are at most 2047 bytes. `out` is written only on success. `error`, if not null, gets the place and the broken rule on
    /// failure. Cost: one pass over the block; no allocation. Thread-safe.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_load", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Load(void* block, UIntPtr block_bytes, File* @out, DataError* error);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_skeleton_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileSkeletonCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_reference_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileReferenceCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_clip_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileClipCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_mesh_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileMeshCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_material_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileMaterialCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_image_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileImageCount(File* file);
    /// <summary>
    /// How many of each there are.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_node_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileNodeCount(File* file);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_skeleton", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileSkeleton(File* file, uint index, Skeleton* @out);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_reference", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileReference(File* file, uint index, SkeletonReference* @out);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_clip", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileClip(File* file, uint index, Clip* @out);
    /// <summary>
    /// level: of detail, 0 in full; beyond the mesh's last it is its last. All levels share one palette.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileMesh(File* file, uint index, uint level, Mesh* @out);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_material", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileMaterial(File* file, uint index, Material* @out);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_image", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileImage(File* file, uint index, Image* @out);
    /// <summary>
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_node", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileNode(File* file, uint index, Node* @out);
    /// <summary>
    /// About all that the mesh's vertices do while the clip plays from its rest pose, at every level of detail, by every
    /// deformer that it was cooked for. Empty if the clip does not move the mesh's skeleton, and in files without bounds.
    /// Codes of 8 bits, rounded outwards: a face may be 1/64 of the box's farthest coordinate beyond the vertices. A clip
    /// pack has none: palette_bounds() in bounds.h. Cost: a look at every clip and mesh; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_bounds", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileBounds(File* file, uint clip, uint mesh, Bounds* @out);
    /// <summary>
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_spring_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileSpringCount(File* file, uint skeleton);
    /// <summary>
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_spring", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileSpring(File* file, uint skeleton, uint index, SpringChain* @out);
    /// <summary>
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_spring_colliders", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileSpringColliders(File* file, uint skeleton, SpringColliderList* @out);
    /// <summary>
    /// Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
    /// holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
    /// with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_example_space_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileExampleSpaceCount(File* file);
    /// <summary>
    /// Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
    /// holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
    /// with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
    /// May be null: error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_example_space", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FileExampleSpace(File* file, uint index, ExampleSpace* @out, DataError* error);
    /// <summary>
    /// Index of the first skeleton with this name, or skeleton_count(). Here and below a null pointer names nothing.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_skeleton", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindSkeleton(File* file, byte* name);
    /// <summary>
    /// The first joint of `skeleton`, a skeleton of this file, with this name, or skeleton.joint_count. Once a load, not a
    /// frame.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_joint", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindJoint(File* file, Skeleton* skeleton, byte* name);
    /// <summary>
    /// Index of the first mesh with this name, or mesh_count(). A mesh of several materials is one a material, all of the
    /// same name.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindMesh(File* file, byte* name);
    /// <summary>
    /// Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
    /// of several skeletons is a clip each, with the same name and duration.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_clip", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindClip(File* file, byte* name);
    /// <summary>
    /// Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
    /// of several skeletons is a clip each, with the same name and duration.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_clip_of", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindClipOf(File* file, byte* name, uint skeleton);
    /// <summary>
    /// Index of the first channel of `clip`, a clip of this file, with this name, or clip.channels.size. Once a load, not
    /// a frame.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_channel", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindChannel(File* file, Clip* clip, byte* name);
    /// <summary>
    /// Index of the first node with this name, or node_count().
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_find_node", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint FileFindNode(File* file, byte* name);
    /// <summary>
    /// The property of `node`, a node of this file, with this name; null if there is none.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_node_property", CallingConvention = CallingConvention.Cdecl)]
    public static extern Property* FileNodeProperty(File* file, Node* node, byte* name);
    /// <summary>
    /// A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
    /// zero-terminated, never null.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_file_text", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte* FileText(File* file, uint name);
    /// <summary>
    /// A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
    /// zero-terminated, never null.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_property_text", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint PropertyText(Property* property);
    /// <summary>
    /// How many groups of four joints a local pose has.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skeleton_soa_size", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr SkeletonSoaSize(Skeleton* skeleton);
    /// <summary>
    /// How many matrices build_palette() writes.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_mesh_palette_size", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint MeshPaletteSize(Mesh* mesh);
    /// <summary>
    /// Whether nothing is known or in it.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bounds_is_empty", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte BoundsIsEmpty(Bounds* bounds);
    /// <summary>
    /// A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
    /// Of a skeleton that is not there it is the hash of no joints. Cost: one pass over the skeleton.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skeleton_hash", CallingConvention = CallingConvention.Cdecl)]
    public static extern ulong SkeletonHash(File* file, uint skeleton);
    /// <summary>
    /// Whether the clips that a pack has for one of its references may move a skeleton of another file. After `ok`,
    /// sample(skeleton, pack.clip(i), …) does for every clip whose Clip::skeleton is `reference` what it would do for the
    /// skeleton's own. Once a load, not a frame. (Sampling an unfit clip is safe: joints out of range are refused, and
    /// within it the pose is nonsense.)
    ///
    /// misfits: gets the first ones, as many as it holds; misfit_count, if not null, how many there are. Both may be left
    /// out. What stands above the roots may differ: it does not concern clips.
    /// Errors: mismatch if the skeletons are not the same; bad_argument if an index is out of range. Cost: one pass over the
    /// skeleton if it fits; else a search by name a joint. No allocation. Thread-safe.
    /// May be null: misfits_there.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bind_clips", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BindClips(File* pack, uint reference, File* character, uint skeleton, JointMisfit* misfits, UIntPtr misfit_count, UIntPtr* misfits_there);
    /// <summary>
    /// Whether an outfit fits a body, and which joint of the body each of its joints is.
    ///
    /// body_joints: at least the outfit's joint_count; gets the number of the body's joint, ascending, or kNoJoint for what
    /// only the outfit has. It fits if all joints of the body are there, in their order and each below the same parent, and
    /// if each joint of its own hangs on another joint. Rest poses may differ, as may what stands above the roots: the same
    /// clothes fit a taller body. Where all joints are the body's own, body_joints[j] is j.
    ///
    /// misfits: as of bind_clips(), where `joint` is of the outfit and `extra` one that the outfit lacks, of the body;
    /// `missing`: a root that the body lacks.
    /// Errors: mismatch if it does not fit, where body_joints holds nothing of use; bad_argument if an index is out of range
    /// or a span too short. Cost: a comparison of names a joint if it fits; else a search by name. No allocation.
    /// Thread-safe.
    /// May be null: misfits_there.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bind_outfit", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BindOutfit(File* outfit, uint skeleton, File* body, uint body_skeleton, ushort* body_joints, UIntPtr body_joint_count, JointMisfit* misfits, UIntPtr misfit_count, UIntPtr* misfits_there);
    /// <summary>
    /// The outfit's scene-space joints in the body's pose: joints of the body are copied, the outfit's own stand at `local`
    /// below their parents. Poses are the same bits as if local_to_model() had posed them all.
    ///
    /// skeleton: the outfit's. body_joints: as bind_outfit() gives it. local: at least skeleton.soa_size(), of which joints
    /// of the body are not read. scene_from_joint: at least skeleton.joint_count; does not overlap the body's.
    /// Errors: bad_argument if a span is too short, a joint out of range, or a root none of the body's.
    /// Cost: 48 bytes are copied a joint of the body; the others cost what local_to_model() does. Where body_joints[j] is
    /// always j, build_palette() and gles3::pose() may as well take the body's joints themselves, without a copy.
    /// Thread-safe on different outputs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_follow_body", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FollowBody(Skeleton* skeleton, ushort* body_joints, UIntPtr body_joint_count, Affine* body_scene_from_joint, UIntPtr body_scene_from_joint_count, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count);
    [DllImport(Library, EntryPoint = "mrw_playback_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void PlaybackInit(Playback* @out);
    /// <summary>
    /// Moves `playback` on by dt_s seconds times its speed, in a clip of `duration_s`. Whatever lies beyond an end counts,
    /// however many times over: a loop loses no time and shows none twice, and so does a turn. Afterwards time_s is in
    /// 0 … duration_s, and below duration_s in a loop; an end that is reached exactly is passed or turned at only when time
    /// moves on. Events at a clip's times are due where time_s was before, where it is now, and `turns` say. A time_s
    /// outside the clip counts as one that has just run there; a duration of 0 makes it 0, without a turn.
    ///
    /// Errors: bad_argument if time_s, speed, dt_s or duration_s is not finite, or duration_s is below 0; nothing is
    /// changed.
    ///
    /// Error: dt_s · speed is exact; to add it to the time rounds once, by at most 2⁻⁵³ (time_s + |dt_s · speed|) before and
    /// 2⁻⁵³ duration_s more where a loop passes its start backwards; finding the place of a time beyond an end is exact. So
    /// after 10⁷ steps of a clip of 10 s time is off by less than 2·10⁻⁸ s. Cost: a few operations; the logarithm of the
    /// turns where there are many. The same bits everywhere; thread-safe on different playbacks.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_advance", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Advance(Playback* playback, float duration_s, float dt_s);
    /// <summary>
    /// The time to sample: time_s as a float, which never goes beyond the clip.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_clip_time", CallingConvention = CallingConvention.Cdecl)]
    public static extern float ClipTime(Playback* playback);
    /// <summary>
    /// Whether a clip that plays once has reached the end towards which it runs; it stays true then. A clip at speed 0 runs
    /// towards none.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_finished", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte Finished(Playback* playback, float duration_s);
    [DllImport(Library, EntryPoint = "mrw_sample_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SampleOptionsInit(SampleOptions* @out);
    /// <summary>
    /// Evaluates `clip` at `time_s`, clamped to each track's first and last key, as glTF 2.0 defines its interpolations:
    /// STEP, LINEAR (spherical along the shortest arc for rotations) and CUBICSPLINE (Hermite, rotations normalised). Coded
    /// tracks are blended between their two nearest frames, rotations on the sphere; they keep the cooker's --clip-error.
    ///
    /// out: at least skeleton.soa_size() elements, caller's memory; joints that the clip leaves alone get their rest pose.
    /// Errors: bad_argument if `out` or the set of joints is too short, the clip belongs to a skeleton with other joints or
    /// is additive, or time_s is not a number. Rotations differ from exact spherical interpolation by at most 1e-6 rad plus
    /// float rounding. Cost: a binary search a distinct key-time list and a few dozen operations a track, wherever time_s
    /// is. Stateless; thread-safe on different outputs.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Sample(Skeleton* skeleton, Clip* clip, float time_s, SoaTransform* @out, UIntPtr out_count, SampleOptions* options);
    [DllImport(Library, EntryPoint = "mrw_sample_cache_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SampleCacheInit(SampleCache* @out);
    /// <summary>
    /// Bytes of SampleCache::memory for this clip: 160 for each four joints that turn, move or change their size, once for
    /// each of the three.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample_cache_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr SampleCacheBytes(Clip* clip);
    /// <summary>
    /// sample() of all joints for an instance that plays on: writes the same bits, and leaves out what the call before with
    /// this cache did already. That another clip, skeleton or `out` was given than in that call is found by itself: a clip
    /// of a File by Clip::id, one that is made by hand by where its tracks lie.
    ///
    /// out: as of sample(), and nobody else writes to it as long as the cache is in use, not to joints that move either:
    /// what rests between two frames is not written again. For a pose that is changed afterwards copy it, or let blend()
    /// read it. cache: one for each `out`; `= {memory}` forgets, as is needed if `out` was written by others. Errors: as
    /// sample(), and bad_argument if the cache's memory is not on a boundary of 16 bytes; then it forgets nothing. Cost: in
    /// the worst case that of sample() and a copy of the frames; playing at 60 Hz over keys at 30 Hz about half.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample_cached", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SampleCached(Skeleton* skeleton, Clip* clip, float time_s, SoaTransform* @out, UIntPtr out_count, SampleCache* cache);
    /// <summary>
    /// Evaluates a clip cooked as additive (`marrow cook --additive`): out = what turns its reference pose into the pose
    /// that sample() would give of an ordinary clip, for add(). Laid on the reference with weight 1 it gives that pose,
    /// within the cooker's --clip-error; joints that the clip leaves alone do not change, where the reference is the rest
    /// pose in them.
    ///
    /// out: at least skeleton.soa_size() elements, caller's memory. Errors: as sample(), and bad_argument if the clip is not
    /// additive. Cost: sample() and make_additive(). Stateless; thread-safe on different outputs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample_additive", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SampleAdditive(Skeleton* skeleton, Clip* clip, float time_s, AdditiveTransform* @out, UIntPtr out_count);
    /// <summary>
    /// Evaluates the clip's channels at `time_s` as above: out[i] is the value of clip.channels[i].
    ///
    /// out: at least clip.channels.size floats. Which channel is which: File::find_channel; numbers that the clip does not
    /// drive have no channel, and keep what the game gives them. An additive clip's channels are values all the same, no
    /// changes. Errors: bad_argument if `out` is too short or time_s is not
    /// a number. Cost: a binary search a distinct key-time list and a few operations a channel.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample_channels", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SampleChannels(Clip* clip, float time_s, float* @out, UIntPtr out_count);
    [DllImport(Library, EntryPoint = "mrw_curve_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void CurveInit(Curve* @out);
    [DllImport(Library, EntryPoint = "mrw_arc_length_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void ArcLengthInit(ArcLength* @out);
    [DllImport(Library, EntryPoint = "mrw_cubic_bezier_ease_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void CubicBezierEaseInit(CubicBezierEase* @out);
    /// <summary>
    /// How many floats `key_count` keys of `components` hold.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_curve_value_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr CurveValueCount(CurveKind kind, uint components, UIntPtr key_count);
    /// <summary>
    /// Whether a curve keeps the rules above: call it once for keys that come from outside. Errors: bad_argument if `kind`
    /// is unknown, there is no key, components is not 1 … 4 (4 for rotations) or values are missing; bad_data if times do
    /// not increase strictly, a number is not finite, a value or control point beyond 1e18, or a tangent over the longest
    /// interval, or a rotation key's squared length is off 1 by more than 1e-3. Cost: once over the keys.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_check_curve", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status CheckCurve(Curve* curve);
    /// <summary>
    /// The value at `time_s`, clamped to the first and last key; one key is a constant.
    ///
    /// out: at least curve.components floats. Errors: bad_argument as in check_curve(), if `out` is too short, or time_s is
    /// not a number. Keys that check_curve() refuses with bad_data are safe but give garbage; of others values are finite.
    /// At a key's time the value is exactly the key's (rotations: but for normalisation and sign). Cost: a binary search and
    /// some dozen operations.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_evaluate_curve", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status EvaluateCurve(Curve* curve, float time_s, float* @out, UIntPtr out_count);
    /// <summary>
    /// The derivative of evaluate_curve() by time, a second. At an inner key: of what follows; before the first and after
    /// the last key: 0. Arguments, errors and cost as there; also unsupported for rotations, and
    /// bad_data, with nothing written, if it is not finite, as keys are so far apart in so little time.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_curve_velocity", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status CurveVelocity(Curve* curve, float time_s, float* @out, UIntPtr out_count);
    /// <summary>
    /// Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
    ///
    /// keys: kind linear. out: curve_value_count(hermite, …) floats, which with the same times are a curve of kind hermite;
    /// it does not overlap the keys. natural_spline: the second derivative is zero at both ends. clamped_spline: the first
    /// derivative at the ends is given, `components` floats a second each. One key: tangents 0, or those given.
    /// Rotations are written with signs that make neighbours nearest; then the spline runs through the four components.
    /// Errors: as check_curve(keys); bad_argument also if kind is not linear or a span is too short; bad_data also if keys
    /// are so close in time or so far in value that a tangent is not finite. After bad_data `out` may hold garbage. Method:
    /// tridiagonal system of the tangents, diagonally dominant, solved by elimination without pivots (de Boor, A Practical
    /// Guide to Splines, chapter IV) in `out` alone. Cost: twice over the keys.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_natural_spline", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status NaturalSpline(Curve* keys, float* @out, UIntPtr out_count);
    /// <summary>
    /// Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
    ///
    /// keys: kind linear. out: curve_value_count(hermite, …) floats, which with the same times are a curve of kind hermite;
    /// it does not overlap the keys. natural_spline: the second derivative is zero at both ends. clamped_spline: the first
    /// derivative at the ends is given, `components` floats a second each. One key: tangents 0, or those given.
    /// Rotations are written with signs that make neighbours nearest; then the spline runs through the four components.
    /// Errors: as check_curve(keys); bad_argument also if kind is not linear or a span is too short; bad_data also if keys
    /// are so close in time or so far in value that a tangent is not finite. After bad_data `out` may hold garbage. Method:
    /// tridiagonal system of the tangents, diagonally dominant, solved by elimination without pivots (de Boor, A Practical
    /// Guide to Splines, chapter IV) in `out` alone. Cost: twice over the keys.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_clamped_spline", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status ClampedSpline(Curve* keys, float* first_velocity, UIntPtr first_velocity_count, float* last_velocity, UIntPtr last_velocity_count, float* @out, UIntPtr out_count);
    /// <summary>
    /// A Bézier curve of any degree at u, by de Casteljau's algorithm.
    ///
    /// points: degree + 1 points of `components` floats (1 … 4). scratch: at least points.size floats, overlapping nothing.
    /// out: at least `components`. u outside [0, 1] extrapolates. Errors: bad_argument if there is no point, points.size is
    /// no multiple of components, a span is too short, or u is not finite; bad_data if the result is not finite.
    /// Cost: degree · (degree + 1) / 2 interpolations.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bezier", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Bezier(float* points, UIntPtr point_count, uint components, float u, float* scratch, UIntPtr scratch_count, float* @out, UIntPtr out_count);
    /// <summary>
    /// The same for unit quaternions, each taken with the sign nearer to the one before; normalised. bad_data also if the
    /// result has no direction, or is too long to be squared.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bezier_rotation", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BezierRotation(float* quaternions, UIntPtr quaternion_count, float u, float* scratch, UIntPtr scratch_count, float* @out, UIntPtr out_count);
    /// <summary>
    /// A bicubic patch over 4 × 4 points: the tensor product of two cubics.
    ///
    /// points: 16 · components floats, component by component within a point, points along u first, then v. out: at least
    /// `components` (1 … 4). Errors: bad_argument if a span is too short, the basis is unknown, or u or v is not finite;
    /// bad_data, with nothing written, if the result is not finite.
    /// Cost: 20 blends of four points.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bicubic_patch", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BicubicPatch(PatchBasis basis, float* points, UIntPtr point_count, uint components, float u, float v, float* @out, UIntPtr out_count);
    /// <summary>
    /// How many floats the table of a curve has.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_arc_length_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr ArcLengthCount(UIntPtr key_count, uint steps);
    /// <summary>
    /// Measures `curve` once. out: arc_length_count() floats; the last is the length of all, in the unit of the values.
    /// Errors: as evaluate_curve(); unsupported for rotations (slerp is even as it is) and for kind step; bad_argument if
    /// `steps` is 0 or `out` too short; bad_data if a length is not finite. Three-point Gauss quadrature a step: exact for
    /// linear, and else of the order steps⁻⁶ where the path does not stop inside a step. Cost: 3 square roots a step.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_build_arc_length", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BuildArcLength(Curve* curve, uint steps, float* @out, UIntPtr out_count);
    /// <summary>
    /// The time at which `curve` has gone `distance`, clamped to the path; where the path rests, the end of the rest.
    /// Between two entries the length is taken as linear, so the point found is off along the path by at most
    /// A / (8 steps²), A being the largest second derivative by u in that key interval, plus rounding: twice the steps,
    /// a quarter of the error. Errors: bad_argument if the table is too short for this curve or `distance` is not a number.
    /// Cost: a binary search.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_time_at_distance", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status TimeAtDistance(Curve* curve, ArcLength* table, float distance, float* time_s);
    /// <summary>
    /// From 0 at u = 0 to 1 at u = 1, both exactly; u is clamped, and what is not a number counts as 0. back and elastic
    /// overshoot. out(u) = 1 - in(1 - u), in_out is the one, then the other at half size. As in Penner's, expo and elastic
    /// leave 0 (out: reach 1) with a jump of 1e-3 or less; back's overshoot is 1.70158, 1.525 times that for in_out;
    /// elastic's period is 0.3, 0.45 for in_out. Within 1e-6 of the closed forms. Unknown enumerators: linear.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_ease", CallingConvention = CallingConvention.Cdecl)]
    public static extern float Ease(Easing easing, EaseMode mode, float u);
    /// <summary>
    /// y at x = u, with u clamped to [0, 1]. The point lies on the curve within 3e-7 in x (4e-7 (1 + |y1| + |y2|) in y):
    /// where the curve is steep, y is as uncertain as x is. Errors: bad_argument unless x1 and x2 are in [0, 1], y1 and y2
    /// finite and u a number. Newton's method within a shrinking bracket. Cost: about 5 steps, at most 40.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_ease_by_curve", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status EaseByCurve(CubicBezierEase* curve, float u, float* @out);
    [DllImport(Library, EntryPoint = "mrw_blend_layer_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void BlendLayerInit(BlendLayer* @out);
    [DllImport(Library, EntryPoint = "mrw_additive_layer_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void AdditiveLayerInit(AdditiveLayer* @out);
    /// <summary>
    /// out = Σ w x / Σ w for each joint, with w = weight · mask: translations and scales are averaged, rotations are summed
    /// as quaternions and normalised. Rotations must be unit quaternions, of which no sum can be 0 then.
    ///
    /// Hemisphere: a layer's quaternion is negated where it points away from the sum of the layers before it, so the result
    /// is that of the shorter arcs for two layers and does not cancel for any number; its sign is arbitrary. Where Σ w is
    /// below `threshold`, the rest pose joins in with the weight that is missing, so no layers at all give the rest pose. A
    /// single layer without a mask is copied bit for bit. Layers of weight 0 are not read; without masks, neither are those
    /// below 1e-12 of the sum or of `threshold`. Finite for poses with translations and scales up to 1e15.
    ///
    /// layers: any number; out: at least skeleton.soa_size(), and may be the pose of a layer. threshold: 1e-6 …
    /// kMaxBlendWeight.
    /// Errors: bad_argument if a span is too short, or a weight or the threshold is out of its range or not a number.
    /// Cost: 14 multiply-adds a layer and joint, a square root and a division, four joints at once.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_blend", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Blend(Skeleton* skeleton, BlendLayer* layers, UIntPtr layer_count, SoaTransform* @out, UIntPtr out_count, float threshold);
    /// <summary>
    /// Replaces a part of `pose`: goes from pose to layer.pose by w = weight · mask, on the shorter arc. Where w is 0 the
    /// pose keeps its bits, where it is 1 it gets the layer's bits, whatever the other joints do.
    /// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_overlay", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Overlay(Skeleton* skeleton, BlendLayer* layer, SoaTransform* pose, UIntPtr pose_count);
    /// <summary>
    /// out = what turns `reference` into `pose`: differences of translations, pose · reference⁻¹ of rotations, ratios of
    /// scales (1 where the reference is less than 1e-20). Rotations must be unit quaternions. Clips cooked as additive hold
    /// their reference and yield changes by themselves: sample_additive(). Errors: bad_argument if a span is too short.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_additive", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeAdditive(Skeleton* skeleton, SoaTransform* pose, UIntPtr pose_count, SoaTransform* reference, UIntPtr reference_count, AdditiveTransform* @out, UIntPtr out_count);
    /// <summary>
    /// Lays w = weight · mask of a change on `pose`: translation + w Δ; rotation multiplied from the left by the normalised
    /// mean of identity and change; scale · (1 + w (ratio - 1)). Where w is 0 the pose keeps its bits.
    /// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_add", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Add(Skeleton* skeleton, AdditiveLayer* layer, SoaTransform* pose, UIntPtr pose_count);
    [DllImport(Library, EntryPoint = "mrw_inertia_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void InertiaInit(Inertia* @out);
    [DllImport(Library, EntryPoint = "mrw_inertial_start_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void InertialStartInit(InertialStart* @out);
    /// <summary>
    /// The new clip's weight, `time_s` after the fade began: exactly 0 at or before 0 and for what is not a number, exactly
    /// 1 from duration_s on (at once if that is not above 0).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_fade_weight", CallingConvention = CallingConvention.Cdecl)]
    public static extern float FadeWeight(Fade shape, float time_s, float duration_s);
    /// <summary>
    /// blend() of two poses: from at weight 0, to at weight 1, both bit for bit.
    /// from, to, out: at least skeleton.soa_size(); out may be either of the poses.
    /// Errors: bad_argument if a span is too short or the weight not in 0 … 1.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_cross_fade", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status CrossFade(Skeleton* skeleton, SoaTransform* from, UIntPtr from_count, SoaTransform* to, UIntPtr to_count, float weight, SoaTransform* @out, UIntPtr out_count);
    /// <summary>
    /// Captures the offset and its velocity; from then on only the new clip is sampled, and apply_inertia() gives what is
    /// shown.
    ///
    /// Inertialisation: D. Bollo, GDC 2018. Each component is the quintic with the offset's value and velocity at the start,
    /// and value, velocity, acceleration and jerk 0 at the end, in the factored form above. A component on its way to zero
    /// that would pass it before duration_s ends sooner, 5 start / -velocity after the beginning, so no offset
    /// changes its sign. Other than there, x, y and z are not reduced to a length on a fixed axis, so the whole velocity
    /// is carried over and not only its part along the offset. The growth of a turn is limited so that it stays below a
    /// whole one; a turn of more than a quarter in one frame is not carried over faithfully.
    /// Rotations must be unit quaternions, translations and scales at most 1e15: then all is finite, here and below. To
    /// begin anew in the middle of a transition, pass the poses that were shown. Errors: bad_argument if a span is too
    /// short, or frame_s or duration_s is not above 0 and finite, or duration_s is above 1e6. Cost: two logarithms of
    /// quaternions a joint, four joints at a time; no allocation.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_begin_inertia", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BeginInertia(Skeleton* skeleton, InertialStart* start, float duration_s, Inertia* inertia);
    /// <summary>
    /// pose: in, the new clip's pose `time_s` after the beginning; out, what is to be shown. From duration_s on, and before
    /// any begin_inertia(), the pose keeps its bits. Times below 0 count as 0.
    /// Errors: bad_argument if a span is too short or time_s not a number.
    /// Cost: nine quintics and one exponential a joint, four joints at a time.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_apply_inertia", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status ApplyInertia(Skeleton* skeleton, Inertia* inertia, float time_s, SoaTransform* pose, UIntPtr pose_count);
    /// <summary>
    /// scene_from_joint = scene_from_root · Π parent_from_joint, from the root down; scene_from_root is what the source has
    /// above the skeleton and never moves, so the matrices are in the source's scene space.
    ///
    /// local: at least skeleton.soa_size(); out: at least skeleton.joint_count; they do not overlap.
    /// Errors: bad_argument if a span is too short.
    /// Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint: 70 instructions on x86-64, 49
    /// on AArch64. Thread-safe on different outputs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_local_to_model", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status LocalToModel(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, Affine* @out, UIntPtr out_count);
    /// <summary>
    /// The same for the first `joint_count` joints only, to the same bits: a level of detail. Joints are breadth-first, so
    /// whatever the count, parents are among them. The others' matrices are left as they are.
    ///
    /// local: at least soa_count(joint_count); out: at least joint_count. Errors: bad_argument also if there are fewer
    /// joints.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_local_to_model_first", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status LocalToModelFirst(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, uint joint_count, Affine* @out, UIntPtr out_count);
    /// <summary>
    /// The same for `joint` and all that hangs below it only, after a change of their local transforms: by inverse
    /// kinematics, say. `out` holds the matrices of the whole skeleton; all others keep their bits.
    ///
    /// local: at least skeleton.soa_size(); out: at least skeleton.joint_count. Errors: bad_argument also if there is no
    /// such joint. Cost: what local_to_model does for these joints, groups that a generation of them cuts as whole ones, and
    /// one comparison for each other joint from `joint` to the last generation.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_local_to_model_below", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status LocalToModelBelow(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, uint joint, Affine* @out, UIntPtr out_count);
    [DllImport(Library, EntryPoint = "mrw_limit_description_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void LimitDescriptionInit(LimitDescription* @out);
    [DllImport(Library, EntryPoint = "mrw_rotation_follower_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void RotationFollowerInit(RotationFollower* @out);
    [DllImport(Library, EntryPoint = "mrw_point_follower_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void PointFollowerInit(PointFollower* @out);
    /// <summary>
    /// Angles least_rad … most_rad; all of them if that is a turn or more.
    /// Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_angle_range", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeAngleRange(float least_rad, float most_rad, AngleRange* @out);
    /// <summary>
    /// `out` is written only on success.
    /// Errors: bad_argument if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least is
    /// above most, an angle is beyond ±2π, a swing not in 0 … kWidestSwing_rad or not symmetric, the second angle of an
    /// euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is none of the above.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_limit", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeLimit(LimitDescription* description, ushort joint, JointLimit* @out);
    /// <summary>
    /// local: in, a rotation x y z w; out, one inside the limit, in the same hemisphere and of unit length.
    ///
    /// What is inside, or outside by no more than kLimitTolerance_rad, keeps its bits, so a second call changes nothing.
    /// What comes out is inside within the same tolerance.
    ///
    /// Outside it is the nearest rotation for a hinge; for a cone the nearest swing, and of the twists the nearest with it;
    /// for euler boxes one round of exact searches along each angle from the clamped angles. docs/ik/limits.md has how near
    /// that is. The nearest rotation jumps where one side of the range is as far as the other. So that the result moves
    /// continuously, over the last quarter of the way from the limit to there it moves through the middle of the range: of a
    /// turn about an axis to the angle opposite the middle, of a swing to 180°, where in its place the twist is lost; and of
    /// euler angles to ±90° of the second, where the third and the first are one. Distances are as tangents of a quarter of
    /// the angle. A range of all angles is a circle, to which nothing leads continuously: it jumps at a swing of 180°, and
    /// an euler limit whose second angle reaches ±90° jumps there, by no more than twice what the rotation is outside.
    ///
    /// Errors: bad_argument if the rotation has no length or is not finite; nothing is written.
    /// Cost: 5 to 15 products of quaternions and a few square roots, inside 3; no trigonometry. Thread-safe.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_clamp_rotation", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status ClampRotation(JointLimit* limit, float* local);
    /// <summary>
    /// By how many radians clamp_rotation() would turn the rotation; 0 for what keeps its bits, and for what it refuses.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_limit_excess", CallingConvention = CallingConvention.Cdecl)]
    public static extern float LimitExcess(JointLimit* limit, float* local);
    /// <summary>
    /// clamp_rotation() for each limit's joint; all other joints keep their bits, and so do rotations that are not finite.
    /// local: of a skeleton that has all the joints. Errors: bad_argument if it has not; nothing is written.
    /// Cost: clamp_rotation() a limit. Thread-safe on different poses.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_limit_pose", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status LimitPose(JointLimit* limits, UIntPtr limit_count, SoaTransform* local, UIntPtr local_count);
    /// <summary>
    /// The limit of a joint, or null. Precondition: the limits' joints ascend, as in a Skeleton. Cost: a binary search.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_find_limit", CallingConvention = CallingConvention.Cdecl)]
    public static extern JointLimit* FindLimit(JointLimit* limits, UIntPtr limit_count, uint joint);
    /// <summary>
    /// Moves `state` for dt_s towards a target that went straight from where it was in the last call to `target`; the result
    /// is state.rotation or state.point.
    ///
    /// A follower that is on its target stays on it, to the bit, as long as the target keeps within the limits. Else it goes
    /// the quickest way there that they allow, and brakes in time: towards a target at rest it neither passes it nor swings
    /// about it, unless it is too fast already or comes from aside. Braking uses nine tenths of the acceleration; the last
    /// part, of 0.9 acceleration / 120² s⁻², is approached as exp(-120 t / s). Without a limit of acceleration it goes with
    /// the speed until it is there; without any limit it is on its target.
    /// Rotations go the shorter way round, along the great circle if they come from rest. Where their target passes aside
    /// they may exceed the acceleration by a few hundredths.
    ///
    /// The path is the same at any frame rate but for how its target is sampled: time goes in even steps of at most 1/960 s,
    /// each with constant acceleration. At rates that divide 960 Hz paths to a target at rest agree to rounding, at others
    /// from 15 to 240 Hz within the larger of 1e-4 rad (m) and 0.1 % of the way; moving targets: docs/ik/limits.md.
    ///
    /// dt_s of 0 changes nothing; what is above 0.25 s counts as 0.25 s, and less than a nanosecond as that. So all that a
    /// follower keeps is finite.
    /// Errors: bad_argument if a number is not finite, dt_s or a limit below 0, a limit from 1e18 on, a target from 1e15 m
    /// on, the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a logarithm of a
    /// quaternion; else a square root or two each step. No trigonometry of a library; the same bits everywhere. Thread-safe
    /// on different states.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_follow_rotation", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FollowRotation(RotationFollower* state, float* target, float dt_s, RateLimit* limit);
    /// <summary>
    /// Moves `state` for dt_s towards a target that went straight from where it was in the last call to `target`; the result
    /// is state.rotation or state.point.
    ///
    /// A follower that is on its target stays on it, to the bit, as long as the target keeps within the limits. Else it goes
    /// the quickest way there that they allow, and brakes in time: towards a target at rest it neither passes it nor swings
    /// about it, unless it is too fast already or comes from aside. Braking uses nine tenths of the acceleration; the last
    /// part, of 0.9 acceleration / 120² s⁻², is approached as exp(-120 t / s). Without a limit of acceleration it goes with
    /// the speed until it is there; without any limit it is on its target.
    /// Rotations go the shorter way round, along the great circle if they come from rest. Where their target passes aside
    /// they may exceed the acceleration by a few hundredths.
    ///
    /// The path is the same at any frame rate but for how its target is sampled: time goes in even steps of at most 1/960 s,
    /// each with constant acceleration. At rates that divide 960 Hz paths to a target at rest agree to rounding, at others
    /// from 15 to 240 Hz within the larger of 1e-4 rad (m) and 0.1 % of the way; moving targets: docs/ik/limits.md.
    ///
    /// dt_s of 0 changes nothing; what is above 0.25 s counts as 0.25 s, and less than a nanosecond as that. So all that a
    /// follower keeps is finite.
    /// Errors: bad_argument if a number is not finite, dt_s or a limit below 0, a limit from 1e18 on, a target from 1e15 m
    /// on, the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a logarithm of a
    /// quaternion; else a square root or two each step. No trigonometry of a library; the same bits everywhere. Thread-safe
    /// on different states.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_follow_point", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FollowPoint(PointFollower* state, float* target, float dt_s, RateLimit* limit);
    /// <summary>
    /// follow_rotation() for the joints whose limit has a rate: in, the pose's rotations are the targets; out, what follows.
    /// All others keep their bits. To stay inside the limits call limit_pose() before, for the targets, and after, for the
    /// way there may lead outside.
    /// states: one a limit. Errors: bad_argument if there are too few, a joint is beyond the pose, or dt_s is below 0 or not
    /// finite; nothing is written. Joints whose rotation is not finite keep it.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_follow_pose", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FollowPose(JointLimit* limits, UIntPtr limit_count, RotationFollower* states, UIntPtr state_count, float dt_s, SoaTransform* local, UIntPtr local_count);
    [DllImport(Library, EntryPoint = "mrw_two_bone_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void TwoBoneInit(TwoBone* @out);
    [DllImport(Library, EntryPoint = "mrw_two_bone_joints_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void TwoBoneJointsInit(TwoBoneJoints* @out);
    [DllImport(Library, EntryPoint = "mrw_two_bone_limb_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void TwoBoneLimbInit(TwoBoneLimb* @out);
    [DllImport(Library, EntryPoint = "mrw_aim_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void AimInit(Aim* @out);
    /// <summary>
    /// Method: the law of cosines in half-angles from lengths, (s - x)(s + x) and (x - m)(x + m), s and m the sum and the
    /// difference of the lengths; then the shortest arc to the target and a turn about it, in one quaternion.
    /// Of a bone of no length the rest is still done; nothing becomes infinite. A target at the start joint folds the limb.
    /// The turns are about the axes of the matrices. Where a joint's own scale mirrors it, its turn's x changes sign if just
    /// one of that scale's y and z is negative, y by z and x, z by x and y; the whole call does so.
    /// Errors: bad_argument, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
    /// large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
    /// Cost: 400 instructions on x86-64, 326 on AArch64; about as much again where the limb is nearly straight or bent the
    /// wrong way, the target more than 140° off or near the pole, or there is a twist.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_turn_two_bone", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status TurnTwoBone(TwoBoneJoints* joints, TwoBone* goal, TwoBoneTurns* @out);
    /// <summary>
    /// Four limbs at once, to the same numbers, at 60 % of the instructions each. Fill up with copies.
    /// Errors: as above, for all four if one is bad.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_turn_two_bone_x4", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status TurnTwoBoneX4(TwoBoneJoints* joints, TwoBone* goals, TwoBoneTurns* @out);
    /// <summary>
    /// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
    /// 0. reached: may be null; see TwoBoneTurns. Errors: as above, and bad_argument if a span is too short or the joints
    /// are not a chain; nothing is written. Cost: the kernel's, and local_to_model_below(start).
    /// Where the limb changes its shape as it turns, by uneven scale above it or of its start joint, it is bent by secants
    /// and then turned: three to five times the cost, at most twelve. The target is met nevertheless; reached says if not.
    /// May be null: reached.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_two_bone", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveTwoBone(Skeleton* skeleton, TwoBoneLimb* limb, TwoBone* goal, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, byte* reached);
    /// <summary>
    /// Method: the point where the ray is as far from the joint as the target is turned onto it by the shortest arc and a
    /// turn about it, in one quaternion.
    /// Errors: bad_argument, and nothing is written, for numbers that are not finite (or too large to be squared), or a
    /// weight outside 0 … 1.
    /// Cost: 219 instructions on x86-64, 180 on AArch64.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_turn_aim", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status TurnAim(Affine* joint, Aim* goal, AimTurn* @out);
    /// <summary>
    /// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
    /// 0. reached: may be null. Errors: as above, and bad_argument if a span is too short or there is no such joint; nothing
    /// is written. Cost: the kernel's, and local_to_model_below(joint).
    /// May be null: reached.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_aim", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveAim(Skeleton* skeleton, uint joint, Aim* goal, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, byte* reached);
    /// <summary>
    /// The same for a chain that shares the turn, such as spine, neck and head: joints from the lowest up to the one that
    /// looks, each below the one before it, whose forward, up and offset are meant; it does what the others leave.
    /// falloff: each joint's share of the turn, of what the next one has; 1: all alike, 0: the last alone.
    /// Errors: as above, and bad_argument if `joints` is empty or not a chain, or falloff not in 0 … 1.
    /// May be null: reached.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_look_at", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveLookAt(Skeleton* skeleton, uint* joints, UIntPtr joint_count, Aim* goal, float falloff, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, byte* reached);
    [DllImport(Library, EntryPoint = "mrw_ik_goal_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void IkGoalInit(IkGoal* @out);
    [DllImport(Library, EntryPoint = "mrw_ik_problem_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void IkProblemInit(IkProblem* @out);
    [DllImport(Library, EntryPoint = "mrw_ik_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void IkOptionsInit(IkOptions* @out);
    /// <summary>
    /// Bytes of scratch memory that solve_ik needs; 0 of a problem without goals or joints that could be read.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_ik_scratch_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr IkScratchBytes(Skeleton* skeleton, IkProblem* problem, IkOptions* options);
    /// <summary>
    /// Turns the joints so that the goals are reached, or as nearly as may be, starting from the pose that is there.
    ///
    /// local: at least skeleton.soa_size(), parent_from_joint; changed: rotations of problem.joints, and the translation of
    /// joints[0] if it may travel. scene_from_joint: at least skeleton.joint_count, of this pose (local_to_model); brought
    /// up to date for what hangs below the joints that turn. scratch: at least ik_scratch_bytes(), of any alignment. report:
    /// may be null.
    /// A rotation in scene space is the product of the rotations from the root down; scale has no part in it.
    /// Errors, and nothing is written: bad_argument if a span is too short, an index out of range, `joints` not ascending,
    /// there are more than kMaxJoints goals, or a goal that no joint turns, a number not finite, a weight or a stiffness out
    /// of range, or the pose not finite on the way to a goal.
    /// Cost: docs/ik.md. Thread-safe on different poses and scratch.
    /// May be null: options, report.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_ik", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveIk(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, IkProblem* problem, IkOptions* options, void* scratch, UIntPtr scratch_bytes, IkReport* report);
    /// <summary>
    /// The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
    /// memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
    /// others.
    /// May be null: options, report.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_ik_chain", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveIkChain(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, IkProblem* problem, IkOptions* options, void* scratch, UIntPtr scratch_bytes, IkReport* report);
    /// <summary>
    /// The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
    /// memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
    /// others.
    /// May be null: options, report.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_ik_body", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveIkBody(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, IkProblem* problem, IkOptions* options, void* scratch, UIntPtr scratch_bytes, IkReport* report);
    /// <summary>
    /// The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
    /// the result jumps as goals move. A function of its own, so that what does not call it does not link it.
    ///
    /// A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
    /// the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
    /// with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
    /// keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
    /// docs/ik.md: tens of microseconds a generation.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_ik_genetic_scratch_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr IkGeneticScratchBytes(Skeleton* skeleton, IkProblem* problem);
    /// <summary>
    /// The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
    /// the result jumps as goals move. A function of its own, so that what does not call it does not link it.
    ///
    /// A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
    /// the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
    /// with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
    /// keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
    /// docs/ik.md: tens of microseconds a generation.
    /// May be null: options, report.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_solve_ik_genetic", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SolveIkGenetic(Skeleton* skeleton, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, IkProblem* problem, IkOptions* options, void* scratch, UIntPtr scratch_bytes, IkReport* report);
    [DllImport(Library, EntryPoint = "mrw_foot_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FootInit(Foot* @out);
    [DllImport(Library, EntryPoint = "mrw_feet_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FeetInit(Feet* @out);
    [DllImport(Library, EntryPoint = "mrw_foot_ground_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FootGroundInit(FootGround* @out);
    [DllImport(Library, EntryPoint = "mrw_foot_motion_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FootMotionInit(FootMotion* @out);
    [DllImport(Library, EntryPoint = "mrw_feet_frame_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void FeetFrameInit(FeetFrame* @out);
    /// <summary>
    /// Where a ray for a foot is to go through: its sole as animated, in the world.
    /// Errors: bad_argument if the span is too short, there is no such joint, or the place is not finite or beyond 1e6.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_foot_sole", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FootSole(Foot* foot, Affine* world_from_scene, Affine* scene_from_joint, UIntPtr scene_from_joint_count, float* sole_world);
    /// <summary>
    /// Places the feet: turns hips, knees and ankles, shifts the pelvis, and brings the matrices of what hangs below up to
    /// date. Call it after local_to_model(), and cast the rays before it, from the same pose.
    ///
    /// local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count. ground, motion: one a foot.
    ///
    /// The sole's target is its animated place, lifted by the height of the ground's plane there; the foot leans with the
    /// plane about its sole. What is planted keeps its place across `up`, and its heading; along `up` it moves as animated,
    /// so that a heel can rise. A step in the ground (another plane than in the last frame), and on release the way to the
    /// target, are an offset from the target that dies away as a critically damped spring at rest does, with the speed
    /// that it had: exact whatever the frame rate, and without a jump in place or speed. The pelvis moves by the lowest
    /// sole's ground, and as much further down as the legs need to reach. Ankles keep their animated attitude but for lean
    /// and heading. See docs/ik/feet.md.
    ///
    /// Errors: bad_argument if a span is too short, joints are not as they should be, or a number is not finite, out of its
    /// range or beyond 1e6; nothing is written.
    /// Cost: local_to_model_below() of the pelvis, if that moves, of each hip and each ankle; one solve_two_bone() a foot,
    /// up to three where joints are scaled unevenly: 6700 instructions a foot on x86-64, the skeleton having 27 joints. No
    /// allocation; thread-safe on different motions and poses.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_place_feet", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status PlaceFeet(Skeleton* skeleton, Feet* feet, FeetFrame* frame, FootGround* ground, UIntPtr ground_count, FootMotion* motion, UIntPtr motion_count, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count);
    [DllImport(Library, EntryPoint = "mrw_springs_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SpringsInit(Springs* @out);
    [DllImport(Library, EntryPoint = "mrw_spring_frame_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SpringFrameInit(SpringFrame* @out);
    /// <summary>
    /// What make_springs needs: 352 bytes for four bones, 272 a chain, 2 a joint of the skeleton; 0 without chains.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_springs_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr SpringsBytes(Skeleton* skeleton, SpringChain* chains, UIntPtr chain_count);
    /// <summary>
    /// Lays springs out in `memory`, which they use from then on, at rest in whatever pose comes first.
    ///
    /// memory: at least springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
    /// Errors: bad_argument if a setting is out of its range, a joint is not in the skeleton or not below the one before it,
    /// a chain has no bone, or the memory does not do; nothing is written.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_springs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeSprings(Skeleton* skeleton, SpringChain* chains, UIntPtr chain_count, void* memory, UIntPtr memory_bytes, Springs* @out);
    /// <summary>
    /// New settings for the same joints, in the midst of motion. Errors: as make_springs, or not the same joints.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_set_springs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SetSprings(Skeleton* skeleton, SpringChain* chains, UIntPtr chain_count, Springs* springs);
    /// <summary>
    /// The next frame begins at rest in its pose.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_reset_springs", CallingConvention = CallingConvention.Cdecl)]
    public static extern void ResetSprings(Springs* springs);
    /// <summary>
    /// Moves the springs on by a frame and bends `local` by them; the matrices of what hangs below are brought up to date.
    ///
    /// local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count; local_to_model() has made
    /// the one from the other. Springs never read what they have written: give them the animated pose of every frame.
    ///
    /// Model. A bone is a damped pendulum about its joint: for its direction d in the world, a unit vector of velocity u,
    ///   du/dt = [ω² t + 2 ζ ω dt'/dt + (gravity - A) / L + drag (wind - V) / L] - (2 ζ ω + drag) u,
    /// of which the part along d is borne by the bone, whose length L never changes. t is the animated direction, turned
    /// with the bones above it as they swing; t' the same without what those do; V and A are velocity and acceleration of
    /// the chain's first joint, from a parabola through its last three places. The first two terms together turn the bone no
    /// harder than SpringJoint::most_pull, if that is set: a load that is more makes it yield. The pull ω² t is in
    /// proportion to the sine of the angle: as much as a linear spring's for small ones, nothing at half a turn. A bone
    /// feels those above it, they do not feel it; so of equal bones in a chain the lower swings 1 / (2 ζ) as far at the
    /// common frequency, less than the upper from ζ = ½ on. A turn of the joint is the shortest that takes the bone there. A
    /// chain below another's joint is carried by it, but does not feel its swing.
    ///
    /// Method. Equal steps of at most 1/60 s: kick, drift on a great circle, kick (Störmer-Verlet), half of the damping
    /// before and half after. Drift and kicks have the strengths with which small swings have the exact frequency and decay,
    /// whatever the step; so a path does not depend on the frame rate but for how the animation's frames cut its curves. The
    /// energy |u|²/2 - F·d is held down to the work done, so that it never grows without input.
    /// What hangs on a bone turns by the nearest rotation to its parent's that takes the one direction to the other, which
    /// is a projection (P. Davenport's matrix; see G. Wahba, SIAM Review 7(3), 1965) and costs one product of matrix and
    /// vector a joint.
    ///
    /// Scales that are not one scale, above a joint: directions are then approximate, lengths still kept. A bone shorter
    /// than a micrometre stays as it is. A weight of 0 leaves the bits of a joint, and, all 0, those of the matrices.
    /// Errors: bad_argument if a span is too short, the skeleton has another count of joints, a number is not finite or out
    /// of its range, or there are more than kMaxSpringColliders; nothing is written.
    /// Cost: at 60 frames/s 726 instructions a joint on x86-64; with colliders 110 more, and 110 for each. No allocation;
    /// thread-safe on different springs and poses.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_simulate_springs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SimulateSprings(Skeleton* skeleton, SpringFrame* frame, Springs* springs, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count);
    /// <summary>
    /// For each target of `mesh` the index of the channel of `clip` that drives its weight, or kNoChannel. The mesh is of
    /// `file`, the clip of `clips`, the same or a clip pack. out: at least mesh.targets.size; errors: bad_argument. Cost:
    /// compares names; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_find_weight_channels", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FindWeightChannels(File* file, Mesh* mesh, File* clips, Clip* clip, uint* @out, UIntPtr out_count);
    /// <summary>
    /// The weights of a moment: of each target its channel's value, or its default without. channels: from
    /// find_weight_channels(); values: from sample_channels() of the same clip; empty spans: all defaults.
    /// out: at least mesh.targets.size. Errors: bad_argument (`out` or `channels` too short, a channel outside the values).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_morph_weights", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MorphWeights(Mesh* mesh, uint* channels, UIntPtr channel_count, float* values, UIntPtr value_count, float* @out, UIntPtr out_count);
    /// <summary>
    /// Bytes that make_morphed() needs; 0 for a geometry without targets, which is its own morphed geometry.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_morphed_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr MorphedBytes(Geometry* geometry);
    /// <summary>
    /// The bind pose. memory: at least morphed_bytes(), 16-byte aligned (bad_argument otherwise); `out` keeps pointers into
    /// it and into `geometry`'s block. Cost: a copy of the vertices; once an instance.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_morphed", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeMorphed(Geometry* geometry, void* memory, UIntPtr memory_bytes, MorphedGeometry* @out);
    /// <summary>
    /// Moves the vertices by `weights`, one a target; whatever they were moved by before is undone. Targets with weight 0
    /// cost nothing. Errors: bad_argument (too few weights, or one that is not finite: nothing is written).
    /// Cost: in proportion to the vertices (blocks of four) that targets with another weight move, and the call before
    /// moved. Instructions a vertex, x86-64, g++ 12 -O3: 9 a target for positions, 15 with normals, 21 with tangents; and,
    /// however many targets move it, 8, 20 or 29 to undo and normalise.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_morph", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Morph(float* weights, UIntPtr weight_count, MorphedGeometry* morphed);
    /// <summary>
    /// Brings animation-space coordinates up to date with the last morph(): q_j.xyz += (q_j)_w Δ and so Σ_j q_j += Δ, where
    /// Δ is how far a vertex is from its bind pose. Δ goes through the blend that normals go through; as_coordinates() of
    /// the morphed geometry is the same where no residual changes a weight.
    ///
    /// coordinates: as_coordinates() of the bind geometry, given to every call since. Errors: bad_argument (too short).
    /// Cost: 60 instructions a vertex with four influences and a residual, of those written by morph() since the last call.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_morph_coordinates", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MorphCoordinates(MorphedGeometry* morphed, float* coordinates, UIntPtr coordinate_count);
    /// <summary>
    /// For each parameter the index of the channel of `clip` that has its name, or kNoChannel. The space is of `file`, the
    /// clip of `clips`, the same or a clip pack. out: at least space.parameters.size. Errors: bad_argument. Cost: compares
    /// names; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_find_example_channels", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FindExampleChannels(File* file, ExampleSpace* space, File* clips, Clip* clip, uint* @out, UIntPtr out_count);
    /// <summary>
    /// Weights of the space's targets at a point of it; others are left as they are.
    ///   weight_t(p) = linear_t · (1, p) + Σ_k radial_kt R(|p - place_k| · inverse_width_k)
    ///   R(x) = 2/3 - x² + x³/2 below 1, (2 - x)³/6 below 2, 0 beyond: the cubic B-spline
    /// At an example's place its own target has weight 1 and all others 0, but for rounding. Far from all examples weights
    /// are linear: they leave 0 … 1, so clamp parameters where a shape must not be exaggerated.
    /// parameters: finite, at least space.parameters.size; weights: one a target of the mesh. Errors: bad_argument (also for
    /// a space by hand whose spans are too short, or with a target beyond the weights); bad_data if a weight is not finite:
    /// nothing is written. The same bits on every processor.
    /// Method: P.-P. Sloan, C. Rose, M. Cohen, "Shape by example", I3D 2001, section 3: cardinal functions.
    /// Cost: instructions an example, each with a target of its own, x86-64, g++ 12 -O3: in spaces of 2 parameters 91 of 8
    /// examples, 69 of 64; of 6 parameters 142 and 131. It grows with the examples that are near.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_evaluate_examples", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status EvaluateExamples(ExampleSpace* space, float* parameters, UIntPtr parameter_count, float* weights, UIntPtr weight_count);
    [DllImport(Library, EntryPoint = "mrw_debug_line_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void DebugLineInit(DebugLine* @out);
    [DllImport(Library, EntryPoint = "mrw_debug_lines_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void DebugLinesInit(DebugLines* @out);
    /// <summary>
    /// A line from each joint's parent to the joint, and the joint's axes x, y, z in red, green, blue: `axis_m` long
    /// whatever its scale; 0: none. scene_from_joint: at least skeleton.joint_count. At most 4 lines a joint.
    /// Errors, of all that follow: bad_argument if a span is too short, a joint is not in the skeleton, or a length is below
    /// 0 or not finite; nothing is appended.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_joint_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status JointLines(Skeleton* skeleton, Affine* scene_from_joint, UIntPtr scene_from_joint_count, float axis_m, DebugLines* lines);
    /// <summary>
    /// What each limit lets the joint do, about the joint, `size_m` large. local: the pose that scene_from_joint is of.
    /// A hinge: the arc along which its y moves. A cone: the rim along which its x moves at most, and four spokes. Euler
    /// angles: three arcs in the colours of their axes, each with the other angles at the middle. Then where the joint is
    /// now, in green inside the limit and red outside of it. Limits that is_valid() refuses are passed over. At most 51
    /// lines a limit.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_limit_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status LimitLines(Skeleton* skeleton, JointLimit* limits, UIntPtr limit_count, SoaTransform* local, UIntPtr local_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, float size_m, DebugLines* lines);
    /// <summary>
    /// A cross at each goal's position, or, where its rotation counts, the axes it asks for; and a line to it from the point
    /// of the joint that is to be there. Green within `tolerance_m`, else red. At most 4 lines a goal.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_goal_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status GoalLines(Skeleton* skeleton, IkGoal* goals, UIntPtr goal_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, float size_m, float tolerance_m, DebugLines* lines);
    /// <summary>
    /// The bones of each chain, and its tip. scene_from_joint: after simulate_springs(). At most a line a joint.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_spring_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SpringLines(Skeleton* skeleton, SpringChain* chains, UIntPtr chain_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, DebugLines* lines);
    /// <summary>
    /// Each collider as great circles about its ends, and lines between them: 48 lines a sphere, 100 a capsule.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_collider_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status ColliderLines(Skeleton* skeleton, SpringCollider* colliders, UIntPtr collider_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, DebugLines* lines);
    /// <summary>
    /// The box's edges and the sphere's three great circles: 60 lines; none if it is empty.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_bounds_lines", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BoundsLines(Bounds* bounds, DebugLines* lines);
    /// <summary>
    /// out[i] = scene_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
    ///
    /// joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path brings its own
    /// bind that also undoes quantisation). out: at least as many and one a helper. Every joint must be below
    /// scene_from_joint.size, what helpers name below joints.size and not the same.
    /// Errors: bad_argument if a span is too short, a joint out of range or a share not between 0 and 1.
    ///
    /// helpers: written behind the joints' entries: entry joints.size + h blends the entries `first` and `second`, the
    /// latter at `share`. Of either entry's matrix, a stretch and then a turn, the turns are blended as quaternions, the
    /// shorter way, and the stretches linearly. Where the origin of the joint `second` goes is what dual quaternions make of
    /// where both take it (L. Kavan et al., Geometric skinning with approximate dual quaternion blending, 2008). Between a
    /// joint and its parent that is a turn about the joint. centres: none, or three numbers a helper: a place, as the joint
    /// `second` sees it, that goes to the mean, by shares, of where both take it (B. Le, J. Hodgins, Real-time skeletal
    /// skinning with optimized centers of rotation, 2016). Half a turn goes round the axis that points to the positive side
    /// along the largest of its components. Where an entry mirrors, its stretch does. Where one has lost its volume, or is
    /// not finite, the two are blended as numbers.
    ///
    /// The same palette serves SSD and animation space (docs/decisions.md, "One palette").
    /// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64; a helper 198 on x86-64, about a
    /// centre 248. Four helpers share their work: where one of them has entries whose stretches differ, all four cost 385.
    /// Thread-safe on different outputs; out overlaps none of the inputs.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_build_palette_of_joints", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BuildPaletteOfJoints(ushort* joints, UIntPtr joint_count, Affine* bind, UIntPtr bind_count, Affine* scene_from_joint, UIntPtr scene_from_joint_count, Affine* @out, UIntPtr out_count, Helper* helpers, UIntPtr helper_count, float* centres, UIntPtr centre_count);
    /// <summary>
    /// The palette of a mesh.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_build_palette", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status BuildPalette(Mesh* mesh, Affine* scene_from_joint, UIntPtr scene_from_joint_count, Affine* @out, UIntPtr out_count);
    /// <summary>
    /// Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
    /// are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
    /// not finite do not.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_turns_inside_out", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte TurnsInsideOut(Affine* map);
    /// <summary>
    /// The same of what follows a palette: whether more of its matrices mirror than not. For culling of meshes that are not
    /// double_sided; a game whose characters are never mirrored, nor hung on what is, need not ask. An instance of a crowd
    /// turns if either this or its scene_from_character does, not if both do: see gles3_crowd.h. Cost: a determinant a
    /// matrix.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_palette_turns_inside_out", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte PaletteTurnsInsideOut(Affine* palette, UIntPtr palette_count);
    /// <summary>
    /// Bytes that make_reach() needs: 24 a palette entry and 24 a morph target, up to a multiple of 16.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_reach_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr ReachBytes(Mesh* mesh);
    /// <summary>
    /// Looks at every vertex once. The result serves all characters with this mesh, at any level of detail whose vertices
    /// are among those of `mesh`.
    ///
    /// mesh: of a file, not of a character whose vertices are morphed. memory: at least reach_bytes(), 16-byte aligned;
    /// `out` keeps pointers into it. Errors: bad_argument (the memory). Cost: once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_reach", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeReach(Mesh* mesh, void* memory, UIntPtr memory_bytes, Reach* @out);
    /// <summary>
    /// The box of the mesh and a sphere about the box's centre, in the palette's space.
    ///
    /// palette: of the mesh, reach.joints.size entries. weights: of its morph targets, any finite numbers; empty: none is
    /// active. Without a vertex `out` is empty (Bounds::is_empty()). Errors: bad_argument (a span too short, a weight that
    /// is not finite); `out` is not written. Method: the box of a transformed box is its centre, transformed, and its half
    /// sides through the absolute values of the matrix (J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems,
    /// 1990); a union of those. The sphere's radius is the distance to the farthest corner of any of them. Cost: 119
    /// instructions a palette entry, x86-64, in two passes. No allocation, thread-safe.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_palette_bounds", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status PaletteBounds(Reach* reach, Affine* palette, UIntPtr palette_count, float* weights, UIntPtr weight_count, Bounds* @out);
    [DllImport(Library, EntryPoint = "mrw_skin_output_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void SkinOutputInit(SkinOutput* @out);
    [DllImport(Library, EntryPoint = "mrw_as_part_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void AsPartInit(AsPart* @out);
    /// <summary>
    /// Each vertex follows the joint with its largest weight.
    ///   position = M_j (v, 1)
    /// palette: mesh.palette_size() entries. Errors, here and below: bad_argument if a span is too short, if the geometry
    /// follows more entries than the mesh has, and so is another one's, if normals or tangents are asked of a mesh without,
    /// or if the geometry's floats do not stand on 16-byte boundaries.
    /// Cost: positions 50 / 32; with exact normals 78 / 49.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skin_rigid", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SkinRigid(Mesh* mesh, Affine* palette, UIntPtr palette_count, SkinOutput* @out);
    /// <summary>
    /// Skeletal subspace deformation, also called linear blend skinning.
    ///   position = (Σ_j w_j M_j) (v, 1)
    /// Cost: positions 38 / 29; with normals through the blended matrix 47 / 34, and tangents 59 / 42; through the inverse
    /// transpose 66 / 47 and 83 / 56. That is 12 multiply-adds an influence but the last, 9 for the position, 9 for a normal
    /// or tangent through the matrix, 27 multiplications and a square root and a division for a normal through its inverse
    /// transpose.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skin_ssd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SkinSsd(Mesh* mesh, Affine* palette, UIntPtr palette_count, SkinOutput* @out);
    /// <summary>
    /// How many floats as_coordinates() writes: 3 a slot, and 4 for each influence but the last.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_as_coordinate_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr AsCoordinateCount(Geometry* geometry);
    /// <summary>
    /// Animation-space coordinates of every slot, from lift and residual: q_j = (w_j v + d_j, w_j + δ_j), Σ_j (q_j)_w = 1.
    /// In the notation of Merry, Marais and Gain (ACM TOG 25(4), 2006) p_j = B_j⁻¹ q_j; B_j⁻¹ stands in the palette here.
    ///
    /// As with the weights of SSD, the last influence is what the others leave: a block holds the sum Σ_j q_j as
    /// x[4] y[4] z[4] (its w is 1), then x[4] y[4] z[4] w[4] of each q_j but the last.
    /// out: as_coordinate_count() floats. Done once a mesh, not a frame.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_as_coordinates", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status AsCoordinates(Geometry* geometry, float* @out, UIntPtr out_count);
    /// <summary>
    /// How many floats as_tangents() writes of a mesh: twice as_coordinate_count().
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_as_tangent_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr AsTangentCount(Geometry* geometry);
    /// <summary>
    /// Bytes of scratch memory that as_tangents() wants: about 32 a slot and 4 an index.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_as_tangent_scratch_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr AsTangentScratchBytes(AsPart* parts, UIntPtr part_count);
    /// <summary>
    /// Two tangents of the surface at every slot as animation-space vectors, as in Merry, Marais and Gain:
    ///   t = Σ_k c_k (p_k - p) over the vertex's neighbours k, so t = Σ_j M_j τ_j with τ_j = Σ_k c_k (q_kj - q_j),
    ///   Σ_j (τ_j)_w = 0
    /// They are derivatives along two directions, means over the triangles weighed by area; in the bind pose, where
    /// residuals leave that in place, perpendicular unit vectors with t₀ × t₁ the mesh's normal, t₀ along its tangent if it
    /// has one. What the triangles do not explain of them goes through the blend: all, if they have no area. An entry
    /// that a neighbour follows and the vertex does not counts as the sum of the vertex's own that blends the same joints at
    /// the same shares, or comes closest; joints that none of those blends count as that which the neighbour follows most.
    ///
    /// parts: the meshes that make up a surface, such as the primitives of one mesh of the source; slots in one place with
    /// the same weights and normals less than 25° apart, in whichever part, are one vertex, so that seams do not show.
    /// scratch: as_tangent_scratch_bytes(), on a 4-byte boundary, free again afterwards. Errors: bad_argument if a mesh has
    /// no normals or a span is too short. Done once, not a frame: some 11 000 instructions a vertex, beside helpers 23 000.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_as_tangents", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status AsTangents(AsPart* parts, UIntPtr part_count, void* scratch, UIntPtr scratch_bytes);
    /// <summary>
    /// Animation space.
    ///   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
    ///            = M_last Σ_j q_j + Σ_{j&lt;last} (M_j - M_last) q_j
    /// Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
    /// coordinates: from as_coordinates() of this geometry.
    /// Cost: positions 40 / 31; with normals through the blended matrix 73 / 56, and tangents 85 / 62; through the inverse
    /// transpose 92 / 69 and 108 / 77. That is 12 multiply-adds an influence but the last and 9 for the sum; with normals 9
    /// more an influence but the last.
    ///
    /// tangents: from as_tangents() of this geometry, or empty. With them normals are the deformed surface's own,
    /// t₀' × t₁' with t' = Σ_j M_j τ_j, and tangents t₀', unit, whatever out.normal_transform says; turned round where the
    /// run's last joint mirrors. They know nothing of morph targets. Cost, x86-64: 140, and with tangents 151.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skin_as", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SkinAs(Mesh* mesh, float* coordinates, UIntPtr coordinate_count, Affine* palette, UIntPtr palette_count, SkinOutput* @out, float* tangents, UIntPtr tangent_count);
    /// <summary>
    /// Multi-weight enveloping: Wang and Phillips, "Multi-weight enveloping: least-squares approximation techniques for skin
    /// animation", SCA 2002. Twelve weights an influence, one for each element of its matrix:
    ///   position = R Σ_j (Ω_j ∘ R⁻¹ M_j) (v, 1)        Ω_j = w_j + Geometry::mwe_residual, ∘ element by element
    /// Elements mean something in one frame only; R is that of the palette entry Geometry::mwe_root: the rotation next to
    /// its matrix's first two columns (Gram and Schmidt) and its translation. So the result moves with the character.
    /// Normals and tangents go through the 3×3 part of the blend, R Σ_j Ω_j ∘ R⁻¹ M_j, which is SSD's where the residual is
    /// zero. With blended_matrix it is that blend that is asked whether it mirrors.
    ///
    /// Errors: also bad_argument for a geometry without mwe_residual. Cost, x86-64: positions 82; with normals through the
    /// blended matrix 110, through the inverse transpose 127. It reads 192 bytes of residual a block and influence, so with
    /// four influences nine times as much as SSD.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skin_mwe", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SkinMwe(Mesh* mesh, Affine* palette, UIntPtr palette_count, SkinOutput* @out);
    /// <summary>
    /// How many floats psd_distances() writes: one for each palette entry and example, and one more an entry; 0 without
    /// examples.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_psd_distance_count", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr PsdDistanceCount(Geometry* geometry);
    /// <summary>
    /// How far a pose is from the examples, joint by joint: what skin_psd() weighs a vertex. Of palette entry j and example
    /// k, D_jk = 1 - (q_j · q_jk)² = sin²(half the angle between), with q_j the rotation of M_j relative to its parent's,
    /// rotations as in skin_mwe(); 0 for an entry without a parent.
    /// out, for each palette entry: -D_jk / 2σ² for each k, then the same of the bind pose. Once a mesh and frame. Errors:
    /// bad_argument if a span is too short.
    /// Cost: 34 instructions a palette entry and example, x86-64.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_psd_distances", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status PsdDistances(Geometry* geometry, Affine* palette, UIntPtr palette_count, float* @out, UIntPtr out_count);
    /// <summary>
    /// Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000, with distances
    /// weighted a vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
    ///   position = (Σ_j w_j M_j) (v + (1 - φ_bind) Σ_k φ_k d_k, 1)        d_k: Geometry::pose_space
    ///   φ_k = exp(-Σ_j w_j D_jk / 2σ²)
    /// where the factor makes nothing of the bind pose. Normals and tangents go through the blend, as SSD's.
    /// distances: from psd_distances() of this geometry and palette. Errors: also bad_argument if they are too few. A
    /// geometry without examples is SSD's.
    /// Cost, x86-64: positions 49, with normals through the blended matrix 61, through the inverse transpose 74; and 30 a
    /// vertex for each example that moves its block.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_skin_psd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SkinPsd(Mesh* mesh, float* distances, UIntPtr distance_count, Affine* palette, UIntPtr palette_count, SkinOutput* @out);
    [DllImport(Library, EntryPoint = "mrw_character_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void CharacterOptionsInit(CharacterOptions* @out);
    [DllImport(Library, EntryPoint = "mrw_animation_layer_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void AnimationLayerInit(AnimationLayer* @out);
    /// <summary>
    /// Bytes that make_animations() needs: for each clip an Animation, 4 a skeleton and 4 a morph target. A multiple of 16.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_animations_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr AnimationsBytes(File* file, File* clips);
    /// <summary>
    /// Makes animations of clips of `file`, the character's, or of a clip pack. A pack's reference goes with the skeleton of
    /// its name if it fits that, else with the first that it fits and no reference before it has; see bind_clips(). If it
    /// fits none, its clips are left out: no skeleton plays them.
    ///
    /// memory: at least animations_bytes(), 16-byte aligned; `out` keeps pointers into it and into both files' blocks.
    /// Errors: bad_argument (the memory); mismatch (`clips` is another file but no pack, or a pack none of whose clips fits
    /// a skeleton). Cost: compares names; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_animations", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeAnimations(File* file, File* clips, void* memory, UIntPtr memory_bytes, Animations* @out);
    /// <summary>
    /// The first with this name that moves anything; null if there is none. Cost: compares names.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_find_animation", CallingConvention = CallingConvention.Cdecl)]
    public static extern Animation* FindAnimation(Animations* animations, byte* name);
    /// <summary>
    /// Bytes that make_character() needs: a multiple of 16, so that the blocks of a crowd may stand back to back.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_character_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr CharacterBytes(File* file, CharacterOptions* options);
    /// <summary>
    /// A character in its rest pose, finished.
    ///
    /// `file`'s block must outlive it. memory: at least character_bytes(), 16-byte aligned.
    /// Errors: bad_argument (the memory, no layers, a default weight that is not finite). Cost: a copy of the vertices of
    /// meshes with morph targets, and as_coordinates().
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_character", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeCharacter(File* file, CharacterOptions* options, void* memory, UIntPtr memory_bytes, Character* @out);
    /// <summary>
    /// Samples and blends: local poses of all skeletons and weights of all morph targets become means of the layers, as
    /// blend() has it; without layers all rest. A clip that is cooked as additive counts as its changes laid on their
    /// reference.
    ///
    /// Errors: bad_argument (more layers than the options say, an animation that is null or not made for this file, a weight
    /// out of range, a time that is not a number); a part of the character may have been written then.
    /// Cost: sample() and blend() of each skeleton, sample_channels() of what drives morph targets.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_sample_character", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status SampleCharacter(Character* character, AnimationLayer* layers, UIntPtr layer_count);
    /// <summary>
    /// Brings scene_from_joint of all skeletons up to date with `local`.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_character_to_model", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status CharacterToModel(Character* character);
    /// <summary>
    /// Both: poses that inverse kinematics, feet and springs can go on with. Errors: as sample_character().
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_pose_character", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status PoseCharacter(Character* character, AnimationLayer* layers, UIntPtr layer_count);
    /// <summary>
    /// Adds an expression of a face or its like to the weights of morph targets, as often as there are expressions: what the
    /// animation makes of them less what they are by default, times `weight`. A weight that no channel drives keeps its
    /// bits, and so do poses. Between pose_character() and finish_character().
    ///
    /// Errors: bad_argument (an animation that is null or not made for this file, a weight out of range, a time that is not
    /// a number); nothing is written. Cost: sample_channels() of what drives morph targets.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_add_expression", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status AddExpression(Character* character, AnimationLayer* expression);
    /// <summary>
    /// Palettes from scene_from_joint, and vertices morphed by `weights`; nothing without `skin`.
    /// Errors: bad_argument (a weight that is not finite). Cost: build_palette(), morph() and morph_coordinates() of each
    /// mesh.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_finish_character", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status FinishCharacter(Character* character);
    /// <summary>
    /// Bytes that make_outfit() needs: 24 a skeleton and 2 a joint, on boundaries of 16. A multiple of 16.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_outfit_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr OutfitBytes(File* outfit);
    /// <summary>
    /// Finds for each skeleton of an outfit the one of the body that it follows: of its name if it fits that, else the first
    /// that it fits. An outfit is cooked with `--skeleton BODY`; outfit.h says when it fits.
    ///
    /// memory: at least outfit_bytes(), 16-byte aligned; `out` keeps pointers into it. Several outfits may follow one body.
    /// Errors: bad_argument (the memory); mismatch if a skeleton fits none, and bind_outfit() says which joints are in the
    /// way. Cost: compares names; once a load.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_make_outfit", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status MakeOutfit(File* body, File* outfit, void* memory, UIntPtr memory_bytes, Outfit* @out);
    /// <summary>
    /// Brings scene_from_joint of an outfit's skeletons to the body's pose: call it when the body is posed, and then
    /// finish_character(). Joints that only the outfit has stand at its `local`, which the outfit keeps from frame to frame.
    /// So where its clips or springs move them, a frame is
    ///
    ///   sample_character(outfit, …); follow_body(…); springs; finish_character(outfit)
    ///
    /// where sample_character without layers puts them back to rest. `local` of joints of the body is neither read nor
    /// written. Morph targets are the outfit's own: its clips move them, or the game writes CharacterMesh::weights.
    ///
    /// worn: made from the outfit's file. Errors: bad_argument if `outfit` was made for other files. Cost: follow_body() of
    /// outfit.h for each skeleton.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_character_follow_body", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status CharacterFollowBody(Outfit* outfit, Character* body, Character* worn);
    [DllImport(Library, EntryPoint = "mrw_gles3_error_watch_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ErrorWatchInit(Gles3ErrorWatch* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_caps_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CapsInit(Gles3Caps* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_vertex_layout_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3VertexLayoutInit(Gles3VertexLayout* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_gpu_mesh_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3GpuMeshInit(Gles3GpuMesh* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_prepare_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3PrepareOptionsInit(Gles3PrepareOptions* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_program_key_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ProgramKeyInit(Gles3ProgramKey* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_program_source_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ProgramSourceInit(Gles3ProgramSource* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_program_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ProgramInit(Gles3Program* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_palette_ring_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3PaletteRingInit(Gles3PaletteRing* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_palette_texture_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3PaletteTextureInit(Gles3PaletteTexture* @out);
    /// <summary>
    /// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader.
    /// Errors: bad_argument without a loader; unsupported if it returns null for a function of OpenGL ES 3.0, whose name is
    /// put in `missing` (static string). Those of 3.1 stay null where there are none. `api` is written only on success.
    ///
    /// ObjectLabel is there with GL_KHR_debug or OpenGL ES 3.2. Then GL objects are labelled as they are made, for RenderDoc
    /// and drivers' tools ("newt: surface"); set to null, they are not. GetGraphicsResetStatus is there with
    /// GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
    /// May be null: missing.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_load_api", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3LoadApi(Gles3Api* api, IntPtr load_proc, byte** missing);
    /// <summary>
    /// Whether the graphics processor was reset and the context is lost with all that is in it: to be asked once a frame.
    /// Then call on_context_lost() for each object that has it, destroy the context, make another, and call
    /// on_context_restored(). True only where GetGraphicsResetStatus is there and the context was created to lose itself on
    /// a reset (EGL_LOSE_CONTEXT_ON_RESET, as marrow::egl::HeadlessContext asks for); other contexts never tell, and
    /// platforms have ways of their own (EGL_CONTEXT_LOST of eglSwapBuffers). GL may tell each reset only once.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_context_was_reset", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte Gles3ContextWasReset(Gles3Api* api);
    /// <summary>
    /// Has every GL error reported that a call through `api` or a copy of it causes, with the call's name, to a watch that
    /// lives as long as they; null: no more. Results stay what they are, as GetError still tells each check of an error. For
    /// debugging: without a watch a call costs a comparison more, with one two calls of glGetError.
    /// May be null: watch.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_watch_errors", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3WatchErrors(Gles3Api* api, Gles3ErrorWatch* watch);
    /// <summary>
    /// Errors: unsupported below OpenGL ES 3.0; gl_error.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_query_caps", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3QueryCaps(Gles3Api* api, Gles3Caps* caps);
    /// <summary>
    /// Bytes of scratch memory that prepare() wants: the largest of its vertex buffers, with `psd` and all changes.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_prepare_scratch_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr Gles3PrepareScratchBytes(Mesh* mesh, Gles3PrepareOptions* options);
    /// <summary>
    /// Uploads a mesh, and writes the bind matrices to build its palettes with:
    ///   bind[i] = inverse_bind[i] · [h·I | c]
    /// c is the middle of the bind box, h one half-extent for all axes: attributes hold (v - c) / h in [-1, 1]³ and the
    /// shader need not undo it. The same palette serves rigid, SSD and AS. In animation space the stored coordinate of an
    /// influence is (w (v - c) + d - δ c, (w + δ) h) / h; where residuals need more room, h grows for the whole mesh.
    ///
    /// bind: at least mesh.joint_count, the caller's to keep. scratch: at least prepare_scratch_bytes(), 4-byte aligned,
    /// free again afterwards. Errors: bad_argument (a mesh without vertices or with another one's geometry, a span too
    /// short); unsupported (more morph targets or examples than a texture of 2048 × 2048 holds); gl_error (out of memory:
    /// nothing is left allocated). `out` and `bind` are written only on success. Leaves GL_ARRAY_BUFFER, the vertex array
    /// and, of a mesh with morph targets or, with `psd`, examples, the active unit's 2D texture at 0. Error of the formats:
    /// docs/performance.md. Cost: a few passes over the vertices; once a mesh.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_prepare", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Prepare(Gles3Api* api, Gles3Caps* caps, Mesh* mesh, Gles3PrepareOptions* options, void* scratch, UIntPtr scratch_bytes, Affine* bind, UIntPtr bind_count, Gles3GpuMesh* @out);
    /// <summary>
    /// Deletes the GL objects and clears the struct.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyMesh(Gles3Api* api, Gles3GpuMesh* mesh);
    /// <summary>
    /// Compiles and links; the palette block is tied to uniform buffer binding `palette_binding`, with kMotion that of the
    /// frame before to the next binding.
    /// Errors: bad_argument (a text missing, influences other than 4 to 8, what crowds cannot); gl_error, with the driver's
    /// words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a frame.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_build_program", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BuildProgram(Gles3Api* api, Gles3ProgramKey* key, Gles3ProgramSource* source, uint palette_binding, Gles3Program* @out, byte* log, UIntPtr log_bytes);
    /// <summary>
    /// Deletes the program and clears the struct.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_program", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyProgram(Gles3Api* api, Gles3Program* program);
    /// <summary>
    /// Room for palettes of `joints` matrices altogether in `palettes` pieces.
    /// Errors: bad_argument (zero); unsupported (caps of less than OpenGL ES 3.0); gl_error. Leaves GL_UNIFORM_BUFFER at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_palette_ring", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreatePaletteRing(Gles3Api* api, Gles3Caps* caps, uint joints, uint palettes, Gles3PaletteRing* @out);
    /// <summary>
    /// Deletes the buffer and clears the struct.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_palette_ring", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyPaletteRing(Gles3Api* api, Gles3PaletteRing* ring);
    /// <summary>
    /// Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_begin_frame", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3BeginFrame(Gles3Api* api, Gles3PaletteRing* ring);
    /// <summary>
    /// Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
    /// ring. Errors: bad_argument (empty, or more than kPaletteJoints); unsupported (the ring is full until begin_frame).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_push_palette", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3PushPalette(Gles3Api* api, Gles3PaletteRing* ring, Affine* palette, UIntPtr palette_count, uint* offset);
    /// <summary>
    /// Ties the palette at `offset` to uniform buffer binding `binding`.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_palette", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3BindPalette(Gles3Api* api, Gles3PaletteRing* ring, uint offset, uint binding);
    /// <summary>
    /// Room for `joints` matrices: 48 B each, three times.
    /// Errors: bad_argument (zero); unsupported (more than a texture of the caps' size holds: 1.39 million in 2048²);
    /// gl_error. Leaves the active unit's 2D texture at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_palette_texture", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreatePaletteTexture(Gles3Api* api, Gles3Caps* caps, uint joints, Gles3PaletteTexture* @out);
    /// <summary>
    /// Deletes the textures and clears the struct.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_palette_texture", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyPaletteTexture(Gles3Api* api, Gles3PaletteTexture* texture);
    /// <summary>
    /// Once a frame, all palettes: whole ones after each other, those of one mesh's instances together, and build_palette()
    /// may write right there. 48 bytes a matrix go up, and nothing else. Errors: bad_argument (empty); unsupported (more
    /// than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_upload_palettes", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3UploadPalettes(Gles3Api* api, Gles3PaletteTexture* texture, Affine* palettes, UIntPtr palette_count);
    /// <summary>
    /// `program`, which must be in use and read palettes from a texture, draws with the palette that begins at matrix
    /// `first` of what was uploaded, its instance i with the one `joints` · i behind it. Leaves `texture_unit` active and
    /// the texture bound to it. Errors: bad_argument (a program of another kind, a palette that reaches beyond what was
    /// uploaded).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_texture_palette", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BindTexturePalette(Gles3Api* api, Gles3PaletteTexture* texture, uint first, uint joints, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// The palettes of the frame before, which are there still, for a program with kMotion that draws from bind_palette() of
    /// the same arguments. kept: false for characters without a frame before; their palettes of this frame are bound then,
    /// and nothing moves. Leaves `texture_unit` active and the texture bound to it; nothing is bound for a program whose
    /// text does not read previous_position. Errors: bad_argument (a program of another kind, a palette that reaches beyond
    /// what was uploaded then).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_previous_palette", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BindPreviousPalette(Gles3Api* api, Gles3PaletteTexture* texture, uint first, uint joints, byte kept, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// Sets by which weights, one a target, `program`, which must be in use, morphs: as morph() does on the CPU, in
    /// animation space through the same blend as normals. Of more than kMorphTargets weights other than 0 those count that
    /// move most. Leaves `texture_unit` active and the mesh's texture bound to it. Errors: bad_argument (a mesh without
    /// targets, a program without kMorphs, too few weights, one that is not finite).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_set_morphs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3SetMorphs(Gles3Api* api, Mesh* mesh, Gles3GpuMesh* gpu, float* weights, UIntPtr weight_count, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// The weights of the frame before, for a program with kMotion, after set_morphs(). Errors: as there.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_set_previous_morphs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3SetPreviousMorphs(Gles3Api* api, Mesh* mesh, Gles3GpuMesh* gpu, float* weights, UIntPtr weight_count, Gles3Program* program);
    /// <summary>
    /// Room that pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and four
    /// examples. 0 without examples.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_distance_matrices", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint Gles3DistanceMatrices(Geometry* geometry);
    /// <summary>
    /// How far a pose is from the examples, as Deformer::psd reads it: psd_distances() in another order. It goes up with
    /// those of other characters as palettes do, by upload_palettes() into a PaletteTexture of its own, on every path.
    /// palette: built with the bind matrices of prepare(), or those of the mesh; no matter which. out: distance_matrices().
    /// Errors: bad_argument (no examples, a span too short). Cost: that of psd_distances().
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_pack_distances", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3PackDistances(Geometry* geometry, Affine* palette, UIntPtr palette_count, Affine* @out, UIntPtr out_count);
    /// <summary>
    /// `program`, which must be in use and of Deformer::psd, deforms by the mesh's examples and by distances that begin at
    /// matrix `first` of what was uploaded, its instance i by those GpuMesh::distances · i behind. Leaves `texture_unit` and
    /// the next one taken, the latter active. Errors: bad_argument (a mesh without examples, a program of another kind,
    /// distances that reach beyond what was uploaded).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_examples", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BindExamples(Gles3Api* api, Gles3GpuMesh* mesh, Gles3PaletteTexture* distances, uint first, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// The distances of the frame before, for a program with kMotion, after bind_examples(). kept and errors: as in
    /// bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_previous_distances", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BindPreviousDistances(Gles3Api* api, Gles3GpuMesh* mesh, Gles3PaletteTexture* distances, uint first, byte kept, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// Draws all triangles, of as many characters as there are instances: more than one with palettes in a texture alone.
    /// `program` must be in use, its palette bound. Leaves the vertex array at 0. Which sides are drawn is the game's to
    /// say: as glTF has it, GL_CULL_FACE is enabled unless Mesh::double_sided, and fronts are GL_CCW, but GL_CW where
    /// turns_inside_out() of the palette, see palette.h. So characters that mirror take a draw call of their own.
    /// Errors: bad_argument if the mesh was not prepared for this deformer.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_draw_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3DrawMesh(Gles3Api* api, Gles3GpuMesh* mesh, Gles3Deformer deformer, Gles3Program* program, uint instances);
    [DllImport(Library, EntryPoint = "mrw_gles3_skinned_mesh_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3SkinnedMeshInit(Gles3SkinnedMesh* @out);
    /// <summary>
    /// Errors: gl_error (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER and the vertex
    /// array at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_skinned", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreateSkinned(Gles3Api* api, Gles3GpuMesh* mesh, Gles3SkinnedMesh* @out);
    /// <summary>
    /// Deletes the GL objects and clears the struct.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_skinned", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroySkinned(Gles3Api* api, Gles3SkinnedMesh* mesh);
    /// <summary>
    /// What skin_ssd() and their like have written. The old contents are orphaned, so the CPU never waits for the GPU.
    /// Errors: bad_argument (a span of another size than the mesh has; normals or tangents may be empty, then they are
    /// undefined). Leaves GL_ARRAY_BUFFER at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_upload_skinned", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3UploadSkinned(Gles3Api* api, Gles3SkinnedMesh* mesh, SkinOutput* vertices);
    /// <summary>
    /// A program for preskin(), of the key's deformer, palettes, and of its features kNormals, kTangents, kMorphs and
    /// kSurfaceNormals. Those must be the mesh's.
    /// Errors: bad_argument (a key of Deformer::none, of a crowd, or with influences other than 4 to 8); unsupported
    /// (compute, without caps.compute); gl_error, with the driver's words in `log`. `out` is written only on success. Cost:
    /// a compile.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_build_preskin", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BuildPreskin(Gles3Api* api, Gles3Caps* caps, Gles3ProgramKey* key, Gles3Preskin method, uint palette_binding, Gles3Program* @out, byte* log, UIntPtr log_bytes);
    /// <summary>
    /// Skins every slot once into `to`, with the palette that is bound. `program` must be in use. By transform feedback it
    /// leaves the vertex array, the default transform feedback object's bindings 0 … 2 and GL_TRANSFORM_FEEDBACK_BUFFER at
    /// 0, and GL_RASTERIZER_DISCARD off; by compute shader GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3 at 0.
    /// Errors: bad_argument (a mesh that was not prepared for this deformer, a program of another kind).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_preskin_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3PreskinMesh(Gles3Api* api, Gles3GpuMesh* mesh, Gles3Deformer deformer, Gles3Program* program, Gles3SkinnedMesh* to);
    /// <summary>
    /// Programs with kMotion take from `previous` where the vertices of `mesh` were in the frame before: another SkinnedMesh
    /// of the same GpuMesh, skinned then; or `mesh` itself, of what has no frame before. To be said again whenever it
    /// changes, so each frame where two take turns. Errors: bad_argument (of another number of slots). Leaves
    /// GL_ARRAY_BUFFER and the vertex array at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_set_previous", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3SetPrevious(Gles3Api* api, Gles3SkinnedMesh* mesh, Gles3SkinnedMesh* previous);
    /// <summary>
    /// Draws all triangles with the program in use, one with Deformer::none. Leaves the vertex array at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_draw_skinned", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DrawSkinned(Gles3Api* api, Gles3GpuMesh* mesh, Gles3SkinnedMesh* skinned);
    [DllImport(Library, EntryPoint = "mrw_gles3_program_set_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ProgramSetInit(Gles3ProgramSet* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_skinner_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3SkinnerOptionsInit(Gles3SkinnerOptions* @out);
    /// <summary>
    /// "ubo", …
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_skinning_path_text", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte* Gles3SkinningPathText(Gles3SkinningPath path);
    /// <summary>
    /// Deletes all programs. Skinners that use the set must go first.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_programs", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyPrograms(Gles3Api* api, Gles3ProgramSet* programs);
    /// <summary>
    /// Bytes of memory that create_skinner() wants.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_skinner_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr Gles3SkinnerBytes(Mesh* mesh, Gles3SkinnerOptions* options);
    /// <summary>
    /// Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: pose() each
    /// before the first update(). Compiles what `programs` lacks for it.
    ///
    /// mesh: its geometry must live as long as the skinner, so that it can be put on the next context. memory: at least
    /// skinner_bytes(), 16-byte aligned, the skinner's until destroy().
    /// Errors: bad_argument (a span too short, no instances, Deformer::none, no role); unsupported (a path that the caps or
    /// the number of joints rule out, a full program set); gl_error (nothing is left allocated but programs). `out` is
    /// written only on success.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_skinner", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreateSkinner(Gles3Api* api, Gles3Caps* caps, Mesh* mesh, Gles3SkinnerOptions* options, Gles3ProgramSet* programs, void* memory, UIntPtr memory_bytes, Gles3Skinner* @out);
    /// <summary>
    /// Deletes the GL objects and clears the struct; the memory is the caller's again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_skinner", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroySkinner(Gles3Api* api, Gles3Skinner* skinner);
    /// <summary>
    /// Character `instance` takes this pose at the next update(). weights: one a morph target. Calls no GL: may run on
    /// another thread than the context's, different instances on different threads.
    /// Errors: bad_argument (no such instance, a span too short, a skinner that was destroyed).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_pose", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Pose(Gles3Skinner* skinner, uint instance, Affine* scene_from_joint, UIntPtr scene_from_joint_count, float* weights, UIntPtr weight_count);
    /// <summary>
    /// Of a skinner with options.motion: to the next update() the character has no frame before, so its vertices do not
    /// move: for one that appears, or is put elsewhere at once. Characters that the update() before left out have none
    /// anyway. May be called where pose() may. Errors: bad_argument (no such instance, a skinner without motion or that was
    /// destroyed).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_reset_motion", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3ResetMotion(Gles3Skinner* skinner, uint instance);
    /// <summary>
    /// Once a frame, after posing: sends up the palettes of characters 0 … count - 1, or skins them. 48 bytes a joint go up
    /// and nothing else, with a pose space 16 more for every four examples, of which the bind pose is one; on path cpu the
    /// vertices.
    /// Errors: bad_argument (more than there are, a weight that is not finite, a skinner that was destroyed); gl_error (the
    /// context is lost).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_update", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Update(Gles3Api* api, Gles3Skinner* skinner, Gles3ProgramSet* programs, uint count);
    /// <summary>
    /// The program of a role for this mesh, never null: use it and set the game's own uniforms before draw().
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_program_of", CallingConvention = CallingConvention.Cdecl)]
    public static extern Gles3Program* Gles3ProgramOf(Gles3Skinner* skinner, Gles3ProgramSet* programs, uint role);
    /// <summary>
    /// Draws characters first … first + count - 1 with `program`, which is program_of() of a role and in use.
    /// Errors: bad_argument (not all of them updated, a skinner that was destroyed); gl_error (the context is lost).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_draw", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Draw(Gles3Api* api, Gles3Skinner* skinner, Gles3ProgramSet* programs, Gles3Program* program, uint first, uint count);
    /// <summary>
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() update() and draw() refuse. The set first or last, as one likes.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_programs_on_context_lost", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3ProgramsOnContextLost(Gles3ProgramSet* programs);
    /// <summary>
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() update() and draw() refuse. The set first or last, as one likes.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_skinner_on_context_lost", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3SkinnerOnContextLost(Gles3Skinner* skinner);
    /// <summary>
    /// Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
    /// create_skinner(); then it may be tried again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_programs_on_context_restored", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3ProgramsOnContextRestored(Gles3Api* api, Gles3Caps* caps, Gles3ProgramSet* programs);
    /// <summary>
    /// Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
    /// create_skinner(); then it may be tried again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_skinner_on_context_restored", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3SkinnerOnContextRestored(Gles3Api* api, Gles3Caps* caps, Gles3Skinner* skinner);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_source_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdSourceInit(Gles3CrowdSource* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_clip_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdClipInit(Gles3CrowdClip* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_frames_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdFramesInit(Gles3CrowdFrames* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_play_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdPlayInit(Gles3CrowdPlay* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_instance_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdInstanceInit(Gles3CrowdInstance* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_mesh_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdMeshInit(Gles3CrowdMesh* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdInit(Gles3Crowd* @out);
    /// <summary>
    /// How many frames it takes to bake clips at `rate_hz` or a little more, a whole number of steps each; 30 a second are
    /// enough for most motion. out: at least as many as sources.
    /// Errors: bad_argument (no sources, a rate that is not finite or not above 0, an additive clip, a span too short);
    /// unsupported (more than 65535 steps of a clip, or kMaxCrowdFrames). Written only on success.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_plan_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3PlanCrowd(Gles3CrowdSource* sources, UIntPtr source_count, float rate_hz, Gles3CrowdClip* @out, UIntPtr out_count, uint* frame_count);
    /// <summary>
    /// Samples them. scratch: at least skeleton.soa_size(); matrices: at least frame_count × joint_count, the caller's to
    /// keep, as are the clips, which must be those that plan_crowd() wrote for these sources; 48 B a joint and frame.
    /// Errors: bad_argument (a span too short, a clip of another skeleton, clips that are not a plan).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bake_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BakeCrowd(Skeleton* skeleton, Gles3CrowdSource* sources, UIntPtr source_count, Gles3CrowdClip* clips, UIntPtr clip_count, SoaTransform* scratch, UIntPtr scratch_count, Affine* matrices, UIntPtr matrice_count, Gles3CrowdFrames* @out);
    /// <summary>
    /// Where a joint of an instance is: linear between two neighbouring frames and between two clips, like the palettes that
    /// are drawn, so that what is put there stays on the surface. What helpers of a palette do between frames and clips
    /// is linear in the drawing too.
    /// Errors: bad_argument (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
    /// scene_from_character beyond 1e12).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_joint", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CrowdJoint(Gles3CrowdFrames* frames, Gles3CrowdInstance* instance, double time_s, uint joint, Affine* scene_from_joint);
    /// <summary>
    /// The same of all joints; out: at least frames.joint_count.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_pose", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CrowdPose(Gles3CrowdFrames* frames, Gles3CrowdInstance* instance, double time_s, Affine* scene_from_joint, UIntPtr scene_from_joint_count);
    /// <summary>
    /// What a texture of the caps' size holds, of palettes of `joints` matrices: frames of a mesh, and instances likewise.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_palettes_that_fit", CallingConvention = CallingConvention.Cdecl)]
    public static extern uint Gles3CrowdPalettesThatFit(Gles3Caps* caps, uint joints);
    /// <summary>
    /// Bytes of memory that create_crowd_mesh() wants: 48 B a joint, and the larger of 0.1 MB and prepare_scratch_bytes().
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_mesh_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr Gles3CrowdMeshBytes(Mesh* mesh, Gles3PrepareOptions* options);
    /// <summary>
    /// Puts a mesh, by prepare(), and its palettes of all frames on the GPU. A level of detail is a CrowdMesh of its own.
    ///
    /// The mesh's geometry, the frames and options.as_tangents must live as long as the CrowdMesh, so that they can be put
    /// on the next context. capacity: instances that are drawn in a frame, at most. memory: at least crowd_mesh_bytes(),
    /// 16-byte aligned, the CrowdMesh's until destroy(). Errors: bad_argument (no capacity, no frames, memory too short or
    /// askew, a joint that the frames lack); unsupported (a mesh with morph targets; more frames or instances than
    /// crowd_palettes_that_fit()); gl_error (nothing is left allocated). `out` is written only on success. Leaves changed
    /// what prepare() does, the active unit's 2D texture and GL_FRAMEBUFFER at 0; GL_PIXEL_UNPACK_BUFFER must be 0. Cost:
    /// the vertices, and 48 B a matrix and frame, go up, once.
    /// motion: keeps the palettes of the frame before as well, 48 B a joint and instance, and programs of roles that read
    /// kMotion have MarrowVertex::previous_position from them.
    /// May be null: options.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_crowd_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreateCrowdMesh(Gles3Api* api, Gles3Caps* caps, Mesh* mesh, Gles3PrepareOptions* options, Gles3CrowdFrames* frames, uint capacity, void* memory, UIntPtr memory_bytes, Gles3CrowdMesh* @out, byte motion);
    /// <summary>
    /// Deletes the GL objects and clears the struct; the memory is the caller's again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_crowd_mesh", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyCrowdMesh(Gles3Api* api, Gles3CrowdMesh* mesh);
    /// <summary>
    /// Room for `capacity` instances. memory: kCrowdInstanceBytes each, 4-byte aligned, the crowd's until destroy().
    /// Errors: bad_argument (zero, memory too short or askew); unsupported (more than 256 × the caps' texture size:
    /// 524 288); gl_error. Leaves the active unit's 2D texture at 0.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_create_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CreateCrowd(Gles3Api* api, Gles3Caps* caps, uint capacity, void* memory, UIntPtr memory_bytes, Gles3Crowd* @out);
    /// <summary>
    /// Deletes the texture and clears the struct; the memory is the caller's again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_destroy_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3DestroyCrowd(Gles3Api* api, Gles3Crowd* crowd);
    /// <summary>
    /// Sets the instances from `first` on: any of those that there are, or more right behind them. While the context is lost
    /// they are kept, and there once it is restored. Errors: bad_argument (a gap before `first`, frames other than those of
    /// the instances before, an instance as crowd_joint() refuses it); unsupported (more than the capacity). Nothing is
    /// changed then. Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and 128 B an
    /// instance, in at most three pieces; where the GPU still draws from the texture the driver may wait or copy it.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_set_instances", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3SetInstances(Gles3Api* api, Gles3Crowd* crowd, Gles3CrowdFrames* frames, uint first, Gles3CrowdInstance* instances, UIntPtr instance_count);
    /// <summary>
    /// The program for blend_crowd(). Errors: gl_error, with the driver's words in `log`. Cost: a compile.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_build_crowd_program", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BuildCrowdProgram(Gles3Api* api, Gles3Program* @out, byte* log, UIntPtr log_bytes);
    /// <summary>
    /// The same and, for a kind of mesh, each role's program that reads palettes of crowds, in a set: what it lacks is
    /// compiled. The set brings them back after a loss of the context. deformer: one that the mesh was prepared for.
    /// features: what programs are to read of what the mesh has. Errors: bad_argument (Deformer::none, no role);
    /// unsupported (a full set); gl_error, with the driver's words in programs.log.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_build_crowd_programs", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BuildCrowdPrograms(Gles3Api* api, Gles3Caps* caps, Gles3CrowdMesh* mesh, Gles3Deformer deformer, byte features, Gles3ProgramSet* programs);
    /// <summary>
    /// What was built with the same arguments, never null.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_program_of", CallingConvention = CallingConvention.Cdecl)]
    public static extern Gles3Program* Gles3CrowdProgramOf(Gles3CrowdMesh* mesh, Gles3Deformer deformer, byte features, Gles3ProgramSet* programs, uint role);
    /// <summary>
    /// What was built with the same arguments, never null.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_blending_program_of", CallingConvention = CallingConvention.Cdecl)]
    public static extern Gles3Program* Gles3BlendingProgramOf(Gles3ProgramSet* programs);
    /// <summary>
    /// With motion: once a frame, before blend_crowd(). What was blended is now the frame before. No call to GL.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_begin_crowd_frame", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3BeginCrowdFrame(Gles3CrowdMesh* mesh);
    /// <summary>
    /// With motion: what the frame before is of instances that were not blended in it, or not where they are now: those that
    /// have been set since to play or stand elsewhere at once. It is as they are set now, at time_s: that of the frame
    /// before, and they move as their clips do; this frame's, and they stand still. Instances beside them stay as they are.
    /// Otherwise as blend_crowd(). Errors: as there; bad_argument too of a mesh without motion.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_blend_previous_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BlendPreviousCrowd(Gles3Api* api, Gles3Crowd* crowd, Gles3CrowdMesh* mesh, uint first, uint count, double time_s, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// Writes the palettes of `count` instances from `first` on, as they are at time_s of the crowd's clock, placed in the
    /// scene: one triangle, a fragment a row of a matrix; once a frame, however often they are drawn then. `program`, from
    /// build_crowd_program(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and GL_RASTERIZER_DISCARD must be off and no
    /// colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport as large as the texture, `texture_unit`
    /// and the one behind it bound and the latter active. Errors: bad_argument (a program of another kind, instances that
    /// are not there, frames other than the mesh's, a time that is not finite); unsupported (more instances than the mesh
    /// has capacity for); gl_error (the context is lost).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_blend_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BlendCrowd(Gles3Api* api, Gles3Crowd* crowd, Gles3CrowdMesh* mesh, uint first, uint count, double time_s, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// The next draw() with `count` instances draws those from `first` on, as they were blended. `program`, which must be in
    /// use, reads palettes of crowds. Binds two texture units as blend_crowd() does, with kMotion the one behind them, too.
    /// Errors: as there.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_bind_crowd", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3BindCrowd(Gles3Api* api, Gles3Crowd* crowd, Gles3CrowdMesh* mesh, uint first, uint count, uint texture_unit, Gles3Program* program);
    /// <summary>
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_mesh_on_context_lost", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdMeshOnContextLost(Gles3CrowdMesh* mesh);
    /// <summary>
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_on_context_lost", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3CrowdOnContextLost(Gles3Crowd* crowd);
    /// <summary>
    /// Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
    /// creation does. Errors: as creation, but for its arguments; then it may be tried again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_mesh_on_context_restored", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CrowdMeshOnContextRestored(Gles3Api* api, Gles3Caps* caps, Gles3CrowdMesh* mesh);
    /// <summary>
    /// Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
    /// creation does. Errors: as creation, but for its arguments; then it may be tried again.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_crowd_on_context_restored", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3CrowdOnContextRestored(Gles3Api* api, Gles3Caps* caps, Gles3Crowd* crowd);
    [DllImport(Library, EntryPoint = "mrw_gles3_path_result_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3PathResultInit(Gles3PathResult* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_self_test_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3SelfTestInit(Gles3SelfTest* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_self_test_options_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3SelfTestOptionsInit(Gles3SelfTestOptions* @out);
    [DllImport(Library, EntryPoint = "mrw_gles3_path_need_init", CallingConvention = CallingConvention.Cdecl)]
    public static extern void Gles3PathNeedInit(Gles3PathNeed* @out);
    /// <summary>
    /// "usable", or why a path is ruled out, in a few words; "" for a value that is none.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_verdict_text", CallingConvention = CallingConvention.Cdecl)]
    public static extern byte* Gles3VerdictText(Gles3Verdict verdict);
    /// <summary>
    /// Bytes of memory that self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as the defaults.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_self_test_bytes", CallingConvention = CallingConvention.Cdecl)]
    public static extern UIntPtr Gles3SelfTestBytes(Gles3SelfTestOptions* options);
    /// <summary>
    /// Tries the paths, in the order of SkinningPath. memory: at least self_test_bytes(), 16-byte aligned, free again
    /// afterwards. Errors: bad_argument (no deformer, options beyond what they may be, memory too short or askew); gl_error
    /// (the context is lost, or nothing can be read back from it; then nothing is known of any path). `out` is written only
    /// on success; no GL object is left.
    ///
    /// Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
    /// framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
    /// GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
    /// binding 0 and what preskin() says.
    /// Cost: some twenty programs compiled, and a wait for each frame; only where nothing is stored.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_run_self_test", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3RunSelfTest(Gles3Api* api, Gles3Caps* caps, Gles3SelfTestOptions* options, void* memory, UIntPtr memory_bytes, Gles3SelfTest* @out);
    /// <summary>
    /// Of the usable paths of the GPU the one that was fastest: ns_per_vertex + (passes - 1) · ns_per_pass. cpu is taken
    /// where there is no other, as its time is not the GPU's. Of those within 5 % of each other, and of all where one has
    /// not been timed, the first in this order:
    ///
    ///                                one pass                           several passes
    ///   up to 7 characters           ubo texture compute feedback cpu   compute feedback ubo texture cpu
    ///   kManyCharacters and more     texture ubo compute feedback cpu   texture compute feedback ubo cpu
    ///   GpuFamily::mali_g            texture compute feedback ubo cpu   the same
    ///
    /// More than kPaletteJoints leave texture and cpu. Why so: docs/decisions.md, "Which path".
    /// Errors: unsupported (none is usable). `out` is written only on success.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_choose", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Choose(Gles3SelfTest* test, Gles3PathNeed* need, Gles3SkinningPath* @out);
    /// <summary>
    /// Writes kSavedSelfTestBytes. Errors: bad_argument (`out` too short).
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_save", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Save(Gles3SelfTest* test, void* @out, UIntPtr out_bytes);
    /// <summary>
    /// The result in bytes that save() has written, if it still holds. Errors: truncated, bad_magic, bad_version,
    /// bad_checksum, bad_data; mismatch (another driver, version of it, library, or other caps or options): then test anew,
    /// and with another driver without what had crashed. `out` is written only on success.
    /// </summary>
    [DllImport(Library, EntryPoint = "mrw_gles3_restore", CallingConvention = CallingConvention.Cdecl)]
    public static extern Status Gles3Restore(Gles3Api* api, Gles3Caps* caps, Gles3SelfTestOptions* options, void* saved, UIntPtr saved_bytes, Gles3SelfTest* @out);

    /// <summary>Whether structs are laid out as those of a library of 64 bits.</summary>
    public static bool IsLaidOut() {
        return sizeof(DataError) == 16 &&
            sizeof(Block) == 16 &&
            sizeof(Bytes) == 16 &&
            sizeof(MeshDecoder) == 16 &&
            sizeof(UnpackSizes) == 8 &&
            sizeof(Unpacking) == 536 &&
            sizeof(SoaTransform) == 160 &&
            sizeof(AdditiveTransform) == 160 &&
            sizeof(Affine) == 48 &&
            sizeof(JointTransform) == 40 &&
            sizeof(ExampleParameter) == 8 &&
            sizeof(ExampleSpace) == 128 &&
            sizeof(AngleRange) == 8 &&
            sizeof(RateLimit) == 8 &&
            sizeof(JointLimit) == 68 &&
            sizeof(SpringJoint) == 28 &&
            sizeof(SpringChain) == 40 &&
            sizeof(SpringCollider) == 32 &&
            sizeof(SpringColliderList) == 16 &&
            sizeof(Skeleton) == 64 &&
            sizeof(SkeletonReference) == 48 &&
            sizeof(Track) == 16 &&
            sizeof(GroupMasks) == 4 &&
            sizeof(Channel) == 24 &&
            sizeof(CodedTracks) == 64 &&
            sizeof(Clip) == 152 &&
            sizeof(Run) == 8 &&
            sizeof(MorphTarget) == 32 &&
            sizeof(PoseSpace) == 56 &&
            sizeof(Geometry) == 248 &&
            sizeof(MeshTarget) == 12 &&
            sizeof(Texture) == 8 &&
            sizeof(Material) == 48 &&
            sizeof(Image) == 48 &&
            sizeof(Property) == 16 &&
            sizeof(Node) == 40 &&
            sizeof(Helper) == 8 &&
            sizeof(MeshLod) == 8 &&
            sizeof(Bounds) == 28 &&
            sizeof(Mesh) == 384 &&
            sizeof(File) == 128 &&
            sizeof(JointMisfit) == 8 &&
            sizeof(Playback) == 24 &&
            sizeof(SampleOptions) == 16 &&
            sizeof(SampleCache) == 40 &&
            sizeof(Curve) == 40 &&
            sizeof(ArcLength) == 24 &&
            sizeof(CubicBezierEase) == 16 &&
            sizeof(BlendLayer) == 40 &&
            sizeof(AdditiveLayer) == 40 &&
            sizeof(InertialOffset) == 432 &&
            sizeof(Inertia) == 24 &&
            sizeof(InertialStart) == 72 &&
            sizeof(LimitDescription) == 76 &&
            sizeof(RotationFollower) == 52 &&
            sizeof(PointFollower) == 44 &&
            sizeof(TwoBone) == 64 &&
            sizeof(TwoBoneTurns) == 48 &&
            sizeof(TwoBoneJoints) == 24 &&
            sizeof(TwoBoneLimb) == 12 &&
            sizeof(Aim) == 80 &&
            sizeof(AimTurn) == 32 &&
            sizeof(IkGoal) == 52 &&
            sizeof(IkProblem) == 88 &&
            sizeof(IkOptions) == 24 &&
            sizeof(IkReport) == 12 &&
            sizeof(Foot) == 40 &&
            sizeof(Feet) == 40 &&
            sizeof(FootGround) == 32 &&
            sizeof(FootMotion) == 128 &&
            sizeof(FeetFrame) == 96 &&
            sizeof(Springs) == 48 &&
            sizeof(SpringFrame) == 128 &&
            sizeof(MorphedGeometry) == 528 &&
            sizeof(DebugLine) == 28 &&
            sizeof(DebugLines) == 32 &&
            sizeof(JointReach) == 24 &&
            sizeof(MorphReach) == 24 &&
            sizeof(Reach) == 56 &&
            sizeof(SkinOutput) == 56 &&
            sizeof(AsPart) == 40 &&
            sizeof(Animation) == 168 &&
            sizeof(Animations) == 16 &&
            sizeof(CharacterOptions) == 12 &&
            sizeof(CharacterSkeleton) == 128 &&
            sizeof(CharacterMesh) == 984 &&
            sizeof(Character) == 216 &&
            sizeof(AnimationLayer) == 16 &&
            sizeof(OutfitSkeleton) == 24 &&
            sizeof(Outfit) == 16 &&
            sizeof(Gles3ErrorWatch) == 32 &&
            sizeof(Gles3Api) == 1776 &&
            sizeof(Gles3Caps) == 20 &&
            sizeof(Gles3VertexLayout) == 64 &&
            sizeof(Gles3GpuMesh) == 152 &&
            sizeof(Gles3PrepareOptions) == 32 &&
            sizeof(Gles3ProgramKey) == 4 &&
            sizeof(Gles3ProgramSource) == 32 &&
            sizeof(Gles3Program) == 88 &&
            sizeof(Gles3PaletteRing) == 16 &&
            sizeof(Gles3PaletteTexture) == 28 &&
            sizeof(Gles3SkinnedMesh) == 16 &&
            sizeof(Gles3ProgramSetEntry) == 96 &&
            sizeof(Gles3ProgramSet) == 18600 &&
            sizeof(Gles3SkinnerOptions) == 40 &&
            sizeof(Gles3SkinnerMotion) == 112 &&
            sizeof(Gles3Skinner) == 1472 &&
            sizeof(Gles3CrowdSource) == 160 &&
            sizeof(Gles3CrowdClip) == 16 &&
            sizeof(Gles3CrowdFrames) == 40 &&
            sizeof(Gles3CrowdPlay) == 24 &&
            sizeof(Gles3CrowdInstance) == 128 &&
            sizeof(Gles3CrowdMesh) == 680 &&
            sizeof(Gles3Crowd) == 40 &&
            sizeof(Gles3PathResult) == 20 &&
            sizeof(Gles3SelfTest) == 112 &&
            sizeof(Gles3SelfTestOptions) == 56 &&
            sizeof(Gles3PathNeed) == 12;
    }

    /// <summary>Bytes on a boundary of 16, which are to be freed by FreeBlock().</summary>
    public static void* Block(ulong bytes) {
        byte* all = (byte*)Marshal.AllocHGlobal(new IntPtr((long)bytes + 32));
        byte* first = (byte*)(((ulong)all + 31) / 16 * 16);
        ((void**)first)[-1] = all;
        return first;
    }
    public static void FreeBlock(void* first) {
        Marshal.FreeHGlobal((IntPtr)((void**)first)[-1]);
    }
    /// <summary>A text of the runtime.</summary>
    public static string Text(byte* text) {
        int length = 0;
        while (text[length] != 0) ++length;
        return System.Text.Encoding.UTF8.GetString(text, length);
    }
}

}
