# Puts a typical wrong answer in place of what the solution says: the file of the answer number N of wrong.txt.
# Usage: awk -v number=N -f wrong.awk wrong.txt solution.hpp
# wrong.txt has, for each answer, a title (#), pairs of what the solution says (-) and what stands there instead (+), and the name of
# the test that has to notice (=).
FNR == NR && /^# / { ++answer }
FNR == NR && answer == number && /^- / { from[++pairs] = substr($0, 3) }
FNR == NR && answer == number && /^\+/ { to[pairs] = substr($0, 3) }
FNR != NR { text = text $0 "\n" }
END {
    for (k = 1; k <= pairs; ++k) {
        if (!index(text, from[k])) {
            print "the solution doesn't say: " from[k] > "/dev/stderr"
            exit 1
        }
        done = ""
        while (at = index(text, from[k])) {
            done = done substr(text, 1, at - 1) to[k]
            text = substr(text, at + length(from[k]))
        }
        text = done text
    }
    printf "%s", text
}
