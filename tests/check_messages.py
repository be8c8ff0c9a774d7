"""The messages in doc/manual/troubleshooting.md are those of the program.

A message is put together from texts in the sources, with names, numbers and
other texts between them, for which the page writes `...`. What is between
these dots has to be in one of the texts; single words may be anything.
"""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "doc/manual/troubleshooting.md"


def texts_of_sources():
    """All string literals, neighbours joined as the compiler does."""
    literal = r'"((?:[^"\\\n]|\\.)*)"'
    texts = []
    for folder in ("source", "include"):
        for file in sorted((root / folder).rglob("*.[ch]*")):
            for found in re.finditer(rf"(?:{literal}\s*)+", file.read_text()):
                text = "".join(re.findall(literal, found.group()))
                texts.append(re.sub(r"\\(.)", r"\1", text))
    return "\n".join(texts)


def quoted_messages():
    """What stands between backticks in the first cells of tables."""
    for line in page.read_text().splitlines():
        if line.startswith("| "):
            first = re.split(r"(?<!\\) \| ", line[2:])[0].replace("\\|", "|")
            yield from re.findall(r"`([^`]+)`", first)


def is_known(message, texts):
    # An entry and what is wrong with it are two texts.
    parts = [part.strip(" .,:;\"'()=") for part in re.split(r"\.\.\.|: ", message)]
    return all(" " not in part or part in texts for part in parts)


def main():
    texts = texts_of_sources()
    messages = list(quoted_messages())
    unknown = [m for m in messages if not is_known(m, texts)]
    for message in unknown:
        print(f"{page.name}: no source has the message: {message}")
    if len(messages) < 50:
        print(f"{page.name}: only {len(messages)} messages were found.")
    return 1 if unknown or len(messages) < 50 else 0


sys.exit(main())
