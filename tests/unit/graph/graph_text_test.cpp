// Texts of graphs that are wrong: the line and column of what is, and the word that helps; what editors know of them.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "cook/graph/build_graph.h"
#include "support/json_schema.h"
#include "support/places.h"
#include "unit/graph/graph_mistakes.h"
#include "unit/graph/oracle_random.h"

namespace marrow::cook {
namespace {

const std::vector<Mistake> kMistakes = {
    {1, "", "", "without \"output\""},
    {1, "output = 1", "1:10", "must be a string"},
    {1, "output = ''", "1:10", "leave it out rather than empty"},
    {1, "output = all", "1:", "no TOML"},
    {1, "outptu = 'all'", "1:1", "did you mean \"output\"?"},
    {2, "[parametres]", "2:2", "did you mean \"parameters\"?"},
    {3, "speed = 1", "3:9", "a parameter must be a table"},
    {3, "speed = { range = [0, 6] }", "3:9", "without \"type\""},
    {3, "speed = { type = 'nmber', range = [0, 6] }", "3:18", "did you mean \"number\"?"},
    {3, "speed = { type = 'number' }", "3:9", "without \"range\""},
    {3, "speed = { type = 'number', range = [0] }", "3:36", "two numbers"},
    {3, "speed = { type = 'number', range = [6, 0] }", "3:36", "ends below its begin"},
    {3, "speed = { type = 'number', range = [0, 'six'] }", "3:40", "must be a number"},
    {3, "speed = { type = 'number', range = [0, nan] }", "3:40", "must be a number"},
    {3, "speed = { type = 'number', range = [0, 6], initial = 7 }", "3:54", "from 0 to 6"},
    {3, "speed = { type = 'number', range = [0, 6], half_life = -1 }", "3:56", "from 0 to 1e+06"},
    {3, "speed = { type = 'number', range = [0, 6], hold = 1 }", "3:44", "a number has no \"hold\""},
    {5, "armed = { type = 'flag', initial = 1 }", "5:36", "true or false"},
    {5, "armed = { type = 'flag', range = [0, 1] }", "5:26", "a flag has no \"range\""},
    {6, "jump = { type = 'trigger', hold = 'long' }", "6:35", "must be a number"},
    {6, "jump = { type = 'trigger', initial = true }", "6:28", "a trigger has no \"initial\""},
    {8, "type = 'clp'", "8:8", "did you mean \"clip\"?"},
    {8, "", "7:1", "without \"type\""},
    {9, "", "7:1", "without \"clip\""},
    {9, "clipp = 'walk'", "9:1", "did you mean \"clip\"?"},
    {10, "speed = 65", "10:9", "from -64 to 64"},
    {10, "speed = inf", "10:9", "from -64 to 64"},
    {11, "play = 'lop'", "11:8", "did you mean \"loop\"?"},
    {14, "by = 'sped'", "14:6", "did you mean \"speed\"?"},
    {14, "by = 'armed'", "14:6", "\"armed\" is no number"},
    {14, "by = ['speed', 'bend', 'speed']", "14:6", "more than two numbers"},
    {14, "by = []", "14:6", "names nothing"},
    {15, "points = []", "15:10", "no points"},
    {15, "points = 'idle'", "15:10", "must be a list"},
    {15, "points = [ { at = 0 } ]", "15:12", "without \"pose\""},
    {15, "points = [ { at = 'x', pose = 'idle' } ]", "15:19", "must be a number"},
    {15, "points = [ { at = 0, pose = 'idle' }, { at = 0, pose = 'walk' } ]", "15:29", "two points at one place"},
    {15, "points = [ { at = 0, pose = 'variants' } ]", "15:29", "must be clips"},
    {15, "points = [ { at = 0, pos = 'idle' } ]", "15:22", "did you mean \"pose\"?"},
    {16, "match_speed = 'yes'", "16:15", "true or false"},
    {17, "sync = false", "16:15", "match_speed is for clips in step"},
    {20, "by = ['speed', 'bnd']", "20:16", "did you mean \"bend\"?"},
    {21, "points = [ { pose = 'idle' } ]", "21:12", "without \"at\""},
    {21, "points = [ { at = 1, pose = 'idle' } ]", "21:19", "two numbers"},
    {21, "points = [ { at = [1], pose = 'idle' } ]", "21:19", "two numbers"},
    {21, "points = [ { at = [0, 0], pose = 'a' }, { at = [1, 1], pose = 'b' }, { at = [2, 2], pose = 'c' } ]", "21:34",
     "on one line"},
    {21, "points = [ { at = [0, 0], pose = 'a' }, { at = [0, 0], pose = 'b' }, { at = [2, 0], pose = 'c' } ]", "21:34",
     "at one place"},
    {21, "points = [ { at = [0, 0], pose = 'all' }, { at = [1, 0], pose = 'b' }, { at = [0, 1], pose = 'c' } ]",
     "21:34", "made of itself"},
    {24, "start = 'grond'", "24:9", "did you mean \"ground\"?"},
    {24, "", "22:1", "without \"start\""},
    {25, "state.ground = 'plane'", "25:16", "a state must be a table"},
    {25, "state.ground = { poses = 'plane' }", "25:18", "did you mean \"pose\"?"},
    {26, "state.air = {}", "26:7", "shows nothing"},
    {27, "state.land = { pose = 'plane' }", "27:23", "which is no clip"},
    {29, "  { from = 'grnd', to = 'air', when = 'jump' },", "29:12", "did you mean \"ground\"?"},
    {29, "  { from = 'ground', to = 'ar', when = 'jump' },", "29:27", "did you mean \"air\"?"},
    {29, "  { from = 'ground', to = 'air' },", "29:3", "taken at once"},
    {29, "  { from = 'ground', when = 'jump' },", "29:3", "without \"to\""},
    {29, "  { from = 'ground', to = 'air', when = 'jmp' },", "29:41", "did you mean \"jump\"?"},
    {29, "  { from = 'ground', to = 'air', when = 'speed' },", "29:41", "as in \"speed > 0.5\""},
    {29, "  { from = 'ground', to = 'air', when = 'jump > 1' },", "29:41", "\"jump\" is no number"},
    {29, "  { from = 'ground', to = 'air', when = 'speed > fast' },", "29:41", "compares with no number"},
    {29, "  { from = 'ground', to = 'air', when = 'speed >' },", "29:41", "compares with no number"},
    {29, "  { from = 'ground', to = 'air', when = 'speed > nan' },", "29:41", "compares with no number"},
    {29, "  { from = 'ground', to = 'air', when = 1 },", "29:41", "a condition, or a list"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', fade = -1 },", "29:56", "from 0 to 1e+06"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', kind = 'inert' },", "29:56", "\"inertial\""},
    {29, "  { from = 'ground', to = 'air', when = 'jump', fad = 1 },", "29:49", "did you mean \"fade\"?"},
    {30, "  { from = [], to = 'land', after = 0.5 },", "30:12", "names nothing"},
    {30, "  { from = 'air', to = 'land', after = 'soon' },", "30:40", "must be a number"},
    {30, "  { from = 'ground', to = 'land', at_end = 0.5 },", "25:25", "which is no clip"},
    {31, "  { from = 'land', to = 'ground', at_end = 0.1, enter = 'begining' },", "31:57",
     "did you mean \"beginning\"?"},
    {31, "  { from = 'land', to = 'ground', at_end = 0.1, enter = -1 },", "31:57", "from 0 to 1e+06"},
    {32, "  { from = '*', to = ['ground', 'land'], when = 'jump' },", "32:33", "must follow one another"},
    {32, "  { from = '*', to = 'air', choose = 'dice', when = 'jump' },", "32:38", "\"chance\""},
    {36, "base = 'guard'", "36:8", "made of itself"},
    {36, "", "34:1", "without \"base\""},
    {37, "pose = 3", "37:8", "must be a string"},
    {38, "mask = { role = 'chst' }", "38:17", "did you mean \"chest\"?"},
    {38, "mask = {}", "38:8", "a role or a joint"},
    {38, "mask = { role = 'chest', joint = 'x' }", "38:8", "a role or a joint"},
    {38, "mask = 'chest'", "38:8", "must be"},
    {38, "mask = []", "38:8", "no joints"},
    {40, "space = 'modl'", "40:9", "did you mean \"model\"?"},
    {38, "mask = { role = 'chest', falloff = -1 }", "38:36", "from 0 to 65535"},
    {39, "weight = 'jump'", "39:10", "is a trigger"},
    {39, "weight = 'amred'", "39:10", "did you mean \"armed\"?"},
    {39, "weight = 1.5", "39:10", "from 0 to 1"},
    {39, "weight = 'speed'", "34:7", "give the number a half_life"},
    {42, "type = 'additive'", "42:8", "\"add\""},
    {50, "", "46:1", "without \"when\""},
    {50, "when = 'jumpp'", "50:8", "did you mean \"jump\"?"},
    {51, "fadein = 0.1", "51:1", "did you mean \"fade_in\"?"},
    {54, "poses = []", "54:9", "names nothing"},
    {54, "", "52:1", "without \"poses\""},
    {55, "choose = 'random'", "55:10", "\"chance\""},
    {57, "type = 'given'\nof = 1", "58:1", "has no \"of\""},
    {57, "type = 'given'\n[nodes.x]\ntype = 'given'", "58:2", "did you mean \"node\"?"},
    {57, "type = 'given'\na.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s.t.u.v.w.x.y.z.a1.b1.c1.d1.e1.f1.g1.h1.i1.j1.k1 = 1",
     "58:", ""},
};

TEST(GraphText, IsRightAsAWhole) {
  Notes notes;
  const BuiltGraph built = build_graph(parse_graph("whole.anim.toml", text_with(0, "")), notes);
  EXPECT_EQ(built.name, "whole");
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(notes.warnings[0].text.find("variants, ragdoll"), std::string::npos) << notes.warnings[0].text;
}

TEST(GraphText, MistakesAreLocated) {
  expect_located(kMistakes);
}

// docs/graph.schema.json, by which editors complete and check.
nlohmann::json as_json(const std::string& toml) {
  std::ostringstream out;
  const toml::table table = toml::parse(toml);
  out << toml::json_formatter{table};
  return nlohmann::json::parse(out.str());
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

test::Schema graph_schema() {
  return test::Schema(nlohmann::json::parse(file_text(test::in_source("docs/graph.schema.json"))));
}

TEST(GraphSchema, AcceptsWhatIsRight) {
  const test::Schema schema = graph_schema();
  std::vector<std::string> texts = {text_with(0, ""), file_text(test::in_golden("graph.toml"))};
  for (const auto& entry : std::filesystem::directory_iterator(test::in_source("tests/examples")))
    if (entry.path().string().ends_with(".anim.toml")) texts.push_back(file_text(entry.path()));
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    texts.push_back(test::oracle::random_graph(seed, 1 + static_cast<int>(seed % 5)));
  EXPECT_GE(texts.size(), 103u);
  for (const std::string& text : texts) {
    Notes notes;
    EXPECT_NO_THROW(build_graph(parse_graph("right.anim.toml", text), notes)) << text;
    EXPECT_TRUE(schema.accepts(as_json(text))) << text;
  }
}

// All mistakes but those that take the whole graph to see: names that are nowhere, and what does not go together.
TEST(GraphSchema, RefusesWhatIsWrong) {
  const test::Schema schema = graph_schema();
  int refused = 0;
  std::set<std::string> left;
  for (const Mistake& m : kMistakes) {
    nlohmann::json text;
    try {
      text = as_json(text_with(m.line, m.text));
    } catch (const toml::parse_error&) {
      continue;
    }
    if (schema.accepts(text))
      left.insert(std::string(m.text) + " | " + m.says);
    else
      ++refused;
  }
  std::printf("%d refused, %zu left to the cooker\n", refused, left.size());
  EXPECT_GE(refused, 65);
  // A name, a number or a pose that something else in the text makes wrong.
  for (const std::string& l : left) {
    bool takes_the_whole = false;
    for (const char* const says :
         {"did you mean", "is no number", "compares with no number", "as in \"speed", "which is no clip",
          "made of itself", "at one place", "must be clips", "on one line", "ends below", "from 0 to 6",
          "shows nothing", "in step", "is a trigger", "half_life", "follow one another"})
      takes_the_whole = takes_the_whole || l.find(says) != std::string::npos;
    EXPECT_TRUE(takes_the_whole) << l;
  }
}

// Deeper than the runtime goes, more than it holds, and larger than a file.
TEST(GraphText, ThatIsTooLargeIsRefused) {
  std::string deep = "output = 'n0'\n";
  for (int i = 0; i < 17; ++i)
    deep += "[node.n" + std::to_string(i) + "]\ntype = 'layer'\nbase = 'n" + std::to_string(i + 1) + "'\npose = 'x'\n";
  std::string wide = "output = 'm'\n[node.m]\ntype = 'pick'\nposes = [";
  for (int i = 0; i < 65; ++i) wide += "'c" + std::to_string(i) + "', ";
  wide += "]\n";
  for (const std::string& text : {deep, wide, std::string(2 << 20, '#')}) {
    Notes notes;
    EXPECT_THROW(build_graph(parse_graph("large.anim.toml", text), notes), tools::Failure);
  }
}

// Every triangle is counter-clockwise, no point is within another's circle, and they cover the hull.
TEST(Triangulate, IsDelaunay) {
  std::uint32_t chance = 1;
  const auto next = [&] { return static_cast<float>((chance = chance * 1664525u + 1013904223u) >> 16) / 65536; };
  for (int round = 0; round < 200; ++round) {
    std::vector<PlanePoint> points;
    const bool is_grid = round % 4 == 0;
    const int side = 2 + round % 6;
    for (int i = 0; i < side * side; ++i)
      points.push_back(is_grid ? PlanePoint{static_cast<float>(i % side), static_cast<float>(i / side)}
                               : PlanePoint{next(), next()});
    const std::vector<PlaneTriangle> triangles = triangulate(points);
    double area = 0;
    for (const PlaneTriangle& t : triangles) {
      const auto at = [&](std::uint32_t p) { return std::pair(double(points[p].x), double(points[p].y)); };
      const auto [ax, ay] = at(t.corners[0]);
      const auto [bx, by] = at(t.corners[1]);
      const auto [cx, cy] = at(t.corners[2]);
      const double twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
      EXPECT_GT(twice, 0);
      area += twice / 2;
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        const auto [x, y] = at(p);
        const double d = 2 * twice, a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
        const double ox = (a2 * (by - cy) + b2 * (cy - ay) + c2 * (ay - by)) / d;
        const double oy = (a2 * (cx - bx) + b2 * (ax - cx) + c2 * (bx - ax)) / d;
        const double radius = (ax - ox) * (ax - ox) + (ay - oy) * (ay - oy);
        EXPECT_GE((x - ox) * (x - ox) + (y - oy) * (y - oy), radius * (1 - 1e-6)) << round;
      }
    }
    if (is_grid) EXPECT_NEAR(area, (side - 1) * (side - 1), 1e-9);
    // Euler: 2n - 2 - h triangles of n points, h of them on the hull.
    EXPECT_LE(triangles.size(), 2 * points.size() - 5);
    EXPECT_GE(triangles.size(), points.size() - 2);
  }
}

}  // namespace
}  // namespace marrow::cook
