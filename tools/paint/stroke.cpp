#include "paint/stroke.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "deform/weights/auto_weights.h"
#include "deform/weights/edit_weights.h"

namespace marrow::tools {
namespace {

constexpr double kLeast = 1e-3;  // what a joint that moves a vertex weighs, at least

}  // namespace

Stroke::Stroke(Canvas& canvas, const Brush& brush, std::uint32_t skeleton, std::uint32_t joint, std::uint32_t mirrored,
               std::span<const std::uint32_t> mirror)
    : canvas_(canvas),
      brush_(brush),
      skeleton_(skeleton),
      joint_(joint),
      mirrored_(mirrored),
      mirror_(mirror),
      own_(canvas.bind.size(), 0),
      image_(canvas.bind.size(), 0),
      changed_(canvas.bind.size(), 0),
      where_(canvas.bind.size(), 0) {}

bool Stroke::may_paint(std::uint32_t place, std::uint32_t joint) const {
  const CanvasGroup& group = canvas_.groups[canvas_.group_of[place]];
  return group.skeleton == skeleton_ && !group.hangs && group.may_follow(joint);
}

// Places, and how much of the brush they feel.
std::vector<std::pair<std::uint32_t, double>> Stroke::reached(std::span<const glm::vec3> posed, const SurfaceHit& hit) {
  std::vector<std::pair<std::uint32_t, double>> out;
  const auto amount = [&](std::uint32_t p) {
    return falloff(static_cast<double>(glm::distance(posed[p], hit.place)), static_cast<double>(brush_.radius));
  };
  if (brush_.through) {
    for (std::uint32_t p = 0; p < posed.size(); ++p)
      if (amount(p) > 0) out.emplace_back(p, amount(p));
    return out;
  }
  std::vector<char> seen(posed.size(), 0);
  const auto visit = [&](std::uint32_t p) {
    if (seen[p] != 0) return;
    seen[p] = 1;
    if (amount(p) > 0) out.emplace_back(p, amount(p));
  };
  for (std::size_t c = 0; c < 3; ++c) visit(canvas_.corners[3 * std::size_t{hit.triangle} + c]);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (const std::uint32_t p : canvas_.neighbours(out[i].first)) visit(p);
  return out;
}

std::vector<Stroke::Touch> Stroke::touches(std::span<const glm::vec3> posed, const SurfaceHit& hit) {
  std::vector<double> now(posed.size(), 0);
  for (const auto& [place, amount] : reached(posed, hit)) now[place] = amount;
  std::vector<Touch> out;
  for (std::uint32_t p = 0; p < posed.size(); ++p) {
    const bool has_image = !mirror_.empty() && mirror_[p] != kNoPlace;
    const double own = may_paint(p, joint_) ? now[p] : 0;
    const double image = has_image && may_paint(p, mirrored_) ? now[mirror_[p]] : 0;
    if (own > 0 || image > 0) out.push_back({p, own, image});
  }
  return out;
}

// All joints, so that what leaves one arrives at those that the neighbours follow.
Influences Stroke::smoothed(std::uint32_t place, double amount) const {
  const std::span<const std::uint32_t> around = canvas_.neighbours(place);
  if (around.empty()) return canvas_.influences[place];
  Influences out;
  const auto add = [&](const Influences& from, double share) {
    for (const deform::Influence& i : from) {
      const auto same = std::ranges::find(out, i.joint, &deform::Influence::joint);
      if (same == out.end()) {
        out.push_back({i.joint, share * i.weight});
      } else {
        same->weight += share * i.weight;
      }
    }
  };
  const double step = amount * static_cast<double>(brush_.strength);
  add(canvas_.influences[place], 1 - step);
  for (const std::uint32_t p : around) add(canvas_.influences[p], step / static_cast<double>(around.size()));
  deform::keep_largest(out, kMaxInfluences, kLeast);
  return out;
}

double Stroke::target(std::uint32_t joint, double amount, const Influences& before) const {
  const double out = painted_weight(brush_, weight_of(before, joint), amount);
  return out < kLeast ? 0 : out;
}

Influences Stroke::painted(const Touch& touch, const Influences& before) {
  std::vector<deform::Influence> given;
  const double own = joint_ == mirrored_ ? std::max(touch.own, touch.image) : touch.own;
  if (own > 0) given.push_back({joint_, target(joint_, own, before)});
  if (joint_ != mirrored_ && touch.image > 0) given.push_back({mirrored_, target(mirrored_, touch.image, before)});
  double sum = 0, others = 1;
  for (const deform::Influence& g : given) {
    sum += g.weight;
    others -= weight_of(before, g.joint);
  }
  Influences out = before;
  deform::set_weights(given, kMaxInfluences, out);
  const bool keeps = others < 1e-9 && sum < 1 - 1e-9;
  const auto at = std::ranges::lower_bound(kept_, touch.place);
  const bool known = at != kept_.end() && *at == touch.place;
  if (keeps && !known) kept_.insert(at, touch.place);
  return out;
}

void Stroke::dab(std::span<const glm::vec3> posed, const SurfaceHit& hit) {
  const std::vector<Touch> now = touches(posed, hit);
  std::vector<Influences> results;
  for (const Touch& touch : now) {
    const std::uint32_t p = touch.place;
    if (changed_[p] == 0) {
      where_[p] = static_cast<std::uint32_t>(edit_.size());
      edit_.push_back({p, canvas_.touched[p] != 0, canvas_.influences[p], {}});
      changed_[p] = 1;
    }
    own_[p] = std::max(own_[p], touch.own);
    image_[p] = std::max(image_[p], touch.image);
    results.push_back(brush_.mode == BrushMode::smooth ? smoothed(p, std::max(touch.own, touch.image))
                                                       : painted({p, own_[p], image_[p]}, edit_[where_[p]].before));
  }
  for (std::size_t i = 0; i < now.size(); ++i) canvas_.influences[now[i].place] = std::move(results[i]);
}

Edit Stroke::edit() const {
  Edit out;
  const auto same = [](const deform::Influence& a, const deform::Influence& b) {
    return a.joint == b.joint && a.weight == b.weight;
  };
  for (const Change& change : edit_) {
    const Influences& after = canvas_.influences[change.place];
    if (std::ranges::equal(change.before, after, same)) continue;
    out.push_back(change);
    out.back().after = after;
  }
  return out;
}

void redo(Canvas& canvas, const Edit& edit) {
  for (const Change& change : edit) {
    canvas.influences[change.place] = change.after;
    canvas.touched[change.place] = 1;
  }
}

void undo(Canvas& canvas, const Edit& edit) {
  for (const Change& change : edit) {
    canvas.influences[change.place] = change.before;
    canvas.touched[change.place] = change.was_touched ? 1 : 0;
  }
}

double falloff(double distance, double radius) {
  if (!(radius > 0) || !(distance < radius)) return 0;
  const double share = distance / radius, inside = 1 - share * share;
  return inside * inside;
}

double painted_weight(const Brush& brush, double before, double amount) {
  const double strength = static_cast<double>(brush.strength);
  switch (brush.mode) {
    case BrushMode::add:
      return std::min(1.0, before + amount * strength);
    case BrushMode::subtract:
      return std::max(0.0, before - amount * strength);
    case BrushMode::set:
      return before + amount * (strength - before);
    case BrushMode::smooth:
      break;
  }
  return before;
}

}  // namespace marrow::tools
