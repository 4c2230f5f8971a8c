// [[shapes]] of marrow.toml: what is read, and every mistake with its place.
#include <string>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/settings.h"

namespace marrow::cook {
namespace {

Settings parse_shapes(const std::string& text) {
  return parse_settings("/project/marrow.toml", text);
}

TEST(ShapeSettings, AreRead) {
  const Settings settings = parse_shapes(R"(
[[shapes]]
name = "face"
mesh = "head"
parameters = ["joy", { name = "anger", default = 0.25 }]
examples = [
  { at = [0, 0] },
  { target = "smile", at = [1, 0] },
  { target = "frown", at = [-0.5, 1.5] },
]

[[file]]
match = "b*"

[[file.shapes]]
name = "hand"
parameters = ["fist"]
examples = [{ at = [0] }, { at = [1], target = "closed" }]
)");
  std::vector<bool> used;
  const CookOptions a = to_options(settings_for(settings, "/project/a.glb", used));
  ASSERT_EQ(a.shapes.size(), 1u);
  const ShapeRule& face = a.shapes[0];
  EXPECT_EQ(face.name, "face");
  EXPECT_EQ(face.mesh, "head");
  EXPECT_EQ(face.origin.where, "2:1");
  EXPECT_FALSE(face.origin.must_fit);
  ASSERT_EQ(face.parameters.size(), 2u);
  EXPECT_EQ(face.parameters[0].name, "joy");
  EXPECT_EQ(face.parameters[0].rest, 0);
  EXPECT_EQ(face.parameters[1].rest, 0.25f);
  ASSERT_EQ(face.examples.size(), 3u);
  EXPECT_EQ(face.examples[0].target, "");
  EXPECT_EQ(face.examples[2].target, "frown");
  EXPECT_EQ(face.examples[2].at, (std::vector<float>{-0.5f, 1.5f}));
  EXPECT_EQ(face.examples[2].where, "9:3");
  const CookOptions b = to_options(settings_for(settings, "/project/b.glb", used));
  ASSERT_EQ(b.shapes.size(), 1u) << "the rule's, in place of those at the top";
  EXPECT_EQ(b.shapes[0].name, "hand");
}

// What a cache goes by.
TEST(ShapeSettings, CountAndTheirPlaceDoesNot) {
  const auto text = [](const std::string& toml) { return canonical_text(parse_shapes(toml).defaults); };
  const std::string one = "[[shapes]]\nname='n'\nparameters=['p']\nexamples=[{at=[0]},{at=[1],target='t'}]\n";
  EXPECT_EQ(text(one), text("\n\n" + one + "# more\n"));
  const char* others[] = {
      "[[shapes]]\nname='m'\nparameters=['p']\nexamples=[{at=[0]},{at=[1],target='t'}]\n",
      "[[shapes]]\nname='n'\nparameters=['q']\nexamples=[{at=[0]},{at=[1],target='t'}]\n",
      "[[shapes]]\nname='n'\nparameters=['p']\nexamples=[{at=[0]},{at=[2],target='t'}]\n",
      "[[shapes]]\nname='n'\nparameters=['p']\nexamples=[{at=[0]},{at=[1],target='u'}]\n",
      "[[shapes]]\nname='n'\nmesh='m'\nparameters=['p']\nexamples=[{at=[0]},{at=[1],target='t'}]\n",
      "[[shapes]]\nname='n'\nparameters=[{name='p',default=1}]\nexamples=[{at=[0]},{at=[1],target='t'}]"};
  for (const char* const other : others) EXPECT_NE(text(one), text(other)) << other;
}

std::string list_of(int count, const std::string& before, const std::string& behind) {
  std::string out;
  for (int i = 0; i < count; ++i) out += before + std::to_string(i) + behind + ", ";
  return out;
}

TEST(ShapeSettings, MistakesAreLocated) {
  const std::string head = "[[shapes]]\nname = 'n'\nparameters = ['p', 'q']\n";
  const struct {
    std::string text;
    const char *where, *says;
  } cases[] = {
      {"shapes = 3", "1:10", "must be a list of tables"},
      {"shapes = [3]", "1:11", "a shape must be a table"},
      {"[[shapse]]\nname = 'n'", "1:3", "did you mean \"shapes\"?"},
      {"[[shapes]]\nname = 'n'", "1:1", "a shape without \"parameters\""},
      {"[[shapes]]\nparameters = ['p']", "1:1", "a shape without \"name\""},
      {"[[shapes]]\nname = ''", "2:8", "\"name\" must be a string"},
      {"[[shapes]]\nname = 3", "2:8", "\"name\" must be a string"},
      {head, "1:1", "a shape without \"examples\""},
      {head + "exmples = []", "4:1", "a shape has no \"exmples\": did you mean \"examples\"?"},
      {head + "mesh = 1\nexamples = []", "4:8", "\"mesh\" must be a string"},
      {head + "examples = 1", "4:12", "\"examples\" must be a list"},
      {head + "examples = []", "4:12", "less than two examples"},
      {head + "examples = [{ at = [0, 0], target = 't' }]", "4:12", "less than two examples"},
      {head + "examples = [{ at = [0, 0] }, { at = [1, 0] }]", "4:12", "no example has a target"},
      {head + "examples = [1]", "4:13", "an example must be a table"},
      {head + "examples = [{ target = 't' }]", "4:13", "an example without \"at\""},
      {head + "examples = [{ at = [0] }]", "4:20", "1 numbers for 2 parameters"},
      {head + "examples = [{ at = [0, 1, 2] }]", "4:20", "3 numbers for 2 parameters"},
      {head + "examples = [{ at = [0, 'x'] }]", "4:24", "must be a number from -1e+06 to 1e+06"},
      {head + "examples = [{ at = [0, nan] }]", "4:24", "must be a number from -1e+06 to 1e+06"},
      {head + "examples = [{ at = [0, -inf] }]", "4:24", "must be a number from -1e+06 to 1e+06"},
      {head + "examples = [{ at = [0, 1e7] }]", "4:24", "must be a number from -1e+06 to 1e+06"},
      {head + "examples = [{ at = [0, 1] },\n { at = [1e-9, 1], target = 't' }]", "5:2", "at the place of another"},
      {head + "examples = [{ at = [0, 1], targt = 't' }]", "4:28", "an example has no \"targt\""},
      {head + "examples = [{ at = [0, 1], target = 1 }]", "4:37", "\"target\" must be a string"},
      {"[[shapes]]\nname = 'n'\nparameters = []\nexamples = []", "1:1", "a shape without parameters"},
      {"[[shapes]]\nname = 'n'\nparameters = [1]", "3:15", "a parameter must be a table"},
      {"[[shapes]]\nname = 'n'\nparameters = [{ default = 1 }]", "3:15", "a parameter without \"name\""},
      {"[[shapes]]\nname = 'n'\nparameters = ['p', 'p']", "3:20", "a second parameter \"p\""},
      {"[[shapes]]\nname = 'n'\nparameters = [{ name = 'p', default = inf }]", "3:39",
       "must be a number from -1e+06 to 1e+06"},
      {"[[shapes]]\nname = 'n'\nparameters = [" + list_of(9, "'p", "'") + "]", "3:63", "more than 8 parameters"},
      {"[[shapes]]\nname = 'n'\nparameters = ['p']\nexamples = [" + list_of(65, "{ at = [", "] }") + "]", "4:963",
       "more than 64 examples"},
  };
  for (const auto& c : cases) {
    try {
      parse_shapes(c.text);
      ADD_FAILURE() << c.text;
    } catch (const tools::Failure& f) {
      EXPECT_EQ(f.code(), tools::Exit::usage);
      EXPECT_EQ(f.file(), "/project/marrow.toml");
      EXPECT_EQ(f.where(), c.where) << f.what();
      EXPECT_NE(std::string(f.what()).find(c.says), std::string::npos) << f.what() << "\nnot " << c.says;
    }
  }
}

}  // namespace
}  // namespace marrow::cook
