#include "ik/system.h"

#include "ik/dense.h"
#include "marrow/block.h"

namespace marrow {
namespace {

constexpr float kLongestTurn = 2;     // radians of an error that one step is to mend at most
constexpr float kLeastPivot = 1e-5f;  // as a share of the mean of J Jᵀ's diagonal; rounding leaves less of a zero

std::size_t tasks_of(const IkGoal& goal) {
  return (goal.position_weight > 0 ? 1u : 0u) + (goal.rotation_weight > 0 ? 1u : 0u);
}

void add_task(const IkNode& tip, bool turn, float weight, IkEntry*& entries, IkSystem& s) {
  const IkTree& tree = *s.tree;
  const bool travels = s.travel_ease > 0;
  std::uint32_t length = 0;
  float bones = 0;  // their length from the tip to the top
  f32x4 from = tip.frame.origin;
  for (std::uint16_t n = tip.parent; n != kNoJoint; n = tree.nodes[n].parent) {
    const f32x4 to = tree.nodes[n].frame.origin;
    bones += sqrt(dot3(from - to, from - to));
    from = to;
    length += n == 0 && travels ? 2 : 1;
  }
  s.tasks.data[s.tasks.size++] = {&tip, entries, length, turn, weight, weight * (turn ? kLongestTurn : bones), 0, 1};
  IkEntry* entry = entries + length;
  for (std::uint16_t n = tip.parent; n != kNoJoint; n = tree.nodes[n].parent) (--entry)->node = n;
  if (entry != entries) entries->node = static_cast<std::uint16_t>(tree.nodes.size);
  entries += length;
}

// How far the root travels, in metres of its parent's space, as easily as a joint turns by a radian. 0: not at all.
float travel_ease(const IkTree& tree, float root_travel_m) {
  if (!(root_travel_m > 0) || tree.nodes[0].place != 0) return 0;
  const f32x4(&axis)[3] = tree.nodes[0].above.axis;
  const f32x4 squares = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  const float scale = sqrt(dot3(squares, splat(1.0f / 3)));
  return scale > 1e-15f ? root_travel_m / scale : 0;
}

void set_entries(const IkSystem& s, const IkTask& task) {
  const IkTree& tree = *s.tree;
  f32x4 point = task.tip->above.origin;
  IkEntry* entry = task.path + task.length;
  for (std::uint16_t n = task.tip->parent; n != kNoJoint;) {
    const IkNode& node = tree.nodes[n];
    const f32x4 factor = splat(task.weight * node.ease_root);
    --entry;
    if (task.turn) {
      set_axes(node.turned, entry->column);
      for (f32x4& c : entry->column) c = c * factor;
    } else {  // axis × point, taken to model space
      const f32x4 at = point * factor;
      const f32x4 x = splat_lane<0>(at), y = splat_lane<1>(at), z = splat_lane<2>(at);
      const f32x4(&axis)[3] = node.frame.axis;
      entry->column[0] = axis[2] * y - axis[1] * z;
      entry->column[1] = axis[0] * z - axis[2] * x;
      entry->column[2] = axis[1] * x - axis[0] * y;
      point = transform(node.parent_from_frame, point);
    }
    if (squared3(node.hinge) > 0) {
      const f32x4 about = times(*entry, node.hinge);
      entry->column[0] = about * splat_lane<0>(node.hinge);
      entry->column[1] = about * splat_lane<1>(node.hinge);
      entry->column[2] = about * splat_lane<2>(node.hinge);
    }
    n = node.parent;
  }
  if (entry == task.path) return;
  const f32x4 factor = splat(task.turn ? 0.0f : task.weight * s.travel_ease);
  for (int i = 0; i < 3; ++i) task.path->column[i] = tree.nodes[0].above.axis[i] * factor;
}

// Adds to `sum` what rows `first` … `end` - 1 still lack, damped, and keeps the rows before them as they are.
void solve_level(IkSystem& s, std::size_t first, std::size_t end, float damping, float least) {
  const std::size_t from = dense_stride(s.rows), to = dense_stride(end);
  for (std::size_t i = 0; i < end; ++i) {
    const float* const row = s.a + i * from;
    float* const out = s.work + i * to;
    for (std::size_t j = i / 4 * 4; j < to; j += 4) store(out + j, load(row + j));
    out[i] += i < first ? least : damping;
    out[end] = 0;
  }
  for (std::size_t i = first; i < end; ++i) {
    float lacks = s.rest[i];
    for (std::size_t j = 0; j < first; ++j) lacks -= s.a[j * from + i] * s.sum[j];
    s.work[i * to + end] = lacks;
  }
  solve_dense(s.work, end, least, s.x);
  for (std::size_t i = 0; i < end; ++i) s.sum[i] += s.x[i];
}

}  // namespace

IkSystem place_system(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch) {
  std::size_t entries = 0, tasks = 0;
  for (const IkGoal& goal : problem.goals) {
    std::size_t depth = 1;  // the travel
    for (std::uint16_t j = goal.joint; j < skeleton.joint_count; j = skeleton.parents[j]) ++depth;
    entries += tasks_of(goal) * depth;
    tasks += tasks_of(goal);
  }
  IkSystem s = {};
  s.rows = 3 * tasks;
  const std::size_t stride = dense_stride(s.rows), moves = (problem.joints.size + 1 + 3) / 4 * 4;
  s.tasks.data = scratch.take<IkTask>(tasks).data;
  s.entries = scratch.take<IkEntry>(entries).data;
  s.moves = {scratch.take<IkMove>(moves).data, moves};
  s.error = scratch.take<float>((4 + 2 * std::uint64_t{s.rows}) * stride).data;
  if (s.error == nullptr) return s;
  s.rest = s.error + stride;
  s.x = s.rest + stride;
  s.sum = s.x + stride;
  s.a = s.sum + stride;
  s.work = s.a + s.rows * stride;
  return s;
}

void count_jacobian(const Skeleton& skeleton, const IkProblem& problem, Memory& count) {
  place_system(skeleton, problem, count);
}

void set_tasks(IkTree& tree, const IkProblem& problem, IkSystem& s) {
  s.tree = &tree;
  s.travel_ease = travel_ease(tree, problem.root_travel_m);
  IkEntry* entries = s.entries;
  for (int priority = 0, next = 0; next < 256; priority = next) {
    next = 256;
    for (const IkNode& tip : tree.tips) {
      const IkGoal& goal = *tip.goal;
      if (goal.priority > priority && goal.priority < next) next = goal.priority;
      if (goal.priority != priority) continue;
      if (goal.position_weight > 0) add_task(tip, false, goal.position_weight, entries, s);
      if (goal.rotation_weight > 0) add_task(tip, true, goal.rotation_weight, entries, s);
    }
  }
  for (std::size_t i = 0; i < s.rows * dense_stride(s.rows); ++i) s.a[i] = 0;
  for (IkMove& move : s.moves) move = IkMove{};
}

float set_errors(IkSystem& s) {
  float total = 0, *to = s.error;
  for (IkTask& task : s.tasks) {
    f32x4 e = task.turn ? rotation_error(*task.tip) : position_error(*task.tip);
    e = e * task.weight;
    const float squared = squared3(e), l = sqrt(squared);
    total += squared;
    task.cut = l > task.longest && task.longest > 0 ? l / task.longest : 1.0f;
    if (l > task.longest) e = e * (task.longest / l);
    task.size =
        length3(e) * (task.turn ? length3(e) : task.longest);  // the curvature of a turn's error grows with its size
    store(to, e);                                              // lane w falls on the next task's row, or on padding
    to += 3;
  }
  return sqrt(total);
}

void set_entries(IkSystem& s) {
  for (const IkTask& task : s.tasks) set_entries(s, task);
}

void set_products(IkSystem& s) {
  const std::size_t stride = dense_stride(s.rows);
  for (std::size_t i = 0; i < s.tasks.size; ++i) {
    const IkTask& a = s.tasks[i];
    for (std::size_t j = i; j < s.tasks.size; ++j) {
      const IkTask& b = s.tasks[j];
      const std::uint32_t most = a.length < b.length ? a.length : b.length;
      f32x4 row0 = splat(0.0f), row1 = row0, row2 = row0;
      for (std::uint32_t k = 0; k < most && a.path[k].node == b.path[k].node; ++k) {
        for (int c = 0; c < 3; ++c) {
          const f32x4 left = a.path[k].column[c], right = b.path[k].column[c];
          row0 = row0 + splat_lane<0>(left) * right;
          row1 = row1 + splat_lane<1>(left) * right;
          row2 = row2 + splat_lane<2>(left) * right;
        }
      }
      float* const to = s.a + 3 * i * stride + 3 * j;
      store(to, row0);  // lane w is 0 and falls on the next block, which comes later
      store(to + stride, row1);
      store(to + 2 * stride, row2);
    }
  }
}

void solve_rows(IkSystem& s, float error_share, float size_share) {
  const std::size_t stride = dense_stride(s.rows);
  float trace = 0;
  for (std::size_t i = 0; i < s.rows; ++i) trace += s.a[i * stride + i];
  for (std::size_t i = 0; i < stride; ++i) s.sum[i] = 0;
  const float mean = trace / static_cast<float>(s.rows), least = mean * kLeastPivot + 1e-30f;
  const float size = mean * size_share + least;
  for (std::size_t first = 0, task = 0; task < s.tasks.size; first = 3 * task) {
    const int priority = s.tasks[task].tip->goal->priority;
    float damping = size;
    for (; task < s.tasks.size && s.tasks[task].tip->goal->priority == priority; ++task)
      damping += s.tasks[task].size * error_share;
    solve_level(s, first, 3 * task, damping, least);
  }
}

void set_answers(IkSystem& s) {
  for (IkMove& move : s.moves) move.answer = splat(0.0f);
  const float* x = s.sum;
  for (const IkTask& task : s.tasks) {
    const f32x4 v = load(x);
    for (std::uint32_t i = 0; i < task.length; ++i) {
      f32x4& answer = s.moves[task.path[i].node].answer;
      answer = answer + products(task.path[i].column, v);
    }
    x += 3;
  }
}

f32x4 times(const IkEntry& entry, f32x4 v) {
  return entry.column[0] * splat_lane<0>(v) + entry.column[1] * splat_lane<1>(v) + entry.column[2] * splat_lane<2>(v);
}

f32x4 effect(const IkTask& task, Span<const IkMove> moves, f32x4 IkMove::*part) {
  f32x4 sum = splat(0.0f);
  for (std::uint32_t i = 0; i < task.length; ++i) sum = sum + times(task.path[i], moves[task.path[i].node].*part);
  return sum;
}

}  // namespace marrow
