"""Whether C++ sources have the form that .clang-format describes: `form.py CLANG_FORMAT FILE...`.

clang-format's answer is compared with the file, piece by piece. Three things it cannot be told are left to the author: where a line is broken, how far a continued line is moved to stand below what it
belongs to, and spaces that make columns after commas. What counts are spaces, the depth of blocks, comments and the order of includes. With --write the pieces that differ are replaced.
Prints them as "file:line: is, should be"; exit code 1 if there are any, 2 if clang-format fails.
"""
import difflib
import re
import subprocess
import sys


INDENT = 4  # IndentWidth of .clang-format


def bare(text):
    """What is left without spaces and line breaks."""
    return "".join(text.split())


def form(line, moved):
    line = re.sub(r"([,{]) +", r"\1 ", line)
    return line.lstrip() if moved else line


def depth(line):
    return len(line) - len(line.lstrip())


def differ(is_so, should_be, before):
    """Whether two pieces differ in what counts. A piece that is moved by something else than a block's depth is a continued line, or in one: before is the line above it."""
    if [bare(line) for line in is_so] != [bare(line) for line in should_be]:
        return bare("".join(is_so)) != bare("".join(should_be))
    moved = any(depth(line) % INDENT for line in should_be) or depth(should_be[0]) > depth(before) + INDENT
    return [form(line, moved) for line in is_so] != [form(line, moved) for line in should_be]


def pieces(is_so, should_be):
    """The pieces that count: (first line, one past the last, lines that belong there)."""
    for kind, first, last, low, high in difflib.SequenceMatcher(None, is_so, should_be, autojunk=False).get_opcodes():
        if kind != "equal" and differ(is_so[first:last], should_be[low:high], should_be[low - 1] if low else ""):
            yield first, last, should_be[low:high]


def check(program, name, write):
    with open(name, encoding="utf-8") as file:
        lines = file.read().splitlines(keepends=True)
    answer = subprocess.run([program, name], capture_output=True, text=True, check=False)
    if answer.returncode:
        print(answer.stderr, end="", file=sys.stderr)
        sys.exit(2)
    found = list(pieces(lines, answer.stdout.splitlines(keepends=True)))
    for first, last, new in reversed(found):
        if write:
            lines[first:last] = new
        else:
            print(f"{name}:{first + 1}: is\n{''.join(lines[first:last])}should be\n{''.join(new)}")
    if write and found:
        with open(name, "w", encoding="utf-8") as file:
            file.writelines(lines)
    return len(found)


def main():
    arguments = [a for a in sys.argv[1:] if a != "--write"]
    total = sum(check(arguments[0], name, "--write" in sys.argv) for name in arguments[1:])
    print(f"form: {total} pieces differ in {len(arguments) - 1} files", file=sys.stderr)
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
