# Reads what doctest says of an answer and tells a person about the first check that failed: what was tried, what was
# expected, what came out. Usage: awk -f feedback.awk OUTPUT
function trimmed(text) { sub(/^[ \t]+/, "", text); sub(/[ \t]+$/, "", text); return text }

# "CHECK( inside )" without its name and brackets
function inside(text) { sub(/^[^(]*\( */, "", text); sub(/ *\)[^)]*$/, "", text); return trimmed(text) }

# Where a comparison stands outside all brackets and quotes: fills left, right and sign, or leaves sign empty
function part(text,    k, depth, pair, c) {
    depth = 0; sign = ""
    for (k = 1; k <= length(text); ++k) {
        c = substr(text, k, 1)
        if (c == "\"") { for (++k; k <= length(text) && substr(text, k, 1) != "\""; ++k) { } continue }
        if (index("([{", c)) ++depth
        if (index(")]}", c)) --depth
        if (depth != 0) continue
        pair = substr(text, k, 4)
        if (pair ~ /^ (==|<=|>=|!=) /) { sign = substr(pair, 2, 2); left = substr(text, 1, k - 1); right = substr(text, k + 4); return }
        if (pair ~ /^ [<>] /) { sign = substr(pair, 2, 1); left = substr(text, 1, k - 1); right = substr(text, k + 3); return }
    }
}

function expectation(sign, right) {
    if (sign == "==" || sign == "") return right
    if (sign == "<") return "less than " right
    if (sign == "<=") return "at most " right
    if (sign == ">") return "more than " right
    if (sign == ">=") return "at least " right
    return "anything but " right
}

function close_check() {
    if (asked == "" || told) return
    told = 1
    print "    the test:  " name
    part(asked)
    if (sign == "") {
        print "    tried:     " asked
        print "    expected:  " (negated ? "false" : "true")
        print "    got:       " (values != "" ? values : (negated ? "true" : "false"))
    } else {
        print "    tried:     " trimmed(left)
        wanted = trimmed(right); got = ""
        if (values != "") { part(values); if (sign != "") { wanted = trimmed(right); got = trimmed(left) } else got = values }
        gsub(/Approx\( */, "", wanted); sub(/ *\)$/, "", wanted)
        print "    expected:  " expectation(sign, wanted)
        if (got != "") print "    got:       " got (got == wanted && sign == "==" ? ", the same in the digits shown but not in all" : "")
    }
    if (logged != "") print "    with:      " logged
}

/^TEST CASE:/ { if (asked == "") name = trimmed(substr($0, 11)); next }
/ERROR: (CHECK|REQUIRE)/ && asked == "" {
    line = substr($0, index($0, "ERROR: ") + 7); negated = line ~ /_FALSE/
    sub(/ is NOT correct!.*$/, "", line); asked = inside(line); next
}
/ERROR: test case THREW|FATAL ERROR: test case CRASHED/ && asked == "" && !told {
    told = 1; print "    the test:  " name
    print "    it " ($0 ~ /CRASHED/ ? "crashed: " substr($0, index($0, "CRASHED") + 9) : "threw an exception"); next
}
asked != "" && !told && /^ +values: / { line = $0; sub(/^ +values: /, "", line); values = inside(line); next }
asked != "" && !told && /^ +logged: / { line = $0; sub(/^ +logged: /, "", line); logged = trimmed(line); next }
asked != "" && !told && logged != "" && /^          [^ ]/ { logged = logged ", " trimmed($0); next }
asked != "" && /^$/ { close_check() }
END { close_check(); if (!told) print "    its tests fail before the first check" }
