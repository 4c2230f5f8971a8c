#include "commands/view/actor.h"

#include <algorithm>
#include <chrono>

#include "render/heat.h"

namespace marrow::tools {
namespace {

float milliseconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::vector<NamedJoint> all_joints(const File& file) {
  std::vector<NamedJoint> out;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Skeleton skeleton = file.skeleton(s);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
      std::string name = file.text(skeleton.names[j]);
      if (name.empty()) name = "joint " + std::to_string(j);
      out.push_back({file.skeleton_count() > 1 ? std::string(skeleton.name) + ": " + name : name, s, j});
    }
  }
  return out;
}

// Of the first clip that moves anything.
std::string first_name(const Play& play) {
  std::uint32_t skeleton = 0;
  while (!play.clip(skeleton)) ++skeleton;
  return play.clip(skeleton)->name;
}

}  // namespace

Actor::Actor(const Gl& gl, gles3::ProgramSet& programs, const LookArguments& arguments, LoadedFile loaded,
             Chosen chosen)
    : gl_(gl),
      programs_(programs),
      arguments_(arguments),
      loaded_(std::move(loaded)),
      joints_(all_joints(loaded_.file)),
      textures_(gl, arguments.file, loaded_.file, places_of_cooked(arguments.file, arguments.images_from)) {
  add_plays(std::move(chosen));
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i)
    coarsest_lod_ = std::max(coarsest_lod_, static_cast<int>(file().mesh(i).lods.size));
}

void Actor::add_plays(Chosen chosen) {
  plays_.push_back({"rest pose", {}});
  for (std::uint32_t i = 0; i < file().clip_count(); ++i) {
    const std::string name = file().clip(i).name;
    // The others of a name play along with the first.
    if (!name.empty() && file().find_clip(name.c_str()) != i) continue;
    plays_.push_back({name.empty() ? "clip " + std::to_string(i) : name, play_together(file(), i)});
  }
  if (chosen.play.empty()) return;
  if (chosen.pack) {
    pack_ = std::move(chosen.pack);
    const Choice& choice = arguments_.choice;
    plays_.push_back({choice.clip + " (" + choice.clips + ")", std::move(chosen.play)});
    chosen_ = plays_.size() - 1;
    return;
  }
  const auto same = [&](const NamedPlay& named) {
    return !named.play.empty() && first_name(named.play) == first_name(chosen.play);
  };
  chosen_ = static_cast<std::size_t>(std::ranges::find_if(plays_, same) - plays_.begin());
}

void Actor::make(const Made& wanted) {
  if (wanted == made_) return;
  if (wanted.lod != made_.lod || wanted.normals != made_.normals) {
    const auto level = static_cast<std::uint32_t>(wanted.lod);
    character_.emplace(file(), wanted.normals, level);
    figure_.emplace(gl_, programs_, file(), &textures_, wanted.normals, level);
  }
  performance_.emplace(file(), *character_, plays_[wanted.clip].play);
  heat_largest_ = 0;
  made_ = wanted;
}

void Actor::pose(const Settings& settings) {
  make({settings.clip, settings.lod, settings.normals});
  const float time_s = clip_time(settings.playback);
  const Play& first = plays_[settings.clip].play;
  times_.pose = milliseconds_of([&] {
    if (settings.second == 0) return character_->pose(first, time_s);
    // In step: at the same share of their lengths.
    const Play& second = plays_[settings.second].play;
    const float share = first.duration_s > 0 ? time_s / first.duration_s : 0;
    const PlayLayer layers[] = {{first, time_s, 1 - settings.second_weight},
                                {second, share * second.duration_s, settings.second_weight}};
    character_->pose(layers);
  });
}

std::vector<Drawable> Actor::drawables(const Settings& settings, Shot& shot) {
  shot.box = performance_->box(*character_);
  std::vector<Drawable> out;
  times_.skin = milliseconds_of([&] {
    if (settings.colours == Colours::distance) {
      out = heat(settings, shot);
    } else if (settings.colours == Colours::weights && !joints_.empty()) {
      out = weighted(settings, shot);
    } else {
      const SkinPath path = cpu_only() ? SkinPath::cpu : settings.path;
      out = drawables_of(arguments_.file, file(), *character_, *figure_, {settings.deformer, path, std::nullopt}, shot);
    }
  });
  return out;
}

std::vector<Drawable> Actor::weighted(const Settings& settings, Shot& shot) {
  const NamedJoint& joint = joints_[settings.joint];
  std::vector<std::vector<float>> colours;
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i) {
    const Mesh mesh = file().mesh(i, static_cast<std::uint32_t>(settings.lod));
    const bool is_its = mesh.skeleton == joint.skeleton;
    colours.push_back(
        ramp_colours(is_its ? joint_weights(mesh, joint.joint) : std::vector<float>(mesh.geometry.slot_count, 0.0f)));
  }
  shot.shading = kHeatShading;
  return figure_->from_cpu(skin_all(file(), *character_, settings.deformer), colours);
}

std::vector<Drawable> Actor::heat(const Settings& settings, Shot& shot) {
  if (settings.pair != heat_pair_) heat_largest_ = 0;
  heat_pair_ = settings.pair;
  const std::vector<PosedMesh> a = skin_all(file(), *character_, settings.pair.first);
  const std::vector<PosedMesh> b = skin_all(file(), *character_, settings.pair.second);
  heat_largest_ = std::max(heat_largest_, largest_distance(a, b));
  heat_scale_ = sensible_scale(heat_largest_, performance_->diagonal());
  shot.shading = kHeatShading;
  return figure_->from_cpu(a, compare(a, b, heat_scale_).colours);
}

}  // namespace marrow::tools
