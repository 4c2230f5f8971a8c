// What tests/c/road.c does, in Rust: the same lines must come of it.
mod marrow;

use marrow::*;
use std::ffi::{CStr, CString};
use std::os::raw::{c_char, c_void};
use std::ptr::{null, null_mut};
use std::sync::atomic::{AtomicU32, Ordering};

fn must(status: Status) {
    if status != Status::OK {
        let text = unsafe { CStr::from_ptr(status_text(status)) };
        panic!("{}", text.to_str().unwrap());
    }
}

// Bytes on a boundary of 16.
fn block(bytes: usize) -> Vec<Affine> {
    vec![Affine::default(); bytes / 48 + 1]
}

struct Hash(u32);
impl Hash {
    fn add<T>(&mut self, first: *const T, words: usize) {
        for &word in unsafe { std::slice::from_raw_parts(first as *const u32, words) } {
            self.0 = (self.0 ^ word).wrapping_mul(16777619);
        }
    }
}

unsafe fn find_joint(file: &File, skeleton: &Skeleton, name: &str) -> u32 {
    let name = CString::new(name).unwrap();
    file_find_joint(file, skeleton, name.as_ptr())
}

static TOLD: AtomicU32 = AtomicU32::new(0);
unsafe extern "C" fn on_call_error(_function: *const c_char, _condition: *const c_char) {
    TOLD.fetch_add(1, Ordering::Relaxed);
}

unsafe fn refuse(bytes: &[u8], file: &File) {
    let mut copy = block(bytes.len() + 4);
    let copied = copy.as_mut_ptr() as *mut u8;
    let (mut skeleton, zeros) = (Skeleton::default(), Pose::default());
    let (mut clip, mut mesh, mut other) = (Clip::default(), Mesh::default(), File::default());
    let mut pose = vec![SoaTransform::default(); 64];
    must(file_skeleton(file, 0, &mut skeleton));
    must(file_clip(file, 0, &mut clip));
    must(file_mesh(file, 0, 0, &mut mesh));
    set_call_error_handler(Some(on_call_error));
    let bad = Status::BAD_ARGUMENT;
    assert_eq!(load(null(), 0, &mut other, null_mut()), bad);
    assert_eq!(load(null(), 64, &mut other, null_mut()), bad);
    assert_eq!(load(bytes.as_ptr() as *const c_void, bytes.len(), null_mut(), null_mut()), bad);
    let size = skeleton_soa_size(&skeleton);
    assert_eq!(sample(&skeleton, &clip, 0.0, pose.as_mut_ptr(), size - 1, null()), bad);
    let limb = TwoBoneLimb::default();
    assert_eq!(solve_two_bone(&zeros, &limb, &TwoBone::default(), null_mut()), bad);
    assert_eq!(skin_ssd(&mesh, null(), 3, &SkinOutput::default()), bad);
    copied.add(4).copy_from(bytes.as_ptr(), bytes.len());
    assert_eq!(load(copied.add(4) as *const c_void, bytes.len(), &mut other, null_mut()), bad);
    copied.copy_from(bytes.as_ptr(), bytes.len());
    assert_eq!(load(copied as *const c_void, bytes.len() - 16, &mut other, null_mut()), Status::TRUNCATED);
    *copied.add(4) += 1;
    assert_eq!(load(copied as *const c_void, bytes.len(), &mut other, null_mut()), Status::BAD_VERSION);
    set_call_error_handler(None);
    println!("9 refused, {} told", TOLD.load(Ordering::Relaxed));
}

unsafe fn reach(file: &File, pose: &Pose, springs: &mut Springs, dt_s: f32) {
    let neck = [find_joint(file, &pose.skeleton, "neck"), find_joint(file, &pose.skeleton, "head")];
    let look = Aim { target: [0.5, 1.25, 2.0], weight: 0.5, ..Aim::default() };
    must(solve_look_at(pose, neck.as_ptr(), 2, &look, 0.5, null_mut()));
    let leg = TwoBoneLimb {
        start: find_joint(file, &pose.skeleton, "thigh.L"),
        mid: find_joint(file, &pose.skeleton, "shin.L"),
        end: find_joint(file, &pose.skeleton, "foot.L"),
    };
    let foot = (*pose.model_from_joint.add(leg.end as usize)).rows;
    let target = [foot[0][3] + 0.0625, foot[1][3] + 0.0625, foot[2][3] + 0.0625];
    let step = TwoBone { target, ..TwoBone::default() };
    must(solve_two_bone(pose, &leg, &step, null_mut()));
    let frame = SpringFrame { dt_s, ..SpringFrame::default() };
    must(simulate_springs(pose, &frame, springs));
}

