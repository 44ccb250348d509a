#include "app/command_line/option_reader.h"

#include <utility>

#include <CLI/CLI.hpp>

namespace throng::app {
namespace {

std::optional<std::string> empty_value_in(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument.starts_with("--") && argument.ends_with('=')) return argument.substr(0, argument.size() - 1);
  }
  return {};
}

std::string unexpected(const std::string& argument, const std::string& command) {
  if (argument.starts_with('-')) return argument + ": unknown option; " + command + " --help lists them all";
  return argument + ": unexpected; options begin with --, and one model is the most";
}

std::string too_many(const std::string& name, const std::vector<std::string>& values, std::size_t most) {
  if (most == 1) return name + ": given more than once";
  return values[most] + ": " + std::to_string(most) + " models are the most";
}

/// CLI11 names the option, then a colon and words of its own.
std::string missing_value(const CLI::ArgumentMismatch& error) {
  const std::string words = error.what();
  return words.substr(0, words.find(':')) + ": a value is missing";
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

std::string with_escaped_bars(std::string text) {
  for (std::size_t bar = 0; (bar = text.find('|', bar)) != std::string::npos; bar += 2) text.insert(bar, 1, '\\');
  return text;
}

}  // namespace

std::string OptionReader::Binding::written() const { return name + (joint == "=" || hint.empty() ? "" : " ") + hint; }

OptionReader::OptionReader(const std::string& command, const std::string& description)
    : app_(std::make_unique<CLI::App>(description, command)) {
  app_->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

OptionReader::~OptionReader() = default;

bool OptionReader::given(const std::string& name) const { return app_->count(name) > 0; }

std::vector<std::string> OptionReader::all_given() const {
  std::vector<std::string> names;
  for (const Binding& binding : bindings_) {
    if (binding.option->count() > 0) names.push_back(binding.name);
  }
  return names;
}

void OptionReader::model(std::string& target, const std::string& description, Need need) {
  CLI::Option* const option = app_->add_option("MODEL")->required(need == Need::required);
  bindings_.push_back({option, "MODEL", " ", "", description, heading_, any_text(target), need});
}

void OptionReader::models(std::vector<std::string>& targets, std::size_t most, const std::string& description) {
  CLI::Option* const option = app_->add_option("MODEL")->expected(-1);
  const auto add = [&targets](const std::string& text) -> Complaint { return any_text(targets.emplace_back())(text); };
  bindings_.push_back({option, "MODEL", " ", "", description, heading_, add, Need::optional, most});
}

void OptionReader::value(const std::string& name, const std::string& hint, const std::string& description,
                         ValueReader reader, Need need) {
  CLI::Option* const option = app_->add_option(name)->required(need == Need::required);
  bindings_.push_back({option, name, " ", hint, description, heading_, std::move(reader), need});
}

void OptionReader::optional_value(const std::string& name, const std::string& unsaid, const std::string& hint,
                                  const std::string& description, ValueReader reader) {
  CLI::Option* const option = app_->add_flag(name + "{" + unsaid + "}");
  bindings_.push_back({option, name, "=", hint, description, heading_, std::move(reader), Need::optional});
}

void OptionReader::flag(const std::string& name, bool& target, const std::string& description) {
  const auto set = [&target](const std::string& text) -> Complaint {
    if (text != "true") return "takes no value";
    target = true;
    return {};
  };
  bindings_.push_back({app_->add_flag(name), name, "=", "", description, heading_, set, Need::optional});
}

void OptionReader::tuning_value(const TuningValue& value, Tuning& tuning) {
  this->value(std::string(value.option_name()), std::string(value.hint()), description(value),
              [&value, &tuning](const std::string& text) { return value.read_option(tuning, text); });
}

void OptionReader::tuning(const std::string& group, Tuning& tuning) {
  heading(group);
  for (const TuningValue& value : tuning_values()) {
    if (value.group == group && !value.option.empty()) tuning_value(value, tuning);
  }
}

std::optional<ParsedCommand> OptionReader::read(const std::vector<std::string>& arguments) {
  if (auto stop = take_apart(arguments)) return stop;
  return read_values();
}

std::optional<ParsedCommand> OptionReader::take_apart(const std::vector<std::string>& arguments) {
  if (const auto name = empty_value_in(arguments)) return UsageError{*name + ": a value is missing after ="};
  try {
    app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return {};
  } catch (const CLI::CallForHelp&) {
    return ShowText{help()};
  } catch (const CLI::ExtrasError&) {
    return UsageError{unexpected(app_->remaining().front(), app_->get_name())};
  } catch (const CLI::ArgumentMismatch& error) {
    return UsageError{missing_value(error)};
  } catch (const CLI::ParseError& error) {
    return UsageError{error.what()};
  }
}

std::optional<ParsedCommand> OptionReader::read_values() const {
  for (const Binding& binding : bindings_) {
    const std::vector<std::string> texts = binding.option->results();
    if (texts.size() > binding.most) return UsageError{too_many(binding.name, texts, binding.most)};
    for (const std::string& text : texts) {
      if (const Complaint complaint = binding.reader(text)) {
        return UsageError{binding.name + binding.joint + text + ": " + *complaint};
      }
    }
  }
  return {};
}

std::string OptionReader::help() const {
  constexpr std::size_t column = 34;
  std::string text = app_->get_description() + "\n\n" + usage() + "\n";
  std::string heading;
  for (const Binding& binding : bindings_) {
    if (binding.heading != heading) text += "\n" + binding.heading + "\n";
    heading = binding.heading;
    text += padded("  " + binding.written(), column) + binding.description + "\n";
  }
  return footer_.empty() ? text : text + "\n" + footer_ + "\n";
}

std::string OptionReader::markdown() const {
  std::string text, heading;
  for (const Binding& binding : bindings_) {
    if (binding.heading != heading) text += "\n" + binding.heading + ":\n\n| option | meaning |\n|---|---|\n";
    heading = binding.heading;
    text += "| `" + with_escaped_bars(binding.written()) + "` | " + with_escaped_bars(binding.description) + " |\n";
  }
  return text;
}

std::string OptionReader::usage() const {
  std::string line = "Usage: " + app_->get_name();
  for (const Binding& binding : bindings_) {
    const std::string hint = binding.hint.empty() ? "" : " " + binding.hint;
    if (binding.need == Need::required)
      line += " " + binding.name + hint;
    else if (binding.name == "MODEL")
      line += " [MODEL]";
  }
  return line + " [options]";
}

}  // namespace throng::app
