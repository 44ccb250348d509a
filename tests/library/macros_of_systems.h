#pragma once

// Macros that headers of systems define, which a host includes before ours.

#include <cstddef>  // of the standard library something has come before: its first header takes away min and max

#include <EGL/egl.h>
#include <GL/glx.h>
#include <X11/X.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

// Those of windows.h without NOMINMAX that are words.
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define far
#define near
#define cdecl
#define pascal
#define hyper long long
#define small char
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define CALLBACK
#define CONST const
#define STRICT 1
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define NO_ERROR 0
#define DELETE (0x00010000L)
#define ABSOLUTE 1
#define RELATIVE 2
#define DIFFERENCE 11
#define OPAQUE 2
#define TRANSPARENT 1
#define AddJob AddJobA
#define CopyFile CopyFileA
#define CreateWindow CreateWindowA
#define DrawText DrawTextA
#define GetCurrentTime() GetTickCount()
#define GetJob GetJobA
#define GetMessage GetMessageA
#define GetObject GetObjectA
#define LoadImage LoadImageA
#define PlaySound PlaySoundA
#define SendMessage SendMessageA
#define Yield()
