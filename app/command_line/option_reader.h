#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line/options.h"
#include "app/settings/option_values.h"
#include "app/settings/tuning_values.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace throng::app {

/// The options of one command: declared one by one, then read from a command line. CLI11 takes the line apart; the help
/// and the words of every refusal are ours.
class OptionReader {
 public:
  OptionReader(const std::string& command, const std::string& description);
  ~OptionReader();
  OptionReader(const OptionReader&) = delete;
  OptionReader& operator=(const OptionReader&) = delete;

  /// Stands in the help above the options declared after it.
  void heading(const std::string& text) { heading_ = text; }

  /// Closes the help.
  void footer(const std::string& text) { footer_ = text; }

  enum class Need { optional, required };

  void model(std::string& target, const std::string& description, Need need);
  /// Any number of models up to `most`, or none.
  void models(std::vector<std::string>& targets, std::size_t most, const std::string& description);
  void value(const std::string& name, const std::string& hint, const std::string& description, ValueReader reader,
             Need need = Need::optional);

  /// Takes a value only after `=`; without one, `reader` gets `unsaid`.
  void optional_value(const std::string& name, const std::string& unsaid, const std::string& hint,
                      const std::string& description, ValueReader reader);
  void flag(const std::string& name, bool& target, const std::string& description);

  /// The option of one value of the tuning, and all of a group under its heading.
  void tuning_value(const TuningValue& value, Tuning& tuning);
  void tuning(const std::string& group, Tuning& tuning);

  /// Reads the line; nothing when all went well, else what to show and end with.
  std::optional<ParsedCommand> read(const std::vector<std::string>& arguments);

  /// The help as tables, one a heading.
  std::string markdown() const;

  /// After read().
  bool given(const std::string& name) const;
  std::vector<std::string> all_given() const;

 private:
  struct Binding {
    CLI::Option* option;
    std::string name;
    std::string joint;  ///< between name and value: a space or =
    std::string hint;
    std::string description;
    std::string heading;
    ValueReader reader;
    Need need;
    std::size_t most = 1;  ///< values; `reader` gets one after the other

    std::string written() const;  ///< name and hint
  };

  std::optional<ParsedCommand> take_apart(const std::vector<std::string>& arguments);
  std::optional<ParsedCommand> read_values() const;
  std::string help() const;
  std::string usage() const;

  std::unique_ptr<CLI::App> app_;
  std::string heading_;
  std::string footer_;
  std::vector<Binding> bindings_;
};

}  // namespace throng::app
