#include "example_tree.hpp"

#include "weave/finish.hpp"
#include "weave/inline.hpp"
#include "weave/ledger.hpp"
#include "weave/text.hpp"

using namespace flying::weave;

TEST_CASE("running text comes apart into prose, code, formulas, inserts and links")
{
    const std::vector<Piece> pieces = pieces_of({{7, "A `b` and $c$, {{eq:d}}"}, {8, "[e](https://f.org) \\$g"}});
    std::vector<std::string> shown;
    for (const Piece& piece : pieces) shown.push_back(std::to_string(static_cast<int>(piece.kind)) + ":" + piece.text);
    CHECK(shown == std::vector<std::string>{"0:A ", "1:b", "0: and ", "2:c", "0:, ", "3:eq:d", "0:\n[e]",
                                            "4:https://f.org", "0: \\$g\n"});
    CHECK(pieces.back().line == 8);
}

TEST_CASE("a printed line `name = number` is a value")
{
    Ledger ledger;
    add_printed_values("demo", "Period error = 1.5e-12 s\nno value here\nx = y\nTotal  energy = 4, say\n", ledger);
    CHECK(ledger.values == std::map<std::string, double>{{"demo.period-error", 1.5e-12}, {"demo.total-energy", 4.0}});
}

TEST_CASE("a line that goes on with a statement gives up its deep indent where there is no room")
{
    Indents indents;
    const auto marked = [&indents](std::size_t indent) { return indents.mark(std::string(indent, ' ') + "x"); };
    CHECK(marked(0) == "x");
    CHECK(marked(4) == "    x");
    CHECK(marked(12) == std::string(12, ' ') + "x"); // two levels
    CHECK(marked(30) == std::string(12, ' ') + "<span class=\"deep\">" + std::string(18, ' ') + "</span>x");
    CHECK(indents.mark("").empty());
    CHECK(marked(8) == std::string(8, ' ') + "x"); // one level in: a statement
    CHECK(marked(17) == std::string(16, ' ') + "<span class=\"deep\"> </span>x");
}

TEST_CASE("an output may be shown table by table")
{
    CHECK(output_tables("a\nb\n\n \nc\n") == std::vector<std::string>{"a\nb\n", "c\n"});
    CHECK(part_of("a\n\n\nb\n\nc\n", {2, 3}) == "b\n\nc\n");
    CHECK(part_of("a\n\n\nb\n", {}) == "a\n\n\nb\n");
    CHECK(output_part("")->last == 0);
    CHECK(output_part("3")->last == 3);
    CHECK(output_part("2-10")->first == 2);
    for (const char* bad : {"0", "x", "1-", "-2", "1 2"}) CHECK_FALSE(output_part(bad).has_value());
}

TEST_CASE("values are set with powers of ten, and no format reaches further than one number")
{
    CHECK(format_value(0.25, "%.2f") == "0.25");
    CHECK(format_value(6.6e-16, "%.1e") == "6.6\u2009\u00b7\u200910<sup>\u221216</sup>");
    CHECK(format_value(9999.0, "%.0f") == "9999");
    CHECK(format_value(31415926.0, "%.0f") == "31,415,926");
    CHECK(format_value(-100000.25, "%.2f") == "\u2212100,000.25");
    CHECK(format_value(1000.0, "%.0e") == "10<sup>3</sup>");
    CHECK(format_value(0.0, "%.0e") == "0");
    CHECK(format_value(-0.269, "%.3f") == "\u22120.269");
    CHECK(format_value(-6.6e-16, "%.1e") == "\u22126.6\u2009\u00b7\u200910<sup>\u221216</sup>");
    for (const char* bad : {"%s", "%n", "%d", "%.3g%s", "x", "", "%", "%*g"})
        CHECK_FALSE(format_value(1.0, bad).has_value());
}

TEST_CASE("a name in code keeps its link only where it is surely the name that is linked")
{
    const auto link = [](const std::string& kind, const std::string& name) {
        return "<a class=\"code hl_" + kind + "\" href=\"x.html#a\">" + name + "</a>";
    };
    const auto stays = [](const std::string& line) { return without_guessed_links(line) == line; };
    CHECK(stays("const " + link("struct", "Body") + "&amp; b = " + link("function", "body_of") + "(" +
                link("variable", "k_first") + ");"));
    CHECK(stays("bodies." + link("variable", "mass") + "[i] + p-&gt;" + link("variable", "x") +
                " + Kind::" + link("enumvalue", "left") + " + " + link("variable", "count_") + " + " +
                link("function", "most") + "&lt;int&gt;()"));
    CHECK(without_guessed_links("double " + link("variable", "mass") + " = " + link("enumvalue", "left") + " + " +
                                link("function", "step") + ";") == "double mass = left + step;");
    CHECK(stays("no link at all"));
    CHECK(stays("<a class=\"code hl_variable\" href=\"cut off"));
}

TEST_CASE("aligned parameters in comments become lists for the manual, and lines stay where they are")
{
    const std::string source =
        "/// Fall.\n///\n/// g, h  weights [N]\n/// t     time since\n///       it began\nint f();\n// [a.b]\n";
    CHECK(filter_source(split_lines(source)) ==
          "/// Fall.\n///\n/// - <b>g, h</b>: weights [N]\n/// - <b>t</b>: time since\n///   it began\nint f();\n\n");
}

