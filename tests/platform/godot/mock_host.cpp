// Loads Marrow's library for Godot 4 as Godot would, calls all that it registers in both of Godot's ways, and unloads
// it. usage: mock_host LIBRARY FILE.mrw BEHAVING.mrw OUT_FOLDER [BAD.mrw ...]
// OUT_FOLDER: poses.bin, graph.bin and graph.txt as reference.c has them, of what the skeleton was told and the methods
// returned; lists.json, what else they returned, for recorded.gd.
#include <dlfcn.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "mock_engine.h"

namespace {

using mock::engine;
using mock::Object;
using mock::Variant;

int failures = 0;

void must(bool good, const std::string& what) {
  if (good) return;
  ++failures;
  std::printf("FAILED: %s\n", what.c_str());
}

std::vector<std::uint8_t> read_file(const std::string& name) {
  std::ifstream stream(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string file_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

using Initialize = std::uint8_t(gdextension::GetFunction, void*, gdextension::Initialization*);

struct Script {
  Object* object;

  template <typename... Arguments>
  Variant call(const char* method, const Arguments&... arguments) {
    Variant result;
    gdextension::CallError error;
    if (!engine().call(*object, method, {&arguments...}, result, error))
      must(false, std::string(method) + " refuses its arguments");
    return result;
  }
  template <typename... Arguments>
  Variant call_typed(const char* method, const Arguments&... arguments) {
    return engine().call_typed(*object, method, {&arguments...});
  }
  template <typename... Arguments>
  void refuses(int wanted, int argument, const char* method, const Arguments&... arguments) {
    Variant result;
    gdextension::CallError error;
    const bool good = engine().call(*object, method, {&arguments...}, result, error);
    must(!good && error.error == wanted && error.argument == argument && result.type == gdextension::kNil,
         std::string(method) + " takes arguments that are none");
  }
  void says(const std::string& message) {
    const auto& property = engine().classes.at(object->type).properties.at("error");
    must(property.setter.empty() && property.type == gdextension::kString, "`error` is to be read alone");
    const std::string error = call(property.getter.c_str()).text();
    must(error.find(message) != std::string::npos, "\"" + error + "\" has \"" + message + "\"");
  }
};

// Poses of all clips, by turns in both ways.
void play(Script native, Object& skeleton, const std::string& name) {
  std::ofstream poses(name, std::ios::binary);
  const Variant none(-1), zero(0.0), all(1.0), on(&skeleton);
  const std::int64_t clips = std::int64_t(native.call("clips").texts().size());
  must(clips == 4, "there are four clips");
  for (std::int64_t clip = 0; clip < clips; ++clip) {
    must(native.call("duration", Variant(clip)).real() > 1, "a clip is longer than a second");
    for (int step = 0; step < 30; ++step) {
      const Variant which(clip), time(step * 0.05);
      const Variant posed = step % 2 == 0 ? native.call("pose", on, which, time, none, zero, all)
                                          : native.call_typed("pose", on, which, time, none, zero, all);
      must(posed.type == gdextension::kBool && posed.truth(), "pose() says that it posed");
      const std::vector<float> sampled = native.call_typed("sample", which, time, none, zero, all).reals();
      must(sampled == skeleton.pose, "sample() is what pose() sets");
      poses.write(reinterpret_cast<const char*>(skeleton.pose.data()), std::streamsize(4 * skeleton.pose.size()));
    }
  }
  // A whole number will do for a time, and half of each of two clips lies between them.
  native.call("pose", on, Variant(0), Variant(0), none, zero, all);
  const float first = skeleton.pose[10 * 5 + 4];
  native.call("pose", on, Variant(1), zero, none, zero, all);
  const float second = skeleton.pose[10 * 5 + 4];
  native.call("pose", on, Variant(0), zero, Variant(1), zero, Variant(0.5));
  const float middle = skeleton.pose[10 * 5 + 4];
  must((middle - first) * (middle - second) < 0, "a fade lies between its clips");
}

// A graph, as reference.c plays it.
void play_graph(Script native, Object& skeleton, const std::string& folder) {
  std::ofstream numbers(folder + "/graph.bin", std::ios::binary), words(folder + "/graph.txt");
  const auto put = [&numbers](const std::vector<float>& reals) {
    numbers.write(reinterpret_cast<const char*>(reals.data()), std::streamsize(4 * reals.size()));
  };
  const Variant on(&skeleton), body("body"), delta(1.0 / 60);
  must(native.call("graphs").texts() == std::vector<std::string>{"animator"}, "there is a graph");
  const Variant other = native.call("make_animator", Variant("")),
                it = native.call("make_animator", Variant("animator"));
  must(other.whole() == 0 && it.whole() == 1, "each has its own number");
  must(native.call("parameters", it).texts() == std::vector<std::string>{"speed", "reach"}, "parameters have names");
  must(native.call_typed("parameter_reals", it).reals() == std::vector<float>{0, 0, 0, 1, 2, 0, 0, 0},
       "a number from 0 to 1, and a trigger");
  const Variant speed = native.call("find_parameter", it, Variant("speed")),
                reach = native.call_typed("find_parameter", it, Variant("reach"));
  must(native.call("state_of", it, body).text().empty(), "nothing is shown at first");
  must(native.call("set_parameter", it, speed, Variant(0.3)).truth(), "speed is set");
  std::vector<std::uint8_t> saved;
  std::string before;
  for (int frame = 0; frame < 300; ++frame) {
    if (frame == 120) {
      saved = native.call_typed("get_state", it).bytes();
      must(saved.size() > 100 && saved == native.call("get_state", it).bytes(), "it has a state");
      must(native.call("set_parameter", it, speed, Variant(0)).truth(), "speed is set to a whole number");
      must(native.call_typed("fire", it, reach).truth(), "reach is fired");
    }
    if (frame == 240) must(native.call("set_state", it, Variant(saved)).truth(), "it is taken back");
    const std::vector<float> step =
        frame % 2 == 0 ? native.call("update", it, delta).reals() : native.call_typed("update", it, delta).reals();
    const std::vector<std::string> events = native.call("events", it).texts();
    must(step.size() == 7 + 2 * events.size(), "a step has its events");
    put(step);
    for (const std::string& event : events) words << frame << ' ' << event << '\n';
    must(native.call("pose_graph", on, it).truth(), "it is posed");
    must(native.call_typed("sample_graph", it).reals() == skeleton.pose, "sample_graph() is what pose_graph() sets");
    put(skeleton.pose);
    const std::string state = native.call("state_of", it, body).text();
    if (state != before) words << frame << " is in " << state << '\n';
    before = state;
  }
  must(std::abs(native.call("state_time", it, body).real() - 3) < 1e-3, "and is in it for 3 s");
  must(native.call("free_animator", it).truth() && !native.call("free_animator", it).truth(), "it is let go");
  native.says("there is no animator 1");
  must(native.call("make_animator", Variant("")).whole() == 1, "a number is given again");
}

void refuse_graph(Script native, Object& skeleton) {
  const Variant it = native.call("make_animator", Variant("")), on(&skeleton), none(-1),
                saved(std::vector<std::uint8_t>(9));
  must(native.call("make_animator", Variant("animatr")).whole() == -1, "another graph");
  native.says("behaving.mrw: there is no graph \"animatr\": it has animator");
  must(native.call("find_parameter", it, Variant("sped")).whole() == -1, "another parameter");
  native.says("has no parameter \"sped\": it has speed, reach");
  const Variant speed(0), reach(1), second(1.0);
  must(!native.call("fire", it, speed).truth(), "a number is fired");
  native.says("\"speed\" is no trigger: set_parameter()");
  must(!native.call("set_parameter", it, reach, second).truth(), "a trigger is set");
  native.says("\"reach\" is a trigger: fire()");
  must(!native.call("set_parameter", it, speed, Variant(std::nan(""))).truth(), "speed is no number");
  native.says("no number");
  for (const Variant* wrong : {&none, &it}) {  // it: 2, as there are two parameters
    must(!native.call("set_parameter", it, *wrong, second).truth(), "a parameter that is not there");
    native.says("has no parameter");
    must(!native.call("fire", it, *wrong).truth(), "nor is it fired");
  }
  must(!native.call("pose_graph", on, it).truth(), "it is posed before its first update");
  native.says("first update()");
  must(native.call("update", it, Variant(-1.0)).reals().empty(), "time goes back");
  native.says("not below 0");
  must(!native.call("set_state", it, saved).truth(), "other bytes are a state");
  native.says("no state of the graph");
  must(native.call("state_of", it, Variant("move")).text().empty(), "a space is no machine");
  native.says("has no machine \"move\": it has body");
  native.call("update", it, second);
  must(!native.call("pose_graph", Variant(), it).truth(), "null is posed");
  native.says("is no skeleton of 44 bones");
  for (const char* method : {"parameters", "parameter_reals", "events", "get_state", "sample_graph"}) {
    const Variant nothing = native.call(method, none);
    must(nothing.texts().empty(), std::string(method) + " of none");
    native.says("there is no animator -1");
  }
  must(native.call("update", none, second).reals().empty() && !native.call("set_state", none, saved).truth() &&
           !native.call("fire", none, reach).truth() &&
           native.call("find_parameter", none, Variant("a")).whole() == -1 &&
           native.call("state_of", none, Variant("body")).text().empty(),
       "none is played");
}

void look_at_lists(Script native) {
  const std::size_t bones = native.call("bones").texts().size();
  const std::vector<std::int32_t> parents = native.call_typed("parents").ints();
  must(bones == 44 && parents.size() == 44 && parents[0] == -1 && parents[43] >= 0, "there are 44 bones");
  must(native.call_typed("bones").texts() == native.call("bones").texts(), "both ways tell the same names");
  must(native.call("rests").reals().size() == 440 && native.call("above").reals().size() == 12, "bones have rests");
  must(native.call("find_clip", Variant("walk")).whole() == 1, "walk is the second clip");
  const std::int64_t meshes = native.call("mesh_count").whole();
  must(meshes == 6 && native.call_typed("mesh_name", Variant(0)).text() == "body", "there are six meshes");
  for (std::int64_t mesh = 0; mesh < meshes; ++mesh) {
    for (std::int64_t influences : {4, 8}) {
      const Variant which(mesh), most(influences);
      const std::size_t vertices = native.call("mesh_reals", which, Variant("positions"), most).reals().size() / 3;
      const std::vector<float> weights = native.call("mesh_reals", which, Variant("weights"), most).reals();
      const std::vector<std::int32_t> of = native.call("mesh_ints", which, Variant("bones"), most).ints();
      const std::size_t binds = native.call_typed("mesh_ints", which, Variant("bind_bones"), most).ints().size();
      must(vertices > 0 && weights.size() == vertices * std::size_t(influences) && of.size() == weights.size() &&
               native.call("mesh_reals", which, Variant("binds"), most).reals().size() == 12 * binds,
           "lists have the sizes of their mesh");
      for (std::size_t v = 0; v < vertices; ++v) {
        float sum = 0;
        for (std::size_t i = 0; i < std::size_t(influences); ++i) sum += weights[v * std::size_t(influences) + i];
        must(sum > 0.99999f && sum < 1.00001f, "weights sum to 1");
      }
      for (std::int32_t bind : of) must(bind >= 0 && std::size_t(bind) < binds, "bones are in range");
      for (std::int32_t index : native.call("mesh_ints", which, Variant("indices"), most).ints())
        must(index >= 0 && std::size_t(index) < vertices, "indices are in range");
    }
  }
}

void refuse(Script native, Object& skeleton) {
  const Variant none(-1), zero(0.0), all(1.0), first(0), on(&skeleton);
  native.call("find_clip", Variant("wolk"));
  native.says("newt.mrw: there is no clip \"wolk\": it has idle, walk, twist, reach, idle");
  Object other{"Node3D", nullptr, {}}, small{"Skeleton3D", nullptr, std::vector<float>(30)};
  for (Object* wrong : {&other, &small, static_cast<Object*>(nullptr)}) {
    must(!native.call("pose", Variant(wrong), first, zero, none, zero, all).truth(), "another object is posed");
    native.says("is no skeleton of 44 bones");
  }
  must(!native.call("pose", Variant(), first, zero, none, zero, all).truth(), "null is posed");
  must(!native.call("pose", on, Variant(8), zero, none, zero, all).truth(), "a ninth clip is played");
  native.says("there is no clip 8");
  must(!native.call("pose", on, first, zero, first, zero, Variant(1.5)).truth(), "more than all is played");
  native.says("share");
  native.refuses(gdextension::kTooFew, 6, "pose", on);
  native.refuses(gdextension::kTooMany, 0, "clips", first);
  native.refuses(gdextension::kInvalidArgument, 0, "find_clip", first);
  native.refuses(gdextension::kInvalidArgument, 1, "pose", on, Variant("walk"), zero, none, zero, all);
  native.refuses(gdextension::kInvalidArgument, 0, "open", Variant("bytes"), Variant("name"), first);
}

template <typename Number>
std::string to_json(const std::vector<Number>& numbers) {
  std::string out = "[";
  char text[32];
  for (const Number& each : numbers) {
    std::snprintf(text, sizeof text, "%.9g", double(each));
    (out += out.size() == 1 ? "" : ",") += text;
  }
  return out + "]";
}

std::string to_json(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& each : texts) (((out += out.size() == 1 ? "" : ",") += '"') += each) += '"';
  return out + "]";
}

void record(Script native, const std::string& name) {
  std::ofstream out(name);
  out << "{\"clips\":" << to_json(native.call("clips").texts())
      << ",\n\"bones\":" << to_json(native.call("bones").texts())
      << ",\n\"parents\":" << to_json(native.call("parents").ints())
      << ",\n\"rests\":" << to_json(native.call("rests").reals())
      << ",\n\"above\":" << to_json(native.call("above").reals());
  std::vector<double> durations;
  for (int clip = 0; clip < 4; ++clip) durations.push_back(native.call("duration", Variant(clip)).real());
  out << ",\n\"durations\":" << to_json(durations);
  for (int mesh = 0; mesh < 6; ++mesh) {
    const Variant which(mesh), most(4);
    out << ",\n\"mesh_name " << mesh << "\":\"" << native.call("mesh_name", which).text() << '"';
    for (const char* what : {"positions", "normals", "tangents", "uvs", "colours", "weights", "binds", "colour"})
      out << ",\n\"" << what << ' ' << mesh
          << "\":" << to_json(native.call("mesh_reals", which, Variant(what), most).reals());
    for (const char* what : {"indices", "bones", "bind_bones", "influences", "double_sided"})
      out << ",\n\"" << what << ' ' << mesh
          << "\":" << to_json(native.call("mesh_ints", which, Variant(what), most).ints());
  }
  out << "}\n";
}

// The file with a graph; then another is opened in its place, and has none.
void run_graph(const char* file, const char* other, const std::string& folder) {
  Object* const object = engine().make("MarrowNative");
  Object skeleton{"Skeleton3D", nullptr, std::vector<float>(440)};
  Script native{object};
  must(native.call("make_animator", Variant("")).whole() == -1 && native.call("graphs").texts().empty(),
       "nothing is open");
  native.says("nothing is open");
  must(native.call("open", Variant(read_file(file)), Variant("behaving.mrw"), Variant(0)).truth(), "it opens");
  play_graph(native, skeleton, folder);
  refuse_graph(native, skeleton);
  must(native.call("open", Variant(read_file(other)), Variant("newt.mrw"), Variant(0)).truth(), "and another");
  must(native.call("update", Variant(0), Variant(1.0)).reals().empty(), "what played went with its file");
  must(native.call("make_animator", Variant("")).whole() == -1, "it has no graph");
  native.says("newt.mrw: there is no graph: cook it with --graph");
  engine().free(object);
}

Object* run(const char* file, const std::string& folder, int bad_count, char** bad) {
  Object* const object = engine().make("MarrowNative");
  Object skeleton{"Skeleton3D", nullptr, std::vector<float>(440)};
  Script native{object};
  must(!native.call("pose", Variant(&skeleton), Variant(0), Variant(0.0), Variant(-1), Variant(0.0), Variant(1.0))
            .truth(),
       "nothing is posed");
  native.says("nothing is open");
  for (int i = 0; i < bad_count; ++i) {
    const Variant bytes(read_file(bad[i])), name(file_name(bad[i]).c_str());
    must(!native.call("open", bytes, name, Variant(0)).truth(), file_name(bad[i]) + " opens");
    std::printf("%s\n", native.call("get_error").text().c_str());
    must(!native.call("add_clips", bytes, name).truth(), "clips are added to nothing");
  }
  const Variant bytes(read_file(file));
  must(!native.call("open", bytes, Variant("newt.mrw"), Variant(3)).truth(), "a fourth skeleton opens");
  native.says("newt.mrw: has no skeleton 3");
  if (!native.call_typed("open", bytes, Variant("newt.mrw"), Variant(0)).truth()) {
    std::printf("%s\n", native.call("get_error").text().c_str());
    ++failures;
    return object;
  }
  native.says("");
  look_at_lists(native);
  play(native, skeleton, folder + "/poses.bin");
  record(native, folder + "/lists.json");
  for (int i = 0; i < bad_count; ++i) {  // of which clip packs are good for this
    const bool good = native.call("add_clips", Variant(read_file(bad[i])), Variant("other.mrw")).truth();
    must(good == (file_name(bad[i]) == "pack.mrw"), file_name(bad[i]) + " is taken for what it is not");
    if (!good) native.says("other.mrw: ");
  }
  must(bad_count == 0 || native.call("clips").texts().size() == 8, "a pack's clips are there");
  must(native.call("duration", Variant(7)).real() == native.call("duration", Variant(3)).real(), "and play as long");
  refuse(native, skeleton);
  if (bad_count == 0) return object;
  const Variant played = native.call("make_animator", Variant("animator"));
  must(played.whole() == 0 && native.call("update", played, Variant(0.5)).reals().size() >= 7 &&
           native.call("pose_graph", Variant(&skeleton), played).truth(),
       "a pack's graph is played");
  return object;
}

// Godots that are not as the library wants them.
void run_on_others(Initialize* initialize) {
  gdextension::Initialization levels;
  engine().without = "object_cast_to";
  must(initialize(mock::get_function, nullptr, &levels) == 0, "the library starts where a function is missing");
  engine().without.clear();
  engine().other_skeleton = true;
  must(initialize(mock::get_function, nullptr, &levels) == 1, "the library starts");
  levels.initialize(levels.userdata, 2);
  must(engine().errors.size() == 4 && engine().errors[1].find("Skeleton3D.set_bone_pose_position") != std::string::npos,
       "another Skeleton3D is told");
  levels.deinitialize(levels.userdata, 2);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  void* const library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  auto* const initialize =
      reinterpret_cast<Initialize*>(library == nullptr ? nullptr : dlsym(library, "marrow_godot_init"));
  if (initialize == nullptr) {
    std::printf("mock_host: %s\n", dlerror());
    return 1;
  }
  gdextension::Initialization levels{};
  must(initialize(mock::get_function, &engine(), &levels) == 1 && levels.minimum_level == 2, "the library starts");
  for (int level = 0; level < 4; ++level) levels.initialize(levels.userdata, level);
  must(engine().classes.size() == 1 && engine().classes.at("MarrowNative").parent == "RefCounted", "a class is there");
  std::printf("MarrowNative: %d methods\n", int(engine().classes.at("MarrowNative").methods.size()));
  engine().free(run(argv[2], argv[4], argc - 5, argv + 5));
  if (failures == 0) run_graph(argv[3], argv[2], argv[4]);
  must(engine().errors.empty(), "nothing is told as an error");
  for (int level = 3; level >= 0; --level) levels.deinitialize(levels.userdata, level);
  must(engine().classes.empty(), "no class stays");
  run_on_others(initialize);
  must(engine().live == 0, std::to_string(engine().live) + " values are not destroyed");
  dlclose(library);
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
