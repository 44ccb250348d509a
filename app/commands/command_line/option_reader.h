#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands/command_line/options.h"
#include "app/settings/option_values.h"
#include "app/settings/tuning_values.h"

namespace throng::app {

/// CLI11's parser of one command. It adds options that a ValueReader takes, and refusals that name option, value and
/// remedy. option_defaults()->group() says under which heading the help lists the options that follow.
class OptionReader : public CLI::App {
 public:
  OptionReader(const std::string& command, const std::string& description);

  CLI::Option* value(const std::string& name, const std::string& hint, const std::string& description,
                     const ValueReader& reader);
  CLI::Option* model(std::string& target, const std::string& description);

  /// Adds an option without a value, which sets `target`.
  CLI::Option* flag(const std::string& name, bool& target, const std::string& description);

  /// Adds the flag that removes remains of killed runs beside the files to write.
  void parts_remover(bool& target);

  /// Adds an option that takes a value only after `=`; without one, `reader` gets `value_if_omitted`.
  CLI::Option* optional_value(const std::string& name, const std::string& value_if_omitted, const std::string& hint,
                              const std::string& description, ValueReader reader);

  /// Adds the option of one value of the tuning.
  void tuning_value(const TuningValue& value, Tuning& tuning);
  /// Adds the options of all values of a group, under its heading.
  void tuning(const std::string& group, Tuning& tuning);

  /// Reads the line. Returns nothing when all went well, else the text to show and the exit status.
  std::optional<ParsedCommand> read(const std::vector<std::string>& arguments);

  /// Returns whether the line names the option. Call it after read().
  bool given(const std::string& name) const { return count(name) > 0; }

  /// Returns the help as tables, one a heading.
  std::string markdown() const;
};

}  // namespace throng::app
