#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Replaces English texts of the window everywhere at once, so that no translation is lost. The table is a JSON list
of {"old": text, "new": text, "de": translation, "es": ..., "ja": ..., "en": forms, "context": name}. All but "old" and
"new" may be missing: without a translation the old one is kept, without a context all contexts are changed. Texts with
%n have a list of forms. Needs clang-format. See docs/translations.md.

Usage: rename_texts.py TABLE [--root FOLDER]"""
import argparse
import collections
import json
import pathlib
import re
import subprocess

# What core declares for the window; see list_strings.cpp.
CORE_CONTEXTS = {"Error", "Method", "Parameter", "ParameterGroup", "Unit", "Experiment", "Finding"}
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|\bR"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"'
                   r"|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'"
                   r'|(?P<text>(?<!\w)(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")', re.S)
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "0": "\0"}
XML = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&apos;"}
CPP = {".cpp", ".h"}


def decoded(literal):
    """The text of a C++ literal, or None if it has escapes that say bytes."""
    body = literal[literal.index('"') + 1:-1]
    if re.search(r"\\[xU1-7]", body):
        return None
    body = re.sub(r"\\u([0-9a-fA-F]{4})", lambda code: chr(int(code.group(1), 16)), body)
    return re.sub(r"\\(.)", lambda one: ESCAPES.get(one.group(1), one.group(1)), body, flags=re.S)


def encoded(text):
    """A text as one C++ literal; clang-format splits it."""
    return '"' + re.sub(r'[\\"]', r"\\\g<0>", text).replace("\n", "\\n").replace("\t", "\\t") + '"'


def literals(source):
    """(start, end, text) of each C++ literal; adjacent literals are one."""
    groups = []
    for token in TOKEN.finditer(source):
        if token["text"] is None:
            continue
        start, before, text = token.start(), "", decoded(token.group())
        if groups and not source[groups[-1][1]:start].strip():
            start, _, before = groups.pop()
        groups.append((start, token.end(), None if before is None or text is None else before + text))
    return groups


def marked_context(source, start):
    """The context of a text that Qt translates: '' if it is that of the class, None if it is not translated."""
    before = source[max(0, start - 300):start]
    call = re.search(r'\b(?:translate|QT_TRANSLATE_NOOP3?)\s*\(\s*"([^"\\]*)"\s*,\s*$', before) or re.search(
        r"(?:\b(\w+)::)?\b(?:tr|QT_TR_NOOP)\s*\(\s*$", before)
    return (call.group(1) or "") if call else None


def is_one_word(text):
    return text.isascii() and " " not in text


def escaped(text):
    return re.sub("[&<>\"']", lambda one: XML[one.group()], text)


def plain(text):
    return re.sub("|".join(XML.values()), lambda code: {v: k for k, v in XML.items()}[code.group()], text)


def renamed_message(part, entry, translation):
    """The <message> of a catalog with its new source, and with a new translation if there is one."""
    source = f"<source>{escaped(entry['new'])}</source>"
    part = re.sub(r"<source>.*?</source>", lambda _: source, part, count=1, flags=re.S)
    if isinstance(translation, list):
        forms = iter(translation)
        return re.sub(r"<numerusform>.*?</numerusform>",
                      lambda _: f"<numerusform>{escaped(next(forms))}</numerusform>", part, flags=re.S)
    if translation is not None:
        part = re.sub(r"(<translation[^>]*>).*?</translation>",
                      lambda tag: f"{tag.group(1)}{escaped(translation)}</translation>", part, flags=re.S)
    return part


class Renamer:
    def __init__(self, root, table):
        self.root, self.table, self.changed, self.doubts = root, table, [], []
        self.contexts = collections.defaultdict(set)  # old text: its contexts in the catalogs
        self.entries = collections.defaultdict(list)  # old text: its entries of the table
        self.in_sources, self.in_catalogs = set(), set()  # ids of the entries that were found
        self.pages = [*root.glob("README.md"), *self.files("docs", {".md"})]
        for entry in table:
            self.entries[entry["old"]].append(entry)
        # The texts of other programs stay, and so do the tests that look for them.
        self.others = "\0".join(self.texts(file) for folder in ("app", "core") for file in self.files(folder, CPP)
                                if "app/dewpoint/" not in file.as_posix())

    def files(self, folder, endings):
        return sorted(file for file in (self.root / folder).rglob("*") if file.suffix in endings)

    @staticmethod
    def texts(file):
        return "\0".join(text or "" for _, _, text in literals(file.read_text(encoding="utf-8")))

    def write(self, file, old, new):
        if new != old:
            self.changed.append(file)
            file.write_text(new, encoding="utf-8")

    def doubt(self, file, source, position, words):
        self.doubts.append(f"{file.relative_to(self.root)}:{source.count(chr(10), 0, position) + 1}: {words}")

    def entry(self, text, context=None, source=""):
        """What to do with a text; `context` as from marked_context(), or None if it does not matter."""
        for entry in self.entries.get(text, []):
            wanted = entry.get("context")
            last = (wanted or "").rsplit("::", maxsplit=1)[-1]
            if not wanted or context in (None, wanted, last) or not context and re.search(rf"\b{last}::", source):
                return entry
        return None

    def entry_in_test(self, text, file):
        shared = text in self.others and not self.contexts[text] & CORE_CONTEXTS and "ui" not in file.parts
        return None if shared or is_one_word(text) else self.entry(text)

    def catalog(self, file):
        language = file.stem.rsplit("_", 1)[1]

        def context(block):
            name, seen = re.search(r"<name>(.*?)</name>", block.group()).group(1), set()

            def message(part):
                text = plain(re.search(r"<source>(.*?)</source>", part.group(), re.S).group(1))
                self.contexts[text].add(name)
                entry, result = self.entry(text, name), part.group()
                if entry:
                    self.in_catalogs.add(id(entry))
                    result = renamed_message(result, entry, entry.get(language))
                key = re.search(r"<source>.*?</source>(?:\s*<comment>.*?</comment>)?", result, re.S).group()
                result = "" if key in seen else result  # two texts may have become one
                seen.add(key)
                return result

            return re.sub(r"    <message.*?</message>\n", message, block.group(), flags=re.S)

        whole = file.read_text(encoding="utf-8")
        self.write(file, whole, re.sub(r"<context>.*?</context>\n", context, whole, flags=re.S))

    def cpp(self, file, kind):
        source = new = file.read_text(encoding="utf-8")
        for start, end, text in reversed(literals(source)):
            if text not in self.entries:
                continue
            context, entry, of_core = marked_context(source, start), None, self.contexts[text] & CORE_CONTEXTS
            if kind == "ui" and context is not None:
                entry = self.entry(text, context, source)
            elif kind == "core" and of_core and (not is_one_word(text) or re.search("parameters|catalog", file.name)):
                entry = self.entry(text)
            elif kind == "tests":
                entry = self.entry_in_test(text, file)
            if entry:
                new = new[:start] + encoded(entry["new"]) + new[end:]
                if kind != "tests":
                    self.in_sources.add(id(entry))
            elif kind != "core" or of_core:
                self.doubt(file, source, start, repr(text))
        self.write(file, source, new)

    def script(self, file):
        source = file.read_text(encoding="utf-8")

        def replaced(found):
            entry = self.entry_in_test(found["text"], file)
            if found["text"] in self.entries and not entry:
                self.doubt(file, source, found.start(), repr(found["text"]))
            return found["quote"] + entry["new"] + found["quote"] if entry else found.group()

        pattern = r"(?P<quote>[\"'])(?P<text>(?:(?!(?P=quote))[^\n\\])+)(?P=quote)"
        self.write(file, source, re.sub(pattern, replaced, source))

    def page(self, file):
        """Names of the window between asterisks or backticks, alone or on a path such as *Edit › Undo*, and in cells."""
        names = {}
        for entry in self.table:
            old, new = (entry[key].replace("&", "") for key in ("old", "new"))
            names[old] = new
            names.setdefault(old.removesuffix("…"), new.removesuffix("…"))
        source = file.read_text(encoding="utf-8")

        def replaced(found):
            old = re.sub(r"\s+", " ", found["text"]).split(" › ")
            new = [names.get(name, name) if name[:1].isupper() or " " in name else name for name in old]
            short = any(map(is_one_word, set(old) & set(names)))
            if old == new or short and found["mark"] != "*":
                return found.group()
            if short:
                self.doubt(file, source, source.index(found.group()), f"{old} became {new}")
            return found["mark"] + " › ".join(new) + found["mark"]

        def cell(found):
            return found.group() if is_one_word(found.group()) else names.get(found.group(), found.group())

        new = re.sub(r"(?<=\| )[^|\n]+(?= \|)", cell, source)
        new = re.sub(r"(?P<mark>(?<!\*)\*{1,2}(?!\*)|(?<!`)`(?!`))(?P<text>(?:(?!(?P=mark)|\n\n).)+?)(?P=mark)",
                     replaced, new, flags=re.S)
        self.write(file, source, new)

    def remains(self, translations):
        """Places in which an old text, or an old translation, is a part of something longer."""
        old = {entry["old"] for entry in self.table if not is_one_word(entry["old"])}
        old |= {text for source, text in translations
                if plain(source) in self.entries and text.strip() and not is_one_word(text)}
        covers = {one: [entry["new"] for entry in self.table if one in entry["new"]] for one in old}
        files = [(file, self.texts(file)) for folder in ("ui", "app", "core", "tests") for file in self.files(folder, CPP)]
        files += [(file, re.sub(r"\s+", " ", file.read_text(encoding="utf-8")))
                  for file in [*self.files("tests", {".sh", ".py"}), *self.pages]]
        for file, text in files:
            for one in sorted(old):
                if one in text and text.count(one) > sum(text.count(new) for new in covers[one]):
                    yield f"{file.relative_to(self.root)}: {one!r}"

    def run(self):
        catalogs = sorted((self.root / "translations").glob("*.ts"))
        before = [pair for file in catalogs for pair in re.findall(
            r"<source>(.*?)</source>\s*<translation>([^<]+)<", file.read_text(encoding="utf-8"))]
        for file in catalogs:
            self.catalog(file)
        for folder, kind in (("ui", "ui"), ("app/dewpoint", "ui"), ("core", "core"), ("tests", "tests")):
            for file in self.files(folder, CPP):
                self.cpp(file, kind)
        for change, files in ((self.script, self.files("tests", {".sh", ".py"})), (self.page, self.pages)):
            for file in files:
                change(file)
        subprocess.run(["clang-format", "-i", *(file for file in self.changed if file.suffix in CPP)], check=True)
        for found, where in ((self.in_sources, "sources"), (self.in_catalogs, "catalogs")):
            yield from (f"not in the {where}: {one['old']!r}" for one in self.table if id(one) not in found)
        yield from (f"look at {place}" for place in self.doubts)
        yield from (f"old text remains: {place}" for place in self.remains(before))
        yield f"{len(self.table)} texts, {len(self.changed)} files changed"


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("table", type=pathlib.Path)
    arguments.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    options = arguments.parse_args()
    for line in Renamer(options.root, json.loads(options.table.read_text(encoding="utf-8"))).run():
        print(line)
