#include "compare/page.h"

#include <fmt/format.h>

namespace marrow::tools {
namespace {

struct MotionColumn {
  const char* heading;
  int decimals;
  std::optional<double> (*value)(const MotionRow& row);
};
constexpr MotionColumn kMotionColumns[] = {
    {"poses worse than SSD", 0, [](const MotionRow& r) { return std::optional(static_cast<double>(r.worse)); }},
    {"the same, of those that fold", 0,
     [](const MotionRow& r) { return std::optional(static_cast<double>(r.worse_folding)); }},
    {"RMS of SSD's", 3, [](const MotionRow& r) { return std::optional(r.of_ssd); }},
    {"in the worst pose", 2, [](const MotionRow& r) { return std::optional(r.worst_of_ssd); }},
    {"ring radius, twisted", 2, [](const MotionRow& r) { return r.ring_over_bind; }},
    {"of the truth's", 2, [](const MotionRow& r) { return r.ring_over_truth; }},
    {"volume of the truth's", 2, [](const MotionRow& r) { return r.volume_over_truth; }},
    {"flipped triangles", 0, [](const MotionRow& r) { return std::optional(static_cast<double>(r.flipped)); }},
};

std::string head(const std::string& first, bool with_poses) {
  std::string out = fmt::format("<div class=\"wide\"><table><thead><tr><th>{}</th>", first);
  if (with_poses) out += "<th>poses</th><th>that fold</th>";
  for (const MotionColumn& column : kMotionColumns) out += fmt::format("<th>{}</th>", column.heading);
  return out + "</tr></thead>\n<tbody>\n";
}

std::string cell(std::size_t count) {
  return fmt::format("<td data-value=\"{0}\">{0}</td>", count);
}

std::string cells(const MotionRow& row) {
  std::string out;
  for (const MotionColumn& column : kMotionColumns) {
    const std::optional<double> value = column.value(row);
    out += value ? fmt::format("<td data-value=\"{:.9g}\">{:.{}f}</td>", *value, *value, column.decimals)
                 : std::string("<td data-value=\"\">–</td>");
  }
  return out + "</tr>\n";
}

std::string name_cell(const std::string& name) {
  return fmt::format("<tr><td data-value=\"{0}\">{0}</td>", html_text(name));
}

constexpr const char* kEnd = "</tbody></table></div>\n";

std::string of_joints(const Study& study, const MotionStudy& motion, const std::string& deformer, std::size_t d) {
  std::string out =
      fmt::format("<details><summary>{}, joint by joint</summary>{}", html_text(deformer), head("joint", true));
  for (const MotionJoint& joint : motion.joints)
    out += name_cell(study.joint_names[joint.joint]) + cell(joint.poses) + cell(joint.folding) + cells(joint.of[d]);
  return out + kEnd + "</details>\n";
}

std::string folding(const Study& study, const MotionStudy& motion) {
  if (motion.folding.empty()) return "";
  std::string out = fmt::format(
      "<details><summary>{} poses in which the truth folds</summary><div class=\"wide\"><table><thead><tr>"
      "<th>pose</th><th>flipped triangles of the truth</th></tr></thead>\n<tbody>\n",
      motion.folding.size());
  for (const std::size_t i : motion.folding)
    out += name_cell(title_of(study, study.motion.poses[i])) + cell(motion.errors[i].truth_flipped) + "</tr>\n";
  return out + kEnd + "</details>\n";
}

}  // namespace

std::string motion_tables(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion) {
  std::string out;
  if (motion.joints.empty()) return out;
  out += fmt::format("<p>{}</p>\n", html_text(summary(comparison, motion))) + head("deformer", false);
  for (std::size_t d = 0; d < motion.of.size(); ++d)
    out += name_cell(comparison.rows[d].deformer) + cells(motion.of[d]);
  out += kEnd;
  out += fmt::format(
      "<p class=\"note\">One joint at a time is turned from the bind pose, {} joints in {} poses: twisted about its "
      "bone to 170° and bent across it to 130°, each way, within its limits. Poses in which the truth itself folds, "
      "with triangles that face inwards, are counted apart; ring radii are of all. Ring radius: how far the surface "
      "round the joint is from "
      "its bone in a twist, over the bind pose's, where it is narrowest; 0 is a wrung towel. Volume: of the surface "
      "round the joint, where it is farthest from the truth's. Flipped triangles: the most in a pose.</p>\n",
      motion.joints.size(), motion.poses);
  for (std::size_t d = 0; d < motion.of.size(); ++d) out += of_joints(study, motion, comparison.rows[d].deformer, d);
  out += folding(study, motion);
  for (const std::string& line : study.left_out_of_motion)
    out += fmt::format("<p class=\"note\">Left out: {}</p>\n", html_text(line));
  return out;
}

}  // namespace marrow::tools
