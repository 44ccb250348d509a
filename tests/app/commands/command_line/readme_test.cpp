#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "app/commands/command_line/options_commands.h"
#include "app/settings/tuning_values.h"

namespace throng::app::readme_test {
namespace {

/// The part of app/commands/command_line/README.md between <!-- name --> and the next <!-- end -->.
std::string part_of_readme(const std::string& name) {
  std::ifstream file(THRONG_SOURCE_DIR "/app/commands/command_line/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string begin = "<!-- " + name + " -->\n";
  const std::size_t from = text.find(begin), to = text.find("<!-- end -->", from);
  if (from == std::string::npos || to == std::string::npos) return "(there is no " + begin + ")";
  return text.substr(from + begin.size(), to - from - begin.size());
}

TEST(ReadmeOfTheCommandLine, HasTheOptionsAsTheHelpHasThem) {
  EXPECT_EQ(part_of_readme("options"), demo_options_as_markdown());
}

TEST(ReadmeOfTheCommandLine, HasTheKeysOfPresets) { EXPECT_EQ(part_of_readme("presets"), presets_as_markdown()); }

TEST(HelpSentences, LeaveNoPlaceholder) {
  for (const TuningValue& value : tuning_values()) {
    EXPECT_EQ(description(value).find_first_of("{}"), std::string::npos) << value.key;
    EXPECT_NE(description(value), "") << value.key;
  }
}

}  // namespace
}  // namespace throng::app::readme_test
