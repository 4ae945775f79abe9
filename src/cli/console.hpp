// The command line: one verb, its options, one exit status.
#pragma once

namespace pmr::cli {

enum ExitStatus { done = 0, wrong_input = 2, failed = 3, interrupted = 130 };

int console(int argc, char** argv);

}  // namespace pmr::cli
