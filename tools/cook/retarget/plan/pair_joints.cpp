#include "cook/retarget/plan/pair_joints.h"

#include <cctype>
#include <map>

#include "cook/scene/raw.h"

namespace marrow::cook {
namespace {

std::string loose(const std::string& name) {
  std::string out;
  const std::size_t colon = name.rfind(':');
  for (std::size_t i = colon == std::string::npos ? 0 : colon + 1; i < name.size(); ++i) {
    const char c = name[i];
    if (c == ' ' || c == '_' || c == '.') continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::string exact(const std::string& name) {
  return name;
}

constexpr int kSeveral = -2;

template <class Key>
std::map<std::string, int> by_key(const std::vector<std::string>& names, const std::vector<int>& partner, Key key) {
  std::map<std::string, int> out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (partner[i] != kNone) continue;
    const auto [at, is_new] = out.try_emplace(key(names[i]), static_cast<int>(i));
    if (!is_new) at->second = kSeveral;
  }
  out.erase("");
  return out;
}

}  // namespace

std::vector<int> pair_joints(const std::vector<std::string>& joints, const std::vector<std::string>& others) {
  std::vector<int> other_of(joints.size(), kNone), joint_of(others.size(), kNone);
  for (const auto key : {exact, loose}) {
    const std::map<std::string, int> right = by_key(others, joint_of, key);
    for (const auto& [name, joint] : by_key(joints, other_of, key)) {
      const auto found = right.find(name);
      if (joint == kSeveral || found == right.end() || found->second == kSeveral) continue;
      other_of[static_cast<std::size_t>(joint)] = found->second;
      joint_of[static_cast<std::size_t>(found->second)] = joint;
    }
  }
  return other_of;
}

}  // namespace marrow::cook
