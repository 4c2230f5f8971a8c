// What is asked of MOTN sections beyond their description.
#include "asset/checker.h"
#include "asset/motion_fault.h"
#include "asset/section_views.h"

namespace marrow {

void check(Checker& c, const format::MotionHeader& h) {
  format::MotionLayout l;
  if (!check_fields(c, h, l)) return;
  if (c.follows_its_like() && c.header_before<format::MotionHeader>().clip >= h.clip)
    return static_cast<void>(c.fail(&h, "one section of motion a clip, in their order"));
  const MotionFault fault = find_fault(view_motion(h, c.nth<format::ClipHeader>(format::kClips, h.clip).duration_s));
  if (fault.rule != nullptr) c.fail(fault.where != nullptr ? fault.where : &h, fault.rule);
}

}  // namespace marrow
