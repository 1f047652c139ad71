#include "example_tree.hpp"

#include "weave/tally.hpp"

// Each rule of the book, broken one at a time in the example chapter: the message names the place, what was found, and
// what was expected.

namespace {

const std::string k_chapter = "chapters/01-hinge/chapter.md";
const std::string k_receipts = "build/receipts/chapter_01.json";

/// `file:line: `, the line being the last that holds the text.
std::string at(const ExampleTree& tree, const std::string& file, const std::string& text)
{
    const std::vector<std::string> lines = flying::weave::split_lines(tree.read(file));
    for (std::size_t k = lines.size(); k-- > 0;)
        if (lines[k].find(text) != std::string::npos) return file + ":" + std::to_string(k + 1) + ": ";
    FAIL("no such line: " << text);
    return "";
}

/// One problem, at the last line of the file that holds the text, in those words.
void check_one(const ExampleTree& tree, const std::string& file, const std::string& text, const std::string& words)
{
    const std::string start = at(tree, file, text);
    const std::string report = tree.problems();
    CAPTURE(report);
    CHECK(report.rfind(start, 0) == 0);
    CHECK(report.find(words) != std::string::npos);
    CHECK(report.find("; expected ") != std::string::npos);
    CHECK(report.find('\n') == report.size() - 1);
}

} // namespace

TEST_CASE("the example of the author's guide keeps every rule")
{
    const ExampleTree tree;
    CHECK(tree.problems() == "");
}

// ---- Receipts -------------------------------------------------------------------------------------------------------

TEST_CASE("an equation without a receipt fails the book")
{
    const ExampleTree tree;
    tree.write(k_receipts, "{}");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end without a receipt");
}

TEST_CASE("an equation whose test failed fails the book")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "\"cases\": 210, \"passed\": true", "\"cases\": 210, \"passed\": false");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end fails its test");
}

TEST_CASE("receipts of a test program that failed elsewhere fail the book")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "{\"passed\": true", "{\"passed\": false");
    CHECK(tree.problems() == "chapter_01.json: receipts of a test program that failed; expected tests that pass\n");
}

TEST_CASE("receipts that can't be read fail the book")
{
    const ExampleTree tree;
    tree.write(k_receipts, "{\"equations\": ");
    CHECK(tree.problems().find("chapter_01.json: receipts that can't be read") != std::string::npos);
}

TEST_CASE("an equation without a wrong twin fails the book")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "\"twins\": 210", "\"twins\": 0");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end without a wrong twin");
}

TEST_CASE("an equation whose twin passes too fails the book")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "\"twins_rejected\": true", "\"twins_rejected\": false");
    check_one(tree, k_chapter, "::equation hinge.end", "takes the wrong twin too");
}

TEST_CASE("a twin that is held to a tighter bound than its equation fails the book")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "\"twin_bound\": 1e-15", "\"twin_bound\": 1e-16");
    check_one(tree, k_chapter, "::equation hinge.end", "twin rejected by a bound of 1e-16");
}

TEST_CASE("a receipt says of which kind it is where it is not an oracle with rounding")
{
    const ExampleTree tree;
    tree.replace(k_receipts, "\"worst\": 2e-16", "\"worst\": 0");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end: no error at all in 210 cases");
    for (const std::string kind : {"same", "exact"}) {
        tree.replace(k_chapter, "::equation hinge.end", "::equation hinge.end " + kind);
        CHECK(tree.problems() == "");
        tree.replace(k_chapter, "::equation hinge.end " + kind, "::equation hinge.end");
    }
    tree.replace(k_receipts, "\"worst\": 0, \"bound\": 1e-15", "\"worst\": 1e-3, \"bound\": 1e-2");
    tree.replace(k_receipts, "\"twin_bound\": 1e-15", "\"twin_bound\": 1e-2");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end: its test allows 1.0e-02");
    tree.replace(k_chapter, "::equation hinge.end", "::equation hinge.end measured");
    CHECK(tree.problems() == "");
    tree.replace(k_chapter, "::equation hinge.end measured", "::equation hinge.end surely");
    check_one(tree, k_chapter, "::equation hinge.end", "equation hinge.end of the kind `surely`");
}

TEST_CASE("a slip in the printed formula fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "I = \\frac{m l^2}{3}\n```", "I = \\frac{m l^2}{2}\n```");
    check_one(tree, k_chapter, "::equation hinge.end",
              "its printed side `\\frac{m l^2}{2}` is 6 at l = 2, m = 3; expected 4");
}

