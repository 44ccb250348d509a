// The texts that a PNG has inside.

#include "throng/render/png_text.h"

#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const throng::fuzz::ScratchFile file("picture.png");
  file.put(data, size);
  (void)throng::render::read_png_texts(file.path());
  return 0;
}
