# What the book calls each chapter, and its folder, from chapters/book.toml: `02 02-rectangle`, `A 00-how-this-book-is-made`.
# Chapters are numbered in the order of the file; folders keep the numbers that they were given.
/^\[\[chapter\]\]/ { label = "" }
/^appendix = / { split($0, part, "\""); label = part[2] }
/^name = / { split($0, part, "\""); print (label == "" ? sprintf("%02d", ++count) : label), part[2] }
