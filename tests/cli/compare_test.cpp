// `marrow compare`, and `marrow cook --as` as a user runs them.
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// One joint, twelve poses. In a twist by 170° linear blend skinning has cos 85° = 0.087 of the radius left.
void expect_range_of_motion(const nlohmann::json& motion) {
  EXPECT_EQ(motion.at("poses").get<std::size_t>() + motion.at("folding_poses").size(), 12u);
  EXPECT_TRUE(motion.at("left_out").empty());
  ASSERT_EQ(motion.at("joints").size(), 1u);
  const nlohmann::json& joint = motion["joints"][0];
  EXPECT_EQ(joint.at("joint"), "bend");
  EXPECT_EQ(joint.at("poses"), motion["poses"]);
  EXPECT_EQ(joint.at("deformers"), motion.at("deformers"));
  std::map<std::string, nlohmann::json> rows;
  for (const auto& row : motion["deformers"]) rows[row.at("deformer")] = row;
  const nlohmann::json& ssd = rows.at("ssd");
  EXPECT_NEAR(ssd.at("ring_over_bind").get<double>(), 0.087, 0.01);
  EXPECT_NEAR(ssd.at("ring_over_truth").get<double>(), 0.087, 0.01);
  EXPECT_EQ(ssd.at("narrowest_pose").at("kind"), "twist");
  EXPECT_NEAR(std::abs(ssd["narrowest_pose"].at("angle_deg").get<double>()), 170, 1e-9);
  EXPECT_EQ(ssd.at("worse_poses"), 0);
  EXPECT_EQ(ssd.at("of_ssd"), 1.0);
  EXPECT_EQ(ssd.at("worst_of_ssd"), 1.0);
  EXPECT_LT(ssd.at("volume_over_truth").get<double>(), 0.8);
  EXPECT_EQ(rows.at("as_lift").at("worse_poses"), 0) << "rounding is not worse";
  EXPECT_EQ(rows.at("rigid").at("worse_poses"), motion["poses"]);
  EXPECT_GT(rows.at("as_helpers_fit4").at("ring_over_truth").get<double>(), 0.8);
  EXPECT_LT(rows.at("as_helpers_fit4").at("of_ssd").get<double>(), 0.3);
}

// Whether the table has a program for the three GPUs that compare names.
bool is_told(const nlohmann::json& costs, const char* program) {
  const auto found = costs["programs"].find(program);
  if (found == costs["programs"].end()) return false;
  for (const std::size_t gpu : {2u, 6u, 8u})
    if ((*found)[gpu].is_null()) return false;
  return true;
}

// What `marrow cook` does not make, EigenSkin beside it.
bool is_measured_alone(const std::string& row) {
  return row == "stitched" || row == "joint_local" || row == "ssd_refit";
}

// Plain skinning wrings, which no fold tells: dual quaternions bend and crease more in the same poses.
void expect_looks(const nlohmann::json& r, const std::map<std::string, nlohmann::json>& rows) {
  const auto look = [&](const char* row, const char* figure) { return rows.at(row).at("look").at(figure); };
  for (const char* const figure : {"flipped_triangles", "bend_deg", "creased_share"}) {
    EXPECT_GT(look("ssd", figure), 0) << figure;
    EXPECT_NEAR(look("as_lift", figure).get<double>(), look("ssd", figure).get<double>(), 1e-9) << "the same surface";
    EXPECT_NEAR(look("as_helpers_fit5", figure).get<double>(), r.at("truth_look").at(figure).get<double>(),
                0.01 * look("ssd", figure).get<double>())
        << "as near as that to the truth";
  }
  EXPECT_GT(r["truth_look"]["bend_deg"], look("ssd", "bend_deg"));
  EXPECT_TRUE(look("ssd", "jump_of_ssd").is_null()) << "there is no clip";
  EXPECT_EQ(r.at("recommended"), "ssd");
  EXPECT_NE(r.at("why").dump().find("as_helpers_fit5 is nearer"), std::string::npos) << r["why"];
  EXPECT_NE(r["why"].dump().find("But ssd wrings joints: twisted to 170° they keep 0.08"), std::string::npos)
      << r["why"];
  ASSERT_EQ(r.at("truth_folds").at("worst").size(), 1u);
  EXPECT_GT(r["truth_folds"]["worst"][0].at("flipped_triangles"), r["truth_folds"]["poses"].is_null() ? 1e9 : 8)
      << "a thousandth of 4000 triangles twice";
}

