#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace flying::fuzz {

/// Ends the program where a promise is broken, and says which: the fuzzer then keeps the input.
inline void promise(bool kept, const char* what, const std::string& found = {})
{
    if (kept) return;
    std::fprintf(stderr, "a broken promise: %s%s%s\n", what, found.empty() ? "" : "; found ", found.c_str());
    std::abort();
}

} // namespace flying::fuzz
