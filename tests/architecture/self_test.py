"""A small project that keeps every rule, and one violation of each; check_architecture.py --self-test runs it."""

import pathlib
import tempfile

MODULES = {
    "common/math": ("math", ""),
    "common/scene": ("scene", "coherency_math"),
    "common/motion": ("motion", "coherency_math"),
    "common/sync": ("sync", "coherency_math"),
    "common/body": ("body", "coherency_math coherency_motion coherency_scene"),
    "common/world": ("world", "coherency_body"),
    "common/wire": ("wire", "coherency_motion coherency_world"),
    "common/config": ("config", "coherency_world coherency_sync"),
    "motion_server/device": ("server_device", "coherency_motion"),
    "motion_server/sampling": ("server_sampling", "coherency_server_device"),
    "motion_server/authority": ("server_authority", "coherency_world"),
    "motion_server/broadcast": ("server_broadcast", "coherency_wire"),
    "motion_server": ("server", "coherency_server_device coherency_server_broadcast"),
    "render_client/receive": ("client_receive", "coherency_wire"),
    "render_client/replica": ("client_replica", "coherency_client_receive"),
    "render_client/compile": ("client_compile", "coherency_scene"),
    "render_client/cull": ("client_cull", "coherency_client_compile"),
    "render_client/draw": ("client_draw", "coherency_client_cull"),
    "render_client/present": ("client_present", "coherency_client_draw"),
    "experiment": ("experiment", "coherency_world"),
}

GOOD = {
    "common/math/A.cpp": '#include "common/math/A.h"\n#include <cmath>\n#include <glm/vec3.hpp>\n',
    "common/world/A.cpp": '#include "common/world/A.h"\n#include "common/math/A.h"\n',
    "common/wire/A.cpp": '#include "coherency.pb.h"\n#include <google/protobuf/arena.h>\n',
    "common/wire/Key.cpp": "#include <sodium.h>\n",
    "common/config/KeyFile.cpp": "#include <sodium.h>\n",
    "motion_server/device/Usb.cpp": "#include <libusb.h>\n",
    "motion_server/broadcast/A.cpp": "#include <boost/asio/io_context.hpp>\n",
    "motion_server/main.cpp": '#include "motion_server/broadcast/A.h"\n#include "motion_server/device/A.h"\n',
    "render_client/draw/A.cpp": '#include "render_client/draw/Gl.h"\n#include "render_client/cull/A.h"\n',
    "render_client/draw/Gl.h": "#include <epoxy/gl.h>\n",
    "render_client/present/A.cpp": "#include <epoxy/egl.h>\n#include <epoxy/gl.h>\n#include <GLFW/glfw3.h>\n",
    "bench/A.cpp": '#include "motion_server/device/A.h"\n#include "render_client/replica/A.h"\n'
    '/* #include "render_client/draw/Gl.h" */\n// #include <libusb.h>\n',
    "bench/peers/A.cpp": "#include <epoxy/egl.h>\n#include <epoxy/gl.h>\n",
}

PROTOBUF_RULE = "only in common/wire/*.cpp"
SODIUM_RULE = "only in common/wire/*.cpp and common/config/KeyFile.cpp"
ASIO_RULE = "only in .cpp files"
GL_RULE = "GL only under"
WINDOW_RULE = "only in render_client/present/*.cpp"
MATH_RULE = "only glm and std"
FLOW_RULE = "not before it in the flow"

