// Made by tools/c_api from the descriptions in runtime/c: do not edit.
// The runtime for Rust, as C has it: see docs/c.md. Link marrow_c, marrow_unpack and marrow_runtime.
#![allow(dead_code, clippy::all)]
use std::os::raw::{c_char, c_void};

/// What abi() must give.
pub const ABI: u32 = 0x322cf8d7;
/// What gles3_abi() must give.
pub const GLES3_ABI: u32 = 0x163cddea;

/// What a call came to.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[must_use]
pub struct Status(pub u8);
impl Status {
    pub const OK: Self = Self(0);
    /// the call is wrong: a span too short, a null pointer, an index out of range
    pub const BAD_ARGUMENT: Self = Self(1);
    /// the data ends before what it announces
    pub const TRUNCATED: Self = Self(2);
    /// not a cooked file
    pub const BAD_MAGIC: Self = Self(3);
    /// cooked for another version of the format
    pub const BAD_VERSION: Self = Self(4);
    /// damaged
    pub const BAD_CHECKSUM: Self = Self(5);
    /// breaks a rule of docs/format.md
    pub const BAD_DATA: Self = Self(6);
    /// legal, but needs what this build or this device lacks
    pub const UNSUPPORTED: Self = Self(7);
    /// the driver refused
    pub const GL_ERROR: Self = Self(8);
    /// both are good, but not made for each other
    pub const MISMATCH: Self = Self(9);
    /// a library that allocates for itself found none
    pub const OUT_OF_MEMORY: Self = Self(10);
}

/// Where a block of data breaks the format, and which rule. `rule` is a static string.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct DataError {
    /// what the call returns
    pub status: Status,
    /// byte in the block
    pub offset: u32,
    /// in English
    pub rule: *const c_char,
}
impl Default for DataError {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            data_error_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<DataError>() == 16);

pub type CallErrorHandler = Option<unsafe extern "C" fn(function: *const c_char, condition: *const c_char)>;

/// Bytes: where blocks begin at multiples of.
pub const BLOCK_BOUNDARY: usize = 16;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Block {
    pub data: *mut c_void,
    pub size: usize,
}
impl Default for Block {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Block>() == 16);

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Bytes {
    pub data: *const c_void,
    pub size: usize,
}
impl Default for Bytes {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            bytes_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Bytes>() == 16);

/// One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MeshDecoder {
    /// as packed files name it
    pub codec: u32,
    /// the codec
    pub decode: Option<unsafe extern "C" fn()>,
}
impl Default for MeshDecoder {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MeshDecoder>() == 16);

/// Bytes of Unpacking's state.
pub const UNPACK_STATE_BYTES: usize = 512;

/// How much memory unpack() takes.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct UnpackSizes {
    /// of the unpacked file
    pub file_bytes: u32,
    /// what unpack() wants: the file and, behind it, room to work in
    pub memory_bytes: u32,
}
impl Default for UnpackSizes {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<UnpackSizes>() == 8);

/// The same in steps, for a game that loads while it plays: as many a frame as its time allows.
///
///   Unpacking loading;
///   begin_unpack(packed, decoders, memory, loading);
///   every frame   while (loading.file.empty() && there is time) unpack_step(loading);
///   then          load(loading.file, file)
///
/// A plain struct; {} is nothing begun. The packed bytes, the decoders and the memory stay as they are until the last
/// step. Stopping half way is forgetting it: nothing is to be freed.
#[repr(C, align(8))]
#[derive(Clone, Copy)]
pub struct Unpacking {
    /// empty until the last step is done; then as of unpack()
    pub file: *const c_void,
    pub file_bytes: usize,
    /// of total_bytes, for a bar
    pub done_bytes: u32,
    /// of the unpacked file
    pub total_bytes: u32,
    /// unpack_step()'s own
    pub state: [u8; 512],
}
impl Default for Unpacking {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            unpacking_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Unpacking>() == 536);

/// Local transforms (parent_from_joint = translate · rotate · scale) of four consecutive joints, one lane a joint.
/// Rotations are unit quaternions. Lanes past the last joint hold the identity.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct SoaTransform {
    /// x, y, z; metres
    pub translation: [[f32; 4]; 3],
    /// x, y, z, w
    pub rotation: [[f32; 4]; 4],
    /// x, y, z
    pub scale: [[f32; 4]; 3],
}
impl Default for SoaTransform {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SoaTransform>() == 160);

/// The change from one pose to another, not a pose: a type of its own, so that one is not taken for the other.
/// translation: difference; rotation: of the parent's axes, w ≥ 0; scale: ratio.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AdditiveTransform {
    /// of four joints
    pub change: SoaTransform,
}
impl Default for AdditiveTransform {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AdditiveTransform>() == 160);

/// An affine map, three rows of four: out = rows · (x, y, z, 1). What palettes and files hold: 48 bytes a joint.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct Affine {
    /// the last column is the translation
    pub rows: [[f32; 4]; 3],
}
impl Default for Affine {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Affine>() == 48);

/// The local transform of one joint.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct JointTransform {
    /// metres
    pub translation: [f32; 3],
    /// a unit quaternion x, y, z, w
    pub rotation: [f32; 4],
    /// along the joint's axes
    pub scale: [f32; 3],
}
impl Default for JointTransform {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            joint_transform_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<JointTransform>() == 40);

/// What a space has at most.
pub const MAX_EXAMPLE_PARAMETERS: u32 = 8;

/// What a space has at most.
/// and targets
pub const MAX_EXAMPLES: u32 = 64;

/// An axis of the space.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct ExampleParameter {
    /// see File::text; also of the channel that drives it
    pub name: u32,
    /// where nothing drives it
    pub rest: f32,
}
impl Default for ExampleParameter {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<ExampleParameter>() == 8);

/// Rows have one float a target, and zeros up to a multiple of four.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct ExampleSpace {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// at most kMaxExamples
    pub example_count: u32,
    /// at most kMaxExampleParameters
    pub parameters: *const ExampleParameter,
    pub parameter_count: usize,
    /// that it weighs, ascending, at most kMaxExamples; the same of each mesh
    pub targets: *const u32,
    pub target_count: usize,
    /// of the file, ascending
    pub meshes: *const u32,
    pub mesh_count: usize,
    /// a row of constants, then a row a parameter
    pub linear: *const f32,
    pub linear_count: usize,
    /// a row an example
    pub radial: *const f32,
    pub radial_count: usize,
    /// an example: its parameters
    pub places: *const f32,
    pub place_count: usize,
    /// an example; above 0
    pub inverse_widths: *const f32,
    pub inverse_width_count: usize,
}
impl Default for ExampleSpace {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<ExampleSpace>() == 128);

/// Limits that every valid file keeps; sizes of caller's memory can be bounded by them.
pub const MAX_JOINTS: u32 = 32767;

/// The most palette entries that a vertex follows.
pub const MAX_INFLUENCES: u32 = 8;

/// In Skeleton::parents: a root.
pub const NO_PARENT: u16 = 0xFFFF;

/// In Geometry::source_slots: a vertex of no triangle.
pub const NO_SLOT: u32 = 0xFFFFFFFF;

/// The most examples of a PoseSpace.
pub const MAX_POSE_EXAMPLES: u32 = 32;

/// In Mesh::material_index: no more than what stands in the Mesh.
pub const NO_MATERIAL: u32 = 0xFFFFFFFF;

/// In place of an image: none.
pub const NO_IMAGE: u32 = 0xFFFFFFFF;

/// In Node::joint and elsewhere: none.
pub const NO_JOINT: u16 = 0xFFFF;

/// What shape the rotations within a JointLimit have.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LimitKind(pub u8);
impl LimitKind {
    /// turns freely; for joints that have a rate limit alone
    pub const NONE: Self = Self(0);
    /// about one axis, between two angles: knees, elbows, fingers
    pub const HINGE: Self = Self(1);
    /// swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
    pub const CONE: Self = Self(2);
    /// three angles about three axes, each between two: rigs whose limits came so
    pub const EULER: Self = Self(3);
}

/// The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AxisOrder(pub u8);
impl AxisOrder {
    pub const XYZ: Self = Self(0);
    pub const XZY: Self = Self(1);
    pub const YXZ: Self = Self(2);
    pub const YZX: Self = Self(3);
    pub const ZXY: Self = Self(4);
    pub const ZYX: Self = Self(5);
}

/// Which part of a local transform a Track drives.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TrackPath(pub u8);
impl TrackPath {
    pub const TRANSLATION: Self = Self(0);
    pub const ROTATION: Self = Self(1);
    pub const SCALE: Self = Self(2);
}

/// What lies between two keys, as glTF 2.0 defines it.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Interpolation(pub u8);
impl Interpolation {
    pub const STEP: Self = Self(0);
    pub const LINEAR: Self = Self(1);
    pub const CUBIC_SPLINE: Self = Self(2);
}

/// Which attributes a morph target changes.
pub const MORPHS_POSITIONS: u32 = 1;

/// Which attributes a morph target changes.
pub const MORPHS_NORMALS: u32 = 2;

/// Which attributes a morph target changes.
pub const MORPHS_TANGENTS: u32 = 4;

/// How a material's alpha is meant, as in glTF 2.0.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AlphaMode(pub u8);
impl AlphaMode {
    pub const OPAQUE: Self = Self(0);
    pub const MASK: Self = Self(1);
    pub const BLEND: Self = Self(2);
}

/// What of a material an image gives.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextureRole(pub u8);
impl TextureRole {
    pub const BASE_COLOUR: Self = Self(0);
    pub const METALLIC_ROUGHNESS: Self = Self(1);
    pub const NORMAL: Self = Self(2);
    pub const OCCLUSION: Self = Self(3);
    pub const EMISSIVE: Self = Self(4);
    /// KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
    pub const SPECULAR_GLOSSINESS: Self = Self(5);
}

/// What lies beyond an image's edge.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wrap(pub u8);
impl Wrap {
    pub const REPEAT: Self = Self(0);
    pub const CLAMP_TO_EDGE: Self = Self(1);
    pub const MIRRORED_REPEAT: Self = Self(2);
}

/// How an image is magnified.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MagFilter(pub u8);
impl MagFilter {
    pub const ANY: Self = Self(0);
    pub const NEAREST: Self = Self(1);
    pub const LINEAR: Self = Self(2);
}

/// How an image is minified; any: the source leaves it to the game.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MinFilter(pub u8);
impl MinFilter {
    pub const ANY: Self = Self(0);
    pub const NEAREST: Self = Self(1);
    pub const LINEAR: Self = Self(2);
    pub const NEAREST_MIPMAP_NEAREST: Self = Self(3);
    pub const LINEAR_MIPMAP_NEAREST: Self = Self(4);
    pub const NEAREST_MIPMAP_LINEAR: Self = Self(5);
    pub const LINEAR_MIPMAP_LINEAR: Self = Self(6);
}

/// What an image's bytes are.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImageFormat(pub u8);
impl ImageFormat {
    pub const UNKNOWN: Self = Self(0);
    pub const PNG: Self = Self(1);
    pub const JPEG: Self = Self(2);
    pub const WEBP: Self = Self(3);
    pub const KTX2: Self = Self(4);
    pub const DDS: Self = Self(5);
}

/// What a Property is.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PropertyType(pub u8);
impl PropertyType {
    pub const NUMBER: Self = Self(0);
    pub const BOOLEAN: Self = Self(1);
    pub const TEXT: Self = Self(2);
}

/// Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
/// clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
/// angle_range() in limits.h.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AngleRange {
    /// -1 … 1: -180° … 180°
    pub middle: f32,
    /// 0 … 1; 1: any angle
    pub half_width: f32,
}
impl Default for AngleRange {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AngleRange>() == 8);

/// The most per second, and per second per second; 0: no limit. Of rotations in radians, of points in metres.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RateLimit {
    /// rad/s or m/s
    pub speed: f32,
    /// rad/s² or m/s²
    pub acceleration: f32,
}
impl Default for RateLimit {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            rate_limit_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<RateLimit>() == 8);

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
#[repr(C)]
#[derive(Clone, Copy)]
pub struct JointLimit {
    /// of the skeleton
    pub joint: u16,
    /// which of the shapes above
    pub kind: LimitKind,
    /// of euler; else xyz
    pub order: AxisOrder,
    /// unit quaternion
    pub limit_from_parent: [f32; 4],
    /// unit quaternion
    pub joint_from_limit: [f32; 4],
    /// of a cone the middles of the second and third are 0; of a hinge both are 0
    pub angles: [AngleRange; 3],
    /// of the local rotation, see follow_pose()
    pub rate: RateLimit,
}
impl Default for JointLimit {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            joint_limit_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<JointLimit>() == 68);

/// as many as SpringChain::colliders has bits
pub const MAX_SPRING_COLLIDERS: usize = 64;

/// A joint that swings, by the bone that goes from it to the next joint of its chain. See springs.h.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringJoint {
    /// of the skeleton
    pub joint: u16,
    /// 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
    pub most_pull: u16,
    /// 0 … 15: of small swings about the animated direction, without damping and gravity
    pub frequency_hz: f32,
    /// 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
    pub damping_ratio: f32,
    /// -10 … 10, times SpringFrame::gravity
    pub gravity: f32,
    /// 0 … 50 1/s: by which the air slows the bone's end, and the wind carries it
    pub drag: f32,
    /// ≥ 0, of the sphere about the bone's end that stays out of colliders; world
    pub radius_m: f32,
    /// 0 … 1, of what is shown; the motion itself goes on
    pub weight: f32,
}
impl Default for SpringJoint {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            spring_joint_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SpringJoint>() == 28);

/// Joints each of which is somewhere below the one before it. A joint belongs to one chain at most.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringChain {
    /// from the chain's root to its end
    pub joints: *const SpringJoint,
    pub joint_count: usize,
    /// end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
    pub tip: [f32; 3],
    /// bit i, lowest first: it stays out of SpringFrame::colliders[i]
    pub colliders: u64,
}
impl Default for SpringChain {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            spring_chain_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SpringChain>() == 40);

/// A capsule, or a sphere where both ends are one point, that moves with a joint. Its radius is scaled as the joint's
/// space is where that is most.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringCollider {
    /// it moves with
    pub joint: u16,
    pub reserved: u16,
    /// in the joint's space
    pub from: [f32; 3],
    /// in the joint's space
    pub to: [f32; 3],
    /// in the joint's space
    pub radius_m: f32,
}
impl Default for SpringCollider {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            spring_collider_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SpringCollider>() == 32);

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringColliderList {
    pub data: *const SpringCollider,
    pub size: usize,
}
impl Default for SpringColliderList {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SpringColliderList>() == 16);

/// The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
/// comes before its children and the roots come first.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Skeleton {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// 1 … kMaxJoints
    pub joint_count: u32,
    /// joints 0 … root_count-1 have no parent joint
    pub root_count: u32,
    /// root_count; what stands above each root and never moves
    pub scene_from_root: *const Affine,
    /// soa_count(joint_count); the pose of joints that a clip leaves alone
    pub rest: *const SoaTransform,
    /// joint_count; kNoParent for roots
    pub parents: *const u16,
    /// joint_count; see File::text
    pub names: *const u32,
    /// ascending by joint; those that the asset came with
    pub limits: *const JointLimit,
    pub limit_count: usize,
}
impl Default for Skeleton {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Skeleton>() == 64);

/// In a clip pack, instead of a skeleton: which one its clips were made for. See clip_pack.h.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SkeletonReference {
    /// the skeleton's
    pub name: *const c_char,
    /// the skeleton's
    pub joint_count: u32,
    /// skeleton_hash() of the skeleton
    pub hash: u64,
    /// joint_count; see File::text
    pub names: *const u32,
    /// joint_count; of each joint's rest pose
    pub rest_hashes: *const u32,
    /// joint_count; kNoParent for roots
    pub parents: *const u16,
}
impl Default for SkeletonReference {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SkeletonReference>() == 48);

/// One channel of a clip stored without loss: the source's own keys at the source's own times.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Track {
    /// of the skeleton
    pub joint: u16,
    /// what of the joint it drives
    pub path: TrackPath,
    /// between its keys
    pub interpolation: Interpolation,
    /// ≥ 1
    pub key_count: u32,
    /// into Clip::times; tracks with the same keys share them
    pub first_time: u32,
    /// Into Clip::values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
    pub first_value: u32,
}
impl Default for Track {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Track>() == 16);

/// Which sub-tracks (rotation, translation or scale of a joint) of a group of four joints move in a clip, and which
/// stay, but not as in the rest pose. Bits 0-3 rotation, 4-7 translation, 8-11 scale; lowest bit first joint.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroupMasks {
    /// what changes over the clip
    pub moving: u16,
    /// what stays, but not as at rest
    pub constant: u16,
}
impl Default for GroupMasks {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<GroupMasks>() == 4);

/// A number over time, such as a morph target's weight or a property of the game: it moves no joint. Without loss, but
/// that keys on a straight line between others may have been left out (docs/cooking/clips.md).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Channel {
    /// see File::text
    pub name: u32,
    /// the number where no clip drives it
    pub rest: f32,
    /// ≥ 1
    pub key_count: u32,
    /// as in Track
    pub first_time: u32,
    /// into Clip::values; one float a key, three for cubic_spline (in, value, out)
    pub first_value: u32,
    /// between its keys
    pub interpolation: Interpolation,
    pub reserved: [u8; 3],
}
impl Default for Channel {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Channel>() == 24);

/// In place of a channel: none.
pub const NO_CHANNEL: u32 = 0xFFFFFFFF;

/// Tracks compressed within a stated error: poses at even steps of time, or at times of their own, in segments, as
/// packed integers relative to the rest pose (docs/format.md). What does not move stands once.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CodedTracks {
    /// 0: the clip has no coded tracks; else ≥ 2
    pub frame_count: u32,
    /// sub-tracks that move
    pub track_count: u32,
    /// sub-tracks that stay, but not as at rest
    pub constant_count: u32,
    /// steps of time a segment; the last may have fewer
    pub segment_intervals: u32,
    /// of frame 0
    pub start_s: f32,
    /// of uneven ones the mean
    pub frames_per_s: f32,
    /// frame_count, ascending; null: even steps
    pub times_s: *const f32,
    /// one a group of four joints
    pub masks: *const GroupMasks,
    /// bytes into payload
    pub segment_offsets: *const u32,
    /// their values
    pub constants: *const c_void,
    /// segments of packed integers
    pub payload: *const c_void,
}
impl Default for CodedTracks {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<CodedTracks>() == 64);

/// An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Clip {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// which skeleton of the file; in a clip pack, which reference
    pub skeleton: u32,
    /// of that skeleton
    pub joint_count: u32,
    /// time of the last key; ≥ 0
    pub duration_s: f32,
    /// for sample_additive(), not for sample()
    pub additive: bool,
    /// additive: the pose that changes are taken from; null: the rest pose
    pub reference: *const SoaTransform,
    /// what is compressed
    pub coded: CodedTracks,
    /// what is stored without loss
    pub tracks: *const Track,
    pub track_count: usize,
    /// numbers that it drives
    pub channels: *const Channel,
    pub channel_count: usize,
    /// key times of tracks and channels, seconds
    pub times_s: *const f32,
    /// keys of tracks and channels
    pub values: *const f32,
    /// of its bytes and its place in the file, from File::clip(); 0: made by hand
    pub id: u64,
}
impl Default for Clip {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Clip>() == 152);

/// Consecutive vertices that depend on the same joints. Each run starts a new block of four vertices; the slots that
/// fill up its last block repeat its last vertex.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Run {
    /// ≥ 1
    pub vertex_count: u32,
    /// 1 … kMaxInfluences
    pub influences: u32,
}
impl Default for Run {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Run>() == 8);

/// What a morph target adds to the vertices of the blocks that it moves, the others it leaves alone. For each of its
/// blocks and attributes, in this order, a record of twelve integers: dx[4] dy[4] dz[4]; times a step each is a change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MorphTarget {
    /// into Geometry::target_blocks
    pub first_block: u32,
    /// how many blocks it moves
    pub block_count: u32,
    /// into Geometry::target_records
    pub first_record: u32,
    /// MorphAttributes; 0 if it moves nothing
    pub attributes: u32,
    /// metres, mesh space
    pub position_step: f32,
    /// a unit of its records of normals
    pub normal_step: f32,
    /// a unit of its records of tangents
    pub tangent_step: f32,
    pub reserved: u32,
}
impl Default for MorphTarget {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MorphTarget>() == 32);

/// What pose-space deformation adds to vertices of the bind pose, see skin_psd() in skin.h: example poses, and for each
/// the deltas of some blocks.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PoseSpace {
    /// width of the Gaussian, a share of 1: sin of half an angle
    pub sigma: f32,
    /// positions alone; empty: none
    pub examples: *const MorphTarget,
    pub example_count: usize,
    /// as Geometry::target_blocks
    pub blocks: *const c_void,
    /// as Geometry::target_records
    pub records: *const i16,
    /// for each example and palette entry x y z w, up to a positive factor
    pub rotations: *const i16,
    /// a palette entry: the one that its rotation is relative to, or kNoParent
    pub parents: *const u16,
}
impl Default for PoseSpace {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<PoseSpace>() == 56);

/// Triangles and bind-pose vertices. Vertices live in *slots*: blocks of four, laid out for the skinning kernels
/// (`k` is the run's influence count). The arrays of blocks begin on 16-byte boundaries.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Geometry {
    /// vertices with padding; a multiple of 4
    pub slot_count: u32,
    /// without padding
    pub vertex_count: u32,
    /// 3 a triangle; counter-clockwise fronts
    pub index_count: u32,
    /// 2 or 4
    pub index_bytes: u32,
    /// how many palette entries the sets refer to
    pub joint_count: u32,
    /// slots
    pub indices: *const c_void,
    /// in the order of the slots
    pub runs: *const Run,
    pub run_count: usize,
    /// for each run its k palette entries, run after run
    pub sets: *const u16,
    /// a block: x[4] y[4] z[4], then k-1 times w[4]; the last weight is 1 - Σ
    pub skin: *const f32,
    /// a block: x[4] y[4] z[4]; unit; null if absent
    pub normals: *const f32,
    /// a block: x[4] y[4] z[4] sign[4]; unit; null if absent
    pub tangents: *const f32,
    /// a block: k times dx[4] dy[4] dz[4] dw[4]; null: the lift, all zero
    pub as_residual: *const f32,
    /// a block: k times three rows x[4] y[4] z[4] t[4]; null if absent
    pub mwe_residual: *const f32,
    /// palette entry whose frame they are meant in
    pub mwe_root: u32,
    /// a slot: u v; null if absent
    pub uvs: *const f32,
    /// a slot: r g b a, linear; null if absent
    pub colours: *const u8,
    /// The slot of each vertex of the source, if cooked with --keep-vertex-order; kNoSlot: no triangle uses it, of this
    /// part of a primitive in parts.
    pub source_slots: *const u32,
    pub source_slot_count: usize,
    /// morph targets, as many as MeshTarget of a mesh
    pub targets: *const MorphTarget,
    pub target_count: usize,
    /// as wide as indices; for each target the blocks it moves, ascending
    pub target_blocks: *const c_void,
    /// twelve a record
    pub target_records: *const i16,
    /// examples empty: none
    pub pose_space: PoseSpace,
    /// of the bind positions, mesh space
    pub box_min: [f32; 3],
    /// likewise
    pub box_max: [f32; 3],
}
impl Default for Geometry {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Geometry>() == 248);

/// A morph target of a mesh: what it is called and what drives it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MeshTarget {
    /// see File::text; may be empty
    pub name: u32,
    /// Name of the channel that clips drive its weight by, see find_weight_channels() in morph.h.
    pub channel: u32,
    /// where no clip does
    pub weight: f32,
}
impl Default for MeshTarget {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MeshTarget>() == 12);

/// An image in a role, channels as glTF 2.0 section 3.9 has them. Base colour, emissive and specular-glossiness images
/// are sRGB (of the last all but alpha), others linear; (0, 0) of the UVs is the image's upper left corner.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Texture {
    /// which image of the file
    pub image: u16,
    /// none twice in a material
    pub role: TextureRole,
    /// along u and v
    pub wrap_u: Wrap,
    /// along u and v
    pub wrap_v: Wrap,
    /// as the source asks
    pub mag: MagFilter,
    /// as the source asks
    pub min: MinFilter,
    pub reserved: u8,
}
impl Default for Texture {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Texture>() == 8);

