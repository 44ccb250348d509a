#ifndef THRONG_C_H
#define THRONG_C_H

/* The library for C, and for languages that call C. It does what the C++ headers say; they explain the words.
 *
 * A function that makes something returns null, THRONG_NONE or an invalid id if it fails. A function that changes or
 * writes something returns 0, or 1 if it fails. A function that answers yes or no returns 1 or 0. throng_last_error()
 * says why a call failed, also after a misuse. A function that lists things writes up to `most` of them, and returns
 * how many there are. Strings are UTF-8. Times are seconds. Vectors are three floats, rotations four: x, y, z, w.
 * No function keeps a pointer after the call, unless its comment says so.
 *
 * Functions, structs and their layouts, names and meanings hold for all versions 1.x. A struct that begins with `size`
 * may get more members at its end: it begins as throng_NAME_default() returns it, and a program that was compiled
 * before has the defaults for what it does not know. Other structs never change, unless their comment says so. */

#include "throng/c/base.h"
#include "throng/c/builder.h"
#include "throng/c/channels.h"
#include "throng/c/characters.h"
#include "throng/c/crowds.h"
#include "throng/c/files.h"
#include "throng/c/host.h"
#include "throng/c/lod.h"
#include "throng/c/many.h"
#include "throng/c/processes.h"

#endif
