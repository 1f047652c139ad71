#include "house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

using house::Source;

namespace {

const std::filesystem::path k_root = FLYING_SOURCE_DIR;

// Paths and texts
using Files = std::vector<std::pair<std::string, std::string>>;

// A small tree of files in a temporary folder, gone with the object
class Tree
{
public:
    explicit Tree(const Files& files)
        : root_(std::filesystem::temp_directory_path() / ("house-" + std::to_string(getpid())))
    {
        std::filesystem::remove_all(root_);
        std::filesystem::create_directories(root_);
        for (const auto& [path, text] : files) {
            std::filesystem::create_directories((root_ / path).parent_path());
            std::ofstream(root_ / path) << text;
        }
    }
    ~Tree() { std::filesystem::remove_all(root_); }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    [[nodiscard]] const std::filesystem::path& root() const { return root_; }
    [[nodiscard]] std::vector<Source> sources() const { return house::read_sources(root_, "src"); }
    [[nodiscard]] house::Book book() const { return house::read_book(root_ / "chapters/book.toml"); }

private:
    std::filesystem::path root_;
};

using Faults = std::vector<std::string>;

void check_none(const Faults& faults)
{
    for (const std::string& fault : faults) FAIL_CHECK(fault);
}

std::vector<Source> engine_and_outer()
{
    return house::read_sources(k_root, "src");
}

} // namespace

TEST_CASE("the house has sources to read")
{
    CHECK(engine_and_outer().size() > 20);
}

// ---- Arrows
// -----------------------------------------------------------------------------------------------------------

TEST_CASE("modules include along the arrows of the design only")
{
    check_none(house::arrow_faults(engine_and_outer()));
}

TEST_CASE("an include against the arrows is found, one along them is not")
{
    const Tree tree(Files{{"src/math/vec2.hpp", "#pragma once\n#include <Eigen/Core>\n"},
                          {"src/motion/body.hpp", "#include \"math/vec2.hpp\"\n#include \"geometry/disc.hpp\"\n"},
                          {"src/events/queue.cpp", "#include \"math/vec2.hpp\"\n#include \"rest/solver.hpp\"\n"},
                          {"src/app/main.cpp", "#include \"math/vec2.hpp\"\n"},
                          {"src/weave/main.cpp", "#include \"math/vec2.hpp\"\n"}});
    CHECK(house::arrow_faults(tree.sources()) == Faults{"src/events/queue.cpp:2: no arrow leads from events to rest",
                                                        "src/motion/body.hpp:2: no arrow leads from motion to geometry",
                                                        "src/weave/main.cpp:1: no arrow leads from weave to math"});
}

TEST_CASE("an include that names no module, and a folder that is no module, are found")
{
    const Tree tree(
        Files{{"src/math/vec2.cpp", "#include \"vec2.hpp\"\n"}, {"src/tools/a.hpp", ""}, {"src/loose.cpp", ""}});
    CHECK(house::arrow_faults(tree.sources()) ==
          Faults{"src/loose.cpp: belongs to no module of the design",
                 "src/math/vec2.cpp:1: \"vec2.hpp\" is not written module/file.hpp",
                 "src/tools/a.hpp: belongs to no module of the design"});
}

TEST_CASE("an include in a comment is none")
{
    const Tree tree(
        Files{{"src/math/a.hpp", "// #include \"world/world.hpp\"\n/*\n#include \"draw/paint.hpp\"\n*/\n"}});
    check_none(house::arrow_faults(tree.sources()));
}

// ---- Headers and words of the engine
// ----------------------------------------------------------------------------------

TEST_CASE("the engine includes Eigen and harmless standard headers only")
{
    check_none(house::header_faults(engine_and_outer()));
}

