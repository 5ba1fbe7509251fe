# SPDX-License-Identifier: Apache-2.0
"""Runs the Python blocks of a page one after the other, as a reader would, and compares what they print.

usage: run_howto.py PAGE     a block of kind `text` right after one of kind `python` is what that must print
"""
import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile


def main(page):
    text = pathlib.Path(page).read_text()
    blocks = [(m.group(1), m.group(2), text.count("\n", 0, m.start(2))) for m in
              re.finditer(r"^```(\w+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)]
    cases = pathlib.Path("cases").resolve()
    names, compared = {"__name__": "__main__"}, 0
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(cases, os.path.join(folder, "cases"))
        os.chdir(folder)
        for (kind, code, line), after in zip(blocks, blocks[1:] + [("", "", 0)]):
            if kind != "python":
                continue
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile("\n" * line + code, page, "exec"), names)  # errors name the line of the page
            if after[0] == "text":
                compared += 1
                if printed.getvalue() != after[1]:
                    sys.exit(f"{page}:{line + 1}: printed\n{printed.getvalue()}and the page says\n{after[1]}")
        os.chdir("/")
    print(f"{page}: {sum(kind == 'python' for kind, _, _ in blocks)} blocks ran, {compared} printed what it says")
    if compared < 3:
        sys.exit("too few blocks: has the page changed its form?")


main(sys.argv[1])
