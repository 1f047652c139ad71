#pragma once

namespace flying {

/// Ask the memory for what will be read soon: a hint, on which no result depends. Any address will do.
inline void fetch(const void* what)
{
    __builtin_prefetch(what);
    asm volatile(""); // no instruction; but without it g++ drops calls of functions that do no more than give hints
}

} // namespace flying