TEST_CASE("a printed formula that can't be evaluated, though its test names quantities, fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "I = \\frac{m l^2}{3}\n```", "I = \\frac{m q^2}{3}\n```");
    check_one(tree, k_chapter, "::equation hinge.end", "no printed side can be evaluated");
}

TEST_CASE("a line of a derivation that does not follow from the one before fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "= \\frac{\\lambda l^3}{3} ", "= \\frac{\\lambda l^3}{2} ");
    check_one(tree, k_chapter, "\\frac{\\lambda l^3}", "as the line before says");
}

TEST_CASE("a derivation that nothing checks fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, " for m in 0.5..20, l in 0.1..4, \\lambda = m / l", "");
    check_one(tree, k_chapter, "::derivation", "derivation hinge.steps that nothing checks");
}

TEST_CASE("a line of a derivation without a reason fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "          % the integral of a square", "");
    check_one(tree, k_chapter, "\\frac{\\lambda l^3}{3}", "a line of a derivation without a reason");
}

TEST_CASE("a derivation checked in a test has as many lines as the test")
{
    const ExampleTree tree;
    tree.replace(k_chapter, " for m in 0.5..20, l in 0.1..4, \\lambda = m / l", "");
    tree.replace(k_receipts, "\"derivations\": {}",
                 "\"derivations\": {\"hinge.steps\": {\"lines\": 2, \"points\": 9, \"passed\": true, \"worst\": 0}}");
    check_one(tree, k_chapter, "::derivation", "derivation hinge.steps of 3 lines; expected 2");
}

TEST_CASE("a symbol of a derivation without a range fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, ", \\lambda = m / l", "");
    check_one(tree, k_chapter, "\\int_0^l", "symbols without a range");
}

TEST_CASE("a formula's id is used once")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "::definition hinge.inertia", "::definition hinge.end");
    CHECK(tree.problems().find("formula `hinge.end`, which stands at " +
                               at(tree, k_chapter, "::definition").substr(0, 31)) != std::string::npos);
}

// ---- Listings -------------------------------------------------------------------------------------------------------

namespace {

/// Marks round lines of the example's source.
void mark(const ExampleTree& tree, const std::string& lines, const std::string& name)
{
    tree.replace("src/rods/rod.hpp", lines, "// [" + name + "]\n" + lines + "// [" + name + "]\n");
}

const std::string k_listing = "::listing rods/rod.hpp:rod_about_end";
const std::string k_return = "    return m * l * l / 3.0;\n";

} // namespace

TEST_CASE("a story that tells less of its files than it has to fails the book")
{
    const ExampleTree tree;
    tree.replace("chapters/book.toml", "written = true", "written = true\ntold = 0.7");
    CHECK(tree.problems() == "chapters/01-hinge/chapter.md: a story that tells 7 of the 12 lines of its files, 58.3 %; "
                             "expected at least 70.0 %, as book.toml has it (told)\n");
}

TEST_CASE("marks that no listing needs fail the book")
{
    const ExampleTree tree;
    mark(tree, "    return m * l * l / 12.0;\n", "rod.middle");
    // At the first of the two
    CHECK(tree.problems() ==
          "src/rods/rod.hpp:16: marks of `rod.middle`, which no listing shows; expected no marks, or a "
          "::listing\n");
}

TEST_CASE("a line shown twice as new fails the book, and once more as again does not")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "It implements", k_listing + "\n\nIt implements");
    check_one(tree, k_chapter, k_listing, "shown as new for the second time");
    tree.replace(k_chapter, k_listing + "\n\nIt implements", k_listing + " again\n\nIt implements");
    CHECK(tree.problems() == "");
}

TEST_CASE("a listing of what is no region fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, k_listing, k_listing + "\n\n::listing rods/rod.hpp:rod_inertai");
    check_one(tree, k_chapter, "rod_inertai", "listing of `rods/rod.hpp:rod_inertai`, which is no region");
}

TEST_CASE("a listing may show several declarations")
{
    const ExampleTree tree;
    tree.replace(k_chapter, k_listing, k_listing + " rods/rod.hpp:rod_about_middle");
    flying::weave::Problems problems;
    const flying::weave::Woven woven = tree.weave(problems);
    CHECK(problems.report() == "");
    CHECK(woven.counts.coverage.sum().told == woven.counts.coverage.sum().lines);
}

