// Signals as a wish to stop: Ctrl-C, SIGTERM, SIGHUP (the terminal went), SIGUSR1 (Slurm's
// --signal), SIGPIPE (who read the output went).
#pragma once
#include "pmr/base/stop.hpp"

namespace pmr::cli {

// From now on these signals end the process at once with status 130, for whatever stands on the
// disk is whole, unless an AtStake lives. A broken pipe alone ends nothing. Signals that the caller
// has set to be ignored (nohup) stay ignored. A file that grows beyond `ulimit -f` is an error of
// the disk and no longer the end of the process.
void end_on_signals();

// There is something to be saved: signals are a wish, for as long as this value lives. Only a
// second Ctrl-C ends the process.
class AtStake {
 public:
  AtStake();
  ~AtStake();
  AtStake(const AtStake&) = delete;
  AtStake& operator=(const AtStake&) = delete;
  StopToken token() const;
};

}  // namespace pmr::cli
