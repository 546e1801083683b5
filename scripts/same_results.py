"""Compares two folders of results for scripts/same-results.sh: same_results.py OLD NEW.

Every number of JSON and CSV files is compared bit for bit as float64, every other value as it is, and every
sample of EXR and PNG images. Entries of a list are paired by what they are about, not by their place.
Ends with 0 if all are the same, with 1 if not.
"""

import csv
import json
import re
import struct
import sys
import zlib
from collections import Counter
from itertools import accumulate
from pathlib import Path

# What is not compared, because it differs from run to run or from build to build by nature: patterns in
# "FILE: PATH OF THE VALUE", with the reason.
BY_NATURE = [
    (r"\b(phases_ms|frame_ms|time_source|slowed)\b", "times, and the clock that took them"),
    (r"^sweep-[^/]*: (pareto|fronts|equal_time|equal_error|floors|advice)\b", "conclusions from times"),
    (r": (interreflect\.)?command$|: invocation\b", "a command line names the program"),
    (r": interreflect\.commit$|\bmachines?\b", "the program's commit and versions, the machine's identity"),
]
# What was changed on purpose since the oldest build that is still compared (CHANGELOG.md), likewise. It is counted, and
# shown apart.
ON_PURPOSE = [
    (r"\bbytes\.own\b", "what methods prepare on the CPU has fewer wrappers"),
    (r"^verify\.json: .*\bcases$", "rules are tried in more scenes"),
    (r"^verify\.json: (summary|counts|failed|passed)", "there are other checks"),
    (
        r"^verify\.json: checks\[.*, (unprepared|shaders_valid|\w+_parity|at_points)\]",
        "checks that are new, or that the compiler makes now",
    ),
    (r"^list\.json: .*\[reference\.offset\]", "a setting that is new"),
]
# Files that are not compared: pages, which are made of the values; journals and traced references, whose
# keys are digests of the program; standard error.
NO_RESULTS = {".html", ".jsonl", ".bin", ".err"}
# In names of a sweep's images: digits of a digest of the program.
PROGRAM = re.compile(r"-[0-9a-f]{6}(?=(\.error)?\.(exr|png)$)")
# Sentences for people: another build may say the same in other words. What differs is listed apart.
SENTENCES = set(
    "doc domain model needs note own_model_missing reference skipped source summary title truth_missing".split()
)
# Names and words of the JSON that changed between builds: old, new.
RENAMED = {
    "records": "runs",
    "conclusive": "above_noise",
    "not_applicable": "unclaimed_falsified",
}
# What an entry of a list is about.
IDENTITY = "scene quantity estimator fidelity params settings backend check id name".split()
# How many differences of a command are shown.
SHOWN = 10


def leaves(value, path=""):
    """(path, value) of everything that is neither an object nor a list, or is empty."""
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            name = RENAMED.get(key, key)
            yield from leaves(inner, f"{path}.{name}" if path else name)
    elif isinstance(value, list) and value:
        seen = Counter()
        for inner in value:
            label = about(inner)
            place = label if label and not seen[label] else f"{label}#{seen[label]}"
            seen[label] += 1
            yield from leaves(inner, f"{path}[{place}]")
    else:
        yield path, canonical(value)


def about(entry):
    """What tells an entry from the others of its list, if it is an object that says so."""
    if not isinstance(entry, dict):
        return ""

    def words(value):
        if isinstance(value, dict):
            return " ".join(f"{key}={canonical(value[key])}" for key in value)
        return RENAMED.get(value, value) if isinstance(value, str) else json.dumps(value)

    # A scene's list of settings describes them; it does not tell the scene from others.
    named = [key for key in IDENTITY if entry.get(key) and not isinstance(entry[key], list)]
    return ", ".join(words(entry[key]) for key in named)


