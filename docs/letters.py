# The book's fonts, each with the signs that the pages have and no others: python3 letters.py HTML STORE
# Debian's fonts hold thousands of signs. What was made stays in STORE, and is made anew only where the signs are others.
import html
import pathlib
import re
import shutil
import sys

from fontTools.subset import main as subset

pages, store = map(pathlib.Path, sys.argv[1:])
share = pathlib.Path("/usr/share")
fonts = {"theme/fonts/" + name + ".woff2": share / "fonts" / source for name, source in {
    "serif": "truetype/charis/CharisSIL-Regular.ttf",
    "serif-italic": "truetype/charis/CharisSIL-Italic.ttf",
    "serif-bold": "truetype/charis/CharisSIL-Bold.ttf",
    "sans": "opentype/inter/Inter-Regular.otf",
    "sans-bold": "opentype/inter/Inter-SemiBold.otf",
    "mono": "truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
    "mono-italic": "truetype/jetbrains-mono/JetBrainsMono-Italic.ttf",
}.items()}
for source in (share / "javascript/katex/fonts").glob("*.woff2"):
    fonts["katex/fonts/" + source.name] = source

# ASCII, what the pages show, and what scripts and sheets name by \u2212 or \2212
signs = set(map(chr, range(0x20, 0x7f)))
for page in pages.rglob("*"):
    if page.suffix in (".html", ".js", ".css"):
        text = html.unescape(page.read_text(encoding="utf-8"))
        signs.update(text, (chr(int(code, 16)) for code in re.findall(r"\\u?([0-9a-fA-F]{4})", text)))
signs = "".join(sorted(sign for sign in signs if sign >= " " and not "\ud800" <= sign <= "\udfff"))

known = store / "signs"
is_known = known.exists() and known.read_text(encoding="utf-8") == signs
known.unlink(missing_ok=True)
store.mkdir(parents=True, exist_ok=True)
listed = store / "signs.txt"
listed.write_text(signs, encoding="utf-8")
for name, source in fonts.items():
    made = store / name
    made.parent.mkdir(parents=True, exist_ok=True)
    if not (is_known and made.exists()):
        subset([str(source), f"--output-file={made}", f"--text-file={listed}", "--flavor=woff2", "--no-hinting",
                "--layout-features=kern,liga,tnum,lnum"])
    (pages / name).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(made, pages / name)
listed.rename(known)
