#include "example_tree.hpp"

#include <set>

#include "weave/finish.hpp"

using namespace flying::weave;

namespace {

/// What stands between `open` and the next quotation mark, wherever `open` occurs.
std::multiset<std::string> all_between(const std::string& text, const std::string& open)
{
    std::multiset<std::string> found;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
        const std::size_t from = at + open.size();
        found.insert(text.substr(from, text.find('"', from) - from));
    }
    return found;
}

/// The pages of the example as they are written, without Doxygen: in the place of its manual, pages that hold nothing.
void write_pages(const ExampleTree& tree)
{
    Problems problems;
    const Woven woven = tree.weave(problems);
    Manual manual;
    for (const auto& [path, file] : woven.material.sources.files) manual.sources[path] = "source.html";
    finish_pages(woven.material, woven.pages, woven.formulas, manual, tree.root() / "html", problems);
    REQUIRE(problems.report() == "");
}

} // namespace

TEST_CASE("the page for print holds all of every chapter, of the answers and of what one looks up")
{
    const ExampleTree tree;
    write_pages(tree);
    const std::string print = tree.read("html/print.html");
    const std::multiset<std::string> anchors = all_between(print, " id=\"");
    std::size_t pictures = 0;
    for (const std::string name : {"chapter_01", "answers", "symbols", "equations"}) {
        const std::string page = tree.read("html/" + name + ".html");
        CHECK(anchors.count(name) == 1);
        const std::string article = page.substr(page.find("<article>"), page.find("</article>") - page.find("<article>"));
        CHECK(article.size() > 400);
        for (const std::string& own : all_between(article, " id=\"")) {
            CAPTURE(own);
            CHECK(anchors.count(name + "." + own) == 1);
        }
        // What has no address is there word for word
        for (std::size_t at = article.find("<p>"); at != std::string::npos; at = article.find("<p>", at + 1)) {
            const std::string paragraph = article.substr(at, article.find("</p>", at) - at);
            CAPTURE(paragraph);
            if (paragraph.find("href") == std::string::npos) CHECK(print.find(paragraph) != std::string::npos);
        }
        pictures += all_between(article, "<img src=\"").size();
    }
    CHECK(pictures > 0);
    CHECK(all_between(print, "<img src=\"").size() == pictures);
}

TEST_CASE("links of the page for print lead to places in it, or away from the book")
{
    const ExampleTree tree;
    write_pages(tree);
    const std::string print = tree.read("html/print.html");
    const std::multiset<std::string> anchors = all_between(print, " id=\"");
    for (const std::string& one : anchors) CHECK(anchors.count(one) == 1);
    const std::string text = print.substr(print.find("<main>"));
    const std::multiset<std::string> targets = all_between(text, " href=\"");
    CHECK(targets.count("#chapter_01") > 0);
    for (const std::string& target : targets) {
        CAPTURE(target);
        if (target.rfind("https://", 0) != 0) CHECK(anchors.count(target.substr(1)) == 1);
    }
}
