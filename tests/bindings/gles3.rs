// What tests/bindings/gles3.c does, in Rust: the same lines must come of it.
mod marrow;

use marrow::*;
use std::ffi::CStr;
use std::os::raw::{c_char, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};

#[link(name = "EGL")]
extern "C" {
    fn eglGetProcAddress(name: *const c_char) -> *mut c_void;
    fn eglGetPlatformDisplay(platform: c_uint, native: *mut c_void, attributes: *const isize) -> *mut c_void;
    fn eglInitialize(display: *mut c_void, major: *mut c_int, minor: *mut c_int) -> c_uint;
    fn eglBindAPI(api: c_uint) -> c_uint;
    fn eglCreateContext(display: *mut c_void, config: *mut c_void, share: *mut c_void, wanted: *const c_int) -> *mut c_void;
    fn eglMakeCurrent(display: *mut c_void, draw: *mut c_void, read: *mut c_void, context: *mut c_void) -> c_uint;
}

fn must(status: Status) {
    if status != Status::OK {
        panic!("{}", unsafe { CStr::from_ptr(status_text(status)) }.to_str().unwrap());
    }
}

fn path_text(path: Gles3SkinningPath) -> &'static str {
    unsafe { CStr::from_ptr(gles3_skinning_path_text(path)) }.to_str().unwrap()
}

unsafe fn open_context() {
    let display = eglGetPlatformDisplay(0x31DD, null_mut(), null()); // Mesa's surfaceless platform
    assert_eq!(eglInitialize(display, null_mut(), null_mut()), 1);
    assert_eq!(eglBindAPI(0x30A0), 1); // OpenGL ES
    let version = [0x3098, 3, 0x3038];
    let context = eglCreateContext(display, null_mut(), null_mut(), version.as_ptr());
    assert_eq!(eglMakeCurrent(display, null_mut(), null_mut(), context), 1);
}

fn main() {
    unsafe {
        assert_eq!(gles3_abi(), GLES3_ABI);
        open_context();
        let (mut api, mut caps) = (Gles3Api::default(), Gles3Caps::default());
        must(gles3_load_api(&mut api, Some(eglGetProcAddress), null_mut()));
        must(gles3_query_caps(&api, &mut caps));
        println!("{} {} {}", caps.uniform_block_bytes, caps.texture_size, caps.compute as u32);
        let options = Gles3SelfTestOptions::default();
        let bytes = gles3_self_test_bytes(&options);
        let mut memory = vec![Affine::default(); bytes / 48 + 1];
        let mut test = Gles3SelfTest::default();
        must(gles3_run_self_test(&api, &caps, &options, memory.as_mut_ptr() as *mut c_void, bytes, &mut test));
        for (i, result) in test.paths.iter().enumerate() {
            println!("{} {} {:.7}", path_text(Gles3SkinningPath(i as u8)), result.verdict.0, result.position_error);
        }
        let mut best = Gles3SkinningPath::default();
        must(gles3_choose(&test, &Gles3PathNeed::default(), &mut best));
        println!("{}", path_text(best));
    }
}
