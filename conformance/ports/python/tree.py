"""From text to a tree of objects and properties (specification 2.1 to 2.5). It cannot fail."""

from language import ENDS, OTHER_BLOCKS, SCENE_BLOCKS, SHAPES, WORDS

BLANKS = " \t\f"


class Line:
    """A line that says something: its word and its value with their places (line.word)."""

    __slots__ = ("number", "column", "word", "value", "value_column")

    def __init__(self, number, text):
        start = 0
        while start < len(text) and text[start] in BLANKS:
            start += 1
        stop = start
        while stop < len(text) and text[stop] not in BLANKS:
            stop += 1
        value = stop
        while value < len(text) and text[value] in BLANKS:
            value += 1
        self.number, self.column = number, start + 1
        self.word = text[start:stop]
        self.value, self.value_column = text[value:], value + 1

    @property
    def key(self):
        """The word in lower case (line.case)."""
        return self.word.lower()


class Property:
    def __init__(self, line):
        self.line, self.key = line, line.key


class Object:
    """An object; closed is None for a proper end, "missing", or the line of a misspelt end."""

    def __init__(self, line):
        self.line, self.key = line, line.key
        self.children = []
        self.closed = None


class StrayEnd:
    def __init__(self, line):
        self.line = line


class UnclosedComment:
    def __init__(self, line):
        self.line = line


def lines(text):
    """All lines of a text that are not empty (text.line-end, text.blank, line.empty)."""
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    for number, content in enumerate(text.split("\n"), 1):
        line = Line(number, content)
        if line.word:
            yield line


def statements(text):
    """The lines without comments; an unclosed comment comes last (comment.line,
    comment.block, comment.one-line, comment.unclosed)."""
    opened = None
    for line in lines(text):
        if opened is not None:
            if line.word == "*/":
                opened = None
        elif line.word == "/*" and "*/" not in line.value:
            opened = line
        elif line.word[0] not in "#/*-!@":
            yield line
    if opened is not None:
        yield UnclosedComment(opened)


def one_slip(word, other):
    """Whether a word becomes the other by one slip (tree.slip)."""
    if word == other:
        return False
    n, m = len(word), len(other)
    if n == m:
        wrong = [i for i in range(n) if word[i] != other[i]]
        return len(wrong) == 1 or (len(wrong) == 2 and wrong[1] == wrong[0] + 1
                                   and word[wrong[0]] == other[wrong[1]]
                                   and word[wrong[1]] == other[wrong[0]])
    if abs(n - m) != 1:
        return False
    longer, shorter = (word, other) if n > m else (other, word)
    return any(longer[:i] + longer[i + 1:] == shorter for i in range(len(longer)))


def read(text):
    """The children of a file (tree.file and what follows it)."""
    top, opened = [], []
    for line in statements(text):
        here = opened[-1].children if opened else top
        if isinstance(line, UnclosedComment):
            here.append(line)
            continue
        key, known, alone = line.key, line.key in WORDS, not line.value
        slip = not known and alone and (one_slip(key, "end") or one_slip(key, "fin"))
        if key in ENDS or slip:                            # tree.end, tree.slip.words
            if opened:
                opened.pop().closed = line if slip else None
            else:
                top.append(StrayEnd(line))
        elif key in SCENE_BLOCKS:                          # tree.scene-word
            for open_object in opened:
                open_object.closed = "missing"
            opened = [Object(line)]
            top.append(opened[0])
        elif key in SHAPES or key in OTHER_BLOCKS or (not known and alone):   # tree.opening
            opened.append(Object(line))
            here.append(opened[-1])
        else:                                              # tree.property
            here.append(Property(line))
    for open_object in opened:                             # tree.end-of-file
        open_object.closed = "missing"
    return top
