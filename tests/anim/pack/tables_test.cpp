#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::pack::tables_test {
namespace {

namespace fs = std::filesystem;

const fs::path engine = THRONG_SOURCE_DIR "/engine/anim";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Returns what stands between the braces that follow `begin`; nothing where it is not found.
std::string braced(const std::string& text, const std::string& begin) {
  const std::size_t found = text.find(begin);
  if (found == std::string::npos) return {};
  const std::size_t first = text.find('{', found);
  int depth = 0;
  for (std::size_t at = first; at < text.size(); ++at) {
    depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
    if (depth == 0) return text.substr(first + 1, at - first - 1);
  }
  return {};
}

/// Returns the names of the data members of a struct, by its body: on lines that end in a semicolon, and are neither
/// functions nor constants.
std::set<std::string> members_in(const std::string& body) {
  static const std::regex member(R"(^  [\w:<>, ]+ (\w+)( = [^;(]*|\{[^;]*\})?;.*)");
  std::set<std::string> members;
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    const bool is_data = line.find("static ") == std::string::npos && line.find("return") == std::string::npos;
    if (is_data && std::regex_match(line, match, member)) members.insert(match[1]);
  }
  return members;
}

/// Returns the body of each struct of engine/anim, by its name.
std::map<std::string, std::string> structs() {
  static const std::regex named(R"(\nstruct (\w+) \{)");
  std::map<std::string, std::string> bodies;
  for (const auto& entry : fs::recursive_directory_iterator(engine)) {
    if (entry.path().extension() != ".h") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it) {
      bodies.emplace((*it)[1], braced(text.substr(static_cast<std::size_t>(it->position())), "struct "));
    }
  }
  return bodies;
}

// What a member holds may be left to others.
const std::set<std::string> left_out{
    "Model.clips",          // have a section of their own
    "ImportedFile.models",  // each has a section of its own
    "Character.lender",     // is the pack itself
    "BakedClip.lender",     // the same
    "BakedClip.generation"  // counts who came and went in memory
};

TEST(PackTables, NameEveryMemberOfWhatTheyHold) {
  const std::string tables = text_of(engine / "pack" / "tables.h");
  const auto bodies = structs();
  static const std::regex described(R"((?:Same<|auto members\()anim::(\w+)[>&] \w+[>)])");
  std::set<std::string> forgotten;
  int checked = 0;
  for (std::sregex_iterator it(tables.begin(), tables.end(), described), end; it != end; ++it) {
    const std::string name = (*it)[1];
    const auto body = bodies.find(name);
    if (body == bodies.end()) continue;  // a template
    const std::string describe = braced(tables.substr(static_cast<std::size_t>(it->position())), "anim::");
    for (const std::string& member : members_in(body->second)) {
      ++checked;
      const bool is_named = std::regex_search(describe, std::regex("\\." + member + "\\b"));
      if (!is_named && !left_out.contains(name + "." + member)) forgotten.insert(name + "." + member);
    }
  }
  EXPECT_THAT(forgotten, testing::IsEmpty()) << "who adds a member to a struct adds it to pack/tables.h";
  EXPECT_GT(checked, 130) << "members are found";
}

}  // namespace
}  // namespace throng::pack::tables_test