/// A material as far as Mesh does not say it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Material {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// opaque: alpha is not looked at
    pub alpha: AlphaMode,
    /// mask: what is less opaque is not drawn
    pub alpha_cutoff: f32,
    /// KHR_materials_unlit: the base colour is what is seen
    pub unlit: bool,
    /// linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
    pub emissive: [f32; 3],
    /// one a role
    pub textures: *const Texture,
    pub texture_count: usize,
}
impl Default for Material {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Material>() == 48);

/// A picture by reference, or as the source's own bytes. They are not checked: whoever decodes them must.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Image {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// relative to the source file and percent-encoded, as it stood there; empty if it had none
    pub uri: *const c_char,
    /// unknown: by its bytes or its URI none of the others
    pub format: ImageFormat,
    /// empty: by reference
    pub bytes: *const c_void,
    pub byte_count: usize,
    /// of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
    pub fallback: u32,
}
impl Default for Image {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Image>() == 48);

/// A number, a truth or a text that an artist gave a node.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Property {
    /// see File::text; of nested ones the path, as in "door/hinges/0"
    pub name: u32,
    /// which of the two members below holds it
    pub r#type: PropertyType,
    pub reserved: [u8; 3],
    /// finite; of a boolean 1 or 0
    /// see File::text
    pub number: f64,
}
impl Default for Property {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Property>() == 16);

/// A node of the source that is kept although it may be no joint: a socket, a locator. Its place in the scene is
/// scene_from_joint[joint] · joint_from_node, or joint_from_node alone without a joint.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Node {
    /// as the source calls it; never empty
    pub name: *const c_char,
    /// which skeleton of the file
    pub skeleton: u32,
    /// the nearest joint at or above it
    pub joint: u16,
    /// never changes
    pub joint_from_node: *const Affine,
    /// the `extras` of the source
    pub properties: *const Property,
    pub property_count: usize,
}
impl Default for Node {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Node>() == 40);

/// A palette entry that blends those of two joints, for vertices that follow both: see build_palette().
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Helper {
    /// palette entries, below Mesh::joint_count, not the same
    pub first: u16,
    /// palette entries, below Mesh::joint_count, not the same
    pub second: u16,
    /// of second; above 0, below 1
    pub share: f32,
}
impl Default for Helper {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            helper_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Helper>() == 8);

/// A level of detail: another geometry over the same palette.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MeshLod {
    /// which of the file
    pub geometry: u32,
    /// the farthest that a vertex of the full mesh is from it, in the clips it was made with
    pub error_m: f32,
}
impl Default for MeshLod {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MeshLod>() == 8);

/// A box, and a sphere about the box's centre, about the same vertices. Scene space, metres.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Bounds {
    /// least corner
    pub box_min: [f32; 3],
    /// greatest corner
    pub box_max: [f32; 3],
    /// below 0: empty, or not known
    pub radius_m: f32,
}
impl Default for Bounds {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Bounds>() == 28);

/// Geometry bound to joints. A mesh hung rigidly on a node is bound to one joint with weight 1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Mesh {
    /// as the source calls it; never null
    pub name: *const c_char,
    /// the material's name; never null
    pub material: *const c_char,
    /// which material of the file, if it has more than what stands here
    pub material_index: u32,
    /// which skeleton of the file
    pub skeleton: u32,
    /// meshes with the same number share their geometry
    pub geometry_index: u32,
    /// palette entries that are joints
    pub joint_count: u32,
    /// joint_count; palette entry → joint of the skeleton
    pub joints: *const u16,
    /// joint_count; joint_from_mesh in the bind pose
    pub inverse_bind: *const Affine,
    /// linear RGBA
    pub base_colour: [f32; 4],
    /// backs are drawn, too
    pub double_sided: bool,
    /// One primitive of the source with the mesh before it, for which one palette was too small. Nothing but the source's
    /// vertex order needs to know: see Geometry::source_slots.
    pub is_next_part: bool,
    /// palette entries behind those of the joints
    pub helpers: *const Helper,
    pub helper_count: usize,
    /// three a helper, or none: see build_palette()
    pub helper_centres: *const f32,
    pub helper_centre_count: usize,
    /// as many as the geometry's
    pub targets: *const MeshTarget,
    pub target_count: usize,
    /// levels 1, 2, …, ever coarser; level 0 is the mesh in full
    pub lods: *const MeshLod,
    pub lod_count: usize,
    /// of the level asked for
    pub geometry: Geometry,
}
impl Default for Mesh {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Mesh>() == 384);

/// A cooked file in memory. Cheap to copy; holds pointers into the block, which must outlive it and stay unchanged.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct File {
    pub block: *const c_void,
    pub sections: *const c_void,
    pub section_count: usize,
    pub numbers: [u32; 26],
}
impl Default for File {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            file_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<File>() == 128);

/// Why a joint keeps a clip pack from fitting a skeleton.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Misfit(pub u8);
impl Misfit {
    /// the skeleton has no joint of this name
    pub const MISSING: Self = Self(0);
    /// it has, below another joint
    pub const OTHER_PARENT: Self = Self(1);
    /// it has, with another rest pose, which coded tracks are relative to
    pub const OTHER_REST: Self = Self(2);
    /// a joint of the skeleton that the clips were made without
    pub const EXTRA: Self = Self(3);
    /// all joints are there, this one at another place in the order
    pub const OTHER_PLACE: Self = Self(4);
}

/// A joint that is in the way.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct JointMisfit {
    /// what is wrong with it
    pub how: Misfit,
    /// of the pack's reference; `extra`: of the skeleton
    pub joint: u32,
}
impl Default for JointMisfit {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<JointMisfit>() == 8);

/// What happens at the ends of a clip.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlayMode(pub u8);
impl PlayMode {
    /// time stops at the end
    pub const ONCE: Self = Self(0);
    /// time goes on from the other end; the last pose and the first are one moment
    pub const LOOP: Self = Self(1);
    /// time turns round
    pub const PING_PONG: Self = Self(2);
}

/// The state of a playing clip: plain numbers that may be set, copied and stored at will. A clip that is to run
/// backwards once begins with time_s = its duration.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Playback {
    /// in the clip
    pub time_s: f64,
    /// seconds of the clip a second; 0 pauses, below 0 runs backwards
    pub speed: f32,
    /// what happens at the ends
    pub mode: PlayMode,
    /// ping_pong: on the way back, so time runs against speed
    pub returning: bool,
    /// Of the last advance(). loop: how often time went from the clip's end to its start, less how often the other way
    /// round; ping_pong: how often time turned; once: 0. Stops at ±2147483647.
    pub turns: i32,
}
impl Default for Playback {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            playback_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Playback>() == 24);

/// Which joints are sampled.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SampleOptions {
    /// A level of detail, or any set of joints: joint j is bit j % 32 of word j / 32; at least ⌈joint_count / 32⌉ words.
    /// Joints whose bit is 0 keep what `out` holds. Empty: all joints. Every group of four without a joint of the set
    /// costs a few operations only.
    pub joints: *const u32,
    pub joint_count: usize,
}
impl Default for SampleOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            sample_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SampleOptions>() == 16);

/// What an instance that plays a clip keeps between two calls of sample_cached(). {} keeps nothing yet. All but `memory`
/// is sample_cached()'s own.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SampleCache {
    /// The caller's, 16-byte aligned: two unpacked frames of the clip, so that times between them are not unpacked again.
    /// With less than sample_cache_bytes() of a clip, or none, only what does not move is kept of it.
    pub memory: *mut c_void,
    pub memory_bytes: usize,
    /// where the last call wrote
    pub out: *const SoaTransform,
    /// which clip
    pub clip: u64,
    /// that is unpacked; 0xFFFFFFFF: none
    pub frame: u32,
    /// for this clip's frames
    pub room: bool,
}
impl Default for SampleCache {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            sample_cache_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SampleCache>() == 40);

/// How values run between two keys, and what a key holds. N is Curve::components, u goes 0 … 1 from one key to the next.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CurveKind(pub u8);
impl CurveKind {
    /// key: value. The earlier key's value
    pub const STEP: Self = Self(0);
    /// key: value. A straight line; for rotations the shorter great arc (slerp)
    pub const LINEAR: Self = Self(1);
    /// key: in-tangent, value, out-tangent; tangents per second, as glTF 2.0 CUBICSPLINE has it
    pub const HERMITE: Self = Self(2);
    /// value, one control point, value, one control point, … value; Bernstein form
    pub const QUADRATIC_BEZIER: Self = Self(3);
    /// value, two control points, value, two control points, … value; Bernstein form
    pub const CUBIC_BEZIER: Self = Self(4);
    /// key: value. Uniform; Catmull and Rom 1974: the tangent at P1 is (P2 - P0) / 2 a key interval
    pub const CATMULL_ROM: Self = Self(5);
    /// key: value. Catmull-Rom with knots √|P2 - P1| apart; Barry and Goldman, SIGGRAPH 1988, and
    /// Yuksel, Schaefer and Keyser 2011: no cusps or loops between two keys. Keys less than 1e18 apart
    pub const CENTRIPETAL: Self = Self(6);
}

/// How a patch's points shape it.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatchBasis(pub u8);
impl PatchBasis {
    /// through its inner points: u, v = 0 … 1 lead from point (1, 1) to point (2, 2)
    pub const CATMULL_ROM: Self = Self(0);
    /// through its corners: from point (0, 0) to point (3, 3)
    pub const BEZIER: Self = Self(1);
}

/// R. Penner's easings (Programming Macromedia Flash MX, 2002, chapter 7).
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Easing(pub u8);
impl Easing {
    pub const LINEAR: Self = Self(0);
    pub const QUAD: Self = Self(1);
    pub const CUBIC: Self = Self(2);
    pub const QUART: Self = Self(3);
    pub const QUINT: Self = Self(4);
    pub const SINE: Self = Self(5);
    pub const EXPO: Self = Self(6);
    pub const CIRC: Self = Self(7);
    pub const BACK: Self = Self(8);
    pub const ELASTIC: Self = Self(9);
    pub const BOUNCE: Self = Self(10);
}

/// At which end a movement is eased.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EaseMode(pub u8);
impl EaseMode {
    pub const IN: Self = Self(0);
    pub const OUT: Self = Self(1);
    pub const IN_OUT: Self = Self(2);
}

/// Keys, as a view. catmull_rom and centripetal draw a smooth path whatever the times are, but its velocity is
/// continuous only where key intervals are even (or go with √distance, centripetal); for motion that is smooth over
/// uneven keys make a spline. Beyond the first and last key they continue with a mirrored point, so that the path leaves
/// and arrives straight.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Curve {
    /// what lies between keys
    pub kind: CurveKind,
    /// Values are unit quaternions x, y, z, w; components is 4. Every key and control point is taken with the sign that is
    /// nearer to the one before it, and what comes out is normalised; its sign is open, as q and -q are the same rotation.
    /// A blend that has no direction gives the earlier key's.
    pub rotation: bool,
    /// floats a value: 1 … 4
    pub components: u32,
    /// one a key, strictly increasing; seconds, or whatever the curve runs over
    pub times_s: *const f32,
    pub time_count: usize,
    /// curve_value_count() floats
    pub values: *const f32,
    pub value_count: usize,
}
impl Default for Curve {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            curve_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Curve>() == 40);

/// Arc length: where on a path to be for its speed to be even.
///
/// The table holds the length of the path up to each of `steps` equal parts of every key interval.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct ArcLength {
    /// a key interval, at least 1
    pub steps: u32,
    /// arc_length_count() of them, ascending
    pub lengths: *const f32,
    pub length_count: usize,
}
impl Default for ArcLength {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            arc_length_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<ArcLength>() == 24);

/// The timing function of CSS Easing Functions Level 1: the cubic Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1), y
/// over x.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CubicBezierEase {
    /// CSS "ease"
    pub x1: f32,
    /// CSS "ease"
    pub y1: f32,
    /// CSS "ease"
    pub x2: f32,
    /// CSS "ease"
    pub y2: f32,
}
impl Default for CubicBezierEase {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            cubic_bezier_ease_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<CubicBezierEase>() == 16);

/// The largest weight of a layer; results stay far from the limits of float.
pub const MAX_BLEND_WEIGHT: f32 = 1e6;

/// Below this sum of weights a joint is filled up with its rest pose.
pub const REST_THRESHOLD: f32 = 0.1;

/// A pose and how much of it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct BlendLayer {
    /// at least skeleton.soa_size()
    pub pose: *const SoaTransform,
    pub pose_count: usize,
    /// 0 … kMaxBlendWeight in blend(), 0 … 1 in overlay()
    pub weight: f32,
    /// A factor for each joint's weight, 0 … 1: below 0 and NaN count as 0, above 1 as 1. Empty: 1 for every joint;
    /// else at least 4 · skeleton.soa_size() floats, in joint order, so that a group's factors are read at once.
    pub mask: *const f32,
    pub mask_count: usize,
}
impl Default for BlendLayer {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            blend_layer_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<BlendLayer>() == 40);

/// A change, and how much of it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AdditiveLayer {
    /// at least skeleton.soa_size()
    pub change: *const AdditiveTransform,
    pub change_count: usize,
    /// 0 … 1
    pub weight: f32,
    /// as in BlendLayer
    pub mask: *const f32,
    pub mask_count: usize,
}
impl Default for AdditiveLayer {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            additive_layer_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AdditiveLayer>() == 40);

/// How a weight goes from 0 to 1; u = time / duration. curve.h has more shapes.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fade(pub u8);
impl Fade {
    /// u
    pub const LINEAR: Self = Self(0);
    /// 3 u² - 2 u³: no jump of speed
    pub const SMOOTHSTEP: Self = Self(1);
    /// 6 u⁵ - 15 u⁴ + 10 u³: no jump of acceleration
    pub const SMOOTHERSTEP: Self = Self(2);
}

/// How far four joints are from the new clip's pose, and how that fades. Each of the nine components of a joint, x y z
/// of the translation, of the rotation vector (axis times angle, in the parent's axes) and of the scale, fades by
/// itself:
///   offset(t) = (1 - s)⁴ (start + slope s) with s = min(rate t, 1).
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct InertialOffset {
    /// metres, radians, factors
    pub start: [[f32; 4]; 9],
    /// over the whole fade
    pub slope: [[f32; 4]; 9],
    /// 1 / seconds
    pub rate: [[f32; 4]; 9],
}
impl Default for InertialOffset {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<InertialOffset>() == 432);

/// A transition under way; the memory is the caller's and can be used again for the next one.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Inertia {
    /// at least skeleton.soa_size()
    pub offsets: *mut InertialOffset,
    pub offset_count: usize,
    /// 0: none, or over
    pub duration_s: f32,
}
impl Default for Inertia {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            inertia_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Inertia>() == 24);

/// What was shown in the last two frames, and what the new clip would show.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct InertialStart {
    /// shown one frame earlier
    pub before: *const SoaTransform,
    pub before_count: usize,
    /// shown last
    pub now: *const SoaTransform,
    pub now_count: usize,
    /// the new clip at the time of `now`
    pub target: *const SoaTransform,
    pub target_count: usize,
    /// the new clip one frame earlier; empty: taken to stand still
    pub target_was: *const SoaTransform,
    pub target_was_count: usize,
    /// between the two, > 0; less than 1e-6 counts as that
    pub frame_s: f32,
}
impl Default for InertialStart {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            inertial_start_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<InertialStart>() == 72);

/// Rotations no farther outside than this keep their bits.
pub const LIMIT_TOLERANCE_RAD: f32 = 1e-5;

/// The widest swing of a cone: 170°.
pub const WIDEST_SWING_RAD: f32 = 2.9670597;

/// A limit as people think of it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct LimitDescription {
    /// its shape
    pub kind: LimitKind,
    /// of euler
    pub order: AxisOrder,
    /// the local rotation where all angles are 0: most often the joint's rest
    pub zero: [f32; 4],
    /// the limit's x in the joint's axes: a hinge's axis, or what a cone points along
    pub axis: [f32; 3],
    /// its y, made perpendicular to x
    pub across: [f32; 3],
    /// hinge: the first is the angle. Cone: the first is the twist; of the second and third, swings about y and z, `most`
    /// is the half-width, and `least` its negative. Euler: the three angles.
    pub least_rad: [f32; 3],
    /// as least_rad
    pub most_rad: [f32; 3],
    /// 0: none
    pub rate: RateLimit,
}
impl Default for LimitDescription {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            limit_description_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<LimitDescription>() == 76);

/// Limits over time. What follows a target with limited speed and acceleration: plain numbers, one for each rotation or
/// point that follows. A new one, one set to `{}`, and one whose numbers no call has left begins anew: the next call
/// takes its target as it is, at rest.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RotationFollower {
    /// where it is: x y z w
    pub rotation: [f32; 4],
    /// of the last call
    pub target: [f32; 4],
    /// radians a second, about the parent's axes
    pub velocity: [f32; 3],
    /// of the last call
    pub frame_s: f32,
    /// follow_rotation()'s own
    pub mode: u32,
}
impl Default for RotationFollower {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            rotation_follower_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<RotationFollower>() == 52);

/// A point that follows another.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PointFollower {
    /// where it is, metres
    pub point: [f32; 3],
    /// of the last call
    pub target: [f32; 3],
    /// metres a second
    pub velocity: [f32; 3],
    /// of the last call
    pub frame_s: f32,
    /// follow_point()'s own
    pub mode: u32,
}
impl Default for PointFollower {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            point_follower_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<PointFollower>() == 44);

/// What is asked of a limb: start, middle and end joint, such as hip, knee and ankle.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct TwoBone {
    /// where the end joint is to be; scene, metres
    pub target: [f32; 3],
    /// 0 … 1: 0 changes no bit, 1 reaches; between, both turns are blended
    pub weight: f32,
    /// The direction, from the start joint, to whose side the middle joint points; scene. Zero: the side it has in the
    /// pose, carried along the shortest way. Less than 0.1 rad off the direction of the target a pole says little, and
    /// the answer goes over to a side of 37° from that of the pose: a target that goes over the pole in the plane of the
    /// pose swings the limb round, and does not make it jump.
    pub pole: [f32; 3],
    /// turns the limb about the line from start to target, away from the pole; a few turns at most
    pub twist_rad: f32,
    /// About what the middle joint bends, by positive angles; in its local space. Says which way a straight limb bends,
    /// and which way it is to bend if the pose has it bent the other way. Zero: as in the pose, and a straight limb
    /// towards the pole.
    pub bend_axis: [f32; 3],
    /// The share of the limb's length from which on it stretches ever more slowly, 0 … 1, so that the middle joint does
    /// not snap when the target goes out of reach. 1: straight to full stretch, and the target is reached exactly to
    /// there; 0.97 is a usual choice.
    pub soft: f32,
    /// ≥ 1: the bones may be this many times as long, if the target is reached no other way
    pub max_stretch: f32,
}
impl Default for TwoBone {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            two_bone_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<TwoBone>() == 64);

/// Unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct TwoBoneTurns {
    /// of the start joint
    pub start: [f32; 4],
    /// of the middle joint
    pub mid: [f32; 4],
    /// for the translations of all joints from below start down to end; 1: unless max_stretch > 1
    pub stretch: f32,
    /// The target is within reach: at weight 1 the end comes to it within 1e-4 of the limb's length.
    pub reached: bool,
}
impl Default for TwoBoneTurns {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<TwoBoneTurns>() == 48);

/// The scene matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct TwoBoneJoints {
    /// hip, shoulder
    pub start: *const Affine,
    /// knee, elbow
    pub mid: *const Affine,
    /// ankle, wrist
    pub end: *const Affine,
}
impl Default for TwoBoneJoints {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            two_bone_joints_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<TwoBoneJoints>() == 24);

/// Joints of a skeleton; other joints may lie between them.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct TwoBoneLimb {
    /// hip, knee and ankle
    pub start: u32,
    /// hip, knee and ankle
    pub mid: u32,
    /// hip, knee and ankle
    pub end: u32,
}
impl Default for TwoBoneLimb {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            two_bone_limb_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<TwoBoneLimb>() == 12);

/// What is asked of a joint that looks or points at something: an eye, a head, a gun.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct Aim {
    /// scene, metres
    pub target: [f32; 3],
    /// 0 … 1: 0 changes no bit, 1 aims
    pub weight: f32,
    /// The scene direction to whose side of the target's direction `up` is turned. Zero: nothing is; the shortest way to
    /// the target is taken. Less than 0.1 rad off the target's direction it says little, as a TwoBone's pole.
    pub pole: [f32; 3],
    /// turns about the direction of the target, on top; a few turns at most
    pub twist_rad: f32,
    /// what is to go through the target; in the joint's local space
    pub forward: [f32; 3],
    /// local; not along forward. Of no use without a pole
    pub up: [f32; 3],
    /// where forward begins: an eye before the head's joint; local
    pub offset: [f32; 3],
}
impl Default for Aim {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            aim_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Aim>() == 80);

/// What aim() gives.
#[repr(C, align(16))]
#[derive(Clone, Copy)]
pub struct AimTurn {
    /// a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
    pub turn: [f32; 4],
    /// The target can be seen: at weight 1 the ray from the offset along forward goes through it. It cannot where the
    /// target is nearer to the joint than the ray ever gets, or than the offset, or where forward has no length.
    pub reached: bool,
}
impl Default for AimTurn {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AimTurn>() == 32);

/// How solve_ik() solves; docs/ik/solvers.md says which is for what.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IkMethod(pub u8);
impl IkMethod {
    pub const FABRIK: Self = Self(0);
    pub const CCD: Self = Self(1);
    pub const DAMPED_LEAST_SQUARES: Self = Self(2);
    pub const GAUSS_NEWTON: Self = Self(3);
}

/// Why a solver stopped.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IkStop(pub u8);
impl IkStop {
    /// the error is less than the tolerance
    pub const REACHED: Self = Self(0);
    /// nothing moved any more: the target is out of reach, or goals contradict each other
    pub const STALLED: Self = Self(1);
    /// max_iterations are over
    pub const ITERATIONS: Self = Self(2);
}

/// Where a point of a joint shall be, how the joint shall be turned, or both. What counts of a goal is its weights: 0
/// and it does not, of twice the weight and it gives way half as far where goals contradict each other.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct IkGoal {
    /// of the skeleton
    pub joint: u16,
    /// 0 first; what is less urgent never disturbs what is more so. Jacobian methods only
    pub priority: u8,
    /// the point of the joint that shall reach `position`; the joint's space, metres
    pub offset: [f32; 3],
    /// scene space, metres
    pub position: [f32; 3],
    /// of the joint's axes, in scene space: a unit quaternion x, y, z, w
    pub rotation: [f32; 4],
    /// 0 … 100
    pub position_weight: f32,
    /// metres a radian: the distance that is as bad as being turned wrong by a radian
    pub rotation_weight: f32,
}
impl Default for IkGoal {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            ik_goal_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<IkGoal>() == 52);

/// What is asked of a pose.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct IkProblem {
    /// at least one that counts
    pub goals: *const IkGoal,
    pub goal_count: usize,
    /// that may turn: ascending, so that parents come first. Others are stiff
    pub joints: *const u16,
    pub joint_count: usize,
    /// one of each of `joints`: 0 turns freely … 1 not at all; empty: all are free
    pub stiffness: *const f32,
    pub stiffness_count: usize,
    /// Joints ascending, as in a skeleton; those of joints that do not turn are left out.
    pub limits: *const JointLimit,
    pub limit_count: usize,
    /// Where a chain with one goal shall bend to, as a knee forward: the middle of its joints faces this point as nearly
    /// as a turn about the line from the first joint to the goal lets it. Of weight 0 … 1. FABRIK and CCD only.
    /// scene space, metres
    pub pole: [f32; 3],
    /// 0: no pole
    pub pole_weight: f32,
    /// By how many metres joints[0] is moved as easily as a joint is turned by a radian: the pelvis of a full body. 0: it
    /// stays. Jacobian methods only.
    pub root_travel_m: f32,
}
impl Default for IkProblem {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            ik_problem_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<IkProblem>() == 88);