TEST_CASE("a header that prints, draws, waits or draws lots is found in the engine, and left alone outside it")
{
    for (const std::string header : {"iostream", "fstream", "cstdio", "chrono", "ctime", "thread", "mutex", "random",
                                     "format", "source_location", "stdexcept", "cairo.h", "unordered_map"}) {
        CAPTURE(header);
        const Tree tree(
            Files{{"src/toi/a.cpp", "#include <vector>\n#include <Eigen/Core>\n#include <" + header + ">\n"},
                  {"src/draw/a.cpp", "#include <" + header + ">\n"}});
        CHECK(house::header_faults(tree.sources()) ==
              Faults{"src/toi/a.cpp:3: the engine does without <" + header + ">"});
    }
}

TEST_CASE("the engine neither throws, prints, waits nor calls functions whose bits differ between platforms")
{
    check_none(house::word_faults(engine_and_outer()));
}

TEST_CASE("a forbidden word is found in the engine, and left alone outside it")
{
    for (const std::string code :
         {"throw 1;", "try {", "} catch (...) {", "x = std::sin(y);", "x = cos (y);", "x = std::pow(y, 2);",
          "x = std::atan2(y, z);", "auto t = std::chrono::now();", "std::cout << x;", "printf(x);", "std::thread t;",
          "std::mt19937 g;", "thread_local int i;", "s = std::format(x);", "long n = 0;", "std::ranges::sort(v);", "Eigen::Rotation2D<double> r;"}) {
        CAPTURE(code);
        const Tree tree(Files{{"src/math/a.cpp", "int a;\n" + code + "\n"}, {"src/app/a.cpp", code + "\n"}});
        const Faults faults = house::word_faults(tree.sources());
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].starts_with("src/math/a.cpp:2: the engine does without '"));
    }
}

TEST_CASE("words in comments and literals, variables and members are left alone")
{
    const Tree tree(
        Files{{"src/math/a.cpp", "// we try to throw std::sin(x)\n"
                                 "/* catch\n throw */ const char* s = \"throw \\\" try\";\n"
                                 "double cos = r.sin() + p->log(2) + 1'000.0; char c = '\"';\n"
                                 "const char* raw = R\"x(throw \" try)x\"; double sine = std::sqrt(cos);\n"}});
    check_none(house::word_faults(tree.sources()));
}

// ---- Length
// -----------------------------------------------------------------------------------------------------------

TEST_CASE("no file is longer than 500 lines")
{
    for (const std::string folder : {"src", "chapters", "tests"})
        check_none(house::length_faults(house::read_sources(k_root, folder), 500));
}

TEST_CASE("a file of 501 lines is found, one of 500 is not")
{
    std::string text;
    for (int i = 0; i < 500; ++i) text += "\n";
    const Tree tree(Files{{"src/math/a.hpp", text}, {"src/math/b.hpp", text + "\n"}});
    CHECK(house::length_faults(tree.sources(), 500) == Faults{"src/math/b.hpp: 501 lines, at most 500"});
}

// ---- Size of classes
// ---------------------------------------------------------------------------------------------------

TEST_CASE("no class has over 25 private functions or 20 members")
{
    check_none(house::class_faults(engine_and_outer(), 25, 20));
}

TEST_CASE("a class with a private function or a member too many is found, whatever else it holds")
{
    const Tree tree(
        Files{{"src/math/a.hpp", "struct Plain\n{\n    int a = 0;\n    int b[2] = {1, 2};\n    std::vector<int(*)(int)> c;\n};\n"
                                 "class Busy\n{\npublic:\n    Busy() : a_(1) {}\n    void go();\n    void stop();\n\n"
                                 "private:\n    using Numbers = std::vector<int>;\n    enum class Kind { one, two };\n"
                                 "    struct Inner\n    {\n        int x = 0;\n        int y = 0;\n    };\n"
                                 "    [[nodiscard]] int one(int a = f(2)) const { int b = 2; return a; }\n"
                                 "    template <typename T>\n    void two();\n    static constexpr double k = 2.0;\n"
                                 "    std::function<int(int)> a_;\n    int (*b_)() = nullptr;\n};\n"}});
    CHECK(house::class_faults(tree.sources(), 2, 3).empty());
    CHECK(house::class_faults(tree.sources(), 1, 2) == Faults{"src/math/a.hpp:2: Plain has 3 members, at most 2",
                                                              "src/math/a.hpp:8: Busy has 2 private functions, at most 1"});
}

