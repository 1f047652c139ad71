// What was found to break the simulator so far, each with a test of its own: the names of the files in tests/regressions.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

int main()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(FLYING_FINDINGS)) {
        if (entry.path().extension() != ".cpp") continue;
        std::string name = entry.path().stem().string();
        std::replace(name.begin(), name.end(), '_', ' ');
        names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) std::printf("- %s\n", name.c_str());
    std::printf("\nfindings = %zu\n", names.size());
    return names.empty() ? 1 : 0;
}