/// How it is solved.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct IkOptions {
    /// see docs/ik/solvers.md
    pub method: IkMethod,
    /// How many poses to start from at most, as long as the goals are not reached: the one that there is, then others in
    /// which joints are turned at random, by `seed`. For sets of limits in which one start ends in a corner. More than 1
    /// costs as many times as much where goals are out of reach, and the result may jump as goals move.
    pub starts: u8,
    /// the most there are
    pub max_iterations: u16,
    /// an error (see IkReport) of less ends the iteration
    pub tolerance_m: f32,
    /// of the Jacobian methods: more is calmer and slower
    pub damping: f32,
    /// of `starts` and of solve_ik_genetic: the same seed, the same result
    pub seed: u32,
    /// 0 leaves every bit as it was; between, rotations lie between
    pub weight: f32,
    /// Of FABRIK and CCD with one goal: where it is beyond reach, the bones from the first joint that turns to the goal's
    /// become longer, by up to this factor; and shorter, by up to as much, where it is too near for them. 1: they keep
    /// their lengths. Changes local translations of the joints on the way.
    pub stretch: f32,
}
impl Default for IkOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            ik_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<IkOptions>() == 24);

/// How a solver ended.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct IkReport {
    /// √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
    pub error_m: f32,
    /// that it took
    pub iterations: u32,
    /// why it took no more
    pub why: IkStop,
}
impl Default for IkReport {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<IkReport>() == 12);

/// A leg. Other joints may lie between these: a hind leg of three bones is hip, knee and paw, and what is between keeps
/// its angle.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Foot {
    /// joints of the skeleton
    pub hip: u32,
    /// joints of the skeleton
    pub knee: u32,
    /// joints of the skeleton
    pub ankle: u32,
    /// what stands on the ground, in the ankle's space: below the ball of the foot, say
    pub sole: [f32; 3],
    /// of the knee; see TwoBone
    pub bend_axis: [f32; 3],
    /// 0 … 1
    pub weight: f32,
}
impl Default for Foot {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            foot_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Foot>() == 40);

/// Two legs or more. The clips have been made for level ground, through the scene's origin.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Feet {
    /// two or more
    pub feet: *const Foot,
    pub foot_count: usize,
    /// moved up and down, with all that hangs on it, the hips too; none: stays
    pub pelvis: u32,
    /// ≥ 0: by how much at most it goes down, or up; world
    pub lower_m: f32,
    /// 0 … 1: it goes down, too, where a leg would be longer than this share of its bones
    pub reach: f32,
    /// 0 … 1.5: by how much at most a foot leans with the ground
    pub slope_rad: f32,
    /// > 0: the time in which all but 2 % of a step in the ground, or of a release, is over
    pub ease_s: f32,
}
impl Default for Feet {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            feet_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Feet>() == 40);

/// What the game knows of a foot in this frame; world.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct FootGround {
    /// false: as if the ground were level at the height of the scene's origin
    pub hit: bool,
    /// of a ray along `up` through foot_sole(), or anywhere on the plane that it hit
    pub point: [f32; 3],
    /// of any length; steeper than 80°: no hit
    pub normal: [f32; 3],
    /// the sole stays at its place until this is false again
    pub planted: bool,
}
impl Default for FootGround {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            foot_ground_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<FootGround>() == 32);

/// The motion of one foot: plain numbers. A new one, one set to `{}`, and one whose numbers are out of hand begins where
/// the animation has the foot. World; on a moving platform, let the world be the platform.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct FootMotion {
    /// of the sole, as shown last
    pub place: [f32; 3],
    /// of the sole from its target
    pub offset: [f32; 3],
    /// of the sole from its target
    pub offset_speed: [f32; 3],
    /// of the ground's normal that the foot leans by from the ground's own
    pub lean: [f32; 3],
    /// of the ground's normal that the foot leans by from the ground's own
    pub lean_speed: [f32; 3],
    /// the ground, last
    pub point: [f32; 3],
    /// the ground, last
    pub normal: [f32; 3],
    /// level: of the ankle's axis `axis` when it was planted
    pub heading: [f32; 3],
    /// about up, from the animated to the planted heading
    pub turn: [f32; 4],
    /// how much of it is left
    pub turn_share: f32,
    /// how much of it is left
    pub turn_share_speed: f32,
    /// whether it is planted, and was begun
    pub axis: u8,
    /// whether it is planted, and was begun
    pub planted: u8,
    /// whether it is planted, and was begun
    pub begun: u8,
    /// whether its ray found ground
    pub hit: u8,
    /// whether the leg was long enough
    pub reached: u8,
}
impl Default for FootMotion {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            foot_motion_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<FootMotion>() == 128);

/// What place_feet() is told of a frame.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct FeetFrame {
    /// since the last frame
    pub dt_s: f32,
    /// Where the character stands: a turn, one scale above 0, a shift.
    pub world_from_scene: Affine,
    /// a unit vector; world
    pub up: [f32; 3],
    /// feet begin anew, none is planted where it was
    pub teleported: bool,
    /// 0 … 1, times each foot's; the motion goes on
    pub weight: f32,
}
impl Default for FeetFrame {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            feet_frame_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<FeetFrame>() == 96);

/// frames are cut into equal steps no longer than this …
pub const MAX_SPRING_STEP_S: f32 = 1.0 / 60.0;

/// … and time beyond so many is left out
pub const MAX_SPRING_STEPS: i32 = 8;

/// shorter frames are saved up
pub const MIN_SPRING_FRAME_S: f32 = 0.001;

#[repr(C)]
pub struct SpringGroup {
    _private: [u8; 0],
}

#[repr(C)]
pub struct SpringRoot {
    _private: [u8; 0],
}

#[repr(C)]
pub struct JointRange {
    _private: [u8; 0],
}

/// Chains of one character. To keep or to copy a motion, copy the memory.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Springs {
    /// four bones each
    pub groups: *mut SpringGroup,
    /// a chain each
    pub roots: *mut SpringRoot,
    /// joints whose matrices springs change
    pub below: *mut JointRange,
    /// of each of them
    pub group_count: u32,
    /// likewise
    pub root_count: u32,
    /// likewise
    pub below_count: u32,
    /// of the skeleton
    pub joint_count: u32,
    /// time of frames that were too short
    pub saved_s: f32,
}
impl Default for Springs {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            springs_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Springs>() == 48);

/// What simulate_springs() is told of a frame.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringFrame {
    /// since the last frame
    pub dt_s: f32,
    /// Where the character stands: a turn, one scale, a shift. Motion in the world is felt, by this and by the pose.
    pub world_from_scene: Affine,
    /// m/s², world
    pub gravity: [f32; 3],
    /// m/s, world; acts by `drag`
    pub wind: [f32; 3],
    /// at most kMaxSpringColliders
    pub colliders: *const SpringCollider,
    pub collider_count: usize,
    /// chains whose first joint moves further than this in one frame are moved along …
    pub teleport_m: f32,
    /// … and so are all if this is set
    pub teleported: bool,
    /// 0 … 1, times each joint's
    pub weight: f32,
}
impl Default for SpringFrame {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            spring_frame_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SpringFrame>() == 128);

/// An instance's vertices, in the caller's memory. Copies are views of the same vertices.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MorphedGeometry {
    /// as the bind geometry, but that skin, normals and tangents are the instance's own
    pub geometry: Geometry,
    /// as the file has it
    pub bind: Geometry,
    /// a block's first float in the skin; one more for the end
    pub offsets: *const u32,
    /// a bit a block: differs from the bind pose
    pub moved: *mut u32,
    /// a bit a block: written since morph_coordinates()
    pub changed: *mut u32,
    /// one, MorphAttributes: what differs in the blocks moved
    pub attributes: *mut u32,
}
impl Default for MorphedGeometry {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MorphedGeometry>() == 528);

/// A line to draw; scene space.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct DebugLine {
    /// its ends, metres
    pub from: [f32; 3],
    /// its ends, metres
    pub to: [f32; 3],
    /// r g b a
    pub colour: [u8; 4],
}
impl Default for DebugLine {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            debug_line_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<DebugLine>() == 28);

/// Room for lines in the caller's memory. The calls below append to it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct DebugLines {
    /// the caller's
    pub room: *mut DebugLine,
    pub room_count: usize,
    /// of lines that are there, from the front
    pub count: usize,
    /// for which there was no room
    pub left_out: usize,
}
impl Default for DebugLines {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            debug_lines_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<DebugLines>() == 32);

/// The vertices of the bind pose that a palette entry has a weight in, as a box in mesh space.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct JointReach {
    /// the box's middle
    pub centre: [f32; 3],
    /// ≥ 0; below 0: nothing follows this entry
    pub half: [f32; 3],
}
impl Default for JointReach {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<JointReach>() == 24);

/// What a morph target (or an example of pose-space deformation) adds to vertices at weight 1: a box about all changes
/// and about 0, in mesh space.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct MorphReach {
    /// ≤ 0
    pub least: [f32; 3],
    /// ≥ 0
    pub most: [f32; 3],
}
impl Default for MorphReach {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<MorphReach>() == 24);

/// Views into the caller's memory.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Reach {
    /// one a palette entry, helpers behind
    pub joints: *mut JointReach,
    pub joint_count: usize,
    /// one a morph target
    pub targets: *mut MorphReach,
    pub target_count: usize,
    /// the sum of what all examples may add
    pub pose_space: MorphReach,
}
impl Default for Reach {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Reach>() == 56);

/// How bind-pose normals and tangents get to the deformed surface. M is the 3×3 part of the vertex's blended matrix.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NormalTransform(pub u8);
impl NormalTransform {
    /// Normals through the inverse transpose of M (its cofactors), tangents through M, both unit: exact for any blend that
    /// can be inverted, mirrored or unevenly scaled ones too.
    pub const INVERSE_TRANSPOSE: Self = Self(0);
    /// Both through M, their length left as it comes: half the time, for shaders that normalise anyway. Right in direction
    /// where M is a rotation, a mirror or an even scale; a blend of rotations is none of these quite. On real clips
    /// normals stray by 0.8° on average, by up to 58° inside sharp bends, and come as short as 0.27
    /// (docs/benchmarks.md). Tangents are inverse_transpose's up to length.
    pub const BLENDED_MATRIX: Self = Self(1);
}

/// Where skinned vertices go: the caller's memory, slot after slot.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SkinOutput {
    /// 3 a slot; required
    pub positions: *mut f32,
    pub position_count: usize,
    /// 3 a slot; leave empty to skip
    pub normals: *mut f32,
    pub normal_count: usize,
    /// 4 a slot: xyz, then the handedness, turned where the blend mirrors. (SSD and animation space with blended_matrix
    /// ask the run's last joint, not the blend: only a vertex between mirrored and unmirrored joints can tell.) Needs
    /// normals. Leave empty to skip.
    pub tangents: *mut f32,
    pub tangent_count: usize,
    /// of tangents, too
    pub normal_transform: NormalTransform,
}
impl Default for SkinOutput {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            skin_output_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<SkinOutput>() == 56);

/// A mesh in animation space, for as_tangents().
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AsPart {
    /// cooked with animation space
    pub mesh: *const Mesh,
    /// from as_coordinates()
    pub coordinates: *const f32,
    pub coordinate_count: usize,
    /// as_tangent_count() floats, to be written
    pub tangents: *mut f32,
    pub tangent_count: usize,
}
impl Default for AsPart {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            as_part_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AsPart>() == 40);

/// In Animation: the skeleton plays nothing.
pub const NO_CLIP: u32 = 0xFFFFFFFF;

/// What the skeletons of a character play together: a clip each, or none. Plain pointers, which a game may fill itself.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Animation {
    /// that they are from: the character's file, or a clip pack
    pub clips: File,
    /// of the longest
    pub duration_s: f32,
    /// One a skeleton of the character: which clip it plays; kNoClip: it rests.
    pub clip_of_skeleton: *const u32,
    pub clip_of_skeleton_count: usize,
    /// One a morph target of the character, mesh after mesh: from find_weight_channels() with the clip that the mesh's
    /// skeleton plays.
    pub channels: *const u32,
    pub channel_count: usize,
}
impl Default for Animation {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Animation>() == 168);

/// All animations of a file, by name.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Animations {
    /// One a clip, with the index that the clip has: the clip, and of each other skeleton the first with the same name.
    /// A clip without a name has nothing to do with others.
    pub all: *const Animation,
    pub all_count: usize,
}
impl Default for Animations {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Animations>() == 16);

/// What a character is made for.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CharacterOptions {
    /// that are blended at once, at most; at least 1
    pub layers: u32,
    /// of detail, as in File::mesh
    pub level: u32,
    /// on the CPU; false: neither palettes nor morphed vertices, a gles3::Skinner has them
    pub skin: bool,
    /// skin by skin_as(), too
    pub animation_space: bool,
}
impl Default for CharacterOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            character_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<CharacterOptions>() == 12);

/// A skeleton and its pose in both forms. What changes one between pose_character() and finish_character() must keep
/// the other alike; all calls of stage 3½ do.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CharacterSkeleton {
    /// of the file
    pub skeleton: Skeleton,
    /// skeleton.soa_size()
    pub local: *mut SoaTransform,
    pub local_count: usize,
    /// skeleton.joint_count
    pub scene_from_joint: *mut Affine,
    pub scene_from_joint_count: usize,
    /// sample_character()'s own, one a layer: a pose, and what is kept of the clip that it is of.
    pub sampled: *mut SoaTransform,
    pub sampled_count: usize,
    /// as `sampled`
    pub caches: *mut SampleCache,
    pub cache_count: usize,
}
impl Default for CharacterSkeleton {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<CharacterSkeleton>() == 128);

/// A mesh, ready for skin_ssd(mesh, palette, …) or skin_as(mesh, coordinates, palette, …) after finish_character().
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CharacterMesh {
    /// of the level asked for; with `skin` its geometry is this character's own, morphed
    pub mesh: Mesh,
    /// of morph targets
    pub weights: *mut f32,
    pub weight_count: usize,
    /// empty without `skin`
    pub palette: *mut Affine,
    pub palette_count: usize,
    /// empty without `skin` and `animation_space`
    pub coordinates: *mut f32,
    pub coordinate_count: usize,
    /// with `skin`
    pub morphed: MorphedGeometry,
    /// what it lies in
    pub vertices: *mut c_void,
    pub vertices_bytes: usize,
    /// in Animation::channels
    pub first_target: u32,
}
impl Default for CharacterMesh {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<CharacterMesh>() == 984);

/// Views into the caller's memory. A copy is the same character.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Character {
    /// as it was given
    pub file: File,
    /// as they were given
    pub options: CharacterOptions,
    /// all of the file, in its order
    pub skeletons: *mut CharacterSkeleton,
    pub skeleton_count: usize,
    /// all of the file, in its order
    pub meshes: *mut CharacterMesh,
    pub mesh_count: usize,
    /// of morph targets, of all meshes
    pub target_count: u32,
    /// Scratch, of the largest skeleton.
    pub blended: *mut BlendLayer,
    pub blended_count: usize,
    /// of the same size
    pub change: *mut AdditiveTransform,
    pub change_count: usize,
}
impl Default for Character {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Character>() == 216);

/// An animation at a time, and how much of it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AnimationLayer {
    /// made for the character's file
    pub animation: *const Animation,
    /// see playback.h
    pub time_s: f32,
    /// 0 … kMaxBlendWeight
    pub weight: f32,
}
impl Default for AnimationLayer {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            animation_layer_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<AnimationLayer>() == 16);

/// Of one skeleton of an outfit: what it follows.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct OutfitSkeleton {
    /// of the body's character
    pub body_skeleton: u32,
    /// one a joint of the outfit; see bind_outfit()
    pub body_joints: *const u16,
    pub body_joint_count: usize,
}
impl Default for OutfitSkeleton {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<OutfitSkeleton>() == 24);

/// What characters of one file, hair or clothes, follow of a body of another. Serves any number of them.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Outfit {
    /// one a skeleton of the outfit
    pub skeletons: *const OutfitSkeleton,
    pub skeleton_count: usize,
}
impl Default for Outfit {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Outfit>() == 16);

pub type Gles3ErrorReport = Option<unsafe extern "C" fn(user: *mut c_void, call: *const c_char, error: u32)>;

pub type Gles3GetError = Option<unsafe extern "C" fn() -> u32>;

/// Told of every GL error by the call that caused it: for debugging, as each call is then between two of glGetError.
/// One an Api and thread.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3ErrorWatch {
    /// call: "glBindBuffer", a static string. May be null.
    /// what `report` gets
    pub report: Gles3ErrorReport,
    /// call: "glBindBuffer", a static string. May be null.
    /// what `report` gets
    pub user: *mut c_void,
    /// what the Api's GetError has yet to tell, as it would without a watch
    pub pending: u32,
    /// the driver's glGetError
    pub get_error: Gles3GetError,
}
impl Default for Gles3ErrorWatch {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_error_watch_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3ErrorWatch>() == 32);

pub type Gles3LoadProc = Option<unsafe extern "C" fn(name: *const c_char) -> *mut c_void>;

/// The driver's entry points.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3Api {
    pub words: [usize; 222],
}
impl Default for Gles3Api {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3Api>() == 1776);

/// Multi-weights are the CPU's alone: with four influences 192 bytes a vertex, more than attributes hold.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3Deformer(pub u8);
impl Gles3Deformer {
    /// vertices skinned elsewhere, in float: position, normal, tangent
    pub const NONE: Self = Self(0);
    /// the joint with the largest weight
    pub const RIGID: Self = Self(1);
    pub const SSD: Self = Self(2);
    pub const AS: Self = Self(3);
    /// SSD of what the mesh's pose space has moved, see skin_psd() in skin.h
    pub const PSD: Self = Self(4);
}

/// Where a program finds its palettes.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3Palettes(pub u8);
impl Gles3Palettes {
    /// PaletteRing: one palette a draw call
    pub const UNIFORM_BLOCK: Self = Self(0);
    /// PaletteTexture: of any size; one draw call may draw many characters
    pub const TEXTURE: Self = Self(1);
    /// CrowdMesh, see gles3_crowd.h: likewise, without work on the CPU; not for Deformer::none, psd or kMorphs
    pub const CROWD: Self = Self(2);
}

/// Which attributes a mesh has and a program reads.
pub const GLES3_NORMALS: u32 = 1;

/// A mesh has tangents, a program reads them; here and below as above.
pub const GLES3_TANGENTS: u32 = 2;

/// Texture coordinates.
pub const GLES3_UVS: u32 = 4;

/// Colours of vertices.
pub const GLES3_COLOURS: u32 = 8;

/// Morph targets.
pub const GLES3_MORPHS: u32 = 16;

/// In animation space normals and tangents are the deformed surface's own, by as_tangents(): see PrepareOptions.
pub const GLES3_SURFACE_NORMALS: u32 = 32;

/// A program's alone, none of a mesh: where each vertex was in the frame before, for motion vectors.
pub const GLES3_MOTION: u32 = 64;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// animation space: 0 … 7 are the coordinates
pub const GLES3_POSITION_LOCATION: u32 = 0;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// and 2
pub const GLES3_WEIGHTS_LOCATION: u32 = 1;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// and 9; on Mali-G up to eight here, two in a number
pub const GLES3_JOINTS_LOCATION: u32 = 8;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// octahedral
pub const GLES3_NORMAL_LOCATION: u32 = 10;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// octahedral, and the handedness
pub const GLES3_TANGENT_LOCATION: u32 = 11;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// in_uv
pub const GLES3_UV_LOCATION: u32 = 12;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// in_colour
pub const GLES3_COLOUR_LOCATION: u32 = 13;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// row of the morph texture
pub const GLES3_MORPH_ROW_LOCATION: u32 = 14;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// row of the texture of examples
pub const GLES3_EXAMPLE_ROW_LOCATION: u32 = 15;

/// Morph targets that a vertex shader adds at a time: a quarter of the uniforms that GLES 3.0 promises.
pub const GLES3_MORPH_TARGETS: u32 = 64;

/// Attribute locations of the skinning text, fixed so that any program draws any mesh; but that animation space with
/// kSurfaceNormals is drawn by programs with it alone, as it has other vectors where normals and tangents are.
/// Deformer::none with kMotion: the position of the frame before
pub const GLES3_PREVIOUS_LOCATION: u32 = 1;

/// Matrices in the uniform block of the programs: as many as fit the smallest block that GLES 3.0 allows.
pub const GLES3_PALETTE_JOINTS: u32 = 341;

/// Bytes of that block.
pub const GLES3_PALETTE_BLOCK_BYTES: u32 = 16368;

/// Texels a row of the texture: what GLES 3.0 promises.
pub const GLES3_PALETTE_TEXTURE_WIDTH: u32 = 2048;

/// What the context can do. The defaults are the least that GLES 3.0 allows; tests force them on any driver.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3Caps {
    /// that one block may have
    pub uniform_block_bytes: u32,
    /// power of two
    pub uniform_offset_alignment: u32,
    /// of four numbers each
    pub vertex_attributes: u32,
    /// along each side
    pub texture_size: u32,
    /// OpenGL ES 3.1 or newer, and its functions
    pub compute: bool,
}
impl Default for Gles3Caps {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_caps_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3Caps>() == 20);

/// Byte offsets in one vertex of each stream. Offsets of what is absent are unused.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3VertexLayout {
    /// the most of any vertex, 4 to 8
    pub influences: u32,
    /// 1 or 2
    pub joint_bytes: u32,
    /// the stream of SSD
    pub ssd_stride: u32,
    /// the stream of SSD
    pub ssd_weights: u32,
    /// the stream of SSD
    pub ssd_joints: u32,
    /// in SSD's stream; 0: there is none
    pub example_row: u32,
    /// the stream of animation space
    pub as_stride: u32,
    /// the stream of animation space
    pub as_tangents: u32,
    /// the stream of animation space
    pub as_joints: u32,
    /// there are tangents, and room for them
    pub surface_normals: bool,
    /// the stream that all deformers share
    pub surface_stride: u32,
    /// the stream that all deformers share
    pub normal: u32,
    /// the stream that all deformers share
    pub tangent: u32,
    /// the stream that all deformers share
    pub uv: u32,
    /// the stream that all deformers share
    pub colour: u32,
    /// unorm16×2, otherwise f32×2
    pub uv_unorm: bool,
}
impl Default for Gles3VertexLayout {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_vertex_layout_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3VertexLayout>() == 64);

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
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3GpuMesh {
    /// vertex array objects; 0 where not asked for. Rigid uses this one too.
    pub ssd_array: u32,
    /// of animation space
    pub as_array: u32,
    /// the streams above, a buffer each
    pub ssd_buffer: u32,
    /// of animation space
    pub as_buffer: u32,
    /// 0 for a mesh of bare positions
    pub surface_buffer: u32,
    /// 0 for a mesh without morph targets
    pub morph_buffer: u32,
    /// likewise
    pub morph_texture: u32,
    /// 0 without PrepareOptions::psd, or examples
    pub example_texture: u32,
    /// of all three vertex arrays
    pub index_buffer: u32,
    /// three a triangle
    pub index_count: u32,
    /// GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
    pub index_type: u32,
    /// what the indices draw: GL_TRIANGLES
    pub primitive: u32,
    /// as Geometry::slot_count
    pub slot_count: u32,
    /// matrices in its palette
    pub joint_count: u32,
    /// all vertex buffers together
    pub vertex_bytes: u32,
    /// the most of any vertex, 4 to 8
    pub influences: u8,
    /// kNormals | …
    pub features: u8,
    /// texels a vertex: positions, normals, tangents
    pub morph_per_row: u8,
    /// the texture's width is 1 << morph_shift
    pub morph_shift: u8,
    /// of a target
    pub morph_texels: u32,
    /// 1 / half-extent, see prepare()
    pub morph_unit: f32,
    /// of changes, in half-extents
    pub example_step: f32,
    /// distance_matrices() of the mesh, where it has examples here
    pub distances: u32,
    /// of them, a palette entry
    pub distance_texels: u32,
    /// Coordinates are stored divided by this; 1 unless a fitted weight lies outside [-1, 1].
    pub coordinate_scale: f32,
    /// of its vertex buffers
    pub layout: Gles3VertexLayout,
}
impl Default for Gles3GpuMesh {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_gpu_mesh_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3GpuMesh>() == 152);

