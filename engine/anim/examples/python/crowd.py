"""A thousand agents from Python: loads a model, plays it, and reads palettes into numpy.

    python3 crowd.py libthrong_c.so MODEL
"""
import ctypes
import sys

import numpy

NONE = 0xFFFFFFFF


class Id(ctypes.Structure):
    _fields_ = [("number", ctypes.c_uint32), ("generation", ctypes.c_uint32)]


class Play(ctypes.Structure):
    _fields_ = [("size", ctypes.c_uint32), ("clip", ctypes.c_uint32), ("fade", ctypes.c_float),
                ("speed", ctypes.c_float), ("start", ctypes.c_float), ("loop", ctypes.c_uint32),
                ("mask", ctypes.c_uint32), ("absolute_root", ctypes.c_void_p)]


class CrowdOptions(ctypes.Structure):
    _fields_ = [("size", ctypes.c_uint32), ("pus", ctypes.c_uint32), ("palettes", ctypes.c_uint32),
                ("hash", ctypes.c_uint32), ("trace", ctypes.c_uint32), ("local_store_bytes", ctypes.c_uint64),
                ("executor", ctypes.c_void_p), ("executor_user", ctypes.c_void_p)]


def open_library(path):
    """Tells ctypes what the functions that are used below take and return."""
    library = ctypes.CDLL(path)
    pointer, number, text = ctypes.c_void_p, ctypes.c_uint32, ctypes.c_char_p
    for name, result, arguments in [
            ("version_text", text, []),
            ("last_error", text, []),
            ("load", pointer, [text, ctypes.c_double]),
            ("file_character", pointer, [pointer, number]),
            ("file_free", None, [pointer]),
            ("character_free", None, [pointer]),
            ("character_clip_count", number, [pointer]),
            ("character_palette_entries", number, [pointer, number]),
            ("crowd_options_fill", ctypes.c_int, [ctypes.POINTER(CrowdOptions), ctypes.c_size_t]),
            ("crowd_create", pointer, [pointer, ctypes.POINTER(CrowdOptions)]),
            ("crowd_free", None, [pointer]),
            ("crowd_palette_bytes", number, [pointer, Id]),
            ("crowd_add_agents", ctypes.c_int, [pointer, Id, number, ctypes.POINTER(Id)]),
            ("crowd_advance", ctypes.c_int, [pointer, ctypes.c_double]),
            ("crowd_update_all", ctypes.c_int, [pointer, pointer, ctypes.c_size_t, number]),
            ("play_fill", ctypes.c_int, [ctypes.POINTER(Play), ctypes.c_size_t]),
            ("agent_play", ctypes.c_int, [pointer, Id, ctypes.POINTER(Play)])]:
        function = getattr(library, "throng_" + name)
        function.restype, function.argtypes = result, arguments
    return library


def checked(library, ok):
    if not ok:
        sys.exit(library.throng_last_error().decode())
    return ok


def main():
    library = open_library(sys.argv[1])
    file = checked(library, library.throng_load(sys.argv[2].encode(), 0.0))
    character = checked(library, library.throng_file_character(file, 0))
    options = CrowdOptions()
    library.throng_crowd_options_fill(options, ctypes.sizeof(options))  # the defaults
    options.pus = 2
    crowd = checked(library, library.throng_crowd_create(character, options))

    agents = (Id * 1000)()
    first = Id(0, NONE)  # whichever character has number 0
    checked(library, library.throng_crowd_add_agents(crowd, first, len(agents), agents) == 0)
    play = Play()
    library.throng_play_fill(play, ctypes.sizeof(play))
    for number, agent in enumerate(agents):
        play.clip = number % library.throng_character_clip_count(character)
        checked(library, library.throng_agent_play(crowd, agent, play) == 0)

    stride = library.throng_crowd_palette_bytes(crowd, first)
    memory = numpy.zeros(len(agents) * stride + 64, dtype=numpy.uint8)
    memory = memory[-memory.ctypes.data % 64:][:len(agents) * stride]  # palettes lie on cache lines
    for _ in range(60):
        library.throng_crowd_advance(crowd, 1.0 / 60.0)
        checked(library, library.throng_crowd_update_all(crowd, memory.ctypes.data, memory.nbytes, stride) == 0)

    entries = library.throng_character_palette_entries(character, 0)
    palettes = memory.reshape(len(agents), stride)[:, :entries * 48].view(numpy.float32).reshape(-1, entries, 3, 4)
    print("throng", library.throng_version_text().decode(), "wrote palettes", palettes.shape,
          "whose rotations have determinant %.4f" % numpy.linalg.det(palettes[..., :3]).mean())
    library.throng_crowd_free(crowd)
    library.throng_character_free(character)
    library.throng_file_free(file)


main()
