// pmr: the Particle Mix Reactor. The command line in, an exit status out:
// 0 done, 2 the user's input is wrong, 3 the simulation failed, 130 interrupted.
#include "cli/console.hpp"

int main(int argc, char** argv) { return pmr::cli::console(argc, argv); }
