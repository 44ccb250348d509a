#include "app/commands/command_line/option_reader.h"

#include <memory>
#include <utility>

#include "app/commands/command_line/version_text.h"
#include "app/files/nearest_names.h"

namespace throng::app {
namespace {

// CLI11 would take the next word for the value.
std::optional<std::string> empty_value_in(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument.starts_with("--") && argument.ends_with('=')) return argument.substr(0, argument.size() - 1);
  }
  return {};
}

std::string unexpected(const std::string& argument, const CLI::App& app) {
  if (argument.starts_with('-')) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const auto meant = name_meant(argument.substr(0, argument.find('=')), names);
    return argument + ": unknown option; " + (meant ? "is " + *meant + " meant? " : "") + app.get_name() +
           " --help lists them all";
  }
  return argument + ": unexpected; options begin with --, and one model is the most";
}

/// The help, which versions of CLI11 lay out in different ways. CLI11's hints list the options that exclude each other,
/// in another order in each run; our help has the text of the option alone.
class HelpPage : public CLI::Formatter {
 public:
  HelpPage() { column_width(34); }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const auto positionals = app->get_options([](const CLI::Option* option) { return option->get_positional(); });
    std::string usage = "Usage: " + name + " [OPTIONS]";
    for (const CLI::Option* option : positionals) usage += " " + make_option_usage(option);
    const std::string model = positionals.empty() ? "" : make_group("Model", true, positionals);
    const std::string footer = app->get_footer().empty() ? "" : app->get_footer() + "\n";
    return app->get_description() + "\n" + usage + "\n" + model + make_groups(app, mode) + "\n" + footer;
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string margin(get_column_width(), ' ');
    std::string line = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    line += line.size() < margin.size() ? margin.substr(line.size()) : "\n" + margin;
    return line + CLI::detail::find_and_replace(make_option_desc(option), "\n", "\n" + margin) + "\n";
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_option_text() + (option->get_required() ? " (required)" : "");
  }
};

/// CLI11 says "--agents: 1 required N missing", "--agents: At Most 1 required ..." and "events was given ...".
std::string mismatch(const CLI::App& app, const std::string& words) {
  const std::size_t colon = words.find(':');
  if (colon == std::string::npos) return "--" + words.substr(0, words.find(' ')) + ": takes no value";
  const std::string name = words.substr(0, colon);
  return name + (app.count(name) > 1 ? ": given more than once" : ": a value is missing");
}

/// A check of CLI11 that hands the text on; `joint` stands between name and value.
auto taken_by(const ValueReader& reader, const std::string& name, const std::string& joint) {
  return [=](const std::string& text) {
    if (const Complaint complaint = reader(text)) {
      throw CLI::ParseError(name + joint + text + ": " + *complaint, CLI::ExitCodes::ValidationError);
    }
  };
}

std::string cell(const std::string& text) { return CLI::detail::find_and_replace(text, "|", "\\|"); }

}  // namespace

OptionReader::OptionReader(const std::string& command, const std::string& description)
    : App(description + "\n", command) {
  formatter(std::make_shared<HelpPage>());
  set_help_flag();  // read() adds one that does not wait until all values are checked
}

CLI::Option* OptionReader::value(const std::string& name, const std::string& hint, const std::string& description,
                                 const ValueReader& reader) {
  return add_option(name, description)->option_text(hint.empty() ? "" : " " + hint)->each(taken_by(reader, name, " "));
}

CLI::Option* OptionReader::model(std::string& target, const std::string& description) {
  return value("MODEL", "", description, any_text(target))->group("Model");
}

CLI::Option* OptionReader::flag(const std::string& name, bool& target, const std::string& description) {
  return add_flag(name, target, description)
      ->disable_flag_override()
      ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

void OptionReader::parts_remover(bool& target) {
  flag("--remove-parts", target, "Remove FILE.*.part, which a run that was killed left beside a file to write");
}

CLI::Option* OptionReader::optional_value(const std::string& name, const std::string& value_if_omitted,
                                          const std::string& hint, const std::string& description, ValueReader reader) {
  const auto said = [value_if_omitted, reader = std::move(reader)](const std::string& text) {
    return reader(text == "true" ? value_if_omitted : text);  // CLI11's word for a flag without a value
  };
  return add_flag(name, description)
      ->multi_option_policy(CLI::MultiOptionPolicy::Throw)
      ->option_text(hint)
      ->each(taken_by(said, name, "="));
}

void OptionReader::tuning_value(const TuningValue& value, Tuning& tuning) {
  this->value(std::string(value.option_name()), std::string(value.hint()), app::description(value),
              [&value, &tuning](const std::string& text) { return value.read_option(tuning, text); });
}

void OptionReader::tuning(const std::string& group, Tuning& tuning) {
  option_defaults()->group(group);
  for (const TuningValue& value : tuning_values()) {
    if (value.group == group && !value.option.empty()) tuning_value(value, tuning);
  }
}

std::optional<ParsedCommand> OptionReader::read(const std::vector<std::string>& arguments) {
  if (const auto name = empty_value_in(arguments)) return UsageError{*name + ": a value is missing after ="};
  option_defaults()->group("Help");
  add_flag_callback(
      "-h,--help", [] { throw CLI::CallForHelp(); }, "Show this text")
      ->trigger_on_parse();
  set_version_flag("--version", "", "Show the version, and what this build and this machine have");
  try {
    parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return {};
  } catch (const CLI::CallForHelp&) {
    return ShowText{CLI::detail::find_and_replace(help(), "\n\n\n", "\n\n")};
  } catch (const CLI::CallForVersion&) {
    return ShowText{version_text()};
  } catch (const CLI::ExtrasError&) {
    return UsageError{unexpected(remaining().front(), *this)};
  } catch (const CLI::ArgumentMismatch& error) {
    return UsageError{mismatch(*this, error.what())};
  } catch (const CLI::ExcludesError& error) {
    return UsageError{error.what() + std::string("; give one of them")};
  } catch (const CLI::ParseError& error) {
    return UsageError{error.what()};
  }
}

std::string OptionReader::markdown() const {
  const HelpPage help;
  std::string text;
  for (const std::string& group : get_groups()) {
    text += "\n" + group + ":\n\n| option | meaning |\n|---|---|\n";
    for (const CLI::Option* option : get_options([&](const auto* each) { return each->get_group() == group; })) {
      const std::string name = help.make_option_name(option, option->get_positional());
      text += "| `" + cell(name + help.make_option_opts(option)) + "` | " + cell(option->get_description()) + " |\n";
    }
  }
  return text;
}

}  // namespace throng::app
