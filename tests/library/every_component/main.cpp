#include "every_header.h"

int main() {
  // A file that is not there, so that the importer is linked and answers in words.
  return throng::import::import_file("no-such-model.glb") ? 1 : 0;
}
