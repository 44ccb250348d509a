#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "throng/render/png_text.h"

#include "app/show/figures/statistics.h"

namespace throng::app {

/// Names the origin of a picture, as the picture says. All names are empty in a picture that does not say it.
struct PictureOrigin {
  std::string program;     ///< "Throng 1.0.0, commit 0123456789ab"
  std::string context;     ///< "egl"
  std::string renderer;    ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string gl_version;  ///< "4.5 (Core Profile) Mesa 22.3.6"

  friend bool operator==(const PictureOrigin&, const PictureOrigin&) = default;
};

/// Returns the origin of a picture that this program draws now.
PictureOrigin origin_of(const DrawnBy& drawn_by);

/// Returns the texts that every picture of this program has inside.
std::vector<render::PngText> origin_texts(const DrawnBy& drawn_by);

/// Reads the origin in a picture. A file that cannot be read has none.
PictureOrigin read_origin(const std::filesystem::path& file);

/// Returns the origin as texts, to write them into another picture.
std::vector<render::PngText> texts_of(const PictureOrigin& origin);

/// Returns the version of Mesa in a version of OpenGL: "22.3.6"; empty if it is another driver's.
std::string mesa_version(const std::string& gl_version);

/// Returns "egl, llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6"; empty if the picture does not say it.
std::string origin_text(const PictureOrigin& origin);

/// Says that another context, renderer or version of Mesa made the expected picture than this one: "the expected
/// picture was made by osmesa, not egl". Empty if they are equal, or the expected picture does not name them.
std::string other_origin(const PictureOrigin& expected, const PictureOrigin& actual);

}  // namespace throng::app
