#pragma once

// CUTWATER_VECTOR before a function: it is compiled three times, for any x86-64, for one with AVX2
// and FMA (x86-64-v3) and for one with AVX-512 (x86-64-v4: twice the registers), and the program
// takes what the machine has when it starts. What such a function calls in its loops must be
// inlined into it (CUTWATER_INLINE), or it is the common code. Results differ between them in the
// last bits, as FMA rounds once; not between runs or threads.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CUTWATER_VECTOR \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CUTWATER_VECTOR
#endif
#define CUTWATER_INLINE inline __attribute__((always_inline))
// The same for a lambda: [](double x) CUTWATER_INLINED { ... }
#define CUTWATER_INLINED __attribute__((always_inline))

namespace cutwater {

/// Four numbers in one register where the machine has AVX, in two where not. Structs of them that
/// go through memory from one function to another say alignas(32): without AVX the compiler takes
/// 16.
using Double4 = double __attribute__((vector_size(32)));

}  // namespace cutwater