/// What prepare() puts on the GPU.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3PrepareOptions {
    /// also what rigid draws from
    pub ssd: bool,
    /// neither: for vertices skinned on the CPU
    pub r#as: bool,
    /// From as_tangents() of this mesh: then animation space draws the deformed surface's own normals, and `features` has
    /// kSurfaceNormals. Empty, or of a mesh with morph targets or without normals: normals through the blend.
    pub as_tangents: *const f32,
    pub as_tangent_count: usize,
    /// With `ssd`: what Deformer::psd draws from, too; nothing more of a mesh without examples.
    pub psd: bool,
}
impl Default for Gles3PrepareOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_prepare_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3PrepareOptions>() == 32);

/// What a program is compiled for: of the mesh's features those that it is to read. With kMorphs it draws only meshes
/// that have targets; set_morphs() before each. With kMotion it skins twice: by the palettes of this frame, and of the
/// frame before, positions alone. Those, bound for each draw call like the others, are
///   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by bind_palette()
///   in a texture         bind_previous_palette(); of crowds bind_crowd() does it
///   skinned elsewhere    set_previous(), see gles3_skinned.h
/// and with kMorphs set_previous_morphs().
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3ProgramKey {
    /// by which vertices are skinned
    pub deformer: Gles3Deformer,
    /// 4 to 8: that of the mesh or more
    pub influences: u8,
    /// kNormals | …, that it reads
    pub features: u8,
    /// where they are
    pub palettes: Gles3Palettes,
}
impl Default for Gles3ProgramKey {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_program_key_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3ProgramKey>() == 4);

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
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3ProgramSource {
    /// as above
    pub vertex: *const c_char,
    /// as above
    pub fragment: *const c_char,
    /// for transform feedback, interleaved; empty otherwise
    pub feedback_varyings: *const *const c_char,
    pub feedback_varying_count: usize,
}
impl Default for Gles3ProgramSource {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_program_source_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3ProgramSource>() == 32);

/// A program of the driver and where its uniforms are. Filled in by Marrow.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3Program {
    /// for UseProgram(); 0: none
    pub id: u32,
    /// where it reads palettes
    pub reads: Gles3Palettes,
    /// built with kMotion
    pub motion: bool,
    /// Locations of uniforms.
    /// of attributes; here and below -1: there is none
    pub coordinate_scale: i32,
    /// Locations of uniforms.
    /// of attributes; here and below -1: there is none
    pub joint_bits: i32,
    /// of palettes in a texture
    pub palettes: i32,
    /// of palettes in a texture
    pub first_row: i32,
    /// of crowds
    pub instances: i32,
    /// of crowds
    pub crowd: i32,
    /// of pre-skinning by compute shaders
    pub vertex_layout: i32,
    /// of morph targets
    pub morph_changes: i32,
    /// of morph targets
    pub morph_targets: i32,
    /// of morph targets
    pub morph_count: i32,
    /// of morph targets
    pub morph_shift: i32,
    /// of morph targets
    pub morph_per_row: i32,
    /// of the frame before
    pub previous_palettes: i32,
    /// of the frame before
    pub previous_targets: i32,
    /// of the frame before
    pub previous_count: i32,
    /// of pose spaces
    pub examples: i32,
    /// of pose spaces
    pub example_step: i32,
    /// of pose spaces
    pub distances: i32,
    /// of pose spaces
    pub distance_row: i32,
    /// of pose spaces
    pub previous_distances: i32,
}
impl Default for Gles3Program {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_program_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3Program>() == 88);

/// One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
/// contents are orphaned, so the CPU never waits for the GPU.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3PaletteRing {
    /// a uniform buffer; 0: none
    pub buffer: u32,
    /// of offsets, bytes
    pub alignment: u32,
    /// bytes that palettes may use
    pub capacity: u32,
    /// bytes, since begin_frame()
    pub used: u32,
}
impl Default for Gles3PaletteRing {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_palette_ring_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3PaletteRing>() == 16);

/// All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Of three, each is written every third
/// frame, so that the driver has no reason to wait for what it still draws from, or to copy it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3PaletteTexture {
    /// 0: none
    pub textures: [u32; 3],
    /// which was written last
    pub current: u32,
    /// matrices
    pub capacity: u32,
    /// that are there
    pub count: u32,
    /// that were there in the frame before
    pub previous_count: u32,
}
impl Default for Gles3PaletteTexture {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_palette_texture_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3PaletteTexture>() == 28);

/// What skins vertices ahead of drawing.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3Preskin(pub u8);
impl Gles3Preskin {
    /// transform feedback, OpenGL ES 3.0
    pub const FEEDBACK: Self = Self(0);
    /// compute shader, 3.1
    pub const COMPUTE: Self = Self(1);
}

/// Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
/// positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them. Texture coordinates, colours
/// and indices are the mesh's, which must be there as long.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3SkinnedMesh {
    /// vertex array object
    pub array: u32,
    /// of the vertices
    pub buffer: u32,
    /// the mesh's
    pub slot_count: u32,
    /// kNormals, kTangents, kUvs, kColours: what programs with Deformer::none may read
    pub features: u8,
}
impl Default for Gles3SkinnedMesh {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_skinned_mesh_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3SkinnedMesh>() == 16);

/// Where vertices are skinned.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3SkinningPath(pub u8);
impl Gles3SkinningPath {
    /// vertex shader, every pass; palettes in a uniform block, a draw call a character
    pub const UBO: Self = Self(0);
    /// vertex shader, every pass; palettes in a texture, one draw call for all characters
    pub const TEXTURE: Self = Self(1);
    /// once a frame, by transform feedback
    pub const FEEDBACK: Self = Self(2);
    /// once a frame, by compute shader; OpenGL ES 3.1
    pub const COMPUTE: Self = Self(3);
    /// once a frame, by the CPU
    pub const CPU: Self = Self(4);
}

/// How many values SkinningPath has.
pub const GLES3_PATH_COUNT: u32 = 5;

/// The most roles of a ProgramSet.
pub const GLES3_MOST_ROLES: u32 = 4;

/// The most programs of a ProgramSet.
pub const GLES3_MOST_PROGRAMS: u32 = 192;

/// One of a set, filled in by Marrow.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3ProgramSetEntry {
    /// what it was built for
    pub key: Gles3ProgramKey,
    /// kMostRoles + Preskin: pre-skinning; and 2: blending of crowds
    pub role: u32,
    /// as it was built
    pub program: Gles3Program,
}
impl Default for Gles3ProgramSetEntry {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3ProgramSetEntry>() == 96);

/// The programs of a context: each role for each kind of mesh, compiled once. A game fills in the first five members.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3ProgramSet {
    /// Texts that live as long as the set. (GCC 12 takes no shorter initialiser.)
    pub roles: [Gles3ProgramSource; 4],
    /// of `roles`, that are used
    pub role_count: u32,
    /// Of what a mesh has, what each role's texts read: a shadow's none, or kUvs where it has holes. kMotion: whether they
    /// read previous_position of skinners and crowds that keep it.
    pub role_features: [u8; 4],
    /// uniform buffer binding of the palettes
    pub palette_binding: u32,
    /// what the driver says of a text that does not compile
    pub log: *mut c_char,
    pub log_bytes: usize,
    /// what was compiled
    pub entries: [Gles3ProgramSetEntry; 192],
    /// of entries
    pub count: u32,
}
impl Default for Gles3ProgramSet {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_program_set_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3ProgramSet>() == 18600);

/// How a mesh is skinned, and for how many characters.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3SkinnerOptions {
    /// choose() in gles3_self_test.h names the best
    pub path: Gles3SkinningPath,
    /// rigid, ssd, as or psd, which is ssd for a mesh without examples
    pub deformer: Gles3Deformer,
    /// characters, at most
    pub instances: u32,
    /// Palettes in a texture; morph targets take the next one, with `motion` palettes of the frame before the third.
    /// A pose space takes the fourth and fifth, with `motion` the sixth.
    pub texture_unit: u32,
    /// what programs are to read of what the mesh has and their role reads
    pub features: u8,
    /// From as_tangents() of this mesh, in the caller's memory for as long as the skinner; see PrepareOptions.
    pub as_tangents: *const f32,
    pub as_tangent_count: usize,
    /// For motion vectors: keeps what the update() before left on the GPU, and programs of roles that read kMotion have
    /// MarrowVertex::previous_position from it. The uniform buffer binding behind ProgramSet::palette_binding is taken,
    /// too. Nothing more goes up; what it costs: docs/performance.md, "Motion vectors".
    pub motion: bool,
}
impl Default for Gles3SkinnerOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_skinner_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3SkinnerOptions>() == 40);

/// What skinners with SkinnerOptions::motion keep of the update() before: two of each, which take turns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3SkinnerMotion {
    /// path ubo
    pub ring: Gles3PaletteRing,
    /// in the ring, a character each
    pub offsets: *mut u32,
    pub offset_count: usize,
    /// of paths that skin once a frame
    pub skinned: *mut Gles3SkinnedMesh,
    pub skinned_count: usize,
    /// of morph targets
    pub weights: *mut f32,
    pub weight_count: usize,
    /// of the last update()
    pub sent_weights: *mut f32,
    pub sent_weight_count: usize,
    /// a character each: 1 if it had no update() before its last
    pub still: *mut u8,
    pub still_count: usize,
    /// 1 if the next update() is to be its first
    pub reset: *mut u8,
    pub reset_count: usize,
}
impl Default for Gles3SkinnerMotion {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3SkinnerMotion>() == 112);

/// A mesh as many characters. Filled in by create_skinner(), to be read only.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3Skinner {
    /// as it was given
    pub mesh: Mesh,
    /// as they were given
    pub options: Gles3SkinnerOptions,
    /// its vertices on the GPU
    pub gpu: Gles3GpuMesh,
    /// path ubo, feedback and compute
    pub ring: Gles3PaletteRing,
    /// path texture
    pub texture: Gles3PaletteTexture,
    /// of pose spaces
    pub distance_texture: Gles3PaletteTexture,
    /// characters that the last update() brought up
    pub updated: u32,
    /// between on_context_lost() and on_context_restored()
    pub lost: bool,
    /// In the caller's memory.
    /// what palettes are built with
    pub bind: *mut Affine,
    pub bind_count: usize,
    /// characters after each other
    pub palettes: *mut Affine,
    pub palette_count: usize,
    /// of pose spaces, characters after each other; path cpu: one character's
    pub distances: *mut Affine,
    pub distance_count: usize,
    /// of morph targets, characters after each other
    pub weights: *mut f32,
    pub weight_count: usize,
    /// in the ring, a character each
    pub offsets: *mut u32,
    pub offset_count: usize,
    /// a character each, of paths that skin once a frame
    pub skinned: *mut Gles3SkinnedMesh,
    pub skinned_count: usize,
    /// with SkinnerOptions::motion
    pub motion: Gles3SkinnerMotion,
    /// path cpu: one character's
    pub positions: *mut f32,
    pub position_count: usize,
    /// path cpu: one character's
    pub normals: *mut f32,
    pub normal_count: usize,
    /// path cpu: one character's
    pub tangents: *mut f32,
    pub tangent_count: usize,
    /// path cpu: one character's
    pub coordinates: *mut f32,
    pub coordinate_count: usize,
    /// path cpu: one character's
    pub morphed: MorphedGeometry,
    /// of prepare(), kept for the next context
    pub scratch: *mut c_void,
    pub scratch_bytes: usize,
}
impl Default for Gles3Skinner {
    fn default() -> Self {
        unsafe { std::mem::zeroed() }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3Skinner>() == 1472);

/// Frames of one crowd: what fits the smallest textures, of meshes with one joint.
pub const GLES3_MAX_CROWD_FRAMES: u32 = 1048576;

/// Nothing to play.
pub const GLES3_NO_CROWD_CLIP: u32 = 4294967295;

/// Bytes of memory an instance for create_crowd().
pub const GLES3_CROWD_INSTANCE_BYTES: usize = 128;

/// What is baked, and how it ends.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdSource {
    /// not an additive one
    pub clip: Clip,
    /// its last pose is followed by its first; otherwise it stays in the last
    pub loops: bool,
}
impl Default for Gles3CrowdSource {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_source_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdSource>() == 160);

/// Where a clip's frames are: steps + 1 of them, at even steps of time; of one that loops the last is the first again.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdClip {
    /// of the clip
    pub duration_s: f32,
    /// of the crowd's frames
    pub first_frame: u32,
    /// 1 … 65535
    pub steps: u32,
    /// as its source's
    pub loops: bool,
}
impl Default for Gles3CrowdClip {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_clip_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdClip>() == 16);

/// Baked clips of one skeleton: a matrix each frame and joint, as local_to_model() writes them.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdFrames {
    /// in the order of their sources
    pub clips: *const Gles3CrowdClip,
    pub clip_count: usize,
    /// frame after frame
    pub character_from_joint: *const Affine,
    pub character_from_joint_count: usize,
    /// of the skeleton
    pub joint_count: u32,
    /// of all clips
    pub frame_count: u32,
}
impl Default for Gles3CrowdFrames {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_frames_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdFrames>() == 40);

/// At start_s of the crowd's clock the clip is at phase_s, before and afterwards wherever `speed` takes it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdPlay {
    /// of CrowdFrames::clips
    pub clip: u32,
    /// of a clip that does not loop within 0 … duration_s, else the nearer end
    pub phase_s: f32,
    /// seconds of the clip a second; may be negative
    pub speed: f32,
    /// seconds
    pub start_s: f64,
}
impl Default for Gles3CrowdPlay {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_play_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdPlay>() == 24);

/// One of a crowd. Any instance is exact up to 36 hours from each of its times; by then set it again, with later ones.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdInstance {
    /// where it stands
    pub scene_from_character: Affine,
    /// must have a clip
    pub a: Gles3CrowdPlay,
    /// kNoCrowdClip: a alone
    pub b: Gles3CrowdPlay,
    /// until then a alone
    pub blend_start_s: f64,
    /// and b alone so much later
    pub blend_s: f32,
    /// marrow_instance_colour() in the vertex shader
    pub colour: [f32; 4],
}
impl Default for Gles3CrowdInstance {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_instance_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdInstance>() == 128);

/// A mesh as crowds draw it: its palette in every frame (RGBA32F), and the palettes of the instances as they are now
/// (RGBA32UI, the bits of floats, for GLES 3.0 renders to no floats). A texel is a row of a matrix, a line 2048 texels.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3CrowdMesh {
    /// what draw() takes
    pub gpu: Gles3GpuMesh,
    /// palettes of all frames
    pub frames_texture: u32,
    /// palettes of the instances
    pub blended_texture: u32,
    /// around the blended texture
    pub framebuffer: u32,
    /// With motion alone: as they were in the frame before. begin_frame() has the two take turns.
    pub previous_texture: u32,
    /// around the previous texture
    pub previous_framebuffer: u32,
    /// matrices of a palette
    pub joints: u32,
    /// of its frames
    pub frame_count: u32,
    /// instances
    pub capacity: u32,
    /// as create_crowd_mesh() was asked
    pub motion: bool,
    /// between on_context_lost() and on_context_restored()
    pub lost: bool,
    /// What it is put on the next context from.
    pub mesh: Mesh,
    /// as they were given
    pub options: Gles3PrepareOptions,
    /// as they were given
    pub frames: Gles3CrowdFrames,
    /// what palettes are built with
    pub bind: *mut Affine,
    pub bind_count: usize,
    /// of prepare(), and of palettes on their way up
    pub scratch: *mut c_void,
    pub scratch_bytes: usize,
}
impl Default for Gles3CrowdMesh {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_mesh_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3CrowdMesh>() == 680);

/// Instances, in a texture: 128 B each, 256 a line. The caller's memory holds the same bytes for the next context.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3Crowd {
    /// of records
    pub texture: u32,
    /// instances, at most
    pub capacity: u32,
    /// that have been set
    pub count: u32,
    /// of the frames that they play
    pub frame_count: u32,
    /// between on_context_lost() and on_context_restored()
    pub lost: bool,
    /// as the texture has them
    pub records: *mut c_void,
    pub records_bytes: usize,
}
impl Default for Gles3Crowd {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_crowd_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3Crowd>() == 40);

/// What the self-test says of a path.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3Verdict(pub u8);
impl Gles3Verdict {
    pub const USABLE: Self = Self(0);
    /// not among SelfTestOptions::paths
    pub const NOT_TRIED: Self = Self(1);
    /// among SelfTestOptions::crashed
    pub const CRASHED: Self = Self(2);
    /// the caps rule it out
    pub const UNSUPPORTED: Self = Self(3);
    /// the driver refuses its programs or its buffers
    pub const REFUSED: Self = Self(4);
    /// GL reports an error while it skins
    pub const GL_ERROR: Self = Self(5);
    /// its vertices differ from the CPU's
    pub const WRONG: Self = Self(6);
    /// right, but SelfTestOptions::slow times slower than the fastest that skins on the GPU
    pub const SLOW: Self = Self(7);
}

/// How many values Verdict has.
pub const GLES3_VERDICT_COUNT: u32 = 8;

/// Chips that want another order of paths where nothing is timed, and other texts of shaders.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gles3GpuFamily(pub u8);
impl Gles3GpuFamily {
    pub const OTHER: Self = Self(0);
    /// Mali-G… and Immortalis: rows of a uniform block cost three times those of a texture, attributes are dear
    pub const MALI_G: Self = Self(1);
    /// Mali-T…: four numbers at a time; the paths as others
    pub const MALI_T: Self = Self(2);
    /// registers enough without branches; the paths as others
    pub const ADRENO: Self = Self(3);
    /// unpacking attributes is dear: a quarter to a third less for animation space as words; the paths as others
    pub const NVIDIA: Self = Self(4);
}

/// How many values GpuFamily has.
pub const GLES3_GPU_FAMILY_COUNT: u32 = 5;

/// The most that PathResult::position_error may be, metres.
pub const GLES3_MOST_POSITION_ERROR: f32 = 0.001;

/// The most that PathResult::normal_error may be.
pub const GLES3_MOST_NORMAL_ERROR: f32 = 0.005;

/// All paths, as bits.
pub const GLES3_ALL_PATHS: u32 = 31;

/// From so many characters on choose() prefers palettes in a texture.
pub const GLES3_MANY_CHARACTERS: u32 = 8;

/// A result as bytes that a game stores. Errors: bad_argument (too short).
pub const GLES3_SAVED_SELF_TEST_BYTES: usize = 128;

pub type Gles3Clock = Option<unsafe extern "C" fn(user: *mut c_void) -> f64>;

pub type Gles3AboutToTry = Option<unsafe extern "C" fn(user: *mut c_void, path: Gles3SkinningPath)>;

/// What one path did.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3PathResult {
    /// whether to use it
    pub verdict: Gles3Verdict,
    /// The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin;
    /// and of unit normals and tangents. Quantised vertices differ by some 0.0001 and 0.0002. Above
    /// kMostPositionError and kMostNormalError the path is wrong: numbers of 16 bits are off by more. Never NaN.
    pub position_error: f32,
    /// of normals and tangents
    pub normal_error: f32,
    /// to skin and draw once; 0: not timed
    pub ns_per_vertex: f32,
    /// a vertex, of each pass that draws it again
    pub ns_per_pass: f32,
}
impl Default for Gles3PathResult {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_path_result_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3PathResult>() == 20);

/// What self_test() found.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3SelfTest {
    /// by SkinningPath
    pub paths: [Gles3PathResult; 5],
    /// by GL_RENDERER
    pub family: Gles3GpuFamily,
    /// of driver, caps, options and this library's shader texts
    pub key: u64,
}
impl Default for Gles3SelfTest {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_self_test_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3SelfTest>() == 112);

/// What is tried, and how it is timed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3SelfTestOptions {
    /// bit_of() of those to try
    pub paths: u32,
    /// Paths during which the process came to its end: they are not tried again. See about_to_try.
    pub crashed: u32,
    /// the deformers that the game uses
    pub ssd: bool,
    /// animation space
    pub r#as: bool,
    /// Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
    pub seconds: Gles3Clock,
    /// times the fastest path's time
    pub slow: f32,
    /// What is timed: characters of a mesh of so many vertices, of up to four influences, by SSD if `ssd`. State what the
    /// game draws most of. 16 … 65 520 vertices, of which a multiple of 16 is taken; 1 … 256 characters.
    pub timed_vertices: u32,
    /// of that mesh
    pub timed_characters: u32,
    /// Called before a path is tried. A game that wants to outlive a driver that crashes stores which, durably, and
    /// forgets it once self_test() has returned. What it finds stored at its next start goes into `crashed`, together
    /// with what has been there before.
    /// what the two functions above get
    pub about_to_try: Gles3AboutToTry,
    /// Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
    pub user: *mut c_void,
}
impl Default for Gles3SelfTestOptions {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_self_test_options_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3SelfTestOptions>() == 56);

