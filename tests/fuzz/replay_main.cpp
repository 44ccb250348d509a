// Tries a target without libFuzzer, the same on every run: each file of its corpus, and so many inputs made of each.
//   throng_fuzz_NAME MUTATIONS INPUT_FILE CORPUS...
// INPUT_FILE holds each input while it is tried, so a crash leaves the input there. CORPUS are folders or files.

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "tests/fuzz/mutator.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file = 65'536;
constexpr unsigned most_seconds = 60;  // for one input, on a machine that does much else

struct CorpusFile {
  std::string name;
  Bytes bytes;
};

CorpusFile read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {file.string(), {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
}

void add(const fs::path& place, std::vector<CorpusFile>& corpus) {
  if (fs::is_regular_file(place)) return corpus.push_back(read(place));
  if (!fs::is_directory(place)) return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.is_regular_file() && entry.file_size() <= largest_file) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) corpus.push_back(read(file));
}

/// Tries an input. It ends the program if it takes too long. Returns whether it was answered or refused.
bool is_harmless(const Bytes& input, const std::string& kept, const std::string& origin) {
  std::ofstream(kept, std::ios::binary)
      .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  alarm(most_seconds);
  try {
    LLVMFuzzerTestOneInput(input.data(), input.size());
  } catch (const std::exception& exception) {
    std::cerr << kept << ": made of " << origin << ": an exception escaped: " << exception.what() << '\n';
    return false;
  }
  alarm(0);
  return true;
}

int replay(std::size_t mutations, const std::string& kept, const std::vector<CorpusFile>& corpus) {
  std::size_t tried = 0;
  for (std::size_t i = 0; i < corpus.size(); ++i) {
    Mutator mutator(0x9E3779B97F4A7C15ULL);
    for (std::size_t round = 0; round <= mutations; ++round, ++tried) {
      const Bytes& other = corpus[(i + round) % corpus.size()].bytes;
      const Bytes input = round == 0 ? corpus[i].bytes : mutator.damaged(corpus[i].bytes, other);
      if (!is_harmless(input, kept, corpus[i].name)) return EXIT_FAILURE;
    }
  }
  fs::remove(kept);
  std::cout << tried << " inputs of " << corpus.size() << " files: all were answered or refused\n";
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace throng::fuzz

int main(int count, char** arguments) {
  using namespace throng::fuzz;
  if (count < 4) {
    std::cerr << arguments[0] << ": takes MUTATIONS INPUT_FILE CORPUS...\n";
    return 2;
  }
  std::vector<CorpusFile> corpus;
  for (int i = 3; i < count; ++i) add(arguments[i], corpus);
  if (corpus.empty()) {
    std::cerr << arguments[0] << ": there is no file in the corpus; build throng_fuzz_seeds_made\n";
    return 2;
  }
  std::cout << "After a crash, or " << most_seconds << " s, the input that did it is " << arguments[2] << std::endl;
  return replay(std::strtoul(arguments[1], nullptr, 10), arguments[2], corpus);
}
