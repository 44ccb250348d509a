#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/show/show.h"
#include "tests/soak/command_lines.h"
#include "tests/soak/growth.h"
#include "tests/soak/round.h"

namespace throng::soak {

/// Rounds with one show that lives as long as the soak: a person's acts at random while it records, then the recording
/// repeated by another show. After each round it rests with the crowd that it began with, and takes as much as before.
class ShowRounds {
 public:
  /// `context` draws the show; ContextKind::none draws nothing.
  ShowRounds(const Models& models, app::ContextKind context) : models_(&models), context_(context) {}

  /// Makes the show, if there is none yet. Shows of one process are made before any of them is measured.
  Fault open();
  /// Makes another show in the place of the one that there is.
  Fault renew();
  Fault run(const RoundPlace& place);

  /// Says what this process has beside the show.
  struct Others {
    int open_files = 0;
    bool draw = false;  ///< the software renderer is there, which keeps what it compiled
  };
  /// Adds what this process takes now, while its shows rest.
  void measure(Growth& growth, const Others& others) const;
  std::string table() const { return table_of(name(), counts_); }

 private:
  const char* name() const { return context_ == app::ContextKind::none ? "show" : "drawn show"; }
  Fault play(const RoundPlace& place, Random& random);
  Fault replay(const RoundPlace& place, Random& random);
  Fault rest();

  const Models* models_;
  app::ContextKind context_;
  std::unique_ptr<app::Show> show_;
  Counts counts_;
};

}  // namespace throng::soak
