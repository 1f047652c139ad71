#pragma once

namespace flying {

/// Ask the memory for what will be read soon, so that it is there by then. A hint: no result depends on it.
/// what  any address; nothing is read from it, so that it need not even be valid
inline void fetch(const void* what)
{
    __builtin_prefetch(what);
    // g++ takes a function that only gives hints for one without effect, and drops its calls. This is an effect to it,
    // and no instruction
    asm volatile("");
}

} // namespace flying
