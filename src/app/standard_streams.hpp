#pragma once

namespace drape::app {

/// Opens those of standard input, output and error that the caller closed. Otherwise the next file that the program
/// opens would take their place and receive text for the terminal. Writing to a standard output that was closed still
/// fails, so that `flushStandardOutput` can report it.
void occupyStandardStreams();

/// Flushes standard output. Throws InputError when the output could not be written completely: the device is full, or
/// standard output was closed.
void flushStandardOutput();

}  // namespace drape::app
