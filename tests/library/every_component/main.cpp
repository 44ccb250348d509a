#include "throng/throng.h"

// A file that is not there, so that all that reads files is linked and answers in words.
int main() { return throng::load("no-such-model.glb") || throng::version() != THRONG_VERSION ? 1 : 0; }
