#!/usr/bin/env python3
"""Checks that the project keeps its module DAG and its fences (docs/architecture.md).

usage: check_architecture.py ROOT         check the project in ROOT; exit 1 and one line for each violation
       check_architecture.py --self-test  build a small project with each violation in turn; each must be caught
"""

import pathlib
import re
import sys

from source_tree import PROGRAMS, ROOTS, SourceTree

# Which modules of common/ each may link to.
ARROWS = {
    "math": set(),
    "scene": {"math"},
    "motion": {"math"},
    "sync": {"math"},
    "body": {"math", "motion", "scene"},
    "objects": {"body", "math", "scene"},
    "world": {"body", "math", "motion", "objects", "scene"},
    "wire": {"body", "math", "motion", "sync", "world"},
    "config": {"body", "math", "motion", "scene", "sync", "world"},
}

# Folders of a program in the order of the data; each may include those before it.
FLOWS = {
    "motion_server": ["device", "sampling", "authority", "broadcast"],
    "render_client": ["receive", "replica", "compile", "cull", "draw", "present"],
}

# Peers draw by themselves, to be measured against the render client.
PEERS = "bench/peers/"
GL_FOLDERS = ("render_client/draw/", "render_client/compile/", "render_client/present/", PEERS)
PROTOBUF = re.compile(r"\.pb\.h$|^google/protobuf/")
ASIO = re.compile(r"^boost/asio")
SODIUM = re.compile(r"^sodium(\.h$|/)")
SODIUM_FOR_KEY_FILES = "common/config/KeyFile.cpp"
LIBUSB = re.compile(r"^(libusb-1\.0/)?libusb\.h$")
GL = re.compile(r"^(epoxy/gl(x)?\.h|GL/|GLES\d?/|glad/)")
WINDOWS = re.compile(r"^(epoxy/egl\.h|EGL/|GLFW/)")
STANDARD = re.compile(r"^[a-z_0-9]+$")  # the C++ headers: no folder, no suffix


def folder_in_program(file):
    """(program, folder) of a file or an include; folder is None for the program's own root."""
    parts = file.split("/")
    return parts[0], parts[1] if len(parts) > 2 else None


def check_links(tree):
    for name, module in tree.modules.items():
        if module.folder.startswith("common/"):
            folder = module.folder.removeprefix("common/")
            if name != folder:
                yield f"{module.file}: module {name} must be named {folder}, as its folder"
            elif folder not in ARROWS:
                yield f"{module.file}: common/{folder} has no place in the DAG"
            for link in sorted(module.links - ARROWS.get(folder, set())):
                yield f"{module.file}: {name} may not link to {link}"
        for link in sorted(module.links):
            if link not in tree.modules:
                yield f"{module.file}: {name} links to {link}, which is no module"
            elif name in tree.closure(link):
                yield f"{module.file}: {name} and {link} link to each other in a circle"
            else:
                yield from check_step(module.file, module.folder + "/x", tree.modules[link].folder + "/x", "link to")


def check_step(where, source, target, verb):
    """Whether a file in `source` may include or link to one in `target`, by the programs' walls and flows."""
    program, folder = folder_in_program(source)
    other, other_folder = folder_in_program(target)
    if other in PROGRAMS and program in ("common", *PROGRAMS) and program != other:
        yield f"{where}: {program} may not {verb} {other} ({target})"
    if program == other and program in FLOWS and folder != other_folder and folder is not None:
        flow = FLOWS[program]
        if folder not in flow:
            yield f"{where}: {program}/{folder} has no place in the flow {' -> '.join(flow)}"
        elif other_folder not in flow[: flow.index(folder)]:
            yield f"{where}: {program}/{folder} may not {verb} {other_folder or program}, which is not before it in the flow"


def check_includes(tree):
    for include in tree.all_includes():
        if include.root not in ROOTS:
            if include.quoted and not PROTOBUF.search(include.target):
                yield f'{include.where}: "{include.target}" is not a path from the root of the repository'
            continue
        yield from check_step(include.where, include.file, include.target, "include")
        module = tree.module_of(include.file)
        other = tree.module_of(include.target)
        if include.file not in tree.includes or include.target not in tree.includes:
            yield f"{include.where}: {include.target} does not exist"
        elif module is not None and other not in tree.closure(module):
            yield f"{include.where}: includes {include.target}, but {module} does not link to {other}"
        elif module is None and include.file.startswith("common/"):
            yield f"{include.where}: belongs to no module"


def check_fences(tree):
    libusb_files = set()
    for include in tree.all_includes():
        file, target, where = include.file, include.target, include.where
        source = file.endswith((".cpp", ".c"))
        if PROTOBUF.search(target) and not (source and file.startswith("common/wire/")):
            yield f"{where}: protobuf ({target}) only in common/wire/*.cpp"
        if ASIO.search(target) and not source:
            yield f"{where}: Asio ({target}) only in .cpp files"
        if SODIUM.search(target) and not (source and file.startswith("common/wire/")) and file != SODIUM_FOR_KEY_FILES:
            yield f"{where}: libsodium ({target}) only in common/wire/*.cpp and {SODIUM_FOR_KEY_FILES}"
        if LIBUSB.search(target):
            libusb_files.add(file)
            if not file.startswith("motion_server/device/"):
                yield f"{where}: libusb only under motion_server/device"
        if WINDOWS.search(target) and not (source and file.startswith(("render_client/present/", PEERS))):
            yield f"{where}: EGL and GLFW ({target}) only in render_client/present/*.cpp and {PEERS}*.cpp"
        if file.startswith("common/math/") and not (
            target.startswith(("glm/", "common/math/")) or (not include.quoted and STANDARD.search(target))
        ):
            yield f"{where}: common/math includes only glm and std, not {target}"
    if len(libusb_files) > 1:
        yield f"libusb in more than one file: {', '.join(sorted(libusb_files))}"


def check_gl(tree):
    """GL stays under its folders, and does not leak out of them through a header either."""
    speaks_gl = {include.file for include in tree.all_includes() if GL.search(include.target)}
    for file in tree.includes:
        if not file.startswith(GL_FOLDERS):
            for source in sorted(tree.reachable_files(file) & speaks_gl):
                by = "" if source == file else f", which reaches {file} through {source}"
                yield f"{file}: GL only under {', '.join(GL_FOLDERS)}{by}"


def violations(root):
    tree = SourceTree(root)
    if not tree.includes or not tree.modules:
        return [f"{root}: no sources found; is this the root of the project?"]
    found = []
    for check in (check_links, check_includes, check_fences, check_gl):
        found.extend(check(tree))
    return sorted(set(found))


def main(arguments):
    if arguments == ["--self-test"]:
        import self_test

        return self_test.run(violations)
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    found = violations(pathlib.Path(arguments[0]))
    for line in found:
        print(line)
    print(f"architecture: {len(found)} violation(s)")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
