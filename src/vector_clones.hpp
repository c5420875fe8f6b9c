#pragma once

/// A function marked with this is compiled for several instruction sets; the widest that the
/// machine has is chosen when the program is loaded. The library is built with -ffp-contract=off,
/// so that every clone rounds alike.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define WRISTWISE_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define WRISTWISE_VECTOR_CLONES
#endif

/// For what is called by such functions, so that it is compiled with them.
#define WRISTWISE_IN_CLONES __attribute__((always_inline)) inline