// The figures of a study of this cylinder are 0.35 and 0.05 of linear blend skinning's error.
TEST(Compare, TheCylinder) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: takes minutes under a sanitizer, which sees the same code in the tests of `deform`";
#endif
  const Ran ran = run_marrow({"compare", "--sample", "cylinder", "--truth", "dqs", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json r = nlohmann::json::parse(ran.out);
  EXPECT_EQ(r.at("truth"), "dqs");
  EXPECT_EQ(r.at("holdout"), "frames");
  EXPECT_EQ(r.at("held_poses"), 1000);
  const nlohmann::json costs = nlohmann::json::parse(read_text(in_source("tools/gpu_cost/table.json")));
  std::map<std::string, nlohmann::json> rows;
  for (const auto& row : r.at("rows")) rows[row.at("deformer")] = row;
  for (const char* const name :
       {"rigid", "stitched", "joint_local", "ssd", "ssd_refit", "as_lift", "as_smooth", "as_fit", "as_helpers",
        "as_helpers_fit4", "as_helpers_fit5", "mwe", "psd", "eigenskin"}) {
    ASSERT_TRUE(rows.contains(name)) << name;
    for (const char* const field : {"train_rms", "train_max", "held_rms", "held_max", "worse_share", "volume",
                                    "crease_deg", "normal_deg", "blended_normal_deg"})
      EXPECT_TRUE(rows[name].at(field).is_number()) << name << " " << field;
    const bool is_eigen = std::string(name) == "eigenskin", is_cooked = !is_eigen && !is_measured_alone(name);
    EXPECT_EQ(rows[name].at("displacements_per_vertex").is_number(), is_eigen) << name;
    EXPECT_EQ(rows[name].at("bytes_per_vertex").is_number(), is_cooked) << name;
    EXPECT_EQ(rows[name].at("ns_per_vertex").is_number(), is_cooked) << name;
    for (const char* const field : {"influences", "palette_entries"})
      EXPECT_EQ(rows[name].at(field).is_number(), is_cooked) << name << " " << field;
    const bool on_gpu = is_cooked && std::string(name) != "mwe" &&
                        (std::string(name) != "psd" || is_told(costs, "ubo/psd/4/pn/colour"));
    for (const char* const field : {"mali_cycles", "adreno_instructions", "videocore_instructions"})
      EXPECT_EQ(rows[name].at(field).is_number(), on_gpu) << name << " " << field;
    // Counted only where the processor's counter can be read; a kernel takes some tens.
    const nlohmann::json& instructions = rows[name].at("instructions_per_vertex");
    EXPECT_TRUE(instructions.is_null() || (is_cooked && instructions > 5 && instructions < 500)) << instructions;
  }
  // The cylinder has two influences and normals, which the programs for four draw: palettes where they cost less.
  const auto least = [&](const char* program, std::size_t gpu, std::size_t figure) {
    double out = 1e9;
    for (const char* const path : {"ubo/", "texture/"})
      out = std::min(out, costs["programs"][path + std::string(program)][gpu][figure].get<double>());
    return out;
  };
  ASSERT_EQ(costs["gpus"][2], "Mali-G57");
  ASSERT_EQ(costs["gpus"][6], "Adreno 660");
  ASSERT_EQ(costs["gpus"][8], "V3D 4.2");
  EXPECT_EQ(rows["ssd"]["mali_cycles"], least("ssd/4/pn/colour", 2, 0));
  EXPECT_EQ(rows["as_fit"]["mali_cycles"], least("as/4/pn-surface/colour", 2, 0));
  EXPECT_EQ(rows["as_fit"]["adreno_instructions"], least("as/4/pn-surface/colour", 6, 1));
  EXPECT_EQ(rows["rigid"]["videocore_instructions"], least("rigid/1/pn/colour", 8, 1));
  const double ssd = rows["ssd"]["held_rms"];
  EXPECT_NEAR(ssd, 0.12, 0.01);  // metres, of a radius of one
  EXPECT_NEAR(rows["as_lift"]["held_rms"].get<double>(), ssd, 1e-9);
  EXPECT_LT(rows["as_fit"]["held_rms"].get<double>(), 0.40 * ssd);
  EXPECT_LT(rows["as_helpers"]["held_rms"].get<double>(), 0.12 * ssd);
  EXPECT_EQ(rows["as_helpers"]["worse_share"], 0);
  EXPECT_LE(rows["as_helpers"]["influences"], rows["ssd"]["influences"]);
  EXPECT_LE(rows["as_helpers"]["bytes_per_vertex"].get<double>(), 1.5 * rows["ssd"]["bytes_per_vertex"].get<double>());
  EXPECT_LT(rows["as_helpers_fit4"]["held_rms"].get<double>(), 0.05 * ssd);
  EXPECT_NEAR(rows["as_helpers_fit4"]["volume"].get<double>(), 1, 0.01);
  EXPECT_LT(rows["eigenskin"]["held_rms"].get<double>(), 0.25 * ssd);
  // Four for each of the vertices that the ramp holds: 0.3 of the length.
  EXPECT_NEAR(rows["eigenskin"]["displacements_per_vertex"].get<double>(), 4 * 0.3, 0.15);
  for (const char* const name : {"as_lift", "as_smooth", "as_fit"}) {
    EXPECT_LT(rows[name]["normal_deg"].get<double>(), 0.5) << name;
    EXPECT_GT(rows[name]["blended_normal_deg"].get<double>(), 10) << name;
  }
  // Where the closed form goes over to other helpers its weights have a kink, which tangents at a vertex do not see.
  for (const char* const name : {"as_helpers", "as_helpers_fit4"}) {
    EXPECT_LT(rows[name]["normal_deg"].get<double>(), 4.5) << name;
    EXPECT_GT(rows[name]["blended_normal_deg"].get<double>(), 9.5) << name;
  }
  EXPECT_EQ(rows["ssd"]["normal_deg"], rows["ssd"]["blended_normal_deg"]);
  expect_range_of_motion(r.at("range_of_motion"));
  expect_looks(r, rows);
}

// The elbow's keys are a quarter of a second apart, with lines between them.
TEST(Compare, SaysHowFarClipsAreOffBetweenFrames) {
  const Ran ran = run_marrow({"compare", in_golden("elbow.gltf"), "--frames", "2,4", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json r = nlohmann::json::parse(ran.out), between = r.at("between_frames");
  for (const nlohmann::json& row : r.at("rows"))
    if (row.at("deformer") == "ssd" || row["deformer"] == "as_lift")
      EXPECT_NEAR(row.at("look").at("jump_of_ssd").get<double>(), 1, 1e-9) << "of its clip";
  ASSERT_EQ(between.size(), 6u);
  const char* const kinds[] = {"linear", "quadratic", "cubic"};
  for (std::size_t i = 0; i < 6; ++i) {
    const nlohmann::json& row = between[i];
    EXPECT_EQ(row.at("hz"), i < 3 ? 2.0 : 4.0);
    EXPECT_EQ(row.at("frames"), i < 3 ? 7 : 12) << "of 2.75 seconds";
    EXPECT_EQ(row.at("interpolation"), kinds[i % 3]);
    EXPECT_LE(row.at("rms"), row.at("max"));
    if (i == 3) {
      EXPECT_LT(row["max"], 1e-5) << "lines are met by lines";
    } else {
      EXPECT_GT(row["rms"], 0.01) << i;
    }
  }
  for (const char* const rates : {"0", "0.5", "241", "nan", "inf", "5,x", "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1"})
    EXPECT_EQ(run_marrow({"compare", in_golden("elbow.gltf"), "--frames", rates}).code, 1) << rates;
  EXPECT_EQ(run_marrow({"compare", "--sample", "cylinder", "--frames", "5"}).code, 1);
}

// The lower arm goes along x by t², as a CUBICSPLINE of two keys, 0 and 2 s.
std::string elbow_on_a_parabola() {
  nlohmann::json elbow = nlohmann::json::parse(read_text(in_golden("elbow.gltf")));
  elbow["buffers"].push_back({{"byteLength", 80},
                              {"uri",
                               "data:application/octet-stream;base64,AAAAAAAAAEAAAAAAAAAAAAAAAAAAAAAAAACAPwAAAAA"
                               "AAAAAAAAAAAAAAAAAAIBAAAAAAAAAAAAAAIBAAACAPwAAAAAAAIBAAAAAAAAAAAA="}});
  elbow["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 8}});
  elbow["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 8}, {"byteLength", 72}});
  elbow["accessors"].push_back(
      {{"bufferView", 7}, {"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}, {"min", {0}}, {"max", {2}}});
  elbow["accessors"].push_back({{"bufferView", 8}, {"componentType", 5126}, {"count", 6}, {"type", "VEC3"}});
  elbow["animations"] = {{{"samplers", {{{"input", 7}, {"output", 8}, {"interpolation", "CUBICSPLINE"}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  return elbow.dump();
}

// Lines are off by h²/4 in the middle of h = half a second; parabolas are met by all else.
TEST(Compare, MeetsAParabolaBetweenFrames) {
  const TemporaryFolder folder;
  write_text(folder / "elbow.gltf", elbow_on_a_parabola());
  const Ran ran = run_marrow({"compare", folder / "elbow.gltf", "--frames", "2", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json between = nlohmann::json::parse(ran.out).at("between_frames");
  ASSERT_EQ(between.size(), 3u);
  EXPECT_EQ(between[0].at("frames"), 5);
  EXPECT_NEAR(between[0].at("max").get<double>(), 0.0625, 1e-5);
  EXPECT_LT(between[1].at("max"), 1e-5);
  EXPECT_LT(between[2].at("max"), 1e-5);
}

TEST(Compare, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_marrow({"compare"}).code, 1);
  EXPECT_EQ(run_marrow({"compare", "--sample", "cylinder", "--truth", "guess"}).code, 1);
  for (const char* const fields : {"0", "17", "2.5", "all"})
    EXPECT_EQ(run_marrow({"compare", "--sample", "cylinder", "--eigenskin", fields}).code, 1) << fields;
#ifdef MARROW_HAS_GLES
  for (const char* const rows : {"ssd", "as_fit,guess", "psd,psd"})
    EXPECT_EQ(run_marrow({"compare", "--sample", "cylinder", "--show", rows}).code, 1) << rows;
#endif
  EXPECT_EQ(run_marrow({"compare", folder / "none.glb"}).code, 2);
  write_triangle(folder / "t.gltf", folder / "t.bin", 1);
  const Ran still = run_marrow({"compare", folder / "t.gltf"});
  EXPECT_EQ(still.code, 3);
  EXPECT_NE(still.err.find("no mesh is bound to a skin"), std::string::npos) << still.err;
}

// Every algorithm on the cylinder, and every path; it draws half a minute long.
TEST(Compare, TheThesis) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: takes minutes under a sanitizer, which sees the same code in the tests of `deform`";
#endif
  EXPECT_EQ(run_marrow({"compare", "--sample", "cylinder", "--full"}).code, 1);
  if (!in_long_form()) GTEST_SKIP() << "SKIPPED: what it reckons is tested in `deform`; MARROW_TESTS=all runs it";
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"compare", "--thesis", "--sample", "cylinder", "--json", "-o", folder / "page.html"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json r = nlohmann::json::parse(ran.out);
  ASSERT_EQ(r.at("studies").size(), 1u);
  std::map<std::string, nlohmann::json> rows;
  for (const auto& row : r["studies"][0].at("rows")) rows[row.at("algorithm")] = row;
  EXPECT_EQ(rows.size(), 17u);
  EXPECT_EQ(rows.at("ssd").at("of_ssd"), 1.0);
  EXPECT_NEAR(rows.at("as_lift").at("twists").at("rms_jump_deg").get<double>(),
              rows["ssd"].at("twists").at("rms_jump_deg").get<double>(), 1e-9)
      << "the same surface";
  // Rigid segments are folded by half a turn where one ends within the other.
  EXPECT_GT(rows.at("rigid").at("bends").at("largest_jump_deg").get<double>(), 170);
  EXPECT_LT(rows.at("as_helpers_fit5").at("twists").at("rms_jump_deg").get<double>(),
            rows["rigid"].at("twists").at("rms_jump_deg").get<double>());
  std::set<std::string> paths;
  for (const auto& rate : r.at("rates")) {
    paths.insert(rate.at("path"));
    ASSERT_EQ(rate.at("frames_per_s").size(), 4u);
    for (const auto& rate_hz : rate["frames_per_s"]) EXPECT_GT(rate_hz.get<double>(), 0);
  }
  EXPECT_TRUE(paths.contains("kernel") && paths.contains("double"));
#ifdef MARROW_HAS_GLES
  for (const char* const path : {"ubo", "texture", "feedback", "cpu"}) EXPECT_TRUE(paths.contains(path)) << path;
#endif
  EXPECT_EQ(r.at("claims").size(), 2u);
  const std::string page = read_text(folder / "page.html");
  for (const char* const mark : {"<h2>What holds</h2>", "<h2>Table 1", "<h2>Table 3", "<h2>Slips"})
    EXPECT_NE(page.find(mark), std::string::npos) << mark;
}

#ifdef MARROW_HAS_GLES
// Each of the page's, under a name that says what it is of.
void expect_pictures_alone(const std::string& page, const std::string& pictures) {
  std::size_t shown = 0, written = 0, errors = 0;
  for (std::size_t at = 0; (at = page.find("data:image/jpeg;base64,", at)) != std::string::npos; ++at) ++shown;
  for (const auto& entry : std::filesystem::directory_iterator(pictures)) {
    EXPECT_EQ(entry.path().extension(), ".png");
    EXPECT_EQ(read_text(entry.path().string()).substr(0, 8), "\x89PNG\r\n\x1a\n");
    ++written;
    errors += entry.path().stem().string().ends_with("-error");
  }
  EXPECT_EQ(written, shown);
  EXPECT_GT(errors, 0u);
  for (const char* const name : {"1-1-ssd", "1-2-joint_local", "1-4-truth", "joint-1-1-ssd"})
    EXPECT_TRUE(std::filesystem::exists(pictures + "/" + name + ".png")) << name;
}
#endif

TEST(Compare, WritesOnePage) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: drivers leak, which the address sanitizer would report";
#endif
  const TemporaryFolder folder;
  std::vector<std::string> arguments = {"compare", tiny_gltf(), "-o", folder / "page.html"};
#ifdef MARROW_HAS_GLES
  arguments.insert(arguments.end(), {"--pictures", folder / "new", "--show", "joint_local,eigenskin"});
#endif
  const Ran ran = run_marrow(arguments);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string page = read_text(folder / "page.html");
  const std::string first = ran.out.substr(0, ran.out.find('\n'));
  EXPECT_EQ(first.find("Use "), 0u) << first;
  EXPECT_NE(page.find("<h1>Use "), std::string::npos);
  EXPECT_LT(page.size(), 3000000u);
  EXPECT_NE(page.find("as_helpers_fit5"), std::string::npos);
  EXPECT_EQ(page.find("://"), std::string::npos) << "self-contained; pictures in base64 have no colons";
  // The figures are there without the script, which finds them by these marks.
  EXPECT_NE(ran.out.find("Poses of the range of motion worse than linear blend skinning"), std::string::npos)
      << ran.out;
  for (const char* const mark :
       {"<th>flipped triangles, a pose</th>", "<th>narrowest ring</th>", "<th>jumps of SSD's</th>",
        "<th>palette entries</th>", "<td data-value=\"truth\">truth</td>", "<h2>Range of motion</h2>",
        "<summary>as_fit, joint by joint</summary>", "<th>ring radius, twisted</th>", "<td data-value=\"ssd\">ssd</td>",
        "<th>RMS, held out, mm</th>", "<svg class=\"chart\"", "<label data-series=\"as_fit\">", "<polyline",
        " data-mm=\""})
    EXPECT_NE(page.find(mark), std::string::npos) << mark;
  EXPECT_EQ(page.find("</script>"), page.rfind("</script>"));
  EXPECT_EQ(page.find(" src=\"http"), std::string::npos);
#ifdef MARROW_HAS_GLES
  EXPECT_NE(page.find("data:image/jpeg;base64,/9j/"), std::string::npos);
  for (const char* const mark :
       {"<figure data-name=\"truth\">", "<figure data-name=\"eigenskin\">", "linear-gradient(90deg,#"})
    EXPECT_NE(page.find(mark), std::string::npos) << mark;
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"new", "page.html"}));
  expect_pictures_alone(page, folder / "new");
  EXPECT_NE(run_marrow({"compare", "--help"}).out.find("--show NAME,...=[as_fit,as_helpers_fit5]"), std::string::npos);
  write_text(folder / "file", "");
  EXPECT_EQ(run_marrow({"compare", tiny_gltf(), "--pictures", folder / "file"}).code, 2);
#else
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"page.html"});
#endif
}

TEST(CookAs, ReportsWhatWasLearnt) {
  const TemporaryFolder folder;
  const std::string out = folder / "t.mrw";
  const Ran ran =
      run_marrow({"cook", tiny_gltf(), "-o", out, "--as", "fit", "--truth", "dqs", "--helpers", "auto", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json learnt = nlohmann::json::parse(ran.out).at("meshes").at(0).at("animation_space");
  for (const char* const field :
       {"kind", "truth", "poses", "made_up_poses", "helpers", "held_out_share", "worse_share"})
    EXPECT_TRUE(learnt.contains(field)) << field;
  EXPECT_EQ(learnt.at("truth"), "dqs");
  EXPECT_EQ(run_marrow({"pose", out, "--deformer", "as", "-o", folder / "p.obj"}).code, 0);
}

TEST(CookAs, TakesHelpersWhereRotationsAreTheTruth) {
  const TemporaryFolder folder;
  const auto cooked = [&](const std::string& truth, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        "cook", in_golden("elbow.gltf"), "-o", folder / "e.mrw", "--as", "fit", "--truth", truth};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_marrow(arguments).code, 0) << truth;
    return read_text(folder / "e.mrw");
  };
  for (const char* const truth : {"dqs", "cor"}) {
    EXPECT_EQ(cooked(truth, {}), cooked(truth, {"--helpers", "auto"})) << truth;
    EXPECT_NE(cooked(truth, {}), cooked(truth, {"--helpers", "0"})) << truth;
  }
  EXPECT_EQ(cooked("delta-mush", {}), cooked("delta-mush", {"--helpers", "0"}));
}

TEST(CookAs, MultiWeightsAndPoseSpaceStandInTheReport) {
  const TemporaryFolder folder;
  for (const char* const codec : {"none", "draco", "meshopt"}) {
    const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--mwe", "--psd", "3", "--truth", "dqs",
                                "--mesh-codec", codec, "--json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const nlohmann::json mesh = nlohmann::json::parse(ran.out).at("meshes").at(0);
    for (const char* const learnt : {"multi_weights", "pose_space"})
      for (const char* const field :
           {"shipped", "truth", "poses", "made_up_poses", "held_out_share", "worse_share", "max_error_m"})
        EXPECT_TRUE(mesh.at(learnt).contains(field)) << learnt << " " << field;
    EXPECT_LE(mesh.at("pose_space").at("examples"), 3);
    EXPECT_EQ(run_marrow({"info", folder / "t.mrw"}).code, 0);
  }
  EXPECT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--mwe", "--as", "fit"}).code, 0);
  EXPECT_EQ(
      run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--mwe", "--truth", "delta-mush", "--delta-mush", "3"})
          .code,
      0);
}

// The elbow is skinned by dual quaternions as it is meant to be: what has learnt from them moves it elsewhere than SSD.
TEST(CookAs, MultiWeightsAndPoseSpaceArePosedAndDrawn) {
  const TemporaryFolder folder;
  const std::string with = folder / "with.mrw", without = folder / "without.mrw";
  ASSERT_EQ(run_marrow({"cook", in_golden("elbow.gltf"), "-o", with, "--mwe", "--psd", "4", "--truth", "dqs"}).code, 0);
  ASSERT_EQ(run_marrow({"cook", in_golden("elbow.gltf"), "-o", without}).code, 0);
  const auto posed = [&](const char* deformer, const char* time) {
    const std::string out = folder / "p.bin";
    EXPECT_EQ(run_marrow({"pose", with, "--clip", "bend", "--time", time, "--deformer", deformer, "-o", out}).code, 0);
    return read_text(out);
  };
  for (const char* const deformer : {"mwe", "psd"}) {
    EXPECT_EQ(posed(deformer, "1").size(), posed("ssd", "1").size());
    EXPECT_NE(posed(deformer, "1"), posed("ssd", "1")) << deformer;
    const Ran bare = run_marrow({"pose", without, "--deformer", deformer, "-o", folder / "p.bin"});
    EXPECT_EQ(bare.code, 4) << bare.err;
    EXPECT_NE(bare.err.find("cook it with --" + std::string(deformer)), std::string::npos) << bare.err;
#ifdef MARROW_HAS_GLES
    const std::vector<std::string> draw = {"render", with,    "--clip",     "bend",   "--time", "1",
                                           "--size", "64x64", "--deformer", deformer, "-o",     folder / "p.png"};
    const auto drawn = [&](const std::string& path) {
      std::vector<std::string> arguments = draw;
      arguments.insert(arguments.end(), {"--path", path});
      return run_marrow(arguments);
    };
    const bool on_gpu = std::string(deformer) == "psd";
    for (const char* const path : {"cpu", "ubo", "texture", "crowd"}) {
      const bool drawable = path == std::string("cpu") || (on_gpu && path != std::string("crowd"));
      const Ran ran = drawn(path);
      EXPECT_EQ(ran.code, drawable ? 0 : 4) << path;
      if (drawable) continue;
      EXPECT_NE(ran.err.find(on_gpu ? "use another --path" : "use --path cpu"), std::string::npos) << ran.err;
    }
    EXPECT_EQ(run_marrow({"render", with, "--clip", "bend", "--time", "1", "--size", "64x64", "--heatmap",
                          "ssd:" + std::string(deformer), "-o", folder / "p.png"})
                  .code,
              0);
#endif
  }
}

TEST(CookAs, ShowsItsProgressOnATerminalOnly) {
  const TemporaryFolder folder;
  const std::vector<std::string> arguments = {"cook",    tiny_gltf(), "-o",    folder / "t.mrw", "--as", "fit",
                                              "--truth", "dqs",       "--mwe", "--psd",          "2",    "--json"};
  const Ran piped = run_marrow(arguments), shown = run_marrow_on_terminal(arguments);
  EXPECT_EQ(piped.err.find("fitting"), std::string::npos) << piped.err;
  EXPECT_EQ(piped.err.find('\r'), std::string::npos) << piped.err;
  EXPECT_EQ(shown.code, 0);
  EXPECT_EQ(shown.out, piped.out);
  EXPECT_NE(shown.err.find("[1/"), std::string::npos) << shown.err;
  EXPECT_NE(shown.err.find("fitting"), std::string::npos) << shown.err;
  EXPECT_TRUE(shown.err.ends_with("\r\033[K")) << "the line is wiped at the end";
}

TEST(CookAs, SaysWhatTookHalfJointsPlace) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--as", "fit", "--half-joints", "1"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("give --helpers N or --helpers auto"), std::string::npos) << ran.err;
}

TEST(CookAs, RefusesWhatMakesNoSense) {
  const TemporaryFolder folder;
  const std::string out = folder / "t.mrw";
  for (const std::vector<std::string>& extra : {std::vector<std::string>{"--truth", "dqs"},
                                                {"--half-joints", "1"},
                                                {"--influences", "4"},
                                                {"--as", "fit", "--influences", "0"},
                                                {"--as", "fit", "--influences", "9"},
                                                {"--keep-bind-pose"},
                                                {"--wide-poses"},
                                                {"--mwe", "--truth", "examples", "--examples", "a", "--wide-poses"},
                                                {"--delta-mush", "10"},
                                                {"--as", "lift", "--delta-mush", "10"},
                                                {"--mwe", "--truth", "dqs", "--delta-mush", "10"},
                                                {"--mwe"},
                                                {"--psd", "8"},
                                                {"--psd", "0", "--truth", "dqs"},
                                                {"--psd", "33", "--truth", "dqs"},
                                                {"--psd", "2.5", "--truth", "dqs"},
                                                {"--as", "smooth", "--helpers", "1"},
                                                {"--as", "fit", "--delta-mush", "0"},
                                                {"--as", "fit", "--delta-mush", "10,2"},
                                                {"--as", "fit", "--delta-mush", "10,0.5,hard"},
                                                {"--elastic", "volume=15"},
                                                {"--as", "fit", "--elastic", "volume=15"},
                                                {"--as", "fit", "--truth", "elastic", "--elastic", "volume"},
                                                {"--as", "fit", "--helpers", "-1"},
                                                {"--as", "fit", "--helpers", "many"},
                                                {"--subdivide", "4"},
                                                {"--subdivide", "1.5"},
                                                {"--subdivide", "-1"},
                                                {"--subdivide", "1", "--mwe", "--truth", "dqs"},
                                                {"--subdivide", "1", "--psd", "2", "--truth", "dqs"},
                                                {"--keep-vertex-order", "--subdivide", "1"}}) {
    std::vector<std::string> arguments = {"cook", tiny_gltf(), "-o", out};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    EXPECT_EQ(run_marrow(arguments).code, 1) << extra.back();
  }
  EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace marrow::test
