"""Comments as C's headers have them: what a C program calls, in lines that fit.

usage: python3 tests/c/words_test.py
"""
import pathlib
import sys
import tempfile
import unittest
from types import SimpleNamespace

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/c_api"))
# pylint: disable=wrong-import-position
import c_words
import description

RUNTIME = """
header status.h
enum status Status u8: ok bad_data unsupported
header file.h
const max_joints u32 kMaxJoints = 9
struct skeleton Skeleton
  joint_count u32
  parents u16[]
struct file File
  bytes u32
fn file.skeleton(index: u32, out: skeleton mut) -> status
fn load(block: byte[], out: file mut) -> status
fn skeleton.soa_size() -> size
header pose.h
fn draw(a: skeleton) -> status as draw_a
fn draw(b: skeleton) -> status as draw_b
fn to_model(local: f32[]) -> status
"""
GLES3 = """
namespace gles3
header gles3.h
enum path Path u8: cpu gpu
fn draw(c: skeleton) -> status
"""


def rows_of(text, above):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "api.txt"
        file.write_text(text)
        return description.read_rows(file, above, "wrappers.cpp", lambda name: [])


class Words(unittest.TestCase):
    def setUp(self):
        c = SimpleNamespace(header="c.h", rows=rows_of(RUNTIME, []))
        gles3 = SimpleNamespace(header="c_gles3.h", rows=rows_of(GLES3, c.rows))
        self.rows = {row.name: row for row in c.rows}
        self.c, self.gles3 = (c_words.Words(part, [c, gles3]) for part in (c, gles3))

    def says(self, text, wanted, header="file.h", about=None):
        self.assertEqual(self.c.comment(text.split("\n"), header, self.rows.get(about)), wanted.split("\n"))

    def test_names(self):
        self.says("At most kMaxJoints, see load().", "At most MRW_MAX_JOINTS, see mrw_load().")
        self.says("Errors: bad_data; unsupported. Status::ok is 0.", "Errors: MRW_BAD_DATA; MRW_UNSUPPORTED. MRW_OK is 0.")
        self.says("Of a Skeleton, as marrow::Skeleton::parents.", "Of an mrw_skeleton, as mrw_skeleton.parents.")
        self.says("By gles3::Path::gpu or File::skeleton().", "By MRW_GLES3_PATH_GPU or mrw_file_skeleton().")
        self.says("By to_model, not by load.", "By mrw_to_model, not by load.")

    def test_what_stays(self):
        for text in ("File it. Skeleton first.", "Skeleton Rules of 1999", 'docs/format.md, "Skeleton"', "MARROW_API of load"):
            self.says(text, text)

    def test_lists(self):
        self.says("A span of Spans: parents.size and Skeleton.", "A list of lists: parent_count and mrw_skeleton.", about="skeleton")
        self.says("skeleton.soa_size(), skeleton.parents.size", "mrw_skeleton_soa_size(skeleton), skeleton.parent_count")

    def test_overloads(self):
        self.says("draw(b)", "mrw_draw_b(b)", header="pose.h")
        self.says("draw()", "mrw_draw_a()", header="pose.h", about="draw_a")
        self.says("draw()", "mrw_draw_…()", header="pose.h")
        self.says("draw() of gles3.h", "mrw_gles3_draw() of part gles3 of c_gles3.h", header="pose.h")

    def test_headers_are_parts(self):
        self.says("See pose.h. file.h has more; so has glm.h.", "See part pose. Part file has more; so has glm.h.")
        self.assertEqual(self.gles3.comment(["As pose.h"], "gles3.h"), ["As part pose of c.h"])

    def test_a_member_that_is_not_there_is_an_error(self):
        with self.assertRaises(SystemExit) as stop:
            self.says("into Skeleton::names", "")
        self.assertIn("Skeleton::names", str(stop.exception))

    def test_lines_that_grow_are_filled_anew(self):
        full = "x" * 99 + " kMaxJoints abc"
        self.says(full + "\ndef", "x" * 99 + " MRW_MAX_JOINTS\nabc def")
        self.says("short\n" + full, "short\n" + "x" * 99 + " MRW_MAX_JOINTS\nabc")
        self.says("  once   " + "x" * 95 + " kMaxJoints abc", "  once   " + "x" * 95 + "\n         MRW_MAX_JOINTS abc")


if __name__ == "__main__":
    unittest.main()
