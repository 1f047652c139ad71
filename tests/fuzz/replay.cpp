#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Tries files once each, without a fuzzer: any compiler will do.  replay FILE...
int main(int count, char** files)
{
    for (int k = 1; k < count; ++k) {
        std::ifstream file(files[k], std::ios::binary);
        if (!file) {
            std::fprintf(stderr, "%s: no file that can be read\n", files[k]);
            return 2;
        }
        const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
        std::fprintf(stderr, "%s\n", files[k]);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    return count > 1 ? 0 : 2;
}