unsafe fn skin(hash: &mut Hash, m: &CharacterMesh) {
    let floats = 3 * m.mesh.geometry.slot_count as usize;
    let (mut positions, mut normals) = (vec![0f32; floats], vec![0f32; floats]);
    let mut out = SkinOutput {
        positions: positions.as_mut_ptr(),
        position_count: floats,
        normals: normals.as_mut_ptr(),
        normal_count: floats,
        ..SkinOutput::default()
    };
    must(skin_ssd(&m.mesh, m.palette, m.palette_count, &out));
    hash.add(m.palette, 12 * m.palette_count);
    hash.add(positions.as_ptr(), floats);
    hash.add(normals.as_ptr(), floats);
    out.normal_count = 0;
    must(skin_as(&m.mesh, m.coordinates, m.coordinate_count, m.palette, m.palette_count, &out, null(), 0));
    hash.add(positions.as_ptr(), floats);
}

unsafe fn road(name: &str) -> u32 {
    let read = std::fs::read(name).unwrap();
    let mut memory = block(read.len());
    let mut bytes = std::slice::from_raw_parts_mut(memory.as_mut_ptr() as *mut u8, read.len());
    bytes.copy_from_slice(&read);
    let mut unpacked;
    if is_packed(bytes.as_ptr() as *const c_void, bytes.len()) {
        let mut decoders = [MeshDecoder::default(); 2];
        let (mut sizes, mut out) = (UnpackSizes::default(), Bytes::default());
        must(draco_decoder(&mut decoders[0]));
        must(meshopt_decoder(&mut decoders[1]));
        must(find_unpack_sizes(bytes.as_ptr() as *const c_void, bytes.len(), &mut sizes, null_mut()));
        unpacked = block(sizes.memory_bytes as usize);
        must(unpack(bytes.as_ptr() as *const c_void, bytes.len(), decoders.as_ptr(), 2,
            unpacked.as_mut_ptr() as *mut c_void, sizes.memory_bytes as usize, &mut out, null_mut()));
        bytes = std::slice::from_raw_parts_mut(out.data as *mut u8, out.size);
    }
    let mut file = File::default();
    must(load(bytes.as_ptr() as *const c_void, bytes.len(), &mut file, null_mut()));
    refuse(bytes, &file);

    let (mut animations, mut character) = (Animations::default(), Character::default());
    let options = CharacterOptions { animation_space: true, ..CharacterOptions::default() };
    let size = animations_bytes(&file, &file);
    let mut shared = block(size);
    must(make_animations(&file, &file, shared.as_mut_ptr() as *mut c_void, size, &mut animations));
    let size = character_bytes(&file, &options);
    let mut own = block(size);
    must(make_character(&file, &options, own.as_mut_ptr() as *mut c_void, size, &mut character));
    let walk = find_animation(&animations, b"walk\0".as_ptr() as *const c_char).as_ref().unwrap();
    let idle = find_animation(&animations, b"idle\0".as_ptr() as *const c_char).as_ref().unwrap();

    let pose = &(*character.skeletons).pose;
    let joints: Vec<SpringJoint> = (3..7)
        .map(|i| SpringJoint {
            joint: find_joint(&file, &pose.skeleton, &format!("tail_{i}")) as u16,
            ..SpringJoint::default()
        })
        .collect();
    let chain = SpringChain { joints: joints.as_ptr(), joint_count: 4, ..SpringChain::default() };
    let size = springs_bytes(&pose.skeleton, &chain, 1);
    let mut of_springs = block(size);
    let mut tail = Springs::default();
    must(make_springs(&pose.skeleton, &chain, 1, of_springs.as_mut_ptr() as *mut c_void, size, &mut tail));

    let mut hash = Hash(2166136261);
    let mut playback = Playback::default();
    let dt_s = 1.0f32 / 60.0;
    for _ in 0..30 {
        must(advance(&mut playback, walk.duration_s, dt_s));
        let time_s = clip_time(&playback);
        let layers = [
            AnimationLayer { animation: walk, time_s, ..AnimationLayer::default() },
            AnimationLayer { animation: idle, time_s, weight: 0.25, ..AnimationLayer::default() },
        ];
        must(pose_character(&mut character, layers.as_ptr(), 2));
        reach(&file, pose, &mut tail, dt_s);
        must(finish_character(&mut character));
        hash.add(pose.local, 40 * pose.local_count);
        hash.add(pose.model_from_joint, 12 * pose.model_from_joint_count);
        for i in 0..character.mesh_count {
            skin(&mut hash, &*character.meshes.add(i));
        }
    }
    hash.0
}

fn main() {
    let name = std::env::args().nth(1).unwrap();
    unsafe {
        assert_eq!(abi(), ABI, "the library is of another ABI");
        println!("{:08x}", road(&name));
    }
}