def canonical(value):
    """A value as text that no other value has. Numbers are float64 by their shortest digits: 1 is 1.0."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return repr(float(value)) if float(value) == value else repr(value)
    if isinstance(value, str):
        value = PROGRAM.sub("", RENAMED.get(value, value))
    return json.dumps(value)


def json_values(data):
    text = data.decode()
    return leaves(json.loads(text) if text.strip() else None)


def csv_values(data):
    """(path, value) of a table whose first line names its columns; empty fields are left out."""

    def field(text):
        try:
            return json.loads(text)
        except ValueError:
            return text

    rows = csv.DictReader(data.decode().splitlines())
    return leaves([{name: field(text) for name, text in row.items() if text} for row in rows])


def exr_values(data):
    """(path, value) of an OpenEXR file of float32 scan lines, plain or packed by ZIP: texts of its header, and
    the bytes of each channel and line."""
    at, header = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)
        (size,) = struct.unpack_from("<i", rest)
        header[name] = rest[4 : 4 + size]
        if kind == b"string":
            yield name.decode(), canonical(header[name].decode("latin-1"))
        at = len(data) - len(rest) + 4 + size
    channels = re.findall(rb"([^\0]+)\0.{16}", header[b"channels"], flags=re.S)
    x0, y0, x1, y1 = struct.unpack("<4i", header[b"dataWindow"])
    row, lines = 4 * (x1 - x0 + 1), {0: 1, 2: 1, 3: 16}[header[b"compression"][0]]
    blocks = -(-(y1 - y0 + 1) // lines)
    for (offset,) in struct.iter_unpack("<Q", data[at + 1 : at + 1 + 8 * blocks]):
        y, size = struct.unpack_from("<2i", data, offset)
        samples = data[offset + 8 : offset + 8 + size]
        if size < row * len(channels) * min(lines, y1 - y + 1):
            # Packed are differences of bytes, the even bytes before the odd ones.
            halves = bytes(accumulate(zlib.decompress(samples), lambda a, b: (a + b - 128) & 255))
            odd = (len(halves) + 1) // 2
            samples = bytearray(len(halves))
            samples[0::2], samples[1::2] = halves[:odd], halves[odd:]
        for i in range(len(samples) // row):
            line, channel = divmod(i, len(channels))
            yield f"{channels[channel].decode()}[line {y + line}]", bytes(samples[row * i : row * (i + 1)])


def png_values(data):
    """(path, value) of a PNG file of 8 bits a channel, not interlaced: its header, and its pixels. Encoders are free in
    how they filter lines: that is undone."""
    at, packed, header = 8, b"", b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            header = data[at + 8 : at + 8 + size]
            yield "header", header
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += 12 + size
    width, height, depth, kind, _, _, interlaced = struct.unpack(">2I5B", header)
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(kind)
    if depth != 8 or interlaced or channels is None:
        raise ValueError(f"a PNG file of {depth} bits a channel, kind {kind}")
    yield "pixels", unfiltered(zlib.decompress(packed), height, width * channels, channels)


def unfiltered(data, height, row, channels):
    """The lines of a PNG image without their filters (PNG specification, section 9)."""
    pixels, above = b"", bytes(row)
    for y in range(height):
        kind, *line = data[y * (row + 1) : (y + 1) * (row + 1)]
        for x, up in enumerate(above):
            left, corner = (line[x - channels], above[x - channels]) if x >= channels else (0, 0)
            line[x] = (line[x] + predicted(kind, left, up, corner)) & 255
        above = bytes(line)
        pixels += above
    return pixels


def predicted(kind, left, up, corner):
    """What a PNG filter expects of a byte from its neighbours."""
    if kind == 4:
        by = left + up - corner
        return min((left, up, corner), key=lambda near: abs(by - near))
    return (0, left, up, (left + up) // 2)[kind]


READERS = {".json": json_values, ".csv": csv_values, ".exr": exr_values, ".png": png_values}


def files(folder):
    """The files with results, by their names without the program's digest."""
    found = (f for f in sorted(folder.rglob("*")) if f.is_file() and f.suffix not in NO_RESULTS)
    return {PROGRAM.sub("", str(f.relative_to(folder))): f for f in found}


def values(file):
    """The values of a file by their paths; none if there is no file."""
    if file is None:
        return {}
    try:
        return dict(READERS[file.suffix](file.read_bytes()))
    except (ValueError, struct.error, zlib.error) as why:
        return {"": f"unreadable: {why}"}


class Command:
    """What was compared of one command's results."""

    def __init__(self):
        self.same, self.not_compared = 0, 0
        self.different, self.on_purpose, self.reworded = [], [], []

    def compare(self, name, old, new):
        for path in dict.fromkeys([*old, *new]):
            place = f"{name}: {path}"
            was, now = old.get(path, "nothing"), new.get(path, "nothing")
            if any(re.search(pattern, place) for pattern, _ in BY_NATURE):
                self.not_compared += 1
            elif was == now:
                self.same += len(was) // 4 if isinstance(was, bytes) else 1
            elif any(re.search(pattern, place) for pattern, _ in ON_PURPOSE):
                self.on_purpose.append((place, was, now))
            elif path.rsplit(".")[-1] in SENTENCES:
                self.reworded.append((place, was, now))
            else:
                self.different.append((place, was, now))

    def report(self, name):
        print(
            f"{name}: {self.same} values are the same, {len(self.different)} differ"
            f" ({self.not_compared} not compared by nature, {len(self.on_purpose)} changed on purpose,"
            f" {len(self.reworded)} sentences in other words)"
        )
        differences = (("differs", self.different), ("on purpose", self.on_purpose), ("other words", self.reworded))
        for word, found in differences:
            for place, was, now in found[:SHOWN]:
                print(f"  {word}: {place}\n    old: {shown(was)}\n    new: {shown(now)}")


def shown(value):
    if isinstance(value, str):
        return value
    return f"{len(value)} bytes, {value[:16].hex(' ', 4)} …"


def main(old, new):
    old, new = files(Path(old)), files(Path(new))
    commands = {}
    for name in sorted({*old, *new}):
        command = commands.setdefault(re.split(r"[/.]", name)[0], Command())
        command.compare(name, values(old.get(name)), values(new.get(name)))
    for name, command in commands.items():
        command.report(name)
    same = sum(c.same for c in commands.values())
    different = sum(len(c.different) for c in commands.values())
    on_purpose = sum(len(c.on_purpose) for c in commands.values())
    print(f"{len(commands)} commands: {same} values are the same, {different} differ, {on_purpose} changed on purpose")
    return 1 if different or not same else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
