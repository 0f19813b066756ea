#pragma once

namespace drape {

/// Opens what the caller closed of standard input, output and error. Otherwise the next file that the program opens
/// would take its place, and text for the terminal would end up in that file. Writing to a standard output that was
/// closed still fails, so that `flushStandardOutput` can tell.
void occupyStandardStreams();

/// Writes out what standard output still holds. Throws InputError when not everything that the program printed could be
/// written, since the device is full or standard output was closed.
void flushStandardOutput();

}  // namespace drape
