#include "commands/command.h"
#include "commands/cook_options.h"
#include "commands/watch/watch.h"

namespace marrow::tools {

void add_watch(CLI::App& app, int&) {
  static WatchArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("watch", "Cook as cook does, stay, and cook again what is saved; Ctrl-C ends it");
  add_cook_files(command, a);
  command->add_flag("--poll", a.poll,
                    "look for changes every 250 ms instead of being told by the system, as drives on a network need");
  add_cook_options(command, {}, a.given);
  command->callback([] { run_watch(a); });
}

}  // namespace marrow::tools
