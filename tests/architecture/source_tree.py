"""The project as check_architecture.py sees it: which file includes what, and which folder links to which."""

import pathlib
import re

PROGRAMS = ("motion_server", "render_client", "experiment")
ROOTS = ("common", *PROGRAMS, "bench")
SUFFIXES = {".h", ".hpp", ".c", ".cpp"}

_INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
_BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_CMAKE_COMMENT = re.compile(r"#[^\n]*")
_MODULE = re.compile(r"\bcoherency_module\s*\(([^)]*)\)")
_LINK = re.compile(r"\btarget_link_libraries\s*\(([^)]*)\)")
_KEYWORDS = ("SOURCES", "LINKS", "PRIVATE_LINKS", "PUBLIC", "PRIVATE", "INTERFACE")


class Include:
    def __init__(self, file, line, quoted, target):
        self.file, self.line, self.quoted, self.target = file, line, quoted, target
        self.root = target.split("/")[0]
        self.where = f"{file}:{line}"


class Module:
    """One coherency_module() call: its folder, its name, and the names of the project's modules it links to."""

    def __init__(self, folder, name):
        self.folder, self.name, self.links, self.file = folder, name, set(), f"{folder}/CMakeLists.txt"


class SourceTree:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.includes = {}  # file -> [Include]
        self.modules = {}  # name -> Module
        for top in ROOTS:
            for path in sorted((self.root / top).rglob("*")):
                if path.suffix in SUFFIXES:
                    self._read_source(path)
                elif path.name == "CMakeLists.txt":
                    self._read_cmake(path)
        self._names = {module.folder: name for name, module in self.modules.items()}

    def _read_source(self, path):
        text = path.read_text(encoding="utf-8", errors="replace")
        text = _BLOCK_COMMENT.sub(lambda m: "\n" * m.group().count("\n"), text)
        file = path.relative_to(self.root).as_posix()
        self.includes[file] = [
            Include(file, text.count("\n", 0, m.start(2)) + 1, m.group(1) == '"', m.group(2))
            for m in _INCLUDE.finditer(text)
        ]

    def _read_cmake(self, path):
        text = _CMAKE_COMMENT.sub("", path.read_text(encoding="utf-8"))
        folder = path.parent.relative_to(self.root).as_posix()
        for call in _MODULE.finditer(text):
            name, *words = call.group(1).split()
            module = self.modules.setdefault(name, Module(folder, name))
            module.links |= self._linked(words)
        for call in _LINK.finditer(text):
            target, *words = call.group(1).split()
            name = target.removeprefix("coherency_")
            if name in self.modules:
                self.modules[name].links |= self._linked(words)

    @staticmethod
    def _linked(words):
        """Project modules among the arguments that follow a link keyword."""
        found, linking = set(), False
        for word in words:
            if word in _KEYWORDS:
                linking = word != "SOURCES"
            elif linking and word.startswith("coherency_") and word not in ("coherency_flags", "coherency_wire_proto"):
                found.add(word.removeprefix("coherency_"))
        return found

    def module_of(self, file):
        """Module that holds `file`: that of the nearest folder above it that has one; None if there is none."""
        for folder in pathlib.PurePosixPath(file).parents:
            if folder.as_posix() in self._names:
                return self._names[folder.as_posix()]
        return None

    def closure(self, name):
        """`name` and every module it reaches through links."""
        seen, waiting = set(), [name]
        while waiting:
            now = waiting.pop()
            if now not in seen:
                seen.add(now)
                waiting.extend(self.modules[now].links if now in self.modules else ())
        return seen

    def reachable_files(self, file):
        """`file` and every file of the project it includes, directly or not."""
        seen, waiting = set(), [file]
        while waiting:
            now = waiting.pop()
            if now in self.includes and now not in seen:
                seen.add(now)
                waiting.extend(include.target for include in self.includes[now])
        return seen

    def all_includes(self):
        return (include for includes in self.includes.values() for include in includes)
