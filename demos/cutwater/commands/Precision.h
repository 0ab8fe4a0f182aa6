#pragma once

namespace cutwater::command {

/// Both precisions of Bullet define the same symbols, so each is in a binary of its own: `cutwater`
/// (double) and, beside it, `cutwater-float32`. main() states its arguments once.
void rememberArguments(char** argv);

/// Continues in the other binary with the same arguments if this one has the wrong precision.
/// @throws HydroError FileNotReadable if the other binary is not there.
void usePrecision(bool doublePrecision);

}  // namespace cutwater::command
