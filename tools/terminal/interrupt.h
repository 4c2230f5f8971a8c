// Ctrl-C.
#pragma once

namespace marrow::tools {

// From here on SIGINT ends the process at once, whatever its threads are at: exit code 130, files old or new and whole,
// no temporary ones left. To be called before there is another thread. Does nothing where SIGINT is ignored.
void end_cleanly_on_interrupt();

}  // namespace marrow::tools