TEST_CASE("a region that opens and never closes fails the book")
{
    const ExampleTree tree;
    tree.replace("src/rods/rod.hpp", k_return, "// [rod.open]\n" + k_return);
    CHECK(tree.problems().find(at(tree, "src/rods/rod.hpp", "[rod.open]") +
                               "region [rod.open] opened and never closed") != std::string::npos);
}

TEST_CASE("two regions of one name fail the book")
{
    const ExampleTree tree;
    mark(tree, k_return, "rod.one");
    mark(tree, "    return m * l * l / 12.0;\n", "rod.one");
    CHECK(tree.problems().find("marker [rod.one], which stands at src/rods/rod.hpp:11 too") != std::string::npos);
}

TEST_CASE("a region inside another is folded in it, and each line counts once")
{
    const ExampleTree tree;
    mark(tree, k_return, "rod.inner");
    const auto told = [&] {
        flying::weave::Problems problems;
        const flying::weave::Woven woven = tree.weave(problems);
        CHECK(problems.report() == "");
        return woven.counts.coverage.sum().told;
    };
    CHECK(told() == 6);
    tree.replace(k_chapter, k_listing, k_listing + "\n\n::listing rod.inner");
    CHECK(told() == 7);
}

TEST_CASE("files of chapters that are not written are held to nothing")
{
    const ExampleTree tree;
    tree.write("src/rods/later.hpp", "int later();\n");
    tree.write("chapters/book.toml",
               tree.read("chapters/book.toml") +
                   "\n[[chapter]]\nnumber = 2\nname = \"02-later\"\ntitle = \"Later\"\nneeds = [1]\n"
                   "written = false\nfiles = [\"src/rods/later.hpp\"]\n");
    CHECK(tree.problems() == "");
}

// ---- Prose ----------------------------------------------------------------------------------------------------------

TEST_CASE("a decimal number typed into the text fails the book, in formulas of the line too")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "a finger turns it.", "a finger turns it with 2.5 newtons.");
    check_one(tree, k_chapter, "a finger turns", "decimal number 2.5 typed into the text");
    tree.replace(k_chapter, "with 2.5 newtons", "with $F = 2.5$");
    check_one(tree, k_chapter, "a finger turns", "decimal number 2.5 typed into the text");
    tree.replace(k_chapter, "$F = 2.5$", "1e-3 of it");
    check_one(tree, k_chapter, "a finger turns", "decimal number 1e-3 typed into the text");
}

TEST_CASE("a decimal number typed into a caption or into a reason fails the book")
{
    const auto with = [](const std::string& from, const std::string& to) {
        const ExampleTree tree;
        tree.replace(k_chapter, from, to);
        return tree.problems();
    };
    const std::string number = "decimal number 2.5 typed into the text";
    CHECK(with("A thin rod, its end", "A thin rod of 2.5 m, its end").find("chapter.md:5: " + number) !=
          std::string::npos);
    CHECK(with("the integral of a square", "2.5 of them").find(number) != std::string::npos);
    CHECK(with("A thin rod, its end", "A thin rod of {{given:2.5}} m, its end") == "");
}

TEST_CASE("a decimal number that is declared as given is counted: code and versions are no numbers")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "a finger turns it.", "$e = {{given:0.5}}$ and {{given:2.5}}, `x = 2.5`, Doxygen 1.9.4.");
    flying::weave::Problems problems;
    CHECK(tree.weave(problems).counts.given == 2);
    CHECK(problems.report() == "");
}

TEST_CASE("a value that nothing computes, a reference to nothing and an unknown insert fail the book")
{
    const ExampleTree tree;
    const auto with = [&](const std::string& insert) {
        const ExampleTree other;
        other.replace(k_chapter, "a finger turns it.", "a finger turns it " + insert);
        return other.problems();
    };
    CHECK(with("{{value:nothing|%.1e}}").find("chapter.md:3: value `nothing`, which nothing computes") !=
          std::string::npos);
    CHECK(with("{{value:hinge.demo.inertia|%s}}").find("format `%s` of a value") != std::string::npos);
    CHECK(with("{{eq:nothing}}").find("reference to formula `nothing`") != std::string::npos);
    CHECK(with("{{ch:nothing}}").find("reference to chapter `nothing`") != std::string::npos);
    CHECK(with("{{file:nothing}}").find("reference to file `nothing`") != std::string::npos);
    CHECK(with("{{nothing}}").find("insert `{{nothing}}`") != std::string::npos);
    CHECK(with("[here](there.md)").find("link to `there.md`") != std::string::npos);
}

