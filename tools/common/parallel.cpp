#include "common/parallel.h"

#include <utility>

#include "common/failure.h"

namespace marrow::tools {
namespace {

thread_local const Work* work_here = nullptr;

void expect_to_go_on(const Work* work) {
  if (work != nullptr && work->stop != nullptr && *work->stop)
    throw Failure(Exit::interrupted, "", "", "stopped", "the caller asked for it");
}

// As UseWork, of a work that outlives it.
class Share {
 public:
  explicit Share(const Work* work) : before_(std::exchange(work_here, work)) {}
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  ~Share() { work_here = before_; }

 private:
  const Work* before_;
};

}  // namespace

UseWork::UseWork(const Work& work) : work_(work), before_(std::exchange(work_here, &work_)) {}

UseWork::~UseWork() {
  work_here = before_;
}

void expect_to_go_on() {
  expect_to_go_on(work_here);
}

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& f) {
  const Work* const work = work_here;
  const auto one = [&](std::size_t i) {
    const Share share(work);
    expect_to_go_on(work);
    f(i);
  };
  if (work != nullptr && work->threads != nullptr) return work->threads->for_each(count, one);
  for (std::size_t i = 0; i < count; ++i) one(i);
}

}  // namespace marrow::tools
