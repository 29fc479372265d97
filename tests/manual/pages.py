# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the manual read in its pages: headings and their anchors, links, pictures, commands,
words, and the navigation."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
NAVIGATION = DOCS / "manual" / "mkdocs.yml"
# Pages that script/manual makes from the declarations of the programs, and the front page from README.md.
MADE = ("index.md", "reference-commands.md", "reference-methods.md", "reference-formats.md", "reference-shortcuts.md")


def pages():
    """All pages that people read: those of the manual, and README.md."""
    return [ROOT / "README.md", *sorted(DOCS.glob("*.md")), DOCS / "examples" / "README.md"]


def code_lines(text):
    """(line number, line) of the blocks of code, indented or fenced. Below an item of a list four spaces only say
    that a line belongs to it."""
    lines, fence, indent, before_is_blank = [], False, 4, True
    for number, line in enumerate(text.split("\n"), 1):
        goes_on = bool(lines) and lines[-1][0] == number - 1
        if line.strip().startswith("```"):
            fence = not fence
        elif fence:
            lines.append((number, line.strip()))
        elif line.startswith(" " * indent) and (before_is_blank or goes_on):
            lines.append((number, line[indent:]))
        elif re.match(r"(\d+\.|[-*]) ", line):
            indent = 8
        elif before_is_blank and line and not line.startswith(" "):
            indent = 4
        before_is_blank = not line.strip()
    return lines


def without_code_blocks(text):
    code = {number for number, _ in code_lines(text)}
    return "\n".join("" if number in code else line for number, line in enumerate(text.split("\n"), 1))


def without_code(text):
    """The text with nothing but line ends in place of code: blocks, and spans between backticks."""
    def blank(match):
        return re.sub(r"[^\n]", "", match.group(0))

    return re.sub(r"(?<!`)(`{1,2})(?!`)[^`\n]+?(?<!`)\1(?!`)", blank, without_code_blocks(text))


def slug(heading):
    """The anchor of a heading: as on GitHub, in the site and in the window (ManualBrowser::slugOf)."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    heading = re.sub(r"[*`]", "", heading).strip().lower()
    return "".join(letter if letter.isalnum() or letter in "_-" else "-" if letter.isspace() else "" for letter in heading)


def anchors(text):
    """The anchors of a page; a heading that comes again has a number."""
    found, blocks = [], re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M)
    for heading in re.findall(r"^#{1,6} (.*)$", blocks, re.M):
        one = slug(heading)
        again = sum(1 for other in found if re.fullmatch(re.escape(one) + r"(_\d+)?", other))
        found.append(f"{one}_{again}" if again else one)
    return found


def links(text):
    """(words, target) of each link or picture of a page, addresses of the network left out."""
    text = without_code(text)
    found = re.findall(r"\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", text)
    found += [("", target) for target in re.findall(r"<(?:img|a)\b[^>]*\b(?:src|href)=\"([^\"]+)\"", text)]
    return [(words, target) for words, target in found if not re.match(r"[a-z]+:", target)]


def link_faults(page, text):
    """A sentence for each link of a page that leads nowhere."""
    faults = []
    for words, target in links(text):
        name, _, anchor = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if not file.exists():
            faults.append(f"{page.name}: '{words}' leads to {target}, which does not exist")
        elif anchor and file.suffix == ".md":
            there = anchors(text if file == page else file.read_text())
            if anchor not in there:
                faults.append(f"{page.name}: '{words}' leads to {target}, but {file.name} has no such heading")
    return faults


def navigation(text):
    """The pages of the navigation, in their order."""
    return re.findall(r"^ *- [^:\n]+: ([\w./-]+\.md)$", text[text.index("\nnav:"):], re.M)


# Words and phrases that the glossary replaces, and what to write. Names of the window between asterisks and
# code are left out.
BANNED = {
    r"look-?alikes?": "distractor; identical target", r"twins?": "identical target", r"the middle(?! button)": "the center; median",
    r"(?<!second )moments?(?<!for a moment)(?<!at the moment)": "frame; time", r"bump(?:s|ed|ing)?": "camera moved",
    r"empty rooms?": "background image", r"verdicts?": "quality; assessment; calibration accuracy",
    r"judged?": "assess", r"turned": "rotated", r"anew": "again", r"surely": "(rewrite)", r"of late": "(rewrite)",
    r"so many": "(rewrite)", r"what is theirs": "(rewrite)", r"the person, who": "you; the user",
    r"things?": "object; target", r"taken? (?:it |them )?back": "undo", r"thrown away": "discard",
    r"gives? way": "(rewrite)", r"late by": "delay", r"(?:is|are|was|were|be) (?:said|told)": "reports; shows",
    r"(?:is|are|was|were|be) asked for": "requested", r"born": "created", r"somebody's": "(rewrite)",
    r"as one likes": "(rewrite)", r"by itself alone": "(rewrite)", r"of its own accord": "(rewrite)",
}


def without_tables(text):
    """The text with nothing but line ends in place of the tables that script/figures makes."""
    return re.sub(r"<!-- table: .*?<!-- /table -->", lambda table: "\n" * table.group(0).count("\n"), text, flags=re.S)


def banned_words(text):
    """(line number, word, what to write) of each word of a page that the glossary replaces."""
    found = []
    text = re.sub(r"\]\([^)]*\)", "]", without_code(text))
    text = re.sub(r"(?<!\*)\*(?!\*)[^*\n]+\*(?!\*)", "", text)
    for number, line in enumerate(text.split("\n"), 1):
        for word, better in BANNED.items():
            found += [(number, match.group(0), better) for match in re.finditer(rf"\b(?:{word})\b", line, re.I)]
    return found