# (file, text put into it, what the checker must say of it)
BAD_INCLUDES = [
    ("common/math/B.cpp", '#include "common/scene/A.h"', "math does not link to scene"),
    ("common/scene/B.h", '#include "common/motion/A.h"', "scene does not link to motion"),
    ("common/sync/B.h", "#include <common/motion/A.h>", "sync does not link to motion"),
    ("common/body/B.cpp", '  #  include "common/world/A.h"', "body does not link to world"),
    ("common/wire/B.cpp", '#include "common/sync/A.h"', "wire does not link to sync"),
    ("common/config/B.cpp", '#include "common/wire/A.h"', "config does not link to wire"),
    ("common/body/B.cpp", '#include "../world/A.h"', "not a path from the root"),
    ("common/body/B.cpp", '#include "A.h"', "not a path from the root"),
    ("common/body/B.cpp", '#include "common/math/Gone.h"', "does not exist"),
    ("common/stray/B.cpp", '#include "common/math/A.h"', "belongs to no module"),
    ("common/wire/B.cpp", '#include "motion_server/device/A.h"', "common may not include motion_server"),
    ("motion_server/B.cpp", '#include "render_client/receive/A.h"', "motion_server may not include render_client"),
    ("render_client/draw/B.cpp", '#include "motion_server/device/A.h"', "render_client may not include motion_server"),
    ("experiment/B.cpp", '#include "render_client/draw/A.h"', "experiment may not include render_client"),
    ("motion_server/B.cpp", '#include "experiment/A.h"', "motion_server may not include experiment"),
    ("motion_server/device/B.cpp", '#include "motion_server/sampling/A.h"', FLOW_RULE),
    ("motion_server/authority/B.cpp", '#include "motion_server/broadcast/A.h"', FLOW_RULE),
    ("motion_server/device/B.cpp", '#include "motion_server/A.h"', FLOW_RULE),
    ("render_client/receive/B.h", '#include "render_client/replica/A.h"', FLOW_RULE),
    ("render_client/compile/B.cpp", '#include "render_client/cull/A.h"', FLOW_RULE),
    ("render_client/draw/B.cpp", '#include "render_client/present/A.h"', FLOW_RULE),
    ("render_client/odd/B.cpp", '#include "render_client/draw/A.h"', "has no place in the flow"),
    ("motion_server/broadcast/B.cpp", '#include "motion_server/device/A.h"', "does not link to server_device"),
    ("common/wire/B.h", '#include "coherency.pb.h"', PROTOBUF_RULE),
    ("common/world/B.cpp", '#include "coherency.pb.h"', PROTOBUF_RULE),
    ("motion_server/broadcast/B.cpp", '#include "proto/coherency.pb.h"', PROTOBUF_RULE),
    ("render_client/receive/B.cpp", "#include <google/protobuf/message_lite.h>", PROTOBUF_RULE),
    ("common/wire/B.h", "#include <sodium.h>", SODIUM_RULE),
    ("common/config/KeyFile.h", "#include <sodium.h>", SODIUM_RULE),
    ("common/config/B.cpp", "#include <sodium/crypto_auth.h>", SODIUM_RULE),
    ("motion_server/broadcast/B.cpp", "#include <sodium.h>", SODIUM_RULE),
    ("render_client/B.cpp", '#include "sodium.h"', SODIUM_RULE),
    ("bench/B.cpp", "#include <sodium.h>", SODIUM_RULE),
    ("common/wire/B.h", "#include <boost/asio.hpp>", ASIO_RULE),
    ("render_client/receive/B.h", "#include <boost/asio/ip/udp.hpp>", ASIO_RULE),
    ("motion_server/device/B.cpp", "#include <libusb-1.0/libusb.h>", "libusb in more than one file"),
    ("motion_server/sampling/B.cpp", "#include <libusb.h>", "libusb only under motion_server/device"),
    ("render_client/replica/B.cpp", "#include <epoxy/gl.h>", GL_RULE),
    ("common/scene/B.cpp", "#include <GL/gl.h>", GL_RULE),
    ("render_client/B.cpp", '#include "render_client/draw/Gl.h"', GL_RULE),
    ("bench/B.cpp", "#include <epoxy/gl.h>", GL_RULE),
    ("render_client/draw/B.cpp", "#include <epoxy/egl.h>", WINDOW_RULE),
    ("render_client/draw/B.cpp", "#include <GLFW/glfw3.h>", WINDOW_RULE),
    ("render_client/present/B.h", "#include <GLFW/glfw3.h>", WINDOW_RULE),
    ("motion_server/B.cpp", "#include <EGL/egl.h>", WINDOW_RULE),
    ("bench/B.cpp", "#include <epoxy/egl.h>", WINDOW_RULE),
    ("bench/peers/B.h", "#include <epoxy/egl.h>", WINDOW_RULE),
    ("common/math/B.cpp", "#include <boost/math/constants/constants.hpp>", MATH_RULE),
    ("common/math/B.cpp", "#include <unistd.h>", MATH_RULE),
    ("common/math/B.cpp", '/* why\n */\n#include <fmt/format.h>', "common/math/B.cpp:3: common/math includes only"),
]


def module_text(name, links):
    return f"# coherency_module(comment LINKS coherency_wire)\ncoherency_module({name} SOURCES A.cpp\n  LINKS {links})\n"


# (CMakeLists.txt, its text, what the checker must say)
BAD_LINKS = [
    ("common/scene", module_text("scene", "coherency_math coherency_motion"), "scene may not link to motion"),
    ("common/math", module_text("math", "coherency_scene"), "math and scene link to each other in a circle"),
    ("common/sync", module_text("sync", "coherency_world"), "sync may not link to world"),
    ("common/config", module_text("config", "coherency_wire"), "config may not link to wire"),
    ("common/wire", module_text("wire", "coherency_world coherency_config"), "wire may not link to config"),
    ("common/body", "coherency_module(body SOURCES A.cpp PRIVATE_LINKS coherency_sync)", "body may not link to sync"),
    (
        "common/motion",
        module_text("motion", "coherency_math") + "target_link_libraries(coherency_motion PRIVATE coherency_scene)",
        "motion may not link to scene",
    ),
    ("common/extra", module_text("extra", "coherency_math"), "has no place in the DAG"),
    ("common/extra", module_text("world_too", "coherency_math"), "must be named extra"),
    ("common/world", module_text("world", "coherency_bodie"), "bodie, which is no module"),
    ("common/world", module_text("world", "coherency_client_draw"), "common may not link to render_client"),
    ("motion_server/device", module_text("server_device", "coherency_server_authority"), FLOW_RULE),
    ("motion_server/broadcast", module_text("server_broadcast", "coherency_client_receive"), "may not link to render"),
]


def write(root, file, text):
    path = pathlib.Path(root) / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text + "\n", encoding="utf-8")


def build_good(root):
    for folder, (name, links) in MODULES.items():
        write(root, f"{folder}/CMakeLists.txt", module_text(name, links))
        write(root, f"{folder}/A.h", "#pragma once\n#include <vector>")
    for file, text in GOOD.items():
        write(root, file, text)


def failures_of(violations, file, text, expected):
    with tempfile.TemporaryDirectory() as root:
        build_good(root)
        write(root, file, text)
        found = violations(root)
    if any(expected in line for line in found):
        return []
    return [f"{file} with {text!r}: expected '{expected}', got {found}"]


def run(violations):
    failures = []
    with tempfile.TemporaryDirectory() as root:
        if not violations(root):
            failures.append("an empty folder passes")
        build_good(root)
        failures += [f"the good project is refused: {line}" for line in violations(root)]
    cases = BAD_INCLUDES + [(f"{folder}/CMakeLists.txt", text, expected) for folder, text, expected in BAD_LINKS]
    for file, text, expected in cases:
        failures += failures_of(violations, file, text, expected)
    for failure in failures:
        print(failure)
    print(f"self-test: {len(cases)} violations, {len(failures)} failure(s)")
    return 1 if failures else 0
