#include "throng/c.h"

int main(void) { return throng_load("no-such-model.glb", 0.0) == 0 && throng_last_error()[0] != 0 ? 0 : 1; }
