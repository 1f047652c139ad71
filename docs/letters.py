# Fonts with the signs that a book has, and no others: python3 letters.py SIGNS FROM TO [FROM TO]...
# SIGNS are code points in hexadecimal, with commas between them.
import sys

from fontTools.subset import main

signs, *files = sys.argv[1:]
for source, made in zip(files[::2], files[1::2]):
    main([source, "--output-file=" + made, "--unicodes=" + signs, "--flavor=woff2", "--no-hinting",
          "--layout-features=kern,liga,tnum,lnum"])
