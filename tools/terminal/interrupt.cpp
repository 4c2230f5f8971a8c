#include "terminal/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <string_view>
#include <system_error>
#include <thread>

#include "common/failure.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

// No handler: what one may call is too little, and a thread can wait for locks.
void wait_for_interrupt(sigset_t signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
  abandon_unfinished_files();
  const std::string_view text =
      ::isatty(STDERR_FILENO) == 1 ? "\r\033[Kmarrow: interrupted\n" : "marrow: interrupted\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(Exit::interrupted));
}

}  // namespace

void end_cleanly_on_interrupt() {
  struct sigaction now {};
  if (::sigaction(SIGINT, nullptr, &now) != 0 || now.sa_handler == SIG_IGN) return;
  sigset_t signals, before;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  // Threads inherit this.
  if (::pthread_sigmask(SIG_BLOCK, &signals, &before) != 0) return;
  try {
    std::thread(wait_for_interrupt, signals).detach();
  } catch (const std::system_error&) {  // no thread to spare: SIGINT kills, as it did
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
}

}  // namespace marrow::tools
