#pragma once

/// Throng: thousands of skinned characters, each in a pose of its own. This is all that a game includes for
/// poses; to draw them with throng::crowd and throng::render it includes crowd_view.h, drawing.h and render/renderer.h.
///
///     auto file = throng::load("man.glb");                           a character, with its clips
///     auto crowd = throng::Crowd::create(file->characters.front());  thousands of agents that play it
///     throng::AgentId id = crowd->add_agent();
///     crowd->agent(id).play({.clip = man.find_clip("walk")});
///     crowd->advance(16ms);                                          the clock
///     crowd->update(requests);                                       poses, written where the requests say
///
/// A call that can fail although its caller made no mistake returns a Result with a sentence. A misuse is reported
/// (host.h) and ignored. Nothing is thrown. From version 1.0 on, what these headers say stays true within a major
/// version.

#include "throng/agent.h"
#include "throng/channels.h"
#include "throng/character.h"
#include "throng/character_builder.h"
#include "throng/crowd.h"
#include "throng/debug.h"
#include "throng/host.h"
#include "throng/ids.h"
#include "throng/lod.h"
#include "throng/many.h"
#include "throng/math.h"
#include "throng/processes.h"
#include "throng/result.h"
#include "throng/state_machine.h"
#include "throng/ticks.h"
#include "throng/version.h"