TEST_CASE("links that lead nowhere are found, to pages and to anchors")
{
    const ExampleTree tree;
    tree.write("html/a.html",
               "<a href=\"b.html#here\">b</a> <a href=\"b.html#gone\"></a> <a href=\"c.html\"></a> <img src=\"d.svg\"> "
               "<a href=\"https://e.org\"></a>");
    tree.write("html/b.html", "<p id=\"here\">");
    Problems problems;
    check_links(tree.root() / "html", problems);
    CHECK(problems.report() == "a.html: link to b.html#gone; expected an anchor that is there\n"
                               "a.html: link to c.html; expected a page or file that is there\n"
                               "a.html: link to d.svg; expected a page or file that is there\n");
}

TEST_CASE("a warning of Doxygen fails the book, and the last good book stays")
{
    const ExampleTree tree;
    std::filesystem::copy(std::filesystem::path(FLYING_SOURCE_DIR) / "docs", tree.root() / "docs",
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    const Folders folders{tree.root(), tree.root() / "docs", tree.root() / "build"};
    tree.write("build/html/index.html", "the last good book");

    // Any program that warns will do for Doxygen's warning
    tree.write("warns", "#!/bin/sh\ntouch header.html\n[ \"$1\" = Doxyfile ] && echo 'src/rods/rod.hpp:3: warning: "
                        "odd' && exit 1\nexit 0\n");
    std::filesystem::permissions(tree.root() / "warns", std::filesystem::perms::owner_all);
    Problems problems;
    make_book(folders, {(tree.root() / "warns").string(), "node"}, problems);
    CHECK(problems.report() == "doxygen: src/rods/rod.hpp:3: warning: odd; expected no warning\n");
    CHECK(tree.read("build/html/index.html") == "the last good book");
}

TEST_CASE("a reference to a chapter has a capital where it begins a sentence")
{
    const ExampleTree tree;
    tree.replace("chapters/01-hinge/chapter.md", "a finger turns it.",
                 "a finger turns it. {{ch:hinge}} asks, and {{ch:hinge}} answers.");
    Problems problems;
    const Woven woven = tree.weave(problems);
    CHECK(problems.report() == "");
    std::string words;
    for (const Fragment& fragment : woven.pages.fragments.list()) {
        for (const char* word : {">Chapter 1<", ">chapter 1<"})
            if (fragment.text.find(word) != std::string::npos) words += word;
    }
    CHECK(words.find(">Chapter 1<>chapter 1<") != std::string::npos);
}

TEST_CASE("a chapter's page loads its experiments where it has any")
{
    const ExampleTree tree;
    const auto page_loads = [&] {
        Problems problems;
        const Woven woven = tree.weave(problems);
        CHECK(problems.report() == "");
        for (const Page& page : woven.pages.list)
            if (page.foot.find("<script src=\"live/01-hinge.js\"") != std::string::npos) return true;
        return false;
    };
    CHECK(!page_loads());
    tree.write("chapters/01-hinge/live.js", "flyingLive('01-hinge/rod', {});\n");
    CHECK(page_loads());
}

TEST_CASE("an equation right behind a derivation that ends with it is the number of the last line")
{
    const ExampleTree tree;
    const auto formulas = [&] {
        Problems problems;
        const Woven woven = tree.weave(problems);
        CHECK(problems.report() == "");
        std::string all;
        for (const Fragment& fragment : woven.pages.fragments.list()) all += fragment.text + "\n";
        return all;
    };
    const std::string k_box = "<div class=\"formula equation\" id=\"eq-hinge-end\">";
    const std::string k_line = "<a class=\"number\" id=\"eq-hinge-end\"";
    const std::string apart = formulas();
    CHECK(apart.find(k_box) != std::string::npos);
    CHECK(apart.find(k_line) == std::string::npos);

    // Without the words and the listing between the two; one formula less is set, its receipt stays
    const std::string chapter = "chapters/01-hinge/chapter.md";
    tree.replace(chapter, "## The code\n\n::listing rods/rod.hpp:rod_about_end\n\nIt implements\n\n", "");
    tree.replace(chapter, "## The demo", "## The code\n\n::listing rods/rod.hpp:rod_about_end\n\n## The demo");
    const std::string joined = formulas();
    CHECK(joined.find(k_box) == std::string::npos);
    CHECK(joined.find(k_line) != std::string::npos);

    // Another end is another formula
    tree.replace(chapter, "```tex\nI = \\frac{m l^2}{3}", "```tex\nI = \\frac{l^2 m}{3}");
    CHECK(formulas().find(k_box) != std::string::npos);
}

TEST_CASE("a live figure needs a recording for where the engine can't run")
{
    const ExampleTree tree;
    tree.replace("chapters/01-hinge/chapter.md", "## Summary",
                 "::live swing \"The rod swings about its hinge\"\n\n## Summary");
    CHECK(tree.problems().find("::live swing without swing.ndjson") != std::string::npos);
    tree.write("build/figures/01-hinge/swing.ndjson", "{\"shapes\": []}\n");
    CHECK(tree.problems() == "");
}
