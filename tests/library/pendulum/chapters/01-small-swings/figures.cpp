#include <fstream>
#include <string>

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    std::ofstream svg(std::string(argv[1]) + "/string.svg");
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 160\" width=\"300\"><path d=\"M150,10 L180,130\" "
           "stroke=\"#333\"/><circle cx=\"180\" cy=\"130\" r=\"9\" fill=\"#1f6fb4\"/></svg>\n";
}