/// What a mesh is to be drawn for.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gles3PathNeed {
    /// that draw it in a frame: colour, depth, shadows
    pub passes: u32,
    /// in one Skinner
    pub characters: u32,
    /// Mesh::palette_size()
    pub joints: u32,
}
impl Default for Gles3PathNeed {
    fn default() -> Self {
        unsafe {
            let mut new: Self = std::mem::zeroed();
            gles3_path_need_init(&mut new);
            new
        }
    }
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(std::mem::size_of::<Gles3PathNeed>() == 12);

extern "C" {
    #[link_name = "mrw_abi"]
    pub fn abi() -> u32;
    #[link_name = "mrw_gles3_abi"]
    pub fn gles3_abi() -> u32;
    #[link_name = "mrw_data_error_init"]
    pub fn data_error_init(out: *mut DataError);
    /// One word or two in English, never null.
    #[link_name = "mrw_status_text"]
    pub fn status_text(status: Status) -> *const c_char;
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
    #[link_name = "mrw_set_call_error_handler"]
    pub fn set_call_error_handler(handler: CallErrorHandler) -> CallErrorHandler;
    /// The handler of now; null: nobody is told. Thread-safe.
    #[link_name = "mrw_get_call_error_handler"]
    pub fn get_call_error_handler() -> CallErrorHandler;
    /// How many bytes of any alignment hold a block of `bytes`.
    #[link_name = "mrw_block_bytes"]
    pub fn block_bytes(bytes: usize) -> usize;
    /// Whether a block may begin there.
    #[link_name = "mrw_is_on_boundary"]
    pub fn is_on_boundary(first: *const c_void) -> bool;
    /// What lies behind the first boundary in `memory`; empty if there is none.
    #[link_name = "mrw_block_in"]
    pub fn block_in(memory: *mut c_void, memory_bytes: usize, out: *mut Block) -> Status;
    #[link_name = "mrw_bytes_init"]
    pub fn bytes_init(out: *mut Bytes);
    /// Whether these are the first bytes of a packed file. Anything else is for load() to judge.
    #[link_name = "mrw_is_packed"]
    pub fn is_packed(bytes: *const c_void, byte_count: usize) -> bool;
    /// How much memory unpacking takes: what the records need by their counts, and bad_data if the header claims anything
    /// else, or a clip or bounds more than their bytes can hold. A mesh's counts are the file's claim, which a codec's few
    /// bytes may bear out, so whoever reads files of strangers should set a limit. Errors: bad_magic, bad_version,
    /// bad_checksum, truncated, bad_data. Cost: the checksum.
    /// May be null: error.
    #[link_name = "mrw_find_unpack_sizes"]
    pub fn find_unpack_sizes(packed: *const c_void, packed_bytes: usize, out: *mut UnpackSizes, error: *mut DataError) -> Status;
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
    #[link_name = "mrw_unpack"]
    pub fn unpack(packed: *const c_void, packed_bytes: usize, decoders: *const MeshDecoder, decoder_count: usize, memory: *mut c_void, memory_bytes: usize, file: *mut Bytes, error: *mut DataError) -> Status;
    #[link_name = "mrw_unpacking_init"]
    pub fn unpacking_init(out: *mut Unpacking);
    /// Checks the header and the records' counts. Errors: as unpack_sizes(), and bad_argument; then nothing is begun.
    /// Cost: the checksum.
    /// May be null: error.
    #[link_name = "mrw_begin_unpack"]
    pub fn begin_unpack(packed: *const c_void, packed_bytes: usize, decoders: *const MeshDecoder, decoder_count: usize, memory: *mut c_void, memory_bytes: usize, out: *mut Unpacking, error: *mut DataError) -> Status;
    /// Goes on with one record, or with one of a mesh's stages: decoding, where animation space has a residual smoothing it
    /// and decoding that, ordering and writing; then with the file's checksum. A step stops when it has done so much, a few
    /// milliseconds whatever the file holds, and the next one goes on there; but for what a codec's library does in one call.
    /// meshoptimizer's decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them. Draco's
    /// decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
    ///
    /// Errors: as unpack(); nothing is in work afterwards. bad_argument: nothing is in work. May run on any thread, on one
    /// at a time.
    /// May be null: error.
    #[link_name = "mrw_unpack_step"]
    pub fn unpack_step(unpacking: *mut Unpacking, error: *mut DataError) -> Status;
    /// For unpack(). Draco allocates while it decodes and frees all of it again.
    #[link_name = "mrw_draco_decoder"]
    pub fn draco_decoder(out: *mut MeshDecoder) -> Status;
    /// For unpack(). Allocates nothing.
    #[link_name = "mrw_meshopt_decoder"]
    pub fn meshopt_decoder(out: *mut MeshDecoder) -> Status;
    #[link_name = "mrw_joint_transform_init"]
    pub fn joint_transform_init(out: *mut JointTransform);
    /// How many SoaTransforms hold a pose of `joint_count` joints.
    #[link_name = "mrw_soa_count"]
    pub fn soa_count(joint_count: usize) -> usize;
    /// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
    /// is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
    #[link_name = "mrw_get_joint"]
    pub fn get_joint(local: *const SoaTransform, local_count: usize, joint: u32, out: *mut JointTransform) -> Status;
    /// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
    /// is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
    #[link_name = "mrw_set_joint"]
    pub fn set_joint(local: *mut SoaTransform, local_count: usize, joint: u32, transform: *const JointTransform) -> Status;
    #[link_name = "mrw_rate_limit_init"]
    pub fn rate_limit_init(out: *mut RateLimit);
    #[link_name = "mrw_joint_limit_init"]
    pub fn joint_limit_init(out: *mut JointLimit);
    #[link_name = "mrw_spring_joint_init"]
    pub fn spring_joint_init(out: *mut SpringJoint);
    #[link_name = "mrw_spring_chain_init"]
    pub fn spring_chain_init(out: *mut SpringChain);
    #[link_name = "mrw_spring_collider_init"]
    pub fn spring_collider_init(out: *mut SpringCollider);
    #[link_name = "mrw_helper_init"]
    pub fn helper_init(out: *mut Helper);
    /// Whether a limit keeps these rules, as those of make_limit() and load() do.
    #[link_name = "mrw_is_valid"]
    pub fn is_valid(limit: *const JointLimit) -> bool;
    #[link_name = "mrw_file_init"]
    pub fn file_init(out: *mut File);
    /// Validates a cooked file (docs/format.md) and makes `out` a view of it.
    ///
    /// The block must be 16-byte aligned (bad_argument otherwise; block.h helps) and may come from anywhere: nothing is
    /// read outside it, whatever it holds, and after `ok` nothing that it holds can make another stage read or write out of
    /// bounds. Numbers of matrices, translations and scales are at most 1e12, and rotations units, so that the product of
    /// what is above a root, a joint and an inverse bind is finite; those of long chains of huge scales need not be. Names
    /// are at most 2047 bytes. `out` is written only on success. `error`, if not null, gets the place and the broken rule on
    /// failure. Cost: one pass over the block; no allocation. Thread-safe.
    /// May be null: error.
    #[link_name = "mrw_load"]
    pub fn load(block: *const c_void, block_bytes: usize, out: *mut File, error: *mut DataError) -> Status;
    /// How many of each there are.
    #[link_name = "mrw_file_skeleton_count"]
    pub fn file_skeleton_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_reference_count"]
    pub fn file_reference_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_clip_count"]
    pub fn file_clip_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_mesh_count"]
    pub fn file_mesh_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_material_count"]
    pub fn file_material_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_image_count"]
    pub fn file_image_count(file: *const File) -> u32;
    /// How many of each there are.
    #[link_name = "mrw_file_node_count"]
    pub fn file_node_count(file: *const File) -> u32;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_skeleton"]
    pub fn file_skeleton(file: *const File, index: u32, out: *mut Skeleton) -> Status;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_reference"]
    pub fn file_reference(file: *const File, index: u32, out: *mut SkeletonReference) -> Status;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_clip"]
    pub fn file_clip(file: *const File, index: u32, out: *mut Clip) -> Status;
    /// level: of detail, 0 in full; beyond the mesh's last it is its last. All levels share one palette.
    #[link_name = "mrw_file_mesh"]
    pub fn file_mesh(file: *const File, index: u32, level: u32, out: *mut Mesh) -> Status;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_material"]
    pub fn file_material(file: *const File, index: u32, out: *mut Material) -> Status;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_image"]
    pub fn file_image(file: *const File, index: u32, out: *mut Image) -> Status;
    /// An index that is not below the count gives what is empty. Cost: a few loads.
    #[link_name = "mrw_file_node"]
    pub fn file_node(file: *const File, index: u32, out: *mut Node) -> Status;
    /// About all that the mesh's vertices do while the clip plays from its rest pose, at every level of detail, by every
    /// deformer that it was cooked for. Empty if the clip does not move the mesh's skeleton, and in files without bounds.
    /// Codes of 8 bits, rounded outwards: a face may be 1/64 of the box's farthest coordinate beyond the vertices. A clip
    /// pack has none: palette_bounds() in bounds.h. Cost: a look at every clip and mesh; once a load.
    #[link_name = "mrw_file_bounds"]
    pub fn file_bounds(file: *const File, clip: u32, mesh: u32, out: *mut Bounds) -> Status;
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    #[link_name = "mrw_file_spring_count"]
    pub fn file_spring_count(file: *const File, skeleton: u32) -> u32;
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    #[link_name = "mrw_file_spring"]
    pub fn file_spring(file: *const File, skeleton: u32, index: u32, out: *mut SpringChain) -> Status;
    /// Spring bones that the asset came with, of one of the skeletons: chains for make_springs(), and SpringFrame's
    /// colliders. Their settings are the asset's; a game may change a copy. Cost: a look at every section of springs.
    #[link_name = "mrw_file_spring_colliders"]
    pub fn file_spring_colliders(file: *const File, skeleton: u32, out: *mut SpringColliderList) -> Status;
    /// Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
    /// holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
    /// with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
    #[link_name = "mrw_file_example_space_count"]
    pub fn file_example_space_count(file: *const File) -> u32;
    /// Spaces of example shapes, see example_space.h. load() knows where they stand, example_space() looks at all that one
    /// holds; spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported,
    /// with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
    /// May be null: error.
    #[link_name = "mrw_file_example_space"]
    pub fn file_example_space(file: *const File, index: u32, out: *mut ExampleSpace, error: *mut DataError) -> Status;
    /// Index of the first skeleton with this name, or skeleton_count(). Here and below a null pointer names nothing.
    #[link_name = "mrw_file_find_skeleton"]
    pub fn file_find_skeleton(file: *const File, name: *const c_char) -> u32;
    /// The first joint of `skeleton`, a skeleton of this file, with this name, or skeleton.joint_count. Once a load, not a
    /// frame.
    #[link_name = "mrw_file_find_joint"]
    pub fn file_find_joint(file: *const File, skeleton: *const Skeleton, name: *const c_char) -> u32;
    /// Index of the first mesh with this name, or mesh_count(). A mesh of several materials is one a material, all of the
    /// same name.
    #[link_name = "mrw_file_find_mesh"]
    pub fn file_find_mesh(file: *const File, name: *const c_char) -> u32;
    /// Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
    /// of several skeletons is a clip each, with the same name and duration.
    #[link_name = "mrw_file_find_clip"]
    pub fn file_find_clip(file: *const File, name: *const c_char) -> u32;
    /// Index of the first clip with this name, or clip_count(); the second of those that move one skeleton. An animation
    /// of several skeletons is a clip each, with the same name and duration.
    #[link_name = "mrw_file_find_clip_of"]
    pub fn file_find_clip_of(file: *const File, name: *const c_char, skeleton: u32) -> u32;
    /// Index of the first channel of `clip`, a clip of this file, with this name, or clip.channels.size. Once a load, not
    /// a frame.
    #[link_name = "mrw_file_find_channel"]
    pub fn file_find_channel(file: *const File, clip: *const Clip, name: *const c_char) -> u32;
    /// Index of the first node with this name, or node_count().
    #[link_name = "mrw_file_find_node"]
    pub fn file_find_node(file: *const File, name: *const c_char) -> u32;
    /// The property of `node`, a node of this file, with this name; null if there is none.
    #[link_name = "mrw_file_node_property"]
    pub fn file_node_property(file: *const File, node: *const Node, name: *const c_char) -> *const Property;
    /// A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
    /// zero-terminated, never null.
    #[link_name = "mrw_file_text"]
    pub fn file_text(file: *const File, name: u32) -> *const c_char;
    /// A name by its number (Skeleton::names, Channel::name, Property::name); empty for what is none. UTF-8,
    /// zero-terminated, never null.
    #[link_name = "mrw_property_text"]
    pub fn property_text(property: *const Property) -> u32;
    /// How many groups of four joints a local pose has.
    #[link_name = "mrw_skeleton_soa_size"]
    pub fn skeleton_soa_size(skeleton: *const Skeleton) -> usize;
    /// How many matrices build_palette() writes.
    #[link_name = "mrw_mesh_palette_size"]
    pub fn mesh_palette_size(mesh: *const Mesh) -> u32;
    /// Whether nothing is known or in it.
    #[link_name = "mrw_bounds_is_empty"]
    pub fn bounds_is_empty(bounds: *const Bounds) -> bool;
    /// A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
    /// Of a skeleton that is not there it is the hash of no joints. Cost: one pass over the skeleton.
    #[link_name = "mrw_skeleton_hash"]
    pub fn skeleton_hash(file: *const File, skeleton: u32) -> u64;
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
    #[link_name = "mrw_bind_clips"]
    pub fn bind_clips(pack: *const File, reference: u32, character: *const File, skeleton: u32, misfits: *mut JointMisfit, misfit_count: usize, misfits_there: *mut usize) -> Status;
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
    #[link_name = "mrw_bind_outfit"]
    pub fn bind_outfit(outfit: *const File, skeleton: u32, body: *const File, body_skeleton: u32, body_joints: *mut u16, body_joint_count: usize, misfits: *mut JointMisfit, misfit_count: usize, misfits_there: *mut usize) -> Status;
    /// The outfit's scene-space joints in the body's pose: joints of the body are copied, the outfit's own stand at `local`
    /// below their parents. Poses are the same bits as if local_to_model() had posed them all.
    ///
    /// skeleton: the outfit's. body_joints: as bind_outfit() gives it. local: at least skeleton.soa_size(), of which joints
    /// of the body are not read. scene_from_joint: at least skeleton.joint_count; does not overlap the body's.
    /// Errors: bad_argument if a span is too short, a joint out of range, or a root none of the body's.
    /// Cost: 48 bytes are copied a joint of the body; the others cost what local_to_model() does. Where body_joints[j] is
    /// always j, build_palette() and gles3::pose() may as well take the body's joints themselves, without a copy.
    /// Thread-safe on different outputs.
    #[link_name = "mrw_follow_body"]
    pub fn follow_body(skeleton: *const Skeleton, body_joints: *const u16, body_joint_count: usize, body_scene_from_joint: *const Affine, body_scene_from_joint_count: usize, local: *const SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize) -> Status;
    #[link_name = "mrw_playback_init"]
    pub fn playback_init(out: *mut Playback);
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
    #[link_name = "mrw_advance"]
    pub fn advance(playback: *mut Playback, duration_s: f32, dt_s: f32) -> Status;
    /// The time to sample: time_s as a float, which never goes beyond the clip.
    #[link_name = "mrw_clip_time"]
    pub fn clip_time(playback: *const Playback) -> f32;
    /// Whether a clip that plays once has reached the end towards which it runs; it stays true then. A clip at speed 0 runs
    /// towards none.
    #[link_name = "mrw_finished"]
    pub fn finished(playback: *const Playback, duration_s: f32) -> bool;
    #[link_name = "mrw_sample_options_init"]
    pub fn sample_options_init(out: *mut SampleOptions);
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
    #[link_name = "mrw_sample"]
    pub fn sample(skeleton: *const Skeleton, clip: *const Clip, time_s: f32, out: *mut SoaTransform, out_count: usize, options: *const SampleOptions) -> Status;
    #[link_name = "mrw_sample_cache_init"]
    pub fn sample_cache_init(out: *mut SampleCache);
    /// Bytes of SampleCache::memory for this clip: 160 for each four joints that turn, move or change their size, once for
    /// each of the three.
    #[link_name = "mrw_sample_cache_bytes"]
    pub fn sample_cache_bytes(clip: *const Clip) -> usize;
    /// sample() of all joints for an instance that plays on: writes the same bits, and leaves out what the call before with
    /// this cache did already. That another clip, skeleton or `out` was given than in that call is found by itself: a clip
    /// of a File by Clip::id, one that is made by hand by where its tracks lie.
    ///
    /// out: as of sample(), and nobody else writes to it as long as the cache is in use, not to joints that move either:
    /// what rests between two frames is not written again. For a pose that is changed afterwards copy it, or let blend()
    /// read it. cache: one for each `out`; `= {memory}` forgets, as is needed if `out` was written by others. Errors: as
    /// sample(), and bad_argument if the cache's memory is not on a boundary of 16 bytes; then it forgets nothing. Cost: in
    /// the worst case that of sample() and a copy of the frames; playing at 60 Hz over keys at 30 Hz about half.
    #[link_name = "mrw_sample_cached"]
    pub fn sample_cached(skeleton: *const Skeleton, clip: *const Clip, time_s: f32, out: *mut SoaTransform, out_count: usize, cache: *mut SampleCache) -> Status;
    /// Evaluates a clip cooked as additive (`marrow cook --additive`): out = what turns its reference pose into the pose
    /// that sample() would give of an ordinary clip, for add(). Laid on the reference with weight 1 it gives that pose,
    /// within the cooker's --clip-error; joints that the clip leaves alone do not change, where the reference is the rest
    /// pose in them.
    ///
    /// out: at least skeleton.soa_size() elements, caller's memory. Errors: as sample(), and bad_argument if the clip is not
    /// additive. Cost: sample() and make_additive(). Stateless; thread-safe on different outputs.
    #[link_name = "mrw_sample_additive"]
    pub fn sample_additive(skeleton: *const Skeleton, clip: *const Clip, time_s: f32, out: *mut AdditiveTransform, out_count: usize) -> Status;
    /// Evaluates the clip's channels at `time_s` as above: out[i] is the value of clip.channels[i].
    ///
    /// out: at least clip.channels.size floats. Which channel is which: File::find_channel; numbers that the clip does not
    /// drive have no channel, and keep what the game gives them. An additive clip's channels are values all the same, no
    /// changes. Errors: bad_argument if `out` is too short or time_s is not
    /// a number. Cost: a binary search a distinct key-time list and a few operations a channel.
    #[link_name = "mrw_sample_channels"]
    pub fn sample_channels(clip: *const Clip, time_s: f32, out: *mut f32, out_count: usize) -> Status;
    #[link_name = "mrw_curve_init"]
    pub fn curve_init(out: *mut Curve);
    #[link_name = "mrw_arc_length_init"]
    pub fn arc_length_init(out: *mut ArcLength);
    #[link_name = "mrw_cubic_bezier_ease_init"]
    pub fn cubic_bezier_ease_init(out: *mut CubicBezierEase);
    /// How many floats `key_count` keys of `components` hold.
    #[link_name = "mrw_curve_value_count"]
    pub fn curve_value_count(kind: CurveKind, components: u32, key_count: usize) -> usize;
    /// Whether a curve keeps the rules above: call it once for keys that come from outside. Errors: bad_argument if `kind`
    /// is unknown, there is no key, components is not 1 … 4 (4 for rotations) or values are missing; bad_data if times do
    /// not increase strictly, a number is not finite, a value or control point beyond 1e18, or a tangent over the longest
    /// interval, or a rotation key's squared length is off 1 by more than 1e-3. Cost: once over the keys.
    #[link_name = "mrw_check_curve"]
    pub fn check_curve(curve: *const Curve) -> Status;
    /// The value at `time_s`, clamped to the first and last key; one key is a constant.
    ///
    /// out: at least curve.components floats. Errors: bad_argument as in check_curve(), if `out` is too short, or time_s is
    /// not a number. Keys that check_curve() refuses with bad_data are safe but give garbage; of others values are finite.
    /// At a key's time the value is exactly the key's (rotations: but for normalisation and sign). Cost: a binary search and
    /// some dozen operations.
    #[link_name = "mrw_evaluate_curve"]
    pub fn evaluate_curve(curve: *const Curve, time_s: f32, out: *mut f32, out_count: usize) -> Status;
    /// The derivative of evaluate_curve() by time, a second. At an inner key: of what follows; before the first and after
    /// the last key: 0. Arguments, errors and cost as there; also unsupported for rotations, and
    /// bad_data, with nothing written, if it is not finite, as keys are so far apart in so little time.
    #[link_name = "mrw_curve_velocity"]
    pub fn curve_velocity(curve: *const Curve, time_s: f32, out: *mut f32, out_count: usize) -> Status;
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
    #[link_name = "mrw_natural_spline"]
    pub fn natural_spline(keys: *const Curve, out: *mut f32, out_count: usize) -> Status;
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
    #[link_name = "mrw_clamped_spline"]
    pub fn clamped_spline(keys: *const Curve, first_velocity: *const f32, first_velocity_count: usize, last_velocity: *const f32, last_velocity_count: usize, out: *mut f32, out_count: usize) -> Status;
    /// A Bézier curve of any degree at u, by de Casteljau's algorithm.
    ///
    /// points: degree + 1 points of `components` floats (1 … 4). scratch: at least points.size floats, overlapping nothing.
    /// out: at least `components`. u outside [0, 1] extrapolates. Errors: bad_argument if there is no point, points.size is
    /// no multiple of components, a span is too short, or u is not finite; bad_data if the result is not finite.
    /// Cost: degree · (degree + 1) / 2 interpolations.
    #[link_name = "mrw_bezier"]
    pub fn bezier(points: *const f32, point_count: usize, components: u32, u: f32, scratch: *mut f32, scratch_count: usize, out: *mut f32, out_count: usize) -> Status;
    /// The same for unit quaternions, each taken with the sign nearer to the one before; normalised. bad_data also if the
    /// result has no direction, or is too long to be squared.
    #[link_name = "mrw_bezier_rotation"]
    pub fn bezier_rotation(quaternions: *const f32, quaternion_count: usize, u: f32, scratch: *mut f32, scratch_count: usize, out: *mut f32, out_count: usize) -> Status;
    /// A bicubic patch over 4 × 4 points: the tensor product of two cubics.
    ///
    /// points: 16 · components floats, component by component within a point, points along u first, then v. out: at least
    /// `components` (1 … 4). Errors: bad_argument if a span is too short, the basis is unknown, or u or v is not finite;
    /// bad_data, with nothing written, if the result is not finite.
    /// Cost: 20 blends of four points.
    #[link_name = "mrw_bicubic_patch"]
    pub fn bicubic_patch(basis: PatchBasis, points: *const f32, point_count: usize, components: u32, u: f32, v: f32, out: *mut f32, out_count: usize) -> Status;
    /// How many floats the table of a curve has.
    #[link_name = "mrw_arc_length_count"]
    pub fn arc_length_count(key_count: usize, steps: u32) -> usize;
    /// Measures `curve` once. out: arc_length_count() floats; the last is the length of all, in the unit of the values.
    /// Errors: as evaluate_curve(); unsupported for rotations (slerp is even as it is) and for kind step; bad_argument if
    /// `steps` is 0 or `out` too short; bad_data if a length is not finite. Three-point Gauss quadrature a step: exact for
    /// linear, and else of the order steps⁻⁶ where the path does not stop inside a step. Cost: 3 square roots a step.
    #[link_name = "mrw_build_arc_length"]
    pub fn build_arc_length(curve: *const Curve, steps: u32, out: *mut f32, out_count: usize) -> Status;
    /// The time at which `curve` has gone `distance`, clamped to the path; where the path rests, the end of the rest.
    /// Between two entries the length is taken as linear, so the point found is off along the path by at most
    /// A / (8 steps²), A being the largest second derivative by u in that key interval, plus rounding: twice the steps,
    /// a quarter of the error. Errors: bad_argument if the table is too short for this curve or `distance` is not a number.
    /// Cost: a binary search.
    #[link_name = "mrw_time_at_distance"]
    pub fn time_at_distance(curve: *const Curve, table: *const ArcLength, distance: f32, time_s: *mut f32) -> Status;
    /// From 0 at u = 0 to 1 at u = 1, both exactly; u is clamped, and what is not a number counts as 0. back and elastic
    /// overshoot. out(u) = 1 - in(1 - u), in_out is the one, then the other at half size. As in Penner's, expo and elastic
    /// leave 0 (out: reach 1) with a jump of 1e-3 or less; back's overshoot is 1.70158, 1.525 times that for in_out;
    /// elastic's period is 0.3, 0.45 for in_out. Within 1e-6 of the closed forms. Unknown enumerators: linear.
    #[link_name = "mrw_ease"]
    pub fn ease(easing: Easing, mode: EaseMode, u: f32) -> f32;
    /// y at x = u, with u clamped to [0, 1]. The point lies on the curve within 3e-7 in x (4e-7 (1 + |y1| + |y2|) in y):
    /// where the curve is steep, y is as uncertain as x is. Errors: bad_argument unless x1 and x2 are in [0, 1], y1 and y2
    /// finite and u a number. Newton's method within a shrinking bracket. Cost: about 5 steps, at most 40.
    #[link_name = "mrw_ease_by_curve"]
    pub fn ease_by_curve(curve: *const CubicBezierEase, u: f32, out: *mut f32) -> Status;
    #[link_name = "mrw_blend_layer_init"]
    pub fn blend_layer_init(out: *mut BlendLayer);
    #[link_name = "mrw_additive_layer_init"]
    pub fn additive_layer_init(out: *mut AdditiveLayer);
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
    #[link_name = "mrw_blend"]
    pub fn blend(skeleton: *const Skeleton, layers: *const BlendLayer, layer_count: usize, out: *mut SoaTransform, out_count: usize, threshold: f32) -> Status;
    /// Replaces a part of `pose`: goes from pose to layer.pose by w = weight · mask, on the shorter arc. Where w is 0 the
    /// pose keeps its bits, where it is 1 it gets the layer's bits, whatever the other joints do.
    /// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
    #[link_name = "mrw_overlay"]
    pub fn overlay(skeleton: *const Skeleton, layer: *const BlendLayer, pose: *mut SoaTransform, pose_count: usize) -> Status;
    /// out = what turns `reference` into `pose`: differences of translations, pose · reference⁻¹ of rotations, ratios of
    /// scales (1 where the reference is less than 1e-20). Rotations must be unit quaternions. Clips cooked as additive hold
    /// their reference and yield changes by themselves: sample_additive(). Errors: bad_argument if a span is too short.
    #[link_name = "mrw_make_additive"]
    pub fn make_additive(skeleton: *const Skeleton, pose: *const SoaTransform, pose_count: usize, reference: *const SoaTransform, reference_count: usize, out: *mut AdditiveTransform, out_count: usize) -> Status;
    /// Lays w = weight · mask of a change on `pose`: translation + w Δ; rotation multiplied from the left by the normalised
    /// mean of identity and change; scale · (1 + w (ratio - 1)). Where w is 0 the pose keeps its bits.
    /// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
    #[link_name = "mrw_add"]
    pub fn add(skeleton: *const Skeleton, layer: *const AdditiveLayer, pose: *mut SoaTransform, pose_count: usize) -> Status;
    #[link_name = "mrw_inertia_init"]
    pub fn inertia_init(out: *mut Inertia);
    #[link_name = "mrw_inertial_start_init"]
    pub fn inertial_start_init(out: *mut InertialStart);
    /// The new clip's weight, `time_s` after the fade began: exactly 0 at or before 0 and for what is not a number, exactly
    /// 1 from duration_s on (at once if that is not above 0).
    #[link_name = "mrw_fade_weight"]
    pub fn fade_weight(shape: Fade, time_s: f32, duration_s: f32) -> f32;
    /// blend() of two poses: from at weight 0, to at weight 1, both bit for bit.
    /// from, to, out: at least skeleton.soa_size(); out may be either of the poses.
    /// Errors: bad_argument if a span is too short or the weight not in 0 … 1.
    #[link_name = "mrw_cross_fade"]
    pub fn cross_fade(skeleton: *const Skeleton, from: *const SoaTransform, from_count: usize, to: *const SoaTransform, to_count: usize, weight: f32, out: *mut SoaTransform, out_count: usize) -> Status;
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
    #[link_name = "mrw_begin_inertia"]
    pub fn begin_inertia(skeleton: *const Skeleton, start: *const InertialStart, duration_s: f32, inertia: *mut Inertia) -> Status;
    /// pose: in, the new clip's pose `time_s` after the beginning; out, what is to be shown. From duration_s on, and before
    /// any begin_inertia(), the pose keeps its bits. Times below 0 count as 0.
    /// Errors: bad_argument if a span is too short or time_s not a number.
    /// Cost: nine quintics and one exponential a joint, four joints at a time.
    #[link_name = "mrw_apply_inertia"]
    pub fn apply_inertia(skeleton: *const Skeleton, inertia: *const Inertia, time_s: f32, pose: *mut SoaTransform, pose_count: usize) -> Status;
    /// scene_from_joint = scene_from_root · Π parent_from_joint, from the root down; scene_from_root is what the source has
    /// above the skeleton and never moves, so the matrices are in the source's scene space.
    ///
    /// local: at least skeleton.soa_size(); out: at least skeleton.joint_count; they do not overlap.
    /// Errors: bad_argument if a span is too short.
    /// Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint: 70 instructions on x86-64, 49
    /// on AArch64. Thread-safe on different outputs.
    #[link_name = "mrw_local_to_model"]
    pub fn local_to_model(skeleton: *const Skeleton, local: *const SoaTransform, local_count: usize, out: *mut Affine, out_count: usize) -> Status;
    /// The same for the first `joint_count` joints only, to the same bits: a level of detail. Joints are breadth-first, so
    /// whatever the count, parents are among them. The others' matrices are left as they are.
    ///
    /// local: at least soa_count(joint_count); out: at least joint_count. Errors: bad_argument also if there are fewer
    /// joints.
    #[link_name = "mrw_local_to_model_first"]
    pub fn local_to_model_first(skeleton: *const Skeleton, local: *const SoaTransform, local_count: usize, joint_count: u32, out: *mut Affine, out_count: usize) -> Status;
    /// The same for `joint` and all that hangs below it only, after a change of their local transforms: by inverse
    /// kinematics, say. `out` holds the matrices of the whole skeleton; all others keep their bits.
    ///
    /// local: at least skeleton.soa_size(); out: at least skeleton.joint_count. Errors: bad_argument also if there is no
    /// such joint. Cost: what local_to_model does for these joints, groups that a generation of them cuts as whole ones, and
    /// one comparison for each other joint from `joint` to the last generation.
    #[link_name = "mrw_local_to_model_below"]
    pub fn local_to_model_below(skeleton: *const Skeleton, local: *const SoaTransform, local_count: usize, joint: u32, out: *mut Affine, out_count: usize) -> Status;
    #[link_name = "mrw_limit_description_init"]
    pub fn limit_description_init(out: *mut LimitDescription);
    #[link_name = "mrw_rotation_follower_init"]
    pub fn rotation_follower_init(out: *mut RotationFollower);
    #[link_name = "mrw_point_follower_init"]
    pub fn point_follower_init(out: *mut PointFollower);
    /// Angles least_rad … most_rad; all of them if that is a turn or more.
    /// Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
    #[link_name = "mrw_make_angle_range"]
    pub fn make_angle_range(least_rad: f32, most_rad: f32, out: *mut AngleRange) -> Status;
    /// `out` is written only on success.
    /// Errors: bad_argument if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least is
    /// above most, an angle is beyond ±2π, a swing not in 0 … kWidestSwing_rad or not symmetric, the second angle of an
    /// euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is none of the above.
    #[link_name = "mrw_make_limit"]
    pub fn make_limit(description: *const LimitDescription, joint: u16, out: *mut JointLimit) -> Status;
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
    #[link_name = "mrw_clamp_rotation"]
    pub fn clamp_rotation(limit: *const JointLimit, local: *mut [f32; 4]) -> Status;
    /// By how many radians clamp_rotation() would turn the rotation; 0 for what keeps its bits, and for what it refuses.
    #[link_name = "mrw_limit_excess"]
    pub fn limit_excess(limit: *const JointLimit, local: *const [f32; 4]) -> f32;
    /// clamp_rotation() for each limit's joint; all other joints keep their bits, and so do rotations that are not finite.
    /// local: of a skeleton that has all the joints. Errors: bad_argument if it has not; nothing is written.
    /// Cost: clamp_rotation() a limit. Thread-safe on different poses.
    #[link_name = "mrw_limit_pose"]
    pub fn limit_pose(limits: *const JointLimit, limit_count: usize, local: *mut SoaTransform, local_count: usize) -> Status;
    /// The limit of a joint, or null. Precondition: the limits' joints ascend, as in a Skeleton. Cost: a binary search.
    #[link_name = "mrw_find_limit"]
    pub fn find_limit(limits: *const JointLimit, limit_count: usize, joint: u32) -> *const JointLimit;
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
    #[link_name = "mrw_follow_rotation"]
    pub fn follow_rotation(state: *mut RotationFollower, target: *const [f32; 4], dt_s: f32, limit: *const RateLimit) -> Status;
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
    #[link_name = "mrw_follow_point"]
    pub fn follow_point(state: *mut PointFollower, target: *const [f32; 3], dt_s: f32, limit: *const RateLimit) -> Status;
    /// follow_rotation() for the joints whose limit has a rate: in, the pose's rotations are the targets; out, what follows.
    /// All others keep their bits. To stay inside the limits call limit_pose() before, for the targets, and after, for the
    /// way there may lead outside.
    /// states: one a limit. Errors: bad_argument if there are too few, a joint is beyond the pose, or dt_s is below 0 or not
    /// finite; nothing is written. Joints whose rotation is not finite keep it.
    #[link_name = "mrw_follow_pose"]
    pub fn follow_pose(limits: *const JointLimit, limit_count: usize, states: *mut RotationFollower, state_count: usize, dt_s: f32, local: *mut SoaTransform, local_count: usize) -> Status;
    #[link_name = "mrw_two_bone_init"]
    pub fn two_bone_init(out: *mut TwoBone);
    #[link_name = "mrw_two_bone_joints_init"]
    pub fn two_bone_joints_init(out: *mut TwoBoneJoints);
    #[link_name = "mrw_two_bone_limb_init"]
    pub fn two_bone_limb_init(out: *mut TwoBoneLimb);
    #[link_name = "mrw_aim_init"]
    pub fn aim_init(out: *mut Aim);
    /// Method: the law of cosines in half-angles from lengths, (s - x)(s + x) and (x - m)(x + m), s and m the sum and the
    /// difference of the lengths; then the shortest arc to the target and a turn about it, in one quaternion.
    /// Of a bone of no length the rest is still done; nothing becomes infinite. A target at the start joint folds the limb.
    /// The turns are about the axes of the matrices. Where a joint's own scale mirrors it, its turn's x changes sign if just
    /// one of that scale's y and z is negative, y by z and x, z by x and y; the whole call does so.
    /// Errors: bad_argument, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
    /// large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
    /// Cost: 400 instructions on x86-64, 326 on AArch64; about as much again where the limb is nearly straight or bent the
    /// wrong way, the target more than 140° off or near the pole, or there is a twist.
    #[link_name = "mrw_turn_two_bone"]
    pub fn turn_two_bone(joints: *const TwoBoneJoints, goal: *const TwoBone, out: *mut TwoBoneTurns) -> Status;
    /// Four limbs at once, to the same numbers, at 60 % of the instructions each. Fill up with copies.
    /// Errors: as above, for all four if one is bad.
    #[link_name = "mrw_turn_two_bone_x4"]
    pub fn turn_two_bone_x4(joints: *const [TwoBoneJoints; 4], goals: *const [TwoBone; 4], out: *mut [TwoBoneTurns; 4]) -> Status;
    /// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
    /// 0. reached: may be null; see TwoBoneTurns. Errors: as above, and bad_argument if a span is too short or the joints
    /// are not a chain; nothing is written. Cost: the kernel's, and local_to_model_below(start).
    /// Where the limb changes its shape as it turns, by uneven scale above it or of its start joint, it is bent by secants
    /// and then turned: three to five times the cost, at most twelve. The target is met nevertheless; reached says if not.
    /// May be null: reached.
    #[link_name = "mrw_solve_two_bone"]
    pub fn solve_two_bone(skeleton: *const Skeleton, limb: *const TwoBoneLimb, goal: *const TwoBone, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, reached: *mut bool) -> Status;
    /// Method: the point where the ray is as far from the joint as the target is turned onto it by the shortest arc and a
    /// turn about it, in one quaternion.
    /// Errors: bad_argument, and nothing is written, for numbers that are not finite (or too large to be squared), or a
    /// weight outside 0 … 1.
    /// Cost: 219 instructions on x86-64, 180 on AArch64.
    #[link_name = "mrw_turn_aim"]
    pub fn turn_aim(joint: *const Affine, goal: *const Aim, out: *mut AimTurn) -> Status;
    /// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
    /// 0. reached: may be null. Errors: as above, and bad_argument if a span is too short or there is no such joint; nothing
    /// is written. Cost: the kernel's, and local_to_model_below(joint).
    /// May be null: reached.
    #[link_name = "mrw_solve_aim"]
    pub fn solve_aim(skeleton: *const Skeleton, joint: u32, goal: *const Aim, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, reached: *mut bool) -> Status;
    /// The same for a chain that shares the turn, such as spine, neck and head: joints from the lowest up to the one that
    /// looks, each below the one before it, whose forward, up and offset are meant; it does what the others leave.
    /// falloff: each joint's share of the turn, of what the next one has; 1: all alike, 0: the last alone.
    /// Errors: as above, and bad_argument if `joints` is empty or not a chain, or falloff not in 0 … 1.
    /// May be null: reached.
    #[link_name = "mrw_solve_look_at"]
    pub fn solve_look_at(skeleton: *const Skeleton, joints: *const u32, joint_count: usize, goal: *const Aim, falloff: f32, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, reached: *mut bool) -> Status;
    #[link_name = "mrw_ik_goal_init"]
    pub fn ik_goal_init(out: *mut IkGoal);
    #[link_name = "mrw_ik_problem_init"]
    pub fn ik_problem_init(out: *mut IkProblem);
    #[link_name = "mrw_ik_options_init"]
    pub fn ik_options_init(out: *mut IkOptions);
    /// Bytes of scratch memory that solve_ik needs; 0 of a problem without goals or joints that could be read.
    /// May be null: options.
    #[link_name = "mrw_ik_scratch_bytes"]
    pub fn ik_scratch_bytes(skeleton: *const Skeleton, problem: *const IkProblem, options: *const IkOptions) -> usize;
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
    #[link_name = "mrw_solve_ik"]
    pub fn solve_ik(skeleton: *const Skeleton, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, problem: *const IkProblem, options: *const IkOptions, scratch: *mut c_void, scratch_bytes: usize, report: *mut IkReport) -> Status;
    /// The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
    /// memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
    /// others.
    /// May be null: options, report.
    #[link_name = "mrw_solve_ik_chain"]
    pub fn solve_ik_chain(skeleton: *const Skeleton, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, problem: *const IkProblem, options: *const IkOptions, scratch: *mut c_void, scratch_bytes: usize, report: *mut IkReport) -> Status;
    /// The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
    /// memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
    /// others.
    /// May be null: options, report.
    #[link_name = "mrw_solve_ik_body"]
    pub fn solve_ik_body(skeleton: *const Skeleton, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, problem: *const IkProblem, options: *const IkOptions, scratch: *mut c_void, scratch_bytes: usize, report: *mut IkReport) -> Status;
    /// The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
    /// the result jumps as goals move. A function of its own, so that what does not call it does not link it.
    ///
    /// A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
    /// the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
    /// with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
    /// keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
    /// docs/ik.md: tens of microseconds a generation.
    #[link_name = "mrw_ik_genetic_scratch_bytes"]
    pub fn ik_genetic_scratch_bytes(skeleton: *const Skeleton, problem: *const IkProblem) -> usize;
    /// The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
    /// the result jumps as goals move. A function of its own, so that what does not call it does not link it.
    ///
    /// A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
    /// the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
    /// with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
    /// keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
    /// docs/ik.md: tens of microseconds a generation.
    /// May be null: options, report.
    #[link_name = "mrw_solve_ik_genetic"]
    pub fn solve_ik_genetic(skeleton: *const Skeleton, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize, problem: *const IkProblem, options: *const IkOptions, scratch: *mut c_void, scratch_bytes: usize, report: *mut IkReport) -> Status;
    #[link_name = "mrw_foot_init"]
    pub fn foot_init(out: *mut Foot);
    #[link_name = "mrw_feet_init"]
    pub fn feet_init(out: *mut Feet);
    #[link_name = "mrw_foot_ground_init"]
    pub fn foot_ground_init(out: *mut FootGround);
    #[link_name = "mrw_foot_motion_init"]
    pub fn foot_motion_init(out: *mut FootMotion);
    #[link_name = "mrw_feet_frame_init"]
    pub fn feet_frame_init(out: *mut FeetFrame);
    /// Where a ray for a foot is to go through: its sole as animated, in the world.
    /// Errors: bad_argument if the span is too short, there is no such joint, or the place is not finite or beyond 1e6.
    #[link_name = "mrw_foot_sole"]
    pub fn foot_sole(foot: *const Foot, world_from_scene: *const Affine, scene_from_joint: *const Affine, scene_from_joint_count: usize, sole_world: *mut [f32; 3]) -> Status;
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
    #[link_name = "mrw_place_feet"]
    pub fn place_feet(skeleton: *const Skeleton, feet: *const Feet, frame: *const FeetFrame, ground: *const FootGround, ground_count: usize, motion: *mut FootMotion, motion_count: usize, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize) -> Status;
    #[link_name = "mrw_springs_init"]
    pub fn springs_init(out: *mut Springs);
    #[link_name = "mrw_spring_frame_init"]
    pub fn spring_frame_init(out: *mut SpringFrame);
    /// What make_springs needs: 352 bytes for four bones, 272 a chain, 2 a joint of the skeleton; 0 without chains.
    #[link_name = "mrw_springs_bytes"]
    pub fn springs_bytes(skeleton: *const Skeleton, chains: *const SpringChain, chain_count: usize) -> usize;
    /// Lays springs out in `memory`, which they use from then on, at rest in whatever pose comes first.
    ///
    /// memory: at least springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
    /// Errors: bad_argument if a setting is out of its range, a joint is not in the skeleton or not below the one before it,
    /// a chain has no bone, or the memory does not do; nothing is written.
    #[link_name = "mrw_make_springs"]
    pub fn make_springs(skeleton: *const Skeleton, chains: *const SpringChain, chain_count: usize, memory: *mut c_void, memory_bytes: usize, out: *mut Springs) -> Status;
    /// New settings for the same joints, in the midst of motion. Errors: as make_springs, or not the same joints.
    #[link_name = "mrw_set_springs"]
    pub fn set_springs(skeleton: *const Skeleton, chains: *const SpringChain, chain_count: usize, springs: *mut Springs) -> Status;
    /// The next frame begins at rest in its pose.
    #[link_name = "mrw_reset_springs"]
    pub fn reset_springs(springs: *mut Springs);
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
    #[link_name = "mrw_simulate_springs"]
    pub fn simulate_springs(skeleton: *const Skeleton, frame: *const SpringFrame, springs: *mut Springs, local: *mut SoaTransform, local_count: usize, scene_from_joint: *mut Affine, scene_from_joint_count: usize) -> Status;
    /// For each target of `mesh` the index of the channel of `clip` that drives its weight, or kNoChannel. The mesh is of
    /// `file`, the clip of `clips`, the same or a clip pack. out: at least mesh.targets.size; errors: bad_argument. Cost:
    /// compares names; once a load.
    #[link_name = "mrw_find_weight_channels"]
    pub fn find_weight_channels(file: *const File, mesh: *const Mesh, clips: *const File, clip: *const Clip, out: *mut u32, out_count: usize) -> Status;
    /// The weights of a moment: of each target its channel's value, or its default without. channels: from
    /// find_weight_channels(); values: from sample_channels() of the same clip; empty spans: all defaults.
    /// out: at least mesh.targets.size. Errors: bad_argument (`out` or `channels` too short, a channel outside the values).
    #[link_name = "mrw_morph_weights"]
    pub fn morph_weights(mesh: *const Mesh, channels: *const u32, channel_count: usize, values: *const f32, value_count: usize, out: *mut f32, out_count: usize) -> Status;
    /// Bytes that make_morphed() needs; 0 for a geometry without targets, which is its own morphed geometry.
    #[link_name = "mrw_morphed_bytes"]
    pub fn morphed_bytes(geometry: *const Geometry) -> usize;
    /// The bind pose. memory: at least morphed_bytes(), 16-byte aligned (bad_argument otherwise); `out` keeps pointers into
    /// it and into `geometry`'s block. Cost: a copy of the vertices; once an instance.
    #[link_name = "mrw_make_morphed"]
    pub fn make_morphed(geometry: *const Geometry, memory: *mut c_void, memory_bytes: usize, out: *mut MorphedGeometry) -> Status;
    /// Moves the vertices by `weights`, one a target; whatever they were moved by before is undone. Targets with weight 0
    /// cost nothing. Errors: bad_argument (too few weights, or one that is not finite: nothing is written).
    /// Cost: in proportion to the vertices (blocks of four) that targets with another weight move, and the call before
    /// moved. Instructions a vertex, x86-64, g++ 12 -O3: 9 a target for positions, 15 with normals, 21 with tangents; and,
    /// however many targets move it, 8, 20 or 29 to undo and normalise.
    #[link_name = "mrw_morph"]
    pub fn morph(weights: *const f32, weight_count: usize, morphed: *mut MorphedGeometry) -> Status;
    /// Brings animation-space coordinates up to date with the last morph(): q_j.xyz += (q_j)_w Δ and so Σ_j q_j += Δ, where
    /// Δ is how far a vertex is from its bind pose. Δ goes through the blend that normals go through; as_coordinates() of
    /// the morphed geometry is the same where no residual changes a weight.
    ///
    /// coordinates: as_coordinates() of the bind geometry, given to every call since. Errors: bad_argument (too short).
    /// Cost: 60 instructions a vertex with four influences and a residual, of those written by morph() since the last call.
    #[link_name = "mrw_morph_coordinates"]
    pub fn morph_coordinates(morphed: *mut MorphedGeometry, coordinates: *mut f32, coordinate_count: usize) -> Status;
    /// For each parameter the index of the channel of `clip` that has its name, or kNoChannel. The space is of `file`, the
    /// clip of `clips`, the same or a clip pack. out: at least space.parameters.size. Errors: bad_argument. Cost: compares
    /// names; once a load.
    #[link_name = "mrw_find_example_channels"]
    pub fn find_example_channels(file: *const File, space: *const ExampleSpace, clips: *const File, clip: *const Clip, out: *mut u32, out_count: usize) -> Status;
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
    #[link_name = "mrw_evaluate_examples"]
    pub fn evaluate_examples(space: *const ExampleSpace, parameters: *const f32, parameter_count: usize, weights: *mut f32, weight_count: usize) -> Status;
    #[link_name = "mrw_debug_line_init"]
    pub fn debug_line_init(out: *mut DebugLine);
    #[link_name = "mrw_debug_lines_init"]
    pub fn debug_lines_init(out: *mut DebugLines);
    /// A line from each joint's parent to the joint, and the joint's axes x, y, z in red, green, blue: `axis_m` long
    /// whatever its scale; 0: none. scene_from_joint: at least skeleton.joint_count. At most 4 lines a joint.
    /// Errors, of all that follow: bad_argument if a span is too short, a joint is not in the skeleton, or a length is below
    /// 0 or not finite; nothing is appended.
    #[link_name = "mrw_joint_lines"]
    pub fn joint_lines(skeleton: *const Skeleton, scene_from_joint: *const Affine, scene_from_joint_count: usize, axis_m: f32, lines: *mut DebugLines) -> Status;
    /// What each limit lets the joint do, about the joint, `size_m` large. local: the pose that scene_from_joint is of.
    /// A hinge: the arc along which its y moves. A cone: the rim along which its x moves at most, and four spokes. Euler
    /// angles: three arcs in the colours of their axes, each with the other angles at the middle. Then where the joint is
    /// now, in green inside the limit and red outside of it. Limits that is_valid() refuses are passed over. At most 51
    /// lines a limit.
    #[link_name = "mrw_limit_lines"]
    pub fn limit_lines(skeleton: *const Skeleton, limits: *const JointLimit, limit_count: usize, local: *const SoaTransform, local_count: usize, scene_from_joint: *const Affine, scene_from_joint_count: usize, size_m: f32, lines: *mut DebugLines) -> Status;
    /// A cross at each goal's position, or, where its rotation counts, the axes it asks for; and a line to it from the point
    /// of the joint that is to be there. Green within `tolerance_m`, else red. At most 4 lines a goal.
    #[link_name = "mrw_goal_lines"]
    pub fn goal_lines(skeleton: *const Skeleton, goals: *const IkGoal, goal_count: usize, scene_from_joint: *const Affine, scene_from_joint_count: usize, size_m: f32, tolerance_m: f32, lines: *mut DebugLines) -> Status;
    /// The bones of each chain, and its tip. scene_from_joint: after simulate_springs(). At most a line a joint.
    #[link_name = "mrw_spring_lines"]
    pub fn spring_lines(skeleton: *const Skeleton, chains: *const SpringChain, chain_count: usize, scene_from_joint: *const Affine, scene_from_joint_count: usize, lines: *mut DebugLines) -> Status;
    /// Each collider as great circles about its ends, and lines between them: 48 lines a sphere, 100 a capsule.
    #[link_name = "mrw_collider_lines"]
    pub fn collider_lines(skeleton: *const Skeleton, colliders: *const SpringCollider, collider_count: usize, scene_from_joint: *const Affine, scene_from_joint_count: usize, lines: *mut DebugLines) -> Status;
    /// The box's edges and the sphere's three great circles: 60 lines; none if it is empty.
    #[link_name = "mrw_bounds_lines"]
    pub fn bounds_lines(bounds: *const Bounds, lines: *mut DebugLines) -> Status;
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
    #[link_name = "mrw_build_palette_of_joints"]
    pub fn build_palette_of_joints(joints: *const u16, joint_count: usize, bind: *const Affine, bind_count: usize, scene_from_joint: *const Affine, scene_from_joint_count: usize, out: *mut Affine, out_count: usize, helpers: *const Helper, helper_count: usize, centres: *const f32, centre_count: usize) -> Status;
    /// The palette of a mesh.
    #[link_name = "mrw_build_palette"]
    pub fn build_palette(mesh: *const Mesh, scene_from_joint: *const Affine, scene_from_joint_count: usize, out: *mut Affine, out_count: usize) -> Status;
    /// Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
    /// are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
    /// not finite do not.
    #[link_name = "mrw_turns_inside_out"]
    pub fn turns_inside_out(map: *const Affine) -> bool;
    /// The same of what follows a palette: whether more of its matrices mirror than not. For culling of meshes that are not
    /// double_sided; a game whose characters are never mirrored, nor hung on what is, need not ask. An instance of a crowd
    /// turns if either this or its scene_from_character does, not if both do: see gles3_crowd.h. Cost: a determinant a
    /// matrix.
    #[link_name = "mrw_palette_turns_inside_out"]
    pub fn palette_turns_inside_out(palette: *const Affine, palette_count: usize) -> bool;
    /// Bytes that make_reach() needs: 24 a palette entry and 24 a morph target, up to a multiple of 16.
    #[link_name = "mrw_reach_bytes"]
    pub fn reach_bytes(mesh: *const Mesh) -> usize;
    /// Looks at every vertex once. The result serves all characters with this mesh, at any level of detail whose vertices
    /// are among those of `mesh`.
    ///
    /// mesh: of a file, not of a character whose vertices are morphed. memory: at least reach_bytes(), 16-byte aligned;
    /// `out` keeps pointers into it. Errors: bad_argument (the memory). Cost: once a load.
    #[link_name = "mrw_make_reach"]
    pub fn make_reach(mesh: *const Mesh, memory: *mut c_void, memory_bytes: usize, out: *mut Reach) -> Status;
    /// The box of the mesh and a sphere about the box's centre, in the palette's space.
    ///
    /// palette: of the mesh, reach.joints.size entries. weights: of its morph targets, any finite numbers; empty: none is
    /// active. Without a vertex `out` is empty (Bounds::is_empty()). Errors: bad_argument (a span too short, a weight that
    /// is not finite); `out` is not written. Method: the box of a transformed box is its centre, transformed, and its half
    /// sides through the absolute values of the matrix (J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems,
    /// 1990); a union of those. The sphere's radius is the distance to the farthest corner of any of them. Cost: 119
    /// instructions a palette entry, x86-64, in two passes. No allocation, thread-safe.
    #[link_name = "mrw_palette_bounds"]
    pub fn palette_bounds(reach: *const Reach, palette: *const Affine, palette_count: usize, weights: *const f32, weight_count: usize, out: *mut Bounds) -> Status;
    #[link_name = "mrw_skin_output_init"]
    pub fn skin_output_init(out: *mut SkinOutput);
    #[link_name = "mrw_as_part_init"]
    pub fn as_part_init(out: *mut AsPart);
    /// Each vertex follows the joint with its largest weight.
    ///   position = M_j (v, 1)
    /// palette: mesh.palette_size() entries. Errors, here and below: bad_argument if a span is too short, if the geometry
    /// follows more entries than the mesh has, and so is another one's, if normals or tangents are asked of a mesh without,
    /// or if the geometry's floats do not stand on 16-byte boundaries.
    /// Cost: positions 50 / 32; with exact normals 78 / 49.
    #[link_name = "mrw_skin_rigid"]
    pub fn skin_rigid(mesh: *const Mesh, palette: *const Affine, palette_count: usize, out: *const SkinOutput) -> Status;
    /// Skeletal subspace deformation, also called linear blend skinning.
    ///   position = (Σ_j w_j M_j) (v, 1)
    /// Cost: positions 38 / 29; with normals through the blended matrix 47 / 34, and tangents 59 / 42; through the inverse
    /// transpose 66 / 47 and 83 / 56. That is 12 multiply-adds an influence but the last, 9 for the position, 9 for a normal
    /// or tangent through the matrix, 27 multiplications and a square root and a division for a normal through its inverse
    /// transpose.
    #[link_name = "mrw_skin_ssd"]
    pub fn skin_ssd(mesh: *const Mesh, palette: *const Affine, palette_count: usize, out: *const SkinOutput) -> Status;
    /// How many floats as_coordinates() writes: 3 a slot, and 4 for each influence but the last.
    #[link_name = "mrw_as_coordinate_count"]
    pub fn as_coordinate_count(geometry: *const Geometry) -> usize;
    /// Animation-space coordinates of every slot, from lift and residual: q_j = (w_j v + d_j, w_j + δ_j), Σ_j (q_j)_w = 1.
    /// In the notation of Merry, Marais and Gain (ACM TOG 25(4), 2006) p_j = B_j⁻¹ q_j; B_j⁻¹ stands in the palette here.
    ///
    /// As with the weights of SSD, the last influence is what the others leave: a block holds the sum Σ_j q_j as
    /// x[4] y[4] z[4] (its w is 1), then x[4] y[4] z[4] w[4] of each q_j but the last.
    /// out: as_coordinate_count() floats. Done once a mesh, not a frame.
    #[link_name = "mrw_as_coordinates"]
    pub fn as_coordinates(geometry: *const Geometry, out: *mut f32, out_count: usize) -> Status;
    /// How many floats as_tangents() writes of a mesh: twice as_coordinate_count().
    #[link_name = "mrw_as_tangent_count"]
    pub fn as_tangent_count(geometry: *const Geometry) -> usize;
    /// Bytes of scratch memory that as_tangents() wants: about 32 a slot and 4 an index.
    #[link_name = "mrw_as_tangent_scratch_bytes"]
    pub fn as_tangent_scratch_bytes(parts: *const AsPart, part_count: usize) -> usize;
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
    #[link_name = "mrw_as_tangents"]
    pub fn as_tangents(parts: *const AsPart, part_count: usize, scratch: *mut c_void, scratch_bytes: usize) -> Status;
    /// Animation space.
    ///   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
    ///            = M_last Σ_j q_j + Σ_{j<last} (M_j - M_last) q_j
    /// Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
    /// coordinates: from as_coordinates() of this geometry.
    /// Cost: positions 40 / 31; with normals through the blended matrix 73 / 56, and tangents 85 / 62; through the inverse
    /// transpose 92 / 69 and 108 / 77. That is 12 multiply-adds an influence but the last and 9 for the sum; with normals 9
    /// more an influence but the last.
    ///
    /// tangents: from as_tangents() of this geometry, or empty. With them normals are the deformed surface's own,
    /// t₀' × t₁' with t' = Σ_j M_j τ_j, and tangents t₀', unit, whatever out.normal_transform says; turned round where the
    /// run's last joint mirrors. They know nothing of morph targets. Cost, x86-64: 140, and with tangents 151.
    #[link_name = "mrw_skin_as"]
    pub fn skin_as(mesh: *const Mesh, coordinates: *const f32, coordinate_count: usize, palette: *const Affine, palette_count: usize, out: *const SkinOutput, tangents: *const f32, tangent_count: usize) -> Status;
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
    #[link_name = "mrw_skin_mwe"]
    pub fn skin_mwe(mesh: *const Mesh, palette: *const Affine, palette_count: usize, out: *const SkinOutput) -> Status;
    /// How many floats psd_distances() writes: one for each palette entry and example, and one more an entry; 0 without
    /// examples.
    #[link_name = "mrw_psd_distance_count"]
    pub fn psd_distance_count(geometry: *const Geometry) -> usize;
    /// How far a pose is from the examples, joint by joint: what skin_psd() weighs a vertex. Of palette entry j and example
    /// k, D_jk = 1 - (q_j · q_jk)² = sin²(half the angle between), with q_j the rotation of M_j relative to its parent's,
    /// rotations as in skin_mwe(); 0 for an entry without a parent.
    /// out, for each palette entry: -D_jk / 2σ² for each k, then the same of the bind pose. Once a mesh and frame. Errors:
    /// bad_argument if a span is too short.
    /// Cost: 34 instructions a palette entry and example, x86-64.
    #[link_name = "mrw_psd_distances"]
    pub fn psd_distances(geometry: *const Geometry, palette: *const Affine, palette_count: usize, out: *mut f32, out_count: usize) -> Status;
    /// Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000, with distances
    /// weighted a vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
    ///   position = (Σ_j w_j M_j) (v + (1 - φ_bind) Σ_k φ_k d_k, 1)        d_k: Geometry::pose_space
    ///   φ_k = exp(-Σ_j w_j D_jk / 2σ²)
    /// where the factor makes nothing of the bind pose. Normals and tangents go through the blend, as SSD's.
    /// distances: from psd_distances() of this geometry and palette. Errors: also bad_argument if they are too few. A
    /// geometry without examples is SSD's.
    /// Cost, x86-64: positions 49, with normals through the blended matrix 61, through the inverse transpose 74; and 30 a
    /// vertex for each example that moves its block.
    #[link_name = "mrw_skin_psd"]
    pub fn skin_psd(mesh: *const Mesh, distances: *const f32, distance_count: usize, palette: *const Affine, palette_count: usize, out: *const SkinOutput) -> Status;
    #[link_name = "mrw_character_options_init"]
    pub fn character_options_init(out: *mut CharacterOptions);
    #[link_name = "mrw_animation_layer_init"]
    pub fn animation_layer_init(out: *mut AnimationLayer);
    /// Bytes that make_animations() needs: for each clip an Animation, 4 a skeleton and 4 a morph target. A multiple of 16.
    #[link_name = "mrw_animations_bytes"]
    pub fn animations_bytes(file: *const File, clips: *const File) -> usize;
    /// Makes animations of clips of `file`, the character's, or of a clip pack. A pack's reference goes with the skeleton of
    /// its name if it fits that, else with the first that it fits and no reference before it has; see bind_clips(). If it
    /// fits none, its clips are left out: no skeleton plays them.
    ///
    /// memory: at least animations_bytes(), 16-byte aligned; `out` keeps pointers into it and into both files' blocks.
    /// Errors: bad_argument (the memory); mismatch (`clips` is another file but no pack, or a pack none of whose clips fits
    /// a skeleton). Cost: compares names; once a load.
    #[link_name = "mrw_make_animations"]
    pub fn make_animations(file: *const File, clips: *const File, memory: *mut c_void, memory_bytes: usize, out: *mut Animations) -> Status;
    /// The first with this name that moves anything; null if there is none. Cost: compares names.
    #[link_name = "mrw_find_animation"]
    pub fn find_animation(animations: *const Animations, name: *const c_char) -> *const Animation;
    /// Bytes that make_character() needs: a multiple of 16, so that the blocks of a crowd may stand back to back.
    /// May be null: options.
    #[link_name = "mrw_character_bytes"]
    pub fn character_bytes(file: *const File, options: *const CharacterOptions) -> usize;
    /// A character in its rest pose, finished.
    ///
    /// `file`'s block must outlive it. memory: at least character_bytes(), 16-byte aligned.
    /// Errors: bad_argument (the memory, no layers, a default weight that is not finite). Cost: a copy of the vertices of
    /// meshes with morph targets, and as_coordinates().
    /// May be null: options.
    #[link_name = "mrw_make_character"]
    pub fn make_character(file: *const File, options: *const CharacterOptions, memory: *mut c_void, memory_bytes: usize, out: *mut Character) -> Status;
    /// Samples and blends: local poses of all skeletons and weights of all morph targets become means of the layers, as
    /// blend() has it; without layers all rest. A clip that is cooked as additive counts as its changes laid on their
    /// reference.
    ///
    /// Errors: bad_argument (more layers than the options say, an animation that is null or not made for this file, a weight
    /// out of range, a time that is not a number); a part of the character may have been written then.
    /// Cost: sample() and blend() of each skeleton, sample_channels() of what drives morph targets.
    #[link_name = "mrw_sample_character"]
    pub fn sample_character(character: *mut Character, layers: *const AnimationLayer, layer_count: usize) -> Status;
    /// Brings scene_from_joint of all skeletons up to date with `local`.
    #[link_name = "mrw_character_to_model"]
    pub fn character_to_model(character: *mut Character) -> Status;
    /// Both: poses that inverse kinematics, feet and springs can go on with. Errors: as sample_character().
    #[link_name = "mrw_pose_character"]
    pub fn pose_character(character: *mut Character, layers: *const AnimationLayer, layer_count: usize) -> Status;
    /// Adds an expression of a face or its like to the weights of morph targets, as often as there are expressions: what the
    /// animation makes of them less what they are by default, times `weight`. A weight that no channel drives keeps its
    /// bits, and so do poses. Between pose_character() and finish_character().
    ///
    /// Errors: bad_argument (an animation that is null or not made for this file, a weight out of range, a time that is not
    /// a number); nothing is written. Cost: sample_channels() of what drives morph targets.
    #[link_name = "mrw_add_expression"]
    pub fn add_expression(character: *mut Character, expression: *const AnimationLayer) -> Status;
    /// Palettes from scene_from_joint, and vertices morphed by `weights`; nothing without `skin`.
    /// Errors: bad_argument (a weight that is not finite). Cost: build_palette(), morph() and morph_coordinates() of each
    /// mesh.
    #[link_name = "mrw_finish_character"]
    pub fn finish_character(character: *mut Character) -> Status;
    /// Bytes that make_outfit() needs: 24 a skeleton and 2 a joint, on boundaries of 16. A multiple of 16.
    #[link_name = "mrw_outfit_bytes"]
    pub fn outfit_bytes(outfit: *const File) -> usize;
    /// Finds for each skeleton of an outfit the one of the body that it follows: of its name if it fits that, else the first
    /// that it fits. An outfit is cooked with `--skeleton BODY`; outfit.h says when it fits.
    ///
    /// memory: at least outfit_bytes(), 16-byte aligned; `out` keeps pointers into it. Several outfits may follow one body.
    /// Errors: bad_argument (the memory); mismatch if a skeleton fits none, and bind_outfit() says which joints are in the
    /// way. Cost: compares names; once a load.
    #[link_name = "mrw_make_outfit"]
    pub fn make_outfit(body: *const File, outfit: *const File, memory: *mut c_void, memory_bytes: usize, out: *mut Outfit) -> Status;
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
    #[link_name = "mrw_character_follow_body"]
    pub fn character_follow_body(outfit: *const Outfit, body: *const Character, worn: *mut Character) -> Status;
    #[link_name = "mrw_gles3_error_watch_init"]
    pub fn gles3_error_watch_init(out: *mut Gles3ErrorWatch);
    #[link_name = "mrw_gles3_caps_init"]
    pub fn gles3_caps_init(out: *mut Gles3Caps);
    #[link_name = "mrw_gles3_vertex_layout_init"]
    pub fn gles3_vertex_layout_init(out: *mut Gles3VertexLayout);
    #[link_name = "mrw_gles3_gpu_mesh_init"]
    pub fn gles3_gpu_mesh_init(out: *mut Gles3GpuMesh);
    #[link_name = "mrw_gles3_prepare_options_init"]
    pub fn gles3_prepare_options_init(out: *mut Gles3PrepareOptions);
    #[link_name = "mrw_gles3_program_key_init"]
    pub fn gles3_program_key_init(out: *mut Gles3ProgramKey);
    #[link_name = "mrw_gles3_program_source_init"]
    pub fn gles3_program_source_init(out: *mut Gles3ProgramSource);
    #[link_name = "mrw_gles3_program_init"]
    pub fn gles3_program_init(out: *mut Gles3Program);
    #[link_name = "mrw_gles3_palette_ring_init"]
    pub fn gles3_palette_ring_init(out: *mut Gles3PaletteRing);
    #[link_name = "mrw_gles3_palette_texture_init"]
    pub fn gles3_palette_texture_init(out: *mut Gles3PaletteTexture);
    /// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader.
    /// Errors: bad_argument without a loader; unsupported if it returns null for a function of OpenGL ES 3.0, whose name is
    /// put in `missing` (static string). Those of 3.1 stay null where there are none. `api` is written only on success.
    ///
    /// ObjectLabel is there with GL_KHR_debug or OpenGL ES 3.2. Then GL objects are labelled as they are made, for RenderDoc
    /// and drivers' tools ("newt: surface"); set to null, they are not. GetGraphicsResetStatus is there with
    /// GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
    /// May be null: missing.
    #[link_name = "mrw_gles3_load_api"]
    pub fn gles3_load_api(api: *mut Gles3Api, load_proc: Gles3LoadProc, missing: *mut *const c_char) -> Status;
    /// Whether the graphics processor was reset and the context is lost with all that is in it: to be asked once a frame.
    /// Then call on_context_lost() for each object that has it, destroy the context, make another, and call
    /// on_context_restored(). True only where GetGraphicsResetStatus is there and the context was created to lose itself on
    /// a reset (EGL_LOSE_CONTEXT_ON_RESET, as marrow::egl::HeadlessContext asks for); other contexts never tell, and
    /// platforms have ways of their own (EGL_CONTEXT_LOST of eglSwapBuffers). GL may tell each reset only once.
    #[link_name = "mrw_gles3_context_was_reset"]
    pub fn gles3_context_was_reset(api: *const Gles3Api) -> bool;
    /// Has every GL error reported that a call through `api` or a copy of it causes, with the call's name, to a watch that
    /// lives as long as they; null: no more. Results stay what they are, as GetError still tells each check of an error. For
    /// debugging: without a watch a call costs a comparison more, with one two calls of glGetError.
    /// May be null: watch.
    #[link_name = "mrw_gles3_watch_errors"]
    pub fn gles3_watch_errors(api: *mut Gles3Api, watch: *mut Gles3ErrorWatch);
    /// Errors: unsupported below OpenGL ES 3.0; gl_error.
    #[link_name = "mrw_gles3_query_caps"]
    pub fn gles3_query_caps(api: *const Gles3Api, caps: *mut Gles3Caps) -> Status;
    /// Bytes of scratch memory that prepare() wants: the largest of its vertex buffers, with `psd` and all changes.
    /// May be null: options.
    #[link_name = "mrw_gles3_prepare_scratch_bytes"]
    pub fn gles3_prepare_scratch_bytes(mesh: *const Mesh, options: *const Gles3PrepareOptions) -> usize;
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
    #[link_name = "mrw_gles3_prepare"]
    pub fn gles3_prepare(api: *const Gles3Api, caps: *const Gles3Caps, mesh: *const Mesh, options: *const Gles3PrepareOptions, scratch: *mut c_void, scratch_bytes: usize, bind: *mut Affine, bind_count: usize, out: *mut Gles3GpuMesh) -> Status;
    /// Deletes the GL objects and clears the struct.
    #[link_name = "mrw_gles3_destroy_mesh"]
    pub fn gles3_destroy_mesh(api: *const Gles3Api, mesh: *mut Gles3GpuMesh);
    /// Compiles and links; the palette block is tied to uniform buffer binding `palette_binding`, with kMotion that of the
    /// frame before to the next binding.
    /// Errors: bad_argument (a text missing, influences other than 4 to 8, what crowds cannot); gl_error, with the driver's
    /// words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a frame.
    #[link_name = "mrw_gles3_build_program"]
    pub fn gles3_build_program(api: *const Gles3Api, key: *const Gles3ProgramKey, source: *const Gles3ProgramSource, palette_binding: u32, out: *mut Gles3Program, log: *mut c_char, log_bytes: usize) -> Status;
    /// Deletes the program and clears the struct.
    #[link_name = "mrw_gles3_destroy_program"]
    pub fn gles3_destroy_program(api: *const Gles3Api, program: *mut Gles3Program);
    /// Room for palettes of `joints` matrices altogether in `palettes` pieces.
    /// Errors: bad_argument (zero); unsupported (caps of less than OpenGL ES 3.0); gl_error. Leaves GL_UNIFORM_BUFFER at 0.
    #[link_name = "mrw_gles3_create_palette_ring"]
    pub fn gles3_create_palette_ring(api: *const Gles3Api, caps: *const Gles3Caps, joints: u32, palettes: u32, out: *mut Gles3PaletteRing) -> Status;
    /// Deletes the buffer and clears the struct.
    #[link_name = "mrw_gles3_destroy_palette_ring"]
    pub fn gles3_destroy_palette_ring(api: *const Gles3Api, ring: *mut Gles3PaletteRing);
    /// Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
    #[link_name = "mrw_gles3_begin_frame"]
    pub fn gles3_begin_frame(api: *const Gles3Api, ring: *mut Gles3PaletteRing);
    /// Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
    /// ring. Errors: bad_argument (empty, or more than kPaletteJoints); unsupported (the ring is full until begin_frame).
    #[link_name = "mrw_gles3_push_palette"]
    pub fn gles3_push_palette(api: *const Gles3Api, ring: *mut Gles3PaletteRing, palette: *const Affine, palette_count: usize, offset: *mut u32) -> Status;
    /// Ties the palette at `offset` to uniform buffer binding `binding`.
    #[link_name = "mrw_gles3_bind_palette"]
    pub fn gles3_bind_palette(api: *const Gles3Api, ring: *const Gles3PaletteRing, offset: u32, binding: u32);
    /// Room for `joints` matrices: 48 B each, three times.
    /// Errors: bad_argument (zero); unsupported (more than a texture of the caps' size holds: 1.39 million in 2048²);
    /// gl_error. Leaves the active unit's 2D texture at 0.
    #[link_name = "mrw_gles3_create_palette_texture"]
    pub fn gles3_create_palette_texture(api: *const Gles3Api, caps: *const Gles3Caps, joints: u32, out: *mut Gles3PaletteTexture) -> Status;
    /// Deletes the textures and clears the struct.
    #[link_name = "mrw_gles3_destroy_palette_texture"]
    pub fn gles3_destroy_palette_texture(api: *const Gles3Api, texture: *mut Gles3PaletteTexture);
    /// Once a frame, all palettes: whole ones after each other, those of one mesh's instances together, and build_palette()
    /// may write right there. 48 bytes a matrix go up, and nothing else. Errors: bad_argument (empty); unsupported (more
    /// than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0.
    #[link_name = "mrw_gles3_upload_palettes"]
    pub fn gles3_upload_palettes(api: *const Gles3Api, texture: *mut Gles3PaletteTexture, palettes: *const Affine, palette_count: usize) -> Status;
    /// `program`, which must be in use and read palettes from a texture, draws with the palette that begins at matrix
    /// `first` of what was uploaded, its instance i with the one `joints` · i behind it. Leaves `texture_unit` active and
    /// the texture bound to it. Errors: bad_argument (a program of another kind, a palette that reaches beyond what was
    /// uploaded).
    #[link_name = "mrw_gles3_bind_texture_palette"]
    pub fn gles3_bind_texture_palette(api: *const Gles3Api, texture: *const Gles3PaletteTexture, first: u32, joints: u32, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// The palettes of the frame before, which are there still, for a program with kMotion that draws from bind_palette() of
    /// the same arguments. kept: false for characters without a frame before; their palettes of this frame are bound then,
    /// and nothing moves. Leaves `texture_unit` active and the texture bound to it; nothing is bound for a program whose
    /// text does not read previous_position. Errors: bad_argument (a program of another kind, a palette that reaches beyond
    /// what was uploaded then).
    #[link_name = "mrw_gles3_bind_previous_palette"]
    pub fn gles3_bind_previous_palette(api: *const Gles3Api, texture: *const Gles3PaletteTexture, first: u32, joints: u32, kept: bool, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// Sets by which weights, one a target, `program`, which must be in use, morphs: as morph() does on the CPU, in
    /// animation space through the same blend as normals. Of more than kMorphTargets weights other than 0 those count that
    /// move most. Leaves `texture_unit` active and the mesh's texture bound to it. Errors: bad_argument (a mesh without
    /// targets, a program without kMorphs, too few weights, one that is not finite).
    #[link_name = "mrw_gles3_set_morphs"]
    pub fn gles3_set_morphs(api: *const Gles3Api, mesh: *const Mesh, gpu: *const Gles3GpuMesh, weights: *const f32, weight_count: usize, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// The weights of the frame before, for a program with kMotion, after set_morphs(). Errors: as there.
    #[link_name = "mrw_gles3_set_previous_morphs"]
    pub fn gles3_set_previous_morphs(api: *const Gles3Api, mesh: *const Mesh, gpu: *const Gles3GpuMesh, weights: *const f32, weight_count: usize, program: *const Gles3Program) -> Status;
    /// Room that pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and four
    /// examples. 0 without examples.
    #[link_name = "mrw_gles3_distance_matrices"]
    pub fn gles3_distance_matrices(geometry: *const Geometry) -> u32;
    /// How far a pose is from the examples, as Deformer::psd reads it: psd_distances() in another order. It goes up with
    /// those of other characters as palettes do, by upload_palettes() into a PaletteTexture of its own, on every path.
    /// palette: built with the bind matrices of prepare(), or those of the mesh; no matter which. out: distance_matrices().
    /// Errors: bad_argument (no examples, a span too short). Cost: that of psd_distances().
    #[link_name = "mrw_gles3_pack_distances"]
    pub fn gles3_pack_distances(geometry: *const Geometry, palette: *const Affine, palette_count: usize, out: *mut Affine, out_count: usize) -> Status;
    /// `program`, which must be in use and of Deformer::psd, deforms by the mesh's examples and by distances that begin at
    /// matrix `first` of what was uploaded, its instance i by those GpuMesh::distances · i behind. Leaves `texture_unit` and
    /// the next one taken, the latter active. Errors: bad_argument (a mesh without examples, a program of another kind,
    /// distances that reach beyond what was uploaded).
    #[link_name = "mrw_gles3_bind_examples"]
    pub fn gles3_bind_examples(api: *const Gles3Api, mesh: *const Gles3GpuMesh, distances: *const Gles3PaletteTexture, first: u32, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// The distances of the frame before, for a program with kMotion, after bind_examples(). kept and errors: as in
    /// bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
    #[link_name = "mrw_gles3_bind_previous_distances"]
    pub fn gles3_bind_previous_distances(api: *const Gles3Api, mesh: *const Gles3GpuMesh, distances: *const Gles3PaletteTexture, first: u32, kept: bool, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// Draws all triangles, of as many characters as there are instances: more than one with palettes in a texture alone.
    /// `program` must be in use, its palette bound. Leaves the vertex array at 0. Which sides are drawn is the game's to
    /// say: as glTF has it, GL_CULL_FACE is enabled unless Mesh::double_sided, and fronts are GL_CCW, but GL_CW where
    /// turns_inside_out() of the palette, see palette.h. So characters that mirror take a draw call of their own.
    /// Errors: bad_argument if the mesh was not prepared for this deformer.
    #[link_name = "mrw_gles3_draw_mesh"]
    pub fn gles3_draw_mesh(api: *const Gles3Api, mesh: *const Gles3GpuMesh, deformer: Gles3Deformer, program: *const Gles3Program, instances: u32) -> Status;
    #[link_name = "mrw_gles3_skinned_mesh_init"]
    pub fn gles3_skinned_mesh_init(out: *mut Gles3SkinnedMesh);
    /// Errors: gl_error (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER and the vertex
    /// array at 0.
    #[link_name = "mrw_gles3_create_skinned"]
    pub fn gles3_create_skinned(api: *const Gles3Api, mesh: *const Gles3GpuMesh, out: *mut Gles3SkinnedMesh) -> Status;
    /// Deletes the GL objects and clears the struct.
    #[link_name = "mrw_gles3_destroy_skinned"]
    pub fn gles3_destroy_skinned(api: *const Gles3Api, mesh: *mut Gles3SkinnedMesh);
    /// What skin_ssd() and their like have written. The old contents are orphaned, so the CPU never waits for the GPU.
    /// Errors: bad_argument (a span of another size than the mesh has; normals or tangents may be empty, then they are
    /// undefined). Leaves GL_ARRAY_BUFFER at 0.
    #[link_name = "mrw_gles3_upload_skinned"]
    pub fn gles3_upload_skinned(api: *const Gles3Api, mesh: *mut Gles3SkinnedMesh, vertices: *const SkinOutput) -> Status;
    /// A program for preskin(), of the key's deformer, palettes, and of its features kNormals, kTangents, kMorphs and
    /// kSurfaceNormals. Those must be the mesh's.
    /// Errors: bad_argument (a key of Deformer::none, of a crowd, or with influences other than 4 to 8); unsupported
    /// (compute, without caps.compute); gl_error, with the driver's words in `log`. `out` is written only on success. Cost:
    /// a compile.
    #[link_name = "mrw_gles3_build_preskin"]
    pub fn gles3_build_preskin(api: *const Gles3Api, caps: *const Gles3Caps, key: *const Gles3ProgramKey, method: Gles3Preskin, palette_binding: u32, out: *mut Gles3Program, log: *mut c_char, log_bytes: usize) -> Status;
    /// Skins every slot once into `to`, with the palette that is bound. `program` must be in use. By transform feedback it
    /// leaves the vertex array, the default transform feedback object's bindings 0 … 2 and GL_TRANSFORM_FEEDBACK_BUFFER at
    /// 0, and GL_RASTERIZER_DISCARD off; by compute shader GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3 at 0.
    /// Errors: bad_argument (a mesh that was not prepared for this deformer, a program of another kind).
    #[link_name = "mrw_gles3_preskin_mesh"]
    pub fn gles3_preskin_mesh(api: *const Gles3Api, mesh: *const Gles3GpuMesh, deformer: Gles3Deformer, program: *const Gles3Program, to: *const Gles3SkinnedMesh) -> Status;
    /// Programs with kMotion take from `previous` where the vertices of `mesh` were in the frame before: another SkinnedMesh
    /// of the same GpuMesh, skinned then; or `mesh` itself, of what has no frame before. To be said again whenever it
    /// changes, so each frame where two take turns. Errors: bad_argument (of another number of slots). Leaves
    /// GL_ARRAY_BUFFER and the vertex array at 0.
    #[link_name = "mrw_gles3_set_previous"]
    pub fn gles3_set_previous(api: *const Gles3Api, mesh: *const Gles3SkinnedMesh, previous: *const Gles3SkinnedMesh) -> Status;
    /// Draws all triangles with the program in use, one with Deformer::none. Leaves the vertex array at 0.
    #[link_name = "mrw_gles3_draw_skinned"]
    pub fn gles3_draw_skinned(api: *const Gles3Api, mesh: *const Gles3GpuMesh, skinned: *const Gles3SkinnedMesh);
    #[link_name = "mrw_gles3_program_set_init"]
    pub fn gles3_program_set_init(out: *mut Gles3ProgramSet);
    #[link_name = "mrw_gles3_skinner_options_init"]
    pub fn gles3_skinner_options_init(out: *mut Gles3SkinnerOptions);
    /// "ubo", …
    #[link_name = "mrw_gles3_skinning_path_text"]
    pub fn gles3_skinning_path_text(path: Gles3SkinningPath) -> *const c_char;
    /// Deletes all programs. Skinners that use the set must go first.
    #[link_name = "mrw_gles3_destroy_programs"]
    pub fn gles3_destroy_programs(api: *const Gles3Api, programs: *mut Gles3ProgramSet);
    /// Bytes of memory that create_skinner() wants.
    #[link_name = "mrw_gles3_skinner_bytes"]
    pub fn gles3_skinner_bytes(mesh: *const Mesh, options: *const Gles3SkinnerOptions) -> usize;
    /// Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: pose() each
    /// before the first update(). Compiles what `programs` lacks for it.
    ///
    /// mesh: its geometry must live as long as the skinner, so that it can be put on the next context. memory: at least
    /// skinner_bytes(), 16-byte aligned, the skinner's until destroy().
    /// Errors: bad_argument (a span too short, no instances, Deformer::none, no role); unsupported (a path that the caps or
    /// the number of joints rule out, a full program set); gl_error (nothing is left allocated but programs). `out` is
    /// written only on success.
    #[link_name = "mrw_gles3_create_skinner"]
    pub fn gles3_create_skinner(api: *const Gles3Api, caps: *const Gles3Caps, mesh: *const Mesh, options: *const Gles3SkinnerOptions, programs: *mut Gles3ProgramSet, memory: *mut c_void, memory_bytes: usize, out: *mut Gles3Skinner) -> Status;
    /// Deletes the GL objects and clears the struct; the memory is the caller's again.
    #[link_name = "mrw_gles3_destroy_skinner"]
    pub fn gles3_destroy_skinner(api: *const Gles3Api, skinner: *mut Gles3Skinner);
    /// Character `instance` takes this pose at the next update(). weights: one a morph target. Calls no GL: may run on
    /// another thread than the context's, different instances on different threads.
    /// Errors: bad_argument (no such instance, a span too short, a skinner that was destroyed).
    #[link_name = "mrw_gles3_pose"]
    pub fn gles3_pose(skinner: *mut Gles3Skinner, instance: u32, scene_from_joint: *const Affine, scene_from_joint_count: usize, weights: *const f32, weight_count: usize) -> Status;
    /// Of a skinner with options.motion: to the next update() the character has no frame before, so its vertices do not
    /// move: for one that appears, or is put elsewhere at once. Characters that the update() before left out have none
    /// anyway. May be called where pose() may. Errors: bad_argument (no such instance, a skinner without motion or that was
    /// destroyed).
    #[link_name = "mrw_gles3_reset_motion"]
    pub fn gles3_reset_motion(skinner: *mut Gles3Skinner, instance: u32) -> Status;
    /// Once a frame, after posing: sends up the palettes of characters 0 … count - 1, or skins them. 48 bytes a joint go up
    /// and nothing else, with a pose space 16 more for every four examples, of which the bind pose is one; on path cpu the
    /// vertices.
    /// Errors: bad_argument (more than there are, a weight that is not finite, a skinner that was destroyed); gl_error (the
    /// context is lost).
    #[link_name = "mrw_gles3_update"]
    pub fn gles3_update(api: *const Gles3Api, skinner: *mut Gles3Skinner, programs: *const Gles3ProgramSet, count: u32) -> Status;
    /// The program of a role for this mesh, never null: use it and set the game's own uniforms before draw().
    #[link_name = "mrw_gles3_program_of"]
    pub fn gles3_program_of(skinner: *const Gles3Skinner, programs: *const Gles3ProgramSet, role: u32) -> *const Gles3Program;
    /// Draws characters first … first + count - 1 with `program`, which is program_of() of a role and in use.
    /// Errors: bad_argument (not all of them updated, a skinner that was destroyed); gl_error (the context is lost).
    #[link_name = "mrw_gles3_draw"]
    pub fn gles3_draw(api: *const Gles3Api, skinner: *const Gles3Skinner, programs: *const Gles3ProgramSet, program: *const Gles3Program, first: u32, count: u32) -> Status;
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() update() and draw() refuse. The set first or last, as one likes.
    #[link_name = "mrw_gles3_programs_on_context_lost"]
    pub fn gles3_programs_on_context_lost(programs: *mut Gles3ProgramSet);
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() update() and draw() refuse. The set first or last, as one likes.
    #[link_name = "mrw_gles3_skinner_on_context_lost"]
    pub fn gles3_skinner_on_context_lost(skinner: *mut Gles3Skinner);
    /// Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
    /// create_skinner(); then it may be tried again.
    #[link_name = "mrw_gles3_programs_on_context_restored"]
    pub fn gles3_programs_on_context_restored(api: *const Gles3Api, caps: *const Gles3Caps, programs: *mut Gles3ProgramSet) -> Status;
    /// Builds everything anew in the context that is current. What had been posed is there at the next update(). Errors: as
    /// create_skinner(); then it may be tried again.
    #[link_name = "mrw_gles3_skinner_on_context_restored"]
    pub fn gles3_skinner_on_context_restored(api: *const Gles3Api, caps: *const Gles3Caps, skinner: *mut Gles3Skinner) -> Status;
    #[link_name = "mrw_gles3_crowd_source_init"]
    pub fn gles3_crowd_source_init(out: *mut Gles3CrowdSource);
    #[link_name = "mrw_gles3_crowd_clip_init"]
    pub fn gles3_crowd_clip_init(out: *mut Gles3CrowdClip);
    #[link_name = "mrw_gles3_crowd_frames_init"]
    pub fn gles3_crowd_frames_init(out: *mut Gles3CrowdFrames);
    #[link_name = "mrw_gles3_crowd_play_init"]
    pub fn gles3_crowd_play_init(out: *mut Gles3CrowdPlay);
    #[link_name = "mrw_gles3_crowd_instance_init"]
    pub fn gles3_crowd_instance_init(out: *mut Gles3CrowdInstance);
    #[link_name = "mrw_gles3_crowd_mesh_init"]
    pub fn gles3_crowd_mesh_init(out: *mut Gles3CrowdMesh);
    #[link_name = "mrw_gles3_crowd_init"]
    pub fn gles3_crowd_init(out: *mut Gles3Crowd);
    /// How many frames it takes to bake clips at `rate_hz` or a little more, a whole number of steps each; 30 a second are
    /// enough for most motion. out: at least as many as sources.
    /// Errors: bad_argument (no sources, a rate that is not finite or not above 0, an additive clip, a span too short);
    /// unsupported (more than 65535 steps of a clip, or kMaxCrowdFrames). Written only on success.
    #[link_name = "mrw_gles3_plan_crowd"]
    pub fn gles3_plan_crowd(sources: *const Gles3CrowdSource, source_count: usize, rate_hz: f32, out: *mut Gles3CrowdClip, out_count: usize, frame_count: *mut u32) -> Status;
    /// Samples them. scratch: at least skeleton.soa_size(); matrices: at least frame_count × joint_count, the caller's to
    /// keep, as are the clips, which must be those that plan_crowd() wrote for these sources; 48 B a joint and frame.
    /// Errors: bad_argument (a span too short, a clip of another skeleton, clips that are not a plan).
    #[link_name = "mrw_gles3_bake_crowd"]
    pub fn gles3_bake_crowd(skeleton: *const Skeleton, sources: *const Gles3CrowdSource, source_count: usize, clips: *const Gles3CrowdClip, clip_count: usize, scratch: *mut SoaTransform, scratch_count: usize, matrices: *mut Affine, matrice_count: usize, out: *mut Gles3CrowdFrames) -> Status;
    /// Where a joint of an instance is: linear between two neighbouring frames and between two clips, like the palettes that
    /// are drawn, so that what is put there stays on the surface. What helpers of a palette do between frames and clips
    /// is linear in the drawing too.
    /// Errors: bad_argument (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
    /// scene_from_character beyond 1e12).
    #[link_name = "mrw_gles3_crowd_joint"]
    pub fn gles3_crowd_joint(frames: *const Gles3CrowdFrames, instance: *const Gles3CrowdInstance, time_s: f64, joint: u32, scene_from_joint: *mut Affine) -> Status;
    /// The same of all joints; out: at least frames.joint_count.
    #[link_name = "mrw_gles3_crowd_pose"]
    pub fn gles3_crowd_pose(frames: *const Gles3CrowdFrames, instance: *const Gles3CrowdInstance, time_s: f64, scene_from_joint: *mut Affine, scene_from_joint_count: usize) -> Status;
    /// What a texture of the caps' size holds, of palettes of `joints` matrices: frames of a mesh, and instances likewise.
    #[link_name = "mrw_gles3_crowd_palettes_that_fit"]
    pub fn gles3_crowd_palettes_that_fit(caps: *const Gles3Caps, joints: u32) -> u32;
    /// Bytes of memory that create_crowd_mesh() wants: 48 B a joint, and the larger of 0.1 MB and prepare_scratch_bytes().
    /// May be null: options.
    #[link_name = "mrw_gles3_crowd_mesh_bytes"]
    pub fn gles3_crowd_mesh_bytes(mesh: *const Mesh, options: *const Gles3PrepareOptions) -> usize;
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
    #[link_name = "mrw_gles3_create_crowd_mesh"]
    pub fn gles3_create_crowd_mesh(api: *const Gles3Api, caps: *const Gles3Caps, mesh: *const Mesh, options: *const Gles3PrepareOptions, frames: *const Gles3CrowdFrames, capacity: u32, memory: *mut c_void, memory_bytes: usize, out: *mut Gles3CrowdMesh, motion: bool) -> Status;
    /// Deletes the GL objects and clears the struct; the memory is the caller's again.
    #[link_name = "mrw_gles3_destroy_crowd_mesh"]
    pub fn gles3_destroy_crowd_mesh(api: *const Gles3Api, mesh: *mut Gles3CrowdMesh);
    /// Room for `capacity` instances. memory: kCrowdInstanceBytes each, 4-byte aligned, the crowd's until destroy().
    /// Errors: bad_argument (zero, memory too short or askew); unsupported (more than 256 × the caps' texture size:
    /// 524 288); gl_error. Leaves the active unit's 2D texture at 0.
    #[link_name = "mrw_gles3_create_crowd"]
    pub fn gles3_create_crowd(api: *const Gles3Api, caps: *const Gles3Caps, capacity: u32, memory: *mut c_void, memory_bytes: usize, out: *mut Gles3Crowd) -> Status;
    /// Deletes the texture and clears the struct; the memory is the caller's again.
    #[link_name = "mrw_gles3_destroy_crowd"]
    pub fn gles3_destroy_crowd(api: *const Gles3Api, crowd: *mut Gles3Crowd);
    /// Sets the instances from `first` on: any of those that there are, or more right behind them. While the context is lost
    /// they are kept, and there once it is restored. Errors: bad_argument (a gap before `first`, frames other than those of
    /// the instances before, an instance as crowd_joint() refuses it); unsupported (more than the capacity). Nothing is
    /// changed then. Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and 128 B an
    /// instance, in at most three pieces; where the GPU still draws from the texture the driver may wait or copy it.
    #[link_name = "mrw_gles3_set_instances"]
    pub fn gles3_set_instances(api: *const Gles3Api, crowd: *mut Gles3Crowd, frames: *const Gles3CrowdFrames, first: u32, instances: *const Gles3CrowdInstance, instance_count: usize) -> Status;
    /// The program for blend_crowd(). Errors: gl_error, with the driver's words in `log`. Cost: a compile.
    #[link_name = "mrw_gles3_build_crowd_program"]
    pub fn gles3_build_crowd_program(api: *const Gles3Api, out: *mut Gles3Program, log: *mut c_char, log_bytes: usize) -> Status;
    /// The same and, for a kind of mesh, each role's program that reads palettes of crowds, in a set: what it lacks is
    /// compiled. The set brings them back after a loss of the context. deformer: one that the mesh was prepared for.
    /// features: what programs are to read of what the mesh has. Errors: bad_argument (Deformer::none, no role);
    /// unsupported (a full set); gl_error, with the driver's words in programs.log.
    #[link_name = "mrw_gles3_build_crowd_programs"]
    pub fn gles3_build_crowd_programs(api: *const Gles3Api, caps: *const Gles3Caps, mesh: *const Gles3CrowdMesh, deformer: Gles3Deformer, features: u8, programs: *mut Gles3ProgramSet) -> Status;
    /// What was built with the same arguments, never null.
    #[link_name = "mrw_gles3_crowd_program_of"]
    pub fn gles3_crowd_program_of(mesh: *const Gles3CrowdMesh, deformer: Gles3Deformer, features: u8, programs: *const Gles3ProgramSet, role: u32) -> *const Gles3Program;
    /// What was built with the same arguments, never null.
    #[link_name = "mrw_gles3_blending_program_of"]
    pub fn gles3_blending_program_of(programs: *const Gles3ProgramSet) -> *const Gles3Program;
    /// With motion: once a frame, before blend_crowd(). What was blended is now the frame before. No call to GL.
    #[link_name = "mrw_gles3_begin_crowd_frame"]
    pub fn gles3_begin_crowd_frame(mesh: *mut Gles3CrowdMesh);
    /// With motion: what the frame before is of instances that were not blended in it, or not where they are now: those that
    /// have been set since to play or stand elsewhere at once. It is as they are set now, at time_s: that of the frame
    /// before, and they move as their clips do; this frame's, and they stand still. Instances beside them stay as they are.
    /// Otherwise as blend_crowd(). Errors: as there; bad_argument too of a mesh without motion.
    #[link_name = "mrw_gles3_blend_previous_crowd"]
    pub fn gles3_blend_previous_crowd(api: *const Gles3Api, crowd: *const Gles3Crowd, mesh: *const Gles3CrowdMesh, first: u32, count: u32, time_s: f64, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// Writes the palettes of `count` instances from `first` on, as they are at time_s of the crowd's clock, placed in the
    /// scene: one triangle, a fragment a row of a matrix; once a frame, however often they are drawn then. `program`, from
    /// build_crowd_program(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and GL_RASTERIZER_DISCARD must be off and no
    /// colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport as large as the texture, `texture_unit`
    /// and the one behind it bound and the latter active. Errors: bad_argument (a program of another kind, instances that
    /// are not there, frames other than the mesh's, a time that is not finite); unsupported (more instances than the mesh
    /// has capacity for); gl_error (the context is lost).
    #[link_name = "mrw_gles3_blend_crowd"]
    pub fn gles3_blend_crowd(api: *const Gles3Api, crowd: *const Gles3Crowd, mesh: *const Gles3CrowdMesh, first: u32, count: u32, time_s: f64, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// The next draw() with `count` instances draws those from `first` on, as they were blended. `program`, which must be in
    /// use, reads palettes of crowds. Binds two texture units as blend_crowd() does, with kMotion the one behind them, too.
    /// Errors: as there.
    #[link_name = "mrw_gles3_bind_crowd"]
    pub fn gles3_bind_crowd(api: *const Gles3Api, crowd: *const Gles3Crowd, mesh: *const Gles3CrowdMesh, first: u32, count: u32, texture_unit: u32, program: *const Gles3Program) -> Status;
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
    #[link_name = "mrw_gles3_crowd_mesh_on_context_lost"]
    pub fn gles3_crowd_mesh_on_context_lost(mesh: *mut Gles3CrowdMesh);
    /// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
    /// on_context_restored() blend_crowd() and bind_crowd() refuse. Meshes, crowds and the program set in any order.
    #[link_name = "mrw_gles3_crowd_on_context_lost"]
    pub fn gles3_crowd_on_context_lost(crowd: *mut Gles3Crowd);
    /// Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
    /// creation does. Errors: as creation, but for its arguments; then it may be tried again.
    #[link_name = "mrw_gles3_crowd_mesh_on_context_restored"]
    pub fn gles3_crowd_mesh_on_context_restored(api: *const Gles3Api, caps: *const Gles3Caps, mesh: *mut Gles3CrowdMesh) -> Status;
    /// Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
    /// creation does. Errors: as creation, but for its arguments; then it may be tried again.
    #[link_name = "mrw_gles3_crowd_on_context_restored"]
    pub fn gles3_crowd_on_context_restored(api: *const Gles3Api, caps: *const Gles3Caps, crowd: *mut Gles3Crowd) -> Status;
    #[link_name = "mrw_gles3_path_result_init"]
    pub fn gles3_path_result_init(out: *mut Gles3PathResult);
    #[link_name = "mrw_gles3_self_test_init"]
    pub fn gles3_self_test_init(out: *mut Gles3SelfTest);
    #[link_name = "mrw_gles3_self_test_options_init"]
    pub fn gles3_self_test_options_init(out: *mut Gles3SelfTestOptions);
    #[link_name = "mrw_gles3_path_need_init"]
    pub fn gles3_path_need_init(out: *mut Gles3PathNeed);
    /// "usable", or why a path is ruled out, in a few words; "" for a value that is none.
    #[link_name = "mrw_gles3_verdict_text"]
    pub fn gles3_verdict_text(verdict: Gles3Verdict) -> *const c_char;
    /// Bytes of memory that self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as the defaults.
    #[link_name = "mrw_gles3_self_test_bytes"]
    pub fn gles3_self_test_bytes(options: *const Gles3SelfTestOptions) -> usize;
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
    #[link_name = "mrw_gles3_run_self_test"]
    pub fn gles3_run_self_test(api: *const Gles3Api, caps: *const Gles3Caps, options: *const Gles3SelfTestOptions, memory: *mut c_void, memory_bytes: usize, out: *mut Gles3SelfTest) -> Status;
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
    #[link_name = "mrw_gles3_choose"]
    pub fn gles3_choose(test: *const Gles3SelfTest, need: *const Gles3PathNeed, out: *mut Gles3SkinningPath) -> Status;
    /// Writes kSavedSelfTestBytes. Errors: bad_argument (`out` too short).
    #[link_name = "mrw_gles3_save"]
    pub fn gles3_save(test: *const Gles3SelfTest, out: *mut c_void, out_bytes: usize) -> Status;
    /// The result in bytes that save() has written, if it still holds. Errors: truncated, bad_magic, bad_version,
    /// bad_checksum, bad_data; mismatch (another driver, version of it, library, or other caps or options): then test anew,
    /// and with another driver without what had crashed. `out` is written only on success.
    #[link_name = "mrw_gles3_restore"]
    pub fn gles3_restore(api: *const Gles3Api, caps: *const Gles3Caps, options: *const Gles3SelfTestOptions, saved: *const c_void, saved_bytes: usize, out: *mut Gles3SelfTest) -> Status;
}
