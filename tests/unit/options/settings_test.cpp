// Reading marrow.toml: every option, every mistake with its place, and nothing that hostile text can do.
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/settings.h"

namespace marrow::cook {
namespace {

Settings parse(const std::string& text) {
  return parse_settings("/project/marrow.toml", text);
}

TEST(Settings, DialsOfTheElasticTruth) {
  const auto dials = [](const std::string& text) {
    std::vector<bool> used;
    const Settings settings = parse("as = \"fit\"\ntruth = \"elastic\"\nelastic = \"" + text + "\"\n");
    return to_options(settings_for(settings, "/project/a.glb", used)).learn;
  };
  EXPECT_EQ(dials("volume=15").elastic.volume, 15);
  EXPECT_EQ(dials("volume=15").elastic.keep, 0.1);
  EXPECT_EQ(dials("keep=0.5,volume=0").elastic.volume, 0);
  EXPECT_EQ(dials("keep=0.5,volume=0").elastic.keep, 0.5);
  EXPECT_EQ(dials("keep=1").truth, Truth::elastic);
  EXPECT_EQ(dials("keep=1").helpers, kAutoHelpers);
  for (const char* const bad : {"", "15", "volume", "volume=", "volume=-1", "volume=101", "keep=0", "keep=nan",
                                "keep=1,", "keep=1;volume=2", "stiff=3", "volume=1e", "volume=0x10"})
    EXPECT_THROW(dials(bad), tools::Failure) << bad;
}

TEST(Settings, DefaultsAndRules) {
  const Settings settings = parse(R"(
clip-error = "0.5mm"
keep-vertex-order = true

[[file]]
match = "chars/hero*.glb"
clip-error = ["0.05mm", "hand*=0.02mm"]
additive = ["aim*=rest"]

[[file]]
match = ["chars/hero_low.glb", "props/*"]
clip-codec = "raw"
keep-vertex-order = false
scene = "attic"
strict = true
)");
  std::vector<bool> used;
  const CookOptions plain = to_options(settings_for(settings, "/project/foe.glb", used));
  EXPECT_EQ(used, (std::vector<bool>{false, false}));
  ASSERT_EQ(plain.clips.error.size(), 2u);
  EXPECT_EQ(plain.clips.error[1].error, 0.5e-3);
  EXPECT_TRUE(plain.mesh.keep_vertex_order);
  EXPECT_FALSE(plain.clips.raw || plain.source.strict);
  EXPECT_EQ(plain.source.scene.name, "");

  const CookOptions hero = to_options(settings_for(settings, "/project/chars/hero_low.glb", used));
  EXPECT_EQ(used, (std::vector<bool>{true, true}));
  ASSERT_EQ(hero.clips.error.size(), 3u) << "a rule replaces the defaults of the same name";
  EXPECT_EQ(hero.clips.error[1].error, 0.05e-3);
  EXPECT_EQ(hero.clips.error[2].joints, "hand*");
  EXPECT_FALSE(hero.clips.error[2].origin.must_fit);
  ASSERT_EQ(hero.clips.additive.size(), 1u);
  EXPECT_EQ(hero.clips.additive[0].reference, "rest");
  EXPECT_EQ(hero.clips.additive[0].origin.where, "8:13");
  EXPECT_TRUE(hero.clips.raw);
  EXPECT_FALSE(hero.mesh.keep_vertex_order);
  EXPECT_EQ(hero.source.scene.name, "attic");
  EXPECT_EQ(hero.source.scene.origin.where, "14:9");
  EXPECT_FALSE(hero.source.scene.origin.must_fit);
  EXPECT_TRUE(hero.source.strict);
}

TEST(Settings, EveryOptionOfTheCommandLineIsKnown) {
  int options = 0;
  for (const Option& option : option_table()) {
    const std::string name = option.name, shape = option.shape;
    const std::string value = option.kind == OptionKind::flag          ? "true"
                              : option.kind == OptionKind::table       ? "{head = \"Head\"}"
                              : !option.choices.empty()                ? '"' + std::string(option.choices.back()) + '"'
                              : shape == "NEW=CLIP"                    ? "\"other=walk\""
                              : shape == "CLIP=HOW"                    ? "\"walk=ground\""
                              : shape == "CLIP=NAME@TIME"              ? "\"walk=hit@50%\""
                              : shape == "CLIP=TIMES"                  ? "\"walk=0,0.5\""
                              : shape == "DEGREES" || shape == "SHARE" ? "\"0.1\""
                              : shape == "STEPS" || shape == "EXAMPLES" || shape == "FIELDS" || shape[0] == 'N'
                                  ? "\"3\""
                              : shape == "ENTRIES"           ? "\"256\""
                              : shape[0] == 'R'              ? "\"0.5,0.25\""
                              : shape.starts_with("CHANNEL") ? "\"loose=chest,pole\""
                              : shape.starts_with("volume")  ? "\"volume=15\""
                              : shape == "JOINT=MASK.png"    ? "\"hand=hand.png\""
                                                             : "\"0.1mm\"";
    // A truth is only for fits, examples for a truth, rebinding for weights that are made.
    const bool of_fit = name == "truth" || name == "helpers" || name == "keep-bind-pose" || name == "delta-mush" ||
                        name == "mwe" || name == "psd" || name == "influences" || name == "wide-poses";
    const std::string pack = name == "truth"      ? "as = 'fit'\nexamples = 'poses.glb'\n"
                             : name == "elastic"  ? "as = 'fit'\ntruth = 'elastic'\n"
                             : name == "rebind"   ? "auto-weights = 'nearest'\n"
                             : name == "examples" ? "as = 'fit'\ntruth = 'examples'\n"
                             : of_fit             ? "as = 'fit'\n"
                                                  : "";
    const Settings settings = parse(pack + name + " = " + value);
    EXPECT_EQ(settings.defaults.count(option.name), 1u) << option.name;
    ++options;
  }
  EXPECT_GE(options, 4);
}

TEST(Settings, MistakesAreLocated) {
  const struct {
    const char *text, *where, *says;
  } cases[] = {
      {"clip-eror = '1mm'", "1:1", "unknown setting \"clip-eror\": did you mean \"clip-error\"?"},
      {"\n\n   clip_error = '1mm'", "3:4", "did you mean \"clip-error\"?"},
      {"[[fille]]\nmatch = 'a'", "1:3", "did you mean \"file\"?"},
      {"[[file]]\nmacth = 'a'", "1:1", "does not say which files"},
      {"[[file]]\nmatch = 'a'\nmacth = 'a'", "3:1", "did you mean \"match\"?"},
      {"zzzzzzzzzzzz = 1", "1:1", "`marrow cook --help` lists the options"},
      {"clip-error = 1", "1:14", "must be a string or a list of them"},
      {"clip-error = ['1mm', 2]", "1:22", "must list strings"},
      {"clip-error = ['1mm',\n  'x=']", "2:3", "\"x=\" is not an error"},
      {"clip-error = '1km'", "1:14", "\"1km\" is not an error"},
      {"clip-shell = '3%'", "1:14", "\"3%\" is no shell"},
      {"clip-codec = 'magic'", "1:14", "give segments or raw"},
      {"clip-codec = ['raw']", "1:14", "must be a string"},
      {"keep-vertex-order = 'yes'", "1:21", "must be true or false"},
      {"additive = '=rest'", "1:12", "names no clip"},
      {"file = 3", "1:8", "must be a list of tables"},
      {"file = [3]", "1:9", "a rule must be a table"},
      {"[file]\nmatch = 'a'", "1:1", "must be a list of tables"},
      {"[[file]]\nmatch = []", "2:9", "names no files"},
      {"[[file]]\nmatch = 'never'\nclip-error = 'x'", "3:14", "\"x\" is not an error"},
      {"[roles]\nleft_fot = 'a'", "2:12", "there is no role \"left_fot\": did you mean \"left_foot\"?"},
      {"roles = ['head=a']", "1:9", "\"roles\" must be a table: write [roles]"},
      {"[roles]\nhead = 1", "2:8", "\"head\" must be a string"},
      {"[roles]\nneck = 'a'\nhead = 'a'", "3:8", "a role has one joint, and a joint one role"},
      {"[roles]\n'head=x' = 'a'", "2:1", "a name with ="},
      {"clip-error = '1mm'\nclip-error = '2mm'", "2:14", "no TOML"},
      {"clip-error = '1mm", "1:18", "no TOML"},
      {"\xFF\xFE", "1:1", "no TOML"},
  };
  int checked = 0;
  for (const auto& c : cases) {
    try {
      parse(c.text);
      ADD_FAILURE() << c.text;
    } catch (const tools::Failure& failure) {
      EXPECT_EQ(failure.code(), tools::Exit::usage) << c.text;
      EXPECT_EQ(failure.file(), "/project/marrow.toml");
      EXPECT_EQ(failure.where(), c.where) << failure.what();
      EXPECT_NE(std::string(failure.what()).find(c.says), std::string::npos) << failure.what();
      ++checked;
    }
  }
  EXPECT_EQ(checked, 28);
}

// Whatever the text, an answer: no crash, no endless work.
TEST(Settings, HostileText) {
  constexpr std::size_t kMost = 64 * 1024;
  const auto repeated = [](const std::string& part, std::size_t bytes) {
    std::string out;
    while (out.size() + part.size() <= bytes) out += part;
    return out;
  };
  const std::string texts[] = {
      "x = " + repeated("[", kMost - 4),
      "x = " + repeated("{a=", kMost - 4),
      repeated("a.", kMost - 6) + "a = 1",
      "[" + repeated("a.", kMost - 6) + "a]",
      "x = {" + repeated("a.", kMost - 16) + "a = 1}",
      "x = [\"\"\"a\"\"\"\", {" + repeated("a.", kMost - 40) + "a = 1}]",  // a quote before the closing ones
      "x = [a, '#', {" + repeated("a.", kMost - 40) + "a = 1}]",
      "\"#\"." + repeated("a.", kMost - 16) + "a = 1",
      repeated("[[file]]\n", kMost),
      repeated("\n", kMost),
      "x = \"" + repeated("\\u0041", kMost - 10) + "\"",
      "match = " + repeated("[{a.a.a.a.a.a.a.a=", kMost - 10),
      std::string(kMost + 1, '#'),
      std::string(kMost, '\0'),
      "clip-error = [" + repeated("'1mm',", kMost - 20) + "]",
  };
  int answered = 0;
  for (const std::string& text : texts) {
    try {
      parse(text);
    } catch (const tools::Failure& failure) {
      EXPECT_LT(std::string(failure.what()).size(), 1000u);
    }
    ++answered;
  }
  EXPECT_EQ(answered, 15);
}

TEST(Settings, DamagedText) {
  const std::string good =
      "clip-error = [\"0.1mm\", 'hand*=0.02mm'] # note\n[[file]]\nmatch = \"a/*\"\nadditive = [ \"x=rest\" ]\n"
      "keep-vertex-order = true\n[[file]]\nmatch = ['b', 'c']\nclip-codec = \"raw\"\n";
  ASSERT_EQ(parse(good).rules.size(), 2u);
  std::mt19937 random(7);
  int refused = 0, taken = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = good;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(at, 1 + random() % 8);
          break;
        case 2:
          text.insert(at, 1 + random() % 3, "[]{}\"'=.#\n"[random() % 10]);
          break;
        default:
          text += text.substr(at, 20);
      }
      if (text.empty()) text = "x";
    }
    try {
      parse(text);
      ++taken;
    } catch (const tools::Failure&) {
      ++refused;
    }
  }
  EXPECT_EQ(refused + taken, 4000);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 50);
}

}  // namespace
}  // namespace marrow::cook
