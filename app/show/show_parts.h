#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "app/character/cast_files.h"
#include "app/character/load_options.h"
#include "app/show/figures/run_figures.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/show_view.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"
#include "engine/tracks/live/live_crowd.h"

namespace throng::app {

/// How characters are loaded in a run, and what came of it.
struct LoadedModels {
  LoadOptions options;                ///< of models that are dropped too
  std::string data;                   ///< the folder that --data names
  std::vector<std::string> left_out;  ///< of the files that were named or dropped
  std::deque<LoadedCast> ahead;       ///< loaded for the next requests that bring characters
};

/// What a show is made of. open_show() fills it.
struct ShowParts {
  ShowView view;
  LoadedModels models;
  std::unique_ptr<Painter> painter;
  std::unique_ptr<Stage> stage;           ///< goes before the painter, as it uses the painter's pages
  std::unique_ptr<Stage> replaced_stage;  ///< in this frame; null: none was
  std::unique_ptr<Stage> past_stage;      ///< replaced in the frame before
  std::unique_ptr<LiveCrowd> live;        ///< null: no rows come
  std::unique_ptr<Viewer> viewer;  ///< null: the crowd is shown; goes before the stage, as it uses the stage's slots
  RunFigures figures;
  Recorder recorder;
  Rewind rewind;
  bool keeps_moments = false;
};

/// Tells people in lines what they would not expect of the show (figures/notices.h); may be empty.
std::string notice_of(const ShowParts& show);

}  // namespace throng::app