// ---- Names
// ------------------------------------------------------------------------------------------------------------

TEST_CASE("no two headers define a type of one name in one namespace")
{
    check_none(house::name_faults(engine_and_outer()));
}

TEST_CASE("a type that two headers define is found, those that are declared, or in other namespaces, are not")
{
    const Tree tree(Files{{"src/math/a.hpp", "namespace flying {\nstruct One\n{\n};\nclass Two;\nenum class Three { a };\n}\n"},
                          {"src/mass/b.hpp", "namespace flying {\nstruct One;\nclass Two : public One\n{\n    struct Three\n    {\n    };\n};\n}\n"},
                          {"src/play/c.hpp", "namespace flying::play {\nstruct One\n{\n};\n}\n"},
                          {"src/rest/d.hpp", "namespace flying {\nstruct One {};\nenum class Three\n{\n    b\n};\n}\n"},
                          {"src/rest/f.hpp", "namespace flying {\nstruct One::Inner\n{\n};\n}\n"},
                          {"src/rest/e.cpp", "namespace flying {\nstruct One\n{\n};\n}\n"}});
    CHECK(house::name_faults(tree.sources()) == Faults{"src/rest/d.hpp:2: flying::One is defined in src/math/a.hpp, too",
                                                       "src/rest/d.hpp:3: flying::Three is defined in src/math/a.hpp, too"});
}

// ---- Regions
// ----------------------------------------------------------------------------------------------------------

TEST_CASE("region markers come in pairs")
{
    for (const std::string folder : {"src", "chapters"})
        check_none(house::marker_faults(house::read_sources(k_root, folder)));
}

TEST_CASE("a region left open and one opened twice are found, units in brackets are no markers")
{
    const Tree tree(Files{{"src/math/a.hpp", "// [math.a]\nint a;\n// [math.a]\n    // [math.b]\nint b; // [m]\n"
                                             "/// [m] a length\n"},
                          {"src/math/b.hpp", "// [math.c]\n// [math.c]\n// [math.c]\n// [math.c]\n"}});
    CHECK(house::marker_faults(tree.sources()) ==
          Faults{"src/math/a.hpp:4: region [math.b] has 1 markers; a region has two",
                 "src/math/b.hpp:4: region [math.c] has 4 markers; a region has two"});
}

// ---- Chapters
// ---------------------------------------------------------------------------------------------------------

TEST_CASE("every engine file belongs to exactly one chapter")
{
    check_none(house::book_faults(engine_and_outer(), house::read_book(k_root / "chapters/book.toml")));
}

TEST_CASE("an engine file in no chapter, one in two, and an entry without a file are found")
{
    const Tree tree(
        {{"src/math/a.hpp", ""},
         {"src/math/a.cpp", ""},
         {"src/math/b.hpp", ""},
         {"src/draw/c.hpp", ""},
         {"chapters/book.toml", "[[chapter]]\nnumber = 1\nfiles = [\"src/math/a.hpp\", \"src/math/b.hpp\"]\n"
                                "[[chapter]]\nnumber = 2\nfiles = [\"src/math/b.hpp\", \"src/math/gone.hpp\"]\n"}});
    CHECK(house::book_faults(tree.sources(), tree.book()) ==
          Faults{"src/math/a.cpp: belongs to no chapters instead of one",
                 "src/math/b.hpp: belongs to 2 chapters instead of one",
                 "chapters/book.toml: chapter 2 lists src/math/gone.hpp, which isn't there"});
}

TEST_CASE("engine files include files of their own and earlier chapters only")
{
    check_none(house::later_faults(engine_and_outer(), house::read_book(k_root / "chapters/book.toml")));
}

