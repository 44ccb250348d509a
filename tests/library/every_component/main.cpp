#include "every_header.h"

int main() {
  // Files that are not there, so that both libraries are linked and answer in words.
  return throng::import::import_file("no-such-model.glb") || throng::pack::Pack::open("no-such.pack") ? 1 : 0;
}
