#include "cook/roles/find_pairs.h"

#include <algorithm>
#include <map>
#include <string>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kMirroredPlaces = 0.02;    // of the body's size: how far mirrored places may be off
constexpr std::size_t kMostChildren = 256;  // of a joint of a body

// A name without its side, and which that is.
std::string without_side(const NameWords& words, const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z')
      out += static_cast<char>(c - 'A' + 'a');
    else
      out += c;
  }
  for (const auto& [left, right] : {std::pair{"left", "right"}, {"lft", "rgt"}}) {
    const std::string side = words.side == Side::left ? left : right;
    if (const std::size_t at = out.find(side); at != std::string::npos) return out.replace(at, side.size(), "?");
  }
  const char letter = words.side == Side::left ? 'l' : 'r';
  const auto is_letter = [&](std::size_t i) { return i < out.size() && out[i] >= 'a' && out[i] <= 'z'; };
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool stands_alone = (i == 0 || !is_letter(i - 1)) && !is_letter(i + 1);
    const bool before_capital = i + 1 < name.size() && name[i + 1] >= 'A' && name[i + 1] <= 'Z';
    const bool first = i == 0 || !is_letter(i - 1);
    if (out[i] == letter && (stands_alone || (first && before_capital))) return out.replace(i, 1, "?");
  }
  return out;
}

class PairFinder {
 public:
  explicit PairFinder(const Body& body) : body_(body), other_(body.size(), kNone) {}

  void add_roles() {
    for (std::size_t j = 0; j < body_.size(); ++j)
      if (const Role role = body_.role(static_cast<int>(j)); other_side(role) > role)
        if (const int right = body_.joint_of(other_side(role)); right != kNone) add(static_cast<int>(j), right);
  }

  void add_names() {
    std::map<std::string, std::vector<int>> sides[2];
    for (std::size_t j = 0; j < body_.size(); ++j) {
      const NameWords words = words_of(body_.names[j]);
      if (other_[j] == kNone && words.side != Side::none)
        sides[words.side == Side::left ? 0 : 1][without_side(words, body_.names[j])].push_back(static_cast<int>(j));
    }
    for (const auto& [name, lefts] : sides[0])
      if (const auto rights = sides[1].find(name);
          rights != sides[1].end() && lefts.size() == 1 && rights->second.size() == 1)
        add(lefts[0], rights->second[0]);
  }

  // Once there are some pairs, they say where the middle is.
  void add_places() {
    if (lefts_.empty()) return;
    glm::dvec3 across(0), middle(0);
    for (const int left : lefts_) {
      across += body_.place(left) - body_.place(other_[to_index(left)]);
      middle += 0.5 * (body_.place(left) + body_.place(other_[to_index(left)]));
    }
    const double length = glm::length(across);
    if (!(length > 0)) return;
    across /= length;
    middle /= static_cast<double>(lefts_.size());
    double size = 0;
    for (const glm::dvec3& place : body_.places) size = std::max(size, glm::length(place - middle));
    // Parents come before their children, so a pair of parents is known by then.
    for (std::size_t j = 0; j < body_.size(); ++j) {
      const double aside = glm::dot(body_.places[j] - middle, across);
      if (other_[j] != kNone || body_.role(static_cast<int>(j)) != Role::none || !(aside > kMirroredPlaces * size))
        continue;
      const glm::dvec3 mirrored = body_.places[j] - 2 * aside * across;
      if (const int right = only_at(mirrored, body_.parents[j], kMirroredPlaces * size); right != kNone)
        add(static_cast<int>(j), right);
    }
  }

  std::vector<JointPair> finish() {
    std::ranges::sort(lefts_);
    std::vector<JointPair> out;
    for (const int left : lefts_)
      out.push_back({static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(other_[to_index(left)])});
    return out;
  }

 private:
  void add(int left, int right) {
    other_[to_index(left)] = right;
    other_[to_index(right)] = left;
    lefts_.push_back(left);
  }
  // A joint without a pair at this place, below what mirrors a parent.
  int only_at(const glm::dvec3& place, int parent, double within) const {
    if (parent == kNone) return kNone;
    const int there = other_[to_index(parent)] != kNone ? other_[to_index(parent)] : parent;
    const std::vector<int>& children = body_.children[to_index(there)];
    if (children.size() > kMostChildren) return kNone;
    int found = kNone;
    for (const int j : children) {
      if (other_[to_index(j)] != kNone || body_.role(j) != Role::none) continue;
      if (!(glm::length(body_.place(j) - place) <= within)) continue;
      if (found != kNone) return kNone;
      found = j;
    }
    return found;
  }

  const Body& body_;
  std::vector<int> other_, lefts_;
};

}  // namespace

std::vector<JointPair> find_pairs(const Body& body) {
  PairFinder pairs(body);
  pairs.add_roles();
  pairs.add_names();
  pairs.add_places();
  return pairs.finish();
}

bool sides_are_crossed(const Body& body) {
  const auto across = [&](Role role) {
    const int left = body.joint_of(role), right = body.joint_of(other_side(role));
    return left == kNone || right == kNone ? glm::dvec3(0) : body.place(left) - body.place(right);
  };
  return glm::dot(across(Role::left_upper_leg), across(Role::left_upper_arm)) < 0;
}

}  // namespace marrow::cook
