// A cooked file as both Godots see it: one of its skeletons, posed, and its meshes as plain lists. No word of Godot.
#pragma once
#include <marrow/c.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace marrow_godot {

// Memory on a boundary of 16 bytes; null if there is none.
class Block {
 public:
  bool make(std::size_t bytes);
  void* data() const { return block_.data; }
  std::size_t size() const { return block_.size; }

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::unique_ptr<void, Free> memory_;
  mrw_block block_{};
};

// A local transform: translation, rotation as a quaternion x y z w, scale.
constexpr int kReals = 10;

class Cooked {
 public:
  // Reads a file that lies in memory, of which a copy is kept. False: error() says why, and nothing is open.
  // name: what messages call it. skeleton: which of the file's, from 0.
  bool open(const void* bytes, std::size_t size, const std::string& name, std::int64_t skeleton);

  // Adds the clips of a clip pack that was cooked for this file: their indices go on. False: nothing is added.
  bool add_clips(const void* bytes, std::size_t size, const std::string& name);

  // The last thing that went wrong, with the file's name and what to do.
  const std::string& error() const { return error_; }
  bool fail(const std::string& what);

  // Clips of the skeleton; an index below is one of this list.
  const std::vector<std::string>& clips() const { return clip_names_; }
  std::int64_t find_clip(const std::string& name);  // -1: none, and error() lists those that there are
  double duration(std::int64_t clip) const;

  std::vector<std::string> bones() const;     // names that Godot takes: mixamorig:Hips is mixamorig_Hips
  std::vector<std::int32_t> parents() const;  // -1: none
  // kReals a bone. A scale of 0 counts as 1, for Godot inverts rests.
  const std::vector<float>& rests() const { return rests_; }
  // What stands above all roots, three rows of four: the transform of the skeleton's node.
  const std::vector<float>& above() const { return above_; }

  // Graphs of behaviour: the file's, then those of packs.
  std::vector<std::string> graphs() const;
  // What plays the graph of a name, or of none the first, by clips that are there now: a number, for the functions
  // below, which refuse others. -1: error() says why. As long as the file is open, or until it is let go.
  std::int64_t make_animator(const std::string& graph);
  bool free_animator(std::int64_t animator);
  std::vector<std::string> parameters(std::int64_t animator);
  // Four a parameter: 0 a number, 1 a flag or 2 a trigger; what it is set to; of a number the least and the most.
  std::vector<float> parameter_reals(std::int64_t animator);
  // -1: none, and error() lists those that there are.
  std::int64_t find_parameter(std::int64_t animator, const std::string& name);
  // A number, or a flag: 0 or not.
  bool set_parameter(std::int64_t animator, std::int64_t parameter, double value);
  bool fire(std::int64_t animator, std::int64_t parameter);
  // Moves on. The root's step, as a rotation x y z w and a translation, then the number and the time of each event.
  // Empty: error() says why.
  std::vector<float> update(std::int64_t animator, double dt_s);
  std::vector<std::string> events(std::int64_t animator);  // names of those of the last update
  const float* pose_graph(std::int64_t animator);          // as pose()
  // The name of the state that a machine is in; empty if it is not shown, or error() says why.
  std::string state_of(std::int64_t animator, const std::string& machine, double* seconds);
  mrw_bytes state(std::int64_t animator);  // what it is in, until the next call; empty: error() says why
  bool restore(std::int64_t animator, const void* bytes, std::size_t size);

  // kReals a bone: `clip` at `time_s`, and of `other`, unless it is -1, all but `share`. Null: error() says why.
  const float* pose(std::int64_t clip, double time_s, std::int64_t other, double other_s, double share);
  std::size_t bone_count() const { return rests_.size() / kReals; }

  std::int64_t mesh_count() const { return std::int64_t(meshes_.size()); }
  std::string mesh_name(std::int64_t mesh) const;
  // positions, normals, uvs, tangents, colours, weights, binds (rows), colour (one). Empty if absent.
  std::vector<float> mesh_reals(std::int64_t mesh, const std::string& what, std::int64_t influences);
  // indices (clockwise fronts), bones (as many a vertex as influences), bind_bones, influences, double_sided.
  std::vector<std::int32_t> mesh_ints(std::int64_t mesh, const std::string& what, std::int64_t influences);

 private:
  // A file, what it lies in, and what plays its clips.
  struct Part {
    std::string name;
    Block block, animations;
    mrw_file file{};
    mrw_animations clips{};
  };
  // A graph with the clips that were there.
  struct Bound {
    Block block;
    mrw_graph_binding binding{};
    std::size_t packs = 0;  // that were there
  };
  struct Played {
    std::shared_ptr<Bound> bound;
    Block block;
    mrw_animator animator{};
    mrw_animator_step step{};
  };

  bool read(const void* bytes, std::size_t size, const std::string& name, Part& out);
  bool choose(std::int64_t skeleton);
  bool place();
  bool take_clips(Part& from);
  bool fail_of(const Part& part, const std::string& what);
  bool layer(std::int64_t clip, double time_s, double weight, mrw_animation_layer& out);
  bool make_room(std::uint32_t layers);
  const float* take_pose();
  const Part* find_graph(const std::string& name, mrw_graph& out);
  std::shared_ptr<Bound> bind(const Part& source, const mrw_graph& graph);
  Played* played(std::int64_t animator);

  std::string name_, error_;
  Part file_;
  std::vector<std::unique_ptr<Part>> packs_;
  Block character_block_;
  mrw_character character_{};
  std::vector<std::shared_ptr<Bound>> bound_;
  std::vector<std::unique_ptr<Played>> animators_;  // null: let go
  mrw_skeleton skeleton_{};
  std::uint32_t chosen_ = 0;
  std::vector<const mrw_animation*> clips_;
  std::vector<std::string> clip_names_;
  std::vector<float> rests_, above_, pose_;
  std::vector<mrw_mesh> meshes_;
};

}  // namespace marrow_godot
