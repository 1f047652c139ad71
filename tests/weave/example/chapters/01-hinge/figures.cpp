#include <fstream>
#include <string>

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    std::ofstream svg(std::string(argv[1]) + "/rod.svg");
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 60\" width=\"300\"><rect x=\"20\" y=\"26\" "
           "width=\"260\" height=\"8\" fill=\"#1f6fb4\"/><circle cx=\"20\" cy=\"30\" r=\"7\" fill=\"#333\"/></svg>\n";
}
