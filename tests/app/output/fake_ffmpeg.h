#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace throng::app::test {

/// Returns what is in a file.
inline std::string contents_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A script that stands in PATH as ffmpeg, and nothing else does, as long as it lives. It has the usual encoders; what
/// it does with a video is `body`, where $file is the file to write. It notes the words that it was started with.
class FakeFfmpeg {
 public:
  /// Writes an .mp4 whose media are what comes: the frames, one behind the other.
  static constexpr const char* takes_all = R"(cat > "$file"
length=$(($(wc -c < "$file") + 8))
digits=$(printf '\\%03o' $((length >> 24 & 255)) $((length >> 16 & 255)) $((length >> 8 & 255)) $((length & 255)))
{ printf "${digits}mdat"; cat "$file"; printf '\000\000\000\010moov'; } > "$file.whole"
mv "$file.whole" "$file")";

  FakeFfmpeg(const std::filesystem::path& folder, const std::string& body,
             const std::string& encoders = " libx264 libvpx-vp9 ")
      : folder_(folder / "programs") {
    std::filesystem::create_directories(folder_);
    const std::filesystem::path script = folder_ / "ffmpeg";
    std::ofstream(script) << "#!/bin/sh\nPATH=/usr/bin:/bin\n"
                          << "case \"$*\" in *-encoders*) echo '" << encoders << "'; exit 0;; esac\n"
                          << "echo \"$@\" > " << words_file().string() << "\n"
                          << "for file; do :; done\nfile=${file#file:}\n"
                          << body << "\n";
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    const char* const before = std::getenv("PATH");
    path_before_ = before == nullptr ? "" : before;
    setenv("PATH", folder_.c_str(), 1);
  }
  ~FakeFfmpeg() { setenv("PATH", path_before_.c_str(), 1); }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

  /// Returns the frames of a video that it has taken.
  static std::string frames_in(const std::filesystem::path& file) {
    const std::string video = contents_of(file);
    return video.size() < 16 ? "" : video.substr(8, video.size() - 16);
  }

  std::string path() const { return folder_.string(); }
  /// Returns the words of its last start for a video.
  std::string words() const { return contents_of(words_file()); }

 private:
  std::filesystem::path words_file() const { return folder_ / "words"; }

  std::filesystem::path folder_;
  std::string path_before_;
};

}  // namespace throng::app::test
