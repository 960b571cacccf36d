#pragma once

namespace coherency {

/// From now on Ctrl-C and SIGTERM ask the program to end in good order instead of ending it; a second one
/// ends it.
void catchStopSignals();
/// True once such a signal came.
bool stopRequested();

}  // namespace coherency
