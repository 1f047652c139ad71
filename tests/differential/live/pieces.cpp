#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "live/pieces.hpp"

// What a page asks, asked natively. Reads a question a line, `NAME number number ...`, and prints the hash of the answer,
// or `none`.
int main()
{
    std::string line;
    while (std::getline(std::cin, line)) {
        std::istringstream words(line);
        std::string name;
        std::string word;
        std::vector<double> numbers;
        words >> name;
        while (words >> word) numbers.push_back(std::stod(word));
        const auto answer = flying::live::answer_of(name, numbers);
        if (answer) std::printf("%016llx\n", static_cast<unsigned long long>(answer->hash()));
        else std::printf("none\n");
    }
}