TEST_CASE("an include of a later chapter's file is found")
{
    const Tree tree(
        {{"src/math/a.hpp", "#include \"math/b.hpp\"\n#include \"math/c.hpp\"\n"},
         {"src/math/b.hpp", ""},
         {"src/math/c.hpp", "#include \"math/a.hpp\"\n"},
         {"chapters/book.toml", "[[chapter]]\nnumber = 1\nfiles = [\"src/math/a.hpp\", \"src/math/b.hpp\"]\n"
                                "[[chapter]]\nnumber = 2\nfiles = [\"src/math/c.hpp\"]\n"}});
    CHECK(house::later_faults(tree.sources(), tree.book()) ==
          Faults{"src/math/a.hpp:2: a file of chapter 1 includes math/c.hpp of chapter 2"});
}

TEST_CASE("the order of the chapters is that of the file, whatever the numbers of their folders")
{
    const Tree tree(
        {{"src/math/a.hpp", "#include \"math/b.hpp\"\n"},
         {"src/math/b.hpp", ""},
         {"chapters/book.toml", "[[chapter]]\nnumber = 7\nfiles = [\"src/math/b.hpp\"]\n"
                                "[[chapter]]\nnumber = 2\nfiles = [\"src/math/a.hpp\"]\n"
                                "[[chapter]]\nnumber = 0\nappendix = \"A\"\nneeds = [7]\n"}});
    check_none(house::later_faults(tree.sources(), tree.book()));
    CHECK(tree.book() == house::Book{{"src/math/a.hpp", {2}}, {"src/math/b.hpp", {1}}});
}

// ---- The top of the tree
// ----------------------------------------------------------------------------------------------

TEST_CASE("everything public in src is reached by a program, a page or those who install the library")
{
    const std::vector<Source> sources = house::read_sources(k_root, "src");
    const std::set<std::string> installed = house::installed_headers(k_root, sources);
    CHECK(installed.contains("src/world/world.hpp"));
    CHECK(installed.contains("src/math/vec2.hpp"));
    check_none(house::reach_faults(sources, installed));
}

TEST_CASE("a function and a type that nothing in src uses are found, those that are installed or used are not")
{
    const Tree tree({{"src/math/a.hpp", "struct Used\n{\n};\nstruct Idle\n{\n};\n[[nodiscard]] Used make(int);\n"
                                        "[[nodiscard]] Used leave(int a,\n                         int b);\n"},
                     {"src/math/a.cpp", "Used make(int)\n{\n    return {};\n}\nUsed leave(int a, int b)\n{\n    return make(a + b);\n}\n"},
                     {"src/math/b.hpp", "void given();\n"},
                     {"src/public_headers.cmake", "set(FLYING_PUBLIC_HEADERS math/b.hpp)\n"}});
    const std::vector<Source> sources = tree.sources();
    const std::set<std::string> installed = house::installed_headers(tree.root(), sources);
    CHECK(installed == std::set<std::string>{"src/math/b.hpp"});
    CHECK(house::reach_faults(sources, installed) ==
          Faults{"src/math/a.hpp:4: nothing in src uses Idle", "src/math/a.hpp:8: nothing in src uses leave"});
}

TEST_CASE("nothing stands at the top that the design doesn't list")
{
    check_none(house::top_level_faults(k_root));
}

TEST_CASE("a file and a folder beside the list are found, those that .gitignore names are not")
{
    const Tree tree(Files{{".gitignore", "/build/\n/build-*/\n"},
                          {"README.md", ""},
                          {"src/math/a.hpp", ""},
                          {"build/x", ""},
                          {"build-clang/x", ""},
                          {"tools/x", ""},
                          {"TODO.txt", ""}});
    CHECK(house::top_level_faults(tree.root()) == Faults{"TODO.txt: the design lists no such file or folder at the top",
                                                         "tools: the design lists no such file or folder at the top"});
}