TEST_CASE("a larger number in words fails the book in a caption, and in the text where it is a rough result")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "A door weighs as much as you do",
                 "Of a hundred doors, some thirty weigh as much as you do");
    check_one(tree, k_chapter, "Of a hundred doors", "a number in words, `some thirty`");
    tree.replace(k_chapter, "some thirty weigh", "{{given:some thirty}} weigh");
    CHECK(tree.problems() == "");
    tree.replace(k_chapter, "::figure rod \"A thin rod", "::figure rod \"Twenty slices of a thin rod");
    check_one(tree, k_chapter, "::figure rod", "a number in words, `Twenty`");
}

TEST_CASE("a caption with a formula needs words without one beside it")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "at the distance x\"", "at the distance $x$\"");
    check_one(tree, k_chapter, "::figure rod", "::figure rod with a formula in its caption");
    tree.replace(k_chapter, "at the distance $x$\"", "at the distance $x$\" \"A thin rod and a slice of it\"");
    CHECK(tree.problems() == "");
}

TEST_CASE("code, formulas and pictures that bypass the directives fail the book")
{
    const auto with = [&](const std::string& text) {
        const ExampleTree tree;
        tree.replace(k_chapter, "a finger turns it.", "a finger turns it.\n\n" + text);
        return tree.problems();
    };
    CHECK(with("```cpp\nint x;\n```").find("chapter.md:5: a block of `cpp` typed into the text") != std::string::npos);
    CHECK(with("```tex\nx\n```").find("chapter.md:5: a formula without a directive") != std::string::npos);
    CHECK(with("$$x = 1$$").find("a displayed formula between $$") != std::string::npos);
    CHECK(with("![door](door.png)").find("a picture in Markdown") != std::string::npos);
    CHECK(with("costs 3$ a piece").find("a dollar without its pair") != std::string::npos);
    CHECK(with("::lsiting rod.inertia").find("unknown directive ::lsiting") != std::string::npos);
    CHECK(with("::equation hinge.other").find("::equation hinge.other without its formula") != std::string::npos);
    CHECK(with("```text\nnever closed").find("a fence ``` that never closes") != std::string::npos);
    CHECK(with("## Where `x` breaks").find("heading `Where `x` breaks`") != std::string::npos);
}

TEST_CASE("bad TeX fails the book and says where")
{
    const ExampleTree tree;
    tree.replace(k_chapter, "I = \\int x^2 \\, dm", "I = \\int x^{2 \\, dm");
    check_one(tree, k_chapter, "::definition", "bad TeX");
    tree.replace(k_chapter, "x^{2 \\, dm", "x^2 \\, dm");
    tree.replace(k_chapter, "a finger turns it.", "a finger turns $\\itt$.");
    check_one(tree, k_chapter, "a finger turns", "bad TeX `\\itt`");
}

// ---- Completeness ---------------------------------------------------------------------------------------------------

TEST_CASE("a figure without words for those who don't see it, or without its file, fails the book")
{
    const ExampleTree tree;
    tree.replace(k_chapter, " \"A thin rod, its end at the hinge, and a slice of it at the distance x\"", "");
    check_one(tree, k_chapter, "::figure", "::figure rod without words for those who don't see it");
    const ExampleTree other;
    other.remove("build/figures/01-hinge/rod.svg");
    check_one(other, k_chapter, "::figure", "::figure rod without rod.svg");
}

