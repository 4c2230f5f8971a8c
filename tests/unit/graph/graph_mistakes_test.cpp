// More texts of graphs that are wrong, by what they are about: parameters and spaces, machines and layers, whole files.
#include "unit/graph/graph_mistakes.h"

#include <map>

namespace marrow::cook {
namespace {

// The columns were marked by hand in the wrong lines.
const std::vector<Mistake> kOfParameters = {
    {1, "Output = 'all'", "1:1", "did you mean \"output\"?"},
    {1, "output = 'all'\noutput = 'body'", "2:10", "stands twice"},
    {1, "output = ['all']", "1:10", "must be a string"},
    {1, "output = { node = 'all' }", "1:10", "must be a string"},
    {1, "output = 'all'\nfps = 30", "2:1", "a graph has no \"fps\""},
    {1, "output = \"a\\u0000b\"", "1:10", "NUL"},
    {2, "[parameter]", "2:2", "did you mean \"parameters\"?"},
    {2, "[[parameters]]", "2:1", "write [parameters]"},
    {3, "speed = { type = 'Number', range = [0, 6] }", "3:18", "did you mean \"number\"?"},
    {3, "speed = { type = 1, range = [0, 6] }", "3:18", "\"type\" must be a string"},
    {3, "speed = { Type = 'number', range = [0, 6] }", "3:11", "did you mean \"type\"?"},
    {3, "speed = { type = 'number', range = 6 }", "3:36", "must be a list"},
    {3, "speed = { type = 'number', range = [0, 6, 9] }", "3:36", "two numbers"},
    {3, "speed = { type = 'number', range = [0, 1e13] }", "3:40", "1e+13 is none of those"},
    {3, "speed = { type = 'number', range = [0, inf] }", "3:40", "must be a number"},
    {3, "speed = { type = 'number', range = [0, 1979-05-27] }", "3:40", "must be a number"},
    {3, "speed = { type = 'number', range = [0, 6], initial = '1' }", "3:54", "without quotes"},
    {3, "speed = { type = 'number', range = [0, 6], half_life = '80ms' }", "3:56", "without quotes"},
    {3, "speed = { type = 'number', range = [0, 6], halflife = 1 }", "3:44", "did you mean \"half_life\"?"},
    {3, "speed = { type = 'number', range = [0, 6], max = 6 }", "3:44", "\"range\""},
    {3, "speed = { type = 'number', range = [0, 6] }\nspeed = { type = 'flag' }", "4:9", "stands twice"},
    {3, "'not armed' = { type = 'flag' }", "3:1", "no condition could name it"},
    {3, "'a > b' = { type = 'flag' }", "3:1", "no condition could name it"},
    {3, "' speed' = { type = 'flag' }", "3:1", "no condition could name it"},
    {3, "'this or that' = { type = 'flag' }", "3:1", "no condition could name it"},
    {3, "'' = { type = 'flag' }", "3:1", "without a name"},
    {3, "\"a\\u0000\" = { type = 'flag' }", "3:1", "NUL"},
    {5, "armed = { type = 'bool' }", "5:18", "\"flag\""},
    {5, "armed = { type = 'flag', initial = 'true' }", "5:36", "without quotes"},
    {5, "armed = true", "5:9", "write { type = \"flag\" }"},
    {6, "jump = { type = 'trigger', hold = -1 }", "6:35", "-1 is none of those"},
    {6, "jump = { type = 'trigger', hold = nan }", "6:35", "must be a number"},
    {6, "jump = { type = 'triger' }", "6:17", "did you mean \"trigger\"?"},
    {6, "jump = { type = 'trigger', half_life = 1 }", "6:28", "\"hold\""},
    {7, "[Node.slow]", "7:2", "did you mean \"node\"?"},
    {7, "[[node.slow]]", "7:1", "write [node.NAME]"},
    {7, "[node]\n'' = 1\n[node.slow]", "8:1", "a node without a name"},
    {8, "tpye = 'clip'", "8:1", "did you mean \"type\"?"},
    {8, "type = 'blend_tree'", "8:8", "\"space\""},
    {8, "type = ''", "8:8", "must be a string"},
    {9, "clip = ['walk', 'run']", "9:8", "must be a string"},
    {9, "pose = 'walk'", "9:1", "a clip has no \"pose\""},
    {9, "clip = \"wa\\u0000lk\"", "9:8", "NUL"},
    {10, "speed = '0.5'", "10:9", "without quotes"},
    {10, "sped = 0.5", "10:1", "did you mean \"speed\"?"},
    {11, "play = 'pingpong'", "11:8", "did you mean \"ping_pong\"?"},
    {11, "play = true", "11:8", "must be a string"},
    {11, "loop = true", "11:1", "a clip has no \"loop\""},
    {13, "type = 'spce'", "13:8", "did you mean \"space\"?"},
    {14, "by = 3", "14:6", "a name, or a list"},
    {14, "by = ['speed', '']", "14:16", "must be a string"},
    {15, "points = [ 'idle', 'slow' ]", "15:12", "write { at = 0, pose ="},
    {15, "points = { at = 0, pose = 'idle' }", "15:10", "must be a list"},
    {15, "points = [ { at = 0, pose = 'idle' }, { at = [1, 1], pose = 'run' } ]", "15:46", "one number"},
    {15, "points = [ { at = 1e13, pose = 'idle' } ]", "15:19", "1e+13 is none of those"},
    {15, "points = [ { at = nan, pose = 'idle' } ]", "15:19", "must be a number"},
    {15, "points = [ { att = 0, pose = 'idle' } ]", "15:14", "did you mean \"at\"?"},
    {15, "points = [ { at = 0, pose = '' } ]", "15:29", "must be a string"},
    {15, "points = [ { at = 0, pose = ['idle'] } ]", "15:29", "must be a string"},
    {15, "points = [ { at = 0, pose = 'gaits' } ]", "15:29", "made of itself"},
    {15, "points = [ { at = 0, pose = 'body' } ]", "15:29", "made of itself"},
    {16, "match_sped = true", "16:1", "did you mean \"match_speed\"?"},
    {17, "sync = 1", "17:8", "true or false"},
    {17, "synced = true", "17:1", "did you mean \"sync\"?"},
    {20, "by = ['speed', 'bend']\nmatch_speed = true", "21:15", "spaces by one number"},
    {20, "by = ['bend', 'armed']", "20:15", "\"armed\" is no number"},
    {21, "points = [ { at = [0, 0], pose = 'gaits' }, { at = 1, pose = 'idle' } ]", "21:52", "two numbers"},
    {21, "points = [ { at = [0, 0, 0], pose = 'gaits' } ]", "21:19", "two numbers"},
    {21, "points = [ { at = [0, 0], pose = 'gaits' }, { at = [1, 0], pose = 'idle' } ]", "21:34", "on one line"},
    {21, "points = [ { at = ['0', 0], pose = 'gaits' } ]", "21:20", "without quotes"},
    {21, "points = [ { at = [0, 0], pose = 'a' }, { at = [1e-200, 0], pose = 'b' }, { at = [0, 1], pose = 'c' } ]",
     "21:34", "at one place"},
};
const std::vector<Mistake> kOfMachines = {
    {23, "type = 'mashine'", "23:8", "did you mean \"machine\"?"},
    {24, "start = 'ground '", "24:9", "did you mean \"ground\"?"},
    {24, "start = ['ground', 'air']", "24:9", "must be a string"},
    {24, "begin = 'ground'", "24:1", "\"start\""},
    {25, "state.'*' = { pose = 'plane' }", "25:7", "any state"},
    {25, "state.'' = { pose = 'plane' }", "25:7", "a state without a name"},
    {25, "state.ground = { pose = 'plane', speed = 1 }", "25:34", "a state has no \"speed\""},
    {25, "states.ground = { pose = 'plane' }", "25:1", "did you mean \"state\"?"},
    {25, "state.ground = { clip = 'plane' }", "25:18", "\"pose\""},
    {25, "state.ground.pose = 3", "25:21", "must be a string"},
    {25, "state.ground = { pose = 'plane' }\nstate.ground = { pose = 'idle' }", "26:16", "stands twice"},
    {28, "transitions = [", "28:1", "did you mean \"transition\"?"},
    {29, "  { from = 'ground', to = 'air', when = 'jump or armed' },", "29:41", "a transition for each"},
    {29, "  { from = 'ground', to = 'air', when = 'jump || armed' },", "29:41", "a transition for each"},
    {29, "  { from = 'ground', to = 'air', when = 'jump and armed' },", "29:41", "write a list"},
    {29, "  { from = 'ground', to = 'air', when = 'armed && jump' },", "29:41", "write a list"},
    {29, "  { from = 'ground', to = 'air', when = '!armed' },", "29:41", "write \"not armed\""},
    {29, "  { from = 'ground', to = 'air', when = 'speed == 1' },", "29:41", ">, <, >= and <="},
    {29, "  { from = 'ground', to = 'air', when = 'speed != 1' },", "29:41", ">, <, >= and <="},
    {29, "  { from = 'ground', to = 'air', when = 'armed = true' },", "29:41", "\"not armed\""},
    {29, "  { from = 'ground', to = 'air', when = 'speed => 1' },", "29:41", "write >= or <="},
    {29, "  { from = 'ground', to = 'air', when = 'not speed > 1' },", "29:41", "exchange < and >="},
    {29, "  { from = 'ground', to = 'air', when = '0.5 < speed' },", "29:41", "as in \"speed > 0.5\""},
    {29, "  { from = 'ground', to = 'air', when = 'speed > 0,5' },", "29:41", "compares with no number"},
    {29, "  { from = 'ground', to = 'air', when = 'speed > 1e39' },", "29:41", "compares with no number"},
    {29, "  { from = 'ground', to = 'air', when = '> 1' },", "29:41", "compares no parameter"},
    {29, "  { from = 'ground', to = 'air', when = 'not speed' },", "29:41", "as in \"speed > 0.5\""},
    {29, "  { from = 'ground', to = 'air', when = 'armed > 0' },", "29:41", "\"armed\", or \"not armed\""},
    {29, "  { from = 'ground', to = 'air', when = 'Jump' },", "29:41", "did you mean \"jump\"?"},
    {29, "  { from = 'ground', to = 'air', when = 'not amred' },", "29:41", "did you mean \"armed\"?"},
    {29, "  { from = 'ground', to = 'air', when = ['jump', 'sped > 1'] },", "29:50", "did you mean \"speed\"?"},
    {29, "  { from = 'ground', to = 'air', when = [''] },", "29:42", "must be a string"},
    {29, "  { from = 'ground', to = 'air', when = [] },", "29:3", "taken at once"},
    {29, "  { from = 'ground', to = 'air', when = { jump = true } },", "29:41", "a condition, or a list"},
    {29, "  { from = 'ground', to = 'air', when = ['jump', 1] },", "29:50", "must be a string"},
    {29, "  { to = 'air', when = 'jump' },", "29:3", "without \"from\""},
    {29, "  { from = '*', to = '*', when = 'jump' },", "29:22", "there is no state \"*\""},
    {29, "  { from = ['*', 'air'], to = 'ground', when = 'jump' },", "29:13", "it stands alone"},
    {29, "  { from = ['ground', 'aire'], to = 'land', when = 'jump' },", "29:23", "did you mean \"air\"?"},
    {29, "  { from = 'ground', to = ['air', 'air'], when = 'jump' },", "29:35", "must follow one another"},
    {29, "  { from = 'ground', to = [], when = 'jump' },", "29:27", "names nothing"},
    {29, "  { from = 1, to = 'air', when = 'jump' },", "29:12", "a name, or a list"},
    {29, "  'jump',", "29:3", "write { from ="},
    {29, "  { from = 'ground', to = 'air', when = 'jump', fade = '0.1' },", "29:56", "without quotes"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', fade = 1e7 },", "29:56", "1e+07 is none of those"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', fade = true },", "29:56", "must be a number"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', kind = 'Inertial' },", "29:56", "did you mean \"inertial\"?"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', kind = 1 },", "29:56", "must be a string"},
    {29, "  { from = 'ground', to = 'air', on = 'jump' },", "29:34", "\"when\""},
    {29, "  { from = 'ground', to = 'air', when = 'jump', at_end = true },", "29:58", "must be a number"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', enter = 'same phase' },", "29:57",
     "did you mean \"same_phase\"?"},
    {29, "  { from = 'ground', to = 'air', when = 'jump', enter = true },", "29:57", "must be a string"},
    {29, "  { from = 'ground', from = 'air', to = 'air', when = 'jump' },", "29:29", "stands twice"},
    {36, "base = ['body']", "36:8", "must be a string"},
    {36, "base = 'all'", "36:8", "made of itself"},
    {37, "pose = 'lean'", "37:8", "made of itself"},
    {37, "poses = 'block'", "37:1", "did you mean \"pose\"?"},
    {38, "mask = { role = 'Chest' }", "38:17", "did you mean \"chest\"?"},
    {38, "mask = { role = 'none' }", "38:17", "there is no role \"none\""},
    {38, "mask = { role = 7 }", "38:17", "must be a string"},
    {38, "mask = { roles = 'chest' }", "38:10", "did you mean \"role\"?"},
    {38, "mask = { joint = '' }", "38:18", "must be a string"},
    {38, "mask = { joint = \"a\\u0000\" }", "38:18", "NUL"},
    {38, "mask = { falloff = 2 }", "38:8", "a role or a joint"},
    {38, "mask = ['chest']", "38:9", "write { role = \"chest\" }"},
    {38, "mask = { role = 'chest', falloff = 1.5 }", "38:36", "a whole number"},
    {38, "mask = { role = 'chest', falloff = 70000 }", "38:36", "70000 is none of those"},
    {38, "masks = { role = 'chest' }", "38:1", "did you mean \"mask\"?"},
    {39, "weight = true", "39:10", "must be a number"},
    {39, "weight = -0.1", "39:10", "-0.1 is none of those"},
    {39, "weight = '0.5'", "39:10", "without quotes"},
    {39, "weight = 'not armed'", "39:10", "there is no parameter"},
    {39, "weight = ''", "39:10", "must be a string"},
    {39, "wieght = 'armed'", "39:1", "did you mean \"weight\"?"},
    {40, "fade = -1", "40:8", "-1 is none of those"},
    {40, "fade_in = 0.1", "40:1", "a layer has no \"fade_in\""},
    {45, "weight = 'jump'", "45:10", "is a trigger"},
    {47, "type = 'oneshot'", "47:8", "did you mean \"one_shot\"?"},
    {49, "pose = 'gaits'", "49:8", "a one_shot waits for the end of \"gaits\""},
    {50, "when = []", "50:8", "waits for nothing"},
    {50, "when = ['jump or armed']", "50:9", "one trigger for all"},
    {51, "fade_in = 'slow'", "51:11", "without quotes"},
    {51, "fade = 0.1", "51:1", "did you mean \"fade_in\"?"},
    {54, "poses = ['a', 3]", "54:15", "must be a string"},
    {54, "pose = ['a', 'b']", "54:1", "did you mean \"poses\"?"},
    {55, "choose = 1", "55:10", "must be a string"},
    {55, "fade = -1", "55:8", "-1 is none of those"},
    {57, "type = 'given'\n[node.other]", "58:1", "without \"type\""},
    {57, "type = 'given'\n[node.guard.state]\nx = { pose = 'y' }", "58:13", "a layer has no \"state\""},
    {57, "type = 'given'\n[transition]\nx = 1", "58:2", "a graph has no \"transition\""},
};
const std::vector<Mistake> kOfFiles = {
    {0, "", "1:1", "without \"output\""},
    {0, "# nothing yet\n", "1:1", "without \"output\""},
    {0,
     "\xEF\xBB\xBF"
     "output = 1\n",
     "1:10", "must be a string"},
    {0, "output = \"x", "1:12", "end-of-file"},
    {0, "output = \"\xFF\xFE\"\n", "1:10", "utf-8"},
    {0, "output = \xE2\x80\x9Cwalk\xE2\x80\x9D\n", "1:10", "straight quotes"},
    {0, "output = walk\n", "1:10", "straight quotes"},
    {0, "output: walk\n", "1:7", "expected '='"},
    {0, "{ \"output\": \"walk\" }\n", "1:1", "saw '{'"},
    {0, "output = 'walk'\n[node.x\ntype = 'given'\n", "2:8", "expected ']'"},
    {0,
     "output = 'walk'\n[node.schl\xC3\xA4"
     "ft]\ntype = 'given'\n",
     "2:11", "is quoted"},
    {0, "output = 'walk'\n[parameters]\na = {\n  type = 'flag'\n}\n", "3:6", "stands in one line"},
    {0, "output = 'walk'\n[parameters]\na = { type = 'flag', }\n", "3:22", "dangling comma"},
    {0, "output = 'walk'\n[parameters]\na = { type = 'flag', initial = True }\n", "3:32", "expected 'true'"},
    {0, "output = 'walk'\n[parameters]\na = { type = 'number', range = [0, 99999999999999999999] }\n", "3:56",
     "64 bits"},
    {0, "output = 'walk'\nparameters = 3\n", "2:14", "write [parameters]"},
    {0, "output = 'walk'\nnode = []\n", "2:8", "write [node.NAME]"},
    {0, "output = 'walk'\n[node]\nmove = 'walk'\n", "3:8", "write [node.NAME]"},
    {0, "output = 'walk'\n[node.a]\ntype = 'given'\n[node.a]\ntype = 'given'\n", "4:1", "stands twice"},
    {0, "output = 'a'\n[node.a]\ntype = 'pick'\nposes = ['a']\n", "4:10", "made of itself"},
    {0,
     "output = 'a'\n[node.a]\ntype = 'layer'\nbase = 'b'\npose = 'x'\n[node.b]\ntype = 'add'\nbase = 'c'\npose = "
     "'x'\n[node.c]\n"
     "type = 'layer'\nbase = 'x'\npose = 'a'\n",
     "13:8", "made of itself"},
    {0, "output = 'm'\n[node.m]\ntype = 'machine'\nstart = 'a'\n", "2:1", "without \"state\""},
    {0, "output = 'm'\n[node.m]\ntype = 'machine'\nstart = 'a'\nstate = {}\n", "2:1", "no states"},
};

TEST(GraphMistakes, OfParametersAndSpaces) {
  expect_located(kOfParameters);
}
TEST(GraphMistakes, OfMachinesAndLayers) {
  expect_located(kOfMachines);
}
TEST(GraphMistakes, OfWholeFiles) {
  expect_located(kOfFiles);
}

std::string numbered(const std::string& before, int count, const std::string& after) {
  std::string out;
  for (int i = 0; i < count; ++i) out += before + std::to_string(i) + after;
  return out;
}

// One more of anything than a graph may have, and the place of it; as many as it may have are right.
struct Limit {
  int most;
  const char *before, *each, *after_each, *after;
  const char *where, *says;
};
TEST(GraphMistakes, OfTooMuch) {
  const Limit limits[] = {
      {256, "output = 'x'\n[parameters]\n", "p", " = { type = 'flag' }\n", "", "259:1", "more than 256 parameters"},
      {64,
       "output = 's'\n[parameters]\nv = { type = 'number', range = [0, 99] }\n[node.s]\ntype = 'space'\nby = "
       "'v'\npoints = [",
       "{ pose = 'x', at = ", " }, ", "]\n", "7:10", "more than 64"},
      {64, "output = 'p'\n[node.p]\ntype = 'pick'\nposes = [", "'c", "', ", "]\n", "4:9", "more than 64"},
      {64, "output = 'm'\n[node.m]\ntype = 'machine'\nstart = 's0'\n", "state.s", " = { pose = 'x' }\n", "", "2:1",
       "more than 64"},
      {256,
       "output = 'm'\n[node.m]\ntype = 'machine'\nstart = 'a'\nstate.a = { pose = 'x' }\nstate.b = { pose = 'y' "
       "}\ntransition = [\n",
       "{ from = 'a', to = 'b', after = ", " },\n", "]\n", "2:7", "more than 256 transitions"},
      {64, "output = 'l'\n[node.l]\ntype = 'layer'\nbase = 'x'\npose = 'y'\nmask = [", "{ joint = 'j", "' }, ", "]\n",
       "6:8", "more than 64 joints"},
  };
  for (const Limit& limit : limits)
    for (const int count : {limit.most, limit.most + 1}) {
      const std::string text = limit.before + numbered(limit.each, count, limit.after_each) + limit.after;
      if (count > limit.most) {
        expect_located({0, limit.before, limit.where, limit.says}, text);
        continue;
      }
      Notes notes;
      EXPECT_NO_THROW(build_graph(parse_graph("most.anim.toml", text), notes)) << limit.says;
    }
}

// A layer takes three nodes: 171 are 512 and more; 600 nodes that nothing takes are no harm.
TEST(GraphMistakes, OfTooManyNodes) {
  std::string text =
      "output = 's'\n[parameters]\nv = { type = 'number', range = [0, 99] }\n[node.s]\ntype = "
      "'space'\nby = 'v'\npoints = [";
  for (int i = 0; i < 60; ++i) text += "{ at = " + std::to_string(i) + ", pose = 'p" + std::to_string(i) + "' }, ";
  text += "]\n";
  for (int i = 0; i < 60; ++i) {
    text += "[node.p" + std::to_string(i) + "]\ntype = 'pick'\nposes = [";
    for (int c = 0; c < 9; ++c) text += "'c" + std::to_string(c) + "', ";
    text += "]\n";
  }
  expect_located({0, "600 nodes and one", "1:10", "more than 512 nodes"}, text);
  Notes notes;
  const std::string unused = "output = 'x'\n" + numbered("[node.n", 600, "]\ntype = 'given'\n");
  EXPECT_EQ(build_graph(parse_graph("unused.anim.toml", unused), notes).nodes.size(), 1u);
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(notes.warnings[0].text.find("and 588 more"), std::string::npos) << notes.warnings[0].text;
}

TEST(GraphMistakes, OfNesting) {
  const auto nested = [](int depth) {
    std::string text = "output = 'n0'\n";
    for (int i = 0; i < depth; ++i)
      text +=
          "[node.n" + std::to_string(i) + "]\ntype = 'layer'\nbase = 'n" + std::to_string(i + 1) + "'\npose = 'x'\n";
    return text;
  };
  Notes notes;
  EXPECT_NO_THROW(build_graph(parse_graph("deep.anim.toml", nested(15)), notes));
  // Node 15 is the base of node 14, which begins in line 2 + 4 · 14.
  expect_located({0, "17 nodes below each other", "64:8", "16 below each other"}, nested(16));
  for (const std::string& of : {std::string("["), std::string("{ a = ")}) {
    std::string deep = "output = 'x'\nz = ";
    for (int i = 0; i < 1000; ++i) deep += of;
    expect_located({0, "brackets", "2:", "nested"}, deep);
  }
  std::string key = "output = 'x'\nz";
  for (int i = 0; i < 1000; ++i) key += ".z";
  expect_located({0, "a key of 1001 parts", "2:1", "too many parts"}, key + " = 1\n");
}

// Texts with some bytes changed, left out or doubled are built or refused at a place, never worse.
TEST(GraphMistakes, OfAnyKind) {
  std::string whole = text_with(0, "");
  std::uint32_t chance = 1;
  const auto dice = [&](std::size_t count) { return (chance = chance * 1664525u + 1013904223u) / 65536u % count; };
  int built = 0, refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string text = whole;
    for (std::size_t changes = 1 + dice(2); changes > 0; --changes) {
      const std::size_t at = dice(text.size()), other = dice(text.size());
      const std::size_t length = std::min<std::size_t>(1 + dice(12), text.size() - std::max(at, other));
      switch (dice(4)) {
        case 0:
          text[at] = static_cast<char>(dice(256));
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, text.substr(other, length));
          break;
        default:
          text.replace(at, length, text.substr(other, length));
          break;
      }
    }
    Notes notes;
    try {
      build_graph(parse_graph("any.anim.toml", text), notes);
      ++built;
    } catch (const tools::Failure& f) {
      ++refused;
      EXPECT_EQ(f.file(), "any.anim.toml");
      EXPECT_NE(f.where(), "") << f.what() << "\n" << text;
    }
  }
  std::printf("%d built, %d refused\n", built, refused);
  EXPECT_GT(built, 20);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace marrow::cook