TEST_CASE("a chapter without demo, tests, figure, exercise, symbols or summary fails the book")
{
    const auto without = [&](const std::string& text, const std::string& file) {
        const ExampleTree tree;
        if (!text.empty()) tree.replace(k_chapter, text, "");
        if (!file.empty()) tree.remove("chapters/01-hinge/" + file);
        return tree.problems();
    };
    CHECK(without("", "demo.cpp").find("a chapter without demo; expected chapters/01-hinge/demo.cpp") !=
          std::string::npos);
    CHECK(without("::output demo\n", "").find("a chapter that never shows its demo's output") != std::string::npos);
    CHECK(without("", "tests.cpp").find("a chapter without tests") != std::string::npos);
    CHECK(without("::figure rod \"A thin rod, its end at the hinge, and a slice of it at the distance x\"\n", "")
              .find("a chapter without figure") != std::string::npos);
    CHECK(without("::exercise e1\n", "").find("a chapter without exercise") != std::string::npos);
    CHECK(without("::exercise e1\n", "").find("an exercise that its chapter never poses") != std::string::npos);
    CHECK(without("## Summary\n", "").find("a chapter without summary") != std::string::npos);
    CHECK(without("## Symbols\n", "").find("a chapter without its table of symbols") != std::string::npos);
    CHECK(without("", "exercises/e1/hint.md").find("chapters/01-hinge/exercises/e1: an exercise without hint.md") !=
          std::string::npos);
    CHECK(without("", "exercises/e1/stub.hpp").find("an exercise in code without stub.hpp") != std::string::npos);
    CHECK(without("", "chapter.md").find("no chapters/01-hinge/chapter.md") != std::string::npos);
}

TEST_CASE("a chapter without hours and goals, or with other needs than it names, fails the book")
{
    const ExampleTree tree;
    tree.replace("chapters/book.toml", "hours = 1\n", "");
    check_one(tree, "chapters/book.toml", "[[chapter]]", "chapter 1 without hours or goals");
    tree.replace("chapters/book.toml", "needs = []", "needs = []\nhours = 1");
    tree.replace(k_chapter, "## Symbols", "## What you need\n\nThe chapter {{ch:hinge}}.\n\n## Symbols");
    const std::string report = tree.problems();
    CAPTURE(report);
    CHECK(report.find("links to the chapters 1; expected none, as `needs` of chapter 1") != std::string::npos);
}

TEST_CASE("a chapter has the exercises that book.toml asks for")
{
    const ExampleTree tree;
    const auto ask = [&](const std::string& least) {
        const std::string book = tree.read("chapters/book.toml");
        tree.write("chapters/book.toml", book.substr(0, book.find("\n[exercises]")) + "\n[exercises]\n" + least);
        return tree.problems();
    };
    CHECK(ask("least = 1\nin_code = 1\n").empty());
    for (const char* more : {"least = 2\n", "in_code = 2\n", "hard = 1\n", "changes = 1\n"}) {
        const std::string report = ask(more);
        CAPTURE(more);
        CAPTURE(report);
        CHECK(report.find("1 exercises, 1 in code, 0 hard, 0 that change a source; expected") != std::string::npos);
    }
    tree.replace("chapters/01-hinge/exercises/e1/text.md", "# The other end\n",
                 "# The other end (hard)\n\nIn `src/rods/rod.hpp` break something.\n");
    CHECK(ask("hard = 1\nchanges = 1\n").empty());
}

TEST_CASE("a chapter is counted: words without formulas, equations by the kind of their receipts")
{
    const ExampleTree tree;
    flying::weave::Problems problems;
    const flying::weave::Woven woven = tree.weave(problems);
    const std::vector<flying::weave::Tally> all = flying::weave::tallies(woven.material, woven.counts.coverage);
    REQUIRE(all.size() == 1);
    const flying::weave::Tally& tally = all.front();
    CHECK(tally.oracle == 1);
    CHECK(tally.measured + tally.same == 0);
    CHECK(tally.worst == 2e-16);
    CHECK(tally.worst_name == "hinge.end");
    CHECK(tally.figures == 1);
    CHECK(tally.exercises.in_code == 1);

    // Formulas, code, inserts and listings are no words
    const int words = tally.words;
    tree.replace(k_chapter, "## Symbols", "Four words of text, $m = 2 l$, `code` {{given:7}}.\n\n## Symbols");
    const flying::weave::Woven more = tree.weave(problems);
    CHECK(flying::weave::tallies(more.material, more.counts.coverage).front().words == words + 4);
}

TEST_CASE("a book whose chapters need later ones or have no number fails")
{
    const ExampleTree tree;
    tree.replace("chapters/book.toml", "needs = []", "needs = [2]");
    check_one(tree, "chapters/book.toml", "[[chapter]]", "chapter 1 needs chapter 2");
    tree.write("chapters/book.toml", "chapter = [");
    check_one(tree, "chapters/book.toml", "chapter = [", "expected valid TOML");
}
